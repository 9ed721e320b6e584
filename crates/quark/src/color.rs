//! The fixed palette: 256 base colours in 32 intensities.
//!
//! Source: QK, frame buffer; colors and textures. The conversion to display
//! colours and the 50/50 blend are ours: see `docs/sources.md`, Quark 3D.

use std::sync::{Arc, LazyLock};

use fillrate_engine::PaletteBlend;

/// Bits of a pixel word that hold the colour: base 0..7, intensity 8..12.
pub const COLOR_MASK: u16 = 0x1fff;
/// Colours of the palette.
pub const COLORS: usize = COLOR_MASK as usize + 1;
/// Where the intensity starts in a colour.
pub const INTENSITY_SHIFT: u32 = 8;
/// The highest 5-bit intensity.
pub const INTENSITY_MAX: u32 = 31;

/// The base colour (red 7..6, green 5..3, blue 2..0) of 8-bit channels, by
/// truncation. Source: QK, `COLOR_RGB`.
pub const fn color_rgb(r: u8, g: u8, b: u8) -> u8 {
    (r >> 6) << 6 | (g >> 5) << 3 | b >> 5
}

/// An intensity of 0..=255 in its place of a pixel word, by truncation; to be
/// joined with a base colour. Source: QK, `COLOR_I`.
pub const fn color_i(intensity: u8) -> u16 {
    (intensity as u16 >> 3) << INTENSITY_SHIFT
}

/// 0..=3 as 0..=255.
const fn widen2(value: u32) -> u32 {
    value * 85
}

/// 0..=7 as 0..=255, by repeating bits.
const fn widen3(value: u32) -> u32 {
    value << 5 | value << 2 | value >> 1
}

/// An 8-bit channel at an intensity of 0..=31, rounded.
const fn shade(channel: u32, intensity: u32) -> u32 {
    (channel * intensity + 15) / INTENSITY_MAX
}

/// Red, green and blue, 0..=255, of a 13-bit colour; higher bits of `color`
/// are ignored.
pub const fn rgb888(color: u16) -> [u8; 3] {
    let c = (color & COLOR_MASK) as u32;
    let i = c >> INTENSITY_SHIFT;
    [
        shade(widen2(c >> 6 & 3), i) as u8,
        shade(widen3(c >> 3 & 7), i) as u8,
        shade(widen3(c & 7), i) as u8,
    ]
}

/// A 13-bit colour as the display's 565: red 15..11, green 10..5, blue 4..0.
pub const fn rgb565(color: u16) -> u16 {
    let [r, g, b] = rgb888(color);
    (r as u16 >> 3) << 11 | (g as u16 >> 2) << 5 | b as u16 >> 3
}

/// Both display colours of every palette colour.
#[derive(Debug)]
pub struct DisplayTables {
    /// [`rgb565`] of each 13-bit colour.
    pub rgb565: Vec<u16>,
    /// [`rgb888`] of each 13-bit colour.
    pub rgb888: Vec<[u8; 3]>,
}

/// The tables of the display conversion; built once.
pub fn display_tables() -> &'static DisplayTables {
    static TABLES: LazyLock<DisplayTables> = LazyLock::new(|| DisplayTables {
        rgb565: (0..COLORS as u16).map(rgb565).collect(),
        rgb888: (0..COLORS as u16).map(rgb888).collect(),
    });
    &TABLES
}

/// For one intensity and one channel: the level nearest to each 5-bit value,
/// and its squared distance. Of equally near levels the lowest counts.
fn nearest_levels(levels: &[u32], intensity: u32) -> [(u16, u32); 32] {
    std::array::from_fn(|five| {
        let wanted = (five << 3 | five >> 2) as u32;
        let distance = |level: &u32| shade(*level, intensity).abs_diff(wanted).pow(2);
        let found = levels.iter().map(distance).enumerate().min_by_key(|&(_, d)| d);
        let (level, distance) = found.expect("there are levels");
        (level as u16, distance)
    })
}

/// The palette colour nearest to each 15-bit colour (red 14..10, green 9..5,
/// blue 4..0), by squared distance; of equally near colours the lowest.
fn nearest_colors() -> Vec<u16> {
    let two: Vec<u32> = (0..4).map(widen2).collect();
    let three: Vec<u32> = (0..8).map(widen3).collect();
    let mut best = vec![(u32::MAX, 0u16); 1 << 15];
    for intensity in 0..=INTENSITY_MAX {
        // At a given intensity the channels do not depend on each other.
        let red = nearest_levels(&two, intensity);
        let rest = nearest_levels(&three, intensity);
        for (index, best) in best.iter_mut().enumerate() {
            let (r, g, b) = (red[index >> 10], rest[index >> 5 & 31], rest[index & 31]);
            let distance = r.1 + g.1 + b.1;
            if distance < best.0 {
                let word = (intensity as u16) << INTENSITY_SHIFT | r.0 << 6 | g.0 << 3 | b.0;
                *best = (distance, word);
            }
        }
    }
    best.into_iter().map(|(_, word)| word).collect()
}

/// The tables of the 50/50 blend; built once.
///
/// Both colours are converted by [`rgb888`], averaged channel by channel with
/// `(a + b) >> 1`, and the palette colour nearest to the upper five bits of
/// each channel is taken.
pub fn blend_table() -> &'static Arc<PaletteBlend> {
    static TABLE: LazyLock<Arc<PaletteBlend>> =
        LazyLock::new(|| Arc::new(PaletteBlend::new(rgb888, &nearest_colors())));
    &TABLE
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn documented_example() {
        assert_eq!(u16::from(color_rgb(255, 255, 0)) | color_i(128), 0x10f8);
    }

    #[test]
    fn levels_and_ends() {
        assert_eq!([0, 1, 2, 3].map(widen2), [0, 85, 170, 255]);
        let levels = [0, 36, 73, 109, 146, 182, 219, 255];
        assert_eq!([0, 1, 2, 3, 4, 5, 6, 7].map(widen3), levels);
        assert_eq!(rgb888(0x00ff), [0, 0, 0]);
        assert_eq!(rgb888(0x1fff), [255, 255, 255]);
        assert_eq!((rgb565(0x1fff), rgb565(0xffff)), (0xffff, 0xffff));
    }

    /// The separable search finds what trying every colour finds.
    #[test]
    fn nearest_colors_are_nearest() {
        let table = nearest_colors();
        for index in (0..1usize << 15).step_by(97) {
            let widen = |five: usize| (five << 3 | five >> 2) as i32;
            let wanted = [index >> 10, index >> 5 & 31, index & 31].map(widen);
            let distance = |word: &u16| -> i32 {
                rgb888(*word).iter().zip(wanted).map(|(&c, w)| (i32::from(c) - w).pow(2)).sum()
            };
            let expected = (0..COLORS as u16).min_by_key(distance).unwrap();
            assert_eq!(table[index], expected, "{index:#x}");
        }
    }
}
