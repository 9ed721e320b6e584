//! Fog.
//!
//! Source: SST1, fogMode and fogTable registers.

use fillrate_engine::state::{DrawState, Fog, FogAmount};

use super::depth::biased;
use super::dither::channels;
use super::pixel::Iterated;

/// The fogged colour; alpha is unchanged.
pub fn apply(state: &DrawState, color: [i32; 4], values: Iterated) -> [i32; 4] {
    let Some(fog) = &state.fog else { return color };
    let fog_color = channels(fog.color);
    let mut out = color;
    for channel in 0..3 {
        out[channel] = match fog.amount {
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
