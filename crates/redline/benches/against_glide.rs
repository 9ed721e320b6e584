//! The same triangles through RRedline and through Glide: small ones, and
//! full-screen layers.
//!
//! `cargo bench -p fillrate-redline --bench against_glide` prints both rates, on
//! one thread and on two, and RRedline's by Glide's; then RRedline's with the
//! board's own thread, which is how programs have it. A frame is everything: the
//! fills, recording, issuing, drawing and the swap. Of every measurement the best of
//! rounds that take turns counts.

use std::time::Instant;

use fillrate_engine::DeviceConfig;
use fillrate_glide::{self as glide, GlideConfig, GrTmuVertex, GrVertex};
use fillrate_redline::surface::{PRIMARY, Z_BUFFER};
use fillrate_redline::{
    BufferGroup, Call, CommandBuffer, Context, NoMemory, RedlineConfig, Surface, VertexType, record,
};

const WIDTH: u32 = 640;
const HEIGHT: u32 = 480;
/// Sides of the texture.
const TEXELS: u32 = 64;
/// Triangles of a frame of small ones.
const SMALL: usize = 50_000;
/// Layers of the others.
const LAYERS: u32 = 20;
const ROUNDS: usize = 15;

/// What is drawn.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Scene {
    /// Triangles of ten pixels, shaded, with depths.
    Small,
    /// Layers with colours between corners and depths, each nearer than those
    /// before.
    Gouraud,
    /// The same with a filtered texture in perspective.
    Textured,
    /// Layers of a half transparent texture.
    Blended,
}

impl Scene {
    fn textured(self) -> bool {
        matches!(self, Scene::Textured | Scene::Blended)
    }

    fn depths(self) -> bool {
        self != Scene::Blended
    }

    /// Millions of triangles, or of pixels, of a frame.
    fn millions(self) -> f64 {
        match self {
            Scene::Small => SMALL as f64 / 1e6,
            _ => f64::from(LAYERS * WIDTH * HEIGHT) / 1e6,
        }
    }
}

/// A corner in both systems' terms.
#[derive(Clone, Copy)]
struct Corner {
    x: u32,
    y: u32,
    z: u32,
    /// 0xRRGGBB.
    color: u32,
    /// In repeats of the texture, 16.16.
    uv: [u32; 2],
    /// 0.24.
    q: u32,
}

fn random(seed: &mut u32) -> u32 {
    *seed ^= *seed << 13;
    *seed ^= *seed >> 17;
    *seed ^= *seed << 5;
    *seed >> 8
}

/// Pixels as repeats of the texture; a quarter of a texel more, so that no pixel
/// lies between two texels.
fn repeats(pixels: u32) -> u32 {
    (pixels << 16) / TEXELS + (1 << 14) / TEXELS
}

fn triangles(scene: Scene) -> Vec<[Corner; 3]> {
    let mut seed = 12_345;
    if scene == Scene::Small {
        let one = |_| {
            let (x, y) = (random(&mut seed) % (WIDTH - 8), random(&mut seed) % (HEIGHT - 8));
            [(0, 0), (5, 1), (1, 5)].map(|(dx, dy)| {
                let (z, color) = (random(&mut seed) % 60_000, random(&mut seed));
                Corner { x: x + dx, y: y + dy, z, color, uv: [0; 2], q: 1 << 23 }
            })
        };
        return (0..SMALL).map(one).collect();
    }
    let layer = |layer: u32| {
        let places = [(0, HEIGHT), (WIDTH, HEIGHT), (WIDTH, 0), (0, 0)];
        let corners = places.map(|(x, y)| {
            let q = if y == 0 { 0x2a_aaaa } else { 0x7f_ffff };
            let (z, color) = (60_000 - layer * 1000, random(&mut seed));
            Corner { x, y, z, color, uv: [x, y].map(repeats), q }
        });
        [[0, 1, 2], [0, 2, 3]].map(|half| half.map(|i: usize| corners[i]))
    };
    (0..LAYERS).flat_map(layer).collect()
}

/// Texels, the first row first: 4444 for blending, else 565.
fn texels(scene: Scene) -> Vec<u16> {
    let mut seed = 99;
    let texel = |i: u32| {
        let (x, y, noise) = (i % TEXELS, i / TEXELS, random(&mut seed) & 3);
        let texel = match scene {
            Scene::Blended => 0x8000 | (x >> 2) << 8 | (y >> 2) << 4 | noise << 2,
            _ => (x >> 1) << 11 | y << 5 | noise << 3,
        };
        texel as u16
    };
    (0..TEXELS * TEXELS).map(texel).collect()
}

trait Frame {
    fn frame(&mut self);
    /// Waits, and counts the fragments written so far.
    fn pixels(&mut self) -> u64;
    /// What is shown, 565.
    fn picture(&mut self) -> Vec<u16>;
}

struct Redline {
    scene: Scene,
    library: Context,
    device: u32,
    display: u32,
    buffer: u32,
    commands: CommandBuffer,
    vertex: VertexType,
    /// Of three vertices each.
    triangles: Vec<[Vec<u32>; 3]>,
}

impl Redline {
    fn new(scene: Scene, triangles: &[[Corner; 3]], threads: usize, background: bool) -> Redline {
        let device = DeviceConfig { threads, ..DeviceConfig::default() };
        let config = RedlineConfig { memory: 8, background, device, ..RedlineConfig::default() };
        let mut library = Context::new(config);
        let mut make = |call: &Call| library.execute(call).expect("it is valid").number();
        let device = make(&Call::OpenVerite {});
        make(&Call::SetDisplayType { device, display_type: 2 });
        let (width, height) = (WIDTH, HEIGHT);
        make(&Call::SetDisplayMode { device, width, height, bits: 16, refresh: 60 });
        let (mask, format) = (PRIMARY | Z_BUFFER, 4);
        let display =
            make(&Call::CreateSurface { device, mask, buffers: 3, format, width, height });
        let format = if scene == Scene::Blended { 5 } else { 4 };
        let (mask, width, height) = (0, TEXELS, TEXELS);
        let texture =
            make(&Call::CreateSurface { device, mask, buffers: 1, format, width, height });
        let words = 1 << 14;
        let buffer = make(&Call::CreateCmdBuffer { device, entries: 4, words });
        let commands = CommandBuffer::new(buffer, 4, words as usize).expect("a valid size");
        let vertex = match scene {
            Scene::Small | Scene::Gouraud => VertexType::KXYZ,
            Scene::Textured => VertexType::XYZUVQ,
            Scene::Blended => VertexType::XYUVQ,
        };
        let words = |c: &Corner| {
            let Corner { x, y, z, color, uv: [u, v], q } = *c;
            let [x, y, z] = [x, y, z].map(|value| value << 16);
            match scene {
                Scene::Small | Scene::Gouraud => vec![color, x, y, z],
                Scene::Textured => vec![x, y, z, u, v, q],
                Scene::Blended => vec![x, y, u, v, q],
            }
        };
        let triangles = triangles.iter().map(|three| three.each_ref().map(words)).collect();
        let mut redline =
            Redline { scene, library, device, display, buffer, commands, vertex, triangles };
        redline.install(texture, format).expect("there is room");
        redline
    }

    fn group(&self, group: u32) -> BufferGroup {
        self.library.group(self.device, group).expect("it was made").clone()
    }

    /// State and texture.
    fn install(&mut self, texture: u32, format: u32) -> Result<(), fillrate_redline::Failure> {
        let (display, group, scene) = (self.group(self.display), self.group(texture), self.scene);
        let to = &mut self.commands;
        record::install_dst_buffer(to, &Surface::new(WIDTH, HEIGHT, 4), &display)?;
        record::install_z_buffer(to, &display)?;
        record::install_texture_map(to, &Surface::new(TEXELS, TEXELS, format), &group)?;
        let place = [group.address(0).expect("it has one"), group.linebytes];
        let texels = texels(scene);
        let pairs = texels.as_chunks::<2>().0.iter();
        let words: Vec<u32> = pairs.map(|&[a, b]| u32::from(a) | u32::from(b) << 16).collect();
        record::mem_write_rect_inline(to, place, [TEXELS * 2, TEXELS], &words)?;
        record::set_src_func(to, u32::from(scene.textured()))?;
        record::set_src_filter(to, u32::from(scene == Scene::Textured))?;
        record::set_z_buf_mode(to, u32::from(scene.depths()))?;
        record::set_z_buf_wr_mode(to, u32::from(scene.depths()))?;
        record::set_blend_enable(to, u32::from(scene == Scene::Blended))?;
        record::set_blend_src_func(to, 2)?;
        record::set_blend_dst_func(to, 3)?;
        self.issue();
        Ok(())
    }

    fn issue(&mut self) {
        let segments = self.commands.snapshot(&NoMemory).expect("no memory is referred to");
        self.commands.reset();
        let (device, buffer, wait) = (self.device, self.buffer, false);
        let call = Call::IssueCmdBuffer { device, buffer, segments, wait };
        self.library.execute(&call).expect("the stream is valid");
    }

    fn record(&mut self) -> Result<(), fillrate_redline::Failure> {
        let display = self.group(self.display);
        let (at, size) = ([0, 0], [WIDTH, HEIGHT]);
        record::fill_buffer(&mut self.commands, &display, 1, at, size, 0)?;
        if self.scene.depths() {
            record::fill_buffer(&mut self.commands, &display, 2, at, size, 0xffff)?;
        }
        let room = 3 * self.vertex.words() + 16;
        let triangles = std::mem::take(&mut self.triangles);
        for [a, b, c] in &triangles {
            if self.commands.free_space().0 < room {
                self.issue();
            }
            record::triangle(&mut self.commands, self.vertex.code(), a, b, c)?;
        }
        self.triangles = triangles;
        record::swap_display_surface(&mut self.commands, &display)?;
        let (device, group) = (self.device, self.display);
        self.library.execute(&Call::SwapBuffers { device, group, a: 0, b: 1 })?;
        self.issue();
        Ok(())
    }
}

impl Frame for Redline {
    fn frame(&mut self) {
        self.record().expect("there is room");
    }

    fn pixels(&mut self) -> u64 {
        self.library.counters(self.device).expect("it is open").pixels_out
    }

    fn picture(&mut self) -> Vec<u16> {
        self.library.shown().expect("a frame is shown").pixels
    }
}

struct Glide {
    library: glide::Context,
    vertices: Vec<GrVertex>,
}

impl Glide {
    fn new(scene: Scene, triangles: &[[Corner; 3]], threads: usize) -> Glide {
        use glide::Call::*;
        let device = DeviceConfig { threads, ..DeviceConfig::default() };
        let config = GlideConfig { device, ..GlideConfig::default() };
        let mut library = glide::Context::new(config).expect("a board");
        let data = texels(scene).iter().flat_map(|texel| texel.to_le_bytes()).collect::<Vec<u8>>();
        let (start, even_odd, small_lod, large_lod, aspect) = (0, 3, 2, 2, 3);
        let format = if scene == Scene::Blended { 0xc } else { 0xa };
        let filter = i32::from(scene == Scene::Textured);
        let calls = [
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
            GrDitherMode { mode: 0 },
            GrDepthBufferMode { mode: i32::from(scene.depths()) },
            GrDepthBufferFunction { function: 1 },
            GrDepthMask { mask: i32::from(scene.depths()) },
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
            GrTexFilterMode { tmu: 0, minify: filter, magnify: filter },
            GrTexClampMode { tmu: 0, s: 0, t: 0 },
            GrTexMipMapMode { tmu: 0, mode: 0, blend: 0 },
            GrTexCombineFunction { tmu: 0, function: 1 },
            GuColorCombineFunction { function: if scene.textured() { 4 } else { 2 } },
        ];
        calls.iter().for_each(|call| {
            library.execute(call);
        });
        if scene == Scene::Blended {
            library.execute(&GuAlphaSource { mode: 2 });
            library.execute(&GrAlphaBlendFunction {
                rgb_source: 1,
                rgb_destination: 5,
                alpha_source: 4,
                alpha_destination: 0,
            });
        }
        let vertex = |c: &Corner| {
            let oow = c.q as f32 / (1 << 24) as f32;
            // Filtering begins half a texel later.
            let half = if filter == 1 { 0.5 } else { 0.0 };
            let [sow, tow] =
                c.uv.map(|v| (v as f32 / 65536.0 + half / TEXELS as f32) * 256.0 * oow);
            let [_, r, g, b] = c.color.to_be_bytes().map(f32::from);
            let (x, y, ooz) = (c.x as f32, c.y as f32, c.z as f32);
            let tmu = GrTmuVertex { sow, tow, oow };
            GrVertex { x, y, z: 0.0, r, g, b, ooz, a: 255.0, oow, tmuvtx: [tmu; 2] }
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

/// Seconds of a frame, each renderer's best of rounds that take turns.
fn measure(renderers: &mut [&mut dyn Frame], frames: usize) -> Vec<f64> {
    let mut times = vec![Vec::new(); renderers.len()];
    for round in 0..ROUNDS + 1 {
        for (renderer, times) in renderers.iter_mut().zip(&mut times) {
            let start = Instant::now();
            (0..frames).for_each(|_| renderer.frame());
            renderer.pixels();
            let time = start.elapsed().as_secs_f64() / frames as f64;
            // The first one warms up.
            if round > 0 {
                times.push(time);
            }
        }
    }
    times.into_iter().map(|times| times.into_iter().fold(f64::INFINITY, f64::min)).collect()
}

fn main() {
    // Names of scenes, all without; what cargo adds begins with a dash.
    let wanted: Vec<String> = std::env::args().skip(1).filter(|a| !a.starts_with('-')).collect();
    println!(
        "{:<9} {:>7} {:>9} {:>9} {:>6} {:>15} {:>6}",
        "scene", "threads", "RRedline", "Glide", "ratio", "own thread", "ratio"
    );
    for (name, scene) in [
        ("small", Scene::Small),
        ("gouraud", Scene::Gouraud),
        ("textured", Scene::Textured),
        ("blended", Scene::Blended),
    ] {
        if !wanted.is_empty() && !wanted.iter().any(|wanted| wanted == name) {
            continue;
        }
        for threads in [1, 2] {
            let triangles = triangles(scene);
            let mut redline = Redline::new(scene, &triangles, threads, false);
            let mut background = Redline::new(scene, &triangles, threads, true);
            let mut glide = Glide::new(scene, &triangles, threads);
            redline.frame();
            glide.frame();
            // RRedline fills colours and depths one after another.
            let filled = u64::from(WIDTH * HEIGHT);
            let fills = 1 + u64::from(scene.depths());
            let (ours, theirs) = (redline.pixels() - fills * filled, glide.pixels() - filled);
            assert!(ours.abs_diff(theirs) <= theirs / 50, "the same work: {ours}, {theirs}");
            let apart = difference(&redline.picture(), &glide.picture());
            assert!(apart < 1.5, "{name}: the same picture: {apart} apart");
            let times = measure(&mut [&mut redline, &mut glide, &mut background], 4);
            let [ours, theirs, own] = [0, 1, 2].map(|i: usize| scene.millions() / times[i]);
            println!(
                "{name:<9} {threads:>7} {ours:>9.2} {theirs:>9.2} {:>6.3} {own:>15.2} {:>6.3}",
                ours / theirs,
                own / theirs
            );
        }
    }
}
