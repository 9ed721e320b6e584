//! Sizes and addresses of mip map levels in texture memory.
//!
//! Levels are numbered by "LOD": 0 is 256 texels on the longer side, 8 is one.
//! Aspect ratios run from 0 (8:1) over 3 (square) to 6 (1:8).
//!
//! Source: G246, texture size tables; SST1, texBaseAddr.

use crate::enums::{LEVELS_BOTH, LEVELS_EVEN, LEVELS_ODD};

/// The smallest level: 1x1.
pub const SMALLEST: u32 = 8;

/// Texels of a level in memory, by the larger side over the smaller one as a
/// power of two (0 to 3) and LOD. Small levels are padded.
const MEMORY_TEXELS: [[u32; 9]; 4] = [
    [0x10000, 0x4000, 0x1000, 0x400, 0x100, 0x40, 0x10, 4, 4],
    [0x8000, 0x2000, 0x800, 0x200, 0x80, 0x20, 8, 4, 4],
    [0x4000, 0x1000, 0x400, 0x100, 0x40, 0x10, 8, 4, 4],
    [0x2000, 0x800, 0x200, 0x80, 0x20, 0x10, 8, 4, 4],
];

/// log2 of the longer side over the shorter one, and whether s is the longer.
pub fn aspect_bits(aspect: i32) -> (u32, bool) {
    let from_square = 3 - aspect.clamp(0, 6);
    (from_square.unsigned_abs(), from_square > 0)
}

/// Columns and rows of a level as texels are stored.
pub fn size(aspect: i32, lod: u32) -> (u32, u32) {
    let (bits, wide) = aspect_bits(aspect);
    let long = 256 >> lod.min(SMALLEST);
    let short = (long >> bits).max(1);
    if wide { (long, short) } else { (short, long) }
}

/// Bytes of a texel: 2 from format 8 on.
pub fn texel_bytes(format: i32) -> u32 {
    if format >= 8 { 2 } else { 1 }
}

/// Bytes of a level in texture memory.
pub fn level_bytes(aspect: i32, lod: u32, format: i32) -> u32 {
    let (bits, _) = aspect_bits(aspect);
    MEMORY_TEXELS[bits as usize][lod.min(SMALLEST) as usize] * texel_bytes(format)
}

/// Whether a level belongs to the even, odd or both levels.
pub fn is_selected(even_odd: u32, lod: u32) -> bool {
    match even_odd {
        LEVELS_EVEN => lod.is_multiple_of(2),
        LEVELS_ODD => !lod.is_multiple_of(2),
        LEVELS_BOTH => true,
        _ => false,
    }
}

/// Bytes of the selected levels from `large` (the lower number) to `small`,
/// rounded up to eight.
pub fn chain_bytes(small: u32, large: u32, aspect: i32, format: i32, even_odd: u32) -> u32 {
    let levels = large..=small.min(SMALLEST);
    let selected = levels.filter(|&lod| is_selected(even_odd, lod));
    let bytes: u32 = selected.map(|lod| level_bytes(aspect, lod, format)).sum();
    bytes.next_multiple_of(8)
}

/// Bytes from where level 256 would be to a level: the selected levels above.
pub fn offset(aspect: i32, lod: u32, format: i32, even_odd: u32) -> u32 {
    (0..lod).filter(|&l| is_selected(even_odd, l)).map(|l| level_bytes(aspect, l, format)).sum()
}

/// The base register (in bytes, wrapping) for a chain whose largest level
/// `large` starts at `start`.
///
/// The register counts eights, for downloads as for drawing: what is below is
/// dropped, and a level of one 8-bit texel may lie four bytes below `start`.
pub fn base_address(start: u32, large: u32, aspect: i32, format: i32, even_odd: u32) -> u32 {
    let first = if is_selected(even_odd, large) { large } else { large + 1 };
    start.wrapping_sub(offset(aspect, first, format, even_odd)) & !7
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_follow_the_aspect_ratio() {
        assert_eq!(size(0, 0), (256, 32));
        assert_eq!(size(3, 2), (64, 64));
        assert_eq!(size(6, 0), (32, 256));
        assert_eq!(size(0, 6), (4, 1));
        assert_eq!(size(6, 8), (1, 1));
    }

    #[test]
    fn chains_add_up() {
        // A full square 8-bit chain: 65536 + ... + 16 + 4 + 4, rounded to 8.
        assert_eq!(chain_bytes(8, 0, 3, 0, LEVELS_BOTH), 87384);
        assert_eq!(chain_bytes(0, 0, 3, 10, LEVELS_BOTH), 131072);
        assert_eq!(chain_bytes(8, 8, 3, 0, LEVELS_BOTH), 8);
        let parts = chain_bytes(8, 0, 3, 10, LEVELS_EVEN) + chain_bytes(8, 0, 3, 10, LEVELS_ODD);
        assert_eq!(parts, chain_bytes(8, 0, 3, 10, LEVELS_BOTH));
    }

    #[test]
    fn the_base_points_to_where_level_256_would_be() {
        assert_eq!(base_address(0x20000, 1, 3, 0, LEVELS_BOTH), 0x10000);
        let base = base_address(64, 2, 3, 0, LEVELS_BOTH);
        assert_eq!(base.wrapping_add(offset(3, 2, 0, LEVELS_BOTH)), 64);
        // Levels of four bytes leave no multiple of eight.
        assert_eq!(base_address(64, 8, 3, 0, LEVELS_BOTH) % 8, 0);
        // An odd chain whose largest level is even starts with the next one.
        let base = base_address(64, 2, 3, 0, LEVELS_ODD);
        assert_eq!(base.wrapping_add(offset(3, 3, 0, LEVELS_ODD)), 64);
    }
}
