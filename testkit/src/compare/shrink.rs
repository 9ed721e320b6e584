//! Smaller cases that still show a mismatch.

use std::sync::Arc;

use fillrate_engine::state::{
    Addend, CombineUnit, DepthState, DrawState, Factor, LodRange, Other, TextureFactor, TextureUnit,
};

use crate::random::{Case, Command};
use crate::reference::Textures;

/// Rounds of all steps after which a case is taken as it is.
const MAX_ROUNDS: usize = 8;

/// Drops commands and simplifies states while `fails` holds. `fails` holds for
/// the case itself.
pub fn shrink(case: &Case, fails: &dyn Fn(&Case) -> bool) -> Case {
    let mut case = case.clone();
    let steps = [drop_commands, shorten_runs, simplify_states, drop_surroundings];
    for _ in 0..MAX_ROUNDS {
        let progress = steps.map(|step| step(&mut case, fails));
        if progress == [false; 4] {
            break;
        }
    }
    case
}

/// Takes a change over if the case still fails with it and is not the same.
fn adopt(case: &mut Case, changed: Case, fails: &dyn Fn(&Case) -> bool) -> bool {
    let take = fails(&changed);
    if take {
        *case = changed;
    }
    take
}

/// Tries to drop ever shorter runs of commands.
fn drop_commands(case: &mut Case, fails: &dyn Fn(&Case) -> bool) -> bool {
    let mut progress = false;
    let mut length = case.commands.len().div_ceil(2);
    while length > 0 {
        let mut end = case.commands.len();
        while end > 0 {
            let start = end.saturating_sub(length);
            let mut changed = case.clone();
            changed.commands.drain(start..end);
            progress |= adopt(case, changed, fails);
            end = start;
        }
        length /= 2;
    }
    progress
}

/// Keeps one half of a run of fragments.
fn shorten_runs(case: &mut Case, fails: &dyn Fn(&Case) -> bool) -> bool {
    let mut progress = false;
    for index in 0..case.commands.len() {
        for keep_right in [false, true] {
            let mut changed = case.clone();
            let Command::Pixels { x, colors, depths, .. } = &mut changed.commands[index] else {
                continue;
            };
            let count = colors.len().min(depths.len());
            if count < 2 {
                continue;
            }
            let half = if keep_right { count / 2..count } else { 0..count / 2 };
            *x += half.start as u32;
            *colors = Arc::from(&colors[half.clone()]);
            *depths = Arc::from(&depths[half]);
            progress |= adopt(case, changed, fails);
        }
    }
    progress
}

fn drop_surroundings(case: &mut Case, fails: &dyn Fn(&Case) -> bool) -> bool {
    let mut progress = false;
    if case.contents.is_some() {
        progress |= adopt(case, Case { contents: None, ..case.clone() }, fails);
    }
    if case.aux.is_some() {
        progress |= adopt(case, Case { aux: None, ..case.clone() }, fails);
    }
    progress
}

/// A change of a state that makes it simpler.
type Simplification = fn(&mut DrawState, &mut Textures);

const SIMPLIFICATIONS: [Simplification; 26] = [
    |state, _| state.origin = DrawState::default().origin,
    |state, _| state.clip = None,
    |state, _| state.stipple = None,
    |state, _| state.depth = DepthState::default(),
    |state, _| state.depth.bias = None,
    |state, _| state.depth.compare_constant = None,
    |state, _| state.aux_write = DrawState::default().aux_write,
    |state, textures| (state.units, *textures) = ([None; 3], [None, None, None]),
    |state, _| state.units[2] = None,
    |state, _| state.units[1..].fill(None),
    |state, _| state.chroma_key = None,
    |state, _| state.color_combine = DrawState::default().color_combine,
    |state, _| state.alpha_combine = DrawState::default().alpha_combine,
    |state, _| (state.color0, state.color1) = (0xffff_ffff, 0xffff_ffff),
    |state, _| state.alpha_test = None,
    |state, _| state.fog = None,
    |state, _| state.fog_table = DrawState::default().fog_table,
    |state, _| state.blend = None,
    |state, _| state.dither = DrawState::default().dither,
    |state, _| simplify_texture_output(state),
    |state, _| state.pattern = None,
    |state, _| state.shade = DrawState::default().shade,
    |state, _| state.dither_offset = [0; 2],
    |state, _| state.logic_op = None,
    |state, _| state.channels = DrawState::default().channels,
    |state, _| state.plane_mask = u32::MAX,
];

/// Shows the texture chain's output alone, unless something simpler is shown.
fn simplify_texture_output(state: &mut DrawState) {
    if state.color_combine == DrawState::default().color_combine {
        return;
    }
    let pass = CombineUnit { factor: Factor::Zero, one_minus: true, ..CombineUnit::default() };
    (state.color_combine.other, state.color_combine.unit) = (Other::Texture, pass);
}

/// A change of a texture unit that makes it simpler.
type UnitSimplification = fn(&mut TextureUnit);

const UNIT_SIMPLIFICATIONS: [UnitSimplification; 14] = [
    |unit| unit.perspective = false,
    |unit| unit.clamp_negative_w = false,
    |unit| unit.minify = TextureUnit::default().minify,
    |unit| unit.magnify = TextureUnit::default().magnify,
    |unit| unit.lod = LodRange { bias: 0, ..unit.lod },
    |unit| unit.lod = LodRange::default(),
    |unit| unit.lod_dither = false,
    |unit| unit.odd_levels = None,
    |unit| unit.trilinear = false,
    |unit| unit.mix_levels = false,
    |unit| unit.drop_keyed = false,
    |unit| (unit.detail_max, unit.detail_bias, unit.detail_scale) = (0, 0, 0),
    |unit| unit.combine.color = texel_alone(),
    |unit| unit.combine.alpha = texel_alone(),
];

fn texel_alone() -> CombineUnit<TextureFactor> {
    CombineUnit { zero_other: true, add: Addend::Local, ..CombineUnit::default() }
}

fn simplify_states(case: &mut Case, fails: &dyn Fn(&Case) -> bool) -> bool {
    let mut progress = false;
    for index in 0..case.commands.len() {
        for change in SIMPLIFICATIONS {
            progress |= change_state(case, index, fails, &change);
        }
        for change in UNIT_SIMPLIFICATIONS {
            let each = |state: &mut DrawState, _: &mut Textures| {
                state.units.iter_mut().flatten().for_each(change);
            };
            progress |= change_state(case, index, fails, &each);
        }
    }
    progress
}

fn change_state(
    case: &mut Case,
    index: usize,
    fails: &dyn Fn(&Case) -> bool,
    change: &dyn Fn(&mut DrawState, &mut Textures),
) -> bool {
    let mut changed = case.clone();
    let Command::State { state, textures } = &mut changed.commands[index] else { return false };
    let before = **state;
    change(state, textures);
    **state != before && adopt(case, changed, fails)
}
