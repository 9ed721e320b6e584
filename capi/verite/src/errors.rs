//! Codes, handlers and the last errors.
//!
//! Handlers are called without the library's lock, so that they may call the
//! library; a failure in there calls them again.

use std::ffi::c_int;

use fillrate_guard::guard;
use fillrate_redline::{Failure, Fault, Result, VError, VlError};

use crate::handle::Opaque;
use crate::session::{Session, session};

/// `v_error_handler` and `vl_error_handler`.
pub type Handler = unsafe extern "C" fn(Opaque, c_int, c_int, c_int);

/// What the process has registered, and what failed last in each layer.
#[derive(Debug, Default)]
pub(crate) struct Errors {
    v: Option<Handler>,
    vl: Option<Handler>,
    /// Routine and error.
    last_v: Option<(c_int, c_int)>,
    last_vl: Option<(c_int, c_int)>,
}

/// Notes a failure and tells the handlers; the number that the call returns.
pub(crate) fn report(device: Opaque, failure: &Failure) -> c_int {
    for fault in failure.faults() {
        let (routine, error) = (fault.routine(), fault.error());
        let handler = {
            let errors = &mut session().errors;
            let (last, handler) = match fault {
                Fault::V(..) => (&mut errors.last_v, errors.v),
                Fault::Vl(..) => (&mut errors.last_vl, errors.vl),
            };
            *last = Some((routine, error));
            handler
        };
        if let Some(handler) = handler {
            // SAFETY: the program registered it to be called so.
            unsafe { handler(device, routine, error, 0) }
        }
    }
    failure.number()
}

/// Runs a call of the lower layer that returns a code.
pub(crate) fn v(device: Opaque, body: impl FnOnce(&mut Session) -> Result<()>) -> c_int {
    guard(VError::Failed.number(), || {
        let result = body(&mut session());
        result.map_or_else(|failure| report(device, &failure), |()| VError::Success.number())
    })
}

/// Runs a call of the upper layer that returns a code.
pub(crate) fn vl(device: Opaque, body: impl FnOnce(&mut Session) -> Result<()>) -> c_int {
    guard(VlError::Failed.number(), || {
        let result = body(&mut session());
        result.map_or_else(|failure| report(device, &failure), |()| VlError::Success.number())
    })
}

/// Runs a call that returns a value, and `fallback` where it fails.
pub(crate) fn value<T: Copy>(
    device: Opaque,
    fallback: T,
    body: impl FnOnce(&mut Session) -> Result<T>,
) -> T {
    guard(fallback, || {
        let result = body(&mut session());
        result.unwrap_or_else(|failure| {
            report(device, &failure);
            fallback
        })
    })
}

/// Runs a call of the lower layer that returns a state, or a failure's code.
pub(crate) fn state(device: Opaque, body: impl FnOnce(&mut Session) -> Result<VError>) -> u32 {
    let number = guard(VError::Failed.number(), || {
        let result = body(&mut session());
        result.map_or_else(|failure| report(device, &failure), VError::number)
    });
    number as u32
}

/// Runs a call that returns a value and never fails aloud.
pub(crate) fn quiet<T: Copy>(fallback: T, body: impl FnOnce(&mut Session) -> Option<T>) -> T {
    guard(fallback, || body(&mut session()).unwrap_or(fallback))
}

/// The exported functions.
pub mod exports {
    use std::ffi::{c_char, c_int};

    use fillrate_guard::{guard, write};
    use fillrate_redline::{VError, VRoutine, VlError, VlRoutine};

    use super::Handler;
    use crate::session::session;

    /// Writes a text with its end into `bytes` bytes; what does not fit is cut.
    ///
    /// # Safety
    /// `to` is null or has room for `bytes` bytes.
    unsafe fn put(text: Option<&str>, to: *mut c_char, bytes: c_int) -> bool {
        let (Some(text), Ok(room @ 1..), false) = (text, usize::try_from(bytes), to.is_null())
        else {
            return false;
        };
        let text = text.bytes().take(room - 1).chain([0]);
        for (i, byte) in text.enumerate() {
            // SAFETY: at most `room` bytes are written.
            unsafe { write(to.add(i), byte as c_char) }
        }
        true
    }

    /// Registers the lower layer's handler; null takes it away.
    #[unsafe(no_mangle)]
    pub extern "C" fn V_RegisterErrorHandler(handler: Option<Handler>) -> c_int {
        guard(VError::Failed.number(), || {
            session().errors.v = handler;
            VError::Success.number()
        })
    }

    /// The lower layer's handler, or null.
    #[unsafe(no_mangle)]
    pub extern "C" fn V_GetErrorHandler() -> Option<Handler> {
        guard(None, || session().errors.v)
    }

    /// The name of a function of the lower layer. Calls no handler.
    ///
    /// # Safety
    /// `text` is null or has room for `bytes` bytes.
    #[unsafe(no_mangle)]
    pub unsafe extern "C" fn V_GetFunctionName(
        routine: c_int,
        text: *mut c_char,
        bytes: c_int,
    ) -> c_int {
        let name = VRoutine::from_number(routine).map(VRoutine::text);
        // SAFETY: the caller's promise.
        match unsafe { put(name, text, bytes) } {
            true => VError::Success.number(),
            false => VError::ParamError.number(),
        }
    }

    /// The text of an error of the lower layer. Calls no handler.
    ///
    /// # Safety
    /// `text` is null or has room for `bytes` bytes.
    #[unsafe(no_mangle)]
    pub unsafe extern "C" fn V_GetErrorText(
        error: c_int,
        text: *mut c_char,
        bytes: c_int,
    ) -> c_int {
        let words = VError::from_number(error).map(VError::text);
        // SAFETY: the caller's promise.
        match unsafe { put(words, text, bytes) } {
            true => VError::Success.number(),
            false => VError::ParamError.number(),
        }
    }

    /// The last failure of the lower layer. Calls no handler.
    ///
    /// # Safety
    /// Each pointer is null or points to a number.
    #[unsafe(no_mangle)]
    pub unsafe extern "C" fn V_GetLastError(
        routine: *mut c_int,
        error: *mut c_int,
        exterr: *mut c_int,
    ) -> c_int {
        guard(VError::Failed.number(), || {
            let last = session().errors.last_v.unwrap_or((0, VError::NoError.number()));
            // SAFETY: the caller's promise.
            unsafe {
                write(routine, last.0);
                write(error, last.1);
                write(exterr, 0);
            }
            VError::Success.number()
        })
    }

    /// Registers the upper layer's handler; null takes it away.
    #[unsafe(export_name = "redline_RegisterErrorHandler")]
    pub extern "C" fn VL_RegisterErrorHandler(handler: Option<Handler>) -> c_int {
        guard(VlError::Failed.number(), || {
            session().errors.vl = handler;
            VlError::Success.number()
        })
    }

    /// The upper layer's handler, or null.
    #[unsafe(export_name = "redline_GetErrorHandler")]
    pub extern "C" fn VL_GetErrorHandler() -> Option<Handler> {
        guard(None, || session().errors.vl)
    }

    /// The name of a function of the upper layer. Calls no handler.
    ///
    /// # Safety
    /// `text` is null or has room for `bytes` bytes.
    #[unsafe(export_name = "redline_GetFunctionName")]
    pub unsafe extern "C" fn VL_GetFunctionName(
        routine: c_int,
        text: *mut c_char,
        bytes: c_int,
    ) -> c_int {
        let name = VlRoutine::from_number(routine).map(VlRoutine::text);
        // SAFETY: the caller's promise.
        match unsafe { put(name, text, bytes) } {
            true => VlError::Success.number(),
            false => VlError::ParamError.number(),
        }
    }

    /// The text of an error of the upper layer. Calls no handler.
    ///
    /// # Safety
    /// `text` is null or has room for `bytes` bytes.
    #[unsafe(export_name = "redline_GetErrorText")]
    pub unsafe extern "C" fn VL_GetErrorText(
        error: c_int,
        text: *mut c_char,
        bytes: c_int,
    ) -> c_int {
        let words = VlError::from_number(error).map(VlError::text);
        // SAFETY: the caller's promise.
        match unsafe { put(words, text, bytes) } {
            true => VlError::Success.number(),
            false => VlError::ParamError.number(),
        }
    }

    /// The last failure of the upper layer, the error first. Calls no handler.
    ///
    /// # Safety
    /// Each pointer is null or points to a number.
    #[unsafe(export_name = "redline_GetLastError")]
    pub unsafe extern "C" fn VL_GetLastError(
        error: *mut c_int,
        routine: *mut c_int,
        exterr: *mut c_int,
    ) -> c_int {
        guard(VlError::Failed.number(), || {
            let last = session().errors.last_vl.unwrap_or((0, VlError::NoError.number()));
            // SAFETY: the caller's promise.
            unsafe {
                write(routine, last.0);
                write(error, last.1);
                write(exterr, 0);
            }
            VlError::Success.number()
        })
    }
}
