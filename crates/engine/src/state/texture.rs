//! Texture units: sampling and texture combine.

use super::CombineUnit;

/// The most texture units of any modelled board.
pub const MAX_TMUS: usize = 3;

/// How a level is sampled.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Filter {
    /// The texel at the coordinate.
    #[default]
    Point,
    /// Four texels, weighted by four fraction bits of the coordinates.
    Bilinear,
}

/// The level-of-detail limits of a texture unit, 8 fraction bits: 0x000 is
/// level 0 of the texture, 0x100 level 1, up to 0xb00; what is above counts as
/// that.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct LodRange {
    /// The finest level of detail used.
    pub min: u16,
    /// The coarsest one used; a fraction is allowed.
    pub max: u16,
    /// Added to every level of detail, 4.2 shifted to 8 fraction bits.
    pub bias: i16,
}

/// Multipliers of a texture unit's combine arithmetic.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum TextureFactor {
    /// 0.
    #[default]
    Zero,
    /// The unit's own texel, channel by channel.
    Local,
    /// Alpha of the unit upstream.
    OtherAlpha,
    /// The own texel's alpha.
    LocalAlpha,
    /// The detail factor, from the level of detail: 0 where `bias * 256 <=
    /// lod`, else `min(max, (bias * 256 - lod) << scale >> 8)`.
    Detail,
    /// The fraction of the level of detail.
    LodFraction,
}

/// How a unit joins its texel ("local") with the output of the unit upstream
/// ("other", 0 for the last unit). `Addend::LocalAlpha` is the texel's alpha.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct TextureCombine {
    /// Red, green and blue.
    pub color: CombineUnit<TextureFactor>,
    /// Alpha.
    pub alpha: CombineUnit<TextureFactor>,
}

/// One texture unit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct TextureUnit {
    /// Divides s and t by w.
    pub perspective: bool,
    /// Where w is negative or zero, s and t are 0 (else the quotient of the
    /// signed values is used, 0 for w = 0).
    pub clamp_negative_w: bool,
    /// Filter where the level of detail is above the minimum.
    pub minify: Filter,
    /// Filter where it equals the minimum.
    pub magnify: Filter,
    /// Clamps s to the texture instead of repeating it.
    pub clamp_s: bool,
    /// Clamps t.
    pub clamp_t: bool,
    /// Level-of-detail limits and bias.
    pub lod: LodRange,
    /// Adds an ordered pattern of less than one level before choosing it.
    pub lod_dither: bool,
    /// In a split chain: which parity of levels this unit holds (`Some(true)`
    /// the odd ones); a missing level is replaced by the next smaller one.
    pub odd_levels: Option<bool>,
    /// Inverts `one_minus` of the combine units where the level is odd.
    pub trilinear: bool,
    /// Samples the selected level and the next coarser one, each with the filter
    /// of its fragment, and mixes them by the fraction of the level of detail,
    /// to the nearest. The logarithm of w in that level of detail is then the
    /// linear one: 256 times the exponent plus the first 8 mantissa bits of w as
    /// a float, so the level is exact where w is a power of two and at most
    /// 0.09 too coarse between.
    pub mix_levels: bool,
    /// Drops fragments half of whose sample or more, by weight, is keyed texels:
    /// see [`crate::Texture::with_key`]. With `mix_levels` those of the finer
    /// level count.
    pub drop_keyed: bool,
    /// Detail factor: limit 0..=255.
    pub detail_max: u8,
    /// Detail factor: level of detail at which it becomes 0, -32..=31.
    pub detail_bias: i8,
    /// Detail factor: shift, 0..=7.
    pub detail_scale: u8,
    /// The combine arithmetic.
    pub combine: TextureCombine,
}
