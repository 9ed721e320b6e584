//! Textures, bitmaps and colour tables of any engine.

use std::ffi::c_void;

use fillrate_guard::{bytes, guard, read, write};
use fillrate_rave::{Call, ImageValue, constants};

use crate::access::hand_out;
use crate::layout::{PARAM_ERR, RawImage, image, image_chain};
use crate::manager::Who;
use crate::order::Order;
use crate::session::{LentPicture, Session, number_of, session};

/// `kQAError`.
const ERROR: i32 = 1;

/// Makes a texture.
///
/// # Safety
/// The images are as declared: one, or a chain with the flag Mipmap.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn QATextureNew(
    engine: *const c_void,
    flags: u32,
    pixel_type: u32,
    images: *const RawImage,
    made: *mut *mut c_void,
) -> i32 {
    guard(ERROR, || {
        // SAFETY: the caller's promise.
        unsafe { write(made, std::ptr::null_mut()) };
        let who = session().engine(engine).filter(|_| !made.is_null() && !images.is_null());
        match who {
            None => PARAM_ERR,
            Some(Who::Program(engine)) => {
                // SAFETY: the caller's promise.
                unsafe { engine.texture_new(flags, pixel_type, images.cast(), made) }
            }
            Some(Who::BuiltIn) => {
                let is_mipmapped = flags & constants::texture::MIPMAP != 0;
                // SAFETY: the caller's promise.
                let raw = unsafe { image_chain(images, is_mipmapped) };
                // SAFETY: the caller's promise.
                let images: Vec<ImageValue> =
                    raw.iter().map(|raw| unsafe { image(pixel_type, raw) }).collect();
                let mut session = session();
                let engine = number_of(engine);
                let call = Call::TextureNew { engine, flags, pixel_type, images: images.clone() };
                let reply = session.call(&call);
                let number = reply.created();
                session.lend(number, false, flags, pixel_type, raw, images);
                // SAFETY: the caller's promise.
                unsafe { hand_out(&reply, made) }
            }
        }
    })
}

/// Makes a bitmap.
///
/// # Safety
/// The image is as declared.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn QABitmapNew(
    engine: *const c_void,
    flags: u32,
    pixel_type: u32,
    picture: *const RawImage,
    made: *mut *mut c_void,
) -> i32 {
    guard(ERROR, || {
        // SAFETY: the caller's promise.
        unsafe { write(made, std::ptr::null_mut()) };
        // SAFETY: the caller's promise.
        let Some(raw) = (unsafe { read(picture) }) else { return PARAM_ERR };
        let who = session().engine(engine).filter(|_| !made.is_null());
        match who {
            None => PARAM_ERR,
            Some(Who::Program(engine)) => {
                // SAFETY: the caller's promise.
                unsafe { engine.bitmap_new(flags, pixel_type, picture.cast(), made) }
            }
            Some(Who::BuiltIn) => {
                // SAFETY: the caller's promise.
                let image = unsafe { image(pixel_type, &raw) };
                let mut session = session();
                let engine = number_of(engine);
                let call = Call::BitmapNew { engine, flags, pixel_type, image: image.clone() };
                let reply = session.call(&call);
                session.lend(reply.created(), true, flags, pixel_type, vec![raw], vec![image]);
                // SAFETY: the caller's promise.
                unsafe { hand_out(&reply, made) }
            }
        }
    })
}

impl Session {
    /// Remembers a picture whose memory stays the program's (NoCopy).
    fn lend(
        &mut self,
        number: u32,
        is_bitmap: bool,
        flags: u32,
        pixel_type: u32,
        images: Vec<RawImage>,
        sent: Vec<ImageValue>,
    ) {
        if number != 0 && flags & constants::texture::NO_COPY != 0 {
            self.lent.push(LentPicture { number, is_bitmap, flags, pixel_type, images, sent });
        }
    }

    /// Tells the library what changed in lent pictures.
    ///
    /// # Safety
    /// Their memory is as it was lent.
    pub unsafe fn send_lent_pictures(&mut self) {
        for at in 0..self.lent.len() {
            // SAFETY: the caller's promise.
            unsafe { self.send_lent(at) };
        }
    }

    /// # Safety
    /// As [`Session::send_lent_pictures`].
    unsafe fn send_lent(&mut self, at: usize) {
        let lent = &mut self.lent[at];
        // SAFETY: the caller's promise.
        let now: Vec<ImageValue> =
            lent.images.iter().map(|raw| unsafe { image(lent.pixel_type, raw) }).collect();
        if now == lent.sent {
            return;
        }
        lent.sent.clone_from(&now);
        let engine = fillrate_rave::EngineId::BUILT_IN.0;
        let (number, flags, pixel_type) = (lent.number, lent.flags, lent.pixel_type);
        let call = match (lent.is_bitmap, now.into_iter().next()) {
            (true, Some(image)) => Call::BitmapUpdate { engine, bitmap: number, image },
            _ => {
                let images = lent.sent.clone();
                Call::TextureUpdate { engine, texture: number, flags, pixel_type, images }
            }
        };
        self.call(&call);
    }

    /// Ends the loan of a picture; `keeps` what is there now.
    ///
    /// # Safety
    /// Where `keeps` is set, its memory is as it was lent.
    unsafe fn end_loan(&mut self, number: u32, is_bitmap: bool, keeps: bool) {
        let is_it = |lent: &LentPicture| (lent.number, lent.is_bitmap) == (number, is_bitmap);
        if let Some(at) = self.lent.iter().position(is_it) {
            if keeps {
                // SAFETY: the caller's promise.
                unsafe { self.send_lent(at) };
            }
            self.lent.swap_remove(at);
        }
    }
}

/// Lets the program free a texture's memory.
///
/// # Safety
/// The texture is the engine's, and its memory is as it was lent.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn QATextureDetach(engine: *const c_void, texture: *mut c_void) -> i32 {
    guard(ERROR, || {
        let Some(who) = session().engine(engine) else { return PARAM_ERR };
        match who {
            // SAFETY: the caller's promise.
            Who::Program(engine) => unsafe { engine.texture_detach(texture) },
            Who::BuiltIn => {
                let (mut session, number) = (session(), number_of(texture));
                // SAFETY: the caller's promise.
                unsafe { session.end_loan(number, false, true) };
                let call = Call::TextureDetach { engine: number_of(engine), texture: number };
                session.call(&call).number()
            }
        }
    })
}

/// Deletes a texture, once what was drawn with it is drawn.
///
/// # Safety
/// The texture is the engine's.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn QATextureDelete(engine: *const c_void, texture: *mut c_void) {
    guard((), || {
        let Some(who) = session().engine(engine) else { return };
        match who {
            // SAFETY: the caller's promise.
            Who::Program(engine) => unsafe { engine.texture_delete(texture) },
            Who::BuiltIn => {
                let (mut session, number) = (session(), number_of(texture));
                // SAFETY: nothing is read.
                unsafe { session.end_loan(number, false, false) };
                session.accesses.remove(&(false, number));
                session.call(&Call::TextureDelete { engine: number_of(engine), texture: number });
            }
        }
    });
}

/// Lets the program free a bitmap's memory.
///
/// # Safety
/// The bitmap is the engine's, and its memory is as it was lent.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn QABitmapDetach(engine: *const c_void, bitmap: *mut c_void) -> i32 {
    guard(ERROR, || {
        let Some(who) = session().engine(engine) else { return PARAM_ERR };
        match who {
            // SAFETY: the caller's promise.
            Who::Program(engine) => unsafe { engine.bitmap_detach(bitmap) },
            Who::BuiltIn => {
                let (mut session, number) = (session(), number_of(bitmap));
                // SAFETY: the caller's promise.
                unsafe { session.end_loan(number, true, true) };
                let call = Call::BitmapDetach { engine: number_of(engine), bitmap: number };
                session.call(&call).number()
            }
        }
    })
}

/// Deletes a bitmap, once it is drawn.
///
/// # Safety
/// The bitmap is the engine's.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn QABitmapDelete(engine: *const c_void, bitmap: *mut c_void) {
    guard((), || {
        let Some(who) = session().engine(engine) else { return };
        match who {
            // SAFETY: the caller's promise.
            Who::Program(engine) => unsafe { engine.bitmap_delete(bitmap) },
            Who::BuiltIn => {
                let (mut session, number) = (session(), number_of(bitmap));
                // SAFETY: nothing is read.
                unsafe { session.end_loan(number, true, false) };
                session.accesses.remove(&(true, number));
                session.call(&Call::BitmapDelete { engine: number_of(engine), bitmap: number });
            }
        }
    });
}

/// Makes a colour table; the entries are copied.
///
/// # Safety
/// `data` holds as many entries as the type has.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn QAColorTableNew(
    engine: *const c_void,
    table_type: u32,
    data: *mut c_void,
    transparent: i32,
    made: *mut *mut c_void,
) -> i32 {
    guard(ERROR, || {
        // SAFETY: the caller's promise.
        unsafe { write(made, std::ptr::null_mut()) };
        let who = session().engine(engine).filter(|_| !made.is_null() && !data.is_null());
        match who {
            None => PARAM_ERR,
            Some(Who::Program(engine)) => {
                // SAFETY: the caller's promise.
                unsafe { engine.color_table_new(table_type, data, transparent, made) }
            }
            Some(Who::BuiltIn) => {
                let count = match table_type {
                    constants::color_table::CL8_RGB32 => 256,
                    constants::color_table::CL4_RGB32 => 16,
                    _ => return PARAM_ERR,
                };
                // SAFETY: the caller's promise.
                let mut entries = unsafe { bytes(data.cast(), 4 * count) }.to_vec();
                Order::of_tables().turn(&mut entries);
                let call = Call::ColorTableNew {
                    engine: number_of(engine),
                    table_type,
                    entries: entries.into(),
                    transparent_index: transparent,
                };
                let reply = session().call(&call);
                // SAFETY: the caller's promise.
                unsafe { hand_out(&reply, made) }
            }
        }
    })
}

/// Deletes a colour table.
///
/// # Safety
/// The table is the engine's.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn QAColorTableDelete(engine: *const c_void, table: *mut c_void) {
    guard((), || {
        let Some(who) = session().engine(engine) else { return };
        match who {
            // SAFETY: the caller's promise.
            Who::Program(engine) => unsafe { engine.color_table_delete(table) },
            Who::BuiltIn => {
                let (engine, table) = (number_of(engine), number_of(table));
                session().call(&Call::ColorTableDelete { engine, table });
            }
        }
    });
}

/// Binds a colour table to a texture.
///
/// # Safety
/// Both are the engine's.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn QATextureBindColorTable(
    engine: *const c_void,
    texture: *mut c_void,
    table: *mut c_void,
) -> i32 {
    guard(ERROR, || {
        let Some(who) = session().engine(engine) else { return PARAM_ERR };
        match who {
            // SAFETY: the caller's promise.
            Who::Program(engine) => unsafe { engine.texture_bind_color_table(texture, table) },
            Who::BuiltIn => {
                let [engine, texture, table] = [engine, texture, table].map(number_of);
                session().call(&Call::TextureBindColorTable { engine, texture, table }).number()
            }
        }
    })
}

/// Binds a colour table to a bitmap.
///
/// # Safety
/// Both are the engine's.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn QABitmapBindColorTable(
    engine: *const c_void,
    bitmap: *mut c_void,
    table: *mut c_void,
) -> i32 {
    guard(ERROR, || {
        let Some(who) = session().engine(engine) else { return PARAM_ERR };
        match who {
            // SAFETY: the caller's promise.
            Who::Program(engine) => unsafe { engine.bitmap_bind_color_table(bitmap, table) },
            Who::BuiltIn => {
                let [engine, bitmap, table] = [engine, bitmap, table].map(number_of);
                session().call(&Call::BitmapBindColorTable { engine, bitmap, table }).number()
            }
        }
    })
}
