//! The same triangles through RAVE and through Glide, in the same states.
//!
//! `cargo bench -p fillrate-rave --bench against_glide` prints both times of a frame
//! and how much longer RAVE takes: frames that are looked at one by one, drawn by
//! one thread, and frames in sequence, drawn behind the program by two. Rounds take
//! turns; the median of their ratios counts.

use std::time::Instant;

use fillrate_engine::DeviceConfig;
use fillrate_glide::{self as glide, GlideConfig, GrTmuVertex, GrVertex, gu};
use fillrate_rave::constants::{blend, compare, fog, quality, texture, texture_op, vertex_mode};
use fillrate_rave::tags::{float, int, pointer};
use fillrate_rave::{
    Call, Context, DeviceValue, DrawContextId, ImageValue, PixelType, RaveConfig, RaveRect,
    VGouraud, VTexture,
};

const WIDTH: u32 = 640;
const HEIGHT: u32 = 480;
/// Sides of the texture.
const TEXELS: u32 = 256;
const ROUNDS: usize = 15;

/// What fragments go through besides the depth test.
#[derive(Clone, Copy, Default)]
struct State {
    textured: bool,
    modulated: bool,
    fogged: bool,
    blended: bool,
    /// Each triangle is a call's value, in place of an array or a function's
    /// arguments.
    by_calls: bool,
}

/// How frames follow one another.
#[derive(Clone, Copy, PartialEq)]
enum Pace {
    /// Each is looked at, and drawn by one thread.
    OneByOne,
    /// All are drawn behind the program, by two threads.
    InSequence,
}

impl Pace {
    fn device(self) -> DeviceConfig {
        let threads = if self == Pace::OneByOne { 1 } else { 2 };
        DeviceConfig { threads, ..DeviceConfig::default() }
    }
}

/// A corner in both systems' terms.
#[derive(Clone, Copy)]
struct Corner {
    x: f32,
    y: f32,
    z: f32,
    inv_w: f32,
    color: [f32; 3],
    alpha: f32,
    u: f32,
    /// From the first row down.
    v: f32,
}

fn random(seed: &mut u32) -> f32 {
    *seed ^= *seed << 13;
    *seed ^= *seed >> 17;
    *seed ^= *seed << 5;
    (*seed >> 8) as f32 / 16_777_216.0
}

/// Triangles with legs of `side` pixels, spread over the screen, each nearer
/// than those before.
fn triangles(count: usize, side: f32) -> Vec<[Corner; 3]> {
    let mut seed = 12_345;
    let one = |i: usize| {
        let (left, top) =
            (random(&mut seed) * (WIDTH as f32 - side), random(&mut seed) * (HEIGHT as f32 - side));
        let z = 0.95 - 0.9 * i as f32 / count as f32;
        [(0.0, 0.0), (1.0, 0.1), (0.2, 1.0)].map(|(x, y)| Corner {
            x: left + x * side,
            y: top + y * side,
            z,
            inv_w: 0.2 + 0.6 * random(&mut seed),
            color: [random(&mut seed), random(&mut seed), random(&mut seed)],
            alpha: 0.3 + 0.5 * random(&mut seed),
            // Larger than its texels even where perspective shrinks it: the two have
            // different rules for levels.
            u: 0.2 * x * side / TEXELS as f32,
            v: 0.2 * y * side / TEXELS as f32,
        })
    };
    (0..count).map(one).collect()
}

/// Layers of the whole screen, each nearer than the one before.
fn layers(count: usize) -> Vec<[Corner; 3]> {
    let mut seed = 777;
    let mut layer = |i: usize| {
        let z = 0.9 - 0.08 * i as f32;
        let alpha = 0.6;
        let corners = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)].map(|(x, y)| Corner {
            x: x * WIDTH as f32,
            y: y * HEIGHT as f32,
            z: z - 0.05 * y,
            inv_w: 0.3 + 0.3 * y + 0.1 * x,
            color: [random(&mut seed), random(&mut seed), random(&mut seed)],
            alpha,
            u: 0.6 * x,
            v: 0.5 * y,
        });
        [[corners[0], corners[1], corners[2]], [corners[1], corners[3], corners[2]]]
    };
    (0..count).flat_map(&mut layer).collect()
}

/// 565 texels of a level.
fn texels(side: u32) -> Vec<u8> {
    let mut seed = 99 + side;
    (0..side * side).flat_map(|_| ((random(&mut seed) * 65_535.0) as u16).to_le_bytes()).collect()
}

trait Frame {
    fn frame(&mut self);
    /// Fragments written so far.
    fn pixels(&mut self) -> u64;
    /// What is shown, 565.
    fn picture(&mut self) -> Vec<u16>;
}

struct Rave {
    library: Context,
    context: u32,
    state: State,
    pace: Pace,
    vertices: Vec<VTexture>,
    /// The same for states without a texture.
    gouraud: Vec<VGouraud>,
}

impl Rave {
    fn new(triangles: &[[Corner; 3]], state: State, pace: Pace) -> Rave {
        let asynchronous = pace == Pace::InSequence;
        let config = RaveConfig { device: pace.device(), asynchronous, ..RaveConfig::default() };
        let mut library = Context::new(config);
        let pixel_type = PixelType::Rgb16_565.number();
        let (width, height) = (WIDTH as i32, HEIGHT as i32);
        let device =
            DeviceValue { device_type: 0, pixel_type, width, height, row_bytes: 2 * width };
        let rect = RaveRect::new(0, 0, width, height);
        let (scaled, clip, flags) = (None, None, fillrate_rave::constants::context::DOUBLE_BUFFER);
        let made = Call::DrawContextNew { engine: 1, device, rect, scaled, clip, flags };
        let context = library.execute(&made).created();
        let images = (0..9).map(|level| {
            let side = TEXELS >> level;
            ImageValue { width: side as i32, height: side as i32, pixels: texels(side).into() }
        });
        let (flags, images) = (texture::MIPMAP, images.collect());
        let made = Call::TextureNew { engine: 1, flags, pixel_type, images };
        let texture = library.execute(&made).created();
        library.execute(&Call::SetTexture { context, tag: pointer::TEXTURE, texture });
        for (tag, value) in [
            (int::Z_FUNCTION, compare::LE),
            (int::TEXTURE_FILTER, quality::MID),
            (int::TEXTURE_OP, if state.modulated { texture_op::MODULATE } else { 0 }),
            (int::BLEND, blend::INTERPOLATE),
            (int::Z_BUFFER_MASK, u32::from(!state.blended)),
            (int::FOG_MODE, if state.fogged { fog::EXPONENTIAL } else { fog::NONE }),
        ] {
            library.execute(&Call::SetInt { context, tag, value });
        }
        for (tag, value) in [
            (float::FOG_DENSITY, 0.35),
            (float::FOG_COLOR_R, 0.5),
            (float::FOG_COLOR_G, 0.6),
            (float::FOG_COLOR_B, 0.7),
        ] {
            library.execute(&Call::SetFloat { context, tag, value });
        }
        let vertex = |c: &Corner| VTexture {
            x: c.x,
            y: c.y,
            z: c.z,
            inv_w: c.inv_w,
            a: if state.blended { c.alpha } else { 1.0 },
            u_over_w: c.u * c.inv_w,
            v_over_w: (1.0 - c.v) * c.inv_w,
            kd_r: c.color[0],
            kd_g: c.color[1],
            kd_b: c.color[2],
            ..VTexture::default()
        };
        let vertices: Vec<VTexture> = triangles.iter().flatten().map(vertex).collect();
        let plain = |v: &VTexture| VGouraud {
            x: v.x,
            y: v.y,
            z: v.z,
            inv_w: v.inv_w,
            r: v.kd_r,
            g: v.kd_g,
            b: v.kd_b,
            a: v.a,
        };
        let gouraud =
            if state.textured { Vec::new() } else { vertices.iter().map(plain).collect() };
        Rave { library, context, state, pace, vertices, gouraud }
    }
}

impl Frame for Rave {
    fn frame(&mut self) {
        let (context, id) = (self.context, DrawContextId(self.context));
        self.library.execute(&Call::RenderStart { context, dirty: None, initial: 0 });
        if self.state.by_calls {
            for &[a, b, c] in self.vertices.as_chunks().0 {
                self.library.execute(&Call::DrawTriTexture { context, a, b, c, flags: 0 });
            }
        } else if self.gouraud.is_empty() {
            self.library.draw_v_texture(id, vertex_mode::TRI, &self.vertices);
        } else {
            self.library.draw_v_gouraud(id, vertex_mode::TRI, &self.gouraud);
        }
        self.library.execute(&Call::RenderEnd { context, modified: None });
        if self.pace == Pace::OneByOne {
            self.library.shown();
        }
    }

    fn pixels(&mut self) -> u64 {
        self.library.counters().pixels_out
    }

    fn picture(&mut self) -> Vec<u16> {
        let shown = self.library.shown().expect("a frame is shown");
        shown.pixels.as_chunks().0.iter().map(|&p| u16::from_le_bytes(p)).collect()
    }
}

struct Glide {
    library: glide::Context,
    state: State,
    pace: Pace,
    vertices: Vec<GrVertex>,
}

impl Glide {
    fn new(triangles: &[[Corner; 3]], state: State, pace: Pace) -> Glide {
        use glide::Call::*;
        let config = GlideConfig { device: pace.device(), ..GlideConfig::default() };
        let mut library = glide::Context::new(config).expect("a board");
        let data = (0..9).flat_map(|level| texels(TEXELS >> level)).collect::<Vec<u8>>();
        let (start, even_odd, small_lod, large_lod, aspect, format) = (0, 3, 8, 0, 3, 0xa);
        for call in [
            GrGlideInit {},
            GrSstWinOpen {
                window: 0,
                resolution: 7,
                refresh: 0,
                color_format: 0,
                origin: 0,
                colors: 2,
                aux: 1,
            },
            GrDitherMode { mode: 2 },
            GrDepthBufferMode { mode: 1 },
            GrDepthBufferFunction { function: 3 },
            GrDepthMask { mask: 1 },
            GrTexDownloadMipMap {
                tmu: 0,
                start,
                even_odd,
                small_lod,
                large_lod,
                aspect,
                format,
                data: data.into(),
            },
            GrTexSource { tmu: 0, start, even_odd, small_lod, large_lod, aspect, format },
            GrTexFilterMode { tmu: 0, minify: 1, magnify: 1 },
            GrTexClampMode { tmu: 0, s: 0, t: 0 },
            GrTexMipMapMode { tmu: 0, mode: 1, blend: 0 },
            GrTexCombineFunction { tmu: 0, function: 1 },
            // Iterated colours, the texel, or their product.
            GuColorCombineFunction {
                function: match (state.textured, state.modulated) {
                    (false, _) => 2,
                    (true, false) => 4,
                    (true, true) => 6,
                },
            },
            GuAlphaSource { mode: 1 },
            GrFogTable { table: gu::fog_table_exp(0.35) },
            GrFogColorValue { color: 0x0080_99b3 },
            GrFogMode { mode: if state.fogged { 2 } else { 0 } },
        ] {
            library.execute(&call);
        }
        if state.blended {
            library.execute(&GrAlphaBlendFunction {
                rgb_source: 1,
                rgb_destination: 5,
                alpha_source: 4,
                alpha_destination: 0,
            });
        }
        let vertex = |c: &Corner| {
            let scale = TEXELS as f32 * c.inv_w;
            let tmu = GrTmuVertex { sow: c.u * scale, tow: c.v * scale, oow: c.inv_w };
            let [r, g, b] = c.color.map(|v| v * 255.0);
            let (a, ooz) = (c.alpha * 255.0, c.z * 65_535.0);
            GrVertex { x: c.x, y: c.y, z: 0.0, r, g, b, ooz, a, oow: c.inv_w, tmuvtx: [tmu; 2] }
        };
        let vertices = triangles.iter().flatten().map(vertex).collect();
        Glide { library, state, pace, vertices }
    }
}

impl Frame for Glide {
    fn frame(&mut self) {
        use glide::Call::*;
        // A clear obeys the depth mask.
        self.library.execute(&GrDepthMask { mask: 1 });
        self.library.execute(&GrBufferClear { color: 0, alpha: 0, depth: 0xffff });
        self.library.execute(&GrDepthMask { mask: i32::from(!self.state.blended) });
        for [a, b, c] in self.vertices.as_chunks().0 {
            if self.state.by_calls {
                self.library.execute(&GrDrawTriangle { a: *a, b: *b, c: *c });
            } else {
                self.library.draw_triangle(a, b, c);
            }
        }
        self.library.execute(&GrBufferSwap { interval: 0 });
        if self.pace == Pace::OneByOne {
            self.library.shown();
        }
    }

    fn pixels(&mut self) -> u64 {
        self.library.total_counters().pixels_out
    }

    fn picture(&mut self) -> Vec<u16> {
        self.library.shown().expect("a frame is shown").pixels
    }
}

/// How far channels are apart on average, of 31 or 63 steps.
fn difference(a: &[u16], b: &[u16]) -> f64 {
    let channels = |p: u16| [p >> 11, p >> 5 & 63, p & 31].map(i32::from);
    let apart = |(&a, &b): (&u16, &u16)| -> i32 {
        channels(a).iter().zip(channels(b)).map(|(a, b)| (a - b).abs()).sum()
    };
    a.iter().zip(b).map(apart).sum::<i32>() as f64 / (3 * a.len().max(1)) as f64
}

/// A run takes so long at least, in seconds.
const RUN: f64 = 0.02;

/// Frames of a run.
fn frames_of(renderer: &mut dyn Frame) -> usize {
    let start = Instant::now();
    (0..4).for_each(|_| renderer.frame());
    renderer.pixels();
    (4.0 * RUN / start.elapsed().as_secs_f64()) as usize + 1
}

/// Milliseconds of a frame.
fn run(renderer: &mut dyn Frame, frames: usize) -> f64 {
    let start = Instant::now();
    (0..frames).for_each(|_| renderer.frame());
    // What is drawn behind the program counts.
    renderer.pixels();
    start.elapsed().as_secs_f64() * 1e3 / frames as f64
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// Times of a frame of RAVE's and of Glide's, and of the first by the second.
fn measure(rave: &mut Rave, glide: &mut Glide) -> [f64; 3] {
    let frames = frames_of(glide);
    let rounds: Vec<[f64; 2]> =
        (0..ROUNDS).map(|_| [run(rave, frames), run(glide, frames)]).collect();
    let all = |value: fn(&[f64; 2]) -> f64| median(rounds.iter().map(value).collect());
    [all(|times| times[0]), all(|times| times[1]), all(|times| times[0] / times[1])]
}

/// Both draw the same triangles, at both paces, where an argument of the command
/// is part of the name, or there is none.
fn compare(name: &str, triangles: &[[Corner; 3]], state: State) {
    let mut asked = std::env::args().skip(1).filter(|text| !text.starts_with('-')).peekable();
    if asked.peek().is_some() && !asked.any(|text| name.contains(&text)) {
        return;
    }
    print!("{name:<32}");
    for pace in [Pace::OneByOne, Pace::InSequence] {
        let mut rave = Rave::new(triangles, state, pace);
        let mut glide = Glide::new(triangles, state, pace);
        rave.frame();
        glide.frame();
        let (ours, theirs) = (rave.pixels(), glide.pixels());
        assert!(ours.abs_diff(theirs) <= theirs / 100, "the same work: {ours}, {theirs} fragments");
        let apart = difference(&rave.picture(), &glide.picture());
        assert!(apart < 1.0, "the same picture: {apart} apart");
        let [ours, theirs, ratio] = measure(&mut rave, &mut glide);
        print!("{ours:>8.3} {theirs:>8.3} {ratio:>7.3}");
    }
    println!();
}

fn main() {
    let texture = State { textured: true, ..State::default() };
    let modulated = State { modulated: true, ..texture };
    let fogged = State { fogged: true, ..modulated };
    let blended = State { blended: true, ..modulated };
    let all = State { fogged: true, ..blended };
    println!("{:<32}{:^24} {:^24}", "", "one by one, 1 thread", "in sequence, 2 threads");
    let header = format!("{:>8} {:>8} {:>7}", "RAVE ms", "Glide ms", "ratio");
    println!("{:<32}{header}{header}", "");
    let layers = layers(8);
    for (name, state) in [
        ("8 layers, Gouraud", State::default()),
        ("8 layers, textured", texture),
        ("8 layers, modulated", modulated),
        ("8 layers, fogged", fogged),
        ("8 layers, blended", blended),
        ("8 layers, fogged, blended", all),
    ] {
        compare(name, &layers, state);
    }
    for (count, side) in [(40, 400.0), (4_000, 40.0), (20_000, 14.0), (50_000, 4.5)] {
        let triangles = triangles(count, side);
        compare(&format!("{count} of {side} pixels, modulated"), &triangles, modulated);
        compare(&format!("{count} of {side} pixels, all"), &triangles, all);
    }
    let small = triangles(50_000, 4.5);
    compare("50000 of 4.5 pixels, Gouraud", &small, State::default());
    let by_calls = State { by_calls: true, ..modulated };
    compare("50000 of 4.5 pixels, by calls", &small, by_calls);
}
