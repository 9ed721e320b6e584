//! Pixel formats: packing with dither, and widening.

use crate::state::{Channels, Dither};

/// What a surface's elements are. Formats of 8 bits lie in 16-bit elements, whose
/// upper byte is 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PixelFormat {
    /// Colour, 16 bits: red 15..11, green 10..5, blue 4..0.
    Rgb565,
    /// Colour, 16 bits: alpha 15, red 14..10, green 9..5, blue 4..0.
    Argb1555,
    /// Colour, 16 bits: as `Argb1555`, bit 15 written as 0 and without meaning.
    Xrgb1555,
    /// Colour, 16 bits: alpha, red, green, blue, four bits each.
    Argb4444,
    /// Colour, 32 bits: 0xAARRGGBB.
    Argb8888,
    /// Colour, 32 bits: as `Argb8888`, the top byte written as 0 and without
    /// meaning.
    Xrgb8888,
    /// Colour, 8 bits: red 7..5, green 4..2, blue 1..0.
    Rgb332,
    /// Colour, 8 bits of grey. A colour becomes `(77 * red + 150 * green + 29 *
    /// blue + 128) >> 8`.
    Gray8,
    /// Colour, 8 bits of alpha over white.
    Alpha8,
    /// Colour, 16 bits, of a palette: base colour 7..0, intensity 12..8. Only
    /// the Quark profile draws into it; a clear takes the element as colour.
    Palette,
    /// Colour, 32 bits: 0xRRGGBBxx. Only the Raw profile draws into it; a
    /// clear takes the element as colour.
    Rgbx8888,
    /// Aux, 16 bits: depth (z or pseudo-float w), or alpha in the low byte.
    Aux16,
    /// Aux, 32 bits: depth of any source.
    Aux32,
}

impl PixelFormat {
    /// Bytes of one element.
    pub fn bytes(self) -> usize {
        match self {
            PixelFormat::Argb8888
            | PixelFormat::Xrgb8888
            | PixelFormat::Rgbx8888
            | PixelFormat::Aux32 => 4,
            _ => 2,
        }
    }

    /// The bits of an element that may be set.
    pub fn element_mask(self) -> u32 {
        match self {
            PixelFormat::Rgb332 | PixelFormat::Gray8 | PixelFormat::Alpha8 => 0xff,
            _ if self.bytes() == 4 => u32::MAX,
            _ => 0xffff,
        }
    }

    /// Whether colours can be drawn into it.
    pub fn is_color(self) -> bool {
        !matches!(self, PixelFormat::Aux16 | PixelFormat::Aux32)
    }

    /// Whether alpha is stored in it; else it reads as 255.
    pub fn has_alpha(self) -> bool {
        !matches!(
            self,
            PixelFormat::Rgb565
                | PixelFormat::Xrgb1555
                | PixelFormat::Xrgb8888
                | PixelFormat::Rgbx8888
                | PixelFormat::Rgb332
                | PixelFormat::Gray8
        )
    }

    /// Whether channels lose bits in it, so that dithering means something.
    pub fn is_reduced(self) -> bool {
        !matches!(
            self,
            PixelFormat::Argb8888
                | PixelFormat::Xrgb8888
                | PixelFormat::Rgbx8888
                | PixelFormat::Gray8
                | PixelFormat::Alpha8
        )
    }

    /// The bits of an element that a colour with only some channels reaches.
    /// The grey of `Gray8` counts as red, green and blue; any of them reaches it.
    pub fn channel_bits(self, channels: Channels) -> u32 {
        let Channels { red, green, blue, alpha } = channels;
        let bits = |on: bool, mask: u32| if on { mask } else { 0 };
        match self {
            PixelFormat::Gray8 => bits(red || green || blue, 0xff),
            PixelFormat::Alpha8 => bits(alpha, 0xff),
            _ => {
                let [rb, gb, bb, ab] = widths(self);
                let mask = |width: u32, at: u32| (((1u64 << width) - 1) << at) as u32;
                bits(red, mask(rb, bb + gb))
                    | bits(green, mask(gb, bb))
                    | bits(blue, mask(bb, 0))
                    | bits(alpha, mask(ab, bb + gb + rb))
            }
        }
    }
}

/// Bits of red, green, blue and alpha of formats that are these fields, from
/// blue as the lowest.
#[inline]
fn widths(format: PixelFormat) -> [u32; 4] {
    match format {
        PixelFormat::Rgb565 => [5, 6, 5, 0],
        PixelFormat::Argb1555 => [5, 5, 5, 1],
        PixelFormat::Xrgb1555 => [5, 5, 5, 0],
        PixelFormat::Argb4444 => [4, 4, 4, 4],
        PixelFormat::Xrgb8888 => [8, 8, 8, 0],
        PixelFormat::Rgb332 => [3, 3, 2, 0],
        _ => [8, 8, 8, 8],
    }
}

/// An 8-bit channel reduced to `bits` bits with dither value `d` (0..=15).
///
/// For 5 and 6 bits this is the chip's rule: `((c << 1) - (c >> 4) + (c >> 7)
/// + d) >> 4` and `((c << 2) - (c >> 4) + (c >> 6) + d) >> 4`.
///
/// Source: SST1, dithering; the rules for fewer bits are ours, of the same form.
#[inline]
fn reduce_dithered(c: u32, bits: u32, d: u32) -> u32 {
    match bits {
        6 => ((c << 2) - (c >> 4) + (c >> 6) + d) >> 4,
        5 => ((c << 1) - (c >> 4) + (c >> 7) + d) >> 4,
        2..=4 => ((c >> (4 - bits)) - (c >> 4) + d) >> 4,
        _ => c >> (8 - bits),
    }
}

/// The grey of a colour in `Gray8`.
#[inline]
fn gray([r, g, b]: [u32; 3]) -> u32 {
    (77 * r + 150 * g + 29 * b + 128) >> 8
}

/// Packs 0xAARRGGBB for screen position (x, y). Alpha is truncated.
#[inline]
pub fn pack(format: PixelFormat, argb: u32, dither: Dither, x: u32, y: u32) -> u32 {
    let [a, r, g, b] = argb.to_be_bytes().map(u32::from);
    match format {
        PixelFormat::Gray8 => return gray([r, g, b]),
        PixelFormat::Alpha8 => return a,
        _ => {}
    }
    let [rb, gb, bb, ab] = widths(format);
    let reduce = |c: u32, bits: u32| match dither.at(x, y) {
        Some(d) => reduce_dithered(c, bits, u32::from(d)),
        None => c >> (8 - bits),
    };
    let (r, g, b) = (reduce(r, rb), reduce(g, gb), reduce(b, bb));
    let a = a >> (8 - ab);
    ((a << rb | r) << gb | g) << bb | b
}

/// Widens an element to 0xAARRGGBB by bit replication; absent alpha is 255,
/// absent colour white.
#[inline]
pub fn unpack(format: PixelFormat, element: u32) -> u32 {
    let byte = element & 0xff;
    match format {
        PixelFormat::Gray8 => return 0xff00_0000 | (byte * 0x0001_0101),
        PixelFormat::Alpha8 => return byte << 24 | 0x00ff_ffff,
        _ => {}
    }
    let [rb, gb, bb, ab] = widths(format);
    let widen = |value: u32, bits: u32| {
        let value = value & ((1 << bits) - 1);
        match bits {
            0 => 255,
            1 => value * 255,
            2 => value * 85,
            3 => value << 5 | value << 2 | value >> 1,
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
