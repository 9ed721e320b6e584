//! State variables to the engine's draw state.
//!
//! Source: RAVE, pixel pipeline and enumerated values.

use fillrate_engine::state::{
    Addend, AlphaCombine, AlphaEquation, AlphaTest, AuxWrite, Axis, Blend, BlendFactor, Channels,
    ColorCombine, ColorLocal, CombineUnit, Compare, DecalBase, DepthSource, DepthState, Dither,
    Factor, Filter, Fog, FogAmount, FogTable, LodRange, MAX_TMUS, Other, Pattern, PatternBits,
    Rect, Shade, TextureCombine, TextureFactor, TextureUnit, ZOverflow,
};
use fillrate_engine::{DrawState, PixelFormat};

use crate::constants::{blend, channel, compare, multi_texture, quality, texture_op};
use crate::state::{GlFilters, Layer, State, unit_byte};
use crate::tags::{float, int};

/// The depth plane that a context compares with.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub(crate) enum Plane {
    /// None.
    #[default]
    None,
    /// z in 16 bits.
    Z16,
    /// z in 24 bits.
    Deep,
    /// 1/w as an ordered integer: nearer is larger.
    InverseW,
}

/// What a primitive gets its colour from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Paint {
    /// Its vertices.
    Gouraud,
    /// The texture.
    Texture,
    /// A bitmap, with the vertex's alpha.
    Bitmap,
}

/// Where fog's distance comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FogSource {
    /// No fog.
    None,
    /// A fragment's 1/w.
    Fragment,
    /// The vertices, which carry what stays of the colour.
    Vertices,
}

/// What a primitive adds to the state: primitives that agree in it share a draw
/// state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Variant {
    pub paint: Paint,
    /// Nothing of the destination is left.
    pub opaque: bool,
    /// A diffuse colour is above 1.
    pub bright: bool,
    pub fog: FogSource,
    pub pattern: PatternUse,
}

/// Which pattern a primitive is drawn through.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PatternUse {
    /// None.
    None,
    /// The area pattern, where it drops something.
    Area,
    /// The line pattern, counted along an axis.
    Line {
        /// Of the longer extent.
        axis: Axis,
        /// The first pixel.
        origin: i32,
        /// Counts against the axis.
        backwards: bool,
    },
}

/// What is known of a picture that is sampled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Sampled {
    /// Number of levels.
    pub levels: usize,
    /// Some texels are keyed.
    pub keyed: bool,
}

/// What a draw state depends on besides the variables.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Surroundings {
    /// Columns and rows of the context.
    pub size: (u32, u32),
    pub format: PixelFormat,
    /// The context does not say NoDither.
    pub dithers: bool,
    pub plane: Plane,
    /// The texture or bitmap, then the further layers, in order.
    pub sampled: [Option<Sampled>; MAX_TMUS],
}

/// The engine's state for primitives of a variant.
pub(crate) fn draw_state(
    state: &State,
    at: &Surroundings,
    variant: &Variant,
    fog_table: &FogTable,
) -> DrawState {
    let (color_combine, alpha_combine, shade) = combine(state, variant);
    DrawState {
        clip: scissor(state, at.size),
        depth: depth(state, at.plane),
        aux_write: if writes_depth(state, at.plane) { AuxWrite::Depth } else { AuxWrite::Nothing },
        units: units(state, at, variant),
        color_combine,
        alpha_combine,
        shade,
        color0: state.color(float::GL_TEXTURE_ENV_COLOR_A),
        alpha_test: alpha_test(state),
        fog: fog_state(state, variant.fog),
        fog_table: match variant.fog {
            FogSource::Fragment => *fog_table,
            _ => FogTable::default(),
        },
        blend: if variant.opaque { None } else { blending(state) },
        dither: if at.dithers && at.format.is_reduced() { Dither::Ordered4x4 } else { Dither::Off },
        color_write: state.int(int::GL_DRAW_BUFFER) & GL_BUFFERS != 0,
        channels: channels(state),
        pattern: pattern(state, variant.pattern),
        ..DrawState::default()
    }
}

/// OpenGL's draw buffers; without one, colours are not written.
const GL_BUFFERS: u32 = 15;

/// The scissor rectangle inside the context; `None`: all of it.
pub(crate) fn scissor(state: &State, (width, height): (u32, u32)) -> Option<Rect> {
    let side = |tag: u32, limit: u32| (state.int(tag) as i32).clamp(0, limit as i32) as u32;
    let rect = Rect::new(
        side(int::GL_SCISSOR_X_MIN, width),
        side(int::GL_SCISSOR_Y_MIN, height),
        side(int::GL_SCISSOR_X_MAX, width),
        side(int::GL_SCISSOR_Y_MAX, height),
    );
    (rect != Rect::new(0, 0, width, height)).then_some(rect)
}

/// `kQAZFunction`, or the reverse where nearer is larger. `None` tests nothing
/// and writes nothing.
fn compare_function(number: u32, plane: Plane) -> Option<Compare> {
    let function = match number {
        compare::LT => Compare::Less,
        compare::EQ => Compare::Equal,
        compare::LE => Compare::LessEqual,
        compare::GT => Compare::Greater,
        compare::NE => Compare::NotEqual,
        compare::GE => Compare::GreaterEqual,
        compare::TRUE => Compare::Always,
        compare::FALSE => Compare::Never,
        _ => return None,
    };
    Some(match (plane, function) {
        (Plane::InverseW, Compare::Less) => Compare::Greater,
        (Plane::InverseW, Compare::LessEqual) => Compare::GreaterEqual,
        (Plane::InverseW, Compare::Greater) => Compare::Less,
        (Plane::InverseW, Compare::GreaterEqual) => Compare::LessEqual,
        _ => function,
    })
}

fn depth(state: &State, plane: Plane) -> DepthState {
    let source = match plane {
        Plane::None | Plane::Z16 => DepthSource::Z,
        Plane::Deep => DepthSource::DeepZ,
        Plane::InverseW => DepthSource::DeepW,
    };
    let test = match plane {
        Plane::None => None,
        _ => compare_function(state.int(int::Z_FUNCTION), plane),
    };
    DepthState { source, test, z_overflow: ZOverflow::Clamp, ..DepthState::default() }
}

fn writes_depth(state: &State, plane: Plane) -> bool {
    plane != Plane::None
        && state.int(int::Z_FUNCTION) != compare::NONE
        && state.int(int::Z_BUFFER_MASK) != 0
}

fn alpha_test(state: &State) -> Option<AlphaTest> {
    let function = state.int(int::ALPHA_TEST_FUNC);
    let compare = compare_function(function, Plane::None)?;
    // As a vertex's alpha becomes a fragment's, so that equal ones are equal.
    let reference = state.float(float::ALPHA_TEST_REF).clamp(0.0, 1.0) * 255.0;
    let reference = ((reference * 4096.0 + 0.5) as u32 >> 12) as u8;
    (compare != Compare::Always).then_some(AlphaTest { compare, reference })
}

fn channels(state: &State) -> Channels {
    let on = |bit: u32| state.int(int::CHANNEL_MASK) & bit != 0;
    Channels {
        red: on(channel::RED),
        green: on(channel::GREEN),
        blue: on(channel::BLUE),
        alpha: on(channel::ALPHA),
    }
}

/// Whether a state replaces the destination where the fragment's alpha is 1.
pub(crate) fn opaque_alpha_replaces(state: &State) -> bool {
    state.int(int::BLEND) != blend::OPEN_GL
}

/// Whether a state replaces the destination whatever the alpha is.
pub(crate) fn always_replaces(state: &State) -> bool {
    state.int(int::BLEND) == blend::OPEN_GL
        && (state.int(int::GL_BLEND_SRC), state.int(int::GL_BLEND_DST)) == (1, 0)
}

fn blending(state: &State) -> Option<Blend> {
    let union = |source: BlendFactor| Blend {
        source,
        destination: BlendFactor::OneMinusSourceAlpha,
        alpha: AlphaEquation::Union,
        ..Blend::default()
    };
    match state.int(int::BLEND) {
        blend::PRE_MULTIPLY => Some(union(BlendFactor::One)),
        blend::INTERPOLATE => Some(union(BlendFactor::SourceAlpha)),
        _ if always_replaces(state) => None,
        _ => Some(Blend {
            source: gl_factor(state.int(int::GL_BLEND_SRC)),
            destination: gl_factor(state.int(int::GL_BLEND_DST)),
            alpha: AlphaEquation::Factors,
            ..Blend::default()
        }),
    }
}

/// OpenGL's numbers; the other operand's colour is what they name there.
fn gl_factor(number: u32) -> BlendFactor {
    match number {
        1 => BlendFactor::One,
        0x300 | 0x306 => BlendFactor::OtherColor,
        0x301 | 0x307 => BlendFactor::OneMinusOtherColor,
        0x302 => BlendFactor::SourceAlpha,
        0x303 => BlendFactor::OneMinusSourceAlpha,
        0x304 => BlendFactor::DestinationAlpha,
        0x305 => BlendFactor::OneMinusDestinationAlpha,
        0x308 => BlendFactor::AlphaSaturate,
        _ => BlendFactor::Zero,
    }
}

fn fog_state(state: &State, source: FogSource) -> Option<Fog> {
    let amount = match source {
        FogSource::None => return None,
        FogSource::Fragment => FogAmount::ByW,
        FogSource::Vertices => FogAmount::Iterated,
    };
    Some(Fog {
        amount,
        color: state.color(float::FOG_COLOR_A) & 0x00ff_ffff,
        drop_fog_color: false,
        drop_fragment_color: false,
    })
}

/// "Other" as it is.
const PASS_OTHER: CombineUnit<Factor> = CombineUnit {
    zero_other: false,
    subtract_local: false,
    factor: Factor::Zero,
    one_minus: true,
    add: Addend::Zero,
    invert: false,
};

/// "Local" as it is.
const PASS_LOCAL: CombineUnit<Factor> =
    CombineUnit { zero_other: true, one_minus: false, add: Addend::Local, ..PASS_OTHER };

/// "Other" times "local".
const PRODUCT: CombineUnit<Factor> =
    CombineUnit { factor: Factor::Local, one_minus: false, ..PASS_OTHER };

/// The combine units, and what follows them.
fn combine(state: &State, variant: &Variant) -> (ColorCombine, AlphaCombine, Shade) {
    let iterated = ColorCombine { unit: PASS_LOCAL, ..ColorCombine::default() };
    let iterated_alpha = AlphaCombine { unit: PASS_LOCAL, ..AlphaCombine::default() };
    let texel = ColorCombine { other: Other::Texture, unit: PASS_OTHER, ..iterated };
    let product_alpha = AlphaCombine { other: Other::Texture, unit: PRODUCT, ..iterated_alpha };
    match variant.paint {
        Paint::Gouraud => return (iterated, iterated_alpha, Shade::default()),
        Paint::Bitmap => return (texel, product_alpha, Shade::default()),
        Paint::Texture => {}
    }
    let op = state.int(int::TEXTURE_OP);
    let on = |bit: u32| op & bit != 0;
    let modulates = on(texture_op::MODULATE);
    let decal = on(texture_op::DECAL);
    let blends = on(texture_op::BLEND) && !decal;
    let shade = Shade {
        decal: decal.then_some(if modulates { DecalBase::Base } else { DecalBase::Iterated }),
        overbright: modulates && !blends && (decal || variant.bright),
        specular: on(texture_op::HIGHLIGHT),
    };
    let color = if blends {
        ColorCombine {
            other: Other::Iterated,
            local: ColorLocal::Constant,
            unit: CombineUnit {
                subtract_local: true,
                factor: Factor::TextureColor,
                one_minus: false,
                add: Addend::Local,
                ..PASS_OTHER
            },
        }
    } else if modulates && !decal && !variant.bright {
        ColorCombine { unit: PRODUCT, ..texel }
    } else {
        texel
    };
    (color, if decal { iterated_alpha } else { product_alpha }, shade)
}

/// The texture units: the last layer is nearest to the combine units, the
/// texture itself is the farthest.
fn units(state: &State, at: &Surroundings, variant: &Variant) -> [Option<TextureUnit>; MAX_TMUS] {
    let mut units = [None; MAX_TMUS];
    let Some(base) = at.sampled[0].filter(|_| variant.paint != Paint::Gouraud) else {
        return units;
    };
    let layers = match variant.paint {
        Paint::Texture => layer_count(at),
        _ => 0,
    };
    units[layers] = Some(match variant.paint {
        Paint::Bitmap => bitmap_unit(state, base),
        _ => base_unit(state, base),
    });
    for (layer, sampled) in at.sampled[1..=layers].iter().enumerate() {
        let Some(sampled) = sampled else { continue };
        units[layers - 1 - layer] = Some(layer_unit(&state.layers[layer], *sampled));
    }
    units
}

/// Layers in a row that have a texture.
pub(crate) fn layer_count(at: &Surroundings) -> usize {
    at.sampled[1..].iter().take_while(|sampled| sampled.is_some()).count()
}

/// Whether the texture's coordinates are limited to it, u and v.
pub(crate) fn clamps(state: &State) -> [bool; 2] {
    let shrinks = state.int(int::TEXTURE_OP) & texture_op::SHRINK != 0;
    [int::GL_TEXTURE_WRAP_U, int::GL_TEXTURE_WRAP_V].map(|tag| shrinks || state.int(tag) != 0)
}

fn base_unit(state: &State, sampled: Sampled) -> TextureUnit {
    let unit = sampler(
        state.int(int::TEXTURE_FILTER),
        state.float(float::MIPMAP_BIAS),
        clamps(state),
        sampled,
    );
    let tags = [int::GL_TEXTURE_MAG_FILTER, int::GL_TEXTURE_MIN_FILTER];
    with_gl_filters(unit, state.gl_filters, tags.map(|tag| state.int(tag)))
}

/// A unit with those of OpenGL's filters that count: the one that magnifies, and
/// the one that minifies.
fn with_gl_filters(mut unit: TextureUnit, counts: GlFilters, filters: [u32; 2]) -> TextureUnit {
    let [magnify, minify] =
        filters.map(|linear| if linear != 0 { Filter::Bilinear } else { Filter::Point });
    if counts.magnify {
        unit.magnify = magnify;
    }
    if counts.minify {
        unit.minify = minify;
    }
    unit
}

fn bitmap_unit(state: &State, sampled: Sampled) -> TextureUnit {
    let filter = match state.int(int::BITMAP_FILTER) {
        quality::FAST => quality::FAST,
        _ => quality::MID,
    };
    sampler(filter, 0.5, [true; 2], sampled)
}

/// A unit that samples by a filter and passes its texel on.
fn sampler(quality: u32, bias: f32, clamp: [bool; 2], sampled: Sampled) -> TextureUnit {
    let filter = if quality == quality::FAST { Filter::Point } else { Filter::Bilinear };
    let mix = quality >= quality::BEST && sampled.levels > 1;
    // Without mixing, the level is the integer part.
    let bias = if mix { bias - 0.5 } else { bias };
    let local = CombineUnit {
        zero_other: true,
        add: Addend::Local,
        ..CombineUnit::<TextureFactor>::default()
    };
    TextureUnit {
        perspective: true,
        clamp_negative_w: true,
        minify: filter,
        magnify: filter,
        clamp_s: clamp[0],
        clamp_t: clamp[1],
        lod: LodRange {
            min: 0,
            max: ((sampled.levels - 1) as u16) << 8,
            bias: (bias.clamp(-16.0, 16.0) * 256.0) as i16,
        },
        mix_levels: mix,
        drop_keyed: sampled.keyed,
        combine: TextureCombine { color: local, alpha: local },
        ..TextureUnit::default()
    }
}

/// A unit that joins its texel with what came from the layers before; alpha is
/// theirs.
fn layer_unit(layer: &Layer, sampled: Sampled) -> TextureUnit {
    let clamp = layer.wrap.map(|wrap| wrap != 0);
    let unit = sampler(layer.filter, layer.mipmap_bias, clamp, sampled);
    let mut unit = with_gl_filters(unit, layer.gl, layer.gl_filters);
    let pass = CombineUnit {
        zero_other: false,
        one_minus: true,
        ..CombineUnit::<TextureFactor>::default()
    };
    let mix = CombineUnit { subtract_local: true, add: Addend::Local, ..pass };
    unit.combine.alpha = pass;
    unit.combine.color = match layer.op {
        multi_texture::ADD => CombineUnit { add: Addend::Local, ..pass },
        multi_texture::MODULATE => {
            CombineUnit { factor: TextureFactor::Local, one_minus: false, ..pass }
        }
        multi_texture::BLEND_ALPHA => CombineUnit { factor: TextureFactor::LocalAlpha, ..mix },
        _ => CombineUnit { factor: TextureFactor::Detail, ..mix },
    };
    // The detail factor's limit is a constant where its bias is out of reach.
    unit.detail_max = unit_byte(layer.factor) as u8;
    (unit.detail_bias, unit.detail_scale) = (31, 7);
    unit
}

fn pattern(state: &State, used: PatternUse) -> Option<Pattern> {
    let bits = match used {
        PatternUse::None => return None,
        PatternUse::Area => {
            let rows = state.area_pattern();
            if rows.iter().all(|&row| row == u32::MAX) {
                return None;
            }
            PatternBits::Area(rows)
        }
        PatternUse::Line { axis, origin, backwards } => PatternBits::Line {
            bits: state.int(int::GL_LINE_PATTERN),
            length: 16,
            factor: state.int(int::GL_LINE_PATTERN_FACTOR) as u16,
            axis,
            origin,
            backwards,
        },
    };
    Some(Pattern { bits, background: None })
}

/// Whether the line pattern drops something.
pub(crate) fn has_line_pattern(state: &State) -> bool {
    state.int(int::GL_LINE_PATTERN) != 0xffff
}
