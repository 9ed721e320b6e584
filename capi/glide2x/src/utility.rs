//! The utility library's parts that need no board, and what is still to come.

use std::collections::BTreeSet;
use std::sync::{Mutex, PoisonError};

use fillrate_glide::gu;
use fillrate_guard::{guard, write};

/// Says once that an entry point does nothing yet.
pub(crate) fn unsupported(function: &'static str) {
    static TOLD: Mutex<BTreeSet<&'static str>> = Mutex::new(BTreeSet::new());
    if TOLD.lock().unwrap_or_else(PoisonError::into_inner).insert(function) {
        eprintln!("fillrate: {function} is not supported yet; see docs/unsupported.md");
    }
}

/// Exports that report themselves and do nothing.
macro_rules! not_yet {
    ($($name:ident($($type:ty),*) $(-> $result:ty = $value:expr)?;)*) => {$(
        /// Not supported yet: reports itself, does nothing, returns failure.
        #[unsafe(no_mangle)]
        pub extern "C" fn $name($(_: $type),*) $(-> $result)? {
            guard((), || unsupported(stringify!($name)));
            $($value)?
        }
    )*};
}

not_yet! {
    guTexAllocateMemory(i32, u8, i32, i32, i32, i32, i32, i32, i32, i32, i32, i32, i32, f32, i32)
        -> u32 = 0xffff_ffff;
    guTexChangeAttributes(u32, i32, i32, i32, i32, i32, i32, i32, i32, i32, i32, i32) -> i32 = 0;
    guTexDownloadMipMap(u32, *const u8, *const u8);
    guTexDownloadMipMapLevel(u32, i32, *mut *const u8);
    guTexSource(u32);
    guTexGetCurrentMipMap(i32) -> u32 = 0xffff_ffff;
    guTexGetMipMapInfo(u32) -> *mut u8 = std::ptr::null_mut();
    guTexMemQueryAvail(i32) -> u32 = 0;
    guTexMemReset();
    guTexCreateColorMipMap() -> *mut u16 = std::ptr::null_mut();
    gu3dfGetInfo(*const i8, *mut u8) -> i32 = 0;
    gu3dfLoad(*const i8, *mut u8) -> i32 = 0;
    guMovieSetName(*const i8);
    guMovieStart();
    guMovieStop();
    guMPInit();
    guMPTexCombineFunction(i32);
    guMPTexSource(i32, u32);
    guMPDrawTriangle(*const u8, *const u8, *const u8);
    guFbReadRegion(i32, i32, i32, i32, *mut u8, i32);
    guFbWriteRegion(i32, i32, i32, i32, *const u8, i32);
    guEncodeRLE16(*mut u8, *const u8, u32, u32) -> i32 = 0;
    ConvertAndDownloadRle(
        i32, u32, i32, i32, i32, i32, u32, *const u8, i32, u32, u32, u32, u32, u32, u32, *const u16
    );
}

/// The w of a fog table entry.
#[unsafe(no_mangle)]
pub extern "C" fn guFogTableIndexToW(index: i32) -> f32 {
    gu::fog_table_w(index)
}

/// Exponential fog.
///
/// # Safety
/// `table` is null or has room for 64 bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn guFogGenerateExp(table: *mut [u8; 64], density: f32) {
    // SAFETY: the caller gives room for a table.
    guard((), || unsafe { write(table, gu::fog_table_exp(density)) })
}

/// Squared exponential fog.
///
/// # Safety
/// `table` is null or has room for 64 bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn guFogGenerateExp2(table: *mut [u8; 64], density: f32) {
    // SAFETY: the caller gives room for a table.
    guard((), || unsafe { write(table, gu::fog_table_exp2(density)) })
}

/// Linear fog.
///
/// # Safety
/// `table` is null or has room for 64 bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn guFogGenerateLinear(table: *mut [u8; 64], near: f32, far: f32) {
    // SAFETY: the caller gives room for a table.
    guard((), || unsafe { write(table, gu::fog_table_linear(near, far)) })
}

/// Exchanges the halves of a word.
#[unsafe(no_mangle)]
pub extern "C" fn guEndianSwapWords(value: u32) -> u32 {
    value.rotate_left(16)
}

/// Exchanges the bytes of a half word.
#[unsafe(no_mangle)]
pub extern "C" fn guEndianSwapBytes(value: u16) -> u16 {
    value.swap_bytes()
}
