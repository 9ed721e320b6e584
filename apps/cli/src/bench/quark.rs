//! The workloads of Quark 3D, and its benchmark scene, also through Glide.
//!
//! Full-screen layers are drawn as by W1 to W4, so that rates compare. The
//! scene is that of the example demo14; its faces, once transformed, are drawn
//! by both front ends.

use std::sync::Arc;

use anyhow::{Context as _, Result, bail};
use fillrate_engine::{Counters, DeviceConfig};
use fillrate_glide::{Call, Context, GlideConfig, GrVertex};
use fillrate_player::{Frame, Pixels};
use fillrate_quark::{
    DrawMode, Gpu, GpuConfig, IndexFormat, Matrix, RasterState, Texture, TriangleList,
    TriangleMode, Vertex, VertexFormat, color_rgb, math,
};

use super::drawing::Drawing;
use super::scene::{Random, texture as glide_texture};
use super::size::Size;

/// What a workload draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Full-screen layers.
    Layers { mode: TriangleMode, draw_mode: DrawMode, gouraud: bool, front_to_back: bool },
    /// Triangles of ten pixels.
    Small,
    /// The scene of demo14 from its lists.
    Scene,
    /// The scene's faces, already projected.
    Faces,
    /// The same faces through Glide.
    GlideFaces,
}

const fn layers(mode: TriangleMode, draw_mode: DrawMode, gouraud: bool) -> Kind {
    Kind::Layers { mode, draw_mode, gouraud, front_to_back: false }
}

/// All of them.
pub const WORKLOADS: [(&str, Kind); 10] = [
    ("Q1_fill_flat_z", layers(TriangleMode::Untextured, DrawMode::Opaque, false)),
    ("Q2_gouraud_z_b2f", layers(TriangleMode::Untextured, DrawMode::Opaque, true)),
    (
        "Q2_gouraud_z_f2b",
        Kind::Layers {
            mode: TriangleMode::Untextured,
            draw_mode: DrawMode::Opaque,
            gouraud: true,
            front_to_back: true,
        },
    ),
    ("Q3_tex_affine_z", layers(TriangleMode::Affine, DrawMode::Opaque, true)),
    ("Q3_tex_persp_z_b2f", layers(TriangleMode::Perspective, DrawMode::Opaque, true)),
    ("Q4_tex_alpha", layers(TriangleMode::Perspective, DrawMode::Alpha, true)),
    ("Q6_tri_10px", Kind::Small),
    ("Q14_scene", Kind::Scene),
    ("Q14_faces", Kind::Faces),
    ("Q14_faces_glide", Kind::GlideFaces),
];

/// Layers of the full-screen workloads.
const OVERDRAW: i32 = 20;
/// Triangles of a frame of small ones.
const SMALL: usize = 200_000;

/// A workload on a graphics processor.
pub struct Prepared {
    kind: Kind,
    gpu: Gpu,
    faces: Vec<[Vertex; 3]>,
    scene: Vec<(TriangleList, [i32; 3])>,
    glide: Option<(Context, Vec<GrVertex>)>,
    pixels: f64,
}

impl Prepared {
    /// Makes the processor and what the workload draws.
    pub fn new(kind: Kind, size: Size, device: DeviceConfig) -> Result<Prepared> {
        let Size { width, height } = size;
        let config = GpuConfig { width, height, device: device.clone(), ..GpuConfig::default() };
        let mut gpu = Gpu::new(config)?;
        gpu.set_work_memory(2000, 0)?;
        let is_scene = matches!(kind, Kind::Scene | Kind::Faces | Kind::GlideFaces);
        let scene = if is_scene { terrain()? } else { Vec::new() };
        let faces = match kind {
            Kind::Layers { mode, gouraud, front_to_back, .. } => {
                quads((width, height), gouraud, front_to_back, mode.is_textured())
            }
            Kind::Small => small((width, height)),
            _ => project(&scene, &gpu),
        };
        let glide = match kind {
            Kind::GlideFaces => Some(glide(&faces, size, device)?),
            _ => None,
        };
        set_state(&mut gpu, kind)?;
        let mut prepared = Prepared { kind, gpu, faces, scene, glide, pixels: 0.0 };
        prepared.count_pixels();
        Ok(prepared)
    }

    /// Fragments of a frame, which rates are counted in.
    fn count_pixels(&mut self) {
        if self.kind == Kind::Small {
            self.pixels = SMALL as f64;
            return;
        }
        let before = self.counters().pixels_in;
        self.frame();
        self.pixels = (self.counters().pixels_in - before) as f64;
    }

    fn draw_scene(&mut self) {
        let camera = camera();
        for (list, at) in &self.scene {
            let mut matrix = camera;
            matrix.translate(at[0], at[1], at[2]);
            self.gpu.view_matrix = Some(matrix);
            // The lists fit the work memory and have coordinates.
            let _ = self.gpu.draw_list(&list.view());
        }
    }
}

impl Drawing for Prepared {
    fn frame(&mut self) {
        if let Some((context, vertices)) = &mut self.glide {
            context.execute(&Call::GrBufferClear { color: 0, alpha: 0, depth: 0 });
            for [a, b, c] in vertices.as_chunks().0 {
                context.draw_triangle(a, b, c);
            }
            context.execute(&Call::GrBufferSwap { interval: 0 });
            return;
        }
        match self.kind {
            Kind::Scene => self.draw_scene(),
            _ => {
                for (i, [a, b, c]) in self.faces.iter().enumerate() {
                    if i % 2 == 0
                        && let Some(state) = &mut self.gpu.triangle_state
                    {
                        state.draw_color = i as u8;
                    }
                    self.gpu.draw_triangle(a, b, c);
                }
            }
        }
        self.gpu.flush_frame(0x1f00);
    }

    fn count(&self) -> f64 {
        self.pixels
    }

    fn picture(&mut self) -> Result<Frame> {
        if let Some((context, _)) = &mut self.glide {
            let shown = context.shown().context("nothing is shown")?;
            return Ok(Frame::new(shown.width, shown.height, Pixels::Rgb565(shown.pixels))?);
        }
        let shown = self.gpu.shown();
        Ok(Frame::new(shown.width, shown.height, Pixels::Rgba8(shown.rgba8888()))?)
    }

    fn counters(&mut self) -> Counters {
        match &mut self.glide {
            Some((context, _)) => context.counters(),
            None => self.gpu.counters(),
        }
    }
}

/// What is counted.
pub fn unit(kind: Kind) -> &'static str {
    if kind == Kind::Small { "Mtri/s" } else { "Mpix/s" }
}

fn set_state(gpu: &mut Gpu, kind: Kind) -> Result<()> {
    let (mode, draw_mode) = match kind {
        Kind::Layers { mode, draw_mode, .. } => (mode, draw_mode),
        _ => (TriangleMode::Perspective, DrawMode::Opaque),
    };
    gpu.triangle_mode = Some(mode);
    gpu.triangle_state = Some(RasterState {
        draw_mode,
        test_culling: false,
        texture: Some(skin()?),
        ..RasterState::default()
    });
    Ok(())
}

/// A texture of 64x64.
fn skin() -> Result<Arc<Texture>> {
    let mut random = Random(77);
    let texels: Vec<u8> = (0..64 * 64)
        .map(|i| color_rgb((i % 64 * 4) as u8, (i / 16) as u8, 0) | (random.bits() & 7) as u8)
        .collect();
    Ok(Arc::new(Texture::new(&texels, 64, 64, -1)?))
}

/// Full-screen quads, each nearer than the one before, or farther: upright, or
/// floors whose upper edges are three times as far.
fn quads(
    (width, height): (u32, u32),
    gouraud: bool,
    front_to_back: bool,
    floor: bool,
) -> Vec<[Vertex; 3]> {
    let far = if floor { 3 } else { 1 };
    let mut random = Random(0x1234_5678);
    let mut out = Vec::new();
    for layer in 0..OVERDRAW {
        let near = if front_to_back { layer } else { OVERDRAW - 1 - layer };
        let flat = 255 - layer;
        let mut light = || if gouraud { (random.bits() & 255) as i32 } else { flat };
        let corner = |x: i32, y: i32, z: i32, i: i32| Vertex {
            x: x * width as i32,
            y: y * height as i32,
            z: z * (100 + near * 3),
            m: 0,
            i,
            u: x * 900,
            v: y * 900,
        };
        let (a, b) = (corner(0, 1, 1, light()), corner(1, 1, 1, light()));
        let (c, d) = (corner(1, 0, far, light()), corner(0, 0, far, light()));
        out.extend([[a, b, c], [a, c, d]]);
    }
    out
}

/// Triangles of about ten pixels all over the screen.
fn small((width, height): (u32, u32)) -> Vec<[Vertex; 3]> {
    let mut random = Random(99);
    let mut below = |end: u32| (random.bits() >> 8) % end;
    let mut triangle = |_| {
        let (x, y) = (below(width - 8) as i32, below(height - 8) as i32);
        let mut corner = |dx: i32, dy: i32| Vertex {
            x: x + dx,
            y: y + dy,
            z: 64 + below(4000) as i32,
            m: 0,
            i: below(256) as i32,
            u: below(256) as i32,
            v: below(256) as i32,
        };
        [corner(0, 0), corner(1, 5), corner(5, 2)]
    };
    (0..SMALL).map(&mut triangle).collect()
}

/// Squares of a terrain tile in each direction, and their side.
const CELLS: i32 = 10;
const CELL: i32 = 160;

fn height(x: i32, z: i32) -> i32 {
    let wave = |angle: i32, size: i32| (size * i32::from(math::sinus(angle))) >> 14;
    wave(x * 2 + 700, 200) + wave(z * 2 - x + 2048, 180) + wave(x * 5 + z * 4, 50)
}

/// Sixteen tiles of 200 triangles, lit by their height.
fn terrain() -> Result<Vec<(TriangleList, [i32; 3])>> {
    let state = RasterState { texture: Some(skin()?), ..RasterState::default() };
    let mut tiles = Vec::new();
    for tile in 0..16 {
        let at =
            [(2 * (tile % 4) - 4) * CELLS * CELL / 2, 0, (2 * (tile / 4) - 4) * CELLS * CELL / 2];
        let vertex = VertexFormat { intensity: true, uv: false };
        let index = IndexFormat { uv: true, ..IndexFormat::default() };
        let side = CELLS + 1;
        let states = vec![state.clone()];
        let (vertices, triangles) = ((side * side) as usize, (CELLS * CELLS * 2) as usize);
        let mut list = TriangleList::new(vertex, vertices, index, triangles, states)?;
        for i in 0..side * side {
            let (x, z) = (i % side * CELL, i / side * CELL);
            let y = height(at[0] + x, at[2] + z);
            list.set_xyz(i as usize, [x as i16, y as i16, z as i16]);
            list.set_i(i as usize, (160 + y / 4).clamp(40, 255));
        }
        for i in 0..CELLS * CELLS {
            let a = (i / CELLS * side + i % CELLS) as u16;
            let b = a + side as u16;
            let face = 2 * i as usize;
            list.set_abc(face, [a, b, b + 1]);
            list.set_uv(face, &[[0, 0], [0, 256], [256, 256]]);
            list.set_abc(face + 1, [a, b + 1, a + 1]);
            list.set_uv(face + 1, &[[0, 0], [256, 256], [256, 0]]);
        }
        list.build_commands(&[]);
        tiles.push((list, at));
    }
    Ok(tiles)
}

/// The camera, as the world sees it.
fn camera() -> Matrix {
    let mut view = Matrix::identity();
    view.rotate_x(math::degree(14));
    view.rotate_y(math::degree(40));
    view.translate(-300, -700, -1500);
    view
}

/// The scene's faces on the screen that need no truncation.
fn project(scene: &[(TriangleList, [i32; 3])], gpu: &Gpu) -> Vec<[Vertex; 3]> {
    let camera = camera();
    let mut faces = Vec::new();
    for (list, at) in scene {
        let mut matrix = camera;
        matrix.translate(at[0], at[1], at[2]);
        for face in 0..list.triangle_count() {
            let (abc, uv) = (list.abc(face), list.uv(face));
            let corner = |k: usize| {
                let number = usize::from(abc[k]);
                let world = matrix.transform_vector(&list.xyz(number).map(i32::from));
                let (m, at) = gpu.camera.project(&world);
                let [x, y, z] = at?;
                let [u, v] = uv[k].map(i32::from);
                (m & 16 == 0).then(|| Vertex { x, y, z, m, i: list.i(number), u, v })
            };
            let (Some(a), Some(b), Some(c)) = (corner(0), corner(1), corner(2)) else { continue };
            let area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
            if a.m & b.m & c.m == 0 && area < 0 {
                faces.push([a, b, c]);
            }
        }
    }
    faces
}

/// The faces through Glide: perspective, one texel a pixel, modulated, with a
/// z-buffer. Vertices are kept within the chip's coordinates.
fn glide(
    faces: &[[Vertex; 3]],
    size: Size,
    device: DeviceConfig,
) -> Result<(Context, Vec<GrVertex>)> {
    let resolution = size.resolution().context("no board shows this size")?;
    let mut context = Context::new(GlideConfig { device, ..GlideConfig::default() })?;
    context.execute(&Call::GrGlideInit {});
    let open = Call::GrSstWinOpen {
        window: 0,
        resolution,
        refresh: 0,
        color_format: 0,
        origin: 0,
        colors: 2,
        aux: 1,
    };
    if context.execute(&open) == 0 {
        bail!("the board cannot be opened");
    }
    let (tmu, start, even_odd, small_lod, large_lod, aspect, format) = (0, 0, 3, 8, 2, 3, 0xa);
    for call in [
        Call::GrTexDownloadMipMap {
            tmu,
            start,
            even_odd,
            small_lod,
            large_lod,
            aspect,
            format,
            data: glide_texture(64, 5).into(),
        },
        Call::GrTexMipMapMode { tmu, mode: 0, blend: 0 },
        Call::GrTexSource { tmu, start, even_odd, small_lod, large_lod, aspect, format },
        Call::GrTexFilterMode { tmu, minify: 0, magnify: 0 },
        Call::GrTexClampMode { tmu, s: 0, t: 0 },
        Call::GrTexCombineFunction { tmu, function: 1 },
        Call::GuColorCombineFunction { function: 6 },
        Call::GrDepthBufferMode { mode: 1 },
        Call::GrDepthBufferFunction { function: 4 },
        Call::GrDepthMask { mask: 1 },
    ] {
        context.execute(&call);
    }
    let far = |v: &Vertex| v.x.abs() > 2000 || v.y.abs() > 2000;
    let inside = faces.iter().filter(|face| !face.iter().any(far));
    let vertices = inside.flatten().map(|v| {
        let oow = 64.0 / v.z as f32;
        let mut out = GrVertex {
            x: v.x as f32,
            y: v.y as f32,
            r: v.i as f32,
            g: v.i as f32,
            b: v.i as f32,
            a: 255.0,
            ooz: 65535.0 * oow,
            oow,
            ..GrVertex::default()
        };
        out.tmuvtx[0].sow = v.u as f32 * oow;
        out.tmuvtx[0].tow = v.v as f32 * oow;
        out.tmuvtx[0].oow = oow;
        out
    });
    let vertices = vertices.collect();
    Ok((context, vertices))
}
