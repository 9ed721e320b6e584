//! Pixel formats: packing with dither, and widening.

use crate::state::Dither;

/// What a surface's elements are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PixelFormat {
    /// Colour, 16 bits: red 15..11, green 10..5, blue 4..0.
    Rgb565,
    /// Colour, 16 bits: alpha 15, red 14..10, green 9..5, blue 4..0.
    Argb1555,
    /// Colour, 16 bits: alpha, red, green, blue, four bits each.
    Argb4444,
    /// Colour, 32 bits: 0xAARRGGBB.
    Argb8888,
    /// Colour, 16 bits, of a palette: base colour 7..0, intensity 12..8. Only
    /// the Quark profile draws into it; a clear takes the element as colour.
    Palette,
    /// Colour, 32 bits: 0xRRGGBBxx. Only the Raw profile draws into it; a
    /// clear takes the element as colour.
    Rgbx8888,
    /// Aux, 32 bits: signed depths of the Raw profile.
    Depth32,
    /// Aux, 16 bits: depth (z or pseudo-float w), or alpha in the low byte.
    Aux16,
}

impl PixelFormat {
    /// Bytes of one element.
    pub fn bytes(self) -> usize {
        match self {
            PixelFormat::Argb8888 | PixelFormat::Rgbx8888 | PixelFormat::Depth32 => 4,
            _ => 2,
        }
    }

    /// Whether colours can be drawn into it.
    pub fn is_color(self) -> bool {
        !matches!(self, PixelFormat::Aux16 | PixelFormat::Depth32)
    }
}

/// Bits of red, green, blue and alpha.
fn widths(format: PixelFormat) -> [u32; 4] {
    match format {
        PixelFormat::Rgb565 => [5, 6, 5, 0],
        PixelFormat::Argb1555 => [5, 5, 5, 1],
        PixelFormat::Argb4444 => [4, 4, 4, 4],
        PixelFormat::Argb8888
        | PixelFormat::Palette
        | PixelFormat::Aux16
        | PixelFormat::Rgbx8888
        | PixelFormat::Depth32 => [8, 8, 8, 8],
    }
}

/// An 8-bit channel reduced to `bits` bits with dither value `d` (0..=15).
///
/// For 5 and 6 bits this is the chip's rule: `((c << 1) - (c >> 4) + (c >> 7)
/// + d) >> 4` and `((c << 2) - (c >> 4) + (c >> 6) + d) >> 4`.
///
/// Source: SST1, dithering; the 4-bit rule is ours, of the same form.
fn reduce_dithered(c: u32, bits: u32, d: u32) -> u32 {
    match bits {
        6 => ((c << 2) - (c >> 4) + (c >> 6) + d) >> 4,
        5 => ((c << 1) - (c >> 4) + (c >> 7) + d) >> 4,
        4 => (c - (c >> 4) + d) >> 4,
        _ => c >> (8 - bits),
    }
}

/// Packs 0xAARRGGBB for screen position (x, y). Alpha is truncated.
pub fn pack(format: PixelFormat, argb: u32, dither: Dither, x: u32, y: u32) -> u32 {
    let [rb, gb, bb, ab] = widths(format);
    let reduce = |c: u32, bits: u32| match dither.at(x, y) {
        Some(d) => reduce_dithered(c, bits, u32::from(d)),
        None => c >> (8 - bits),
    };
    let r = reduce(argb >> 16 & 0xff, rb);
    let g = reduce(argb >> 8 & 0xff, gb);
    let b = reduce(argb & 0xff, bb);
    let a = (argb >> 24) >> (8 - ab);
    ((a << rb | r) << gb | g) << bb | b
}

/// Widens an element to 0xAARRGGBB by bit replication; absent alpha is 255.
pub fn unpack(format: PixelFormat, element: u32) -> u32 {
    let [rb, gb, bb, ab] = widths(format);
    let widen = |value: u32, bits: u32| {
        let value = value & ((1 << bits) - 1);
        match bits {
            0 => 255,
            1 => value * 255,
            8 => value,
            _ => value << (8 - bits) | value >> (2 * bits - 8),
        }
    };
    let b = widen(element, bb);
    let g = widen(element >> bb, gb);
    let r = widen(element >> (bb + gb), rb);
    let a = widen(element.checked_shr(bb + gb + rb).unwrap_or(0), ab);
    a << 24 | r << 16 | g << 8 | b
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn undithered_pack_and_unpack_are_inverse() {
        for format in [PixelFormat::Rgb565, PixelFormat::Argb1555, PixelFormat::Argb4444] {
            for element in 0..=0xffff {
                assert_eq!(pack(format, unpack(format, element), Dither::Off, 0, 0), element);
            }
        }
    }

    #[test]
    fn dithering_never_overflows_and_keeps_the_ends() {
        for y in 0..4 {
            for x in 0..4 {
                for format in [PixelFormat::Rgb565, PixelFormat::Argb4444] {
                    let top = pack(format, 0xffff_ffff, Dither::Ordered4x4, x, y);
                    assert_eq!(top, 0xffff, "{format:?}");
                    assert_eq!(pack(format, 0, Dither::Ordered4x4, x, y), 0);
                }
            }
        }
    }

    /// SST1: a 5-bit value 2 at matrix value 0 becomes 1.
    #[test]
    fn dithering_is_not_an_identity() {
        let widened = unpack(PixelFormat::Rgb565, 2);
        assert_eq!(pack(PixelFormat::Rgb565, widened, Dither::Ordered4x4, 0, 0), 1);
    }
}
