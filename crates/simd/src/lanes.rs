//! The traits that every level implements.

use core::ops::{Add, BitAnd, BitOr, BitXor, Div, Mul, Sub};

use crate::Level;

/// A computation that runs at whatever level it is entered with.
///
/// `run` must be `#[inline(always)]`, and so must everything between it and
/// the lane operations: only then is it compiled with the level's instructions.
pub trait Kernel {
    /// What the computation returns.
    type Output;
    /// Runs the computation with the lanes of `simd`.
    fn run<S: Simd>(self, simd: S) -> Self::Output;
}

/// A level's token: proof that the processor has it, and the maker of lanes.
pub trait Simd: Copy + Send + Sync + 'static {
    /// 32-bit lanes in a vector: 4, 8 or 16.
    const LANES: usize;
    /// Lanes are computed one by one, so that leaving a vector out pays.
    const ONE_BY_ONE: bool = false;
    /// Which level this is.
    const LEVEL: Level;
    /// 32-bit integers, also seen as pairs of 16-bit integers.
    type I: IntLanes<M = Self::M>;
    /// 64-bit floats, as many as there are 32-bit lanes.
    type F: FloatLanes<I = Self::I, M = Self::M>;
    /// 32-bit floats, one for each 32-bit integer.
    type G: SingleLanes<I = Self::I, F = Self::F, M = Self::M>;
    /// One yes or no for each lane.
    type M: MaskLanes;

    /// Runs `kernel` compiled for this level, as a function of its own.
    fn vectorize<K: Kernel>(self, kernel: K) -> K::Output;

    /// The same integer in every lane.
    fn splat(self, value: i32) -> Self::I;
    /// Loads the first `LANES` integers of `from`; it must hold that many.
    fn load(self, from: &[i32]) -> Self::I;
    /// Stores into the first `LANES` integers of `to`; it must hold that many.
    fn store(self, lanes: Self::I, to: &mut [i32]);
    /// Loads `LANES` 16-bit integers, zero-extended.
    fn load16(self, from: &[u16]) -> Self::I;
    /// Stores the low halves of the lanes that are on in `mask`.
    fn store16(self, lanes: Self::I, to: &mut [u16], mask: Self::M);
    /// Stores the low halves of all lanes.
    fn store16_all(self, lanes: Self::I, to: &mut [u16]);
    /// Stores the lanes that are on in `mask`.
    fn store_masked(self, lanes: Self::I, to: &mut [i32], mask: Self::M);
    /// The same float in every lane.
    fn splat_f(self, value: f64) -> Self::F;
    /// Loads the first `LANES` floats of `from`; it must hold that many.
    fn load_f(self, from: &[f64]) -> Self::F;
    /// Stores into the first `LANES` floats of `to`.
    fn store_f(self, lanes: Self::F, to: &mut [f64]);
    /// The same 32-bit float in every lane.
    fn splat_g(self, value: f32) -> Self::G;
    /// Loads the first `LANES` floats of `from`; it must hold that many.
    fn load_g(self, from: &[f32]) -> Self::G;
    /// Stores into the first `LANES` floats of `to`; it must hold that many.
    fn store_g(self, lanes: Self::G, to: &mut [f32]);
    /// Writes the lanes of four vectors side by side: `to[lane]` gets that lane of
    /// each. There must be `LANES` places.
    fn transpose(self, columns: [Self::I; 4], to: &mut [[i32; 4]]);
    /// The same of floats.
    fn transpose_f(self, columns: [Self::F; 4], to: &mut [[f64; 4]]);
    /// Lane `i` is on when bit `i` of `bits` is set. Higher bits are ignored.
    fn mask(self, bits: u32) -> Self::M;
    /// Entry `index & 15` of `table`, lane by lane.
    fn lookup16(self, table: &[i32; 16], index: Self::I) -> Self::I;
    /// Entry `index & 63` of `table`, lane by lane.
    #[inline(always)]
    fn lookup64(self, table: &[i32; 64], index: Self::I) -> Self::I {
        let mut at = [0; crate::MAX_LANES];
        self.store(index, &mut at);
        for at in &mut at[..Self::LANES] {
            *at = table[(*at & 63) as usize];
        }
        self.load(&at)
    }
    /// The low and the high halves of `table[min(index, last)]`, lane by lane,
    /// the index taken as unsigned.
    ///
    /// # Panics
    ///
    /// When `table` is empty.
    fn load_pairs(self, table: &[u64], index: Self::I) -> (Self::I, Self::I);
    /// [`Simd::load_pairs`] by the first `LANES` indices of `index`, which lie
    /// in memory already: faster where lanes would be taken out of a register
    /// one by one.
    ///
    /// # Panics
    ///
    /// When `table` is empty.
    #[inline(always)]
    fn load_pairs_at(self, table: &[u64], index: &[i32]) -> (Self::I, Self::I) {
        self.load_pairs(table, self.load(index))
    }
}

/// Integer lanes. Sums and products wrap; `16` in a name means that each lane
/// is taken as two 16-bit integers.
pub trait IntLanes:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + BitAnd<Output = Self>
    + BitOr<Output = Self>
    + BitXor<Output = Self>
{
    /// The mask that comparisons return.
    type M: MaskLanes;

    /// Low 32 bits of the product.
    fn mul(self, other: Self) -> Self;
    /// Shift left by `count` bits, 0 to 31.
    fn shl(self, count: u32) -> Self;
    /// Logical shift right by `count` bits, 0 to 31.
    fn shr(self, count: u32) -> Self;
    /// Arithmetic shift right by `count` bits, 0 to 31.
    fn sar(self, count: u32) -> Self;
    /// Arithmetic shift right of each lane by its own count, 0 to 31.
    fn sar_each(self, count: Self) -> Self;
    /// Signed minimum.
    fn min(self, other: Self) -> Self;
    /// Signed maximum.
    fn max(self, other: Self) -> Self;
    /// Whether any bit of any lane is set.
    fn any(self) -> bool;
    /// Lanes that are equal.
    fn eq(self, other: Self) -> Self::M;
    /// Lanes where `self > other`, signed.
    fn gt(self, other: Self) -> Self::M;
    /// Lanes of `self` where `mask` is on, of `other` elsewhere.
    fn select(self, other: Self, mask: Self::M) -> Self;

    /// 16-bit sum.
    fn add16(self, other: Self) -> Self;
    /// 16-bit difference.
    fn sub16(self, other: Self) -> Self;
    /// Unsigned 16-bit sum, 65535 at most.
    fn add_sat_u16(self, other: Self) -> Self;
    /// Low 16 bits of the product.
    fn mul16(self, other: Self) -> Self;
    /// High 16 bits of the signed 32-bit product.
    fn mul_high_i16(self, other: Self) -> Self;
    /// Signed 16-bit minimum.
    fn min16(self, other: Self) -> Self;
    /// Signed 16-bit maximum.
    fn max16(self, other: Self) -> Self;
    /// All ones in the halves that are equal, zero elsewhere.
    fn eq16(self, other: Self) -> Self;
    /// 16-bit shift left by `count`, 0 to 15.
    fn shl16(self, count: u32) -> Self;
    /// 16-bit logical shift right by `count`, 0 to 15.
    fn shr16(self, count: u32) -> Self;
    /// In each half: low byte times the low byte of `weights` plus high byte
    /// times the high byte of `weights`. Bytes are unsigned; weights are below
    /// 128 and the sum must stay below 32768.
    fn dot_bytes(self, weights: Self) -> Self;
}

/// Float lanes. Only correctly rounded operations exist.
pub trait FloatLanes:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// The integer lanes of the same level.
    type I: IntLanes<M = Self::M>;
    /// The mask that comparisons return.
    type M: MaskLanes;

    /// Lanes where `self < other`; false where either is not a number.
    fn lt(self, other: Self) -> Self::M;
    /// Integers as floats.
    fn from_i32(lanes: Self::I) -> Self;
    /// Lanes of `self` where `mask` is on, of `other` elsewhere.
    fn select(self, other: Self, mask: Self::M) -> Self;
    /// Without their signs.
    fn abs(self) -> Self;
    /// Rounded towards zero, to a float.
    fn trunc(self) -> Self;
    /// Rounded down, to a float.
    fn floor(self) -> Self;
    /// Floor, limited to the range of `i32`. Not-a-number gives no fixed
    /// value: mask it away.
    fn floor_i32(self) -> Self::I;
    /// The high words of the floats' bit patterns: sign, exponent and the
    /// first 20 bits of the mantissa.
    fn high_word(self) -> Self::I;
}

/// 32-bit float lanes, as many as there are integers. Only correctly rounded
/// operations exist; subnormal numbers are kept.
pub trait SingleLanes:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// The integer lanes of the same level.
    type I: IntLanes<M = Self::M>;
    /// Its lanes of 64-bit floats.
    type F: FloatLanes<I = Self::I, M = Self::M>;
    /// The mask that comparisons return.
    type M: MaskLanes;

    /// The same values in 64 bits.
    fn widen(self) -> Self::F;
    /// The bit patterns.
    fn to_bits(self) -> Self::I;
    /// The floats of these bit patterns.
    fn from_bits(bits: Self::I) -> Self;
    /// Integers, rounded to the nearest float, ties to even.
    fn from_i32(lanes: Self::I) -> Self;
    /// Rounded towards zero, limited to the range of `i32`; 0 where the lane
    /// is not a number.
    fn to_i32(self) -> Self::I;
    /// The same in one step. Values out of range, and what is not a number, give
    /// no fixed value: mask them away.
    fn truncate_i32(self) -> Self::I;
    /// Lanes where `self < other`; false where either is not a number.
    fn lt(self, other: Self) -> Self::M;
    /// Lanes of `self` where `mask` is on, of `other` elsewhere.
    #[inline(always)]
    fn select(self, other: Self, mask: Self::M) -> Self {
        Self::from_bits(self.to_bits().select(other.to_bits(), mask))
    }
}

/// One yes or no for each lane.
pub trait MaskLanes: Copy + BitAnd<Output = Self> + BitOr<Output = Self> {
    /// Bit `i` is set where lane `i` is on.
    fn bits(self) -> u32;
}
