//! A workload beyond what boards show, through the engine's API: the draw
//! state, textures and vertices are those that a board hands to the engine.
//!
//! Vertices have 12.4 coordinates, so a surface can be drawn to up to column
//! and row 2047. Larger pictures are several surfaces side by side, each with
//! the whole scene on it and its share of the small triangles.

use std::sync::Arc;

use anyhow::{Context as _, Result};
use fillrate_engine::state::{Dither, MAX_TMUS, Rect};
use fillrate_engine::{
    ClearValues, Counters, Cull, Device, DeviceConfig, DrawState, FlushReason, PixelFormat,
    SurfaceId, Texture, TextureDesc, Vertex,
};
use fillrate_glide::GrVertex;
use fillrate_player::{Frame, Pixels};

use super::board::{Board, constant_color};
use super::drawing::Drawing;
use super::scene;
use super::size::Size;
use super::workload::{Kind, Workload};

/// The longest side of one surface.
const PART_SIDE: u32 = 2048;
/// The largest coordinate of a vertex.
const MAX_COORDINATE: f32 = 2047.9375;
/// Boards of this size lend their state.
const LENDER: Size = Size { width: 640, height: 480 };

/// A texture for each unit.
type Textures = [Option<Arc<Texture>>; MAX_TMUS];

/// Triangles of one draw state.
struct Batch {
    state: DrawState,
    textures: Textures,
    triangles: Vec<[Vertex; 3]>,
}

/// A part of the picture.
struct Part {
    /// On the picture.
    rect: Rect,
    color: SurfaceId,
    aux: SurfaceId,
    batches: Vec<Batch>,
}

/// A device with the surfaces of a picture.
pub struct Surfaces {
    workload: Workload,
    size: Size,
    device: Device,
    parts: Vec<Part>,
}

impl Surfaces {
    /// Makes the surfaces. Textured workloads take a texture of
    /// `texture_side` texels where it is given, a power of two up to 2048.
    pub fn new(
        workload: Workload,
        size: Size,
        config: DeviceConfig,
        texture_side: Option<u32>,
    ) -> Result<Surfaces> {
        let mut board = Board::open(workload, LENDER, config.clone())?;
        let texture = texture_side.map(large_texture).transpose()?;
        let mut device = Device::new(config)?;
        let mut parts = Vec::new();
        let count = cuts(size.width).count() * cuts(size.height).count();
        for (x0, x1) in cuts(size.width) {
            for (y0, y1) in cuts(size.height) {
                let rect = Rect::new(x0, y0, x1, y1);
                let (width, height) = (x1 - x0, y1 - y0);
                let vertices = workload.share(count).vertices(Size { width, height });
                let batches = batches(&mut board, &workload, &vertices, texture.as_ref())?;
                let color = device.create_surface(width, height, PixelFormat::Rgb565)?;
                let aux = device.create_surface(width, height, PixelFormat::Aux16)?;
                parts.push(Part { rect, color, aux, batches });
            }
        }
        Ok(Surfaces { workload, size, device, parts })
    }
}

impl Drawing for Surfaces {
    fn frame(&mut self) {
        for part in &self.parts {
            // Both were made by this device, of one size.
            let _ = self.device.set_target(part.color, Some(part.aux));
            if self.workload.uses_depth() {
                let (width, height) = (part.rect.x1 - part.rect.x0, part.rect.y1 - part.rect.y0);
                let values =
                    ClearValues { color: Some((0, Dither::Ordered4x4)), aux: Some(0xffff) };
                self.device.clear(Rect::new(0, 0, width, height), values);
            }
            for batch in &part.batches {
                self.device.set_state(&batch.state, batch.textures.clone());
                for [a, b, c] in &batch.triangles {
                    self.device.draw_triangle([a, b, c], Cull::Disabled);
                }
            }
            self.device.submit(FlushReason::Swap);
        }
    }

    fn count(&self) -> f64 {
        self.workload.count(self.size)
    }

    fn picture(&mut self) -> Result<Frame> {
        let Size { width, height } = self.size;
        let mut pixels = vec![0; (width * height) as usize];
        for part in &self.parts {
            let Rect { x0, y0, x1, y1 } = part.rect;
            let first = (y0 * width + x0) as usize;
            let all = Rect::new(0, 0, x1 - x0, y1 - y0);
            self.device.read16(part.color, all, &mut pixels[first..], width as usize)?;
        }
        Ok(Frame::new(width, height, Pixels::Rgb565(pixels))?)
    }

    fn counters(&mut self) -> Counters {
        self.device.counters()
    }
}

/// The parts of a side.
fn cuts(side: u32) -> impl Iterator<Item = (u32, u32)> + Clone {
    (0..side).step_by(PART_SIDE as usize).map(move |at| (at, side.min(at + PART_SIDE)))
}

/// The draw states of a part, each with its triangles.
fn batches(
    board: &mut Board,
    workload: &Workload,
    vertices: &[GrVertex],
    texture: Option<&Arc<Texture>>,
) -> Result<Vec<Batch>> {
    let flat = workload.kind == Kind::Flat;
    // A quad of the flat workload has its own state; others share one.
    let group = if flat { 6 } else { vertices.len().max(1) };
    let mut batches = Vec::new();
    for (i, vertices) in vertices.chunks(group).enumerate() {
        if flat {
            board.context().execute(&constant_color(i));
        }
        let (mut state, mut textures) =
            board.context().draw_state().context("the board is closed")?;
        // The board's window is not the surface's.
        state.clip = None;
        if let (Some(texture), Some(first)) = (texture, &mut textures[0]) {
            *first = texture.clone();
        }
        let mut triangles = Vec::new();
        for corners in vertices.as_chunks::<3>().0 {
            let converted = corners.map(|v| board.context().engine_vertex(&limited(&v)));
            let [Some(a), Some(b), Some(c)] = converted else { continue };
            triangles.push([a, b, c]);
        }
        batches.push(Batch { state, textures, triangles });
    }
    Ok(batches)
}

/// A vertex no farther than the largest coordinate: an edge there covers the
/// same pixels as one at 2048.
fn limited(v: &GrVertex) -> GrVertex {
    GrVertex { x: v.x.min(MAX_COORDINATE), y: v.y.min(MAX_COORDINATE), ..*v }
}

/// A chain of levels from `side` texels down to one.
fn large_texture(side: u32) -> Result<Arc<Texture>> {
    let bits = side.ilog2() as u8;
    let desc = TextureDesc { s_bits: bits, t_bits: bits, first: 0, last: bits, clamp_s: false };
    let bytes = scene::texture(side as usize, scene::BASE_SEED);
    let mut texels = bytes.as_chunks().0.iter().map(|texel| argb(u16::from_le_bytes(*texel)));
    let texture = Texture::build(desc, |level, out| {
        let side = side as usize >> level;
        out.extend(texels.by_ref().take(side * side));
    })?;
    Ok(Arc::new(texture))
}

/// A 565 texel as 0xAARRGGBB, high bits repeated below.
fn argb(texel: u16) -> u32 {
    let (r, g, b) = (u32::from(texel >> 11), u32::from(texel >> 5 & 63), u32::from(texel & 31));
    0xff00_0000 | (r << 3 | r >> 2) << 16 | (g << 2 | g >> 4) << 8 | (b << 3 | b >> 2)
}
