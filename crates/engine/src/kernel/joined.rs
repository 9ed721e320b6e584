//! The commonest ends of a stage list as one loop, so that a fragment's values
//! stay in registers from its first colour to the frame buffer.
//!
//! Nothing is computed here: the functions are those of the single stages, and
//! the list without joining draws the same pixels.

use fillrate_simd::Simd;

use super::block::{Block, STAMP, Slot, Strip, any_live};
use super::fog::FogColor;
use super::iterate::{ColorIterators, iterated_colors};
use super::lanes::{join as join_halves, places};
use super::output::{blended, copy_strip, pack};
use super::pipeline::{Pipeline, Stage};
use super::texture::{multiplied_texels, texels};
use super::{ColorTile, Pass, Tile};
use crate::state::{
    AlphaCombine, AlphaLocal, AuxWrite, ColorLocal, Dither, Factor, FogAmount, Other,
};
use crate::target::PixelFormat;

/// Where the fragments' colour comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ColorSource {
    Iterated,
    Texel,
    /// Texel times iterated colour.
    Product,
}

/// Where their alpha comes from, where it is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum AlphaSource {
    /// From where the colour comes.
    Color,
    Texel,
    Iterated,
    /// `color0`.
    Constant0,
    /// `color1`.
    Constant1,
}

/// A joined end of a stage list: colour, fog, blend, write.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Joined {
    pub color: ColorSource,
    pub alpha: AlphaSource,
    /// The texel is multiplied by that of the unit upstream.
    pub chain: bool,
    /// By the table.
    pub fog: bool,
    pub blend: bool,
}

impl Joined {
    /// Whether it is more than colour, blend and write. So much at once pays only
    /// where a stamp is one vector; elsewhere its stages run one by one.
    pub fn is_long(&self) -> bool {
        self.chain || self.fog
    }

    /// Whether iterated colours are written, blended or not, and nothing else is done.
    pub fn is_iterated(&self) -> bool {
        self.color == ColorSource::Iterated && !self.is_long()
    }

    /// The single stages that it stands for.
    pub fn stages(&self) -> impl Iterator<Item = Stage> {
        let textured = self.color != ColorSource::Iterated;
        let stages = [
            (textured, Stage::Fetch(0)),
            (self.chain, Stage::TextureCombine(0)),
            (self.color != ColorSource::Texel, Stage::IterateColors),
            (textured, Stage::Combine),
            (self.fog, Stage::Fog),
            (self.blend, Stage::Blend),
            (true, Stage::Write),
        ];
        stages.into_iter().filter_map(|(wanted, stage)| wanted.then_some(stage))
    }
}

/// Replaces the end of a pipeline's stage list where it can be joined.
pub(super) fn join_stages(pipeline: &mut Pipeline, format: PixelFormat) {
    let state = &pipeline.state;
    if format != PixelFormat::Rgb565 || !state.color_write || state.aux_write == AuxWrite::Alpha {
        return;
    }
    let Some(color) = color_source(pipeline) else { return };
    let Some(alpha) = alpha_source(pipeline, color) else { return };
    let joined = Joined {
        color,
        alpha,
        chain: color != ColorSource::Iterated
            && pipeline.units[0].as_ref().is_some_and(|plan| !plan.texel_only),
        fog: state.fog.is_some_and(|fog| fog.amount == FogAmount::Table),
        blend: state.blend.is_some(),
    };
    let end: Vec<Stage> = joined.stages().collect();
    let misses_alpha = alpha == AlphaSource::Iterated && color == ColorSource::Texel;
    if !misses_alpha && pipeline.stages.ends_with(&end) {
        pipeline.stages.truncate(pipeline.stages.len() - end.len());
        pipeline.stages.push(Stage::Joined(joined));
    }
}

fn color_source(pipeline: &Pipeline) -> Option<ColorSource> {
    let combine = &pipeline.state.color_combine;
    let unit = &combine.unit;
    if pipeline.passes_iterated {
        return Some(ColorSource::Iterated);
    }
    let texel = pipeline.units[0].as_ref().is_some_and(|plan| plan.texel_only || plan.multiplies);
    if !texel || combine.other != Other::Texture || !unit.scales() {
        return None;
    }
    match unit.factor {
        Factor::Zero if unit.one_minus => Some(ColorSource::Texel),
        Factor::Local if !unit.one_minus && combine.local == ColorLocal::Iterated => {
            Some(ColorSource::Product)
        }
        _ => None,
    }
}

fn alpha_source(pipeline: &Pipeline, color: ColorSource) -> Option<AlphaSource> {
    if !pipeline.reads_alpha || color == ColorSource::Iterated {
        return Some(AlphaSource::Color);
    }
    let AlphaCombine { other, local, unit } = &pipeline.state.alpha_combine;
    if unit.passes_local() {
        return match local {
            AlphaLocal::Iterated => Some(AlphaSource::Iterated),
            AlphaLocal::Constant => Some(AlphaSource::Constant0),
            AlphaLocal::Depth => None,
        };
    }
    if !unit.scales() {
        return None;
    }
    match (unit.factor, unit.one_minus, other) {
        (Factor::Zero, true, Other::Texture) => Some(AlphaSource::Texel),
        (Factor::Zero, true, Other::Iterated) => Some(AlphaSource::Iterated),
        (Factor::Zero, true, Other::Constant) => Some(AlphaSource::Constant1),
        (Factor::Local | Factor::LocalAlpha, false, Other::Texture)
            if color == ColorSource::Product && *local == AlphaLocal::Iterated =>
        {
            Some(AlphaSource::Color)
        }
        _ => None,
    }
}

/// Runs a joined end over a block; `LONG` where it is [`Joined::is_long`].
#[inline(always)]
pub(super) fn run_joined<S: Simd, const TEXEL: bool, const ITERATED: bool, const LONG: bool>(
    s: S,
    block: &mut Block,
    pass: &Pass<'_>,
    tile: &mut Tile<'_>,
) {
    let Some(Stage::Joined(joined)) = pass.pipeline.stages.last() else { return };
    let dithered = pass.pipeline.state.dither != Dither::Off;
    macro_rules! run {
        ($blend:literal, $dither:literal) => {
            fragments::<S, TEXEL, ITERATED, LONG, $blend, $dither>(s, block, pass, tile, joined)
        };
    }
    match (joined.blend, dithered) {
        (false, false) => run!(false, false),
        (false, true) => run!(false, true),
        (true, false) => run!(true, false),
        (true, true) => run!(true, true),
    }
}

#[inline(always)]
fn fragments<
    S: Simd,
    const TEXEL: bool,
    const ITERATED: bool,
    const LONG: bool,
    const BLEND: bool,
    const DITHER: bool,
>(
    s: S,
    block: &mut Block,
    pass: &Pass<'_>,
    tile: &mut Tile<'_>,
    joined: &Joined,
) {
    let ColorTile::Bits16(pixels, _) = &mut tile.color else { return };
    let fogged = LONG && joined.fog;
    let fog = FogColor::new(s, pass);
    for slot in 0..block.count {
        let live = (block.live >> (slot * STAMP)) as u32 & 0xffff;
        if live == 0 {
            continue;
        }
        let at = block.slots[slot].at as usize;
        let pixels = &mut pixels[at..][..STAMP];
        let aux = tile.aux.get(at..).unwrap_or(&[]);
        for j in (0..STAMP).step_by(S::LANES) {
            if S::ONE_BY_ONE && !any_live::<S>(live, j) {
                continue;
            }
            let before = colors::<S, TEXEL, ITERATED, LONG, BLEND>(s, block, pass, joined, slot, j);
            let mut color = before;
            if fogged {
                color = fog.mixed(s, before, s.load(&block.fog.0[slot * STAMP + j..]));
            }
            let aux = aux.get(j..).unwrap_or(&[]);
            let pixels = &mut pixels[j..];
            let color = finished::<S, BLEND, DITHER>(s, pass, [color, before], pixels, aux, j);
            s.store16(color, pixels, s.mask(live >> j));
        }
    }
    tile.counters.pixels_out += u64::from(block.live.count_ones());
}

/// Blends and dithers the colours of fragments `j..` of a stamp, to be written;
/// the colours before fog follow them, and the slices begin with their elements.
#[inline(always)]
fn finished<S: Simd, const BLEND: bool, const DITHER: bool>(
    s: S,
    pass: &Pass<'_>,
    colors: [[S::I; 2]; 2],
    pixels: &[u16],
    aux: &[u16],
    j: usize,
) -> S::I {
    let pipeline = pass.pipeline;
    let format = PixelFormat::Rgb565;
    let mut color = colors[0];
    if BLEND && let Some(config) = &pipeline.state.blend {
        let element = s.load16(pixels);
        color = blended::<S, false>(s, pass, config, format, colors, element, aux, j);
    }
    let dither = if DITHER { Some(s.load(&pipeline.dither[j..])) } else { None };
    pack(s, format, color, dither)
}

/// Draws a strip whose fragments get their iterated colours.
#[inline(always)]
pub(super) fn iterated_strip<S: Simd>(s: S, strip: &Strip, pass: &Pass<'_>, tile: &mut Tile<'_>) {
    let state = &pass.pipeline.state;
    let one_color = pass.triangle(&strip.first).narrow.has_one_color();
    match (state.blend.is_some(), state.dither != Dither::Off) {
        (false, false) if one_color => one_color_strip::<S, false>(s, strip, pass, tile),
        (false, true) if one_color => one_color_strip::<S, true>(s, strip, pass, tile),
        (false, false) => strip_fragments::<S, false, false>(s, strip, pass, tile),
        (false, true) => strip_fragments::<S, false, true>(s, strip, pass, tile),
        (true, false) => strip_fragments::<S, true, false>(s, strip, pass, tile),
        (true, true) => strip_fragments::<S, true, true>(s, strip, pass, tile),
    }
}

/// A strip of a triangle whose corners have one colour: every stamp is the same.
#[inline(always)]
fn one_color_strip<S: Simd, const DITHER: bool>(
    s: S,
    strip: &Strip,
    pass: &Pass<'_>,
    tile: &mut Tile<'_>,
) {
    let ColorTile::Bits16(pixels, _) = &mut tile.color else { return };
    copy_strip(s, &iterated_stamp::<S, DITHER>(s, pass, &strip.first), strip, pixels);
    tile.counters.pixels_out += strip.len();
}

/// The iterated colours of a stamp, as they are written without blending.
#[inline(always)]
fn iterated_stamp<S: Simd, const DITHER: bool>(s: S, pass: &Pass<'_>, at: &Slot) -> [u16; STAMP] {
    let (mut stamp, narrow) = ([0; STAMP], &pass.triangle(at).narrow);
    for j in (0..STAMP).step_by(S::LANES) {
        let color = iterated_colors::<S, false>(s, narrow, places(s, at.x, at.y, j));
        let color = finished::<S, false, DITHER>(s, pass, [color, color], &[], &[], j);
        s.store16_all(color, &mut stamp[j..]);
    }
    stamp
}

/// What a triangle of a state that [`Pipeline::replaces_tile`] leaves in every stamp;
/// `None` where its colours differ. `at` is one of its stamps.
#[inline(always)]
pub(crate) fn one_stamp<S: Simd>(s: S, pass: &Pass<'_>, at: &Slot) -> Option<[u16; STAMP]> {
    if pass.pipeline.flat.is_some() {
        return pass.pipeline.flat;
    }
    if !pass.triangle(at).narrow.has_one_color() {
        return None;
    }
    Some(match pass.pipeline.state.dither {
        Dither::Off => iterated_stamp::<S, false>(s, pass, at),
        _ => iterated_stamp::<S, true>(s, pass, at),
    })
}

#[inline(always)]
fn strip_fragments<S: Simd, const BLEND: bool, const DITHER: bool>(
    s: S,
    strip: &Strip,
    pass: &Pass<'_>,
    tile: &mut Tile<'_>,
) {
    let ColorTile::Bits16(pixels, _) = &mut tile.color else { return };
    let pixels = strip.elements(pixels);
    let (first, whole) = (&strip.first, strip.is_whole());
    let narrow = &pass.triangle(first).narrow;
    for j in (0..STAMP).step_by(S::LANES) {
        let mut colors = ColorIterators::new(s, narrow, places(s, first.x, first.y, j));
        for (i, (live, pixels)) in strip.live.iter().zip(&mut *pixels).enumerate() {
            let color = colors.colors::<BLEND>(s);
            colors.advance();
            let aux = tile.aux.get(first.at as usize + i * STAMP + j..).unwrap_or(&[]);
            let pixels = &mut pixels[j..];
            let color = finished::<S, BLEND, DITHER>(s, pass, [color, color], pixels, aux, j);
            if whole {
                s.store16_all(color, pixels);
            } else {
                s.store16(color, pixels, s.mask(u32::from(*live) >> j));
            }
        }
    }
    tile.counters.pixels_out += strip.len();
}

/// The colours of fragments `j..` of a slot; their alpha only where `ALPHA`.
#[inline(always)]
fn colors<S: Simd, const TEXEL: bool, const ITERATED: bool, const LONG: bool, const ALPHA: bool>(
    s: S,
    block: &Block,
    pass: &Pass<'_>,
    joined: &Joined,
    slot: usize,
    j: usize,
) -> [S::I; 2] {
    let zero = s.splat(0);
    let mut iterated = [zero; 2];
    if ITERATED {
        let at = &block.slots[slot];
        let narrow = &pass.triangle(at).narrow;
        iterated = iterated_colors::<S, ALPHA>(s, narrow, places(s, at.x, at.y, j));
    }
    if !TEXEL {
        return iterated;
    }
    let Some(plan) = &pass.pipeline.units[0] else { return iterated };
    let entries = plan.texture.entries();
    let k = slot * STAMP + j;
    let mut texel = if plan.point {
        texels::<S, true>(s, block, entries, k)
    } else {
        texels::<S, false>(s, block, entries, k)
    };
    if LONG && joined.chain {
        texel = multiplied_texels(s, block, plan, texel, k);
    }
    let mut color = texel;
    if ITERATED {
        let switches = &pass.pipeline.combine;
        color[0] = switches.scaled(s, 0, texel[0], iterated[0]);
        color[1] = switches.scaled(s, 1, texel[1], iterated[1]);
    }
    if !ALPHA {
        return color;
    }
    let pipeline = pass.pipeline;
    color[1] = match joined.alpha {
        AlphaSource::Color => color[1],
        AlphaSource::Texel => join_halves(s, color[1], texel[1]),
        AlphaSource::Iterated => join_halves(s, color[1], iterated[1]),
        AlphaSource::Constant0 => join_halves(s, color[1], s.splat(pipeline.color0.ga.0[0])),
        AlphaSource::Constant1 => join_halves(s, color[1], s.splat(pipeline.color1.ga.0[0])),
    };
    color
}
