//! SSE4.1, AVX2 and AVX-512 lanes.
//!
//! Every `unsafe` block here calls intrinsics whose features the token
//! proves: a token is only made by `detect`, and lanes only by a token.
//! Loads and stores check their slices first.

use core::arch::x86_64::{__m256i, _mm256_set_epi64x};

mod avx2;
mod avx512;
mod sse41;

pub use avx2::Avx2;
pub use avx512::Avx512;
pub use sse41::Sse41;

/// Entry `at` of `table`, unchecked. A function rather than a closure, because
/// only a function can be sure to be inlined into the kernel.
///
/// # Safety
///
/// `at`, as unsigned, is an index into `table`.
#[inline(always)]
unsafe fn entry(table: &[u64], at: i32) -> i64 {
    // SAFETY: the caller's promise.
    unsafe { *table.get_unchecked(at as u32 as usize) as i64 }
}

/// Four entries of `table`, unchecked, in order.
///
/// # Safety
///
/// The machine has AVX2; each of `at`, as unsigned, is an index into `table`.
#[inline(always)]
unsafe fn four(table: &[u64], at: [i32; 4]) -> __m256i {
    // SAFETY: the caller's promise.
    unsafe {
        _mm256_set_epi64x(
            entry(table, at[3]),
            entry(table, at[2]),
            entry(table, at[1]),
            entry(table, at[0]),
        )
    }
}

/// [`four`] at the indices from `first` on.
///
/// They are read from memory one by one, in one step each. That takes volatile
/// reads: compilers would take them out of a vector that was loaded before, in
/// two.
///
/// # Safety
///
/// As of [`four`], of four elements of `at` from `first` on, which there are.
#[inline(always)]
unsafe fn four_at(table: &[u64], at: &[i32], first: usize) -> __m256i {
    // SAFETY: the caller's promise; a reference to integers may be read.
    unsafe {
        let at = at.as_ptr().add(first);
        four(
            table,
            [
                at.read_volatile(),
                at.add(1).read_volatile(),
                at.add(2).read_volatile(),
                at.add(3).read_volatile(),
            ],
        )
    }
}

/// Implements an operator trait by an intrinsic on the wrapped register.
macro_rules! operator {
    ($lanes:ident, $trait:ident, $name:ident, $intrinsic:ident) => {
        impl core::ops::$trait for $lanes {
            type Output = $lanes;
            #[inline(always)]
            fn $name(self, other: $lanes) -> $lanes {
                // SAFETY: lanes exist only where the level was detected.
                $lanes(unsafe { $intrinsic(self.0, other.0) })
            }
        }
    };
}

/// Implements an operator trait on a pair of float registers.
macro_rules! float_operator {
    ($lanes:ident, $trait:ident, $name:ident, $intrinsic:ident) => {
        impl core::ops::$trait for $lanes {
            type Output = $lanes;
            #[inline(always)]
            fn $name(self, other: $lanes) -> $lanes {
                // SAFETY: lanes exist only where the level was detected.
                unsafe { $lanes($intrinsic(self.0, other.0), $intrinsic(self.1, other.1)) }
            }
        }
    };
}

/// Methods `fn name(self, other) -> Self` by one intrinsic each.
macro_rules! binary {
    ($($name:ident $intrinsic:ident)*) => {$(
        #[inline(always)]
        fn $name(self, other: Self) -> Self {
            // SAFETY: lanes exist only where the level was detected.
            Self(unsafe { $intrinsic(self.0, other.0) })
        }
    )*};
}

/// Methods `fn name(self, count) -> Self`: shifts by a count that is a
/// constant once inlined.
macro_rules! shifts {
    ($($name:ident $intrinsic:ident)*) => {$(
        #[inline(always)]
        fn $name(self, count: u32) -> Self {
            // SAFETY: lanes exist only where the level was detected.
            Self(unsafe { $intrinsic(self.0, _mm_cvtsi32_si128(count as i32)) })
        }
    )*};
}

pub(crate) use {binary, float_operator, operator, shifts};
