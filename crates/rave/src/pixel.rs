//! Pixel types.

/// The layout of pixels, `TQAImagePixelType`. Bit 0 is the least significant;
/// 16- and 32-bit pixels are integers of the host.
///
/// Source: RAVE, pixel types.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u32)]
pub enum PixelType {
    /// One bit of alpha, white; the leftmost pixel in the highest bit.
    Alpha1 = 0,
    /// Red 14..10, green 9..5, blue 4..0.
    Rgb16 = 1,
    /// Alpha 15, then as [`PixelType::Rgb16`].
    Argb16 = 2,
    /// Red 23..16, green 15..8, blue 7..0.
    Rgb32 = 3,
    /// Alpha 31..24, then as [`PixelType::Rgb32`].
    Argb32 = 4,
    /// Index of 4 bits; the left pixel in the high nibble.
    Cl4 = 5,
    /// Index of 8 bits.
    Cl8 = 6,
    /// Red 15..11, green 10..5, blue 4..0.
    Rgb16_565 = 7,
    /// Bytes blue, green, red.
    Rgb24 = 8,
    /// Red 7..5, green 4..2, blue 1..0.
    Rgb8_332 = 9,
    /// Alpha, red, green, blue, four bits each.
    Argb16_4444 = 10,
    /// Alpha 15..8, index 7..0.
    Acl16_88 = 11,
    /// Intensity.
    I8 = 12,
    /// Alpha 15..8, intensity 7..0.
    Ai16_88 = 13,
    /// Bytes Y U Y V, unsigned chroma.
    Yuvs = 14,
    /// Bytes Y U Y V, signed chroma.
    Yuvu = 15,
    /// Bytes Y V Y U.
    Yvyu422 = 16,
    /// Bytes U Y V Y.
    Uyvy422 = 17,
}

impl PixelType {
    /// All types, by number.
    pub const ALL: [PixelType; 18] = [
        PixelType::Alpha1,
        PixelType::Rgb16,
        PixelType::Argb16,
        PixelType::Rgb32,
        PixelType::Argb32,
        PixelType::Cl4,
        PixelType::Cl8,
        PixelType::Rgb16_565,
        PixelType::Rgb24,
        PixelType::Rgb8_332,
        PixelType::Argb16_4444,
        PixelType::Acl16_88,
        PixelType::I8,
        PixelType::Ai16_88,
        PixelType::Yuvs,
        PixelType::Yuvu,
        PixelType::Yvyu422,
        PixelType::Uyvy422,
    ];

    /// The type of a number.
    pub fn from_number(number: u32) -> Option<PixelType> {
        PixelType::ALL.get(number as usize).copied()
    }

    /// Its number.
    pub fn number(self) -> u32 {
        self as u32
    }

    /// Its bit in the masks of gestalt.
    pub fn bit(self) -> u32 {
        1 << self.number()
    }

    /// Bits of one pixel.
    pub fn bits(self) -> u32 {
        use PixelType::*;
        match self {
            Alpha1 => 1,
            Cl4 => 4,
            Cl8 | Rgb8_332 | I8 => 8,
            Rgb24 => 24,
            Rgb32 | Argb32 => 32,
            Rgb16 | Argb16 | Rgb16_565 | Argb16_4444 | Acl16_88 | Ai16_88 => 16,
            Yuvs | Yuvu | Yvyu422 | Uyvy422 => 16,
        }
    }

    /// Bytes of a row of `width` pixels without padding. The pairs of the YUV
    /// types are whole.
    pub fn row_bytes(self, width: u32) -> usize {
        use PixelType::*;
        let width = match self {
            Yuvs | Yuvu | Yvyu422 | Uyvy422 => width.next_multiple_of(2),
            _ => width,
        };
        (width as usize * self.bits() as usize).div_ceil(8)
    }

    /// Whether pixels are indices into a colour table.
    pub fn is_indexed(self) -> bool {
        matches!(self, PixelType::Cl4 | PixelType::Cl8 | PixelType::Acl16_88)
    }
}
