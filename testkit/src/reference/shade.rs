//! Colour after the combine units: decal, modulation beyond one, the second
//! colour, the colour of a pattern's gaps.

use fillrate_engine::state::{Axis, DecalBase, DrawState, Pattern, PatternBits};

use super::dither::channels;

/// What the steps read besides the colour that they change.
#[derive(Clone, Copy, Debug)]
pub struct ShadeInputs {
    /// Iterated colour and alpha.
    pub iterated: [i32; 4],
    /// Integer parts of iterated red, green and blue, not wrapped.
    pub over: [i32; 3],
    /// The texture chain's output.
    pub texel: [i32; 4],
    /// The second colour.
    pub specular: [i32; 3],
    /// The third colour.
    pub base: [i32; 3],
}

/// `numerator / denominator` to the nearest, halves up; both positive.
pub fn rounded(numerator: i32, denominator: i32) -> i32 {
    (2 * numerator + denominator) / (2 * denominator)
}

/// The colour that leaves the steps; alpha is unchanged.
pub fn apply(state: &DrawState, color: [i32; 4], inputs: &ShadeInputs) -> [i32; 4] {
    let mut out = color;
    let coverage = inputs.texel[3];
    for (channel, value) in out.iter_mut().enumerate().take(3) {
        if let Some(from) = state.shade.decal {
            let base = match from {
                DecalBase::Iterated => inputs.iterated[channel],
                DecalBase::Base => inputs.base[channel],
            };
            *value = rounded(inputs.texel[channel] * coverage + base * (255 - coverage), 255);
        }
        if state.shade.overbright {
            let factor = inputs.over[channel].max(0);
            *value = rounded(*value * factor, 255).min(255);
        }
        if state.shade.specular {
            *value = (*value + inputs.specular[channel]).min(255);
        }
    }
    out
}

/// A pattern's bit at a surface position.
fn bit(pattern: &Pattern, x: u32, row: u32) -> bool {
    match pattern.bits {
        PatternBits::Area(rows) => rows[row as usize % 32] & (0x8000_0000 >> (x % 32)) != 0,
        PatternBits::Line { bits, length, factor, axis, origin, backwards } => {
            let place = i64::from(match axis {
                Axis::X => x,
                Axis::Y => row,
            });
            let origin = i64::from(origin);
            let distance = if backwards { origin - place } else { place - origin };
            let steps = distance.div_euclid(i64::from(factor.max(1)));
            let index = steps.rem_euclid(i64::from(length.clamp(1, 32)));
            bits & (1 << index) != 0
        }
    }
}

/// Whether a pattern drops a fragment.
pub fn patterned_out(state: &DrawState, x: u32, row: u32) -> bool {
    state.pattern.is_some_and(|p| p.background.is_none() && !bit(&p, x, row))
}

/// The colour of a pattern's gap at a position, if there is one.
pub fn gap_color(state: &DrawState, x: u32, row: u32) -> Option<[i32; 4]> {
    let pattern = state.pattern?;
    let background = pattern.background?;
    (!bit(&pattern, x, row)).then(|| channels(background))
}
