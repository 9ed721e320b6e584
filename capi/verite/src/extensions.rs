//! Names of extensions, and the functions that they bring.

use std::ffi::{c_char, c_int, c_void};

use fillrate_guard::text;
use fillrate_redline::{Failure, VlError, VlRoutine, record};

use crate::errors::{quiet, value};
use crate::handle::Opaque;
use crate::sink::recorded;

/// The names, each with a space on both sides. They stay where they are.
#[unsafe(export_name = "redline_GetExtensions")]
pub extern "C" fn VL_GetExtensions(device: Opaque) -> *const c_char {
    value(device, std::ptr::null(), |session| {
        let failed = Failure::vl(VlRoutine::GetExtensions, VlError::ParamError);
        session.device(device).ok_or(failed)?;
        Ok(session.extensions.as_ptr())
    })
}

/// A function of an extension that the opened board has, or null.
///
/// # Safety
/// `name` is null or a text with its end.
#[unsafe(export_name = "redline_GetExtensionFunction")]
pub unsafe extern "C" fn VL_GetExtensionFunction(name: *const c_char) -> *const c_void {
    type Setter = unsafe extern "C" fn(*mut Opaque, u32) -> c_int;
    quiet(std::ptr::null(), |session| {
        // SAFETY: the caller's promise.
        let name = unsafe { text(name) }?;
        let found: Setter = match name {
            b"VL_SetSpecularEnable" => set_specular_enable,
            b"VL_SetSpecularColorRGB" => set_specular_color_rgb,
            b"VL_SetSpecularColorBGR" => set_specular_color_bgr,
            _ => return None,
        };
        session.context.has_specular().then_some(found as *const c_void)
    })
}

/// Adds the second colour, or not.
unsafe extern "C" fn set_specular_enable(cmdbuffer: *mut Opaque, value: u32) -> c_int {
    let routine = VlRoutine::SetSpecularEnable;
    // SAFETY: the caller's promise.
    unsafe { recorded(cmdbuffer, routine, |sink| record::set_specular_enable(sink, value)) }
}

/// The second colour of vertices without one.
unsafe extern "C" fn set_specular_color_rgb(cmdbuffer: *mut Opaque, value: u32) -> c_int {
    let routine = VlRoutine::SetSpecularColorRGB;
    // SAFETY: the caller's promise.
    unsafe { recorded(cmdbuffer, routine, |sink| record::set_specular_color_rgb(sink, value)) }
}

/// The same, blue first.
unsafe extern "C" fn set_specular_color_bgr(cmdbuffer: *mut Opaque, value: u32) -> c_int {
    let routine = VlRoutine::SetSpecularColorBGR;
    // SAFETY: the caller's promise.
    unsafe { recorded(cmdbuffer, routine, |sink| record::set_specular_color_bgr(sink, value)) }
}
