//! Random states of the Glide front end, every enumerant among them: triangles
//! and frame buffer writes through it must leave what the reference leaves,
//! which is given the state in the engine's terms. Pixels that programs store
//! are taken apart here once more.
//!
//! `FILLRATE_CASES` sets how many states (1,200 without it), `FILLRATE_SEED` the
//! first.

use std::collections::BTreeMap;
use std::sync::Arc;

use fillrate_engine::state::{Dither, DrawState, Origin};
use fillrate_engine::{Cull, DeviceConfig, PixelFormat, PixelRun, TmuVertex, Vertex};
use fillrate_glide::gu::MipMap;
use fillrate_glide::{Call, Context, GlideConfig, GrTmuVertex, GrVertex};
use fillrate_testkit::Reference;
use fillrate_testkit::random::Rng;
use fillrate_testkit::reference::pack;

const WIDTH: u32 = 320;
const HEIGHT: u32 = 200;

const FUNCTIONS: [i32; 11] = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 0x10];
const FACTORS: [i32; 12] = [0, 1, 2, 3, 4, 5, 8, 9, 0xa, 0xb, 0xc, 0xd];
const BLENDS: [i32; 9] = [0, 1, 2, 3, 4, 5, 6, 7, 0xf];
const FORMATS: [i32; 13] = [0, 1, 2, 3, 4, 5, 8, 9, 10, 11, 12, 13, 14];
const WRITE_MODES: [i32; 9] = [0, 1, 2, 4, 5, 0xc, 0xd, 0xe, 0xf];

/// How often each enumerant was in force where pixels were drawn.
type Hits = BTreeMap<(&'static str, i32), u32>;

/// A board and the reference of its back and aux buffer.
struct Pair {
    context: Context,
    reference: Reference,
    /// The enumerants in force.
    current: BTreeMap<&'static str, i32>,
    hits: Hits,
}

/// An enumerant, noted under a name.
fn pick(pair: &mut Pair, rng: &mut Rng, name: &'static str, values: &[i32]) -> i32 {
    let value = rng.pick(values);
    pair.current.insert(name, value);
    value
}

impl Pair {
    fn new() -> Pair {
        let device = DeviceConfig { threads: 1, ..DeviceConfig::default() };
        let config = GlideConfig { device, ..GlideConfig::default() };
        let mut context = Context::new(config).expect("the default board is valid");
        context.execute(&Call::GrGlideInit {});
        let reference =
            Reference::new(WIDTH, HEIGHT, PixelFormat::Rgb565, Some(PixelFormat::Aux16));
        Pair { context, reference, current: BTreeMap::new(), hits: Hits::new() }
    }

    fn call(&mut self, call: &Call) -> u32 {
        self.context.execute(call)
    }

    fn open(&mut self, rng: &mut Rng) {
        self.current.clear();
        let color_format = pick(self, rng, "color format", &[0, 1, 2, 3]);
        let origin = pick(self, rng, "origin", &[0, 1]);
        self.call(&Call::GrSstWinClose {});
        let opened = self.call(&Call::GrSstWinOpen {
            window: 0,
            resolution: 0,
            refresh: 0,
            color_format,
            origin,
            colors: 2,
            aux: 1,
        });
        assert_eq!(opened, 1);
        self.call(&Call::GrSstResetPerfStats {});
        self.reference =
            Reference::new(WIDTH, HEIGHT, PixelFormat::Rgb565, Some(PixelFormat::Aux16));
    }

    /// The state in the engine's terms.
    fn state(&mut self) -> (DrawState, [Option<Arc<fillrate_engine::Texture>>; 3]) {
        self.context.draw_state().expect("the board is open")
    }

    /// Notes the enumerants of the state where drawing left a mark.
    fn note(&mut self, before: u64) {
        if self.reference.counters.pixels_out > before {
            for (&name, &value) in &self.current {
                *self.hits.entry((name, value)).or_default() += 1;
            }
        }
    }

    fn compare(&mut self, seed: u64) {
        let drawn = self.context.lfb_read_region(1, (0, 0), (WIDTH, HEIGHT)).expect("a buffer");
        let aux = self.context.lfb_read_region(2, (0, 0), (WIDTH, HEIGHT)).expect("a buffer");
        let place = |i: usize| (i % WIDTH as usize, i / WIDTH as usize);
        for (i, (&a, &b)) in drawn.iter().zip(&self.reference.color).enumerate() {
            assert_eq!(u32::from(a), b, "FILLRATE_SEED={seed}: {:?}, {:?}", place(i), self.current);
        }
        let expected = self.reference.aux.as_deref().expect("there is an aux buffer");
        for (i, (a, b)) in aux.iter().zip(expected).enumerate() {
            assert_eq!(
                u32::from(*a),
                *b,
                "FILLRATE_SEED={seed}: aux at {:?}, {:?}",
                place(i),
                self.current
            );
        }
        let counters = self.context.counters();
        assert_eq!(counters, self.reference.counters, "FILLRATE_SEED={seed}: {:?}", self.current);
    }
}

/// Sets everything there is to set.
fn set_state(pair: &mut Pair, rng: &mut Rng) {
    combine_units(pair, rng);
    pixel_state(pair, rng);
    for tmu in [0, 1] {
        texture(pair, rng, tmu);
    }
}

fn combine_units(pair: &mut Pair, rng: &mut Rng) {
    let function = pick(pair, rng, "color function", &FUNCTIONS);
    let factor = pick(pair, rng, "color factor", &FACTORS);
    let local = pick(pair, rng, "color local", &[0, 1]);
    let other = pick(pair, rng, "color other", &[0, 1, 1, 2]);
    let invert = pick(pair, rng, "color invert", &[0, 0, 1]);
    pair.call(&Call::GrColorCombine { function, factor, local, other, invert });
    let function = pick(pair, rng, "alpha function", &FUNCTIONS);
    let factor = pick(pair, rng, "alpha factor", &FACTORS);
    let local = pick(pair, rng, "alpha local", &[0, 1, 2]);
    let other = pick(pair, rng, "alpha other", &[0, 1, 2]);
    let invert = pick(pair, rng, "alpha invert", &[0, 0, 1]);
    pair.call(&Call::GrAlphaCombine { function, factor, local, other, invert });
    if rng.one_in(3) {
        let function =
            pick(pair, rng, "color preset", &std::array::from_fn::<i32, 17, _>(|i| i as i32));
        // The two that replace the iterated colour are left to C.
        if !matches!(function, 3 | 7) {
            pair.call(&Call::GuColorCombineFunction { function });
        }
        let mode = pick(pair, rng, "alpha preset", &[0, 1, 2, 3]);
        pair.call(&Call::GuAlphaSource { mode });
    }
    let enable = pick(pair, rng, "lighting by alpha", &[0, 0, 0, 1]);
    pair.call(&Call::GrAlphaControlsItrgbLighting { enable });
}

fn pixel_state(pair: &mut Pair, rng: &mut Rng) {
    let blending = rng.coin();
    let factors = [
        if blending { pick(pair, rng, "source factor", &BLENDS) } else { 4 },
        if blending { pick(pair, rng, "destination factor", &BLENDS) } else { 0 },
        pick(pair, rng, "alpha source factor", &[0, 4]),
        pick(pair, rng, "alpha destination factor", &[0, 4]),
    ];
    let [rgb_source, rgb_destination, alpha_source, alpha_destination] = factors;
    pair.call(&Call::GrAlphaBlendFunction {
        rgb_source,
        rgb_destination,
        alpha_source,
        alpha_destination,
    });
    let mode = pick(pair, rng, "depth mode", &[0, 0, 1, 2, 3, 4]);
    let (rgb, alpha) = (i32::from(!rng.one_in(8)), pick(pair, rng, "alpha mask", &[0, 1]));
    pair.call(&Call::GrDepthBufferMode { mode: 0 });
    pair.call(&Call::GrColorMask { rgb, alpha });
    pair.call(&Call::GrDepthBufferMode { mode });
    let function = pick(pair, rng, "depth function", &[0, 1, 2, 3, 4, 5, 6, 6, 7, 7, 7]);
    pair.call(&Call::GrDepthBufferFunction { function });
    if mode != 0 {
        let mask = pick(pair, rng, "depth mask", &[0, 1]);
        pair.call(&Call::GrDepthMask { mask });
    }
    let level = if rng.coin() { 0 } else { rng.word() as i16 };
    pair.call(&Call::GrDepthBiasLevel { level });
    let function = pick(pair, rng, "alpha test", &[0, 1, 2, 3, 4, 5, 6, 7, 7, 7, 7, 7]);
    pair.call(&Call::GrAlphaTestFunction { function });
    pair.call(&Call::GrAlphaTestReferenceValue { value: rng.word() as u8 });
    let mode = pick(pair, rng, "chroma key", &[0, 0, 1]);
    pair.call(&Call::GrChromakeyMode { mode });
    pair.call(&Call::GrChromakeyValue { value: rng.pick(&[0, 0x00ff_ffff, 0xff00_ff00]) });
    pair.call(&Call::GrConstantColorValue { value: rng.word() });
    let mode = pick(pair, rng, "dither", &[0, 1, 2]);
    pair.call(&Call::GrDitherMode { mode });
    fog(pair, rng);
    let mode = pick(pair, rng, "cull", &[0, 0, 1, 2]);
    pair.call(&Call::GrCullMode { mode });
    let (x, y) = (rng.below(100), rng.below(60));
    pair.call(&Call::GrClipWindow {
        x0: x,
        y0: y,
        x1: x + 60 + rng.below(300),
        y1: y + 60 + rng.below(200),
    });
}

fn fog(pair: &mut Pair, rng: &mut Rng) {
    let source = pick(pair, rng, "fog", &[0, 0, 1, 2, 3]);
    let flags = pick(pair, rng, "fog flags", &[0, 0, 0x100, 0x200, 0x300]);
    pair.call(&Call::GrFogMode { mode: source | flags });
    pair.call(&Call::GrFogColorValue { color: rng.word() });
    let step = rng.below(8) as u8;
    let table = core::array::from_fn(|i| (i as u8).wrapping_mul(step));
    pair.call(&Call::GrFogTable { table });
}

/// Names of what is noted of each unit.
const UNIT_NAMES: [[&str; 11]; 2] = [
    [
        "unit 0 format",
        "unit 0 aspect",
        "unit 0 levels",
        "unit 0 mip mapping",
        "unit 0 blend",
        "unit 0 minify",
        "unit 0 magnify",
        "unit 0 s clamp",
        "unit 0 t clamp",
        "unit 0 function",
        "unit 0 factor",
    ],
    [
        "unit 1 format",
        "unit 1 aspect",
        "unit 1 levels",
        "unit 1 mip mapping",
        "unit 1 blend",
        "unit 1 minify",
        "unit 1 magnify",
        "unit 1 s clamp",
        "unit 1 t clamp",
        "unit 1 function",
        "unit 1 factor",
    ],
];

fn texture(pair: &mut Pair, rng: &mut Rng, tmu: i32) {
    let names = UNIT_NAMES[tmu as usize];
    let format = pick(pair, rng, names[0], &FORMATS);
    let aspect = pick(pair, rng, names[1], &[0, 1, 2, 3, 4, 5, 6]);
    let even_odd = pick(pair, rng, names[2], &[1, 2, 3, 3, 3]);
    let mode = pick(pair, rng, names[3], &[0, 1, 2]);
    let blend = pick(pair, rng, names[4], &[0, 1]);
    let (minify, magnify) =
        (pick(pair, rng, names[5], &[0, 1]), pick(pair, rng, names[6], &[0, 1]));
    let (s, t) = (pick(pair, rng, names[7], &[0, 1]), pick(pair, rng, names[8], &[0, 1]));
    let large_lod = if rng.one_in(12) { 0 } else { 3 + rng.below(6) as i32 };
    let small_lod = large_lod + rng.below(9 - large_lod as u32) as i32;
    let colors: Vec<u32> = (0..256).map(|_| rng.word() & 0x00ff_ffff).collect();
    pair.call(&Call::GrTexDownloadTable { tmu, table: 2, first: 0, words: colors });
    let words: Vec<u32> = (0..12).map(|_| rng.word() & 0x7fff_ffff).collect();
    let table = pick(pair, rng, "compression table", &[0, 1]);
    pair.call(&Call::GrTexDownloadTable { tmu, table, first: 0, words });
    let id = pair.call(&Call::GuTexAllocateMemory {
        tmu,
        even_odd: even_odd as u8,
        width: 0,
        height: 0,
        format,
        mip_map_mode: mode,
        small_lod,
        large_lod,
        aspect,
        s_clamp: s,
        t_clamp: t,
        minify,
        magnify,
        lod_bias: 0.0,
        trilinear: blend,
    });
    let bytes = pair.context.mip_map(id).map_or(0, MipMap::all_bytes);
    let data: Vec<u8> = (0..bytes).map(|_| rng.word() as u8).collect();
    pair.call(&Call::GuTexDownloadMipMap { id, data: data.into(), table: None });
    let start = pair.context.mip_map(id).map_or(0, |mip_map| mip_map.start);
    let even_odd = even_odd as u32;
    pair.call(&Call::GrHints { hint: 3, mask: u32::from(rng.coin()) });
    pair.call(&Call::GrTexSource { tmu, start, even_odd, small_lod, large_lod, aspect, format });
    pair.call(&Call::GrTexNccTable { tmu, table });
    pair.call(&Call::GrTexClampMode { tmu, s, t });
    pair.call(&Call::GrTexFilterMode { tmu, minify, magnify });
    pair.call(&Call::GrTexMipMapMode { tmu, mode, blend });
    pair.call(&Call::GrTexLodBiasValue { tmu, bias: rng.float(-4.0, 4.0) });
    let (lod_bias, scale) = (rng.range(-32, 31), rng.below(8) as u8);
    pair.call(&Call::GrTexDetailControl { tmu, lod_bias, scale, max: rng.float(0.0, 1.0) });
    let rgb_function = pick(pair, rng, names[9], &FUNCTIONS);
    let rgb_factor = pick(pair, rng, names[10], &FACTORS);
    pair.call(&Call::GrTexCombine {
        tmu,
        rgb_function,
        rgb_factor,
        alpha_function: rng.pick(&FUNCTIONS),
        alpha_factor: rng.pick(&FACTORS),
        rgb_invert: i32::from(rng.one_in(4)),
        alpha_invert: i32::from(rng.one_in(4)),
    });
    if rng.one_in(4) {
        let function = pick(pair, rng, "texture preset", &[0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10]);
        pair.call(&Call::GrTexCombineFunction { tmu, function });
    }
}

/// A triangle with the same coordinates for every unit, so that none of the
/// rules for choosing among them matters.
fn corner(rng: &mut Rng) -> GrVertex {
    let oow = 1.0 / rng.float(1.0, 60.0);
    let (s, t) = (rng.float(-300.0, 600.0) * oow, rng.float(-300.0, 600.0) * oow);
    let tmu = GrTmuVertex { sow: s, tow: t, oow };
    GrVertex {
        x: rng.float(-10.0, 200.0),
        y: rng.float(-10.0, 150.0),
        z: 0.0,
        r: rng.float(0.0, 255.0),
        g: rng.float(0.0, 255.0),
        b: rng.float(0.0, 255.0),
        ooz: rng.float(0.0, 65535.0),
        a: rng.float(0.0, 255.0),
        oow,
        tmuvtx: [tmu; 2],
    }
}

fn draw_triangle(pair: &mut Pair, rng: &mut Rng) {
    let corners = [corner(rng), corner(rng), corner(rng)];
    let [a, b, c] = corners;
    pair.call(&Call::GrDrawTriangle { a, b, c });
    let vertices = corners.map(|v| {
        let tmu = TmuVertex { s: v.tmuvtx[0].sow, t: v.tmuvtx[0].tow, w: v.oow };
        Vertex { x: v.x, y: v.y, r: v.r, g: v.g, b: v.b, a: v.a, z: v.ooz, w: v.oow, tmu: [tmu; 3] }
    });
    let cull = [Cull::Disabled, Cull::Negative, Cull::Positive][pair.current["cull"] as usize];
    let (state, textures) = pair.state();
    let before = pair.reference.counters.pixels_out;
    pair.reference.triangle(&state, &textures, &vertices, cull);
    pair.note(before);
}

/// A stored pixel, taken apart by the databook's table: 8-bit colour, alpha,
/// depth, where the mode has them.
fn take_apart(mode: i32, format: i32, value: u32) -> (Option<[u32; 3]>, Option<u32>, Option<u32>) {
    let field = |low: u32, bits: u32| value >> low & ((1 << bits) - 1);
    let widen = |v: u32, bits: u32| v << (8 - bits) | v >> (2 * bits - 8);
    // Where the program's format keeps alpha in the low bits, colour is above.
    let up = if format >= 2 { 1 } else { 0 };
    let three = match mode {
        0 | 0xc => [widen(field(11, 5), 5), widen(field(5, 6), 6), widen(field(0, 5), 5)],
        1 | 2 | 0xd | 0xe => [10, 5, 0].map(|low| widen(field(low + up, 5), 5)),
        4 | 5 => [16, 8, 0].map(|low| field(low + 8 * up, 8)),
        _ => [0; 3],
    };
    let [r, g, b] = three;
    let color = (mode != 0xf).then_some(if matches!(format, 1 | 3) { [b, g, r] } else { three });
    let alpha = match mode {
        2 | 0xe => Some(255 * field(if up == 1 { 0 } else { 15 }, 1)),
        5 => Some(field(if up == 1 { 0 } else { 24 }, 8)),
        _ => None,
    };
    let depth = match mode {
        0xc..=0xe => Some(field(16, 16)),
        0xf => Some(field(0, 16)),
        _ => None,
    };
    (color, alpha, depth)
}

/// Locks in any mode, stores a few runs, draws, stores again, and unlocks; and
/// the same in the reference.
fn write_pixels(pair: &mut Pair, rng: &mut Rng) {
    let mode = pick(pair, rng, "write mode", &WRITE_MODES);
    let origin = pick(pair, rng, "write origin", &[0, 1]);
    let pipeline = pick(pair, rng, "write pipeline", &[0, 1]);
    let buffer = if mode == 0xf { 2 } else { 1 };
    let format = pick(pair, rng, "write color format", &[0, 1, 2, 3]);
    let (alpha, depth) = (rng.word() as u8, rng.word() as u16);
    pair.call(&Call::GrLfbWriteColorFormat { format });
    pair.call(&Call::GrLfbConstantAlpha { alpha });
    pair.call(&Call::GrLfbConstantDepth { depth });
    assert_eq!(pair.call(&Call::GrLfbLock { kind: 1, buffer, mode, origin, pipeline }), 1);
    let (state, _) = pair.state();
    let before = pair.reference.counters.pixels_out;
    let alpha_planes = pair.current.get("alpha mask") == Some(&1);
    let write = Write { state: &state, mode, format, origin, alpha, depth, alpha_planes };
    for _ in 0..3 {
        write.store_runs(pair, rng, pipeline == 1);
        draw_triangle(pair, rng);
        write.check_shown(pair, rng, pipeline == 1);
    }
    write.store_runs(pair, rng, pipeline == 1);
    assert_eq!(pair.call(&Call::GrLfbUnlock { kind: 1, buffer, written: None }), 1);
    if pipeline == 1 {
        pair.note(before);
    } else {
        // Such pixels are not counted; they always arrive.
        for name in ["write mode", "write origin", "write pipeline", "write color format"] {
            let value = pair.current[name];
            *pair.hits.entry((name, value)).or_default() += 1;
        }
    }
    let keys = ["write mode", "write origin", "write pipeline", "write color format"];
    pair.current.retain(|name, _| !keys.contains(name));
}

/// One write lock's settings.
struct Write<'a> {
    state: &'a DrawState,
    mode: i32,
    format: i32,
    origin: i32,
    alpha: u8,
    depth: u16,
    /// Whether the aux buffer holds alpha, which depth buffering does not change.
    alpha_planes: bool,
}

impl Write<'_> {
    /// A few runs of pixels of three rows.
    fn store_runs(&self, pair: &mut Pair, rng: &mut Rng, pipeline: bool) {
        let wide = matches!(self.mode, 4 | 5 | 0xc..=0xe);
        let mut rows: Vec<u32> = (0..3).map(|_| rng.below(HEIGHT)).collect();
        rows.sort_unstable();
        rows.dedup();
        for y in rows {
            let (x, count) = (rng.below(200), 1 + rng.below(60));
            let mut values = Vec::new();
            let words = pair.context.lfb_memory(1).expect("the lock is held");
            for x in x..x + count {
                let at = (y * 1024 + x) as usize;
                // Never what is there: where that is noise, a store of it
                // cannot be seen.
                let held = if wide { words[at] } else { words[at / 2] >> (16 * (at & 1)) & 0xffff };
                let random = if wide { rng.word() } else { rng.word() & 0xffff };
                let value = if random == held { held ^ 1 } else { random };
                if wide {
                    words[at] = value;
                } else {
                    let half = 16 * (at & 1);
                    words[at / 2] = words[at / 2] & !(0xffff << half) | value << half;
                }
                values.push(value);
            }
            if pipeline {
                self.through_pipeline(&mut pair.reference, x, y, &values);
            } else {
                self.past_pipeline(&mut pair.reference, x, y, &values);
            }
        }
    }

    /// A row of the buffer's own pixels in the memory of a lock.
    fn check_shown(&self, pair: &mut Pair, rng: &mut Rng, pipeline: bool) {
        let plain = self.mode == 0 && matches!(self.format, 0 | 2) || self.mode == 0xf;
        if !plain || pipeline {
            return;
        }
        // Stores elsewhere are still as they were stored, undithered.
        pair.call(&Call::GrSstIdle {});
        let y = rng.below(HEIGHT);
        let row = if self.origin == 1 { HEIGHT - 1 - y } else { y };
        let words = pair.context.lfb_memory(1).expect("the lock is held");
        for x in 0..WIDTH {
            let at = (y * 1024 + x) as usize;
            let element = (row * WIDTH + x) as usize;
            let expected = match self.mode {
                0xf => pair.reference.aux.as_ref().expect("an aux buffer")[element],
                _ => pair.reference.color[element],
            };
            assert_eq!(words[at / 2] >> (16 * (at & 1)) & 0xffff, expected, "column {x} of {y}");
        }
    }

    fn through_pipeline(&self, reference: &mut Reference, x: u32, y: u32, values: &[u32]) {
        let origin = if self.origin == 1 { Origin::LowerLeft } else { Origin::UpperLeft };
        let state = DrawState { origin, ..*self.state };
        let (mut colors, mut depths) = (Vec::new(), Vec::new());
        for &value in values {
            let (color, alpha, depth) = take_apart(self.mode, self.format, value);
            let rgb = color.map_or(state.color1 & 0x00ff_ffff, |[r, g, b]| r << 16 | g << 8 | b);
            colors.push(alpha.unwrap_or(u32::from(self.alpha)) << 24 | rgb);
            depths.push(depth.unwrap_or(u32::from(self.depth)) as u16);
        }
        reference.pixels(&state, &PixelRun { x, y, colors: &colors, depths: &depths });
    }

    /// Only reduced to the buffer's bits. Alpha lands in the aux buffer where
    /// that holds alpha, depth where it does not; ZA16 always.
    fn past_pipeline(&self, reference: &mut Reference, x: u32, y: u32, values: &[u32]) {
        let row = if self.origin == 1 { HEIGHT - 1 - y } else { y };
        let dither: Dither = self.state.dither;
        for (x, &value) in (x..).zip(values) {
            let at = (row * WIDTH + x) as usize;
            let (color, alpha, depth) = take_apart(self.mode, self.format, value);
            if let Some([r, g, b]) = color {
                let argb = r << 16 | g << 8 | b;
                reference.color[at] = pack(PixelFormat::Rgb565, argb, dither, x, row);
            }
            let aux = &mut reference.aux.as_mut().expect("there is an aux buffer")[at];
            match (self.mode == 0xf, self.alpha_planes, alpha, depth) {
                (true, _, _, Some(depth)) | (false, false, _, Some(depth)) => *aux = depth & 0xffff,
                (false, true, Some(alpha), _) => *aux = alpha & 0xffff,
                _ => {}
            }
        }
    }
}

/// Everything that must have been in force where something was drawn.
fn expected() -> Vec<(&'static str, Vec<i32>)> {
    let mut all: Vec<(&'static str, Vec<i32>)> = vec![
        ("color function", FUNCTIONS.into()),
        ("color factor", FACTORS.into()),
        ("color local", vec![0, 1]),
        ("color other", vec![0, 1, 2]),
        ("color invert", vec![0, 1]),
        ("color preset", (0..17).collect()),
        ("alpha function", FUNCTIONS.into()),
        ("alpha factor", FACTORS.into()),
        ("alpha local", vec![0, 1, 2]),
        ("alpha other", vec![0, 1, 2]),
        ("alpha invert", vec![0, 1]),
        ("alpha preset", (0..4).collect()),
        ("lighting by alpha", vec![0, 1]),
        ("source factor", BLENDS.into()),
        ("destination factor", BLENDS.into()),
        ("alpha source factor", vec![0, 4]),
        ("alpha destination factor", vec![0, 4]),
        ("depth mode", (0..5).collect()),
        ("depth function", (1..8).collect()),
        ("depth mask", vec![0, 1]),
        ("alpha mask", vec![0, 1]),
        ("alpha test", (1..8).collect()),
        ("chroma key", vec![0, 1]),
        ("dither", vec![0, 1, 2]),
        ("fog", (0..4).collect()),
        ("fog flags", vec![0, 0x100, 0x200, 0x300]),
        ("cull", vec![0, 1, 2]),
        ("origin", vec![0, 1]),
        ("color format", (0..4).collect()),
        ("compression table", vec![0, 1]),
        ("texture preset", (0..11).collect()),
        ("write mode", WRITE_MODES.into()),
        ("write origin", vec![0, 1]),
        ("write pipeline", vec![0, 1]),
        ("write color format", (0..4).collect()),
    ];
    for names in UNIT_NAMES {
        let values: [Vec<i32>; 11] = [
            FORMATS.into(),
            (0..7).collect(),
            vec![1, 2, 3],
            vec![0, 1, 2],
            vec![0, 1],
            vec![0, 1],
            vec![0, 1],
            vec![0, 1],
            vec![0, 1],
            FUNCTIONS.into(),
            FACTORS.into(),
        ];
        all.extend(names.into_iter().zip(values));
    }
    all
}

/// A number from the environment.
fn setting(name: &str, default: u64) -> u64 {
    std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(default)
}

#[test]
fn random_glide_states_equal_the_reference() {
    let (first, cases) = (setting("FILLRATE_SEED", 1), setting("FILLRATE_CASES", 1200));
    let mut pair = Pair::new();
    for seed in first..first + cases {
        let rng = &mut Rng::new(seed);
        pair.open(rng);
        for _ in 0..2 {
            set_state(&mut pair, rng);
            draw_triangle(&mut pair, rng);
            draw_triangle(&mut pair, rng);
            write_pixels(&mut pair, rng);
        }
        pair.compare(seed);
    }
    if cases < 1000 {
        return;
    }
    let never: Vec<(&str, i32)> = expected()
        .into_iter()
        .flat_map(|(name, values)| values.into_iter().map(move |value| (name, value)))
        .filter(|key| pair.hits.get(key).is_none_or(|&hits| hits < 3))
        .collect();
    assert!(never.is_empty(), "hardly ever in force: {never:?}");
}
