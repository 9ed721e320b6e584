//! The utility library's parts that need no board.

use std::ffi::c_char;

use fillrate_glide::{Call, gu};
use fillrate_guard::{bytes, guard, text, write};

use crate::library::calls;
use crate::session::{call, null};

/// The w of a fog table entry.
#[unsafe(no_mangle)]
pub extern "C" fn guFogTableIndexToW(index: i32) -> f32 {
    gu::fog_table_w(index)
}

/// Stores a fog table for the function of that name.
///
/// # Safety
/// `to` is null or has room for 64 bytes.
unsafe fn give_table(function: &str, to: *mut [u8; 64], table: [u8; 64]) {
    if to.is_null() {
        return null(function);
    }
    // SAFETY: the caller gives room for a table.
    unsafe { write(to, table) }
}

/// Exponential fog.
///
/// # Safety
/// `table` is null or has room for 64 bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn guFogGenerateExp(table: *mut [u8; 64], density: f32) {
    // SAFETY: the caller's promise.
    guard((), || unsafe { give_table("guFogGenerateExp", table, gu::fog_table_exp(density)) })
}

/// Squared exponential fog.
///
/// # Safety
/// `table` is null or has room for 64 bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn guFogGenerateExp2(table: *mut [u8; 64], density: f32) {
    // SAFETY: the caller's promise.
    guard((), || unsafe { give_table("guFogGenerateExp2", table, gu::fog_table_exp2(density)) })
}

/// Linear fog.
///
/// # Safety
/// `table` is null or has room for 64 bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn guFogGenerateLinear(table: *mut [u8; 64], near: f32, far: f32) {
    // SAFETY: the caller's promise.
    guard((), || unsafe {
        give_table("guFogGenerateLinear", table, gu::fog_table_linear(near, far))
    })
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

/// Codes a 565 picture in runs: a word each, the length in its high half.
/// Returns the bytes that takes; a null destination only counts.
///
/// # Safety
/// `source` is null or points to `width` x `height` pixels, `destination` is
/// null or has room for what is counted.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn guEncodeRLE16(
    destination: *mut u32,
    source: *const u8,
    width: u32,
    height: u32,
) -> i32 {
    guard(0, || {
        let count = (width as usize).saturating_mul(height as usize).saturating_mul(2);
        if source.is_null() || count > i32::MAX as usize / 2 {
            null("guEncodeRLE16");
            return 0;
        }
        // SAFETY: the caller's picture.
        let pixels = unsafe { bytes(source, count) }.as_chunks().0;
        let runs = gu::encode_rle16(pixels.iter().map(|&pixel| u16::from_le_bytes(pixel)));
        if !destination.is_null() {
            for (i, &run) in runs.iter().enumerate() {
                // SAFETY: the caller gives room for what was counted.
                unsafe { write(destination.wrapping_add(i), run) }
            }
        }
        (runs.len() * 4) as i32
    })
}

calls! {
    /// Starts a movie, which no release ever did.
    guMovieStart() = Call::GuMovieStart {};
    /// Stops a movie.
    guMovieStop() = Call::GuMovieStop {};
}

/// Names a movie.
///
/// # Safety
/// `name` is null or a text that ends.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn guMovieSetName(name: *const c_char) {
    guard((), || {
        // SAFETY: the caller's text.
        let name = unsafe { text(name) }.unwrap_or_default().into();
        call(Call::GuMovieSetName { name });
    })
}
