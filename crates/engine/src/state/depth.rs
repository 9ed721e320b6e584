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
    pub fn holds(self, source: i32, reference: i32) -> bool {
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
}

/// How fragments are compared with the aux plane.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct DepthState {
    /// z or w.
    pub source: DepthSource,
    /// The test, or `None` where depth buffering is off.
    pub test: Option<Compare>,
    /// Added to the depth value, which is then limited to 0..=65535.
    pub bias: Option<i16>,
    /// Compares this constant instead of the fragment's depth; what is
    /// written is still the fragment's depth.
    pub compare_constant: Option<u16>,
}

/// What a surviving fragment writes into the aux plane.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum AuxWrite {
    /// Nothing.
    #[default]
    Nothing,
    /// Its depth (with the bias).
    Depth,
    /// Its alpha, in the low byte.
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
