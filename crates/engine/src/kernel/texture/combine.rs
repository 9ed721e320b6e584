//! Texture combine: joins a unit's texel with the unit upstream.

use fillrate_simd::{IntLanes, Simd};

use super::UnitPlan;
use crate::kernel::block::Block;
use crate::kernel::combine::Arithmetic;
use crate::kernel::lanes::{join, spread_alpha};
use crate::state::TextureFactor;

/// Combines the texels in `block.scratch` with `block.texture` into
/// `block.texture`.
#[inline(always)]
pub(crate) fn texture_combine<S: Simd>(s: S, block: &mut Block, plan: &UnitPlan) {
    for k in (0..block.len()).step_by(S::LANES) {
        let local = [s.load(&block.scratch.rb.0[k..]), s.load(&block.scratch.ga.0[k..])];
        let [rb, ga] = if plan.multiplies {
            multiplied_texels(s, block, plan, local, k)
        } else {
            combined_texels(s, block, plan, local, k)
        };
        s.store(rb, &mut block.texture.rb.0[k..]);
        s.store(ga, &mut block.texture.ga.0[k..]);
    }
}

/// What comes from the unit upstream for fragments `k..`: "other".
#[inline(always)]
fn other_texels<S: Simd>(s: S, block: &Block, plan: &UnitPlan, k: usize) -> [S::I; 2] {
    if !plan.has_other {
        return [s.splat(0); 2];
    }
    [s.load(&block.texture.rb.0[k..]), s.load(&block.texture.ga.0[k..])]
}

/// The texels of fragments `k..` ("local") times "other", where the unit does no
/// more: see [`UnitPlan::multiplies`].
#[inline(always)]
pub(crate) fn multiplied_texels<S: Simd>(
    s: S,
    block: &Block,
    plan: &UnitPlan,
    local: [S::I; 2],
    k: usize,
) -> [S::I; 2] {
    let [rb, ga] = other_texels(s, block, plan, k);
    [plan.switches.scaled(s, 0, rb, local[0]), plan.switches.scaled(s, 1, ga, local[1])]
}

/// The texels of fragments `k..` combined with "other" as the unit says.
#[inline(always)]
fn combined_texels<S: Simd>(
    s: S,
    block: &Block,
    plan: &UnitPlan,
    local: [S::I; 2],
    k: usize,
) -> [S::I; 2] {
    let combine = &plan.unit.combine;
    let [other_rb, other_ga] = other_texels(s, block, plan, k);
    let lod = s.load(&block.lod.0[k..]);
    let color = factor(s, plan, combine.color.factor, local, other_ga, lod);
    let alpha_factor = factor(s, plan, combine.alpha.factor, local, other_ga, lod);
    let odd = if plan.unit.trilinear {
        // Bit 0 of the level over both halves, as 0xff.
        lod.shl(23).sar(31) & s.splat(0x00ff_00ff)
    } else {
        s.splat(0)
    };
    let factor_ga = join(s, color[1], alpha_factor[1]) ^ odd;
    if plan.arithmetic == Arithmetic::Scale {
        let rb = plan.switches.scaled(s, 0, other_rb, color[0] ^ odd);
        return [rb, plan.switches.scaled(s, 1, other_ga, factor_ga)];
    }
    let alpha = spread_alpha(s, local[1]);
    let rb = plan.switches.apply(s, 0, [other_rb, local[0], alpha, color[0] ^ odd]);
    [rb, plan.switches.apply(s, 1, [other_ga, local[1], alpha, factor_ga])]
}

/// A factor for both vectors.
#[inline(always)]
fn factor<S: Simd>(
    s: S,
    plan: &UnitPlan,
    factor: TextureFactor,
    local: [S::I; 2],
    other_ga: S::I,
    lod: S::I,
) -> [S::I; 2] {
    match factor {
        TextureFactor::Zero => [s.splat(0); 2],
        TextureFactor::Local => local,
        TextureFactor::OtherAlpha => [spread_alpha(s, other_ga); 2],
        TextureFactor::LocalAlpha => [spread_alpha(s, local[1]); 2],
        TextureFactor::Detail => [detail(s, plan, lod); 2],
        TextureFactor::LodFraction => {
            let fraction = lod & s.splat(0xff);
            [fraction | fraction.shl(16); 2]
        }
    }
}

/// The detail factor of levels of detail, in both halves.
///
/// Source: SST1, tDetail.
#[inline(always)]
fn detail<S: Simd>(s: S, plan: &UnitPlan, lod: S::I) -> S::I {
    let bias = s.splat(i32::from(plan.unit.detail_bias) << 8);
    let distance = (bias - lod).max(s.splat(0));
    let scaled = distance.shl(u32::from(plan.unit.detail_scale & 7)).sar(8);
    let factor = scaled.min(s.splat(i32::from(plan.unit.detail_max)));
    factor | factor.shl(16)
}
