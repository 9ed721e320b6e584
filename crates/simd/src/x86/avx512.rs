//! AVX-512 (F, BW, DQ, VL): sixteen lanes; masks are mask registers.

use core::arch::x86_64::*;
use core::ops::{BitAnd, BitOr};

use super::{binary, float_operator, four, four_at, operator, shifts};
use crate::{FloatLanes, IntLanes, Kernel, Level, MaskLanes, Simd, SingleLanes};

/// The token of the AVX-512 level.
#[derive(Clone, Copy, Debug)]
pub struct Avx512(());

/// Sixteen integers.
#[derive(Clone, Copy)]
pub struct I(__m512i);
/// Sixteen floats.
#[derive(Clone, Copy)]
pub struct F(__m512d, __m512d);
/// Sixteen 32-bit floats.
#[derive(Clone, Copy)]
pub struct G(__m512);
/// Sixteen switches.
#[derive(Clone, Copy)]
pub struct M(__mmask16);

impl Avx512 {
    /// The token, where the machine has all of the features used.
    #[inline]
    pub fn detect() -> Option<Self> {
        (is_x86_feature_detected!("avx512f")
            && is_x86_feature_detected!("avx512bw")
            && is_x86_feature_detected!("avx512dq")
            && is_x86_feature_detected!("avx512vl")
            && is_x86_feature_detected!("popcnt"))
        .then_some(Self(()))
    }
}

/// The even and the odd words of two registers, in order.
#[inline(always)]
fn split_words(a: __m512i, b: __m512i) -> (__m512i, __m512i) {
    // SAFETY: only called on lanes, which exist only where AVX-512 was detected.
    unsafe {
        let even = _mm512_setr_epi32(0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30);
        let odd = _mm512_add_epi32(even, _mm512_set1_epi32(1));
        (_mm512_permutex2var_epi32(a, even, b), _mm512_permutex2var_epi32(a, odd, b))
    }
}

/// Writes eight lanes of four vectors side by side.
#[inline(always)]
fn transpose_eight([a, b, c, d]: [__m512d; 4], to: &mut [[f64; 4]]) {
    let to = &mut to[..8];
    // SAFETY: only called on lanes, which exist only where AVX-512 was detected;
    // the slice holds eight times 32 bytes.
    unsafe {
        let ab = [_mm512_unpacklo_pd(a, b), _mm512_unpackhi_pd(a, b)];
        let cd = [_mm512_unpacklo_pd(c, d), _mm512_unpackhi_pd(c, d)];
        for i in 0..2 {
            // Quarter `q` of a pair is lane 2q + i.
            let even = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13);
            let odd = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
            let even = _mm512_permutex2var_pd(ab[i], even, cd[i]);
            let odd = _mm512_permutex2var_pd(ab[i], odd, cd[i]);
            _mm256_storeu_pd(to[i].as_mut_ptr(), _mm512_castpd512_pd256(even));
            _mm256_storeu_pd(to[2 + i].as_mut_ptr(), _mm512_castpd512_pd256(odd));
            _mm256_storeu_pd(to[4 + i].as_mut_ptr(), _mm512_extractf64x4_pd::<1>(even));
            _mm256_storeu_pd(to[6 + i].as_mut_ptr(), _mm512_extractf64x4_pd::<1>(odd));
        }
    }
}

impl Simd for Avx512 {
    const LANES: usize = 16;
    const LEVEL: Level = Level::Avx512;
    type I = I;
    type F = F;
    type G = G;
    type M = M;

    #[inline(always)]
    fn vectorize<K: Kernel>(self, kernel: K) -> K::Output {
        #[target_feature(enable = "avx512f,avx512bw,avx512dq,avx512vl,avx2,popcnt")]
        fn inner<K: Kernel>(simd: Avx512, kernel: K) -> K::Output {
            kernel.run(simd)
        }
        // SAFETY: the token proves every feature; AVX-512 F implies AVX2.
        unsafe { inner(self, kernel) }
    }
    #[inline(always)]
    fn splat(self, value: i32) -> I {
        // SAFETY: the token proves AVX-512.
        I(unsafe { _mm512_set1_epi32(value) })
    }
    #[inline(always)]
    fn load(self, from: &[i32]) -> I {
        let from = &from[..16];
        // SAFETY: the slice holds 64 bytes; the load takes any alignment.
        I(unsafe { _mm512_loadu_si512(from.as_ptr().cast()) })
    }
    #[inline(always)]
    fn store(self, lanes: I, to: &mut [i32]) {
        let to = &mut to[..16];
        // SAFETY: the slice holds 64 bytes; the store takes any alignment.
        unsafe { _mm512_storeu_si512(to.as_mut_ptr().cast(), lanes.0) }
    }
    #[inline(always)]
    fn load16(self, from: &[u16]) -> I {
        let from = &from[..16];
        // SAFETY: the slice holds 32 bytes; the token proves AVX-512.
        I(unsafe { _mm512_cvtepu16_epi32(_mm256_loadu_si256(from.as_ptr().cast())) })
    }
    #[inline(always)]
    fn store16(self, lanes: I, to: &mut [u16], mask: M) {
        let to = &mut to[..16];
        // SAFETY: the slice holds 32 bytes; the token proves AVX-512.
        unsafe {
            let new = _mm512_cvtepi32_epi16(lanes.0);
            _mm256_mask_storeu_epi16(to.as_mut_ptr().cast(), mask.0, new);
        }
    }
    #[inline(always)]
    fn store16_all(self, lanes: I, to: &mut [u16]) {
        let to = &mut to[..16];
        // SAFETY: the slice holds 32 bytes; the token proves AVX-512.
        unsafe {
            _mm256_storeu_si256(to.as_mut_ptr().cast(), _mm512_cvtepi32_epi16(lanes.0));
        }
    }
    #[inline(always)]
    fn store_masked(self, lanes: I, to: &mut [i32], mask: M) {
        let to = &mut to[..16];
        // SAFETY: the slice holds 64 bytes; the token proves AVX-512.
        unsafe { _mm512_mask_storeu_epi32(to.as_mut_ptr(), mask.0, lanes.0) }
    }
    #[inline(always)]
    fn splat_f(self, value: f64) -> F {
        // SAFETY: the token proves AVX-512.
        unsafe { F(_mm512_set1_pd(value), _mm512_set1_pd(value)) }
    }
    #[inline(always)]
    fn load_f(self, from: &[f64]) -> F {
        let from = &from[..16];
        // SAFETY: the slice holds 128 bytes.
        unsafe { F(_mm512_loadu_pd(from.as_ptr()), _mm512_loadu_pd(from.as_ptr().add(8))) }
    }
    #[inline(always)]
    fn store_f(self, lanes: F, to: &mut [f64]) {
        let to = &mut to[..16];
        // SAFETY: the slice holds 128 bytes.
        unsafe {
            _mm512_storeu_pd(to.as_mut_ptr(), lanes.0);
            _mm512_storeu_pd(to.as_mut_ptr().add(8), lanes.1);
        }
    }
    #[inline(always)]
    fn splat_g(self, value: f32) -> G {
        // SAFETY: the token proves AVX-512.
        G(unsafe { _mm512_set1_ps(value) })
    }
    #[inline(always)]
    fn load_g(self, from: &[f32]) -> G {
        let from = &from[..16];
        // SAFETY: the slice holds 64 bytes; the load takes any alignment.
        G(unsafe { _mm512_loadu_ps(from.as_ptr()) })
    }
    #[inline(always)]
    fn store_g(self, lanes: G, to: &mut [f32]) {
        let to = &mut to[..16];
        // SAFETY: the slice holds 64 bytes; the store takes any alignment.
        unsafe { _mm512_storeu_ps(to.as_mut_ptr(), lanes.0) }
    }
    #[inline(always)]
    fn transpose(self, [I(a), I(b), I(c), I(d)]: [I; 4], to: &mut [[i32; 4]]) {
        let to = &mut to[..16];
        // SAFETY: the slice holds sixteen times 16 bytes; the token proves AVX-512.
        unsafe {
            let (ab_low, ab_high) = (_mm512_unpacklo_epi32(a, b), _mm512_unpackhi_epi32(a, b));
            let (cd_low, cd_high) = (_mm512_unpacklo_epi32(c, d), _mm512_unpackhi_epi32(c, d));
            // Quarter `q` of row `r` is lane 4q + r.
            let rows = [
                _mm512_unpacklo_epi64(ab_low, cd_low),
                _mm512_unpackhi_epi64(ab_low, cd_low),
                _mm512_unpacklo_epi64(ab_high, cd_high),
                _mm512_unpackhi_epi64(ab_high, cd_high),
            ];
            for (i, row) in rows.into_iter().enumerate() {
                let quarters = [
                    _mm512_castsi512_si128(row),
                    _mm512_extracti32x4_epi32::<1>(row),
                    _mm512_extracti32x4_epi32::<2>(row),
                    _mm512_extracti32x4_epi32::<3>(row),
                ];
                for (q, quarter) in quarters.into_iter().enumerate() {
                    _mm_storeu_si128(to[4 * q + i].as_mut_ptr().cast(), quarter);
                }
            }
        }
    }
    #[inline(always)]
    fn transpose_f(self, [a, b, c, d]: [F; 4], to: &mut [[f64; 4]]) {
        let (front, back) = to[..16].split_at_mut(8);
        transpose_eight([a.0, b.0, c.0, d.0], front);
        transpose_eight([a.1, b.1, c.1, d.1], back);
    }
    #[inline(always)]
    fn mask(self, bits: u32) -> M {
        M(bits as u16)
    }
    #[inline(always)]
    fn lookup16(self, table: &[i32; 16], index: I) -> I {
        let table = self.load(table);
        // SAFETY: the token proves AVX-512; the permute uses the low four bits.
        I(unsafe { _mm512_permutexvar_epi32(index.0, table.0) })
    }
    #[inline(always)]
    fn lookup64(self, table: &[i32; 64], index: I) -> I {
        let (t0, t1) = (self.load(&table[..16]), self.load(&table[16..32]));
        let (t2, t3) = (self.load(&table[32..48]), self.load(&table[48..]));
        // SAFETY: the token proves AVX-512; the permutes use the low five bits.
        unsafe {
            let low = _mm512_permutex2var_epi32(t0.0, index.0, t1.0);
            let high = _mm512_permutex2var_epi32(t2.0, index.0, t3.0);
            let upper = _mm512_test_epi32_mask(index.0, _mm512_set1_epi32(32));
            I(_mm512_mask_blend_epi32(upper, low, high))
        }
    }
    #[inline(always)]
    fn load_pairs(self, table: &[u64], index: I) -> (I, I) {
        let last = crate::last_index(table);
        let mut at = [0; 16];
        // SAFETY: the token proves AVX-512. Each index is at most `last`, so
        // the entries read lie inside `table`.
        unsafe {
            let index = I(_mm512_min_epu32(index.0, _mm512_set1_epi32(last as i32)));
            self.store(index, &mut at);
            let front = _mm512_inserti64x4::<1>(
                _mm512_castsi256_si512(four(table, [at[0], at[1], at[2], at[3]])),
                four(table, [at[4], at[5], at[6], at[7]]),
            );
            let back = _mm512_inserti64x4::<1>(
                _mm512_castsi256_si512(four(table, [at[8], at[9], at[10], at[11]])),
                four(table, [at[12], at[13], at[14], at[15]]),
            );
            let (low, high) = split_words(front, back);
            (I(low), I(high))
        }
    }
    #[inline(always)]
    fn load_pairs_at(self, table: &[u64], index: &[i32]) -> (I, I) {
        let last = crate::last_index(table);
        let index = &index[..16];
        // SAFETY: the token proves AVX-512. No index is above `last`, so the
        // entries read lie inside `table`.
        unsafe {
            let lanes = _mm512_loadu_si512(index.as_ptr().cast());
            if _mm512_cmpgt_epu32_mask(lanes, _mm512_set1_epi32(last as i32)) != 0 {
                return self.load_pairs(table, I(lanes));
            }
            let front = _mm512_inserti64x4::<1>(
                _mm512_castsi256_si512(four_at(table, index, 0)),
                four_at(table, index, 4),
            );
            let back = _mm512_inserti64x4::<1>(
                _mm512_castsi256_si512(four_at(table, index, 8)),
                four_at(table, index, 12),
            );
            let (low, high) = split_words(front, back);
            (I(low), I(high))
        }
    }
}

impl IntLanes for I {
    type M = M;

    #[inline(always)]
    fn any(self) -> bool {
        // SAFETY: lanes exist only where AVX-512 was detected.
        unsafe { _mm512_test_epi32_mask(self.0, self.0) != 0 }
    }

    binary! {
        mul _mm512_mullo_epi32
        min _mm512_min_epi32
        max _mm512_max_epi32
        sar_each _mm512_srav_epi32
        add16 _mm512_add_epi16
        sub16 _mm512_sub_epi16
        add_sat_u16 _mm512_adds_epu16
        mul16 _mm512_mullo_epi16
        mul_high_i16 _mm512_mulhi_epi16
        min16 _mm512_min_epi16
        max16 _mm512_max_epi16
        dot_bytes _mm512_maddubs_epi16
    }
    shifts! {
        shl _mm512_sll_epi32
        shr _mm512_srl_epi32
        sar _mm512_sra_epi32
        shl16 _mm512_sll_epi16
        shr16 _mm512_srl_epi16
    }
    #[inline(always)]
    fn eq16(self, other: I) -> I {
        // SAFETY: lanes exist only where AVX-512 was detected.
        I(unsafe { _mm512_movm_epi16(_mm512_cmpeq_epi16_mask(self.0, other.0)) })
    }
    #[inline(always)]
    fn eq(self, other: I) -> M {
        // SAFETY: lanes exist only where AVX-512 was detected.
        M(unsafe { _mm512_cmpeq_epi32_mask(self.0, other.0) })
    }
    #[inline(always)]
    fn gt(self, other: I) -> M {
        // SAFETY: lanes exist only where AVX-512 was detected.
        M(unsafe { _mm512_cmpgt_epi32_mask(self.0, other.0) })
    }
    #[inline(always)]
    fn select(self, other: I, mask: M) -> I {
        // SAFETY: lanes exist only where AVX-512 was detected.
        I(unsafe { _mm512_mask_blend_epi32(mask.0, other.0, self.0) })
    }
}

impl FloatLanes for F {
    type I = I;
    type M = M;

    #[inline(always)]
    fn lt(self, other: F) -> M {
        // SAFETY: lanes exist only where AVX-512 was detected.
        unsafe {
            let low = _mm512_cmp_pd_mask::<_CMP_LT_OQ>(self.0, other.0);
            let high = _mm512_cmp_pd_mask::<_CMP_LT_OQ>(self.1, other.1);
            M(u16::from(low) | u16::from(high) << 8)
        }
    }
    #[inline(always)]
    fn from_i32(lanes: I) -> F {
        // SAFETY: lanes exist only where AVX-512 was detected.
        unsafe {
            F(
                _mm512_cvtepi32_pd(_mm512_castsi512_si256(lanes.0)),
                _mm512_cvtepi32_pd(_mm512_extracti64x4_epi64::<1>(lanes.0)),
            )
        }
    }
    #[inline(always)]
    fn select(self, other: F, mask: M) -> F {
        // SAFETY: lanes exist only where AVX-512 was detected.
        unsafe {
            let low = _mm512_mask_blend_pd(mask.0 as u8, other.0, self.0);
            F(low, _mm512_mask_blend_pd((mask.0 >> 8) as u8, other.1, self.1))
        }
    }
    #[inline(always)]
    fn abs(self) -> F {
        // SAFETY: lanes exist only where AVX-512 was detected.
        unsafe { F(_mm512_abs_pd(self.0), _mm512_abs_pd(self.1)) }
    }
    #[inline(always)]
    fn trunc(self) -> F {
        const TO_ZERO: i32 = _MM_FROUND_TO_ZERO | _MM_FROUND_NO_EXC;
        // SAFETY: lanes exist only where AVX-512 was detected.
        unsafe {
            let low = _mm512_roundscale_pd::<TO_ZERO>(self.0);
            F(low, _mm512_roundscale_pd::<TO_ZERO>(self.1))
        }
    }
    #[inline(always)]
    fn floor(self) -> F {
        const DOWN: i32 = _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC;
        // SAFETY: lanes exist only where AVX-512 was detected.
        unsafe {
            let low = _mm512_roundscale_pd::<DOWN>(self.0);
            F(low, _mm512_roundscale_pd::<DOWN>(self.1))
        }
    }
    #[inline(always)]
    fn floor_i32(self) -> I {
        #[inline(always)]
        fn half(x: __m512d) -> __m256i {
            const FLOOR: i32 = _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC;
            // SAFETY: lanes exist only where AVX-512 was detected.
            unsafe {
                // What does not fit becomes the least integer.
                let limited = _mm512_min_pd(x, _mm512_set1_pd(i32::MAX as f64));
                _mm512_cvt_roundpd_epi32::<FLOOR>(limited)
            }
        }
        // SAFETY: lanes exist only where AVX-512 was detected.
        I(unsafe { _mm512_inserti64x4::<1>(_mm512_castsi256_si512(half(self.0)), half(self.1)) })
    }
    #[inline(always)]
    fn high_word(self) -> I {
        // SAFETY: lanes exist only where AVX-512 was detected.
        let (a, b) = unsafe { (_mm512_castpd_si512(self.0), _mm512_castpd_si512(self.1)) };
        I(split_words(a, b).1)
    }
}

impl SingleLanes for G {
    type I = I;
    type F = F;
    type M = M;

    #[inline(always)]
    fn widen(self) -> F {
        // SAFETY: lanes exist only where AVX-512 was detected.
        unsafe {
            F(
                _mm512_cvtps_pd(_mm512_castps512_ps256(self.0)),
                _mm512_cvtps_pd(_mm512_extractf32x8_ps::<1>(self.0)),
            )
        }
    }
    #[inline(always)]
    fn truncate_i32(self) -> I {
        // SAFETY: lanes exist only where AVX-512 was detected.
        I(unsafe { _mm512_cvttps_epi32(self.0) })
    }
    #[inline(always)]
    fn to_bits(self) -> I {
        // SAFETY: lanes exist only where AVX-512 was detected.
        I(unsafe { _mm512_castps_si512(self.0) })
    }
    #[inline(always)]
    fn from_bits(bits: I) -> G {
        // SAFETY: lanes exist only where AVX-512 was detected.
        G(unsafe { _mm512_castsi512_ps(bits.0) })
    }
    #[inline(always)]
    fn from_i32(lanes: I) -> G {
        // SAFETY: lanes exist only where AVX-512 was detected.
        G(unsafe { _mm512_cvtepi32_ps(lanes.0) })
    }
    #[inline(always)]
    fn to_i32(self) -> I {
        // SAFETY: lanes exist only where AVX-512 was detected.
        unsafe {
            // The conversion gives the least integer for what does not fit.
            let limit = _mm512_set1_ps(2_147_483_648.0);
            let above = _mm512_cmp_ps_mask::<_CMP_GE_OQ>(self.0, limit);
            let number = _mm512_cmp_ps_mask::<_CMP_ORD_Q>(self.0, self.0);
            let whole = _mm512_maskz_cvttps_epi32(number, self.0);
            I(_mm512_mask_mov_epi32(whole, above, _mm512_set1_epi32(i32::MAX)))
        }
    }
    #[inline(always)]
    fn lt(self, other: G) -> M {
        // SAFETY: lanes exist only where AVX-512 was detected.
        M(unsafe { _mm512_cmp_ps_mask::<_CMP_LT_OQ>(self.0, other.0) })
    }
}

impl MaskLanes for M {
    #[inline(always)]
    fn bits(self) -> u32 {
        u32::from(self.0)
    }
}

operator!(I, Add, add, _mm512_add_epi32);
operator!(I, Sub, sub, _mm512_sub_epi32);
operator!(I, BitAnd, bitand, _mm512_and_si512);
operator!(I, BitOr, bitor, _mm512_or_si512);
operator!(I, BitXor, bitxor, _mm512_xor_si512);
float_operator!(F, Add, add, _mm512_add_pd);
float_operator!(F, Sub, sub, _mm512_sub_pd);
float_operator!(F, Mul, mul, _mm512_mul_pd);
float_operator!(F, Div, div, _mm512_div_pd);
operator!(G, Add, add, _mm512_add_ps);
operator!(G, Sub, sub, _mm512_sub_ps);
operator!(G, Mul, mul, _mm512_mul_ps);
operator!(G, Div, div, _mm512_div_ps);

impl BitAnd for M {
    type Output = M;
    #[inline(always)]
    fn bitand(self, other: M) -> M {
        M(self.0 & other.0)
    }
}
impl BitOr for M {
    type Output = M;
    #[inline(always)]
    fn bitor(self, other: M) -> M {
        M(self.0 | other.0)
    }
}
