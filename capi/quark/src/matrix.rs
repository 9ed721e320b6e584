//! Matrices. Null pointers are ignored.

use fillrate_guard::{guard, read, write};
use fillrate_quark::Matrix;

use crate::layout::RawMatrix;

/// Changes a matrix in place.
///
/// # Safety
/// `matrix` is null or points to a matrix.
unsafe fn change(matrix: *mut RawMatrix, change: impl FnOnce(&mut Matrix)) {
    guard((), || {
        // SAFETY: the caller's promise.
        if let Some(m) = unsafe { read(matrix) } {
            let mut changed = Matrix { m };
            change(&mut changed);
            // SAFETY: it was just read.
            unsafe { write(matrix, changed.m) }
        }
    })
}

/// Applies a matrix to a vector.
///
/// # Safety
/// Each pointer is null or points to a matrix, or three numbers.
unsafe fn apply(
    matrix: *const RawMatrix,
    from: *const [i32; 3],
    to: *mut [i32; 3],
    apply: impl FnOnce(&Matrix, &[i32; 3]) -> [i32; 3],
) {
    guard((), || {
        // SAFETY: the caller's promise.
        if let (Some(m), Some(v)) = unsafe { (read(matrix), read(from)) } {
            // SAFETY: the caller's promise.
            unsafe { write(to, apply(&Matrix { m }, &v)) }
        }
    })
}

macro_rules! changes {
    ($($(#[$doc:meta])* $name:ident($($arg:ident),*) |$m:ident| $body:expr;)*) => {$(
        $(#[$doc])*
        ///
        /// # Safety
        /// `matrix` is null or points to a matrix.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $name(matrix: *mut RawMatrix $(, $arg: i32)*) {
            // SAFETY: the caller's promise.
            unsafe { change(matrix, |$m| $body) }
        }
    )*};
}

changes! {
    /// Makes it turn and move nothing.
    quark_matrix_load_identity() |m| *m = Matrix::identity();
    /// Moves along its own axes.
    quark_matrix_translate(x, y, z) |m| m.translate(x, y, z);
    /// Turns about its x axis.
    quark_matrix_rotate_x(a) |m| m.rotate_x(a);
    /// Turns about its y axis.
    quark_matrix_rotate_y(a) |m| m.rotate_y(a);
    /// Turns about its z axis.
    quark_matrix_rotate_z(a) |m| m.rotate_z(a);
    /// Scales its axes.
    quark_matrix_scale(s) |m| m.scale(s);
}

macro_rules! applications {
    ($($(#[$doc:meta])* $name:ident = $function:ident;)*) => {$(
        $(#[$doc])*
        ///
        /// # Safety
        /// Each pointer is null or points to a matrix, or three numbers.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $name(
            matrix: *const RawMatrix,
            from: *const [i32; 3],
            to: *mut [i32; 3],
        ) {
            // SAFETY: the caller's promise.
            unsafe { apply(matrix, from, to, Matrix::$function) }
        }
    )*};
}

applications! {
    /// Turns and moves a point.
    quark_matrix_transform_vector = transform_vector;
    /// Turns a vector.
    quark_matrix_rotate_vector = rotate_vector;
    /// Turns a vector back.
    quark_matrix_inv_rotate_vector = inv_rotate_vector;
}

/// Copies a matrix.
///
/// # Safety
/// Each pointer is null or points to a matrix.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn quark_matrix_load(matrix: *mut RawMatrix, from: *const RawMatrix) {
    guard((), || {
        // SAFETY: the caller's promise.
        if let Some(m) = unsafe { read(from) } {
            // SAFETY: the caller's promise.
            unsafe { write(matrix, m) }
        }
    })
}

/// Multiplies a matrix by another.
///
/// # Safety
/// Each pointer is null or points to a matrix.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn quark_matrix_mult(matrix: *mut RawMatrix, other: *const RawMatrix) {
    // SAFETY: the caller's promise.
    if let Some(m) = unsafe { read(other) } {
        // SAFETY: the caller's promise.
        unsafe { change(matrix, |left| left.mult(&Matrix { m })) }
    }
}
