//! Stipple: drops fragments by a fixed pattern.

use super::block::{Block, STAMP};
use super::{Pass, Tile};

/// Drops the fragments whose pattern bit is 0. They count in no counter but
/// `pixels_in`.
///
/// Source: SST1, stipple register, pattern mode.
pub(crate) fn stipple(block: &mut Block, pass: &Pass<'_>, _tile: &mut Tile<'_>) {
    let Some(stipple) = pass.pipeline.state.stipple else { return };
    let mut pass_bits = 0u64;
    for slot in 0..block.count {
        let at = block.slots[slot];
        for i in 0..STAMP {
            let (x, y) = (at.x as u32 + (i as u32 & 3), at.y as u32 + (i as u32 >> 2));
            let bit = ((y & 3) << 3) | (!x & 7);
            pass_bits |= u64::from(stipple.pattern >> bit & 1) << (slot * STAMP + i);
        }
    }
    block.keep(pass_bits);
}
