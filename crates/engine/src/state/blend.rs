//! Alpha blending and dithering.

/// A multiplier of a blended colour, in 256ths: a value v of 0..=255 counts
/// as v + 1, "one minus v" as 256 - v.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BlendFactor {
    /// 0.
    Zero,
    /// Source alpha.
    SourceAlpha,
    /// The other operand's colour: the destination's for the source factor,
    /// the source's for the destination factor.
    OtherColor,
    /// Destination alpha.
    DestinationAlpha,
    /// 256.
    One,
    /// One minus source alpha.
    OneMinusSourceAlpha,
    /// One minus the other operand's colour.
    OneMinusOtherColor,
    /// One minus destination alpha.
    OneMinusDestinationAlpha,
    /// The smaller of source alpha and one minus destination alpha; only as
    /// source factor.
    AlphaSaturate,
    /// The source colour before fog; only as destination factor.
    PrefogColor,
    /// One minus the smaller of source alpha and one minus destination alpha,
    /// the latter 255 - v here; only as source factor.
    OneMinusAlphaSaturate,
}

/// Where the alpha of a blended colour comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum AlphaEquation {
    /// By [`Blend::source_alpha`] and [`Blend::destination_alpha`].
    #[default]
    Switches,
    /// As red, green and blue, by the same factors; where a factor is a colour,
    /// that operand's alpha counts.
    Factors,
    /// `1 - (1 - source) * (1 - destination)`, to the nearest.
    Union,
}

/// `(source * source factor + destination * destination factor) >> 8`,
/// limited to 255.
///
/// The default writes the source.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Blend {
    /// Factor of the source colour.
    pub source: BlendFactor,
    /// Factor of the destination colour.
    pub destination: BlendFactor,
    /// Keeps the source alpha in the result (else it counts 0).
    pub source_alpha: bool,
    /// Adds the destination alpha to the result.
    pub destination_alpha: bool,
    /// Whether the aux plane holds destination alpha (else it reads as 255).
    pub alpha_plane: bool,
    /// Raises the destination by what dithering took from it on average
    /// before blending.
    pub subtract_dither: bool,
    /// What the result's alpha is.
    pub alpha: AlphaEquation,
    /// Takes this 0xAARRGGBB as the destination instead of what the surface
    /// holds.
    pub constant_destination: Option<u32>,
}

impl Default for Blend {
    fn default() -> Blend {
        Blend {
            source: BlendFactor::One,
            destination: BlendFactor::Zero,
            source_alpha: true,
            destination_alpha: false,
            alpha_plane: false,
            subtract_dither: false,
            alpha: AlphaEquation::Switches,
            constant_destination: None,
        }
    }
}

/// How colours are reduced to the surface's bits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Dither {
    /// Truncation.
    #[default]
    Off,
    /// Ordered, 2x2.
    Ordered2x2,
    /// Ordered, 4x4.
    Ordered4x4,
}

/// The 4x4 dither matrix, `[row & 3][column & 3]`, 0 to 15.
///
/// Source: SST1, dithering; row is the screen row after any flip.
pub const DITHER_4X4: [[u8; 4]; 4] = [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]];

/// The 2x2 dither matrix in the same units, `[row & 1][column & 1]`.
pub const DITHER_2X2: [[u8; 2]; 2] = [[2, 10], [14, 6]];

impl Dither {
    /// The value added before truncation at a screen position, 0 to 15, in
    /// sixteenths of a step; `None` where dithering is off.
    pub fn at(self, x: u32, y: u32) -> Option<u8> {
        match self {
            Dither::Off => None,
            Dither::Ordered2x2 => Some(DITHER_2X2[(y & 1) as usize][(x & 1) as usize]),
            Dither::Ordered4x4 => Some(DITHER_4X4[(y & 3) as usize][(x & 3) as usize]),
        }
    }
}
