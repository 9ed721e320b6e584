//! The level of detail of a pixel.
//!
//! Source: SST1, tLOD register.

use fillrate_engine::state::TextureUnit;
use fillrate_engine::{Registers, WideParam};

use super::dither::matrix;
use super::log2::{log2_8_f64, log2_8_u64};
use super::pixel::Position;

/// The smallest level of the largest texture, 8 fraction bits.
const COARSEST: i32 = 0xb00;
/// The base where s and t do not change: below every limit.
const MAGNIFIED: i32 = -0x8000;
/// Above every limit: the level where there is no finite one.
const BEYOND: i32 = 1 << 24;

/// A level of detail within its limits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Lod {
    /// 8 fraction bits, 0x000 to 0xb00.
    pub value: i32,
    /// Whether it is the limit at the fine end.
    pub is_finest: bool,
}

impl Lod {
    /// The level, before any replacement in a split chain.
    pub fn level(self) -> i32 {
        self.value >> 8
    }

    /// The fraction, 0 to 255.
    pub fn fraction(self) -> i32 {
        self.value & 0xff
    }
}

/// The level of detail where iterated 1/w is `w` (32 fraction bits; 2^32
/// without perspective).
pub fn at(unit: &TextureUnit, registers: &Registers, index: usize, w: i64, at: Position) -> Lod {
    let [s, t, _] = &registers.tmu[index];
    let mut lod = match u64::try_from(w) {
        Ok(w) if w > 0 && unit.mix_levels => base(s, t) - linear_log(w),
        Ok(w) if w > 0 => base(s, t) - log2_8_u64(w),
        _ => BEYOND,
    };
    lod += i32::from(unit.lod.bias);
    if unit.lod_dither {
        lod += (matrix(at.x, at.row) << 4) as i32;
    }
    let upper = i32::from(unit.lod.max).min(COARSEST);
    let lower = i32::from(unit.lod.min);
    let value = lod.max(lower).min(upper);
    Lod { value, is_finest: value == lower.min(upper) }
}

/// 256 times a logarithm that is linear between powers of two, rounded down, of
/// a number as the nearest float.
fn linear_log(w: u64) -> i32 {
    let mut value = w as f64;
    let mut octaves = 0;
    while value >= 2.0 {
        (value, octaves) = (value / 2.0, octaves + 1);
    }
    octaves * 256 + ((value - 1.0) * 256.0).floor() as i32
}

/// 256 times log2 of the longer gradient vector of a triangle.
fn base(s: &WideParam, t: &WideParam) -> i32 {
    let square = |ds: i64, dt: i64| {
        let (ds, dt) = (ds as f64, dt as f64);
        ds * ds + dt * dt
    };
    let longest = square(s.dx, t.dx).max(square(s.dy, t.dy));
    if longest == 0.0 {
        return MAGNIFIED;
    }
    log2_8_f64(longest) >> 1
}
