//! Colour after the combine units: decal, modulation beyond one, the second
//! colour, the colour of a pattern's gaps. The equations stand in
//! [`crate::state::Shade`].

use fillrate_simd::{IntLanes, Simd};

use super::Pass;
use super::block::{Block, STAMP, Slot};
use super::iterate::iterated_colors;
use super::lanes::{iterate, join, lerp_255, places, spread_alpha, wrap, wrap_colors};
use super::stipple::pattern_bits;
use crate::setup::{BASE, Plane64, SPECULAR};
use crate::state::DecalBase;

/// A 32-bit attribute that lies in the low halves of a 64-bit one.
#[inline(always)]
fn iterate_low<S: Simd>(s: S, plane: &Plane64, [x, y]: [S::I; 2]) -> S::I {
    s.splat(plane.c as i32) + (x.mul(s.splat(plane.dx as i32)) + y.mul(s.splat(plane.dy as i32)))
}

/// The second (`lane` [`SPECULAR`]) or third colour (`lane` [`BASE`]) of
/// fragments `j..` of a stamp, wrapped as the first.
#[inline(always)]
pub(super) fn extra_colors<S: Simd>(
    s: S,
    pass: &Pass<'_>,
    at: &Slot,
    lane: usize,
    j: usize,
) -> [S::I; 2] {
    let high = s.splat(0x0fff_0000);
    let [r, g, b, a] = pass.triangles.extra_color(pass.triangle(at), lane);
    let places = places(s, at.x, at.y, j);
    let rb = iterate_low(s, &r, places).shr(20) | (iterate_low(s, &b, places).shr(4) & high);
    let ga = iterate_low(s, &g, places).shr(20) | (iterate_low(s, &a, places).shr(4) & high);
    [wrap_colors(s, rb), wrap_colors(s, ga)]
}

/// The fog factor of fragments `j..` of a stamp, in both halves.
#[inline(always)]
pub(super) fn fog_factor<S: Simd>(s: S, pass: &Pass<'_>, at: &Slot, j: usize) -> S::I {
    let [.., part] = pass.triangles.extra_color(pass.triangle(at), SPECULAR);
    let whole = iterate_low(s, &part, places(s, at.x, at.y, j)).shr(20);
    let factor = wrap::<S, 12, 8>(s, whole);
    factor | factor.shl(16)
}

/// Replaces `block.color` but its alpha, by a function of what it was; `j` is
/// the first fragment's place in the stamp of a slot, `k` that in the block.
macro_rules! recolor {
    ($s:ident, $block:ident, |$at:ident, $j:ident, $k:ident, $rb:ident, $ga:ident| $body:expr) => {
        for slot in 0..$block.count {
            let $at = &$block.slots[slot];
            for $j in (0..STAMP).step_by(S::LANES) {
                let $k = slot * STAMP + $j;
                let $rb = $s.load(&$block.color.rb.0[$k..]);
                let $ga = $s.load(&$block.color.ga.0[$k..]);
                let [rb, g] = $body;
                $s.store(rb, &mut $block.color.rb.0[$k..]);
                $s.store(join($s, g, $ga), &mut $block.color.ga.0[$k..]);
            }
        }
    };
}

/// The texture over a base colour.
#[inline(always)]
pub(crate) fn decal<S: Simd>(s: S, block: &mut Block, pass: &Pass<'_>) {
    let Some(from) = pass.pipeline.state.shade.decal else { return };
    recolor!(s, block, |at, j, k, _rb, _ga| {
        let texture = pass.pipeline.texture_output(&block.texture);
        let (rb, ga) = (s.load(&texture.rb.0[k..]), s.load(&texture.ga.0[k..]));
        let alpha = spread_alpha(s, ga);
        let base = match from {
            DecalBase::Base => extra_colors(s, pass, at, BASE, j),
            DecalBase::Iterated => {
                iterated_colors::<S, false>(s, &pass.triangle(at).narrow, places(s, at.x, at.y, j))
            }
        };
        [lerp_255(s, rb, base[0], alpha), lerp_255(s, ga, base[1], alpha)]
    });
}

/// Times the iterated colour, up to eight times as bright.
#[inline(always)]
pub(crate) fn overbright<S: Simd>(s: S, block: &mut Block, pass: &Pass<'_>) {
    recolor!(s, block, |at, j, k, rb, ga| {
        let narrow = &pass.triangle(at).narrow;
        let places = places(s, at.x, at.y, j);
        let low = s.splat(0xffff);
        let r = multiplied(s, rb & low, iterate(s, narrow, 0, places));
        let g = multiplied(s, ga & low, iterate(s, narrow, 1, places));
        let b = multiplied(s, rb.shr(16), iterate(s, narrow, 2, places));
        [r | b.shl(16), g]
    });
}

/// A channel times the integer part of an iterated colour, which is not wrapped
/// and counts 0 at least, by 255, to the nearest, at most 255.
#[inline(always)]
fn multiplied<S: Simd>(s: S, channel: S::I, factor: S::I) -> S::I {
    let product = channel.mul(factor.sar(20).max(s.splat(0)));
    let v = product.min(s.splat(255 * 255)) + s.splat(128);
    (v + v.shr(8)).shr(8)
}

/// Adds the second iterated colour.
#[inline(always)]
pub(crate) fn specular<S: Simd>(s: S, block: &mut Block, pass: &Pass<'_>) {
    let top = s.splat(0x00ff_00ff);
    recolor!(s, block, |at, j, k, rb, ga| {
        let added = extra_colors(s, pass, at, SPECULAR, j);
        [rb.add16(added[0]).min16(top), ga.add16(added[1]).min16(top)]
    });
}

/// The background colour and alpha where a pattern has gaps.
#[inline(always)]
pub(crate) fn background<S: Simd>(s: S, block: &mut Block, pass: &Pass<'_>) {
    let Some(pattern) = &pass.pipeline.state.pattern else { return };
    let gaps = !pattern_bits(block, pattern);
    let [rb, ga] = [&pass.pipeline.background.rb, &pass.pipeline.background.ga];
    for k in (0..block.len()).step_by(S::LANES) {
        let gap = s.mask((gaps >> k) as u32);
        let color = &mut block.color;
        s.store(s.splat(rb.0[0]).select(s.load(&color.rb.0[k..]), gap), &mut color.rb.0[k..]);
        s.store(s.splat(ga.0[0]).select(s.load(&color.ga.0[k..]), gap), &mut color.ga.0[k..]);
    }
}
