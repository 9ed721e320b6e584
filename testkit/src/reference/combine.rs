//! The combine arithmetic, and the colour and alpha combine units.
//!
//! Source: SST1, fbzColorPath register.

use fillrate_engine::state::{
    Addend, AlphaLocal, ColorLocal, CombineUnit, DrawState, Factor, Other,
};

use super::dither::channels;
use super::pixel::Shaded;

/// One channel's inputs of a combine unit.
#[derive(Clone, Copy, Debug)]
pub struct Inputs {
    /// "Other".
    pub other: i32,
    /// "Local".
    pub local: i32,
    /// "Local" of the alpha unit.
    pub local_alpha: i32,
    /// The chosen factor, 0 to 255, before inversion.
    pub factor: i32,
    /// Whether to invert the factor.
    pub one_minus: bool,
}

/// One channel's output of a combine unit.
pub fn channel<F>(unit: &CombineUnit<F>, inputs: Inputs) -> i32 {
    let mut value = if unit.zero_other { 0 } else { inputs.other };
    if unit.subtract_local {
        value -= inputs.local;
    }
    let factor = if inputs.one_minus { inputs.factor ^ 0xff } else { inputs.factor };
    value = (value * (factor + 1)) >> 8;
    value += match unit.add {
        Addend::Zero => 0,
        Addend::Local => inputs.local,
        Addend::LocalAlpha => inputs.local_alpha,
    };
    value = value.clamp(0, 255);
    if unit.invert { value ^ 0xff } else { value }
}

/// Both units of the pixel pipeline: iterated colour, iterated z without bias
/// and the texture chain's output in, the fragment's colour out.
pub fn pixel(state: &DrawState, iterated: [i32; 4], z: i32, texel: [i32; 4]) -> Shaded {
    let constant0 = channels(state.color0);
    let constant1 = channels(state.color1);
    let select = |other: Other| match other {
        Other::Iterated => iterated,
        Other::Texture => texel,
        Other::Constant => constant1,
    };
    let color_other = select(state.color_combine.other);
    let color_local = match state.color_combine.local {
        ColorLocal::Iterated => iterated,
        ColorLocal::Constant => constant0,
        ColorLocal::ByTextureAlpha if texel[3] & 0x80 != 0 => constant0,
        ColorLocal::ByTextureAlpha => iterated,
    };
    let alpha_other = select(state.alpha_combine.other)[3];
    let alpha_local = match state.alpha_combine.local {
        AlphaLocal::Iterated => iterated[3],
        AlphaLocal::Constant => constant0[3],
        AlphaLocal::Depth => z >> 8,
    };
    let mut out = [0; 4];
    for (index, out) in out.iter_mut().enumerate() {
        let is_alpha = index == 3;
        let local = if is_alpha { alpha_local } else { color_local[index] };
        let other = if is_alpha { alpha_other } else { color_other[index] };
        let unit = if is_alpha { &state.alpha_combine.unit } else { &state.color_combine.unit };
        let factor = match unit.factor {
            Factor::Zero => 0,
            Factor::Local => local,
            Factor::OtherAlpha => alpha_other,
            Factor::LocalAlpha => alpha_local,
            Factor::TextureAlpha => texel[3],
            Factor::TextureColor => texel[index],
        };
        let one_minus = unit.one_minus;
        *out = channel(unit, Inputs { other, local, local_alpha: alpha_local, factor, one_minus });
    }
    Shaded { other: [color_other[0], color_other[1], color_other[2]], out }
}
