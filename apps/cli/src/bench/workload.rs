//! The workloads: state, vertices, and a frame of each.

use anyhow::{Context as _, Result, bail};
use fillrate_engine::DeviceConfig;
use fillrate_glide::{Call, Context, GlideConfig, GrVertex, gu};
use fillrate_player::{Frame, Pixels};

use super::{Drawing, scene};

/// What a workload draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Flat,
    FlatDepth,
    Gouraud,
    Textured,
    Blended,
    TwoTextures,
    Triangles { count: usize, area: u32 },
    Clears,
}

/// A workload.
#[derive(Clone, Copy, Debug)]
pub struct Workload {
    /// The name that all renderers measured share.
    pub name: &'static str,
    kind: Kind,
    /// Nearest layer first: only the first passes the depth test.
    front_to_back: bool,
}

const fn workload(name: &'static str, kind: Kind, front_to_back: bool) -> Workload {
    Workload { name, kind, front_to_back }
}

/// All of them.
pub const WORKLOADS: [Workload; 13] = [
    workload("W1_fill_flat", Kind::Flat, false),
    workload("W1_fill_flat_z", Kind::FlatDepth, false),
    workload("W2_gouraud_z_b2f", Kind::Gouraud, false),
    workload("W2_gouraud_z_f2b", Kind::Gouraud, true),
    workload("W3_tex_bilin_z_b2f", Kind::Textured, false),
    workload("W3_tex_bilin_z_f2b", Kind::Textured, true),
    workload("W4_tex_blend", Kind::Blended, false),
    workload("W5_multitex_fog_z", Kind::TwoTextures, false),
    workload("W6a_tri_10px", Kind::Triangles { count: 1_000_000, area: 10 }, false),
    workload("W6b_tri_2px", Kind::Triangles { count: 1_000_000, area: 2 }, false),
    workload("W7_tri_100px", Kind::Triangles { count: 100_000, area: 100 }, false),
    workload("W8_clear", Kind::Clears, false),
    workload("W9_immediate", Kind::Triangles { count: 200_000, area: 10 }, false),
];

/// Layers of the full-screen workloads.
const OVERDRAW: u32 = 20;
/// Clears in a frame of W8.
const CLEARS: u32 = 100;

impl Workload {
    /// What is counted.
    pub fn unit(&self) -> &'static str {
        if matches!(self.kind, Kind::Triangles { .. }) { "Mtri/s" } else { "Mpix/s" }
    }

    fn is_flat(&self) -> bool {
        matches!(self.kind, Kind::Flat | Kind::FlatDepth)
    }

    fn uses_depth(&self) -> bool {
        self.kind != Kind::Flat
    }
}

/// The number of a resolution that a board can show, and its columns and rows.
pub fn resolution(size: &str) -> Result<(i32, (u32, u32))> {
    Ok(match size {
        "320x240" => (1, (320, 240)),
        "512x384" => (3, (512, 384)),
        "640x480" => (7, (640, 480)),
        "800x600" => (8, (800, 600)),
        _ => bail!("'{size}' is not a size a board can show"),
    })
}

/// A workload on an open board.
pub struct Prepared<'a> {
    workload: &'a Workload,
    context: Context,
    vertices: Vec<GrVertex>,
    size: (u32, u32),
}

impl<'a> Prepared<'a> {
    /// Opens a board of that size and sets the workload's state.
    pub fn new(workload: &'a Workload, size: &str, device: DeviceConfig) -> Result<Self> {
        let (resolution, (width, height)) = resolution(size)?;
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
        let size = (width, height);
        let vertices = vertices(workload, (width as f32, height as f32));
        let mut prepared = Prepared { workload, context, vertices, size };
        prepared.set_state();
        Ok(prepared)
    }

    fn set(&mut self, calls: &[Call]) {
        for call in calls {
            self.context.execute(call);
        }
    }

    fn set_state(&mut self) {
        let kind = self.workload.kind;
        let modulate = Call::GuColorCombineFunction { function: 6 };
        self.set(&[
            Call::GrDitherMode { mode: 2 },
            Call::GuColorCombineFunction { function: if self.workload.is_flat() { 1 } else { 2 } },
        ]);
        if self.workload.uses_depth() {
            self.set(&[
                Call::GrDepthBufferMode { mode: 1 },
                Call::GrDepthBufferFunction { function: 3 },
                Call::GrDepthMask { mask: i32::from(kind != Kind::Blended) },
            ]);
        }
        match kind {
            Kind::Textured | Kind::Triangles { .. } => {
                self.set_texture(0, 0, 256, 0x1234_5678);
                self.set(&[Call::GrTexCombineFunction { tmu: 0, function: 1 }, modulate]);
            }
            Kind::Blended => {
                self.set_texture(0, 0, 256, 0x1234_5678);
                self.set(&[
                    Call::GrTexCombineFunction { tmu: 0, function: 1 },
                    modulate,
                    Call::GuAlphaSource { mode: 1 },
                    Call::GrAlphaBlendFunction {
                        rgb_source: 1,
                        rgb_destination: 5,
                        alpha_source: 4,
                        alpha_destination: 0,
                    },
                ]);
            }
            Kind::TwoTextures => {
                self.set_texture(0, 0, 256, 0x1234_5678);
                self.set_texture(1, 2, 64, 0x8765_4321);
                self.set(&[
                    Call::GrTexCombineFunction { tmu: 1, function: 1 },
                    Call::GrTexCombineFunction { tmu: 0, function: 4 },
                    Call::GrHints { hint: 0, mask: 0x10 },
                    modulate,
                    Call::GrFogTable { table: gu::fog_table_exp(0.3) },
                    Call::GrFogColorValue { color: 0x0080_90a0 },
                    Call::GrFogMode { mode: 2 },
                ]);
            }
            Kind::Flat | Kind::FlatDepth | Kind::Gouraud | Kind::Clears => {}
        }
    }

    /// A repeating bilinear texture of 565 texels with nearest mip maps.
    fn set_texture(&mut self, tmu: i32, large_lod: i32, side: usize, seed: u32) {
        let (start, even_odd, small_lod, aspect, format) = (0, 3, 8, 3, 0xa);
        let data = scene::texture(side, seed).into();
        self.set(&[
            Call::GrTexDownloadMipMap {
                tmu,
                start,
                even_odd,
                small_lod,
                large_lod,
                aspect,
                format,
                data,
            },
            Call::GrTexMipMapMode { tmu, mode: 1, blend: 0 },
            Call::GrTexSource { tmu, start, even_odd, small_lod, large_lod, aspect, format },
            Call::GrTexFilterMode { tmu, minify: 1, magnify: 1 },
            Call::GrTexClampMode { tmu, s: 0, t: 0 },
        ]);
    }
}

impl Drawing for Prepared<'_> {
    fn frame(&mut self) {
        let clear = Call::GrBufferClear { color: 0, alpha: 0, depth: 0xffff };
        if self.workload.kind == Kind::Clears {
            for i in 0..CLEARS {
                self.context.execute(&Call::GrBufferClear { color: i, alpha: 0, depth: 0xffff });
            }
        } else if self.workload.uses_depth() {
            // A clear obeys the depth mask.
            let written = i32::from(self.workload.kind != Kind::Blended);
            self.context.execute(&Call::GrDepthMask { mask: 1 });
            self.context.execute(&clear);
            self.context.execute(&Call::GrDepthMask { mask: written });
        }
        let flat = self.workload.is_flat();
        for (i, [a, b, c]) in self.vertices.as_chunks().0.iter().enumerate() {
            if flat && i % 2 == 0 {
                let value = 0x0001_0307 * (i as u32 + 1);
                self.context.execute(&Call::GrConstantColorValue { value });
            }
            self.context.draw_triangle(a, b, c);
        }
        self.context.execute(&Call::GrBufferSwap { interval: 0 });
    }

    fn count(&self) -> f64 {
        let pixels = f64::from(self.size.0) * f64::from(self.size.1);
        match self.workload.kind {
            Kind::Triangles { count, .. } => count as f64,
            Kind::Clears => pixels * f64::from(CLEARS),
            _ => pixels * f64::from(OVERDRAW),
        }
    }

    fn digest(&mut self) -> Result<u64> {
        let shown = self.context.shown().context("nothing is shown")?;
        Ok(Frame::new(shown.width, shown.height, Pixels::Rgb565(shown.pixels))?.hash())
    }
}

fn vertices(workload: &Workload, size: (f32, f32)) -> Vec<GrVertex> {
    let layers = |gouraud: bool, perspective: bool, alpha: u32| {
        let layer = |i: u32| {
            let depth = i as f32 / OVERDRAW as f32 * 0.9;
            let z = if workload.front_to_back { 0.05 + depth } else { 0.95 - depth };
            scene::quad(size, z, gouraud, perspective, alpha, i + 1)
        };
        (0..OVERDRAW).flat_map(layer).collect()
    };
    match workload.kind {
        Kind::Flat | Kind::FlatDepth => layers(false, false, 255),
        Kind::Gouraud => layers(true, false, 255),
        Kind::Textured | Kind::TwoTextures => layers(true, true, 255),
        Kind::Blended => layers(true, true, 128),
        Kind::Triangles { count, area } => scene::triangles(count, size, area as f32),
        Kind::Clears => Vec::new(),
    }
}
