//! Iterated colour and alpha.

use fillrate_simd::{IntLanes, Simd};

use super::Pass;
use super::block::{Block, STAMP, Slot};
use super::lanes::{ramp, wrap_colors};
use crate::setup::NARROW;

/// The colour iterators over one stamp after another.
///
/// Source: SST1, colour iterators; they wrap, see [`wrap_colors`].
#[derive(Clone, Debug)]
pub(crate) struct IteratedColors {
    /// What the steps belong to.
    pub(super) triangle: u32,
    /// Red, green, blue and alpha within a stamp, less its first fragment.
    ramps: [[i32; STAMP]; 4],
    /// At the stamp's first fragment.
    base: [i32; NARROW],
}

impl IteratedColors {
    pub const NONE: IteratedColors =
        IteratedColors { triangle: u32::MAX, ramps: [[0; STAMP]; 4], base: [0; NARROW] };

    /// Goes to a stamp.
    #[inline(always)]
    pub fn enter<S: Simd>(&mut self, s: S, pass: &Pass<'_>, at: &Slot) {
        let narrow = &pass.triangle(at).narrow;
        if at.triangle != self.triangle {
            self.triangle = at.triangle;
            for (lane, ramp_of_lane) in self.ramps.iter_mut().enumerate() {
                ramp(s, narrow.dx[lane], narrow.dy[lane], ramp_of_lane);
            }
        }
        self.base = narrow.at(at.x, at.y);
    }

    /// The colours of the stamp's fragments `j..`. The iterators are 12.12 in
    /// the top 24 bits: the integer part is the top 12.
    #[inline(always)]
    pub fn lanes<S: Simd>(&self, s: S, j: usize) -> [S::I; 2] {
        let [r, g, b, a, ..] = self.base;
        let r = s.splat(r) + s.load(&self.ramps[0][j..]);
        let g = s.splat(g) + s.load(&self.ramps[1][j..]);
        let b = s.splat(b) + s.load(&self.ramps[2][j..]);
        let a = s.splat(a) + s.load(&self.ramps[3][j..]);
        let high = s.splat(0x0fff_0000);
        let rb = r.shr(20) | (b.shr(4) & high);
        let ga = g.shr(20) | (a.shr(4) & high);
        // In range there is nothing to wrap.
        if ((rb | ga) & s.splat(0xff00_ff00u32 as i32)).any() {
            return [wrap_colors(s, rb), wrap_colors(s, ga)];
        }
        [rb, ga]
    }
}

/// Iterates red, green, blue and alpha into `block.iterated`, or straight into
/// `block.color` where the combine units pass them on.
#[inline(always)]
pub(crate) fn iterate_colors<S: Simd>(s: S, block: &mut Block, pass: &Pass<'_>) {
    let Block { count, slots, iterated, color, steps, .. } = block;
    let out = if pass.pipeline.passes_iterated { color } else { iterated };
    let colors = &mut steps.colors;
    for (slot, at) in slots[..*count].iter().enumerate() {
        colors.enter(s, pass, at);
        for j in (0..STAMP).step_by(S::LANES) {
            let k = slot * STAMP + j;
            let [rb, ga] = colors.lanes(s, j);
            s.store(rb, &mut out.rb.0[k..]);
            s.store(ga, &mut out.ga.0[k..]);
        }
    }
}
