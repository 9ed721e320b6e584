//! Depth: z and w of the fragments, the test, and the write.
//!
//! Source: SST1, fbzMode; the test runs before texturing, which changes no
//! result because depth is written only where everything else passes.

use fillrate_simd::{FloatLanes, IntLanes, MaskLanes, Simd};

use super::block::{Block, STAMP};
use super::lanes::{COLUMN_F, ROW_F, iterate, wrap};
use super::{Pass, Tile};
use crate::setup::{Plane64, Triangle};
use crate::state::{Compare, DepthSource};

/// The pseudo-float of a 48-bit w with 32 fraction bits: 4 exponent bits and
/// 12 inverted mantissa bits, plus one; 0 for w of one and above or negative,
/// 0xffff for the smallest.
pub(crate) fn float_w(w: i64) -> u16 {
    if (w >> 32) & 0xffff != 0 {
        return 0;
    }
    let low = w as u32;
    if low & 0xffff_0000 == 0 {
        return 0xffff;
    }
    let exponent = low.leading_zeros();
    let mantissa = !low >> (19 - exponent) & 0xfff;
    (((exponent << 12) | mantissa) + 1).min(0xffff) as u16
}

/// [`float_w`] of integers below 2^47 held as floats. Their bit patterns
/// already hold exponent and mantissa.
#[inline(always)]
fn float_w_lanes<S: Simd>(s: S, w: S::F) -> S::I {
    let high = w.high_word();
    let leading_zeros = s.splat(31 + 1023) - high.shr(20);
    let mantissa = high.shr(8) & s.splat(0xfff);
    let packed = leading_zeros.shl(12) | (mantissa ^ s.splat(0xfff));
    let value = (packed + s.splat(1)).min(s.splat(0xffff));
    // Below 2^16: nothing left in the upper half.
    let tiny = s.splat((16 + 1023) << 20).gt(high);
    let value = s.splat(0xffff).select(value, tiny);
    // At least 2^32, or negative.
    let near = high.gt(s.splat(((32 + 1023) << 20) - 1));
    let negative = s.splat(0).gt(high);
    s.splat(0).select(value, near | negative)
}

/// A 64-bit attribute at fragments `j..` of a stamp, in floats; the triangle
/// must be exact.
#[inline(always)]
pub(crate) fn iterate_wide<S: Simd>(s: S, plane: &Plane64, x: i32, y: i32, j: usize) -> S::F {
    s.splat_f(plane.at(x, y) as f64)
        + (s.load_f(&COLUMN_F[j..]) * s.splat_f(plane.dx as f64)
            + s.load_f(&ROW_F[j..]) * s.splat_f(plane.dy as f64))
}

/// Iterates z into `block.z`.
#[inline(always)]
fn z_of_slot<S: Simd>(s: S, block: &mut Block, triangle: &Triangle, slot: usize) {
    let at = block.slots[slot];
    for j in (0..STAMP).step_by(S::LANES) {
        let z = iterate(s, &triangle.z, at.x, at.y, j);
        s.store(wrap::<S, 20, 16>(s, z.shr(12)), &mut block.z.0[slot * STAMP + j..]);
    }
}

/// Iterates the pseudo-float w into `block.w`.
#[inline(always)]
fn w_of_slot<S: Simd>(s: S, block: &mut Block, triangle: &Triangle, slot: usize) {
    let at = block.slots[slot];
    if !triangle.exact {
        for (i, out) in block.w.0[slot * STAMP..][..STAMP].iter_mut().enumerate() {
            let (x, y) = (at.x + (i & 3) as i32, at.y + (i >> 2) as i32);
            *out = i32::from(float_w(triangle.w.at(x, y)));
        }
        return;
    }
    for j in (0..STAMP).step_by(S::LANES) {
        let w = iterate_wide(s, &triangle.w, at.x, at.y, j);
        s.store(float_w_lanes(s, w), &mut block.w.0[slot * STAMP + j..]);
    }
}

/// Computes z and w where the pipeline needs them, and the biased depth.
#[inline(always)]
pub(crate) fn depth_values<S: Simd>(s: S, block: &mut Block, pass: &Pass<'_>) {
    let needs = &pass.pipeline.needs;
    for slot in 0..block.count {
        let triangle = &pass.triangles[block.slots[slot].triangle as usize];
        if needs.z {
            z_of_slot(s, block, triangle, slot);
        }
        if needs.w {
            w_of_slot(s, block, triangle, slot);
        }
    }
    bias_depth(s, block, pass);
}

/// Makes `block.depth` from z or w and the bias.
#[inline(always)]
pub(crate) fn bias_depth<S: Simd>(s: S, block: &mut Block, pass: &Pass<'_>) {
    let depth = &pass.pipeline.state.depth;
    let bias = s.splat(i32::from(depth.bias.unwrap_or(0)));
    let source = match depth.source {
        DepthSource::Z => &block.z,
        DepthSource::FloatW => &block.w,
    };
    for k in (0..block.len()).step_by(S::LANES) {
        let biased = (s.load(&source.0[k..]) + bias).max(s.splat(0)).min(s.splat(0xffff));
        s.store(biased, &mut block.depth.0[k..]);
    }
}

/// Lanes where `source OP reference`, as bits.
#[inline(always)]
pub(crate) fn compare<S: Simd>(op: Compare, source: S::I, reference: S::I) -> u32 {
    let all = (1u64 << S::LANES) as u32 - 1;
    match op {
        Compare::Never => 0,
        Compare::Less => reference.gt(source).bits(),
        Compare::Equal => source.eq(reference).bits(),
        Compare::LessEqual => !source.gt(reference).bits() & all,
        Compare::Greater => source.gt(reference).bits(),
        Compare::NotEqual => !source.eq(reference).bits() & all,
        Compare::GreaterEqual => !reference.gt(source).bits() & all,
        Compare::Always => all,
    }
}

/// Drops the fragments that fail the depth test.
#[inline(always)]
pub(crate) fn depth_test<S: Simd>(s: S, block: &mut Block, pass: &Pass<'_>, tile: &mut Tile<'_>) {
    let depth = &pass.pipeline.state.depth;
    let Some(op) = depth.test else { return };
    let constant = depth.compare_constant.map(i32::from);
    let mut passed = 0u64;
    for slot in 0..block.count {
        let at = block.slots[slot].at as usize;
        for j in (0..STAMP).step_by(S::LANES) {
            let k = slot * STAMP + j;
            let source = match constant {
                Some(value) => s.splat(value),
                None => s.load(&block.depth.0[k..]),
            };
            let stored = s.load16(&tile.aux[at + j..]);
            passed |= u64::from(compare::<S>(op, source, stored)) << k;
        }
    }
    tile.counters.depth_fail += block.keep(passed);
}

/// Writes the depth of the fragments left.
#[inline(always)]
pub(crate) fn depth_write<S: Simd>(s: S, block: &mut Block, tile: &mut Tile<'_>) {
    for slot in 0..block.count {
        let at = block.slots[slot].at as usize;
        for j in (0..STAMP).step_by(S::LANES) {
            let k = slot * STAMP + j;
            let live = s.mask((block.live >> k) as u32);
            s.store16(s.load(&block.depth.0[k..]), &mut tile.aux[at + j..], live);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use fillrate_simd::{Kernel, Level};

    struct FloatW(Vec<i64>);

    impl Kernel for FloatW {
        type Output = Vec<i32>;
        #[inline(always)]
        fn run<S: Simd>(self, s: S) -> Vec<i32> {
            let mut out = vec![0; self.0.len()];
            for (w, out) in self.0.chunks_exact(16).zip(out.chunks_exact_mut(16)) {
                for j in (0..16).step_by(S::LANES) {
                    let w: Vec<f64> = w[j..].iter().map(|&w| w as f64).collect();
                    let mut padded = [0.0; 16];
                    padded[..w.len()].copy_from_slice(&w);
                    s.store(float_w_lanes(s, s.load_f(&padded)), &mut out[j..]);
                }
            }
            out
        }
    }

    #[test]
    fn float_w_of_known_values() {
        assert_eq!(float_w(1 << 32), 0);
        assert_eq!(float_w(-1), 0);
        assert_eq!(float_w(0xffff_ffff), 1);
        assert_eq!(float_w(0x8000_0000), 0x1000);
        assert_eq!(float_w(0), 0xffff);
        assert_eq!(float_w(0xffff), 0xffff);
        assert_eq!(float_w(0x1_0000), 0xffff);
        assert_eq!(float_w(0x1_8000), 0xf800);
    }

    #[test]
    fn float_w_lanes_equal_the_scalar() {
        let mut values = vec![0, 1, 0xffff, 0x1_0000, 0x1_0001, 0xffff_ffff, 1 << 32, -1, -70000];
        let mut seed = 1u64;
        while values.len() < 160_000 {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            values.push((seed >> 17) as i64 >> (seed % 47));
            values.push(-((seed >> 20) as i64 >> (seed % 31)));
        }
        values.truncate(160_000);
        let expected: Vec<i32> = values.iter().map(|&w| i32::from(float_w(w))).collect();
        for level in Level::available() {
            assert_eq!(level.dispatch(FloatW(values.clone())), expected, "{level}");
        }
    }
}
