//! The drawing calls as functions, for programs that undefine the macros: each
//! goes through the context's methods, as the macro does.

use std::ffi::c_void;

use fillrate_guard::guard;

use crate::layout::{Method, NOT_SUPPORTED, RawDrawContext, RawMemory, RawRect, RawZBuffer};
use crate::session::session;

/// A method of a context of ours, of whichever engine; `None` for others.
fn method(context: *const RawDrawContext, slot: usize) -> Option<Method> {
    guard(None, || {
        let address = context as usize;
        let session = session();
        let is_ours =
            session.contexts.contains_key(&address) || session.foreign.contains_key(&address);
        // SAFETY: a context of ours.
        is_ours.then(|| unsafe { (*context).methods[slot] })
    })
}

macro_rules! exports {
    ($($slot:literal $name:ident($($arg:ident: $type:ty),*) $(-> $result:ty, $missing:expr)?;)*) => {$(
        #[doc = concat!("The context's method ", $slot, ".")]
        ///
        /// # Safety
        /// The arguments are as the method expects them.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $name(
            context: *const RawDrawContext, $($arg: $type),*
        ) $(-> $result)? {
            let Some(method) = method(context, $slot) else { return $($missing)? };
            type Signature =
                unsafe extern "C" fn(*const RawDrawContext, $($type),*) $(-> $result)?;
            // SAFETY: registered for the tag of this signature.
            let method: Signature = unsafe { std::mem::transmute(method) };
            // SAFETY: the caller's promise.
            unsafe { method(context, $($arg),*) }
        }
    )*};
}

type Gouraud = *const [f32; 8];
type Texture = *const [f32; 16];
type Triangles = *const [u32; 4];

exports! {
    0 QASetFloat(tag: u32, value: f32);
    1 QASetInt(tag: u32, value: u32);
    2 QASetPtr(tag: u32, value: *const c_void);
    3 QAGetFloat(tag: u32) -> f32, 0.0;
    4 QAGetInt(tag: u32) -> u32, 0;
    5 QAGetPtr(tag: u32) -> *mut c_void, std::ptr::null_mut();
    6 QADrawPoint(v: Gouraud);
    7 QADrawLine(a: Gouraud, b: Gouraud);
    8 QADrawTriGouraud(a: Gouraud, b: Gouraud, c: Gouraud, flags: u32);
    9 QADrawTriTexture(a: Texture, b: Texture, c: Texture, flags: u32);
    10 QADrawVGouraud(count: u32, mode: u32, vertices: Gouraud, flags: *const u32);
    11 QADrawVTexture(count: u32, mode: u32, vertices: Texture, flags: *const u32);
    12 QADrawBitmap(v: Gouraud, bitmap: *const c_void);
    13 QARenderStart(dirty: *const RawRect, initial: *const RawDrawContext);
    14 QARenderEnd(modified: *const RawRect) -> i32, NOT_SUPPORTED;
    15 QARenderAbort() -> i32, NOT_SUPPORTED;
    16 QAFlush() -> i32, NOT_SUPPORTED;
    17 QASync() -> i32, NOT_SUPPORTED;
    18 QASubmitVerticesGouraud(count: u32, vertices: Gouraud);
    19 QASubmitVerticesTexture(count: u32, vertices: Texture);
    20 QADrawTriMeshGouraud(count: u32, triangles: Triangles);
    21 QADrawTriMeshTexture(count: u32, triangles: Triangles);
    22 QASetNoticeMethod(selector: i32, method: Method, ref_con: *mut c_void) -> i32, NOT_SUPPORTED;
    23 QAGetNoticeMethod(selector: i32, method: *mut Method, ref_con: *mut *mut c_void)
        -> i32, NOT_SUPPORTED;
    24 QASubmitMultiTextureParams(count: u32, params: *const [f32; 3]);
    25 QAAccessDrawBuffer(buffer: *mut RawMemory) -> i32, NOT_SUPPORTED;
    26 QAAccessDrawBufferEnd(dirty: *const RawRect) -> i32, NOT_SUPPORTED;
    27 QAAccessZBuffer(buffer: *mut RawZBuffer) -> i32, NOT_SUPPORTED;
    28 QAAccessZBufferEnd(dirty: *const RawRect) -> i32, NOT_SUPPORTED;
    29 QAClearDrawBuffer(rect: *const RawRect, initial: *const RawDrawContext)
        -> i32, NOT_SUPPORTED;
    30 QAClearZBuffer(rect: *const RawRect, initial: *const RawDrawContext) -> i32, NOT_SUPPORTED;
    31 QATextureNewFromDrawContext(flags: u32, made: *mut *mut c_void) -> i32, NOT_SUPPORTED;
    32 QABitmapNewFromDrawContext(flags: u32, made: *mut *mut c_void) -> i32, NOT_SUPPORTED;
    33 QABusy() -> u8, 0;
    34 QASwapBuffers(dirty: *const RawRect) -> i32, NOT_SUPPORTED;
}
