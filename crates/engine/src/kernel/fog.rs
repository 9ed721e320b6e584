//! Fog.

use fillrate_simd::{IntLanes, Simd};

use super::Pass;
use super::block::{Block, Colors, STAMP, Slot};
use super::lanes::{clamp, join, lerp_255, scale, spread_alpha};
use super::shade::fog_factor;
use crate::state::{FOG_SAMPLES, Fog, FogAmount, FogTable};

/// A fog table as 64 entries: the amount in the low eight bits, then the slope.
pub(crate) fn fog_entries(table: &FogTable) -> [i32; 64] {
    core::array::from_fn(|i| i32::from(table.value[i]) | i32::from(table.delta[i]) << 8)
}

/// A table of [`FogTable::by_w`] as 64 entries: every other sample in the low eight
/// bits, then the two after it.
pub(crate) fn fog_samples(table: &FogTable) -> [i32; FOG_SAMPLES / 2] {
    let sample = |i: usize| i32::from(table.sample(i));
    core::array::from_fn(|i| sample(2 * i) | sample(2 * i + 1) << 8 | sample(2 * i + 2) << 16)
}

/// The fog amount, 0..=255, in both halves.
///
/// Source: SST1, fogTable.
#[inline(always)]
fn amount<S: Simd>(s: S, block: &Block, pass: &Pass<'_>, fog: &Fog, k: usize) -> S::I {
    match fog.amount {
        FogAmount::Table => {
            let bias = s.splat(i32::from(pass.pipeline.state.depth.bias.unwrap_or(0)));
            let w = (s.load(&block.w.0[k..]) + bias).max(s.splat(0)).min(s.splat(0xffff));
            let entry = s.lookup64(&pass.pipeline.fog_entries, w.shr(10));
            let step = entry.shr(8).mul(w.shr(2) & s.splat(0xff)).shr(10);
            let amount = ((entry & s.splat(0xff)) + step).min(s.splat(255));
            amount | amount.shl(16)
        }
        FogAmount::IteratedAlpha => spread_alpha(s, s.load(&block.iterated.ga.0[k..])),
        FogAmount::IteratedZ => {
            let amount = s.load(&block.z.0[k..]).shr(8);
            amount | amount.shl(16)
        }
        FogAmount::Constant | FogAmount::Iterated | FogAmount::ByW => s.splat(0),
    }
}

/// The colour moved towards the fog colour.
#[inline(always)]
fn mix<S: Simd>(s: S, color: S::I, fog_color: S::I, amount: S::I) -> S::I {
    clamp(s, color.add16(scale(s, fog_color.sub16(color), amount)))
}

/// Fogs `block.color`; alpha stays. The colour before goes to `block.prefog` where
/// blending may read it.
#[inline(always)]
pub(crate) fn fog<S: Simd>(s: S, block: &mut Block, pass: &Pass<'_>) {
    let Some(fog) = pass.pipeline.state.fog else { return };
    // The constant mode adds the fog colour whole, whatever is dropped.
    let dropped = fog.drop_fog_color && fog.amount != FogAmount::Constant;
    let fog_color = Colors::splat(if dropped { 0 } else { fog.color & 0xff_ffff });
    let (fog_rb, fog_ga) = (s.splat(fog_color.rb.0[0]), s.splat(fog_color.ga.0[0]));
    let keep = s.splat(if fog.drop_fragment_color { 0 } else { -1 });
    let blends = pass.pipeline.state.blend.is_some();
    for k in (0..block.len()).step_by(S::LANES) {
        let amount = amount(s, block, pass, &fog, k);
        let rb = s.load(&block.color.rb.0[k..]);
        let ga = s.load(&block.color.ga.0[k..]);
        if blends {
            s.store(rb, &mut block.prefog.rb.0[k..]);
            s.store(ga, &mut block.prefog.ga.0[k..]);
        }
        let (new_rb, new_ga) = if fog.amount == FogAmount::Constant {
            (clamp(s, rb.add16(fog_rb)), clamp(s, ga.add16(fog_ga)))
        } else {
            (mix(s, rb & keep, fog_rb, amount), mix(s, ga & keep, fog_ga, amount))
        };
        s.store(new_rb, &mut block.color.rb.0[k..]);
        s.store(join(s, new_ga, ga), &mut block.color.ga.0[k..]);
    }
}

/// The part of the colour that fog leaves, 0..=255, in both halves, of
/// fragments `j..` of a slot, which are `k..` of the block.
#[inline(always)]
fn part_left<S: Simd>(
    s: S,
    block: &Block,
    pass: &Pass<'_>,
    fog: &Fog,
    at: &Slot,
    [j, k]: [usize; 2],
) -> S::I {
    if fog.amount == FogAmount::Iterated {
        return fog_factor(s, pass, at, j);
    }
    let w = s.load(&block.w.0[k..]);
    let entry = s.lookup64(&pass.pipeline.fog_entries, w.shr(10));
    // The odd samples begin eight bits later.
    let samples = entry.sar_each(w.shr(6) & s.splat(8));
    let (from, to) = (samples & s.splat(0xff), samples.shr(8) & s.splat(0xff));
    let along = w.shr(1) & s.splat(0xff);
    let part = (from.shl(8) + (to - from).mul(along) + s.splat(128)).shr(8);
    part | part.shl(16)
}

/// Mixes `block.color` with the fog colour by the part that stays; alpha stays.
/// The colour before goes to `block.prefog` where blending may read it.
#[inline(always)]
pub(crate) fn fog_by_part<S: Simd>(s: S, block: &mut Block, pass: &Pass<'_>) {
    let Some(fog) = pass.pipeline.state.fog else { return };
    let fog_color = Colors::splat(if fog.drop_fog_color { 0 } else { fog.color & 0xff_ffff });
    let (fog_rb, fog_ga) = (s.splat(fog_color.rb.0[0]), s.splat(fog_color.ga.0[0]));
    let keep = s.splat(if fog.drop_fragment_color { 0 } else { -1 });
    let blends = pass.pipeline.state.blend.is_some();
    for slot in 0..block.count {
        let at = block.slots[slot];
        for j in (0..STAMP).step_by(S::LANES) {
            let k = slot * STAMP + j;
            let part = part_left(s, block, pass, &fog, &at, [j, k]);
            let rb = s.load(&block.color.rb.0[k..]);
            let ga = s.load(&block.color.ga.0[k..]);
            if blends {
                s.store(rb, &mut block.prefog.rb.0[k..]);
                s.store(ga, &mut block.prefog.ga.0[k..]);
            }
            s.store(lerp_255(s, rb & keep, fog_rb, part), &mut block.color.rb.0[k..]);
            let g = lerp_255(s, ga & keep, fog_ga, part);
            s.store(join(s, g, ga), &mut block.color.ga.0[k..]);
        }
    }
}
