//! Iterated colour and alpha.

use fillrate_simd::{IntLanes, Simd};

use super::Pass;
use super::block::{Block, Colors, STAMP};
use super::lanes::{ramp, wrap_colors};

/// Iterates red, green, blue and alpha into `block.iterated`, or straight into
/// `block.color` where the combine units pass them on.
///
/// Source: SST1, colour iterators; they wrap, see [`wrap_colors`].
#[inline(always)]
pub(crate) fn iterate_colors<S: Simd>(s: S, block: &mut Block, pass: &Pass<'_>) {
    let Block { count, slots, iterated, color, .. } = block;
    let out: &mut Colors = if pass.pipeline.passes_iterated() { color } else { iterated };
    let mut ramps = [[0; STAMP]; 4];
    let mut current = u32::MAX;
    for (slot, at) in slots[..*count].iter().enumerate() {
        let narrow = &pass.triangles[at.triangle as usize].narrow;
        if at.triangle != current {
            current = at.triangle;
            for (lane, ramp_of_lane) in ramps.iter_mut().enumerate() {
                ramp(s, narrow.dx[lane], narrow.dy[lane], ramp_of_lane);
            }
        }
        let [r, g, b, a, ..] = narrow.at(at.x, at.y);
        for j in (0..STAMP).step_by(S::LANES) {
            let k = slot * STAMP + j;
            let r = s.splat(r) + s.load(&ramps[0][j..]);
            let g = s.splat(g) + s.load(&ramps[1][j..]);
            let b = s.splat(b) + s.load(&ramps[2][j..]);
            let a = s.splat(a) + s.load(&ramps[3][j..]);
            s.store(pair(s, r, b), &mut out.rb.0[k..]);
            s.store(pair(s, g, a), &mut out.ga.0[k..]);
        }
    }
}

/// A pair of channels from two iterators. They are 12.12 in the top 24 bits:
/// the integer part is the top 12.
#[inline(always)]
fn pair<S: Simd>(s: S, low: S::I, high: S::I) -> S::I {
    wrap_colors(s, low.shr(20) | (high.shr(4) & s.splat(0x0fff_0000)))
}
