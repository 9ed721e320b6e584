//! Surfaces: structures that the program reads and changes.

use std::ffi::c_int;

use fillrate_guard::{guard, read, write};
use fillrate_redline::surface::{UCLAMP, VCLAMP};
use fillrate_redline::{BufferGroup, Call, Failure, Reply, Result, Surface, VlError, VlRoutine};

use crate::errors::{report, vl};
use crate::handle::Opaque;
use crate::session::Session;

/// `v_surface`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct RawSurface {
    width: u32,
    height: u32,
    pixel_fmt: u32,
    chroma_color: u32,
    chroma_mask: u32,
    chromakey: u32,
    color_pad: u32,
    bgr: u32,
    clamp: u32,
    palette: *const u32,
    start_index: u32,
    num_entries: u32,
    memsize: u32,
    num_buffers: u32,
    buffer_mask: u32,
    buffer_group: Opaque,
}

/// A surface that the library made; its members stay where they are until it is
/// destroyed.
pub(crate) struct Owned {
    raw: *mut RawSurface,
    /// Its group, whatever the program makes of the member.
    group: Opaque,
}

// SAFETY: the pointers in it are handed back to the program and followed only
// in its calls.
unsafe impl Send for Owned {}

impl Drop for Owned {
    fn drop(&mut self) {
        // SAFETY: it came from a box, and the program has given it back.
        drop(unsafe { Box::from_raw(self.raw) });
    }
}

impl RawSurface {
    /// What recording needs of the members.
    ///
    /// # Safety
    /// The palette is null or holds as many entries as the members say.
    unsafe fn surface(&self) -> Surface {
        let new = Surface::new(self.width, self.height, self.pixel_fmt);
        Surface {
            chroma_color: self.chroma_color,
            chroma_mask: self.chroma_mask,
            chromakey: self.chromakey,
            color_pad: self.color_pad,
            bgr: self.bgr,
            clamp: self.clamp,
            // SAFETY: the caller's promise.
            palette: unsafe { self.palette_entries() },
            start_index: self.start_index,
            num_entries: self.num_entries,
            ..new
        }
    }

    /// The 16 entries, those in use filled in.
    ///
    /// # Safety
    /// As for `surface`.
    unsafe fn palette_entries(&self) -> Option<[u32; 16]> {
        if self.palette.is_null() {
            return None;
        }
        let mut entries = [0; 16];
        let start = self.start_index.min(16) as usize;
        let places = entries[start..].iter_mut().take(self.num_entries as usize);
        for (i, entry) in places.enumerate() {
            // SAFETY: the caller's promise.
            *entry = unsafe { self.palette.add(i).read_unaligned() };
        }
        Some(entries)
    }
}

impl Session {
    /// A surface's members for recording, and its group.
    ///
    /// # Safety
    /// `surface` is null or points to a surface whose palette is null or holds
    /// as many entries as it says.
    pub unsafe fn surface(
        &self,
        surface: *const RawSurface,
        routine: VlRoutine,
    ) -> Result<(Surface, BufferGroup, Opaque)> {
        let failed = Failure::vl(routine, VlError::ParamError);
        // SAFETY: the caller's promise.
        let raw = unsafe { read(surface) }.ok_or(failed)?;
        let group = self.group(raw.buffer_group).ok_or(failed)?.clone();
        // SAFETY: the caller's promise.
        Ok((unsafe { raw.surface() }, group, raw.buffer_group))
    }

    /// Makes a surface and hands it to the program.
    ///
    /// # Safety
    /// `surface` is null or points to a pointer.
    unsafe fn make_surface(
        &mut self,
        device: Opaque,
        surface: *mut *mut RawSurface,
        routine: VlRoutine,
        call: impl FnOnce(u32) -> Call,
    ) -> Result<()> {
        let failed = |error| Failure::vl(routine, error);
        let open = self.device(device).filter(|_| !surface.is_null());
        let open = open.ok_or(failed(VlError::ParamError))?;
        let Reply::Group(number, memsize) = self.call(&call(open))? else {
            return Err(failed(VlError::Failed));
        };
        let Some(group) = self.context.group(open, number).cloned() else {
            return Err(failed(VlError::Failed));
        };
        let handle = self.name_group(open, number).ok_or(failed(VlError::AllocFailed))?;
        let made = Surface::new(group.width, group.height, group.format.code());
        let raw = Box::into_raw(Box::new(RawSurface {
            width: made.width,
            height: made.height,
            pixel_fmt: made.pixel_fmt,
            chroma_color: made.chroma_color,
            chroma_mask: made.chroma_mask,
            chromakey: made.chromakey,
            color_pad: made.color_pad,
            bgr: made.bgr,
            clamp: made.clamp,
            palette: std::ptr::null(),
            start_index: made.start_index,
            num_entries: made.num_entries,
            memsize,
            num_buffers: group.count(),
            buffer_mask: group.mask,
            buffer_group: handle,
        }));
        // SAFETY: the caller's promise.
        unsafe { write(surface, raw) };
        self.surfaces.insert(raw.addr(), Owned { raw, group: handle });
        Ok(())
    }
}

/// Makes a surface with memory of its own.
///
/// # Safety
/// `surface` is null or points to a pointer.
#[unsafe(export_name = "redline_CreateSurface")]
pub unsafe extern "C" fn VL_CreateSurface(
    device: Opaque,
    surface: *mut *mut RawSurface,
    mask: u32,
    buffers: u32,
    format: u32,
    width: u32,
    height: u32,
) -> c_int {
    vl(device, |session| {
        let call = |device| Call::CreateSurface { device, mask, buffers, format, width, height };
        // SAFETY: the caller's promise.
        unsafe { session.make_surface(device, surface, VlRoutine::CreateSurface, call) }
    })
}

/// Makes a surface over video memory that exists.
///
/// # Safety
/// `surface` is null or points to a pointer.
#[unsafe(export_name = "redline_PointSurface")]
pub unsafe extern "C" fn VL_PointSurface(
    device: Opaque,
    surface: *mut *mut RawSurface,
    mask: u32,
    buffers: u32,
    format: u32,
    width: u32,
    height: u32,
    address: u32,
) -> c_int {
    vl(device, |session| {
        let call =
            |device| Call::PointSurface { device, mask, buffers, format, width, height, address };
        // SAFETY: the caller's promise.
        unsafe { session.make_surface(device, surface, VlRoutine::PointSurface, call) }
    })
}

/// Gives a surface back. Pointers that the library did not make are refused.
#[unsafe(export_name = "redline_DestroySurface")]
pub extern "C" fn VL_DestroySurface(device: Opaque, surface: *mut RawSurface) -> c_int {
    vl(device, |session| {
        let failed = Failure::vl(VlRoutine::DestroySurface, VlError::ParamError);
        let group = session.surfaces.get(&surface.addr()).ok_or(failed)?.group;
        let owner = session.group_number(group).ok_or(failed)?;
        if session.device(device) != Some(owner.0) {
            return Err(failed);
        }
        session.call(&Call::DestroySurface { device: owner.0, group: owner.1 })?;
        session.forget_group(group);
        session.surfaces.remove(&surface.addr());
        Ok(())
    })
}

/// Takes memory again where it was lost. The contents are undefined.
///
/// # Safety
/// `surface` is null or points to a surface.
#[unsafe(export_name = "redline_RestoreSurface")]
pub unsafe extern "C" fn VL_RestoreSurface(device: Opaque, surface: *mut RawSurface) -> c_int {
    vl(device, |session| {
        let failed = Failure::vl(VlRoutine::RestoreSurface, VlError::ParamError);
        // SAFETY: the caller's promise.
        let raw = unsafe { read(surface) }.ok_or(failed)?;
        let owner = session.group_number(raw.buffer_group);
        let owner = owner.filter(|(owner, _)| session.device(device) == Some(*owner));
        let (device, group) = owner.ok_or(failed)?;
        session.call(&Call::RestoreSurface { device, group })?;
        if let Some(group) = session.context.group(device, group) {
            // SAFETY: the caller's promise.
            unsafe { write(&raw mut (*surface).buffer_mask, group.mask) };
        }
        Ok(())
    })
}

/// Changes a surface's members.
///
/// # Safety
/// `surface` is null or points to a surface.
unsafe fn change(
    surface: *mut RawSurface,
    routine: VlRoutine,
    how: impl FnOnce(&mut RawSurface),
) -> c_int {
    guard(VlError::Failed.number(), || {
        // SAFETY: the caller's promise.
        let Some(mut raw) = (unsafe { read(surface) }) else {
            let failure = Failure::vl(routine, VlError::ParamError);
            return report(std::ptr::null_mut(), &failure);
        };
        how(&mut raw);
        // SAFETY: it was just read.
        unsafe { write(surface, raw) };
        VlError::Success.number()
    })
}

/// Declares functions that set one member: C name, name, routine, member.
macro_rules! members {
    ($($c:literal $name:ident $routine:ident $member:ident;)*) => {$(
        #[doc = concat!("Sets `", stringify!($member), "`.")]
        ///
        /// # Safety
        /// `surface` is null or points to a surface.
        #[unsafe(export_name = $c)]
        pub unsafe extern "C" fn $name(surface: *mut RawSurface, value: u32) -> c_int {
            // SAFETY: the caller's promise.
            unsafe { change(surface, VlRoutine::$routine, |raw| raw.$member = value) }
        }
    )*};
}

members! {
    "redline_SetSurfaceChromaKey" VL_SetSurfaceChromaKey SetSurfaceChromaKey chromakey;
    "redline_SetSurfaceChromaColor" VL_SetSurfaceChromaColor SetSurfaceChromaColor chroma_color;
    "redline_SetSurfaceChromaMask" VL_SetSurfaceChromaMask SetSurfaceChromaMask chroma_mask;
    "redline_SetSurfaceColorPad" VL_SetSurfaceColorPad SetSurfaceColorPad color_pad;
    "redline_SetSurfaceBGR" VL_SetSurfaceBGR SetSurfaceBGR bgr;
}

/// Clamps or repeats the axes.
///
/// # Safety
/// `surface` is null or points to a surface.
#[unsafe(export_name = "redline_SetSurfaceClamp")]
pub unsafe extern "C" fn VL_SetSurfaceClamp(surface: *mut RawSurface, u: u32, v: u32) -> c_int {
    let bit = |on: u32, bit: u32| if on != 0 { bit } else { 0 };
    // SAFETY: the caller's promise.
    unsafe {
        change(surface, VlRoutine::SetSurfaceClamp, |raw| {
            raw.clamp = bit(u, UCLAMP) | bit(v, VCLAMP);
        })
    }
}

/// Sets the palette of a 4-bit texture; the entries are read when the texture
/// is installed.
///
/// # Safety
/// `surface` is null or points to a surface.
#[unsafe(export_name = "redline_SetSurfaceTexturePalette")]
pub unsafe extern "C" fn VL_SetSurfaceTexturePalette(
    surface: *mut RawSurface,
    start: c_int,
    count: c_int,
    entries: *const u32,
) -> c_int {
    let routine = VlRoutine::SetSurfaceTexturePalette;
    if start < 0 || count < 0 || i64::from(start) + i64::from(count) > 16 {
        return guard(VlError::Failed.number(), || {
            report(std::ptr::null_mut(), &Failure::vl(routine, VlError::ParamError))
        });
    }
    // SAFETY: the caller's promise.
    unsafe {
        change(surface, routine, |raw| {
            raw.palette = entries;
            raw.start_index = start as u32;
            raw.num_entries = count as u32;
        })
    }
}
