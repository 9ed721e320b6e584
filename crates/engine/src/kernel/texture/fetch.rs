//! Texels: loading and filtering.

use fillrate_simd::{IntLanes, Simd};

use super::UnitPlan;
use crate::kernel::block::Block;
use crate::kernel::lanes::mix_256;

/// The samples of fragments `k..` that [`super::address`] described.
///
/// A bilinear sample is the sum of four texels by weights of 256 together,
/// truncated once.
#[inline(always)]
pub(crate) fn texels<S: Simd, const POINT: bool>(
    s: S,
    block: &Block,
    entries: &[u64],
    k: usize,
) -> [S::I; 2] {
    let (rb0, ga0) = s.load_pairs_at(entries, &block.row0.0[k..]);
    if POINT {
        let channels = s.splat(0x00ff_00ff);
        return [rb0 & channels, ga0 & channels];
    }
    let (rb1, ga1) = s.load_pairs_at(entries, &block.row1.0[k..]);
    let across = s.load(&block.weight_s.0[k..]);
    let lower = s.load(&block.weight_t.0[k..]);
    let upper = s.splat(0x0010_0010).sub16(lower);
    let rb = rb0.dot_bytes(across).mul16(upper).add16(rb1.dot_bytes(across).mul16(lower));
    let ga = ga0.dot_bytes(across).mul16(upper).add16(ga1.dot_bytes(across).mul16(lower));
    [rb.shr16(8), ga.shr16(8)]
}

/// Loads and filters the block's texels into `block.texture` where they are
/// the unit's output, else `block.scratch`.
#[inline(always)]
pub(crate) fn fetch<S: Simd>(s: S, block: &mut Block, plan: &UnitPlan) {
    if plan.point {
        fetch_all::<S, true>(s, block, plan)
    } else {
        fetch_all::<S, false>(s, block, plan)
    }
}

#[inline(always)]
fn fetch_all<S: Simd, const POINT: bool>(s: S, block: &mut Block, plan: &UnitPlan) {
    let entries = plan.texture.entries();
    for k in (0..block.len()).step_by(S::LANES) {
        let [rb, ga] = texels::<S, POINT>(s, block, entries, k);
        let out = if plan.texel_only { &mut block.texture } else { &mut block.scratch };
        s.store(rb, &mut out.rb.0[k..]);
        s.store(ga, &mut out.ga.0[k..]);
    }
}

/// Mixes the samples of [`fetch`] with those of the next coarser level, whose
/// addresses are in the block now, by the fraction of the level of detail.
#[inline(always)]
pub(crate) fn mix_next<S: Simd>(s: S, block: &mut Block, plan: &UnitPlan) {
    let entries = plan.texture.entries();
    for k in (0..block.len()).step_by(S::LANES) {
        let [rb, ga] = if plan.point {
            texels::<S, true>(s, block, entries, k)
        } else {
            texels::<S, false>(s, block, entries, k)
        };
        let fraction = s.load(&block.lod.0[k..]) & s.splat(0xff);
        let fraction = fraction | fraction.shl(16);
        let out = if plan.texel_only { &mut block.texture } else { &mut block.scratch };
        let finer = [s.load(&out.rb.0[k..]), s.load(&out.ga.0[k..])];
        s.store(mix_256(s, finer[0], rb, fraction), &mut out.rb.0[k..]);
        s.store(mix_256(s, finer[1], ga, fraction), &mut out.ga.0[k..]);
    }
}
