//! AVX2: eight lanes; masks are registers.

use core::arch::x86_64::*;

use super::{binary, float_operator, four, four_at, operator, shifts};
use crate::{FloatLanes, IntLanes, Kernel, Level, MaskLanes, Simd, SingleLanes};

/// The token of the AVX2 level.
#[derive(Clone, Copy, Debug)]
pub struct Avx2(());

/// Eight integers.
#[derive(Clone, Copy)]
pub struct I(__m256i);
/// Eight floats.
#[derive(Clone, Copy)]
pub struct F(__m256d, __m256d);
/// Eight 32-bit floats.
#[derive(Clone, Copy)]
pub struct G(__m256);
/// Eight switches, all ones or zero.
#[derive(Clone, Copy)]
pub struct M(__m256i);

impl Avx2 {
    /// The token, where the machine has AVX2.
    #[inline]
    pub fn detect() -> Option<Self> {
        (is_x86_feature_detected!("avx2") && is_x86_feature_detected!("popcnt")).then_some(Self(()))
    }
}

/// The even and the odd words of two registers, in order.
#[inline(always)]
fn split_words(a: __m256i, b: __m256i) -> (__m256i, __m256i) {
    // SAFETY: only called on lanes, which exist only where AVX2 was detected.
    unsafe {
        let (a, b) = (_mm256_castsi256_ps(a), _mm256_castsi256_ps(b));
        let even = _mm256_castps_si256(_mm256_shuffle_ps::<0x88>(a, b));
        let odd = _mm256_castps_si256(_mm256_shuffle_ps::<0xdd>(a, b));
        (_mm256_permute4x64_epi64::<0xd8>(even), _mm256_permute4x64_epi64::<0xd8>(odd))
    }
}

/// Writes four lanes of four vectors side by side.
#[inline(always)]
fn transpose_four([a, b, c, d]: [__m256d; 4], to: &mut [[f64; 4]]) {
    let to = &mut to[..4];
    // SAFETY: only called on lanes, which exist only where AVX2 was detected; the
    // slice holds four times 32 bytes.
    unsafe {
        let ab = [_mm256_unpacklo_pd(a, b), _mm256_unpackhi_pd(a, b)];
        let cd = [_mm256_unpacklo_pd(c, d), _mm256_unpackhi_pd(c, d)];
        for i in 0..2 {
            let (even, odd) = (to[i].as_mut_ptr(), to[2 + i].as_mut_ptr());
            _mm256_storeu_pd(even, _mm256_permute2f128_pd::<0x20>(ab[i], cd[i]));
            _mm256_storeu_pd(odd, _mm256_permute2f128_pd::<0x31>(ab[i], cd[i]));
        }
    }
}

impl Simd for Avx2 {
    const LANES: usize = 8;
    const LEVEL: Level = Level::Avx2;
    type I = I;
    type F = F;
    type G = G;
    type M = M;

    #[inline(always)]
    fn vectorize<K: Kernel>(self, kernel: K) -> K::Output {
        #[target_feature(enable = "avx2,popcnt")]
        fn inner<K: Kernel>(simd: Avx2, kernel: K) -> K::Output {
            kernel.run(simd)
        }
        // SAFETY: the token proves both features.
        unsafe { inner(self, kernel) }
    }
    #[inline(always)]
    fn splat(self, value: i32) -> I {
        // SAFETY: the token proves AVX2.
        I(unsafe { _mm256_set1_epi32(value) })
    }
    #[inline(always)]
    fn load(self, from: &[i32]) -> I {
        let from = &from[..8];
        // SAFETY: the slice holds 32 bytes; the load takes any alignment.
        I(unsafe { _mm256_loadu_si256(from.as_ptr().cast()) })
    }
    #[inline(always)]
    fn store(self, lanes: I, to: &mut [i32]) {
        let to = &mut to[..8];
        // SAFETY: the slice holds 32 bytes; the store takes any alignment.
        unsafe { _mm256_storeu_si256(to.as_mut_ptr().cast(), lanes.0) }
    }
    #[inline(always)]
    fn load16(self, from: &[u16]) -> I {
        let from = &from[..8];
        // SAFETY: the slice holds 16 bytes; the token proves AVX2.
        I(unsafe { _mm256_cvtepu16_epi32(_mm_loadu_si128(from.as_ptr().cast())) })
    }
    #[inline(always)]
    fn store16(self, lanes: I, to: &mut [u16], mask: M) {
        let to = &mut to[..8];
        // SAFETY: the slice holds 16 bytes; the token proves AVX2.
        unsafe {
            let low = _mm256_and_si256(lanes.0, _mm256_set1_epi32(0xffff));
            let new =
                _mm_packus_epi32(_mm256_castsi256_si128(low), _mm256_extracti128_si256::<1>(low));
            let on = _mm_packs_epi32(
                _mm256_castsi256_si128(mask.0),
                _mm256_extracti128_si256::<1>(mask.0),
            );
            let old = _mm_loadu_si128(to.as_ptr().cast());
            _mm_storeu_si128(to.as_mut_ptr().cast(), _mm_blendv_epi8(old, new, on));
        }
    }
    #[inline(always)]
    fn store16_all(self, lanes: I, to: &mut [u16]) {
        let to = &mut to[..8];
        // SAFETY: the slice holds 16 bytes; the token proves AVX2.
        unsafe {
            let low = _mm256_and_si256(lanes.0, _mm256_set1_epi32(0xffff));
            let new =
                _mm_packus_epi32(_mm256_castsi256_si128(low), _mm256_extracti128_si256::<1>(low));
            _mm_storeu_si128(to.as_mut_ptr().cast(), new);
        }
    }
    #[inline(always)]
    fn store_masked(self, lanes: I, to: &mut [i32], mask: M) {
        // Not a masked store: on Zen 4 that takes ten times as long, whatever
        // the mask.
        let old = self.load(to);
        self.store(lanes.select(old, mask), to);
    }
    #[inline(always)]
    fn splat_f(self, value: f64) -> F {
        // SAFETY: the token proves AVX2.
        unsafe { F(_mm256_set1_pd(value), _mm256_set1_pd(value)) }
    }
    #[inline(always)]
    fn load_f(self, from: &[f64]) -> F {
        let from = &from[..8];
        // SAFETY: the slice holds 64 bytes.
        unsafe { F(_mm256_loadu_pd(from.as_ptr()), _mm256_loadu_pd(from.as_ptr().add(4))) }
    }
    #[inline(always)]
    fn store_f(self, lanes: F, to: &mut [f64]) {
        let to = &mut to[..8];
        // SAFETY: the slice holds 64 bytes.
        unsafe {
            _mm256_storeu_pd(to.as_mut_ptr(), lanes.0);
            _mm256_storeu_pd(to.as_mut_ptr().add(4), lanes.1);
        }
    }
    #[inline(always)]
    fn splat_g(self, value: f32) -> G {
        // SAFETY: the token proves AVX2.
        G(unsafe { _mm256_set1_ps(value) })
    }
    #[inline(always)]
    fn load_g(self, from: &[f32]) -> G {
        let from = &from[..8];
        // SAFETY: the slice holds 32 bytes; the load takes any alignment.
        G(unsafe { _mm256_loadu_ps(from.as_ptr()) })
    }
    #[inline(always)]
    fn store_g(self, lanes: G, to: &mut [f32]) {
        let to = &mut to[..8];
        // SAFETY: the slice holds 32 bytes; the store takes any alignment.
        unsafe { _mm256_storeu_ps(to.as_mut_ptr(), lanes.0) }
    }
    #[inline(always)]
    fn transpose(self, [I(a), I(b), I(c), I(d)]: [I; 4], to: &mut [[i32; 4]]) {
        let to = &mut to[..8];
        // SAFETY: the slice holds eight times 16 bytes; the token proves AVX2.
        unsafe {
            let (ab_low, ab_high) = (_mm256_unpacklo_epi32(a, b), _mm256_unpackhi_epi32(a, b));
            let (cd_low, cd_high) = (_mm256_unpacklo_epi32(c, d), _mm256_unpackhi_epi32(c, d));
            // Half `h` of row `r` is lane 4h + r.
            let rows = [
                _mm256_unpacklo_epi64(ab_low, cd_low),
                _mm256_unpackhi_epi64(ab_low, cd_low),
                _mm256_unpacklo_epi64(ab_high, cd_high),
                _mm256_unpackhi_epi64(ab_high, cd_high),
            ];
            for (i, row) in rows.into_iter().enumerate() {
                let halves = [_mm256_castsi256_si128(row), _mm256_extracti128_si256::<1>(row)];
                _mm_storeu_si128(to[i].as_mut_ptr().cast(), halves[0]);
                _mm_storeu_si128(to[4 + i].as_mut_ptr().cast(), halves[1]);
            }
        }
    }
    #[inline(always)]
    fn transpose_f(self, [a, b, c, d]: [F; 4], to: &mut [[f64; 4]]) {
        let (front, back) = to[..8].split_at_mut(4);
        transpose_four([a.0, b.0, c.0, d.0], front);
        transpose_four([a.1, b.1, c.1, d.1], back);
    }
    #[inline(always)]
    fn mask(self, bits: u32) -> M {
        // SAFETY: the token proves AVX2.
        unsafe {
            let each = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
            let bits = _mm256_set1_epi32(bits as i32);
            M(_mm256_cmpeq_epi32(_mm256_and_si256(bits, each), each))
        }
    }
    #[inline(always)]
    fn lookup16(self, table: &[i32; 16], index: I) -> I {
        let (low, high) = (self.load(&table[..8]), self.load(&table[8..]));
        // SAFETY: the token proves AVX2. The permutes use the low three bits,
        // the blend the sign bit, where bit 3 was moved.
        unsafe {
            let low = _mm256_castsi256_ps(_mm256_permutevar8x32_epi32(low.0, index.0));
            let high = _mm256_castsi256_ps(_mm256_permutevar8x32_epi32(high.0, index.0));
            let upper = _mm256_castsi256_ps(_mm256_slli_epi32::<28>(index.0));
            I(_mm256_castps_si256(_mm256_blendv_ps(low, high, upper)))
        }
    }
    #[inline(always)]
    fn load_pairs(self, table: &[u64], index: I) -> (I, I) {
        let last = crate::last_index(table);
        let mut at = [0; 8];
        // SAFETY: the token proves AVX2. Each index is at most `last`, so the
        // entries read lie inside `table`.
        unsafe {
            let index = I(_mm256_min_epu32(index.0, _mm256_set1_epi32(last as i32)));
            self.store(index, &mut at);
            let (low, high) = split_words(
                four(table, [at[0], at[1], at[2], at[3]]),
                four(table, [at[4], at[5], at[6], at[7]]),
            );
            (I(low), I(high))
        }
    }
    #[inline(always)]
    fn load_pairs_at(self, table: &[u64], index: &[i32]) -> (I, I) {
        let last = crate::last_index(table);
        let index = &index[..8];
        // SAFETY: the token proves AVX2. No index is above `last`, so the
        // entries read lie inside `table`.
        unsafe {
            let lanes = _mm256_loadu_si256(index.as_ptr().cast());
            let last = _mm256_set1_epi32(last as i32);
            let excess = _mm256_xor_si256(_mm256_max_epu32(lanes, last), last);
            if _mm256_testz_si256(excess, excess) == 0 {
                return self.load_pairs(table, I(lanes));
            }
            let (low, high) = split_words(four_at(table, index, 0), four_at(table, index, 4));
            (I(low), I(high))
        }
    }
}

impl IntLanes for I {
    type M = M;

    #[inline(always)]
    fn any(self) -> bool {
        // SAFETY: lanes exist only where AVX2 was detected.
        unsafe { _mm256_testz_si256(self.0, self.0) == 0 }
    }

    binary! {
        mul _mm256_mullo_epi32
        min _mm256_min_epi32
        max _mm256_max_epi32
        sar_each _mm256_srav_epi32
        add16 _mm256_add_epi16
        sub16 _mm256_sub_epi16
        add_sat_u16 _mm256_adds_epu16
        mul16 _mm256_mullo_epi16
        mul_high_i16 _mm256_mulhi_epi16
        min16 _mm256_min_epi16
        max16 _mm256_max_epi16
        eq16 _mm256_cmpeq_epi16
        dot_bytes _mm256_maddubs_epi16
    }
    shifts! {
        shl _mm256_sll_epi32
        shr _mm256_srl_epi32
        sar _mm256_sra_epi32
        shl16 _mm256_sll_epi16
        shr16 _mm256_srl_epi16
    }
    #[inline(always)]
    fn eq(self, other: I) -> M {
        // SAFETY: lanes exist only where AVX2 was detected.
        M(unsafe { _mm256_cmpeq_epi32(self.0, other.0) })
    }
    #[inline(always)]
    fn gt(self, other: I) -> M {
        // SAFETY: lanes exist only where AVX2 was detected.
        M(unsafe { _mm256_cmpgt_epi32(self.0, other.0) })
    }
    #[inline(always)]
    fn select(self, other: I, mask: M) -> I {
        // SAFETY: lanes exist only where AVX2 was detected.
        I(unsafe { _mm256_blendv_epi8(other.0, self.0, mask.0) })
    }
}

impl FloatLanes for F {
    type I = I;
    type M = M;

    #[inline(always)]
    fn lt(self, other: F) -> M {
        // SAFETY: lanes exist only where AVX2 was detected.
        unsafe {
            let low = _mm256_castpd_si256(_mm256_cmp_pd::<_CMP_LT_OQ>(self.0, other.0));
            let high = _mm256_castpd_si256(_mm256_cmp_pd::<_CMP_LT_OQ>(self.1, other.1));
            M(split_words(low, high).0)
        }
    }
    #[inline(always)]
    fn from_i32(lanes: I) -> F {
        // SAFETY: lanes exist only where AVX2 was detected.
        unsafe {
            F(
                _mm256_cvtepi32_pd(_mm256_castsi256_si128(lanes.0)),
                _mm256_cvtepi32_pd(_mm256_extracti128_si256::<1>(lanes.0)),
            )
        }
    }
    #[inline(always)]
    fn select(self, other: F, mask: M) -> F {
        // SAFETY: lanes exist only where AVX2 was detected.
        unsafe {
            let low = _mm256_cvtepi32_epi64(_mm256_castsi256_si128(mask.0));
            let high = _mm256_cvtepi32_epi64(_mm256_extracti128_si256::<1>(mask.0));
            F(
                _mm256_blendv_pd(other.0, self.0, _mm256_castsi256_pd(low)),
                _mm256_blendv_pd(other.1, self.1, _mm256_castsi256_pd(high)),
            )
        }
    }
    #[inline(always)]
    fn abs(self) -> F {
        // SAFETY: lanes exist only where AVX2 was detected.
        unsafe {
            let sign = _mm256_set1_pd(-0.0);
            F(_mm256_andnot_pd(sign, self.0), _mm256_andnot_pd(sign, self.1))
        }
    }
    #[inline(always)]
    fn trunc(self) -> F {
        const TO_ZERO: i32 = _MM_FROUND_TO_ZERO | _MM_FROUND_NO_EXC;
        // SAFETY: lanes exist only where AVX2 was detected.
        unsafe { F(_mm256_round_pd::<TO_ZERO>(self.0), _mm256_round_pd::<TO_ZERO>(self.1)) }
    }
    #[inline(always)]
    fn floor(self) -> F {
        // SAFETY: lanes exist only where AVX2 was detected.
        unsafe { F(_mm256_floor_pd(self.0), _mm256_floor_pd(self.1)) }
    }
    #[inline(always)]
    fn floor_i32(self) -> I {
        #[inline(always)]
        fn half(x: __m256d) -> __m128i {
            // SAFETY: lanes exist only where AVX2 was detected.
            unsafe {
                // What does not fit becomes the least integer.
                let limited = _mm256_min_pd(x, _mm256_set1_pd(i32::MAX as f64));
                _mm256_cvttpd_epi32(_mm256_floor_pd(limited))
            }
        }
        // SAFETY: lanes exist only where AVX2 was detected.
        I(unsafe { _mm256_set_m128i(half(self.1), half(self.0)) })
    }
    #[inline(always)]
    fn high_word(self) -> I {
        // SAFETY: lanes exist only where AVX2 was detected.
        let (a, b) = unsafe { (_mm256_castpd_si256(self.0), _mm256_castpd_si256(self.1)) };
        I(split_words(a, b).1)
    }
}

impl SingleLanes for G {
    type I = I;
    type F = F;
    type M = M;

    #[inline(always)]
    fn widen(self) -> F {
        // SAFETY: lanes exist only where AVX2 was detected.
        unsafe {
            F(
                _mm256_cvtps_pd(_mm256_castps256_ps128(self.0)),
                _mm256_cvtps_pd(_mm256_extractf128_ps::<1>(self.0)),
            )
        }
    }
    #[inline(always)]
    fn truncate_i32(self) -> I {
        // SAFETY: lanes exist only where AVX2 was detected.
        I(unsafe { _mm256_cvttps_epi32(self.0) })
    }
    #[inline(always)]
    fn to_bits(self) -> I {
        // SAFETY: lanes exist only where AVX2 was detected.
        I(unsafe { _mm256_castps_si256(self.0) })
    }
    #[inline(always)]
    fn from_bits(bits: I) -> G {
        // SAFETY: lanes exist only where AVX2 was detected.
        G(unsafe { _mm256_castsi256_ps(bits.0) })
    }
    #[inline(always)]
    fn from_i32(lanes: I) -> G {
        // SAFETY: lanes exist only where AVX2 was detected.
        G(unsafe { _mm256_cvtepi32_ps(lanes.0) })
    }
    #[inline(always)]
    fn to_i32(self) -> I {
        // SAFETY: lanes exist only where AVX2 was detected.
        unsafe {
            // The conversion gives the least integer for what does not fit.
            let limit = _mm256_set1_ps(2_147_483_648.0);
            let above = _mm256_castps_si256(_mm256_cmp_ps::<_CMP_GE_OQ>(self.0, limit));
            let number = _mm256_castps_si256(_mm256_cmp_ps::<_CMP_ORD_Q>(self.0, self.0));
            I(_mm256_and_si256(_mm256_xor_si256(_mm256_cvttps_epi32(self.0), above), number))
        }
    }
    #[inline(always)]
    fn lt(self, other: G) -> M {
        // SAFETY: lanes exist only where AVX2 was detected.
        M(unsafe { _mm256_castps_si256(_mm256_cmp_ps::<_CMP_LT_OQ>(self.0, other.0)) })
    }
}

impl MaskLanes for M {
    #[inline(always)]
    fn bits(self) -> u32 {
        // SAFETY: lanes exist only where AVX2 was detected.
        unsafe { _mm256_movemask_ps(_mm256_castsi256_ps(self.0)) as u32 }
    }
}

operator!(I, Add, add, _mm256_add_epi32);
operator!(I, Sub, sub, _mm256_sub_epi32);
operator!(I, BitAnd, bitand, _mm256_and_si256);
operator!(I, BitOr, bitor, _mm256_or_si256);
operator!(I, BitXor, bitxor, _mm256_xor_si256);
float_operator!(F, Add, add, _mm256_add_pd);
float_operator!(F, Sub, sub, _mm256_sub_pd);
float_operator!(F, Mul, mul, _mm256_mul_pd);
float_operator!(F, Div, div, _mm256_div_pd);
operator!(G, Add, add, _mm256_add_ps);
operator!(G, Sub, sub, _mm256_sub_ps);
operator!(G, Mul, mul, _mm256_mul_ps);
operator!(G, Div, div, _mm256_div_ps);
operator!(M, BitAnd, bitand, _mm256_and_si256);
operator!(M, BitOr, bitor, _mm256_or_si256);
