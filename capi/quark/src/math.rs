//! Mathematics. Null pointers are ignored.

use std::ffi::c_char;

use fillrate_guard::{guard, read, write};
use fillrate_quark::math;

/// Sine of an angle.
#[unsafe(no_mangle)]
pub extern "C" fn quark_sinus(a: i32) -> i16 {
    math::sinus(a)
}

/// Cosine of an angle.
#[unsafe(no_mangle)]
pub extern "C" fn quark_cosinus(a: i32) -> i16 {
    math::cosinus(a)
}

/// Square root.
#[unsafe(no_mangle)]
pub extern "C" fn quark_sqrti(a: i32) -> i32 {
    math::sqrti(a)
}

/// Angle of a vector.
#[unsafe(no_mangle)]
pub extern "C" fn quark_atan2i(x: i32, y: i32) -> i32 {
    math::atan2i(x, y)
}

/// Base-2 logarithm.
#[unsafe(no_mangle)]
pub extern "C" fn quark_log2(a: i32) -> i32 {
    math::log2(a)
}

/// Takes common repeats from texture coordinates.
///
/// # Safety
/// `uv` is null or points to six numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn quark_convert_uv(uv: *mut [i16; 6]) {
    guard((), || {
        // SAFETY: the caller's promise.
        if let Some(mut values) = unsafe { read(uv) } {
            math::convert_uv(&mut values);
            // SAFETY: it was just read.
            unsafe { write(uv, values) }
        }
    })
}

/// Scales a vector to unit length.
///
/// # Safety
/// `n` is null or points to three numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn quark_normalize(n: *mut [i32; 3]) {
    guard((), || {
        // SAFETY: the caller's promise.
        if let Some(mut vector) = unsafe { read(n) } {
            math::normalize(&mut vector);
            // SAFETY: it was just read.
            unsafe { write(n, vector) }
        }
    })
}

/// A vector perpendicular to a plane.
///
/// # Safety
/// Each pointer is null or points to three numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn quark_def_u_normal(
    a: *const [i32; 3],
    b: *const [i32; 3],
    c: *const [i32; 3],
    n: *mut [i32; 3],
) {
    guard((), || {
        // SAFETY: the caller's promise.
        if let (Some(a), Some(b), Some(c)) = unsafe { (read(a), read(b), read(c)) } {
            // SAFETY: the caller's promise.
            unsafe { write(n, math::def_u_normal(&a, &b, &c)) }
        }
    })
}

/// A number in decimal.
///
/// # Safety
/// `text` is null or has room for the digits, a sign and a zero: 12 bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn quark_itoa(a: i32, text: *mut c_char) {
    guard((), || {
        if text.is_null() {
            return;
        }
        let digits = math::itoa(a);
        for (i, byte) in digits.bytes().chain([0]).enumerate() {
            // SAFETY: the caller gives room for all of them.
            unsafe { write(text.add(i), byte as c_char) }
        }
    })
}
