//! WebAssembly simd128: four lanes; masks are registers.
//!
//! Compiled only where the target has simd128, so every instruction exists;
//! `unsafe` is needed for memory alone. Relaxed instructions are never used:
//! their results differ between hosts.

use core::arch::wasm32::*;

use crate::{FloatLanes, IntLanes, Kernel, Level, MaskLanes, Simd, SingleLanes};

/// The token of the simd128 level.
#[derive(Clone, Copy, Debug)]
pub struct Simd128(());

/// Four integers.
#[derive(Clone, Copy)]
pub struct I(v128);
/// Four floats.
#[derive(Clone, Copy)]
pub struct F(v128, v128);
/// Four 32-bit floats.
#[derive(Clone, Copy)]
pub struct G(v128);
/// Four switches, all ones or zero.
#[derive(Clone, Copy)]
pub struct M(v128);

impl Simd128 {
    /// The token; simd128 is part of the target.
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self(())
    }
}

/// The even words of two registers.
#[inline(always)]
fn even_words(a: v128, b: v128) -> v128 {
    i32x4_shuffle::<0, 2, 4, 6>(a, b)
}

/// The odd words of two registers.
#[inline(always)]
fn odd_words(a: v128, b: v128) -> v128 {
    i32x4_shuffle::<1, 3, 5, 7>(a, b)
}

impl Simd for Simd128 {
    const LANES: usize = 4;
    const LEVEL: Level = Level::Simd128;
    type I = I;
    type F = F;
    type G = G;
    type M = M;

    #[inline(always)]
    fn vectorize<K: Kernel>(self, kernel: K) -> K::Output {
        kernel.run(self)
    }
    #[inline(always)]
    fn splat(self, value: i32) -> I {
        I(i32x4_splat(value))
    }
    #[inline(always)]
    fn load(self, from: &[i32]) -> I {
        let from = &from[..4];
        // SAFETY: the slice holds 16 bytes; the load takes any alignment.
        I(unsafe { v128_load(from.as_ptr().cast()) })
    }
    #[inline(always)]
    fn store(self, lanes: I, to: &mut [i32]) {
        let to = &mut to[..4];
        // SAFETY: the slice holds 16 bytes; the store takes any alignment.
        unsafe { v128_store(to.as_mut_ptr().cast(), lanes.0) }
    }
    #[inline(always)]
    fn load16(self, from: &[u16]) -> I {
        let from = &from[..4];
        // SAFETY: the slice holds 8 bytes; the load takes any alignment.
        I(unsafe { u32x4_load_extend_u16x4(from.as_ptr()) })
    }
    #[inline(always)]
    fn store16(self, lanes: I, to: &mut [u16], mask: M) {
        let to = &mut to[..4];
        let low = v128_and(lanes.0, i32x4_splat(0xffff));
        let new = u16x8_narrow_i32x4(low, low);
        let on = i16x8_narrow_i32x4(mask.0, mask.0);
        // SAFETY: the slice holds 8 bytes; both accesses take any alignment.
        unsafe {
            let old = v128_load64_zero(to.as_ptr().cast());
            v128_store64_lane::<0>(v128_bitselect(new, old, on), to.as_mut_ptr().cast());
        }
    }
    #[inline(always)]
    fn store16_all(self, lanes: I, to: &mut [u16]) {
        let to = &mut to[..4];
        let low = v128_and(lanes.0, i32x4_splat(0xffff));
        // SAFETY: the slice holds 8 bytes; the store takes any alignment.
        unsafe {
            v128_store64_lane::<0>(u16x8_narrow_i32x4(low, low), to.as_mut_ptr().cast());
        }
    }
    #[inline(always)]
    fn store_masked(self, lanes: I, to: &mut [i32], mask: M) {
        let old = self.load(to);
        self.store(lanes.select(old, mask), to);
    }
    #[inline(always)]
    fn splat_f(self, value: f64) -> F {
        F(f64x2_splat(value), f64x2_splat(value))
    }
    #[inline(always)]
    fn load_f(self, from: &[f64]) -> F {
        let from = &from[..4];
        // SAFETY: the slice holds 32 bytes.
        unsafe { F(v128_load(from.as_ptr().cast()), v128_load(from.as_ptr().add(2).cast())) }
    }
    #[inline(always)]
    fn store_f(self, lanes: F, to: &mut [f64]) {
        let to = &mut to[..4];
        // SAFETY: the slice holds 32 bytes.
        unsafe {
            v128_store(to.as_mut_ptr().cast(), lanes.0);
            v128_store(to.as_mut_ptr().add(2).cast(), lanes.1);
        }
    }
    #[inline(always)]
    fn splat_g(self, value: f32) -> G {
        G(f32x4_splat(value))
    }
    #[inline(always)]
    fn load_g(self, from: &[f32]) -> G {
        let from = &from[..4];
        // SAFETY: the slice holds 16 bytes; the load takes any alignment.
        G(unsafe { v128_load(from.as_ptr().cast()) })
    }
    #[inline(always)]
    fn store_g(self, lanes: G, to: &mut [f32]) {
        let to = &mut to[..4];
        // SAFETY: the slice holds 16 bytes; the store takes any alignment.
        unsafe { v128_store(to.as_mut_ptr().cast(), lanes.0) }
    }
    #[inline(always)]
    fn transpose(self, [I(a), I(b), I(c), I(d)]: [I; 4], to: &mut [[i32; 4]]) {
        let to = &mut to[..4];
        let ab = [i32x4_shuffle::<0, 4, 1, 5>(a, b), i32x4_shuffle::<2, 6, 3, 7>(a, b)];
        let cd = [i32x4_shuffle::<0, 4, 1, 5>(c, d), i32x4_shuffle::<2, 6, 3, 7>(c, d)];
        for i in 0..2 {
            let even = i64x2_shuffle::<0, 2>(ab[i], cd[i]);
            let odd = i64x2_shuffle::<1, 3>(ab[i], cd[i]);
            // SAFETY: both places hold 16 bytes; the stores take any alignment.
            unsafe {
                v128_store(to[2 * i].as_mut_ptr().cast(), even);
                v128_store(to[2 * i + 1].as_mut_ptr().cast(), odd);
            }
        }
    }
    #[inline(always)]
    fn transpose_f(self, [a, b, c, d]: [F; 4], to: &mut [[f64; 4]]) {
        let to = &mut to[..4];
        for (half, [a, b, c, d]) in
            [[a.0, b.0, c.0, d.0], [a.1, b.1, c.1, d.1]].into_iter().enumerate()
        {
            let (even, odd) = (to[2 * half].as_mut_ptr(), to[2 * half + 1].as_mut_ptr());
            // SAFETY: both places hold 32 bytes; the stores take any alignment.
            unsafe {
                v128_store(even.cast(), i64x2_shuffle::<0, 2>(a, b));
                v128_store(even.add(2).cast(), i64x2_shuffle::<0, 2>(c, d));
                v128_store(odd.cast(), i64x2_shuffle::<1, 3>(a, b));
                v128_store(odd.add(2).cast(), i64x2_shuffle::<1, 3>(c, d));
            }
        }
    }
    #[inline(always)]
    fn mask(self, bits: u32) -> M {
        let each = i32x4(1, 2, 4, 8);
        M(i32x4_eq(v128_and(i32x4_splat(bits as i32), each), each))
    }
    #[inline(always)]
    fn lookup16(self, table: &[i32; 16], index: I) -> I {
        let index = v128_and(index.0, i32x4_splat(15));
        I(i32x4(
            table[(i32x4_extract_lane::<0>(index) & 15) as usize],
            table[(i32x4_extract_lane::<1>(index) & 15) as usize],
            table[(i32x4_extract_lane::<2>(index) & 15) as usize],
            table[(i32x4_extract_lane::<3>(index) & 15) as usize],
        ))
    }
    #[inline(always)]
    fn load_pairs(self, table: &[u64], index: I) -> (I, I) {
        let index = u32x4_min(index.0, u32x4_splat(crate::last_index(table)));
        // SAFETY: each index is at most that of the last entry, so the entries
        // read lie inside `table`.
        let (front, back) = unsafe {
            (
                u64x2(
                    *table.get_unchecked(u32x4_extract_lane::<0>(index) as usize),
                    *table.get_unchecked(u32x4_extract_lane::<1>(index) as usize),
                ),
                u64x2(
                    *table.get_unchecked(u32x4_extract_lane::<2>(index) as usize),
                    *table.get_unchecked(u32x4_extract_lane::<3>(index) as usize),
                ),
            )
        };
        (I(even_words(front, back)), I(odd_words(front, back)))
    }
}

/// Methods `fn name(self, other) -> Self` by one instruction each.
macro_rules! binary {
    ($($name:ident $intrinsic:ident)*) => {$(
        #[inline(always)]
        fn $name(self, other: I) -> I {
            I($intrinsic(self.0, other.0))
        }
    )*};
}

/// Methods `fn name(self, count) -> Self` by one instruction each.
macro_rules! shifts {
    ($($name:ident $intrinsic:ident)*) => {$(
        #[inline(always)]
        fn $name(self, count: u32) -> I {
            I($intrinsic(self.0, count))
        }
    )*};
}

impl IntLanes for I {
    type M = M;

    #[inline(always)]
    fn any(self) -> bool {
        v128_any_true(self.0)
    }

    binary! {
        mul i32x4_mul
        min i32x4_min
        max i32x4_max
        add16 i16x8_add
        sub16 i16x8_sub
        add_sat_u16 u16x8_add_sat
        mul16 i16x8_mul
        min16 i16x8_min
        max16 i16x8_max
        eq16 i16x8_eq
    }
    shifts! {
        shl i32x4_shl
        shr u32x4_shr
        sar i32x4_shr
        shl16 i16x8_shl
        shr16 u16x8_shr
    }
    #[inline(always)]
    fn sar_each(self, count: I) -> I {
        I(i32x4(
            i32x4_extract_lane::<0>(self.0) >> (i32x4_extract_lane::<0>(count.0) & 31),
            i32x4_extract_lane::<1>(self.0) >> (i32x4_extract_lane::<1>(count.0) & 31),
            i32x4_extract_lane::<2>(self.0) >> (i32x4_extract_lane::<2>(count.0) & 31),
            i32x4_extract_lane::<3>(self.0) >> (i32x4_extract_lane::<3>(count.0) & 31),
        ))
    }
    #[inline(always)]
    fn eq(self, other: I) -> M {
        M(i32x4_eq(self.0, other.0))
    }
    #[inline(always)]
    fn gt(self, other: I) -> M {
        M(i32x4_gt(self.0, other.0))
    }
    #[inline(always)]
    fn select(self, other: I, mask: M) -> I {
        I(v128_bitselect(self.0, other.0, mask.0))
    }
    #[inline(always)]
    fn mul_high_i16(self, other: I) -> I {
        let low = i32x4_extmul_low_i16x8(self.0, other.0);
        let high = i32x4_extmul_high_i16x8(self.0, other.0);
        I(i16x8_shuffle::<1, 3, 5, 7, 9, 11, 13, 15>(low, high))
    }
    #[inline(always)]
    fn dot_bytes(self, weights: I) -> I {
        let low = i16x8_splat(0xff);
        I(i16x8_add(
            i16x8_mul(v128_and(self.0, low), v128_and(weights.0, low)),
            i16x8_mul(u16x8_shr(self.0, 8), u16x8_shr(weights.0, 8)),
        ))
    }
}

impl FloatLanes for F {
    type I = I;
    type M = M;

    #[inline(always)]
    fn lt(self, other: F) -> M {
        M(even_words(f64x2_lt(self.0, other.0), f64x2_lt(self.1, other.1)))
    }
    #[inline(always)]
    fn from_i32(lanes: I) -> F {
        let high = i64x2_shuffle::<1, 1>(lanes.0, lanes.0);
        F(f64x2_convert_low_i32x4(lanes.0), f64x2_convert_low_i32x4(high))
    }
    #[inline(always)]
    fn select(self, other: F, mask: M) -> F {
        let low = i32x4_shuffle::<0, 0, 1, 1>(mask.0, mask.0);
        let high = i32x4_shuffle::<2, 2, 3, 3>(mask.0, mask.0);
        F(v128_bitselect(self.0, other.0, low), v128_bitselect(self.1, other.1, high))
    }
    #[inline(always)]
    fn abs(self) -> F {
        F(f64x2_abs(self.0), f64x2_abs(self.1))
    }
    #[inline(always)]
    fn trunc(self) -> F {
        F(f64x2_trunc(self.0), f64x2_trunc(self.1))
    }
    #[inline(always)]
    fn floor(self) -> F {
        F(f64x2_floor(self.0), f64x2_floor(self.1))
    }
    #[inline(always)]
    fn floor_i32(self) -> I {
        let low = i32x4_trunc_sat_f64x2_zero(f64x2_floor(self.0));
        let high = i32x4_trunc_sat_f64x2_zero(f64x2_floor(self.1));
        I(i64x2_shuffle::<0, 2>(low, high))
    }
    #[inline(always)]
    fn high_word(self) -> I {
        I(odd_words(self.0, self.1))
    }
}

impl SingleLanes for G {
    type I = I;
    type F = F;
    type M = M;

    #[inline(always)]
    fn widen(self) -> F {
        let high = i64x2_shuffle::<1, 1>(self.0, self.0);
        F(f64x2_promote_low_f32x4(self.0), f64x2_promote_low_f32x4(high))
    }
    #[inline(always)]
    fn truncate_i32(self) -> I {
        self.to_i32()
    }
    #[inline(always)]
    fn to_bits(self) -> I {
        I(self.0)
    }
    #[inline(always)]
    fn from_bits(bits: I) -> G {
        G(bits.0)
    }
    #[inline(always)]
    fn from_i32(lanes: I) -> G {
        G(f32x4_convert_i32x4(lanes.0))
    }
    #[inline(always)]
    fn to_i32(self) -> I {
        I(i32x4_trunc_sat_f32x4(self.0))
    }
    #[inline(always)]
    fn lt(self, other: G) -> M {
        M(f32x4_lt(self.0, other.0))
    }
}

impl MaskLanes for M {
    #[inline(always)]
    fn bits(self) -> u32 {
        u32::from(i32x4_bitmask(self.0))
    }
}

/// Implements an operator trait by an instruction on the wrapped registers.
macro_rules! operator {
    ($lanes:ident, $trait:ident, $name:ident, $intrinsic:ident $(, $second:tt)?) => {
        impl core::ops::$trait for $lanes {
            type Output = $lanes;
            #[inline(always)]
            fn $name(self, other: $lanes) -> $lanes {
                $lanes($intrinsic(self.0, other.0) $(, $intrinsic(self.$second, other.$second))?)
            }
        }
    };
}

operator!(I, Add, add, i32x4_add);
operator!(I, Sub, sub, i32x4_sub);
operator!(I, BitAnd, bitand, v128_and);
operator!(I, BitOr, bitor, v128_or);
operator!(I, BitXor, bitxor, v128_xor);
operator!(F, Add, add, f64x2_add, 1);
operator!(F, Sub, sub, f64x2_sub, 1);
operator!(F, Mul, mul, f64x2_mul, 1);
operator!(F, Div, div, f64x2_div, 1);
operator!(G, Add, add, f32x4_add);
operator!(G, Sub, sub, f32x4_sub);
operator!(G, Mul, mul, f32x4_mul);
operator!(G, Div, div, f32x4_div);
operator!(M, BitAnd, bitand, v128_and);
operator!(M, BitOr, bitor, v128_or);
