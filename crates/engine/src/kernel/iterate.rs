//! Iterated colour and alpha.

use fillrate_simd::{IntLanes, Simd};

use super::Pass;
use super::block::{Block, STAMP};
use super::lanes::{iterate, places, wrap_colors};
use crate::setup::Narrow;

/// Red, green, blue and alpha at screen columns and rows. The iterators are
/// 12.12 in the top 24 bits: the integer part is the top 12.
///
/// Source: SST1, colour iterators; they wrap, see [`wrap_colors`].
#[inline(always)]
pub(super) fn iterated_colors<S: Simd>(s: S, narrow: &Narrow, places: [S::I; 2]) -> [S::I; 2] {
    let high = s.splat(0x0fff_0000);
    let (r, g) = (iterate(s, narrow, 0, places), iterate(s, narrow, 1, places));
    let (b, a) = (iterate(s, narrow, 2, places), iterate(s, narrow, 3, places));
    let rb = r.shr(20) | (b.shr(4) & high);
    let ga = g.shr(20) | (a.shr(4) & high);
    // In range there is nothing to wrap.
    if ((rb | ga) & s.splat(0xff00_ff00u32 as i32)).any() {
        return [wrap_colors(s, rb), wrap_colors(s, ga)];
    }
    [rb, ga]
}

/// Iterates red, green, blue and alpha into `block.iterated`, or straight into
/// `block.color` where the combine units pass them on.
#[inline(always)]
pub(crate) fn iterate_colors<S: Simd>(s: S, block: &mut Block, pass: &Pass<'_>) {
    let Block { count, slots, iterated, color, .. } = block;
    let out = if pass.pipeline.passes_iterated { color } else { iterated };
    for (slot, at) in slots[..*count].iter().enumerate() {
        let narrow = &pass.triangle(at).narrow;
        for j in (0..STAMP).step_by(S::LANES) {
            let k = slot * STAMP + j;
            let [rb, ga] = iterated_colors(s, narrow, places(s, at.x, at.y, j));
            s.store(rb, &mut out.rb.0[k..]);
            s.store(ga, &mut out.ga.0[k..]);
        }
    }
}
