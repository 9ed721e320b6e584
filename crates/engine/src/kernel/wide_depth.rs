//! Depth beyond the SST-1's: 32-bit planes and deep sources. It stands in the
//! place of the depth stage of states that have either.

use fillrate_simd::{FloatLanes, IntLanes, MaskLanes, Simd};

use super::block::{Block, Lanes, STAMP, Slot};
use super::depth::{DepthLanes, DepthTest, IteratedZ, Kept, compare, keep_depth, reject_overflow};
use super::lanes::ramp_wide;
use super::{Pass, Tile};
use crate::setup::{Plane64, PlaneF};
use crate::state::DepthSource;

/// Depths of a deep source.
struct Deep {
    values: [i32; STAMP],
}

impl<S: Simd> DepthLanes<S> for Deep {
    #[inline(always)]
    fn enter(&mut self, s: S, pass: &Pass<'_>, at: &Slot, _slot: usize) {
        let (triangle, pipeline) = (pass.triangle(at), pass.pipeline);
        let by_w = pipeline.state.depth.source == DepthSource::DeepW;
        let plane = if by_w {
            pass.triangles.w(triangle)
        } else {
            pass.triangles.deep_z(triangle, pipeline.needs.extra)
        };
        let corner = plane.at(at.x, at.y);
        if !floats_hold(&plane, corner) {
            return exact_stamp(&plane, by_w, at, &mut self.values);
        }
        let mut ramp = [0.0; STAMP];
        let steps = PlaneF { start: 0.0, dx: plane.dx as f64, dy: plane.dy as f64 };
        ramp_wide(s, &steps, &mut ramp);
        let base = s.splat_f(corner as f64);
        let whole = s.splat_f(1.0 / (1u64 << 32) as f64);
        for j in (0..STAMP).step_by(S::LANES) {
            let value = base + s.load_f(&ramp[j..]);
            let depth = if by_w { value.high_word() } else { (value * whole).floor_i32() };
            s.store(depth.max(s.splat(0)), &mut self.values[j..]);
        }
    }

    #[inline(always)]
    fn lanes(&self, s: S, _pass: &Pass<'_>, _at: &Slot, j: usize) -> S::I {
        s.load(&self.values[j..])
    }
}

/// Whether all values of a stamp with that first one are integers that floats
/// hold.
fn floats_hold(plane: &Plane64, corner: i64) -> bool {
    let reach = plane.dx.unsigned_abs().saturating_add(plane.dy.unsigned_abs()).saturating_mul(3);
    reach.saturating_add(corner.unsigned_abs()) < 1 << 52
}

/// The depths of a stamp whose iterators are too large for floats.
#[inline(always)]
fn exact_stamp(plane: &Plane64, by_w: bool, at: &Slot, out: &mut [i32; STAMP]) {
    for (i, out) in out.iter_mut().enumerate() {
        let value = plane.at(at.x + (i & 3) as i32, at.y + (i >> 2) as i32);
        *out = match by_w {
            true => ((value.max(0) as f64).to_bits() >> 32) as i32,
            false => (value >> 32).clamp(0, i64::from(i32::MAX)) as i32,
        };
    }
}

/// Computes z and w where they are needed, tests and writes depth; `READY` where
/// the depths are in the block already.
#[inline(always)]
pub(crate) fn wide_depth<S: Simd, const READY: bool>(
    s: S,
    block: &mut Block,
    pass: &Pass<'_>,
    tile: &mut Tile<'_>,
) {
    if READY {
        let Block { live, count, slots, z, depth, .. } = block;
        let fragments = Fragments { live, slots: &slots[..*count], depth };
        return test_depth(s, fragments, &mut Kept { values: z, first: 0 }, pass, tile);
    }
    reject_overflow(s, block, pass, tile);
    keep_depth(s, block, pass);
    let Block { live, count, slots, steps, depth, .. } = block;
    let fragments = Fragments { live, slots: &slots[..*count], depth };
    match pass.pipeline.state.depth.source {
        DepthSource::Z => test_depth(s, fragments, &mut IteratedZ::new(pass), pass, tile),
        DepthSource::FloatW => test_depth(s, fragments, &mut steps.w, pass, tile),
        DepthSource::DeepZ | DepthSource::DeepW => {
            test_depth(s, fragments, &mut Deep { values: [0; STAMP] }, pass, tile);
        }
    }
}

/// The parts of a block that the depth test works on.
struct Fragments<'a> {
    live: &'a mut u64,
    slots: &'a [Slot],
    depth: &'a mut Lanes,
}

/// Drops the fragments that fail the test, and writes the depth of the others,
/// at once or into `block.depth` where something later can drop them.
#[inline(always)]
fn test_depth<S: Simd, D: DepthLanes<S>>(
    s: S,
    fragments: Fragments<'_>,
    source: &mut D,
    pass: &Pass<'_>,
    tile: &mut Tile<'_>,
) {
    let needs = &pass.pipeline.needs;
    if !needs.depth {
        return;
    }
    let deep = pass.pipeline.state.depth.source.is_deep();
    let test = DepthTest::new(pass.pipeline);
    let before = *fragments.live;
    let mut left = 0;
    for (slot, at) in fragments.slots.iter().enumerate() {
        source.enter(s, pass, at, slot);
        for j in (0..STAMP).step_by(S::LANES) {
            let k = slot * STAMP + j;
            let value = source.lanes(s, pass, at, j);
            let value = if deep { value } else { test.biased(s, value) };
            if needs.late_depth_write {
                s.store(value, &mut fragments.depth.0[k..]);
            }
            let place = at.at as usize + j;
            let mut passed = s.mask((before >> k) as u32);
            if let Some(op) = test.test {
                let compared = match test.constant {
                    Some(constant) if !deep => s.splat(constant),
                    _ => value,
                };
                // Planes hold unsigned numbers, and lanes compare signed ones.
                let sign = s.splat(i32::MIN);
                let stored = tile.load_aux(s, place);
                passed = passed & compare(s, op, compared ^ sign, stored ^ sign);
            }
            if test.writes {
                tile.store_aux(s, value, place, passed);
            }
            left |= u64::from(passed.bits()) << k;
        }
    }
    *fragments.live = left;
    tile.counters.depth_fail += u64::from((before & !left).count_ones());
}
