//! Stipple and patterns: drop fragments by their place.

use super::block::{Block, STAMP};
use super::{Pass, Tile};
use crate::state::{Pattern, PatternBits};

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

/// Drops the fragments in the gaps of a pattern without a background.
pub(crate) fn pattern(block: &mut Block, pass: &Pass<'_>, _tile: &mut Tile<'_>) {
    let Some(pattern) = &pass.pipeline.state.pattern else { return };
    let pass_bits = pattern_bits(block, pattern);
    block.keep(pass_bits);
}

/// The pattern's bits at a block's fragments.
pub(super) fn pattern_bits(block: &Block, pattern: &Pattern) -> u64 {
    let mut bits = 0u64;
    for (slot, at) in block.slots[..block.count].iter().enumerate() {
        bits |= u64::from(stamp_bits(pattern, at.x as u32, at.y as u32)) << (slot * STAMP);
    }
    bits
}

/// The pattern's bits at the stamp at (x, y).
fn stamp_bits(pattern: &Pattern, x: u32, y: u32) -> u16 {
    let mut bits = 0;
    match &pattern.bits {
        PatternBits::Area(rows) => {
            for row in 0..4 {
                // Four columns, the left one highest.
                let four = rows[((y + row) & 31) as usize] >> (28 - (x & 31)) & 15;
                bits |= (four.reverse_bits() >> 28) << (row * 4);
            }
        }
        PatternBits::Line { .. } => {
            // One row and one column, of which only the axis counts.
            let row = (0..4).map(|i| u32::from(pattern.draws(x + i, y)) << i).sum::<u32>();
            for i in 0..4 {
                let four =
                    if pattern.along_x() { row } else { u32::from(pattern.draws(x, y + i)) * 15 };
                bits |= four << (i * 4);
            }
        }
    }
    bits as u16
}
