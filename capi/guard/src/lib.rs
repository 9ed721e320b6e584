//! What every C library of ours needs at its border: no panic crosses it, and
//! pointers are checked before they are read.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Once;

/// Runs `body`; where it panics, says so once on standard error and returns
/// `fallback`.
pub fn guard<T>(fallback: T, body: impl FnOnce() -> T) -> T {
    static FIRST: Once = Once::new();
    match catch_unwind(AssertUnwindSafe(body)) {
        Ok(value) => value,
        Err(_) => {
            FIRST.call_once(|| {
                eprintln!("fillrate: internal error; the call was dropped. Please report this.");
            });
            fallback
        }
    }
}

/// Copies what a pointer points to; `None` for null.
///
/// # Safety
/// `pointer` is null or points to a readable `T` (of any alignment).
pub unsafe fn read<T: Copy>(pointer: *const T) -> Option<T> {
    // SAFETY: not null, so readable by the caller's promise.
    (!pointer.is_null()).then(|| unsafe { pointer.read_unaligned() })
}

/// Stores through a pointer; null is ignored.
///
/// # Safety
/// `pointer` is null or points to a writable `T` (of any alignment).
pub unsafe fn write<T>(pointer: *mut T, value: T) {
    if !pointer.is_null() {
        // SAFETY: not null, so writable by the caller's promise.
        unsafe { pointer.write_unaligned(value) }
    }
}

/// The bytes from a pointer on; empty for null.
///
/// # Safety
/// `pointer` is null or points to `count` readable bytes that stay unchanged
/// while the slice is used.
pub unsafe fn bytes<'a>(pointer: *const u8, count: usize) -> &'a [u8] {
    if pointer.is_null() || count == 0 || count > isize::MAX as usize {
        return &[];
    }
    // SAFETY: not null, so readable by the caller's promise.
    unsafe { std::slice::from_raw_parts(pointer, count) }
}

/// The bytes of a text, without the zero that ends it; `None` for null.
///
/// # Safety
/// `pointer` is null or points to bytes that end with a zero and stay
/// unchanged while the slice is used.
pub unsafe fn text<'a>(pointer: *const std::ffi::c_char) -> Option<&'a [u8]> {
    // SAFETY: not null, so it ends by the caller's promise.
    (!pointer.is_null()).then(|| unsafe { std::ffi::CStr::from_ptr(pointer) }.to_bytes())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn panics_stop_here() {
        assert_eq!(guard(7, || panic!("on purpose")), 7);
        assert_eq!(guard(7, || 8), 8);
    }

    #[test]
    fn null_is_nothing() {
        // SAFETY: null is allowed.
        unsafe {
            assert_eq!(read::<u32>(std::ptr::null()), None);
            write::<u32>(std::ptr::null_mut(), 1);
            assert!(bytes(std::ptr::null(), 100).is_empty());
            assert_eq!(text(std::ptr::null()), None);
            assert_eq!(text(c"name".as_ptr()), Some(&b"name"[..]));
        }
    }
}
