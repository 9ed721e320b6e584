//! Texture combine: joins a unit's texel with the unit upstream.

use fillrate_simd::{IntLanes, Simd};

use super::UnitPlan;
use crate::kernel::block::Block;
use crate::kernel::lanes::{join, spread_alpha};
use crate::state::TextureFactor;

/// Combines the texels in `block.scratch` ("local") with `block.texture`
/// ("other") into `block.texture`.
#[inline(always)]
pub(crate) fn texture_combine<S: Simd>(s: S, block: &mut Block, plan: &UnitPlan) {
    let combine = &plan.unit.combine;
    for k in (0..block.len()).step_by(S::LANES) {
        let zero = s.splat(0);
        let (mut other_rb, mut other_ga) = (zero, zero);
        if plan.has_other {
            other_rb = s.load(&block.texture.rb.0[k..]);
            other_ga = s.load(&block.texture.ga.0[k..]);
        }
        let local_rb = s.load(&block.scratch.rb.0[k..]);
        let local_ga = s.load(&block.scratch.ga.0[k..]);
        let alpha = spread_alpha(s, local_ga);
        let factor = |factor: TextureFactor| match factor {
            TextureFactor::Zero => [zero; 2],
            TextureFactor::Local => [local_rb, local_ga],
            TextureFactor::OtherAlpha => [spread_alpha(s, other_ga); 2],
            TextureFactor::LocalAlpha => [alpha; 2],
            TextureFactor::Detail => [detail(s, plan, s.load(&block.lod.0[k..])); 2],
            TextureFactor::LodFraction => {
                let fraction = s.load(&block.lod.0[k..]) & s.splat(0xff);
                [fraction | fraction.shl(16); 2]
            }
        };
        let color = factor(combine.color.factor);
        let alpha_factor = factor(combine.alpha.factor);
        let odd = if plan.unit.trilinear {
            // Bit 0 of the level over both halves, as 0xff.
            s.load(&block.lod.0[k..]).shl(23).sar(31) & s.splat(0x00ff_00ff)
        } else {
            zero
        };
        let rb = [other_rb, local_rb, alpha, color[0] ^ odd];
        let ga = [other_ga, local_ga, alpha, join(s, color[1], alpha_factor[1]) ^ odd];
        s.store(plan.switches.apply(s, 0, rb), &mut block.texture.rb.0[k..]);
        s.store(plan.switches.apply(s, 1, ga), &mut block.texture.ga.0[k..]);
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
