//! The workloads of RAVE.
//!
//! Layers and triangles are those of W2 to W7, so that rates compare; the mesh
//! shares its vertices, as programs of RAVE do.

use anyhow::{Context as _, Result};
use fillrate_engine::{Counters, DeviceConfig};
use fillrate_glide::GrVertex;
use fillrate_player::{Frame, Pixels};
use fillrate_rave::constants::{
    blend, compare, context, device, fog, quality, texture, texture_op, vertex_mode,
};
use fillrate_rave::tags::{float, int, pointer};
use fillrate_rave::{
    Call, Context, DeviceValue, DrawContextId, EngineId, ImageValue, IndexedTriangle, PixelType,
    RaveConfig, RaveRect, VGouraud, VTexture,
};

use super::drawing::Drawing;
use super::scene::{self, Quad};
use super::size::Size;
use super::workload::OVERDRAW;

/// What a workload draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Layers with colours between corners, each nearer than the one before.
    Gouraud,
    /// Layers with a filtered texture in perspective, the same way.
    Textured,
    /// The same, times a colour between corners.
    Modulated,
    /// The same under fog by distance.
    Fogged,
    /// Layers of half transparent colours times texels, depth not written.
    Blended,
    /// Textured triangles of ten pixels that share their corners.
    Mesh,
    /// Textured triangles of ten pixels in one array.
    Array,
    /// The same, each by a call of its own.
    Single,
}

/// All of them.
pub const WORKLOADS: [(&str, Kind); 8] = [
    ("A1_gouraud_z_b2f", Kind::Gouraud),
    ("A2_tex_bilin_z_b2f", Kind::Textured),
    ("A3_tex_modulate_z_b2f", Kind::Modulated),
    ("A4_tex_modulate_fog_z_b2f", Kind::Fogged),
    ("A5_tex_blend", Kind::Blended),
    ("A6_mesh_10px", Kind::Mesh),
    ("A7_tri_10px", Kind::Array),
    ("A8_immediate", Kind::Single),
];

const ENGINE: u32 = EngineId::BUILT_IN.0;
/// Triangles of an array.
const SMALL: usize = 100_000;
/// Pixels of one of them.
const AREA: f32 = 10.0;
/// Columns and rows of a mesh's cell, which is two triangles of ten pixels.
const CELL: (u32, u32) = (5, 4);

impl Kind {
    /// Whether layers are drawn, and not small triangles.
    fn is_layers(self) -> bool {
        !matches!(self, Kind::Mesh | Kind::Array | Kind::Single)
    }

    fn operation(self) -> u32 {
        match self {
            Kind::Textured => texture_op::NONE,
            _ => texture_op::MODULATE,
        }
    }
}

/// What is counted.
pub fn unit(kind: Kind) -> &'static str {
    if kind.is_layers() { "Mpix/s" } else { "Mtri/s" }
}

/// A workload in a draw context.
pub struct Prepared {
    kind: Kind,
    library: Context,
    context: DrawContextId,
    vertices: Vec<VTexture>,
    gouraud: Vec<VGouraud>,
    mesh: Call,
    count: f64,
}

impl Prepared {
    /// Makes a draw context and what the workload draws.
    ///
    /// # Errors
    /// Where the context cannot be made.
    pub fn new(kind: Kind, size: Size, config: DeviceConfig) -> Result<Prepared> {
        // On one thread there is nothing to draw behind the program's back with.
        let asynchronous = config.threads > 1;
        let config = RaveConfig { device: config, asynchronous, ..RaveConfig::default() };
        let mut library = Context::new(config);
        let context = open(&mut library, size)?;
        let vertices = vertices(kind, size);
        let triangles = mesh(size);
        let count = match kind {
            Kind::Mesh => triangles.len() as f64,
            Kind::Array | Kind::Single => SMALL as f64,
            _ => f64::from(OVERDRAW) * f64::from(size.width) * f64::from(size.height),
        };
        let gouraud = vertices.iter().map(plain).collect();
        let mesh = Call::DrawTriMeshTexture { context: context.0, triangles };
        let mut prepared = Prepared { kind, library, context, vertices, gouraud, mesh, count };
        prepared.set_state()?;
        Ok(prepared)
    }

    fn set_state(&mut self) -> Result<()> {
        let context = self.context.0;
        let writes_z = u32::from(self.kind != Kind::Blended);
        let fogs = if self.kind == Kind::Fogged { fog::EXPONENTIAL } else { fog::NONE };
        for (tag, value) in [
            (int::Z_FUNCTION, compare::LE),
            (int::Z_BUFFER_MASK, writes_z),
            (int::BLEND, blend::INTERPOLATE),
            (int::TEXTURE_FILTER, quality::MID),
            (int::TEXTURE_OP, self.kind.operation()),
            (int::FOG_MODE, fogs),
        ] {
            self.library.execute(&Call::SetInt { context, tag, value });
        }
        for (tag, value) in [
            (float::FOG_DENSITY, 0.35),
            (float::FOG_COLOR_R, 0.5),
            (float::FOG_COLOR_G, 0.6),
            (float::FOG_COLOR_B, 0.7),
        ] {
            self.library.execute(&Call::SetFloat { context, tag, value });
        }
        let (flags, pixel_type) = (texture::MIPMAP, PixelType::Rgb16_565.number());
        let made = Call::TextureNew { engine: ENGINE, flags, pixel_type, images: images() };
        let texture = self.library.execute(&made).created();
        anyhow::ensure!(texture != 0, "the texture cannot be made");
        self.library.execute(&Call::SetTexture { context, tag: pointer::TEXTURE, texture });
        self.library.submit_vertices_texture(self.context, &self.vertices);
        Ok(())
    }

    fn draw(&mut self) {
        let context = self.context;
        match self.kind {
            Kind::Gouraud => {
                self.library.draw_v_gouraud(context, vertex_mode::TRI, &self.gouraud);
            }
            Kind::Mesh => {
                self.library.execute(&self.mesh);
            }
            Kind::Single => {
                for &[a, b, c] in self.vertices.as_chunks().0 {
                    let (context, flags) = (context.0, 0);
                    self.library.execute(&Call::DrawTriTexture { context, a, b, c, flags });
                }
            }
            _ => self.library.draw_v_texture(context, vertex_mode::TRI, &self.vertices),
        }
    }
}

impl Drawing for Prepared {
    fn frame(&mut self) {
        let context = self.context.0;
        self.library.execute(&Call::RenderStart { context, dirty: None, initial: 0 });
        self.draw();
        self.library.execute(&Call::RenderEnd { context, modified: None });
    }

    fn count(&self) -> f64 {
        self.count
    }

    fn picture(&mut self) -> Result<Frame> {
        let shown = self.library.shown().context("nothing is shown")?;
        let pixels = shown.pixels.as_chunks().0.iter().map(|&p| u16::from_le_bytes(p)).collect();
        Ok(Frame::new(shown.width, shown.height, Pixels::Rgb565(pixels))?)
    }

    fn counters(&mut self) -> Counters {
        self.library.counters()
    }
}

/// A double-buffered context of 565 pixels with 16 bits of z.
fn open(library: &mut Context, size: Size) -> Result<DrawContextId> {
    let (width, height) = (size.width as i32, size.height as i32);
    let device = DeviceValue {
        device_type: device::OFFSCREEN,
        pixel_type: PixelType::Rgb16_565.number(),
        ..DeviceValue::default()
    };
    let (rect, flags) = (RaveRect::new(0, 0, width, height), context::DOUBLE_BUFFER);
    let (scaled, clip) = (None, None);
    let made = Call::DrawContextNew { engine: ENGINE, device, rect, scaled, clip, flags };
    let context = library.execute(&made).created();
    anyhow::ensure!(context != 0, "no context of {size} can be made");
    Ok(DrawContextId(context))
}

/// The levels of the base texture.
fn images() -> Vec<ImageValue> {
    let texels = scene::texture(scene::BASE_SIDE, scene::BASE_SEED);
    let mut rest = &texels[..];
    let sides =
        std::iter::successors(Some(scene::BASE_SIDE), |&side| (side > 1).then_some(side / 2));
    sides
        .map(|side| {
            let (level, after) = rest.split_at(2 * side * side);
            rest = after;
            let side = side as i32;
            ImageValue { width: side, height: side, pixels: level.to_vec().into() }
        })
        .collect()
}

/// The corners of what is drawn: three for each triangle, or those of the mesh.
fn vertices(kind: Kind, size: Size) -> Vec<VTexture> {
    let screen = (size.width as f32, size.height as f32);
    let layer = |i: u32| {
        let near = 0.9 - 0.04 * i as f32;
        let alpha = if kind == Kind::Blended { 160 } else { 255 };
        let perspective = kind != Kind::Gouraud;
        scene::quad(screen, &Quad { near, gouraud: true, perspective, alpha, seed: i + 1 })
    };
    match kind {
        Kind::Mesh => corners(size),
        Kind::Array | Kind::Single => {
            scene::triangles(SMALL, screen, AREA).iter().map(vertex).collect()
        }
        _ => (0..OVERDRAW).flat_map(layer).map(|v| vertex(&v)).collect(),
    }
}

/// A vertex of the workloads in RAVE's terms.
fn vertex(v: &GrVertex) -> VTexture {
    let unit = |channel: f32| channel / 255.0;
    let [u, v_down] = [v.tmuvtx[0].sow, v.tmuvtx[0].tow].map(|at| at / scene::TEXTURE);
    VTexture {
        x: v.x,
        y: v.y,
        z: v.ooz / 65_535.0,
        inv_w: v.oow,
        a: unit(v.a),
        u_over_w: u,
        v_over_w: v.oow - v_down,
        kd_r: unit(v.r),
        kd_g: unit(v.g),
        kd_b: unit(v.b),
        ..VTexture::default()
    }
}

/// The same without its texture.
fn plain(v: &VTexture) -> VGouraud {
    VGouraud { x: v.x, y: v.y, z: v.z, inv_w: v.inv_w, r: v.kd_r, g: v.kd_g, b: v.kd_b, a: v.a }
}

/// Columns and rows of the mesh's cells.
fn cells(size: Size) -> (u32, u32) {
    (size.width / CELL.0, size.height / CELL.1)
}

/// The corners of a wavy floor that covers the screen.
fn corners(size: Size) -> Vec<VTexture> {
    let (columns, rows) = cells(size);
    let places = (0..=rows).flat_map(|row| (0..=columns).map(move |column| (column, row)));
    places
        .map(|(column, row)| {
            let (x, y) = ((column * CELL.0) as f32, (row * CELL.1) as f32);
            let w = 1.0 + 2.0 * (1.0 - y / size.height as f32);
            let wave = ((column * 7 + row * 13) % 16) as f32 / 16.0;
            VTexture {
                x,
                y,
                z: 0.3 + 0.2 * w,
                inv_w: 1.0 / w,
                a: 1.0,
                u_over_w: x / scene::TEXTURE,
                v_over_w: y / scene::TEXTURE,
                kd_r: 0.5 + 0.5 * wave,
                kd_g: 1.0 - 0.5 * wave,
                kd_b: 0.75,
                ..VTexture::default()
            }
        })
        .collect()
}

/// Two triangles for each cell.
fn mesh(size: Size) -> Vec<IndexedTriangle> {
    let (columns, rows) = cells(size);
    let cells = (0..rows).flat_map(|row| (0..columns).map(move |column| (column, row)));
    cells
        .flat_map(|(column, row)| {
            let a = row * (columns + 1) + column;
            let (b, c, d) = (a + 1, a + columns + 1, a + columns + 2);
            [[a, b, c], [b, d, c]].map(|vertices| IndexedTriangle { flags: 0, vertices })
        })
        .collect()
}
