//! Texel key: drops the fragments that show keyed texels.

use fillrate_simd::{IntLanes, MaskLanes, Simd};

use super::{UnitPlan, texels};
use crate::kernel::Tile;
use crate::kernel::block::Block;

/// The part of a keyed texel's mark from which on a sample is keyed: half.
const HALF: i32 = 0x40;

/// Drops the fragments half of whose sample, or more, is keyed texels. It runs
/// while the unit's addresses and weights are still in the block.
#[inline(always)]
pub(crate) fn texel_key<S: Simd>(s: S, block: &mut Block, plan: &UnitPlan, tile: &mut Tile<'_>) {
    let keys = plan.texture.keys();
    if keys.is_empty() {
        return;
    }
    let mut keyed = 0u64;
    for k in (0..block.len()).step_by(S::LANES) {
        let [marks, _] = if plan.point {
            texels::<S, true>(s, block, keys, k)
        } else {
            texels::<S, false>(s, block, keys, k)
        };
        let is_keyed = (marks & s.splat(0xff)).gt(s.splat(HALF - 1));
        keyed |= u64::from(is_keyed.bits()) << k;
    }
    tile.counters.chroma_fail += block.keep(!keyed);
}
