//! The colour and alpha combine units.

use fillrate_simd::{IntLanes, Simd};

use super::Pass;
use super::block::{Block, Colors, Lanes};
use super::lanes::{clamp, join, scale, spread_alpha};
use crate::state::{Addend, AlphaLocal, ColorLocal, CombineUnit, Factor, Other};

/// The switches of a colour and an alpha unit as masks over channel pairs.
/// The (red, blue) vector obeys the colour unit alone; in (green, alpha) the
/// high half obeys the alpha unit.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Switches {
    keep_other: [i32; 2],
    subtract_local: [i32; 2],
    invert_factor: [i32; 2],
    add_local: [i32; 2],
    add_alpha: [i32; 2],
    invert: [i32; 2],
}

impl Switches {
    /// From the two units' settings; in the alpha unit both addends are the
    /// local alpha.
    pub fn new<F>(color: &CombineUnit<F>, alpha: &CombineUnit<F>) -> Switches {
        let both = |color: bool, alpha: bool, ones: u32| {
            let on = |on: bool| if on { ones } else { 0 };
            [(on(color) * 0x0001_0001) as i32, (on(color) | on(alpha) << 16) as i32]
        };
        let adds_local = |unit: &CombineUnit<F>| unit.add == Addend::Local;
        Switches {
            keep_other: both(!color.zero_other, !alpha.zero_other, 0xffff),
            subtract_local: both(color.subtract_local, alpha.subtract_local, 0xffff),
            invert_factor: both(color.one_minus, alpha.one_minus, 0xff),
            add_local: both(adds_local(color), alpha.add != Addend::Zero, 0xffff),
            add_alpha: both(color.add == Addend::LocalAlpha, false, 0xffff),
            invert: both(color.invert, alpha.invert, 0xff),
        }
    }

    /// [`Switches::apply`] of units that only multiply: see [`Arithmetic`].
    #[inline(always)]
    pub fn scaled<S: Simd>(&self, s: S, pair: usize, other: S::I, factor: S::I) -> S::I {
        let factor = factor ^ s.splat(self.invert_factor[pair]);
        other.mul16(factor.add16(s.splat(0x0001_0001))).shr16(8)
    }

    /// The units' arithmetic on one vector of pairs (0: red, blue; 1: green,
    /// alpha). `alpha` is the local alpha in both halves.
    ///
    /// Source: SST1, fbzColorPath; the text stands in [`crate::state`].
    #[inline(always)]
    pub fn apply<S: Simd>(
        &self,
        s: S,
        pair: usize,
        [other, local, alpha, factor]: [S::I; 4],
    ) -> S::I {
        let kept = other & s.splat(self.keep_other[pair]);
        let x = kept.sub16(local & s.splat(self.subtract_local[pair]));
        let x = scale(s, x, factor ^ s.splat(self.invert_factor[pair]));
        let add_local = local & s.splat(self.add_local[pair]);
        let add = add_local | (alpha & s.splat(self.add_alpha[pair]));
        clamp(s, x.add16(add)) ^ s.splat(self.invert[pair])
    }
}

/// How much of the combine arithmetic a state needs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Arithmetic {
    /// All of it.
    #[default]
    Any,
    /// Other times factor.
    Scale,
}

impl Arithmetic {
    /// What two units need; the alpha unit counts where alpha is read.
    pub fn of<F>(color: &CombineUnit<F>, alpha: &CombineUnit<F>, reads_alpha: bool) -> Arithmetic {
        let scale = color.scales() && (!reads_alpha || alpha.scales());
        if scale { Arithmetic::Scale } else { Arithmetic::Any }
    }
}

/// The lanes a factor is read from, and whether the alpha in them counts for
/// every channel.
struct FactorLanes<'a> {
    rb: &'a Lanes,
    ga: &'a Lanes,
    spread: bool,
}

/// Where the two units find their operands.
struct Operands<'a> {
    other: &'a Colors,
    other_alpha: &'a Lanes,
    local: &'a Colors,
    local_alpha: &'a Lanes,
    texture: &'a Colors,
    zero: &'a Colors,
}

impl<'a> Operands<'a> {
    fn color_factor(&self, factor: Factor) -> FactorLanes<'a> {
        let alpha = |ga| FactorLanes { rb: ga, ga, spread: true };
        let colors = |c: &'a Colors| FactorLanes { rb: &c.rb, ga: &c.ga, spread: false };
        match factor {
            Factor::Zero => colors(self.zero),
            Factor::Local => colors(self.local),
            Factor::OtherAlpha => alpha(self.other_alpha),
            Factor::LocalAlpha => alpha(self.local_alpha),
            Factor::TextureAlpha => alpha(&self.texture.ga),
            Factor::TextureColor => colors(self.texture),
        }
    }

    fn alpha_factor(&self, factor: Factor) -> &'a Lanes {
        match factor {
            Factor::Zero => &self.zero.ga,
            Factor::Local | Factor::LocalAlpha => self.local_alpha,
            Factor::OtherAlpha => self.other_alpha,
            Factor::TextureAlpha | Factor::TextureColor => &self.texture.ga,
        }
    }
}

/// Prepares "local" in `block.scratch` where it is not read from one place:
/// chosen by texture alpha, or depth as alpha.
#[inline(always)]
fn unusual_locals<S: Simd>(s: S, block: &mut Block, pass: &Pass<'_>) {
    let state = &pass.pipeline.state;
    let constant = &pass.pipeline.color0;
    let by_texture =
        state.color_combine.local == ColorLocal::ByTextureAlpha && pass.pipeline.unit_count > 0;
    for k in (0..block.len()).step_by(S::LANES) {
        let rb = s.load(&block.iterated.rb.0[k..]);
        let ga = s.load(&block.iterated.ga.0[k..]);
        // Bit 7 of the texture alpha, over the whole lane.
        let chosen = s.load(&block.texture.ga.0[k..]).shl(8).sar(31);
        let chosen = if by_texture { chosen } else { s.splat(0) };
        let depth = s.load(&block.z.0[k..]).shl(8) & s.splat(0x00ff_0000);
        let rb = rb ^ ((rb ^ s.splat(constant.rb.0[0])) & chosen);
        let g = ga ^ ((ga ^ s.splat(constant.ga.0[0])) & chosen);
        s.store(rb, &mut block.scratch.rb.0[k..]);
        s.store(join(s, g, depth), &mut block.scratch.ga.0[k..]);
    }
}

/// Runs both units into `block.color`.
#[inline(always)]
pub(crate) fn combine<S: Simd>(s: S, block: &mut Block, pass: &Pass<'_>) {
    let pipeline = pass.pipeline;
    let (cc, ac) = (&pipeline.state.color_combine, &pipeline.state.alpha_combine);
    if cc.local == ColorLocal::ByTextureAlpha || ac.local == AlphaLocal::Depth {
        unusual_locals(s, block, pass);
    }
    let len = block.len();
    let Block { iterated, texture, color, scratch, .. } = block;
    let texture = pipeline.texture_output(texture);
    let operands = Operands {
        other: pick(cc.other, iterated, texture, &pipeline.color1),
        other_alpha: &pick(ac.other, iterated, texture, &pipeline.color1).ga,
        local: match cc.local {
            ColorLocal::Iterated => iterated,
            ColorLocal::Constant => &pipeline.color0,
            ColorLocal::ByTextureAlpha => scratch,
        },
        local_alpha: match ac.local {
            AlphaLocal::Iterated => &iterated.ga,
            AlphaLocal::Constant => &pipeline.color0.ga,
            AlphaLocal::Depth => &scratch.ga,
        },
        texture,
        zero: &pipeline.zero,
    };
    match pipeline.arithmetic {
        Arithmetic::Scale => scale_colors(s, len, pass, &operands, color),
        Arithmetic::Any => run(s, len, pass, &operands, color),
    }
}

#[inline(always)]
fn pick<'a>(
    other: Other,
    iterated: &'a Colors,
    texture: &'a Colors,
    constant: &'a Colors,
) -> &'a Colors {
    match other {
        Other::Iterated => iterated,
        Other::Texture => texture,
        Other::Constant => constant,
    }
}

#[inline(always)]
fn load<S: Simd>(s: S, lanes: &Lanes, k: usize) -> S::I {
    s.load(&lanes.0[k..])
}

/// Only `(other * (factor + 1)) >> 8`, where the alpha unit does no more or
/// nobody reads alpha.
#[inline(always)]
fn scale_colors<S: Simd>(s: S, len: usize, pass: &Pass<'_>, from: &Operands<'_>, out: &mut Colors) {
    let state = &pass.pipeline.state;
    let switches = &pass.pipeline.combine;
    let factor = from.color_factor(state.color_combine.unit.factor);
    let factor_alpha = from.alpha_factor(state.alpha_combine.unit.factor);
    for k in (0..len).step_by(S::LANES) {
        let (mut f_rb, mut f_ga) = (load(s, factor.rb, k), load(s, factor.ga, k));
        if factor.spread {
            f_rb = spread_alpha(s, f_rb);
            f_ga = f_rb;
        }
        let mut ga = load(s, &from.other.ga, k);
        if pass.pipeline.reads_alpha {
            f_ga = join(s, f_ga, load(s, factor_alpha, k));
            ga = join(s, ga, load(s, from.other_alpha, k));
        }
        let rb = load(s, &from.other.rb, k);
        s.store(switches.scaled(s, 0, rb, f_rb), &mut out.rb.0[k..]);
        s.store(switches.scaled(s, 1, ga, f_ga), &mut out.ga.0[k..]);
    }
}

#[inline(always)]
fn run<S: Simd>(s: S, len: usize, pass: &Pass<'_>, from: &Operands<'_>, out: &mut Colors) {
    let state = &pass.pipeline.state;
    let switches = &pass.pipeline.combine;
    let factor = from.color_factor(state.color_combine.unit.factor);
    let factor_alpha = from.alpha_factor(state.alpha_combine.unit.factor);
    for k in (0..len).step_by(S::LANES) {
        let (mut f_rb, mut f_g) = (load(s, factor.rb, k), load(s, factor.ga, k));
        if factor.spread {
            f_rb = spread_alpha(s, f_rb);
            f_g = f_rb;
        }
        let local_alpha = load(s, from.local_alpha, k);
        let alpha = spread_alpha(s, local_alpha);
        let rb = [load(s, &from.other.rb, k), load(s, &from.local.rb, k), alpha, f_rb];
        let ga = [
            join(s, load(s, &from.other.ga, k), load(s, from.other_alpha, k)),
            join(s, load(s, &from.local.ga, k), local_alpha),
            alpha,
            join(s, f_g, load(s, factor_alpha, k)),
        ];
        s.store(switches.apply(s, 0, rb), &mut out.rb.0[k..]);
        s.store(switches.apply(s, 1, ga), &mut out.ga.0[k..]);
    }
}
