//! Pixel formats of sources, destinations and the screen.
//!
//! Source: RR, pixel formats; codes from the interface headers.

/// A pixel format. The numbers are the chip's own codes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u32)]
pub enum PixFmt {
    /// `V_PIXFMT_332`: red 7..5, green 4..2, blue 1..0.
    Rgb332 = 1,
    /// `V_PIXFMT_8I`: red = green = blue.
    Gray8 = 2,
    /// `V_PIXFMT_8A`: alpha of white.
    Alpha8 = 3,
    /// `V_PIXFMT_565`.
    Rgb565 = 4,
    /// `V_PIXFMT_4444`, alpha highest.
    Argb4444 = 5,
    /// `V_PIXFMT_1555`, alpha highest.
    Argb1555 = 6,
    /// `V_PIXFMT_4I_565`: 16 palette entries of 565.
    Palette565 = 8,
    /// `V_PIXFMT_4I_4444`: 16 palette entries of 4444.
    Palette4444 = 9,
    /// `V_PIXFMT_4I_1555`: 16 palette entries of 1555.
    Palette1555 = 10,
    /// `V_PIXFMT_8888`, alpha highest.
    Argb8888 = 12,
    /// `V_PIXFMT_Y0CRY1CB`: two pixels in four bytes Y0, Cr, Y1, Cb.
    Yuv422 = 13,
}

/// `V_PIXFMT_DSTFMT`: as a source format, the destination's.
pub const DESTINATION_FORMAT: u32 = 0;

impl PixFmt {
    /// All formats.
    pub const ALL: [PixFmt; 11] = [
        PixFmt::Rgb332,
        PixFmt::Gray8,
        PixFmt::Alpha8,
        PixFmt::Rgb565,
        PixFmt::Argb4444,
        PixFmt::Argb1555,
        PixFmt::Palette565,
        PixFmt::Palette4444,
        PixFmt::Palette1555,
        PixFmt::Argb8888,
        PixFmt::Yuv422,
    ];

    /// The format with this code.
    pub fn from_code(code: u32) -> Option<PixFmt> {
        PixFmt::ALL.into_iter().find(|format| *format as u32 == code)
    }

    /// The chip's code.
    pub fn code(self) -> u32 {
        self as u32
    }

    /// Bits of a pixel: 4 to 32.
    pub fn bits(self) -> u32 {
        match self {
            PixFmt::Palette565 | PixFmt::Palette4444 | PixFmt::Palette1555 => 4,
            PixFmt::Rgb332 | PixFmt::Gray8 | PixFmt::Alpha8 => 8,
            PixFmt::Argb8888 => 32,
            _ => 16,
        }
    }

    /// Bytes of a pixel as `V_PIXEL_SIZE` says: 0 for 4-bit formats.
    pub fn bytes(self) -> u32 {
        self.bits() / 8
    }

    /// Bytes of `width` pixels, without padding.
    pub fn row_bytes(self, width: u32) -> u64 {
        (u64::from(width) * u64::from(self.bits())).div_ceil(8)
    }

    /// The format of the palette's entries, for 4-bit formats.
    pub fn palette_entry(self) -> Option<PixFmt> {
        match self {
            PixFmt::Palette565 => Some(PixFmt::Rgb565),
            PixFmt::Palette4444 => Some(PixFmt::Argb4444),
            PixFmt::Palette1555 => Some(PixFmt::Argb1555),
            _ => None,
        }
    }

    /// Whether it can be drawn into: 4-bit and YUV formats are for sources.
    pub fn is_destination(self) -> bool {
        self.palette_entry().is_none() && self != PixFmt::Yuv422
    }

    /// Bits of alpha, red, green, blue; of the entries for 4-bit formats.
    pub fn channels(self) -> [u32; 4] {
        match self {
            PixFmt::Rgb332 => [0, 3, 3, 2],
            PixFmt::Gray8 | PixFmt::Yuv422 => [0, 8, 8, 8],
            PixFmt::Alpha8 => [8, 0, 0, 0],
            PixFmt::Rgb565 | PixFmt::Palette565 => [0, 5, 6, 5],
            PixFmt::Argb4444 | PixFmt::Palette4444 => [4, 4, 4, 4],
            PixFmt::Argb1555 | PixFmt::Palette1555 => [1, 5, 5, 5],
            PixFmt::Argb8888 => [8, 8, 8, 8],
        }
    }

    /// All bits of a pixel set: the default key mask.
    pub fn full_mask(self) -> u32 {
        match self.bits() {
            32 => u32::MAX,
            bits => (1 << bits) - 1,
        }
    }
}

/// Widens `value` of `bits` bits to 8, filling low bits by repetition or, not
/// padded, with zeros.
fn widen(value: u32, bits: u32, pad: bool) -> u32 {
    let value = value & ((1 << bits) - 1);
    match (bits, pad) {
        (8, _) => value,
        (1, true) => value * 255,
        (2, true) => value * 0x55,
        (3, true) => value << 5 | value << 2 | value >> 1,
        (_, true) => value << (8 - bits) | value >> (2 * bits - 8),
        (_, false) => value << (8 - bits),
    }
}

/// Widens a pixel to 0xAARRGGBB. Absent alpha is 255, absent colour white.
///
/// `pad` repeats high bits in the low ones, as `VL_SetSrcColorNoPad(0)` does.
/// 4-bit formats take a palette entry; YUV pixels are for [`yuv`].
///
/// Source: RR, pixel formats, colour padding.
pub fn unpack(format: PixFmt, pixel: u32, pad: bool) -> u32 {
    if format == PixFmt::Gray8 {
        return 0xff00_0000 | ((pixel & 0xff) * 0x1_0101);
    }
    let [a, r, g, b] = format.channels();
    let mut shift = 0;
    let mut channel = |bits: u32| {
        let value = pixel.checked_shr(shift).unwrap_or(0);
        shift += bits;
        if bits == 0 { 255 } else { widen(value, bits, pad) }
    };
    let (blue, green, red) = (channel(b), channel(g), channel(r));
    channel(a) << 24 | red << 16 | green << 8 | blue
}

/// Reduces 0xAARRGGBB to a pixel by truncation. Grey is `(77 * red + 150 * green
/// + 29 * blue + 128) >> 8`.
pub fn pack(format: PixFmt, argb: u32) -> u32 {
    let reduce = |shift: u32, bits: u32| (argb >> shift & 0xff) >> (8 - bits);
    let [a, r, g, b] = format.channels();
    match format {
        PixFmt::Gray8 => {
            let channel = |shift: u32| argb >> shift & 0xff;
            (77 * channel(16) + 150 * channel(8) + 29 * channel(0) + 128) >> 8
        }
        _ => ((reduce(24, a) << r | reduce(16, r)) << g | reduce(8, g)) << b | reduce(0, b),
    }
}

/// Exchanges red and blue of a pixel; nothing where they differ in width or are
/// one.
pub fn swap_red_blue(format: PixFmt, pixel: u32) -> u32 {
    let [_, r, g, b] = format.channels();
    if r != b || r == 0 || format == PixFmt::Gray8 || format == PixFmt::Yuv422 {
        return pixel;
    }
    let mask = (1u32 << b) - 1;
    let (blue, red) = (pixel & mask, pixel >> (b + g) & mask);
    pixel & !(mask | mask << (b + g)) | red | blue << (b + g)
}

/// One pixel of 4:2:2, BT.601 studio range, as 0xAARRGGBB.
///
/// The sums have 8 fraction bits and are rounded.
pub fn yuv(y: u8, cr: u8, cb: u8) -> u32 {
    let (y, cr, cb) = (298 * (i32::from(y) - 16), i32::from(cr) - 128, i32::from(cb) - 128);
    let channel = |sum: i32| ((sum + 128) >> 8).clamp(0, 255) as u32;
    let red = channel(y + 409 * cr);
    let green = channel(y - 208 * cr - 100 * cb);
    let blue = channel(y + 516 * cb);
    0xff00_0000 | red << 16 | green << 8 | blue
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn white_is_padded_or_not() {
        assert_eq!(unpack(PixFmt::Rgb565, 0xffff, true), 0xffff_ffff);
        assert_eq!(unpack(PixFmt::Rgb565, 0xffff, false), 0xfff8_fcf8);
        assert_eq!(unpack(PixFmt::Argb1555, 0x8000, true), 0xff00_0000);
        assert_eq!(unpack(PixFmt::Alpha8, 0x40, true), 0x40ff_ffff);
        assert_eq!(unpack(PixFmt::Rgb332, 0b1110_0011, true), 0xffff_00ff);
    }

    #[test]
    fn packing_undoes_widening() {
        for format in PixFmt::ALL.into_iter().filter(|f| f.is_destination() && f.bits() <= 16) {
            for pixel in 0..=format.full_mask() {
                for pad in [false, true] {
                    assert_eq!(pack(format, unpack(format, pixel, pad)), pixel, "{format:?}");
                }
            }
        }
    }

    #[test]
    fn exchange_of_red_and_blue() {
        assert_eq!(swap_red_blue(PixFmt::Rgb565, 0xf800), 0x001f);
        assert_eq!(swap_red_blue(PixFmt::Argb8888, 0x8011_2233), 0x8033_2211);
        assert_eq!(swap_red_blue(PixFmt::Argb4444, 0xa123), 0xa321);
        assert_eq!(swap_red_blue(PixFmt::Gray8, 0x12), 0x12);
    }

    #[test]
    fn studio_black_and_white() {
        assert_eq!(yuv(16, 128, 128), 0xff00_0000);
        assert_eq!(yuv(235, 128, 128), 0xffff_ffff);
    }
}
