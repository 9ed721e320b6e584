//! A workload on a board, through the Glide API.

use anyhow::{Context as _, Result, bail};
use fillrate_engine::{Counters, DeviceConfig};
use fillrate_glide::{Call, Context, GlideConfig, GrVertex, gu};
use fillrate_player::{Frame, Pixels};

use super::drawing::Drawing;
use super::scene;
use super::size::Size;
use super::workload::{Kind, Workload};

/// What clears both planes: black, farthest.
const CLEAR: Call = Call::GrBufferClear { color: 0, alpha: 0, depth: 0xffff };

/// An open board in a workload's state.
pub struct Board {
    workload: Workload,
    size: Size,
    context: Context,
    vertices: Vec<GrVertex>,
}

impl Board {
    /// Opens a board and sets the workload's state.
    pub fn new(workload: Workload, size: Size, device: DeviceConfig) -> Result<Board> {
        let mut board = Board::open(workload, size, device)?;
        board.vertices = workload.vertices(size);
        Ok(board)
    }

    /// The same without triangles.
    pub fn open(workload: Workload, size: Size, device: DeviceConfig) -> Result<Board> {
        let resolution = size.resolution().context("no board shows this size")?;
        let context = Context::new(GlideConfig { device, ..GlideConfig::default() })?;
        let mut board = Board { workload, size, context, vertices: Vec::new() };
        board.set(&[Call::GrGlideInit {}]);
        let open = Call::GrSstWinOpen {
            window: 0,
            resolution,
            refresh: 0,
            color_format: 0,
            origin: 0,
            colors: 2,
            aux: 1,
        };
        if board.context.execute(&open) == 0 {
            bail!("the board cannot be opened");
        }
        board.set_state();
        Ok(board)
    }

    /// The library.
    pub fn context(&mut self) -> &mut Context {
        &mut self.context
    }

    fn set(&mut self, calls: &[Call]) {
        for call in calls {
            self.context.execute(call);
        }
    }

    fn set_state(&mut self) {
        let kind = self.workload.kind;
        self.set(&[
            Call::GrDitherMode { mode: 2 },
            Call::GuColorCombineFunction { function: if kind == Kind::Flat { 1 } else { 2 } },
        ]);
        if self.workload.uses_depth() {
            self.set(&[
                Call::GrDepthBufferMode { mode: 1 },
                Call::GrDepthBufferFunction { function: 3 },
                Call::GrDepthMask { mask: i32::from(self.workload.writes_depth()) },
            ]);
        }
        let modulate = Call::GuColorCombineFunction { function: 6 };
        let one_texture = [Call::GrTexCombineFunction { tmu: 0, function: 1 }, modulate];
        match kind {
            Kind::Textured | Kind::Triangles { .. } => {
                self.set_base_texture();
                self.set(&one_texture);
            }
            Kind::Blended => {
                self.set_base_texture();
                self.set(&one_texture);
                self.set_blending();
            }
            Kind::TwoTextures => {
                self.set_base_texture();
                self.set_light_map();
                self.set_fog();
            }
            Kind::Flat | Kind::Gouraud | Kind::Clear { .. } => {}
        }
    }

    fn set_blending(&mut self) {
        self.set(&[
            Call::GuAlphaSource { mode: 1 },
            Call::GrAlphaBlendFunction {
                rgb_source: 1,
                rgb_destination: 5,
                alpha_source: 4,
                alpha_destination: 0,
            },
        ]);
    }

    fn set_fog(&mut self) {
        self.set(&[
            Call::GrFogTable { table: gu::fog_table_exp(0.35) },
            Call::GrFogColorValue { color: 0x0080_99b3 },
            Call::GrFogMode { mode: 2 },
        ]);
    }

    /// 256x256 with nearest mip maps.
    fn set_base_texture(&mut self) {
        self.set_texture(0, 0, scene::texture(scene::BASE_SIDE, scene::BASE_SEED));
        self.set(&[Call::GrTexMipMapMode { tmu: 0, mode: 1, blend: 0 }]);
    }

    /// 64x64 without mip maps on the second unit, multiplied with the first.
    fn set_light_map(&mut self) {
        self.set_texture(1, 2, scene::texture(scene::LIGHT_SIDE, scene::LIGHT_SEED));
        self.set(&[
            Call::GrTexMipMapMode { tmu: 1, mode: 0, blend: 0 },
            Call::GrTexCombineFunction { tmu: 1, function: 1 },
            Call::GrTexCombineFunction { tmu: 0, function: 4 },
            // The second unit has its own coordinates.
            Call::GrHints { hint: 0, mask: 0x10 },
            Call::GuColorCombineFunction { function: 6 },
        ]);
    }

    /// A repeating bilinear texture of 565 texels from that level down.
    fn set_texture(&mut self, tmu: i32, large_lod: i32, texels: Vec<u8>) {
        let (start, even_odd, small_lod, aspect, format) = (0, 3, 8, 3, 0xa);
        self.set(&[
            Call::GrTexDownloadMipMap {
                tmu,
                start,
                even_odd,
                small_lod,
                large_lod,
                aspect,
                format,
                data: texels.into(),
            },
            Call::GrTexSource { tmu, start, even_odd, small_lod, large_lod, aspect, format },
            Call::GrTexFilterMode { tmu, minify: 1, magnify: 1 },
            Call::GrTexClampMode { tmu, s: 0, t: 0 },
        ]);
    }
}

impl Drawing for Board {
    fn frame(&mut self) {
        if self.workload.uses_depth() {
            // A clear obeys the depth mask.
            let written = i32::from(self.workload.writes_depth());
            self.set(&[Call::GrDepthMask { mask: 1 }, CLEAR, Call::GrDepthMask { mask: written }]);
        }
        let flat = self.workload.kind == Kind::Flat;
        for (i, [a, b, c]) in self.vertices.as_chunks().0.iter().enumerate() {
            if flat && i % 2 == 0 {
                self.context.execute(&constant_color(i / 2));
            }
            self.context.draw_triangle(a, b, c);
        }
        self.set(&[Call::GrBufferSwap { interval: 0 }]);
    }

    fn count(&self) -> f64 {
        self.workload.count(self.size)
    }

    fn picture(&mut self) -> Result<Frame> {
        let shown = self.context.shown().context("nothing is shown")?;
        Ok(Frame::new(shown.width, shown.height, Pixels::Rgb565(shown.pixels))?)
    }

    fn counters(&mut self) -> Counters {
        self.context.total_counters()
    }
}

/// Sets the colour of a quad of the flat workload.
pub fn constant_color(quad: usize) -> Call {
    Call::GrConstantColorValue { value: 0x0001_0307 * (2 * quad as u32 + 1) }
}
