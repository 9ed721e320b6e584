//! Depth: z and w of the fragments, the test, and the write.
//!
//! Source: SST1, fbzMode; the test runs before texturing, which changes no
//! result because depth is written only where everything else passes.

use fillrate_simd::{FloatLanes, IntLanes, MaskLanes, Simd};

use super::block::{Block, STAMP};
use super::lanes::{ramp, ramp_wide, wrap};
use super::{Pass, Tile};
use crate::setup::{Triangle, Z};
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

/// Iterates z of one stamp into `z`.
#[inline(always)]
fn z_of_stamp<S: Simd>(s: S, base: i32, ramp: &[i32; STAMP], z: &mut [i32]) {
    for j in (0..STAMP).step_by(S::LANES) {
        let value = s.splat(base) + s.load(&ramp[j..]);
        s.store(wrap::<S, 20, 16>(s, value.shr(12)), &mut z[j..]);
    }
}

/// Iterates z into `block.z`.
#[inline(always)]
fn iterate_z<S: Simd>(s: S, block: &mut Block, pass: &Pass<'_>) {
    let Block { count, slots, z, .. } = block;
    let mut z_ramp = [0; STAMP];
    let mut current = u32::MAX;
    for (slot, at) in slots[..*count].iter().enumerate() {
        let narrow = &pass.triangles[at.triangle as usize].narrow;
        if at.triangle != current {
            current = at.triangle;
            ramp(s, narrow.dx[Z], narrow.dy[Z], &mut z_ramp);
        }
        z_of_stamp(s, narrow.value(Z, at.x, at.y), &z_ramp, &mut z.0[slot * STAMP..]);
    }
}

/// Iterates the pseudo-float w into `block.w`.
#[inline(always)]
fn iterate_w<S: Simd>(s: S, block: &mut Block, pass: &Pass<'_>) {
    let Block { count, slots, w, .. } = block;
    let mut w_ramp = [0.0; STAMP];
    let mut current = u32::MAX;
    for (slot, at) in slots[..*count].iter().enumerate() {
        let triangle = &pass.triangles[at.triangle as usize];
        let out = &mut w.0[slot * STAMP..][..STAMP];
        if !triangle.exact {
            exact_w_of_stamp(triangle, at.x, at.y, out);
            continue;
        }
        if at.triangle != current {
            current = at.triangle;
            ramp_wide(s, &triangle.w, &mut w_ramp);
        }
        let base = s.splat_f(triangle.w.at(at.x, at.y) as f64);
        for j in (0..STAMP).step_by(S::LANES) {
            s.store(float_w_lanes(s, base + s.load_f(&w_ramp[j..])), &mut out[j..]);
        }
    }
}

/// The pseudo-float w of a stamp whose iterators are too large for floats.
fn exact_w_of_stamp(triangle: &Triangle, x: i32, y: i32, out: &mut [i32]) {
    for (i, out) in out.iter_mut().enumerate() {
        *out = i32::from(float_w(triangle.w.at(x + (i & 3) as i32, y + (i >> 2) as i32)));
    }
}

/// Computes z and w where the pipeline needs them.
#[inline(always)]
pub(crate) fn depth_values<S: Simd>(s: S, block: &mut Block, pass: &Pass<'_>) {
    let needs = &pass.pipeline.needs;
    if needs.z {
        iterate_z(s, block, pass);
    }
    if needs.w {
        iterate_w(s, block, pass);
    }
}

/// Lanes where `source OP reference`.
#[inline(always)]
pub(crate) fn compare<S: Simd>(s: S, op: Compare, source: S::I, reference: S::I) -> S::M {
    let one = s.splat(1);
    match op {
        Compare::Never => s.mask(0),
        Compare::Less => reference.gt(source),
        Compare::Equal => source.eq(reference),
        Compare::LessEqual => (reference + one).gt(source),
        Compare::Greater => source.gt(reference),
        Compare::NotEqual => source.gt(reference) | reference.gt(source),
        Compare::GreaterEqual => (source + one).gt(reference),
        Compare::Always => s.mask(u32::MAX),
    }
}

/// Biases the depth values into `block.depth` where something later reads
/// them, drops the fragments that fail the depth test, and writes the depth of
/// the others where nothing later can drop them.
#[inline(always)]
pub(crate) fn test_depth<S: Simd>(s: S, block: &mut Block, pass: &Pass<'_>, tile: &mut Tile<'_>) {
    let pipeline = pass.pipeline;
    if !pipeline.needs.depth {
        return;
    }
    let depth = &pipeline.state.depth;
    let late = pipeline.needs.late_depth_write;
    let writes = pipeline.writes_depth() && !late;
    let bias = s.splat(i32::from(depth.bias.unwrap_or(0)));
    let constant = depth.compare_constant.map(i32::from);
    let Block { live, count, slots, z, w, depth: kept, .. } = block;
    let values = match depth.source {
        DepthSource::Z => z,
        DepthSource::FloatW => w,
    };
    let before = live.count_ones();
    for (slot, at) in slots[..*count].iter().enumerate() {
        for j in (0..STAMP).step_by(S::LANES) {
            let k = slot * STAMP + j;
            let mut value = s.load(&values.0[k..]);
            if depth.bias.is_some() {
                value = (value + bias).max(s.splat(0)).min(s.splat(0xffff));
            }
            if late {
                s.store(value, &mut kept.0[k..]);
            }
            let mut lanes = s.mask((*live >> k) as u32);
            if let Some(op) = depth.test {
                let source = match constant {
                    Some(constant) => s.splat(constant),
                    None => value,
                };
                let stored = s.load16(&tile.aux[at.at as usize + j..]);
                lanes = lanes & compare(s, op, source, stored);
                let all = (1u64 << S::LANES) - 1;
                *live &= !(all << k) | u64::from(lanes.bits()) << k;
            }
            if writes {
                s.store16(value, &mut tile.aux[at.at as usize + j..], lanes);
            }
        }
    }
    tile.counters.depth_fail += u64::from(before - live.count_ones());
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
