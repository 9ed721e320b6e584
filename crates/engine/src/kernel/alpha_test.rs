//! Alpha test.

use fillrate_simd::{IntLanes, MaskLanes, Simd};

use super::block::Block;
use super::depth::compare;
use super::{Pass, Tile};

/// Drops the fragments whose combined alpha fails the test.
///
/// Source: SST1, alphaMode; the alpha is the alpha combine unit's output.
#[inline(always)]
pub(crate) fn alpha_test<S: Simd>(s: S, block: &mut Block, pass: &Pass<'_>, tile: &mut Tile<'_>) {
    let Some(test) = pass.pipeline.state.alpha_test else { return };
    let reference = s.splat(i32::from(test.reference));
    let mut passed = 0u64;
    for k in (0..block.len()).step_by(S::LANES) {
        let alpha = s.load(&block.color.ga.0[k..]).shr(16);
        passed |= u64::from(compare(s, test.compare, alpha, reference).bits()) << k;
    }
    tile.counters.alpha_fail += block.keep(passed);
}
