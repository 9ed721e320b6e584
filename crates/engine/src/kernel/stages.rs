//! Stages as functions of one level, and the loop over a list of them.

use fillrate_simd::{Kernel, MAX_LANES, Simd};

use super::block::{Block, Strip};
use super::joined::{self, ColorSource};
use super::pipeline::Stage;
use super::texture::{address, fetch, mix_next, texel_key, texture_combine};
use super::{
    Pass, Tile, alpha_test, chroma_key, combine, depth, fog, iterate, output, shade, stipple,
    wide_depth,
};

/// A stage at one level.
type StageFn<S> = fn(S, &mut Block, &Pass<'_>, &mut Tile<'_>);

/// The most stages of a pipeline: every one there is, with three texture units.
const MAX_STAGES: usize = 40;

/// The stages of a pipeline, at one level.
pub(crate) struct StageList<S: Simd> {
    stages: [StageFn<S>; MAX_STAGES],
    count: usize,
}

impl<S: Simd> StageList<S> {
    pub fn new() -> StageList<S> {
        StageList { stages: [stipple_stage; MAX_STAGES], count: 0 }
    }

    fn push(&mut self, stage: StageFn<S>) {
        self.stages[self.count] = stage;
        self.count += 1;
    }
}

/// Defines a stage function: a kernel of its own, so that it is compiled with
/// the level's instructions and called once for 64 fragments.
macro_rules! stage {
    ($name:ident, |$s:ident, $block:ident, $pass:ident, $tile:ident| $body:expr) => {
        fn $name<S: Simd>(s: S, block: &mut Block, pass: &Pass<'_>, tile: &mut Tile<'_>) {
            struct Body<'a, 'b, 'c, 'd, 'e>(&'a mut Block, &'b Pass<'c>, &'d mut Tile<'e>);
            impl Kernel for Body<'_, '_, '_, '_, '_> {
                type Output = ();
                #[inline(always)]
                fn run<S: Simd>(self, $s: S) {
                    let Body($block, $pass, $tile) = self;
                    $body
                }
            }
            s.vectorize(Body(block, pass, tile))
        }
    };
}

/// Draws a strip: the whole of a short stage list at one level.
pub(crate) type StripFn<S> = fn(S, &Strip, &Pass<'_>, &mut Tile<'_>);

/// Defines a strip function as [`stage`] defines a stage's.
macro_rules! strip {
    ($name:ident, $body:path) => {
        fn $name<S: Simd>(s: S, strip: &Strip, pass: &Pass<'_>, tile: &mut Tile<'_>) {
            struct Body<'a, 'b, 'c, 'd, 'e>(&'a Strip, &'b Pass<'c>, &'d mut Tile<'e>);
            impl Kernel for Body<'_, '_, '_, '_, '_> {
                type Output = ();
                #[inline(always)]
                fn run<S: Simd>(self, s: S) {
                    $body(s, self.0, self.1, self.2);
                }
            }
            s.vectorize(Body(strip, pass, tile))
        }
    };
}

strip!(iterated_strip, joined::iterated_strip);
strip!(flat_strip, output::flat_strip);

/// The function that draws strips by these stages, where there is one.
pub(crate) fn strip_function<S: Simd>(stages: &[Stage]) -> Option<StripFn<S>> {
    match stages {
        [Stage::Joined(end)] if end.is_iterated() => Some(iterated_strip),
        [Stage::Flat] => Some(flat_strip),
        _ => None,
    }
}

macro_rules! unit_stages {
    ($($address:ident $fetch:ident $key:ident $next:ident $mix:ident $combine:ident $index:literal)*) => {$(
        stage!($address, |s, block, pass, _tile| {
            if let Some(plan) = &pass.pipeline.units[$index] { address(s, block, pass, plan) }
        });
        stage!($fetch, |s, block, pass, _tile| {
            if let Some(plan) = &pass.pipeline.units[$index] { fetch(s, block, plan) }
        });
        stage!($key, |s, block, pass, tile| {
            if let Some(plan) = &pass.pipeline.units[$index] { texel_key(s, block, plan, tile) }
        });
        stage!($next, |s, block, pass, _tile| {
            let plan = pass.pipeline.units[$index].as_deref();
            if let Some(plan) = plan.and_then(|plan| plan.next.as_deref()) {
                address(s, block, pass, plan)
            }
        });
        stage!($mix, |s, block, pass, _tile| {
            if let Some(plan) = &pass.pipeline.units[$index] { mix_next(s, block, plan) }
        });
        stage!($combine, |s, block, pass, _tile| {
            if let Some(plan) = &pass.pipeline.units[$index] { texture_combine(s, block, plan) }
        });
    )*};
}

unit_stages! {
    address_0 fetch_0 texel_key_0 next_0 mix_0 texture_combine_0 0
    address_1 fetch_1 texel_key_1 next_1 mix_1 texture_combine_1 1
    address_2 fetch_2 texel_key_2 next_2 mix_2 texture_combine_2 2
}
stage!(depth_stage, |s, block, pass, tile| depth::depth(s, block, pass, tile));
stage!(keep_depth, |s, block, pass, _tile| depth::keep_depth(s, block, pass));
stage!(ready_depth, |s, block, pass, tile| depth::ready_depth(s, block, pass, tile));
stage!(wide_depth_stage, |s, block, pass, tile| {
    wide_depth::wide_depth::<S, false>(s, block, pass, tile)
});
stage!(ready_wide_depth, |s, block, pass, tile| {
    wide_depth::wide_depth::<S, true>(s, block, pass, tile)
});
stage!(iterate_colors, |s, block, pass, _tile| iterate::iterate_colors(s, block, pass));
stage!(chroma_key, |s, block, pass, tile| chroma_key::chroma_key(s, block, pass, tile));
stage!(combine, |s, block, pass, _tile| combine::combine(s, block, pass));
stage!(decal, |s, block, pass, _tile| shade::decal(s, block, pass));
stage!(overbright, |s, block, pass, _tile| shade::overbright(s, block, pass));
stage!(specular, |s, block, pass, _tile| shade::specular(s, block, pass));
stage!(background, |s, block, pass, _tile| shade::background(s, block, pass));
stage!(fog_by_part, |s, block, pass, _tile| fog::fog_by_part(s, block, pass));
stage!(blend_fully, |s, block, pass, tile| output::blend_fully(s, block, pass, tile));
stage!(write_bits, |s, block, pass, tile| output::write_bits(s, block, pass, tile));
stage!(alpha_test, |s, block, pass, tile| alpha_test::alpha_test(s, block, pass, tile));
stage!(fog, |s, block, pass, _tile| fog::fog(s, block, pass));
stage!(fog_amount, |s, block, pass, _tile| fog::fog_amount(s, block, pass));
stage!(depth_write, |s, block, _pass, tile| depth::depth_write(s, block, tile));
stage!(blend, |s, block, pass, tile| output::blend_stage(s, block, pass, tile));

macro_rules! ends {
    ($($name:ident $texel:literal $iterated:literal $long:literal)*) => {$(
        stage!($name, |s, block, pass, tile| {
            joined::run_joined::<S, $texel, $iterated, $long>(s, block, pass, tile)
        });
    )*};
}

ends! {
    iterated_end false true false
    texel_end true false false
    product_end true true false
    long_iterated_end false true true
    long_texel_end true false true
    long_product_end true true true
}
stage!(write_flat, |s, block, pass, tile| output::write_flat(s, block, pass, tile));
stage!(write, |s, block, pass, tile| output::write(s, block, pass, tile));

fn stipple_stage<S: Simd>(_: S, block: &mut Block, pass: &Pass<'_>, tile: &mut Tile<'_>) {
    stipple::stipple(block, pass, tile);
}

fn pattern_stage<S: Simd>(_: S, block: &mut Block, pass: &Pass<'_>, tile: &mut Tile<'_>) {
    stipple::pattern(block, pass, tile);
}

/// The functions of a pipeline's stages at level `S`. Long ends are joined only at the
/// widest: the narrower ones have half the registers for two to four times the vectors.
pub(crate) fn stage_list<S: Simd>(stages: &[Stage], out: &mut StageList<S>) {
    out.count = 0;
    for stage in stages {
        match stage {
            Stage::Joined(end) if end.is_long() && S::LANES < MAX_LANES => {
                end.stages().for_each(|stage| out.push(stage_function(&stage)));
            }
            stage => out.push(stage_function(stage)),
        }
    }
}

/// The function of a stage.
fn stage_function<S: Simd>(stage: &Stage) -> StageFn<S> {
    match stage {
        Stage::Stipple => stipple_stage,
        Stage::Pattern => pattern_stage,
        Stage::Depth => depth_stage,
        Stage::KeepDepth => keep_depth,
        Stage::ReadyDepth => ready_depth,
        Stage::WideDepth => wide_depth_stage,
        Stage::ReadyWideDepth => ready_wide_depth,
        Stage::Address(0) => address_0,
        Stage::Address(1) => address_1,
        Stage::Address(_) => address_2,
        Stage::Fetch(0) => fetch_0,
        Stage::Fetch(1) => fetch_1,
        Stage::Fetch(_) => fetch_2,
        Stage::TexelKey(0) => texel_key_0,
        Stage::TexelKey(1) => texel_key_1,
        Stage::TexelKey(_) => texel_key_2,
        Stage::AddressNext(0) => next_0,
        Stage::AddressNext(1) => next_1,
        Stage::AddressNext(_) => next_2,
        Stage::MixNext(0) => mix_0,
        Stage::MixNext(1) => mix_1,
        Stage::MixNext(_) => mix_2,
        Stage::TextureCombine(0) => texture_combine_0,
        Stage::TextureCombine(1) => texture_combine_1,
        Stage::TextureCombine(_) => texture_combine_2,
        Stage::IterateColors => iterate_colors,
        Stage::ChromaKey => chroma_key,
        Stage::Combine => combine,
        Stage::Decal => decal,
        Stage::Overbright => overbright,
        Stage::Specular => specular,
        Stage::Background => background,
        Stage::AlphaTest => alpha_test,
        Stage::Fog => fog,
        Stage::FogAmount => fog_amount,
        Stage::FogByPart => fog_by_part,
        Stage::DepthWrite => depth_write,
        Stage::Blend => blend,
        Stage::BlendFully => blend_fully,
        Stage::Write => write,
        Stage::WriteBits => write_bits,
        Stage::Flat => write_flat,
        Stage::Joined(end) => match (end.color, end.is_long()) {
            (ColorSource::Iterated, false) => iterated_end,
            (ColorSource::Texel, false) => texel_end,
            (ColorSource::Product, false) => product_end,
            (ColorSource::Iterated, true) => long_iterated_end,
            (ColorSource::Texel, true) => long_texel_end,
            (ColorSource::Product, true) => long_product_end,
        },
    }
}

/// Runs a block through the list, until no fragment is left, and empties it.
#[inline(always)]
pub(crate) fn run<S: Simd>(
    s: S,
    list: &StageList<S>,
    block: &mut Block,
    pass: &Pass<'_>,
    tile: &mut Tile<'_>,
) {
    for stage in &list.stages[..list.count] {
        if block.live == 0 {
            break;
        }
        stage(s, block, pass, tile);
    }
    block.count = 0;
    block.live = 0;
}
