//! Access to buffers, textures and bitmaps: copies that the program writes into,
//! taken over when it is done. Clears, and pictures of draw contexts.

use std::ffi::c_void;

use fillrate_guard::{guard, write};
use fillrate_rave::{BitmapId, Call, DrawContextId, PixelType, RaveRect, Reply, Shown, TextureId};

use crate::draw::{context_number, on};
use crate::layout::{PARAM_ERR, RawDrawContext, RawMemory, RawRect, RawZBuffer, value};
use crate::manager::Who;
use crate::order::Order;
use crate::session::{Session, as_pointer, number_of, session};

/// `kQAError`.
const ERROR: i32 = 1;

/// A copy of pixels that the program holds a pointer to.
pub struct Staging {
    block: *mut [u8],
    width: u32,
    height: u32,
    /// Bits of an element.
    bits: u32,
    /// Bytes of a row.
    row: usize,
    order: Order,
}

// SAFETY: the block is the staging's own.
unsafe impl Send for Staging {}

impl Drop for Staging {
    fn drop(&mut self) {
        // SAFETY: made of a box, and freed once.
        drop(unsafe { Box::from_raw(self.block) });
    }
}

impl Staging {
    /// A copy of rows without padding, as calls carry them.
    fn new(mut bytes: Vec<u8>, size: [u32; 2], bits: u32, order: Order) -> Staging {
        order.turn(&mut bytes);
        let [width, height] = size;
        let row = bytes.len() / (height as usize).max(1);
        let block = Box::into_raw(bytes.into_boxed_slice());
        Staging { block, width, height, bits, row, order }
    }

    fn of(shown: Shown) -> Staging {
        let order = Order::of_buffers(shown.pixel_type);
        let size = [shown.width, shown.height];
        Staging::new(shown.pixels, size, shown.pixel_type.bits(), order)
    }

    fn base(&self) -> *mut u8 {
        self.block.cast()
    }

    /// The rectangle of whole bytes around one, and its rows; all for `None`.
    fn take(&self, rect: Option<RaveRect>) -> (RaveRect, Vec<u8>) {
        let all = RaveRect::new(0, 0, self.width as i32, self.height as i32);
        let mut rect = rect.unwrap_or(all).intersect(&all);
        if self.bits < 8 || !self.row.is_multiple_of(self.width.max(1) as usize) {
            // Pixels share bytes: whole rows.
            (rect.left, rect.right) = (all.left, all.right);
        }
        if rect.is_empty() {
            return (RaveRect::default(), Vec::new());
        }
        let whole = (rect.left, rect.right) == (all.left, all.right);
        let bytes = self.bits as usize / 8;
        let (first, count) = match whole {
            true => (0, self.row),
            false => (rect.left as usize * bytes, rect.width() as usize * bytes),
        };
        let mut rows = Vec::with_capacity(count * rect.height() as usize);
        for y in rect.top as usize..rect.bottom as usize {
            // SAFETY: the block holds all rows.
            let row =
                unsafe { std::slice::from_raw_parts(self.base().add(y * self.row + first), count) };
            rows.extend_from_slice(row);
        }
        self.order.turn(&mut rows);
        (rect, rows)
    }

    fn memory(&self, pixel_type: PixelType) -> RawMemory {
        RawMemory {
            row_bytes: self.row as i32,
            pixel_type: pixel_type.number(),
            width: self.width as i32,
            height: self.height as i32,
            base: self.base(),
        }
    }
}

/// `QAAccessDrawBuffer`.
///
/// # Safety
/// `buffer` is null or can be written.
pub unsafe extern "C" fn access_draw_buffer(
    context: *const RawDrawContext,
    buffer: *mut RawMemory,
) -> i32 {
    let address = context as usize;
    on(context, PARAM_ERR, |session, number| {
        if buffer.is_null() {
            return PARAM_ERR;
        }
        let status = session.call(&Call::AccessDrawBuffer { context: number }).number();
        if status != 0 {
            return status;
        }
        let Some(shown) = session.context.draw_buffer(DrawContextId(number)) else { return ERROR };
        let pixel_type = shown.pixel_type;
        let staging = Staging::of(shown);
        // SAFETY: the caller's promise.
        unsafe { write(buffer, staging.memory(pixel_type)) };
        if let Some(known) = session.contexts.get_mut(&address) {
            known.draw_access = Some(staging);
        }
        0
    })
}

/// `QAAccessDrawBufferEnd`.
///
/// # Safety
/// `dirty` is null or can be read.
pub unsafe extern "C" fn access_draw_buffer_end(
    context: *const RawDrawContext,
    dirty: *const RawRect,
) -> i32 {
    let address = context as usize;
    on(context, PARAM_ERR, |session, number| {
        // SAFETY: the caller's promise.
        let dirty = unsafe { value::<RaveRect>(dirty) };
        let known = session.contexts.get_mut(&address);
        let Some(staging) = known.and_then(|known| known.draw_access.take()) else { return ERROR };
        let (rect, pixels) = staging.take(dirty);
        let pixels = pixels.into();
        session.call(&Call::AccessDrawBufferEnd { context: number, rect, pixels }).number()
    })
}

/// `QAAccessZBuffer`.
///
/// # Safety
/// `buffer` is null or can be written.
pub unsafe extern "C" fn access_z_buffer(
    context: *const RawDrawContext,
    buffer: *mut RawZBuffer,
) -> i32 {
    let address = context as usize;
    on(context, PARAM_ERR, |session, number| {
        if buffer.is_null() {
            return PARAM_ERR;
        }
        let status = session.call(&Call::AccessZBuffer { context: number }).number();
        if status != 0 {
            return status;
        }
        let Some(depths) = session.context.z_buffer(DrawContextId(number)) else { return ERROR };
        let row = depths.width as usize * depths.depth as usize / 8;
        let size = [depths.width, depths.height];
        let order = Order::of_depths(depths.depth);
        let staging = Staging::new(depths.elements, size, depths.depth, order);
        let raw = RawZBuffer {
            width: size[0] as i32,
            height: size[1] as i32,
            row_bytes: row as i32,
            zbuffer: staging.base(),
            z_depth: depths.depth as i32,
            is_big_endian: order.is_big_endian().into(),
        };
        // SAFETY: the caller's promise.
        unsafe { write(buffer, raw) };
        if let Some(known) = session.contexts.get_mut(&address) {
            known.z_access = Some(staging);
        }
        0
    })
}

/// `QAAccessZBufferEnd`.
///
/// # Safety
/// `dirty` is null or can be read.
pub unsafe extern "C" fn access_z_buffer_end(
    context: *const RawDrawContext,
    dirty: *const RawRect,
) -> i32 {
    let address = context as usize;
    on(context, PARAM_ERR, |session, number| {
        // SAFETY: the caller's promise.
        let dirty = unsafe { value::<RaveRect>(dirty) };
        let known = session.contexts.get_mut(&address);
        let Some(staging) = known.and_then(|known| known.z_access.take()) else { return ERROR };
        let (rect, depths) = staging.take(dirty);
        let depths = depths.into();
        session.call(&Call::AccessZBufferEnd { context: number, rect, depths }).number()
    })
}

/// `QAClearDrawBuffer`.
///
/// # Safety
/// `rect` is null or can be read.
pub unsafe extern "C" fn clear_draw_buffer(
    context: *const RawDrawContext,
    rect: *const RawRect,
    initial: *const RawDrawContext,
) -> i32 {
    on(context, PARAM_ERR, |session, context| {
        // SAFETY: the caller's promise.
        let rect = unsafe { value(rect) };
        let initial = context_number(session, initial);
        session.call(&Call::ClearDrawBuffer { context, rect, initial }).number()
    })
}

/// `QAClearZBuffer`.
///
/// # Safety
/// `rect` is null or can be read.
pub unsafe extern "C" fn clear_z_buffer(
    context: *const RawDrawContext,
    rect: *const RawRect,
    initial: *const RawDrawContext,
) -> i32 {
    on(context, PARAM_ERR, |session, context| {
        // SAFETY: the caller's promise.
        let rect = unsafe { value(rect) };
        let initial = context_number(session, initial);
        session.call(&Call::ClearZBuffer { context, rect, initial }).number()
    })
}

/// Hands the number of a new object out.
///
/// # Safety
/// `made` can be written.
pub unsafe fn hand_out(reply: &Reply, made: *mut *mut c_void) -> i32 {
    // SAFETY: the caller's promise.
    unsafe { write(made, as_pointer(reply.created())) };
    reply.number()
}

/// Makes an object of a context's pixels.
///
/// # Safety
/// `made` is null or can be written.
unsafe fn from_context(
    context: *const RawDrawContext,
    made: *mut *mut c_void,
    call: impl FnOnce(u32) -> Call,
) -> i32 {
    // SAFETY: the caller's promise.
    unsafe { write(made, std::ptr::null_mut()) };
    on(context, PARAM_ERR, |session, number| {
        if made.is_null() {
            return PARAM_ERR;
        }
        let reply = session.call(&call(number));
        // SAFETY: the caller's promise.
        unsafe { hand_out(&reply, made) }
    })
}

/// `QATextureNewFromDrawContext`.
///
/// # Safety
/// `made` is null or can be written.
pub unsafe extern "C" fn texture_from_context(
    context: *const RawDrawContext,
    flags: u32,
    made: *mut *mut c_void,
) -> i32 {
    // SAFETY: the caller's promise.
    unsafe { from_context(context, made, |context| Call::TextureFromContext { context, flags }) }
}

/// `QABitmapNewFromDrawContext`.
///
/// # Safety
/// `made` is null or can be written.
pub unsafe extern "C" fn bitmap_from_context(
    context: *const RawDrawContext,
    flags: u32,
    made: *mut *mut c_void,
) -> i32 {
    // SAFETY: the caller's promise.
    unsafe { from_context(context, made, |context| Call::BitmapFromContext { context, flags }) }
}

impl Session {
    /// Shows a picture's memory to the program.
    fn open_picture(
        &mut self,
        (is_bitmap, number): (bool, u32),
        call: &Call,
    ) -> Result<RawMemory, i32> {
        let status = self.call(call).number();
        if status != 0 {
            return Err(status);
        }
        let opened = match is_bitmap {
            true => self.context.accessed_bitmap(BitmapId(number)),
            false => self.context.accessed_texture(TextureId(number)),
        };
        let (pixel_type, image) = opened.ok_or(ERROR)?;
        let (width, height) = (image.width as u32, image.height as u32);
        // Pixels that the program gave may be followed by others.
        let bytes = pixel_type.row_bytes(width) * height as usize;
        let pixels = image.pixels[..bytes].to_vec();
        let order = Order::of_pictures(pixel_type);
        let staging = Staging::new(pixels, [width, height], pixel_type.bits(), order);
        let memory = staging.memory(pixel_type);
        self.accesses.insert((is_bitmap, number), staging);
        Ok(memory)
    }
}

/// Shows a level of a texture in memory.
///
/// # Safety
/// `buffer` is null or can be written.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn QAAccessTexture(
    engine: *const c_void,
    texture: *mut c_void,
    level: i32,
    flags: i32,
    buffer: *mut RawMemory,
) -> i32 {
    guard(ERROR, || {
        let Some(who) = session().engine(engine).filter(|_| !buffer.is_null()) else {
            return PARAM_ERR;
        };
        let number = number_of(texture);
        match who {
            Who::Program(engine) => {
                // SAFETY: the caller's promise.
                unsafe { engine.access_texture(texture, level, flags, buffer.cast()) }
            }
            Who::BuiltIn => {
                let call = Call::AccessTexture {
                    engine: number_of(engine),
                    texture: number,
                    level,
                    flags,
                };
                let opened = session().open_picture((false, number), &call);
                // SAFETY: the caller's promise.
                opened.map(|memory| unsafe { write(buffer, memory) }).err().unwrap_or(0)
            }
        }
    })
}

/// Takes over what was written.
///
/// # Safety
/// `dirty` is null or can be read.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn QAAccessTextureEnd(
    engine: *const c_void,
    texture: *mut c_void,
    dirty: *const RawRect,
) -> i32 {
    guard(ERROR, || {
        let Some(who) = session().engine(engine) else { return PARAM_ERR };
        let number = number_of(texture);
        match who {
            // SAFETY: the caller's promise.
            Who::Program(engine) => unsafe { engine.access_texture_end(texture, dirty.cast()) },
            Who::BuiltIn => {
                let mut session = session();
                let staging = session.accesses.remove(&(false, number));
                let Some(staging) = staging else { return ERROR };
                // SAFETY: the caller's promise.
                let (rect, pixels) = staging.take(unsafe { value(dirty) });
                let pixels = pixels.into();
                let engine = number_of(engine);
                let call = Call::AccessTextureEnd { engine, texture: number, rect, pixels };
                session.call(&call).number()
            }
        }
    })
}

/// Shows a bitmap in memory.
///
/// # Safety
/// `buffer` is null or can be written.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn QAAccessBitmap(
    engine: *const c_void,
    bitmap: *mut c_void,
    flags: i32,
    buffer: *mut RawMemory,
) -> i32 {
    guard(ERROR, || {
        let Some(who) = session().engine(engine).filter(|_| !buffer.is_null()) else {
            return PARAM_ERR;
        };
        let number = number_of(bitmap);
        match who {
            // SAFETY: the caller's promise.
            Who::Program(engine) => unsafe { engine.access_bitmap(bitmap, flags, buffer.cast()) },
            Who::BuiltIn => {
                let call = Call::AccessBitmap { engine: number_of(engine), bitmap: number, flags };
                let opened = session().open_picture((true, number), &call);
                // SAFETY: the caller's promise.
                opened.map(|memory| unsafe { write(buffer, memory) }).err().unwrap_or(0)
            }
        }
    })
}

/// Takes over what was written.
///
/// # Safety
/// `dirty` is null or can be read.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn QAAccessBitmapEnd(
    engine: *const c_void,
    bitmap: *mut c_void,
    dirty: *const RawRect,
) -> i32 {
    guard(ERROR, || {
        let Some(who) = session().engine(engine) else { return PARAM_ERR };
        let number = number_of(bitmap);
        match who {
            // SAFETY: the caller's promise.
            Who::Program(engine) => unsafe { engine.access_bitmap_end(bitmap, dirty.cast()) },
            Who::BuiltIn => {
                let mut session = session();
                let Some(staging) = session.accesses.remove(&(true, number)) else { return ERROR };
                // SAFETY: the caller's promise.
                let (rect, pixels) = staging.take(unsafe { value(dirty) });
                let pixels = pixels.into();
                let engine = number_of(engine);
                let call = Call::AccessBitmapEnd { engine, bitmap: number, rect, pixels };
                session.call(&call).number()
            }
        }
    })
}
