//! The same triangles through RAVE and through Glide: textured, modulated,
//! fogged, blended and z-buffered.
//!
//! `cargo bench -p fillrate-rave` prints both times of a frame, on one thread,
//! and how much longer RAVE takes; then RAVE's with the renderer on a thread of
//! its own. Of every measurement the median of rounds that take turns counts.

use std::time::Instant;

use fillrate_engine::DeviceConfig;
use fillrate_glide::{self as glide, GlideConfig, GrTmuVertex, GrVertex, gu};
use fillrate_rave::constants::{blend, compare, fog, quality, texture, texture_op, vertex_mode};
use fillrate_rave::tags::{float, int, pointer};
use fillrate_rave::{
    Call, Context, DeviceValue, DrawContextId, ImageValue, PixelType, RaveConfig, RaveRect,
    VTexture,
};

const WIDTH: u32 = 640;
const HEIGHT: u32 = 480;
/// Sides of the texture.
const TEXELS: u32 = 256;
const ROUNDS: usize = 15;

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
            u: x * side / TEXELS as f32 + 0.25,
            v: y * side / TEXELS as f32 + 0.25,
        })
    };
    (0..count).map(one).collect()
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
    vertices: Vec<VTexture>,
}

impl Rave {
    fn new(triangles: &[[Corner; 3]], asynchronous: bool) -> Rave {
        let device = DeviceConfig { threads: 1, ..DeviceConfig::default() };
        let config = RaveConfig { device, asynchronous, ..RaveConfig::default() };
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
            (int::TEXTURE_OP, texture_op::MODULATE),
            (int::BLEND, blend::INTERPOLATE),
            (int::FOG_MODE, fog::EXPONENTIAL),
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
            a: c.alpha,
            u_over_w: c.u * c.inv_w,
            v_over_w: (1.0 - c.v) * c.inv_w,
            kd_r: c.color[0],
            kd_g: c.color[1],
            kd_b: c.color[2],
            ..VTexture::default()
        };
        Rave { library, context, vertices: triangles.iter().flatten().map(vertex).collect() }
    }
}

impl Frame for Rave {
    fn frame(&mut self) {
        let context = self.context;
        self.library.execute(&Call::RenderStart { context, dirty: None, initial: 0 });
        self.library.draw_v_texture(DrawContextId(context), vertex_mode::TRI, &self.vertices);
        self.library.execute(&Call::RenderEnd { context, modified: None });
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
    vertices: Vec<GrVertex>,
}

impl Glide {
    fn new(triangles: &[[Corner; 3]]) -> Glide {
        use glide::Call::*;
        let device = DeviceConfig { threads: 1, ..DeviceConfig::default() };
        let config = GlideConfig { device, ..GlideConfig::default() };
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
            GuColorCombineFunction { function: 6 },
            GuAlphaSource { mode: 1 },
            GrAlphaBlendFunction {
                rgb_source: 1,
                rgb_destination: 5,
                alpha_source: 4,
                alpha_destination: 0,
            },
            GrFogTable { table: gu::fog_table_exp(0.35) },
            GrFogColorValue { color: 0x0080_99b3 },
            GrFogMode { mode: 2 },
        ] {
            library.execute(&call);
        }
        let vertex = |c: &Corner| {
            let scale = TEXELS as f32 * c.inv_w;
            let tmu = GrTmuVertex { sow: c.u * scale, tow: c.v * scale, oow: c.inv_w };
            let [r, g, b] = c.color.map(|v| v * 255.0);
            let (a, ooz) = (c.alpha * 255.0, c.z * 65_535.0);
            GrVertex { x: c.x, y: c.y, z: 0.0, r, g, b, ooz, a, oow: c.inv_w, tmuvtx: [tmu; 2] }
        };
        Glide { library, vertices: triangles.iter().flatten().map(vertex).collect() }
    }
}

impl Frame for Glide {
    fn frame(&mut self) {
        let clear = glide::Call::GrBufferClear { color: 0, alpha: 0, depth: 0xffff };
        self.library.execute(&clear);
        for [a, b, c] in self.vertices.as_chunks().0 {
            self.library.draw_triangle(a, b, c);
        }
        self.library.execute(&glide::Call::GrBufferSwap { interval: 0 });
        // A frame that is not looked at is not complete.
        self.library.shown();
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

/// Milliseconds of a frame, each renderer's median of rounds that take turns.
fn measure(renderers: &mut [&mut dyn Frame], frames: usize) -> Vec<f64> {
    let mut times = vec![Vec::new(); renderers.len()];
    for round in 0..ROUNDS + 1 {
        for (renderer, times) in renderers.iter_mut().zip(&mut times) {
            let start = Instant::now();
            (0..frames).for_each(|_| renderer.frame());
            renderer.pixels();
            let time = start.elapsed().as_secs_f64() * 1e3 / frames as f64;
            // The first one warms up.
            if round > 0 {
                times.push(time);
            }
        }
    }
    let median = |mut times: Vec<f64>| {
        times.sort_by(f64::total_cmp);
        times[times.len() / 2]
    };
    times.into_iter().map(median).collect()
}

fn main() {
    println!(
        "{:>9} {:>6} {:>9} {:>9} {:>7} {:>9}",
        "triangles", "side", "RAVE", "Glide", "ratio", "threaded"
    );
    for (count, side, frames) in
        [(40, 400.0, 4), (4_000, 40.0, 4), (20_000, 14.0, 4), (50_000, 4.0, 2)]
    {
        let triangles = triangles(count, side);
        let mut rave = Rave::new(&triangles, false);
        let mut threaded = Rave::new(&triangles, true);
        let mut glide = Glide::new(&triangles);
        rave.frame();
        glide.frame();
        let (ours, theirs) = (rave.pixels(), glide.pixels());
        assert!(ours.abs_diff(theirs) <= theirs / 100, "the same work: {ours}, {theirs} fragments");
        let apart = difference(&rave.picture(), &glide.picture());
        assert!(apart < 1.0, "the same picture: {apart} apart");
        let times = measure(&mut [&mut rave, &mut glide, &mut threaded], frames);
        let ratio = times[0] / times[1];
        println!(
            "{count:>9} {side:>6} {:>6.2} ms {:>6.2} ms {ratio:>7.3} {:>6.2} ms",
            times[0], times[1], times[2]
        );
    }
}
