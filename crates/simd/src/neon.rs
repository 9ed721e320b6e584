//! AArch64 NEON: four lanes; masks are registers.
//!
//! NEON belongs to every AArch64 target that this module is compiled for, so
//! the intrinsics of every `unsafe` block here always exist. Lanes are
//! reinterpreted in little-endian order; big-endian targets use the scalar
//! level.

use core::arch::aarch64::*;

use crate::{FloatLanes, IntLanes, Kernel, Level, MaskLanes, Simd, SingleLanes};

/// The token of the NEON level.
#[derive(Clone, Copy, Debug)]
pub struct Neon(());

/// Four integers.
#[derive(Clone, Copy)]
pub struct I(int32x4_t);
/// Four floats.
#[derive(Clone, Copy)]
pub struct F(float64x2_t, float64x2_t);
/// Four 32-bit floats.
#[derive(Clone, Copy)]
pub struct G(float32x4_t);
/// Four switches, all ones or zero.
#[derive(Clone, Copy)]
pub struct M(uint32x4_t);

/// The bit of each lane in a bit mask.
const LANE_BITS: [u32; 4] = [1, 2, 4, 8];

impl Neon {
    /// The token; NEON is part of the target.
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self(())
    }
}

/// The even and the odd words of two registers.
#[inline(always)]
fn split_words(a: uint64x2_t, b: uint64x2_t) -> (uint32x4_t, uint32x4_t) {
    // SAFETY: NEON.
    unsafe {
        let (a, b) = (vreinterpretq_u32_u64(a), vreinterpretq_u32_u64(b));
        (vuzp1q_u32(a, b), vuzp2q_u32(a, b))
    }
}

impl Simd for Neon {
    const LANES: usize = 4;
    const LEVEL: Level = Level::Neon;
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
        // SAFETY: NEON.
        I(unsafe { vdupq_n_s32(value) })
    }
    #[inline(always)]
    fn load(self, from: &[i32]) -> I {
        let from = &from[..4];
        // SAFETY: the slice holds 16 bytes.
        I(unsafe { vld1q_s32(from.as_ptr()) })
    }
    #[inline(always)]
    fn store(self, lanes: I, to: &mut [i32]) {
        let to = &mut to[..4];
        // SAFETY: the slice holds 16 bytes.
        unsafe { vst1q_s32(to.as_mut_ptr(), lanes.0) }
    }
    #[inline(always)]
    fn load16(self, from: &[u16]) -> I {
        let from = &from[..4];
        // SAFETY: the slice holds 8 bytes.
        I(unsafe { vreinterpretq_s32_u32(vmovl_u16(vld1_u16(from.as_ptr()))) })
    }
    #[inline(always)]
    fn store16(self, lanes: I, to: &mut [u16], mask: M) {
        let to = &mut to[..4];
        // SAFETY: the slice holds 8 bytes.
        unsafe {
            let new = vmovn_u32(vreinterpretq_u32_s32(lanes.0));
            let old = vld1_u16(to.as_ptr());
            vst1_u16(to.as_mut_ptr(), vbsl_u16(vmovn_u32(mask.0), new, old));
        }
    }
    #[inline(always)]
    fn store16_all(self, lanes: I, to: &mut [u16]) {
        let to = &mut to[..4];
        // SAFETY: the slice holds 8 bytes.
        unsafe { vst1_u16(to.as_mut_ptr(), vmovn_u32(vreinterpretq_u32_s32(lanes.0))) }
    }
    #[inline(always)]
    fn store_masked(self, lanes: I, to: &mut [i32], mask: M) {
        let old = self.load(to);
        self.store(lanes.select(old, mask), to);
    }
    #[inline(always)]
    fn splat_f(self, value: f64) -> F {
        // SAFETY: NEON.
        unsafe { F(vdupq_n_f64(value), vdupq_n_f64(value)) }
    }
    #[inline(always)]
    fn load_f(self, from: &[f64]) -> F {
        let from = &from[..4];
        // SAFETY: the slice holds 32 bytes.
        unsafe { F(vld1q_f64(from.as_ptr()), vld1q_f64(from.as_ptr().add(2))) }
    }
    #[inline(always)]
    fn store_f(self, lanes: F, to: &mut [f64]) {
        let to = &mut to[..4];
        // SAFETY: the slice holds 32 bytes.
        unsafe {
            vst1q_f64(to.as_mut_ptr(), lanes.0);
            vst1q_f64(to.as_mut_ptr().add(2), lanes.1);
        }
    }
    #[inline(always)]
    fn splat_g(self, value: f32) -> G {
        // SAFETY: NEON.
        G(unsafe { vdupq_n_f32(value) })
    }
    #[inline(always)]
    fn load_g(self, from: &[f32]) -> G {
        let from = &from[..4];
        // SAFETY: the slice holds 16 bytes.
        G(unsafe { vld1q_f32(from.as_ptr()) })
    }
    #[inline(always)]
    fn store_g(self, lanes: G, to: &mut [f32]) {
        let to = &mut to[..4];
        // SAFETY: the slice holds 16 bytes.
        unsafe { vst1q_f32(to.as_mut_ptr(), lanes.0) }
    }
    #[inline(always)]
    fn transpose(self, [I(a), I(b), I(c), I(d)]: [I; 4], to: &mut [[i32; 4]]) {
        let to = &mut to[..4];
        // SAFETY: the slice holds four times 16 bytes.
        unsafe { vst4q_s32(to.as_mut_ptr().cast(), int32x4x4_t(a, b, c, d)) }
    }
    #[inline(always)]
    fn transpose_f(self, [a, b, c, d]: [F; 4], to: &mut [[f64; 4]]) {
        let to = &mut to[..4];
        // SAFETY: the slice holds four times 32 bytes.
        unsafe {
            vst4q_f64(to.as_mut_ptr().cast(), float64x2x4_t(a.0, b.0, c.0, d.0));
            vst4q_f64(to[2..].as_mut_ptr().cast(), float64x2x4_t(a.1, b.1, c.1, d.1));
        }
    }
    #[inline(always)]
    fn mask(self, bits: u32) -> M {
        // SAFETY: `LANE_BITS` holds 16 bytes.
        M(unsafe { vtstq_u32(vdupq_n_u32(bits), vld1q_u32(LANE_BITS.as_ptr())) })
    }
    #[inline(always)]
    fn lookup16(self, table: &[i32; 16], index: I) -> I {
        // SAFETY: the table holds 64 bytes, read as four times 16. A word
        // index becomes the four byte indices 4i..4i + 3, all below 64.
        unsafe {
            let bytes: *const u8 = table.as_ptr().cast();
            let table = uint8x16x4_t(
                vld1q_u8(bytes),
                vld1q_u8(bytes.add(16)),
                vld1q_u8(bytes.add(32)),
                vld1q_u8(bytes.add(48)),
            );
            let word = vandq_s32(index.0, vdupq_n_s32(15));
            let at = vmlaq_s32(vdupq_n_s32(0x0302_0100), word, vdupq_n_s32(0x0404_0404));
            I(vreinterpretq_s32_u8(vqtbl4q_u8(table, vreinterpretq_u8_s32(at))))
        }
    }
    #[inline(always)]
    fn load_pairs(self, table: &[u64], index: I) -> (I, I) {
        let last = crate::last_index(table);
        let mut at = [0; 4];
        // SAFETY: `at` holds 16 bytes. Each index is at most `last`, so the
        // entries read lie inside `table`.
        unsafe {
            let index = vminq_u32(vreinterpretq_u32_s32(index.0), vdupq_n_u32(last));
            vst1q_u32(at.as_mut_ptr(), index);
            let front =
                [*table.get_unchecked(at[0] as usize), *table.get_unchecked(at[1] as usize)];
            let back = [*table.get_unchecked(at[2] as usize), *table.get_unchecked(at[3] as usize)];
            let (low, high) = split_words(vld1q_u64(front.as_ptr()), vld1q_u64(back.as_ptr()));
            (I(vreinterpretq_s32_u32(low)), I(vreinterpretq_s32_u32(high)))
        }
    }
}

/// Methods `fn name(self, other) -> Self` on signed or unsigned halves.
macro_rules! binary16 {
    ($($name:ident $intrinsic:ident $to:ident $from:ident)*) => {$(
        #[inline(always)]
        fn $name(self, other: I) -> I {
            // SAFETY: NEON.
            I(unsafe { $from($intrinsic($to(self.0), $to(other.0))) })
        }
    )*};
}

/// Methods `fn name(self, other) -> Self` on whole lanes.
macro_rules! binary {
    ($($name:ident $intrinsic:ident)*) => {$(
        #[inline(always)]
        fn $name(self, other: I) -> I {
            // SAFETY: NEON.
            I(unsafe { $intrinsic(self.0, other.0) })
        }
    )*};
}

impl IntLanes for I {
    type M = M;

    #[inline(always)]
    fn any(self) -> bool {
        // SAFETY: every AArch64 machine of this target has NEON.
        unsafe { vmaxvq_u32(vreinterpretq_u32_s32(self.0)) != 0 }
    }

    binary! {
        mul vmulq_s32
        min vminq_s32
        max vmaxq_s32
    }
    binary16! {
        add16 vaddq_s16 vreinterpretq_s16_s32 vreinterpretq_s32_s16
        sub16 vsubq_s16 vreinterpretq_s16_s32 vreinterpretq_s32_s16
        add_sat_u16 vqaddq_u16 vreinterpretq_u16_s32 vreinterpretq_s32_u16
        mul16 vmulq_s16 vreinterpretq_s16_s32 vreinterpretq_s32_s16
        min16 vminq_s16 vreinterpretq_s16_s32 vreinterpretq_s32_s16
        max16 vmaxq_s16 vreinterpretq_s16_s32 vreinterpretq_s32_s16
        eq16 vceqq_s16 vreinterpretq_s16_s32 vreinterpretq_s32_u16
    }
    #[inline(always)]
    fn shl(self, count: u32) -> I {
        // SAFETY: NEON.
        I(unsafe { vshlq_s32(self.0, vdupq_n_s32(count as i32)) })
    }
    #[inline(always)]
    fn shr(self, count: u32) -> I {
        // SAFETY: NEON. A shift left by a negative count is one right.
        unsafe {
            let by = vdupq_n_s32(-(count as i32));
            I(vreinterpretq_s32_u32(vshlq_u32(vreinterpretq_u32_s32(self.0), by)))
        }
    }
    #[inline(always)]
    fn sar(self, count: u32) -> I {
        // SAFETY: NEON.
        I(unsafe { vshlq_s32(self.0, vdupq_n_s32(-(count as i32))) })
    }
    #[inline(always)]
    fn sar_each(self, count: I) -> I {
        // SAFETY: NEON.
        I(unsafe { vshlq_s32(self.0, vnegq_s32(count.0)) })
    }
    #[inline(always)]
    fn eq(self, other: I) -> M {
        // SAFETY: NEON.
        M(unsafe { vceqq_s32(self.0, other.0) })
    }
    #[inline(always)]
    fn gt(self, other: I) -> M {
        // SAFETY: NEON.
        M(unsafe { vcgtq_s32(self.0, other.0) })
    }
    #[inline(always)]
    fn select(self, other: I, mask: M) -> I {
        // SAFETY: NEON.
        I(unsafe { vbslq_s32(mask.0, self.0, other.0) })
    }
    #[inline(always)]
    fn mul_high_i16(self, other: I) -> I {
        // SAFETY: NEON.
        unsafe {
            let (a, b) = (vreinterpretq_s16_s32(self.0), vreinterpretq_s16_s32(other.0));
            let low = vreinterpretq_s16_s32(vmull_s16(vget_low_s16(a), vget_low_s16(b)));
            let high = vreinterpretq_s16_s32(vmull_high_s16(a, b));
            I(vreinterpretq_s32_s16(vuzp2q_s16(low, high)))
        }
    }
    #[inline(always)]
    fn shl16(self, count: u32) -> I {
        // SAFETY: NEON.
        unsafe {
            let by = vdupq_n_s16(count as i16);
            I(vreinterpretq_s32_s16(vshlq_s16(vreinterpretq_s16_s32(self.0), by)))
        }
    }
    #[inline(always)]
    fn shr16(self, count: u32) -> I {
        // SAFETY: NEON.
        unsafe {
            let by = vdupq_n_s16(-(count as i16));
            I(vreinterpretq_s32_u16(vshlq_u16(vreinterpretq_u16_s32(self.0), by)))
        }
    }
    #[inline(always)]
    fn dot_bytes(self, weights: I) -> I {
        // SAFETY: NEON.
        unsafe {
            let (a, w) = (vreinterpretq_u8_s32(self.0), vreinterpretq_u8_s32(weights.0));
            let low = vmull_u8(vget_low_u8(a), vget_low_u8(w));
            let high = vmull_high_u8(a, w);
            I(vreinterpretq_s32_u16(vpaddq_u16(low, high)))
        }
    }
}

impl FloatLanes for F {
    type I = I;
    type M = M;

    #[inline(always)]
    fn lt(self, other: F) -> M {
        // SAFETY: NEON.
        let (low, high) = unsafe { (vcltq_f64(self.0, other.0), vcltq_f64(self.1, other.1)) };
        M(split_words(low, high).0)
    }
    #[inline(always)]
    fn from_i32(lanes: I) -> F {
        // SAFETY: NEON.
        unsafe {
            let (low, high) = (vmovl_s32(vget_low_s32(lanes.0)), vmovl_high_s32(lanes.0));
            F(vcvtq_f64_s64(low), vcvtq_f64_s64(high))
        }
    }
    #[inline(always)]
    fn select(self, other: F, mask: M) -> F {
        // SAFETY: NEON.
        unsafe {
            let low = vreinterpretq_u64_u32(vzip1q_u32(mask.0, mask.0));
            let high = vreinterpretq_u64_u32(vzip2q_u32(mask.0, mask.0));
            F(vbslq_f64(low, self.0, other.0), vbslq_f64(high, self.1, other.1))
        }
    }
    #[inline(always)]
    fn abs(self) -> F {
        // SAFETY: NEON.
        unsafe { F(vabsq_f64(self.0), vabsq_f64(self.1)) }
    }
    #[inline(always)]
    fn trunc(self) -> F {
        // SAFETY: NEON.
        unsafe { F(vrndq_f64(self.0), vrndq_f64(self.1)) }
    }
    #[inline(always)]
    fn floor(self) -> F {
        // SAFETY: NEON.
        unsafe { F(vrndmq_f64(self.0), vrndmq_f64(self.1)) }
    }
    #[inline(always)]
    fn floor_i32(self) -> I {
        // SAFETY: NEON. Both conversions limit to their range.
        unsafe {
            let low = vqmovn_s64(vcvtmq_s64_f64(self.0));
            let high = vqmovn_s64(vcvtmq_s64_f64(self.1));
            I(vcombine_s32(low, high))
        }
    }
    #[inline(always)]
    fn high_word(self) -> I {
        // SAFETY: NEON.
        unsafe {
            let (a, b) = (vreinterpretq_u64_f64(self.0), vreinterpretq_u64_f64(self.1));
            I(vreinterpretq_s32_u32(split_words(a, b).1))
        }
    }
}

impl SingleLanes for G {
    type I = I;
    type F = F;
    type M = M;

    #[inline(always)]
    fn widen(self) -> F {
        // SAFETY: NEON.
        unsafe { F(vcvt_f64_f32(vget_low_f32(self.0)), vcvt_high_f64_f32(self.0)) }
    }
    #[inline(always)]
    fn truncate_i32(self) -> I {
        self.to_i32()
    }
    #[inline(always)]
    fn to_bits(self) -> I {
        // SAFETY: NEON.
        I(unsafe { vreinterpretq_s32_f32(self.0) })
    }
    #[inline(always)]
    fn from_bits(bits: I) -> G {
        // SAFETY: NEON.
        G(unsafe { vreinterpretq_f32_s32(bits.0) })
    }
    #[inline(always)]
    fn from_i32(lanes: I) -> G {
        // SAFETY: NEON.
        G(unsafe { vcvtq_f32_s32(lanes.0) })
    }
    #[inline(always)]
    fn to_i32(self) -> I {
        // SAFETY: NEON. The conversion limits, and gives 0 for no number.
        I(unsafe { vcvtq_s32_f32(self.0) })
    }
    #[inline(always)]
    fn lt(self, other: G) -> M {
        // SAFETY: NEON.
        M(unsafe { vcltq_f32(self.0, other.0) })
    }
}

impl MaskLanes for M {
    #[inline(always)]
    fn bits(self) -> u32 {
        // SAFETY: `LANE_BITS` holds 16 bytes.
        unsafe { vaddvq_u32(vandq_u32(self.0, vld1q_u32(LANE_BITS.as_ptr()))) }
    }
}

/// Implements an operator trait by an intrinsic on the wrapped register.
macro_rules! operator {
    ($lanes:ident, $trait:ident, $name:ident, $intrinsic:ident $(, $second:tt)?) => {
        impl core::ops::$trait for $lanes {
            type Output = $lanes;
            #[inline(always)]
            fn $name(self, other: $lanes) -> $lanes {
                // SAFETY: NEON.
                unsafe {
                    $lanes($intrinsic(self.0, other.0) $(, $intrinsic(self.$second, other.$second))?)
                }
            }
        }
    };
}

operator!(I, Add, add, vaddq_s32);
operator!(I, Sub, sub, vsubq_s32);
operator!(I, BitAnd, bitand, vandq_s32);
operator!(I, BitOr, bitor, vorrq_s32);
operator!(I, BitXor, bitxor, veorq_s32);
operator!(F, Add, add, vaddq_f64, 1);
operator!(F, Sub, sub, vsubq_f64, 1);
operator!(F, Mul, mul, vmulq_f64, 1);
operator!(F, Div, div, vdivq_f64, 1);
operator!(G, Add, add, vaddq_f32);
operator!(G, Sub, sub, vsubq_f32);
operator!(G, Mul, mul, vmulq_f32);
operator!(G, Div, div, vdivq_f32);
operator!(M, BitAnd, bitand, vandq_u32);
operator!(M, BitOr, bitor, vorrq_u32);
