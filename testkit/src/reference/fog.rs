//! Fog.
//!
//! Source: SST1, fogMode and fogTable registers.

use fillrate_engine::state::{DrawState, Fog, FogAmount};

use super::depth::biased;
use super::dither::channels;
use super::pixel::Iterated;
use super::shade::rounded;

/// The fogged colour; alpha is unchanged.
pub fn apply(state: &DrawState, color: [i32; 4], values: Iterated) -> [i32; 4] {
    let Some(fog) = &state.fog else { return color };
    let fog_color = channels(fog.color);
    let mut out = color;
    for channel in 0..3 {
        out[channel] = match fog.amount {
            FogAmount::Iterated => match values.fog_part {
                Some(part) => by_part(fog, color[channel], fog_color[channel], part),
                None => color[channel],
            },
            FogAmount::ByW => {
                by_part(fog, color[channel], fog_color[channel], part_by_w(state, values.w))
            }
            FogAmount::Constant => (color[channel] + fog_color[channel]).min(255),
            _ => mix(fog, color[channel], fog_color[channel], amount(state, fog, values)),
        };
    }
    out
}

/// One channel with `amount` of 1 to 256 parts of fog.
fn mix(fog: &Fog, color: i32, fog_color: i32, amount: i32) -> i32 {
    let added = if fog.drop_fog_color { 0 } else { fog_color };
    let kept = if fog.drop_fragment_color { 0 } else { color };
    (kept + (((added - kept) * amount) >> 8)).clamp(0, 255)
}

/// 1 to 256.
fn amount(state: &DrawState, fog: &Fog, values: Iterated) -> i32 {
    let amount = match fog.amount {
        FogAmount::Table => table(state, biased(values.w, values.bias)),
        FogAmount::IteratedAlpha => values.alpha,
        FogAmount::IteratedZ => values.z >> 8,
        FogAmount::Constant | FogAmount::Iterated | FogAmount::ByW => 255,
    };
    amount + 1
}

/// The table's amount for a pseudo-float w. Slopes are unsigned.
fn table(state: &DrawState, w: i32) -> i32 {
    let entry = (w >> 10) as usize;
    let fraction = w >> 2 & 0xff;
    let value = i32::from(state.fog_table.value[entry]);
    let delta = i32::from(state.fog_table.delta[entry]);
    (value + ((delta * fraction) >> 10)).min(255)
}

/// One channel, of which `part` of 255 stays.
fn by_part(fog: &Fog, color: i32, fog_color: i32, part: i32) -> i32 {
    let added = if fog.drop_fog_color { 0 } else { fog_color };
    let kept = if fog.drop_fragment_color { 0 } else { color };
    rounded(kept * part + added * (255 - part), 255)
}

/// What the table by w leaves at a pseudo-float w.
fn part_by_w(state: &DrawState, w: i32) -> i32 {
    let samples = [state.fog_table.value, state.fog_table.delta].concat();
    let index = (w / 512) as usize;
    let (from, to) = (samples[index], samples[(index + 1).min(127)]);
    let along = w % 512 / 2;
    rounded(i32::from(from) * (256 - along) + i32::from(to) * along, 256)
}
