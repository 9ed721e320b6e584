//! Random draw states: every value of every field.

use fillrate_engine::state::{
    Addend, AlphaCombine, AlphaEquation, AlphaLocal, AlphaTest, AuxWrite, Axis, Blend, BlendFactor,
    Channels, ColorCombine, ColorLocal, CombineUnit, Compare, DecalBase, DepthSource, DepthState,
    Dither, DrawState, Factor, Filter, Fog, FogAmount, FogTable, LodRange, LogicOp, Origin, Other,
    Pattern, PatternBits, Rect, Shade, Stipple, TextureCombine, TextureFactor, TextureUnit,
    ZOverflow,
};

use super::Rng;
use super::texture::KEY_COLORS;

/// A draw state for a surface of `width` x `height`.
pub fn draw_state(rng: &mut Rng, width: u32, height: u32) -> DrawState {
    let state = any_state(rng, width, height);
    if rng.one_in(6) { common(rng, &state) } else { state }
}

/// What programs draw with most: iterated colours, a texel, a product of those or of
/// two texels; with fog by the table, blended, and written whole.
fn common(rng: &mut Rng, state: &DrawState) -> DrawState {
    let mut units = state.units;
    for unit in units.iter_mut().flatten() {
        (unit.mix_levels, unit.drop_keyed) = (false, false);
        unit.trilinear &= rng.one_in(4);
        let alphas = [TextureFactor::Local, TextureFactor::LocalAlpha];
        unit.combine = match rng.one_in(3) {
            true => replace(),
            false => TextureCombine {
                color: scale(TextureFactor::Local, rng.one_in(4)),
                alpha: scale(rng.pick(&alphas), rng.one_in(4)),
            },
        };
    }
    let mut fog = rng.maybe(2, fog);
    if let Some(fog) = &mut fog
        && !rng.one_in(4)
    {
        fog.amount = FogAmount::Table;
    }
    let whole = scale(Factor::Zero, true);
    let local = CombineUnit { zero_other: true, add: Addend::Local, ..CombineUnit::default() };
    let products = [scale(Factor::Local, false), scale(Factor::LocalAlpha, false)];
    DrawState {
        aux_write: rng.pick(&[AuxWrite::Nothing, AuxWrite::Depth]),
        units,
        chroma_key: None,
        color_combine: ColorCombine {
            other: rng.pick(&[Other::Texture, Other::Texture, Other::Iterated]),
            local: ColorLocal::Iterated,
            unit: rng.pick(&[whole, products[0]]),
        },
        alpha_combine: AlphaCombine {
            other: rng.pick(&OTHERS),
            local: rng.pick(&[AlphaLocal::Iterated, AlphaLocal::Iterated, AlphaLocal::Constant]),
            unit: rng.pick(&[whole, local, products[0], products[1]]),
        },
        alpha_test: rng.maybe(4, alpha_test),
        fog,
        blend: state.blend.map(|blend| Blend {
            alpha: AlphaEquation::Switches,
            constant_destination: None,
            ..blend
        }),
        color_write: true,
        pattern: None,
        shade: Shade::default(),
        logic_op: None,
        channels: Channels::ALL,
        plane_mask: u32::MAX,
        ..*state
    }
}

/// A unit that multiplies.
fn scale<F: Copy + Default>(factor: F, one_minus: bool) -> CombineUnit<F> {
    CombineUnit { factor, one_minus, ..CombineUnit::default() }
}

fn any_state(rng: &mut Rng, width: u32, height: u32) -> DrawState {
    DrawState {
        origin: rng.pick(&[Origin::UpperLeft, Origin::LowerLeft]),
        clip: rng.maybe(3, |rng| clip(rng, width, height)),
        stipple: rng.maybe(5, |rng| Stipple { pattern: rng.word() | rng.word() }),
        depth: depth(rng),
        aux_write: rng.pick(&[
            AuxWrite::Nothing,
            AuxWrite::Depth,
            AuxWrite::Depth,
            AuxWrite::Alpha,
        ]),
        units: units(rng),
        chroma_key: rng.maybe(5, |rng| rng.pick(&KEY_COLORS) | rng.word() & 0xff00_0000),
        color_combine: color_combine(rng),
        alpha_combine: alpha_combine(rng),
        color0: constant(rng),
        color1: constant(rng),
        alpha_test: rng.maybe(4, alpha_test),
        fog: rng.maybe(3, fog),
        fog_table: fog_table(rng),
        blend: rng.maybe(2, blend),
        dither: rng.pick(&[Dither::Off, Dither::Ordered2x2, Dither::Ordered4x4]),
        color_write: !rng.one_in(10),
        pattern: rng.maybe(6, pattern),
        shade: shade(rng),
        dither_offset: rng.pick(&[[0, 0], [0, 0], [1, 2], [3, 255]]),
        logic_op: rng.maybe(5, |rng| LogicOp::new(rng.word() as u8)),
        channels: channels(rng),
        plane_mask: if rng.one_in(8) { rng.word() } else { u32::MAX },
    }
}

fn pattern(rng: &mut Rng) -> Pattern {
    let bits = match rng.coin() {
        true => PatternBits::Area([(); 32].map(|()| rng.word() | rng.word())),
        false => PatternBits::Line {
            bits: rng.word() | rng.word(),
            length: if rng.one_in(8) { rng.word() as u8 } else { 1 + rng.below(32) as u8 },
            factor: rng.pick(&[0, 1, 1, 2, 3, 300]),
            axis: rng.pick(&[Axis::X, Axis::Y]),
            origin: if rng.one_in(8) { rng.word() as i32 } else { rng.range(-50, 50) },
            backwards: rng.coin(),
        },
    };
    Pattern { bits, background: rng.maybe(2, constant) }
}

/// Nothing mostly: what follows then reads the combine units' output.
fn shade(rng: &mut Rng) -> Shade {
    if rng.coin() {
        return Shade::default();
    }
    Shade {
        decal: rng.maybe(2, |rng| rng.pick(&[DecalBase::Iterated, DecalBase::Base])),
        overbright: rng.one_in(3),
        specular: rng.coin(),
    }
}

fn channels(rng: &mut Rng) -> Channels {
    if !rng.one_in(5) {
        return Channels::ALL;
    }
    let [red, green, blue, alpha] = [(); 4].map(|()| rng.coin());
    Channels { red, green, blue, alpha }
}

/// Windows inside, around, empty, and beyond the surface.
fn clip(rng: &mut Rng, width: u32, height: u32) -> Rect {
    if rng.one_in(12) {
        return Rect::new(rng.word(), rng.word(), rng.word(), rng.word());
    }
    let (x0, y0) = (rng.below(width), rng.below(height));
    let (x1, y1) = (rng.below(width + 40), rng.below(height + 40));
    match rng.below(8) {
        0 => Rect::new(x0, y0, x1, y1),
        1 => Rect::new(0, 0, u32::MAX, u32::MAX),
        _ => Rect::new(x0 / 2, y0 / 2, x1.max(x0 + 1), y1.max(y0 + 1)),
    }
}

fn compare(rng: &mut Rng) -> Compare {
    rng.pick(&Compare::ALL)
}

fn depth(rng: &mut Rng) -> DepthState {
    DepthState {
        source: match rng.below(12) {
            0 => rng.pick(&[DepthSource::DeepZ, DepthSource::DeepW]),
            1..=6 => DepthSource::Z,
            _ => DepthSource::FloatW,
        },
        test: rng.maybe(2, compare),
        bias: rng.maybe(4, |rng| match rng.coin() {
            true => rng.word() as i16,
            false => rng.range(-600, 600) as i16,
        }),
        compare_constant: rng.maybe(8, |rng| rng.word() as u16),
        z_overflow: rng.pick(&[
            ZOverflow::Wrap,
            ZOverflow::Wrap,
            ZOverflow::Clamp,
            ZOverflow::Reject,
        ]),
    }
}

/// An ARGB constant that often equals a key.
fn constant(rng: &mut Rng) -> u32 {
    match rng.coin() {
        true => rng.word(),
        false => rng.pick(&KEY_COLORS) | rng.word() & 0xff00_0000,
    }
}

fn combine_unit<F: Copy>(rng: &mut Rng, factors: &[F]) -> CombineUnit<F> {
    CombineUnit {
        zero_other: rng.one_in(4),
        subtract_local: rng.one_in(3),
        factor: rng.pick(factors),
        one_minus: rng.coin(),
        add: rng.pick(&[Addend::Zero, Addend::Local, Addend::LocalAlpha]),
        invert: rng.one_in(6),
    }
}

const FACTORS: [Factor; 6] = [
    Factor::Zero,
    Factor::Local,
    Factor::OtherAlpha,
    Factor::LocalAlpha,
    Factor::TextureAlpha,
    Factor::TextureColor,
];
const OTHERS: [Other; 3] = [Other::Iterated, Other::Texture, Other::Constant];

fn color_combine(rng: &mut Rng) -> ColorCombine {
    let locals = [ColorLocal::Iterated, ColorLocal::Constant, ColorLocal::ByTextureAlpha];
    ColorCombine {
        other: rng.pick(&OTHERS),
        local: rng.pick(&locals),
        unit: combine_unit(rng, &FACTORS),
    }
}

fn alpha_combine(rng: &mut Rng) -> AlphaCombine {
    let locals = [AlphaLocal::Iterated, AlphaLocal::Constant, AlphaLocal::Depth];
    AlphaCombine {
        other: rng.pick(&OTHERS),
        local: rng.pick(&locals),
        unit: combine_unit(rng, &FACTORS),
    }
}

fn alpha_test(rng: &mut Rng) -> AlphaTest {
    let reference = if rng.coin() { rng.word() as u8 } else { rng.pick(&[0, 1, 127, 128, 255]) };
    AlphaTest { compare: compare(rng), reference }
}

fn fog(rng: &mut Rng) -> Fog {
    Fog {
        amount: rng.pick(&[
            FogAmount::Table,
            FogAmount::Table,
            FogAmount::IteratedAlpha,
            FogAmount::IteratedZ,
            FogAmount::Constant,
            FogAmount::Iterated,
            FogAmount::Iterated,
            FogAmount::ByW,
        ]),
        color: constant(rng),
        drop_fog_color: rng.one_in(4),
        drop_fragment_color: rng.one_in(4),
    }
}

/// A rising table with the slopes of its steps, or noise.
fn fog_table(rng: &mut Rng) -> FogTable {
    let mut table = FogTable::default();
    if rng.one_in(4) {
        table.value = [(); 64].map(|()| rng.word() as u8);
        table.delta = [(); 64].map(|()| rng.word() as u8);
        return table;
    }
    let step = rng.below(8);
    for entry in 0..64u32 {
        table.value[entry as usize] = (entry * step).min(255) as u8;
        table.delta[entry as usize] = (step * 4) as u8;
    }
    table
}

fn blend(rng: &mut Rng) -> Blend {
    use BlendFactor as F;
    let common = [
        F::Zero,
        F::SourceAlpha,
        F::OtherColor,
        F::DestinationAlpha,
        F::One,
        F::OneMinusSourceAlpha,
        F::OneMinusOtherColor,
        F::OneMinusDestinationAlpha,
    ];
    Blend {
        source: match rng.below(12) {
            0 => F::AlphaSaturate,
            1 => F::OneMinusAlphaSaturate,
            _ => rng.pick(&common),
        },
        destination: if rng.one_in(9) { F::PrefogColor } else { rng.pick(&common) },
        source_alpha: rng.coin(),
        destination_alpha: rng.coin(),
        alpha_plane: rng.one_in(3),
        subtract_dither: rng.coin(),
        alpha: rng.pick(&[
            AlphaEquation::Switches,
            AlphaEquation::Switches,
            AlphaEquation::Factors,
            AlphaEquation::Union,
        ]),
        constant_destination: rng.maybe(5, constant),
    }
}

/// A chain of none to three units.
fn units(rng: &mut Rng) -> [Option<TextureUnit>; 3] {
    let count = rng.pick(&[0, 1, 1, 1, 2, 2, 3, 3]);
    [0, 1, 2].map(|index| if index < count { Some(unit(rng)) } else { None })
}

fn unit(rng: &mut Rng) -> TextureUnit {
    let filters = [Filter::Point, Filter::Bilinear];
    let factors = [
        TextureFactor::Zero,
        TextureFactor::Local,
        TextureFactor::OtherAlpha,
        TextureFactor::LocalAlpha,
        TextureFactor::Detail,
        TextureFactor::LodFraction,
    ];
    let combine = match rng.one_in(3) {
        true => replace(),
        false => TextureCombine {
            color: combine_unit(rng, &factors),
            alpha: combine_unit(rng, &factors),
        },
    };
    TextureUnit {
        perspective: !rng.one_in(4),
        clamp_negative_w: rng.coin(),
        minify: rng.pick(&filters),
        magnify: rng.pick(&filters),
        clamp_s: rng.coin(),
        clamp_t: rng.coin(),
        lod: lod(rng),
        lod_dither: rng.one_in(4),
        odd_levels: rng.maybe(5, Rng::coin),
        trilinear: rng.one_in(3),
        detail_max: rng.word() as u8,
        detail_bias: rng.range(-32, 31) as i8,
        detail_scale: rng.below(8) as u8,
        combine,
        mix_levels: rng.one_in(5),
        drop_keyed: rng.one_in(5),
    }
}

/// The texel alone.
fn replace() -> TextureCombine {
    let color = CombineUnit { zero_other: true, add: Addend::Local, ..CombineUnit::default() };
    TextureCombine { color, alpha: color }
}

fn lod(rng: &mut Rng) -> LodRange {
    let quarters = |rng: &mut Rng, most: u32| (rng.below(most + 1) << 6) as u16;
    match rng.below(8) {
        0 => LodRange { min: quarters(rng, 32), max: quarters(rng, 63), bias: 0 },
        1 => LodRange { min: rng.word() as u16, max: rng.word() as u16, bias: rng.word() as i16 },
        2 => {
            let same = quarters(rng, 32);
            LodRange { min: same, max: same, bias: 0 }
        }
        _ => LodRange {
            min: if rng.coin() { 0 } else { quarters(rng, 12) },
            max: if rng.coin() { rng.pick(&[0x800, 0xb00]) } else { quarters(rng, 44) },
            bias: (rng.range(-32, 31) << 6) as i16,
        },
    }
}
