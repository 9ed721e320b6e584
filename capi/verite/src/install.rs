//! Surfaces as destination, depth buffer and texture; flips.

use std::ffi::c_int;

use fillrate_redline::{BufferGroup, Call, Result, Surface, VlRoutine, record};

use crate::handle::Opaque;
use crate::sink::{Sink, recorded};
use crate::surface::RawSurface;

/// Runs a recording call on a surface.
///
/// # Safety
/// `cmdbuffer` is null or points to a handle, `surface` is null or points to a
/// surface whose palette is null or holds as many entries as it says.
pub(crate) unsafe fn with_surface(
    cmdbuffer: *mut Opaque,
    surface: *const RawSurface,
    routine: VlRoutine,
    body: impl FnOnce(&mut Sink, &Surface, &BufferGroup) -> Result<()>,
) -> c_int {
    // SAFETY: the caller's promise.
    unsafe {
        recorded(cmdbuffer, routine, |sink| {
            let (surface, group, _) = sink.session().surface(surface, routine)?;
            body(sink, &surface, &group)
        })
    }
}

/// Draws into a surface.
///
/// # Safety
/// As for `with_surface`.
#[unsafe(export_name = "redline_InstallDstBuffer")]
pub unsafe extern "C" fn VL_InstallDstBuffer(
    cmdbuffer: *mut Opaque,
    surface: *const RawSurface,
) -> c_int {
    // SAFETY: the caller's promise.
    unsafe {
        with_surface(cmdbuffer, surface, VlRoutine::InstallDstBuffer, |sink, surface, group| {
            record::install_dst_buffer(sink, surface, group)
        })
    }
}

/// Takes a surface's depth buffer.
///
/// # Safety
/// As for `with_surface`.
#[unsafe(export_name = "redline_InstallZBuffer")]
pub unsafe extern "C" fn VL_InstallZBuffer(
    cmdbuffer: *mut Opaque,
    surface: *const RawSurface,
) -> c_int {
    // SAFETY: the caller's promise.
    unsafe {
        with_surface(cmdbuffer, surface, VlRoutine::InstallZBuffer, |sink, _, group| {
            record::install_z_buffer(sink, group)
        })
    }
}

/// Takes a surface as texture, with all that its members say.
///
/// # Safety
/// As for `with_surface`.
#[unsafe(export_name = "redline_InstallTextureMap")]
pub unsafe extern "C" fn VL_InstallTextureMap(
    cmdbuffer: *mut Opaque,
    surface: *const RawSurface,
) -> c_int {
    // SAFETY: the caller's promise.
    unsafe {
        with_surface(cmdbuffer, surface, VlRoutine::InstallTextureMap, |sink, surface, group| {
            record::install_texture_map(sink, surface, group)
        })
    }
}

/// Takes a surface as texture: where it is and how large.
///
/// # Safety
/// As for `with_surface`.
#[unsafe(export_name = "redline_InstallTextureMapBasic")]
pub unsafe extern "C" fn VL_InstallTextureMapBasic(
    cmdbuffer: *mut Opaque,
    surface: *const RawSurface,
) -> c_int {
    let routine = VlRoutine::InstallTextureMapBasic;
    // SAFETY: the caller's promise.
    unsafe {
        with_surface(cmdbuffer, surface, routine, |sink, surface, group| {
            record::install_texture_map_basic(sink, surface, group)
        })
    }
}

/// Shows the back buffer, and draws into what was the front buffer.
///
/// # Safety
/// As for `with_surface`.
#[unsafe(export_name = "redline_SwapDisplaySurface")]
pub unsafe extern "C" fn VL_SwapDisplaySurface(
    cmdbuffer: *mut Opaque,
    surface: *const RawSurface,
) -> c_int {
    let routine = VlRoutine::SwapDisplaySurface;
    // SAFETY: the caller's promise.
    unsafe {
        recorded(cmdbuffer, routine, |sink| {
            let (_, group, handle) = sink.session().surface(surface, routine)?;
            record::swap_display_surface(sink, &group)?;
            if let Ok(buffer) = sink.buffer() {
                buffer.flips += 1;
            }
            let Some((device, group)) = sink.session().group_number(handle) else { return Ok(()) };
            let call = Call::SwapBuffers { device, group, a: 0, b: 1 };
            sink.session().call(&call).map(|_| ())
        })
    }
}
