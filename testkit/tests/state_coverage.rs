//! The random cases of the engine hold every value of every field of a draw
//! state, each many times where pixels were drawn.

use std::collections::BTreeMap;

use fillrate_engine::state::{
    Addend, AlphaEquation, AlphaLocal, AuxWrite, Axis, BlendFactor, Channels, ColorLocal,
    CombineUnit, Compare, DecalBase, DepthSource, Dither, DrawState, Factor, Filter, FogAmount,
    LogicOp, Origin, Other, PatternBits, TextureFactor, TextureUnit, ZOverflow,
};
use fillrate_testkit::random::{Command, case};

/// Seeds that are looked at: those that a normal run draws.
const SEEDS: u64 = 10_000;

/// Fewest states with each value.
const ENOUGH: u32 = 20;

type Seen = BTreeMap<String, u32>;

fn note(seen: &mut Seen, name: &str, value: &dyn std::fmt::Debug) {
    *seen.entry(format!("{name} {value:?}")).or_default() += 1;
}

/// The eleven functions of the API are shapes of a unit: what is scaled, what
/// is taken off and what is added.
fn note_unit<F: std::fmt::Debug>(seen: &mut Seen, name: &str, unit: &CombineUnit<F>) {
    let shape = (unit.zero_other, unit.subtract_local, unit.add);
    note(seen, &format!("{name} shape"), &shape);
    note(seen, &format!("{name} factor"), &(&unit.factor, unit.one_minus));
    note(seen, &format!("{name} invert"), &unit.invert);
}

fn note_texture_unit(seen: &mut Seen, index: usize, unit: &TextureUnit) {
    let name = |what: &str| format!("unit {index} {what}");
    note_unit(seen, &name("color"), &unit.combine.color);
    note_unit(seen, &name("alpha"), &unit.combine.alpha);
    note(seen, &name("filters"), &(unit.minify, unit.magnify));
    note(seen, &name("clamps"), &(unit.clamp_s, unit.clamp_t));
    note(seen, &name("levels"), &unit.odd_levels);
    note(seen, &name("trilinear"), &unit.trilinear);
    note(seen, &name("lod dither"), &unit.lod_dither);
    note(seen, &name("perspective"), &unit.perspective);
    note(seen, &name("clamp w"), &unit.clamp_negative_w);
    note(seen, &name("detail scale"), &unit.detail_scale);
    note(seen, &name("mixes levels"), &unit.mix_levels);
    note(seen, &name("drops keyed"), &unit.drop_keyed);
}

/// What no board of the SST-1's kind has.
fn note_extras(seen: &mut Seen, state: &DrawState) {
    note(seen, "decal", &state.shade.decal);
    note(seen, "overbright", &state.shade.overbright);
    note(seen, "specular", &state.shade.specular);
    note(seen, "plane mask", &(state.plane_mask != u32::MAX));
    note(seen, "channels", &(state.channels != Channels::ALL));
    if state.blend.is_none() {
        note(seen, "logic", &state.logic_op.map(LogicOp::table));
    }
    if let Some(pattern) = state.pattern {
        note(seen, "background", &pattern.background.is_some());
        note(seen, "area", &matches!(pattern.bits, PatternBits::Area(_)));
        if let PatternBits::Line { axis, backwards, .. } = pattern.bits {
            note(seen, "line", &(axis, backwards));
        }
    }
}

fn note_state(seen: &mut Seen, state: &DrawState) {
    note(seen, "origin", &state.origin);
    note(seen, "clip", &state.clip.is_some());
    note(seen, "stipple", &state.stipple.is_some());
    note(seen, "depth source", &state.depth.source);
    note(seen, "z overflow", &state.depth.z_overflow);
    note(seen, "depth test", &state.depth.test);
    note(seen, "depth bias", &state.depth.bias.is_some());
    note(seen, "depth constant", &state.depth.compare_constant.is_some());
    note(seen, "aux write", &state.aux_write);
    note(seen, "chroma key", &state.chroma_key.is_some());
    note(seen, "color other", &state.color_combine.other);
    note(seen, "color local", &state.color_combine.local);
    note_unit(seen, "color", &state.color_combine.unit);
    note(seen, "alpha other", &state.alpha_combine.other);
    note(seen, "alpha local", &state.alpha_combine.local);
    note_unit(seen, "alpha", &state.alpha_combine.unit);
    note(seen, "alpha test", &state.alpha_test.map(|test| test.compare));
    note(seen, "fog", &state.fog.map(|fog| fog.amount));
    if let Some(fog) = state.fog {
        note(seen, "fog drops", &(fog.drop_fog_color, fog.drop_fragment_color));
    }
    if let Some(blend) = state.blend {
        note(seen, "source", &blend.source);
        note(seen, "destination", &blend.destination);
        note(seen, "blend alpha", &(blend.source_alpha, blend.destination_alpha));
        note(seen, "alpha plane", &blend.alpha_plane);
        note(seen, "subtract dither", &blend.subtract_dither);
        note(seen, "alpha equation", &blend.alpha);
        note(seen, "constant destination", &blend.constant_destination.is_some());
    }
    note(seen, "dither", &state.dither);
    note(seen, "dither offset", &(state.dither_offset != [0; 2]));
    note_extras(seen, state);
    note(seen, "color write", &state.color_write);
    let units = state.units.iter().flatten();
    note(seen, "units", &units.clone().count());
    units.enumerate().for_each(|(index, unit)| note_texture_unit(seen, index, unit));
}

/// Texts of all values of a field.
struct Wanted(Vec<String>);

impl Wanted {
    fn all<T: std::fmt::Debug>(&mut self, name: &str, values: &[T]) {
        self.0.extend(values.iter().map(|value| format!("{name} {value:?}")));
    }

    fn pairs<A: std::fmt::Debug, B: std::fmt::Debug>(&mut self, name: &str, a: &[A], b: &[B]) {
        let pairs = a.iter().flat_map(|a| b.iter().map(move |b| format!("{name} {:?}", (a, b))));
        self.0.extend(pairs);
    }

    fn unit<F: std::fmt::Debug>(&mut self, name: &str, factors: &[F]) {
        for zero in BOTH {
            for minus in BOTH {
                for add in [Addend::Zero, Addend::Local, Addend::LocalAlpha] {
                    self.all(&format!("{name} shape"), &[(zero, minus, add)]);
                }
            }
        }
        self.pairs(&format!("{name} factor"), factors, &BOTH);
        self.all(&format!("{name} invert"), &BOTH);
    }
}

const BOTH: [bool; 2] = [false, true];

fn wanted() -> Vec<String> {
    use BlendFactor as B;
    let mut all = Wanted(Vec::new());
    let factors = [
        Factor::Zero,
        Factor::Local,
        Factor::OtherAlpha,
        Factor::LocalAlpha,
        Factor::TextureAlpha,
        Factor::TextureColor,
    ];
    let texture_factors = [
        TextureFactor::Zero,
        TextureFactor::Local,
        TextureFactor::OtherAlpha,
        TextureFactor::LocalAlpha,
        TextureFactor::Detail,
        TextureFactor::LodFraction,
    ];
    let common = [
        B::Zero,
        B::SourceAlpha,
        B::OtherColor,
        B::DestinationAlpha,
        B::One,
        B::OneMinusSourceAlpha,
        B::OneMinusOtherColor,
        B::OneMinusDestinationAlpha,
    ];
    let others = [Other::Iterated, Other::Texture, Other::Constant];
    let tests: Vec<Option<Compare>> =
        Compare::ALL.map(Some).into_iter().filter(|&c| c != Some(Compare::ALL[0])).collect();
    all.all("origin", &[Origin::UpperLeft, Origin::LowerLeft]);
    let sources = [DepthSource::Z, DepthSource::FloatW, DepthSource::DeepZ, DepthSource::DeepW];
    all.all("depth source", &sources);
    all.all("z overflow", &[ZOverflow::Wrap, ZOverflow::Clamp, ZOverflow::Reject]);
    all.all("depth test", &tests);
    all.all("depth test", &[None::<Compare>]);
    all.all("alpha test", &tests);
    all.all("alpha test", &[None::<Compare>]);
    all.all("aux write", &[AuxWrite::Nothing, AuxWrite::Depth, AuxWrite::Alpha]);
    all.all("color other", &others);
    all.all("alpha other", &others);
    let locals = [ColorLocal::Iterated, ColorLocal::Constant, ColorLocal::ByTextureAlpha];
    all.all("color local", &locals);
    all.all("alpha local", &[AlphaLocal::Iterated, AlphaLocal::Constant, AlphaLocal::Depth]);
    all.unit("color", &factors);
    all.unit("alpha", &factors);
    let amounts = [
        FogAmount::Table,
        FogAmount::IteratedAlpha,
        FogAmount::IteratedZ,
        FogAmount::Constant,
        FogAmount::Iterated,
        FogAmount::ByW,
    ];
    all.all("fog", &amounts.map(Some));
    all.pairs("fog drops", &BOTH, &BOTH);
    all.all("source", &common);
    all.all("source", &[B::AlphaSaturate, B::OneMinusAlphaSaturate]);
    all.all("destination", &common);
    all.all("destination", &[B::PrefogColor]);
    all.pairs("blend alpha", &BOTH, &BOTH);
    all.all("dither", &[Dither::Off, Dither::Ordered2x2, Dither::Ordered4x4]);
    let switches = [
        "clip",
        "stipple",
        "depth bias",
        "depth constant",
        "chroma key",
        "alpha plane",
        "constant destination",
        "dither offset",
        "overbright",
        "specular",
        "plane mask",
        "channels",
        "background",
        "area",
        "subtract dither",
        "color write",
    ];
    switches.iter().for_each(|name| all.all(name, &BOTH));
    let equations = [AlphaEquation::Switches, AlphaEquation::Factors, AlphaEquation::Union];
    all.all("alpha equation", &equations);
    all.all("decal", &[None, Some(DecalBase::Iterated), Some(DecalBase::Base)]);
    all.all("logic", &[None::<u8>]);
    all.all("logic", &core::array::from_fn::<_, 16, _>(|table| Some(table as u8)));
    all.all("line", &[(Axis::X, false), (Axis::X, true), (Axis::Y, false), (Axis::Y, true)]);
    all.all("units", &[0, 1, 2, 3]);
    for index in 0..3 {
        let name = |what: &str| format!("unit {index} {what}");
        all.unit(&name("color"), &texture_factors);
        all.unit(&name("alpha"), &texture_factors);
        let filters = [Filter::Point, Filter::Bilinear];
        all.pairs(&name("filters"), &filters, &filters);
        all.pairs(&name("clamps"), &BOTH, &BOTH);
        all.all(&name("levels"), &[None, Some(false), Some(true)]);
        let switches =
            ["mixes levels", "drops keyed", "trilinear", "lod dither", "perspective", "clamp w"];
        switches.iter().for_each(|what| all.all(&name(what), &BOTH));
        all.all(&name("detail scale"), &[0, 1, 2, 3, 4, 5, 6, 7]);
    }
    all.0
}

#[test]
fn random_cases_hold_every_state() {
    let mut seen = Seen::new();
    for seed in 1..=SEEDS {
        let drawn = case(seed);
        let mut surfaces = fillrate_testkit::canvas::ReferenceCanvas::new(drawn.surfaces());
        let mut current = None;
        for command in drawn.commands.iter().take(8) {
            let before = surfaces.reference.counters.pixels_out;
            command.draw(&mut surfaces);
            match command {
                Command::State { state, .. } => current = Some(**state),
                Command::Clear { .. } | Command::Pixels { .. } => {}
                // Counted once, where the first of its triangles is seen.
                _ if surfaces.reference.counters.pixels_out > before => {
                    current.take().iter().for_each(|state| note_state(&mut seen, state));
                }
                _ => {}
            }
        }
    }
    let missing: Vec<String> =
        wanted().into_iter().filter(|value| seen.get(value).is_none_or(|&n| n < ENOUGH)).collect();
    assert!(missing.is_empty(), "hardly ever drawn: {missing:?}");
}
