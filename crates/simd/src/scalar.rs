//! The scalar level: the definition of every operation, in plain Rust.

use core::array::from_fn;
use core::ops::{Add, BitAnd, BitOr, BitXor, Div, Mul, Sub};

use crate::{FloatLanes, IntLanes, Kernel, Level, MaskLanes, Simd, SingleLanes};

/// Lanes of the scalar level: four, so that dither phases and stamps fit.
const N: usize = 4;

/// The token of the scalar level; always available.
#[derive(Clone, Copy, Debug)]
pub struct Scalar;

/// Four integers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct I4([i32; N]);
/// Four floats.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct F4([f64; N]);
/// Four 32-bit floats.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct G4([f32; N]);
/// Four switches, one bit each.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct M4(u32);

#[inline(always)]
fn lanes(f: impl Fn(usize) -> i32) -> I4 {
    I4(from_fn(f))
}

#[inline(always)]
fn switches(f: impl Fn(usize) -> bool) -> M4 {
    M4((0..N).fold(0, |bits, i| bits | u32::from(f(i)) << i))
}

/// Applies `f` to the low and to the high halves of both operands.
#[inline(always)]
fn halves(a: I4, b: I4, f: impl Fn(i16, i16) -> i16) -> I4 {
    lanes(|i| {
        let low = f(a.0[i] as i16, b.0[i] as i16) as u16;
        let high = f((a.0[i] >> 16) as i16, (b.0[i] >> 16) as i16) as u16;
        (u32::from(low) | u32::from(high) << 16) as i32
    })
}

/// `f64::trunc`, which is a library call on many targets.
#[inline(always)]
fn trunc(x: f64) -> f64 {
    // Added to a smaller one it leaves no fraction.
    const WHOLE: f64 = (1_u64 << 52) as f64;
    let magnitude = x.abs();
    if magnitude < WHOLE {
        let nearest = (magnitude + WHOLE) - WHOLE;
        let below = if nearest > magnitude { nearest - 1.0 } else { nearest };
        below.copysign(x)
    } else {
        x
    }
}

impl Simd for Scalar {
    const LANES: usize = N;
    const ONE_BY_ONE: bool = true;
    const LEVEL: Level = Level::Scalar;
    type I = I4;
    type F = F4;
    type G = G4;
    type M = M4;

    #[inline(always)]
    fn vectorize<K: Kernel>(self, kernel: K) -> K::Output {
        kernel.run(self)
    }
    #[inline(always)]
    fn splat(self, value: i32) -> I4 {
        I4([value; N])
    }
    #[inline(always)]
    fn load(self, from: &[i32]) -> I4 {
        lanes(|i| from[i])
    }
    #[inline(always)]
    fn store(self, lanes: I4, to: &mut [i32]) {
        to[..N].copy_from_slice(&lanes.0);
    }
    #[inline(always)]
    fn load16(self, from: &[u16]) -> I4 {
        lanes(|i| i32::from(from[i]))
    }
    #[inline(always)]
    fn store16(self, lanes: I4, to: &mut [u16], mask: M4) {
        for (i, to) in to[..N].iter_mut().enumerate() {
            if mask.0 >> i & 1 != 0 {
                *to = lanes.0[i] as u16;
            }
        }
    }
    #[inline(always)]
    fn store16_all(self, lanes: I4, to: &mut [u16]) {
        for (to, lane) in to[..N].iter_mut().zip(lanes.0) {
            *to = lane as u16;
        }
    }
    #[inline(always)]
    fn store_masked(self, lanes: I4, to: &mut [i32], mask: M4) {
        for (i, to) in to[..N].iter_mut().enumerate() {
            if mask.0 >> i & 1 != 0 {
                *to = lanes.0[i];
            }
        }
    }
    #[inline(always)]
    fn splat_f(self, value: f64) -> F4 {
        F4([value; N])
    }
    #[inline(always)]
    fn load_f(self, from: &[f64]) -> F4 {
        F4(from_fn(|i| from[i]))
    }
    #[inline(always)]
    fn store_f(self, lanes: F4, to: &mut [f64]) {
        to[..N].copy_from_slice(&lanes.0);
    }
    #[inline(always)]
    fn splat_g(self, value: f32) -> G4 {
        G4([value; N])
    }
    #[inline(always)]
    fn load_g(self, from: &[f32]) -> G4 {
        G4(from_fn(|i| from[i]))
    }
    #[inline(always)]
    fn store_g(self, lanes: G4, to: &mut [f32]) {
        to[..N].copy_from_slice(&lanes.0);
    }
    #[inline(always)]
    fn transpose(self, [a, b, c, d]: [I4; 4], to: &mut [[i32; 4]]) {
        for (i, to) in to[..N].iter_mut().enumerate() {
            *to = [a.0[i], b.0[i], c.0[i], d.0[i]];
        }
    }
    #[inline(always)]
    fn transpose_f(self, [a, b, c, d]: [F4; 4], to: &mut [[f64; 4]]) {
        for (i, to) in to[..N].iter_mut().enumerate() {
            *to = [a.0[i], b.0[i], c.0[i], d.0[i]];
        }
    }
    #[inline(always)]
    fn mask(self, bits: u32) -> M4 {
        M4(bits & ((1 << N) - 1))
    }
    #[inline(always)]
    fn lookup16(self, table: &[i32; 16], index: I4) -> I4 {
        lanes(|i| table[(index.0[i] & 15) as usize])
    }
    #[inline(always)]
    fn load_pairs(self, table: &[u64], index: I4) -> (I4, I4) {
        let last = crate::last_index(table);
        let pair = |i: usize| table[(index.0[i] as u32).min(last) as usize];
        (lanes(|i| pair(i) as i32), lanes(|i| (pair(i) >> 32) as i32))
    }
}

impl IntLanes for I4 {
    type M = M4;

    #[inline(always)]
    fn any(self) -> bool {
        self.0.iter().any(|&lane| lane != 0)
    }

    #[inline(always)]
    fn mul(self, other: I4) -> I4 {
        lanes(|i| self.0[i].wrapping_mul(other.0[i]))
    }
    #[inline(always)]
    fn shl(self, count: u32) -> I4 {
        lanes(|i| self.0[i] << count)
    }
    #[inline(always)]
    fn shr(self, count: u32) -> I4 {
        lanes(|i| (self.0[i] as u32 >> count) as i32)
    }
    #[inline(always)]
    fn sar(self, count: u32) -> I4 {
        lanes(|i| self.0[i] >> count)
    }
    #[inline(always)]
    fn sar_each(self, count: I4) -> I4 {
        lanes(|i| self.0[i] >> (count.0[i] & 31))
    }
    #[inline(always)]
    fn min(self, other: I4) -> I4 {
        lanes(|i| self.0[i].min(other.0[i]))
    }
    #[inline(always)]
    fn max(self, other: I4) -> I4 {
        lanes(|i| self.0[i].max(other.0[i]))
    }
    #[inline(always)]
    fn eq(self, other: I4) -> M4 {
        switches(|i| self.0[i] == other.0[i])
    }
    #[inline(always)]
    fn gt(self, other: I4) -> M4 {
        switches(|i| self.0[i] > other.0[i])
    }
    #[inline(always)]
    fn select(self, other: I4, mask: M4) -> I4 {
        lanes(|i| if mask.0 >> i & 1 != 0 { self.0[i] } else { other.0[i] })
    }
    #[inline(always)]
    fn add16(self, other: I4) -> I4 {
        halves(self, other, i16::wrapping_add)
    }
    #[inline(always)]
    fn sub16(self, other: I4) -> I4 {
        halves(self, other, i16::wrapping_sub)
    }
    #[inline(always)]
    fn add_sat_u16(self, other: I4) -> I4 {
        halves(self, other, |a, b| (a as u16).saturating_add(b as u16) as i16)
    }
    #[inline(always)]
    fn mul16(self, other: I4) -> I4 {
        halves(self, other, i16::wrapping_mul)
    }
    #[inline(always)]
    fn mul_high_i16(self, other: I4) -> I4 {
        halves(self, other, |a, b| ((i32::from(a) * i32::from(b)) >> 16) as i16)
    }
    #[inline(always)]
    fn min16(self, other: I4) -> I4 {
        halves(self, other, i16::min)
    }
    #[inline(always)]
    fn max16(self, other: I4) -> I4 {
        halves(self, other, i16::max)
    }
    #[inline(always)]
    fn eq16(self, other: I4) -> I4 {
        halves(self, other, |a, b| if a == b { -1 } else { 0 })
    }
    #[inline(always)]
    fn shl16(self, count: u32) -> I4 {
        halves(self, self, |a, _| a << count)
    }
    #[inline(always)]
    fn shr16(self, count: u32) -> I4 {
        halves(self, self, |a, _| (a as u16 >> count) as i16)
    }
    #[inline(always)]
    fn dot_bytes(self, weights: I4) -> I4 {
        halves(self, weights, |a, w| {
            let [a0, a1] = a.to_le_bytes().map(i16::from);
            let [w0, w1] = w.to_le_bytes().map(i16::from);
            (a0.wrapping_mul(w0)).wrapping_add(a1.wrapping_mul(w1))
        })
    }
}

impl FloatLanes for F4 {
    type I = I4;
    type M = M4;

    #[inline(always)]
    fn lt(self, other: F4) -> M4 {
        switches(|i| self.0[i] < other.0[i])
    }
    #[inline(always)]
    fn from_i32(lanes: I4) -> F4 {
        F4(lanes.0.map(f64::from))
    }
    #[inline(always)]
    fn select(self, other: F4, mask: M4) -> F4 {
        F4(from_fn(|i| if mask.0 >> i & 1 != 0 { self.0[i] } else { other.0[i] }))
    }
    #[inline(always)]
    fn abs(self) -> F4 {
        F4(self.0.map(f64::abs))
    }
    #[inline(always)]
    fn trunc(self) -> F4 {
        F4(self.0.map(trunc))
    }
    #[inline(always)]
    fn floor(self) -> F4 {
        F4(self.0.map(|x| {
            let whole = trunc(x);
            if whole > x { whole - 1.0 } else { whole }
        }))
    }
    #[inline(always)]
    fn floor_i32(self) -> I4 {
        // The conversion truncates and limits, which is one too high for a
        // negative fraction. `f64::floor` is a library call on many targets.
        lanes(|i| {
            let truncated = self.0[i] as i32;
            truncated.saturating_sub(i32::from(self.0[i] < f64::from(truncated)))
        })
    }
    #[inline(always)]
    fn high_word(self) -> I4 {
        lanes(|i| (self.0[i].to_bits() >> 32) as i32)
    }
}

impl SingleLanes for G4 {
    type I = I4;
    type F = F4;
    type M = M4;

    #[inline(always)]
    fn widen(self) -> F4 {
        F4(self.0.map(f64::from))
    }
    #[inline(always)]
    fn truncate_i32(self) -> I4 {
        I4(crate::truncate(self.0))
    }
    #[inline(always)]
    fn to_bits(self) -> I4 {
        lanes(|i| self.0[i].to_bits() as i32)
    }
    #[inline(always)]
    fn from_bits(bits: I4) -> G4 {
        G4(bits.0.map(|bits| f32::from_bits(bits as u32)))
    }
    #[inline(always)]
    fn from_i32(lanes: I4) -> G4 {
        G4(lanes.0.map(|lane| lane as f32))
    }
    #[inline(always)]
    fn to_i32(self) -> I4 {
        lanes(|i| self.0[i] as i32)
    }
    #[inline(always)]
    fn lt(self, other: G4) -> M4 {
        switches(|i| self.0[i] < other.0[i])
    }
}

impl MaskLanes for M4 {
    #[inline(always)]
    fn bits(self) -> u32 {
        self.0
    }
}

macro_rules! operator {
    ($lanes:ident, $trait:ident, $name:ident, $one:expr) => {
        impl $trait for $lanes {
            type Output = $lanes;
            #[inline(always)]
            fn $name(self, other: $lanes) -> $lanes {
                $lanes(from_fn(|i| $one(self.0[i], other.0[i])))
            }
        }
    };
}
operator!(I4, Add, add, i32::wrapping_add);
operator!(I4, Sub, sub, i32::wrapping_sub);
operator!(I4, BitAnd, bitand, |a, b| a & b);
operator!(I4, BitOr, bitor, |a, b| a | b);
operator!(I4, BitXor, bitxor, |a, b| a ^ b);
operator!(F4, Add, add, |a, b| a + b);
operator!(F4, Sub, sub, |a, b| a - b);
operator!(F4, Mul, mul, |a, b| a * b);
operator!(F4, Div, div, |a, b| a / b);
operator!(G4, Add, add, |a, b| a + b);
operator!(G4, Sub, sub, |a, b| a - b);
operator!(G4, Mul, mul, |a, b| a * b);
operator!(G4, Div, div, |a, b| a / b);

impl BitAnd for M4 {
    type Output = M4;
    #[inline(always)]
    fn bitand(self, other: M4) -> M4 {
        M4(self.0 & other.0)
    }
}
impl BitOr for M4 {
    type Output = M4;
    #[inline(always)]
    fn bitor(self, other: M4) -> M4 {
        M4(self.0 | other.0)
    }
}
