//! Texels: loading and filtering.

use fillrate_simd::{IntLanes, Simd};

use super::UnitPlan;
use crate::kernel::block::{Block, Colors};

/// Loads and filters the texels that [`super::address`] found, into
/// `block.texture` where they are the unit's output, else `block.scratch`.
///
/// A bilinear sample is the sum of four texels by weights of 256 together,
/// truncated once.
#[inline(always)]
pub(crate) fn fetch<S: Simd>(s: S, block: &mut Block, plan: &UnitPlan) {
    let entries = plan.texture.entries();
    let len = block.len();
    let Block { row0, row1, weight_s, weight_t, texture, scratch, .. } = block;
    let out: &mut Colors = if plan.texel_only { texture } else { scratch };
    if plan.point {
        let channels = s.splat(0x00ff_00ff);
        for k in (0..len).step_by(S::LANES) {
            let (rb, ga) = s.load_pairs_at(entries, &row0.0[k..]);
            s.store(rb & channels, &mut out.rb.0[k..]);
            s.store(ga & channels, &mut out.ga.0[k..]);
        }
        return;
    }
    for k in (0..len).step_by(S::LANES) {
        let (rb0, ga0) = s.load_pairs_at(entries, &row0.0[k..]);
        let (rb1, ga1) = s.load_pairs_at(entries, &row1.0[k..]);
        let across = s.load(&weight_s.0[k..]);
        let lower = s.load(&weight_t.0[k..]);
        let upper = s.splat(0x0010_0010).sub16(lower);
        let rb = rb0.dot_bytes(across).mul16(upper).add16(rb1.dot_bytes(across).mul16(lower));
        let ga = ga0.dot_bytes(across).mul16(upper).add16(ga1.dot_bytes(across).mul16(lower));
        s.store(rb.shr16(8), &mut out.rb.0[k..]);
        s.store(ga.shr16(8), &mut out.ga.0[k..]);
    }
}
