//! Combine functions and factors as unit bits, and the `gu` presets.
//!
//! Source: G246, `grColorCombine`, `grAlphaCombine`, `grTexCombine`; the
//! presets of `guColorCombineFunction`, `guAlphaSource` and
//! `guTexCombineFunction`.

use crate::enums::*;
use crate::registers::unit;

/// Which of the two adders a unit has for "local alpha": the alpha units and
/// both adders of the alpha unit add the alpha local.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Channel {
    Color,
    Alpha,
}

/// The nine bits of a combine unit, or `None` for an unknown function or
/// factor.
pub(crate) fn unit_bits(function: i32, factor: i32, invert: bool, channel: Channel) -> Option<u32> {
    if !matches!(factor, 0..=5 | 8..=0xd) {
        return None;
    }
    use unit::{ADD_ALPHA, ADD_LOCAL, SUB_LOCAL, ZERO_OTHER};
    let bits = match function {
        COMBINE_ZERO => ZERO_OTHER,
        COMBINE_LOCAL => ZERO_OTHER | ADD_LOCAL,
        COMBINE_LOCAL_ALPHA => ZERO_OTHER | ADD_ALPHA,
        COMBINE_SCALE_OTHER => 0,
        COMBINE_SCALE_OTHER_ADD_LOCAL => ADD_LOCAL,
        COMBINE_SCALE_OTHER_ADD_LOCAL_ALPHA => ADD_ALPHA,
        COMBINE_SCALE_OTHER_MINUS_LOCAL => SUB_LOCAL,
        COMBINE_BLEND => SUB_LOCAL | ADD_LOCAL,
        COMBINE_BLEND_ADD_LOCAL_ALPHA => SUB_LOCAL | ADD_ALPHA,
        COMBINE_BLEND_LOCAL => ZERO_OTHER | SUB_LOCAL | ADD_LOCAL,
        COMBINE_BLEND_LOCAL_ADD_LOCAL_ALPHA => ZERO_OTHER | SUB_LOCAL | ADD_ALPHA,
        _ => return None,
    };
    // The alpha unit has one local: the reference sets the other adder.
    let bits = match channel {
        Channel::Alpha if bits & ADD_LOCAL != 0 => bits & !ADD_LOCAL | ADD_ALPHA,
        _ => bits,
    };
    let factor = factor as u32;
    let reverse = if factor & 8 == 0 { unit::REVERSE_BLEND } else { 0 };
    let invert = if invert { unit::INVERT } else { 0 };
    Some(bits | (factor & 7) << unit::SELECT_SHIFT | reverse | invert)
}

/// Function, factor, local, other, invert of a combine call.
pub(crate) type Preset = (i32, i32, i32, i32, bool);

/// What a `guColorCombineFunction` preset stands for.
pub(crate) fn color_preset(function: i32) -> Option<Preset> {
    let (none, iterated, constant) = (LOCAL_CONSTANT, LOCAL_ITERATED, LOCAL_CONSTANT);
    let texture = OTHER_TEXTURE;
    Some(match function {
        0x0 => (COMBINE_ZERO, FACTOR_NONE, none, OTHER_CONSTANT, false),
        0x1 => (COMBINE_LOCAL, FACTOR_NONE, constant, OTHER_CONSTANT, false),
        0x2 | 0x3 => (COMBINE_LOCAL, FACTOR_NONE, iterated, OTHER_CONSTANT, false),
        0x4 => (COMBINE_SCALE_OTHER, FACTOR_ONE, none, texture, false),
        0x5 => (COMBINE_SCALE_OTHER, FACTOR_LOCAL, constant, texture, false),
        0x6 | 0x7 => (COMBINE_SCALE_OTHER, FACTOR_LOCAL, iterated, texture, false),
        0x8 => (COMBINE_SCALE_OTHER_ADD_LOCAL_ALPHA, FACTOR_LOCAL, iterated, texture, false),
        0x9 => (COMBINE_SCALE_OTHER, FACTOR_LOCAL_ALPHA, none, texture, false),
        0xa => (COMBINE_SCALE_OTHER_ADD_LOCAL, FACTOR_LOCAL_ALPHA, iterated, texture, false),
        0xb => (COMBINE_SCALE_OTHER_ADD_LOCAL, FACTOR_ONE, iterated, texture, false),
        0xc => (COMBINE_SCALE_OTHER_MINUS_LOCAL, FACTOR_ONE, iterated, texture, false),
        0xd => (COMBINE_BLEND, FACTOR_TEXTURE_ALPHA, constant, OTHER_ITERATED, false),
        0xe => (COMBINE_SCALE_OTHER_ADD_LOCAL, FACTOR_LOCAL_ALPHA, iterated, texture, false),
        0xf => (COMBINE_SCALE_OTHER_ADD_LOCAL_ALPHA, FACTOR_LOCAL, iterated, texture, false),
        0x10 => (COMBINE_ZERO, FACTOR_NONE, none, OTHER_CONSTANT, true),
        _ => return None,
    })
}

/// Whether a `guColorCombineFunction` preset takes its iterated colour from
/// `grConstantColorValue4`.
pub(crate) fn is_delta0(function: i32) -> bool {
    matches!(function, 0x3 | 0x7)
}

/// What a `guAlphaSource` mode stands for.
pub(crate) fn alpha_preset(mode: i32) -> Option<Preset> {
    Some(match mode {
        0 => (COMBINE_LOCAL, FACTOR_NONE, LOCAL_CONSTANT, OTHER_CONSTANT, false),
        1 => (COMBINE_LOCAL, FACTOR_NONE, LOCAL_ITERATED, OTHER_CONSTANT, false),
        2 => (COMBINE_SCALE_OTHER, FACTOR_ONE, LOCAL_CONSTANT, OTHER_TEXTURE, false),
        3 => (COMBINE_SCALE_OTHER, FACTOR_LOCAL, LOCAL_ITERATED, OTHER_TEXTURE, false),
        _ => return None,
    })
}

/// Function, factor and invert of a `guTexCombineFunction` preset.
pub(crate) fn texture_preset(function: i32) -> Option<(i32, i32, bool)> {
    Some(match function {
        0x0 => (COMBINE_ZERO, FACTOR_NONE, false),
        0x1 => (COMBINE_LOCAL, FACTOR_NONE, false),
        0x2 => (COMBINE_SCALE_OTHER, FACTOR_ONE, false),
        0x3 => (COMBINE_SCALE_OTHER_ADD_LOCAL, FACTOR_ONE, false),
        0x4 => (COMBINE_SCALE_OTHER, FACTOR_LOCAL, false),
        0x5 => (COMBINE_SCALE_OTHER_MINUS_LOCAL, FACTOR_ONE, false),
        0x6 => (COMBINE_BLEND, FACTOR_ONE_MINUS_DETAIL, false),
        0x7 => (COMBINE_BLEND, FACTOR_DETAIL, false),
        0x8 => (COMBINE_BLEND, FACTOR_ONE_MINUS_LOD_FRACTION, false),
        0x9 => (COMBINE_BLEND, FACTOR_LOD_FRACTION, false),
        0xa => (COMBINE_ZERO, FACTOR_NONE, true),
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn factor_one_is_zero_not_reversed() {
        assert_eq!(unit_bits(COMBINE_SCALE_OTHER, FACTOR_ONE, false, Channel::Color), Some(0));
        let zero = unit_bits(COMBINE_SCALE_OTHER, FACTOR_NONE, false, Channel::Color);
        assert_eq!(zero, Some(unit::REVERSE_BLEND));
    }

    #[test]
    fn alpha_adds_its_one_local() {
        let bits = unit_bits(COMBINE_LOCAL, FACTOR_NONE, false, Channel::Alpha);
        assert_eq!(bits, Some(unit::ZERO_OTHER | unit::ADD_ALPHA | unit::REVERSE_BLEND));
    }

    #[test]
    fn unknown_values_are_refused() {
        for (function, factor) in [(0xa, 0), (0x11, 0), (-1, 0), (3, 6), (3, 0xe), (3, -1)] {
            assert_eq!(unit_bits(function, factor, false, Channel::Color), None);
        }
        assert_eq!(color_preset(0x11), None);
        assert_eq!(alpha_preset(4), None);
        assert_eq!(texture_preset(0xb), None);
    }
}
