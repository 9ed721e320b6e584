//! From the registers to the engine's draw state.
//!
//! Source: RR, pixel pipeline.

use fillrate_engine::state::{
    Addend, AlphaCombine, AlphaEquation, AlphaTest, AuxWrite, Axis, Blend, BlendFactor,
    ColorCombine, CombineUnit, Compare, DepthSource, DepthState, Dither, DrawState, Factor, Filter,
    Fog, FogAmount, LogicOp, Other, Pattern, PatternBits, Rect, Shade, TextureCombine,
    TextureFactor, TextureUnit, ZOverflow,
};

use super::state::State;
use super::texture::Binding;
use crate::format::swap_red_blue;
use crate::opcode::Register;

/// How the source colour is made (`v_SrcFunc`).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum SourceFunction {
    NoTexture,
    Replace,
    Decal,
    Modulate,
}

impl SourceFunction {
    /// The state's function.
    pub fn of(state: &State) -> SourceFunction {
        match state.get(Register::SrcFunc) & 3 {
            1 => SourceFunction::Replace,
            2 => SourceFunction::Decal,
            3 => SourceFunction::Modulate,
            _ => SourceFunction::NoTexture,
        }
    }
}

/// A unit that passes "local" on.
fn local<F: Default>() -> CombineUnit<F> {
    CombineUnit { zero_other: true, add: Addend::Local, ..CombineUnit::default() }
}

/// A unit that passes "other" on.
fn other() -> CombineUnit<Factor> {
    CombineUnit { one_minus: true, ..CombineUnit::default() }
}

/// "other" times "local".
fn product() -> CombineUnit<Factor> {
    CombineUnit { factor: Factor::Local, ..CombineUnit::default() }
}

/// Sets the combine units of a source function. `coverage` makes alpha a
/// product with the iterated alpha where it would be the texture's alone.
pub(crate) fn source(draw: &mut DrawState, function: SourceFunction, coverage: bool) {
    let (color, alpha) = match function {
        SourceFunction::NoTexture => (local(), local()),
        SourceFunction::Replace if coverage => (other(), product()),
        SourceFunction::Replace => (other(), other()),
        SourceFunction::Modulate => (product(), product()),
        SourceFunction::Decal => {
            let mix = CombineUnit {
                subtract_local: true,
                factor: Factor::TextureAlpha,
                add: Addend::Local,
                ..CombineUnit::default()
            };
            (mix, local())
        }
    };
    draw.color_combine =
        ColorCombine { other: Other::Texture, unit: color, ..ColorCombine::default() };
    draw.alpha_combine =
        AlphaCombine { other: Other::Texture, unit: alpha, ..AlphaCombine::default() };
}

/// A texture unit that passes its texel on.
pub(crate) fn texture_unit(filter: Filter, perspective: bool, clamp: [bool; 2]) -> TextureUnit {
    let [clamp_s, clamp_t] = clamp;
    TextureUnit {
        perspective,
        minify: filter,
        magnify: filter,
        clamp_s,
        clamp_t,
        combine: TextureCombine {
            color: local::<TextureFactor>(),
            alpha: local::<TextureFactor>(),
        },
        drop_keyed: true,
        ..TextureUnit::default()
    }
}

/// The unit that samples a binding.
pub(crate) fn bound_unit(state: &State, binding: &Binding, perspective: bool) -> TextureUnit {
    let clamp = [binding.columns.clamps(), binding.rows.clamps()];
    let unit = texture_unit(filter(state), perspective, clamp);
    TextureUnit { drop_keyed: state.is_set(Register::ChromaKey), ..unit }
}

/// The source filter.
pub(crate) fn filter(state: &State) -> Filter {
    match state.is_set(Register::SrcFilter) {
        true => Filter::Bilinear,
        false => Filter::Point,
    }
}

/// A factor of the source (`destination` false) or the destination.
fn factor(code: u32, destination: bool) -> BlendFactor {
    match (code, destination) {
        (0, _) => BlendFactor::OtherColor,
        (1, _) => BlendFactor::OneMinusOtherColor,
        (2, _) => BlendFactor::SourceAlpha,
        (3, _) => BlendFactor::OneMinusSourceAlpha,
        (4, _) => BlendFactor::DestinationAlpha,
        (5, _) => BlendFactor::OneMinusDestinationAlpha,
        (7, _) => BlendFactor::One,
        (8, false) => BlendFactor::AlphaSaturate,
        (9, false) => BlendFactor::OneMinusAlphaSaturate,
        // 6, and codes that setters refuse.
        _ => BlendFactor::Zero,
    }
}

/// Blending as the state has it.
fn blend(state: &State) -> Blend {
    let constant = state.is_set(Register::DstRdDisable);
    Blend {
        source: factor(state.get(Register::BlendSrcFunc), false),
        destination: factor(state.get(Register::BlendDstFunc), true),
        alpha: AlphaEquation::Factors,
        constant_destination: constant.then(|| state.get(Register::DstColorArgb)),
        ..Blend::default()
    }
}

/// Source alpha over the destination: what antialiasing blends with where the
/// program blends not at all.
pub(crate) fn coverage_blend(state: &State) -> Blend {
    if state.is_set(Register::BlendEnable) {
        return blend(state);
    }
    let (source, destination) = (BlendFactor::SourceAlpha, BlendFactor::OneMinusSourceAlpha);
    Blend { source, destination, ..blend(state) }
}

/// Depth test and write; both off where neither can change a pixel.
fn depth(draw: &mut DrawState, state: &State) {
    let compare = match state.get(Register::ZBufMode) & 7 {
        0 => Compare::Always,
        mode => Compare::ALL[mode as usize],
    };
    let write = state.is_set(Register::ZBufWrMode);
    let z_overflow = match state.is_set(Register::ZScissor) {
        true => ZOverflow::Reject,
        false => ZOverflow::Clamp,
    };
    let test = (write || compare != Compare::Always).then_some(compare);
    draw.depth = DepthState { source: DepthSource::Z, z_overflow, test, ..DepthState::default() };
    draw.aux_write = if write { AuxWrite::Depth } else { AuxWrite::Nothing };
}

/// Whether the state needs a depth buffer.
pub(crate) fn uses_depth(state: &State) -> bool {
    state.is_set(Register::ZBufWrMode) || state.get(Register::ZBufMode) & 7 != 0
}

/// The pattern along x; bit 31 comes first.
fn pattern(state: &State) -> Pattern {
    let length = pattern_length(state);
    Pattern {
        bits: PatternBits::Line {
            bits: state.get(Register::Pat).reverse_bits(),
            length: length as u8,
            factor: 1,
            axis: Axis::X,
            origin: -((state.get(Register::PatOffset) % length) as i32),
            backwards: false,
        },
        background: pattern_background(state),
    }
}

/// Bits of the pattern that count, 1 to 32.
pub(crate) fn pattern_length(state: &State) -> u32 {
    (state.get(Register::PatLengthM1) & 31) + 1
}

/// Whether the pattern draws at a position.
pub(crate) fn pattern_draws(state: &State, position: u32) -> bool {
    let length = pattern_length(state);
    let offset = state.get(Register::PatOffset) % length;
    let bit = (position % length + offset) % length;
    state.get(Register::Pat) << bit >> 31 != 0
}

/// The colour of a pattern's zeros, if they are drawn.
pub(crate) fn pattern_background(state: &State) -> Option<u32> {
    state.is_set(Register::PatOpaque).then(|| state.get(Register::BgColorArgb))
}

/// The draw state without source function and texture.
pub(crate) fn draw_state(state: &State, has_specular: bool) -> DrawState {
    let mut draw = DrawState::default();
    let [left, right, top, bottom] = state.scissor();
    draw.clip = Some(Rect::new(left, top, right.max(left), bottom.max(top)));
    depth(&mut draw, state);
    if state.is_set(Register::TranspReject) {
        let reference = state.get(Register::AlphaThreshold) as u8;
        draw.alpha_test = Some(AlphaTest { compare: Compare::Greater, reference });
    }
    if state.is_set(Register::FogEnable) {
        draw.fog = Some(Fog {
            amount: FogAmount::Iterated,
            color: state.get(Register::FogColorRgb) & 0x00ff_ffff,
            drop_fog_color: false,
            drop_fragment_color: false,
        });
    }
    let specular = has_specular && state.is_set(Register::SpecularEnable);
    draw.shade = Shade { specular, ..Shade::default() };
    if state.is_set(Register::BlendEnable) {
        draw.blend = Some(blend(state));
    } else {
        let operation = LogicOp::new(state.get(Register::AluMode) as u8);
        draw.logic_op = (operation != LogicOp::SOURCE).then_some(operation);
    }
    if state.is_set(Register::DitherEnable) {
        let offset = state.get(Register::DitherOffset);
        draw.dither = Dither::Ordered4x4;
        draw.dither_offset = [offset as u8 & 3, (offset >> 4) as u8 & 3];
    }
    if state.is_set(Register::PatEnable) {
        draw.pattern = Some(pattern(state));
    }
    draw.plane_mask = plane_mask(state);
    draw
}

/// The plane mask as the engine's elements have their bits.
fn plane_mask(state: &State) -> u32 {
    let mask = state.get(Register::PMask);
    match state.destination_format() {
        Some(format) if mask & format.full_mask() == format.full_mask() => u32::MAX,
        Some(format) if state.is_set(Register::DstBgr) => swap_red_blue(format, mask),
        _ => mask,
    }
}
