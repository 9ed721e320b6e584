//! Random textures.

use std::sync::Arc;

use fillrate_engine::state::DrawState;
use fillrate_engine::{Texture, TextureDesc};

use super::Rng;
use crate::reference::Textures;

/// Textures for the units of a state. Now and then a unit has none.
pub fn textures(rng: &mut Rng, state: &DrawState) -> Textures {
    state.units.map(|unit| match unit {
        Some(unit) if !rng.one_in(16) => Some(Arc::new(texture(rng, unit.clamp_s))),
        _ => None,
    })
}

fn texture(rng: &mut Rng, clamp_s: bool) -> Texture {
    // Small sides mostly: large textures take long to fill, and repeat less.
    let largest = if rng.one_in(40) { 9 } else { 6 };
    let first = if rng.coin() { 0 } else { rng.below(9) as u8 };
    let last = if rng.one_in(4) { first } else { first + rng.below(12 - u32::from(first)) as u8 };
    let bits = |rng: &mut Rng| {
        let level_bits = rng.below(largest) as u8;
        (level_bits + first).min(11)
    };
    let desc = TextureDesc { s_bits: bits(rng), t_bits: bits(rng), first, last, clamp_s };
    let palette: Vec<u32> = (0..1 + rng.below(7)).map(|_| texel(rng)).collect();
    let few_colors = rng.one_in(4);
    let border = rng.maybe(5, texel);
    let mut texels = |level: u8, out: &mut Vec<u32>| {
        let side = |bits: u8| 1usize << bits.saturating_sub(level);
        let count = side(desc.s_bits) * side(desc.t_bits);
        out.extend((0..count).map(|_| match few_colors {
            true => rng.pick(&palette),
            false => texel(rng),
        }));
    };
    let built = match border {
        Some(border) => Texture::build_bordered(desc, border, &mut texels),
        None => Texture::build(desc, &mut texels),
    };
    let texture = built.expect("sides, levels and texel counts are within limits");
    match rng.one_in(3) {
        true => texture.with_key(|_, _, _| rng.one_in(4)),
        false => texture,
    }
}

/// A texel; often with channels at the ends of their range.
fn texel(rng: &mut Rng) -> u32 {
    match rng.below(8) {
        0 => 0,
        1 => 0xffff_ffff,
        2 => rng.word() | 0xff00_0000,
        3 => rng.word() & 0x00ff_ffff,
        4 => rng.pick(&KEY_COLORS) | rng.word() & 0xff00_0000,
        _ => rng.word(),
    }
}

/// Colours that chroma keys and constants are chosen from as well, so that keys
/// meet colours.
pub(super) const KEY_COLORS: [u32; 4] = [0x0000_0000, 0x00ff_ffff, 0x00ff_00ff, 0x0008_1018];
