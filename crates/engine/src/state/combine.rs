//! The colour and alpha combine units.
//!
//! Both the pixel pipeline and every texture unit use the same arithmetic,
//! for each channel:
//!
//! ```text
//! x = (zero_other ? 0 : other) - (subtract_local ? local : 0)
//! f = factor, inverted (f ^ 0xff) where one_minus is set
//! x = (x * (f + 1)) >> 8
//! x = clamp(x + addend, 0, 255), inverted (x ^ 0xff) where invert is set
//! ```
//!
//! Source: SST1, fbzColorPath and textureMode registers.

/// What is added after the multiplication.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Addend {
    /// Nothing.
    #[default]
    Zero,
    /// The unit's local value, channel by channel.
    Local,
    /// The local alpha, in every channel.
    LocalAlpha,
}

/// The arithmetic of one unit, for factors of type `F`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct CombineUnit<F> {
    /// Takes 0 instead of "other".
    pub zero_other: bool,
    /// Subtracts "local" before the multiplication.
    pub subtract_local: bool,
    /// The multiplier before inversion.
    pub factor: F,
    /// Uses 255 - factor. The multiplication is by (factor + 1) / 256, so that
    /// `one_minus` of [`Factor::Zero`] is exactly one.
    pub one_minus: bool,
    /// Added after the multiplication.
    pub add: Addend,
    /// Inverts the result.
    pub invert: bool,
}

impl<F> CombineUnit<F> {
    /// Whether the unit only multiplies "other" by the factor.
    pub(crate) fn scales(&self) -> bool {
        !self.zero_other && !self.subtract_local && self.add == Addend::Zero && !self.invert
    }

    /// Whether the unit passes "local" on unchanged; any addend will do where
    /// it is the alpha unit.
    pub(crate) fn passes_local(&self) -> bool {
        self.zero_other && !self.subtract_local && self.add != Addend::Zero && !self.invert
    }
}

/// Multipliers of the pixel pipeline's units.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Factor {
    /// 0.
    #[default]
    Zero,
    /// The unit's local value, channel by channel.
    Local,
    /// The alpha unit's "other".
    OtherAlpha,
    /// The alpha unit's "local".
    LocalAlpha,
    /// The texture chain's alpha.
    TextureAlpha,
    /// The texture chain's colour (alpha in the alpha unit).
    TextureColor,
}

/// What a unit calls "other".
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Other {
    /// The iterated value.
    #[default]
    Iterated,
    /// The texture chain's output; 0 where texturing is off.
    Texture,
    /// [`crate::state::DrawState::color1`].
    Constant,
}

/// What the colour unit calls "local".
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum ColorLocal {
    /// The iterated colour.
    #[default]
    Iterated,
    /// [`crate::state::DrawState::color0`].
    Constant,
    /// The constant where bit 7 of the texture alpha is set, else iterated.
    ByTextureAlpha,
}

/// What the alpha unit calls "local".
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum AlphaLocal {
    /// Iterated alpha.
    #[default]
    Iterated,
    /// Alpha of [`crate::state::DrawState::color0`].
    Constant,
    /// Bits 15..8 of the iterated z, after its wrap rule, without bias.
    Depth,
}

/// The colour combine unit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct ColorCombine {
    /// "Other", also compared with the chroma key.
    pub other: Other,
    /// "Local".
    pub local: ColorLocal,
    /// The arithmetic. `Addend::LocalAlpha` is the alpha unit's local.
    pub unit: CombineUnit<Factor>,
}

/// The alpha combine unit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct AlphaCombine {
    /// "Other".
    pub other: Other,
    /// "Local".
    pub local: AlphaLocal,
    /// The arithmetic. Both local addends are the alpha local.
    pub unit: CombineUnit<Factor>,
}
