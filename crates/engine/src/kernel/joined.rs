//! The commonest ends of a stage list as one loop, so that a fragment's values
//! stay in registers from its first colour to the frame buffer.
//!
//! Nothing is computed here: the functions are those of the single stages, and
//! the list without joining draws the same pixels.

use fillrate_simd::{MaskLanes, Simd};

use super::block::{Block, STAMP};
use super::depth::{DepthLanes, DepthTest, IteratedZ};
use super::iterate::iterated_colors;
use super::lanes::{join as join_halves, places};
use super::output::{blended, pack};
use super::pipeline::{Pipeline, Stage};
use super::texture::texels;
use super::{ColorTile, Pass, Tile};
use crate::state::{
    AlphaCombine, AlphaLocal, AuxWrite, ColorLocal, DepthSource, Dither, Factor, Other,
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

/// A joined end of a stage list: colour, blend, write; with the depth test
/// first where nothing stands between.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Joined {
    pub depth: bool,
    pub color: ColorSource,
    pub alpha: AlphaSource,
    pub blend: bool,
}

/// Replaces the end of a pipeline's stage list where it can be joined.
pub(super) fn join_stages(pipeline: &mut Pipeline, format: PixelFormat) {
    let state = &pipeline.state;
    if format != PixelFormat::Rgb565 || !state.color_write || state.aux_write == AuxWrite::Alpha {
        return;
    }
    let Some(color) = color_source(pipeline) else { return };
    let Some(alpha) = alpha_source(pipeline, color) else { return };
    let blend = state.blend.is_some();
    let mut end: Vec<Stage> = match color {
        ColorSource::Iterated => vec![Stage::IterateColors],
        ColorSource::Texel => vec![Stage::Fetch(0), Stage::Combine],
        ColorSource::Product => vec![Stage::Fetch(0), Stage::IterateColors, Stage::Combine],
    };
    end.extend(blend.then_some(Stage::Blend));
    end.push(Stage::Write);
    if alpha == AlphaSource::Iterated && color == ColorSource::Texel
        || !pipeline.stages.ends_with(&end)
    {
        return;
    }
    let mut start = pipeline.stages.len() - end.len();
    let needs = &pipeline.needs;
    let depth = pipeline.stages[..start] == [Stage::Depth]
        && state.depth.source == DepthSource::Z
        && !needs.keeps_z
        && !needs.keeps_w
        && !needs.late_depth_write
        && color == ColorSource::Iterated;
    if depth {
        start = 0;
    }
    pipeline.stages.truncate(start);
    pipeline.stages.push(Stage::Joined(Joined { depth, color, alpha, blend }));
}

fn color_source(pipeline: &Pipeline) -> Option<ColorSource> {
    let combine = &pipeline.state.color_combine;
    let unit = &combine.unit;
    if pipeline.passes_iterated {
        return Some(ColorSource::Iterated);
    }
    let texel = pipeline.units[0].as_ref().is_some_and(|plan| plan.texel_only);
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

/// Runs a joined end over a block.
#[inline(always)]
pub(super) fn run_joined<S, const DEPTH: bool, const TEXEL: bool, const ITERATED: bool>(
    s: S,
    block: &mut Block,
    pass: &Pass<'_>,
    tile: &mut Tile<'_>,
) where
    S: Simd,
{
    let Some(Stage::Joined(joined)) = pass.pipeline.stages.last() else { return };
    let dithered = pass.pipeline.state.dither != Dither::Off;
    match (joined.blend, dithered) {
        (false, false) => {
            fragments::<S, DEPTH, TEXEL, ITERATED, false, false>(s, block, pass, tile, joined);
        }
        (false, true) => {
            fragments::<S, DEPTH, TEXEL, ITERATED, false, true>(s, block, pass, tile, joined);
        }
        (true, false) => {
            fragments::<S, DEPTH, TEXEL, ITERATED, true, false>(s, block, pass, tile, joined);
        }
        (true, true) => {
            fragments::<S, DEPTH, TEXEL, ITERATED, true, true>(s, block, pass, tile, joined);
        }
    }
}

#[inline(always)]
fn fragments<
    S: Simd,
    const DEPTH: bool,
    const TEXEL: bool,
    const ITERATED: bool,
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
    let pipeline = pass.pipeline;
    let test = DepthTest::new(pipeline);
    let before = block.live;
    for slot in 0..block.count {
        let at = block.slots[slot];
        let first = slot * STAMP;
        if DEPTH {
            let mut passed = 0;
            for j in (0..STAMP).step_by(S::LANES) {
                let value = test.biased(s, IteratedZ.lanes(s, pass, &at, j));
                let live = s.mask((before >> (first + j)) as u32);
                passed |= test.run(s, value, live, tile.aux, at.at as usize + j).bits() << j;
            }
            block.live &= !(0xffff << first) | u64::from(passed) << first;
        }
        let live = (block.live >> first) as u32 & 0xffff;
        if live == 0 {
            continue;
        }
        for j in (0..STAMP).step_by(S::LANES) {
            let place = at.at as usize + j;
            let mut color = colors::<S, TEXEL, ITERATED>(s, block, pass, joined.alpha, slot, j);
            if BLEND && let Some(config) = &pipeline.state.blend {
                let element = s.load16(&pixels[place..]);
                let aux = tile.aux.get(place..).unwrap_or(&[]);
                let format = PixelFormat::Rgb565;
                color = blended(s, pass, config, format, [color, color], element, aux, j);
            }
            let dither = if DITHER { Some(s.load(&pipeline.dither[j..])) } else { None };
            let packed = pack(s, PixelFormat::Rgb565, color, dither);
            s.store16(packed, &mut pixels[place..], s.mask(live >> j));
        }
    }
    tile.counters.depth_fail += u64::from((before & !block.live).count_ones());
    tile.counters.pixels_out += u64::from(block.live.count_ones());
}

/// The colours of fragments `j..` of a slot.
#[inline(always)]
fn colors<S: Simd, const TEXEL: bool, const ITERATED: bool>(
    s: S,
    block: &Block,
    pass: &Pass<'_>,
    alpha: AlphaSource,
    slot: usize,
    j: usize,
) -> [S::I; 2] {
    let zero = s.splat(0);
    let mut iterated = [zero; 2];
    if ITERATED {
        let at = &block.slots[slot];
        iterated = iterated_colors(s, &pass.triangle(at).narrow, places(s, at.x, at.y, j));
    }
    if !TEXEL {
        return iterated;
    }
    let Some(plan) = &pass.pipeline.units[0] else { return iterated };
    let entries = plan.texture.entries();
    let texel = if plan.point {
        texels::<S, true>(s, block, entries, slot * STAMP + j)
    } else {
        texels::<S, false>(s, block, entries, slot * STAMP + j)
    };
    let mut color = texel;
    if ITERATED {
        let switches = &pass.pipeline.combine;
        color[0] = switches.scaled(s, 0, texel[0], iterated[0]);
        color[1] = switches.scaled(s, 1, texel[1], iterated[1]);
    }
    let pipeline = pass.pipeline;
    color[1] = match alpha {
        AlphaSource::Color => color[1],
        AlphaSource::Texel => join_halves(s, color[1], texel[1]),
        AlphaSource::Iterated => join_halves(s, color[1], iterated[1]),
        AlphaSource::Constant0 => join_halves(s, color[1], s.splat(pipeline.color0.ga.0[0])),
        AlphaSource::Constant1 => join_halves(s, color[1], s.splat(pipeline.color1.ga.0[0])),
    };
    color
}
