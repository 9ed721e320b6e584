//! Fixed-width lanes for the pixel engine, at the level the machine offers.
//!
//! One pixel lives in one 32-bit lane, always and in order; a colour is two
//! vectors, each holding a pair of 16-bit channels in every lane: (red, blue)
//! and (green, alpha), the first of a pair in the low half. Coordinates that
//! need more than 32 bits are `f64` lanes holding integers below 2^53, which
//! is exact on every machine. Where a source computes in single precision,
//! there are `f32` lanes.
//!
//! An algorithm is written once, generic over [`Simd`], and entered through
//! [`Level::dispatch`] or [`Simd::vectorize`]. Every level gives the same
//! bits; [`Scalar`] is the definition of each operation, and the tests compare
//! every other level with it.
//!
//! This crate holds all `unsafe` code of the engine. A token of a level exists
//! only where the processor was found to have it, so everything above is safe.

mod lanes;
mod level;
mod scalar;
#[cfg(test)]
mod tests;

#[cfg(all(target_arch = "aarch64", target_feature = "neon", target_endian = "little"))]
mod neon;
#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
mod wasm;
#[cfg(target_arch = "x86_64")]
mod x86;

pub use lanes::{FloatLanes, IntLanes, Kernel, MaskLanes, Simd, SingleLanes};
pub use level::{Level, UnknownLevel};
pub use scalar::Scalar;

/// The widest vector of any level, in 32-bit lanes. Every level's lane count
/// divides it, and buffers are padded to it.
pub const MAX_LANES: usize = 16;

/// Tells the processor that `value` is read soon, where it can be told. Changes
/// no result.
#[inline(always)]
pub fn prefetch<T>(value: &T) {
    #[cfg(target_arch = "x86_64")]
    for line in (0..size_of::<T>()).step_by(64) {
        use core::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
        // SAFETY: SSE is part of x86-64; a prefetch reads nothing, and the
        // address lies within the value.
        unsafe { _mm_prefetch::<_MM_HINT_T0>(core::ptr::from_ref(value).cast::<i8>().add(line)) }
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = value;
}

/// Tells the processor that `value` is written soon, where a processor of this level
/// can be told: its memory is fetched from other cores meanwhile. Changes no result.
#[inline(always)]
pub fn prefetch_write<T>(level: Level, value: &mut T) {
    #[cfg(target_arch = "x86_64")]
    if matches!(level, Level::Avx2 | Level::Avx512) {
        let first = core::ptr::from_mut(value).cast::<u8>();
        for line in (0..size_of::<T>()).step_by(64) {
            // SAFETY: a prefetch changes no memory and no register, and the address
            // lies within the value. Processors with AVX2 have PREFETCHW or take it
            // for a NOP; its intrinsic would need a feature of its own.
            unsafe {
                core::arch::asm!(
                    "prefetchw [{}]",
                    in(reg) first.add(line),
                    options(nostack, preserves_flags)
                );
            }
        }
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = (level, value);
}

/// Truncates floats within the range of `i32` toward zero; others give no fixed
/// value. Rust's conversion, which limits them, is many instructions a float.
#[inline(always)]
pub fn truncate(values: [f32; 4]) -> [i32; 4] {
    #[cfg(target_arch = "x86_64")]
    {
        use core::arch::x86_64::{_mm_cvttps_epi32, _mm_loadu_ps, _mm_storeu_si128};
        let mut out = [0; 4];
        // SAFETY: SSE2 is part of x86-64; both arrays hold 16 bytes.
        unsafe {
            let lanes = _mm_cvttps_epi32(_mm_loadu_ps(values.as_ptr()));
            _mm_storeu_si128(out.as_mut_ptr().cast(), lanes);
        }
        out
    }
    #[cfg(not(target_arch = "x86_64"))]
    values.map(|value| value as i32)
}

/// The index of the last entry of a table that `load_pairs` reads, or the
/// greatest index there is. The unchecked loads rely on it.
///
/// # Panics
///
/// When `table` is empty.
#[inline(always)]
fn last_index(table: &[u64]) -> u32 {
    assert!(!table.is_empty(), "a table of pairs has at least one entry");
    u32::try_from(table.len() - 1).unwrap_or(u32::MAX)
}
