//! Engines that programs register.

use std::cell::Cell;
use std::ffi::{c_long, c_void};

use crate::layout::{Method, NOT_SUPPORTED, PARAM_ERR};

/// Methods of an engine.
pub const ENGINE_METHODS: usize = 18;

/// Places of engine methods, `TQAEngineMethodTag`.
#[derive(Clone, Copy)]
pub enum Tag {
    DrawPrivateNew = 0,
    DrawPrivateDelete = 1,
    CheckDevice = 2,
    Gestalt = 3,
    TextureNew = 4,
    TextureDetach = 5,
    TextureDelete = 6,
    BitmapNew = 7,
    BitmapDetach = 8,
    BitmapDelete = 9,
    ColorTableNew = 10,
    ColorTableDelete = 11,
    TextureBindColorTable = 12,
    BitmapBindColorTable = 13,
    AccessTexture = 14,
    AccessTextureEnd = 15,
    AccessBitmap = 16,
    AccessBitmapEnd = 17,
}

/// `TQAEngineGetMethod`.
pub type GetMethod = unsafe extern "C" fn(tag: i32, method: *mut Method) -> i32;

/// An engine of the program: its methods, asked for once.
#[derive(Clone, Copy)]
pub struct Engine {
    methods: [Method; ENGINE_METHODS],
    ref_con: c_long,
}

// SAFETY: functions do not belong to a thread.
unsafe impl Send for Engine {}

thread_local! {
    static REF_CON: Cell<c_long> = const { Cell::new(0) };
}

/// The number of the engine whose method runs on this thread.
pub fn current_ref_con() -> c_long {
    REF_CON.get()
}

/// Runs a method of an engine with its number in place.
fn with_ref_con<T>(ref_con: c_long, call: impl FnOnce() -> T) -> T {
    let before = REF_CON.replace(ref_con);
    let result = call();
    REF_CON.set(before);
    result
}

/// Engine methods by their signatures. A method that is missing is not
/// supported.
macro_rules! methods {
    ($($(#[$doc:meta])* $name:ident($($arg:ident: $type:ty),*) = $tag:ident $(-> $result:ty, $missing:expr)?;)*) => {
        impl Engine {$(
            $(#[$doc])*
            ///
            /// # Safety
            /// The arguments are what the engine expects.
            pub unsafe fn $name(&self, $($arg: $type),*) $(-> $result)? {
                let method = self.methods[Tag::$tag as usize];
                if method.is_null() {
                    return $($missing)?;
                }
                type Signature = unsafe extern "C" fn($($type),*) $(-> $result)?;
                // SAFETY: the engine handed it out under the tag of this signature.
                let method: Signature = unsafe { std::mem::transmute(method) };
                // SAFETY: the caller's promise.
                with_ref_con(self.ref_con, || unsafe { method($($arg),*) })
            }
        )*}
    };
}

methods! {
    /// Makes a draw context's private part and registers its methods.
    draw_private_new(
        context: *mut crate::layout::RawDrawContext, device: *const c_void, rect: *const c_void,
        clip: *const c_void, flags: u32
    ) = DrawPrivateNew -> i32, NOT_SUPPORTED;
    /// Deletes it.
    draw_private_delete(draw_private: *mut c_void) = DrawPrivateDelete;
    /// Whether the engine draws to a device.
    check_device(device: *const c_void) = CheckDevice -> i32, NOT_SUPPORTED;
    /// Answers a question about the engine.
    gestalt(selector: u32, response: *mut c_void) = Gestalt -> i32, NOT_SUPPORTED;
    /// Makes a texture.
    texture_new(flags: u32, pixel_type: u32, images: *const c_void, made: *mut *mut c_void)
        = TextureNew -> i32, NOT_SUPPORTED;
    /// Makes the engine's own copy.
    texture_detach(texture: *mut c_void) = TextureDetach -> i32, NOT_SUPPORTED;
    /// Deletes a texture.
    texture_delete(texture: *mut c_void) = TextureDelete;
    /// Makes a bitmap.
    bitmap_new(flags: u32, pixel_type: u32, image: *const c_void, made: *mut *mut c_void)
        = BitmapNew -> i32, NOT_SUPPORTED;
    /// Makes the engine's own copy.
    bitmap_detach(bitmap: *mut c_void) = BitmapDetach -> i32, NOT_SUPPORTED;
    /// Deletes a bitmap.
    bitmap_delete(bitmap: *mut c_void) = BitmapDelete;
    /// Makes a colour table.
    color_table_new(table_type: u32, data: *mut c_void, transparent: i32, made: *mut *mut c_void)
        = ColorTableNew -> i32, NOT_SUPPORTED;
    /// Deletes it.
    color_table_delete(table: *mut c_void) = ColorTableDelete;
    /// Binds a table to a texture.
    texture_bind_color_table(texture: *mut c_void, table: *mut c_void)
        = TextureBindColorTable -> i32, NOT_SUPPORTED;
    /// Binds a table to a bitmap.
    bitmap_bind_color_table(bitmap: *mut c_void, table: *mut c_void)
        = BitmapBindColorTable -> i32, NOT_SUPPORTED;
    /// Shows a texture's memory.
    access_texture(texture: *mut c_void, level: i32, flags: i32, buffer: *mut c_void)
        = AccessTexture -> i32, NOT_SUPPORTED;
    /// Ends it.
    access_texture_end(texture: *mut c_void, dirty: *const c_void)
        = AccessTextureEnd -> i32, NOT_SUPPORTED;
    /// Shows a bitmap's memory.
    access_bitmap(bitmap: *mut c_void, flags: i32, buffer: *mut c_void)
        = AccessBitmap -> i32, NOT_SUPPORTED;
    /// Ends it.
    access_bitmap_end(bitmap: *mut c_void, dirty: *const c_void)
        = AccessBitmapEnd -> i32, NOT_SUPPORTED;
}

impl Engine {
    /// Asks for all methods.
    ///
    /// # Safety
    /// `get_method` is an engine's.
    ///
    /// # Errors
    /// `kQAParamErr` where the engine lacks what all engines have.
    pub unsafe fn ask(get_method: GetMethod, ref_con: c_long) -> Result<Engine, i32> {
        let mut methods = [std::ptr::null(); ENGINE_METHODS];
        with_ref_con(ref_con, || {
            for (tag, slot) in methods.iter_mut().enumerate() {
                let mut method = std::ptr::null();
                // SAFETY: the caller's promise; a union of functions is one.
                if unsafe { get_method(tag as i32, &mut method) } == 0 {
                    *slot = method;
                }
            }
        });
        let required =
            [Tag::DrawPrivateNew, Tag::DrawPrivateDelete, Tag::CheckDevice, Tag::Gestalt];
        if required.into_iter().any(|tag| methods[tag as usize].is_null()) {
            return Err(PARAM_ERR);
        }
        Ok(Engine { methods, ref_con })
    }

    /// A number that the engine answers with; 0 where it knows none.
    pub fn number(&self, selector: u32) -> u32 {
        // Room for engines that answer with the host's `unsigned long`.
        let mut answer = [0u32; 4];
        // SAFETY: the answers to these selectors are numbers.
        let status = unsafe { self.gestalt(selector, answer.as_mut_ptr().cast()) };
        if status == 0 { answer[0] } else { 0 }
    }
}
