//! Level of detail.
//!
//! lod = log2 of the longer of the two gradient vectors of (s, t), less log2
//! of w, eight fraction bits each, plus the bias. For a given triangle it
//! only falls as w rises, so a stamp's level is decided by comparing w with
//! thresholds, exactly.

use super::UnitPlan;
use crate::kernel::block::{STAMP, Slot};
use crate::log2::{log2_8, log2_8_int, smallest_with_log2_8};
use crate::setup::Plane64;
use crate::state::DITHER_4X4;

/// Level of detail at w = 1, from the squares of how far (s, t) goes per column and
/// per row, with 32 fraction bits; far below any limit where it goes nowhere.
#[inline(always)]
pub(crate) fn lod_base(across: f64, down: f64) -> i32 {
    let longest = if across > down { across } else { down };
    if longest > 0.0 { log2_8(longest) >> 1 } else { -0x8000 }
}

/// The smallest w whose level of detail, before limits, is at most `lod`;
/// `base` includes the bias.
#[inline(always)]
pub(super) fn smallest_w(base: i32, lod: i32) -> f64 {
    smallest_with_log2_8(base - lod)
}

/// The level of detail, whole and limited, that a w selects.
#[inline(always)]
pub(super) fn level_at((finest, coarsest): (i32, i32), base: i32, w: f64) -> i32 {
    if w <= 0.0 {
        return coarsest;
    }
    ((base - log2_8(w)) >> 8).min(coarsest).max(finest)
}

/// The smallest w whose level is below `level`.
#[inline(always)]
pub(super) fn smallest_w_below(base: i32, level: i32) -> f64 {
    smallest_with_log2_8(base - (level << 8) + 1)
}

/// 256 times the logarithm of a positive float that is linear between powers of
/// two, rounded down.
#[inline(always)]
fn linear_log2_8(value: f64) -> i32 {
    (value.to_bits() >> 44) as i32 - (1023 << 8)
}

/// The level of detail of one fragment, limited.
pub(super) fn lod_at(plan: &UnitPlan, base: i32, w: i64, x: i32, y: i32) -> i32 {
    if w <= 0 {
        return plan.lod_max;
    }
    let dither = if plan.unit.lod_dither {
        i32::from(DITHER_4X4[(y & 3) as usize][(x & 3) as usize]) << 4
    } else {
        0
    };
    plan.limit(base - log2_8_int(w as u64) + dither)
}

/// The levels of detail of a stamp at `at` where levels are mixed, limited.
#[inline(always)]
pub(super) fn linear_lods(out: &mut [i32], plan: &UnitPlan, w: &Plane64, base: i32, at: Slot) {
    let corner = w.at(at.x, at.y);
    for (i, out) in out[..STAMP].iter_mut().enumerate() {
        let (column, row) = (i & 3, i >> 2);
        let right = w.dx.wrapping_mul(column as i64);
        let value = corner.wrapping_add(right).wrapping_add(w.dy.wrapping_mul(row as i64));
        let dither = i32::from(DITHER_4X4[row][column]) << 4;
        let dither = if plan.unit.lod_dither { dither } else { 0 };
        let lod = plan.limit(base - linear_log2_8(value as f64) + dither);
        *out = if value > 0 { lod } else { plan.lod_max };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thresholds_separate_levels() {
        let lod = |base: i32, w: u64| base - log2_8_int(w);
        for base in [32 * 256 - 700, 32 * 256 + 13, 35 * 256 + 255, 40 * 256] {
            for level in 1..9 {
                let w = smallest_w_below(base, level).ceil() as u64;
                assert!(lod(base, w) < level << 8);
                assert!(lod(base, w - 1) >= level << 8);
                let w = smallest_w(base, level << 8).ceil() as u64;
                assert!(lod(base, w) <= level << 8);
                assert!(lod(base, w - 1) > level << 8);
            }
        }
    }

    #[test]
    fn one_texel_a_pixel_is_level_0() {
        let one = (1u64 << 32) as f64;
        let base = lod_base(one * one, 0.0);
        assert_eq!(base - log2_8_int(1 << 32), 0);
        let base = lod_base(0.0, 16.0 * one * one);
        assert_eq!(base - log2_8_int(1 << 32), 0x200);
    }
}
