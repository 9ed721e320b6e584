//! Registers to the engine's draw state.
//!
//! Source: SST1, register descriptions.

use fillrate_engine::DrawState;
use fillrate_engine::state::{
    Addend, AlphaCombine, AlphaLocal, AlphaTest, AuxWrite, Blend, BlendFactor, ColorCombine,
    ColorLocal, CombineUnit, Compare, DepthSource, DepthState, Dither, Factor, Filter, Fog,
    FogAmount, FogTable, LodRange, MAX_TMUS, Origin, Other, Rect, Stipple, TextureCombine,
    TextureFactor, TextureUnit,
};

use crate::registers::{
    FbiRegisters, TmuRegisters, alpha, color_path, fbz, fog, t_lod, texture_mode, unit,
};

/// The draw state that the registers describe.
pub(crate) fn draw_state(
    fbi: &FbiRegisters,
    units: &[TmuRegisters],
    fog_table: &FogTable,
) -> DrawState {
    let path = fbi.fbz_color_path;
    let on = |bit: u32| fbi.fbz_mode & bit != 0;
    let textured = path & color_path::TEXTURE_ENABLE != 0;
    DrawState {
        origin: if on(fbz::LOWER_LEFT) { Origin::LowerLeft } else { Origin::UpperLeft },
        clip: on(fbz::CLIP).then(|| clip(fbi)),
        stipple: (on(fbz::STIPPLE) && on(fbz::STIPPLE_PATTERN))
            .then_some(Stipple { pattern: fbi.stipple }),
        depth: depth(fbi),
        aux_write: match (on(fbz::AUX_WRITE), on(fbz::ALPHA_PLANES)) {
            (false, _) => AuxWrite::Nothing,
            (true, true) => AuxWrite::Alpha,
            (true, false) => AuxWrite::Depth,
        },
        units: if textured { chain(units) } else { [None; MAX_TMUS] },
        chroma_key: on(fbz::CHROMA_KEY).then_some(fbi.chroma_key & 0x00ff_ffff),
        color_combine: ColorCombine {
            other: other(path & 3),
            local: color_local(path),
            unit: combine_unit(path >> color_path::COLOR_UNIT, factor),
        },
        alpha_combine: AlphaCombine {
            other: other(path >> 2 & 3),
            local: match path >> 5 & 3 {
                0 => AlphaLocal::Iterated,
                1 => AlphaLocal::Constant,
                _ => AlphaLocal::Depth,
            },
            unit: combine_unit(path >> color_path::ALPHA_UNIT, factor),
        },
        color0: fbi.color0,
        color1: fbi.color1,
        alpha_test: (fbi.alpha_mode & alpha::TEST != 0).then(|| AlphaTest {
            compare: compare(fbi.alpha_mode >> 1),
            reference: (fbi.alpha_mode >> 24) as u8,
        }),
        fog: fog_state(fbi),
        fog_table: *fog_table,
        blend: blend(fbi),
        dither: match (on(fbz::DITHER), on(fbz::DITHER_2X2)) {
            (false, _) => Dither::Off,
            (true, true) => Dither::Ordered2x2,
            (true, false) => Dither::Ordered4x4,
        },
        color_write: on(fbz::RGB_WRITE),
        ..DrawState::default()
    }
}

fn clip(fbi: &FbiRegisters) -> Rect {
    let field = |register: u32, shift: u32| register >> shift & 0x3ff;
    Rect::new(
        field(fbi.clip_left_right, 16),
        field(fbi.clip_bottom_top, 16),
        field(fbi.clip_left_right, 0),
        field(fbi.clip_bottom_top, 0),
    )
}

fn compare(bits: u32) -> Compare {
    Compare::ALL[(bits & 7) as usize]
}

fn depth(fbi: &FbiRegisters) -> DepthState {
    let on = |bit: u32| fbi.fbz_mode & bit != 0;
    DepthState {
        source: if on(fbz::W_BUFFER) { DepthSource::FloatW } else { DepthSource::Z },
        test: on(fbz::DEPTH_ENABLE).then(|| compare(fbi.fbz_mode >> fbz::DEPTH_FUNCTION)),
        bias: on(fbz::DEPTH_BIAS).then_some(fbi.za_color as u16 as i16),
        compare_constant: on(fbz::COMPARE_CONSTANT).then_some(fbi.za_color as u16),
        ..DepthState::default()
    }
}

fn other(bits: u32) -> Other {
    match bits {
        0 => Other::Iterated,
        1 => Other::Texture,
        _ => Other::Constant,
    }
}

fn color_local(path: u32) -> ColorLocal {
    match (path & color_path::LOCAL_BY_TEXTURE_ALPHA != 0, path >> 4 & 1) {
        (true, _) => ColorLocal::ByTextureAlpha,
        (false, 0) => ColorLocal::Iterated,
        (false, _) => ColorLocal::Constant,
    }
}

fn factor(bits: u32) -> Factor {
    match bits {
        1 => Factor::Local,
        2 => Factor::OtherAlpha,
        3 => Factor::LocalAlpha,
        4 => Factor::TextureAlpha,
        5 => Factor::TextureColor,
        _ => Factor::Zero,
    }
}

fn texture_factor(bits: u32) -> TextureFactor {
    match bits {
        1 => TextureFactor::Local,
        2 => TextureFactor::OtherAlpha,
        3 => TextureFactor::LocalAlpha,
        4 => TextureFactor::Detail,
        5 => TextureFactor::LodFraction,
        _ => TextureFactor::Zero,
    }
}

/// The same where the fraction of the level counts as 0.
fn factor_without_fraction(bits: u32) -> TextureFactor {
    match texture_factor(bits) {
        TextureFactor::LodFraction => TextureFactor::Zero,
        other => other,
    }
}

/// Decodes the nine bits of a combine unit.
fn combine_unit<F>(bits: u32, factor: fn(u32) -> F) -> CombineUnit<F> {
    CombineUnit {
        zero_other: bits & unit::ZERO_OTHER != 0,
        subtract_local: bits & unit::SUB_LOCAL != 0,
        factor: factor(bits >> unit::SELECT_SHIFT & 7),
        one_minus: bits & unit::REVERSE_BLEND == 0,
        add: match (bits & unit::ADD_LOCAL != 0, bits & unit::ADD_ALPHA != 0) {
            (true, _) => Addend::Local,
            (false, true) => Addend::LocalAlpha,
            (false, false) => Addend::Zero,
        },
        invert: bits & unit::INVERT != 0,
    }
}

fn fog_state(fbi: &FbiRegisters) -> Option<Fog> {
    let on = |bit: u32| fbi.fog_mode & bit != 0;
    on(fog::ENABLE).then(|| Fog {
        amount: match (on(fog::CONSTANT), on(fog::ITERATED_Z), on(fog::ITERATED_ALPHA)) {
            (true, _, _) => FogAmount::Constant,
            (_, true, _) => FogAmount::IteratedZ,
            (_, _, true) => FogAmount::IteratedAlpha,
            _ => FogAmount::Table,
        },
        color: fbi.fog_color & 0x00ff_ffff,
        drop_fog_color: on(fog::ADD),
        drop_fragment_color: on(fog::MULT),
    })
}

fn blend_factor(bits: u32, is_source: bool) -> BlendFactor {
    match bits & 15 {
        1 => BlendFactor::SourceAlpha,
        2 => BlendFactor::OtherColor,
        3 => BlendFactor::DestinationAlpha,
        4 => BlendFactor::One,
        5 => BlendFactor::OneMinusSourceAlpha,
        6 => BlendFactor::OneMinusOtherColor,
        7 => BlendFactor::OneMinusDestinationAlpha,
        15 if is_source => BlendFactor::AlphaSaturate,
        15 => BlendFactor::PrefogColor,
        _ => BlendFactor::Zero,
    }
}

fn blend(fbi: &FbiRegisters) -> Option<Blend> {
    let mode = fbi.alpha_mode;
    let on = |bit: u32| fbi.fbz_mode & bit != 0;
    (mode & alpha::BLEND != 0).then(|| Blend {
        source: blend_factor(mode >> 8, true),
        destination: blend_factor(mode >> 12, false),
        source_alpha: mode >> 16 & 15 == 4,
        destination_alpha: mode >> 20 & 15 == 4,
        alpha_plane: on(fbz::ALPHA_PLANES),
        subtract_dither: on(fbz::SUBTRACT_DITHER) && on(fbz::DITHER),
        ..Blend::default()
    })
}

/// Whether a unit's texel reaches its output.
pub(crate) fn uses_texel(registers: &TmuRegisters) -> bool {
    let uses = |bits: u32| {
        let select = bits >> unit::SELECT_SHIFT & 7;
        let locals = unit::SUB_LOCAL | unit::ADD_LOCAL | unit::ADD_ALPHA;
        let factor = bits & unit::ZERO_OTHER == 0 && matches!(select, 1 | 3);
        bits & locals != 0 || factor
    };
    let mode = registers.texture_mode;
    uses(mode >> texture_mode::COLOR_UNIT) || uses(mode >> texture_mode::ALPHA_UNIT)
}

/// Whether a unit's output depends on the unit upstream.
pub(crate) fn uses_other(registers: &TmuRegisters) -> bool {
    let uses = |bits: u32| {
        let scales = bits & unit::ZERO_OTHER == 0 || bits & unit::SUB_LOCAL != 0;
        let zero = bits >> unit::SELECT_SHIFT & 7 == 0 && bits & unit::REVERSE_BLEND != 0;
        let alpha = bits >> unit::SELECT_SHIFT & 7 == 2;
        (bits & unit::ZERO_OTHER == 0 && !zero) || (scales && alpha)
    };
    let mode = registers.texture_mode;
    uses(mode >> texture_mode::COLOR_UNIT) || uses(mode >> texture_mode::ALPHA_UNIT)
}

/// The units from the first one up to the last whose output counts.
fn chain(units: &[TmuRegisters]) -> [Option<TextureUnit>; MAX_TMUS] {
    let mut chain = [None; MAX_TMUS];
    for (slot, registers) in chain.iter_mut().zip(units) {
        *slot = Some(texture_unit(registers));
        if !uses_other(registers) {
            break;
        }
    }
    chain
}

/// Level of detail of the smallest map a board has, one texel, 8 fraction bits.
const SMALLEST_LEVEL: u32 = 0x800;

/// Whether a unit that has all levels samples the even or the odd ones, as
/// filtering between levels in two passes needs it.
///
/// Source: G246, `grTexCombine`: for such a pass over a whole texture the library
/// sets the odd bit alone, and later releases did for two units at once.
pub(crate) fn has_parity(registers: &TmuRegisters) -> bool {
    let limits = [registers.t_lod & 63, registers.t_lod >> 6 & 63];
    registers.texture_mode & texture_mode::TRILINEAR != 0 && limits[0] != limits[1]
}

fn texture_unit(registers: &TmuRegisters) -> TextureUnit {
    let (mode, lod) = (registers.texture_mode, registers.t_lod);
    let on = |bit: u32| mode & bit != 0;
    let filter = |bit: u32| if on(bit) { Filter::Bilinear } else { Filter::Point };
    let signed6 = |bits: u32| ((bits << 2) as u8 as i8) >> 2;
    let factor = match lod & t_lod::ZERO_FRACTION {
        0 => texture_factor,
        _ => factor_without_fraction,
    };
    // Blended levels take turns even where a unit has all of them.
    let chooses = lod & t_lod::SPLIT != 0 || has_parity(registers);
    TextureUnit {
        perspective: on(texture_mode::PERSPECTIVE),
        clamp_negative_w: on(texture_mode::CLAMP_W),
        minify: filter(texture_mode::MINIFY_BILINEAR),
        magnify: filter(texture_mode::MAGNIFY_BILINEAR),
        clamp_s: on(texture_mode::CLAMP_S),
        clamp_t: on(texture_mode::CLAMP_T),
        lod: LodRange {
            min: ((lod & 63) << 6).min(SMALLEST_LEVEL) as u16,
            max: ((lod >> 6 & 63) << 6).min(SMALLEST_LEVEL) as u16,
            bias: i16::from(signed6(lod >> 12 & 63)) << 6,
        },
        lod_dither: on(texture_mode::LOD_DITHER),
        odd_levels: chooses.then_some(lod & t_lod::ODD != 0),
        trilinear: on(texture_mode::TRILINEAR),
        detail_max: registers.t_detail as u8,
        detail_bias: signed6(registers.t_detail >> 8 & 63),
        detail_scale: (registers.t_detail >> 14 & 7) as u8,
        combine: TextureCombine {
            color: combine_unit(mode >> texture_mode::COLOR_UNIT, factor),
            alpha: combine_unit(mode >> texture_mode::ALPHA_UNIT, factor),
        },
        ..TextureUnit::default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::combine::{Channel, texture_preset, unit_bits};

    fn unit(preset: i32) -> TmuRegisters {
        let (function, factor, invert) = texture_preset(preset).unwrap();
        let bits = |channel| unit_bits(function, factor, invert, channel).unwrap();
        TmuRegisters {
            texture_mode: bits(Channel::Color) << texture_mode::COLOR_UNIT
                | bits(Channel::Alpha) << texture_mode::ALPHA_UNIT,
            ..TmuRegisters::default()
        }
    }

    #[test]
    fn presets_use_what_their_names_say() {
        let uses = |preset| (uses_texel(&unit(preset)), uses_other(&unit(preset)));
        assert_eq!(uses(0), (false, false), "zero");
        assert_eq!(uses(1), (true, false), "decal");
        assert_eq!(uses(2), (false, true), "other");
        for preset in 3..=9 {
            assert_eq!(uses(preset), (true, true), "{preset}");
        }
    }

    #[test]
    fn a_fraction_of_zero_is_the_factor_zero() {
        let trilinear = unit(9);
        let zero = TmuRegisters { t_lod: t_lod::ZERO_FRACTION, ..trilinear };
        let factor = |registers| texture_unit(registers).combine.color.factor;
        assert_eq!(factor(&trilinear), TextureFactor::LodFraction);
        assert_eq!(factor(&zero), TextureFactor::Zero);
    }

    #[test]
    fn signed_fields() {
        let registers = TmuRegisters { t_lod: 0x3f << 12, t_detail: 0x20 << 8, ..unit(1) };
        let unit = texture_unit(&registers);
        assert_eq!(unit.lod.bias, -64);
        assert_eq!(unit.detail_bias, -32);
    }
}
