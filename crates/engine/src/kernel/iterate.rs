//! Iterated colour and alpha.

use fillrate_simd::{IntLanes, Simd};

use super::Pass;
use super::block::{Block, STAMP, Slot};
use super::lanes::{iterate, wrap_colors};
use crate::setup::Plane32;

/// Iterates red, green, blue and alpha into `block.iterated`.
///
/// Source: SST1, colour iterators; they wrap, see [`wrap_colors`].
#[inline(always)]
pub(crate) fn iterate_colors<S: Simd>(s: S, block: &mut Block, pass: &Pass<'_>) {
    for slot in 0..block.count {
        let at = block.slots[slot];
        let [r, g, b, a] = &pass.triangles[at.triangle as usize].color;
        for j in (0..STAMP).step_by(S::LANES) {
            let k = slot * STAMP + j;
            let rb = pair(s, [r, b], at, j);
            let ga = pair(s, [g, a], at, j);
            s.store(rb, &mut block.iterated.rb.0[k..]);
            s.store(ga, &mut block.iterated.ga.0[k..]);
        }
    }
}

/// A pair of channels of fragments `j..` of a stamp. The planes are 12.12 in
/// the top 24 bits: the integer part is the top 12.
#[inline(always)]
fn pair<S: Simd>(s: S, [low, high]: [&Plane32; 2], at: Slot, j: usize) -> S::I {
    let low = iterate(s, low, at.x, at.y, j).shr(20);
    let high = iterate(s, high, at.x, at.y, j).shr(4) & s.splat(0x0fff_0000);
    wrap_colors(s, low | high)
}
