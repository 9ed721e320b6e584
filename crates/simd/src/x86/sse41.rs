//! SSE4.1: four lanes; masks are registers.

use core::arch::x86_64::*;

use super::{binary, entry, float_operator, operator, shifts};
use crate::{FloatLanes, IntLanes, Kernel, Level, MaskLanes, Simd, SingleLanes};

/// The token of the SSE4.1 level.
#[derive(Clone, Copy, Debug)]
pub struct Sse41(());

/// Four integers.
#[derive(Clone, Copy)]
pub struct I(__m128i);
/// Four floats.
#[derive(Clone, Copy)]
pub struct F(__m128d, __m128d);
/// Four 32-bit floats.
#[derive(Clone, Copy)]
pub struct G(__m128);
/// Four switches, all ones or zero.
#[derive(Clone, Copy)]
pub struct M(__m128i);

impl Sse41 {
    /// The token, where the machine has all of the features used. The first
    /// processors with SSE4.1 lack POPCNT.
    #[inline]
    pub fn detect() -> Option<Self> {
        (is_x86_feature_detected!("sse4.1")
            && is_x86_feature_detected!("ssse3")
            && is_x86_feature_detected!("popcnt"))
        .then_some(Self(()))
    }
}

/// The even and the odd words of two registers.
#[inline(always)]
fn split_words(a: __m128i, b: __m128i) -> (__m128i, __m128i) {
    // SAFETY: SSE2, part of x86-64.
    unsafe {
        let (a, b) = (_mm_castsi128_ps(a), _mm_castsi128_ps(b));
        (
            _mm_castps_si128(_mm_shuffle_ps::<0x88>(a, b)),
            _mm_castps_si128(_mm_shuffle_ps::<0xdd>(a, b)),
        )
    }
}

/// Writes two lanes of four vectors side by side.
#[inline(always)]
fn transpose_two([a, b, c, d]: [__m128d; 4], to: &mut [[f64; 4]]) {
    let to = &mut to[..2];
    // SAFETY: SSE2, part of x86-64; the slice holds twice 32 bytes.
    unsafe {
        let ab = [_mm_unpacklo_pd(a, b), _mm_unpackhi_pd(a, b)];
        let cd = [_mm_unpacklo_pd(c, d), _mm_unpackhi_pd(c, d)];
        for i in 0..2 {
            _mm_storeu_pd(to[i].as_mut_ptr(), ab[i]);
            _mm_storeu_pd(to[i][2..].as_mut_ptr(), cd[i]);
        }
    }
}

impl Simd for Sse41 {
    const LANES: usize = 4;
    const LEVEL: Level = Level::Sse41;
    type I = I;
    type F = F;
    type G = G;
    type M = M;

    #[inline(always)]
    fn vectorize<K: Kernel>(self, kernel: K) -> K::Output {
        #[target_feature(enable = "sse4.1,ssse3,popcnt")]
        fn inner<K: Kernel>(simd: Sse41, kernel: K) -> K::Output {
            kernel.run(simd)
        }
        // SAFETY: the token proves every feature.
        unsafe { inner(self, kernel) }
    }
    #[inline(always)]
    fn splat(self, value: i32) -> I {
        // SAFETY: SSE2.
        I(unsafe { _mm_set1_epi32(value) })
    }
    #[inline(always)]
    fn load(self, from: &[i32]) -> I {
        let from = &from[..4];
        // SAFETY: the slice holds 16 bytes; the load takes any alignment.
        I(unsafe { _mm_loadu_si128(from.as_ptr().cast()) })
    }
    #[inline(always)]
    fn store(self, lanes: I, to: &mut [i32]) {
        let to = &mut to[..4];
        // SAFETY: the slice holds 16 bytes; the store takes any alignment.
        unsafe { _mm_storeu_si128(to.as_mut_ptr().cast(), lanes.0) }
    }
    #[inline(always)]
    fn load16(self, from: &[u16]) -> I {
        let from = &from[..4];
        // SAFETY: the slice holds 8 bytes; the token proves SSE4.1.
        I(unsafe { _mm_cvtepu16_epi32(_mm_loadl_epi64(from.as_ptr().cast())) })
    }
    #[inline(always)]
    fn store16(self, lanes: I, to: &mut [u16], mask: M) {
        let to = &mut to[..4];
        // SAFETY: the slice holds 8 bytes; the token proves SSE4.1.
        unsafe {
            let low = _mm_and_si128(lanes.0, _mm_set1_epi32(0xffff));
            let new = _mm_packus_epi32(low, low);
            let on = _mm_packs_epi32(mask.0, mask.0);
            let old = _mm_loadl_epi64(to.as_ptr().cast());
            _mm_storel_epi64(to.as_mut_ptr().cast(), _mm_blendv_epi8(old, new, on));
        }
    }
    #[inline(always)]
    fn store16_all(self, lanes: I, to: &mut [u16]) {
        let to = &mut to[..4];
        // SAFETY: the slice holds 8 bytes; the token proves SSE4.1.
        unsafe {
            let low = _mm_and_si128(lanes.0, _mm_set1_epi32(0xffff));
            _mm_storel_epi64(to.as_mut_ptr().cast(), _mm_packus_epi32(low, low));
        }
    }
    #[inline(always)]
    fn store_masked(self, lanes: I, to: &mut [i32], mask: M) {
        let old = self.load(to);
        self.store(lanes.select(old, mask), to);
    }
    #[inline(always)]
    fn splat_f(self, value: f64) -> F {
        // SAFETY: SSE2.
        unsafe { F(_mm_set1_pd(value), _mm_set1_pd(value)) }
    }
    #[inline(always)]
    fn load_f(self, from: &[f64]) -> F {
        let from = &from[..4];
        // SAFETY: the slice holds 32 bytes.
        unsafe { F(_mm_loadu_pd(from.as_ptr()), _mm_loadu_pd(from.as_ptr().add(2))) }
    }
    #[inline(always)]
    fn store_f(self, lanes: F, to: &mut [f64]) {
        let to = &mut to[..4];
        // SAFETY: the slice holds 32 bytes.
        unsafe {
            _mm_storeu_pd(to.as_mut_ptr(), lanes.0);
            _mm_storeu_pd(to.as_mut_ptr().add(2), lanes.1);
        }
    }
    #[inline(always)]
    fn splat_g(self, value: f32) -> G {
        // SAFETY: SSE.
        G(unsafe { _mm_set1_ps(value) })
    }
    #[inline(always)]
    fn load_g(self, from: &[f32]) -> G {
        let from = &from[..4];
        // SAFETY: the slice holds 16 bytes; the load takes any alignment.
        G(unsafe { _mm_loadu_ps(from.as_ptr()) })
    }
    #[inline(always)]
    fn store_g(self, lanes: G, to: &mut [f32]) {
        let to = &mut to[..4];
        // SAFETY: the slice holds 16 bytes; the store takes any alignment.
        unsafe { _mm_storeu_ps(to.as_mut_ptr(), lanes.0) }
    }
    #[inline(always)]
    fn transpose(self, [I(a), I(b), I(c), I(d)]: [I; 4], to: &mut [[i32; 4]]) {
        let to = &mut to[..4];
        // SAFETY: the slice holds four times 16 bytes; the token proves SSE4.1.
        unsafe {
            let (ab_low, ab_high) = (_mm_unpacklo_epi32(a, b), _mm_unpackhi_epi32(a, b));
            let (cd_low, cd_high) = (_mm_unpacklo_epi32(c, d), _mm_unpackhi_epi32(c, d));
            let rows = [
                _mm_unpacklo_epi64(ab_low, cd_low),
                _mm_unpackhi_epi64(ab_low, cd_low),
                _mm_unpacklo_epi64(ab_high, cd_high),
                _mm_unpackhi_epi64(ab_high, cd_high),
            ];
            for (to, row) in to.iter_mut().zip(rows) {
                _mm_storeu_si128(to.as_mut_ptr().cast(), row);
            }
        }
    }
    #[inline(always)]
    fn transpose_f(self, [a, b, c, d]: [F; 4], to: &mut [[f64; 4]]) {
        let (front, back) = to[..4].split_at_mut(2);
        transpose_two([a.0, b.0, c.0, d.0], front);
        transpose_two([a.1, b.1, c.1, d.1], back);
    }
    #[inline(always)]
    fn mask(self, bits: u32) -> M {
        // SAFETY: SSE2.
        unsafe {
            let each = _mm_setr_epi32(1, 2, 4, 8);
            M(_mm_cmpeq_epi32(_mm_and_si128(_mm_set1_epi32(bits as i32), each), each))
        }
    }
    #[inline(always)]
    fn lookup16(self, table: &[i32; 16], index: I) -> I {
        let mut at = [0; 4];
        self.store(index, &mut at);
        self.load(&[
            table[(at[0] & 15) as usize],
            table[(at[1] & 15) as usize],
            table[(at[2] & 15) as usize],
            table[(at[3] & 15) as usize],
        ])
    }
    #[inline(always)]
    fn load_pairs(self, table: &[u64], index: I) -> (I, I) {
        let last = crate::last_index(table);
        let mut at = [0; 4];
        // SAFETY: the token proves SSE4.1. Each index is at most `last`, so the
        // entries read lie inside `table`.
        unsafe {
            let index = I(_mm_min_epu32(index.0, _mm_set1_epi32(last as i32)));
            self.store(index, &mut at);
            let (low, high) = split_words(
                _mm_set_epi64x(entry(table, at[1]), entry(table, at[0])),
                _mm_set_epi64x(entry(table, at[3]), entry(table, at[2])),
            );
            (I(low), I(high))
        }
    }
}

impl IntLanes for I {
    type M = M;

    #[inline(always)]
    fn any(self) -> bool {
        // SAFETY: lanes exist only where SSE4.1 was detected.
        unsafe { _mm_testz_si128(self.0, self.0) == 0 }
    }

    binary! {
        mul _mm_mullo_epi32
        min _mm_min_epi32
        max _mm_max_epi32
        add16 _mm_add_epi16
        sub16 _mm_sub_epi16
        add_sat_u16 _mm_adds_epu16
        mul16 _mm_mullo_epi16
        mul_high_i16 _mm_mulhi_epi16
        min16 _mm_min_epi16
        max16 _mm_max_epi16
        eq16 _mm_cmpeq_epi16
        dot_bytes _mm_maddubs_epi16
    }
    shifts! {
        shl _mm_sll_epi32
        shr _mm_srl_epi32
        sar _mm_sra_epi32
        shl16 _mm_sll_epi16
        shr16 _mm_srl_epi16
    }
    #[inline(always)]
    fn sar_each(self, count: I) -> I {
        // SAFETY: lanes exist only where SSE4.1 was detected. A shift takes
        // its count from the low 64 bits of a register: lane by lane, each
        // count is brought there, and the lane is picked from that shift.
        unsafe {
            let upper = _mm_unpackhi_epi64(count.0, count.0);
            let lane0 = _mm_sra_epi32(self.0, _mm_cvtepu32_epi64(count.0));
            let lane1 = _mm_sra_epi32(self.0, _mm_srli_epi64::<32>(count.0));
            let lane2 = _mm_sra_epi32(self.0, _mm_cvtepu32_epi64(upper));
            let lane3 = _mm_sra_epi32(self.0, _mm_srli_epi64::<32>(upper));
            I(_mm_blend_epi16::<0xf0>(
                _mm_blend_epi16::<0x0c>(lane0, lane1),
                _mm_blend_epi16::<0xc0>(lane2, lane3),
            ))
        }
    }
    #[inline(always)]
    fn eq(self, other: I) -> M {
        // SAFETY: SSE2.
        M(unsafe { _mm_cmpeq_epi32(self.0, other.0) })
    }
    #[inline(always)]
    fn gt(self, other: I) -> M {
        // SAFETY: SSE2.
        M(unsafe { _mm_cmpgt_epi32(self.0, other.0) })
    }
    #[inline(always)]
    fn select(self, other: I, mask: M) -> I {
        // SAFETY: lanes exist only where SSE4.1 was detected.
        I(unsafe { _mm_blendv_epi8(other.0, self.0, mask.0) })
    }
}

impl FloatLanes for F {
    type I = I;
    type M = M;

    #[inline(always)]
    fn lt(self, other: F) -> M {
        // SAFETY: SSE2.
        unsafe {
            let low = _mm_castpd_si128(_mm_cmplt_pd(self.0, other.0));
            let high = _mm_castpd_si128(_mm_cmplt_pd(self.1, other.1));
            M(split_words(low, high).0)
        }
    }
    #[inline(always)]
    fn from_i32(lanes: I) -> F {
        // SAFETY: lanes exist only where SSE4.1 was detected.
        unsafe {
            let back = _mm_shuffle_epi32::<0b1110>(lanes.0);
            F(_mm_cvtepi32_pd(lanes.0), _mm_cvtepi32_pd(back))
        }
    }
    #[inline(always)]
    fn select(self, other: F, mask: M) -> F {
        // SAFETY: lanes exist only where SSE4.1 was detected.
        unsafe {
            let low = _mm_castsi128_pd(_mm_unpacklo_epi32(mask.0, mask.0));
            let high = _mm_castsi128_pd(_mm_unpackhi_epi32(mask.0, mask.0));
            F(_mm_blendv_pd(other.0, self.0, low), _mm_blendv_pd(other.1, self.1, high))
        }
    }
    #[inline(always)]
    fn abs(self) -> F {
        // SAFETY: lanes exist only where SSE4.1 was detected.
        unsafe {
            let sign = _mm_set1_pd(-0.0);
            F(_mm_andnot_pd(sign, self.0), _mm_andnot_pd(sign, self.1))
        }
    }
    #[inline(always)]
    fn trunc(self) -> F {
        const TO_ZERO: i32 = _MM_FROUND_TO_ZERO | _MM_FROUND_NO_EXC;
        // SAFETY: lanes exist only where SSE4.1 was detected.
        unsafe { F(_mm_round_pd::<TO_ZERO>(self.0), _mm_round_pd::<TO_ZERO>(self.1)) }
    }
    #[inline(always)]
    fn floor(self) -> F {
        // SAFETY: lanes exist only where SSE4.1 was detected.
        unsafe { F(_mm_floor_pd(self.0), _mm_floor_pd(self.1)) }
    }
    #[inline(always)]
    fn floor_i32(self) -> I {
        #[inline(always)]
        fn half(x: __m128d) -> __m128i {
            // SAFETY: lanes exist only where SSE4.1 was detected.
            unsafe {
                // What does not fit becomes the least integer.
                let limited = _mm_min_pd(x, _mm_set1_pd(i32::MAX as f64));
                _mm_cvttpd_epi32(_mm_floor_pd(limited))
            }
        }
        // SAFETY: SSE2.
        I(unsafe { _mm_unpacklo_epi64(half(self.0), half(self.1)) })
    }
    #[inline(always)]
    fn high_word(self) -> I {
        // SAFETY: SSE2.
        let (a, b) = unsafe { (_mm_castpd_si128(self.0), _mm_castpd_si128(self.1)) };
        I(split_words(a, b).1)
    }
}

impl SingleLanes for G {
    type I = I;
    type F = F;
    type M = M;

    #[inline(always)]
    fn widen(self) -> F {
        // SAFETY: lanes exist only where SSE4.1 was detected.
        unsafe { F(_mm_cvtps_pd(self.0), _mm_cvtps_pd(_mm_movehl_ps(self.0, self.0))) }
    }
    #[inline(always)]
    fn truncate_i32(self) -> I {
        // SAFETY: lanes exist only where SSE4.1 was detected.
        I(unsafe { _mm_cvttps_epi32(self.0) })
    }
    #[inline(always)]
    fn to_bits(self) -> I {
        // SAFETY: lanes exist only where SSE4.1 was detected.
        I(unsafe { _mm_castps_si128(self.0) })
    }
    #[inline(always)]
    fn from_bits(bits: I) -> G {
        // SAFETY: lanes exist only where SSE4.1 was detected.
        G(unsafe { _mm_castsi128_ps(bits.0) })
    }
    #[inline(always)]
    fn from_i32(lanes: I) -> G {
        // SAFETY: lanes exist only where SSE4.1 was detected.
        G(unsafe { _mm_cvtepi32_ps(lanes.0) })
    }
    #[inline(always)]
    fn to_i32(self) -> I {
        // SAFETY: lanes exist only where SSE4.1 was detected.
        unsafe {
            // The conversion gives the least integer for what does not fit.
            let above = _mm_castps_si128(_mm_cmpge_ps(self.0, _mm_set1_ps(2_147_483_648.0)));
            let number = _mm_castps_si128(_mm_cmpord_ps(self.0, self.0));
            I(_mm_and_si128(_mm_xor_si128(_mm_cvttps_epi32(self.0), above), number))
        }
    }
    #[inline(always)]
    fn lt(self, other: G) -> M {
        // SAFETY: lanes exist only where SSE4.1 was detected.
        M(unsafe { _mm_castps_si128(_mm_cmplt_ps(self.0, other.0)) })
    }
}

impl MaskLanes for M {
    #[inline(always)]
    fn bits(self) -> u32 {
        // SAFETY: SSE2.
        unsafe { _mm_movemask_ps(_mm_castsi128_ps(self.0)) as u32 }
    }
}

operator!(I, Add, add, _mm_add_epi32);
operator!(I, Sub, sub, _mm_sub_epi32);
operator!(I, BitAnd, bitand, _mm_and_si128);
operator!(I, BitOr, bitor, _mm_or_si128);
operator!(I, BitXor, bitxor, _mm_xor_si128);
float_operator!(F, Add, add, _mm_add_pd);
float_operator!(F, Sub, sub, _mm_sub_pd);
float_operator!(F, Mul, mul, _mm_mul_pd);
float_operator!(F, Div, div, _mm_div_pd);
operator!(G, Add, add, _mm_add_ps);
operator!(G, Sub, sub, _mm_sub_ps);
operator!(G, Mul, mul, _mm_mul_ps);
operator!(G, Div, div, _mm_div_ps);
operator!(M, BitAnd, bitand, _mm_and_si128);
operator!(M, BitOr, bitor, _mm_or_si128);
