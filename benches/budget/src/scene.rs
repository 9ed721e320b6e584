//! The scenes: a small board, fixed triangles.

use anyhow::{Context as _, Result, bail};
use fillrate_engine::DeviceConfig;
use fillrate_glide::{Call, Context, GlideConfig, GrTmuVertex, GrVertex};
use fillrate_player::{Frame, Pixels};

use crate::kernels::{Draw, Kernel};

/// Columns of the screen.
const WIDTH: u32 = 320;
/// Rows of the screen.
const HEIGHT: u32 = 240;
/// Its number in `grSstWinOpen`.
const RESOLUTION: i32 = 1;

/// Full-screen layers of a frame.
const LAYERS: u32 = 4;
/// Small triangles, and lines, of a frame.
const SMALL: u32 = 1500;
/// Clears of a frame.
const CLEARS: u32 = 4;
/// Pixels between those that make a clear be carried out.
const CLEAR_STEP: usize = 16;

/// Seen where fragments are dropped.
const BACKGROUND: u32 = 0x0020_4080;

/// 565.
pub const TEXEL_FORMAT: i32 = 0xa;
/// Side of the texture.
const SIDE: u32 = 128;

/// A board in a kernel's state, and what is drawn.
pub struct Scene {
    draw: Draw,
    context: Context,
    vertices: Vec<GrVertex>,
    pixels: Vec<u8>,
}

impl Scene {
    /// Opens a board.
    pub fn new(kernel: &Kernel, device: DeviceConfig) -> Result<Scene> {
        let mut context = Context::new(GlideConfig { device, ..GlideConfig::default() })?;
        context.execute(&Call::GrGlideInit {});
        let open = Call::GrSstWinOpen {
            window: 0,
            resolution: RESOLUTION,
            refresh: 0,
            color_format: 0,
            origin: 0,
            colors: 2,
            aux: 1,
        };
        if context.execute(&open) == 0 {
            bail!("the board cannot be opened");
        }
        let mut calls = vec![Call::GrDitherMode { mode: 2 }];
        (kernel.state)(&mut calls);
        calls.iter().for_each(|call| {
            context.execute(call);
        });
        let pixels = (0..WIDTH * HEIGHT).flat_map(|i| (i.wrapping_mul(40503) as u16).to_le_bytes());
        Ok(Scene {
            draw: kernel.draw,
            context,
            vertices: vertices(kernel.draw),
            pixels: pixels.collect(),
        })
    }

    /// Draws and shows a frame.
    pub fn frame(&mut self) {
        match self.draw {
            Draw::Layers | Draw::Hidden | Draw::Triangles(_) => {
                self.clear(BACKGROUND);
                self.triangles();
            }
            Draw::Lines => {
                self.clear(BACKGROUND);
                for [a, b] in self.vertices.as_chunks().0 {
                    self.context.execute(&Call::GrDrawLine { a: *a, b: *b });
                }
            }
            Draw::Clears => {
                for i in 0..CLEARS {
                    self.clear(i * 0x0011_2233);
                    self.triangles();
                }
            }
            Draw::LfbWrite => self.write_region(),
            Draw::LfbRead => {
                std::hint::black_box(self.context.lfb_read_region(1, (0, 0), (WIDTH, HEIGHT)));
            }
            Draw::Upload => {
                self.upload();
                self.triangles();
            }
        }
        self.context.execute(&Call::GrBufferSwap { interval: 0 });
    }

    /// Pixels, triangles, lines or texels of a frame.
    pub fn count(&self) -> u64 {
        let screen = u64::from(WIDTH * HEIGHT);
        match self.draw {
            Draw::Layers | Draw::Hidden => screen * u64::from(LAYERS),
            Draw::Triangles(_) | Draw::Lines => u64::from(SMALL),
            Draw::Clears => screen * u64::from(CLEARS),
            Draw::LfbWrite | Draw::LfbRead => screen,
            Draw::Upload => u64::from(SIDE * SIDE),
        }
    }

    /// The picture shown.
    pub fn picture(&mut self) -> Result<Frame> {
        let shown = self.context.shown().context("nothing is shown")?;
        Ok(Frame::new(shown.width, shown.height, Pixels::Rgb565(shown.pixels))?)
    }

    fn clear(&mut self, color: u32) {
        self.context.execute(&Call::GrBufferClear { color, alpha: 0, depth: 0xffff });
    }

    fn triangles(&mut self) {
        for [a, b, c] in self.vertices.as_chunks().0 {
            self.context.draw_triangle(a, b, c);
        }
    }

    fn write_region(&mut self) {
        let (buffer, x, y, format, stride) = (1, 0, 0, 0, WIDTH as i32 * 2);
        let data = self.pixels.as_slice().into();
        self.context.execute(&Call::GrLfbWriteRegion {
            buffer,
            x,
            y,
            format,
            width: WIDTH,
            height: HEIGHT,
            stride,
            data,
        });
    }

    /// Stores the finest level, so that the texture has to be decoded anew.
    fn upload(&mut self) {
        let (tmu, start, this_lod, large_lod, aspect, even_odd) = (0, 0, 1, 1, 3, 3);
        let bytes = (SIDE * SIDE * 2) as usize;
        self.context.execute(&Call::GrTexDownloadMipMapLevelPartial {
            tmu,
            start,
            this_lod,
            large_lod,
            aspect,
            format: TEXEL_FORMAT,
            even_odd,
            data: self.pixels[..bytes].into(),
            first: 0,
            last: SIDE as i32 - 1,
        });
    }
}

/// A xorshift generator.
struct Random(u32);

impl Random {
    fn bits(&mut self) -> u32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        self.0
    }

    fn float(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * (self.bits() >> 8) as f32 * (1.0 / 16_777_216.0)
    }
}

/// A vertex; `st` in texels of a 256-texel texture.
fn vertex(at: (f32, f32), z: f32, w: f32, st: (f32, f32), color: u32) -> GrVertex {
    let oow = 1.0 / w;
    let byte = |shift: u32| (color >> shift & 0xff) as f32;
    let tmu = GrTmuVertex { sow: st.0 * oow, tow: st.1 * oow, oow };
    GrVertex {
        x: at.0,
        y: at.1,
        z: 0.0,
        r: byte(0),
        g: byte(8),
        b: byte(16),
        ooz: z * 65535.0,
        a: byte(24),
        oow,
        tmuvtx: [tmu; 2],
    }
}

fn vertices(draw: Draw) -> Vec<GrVertex> {
    let mut random = Random(0x00C0_FFEE);
    match draw {
        Draw::Layers | Draw::Hidden => (0..LAYERS)
            .flat_map(|i| {
                let near = 0.2 * i as f32;
                layer(&mut random, if draw == Draw::Hidden { 0.1 + near } else { 0.9 - near })
            })
            .collect(),
        Draw::Triangles(area) => {
            (0..SMALL).flat_map(|_| triangle(&mut random, area as f32)).collect()
        }
        Draw::Lines => (0..SMALL).flat_map(|_| line(&mut random)).collect(),
        Draw::Clears => {
            let rows = (0..HEIGHT).step_by(CLEAR_STEP);
            let places = rows.flat_map(|y| (0..WIDTH).step_by(CLEAR_STEP).map(move |x| (x, y)));
            places.flat_map(|(x, y)| dot(x as f32, y as f32)).collect()
        }
        Draw::Upload => dot(8.0, 8.0).to_vec(),
        Draw::LfbWrite | Draw::LfbRead => Vec::new(),
    }
}

/// A floor over the screen, w from 1 at the bottom to 3 at the top.
fn layer(random: &mut Random, z: f32) -> [GrVertex; 6] {
    let (width, height) = (WIDTH as f32, HEIGHT as f32);
    let corners = [(0.0, height), (width, height), (width, 0.0), (0.0, 0.0)].map(|at| {
        let w = if at.1 == 0.0 { 3.0 } else { 1.0 };
        let st = ((at.0 - width / 2.0) * w, height * w + at.0 / 4.0);
        vertex(at, z, w, st, random.bits() | 0x0040_4040)
    });
    [0, 1, 2, 0, 2, 3].map(|i: usize| corners[i])
}

fn triangle(random: &mut Random, area: f32) -> [GrVertex; 3] {
    let side = (2.0 * area).sqrt();
    let angle = random.float(0.0, 1.0);
    // A point of the unit circle without trigonometry.
    let scale = 1.0 / (1.0 + angle * angle);
    let (cosine, sine) = ((1.0 - angle * angle) * scale, 2.0 * angle * scale);
    let place = (random.float(20.0, WIDTH as f32 - 20.0), random.float(20.0, HEIGHT as f32 - 20.0));
    let (z, w) = (random.float(0.1, 0.9), random.float(1.0, 4.0));
    [(0.0, 0.0), (side, 0.0), (0.4 * side, side)].map(|(px, py)| {
        let at = (place.0 + px * cosine - py * sine, place.1 + px * sine + py * cosine);
        vertex(at, z, w, (at.0 * w, at.1 * w), random.bits())
    })
}

fn line(random: &mut Random) -> [GrVertex; 2] {
    let from = (random.float(40.0, WIDTH as f32 - 40.0), random.float(40.0, HEIGHT as f32 - 40.0));
    let to = (from.0 + random.float(-30.0, 30.0), from.1 + random.float(-30.0, 30.0));
    let z = random.float(0.1, 0.9);
    [from, to].map(|at| vertex(at, z, 1.0, at, random.bits()))
}

/// A triangle over one pixel.
fn dot(x: f32, y: f32) -> [GrVertex; 3] {
    let corners = [(0.0, 0.0), (1.5, 0.0), (0.0, 1.5)];
    corners.map(|(dx, dy)| vertex((x + dx, y + dy), 0.5, 1.0, (x, y), u32::MAX))
}

/// Texels of all levels from [`SIDE`] down: noise over a ramp, every eighth
/// black.
pub fn texels() -> Vec<u8> {
    let mut random = Random(11);
    let mut out = Vec::new();
    let mut side = SIDE;
    while side > 0 {
        for i in 0..side * side {
            let texel = if i % 8 == 0 { 0 } else { (random.bits() & 0x39e7) + (i & 0x1f) };
            out.extend((texel as u16).to_le_bytes());
        }
        side /= 2;
    }
    out
}
