//! A draw state compiled: the stages it needs and their constants.

use std::sync::Arc;

use fillrate_simd::Scalar;

use super::block::{Block, Colors, STAMP};
use super::combine::{Arithmetic, Switches};
use super::depth::{early, early_test};
use super::fog::{fog_entries, fog_samples};
use super::joined::{Joined, join_stages};
use super::lanes::dither_pattern;
use super::stages::{StageList, run, stage_list};
use super::texture::UnitPlan;
use super::{ColorTile, Pass, Tile};
use crate::setup::{ExtraNeeds, Triangles};
use crate::state::{
    Addend, AlphaEquation, AlphaLocal, AuxWrite, Blend, Channels, ColorLocal, CombineUnit, Compare,
    DecalBase, DepthSource, Dither, DrawState, Factor, Fog, FogAmount, LogicOp, MAX_TMUS, Other,
    Shade,
};
use crate::stats::Counters;
use crate::target::PixelFormat;
use crate::texture::{Texture, TextureDesc};

/// One stage of the list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Stage {
    Stipple,
    Pattern,
    Depth,
    /// z and w that are read after the test, which ran before; see
    /// [`Pipeline::early`].
    KeepDepth,
    /// The depth test on depths that are already there.
    ReadyDepth,
    /// Depth with a deep source or a 32-bit plane.
    WideDepth,
    /// The same on depths that are already there.
    ReadyWideDepth,
    Address(usize),
    Fetch(usize),
    TexelKey(usize),
    /// Addresses of the next coarser level.
    AddressNext(usize),
    /// Texels of the two levels mixed.
    MixNext(usize),
    TextureCombine(usize),
    IterateColors,
    ChromaKey,
    Combine,
    Decal,
    Overbright,
    Specular,
    /// The colour of a pattern's gaps.
    Background,
    AlphaTest,
    Fog,
    /// The amount of fog by the table, for [`Stage::Fog`].
    FogAmount,
    /// Fog by the part of the colour that stays.
    FogByPart,
    Blend,
    /// Blending with a constant destination or an equation for alpha.
    BlendFully,
    DepthWrite,
    Write,
    /// Writing with a logic operation or masks.
    WriteBits,
    /// The end of the list in one loop.
    Joined(Joined),
    /// One colour for all fragments; see [`Pipeline::flat`].
    Flat,
}

/// Which iterated values the stages read.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Needs {
    /// z is read after the depth test.
    pub keeps_z: bool,
    /// The pseudo-float w is read after the depth test.
    pub keeps_w: bool,
    /// Iterated colours, and with their alpha.
    pub colors: bool,
    pub alpha: bool,
    /// Fragments can be dropped after the depth test, or blending reads the
    /// aux plane, so depth is written at the end.
    pub late_depth_write: bool,
    /// The depth value is compared or written.
    pub depth: bool,
    /// Parameters besides.
    pub extra: ExtraNeeds,
}

/// A compiled draw state.
#[derive(Clone, Debug)]
pub(crate) struct Pipeline {
    pub state: DrawState,
    pub needs: Needs,
    /// The depth test that runs before the stages, one of
    /// [`super::depth::early`].
    pub early: u8,
    pub stages: Vec<Stage>,
    /// Stages read what others write into the tile, so a block must not hold a
    /// stamp twice.
    pub in_order: bool,
    pub units: [Option<Box<UnitPlan>>; MAX_TMUS],
    /// Texture units that iterate coordinates: the highest in use, plus one.
    pub unit_count: usize,
    pub combine: Switches,
    pub arithmetic: Arithmetic,
    /// Iterated colours are the fragments' colours; no combine stage runs.
    pub passes_iterated: bool,
    /// Something after the combine units reads alpha.
    pub reads_alpha: bool,
    pub color0: Colors,
    pub color1: Colors,
    pub zero: Colors,
    /// The fog table as the state's kind of fog reads it.
    pub fog_entries: [i32; 64],
    /// The colour of a pattern's gaps.
    pub background: Colors,
    /// The bits of elements that are written.
    pub write_mask: u32,
    /// The operation that joins elements with what is there.
    pub logic_op: Option<LogicOp>,
    pub dither: [i32; STAMP],
    /// The stamp that the pipeline draws, where every fragment gets the same
    /// colour, whatever its place and what was there before.
    pub flat: Option<[u16; STAMP]>,
    /// 15 less the 4x4 matrix: what dithering took, at most.
    pub undither: [i32; STAMP],
}

impl Pipeline {
    /// Compiles a state for a target of `format`, with or without an aux plane
    /// of a format.
    pub fn new(
        state: &DrawState,
        textures: &[Option<Arc<Texture>>; MAX_TMUS],
        format: PixelFormat,
        aux: Option<PixelFormat>,
    ) -> Pipeline {
        let mut state = *state;
        drop_aux(&mut state, aux);
        simplify(&mut state, format);
        // Depths are in the range that a bias limits them to.
        state.depth.bias = state.depth.bias.filter(|&bias| bias != 0);
        let reads_alpha = reads_alpha(&state, format);
        let needs = needs(&state, reads_alpha);
        let units = units(&state, textures);
        let passes_iterated = passes_iterated(&state, reads_alpha);
        let (color, alpha) = (&state.color_combine.unit, &state.alpha_combine.unit);
        let mut pipeline = Pipeline {
            stages: stages(&state, &needs, &units, passes_iterated, (format, aux)),
            passes_iterated,
            arithmetic: Arithmetic::of(color, alpha, reads_alpha),
            reads_alpha,
            needs,
            early: early::NONE,
            in_order: true,
            unit_count: units.iter().rposition(Option::is_some).map_or(0, |i| i + 1),
            units,
            combine: Switches::new(color, alpha),
            color0: Colors::splat(state.color0),
            color1: Colors::splat(state.color1),
            zero: Colors::splat(0),
            fog_entries: match state.fog {
                Some(Fog { amount: FogAmount::ByW, .. }) => fog_samples(&state.fog_table),
                _ => fog_entries(&state.fog_table),
            },
            background: background(&state),
            write_mask: write_mask(&state, format),
            logic_op: logic_op(&state),
            dither: dither_pattern(state.dither, state.dither_offset),
            flat: None,
            undither: dither_pattern(Dither::Ordered4x4, [0; 2]).map(|d| 0x000f_000f - d),
            state,
        };
        join_stages(&mut pipeline, format);
        flatten(&mut pipeline, format);
        pipeline.test_early();
        pipeline
    }

    /// Takes the depth test out of the stages where it can run before them.
    fn test_early(&mut self) {
        if self.stages.first() == Some(&Stage::Depth) {
            self.early = early_test(self);
            if self.early != early::NONE {
                self.stages[0] = Stage::KeepDepth;
                if !self.needs.keeps_z && !self.needs.keeps_w {
                    self.stages.remove(0);
                }
            }
        }
        let reads = [
            Stage::Depth,
            Stage::ReadyDepth,
            Stage::WideDepth,
            Stage::ReadyWideDepth,
            Stage::DepthWrite,
            Stage::Blend,
            Stage::BlendFully,
            Stage::WriteBits,
        ];
        // Levels that run the stages of a long end one by one blend before they write.
        self.in_order = self.stages.iter().any(|stage| match stage {
            Stage::Joined(end) => end.is_long() && end.blend,
            stage => reads.contains(stage),
        });
    }

    /// Whether a triangle of one colour that covers a tile replaces all its colours
    /// and changes nothing else.
    pub fn replaces_tile(&self) -> bool {
        let alone = match self.stages[..] {
            [Stage::Flat] => true,
            [Stage::Joined(end)] => end.is_iterated() && !end.blend,
            _ => false,
        };
        self.early == early::NONE && alone
    }

    /// Compiles the stages that ready-made fragments pass: no texturing, no
    /// combining, and a depth without bias.
    pub fn for_pixels(
        state: &DrawState,
        format: PixelFormat,
        aux: Option<PixelFormat>,
    ) -> Pipeline {
        let mut state = *state;
        state.depth.bias = None;
        state.units = [None; MAX_TMUS];
        state.color_combine.other = Other::Iterated;
        // Their colours are ready, and there is no triangle to iterate.
        state.shade = Shade::default();
        state.fog = state.fog.filter(|fog| fog.amount != FogAmount::Iterated);
        let mut pipeline = Pipeline::new(&state, &[const { None }; MAX_TMUS], format, aux);
        pipeline.stages = stages(
            &pipeline.state,
            &pipeline.needs,
            &pipeline.units,
            pipeline.passes_iterated,
            (format, aux),
        );
        (pipeline.early, pipeline.in_order) = (early::NONE, true);
        // It is in the block already.
        pipeline.needs.keeps_w = true;
        let made = [Stage::IterateColors, Stage::Combine];
        pipeline.stages.retain(|stage| !made.contains(stage));
        for stage in &mut pipeline.stages {
            match stage {
                Stage::Depth => *stage = Stage::ReadyDepth,
                Stage::WideDepth => *stage = Stage::ReadyWideDepth,
                _ => {}
            }
        }
        pipeline
    }

    /// The texture chain's output: `chain`, or zeros where texturing is off.
    pub fn texture_output<'a>(&'a self, chain: &'a Colors) -> &'a Colors {
        if self.unit_count > 0 { chain } else { &self.zero }
    }

    /// Whether fragments are dropped by their place, before any test.
    pub fn drops_by_place(&self) -> bool {
        self.state.stipple.is_some() || self.state.pattern.is_some_and(|pattern| pattern.drops())
    }

    /// Whether anything is written to the aux plane.
    pub fn writes_aux(&self) -> bool {
        self.state.aux_write != AuxWrite::Nothing
    }

    /// Whether depth is written, early or late.
    pub fn writes_depth(&self) -> bool {
        self.state.aux_write == AuxWrite::Depth
    }
}

/// Drops what an aux plane, or none, does not do.
fn drop_aux(state: &mut DrawState, aux: Option<PixelFormat>) {
    let wide = aux == Some(PixelFormat::Aux32);
    if aux.is_none() || state.depth.source.is_deep() && !wide {
        state.depth.test = None;
        if state.aux_write == AuxWrite::Depth {
            state.aux_write = AuxWrite::Nothing;
        }
    }
    if aux.is_none() || wide {
        if state.aux_write == AuxWrite::Alpha {
            state.aux_write = AuxWrite::Nothing;
        }
        if let Some(blend) = &mut state.blend {
            blend.alpha_plane = false;
        }
    }
}

/// Drops what changes nothing on a target of a format.
fn simplify(state: &mut DrawState, format: PixelFormat) {
    if !format.has_alpha()
        && state.aux_write != AuxWrite::Alpha
        && let Some(blend) = &mut state.blend
    {
        blend.alpha = AlphaEquation::Switches;
    }
}

/// The colour of a pattern's gaps.
fn background(state: &DrawState) -> Colors {
    Colors::splat(state.pattern.and_then(|pattern| pattern.background).unwrap_or(0))
}

/// The bits of elements that a state writes.
fn write_mask(state: &DrawState, format: PixelFormat) -> u32 {
    let channels = match state.channels {
        Channels::ALL => format.element_mask(),
        channels => format.channel_bits(channels),
    };
    channels & state.plane_mask
}

/// The logic operation of a state, unless it is none.
fn logic_op(state: &DrawState) -> Option<LogicOp> {
    state.logic_op.filter(|op| *op != LogicOp::SOURCE && state.blend.is_none())
}

/// Draws one stamp now, where combine and write need nothing of the fragments,
/// and replaces these stages by storing it.
fn flatten(pipeline: &mut Pipeline, format: PixelFormat) {
    let state = &pipeline.state;
    let ends = pipeline.stages.ends_with(&[Stage::Combine, Stage::Write]);
    let before = pipeline.stages.len().saturating_sub(2);
    let constant = ends
        && format.bytes() == 2
        && state.color_write
        && state.aux_write != AuxWrite::Alpha
        && !pipeline.needs.colors
        && !reads_texture(state)
        && state.alpha_combine.local != AlphaLocal::Depth;
    if !constant {
        return;
    }
    let mut stamp = [0; STAMP];
    draw_stamp(pipeline, before, format, &mut stamp);
    pipeline.flat = Some(stamp);
    pipeline.stages.truncate(before);
    pipeline.stages.push(Stage::Flat);
}

/// Runs the stages from `first` on over one whole stamp.
fn draw_stamp(pipeline: &Pipeline, first: usize, format: PixelFormat, to: &mut [u16; STAMP]) {
    let mut block = Block::new();
    (block.live, block.count) = (0xffff, 1);
    let mut list = StageList::<Scalar>::new();
    stage_list(&pipeline.stages[first..], &mut list);
    let triangles = Triangles::default();
    let mut counters = Counters::default();
    let pass = Pass { pipeline, triangles: &triangles };
    let color = ColorTile::Bits16(to, format);
    let mut tile = Tile { color, aux: &mut [], aux32: &mut [], counters: &mut counters };
    run(Scalar, &list, &mut block, &pass, &mut tile);
}

fn units(
    state: &DrawState,
    textures: &[Option<Arc<Texture>>; MAX_TMUS],
) -> [Option<Box<UnitPlan>>; MAX_TMUS] {
    let mut plans = [const { None }; MAX_TMUS];
    let mut has_other = false;
    for index in (0..MAX_TMUS).rev() {
        let Some(unit) = state.units[index] else { continue };
        let texture = textures[index].clone().unwrap_or_else(transparent_black);
        plans[index] = Some(Box::new(UnitPlan::new(index, unit, texture, has_other)));
        has_other = true;
    }
    plans
}

/// The texture of a unit that has none.
fn transparent_black() -> Arc<Texture> {
    let desc = TextureDesc { s_bits: 0, t_bits: 0, first: 0, last: 0, clamp_s: true };
    let texture = Texture::build(desc, |_, out| out.push(0));
    Arc::new(texture.expect("one texel is a valid texture"))
}

/// Whether anything reads the iterated colours or their alpha, and whether their
/// alpha.
fn reads_iterated(state: &DrawState, reads_alpha: bool) -> (bool, bool) {
    let (cc, ac) = (&state.color_combine, &state.alpha_combine);
    let (color, alpha) = (&cc.unit, &ac.unit);
    let color_other = !color.zero_other || state.chroma_key.is_some();
    let color_local =
        color.subtract_local || color.add == Addend::Local || color.factor == Factor::Local;
    let alpha_other = color.factor == Factor::OtherAlpha
        || reads_alpha && (!alpha.zero_other || alpha.factor == Factor::OtherAlpha);
    let alpha_local = color.factor == Factor::LocalAlpha
        || color.add == Addend::LocalAlpha
        || reads_alpha
            && (alpha.subtract_local
                || alpha.add != Addend::Zero
                || matches!(alpha.factor, Factor::Local | Factor::LocalAlpha));
    let alpha = alpha_other && ac.other == Other::Iterated
        || alpha_local && ac.local == AlphaLocal::Iterated
        || state.fog.is_some_and(|fog| fog.amount == FogAmount::IteratedAlpha);
    let color = color_other && cc.other == Other::Iterated
        || color_local && cc.local != ColorLocal::Constant;
    (color || alpha, alpha)
}

fn needs(state: &DrawState, reads_alpha: bool) -> Needs {
    let fog = |amount: FogAmount| state.fog.is_some_and(|fog| fog.amount == amount);
    let compares = state.depth.test.is_some_and(|test| test != Compare::Always);
    let z = &state.depth;
    let depth = compares || state.aux_write == AuxWrite::Depth;
    let (colors, alpha) = reads_iterated(state, reads_alpha);
    Needs {
        keeps_z: fog(FogAmount::IteratedZ) || state.alpha_combine.local == AlphaLocal::Depth,
        // The stage of amounts works w out itself, unless the test does.
        keeps_w: fog(FogAmount::Table) && depth && z.source == DepthSource::FloatW
            || fog(FogAmount::ByW),
        colors,
        alpha,
        late_depth_write: state.chroma_key.is_some()
            || drops_keyed(state)
            || state.alpha_test.is_some()
            || state.blend.is_some_and(|blend| blend.alpha_plane),
        depth,
        extra: ExtraNeeds {
            colors: state.shade.specular
                || state.shade.decal == Some(DecalBase::Base)
                || fog(FogAmount::Iterated),
            deep_z: depth && z.source == DepthSource::DeepZ,
        },
    }
}

/// Whether anything reads the texture chain's output.
fn reads_texture(state: &DrawState) -> bool {
    let (cc, ac) = (&state.color_combine, &state.alpha_combine);
    let texture_factor = |f: Factor| matches!(f, Factor::TextureAlpha | Factor::TextureColor);
    state.shade.decal.is_some()
        || cc.other == Other::Texture
        || ac.other == Other::Texture
        || cc.local == ColorLocal::ByTextureAlpha
        || texture_factor(cc.unit.factor)
        || texture_factor(ac.unit.factor)
}

/// Whether texels can drop fragments.
fn drops_keyed(state: &DrawState) -> bool {
    state.units.iter().flatten().any(|unit| unit.drop_keyed)
}

/// Whether anything after the combine units reads alpha.
fn reads_alpha(state: &DrawState, format: PixelFormat) -> bool {
    format.has_alpha()
        || state.alpha_test.is_some()
        || state.blend.is_some()
        || state.aux_write == AuxWrite::Alpha
}

/// Whether the fragments' colours are the iterated ones, and no other stage
/// reads those.
fn passes_iterated(state: &DrawState, reads_alpha: bool) -> bool {
    let (cc, ac) = (&state.color_combine, &state.alpha_combine);
    // Multiplied by one whole.
    let passes_other =
        |unit: &CombineUnit<Factor>| unit.scales() && unit.factor == Factor::Zero && unit.one_minus;
    let color = passes_other(&cc.unit) && cc.other == Other::Iterated
        || cc.unit.passes_local()
            && cc.unit.add == Addend::Local
            && cc.local == ColorLocal::Iterated;
    let alpha = passes_other(&ac.unit) && ac.other == Other::Iterated
        || ac.unit.passes_local() && ac.local == AlphaLocal::Iterated;
    let fogged = state.fog.is_some_and(|fog| fog.amount == FogAmount::IteratedAlpha);
    color && (alpha || !reads_alpha) && state.chroma_key.is_none() && !fogged
}

fn stages(
    state: &DrawState,
    needs: &Needs,
    units: &[Option<Box<UnitPlan>>; MAX_TMUS],
    passes_iterated: bool,
    (format, aux): (PixelFormat, Option<PixelFormat>),
) -> Vec<Stage> {
    let mut list = Vec::with_capacity(16);
    let mut add = |wanted: bool, stage: Stage| {
        if wanted {
            list.push(stage);
        }
    };
    add(state.stipple.is_some(), Stage::Stipple);
    add(state.pattern.is_some_and(|pattern| pattern.drops()), Stage::Pattern);
    let wide = state.depth.source.is_deep() || aux == Some(PixelFormat::Aux32);
    let depth = if wide { Stage::WideDepth } else { Stage::Depth };
    add(needs.depth || needs.keeps_z || needs.keeps_w || state.depth.rejects(), depth);
    let by_table = |fog: Fog| fog.amount == FogAmount::Table;
    add(state.fog.is_some_and(by_table), Stage::FogAmount);
    if reads_texture(state) || drops_keyed(state) {
        for (index, plan) in units.iter().enumerate().rev() {
            let Some(plan) = plan else { continue };
            add(true, Stage::Address(index));
            add(true, Stage::Fetch(index));
            add(plan.unit.drop_keyed, Stage::TexelKey(index));
            add(plan.next.is_some(), Stage::AddressNext(index));
            add(plan.next.is_some(), Stage::MixNext(index));
            add(!plan.texel_only, Stage::TextureCombine(index));
        }
    }
    add(needs.colors, Stage::IterateColors);
    add(state.chroma_key.is_some(), Stage::ChromaKey);
    add(!passes_iterated, Stage::Combine);
    add(state.shade.decal.is_some(), Stage::Decal);
    add(state.shade.overbright, Stage::Overbright);
    add(state.shade.specular, Stage::Specular);
    add(state.pattern.is_some_and(|pattern| !pattern.drops()), Stage::Background);
    add(state.alpha_test.is_some(), Stage::AlphaTest);
    let by_part = |fog: Fog| matches!(fog.amount, FogAmount::Iterated | FogAmount::ByW);
    add(
        state.fog.is_some(),
        if state.fog.is_some_and(by_part) { Stage::FogByPart } else { Stage::Fog },
    );
    let fully = |blend: Blend| {
        blend.alpha != AlphaEquation::Switches || blend.constant_destination.is_some()
    };
    add(
        state.blend.is_some(),
        if state.blend.is_some_and(fully) { Stage::BlendFully } else { Stage::Blend },
    );
    add(needs.late_depth_write && state.aux_write == AuxWrite::Depth, Stage::DepthWrite);
    let whole = write_mask(state, format) == format.element_mask() && logic_op(state).is_none();
    add(true, if whole { Stage::Write } else { Stage::WriteBits });
    list
}
