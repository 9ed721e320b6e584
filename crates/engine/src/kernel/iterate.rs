//! Iterated colour and alpha.

use fillrate_simd::{IntLanes, Simd};

use super::Pass;
use super::block::{Block, STAMP};
use super::lanes::{iterate, wrap_colors};

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
            // 12.12 in the top 24 bits: the integer part is the top 12.
            let low = |plane| iterate(s, plane, at.x, at.y, j).shr(20);
            let high = |plane| iterate(s, plane, at.x, at.y, j).shr(4) & s.splat(0x0fff_0000);
            s.store(wrap_colors(s, low(r) | high(b)), &mut block.iterated.rb.0[k..]);
            s.store(wrap_colors(s, low(g) | high(a)), &mut block.iterated.ga.0[k..]);
        }
    }
}
