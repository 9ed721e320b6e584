//! Fog.

use fillrate_simd::{IntLanes, Simd};

use super::Pass;
use super::block::{Block, Colors, STAMP, Slot};
use super::depth::keep;
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

/// The amount that the table has for pseudo-floats w, 0..=255, in both halves.
///
/// Source: SST1, fogTable.
#[inline(always)]
fn table_amount<S: Simd>(s: S, pass: &Pass<'_>, w: S::I) -> S::I {
    let bias = s.splat(i32::from(pass.pipeline.state.depth.bias.unwrap_or(0)));
    let w = (w + bias).max(s.splat(0)).min(s.splat(0xffff));
    let entry = s.lookup64(&pass.pipeline.fog_entries, w.shr(10));
    let step = entry.shr(8).mul(w.shr(2) & s.splat(0xff)).shr(10);
    let amount = ((entry & s.splat(0xff)) + step).min(s.splat(255));
    amount | amount.shl(16)
}

/// The fog amount, 0..=255, in both halves.
#[inline(always)]
fn amount<S: Simd>(s: S, block: &Block, fog: &Fog, k: usize) -> S::I {
    match fog.amount {
        FogAmount::Table => s.load(&block.fog.0[k..]),
        FogAmount::IteratedAlpha => spread_alpha(s, s.load(&block.iterated.ga.0[k..])),
        FogAmount::IteratedZ => {
            let amount = s.load(&block.z.0[k..]).shr(8);
            amount | amount.shl(16)
        }
        FogAmount::Constant | FogAmount::Iterated | FogAmount::ByW => s.splat(0),
    }
}

/// Amounts by the table, into `block.fog`. Looking them up takes long, so many of
/// them are under way in a loop that does nothing else.
#[inline(always)]
pub(crate) fn fog_amount<S: Simd>(s: S, block: &mut Block, pass: &Pass<'_>) {
    let Block { slots, count, steps, w, fog, .. } = block;
    if !pass.pipeline.needs.keeps_w {
        keep(s, &mut steps.w, &slots[..*count], pass, w);
    }
    for k in (0..*count * STAMP).step_by(S::LANES) {
        s.store(table_amount(s, pass, s.load(&w.0[k..])), &mut fog.0[k..]);
    }
}

/// What all fragments have of a state's fog.
#[derive(Clone, Copy)]
pub(super) struct FogColor<S: Simd> {
    color: [S::I; 2],
    /// Ones where the fragment's colour counts.
    keep: S::I,
}

impl<S: Simd> FogColor<S> {
    #[inline(always)]
    pub fn new(s: S, pass: &Pass<'_>) -> Self {
        let (mut color, mut keep) = (0, true);
        if let Some(fog) = &pass.pipeline.state.fog {
            // The constant mode adds the fog colour whole, whatever is dropped.
            let dropped = fog.drop_fog_color && fog.amount != FogAmount::Constant;
            (color, keep) = (if dropped { 0 } else { fog.color }, !fog.drop_fragment_color);
        }
        let color = Colors::splat(color & 0xff_ffff);
        FogColor {
            color: [s.splat(color.rb.0[0]), s.splat(color.ga.0[0])],
            keep: s.splat(if keep { -1 } else { 0 }),
        }
    }

    /// Colours moved towards that of the fog by an amount; alpha stays.
    #[inline(always)]
    pub fn mixed(&self, s: S, [rb, ga]: [S::I; 2], amount: S::I) -> [S::I; 2] {
        let g = mix(s, ga & self.keep, self.color[1], amount);
        [mix(s, rb & self.keep, self.color[0], amount), join(s, g, ga)]
    }

    /// Colours with that of the fog added; alpha stays.
    #[inline(always)]
    fn added(&self, s: S, [rb, ga]: [S::I; 2]) -> [S::I; 2] {
        let g = clamp(s, ga.add16(self.color[1]));
        [clamp(s, rb.add16(self.color[0])), join(s, g, ga)]
    }

    /// Colours mixed with that of the fog by the part that stays; alpha stays.
    #[inline(always)]
    fn by_part(&self, s: S, [rb, ga]: [S::I; 2], part: S::I) -> [S::I; 2] {
        let g = lerp_255(s, ga & self.keep, self.color[1], part);
        [lerp_255(s, rb & self.keep, self.color[0], part), join(s, g, ga)]
    }
}

/// The colour moved towards the fog colour.
#[inline(always)]
fn mix<S: Simd>(s: S, color: S::I, fog_color: S::I, amount: S::I) -> S::I {
    clamp(s, color.add16(scale(s, fog_color.sub16(color), amount)))
}

/// The colour of fragments `k..`, which goes to `block.prefog` where blending may
/// read it.
#[inline(always)]
fn before<S: Simd>(s: S, block: &mut Block, blends: bool, k: usize) -> [S::I; 2] {
    let [rb, ga] = [s.load(&block.color.rb.0[k..]), s.load(&block.color.ga.0[k..])];
    if blends {
        s.store(rb, &mut block.prefog.rb.0[k..]);
        s.store(ga, &mut block.prefog.ga.0[k..]);
    }
    [rb, ga]
}

/// Fogs `block.color`; alpha stays.
#[inline(always)]
pub(crate) fn fog<S: Simd>(s: S, block: &mut Block, pass: &Pass<'_>) {
    let Some(fog) = pass.pipeline.state.fog else { return };
    let color = FogColor::new(s, pass);
    let blends = pass.pipeline.state.blend.is_some();
    for k in (0..block.len()).step_by(S::LANES) {
        let amount = amount(s, block, &fog, k);
        let before = before(s, block, blends, k);
        let [rb, ga] = match fog.amount {
            FogAmount::Constant => color.added(s, before),
            _ => color.mixed(s, before, amount),
        };
        s.store(rb, &mut block.color.rb.0[k..]);
        s.store(ga, &mut block.color.ga.0[k..]);
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
#[inline(always)]
pub(crate) fn fog_by_part<S: Simd>(s: S, block: &mut Block, pass: &Pass<'_>) {
    let Some(fog) = pass.pipeline.state.fog else { return };
    let color = FogColor::new(s, pass);
    let blends = pass.pipeline.state.blend.is_some();
    for slot in 0..block.count {
        let at = block.slots[slot];
        for j in (0..STAMP).step_by(S::LANES) {
            let k = slot * STAMP + j;
            let part = part_left(s, block, pass, &fog, &at, [j, k]);
            let before = before(s, block, blends, k);
            let [rb, ga] = color.by_part(s, before, part);
            s.store(rb, &mut block.color.rb.0[k..]);
            s.store(ga, &mut block.color.ga.0[k..]);
        }
    }
}
