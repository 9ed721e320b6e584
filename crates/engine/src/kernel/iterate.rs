//! Iterated colour and alpha.

use fillrate_simd::{IntLanes, Simd};

use super::Pass;
use super::block::{Block, STAMP};
use super::lanes::{iterate, places, wrap_colors};
use crate::setup::Narrow;

/// The red, green, blue and alpha iterators over a strip, one vector of each
/// stamp.
pub(super) struct ColorIterators<S: Simd> {
    now: [S::I; 4],
    /// From stamp to stamp.
    step: [S::I; 4],
}

impl<S: Simd> ColorIterators<S> {
    /// At screen columns and rows.
    #[inline(always)]
    pub fn new(s: S, narrow: &Narrow, places: [S::I; 2]) -> Self {
        let step = |lane: usize| narrow.dx[lane].wrapping_mul(4);
        ColorIterators {
            now: [
                iterate(s, narrow, 0, places),
                iterate(s, narrow, 1, places),
                iterate(s, narrow, 2, places),
                iterate(s, narrow, 3, places),
            ],
            step: [s.splat(step(0)), s.splat(step(1)), s.splat(step(2)), s.splat(step(3))],
        }
    }

    /// The same fragments of the next stamp.
    #[inline(always)]
    pub fn advance(&mut self) {
        for (now, step) in self.now.iter_mut().zip(self.step) {
            *now = *now + step;
        }
    }

    /// Red, green, blue, and alpha where it is wanted. The iterators are 12.12 in
    /// the top 24 bits: the integer part is the top 12.
    ///
    /// Source: SST1, colour iterators; they wrap, see [`wrap_colors`].
    #[inline(always)]
    pub fn colors<const ALPHA: bool>(&self, s: S) -> [S::I; 2] {
        let high = s.splat(0x0fff_0000);
        let [r, g, b, a] = self.now;
        let rb = r.shr(20) | (b.shr(4) & high);
        let ga = if ALPHA { g.shr(20) | (a.shr(4) & high) } else { g.shr(20) };
        // In range there is nothing to wrap.
        if ((rb | ga) & s.splat(0xff00_ff00u32 as i32)).any() {
            return [wrap_colors(s, rb), wrap_colors(s, ga)];
        }
        [rb, ga]
    }
}

/// [`ColorIterators::colors`] at screen columns and rows.
#[inline(always)]
pub(super) fn iterated_colors<S: Simd, const ALPHA: bool>(
    s: S,
    narrow: &Narrow,
    places: [S::I; 2],
) -> [S::I; 2] {
    ColorIterators::new(s, narrow, places).colors::<ALPHA>(s)
}

/// Iterates red, green, blue and alpha into `block.iterated`, or straight into
/// `block.color` where the combine units pass them on.
#[inline(always)]
pub(crate) fn iterate_colors<S: Simd>(s: S, block: &mut Block, pass: &Pass<'_>) {
    match pass.pipeline.needs.alpha {
        true => iterate_all::<S, true>(s, block, pass),
        false => iterate_all::<S, false>(s, block, pass),
    }
}

#[inline(always)]
fn iterate_all<S: Simd, const ALPHA: bool>(s: S, block: &mut Block, pass: &Pass<'_>) {
    let Block { count, slots, iterated, color, .. } = block;
    let out = if pass.pipeline.passes_iterated { color } else { iterated };
    for (slot, at) in slots[..*count].iter().enumerate() {
        let narrow = &pass.triangle(at).narrow;
        for j in (0..STAMP).step_by(S::LANES) {
            let k = slot * STAMP + j;
            let [rb, ga] = iterated_colors::<S, ALPHA>(s, narrow, places(s, at.x, at.y, j));
            s.store(rb, &mut out.rb.0[k..]);
            s.store(ga, &mut out.ga.0[k..]);
        }
    }
}
