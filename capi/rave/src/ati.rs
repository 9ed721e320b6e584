//! What programs use of ATI's extension, for `RAVE_ati.h`.

use std::ffi::c_void;

use fillrate_guard::{guard, read, write};
use fillrate_rave::{Call, EngineId, ImageValue, constants};

use crate::access::{clear_draw_buffer, clear_z_buffer};
use crate::draw::on;
use crate::layout::{
    Method, NOT_SUPPORTED, PARAM_ERR, RawDevice, RawDrawContext, RawImage, RawRect, image,
    image_chain, read_device,
};
use crate::session::{number_of, session};

/// `kATIGestalt_CurrentContext`.
pub const CURRENT_CONTEXT: u32 = 1000;

/// Entries of the table: the five that are known, and refusals where later
/// tables have more.
const ENTRIES: usize = 65;

/// A table of functions that never changes.
struct Table([Method; ENTRIES]);

// SAFETY: functions do not belong to a thread.
unsafe impl Sync for Table {}

static TABLE: Table = Table({
    let mut table = [refuse as Method; ENTRIES];
    table[0] = clear_draw as Method;
    table[1] = clear_z as Method;
    table[2] = texture_update as Method;
    table[4] = get_draw_buffer as Method;
    table
});

/// The table of `kATIRaveExtFuncs`.
pub fn functions() -> *mut c_void {
    (&raw const TABLE.0).cast_mut().cast()
}

extern "C" fn refuse() -> i32 {
    NOT_SUPPORTED
}

unsafe extern "C" fn clear_draw(context: *const RawDrawContext, rect: *const RawRect) -> i32 {
    // SAFETY: the caller's promise.
    unsafe { clear_draw_buffer(context, rect, std::ptr::null()) }
}

unsafe extern "C" fn clear_z(context: *const RawDrawContext, rect: *const RawRect) -> i32 {
    // SAFETY: the caller's promise.
    unsafe { clear_z_buffer(context, rect, std::ptr::null()) }
}

unsafe extern "C" fn texture_update(
    flags: u32,
    pixel_type: u32,
    images: *const RawImage,
    texture: *const c_void,
) -> i32 {
    guard(PARAM_ERR, || {
        // SAFETY: the caller's promise.
        let raw = unsafe { image_chain(images, flags & constants::texture::MIPMAP != 0) };
        // SAFETY: the caller's promise.
        let images: Vec<ImageValue> =
            raw.iter().map(|raw| unsafe { image(pixel_type, raw) }).collect();
        let (engine, texture) = (EngineId::BUILT_IN.0, number_of(texture));
        session().call(&Call::TextureUpdate { engine, texture, flags, pixel_type, images }).number()
    })
}

/// The program's memory of the context: what the next frame is shown in.
unsafe extern "C" fn get_draw_buffer(
    context: *const RawDrawContext,
    device: *mut RawDevice,
) -> i32 {
    let address = context as usize;
    on(context, PARAM_ERR, |session, _| {
        let memory = session.contexts.get(&address).and_then(|known| known.device);
        let Some(memory) = memory.filter(|_| !device.is_null()) else { return PARAM_ERR };
        // SAFETY: the caller's promise.
        unsafe { write(device, RawDevice { device_type: constants::device::MEMORY, memory }) };
        0
    })
}

/// Replaces the address of a device by that of the draw context on it.
///
/// # Safety
/// `response` can be read and written, and holds null or the address of a device.
pub unsafe fn current_context(response: *mut *const RawDevice) -> i32 {
    // SAFETY: the caller's promise.
    let asked = unsafe { read(response) }.unwrap_or(std::ptr::null());
    // SAFETY: the caller's promise.
    let device = unsafe { read_device(asked) };
    let base = device.map(|device| device.memory.base);
    let session = session();
    let draws_there = |base: *mut u8| {
        let mut contexts = session.contexts.iter();
        let is_there = |device: crate::layout::RawMemory| device.base == base;
        contexts.find(|(_, known)| known.device.is_some_and(is_there)).map(|(&address, _)| address)
    };
    let found = base.filter(|base| !base.is_null()).and_then(draws_there);
    // SAFETY: the caller's promise.
    unsafe { write(response, found.unwrap_or(0) as *const RawDevice) };
    0
}
