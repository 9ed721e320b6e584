//! Depth test, depth write, and what the aux plane receives.

/// A comparison `source OP reference`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Compare {
    /// Never passes.
    Never,
    /// Less than.
    Less,
    /// Equal.
    Equal,
    /// Less than or equal.
    LessEqual,
    /// Greater than.
    Greater,
    /// Not equal.
    NotEqual,
    /// Greater than or equal.
    GreaterEqual,
    /// Always passes.
    #[default]
    Always,
}

impl Compare {
    /// All comparisons, in the numbering the chips share: bit 0 less, bit 1
    /// equal, bit 2 greater.
    pub const ALL: [Compare; 8] = [
        Compare::Never,
        Compare::Less,
        Compare::Equal,
        Compare::LessEqual,
        Compare::Greater,
        Compare::NotEqual,
        Compare::GreaterEqual,
        Compare::Always,
    ];

    /// Whether `source OP reference` holds.
    pub fn holds<T: Ord>(self, source: T, reference: T) -> bool {
        let bits = self as u32;
        let order = source.cmp(&reference) as i32;
        bits >> (order + 1) & 1 != 0
    }
}

/// Where the depth value of a fragment comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum DepthSource {
    /// The z iterator, 16 bits after its wrap rule.
    #[default]
    Z,
    /// The 16-bit pseudo-float made from iterated 1/w (a w-buffer).
    FloatW,
    /// The integer part of [`crate::Registers::deep_z`], limited to 31 bits.
    /// Needs an [`crate::PixelFormat::Aux32`] plane.
    DeepZ,
    /// Iterated 1/w as an integer of the same order: the upper 32 bits of its
    /// double-precision float, 0 where it is not positive. Nearer is larger.
    /// Needs an [`crate::PixelFormat::Aux32`] plane.
    DeepW,
}

impl DepthSource {
    /// Whether it needs an [`crate::PixelFormat::Aux32`] plane.
    pub fn is_deep(self) -> bool {
        matches!(self, DepthSource::DeepZ | DepthSource::DeepW)
    }
}

/// What becomes of iterated z outside 0..=65535.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum ZOverflow {
    /// The chip's wrap rule: of the 20-bit integer part -1 counts as 0, 65536
    /// as 65535, else the low 16 bits count.
    #[default]
    Wrap,
    /// The nearest value inside.
    Clamp,
    /// The fragment is dropped as if it failed the depth test, whether or not
    /// there is one, unless the depth source is another.
    Reject,
}

/// How fragments are compared with the aux plane.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct DepthState {
    /// z or w. A deep source on a 16-bit aux plane tests and writes nothing;
    /// the others are 16 bits on any.
    pub source: DepthSource,
    /// What z outside its range counts as, for everything that reads iterated z.
    pub z_overflow: ZOverflow,
    /// The test, or `None` where depth buffering is off.
    pub test: Option<Compare>,
    /// Added to the depth value, which is then limited to 0..=65535; not to a
    /// deep one.
    pub bias: Option<i16>,
    /// Compares this constant instead of the fragment's depth; what is
    /// written is still the fragment's depth. Not for deep sources.
    pub compare_constant: Option<u16>,
}

impl DepthState {
    /// Whether fragments are dropped for their z.
    pub(crate) fn rejects(&self) -> bool {
        self.z_overflow == ZOverflow::Reject && self.source == DepthSource::Z
    }
}

/// What a surviving fragment writes into the aux plane.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum AuxWrite {
    /// Nothing.
    #[default]
    Nothing,
    /// Its depth (with the bias).
    Depth,
    /// Its alpha, in the low byte; nothing on a 32-bit plane.
    Alpha,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn compare_follows_the_bit_numbering() {
        for (index, compare) in Compare::ALL.into_iter().enumerate() {
            assert_eq!(compare as usize, index);
            assert_eq!(compare.holds(1, 2), index & 1 != 0);
            assert_eq!(compare.holds(2, 2), index & 2 != 0);
            assert_eq!(compare.holds(3, 2), index & 4 != 0);
        }
    }
}
