//! The workloads of RRedline.
//!
//! Full-screen layers are drawn as by W1 to W4, so that rates compare; R1 only
//! records triangles into command buffers, which is the program's half.

use anyhow::{Context as _, Result};
use fillrate_engine::{Counters, DeviceConfig};
use fillrate_player::{Frame, Pixels};
use fillrate_redline::surface::{PRIMARY, Z_BUFFER};
use fillrate_redline::{
    BufferGroup, Call, CommandBuffer, CommandSink, Context, NoMemory, RedlineConfig, Surface,
    VertexType, record,
};

use super::drawing::Drawing;
use super::scene::Random;
use super::size::Size;

/// What a workload draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Triangles recorded and dropped.
    Submit,
    /// Full-screen layers in one colour each.
    Flat,
    /// Layers with colours between corners and depths, each nearer than the
    /// one before.
    Gouraud,
    /// Layers with a filtered texture in perspective, and depths.
    Textured,
    /// Layers of a half transparent texture.
    Blended,
    /// Triangles of ten pixels with depths.
    Small,
}

/// All of them.
pub const WORKLOADS: [(&str, Kind); 6] = [
    ("R1_submit_kxyz", Kind::Submit),
    ("R2_fill_flat", Kind::Flat),
    ("R3_gouraud_z_b2f", Kind::Gouraud),
    ("R4_tex_bilin_z_b2f", Kind::Textured),
    ("R5_tex_blend", Kind::Blended),
    ("R6_tri_10px", Kind::Small),
];

/// Layers of the full-screen workloads.
const LAYERS: u32 = 20;
/// Triangles of a frame of small ones, and of one that is only recorded.
const SMALL: usize = 100_000;
/// Words of a command buffer.
const WORDS: usize = 1 << 14;
/// Columns and rows of the texture.
const TEXTURE: u32 = 64;

/// What is counted.
pub fn unit(kind: Kind) -> &'static str {
    if matches!(kind, Kind::Submit | Kind::Small) { "Mtri/s" } else { "Mpix/s" }
}

/// A workload on a device.
pub struct Prepared {
    kind: Kind,
    context: Context,
    device: u32,
    display: u32,
    buffer: u32,
    commands: CommandBuffer,
    vertex: VertexType,
    /// The words of all vertices, three after three.
    vertices: Vec<u32>,
    /// Before each two triangles, where layers have one colour.
    colors: Vec<u32>,
    count: f64,
}

impl Prepared {
    /// Opens a device and makes what the workload draws.
    pub fn new(kind: Kind, size: Size, device: DeviceConfig) -> Result<Prepared> {
        let config = RedlineConfig { memory: 8, background: false, device, ..Default::default() };
        let mut context = Context::new(config);
        let mut make = |call: &Call| context.execute(call).map(|reply| reply.number());
        let device = make(&Call::OpenVerite {})?;
        let Size { width, height } = size;
        make(&Call::SetDisplayType { device, display_type: 2 })?;
        make(&Call::SetDisplayMode { device, width, height, bits: 16, refresh: 60 })?;
        let (mask, format) = (PRIMARY | Z_BUFFER, 4);
        let display =
            make(&Call::CreateSurface { device, mask, buffers: 3, format, width, height })?;
        let (width, height, format) = (TEXTURE, TEXTURE, texture_format(kind));
        let texture =
            make(&Call::CreateSurface { device, mask: 0, buffers: 1, format, width, height })?;
        let buffer = make(&Call::CreateCmdBuffer { device, entries: 4, words: WORDS as i32 })?;
        let (vertex, vertices) = vertices(kind, size);
        let colors = (0..LAYERS).map(|layer| 0xff00_0000 | (layer * 0x000b_0703)).collect();
        let commands = CommandBuffer::new(buffer, 4, WORDS).map_err(anyhow::Error::msg)?;
        let count = match kind {
            Kind::Submit | Kind::Small => SMALL as f64,
            _ => f64::from(LAYERS) * f64::from(size.width) * f64::from(size.height),
        };
        let mut prepared = Prepared {
            kind,
            context,
            device,
            display,
            buffer,
            commands,
            vertex,
            vertices,
            colors,
            count,
        };
        prepared.install(texture, format)?;
        Ok(prepared)
    }

    fn group(&self, group: u32) -> Result<BufferGroup> {
        self.context.group(self.device, group).cloned().context("the group is gone")
    }

    /// State and texture.
    fn install(&mut self, texture: u32, format: u32) -> Result<()> {
        let (display, group) = (self.group(self.display)?, self.group(texture)?);
        let to = &mut self.commands;
        let surface = Surface::new(display.width, display.height, 4);
        record::install_dst_buffer(to, &surface, &display)?;
        record::install_z_buffer(to, &display)?;
        record::install_texture_map(to, &Surface::new(TEXTURE, TEXTURE, format), &group)?;
        let place = [group.address(0).context("it has one")?, group.linebytes];
        let texels = texels(format);
        record::mem_write_rect_inline(to, place, [TEXTURE * 2, TEXTURE], &texels)?;
        let textured = matches!(self.kind, Kind::Textured | Kind::Blended);
        record::set_src_func(to, u32::from(textured))?;
        record::set_src_filter(to, u32::from(self.kind == Kind::Textured))?;
        let depths = matches!(self.kind, Kind::Gouraud | Kind::Textured | Kind::Small);
        record::set_z_buf_mode(to, u32::from(depths))?;
        record::set_z_buf_wr_mode(to, u32::from(depths))?;
        record::set_blend_enable(to, u32::from(self.kind == Kind::Blended))?;
        record::set_blend_src_func(to, 2)?;
        record::set_blend_dst_func(to, 3)?;
        self.issue()
    }

    fn issue(&mut self) -> Result<()> {
        let segments = self.commands.snapshot(&NoMemory).map_err(anyhow::Error::msg)?;
        self.commands.reset();
        let (device, buffer) = (self.device, self.buffer);
        let call = Call::IssueCmdBuffer { device, buffer, segments, wait: true };
        self.context.execute(&call)?;
        Ok(())
    }

    /// Records all triangles; hands full buffers over, or drops them.
    fn record(&mut self) -> Result<()> {
        let size = self.vertex.words();
        let room = 3 * size + 3;
        let vertices = std::mem::take(&mut self.vertices);
        for (i, corners) in vertices.chunks_exact(3 * size).enumerate() {
            if self.commands.free_space().0 < room {
                match self.kind {
                    Kind::Submit => self.commands.reset(),
                    _ => self.issue()?,
                }
            }
            if self.kind == Kind::Flat && i % 2 == 0 {
                record::set_fg_color_argb(&mut self.commands, self.colors[i / 2])?;
            }
            let (a, rest) = corners.split_at(size);
            let (b, c) = rest.split_at(size);
            record::triangle(&mut self.commands, self.vertex.code(), a, b, c)?;
        }
        self.vertices = vertices;
        Ok(())
    }

    /// Draws a frame and shows it.
    fn draw(&mut self) -> Result<()> {
        if self.kind == Kind::Submit {
            return self.record();
        }
        let display = self.group(self.display)?;
        let size = [display.width, display.height];
        record::fill_buffer(&mut self.commands, &display, 2, [0, 0], size, 0xffff)?;
        if matches!(self.kind, Kind::Small | Kind::Blended) {
            record::fill_buffer(&mut self.commands, &display, 1, [0, 0], size, 0)?;
        }
        self.record()?;
        self.show(&display)
    }

    fn show(&mut self, display: &BufferGroup) -> Result<()> {
        if self.commands.free_space().0 < 16 {
            self.issue()?;
        }
        record::swap_display_surface(&mut self.commands, display)?;
        let (device, group) = (self.device, self.display);
        self.context.execute(&Call::SwapBuffers { device, group, a: 0, b: 1 })?;
        self.issue()
    }

    /// Shows what the last recorded buffer draws.
    fn show_recorded(&mut self) -> Result<(), anyhow::Error> {
        let display = self.group(self.display)?;
        let words = self.commands.words().to_vec();
        self.commands.reset();
        let size = [display.width, display.height];
        record::fill_buffer(&mut self.commands, &display, 1, [0, 0], size, 0)?;
        self.issue()?;
        let out = self.commands.reserve(words.len(), 0).map_err(anyhow::Error::msg)?;
        out.copy_from_slice(&words);
        self.issue()?;
        self.show(&display)
    }
}

impl Drawing for Prepared {
    fn frame(&mut self) {
        // What is drawn has its size from what was made.
        self.draw().expect("the workload fits its board");
    }

    fn count(&self) -> f64 {
        self.count
    }

    fn picture(&mut self) -> Result<Frame> {
        if self.kind == Kind::Submit {
            self.commands.reset();
            self.record()?;
            self.show_recorded()?;
        }
        let shown = self.context.shown().context("nothing is shown")?;
        Ok(Frame::new(shown.width, shown.height, Pixels::Rgb565(shown.pixels))?)
    }

    fn counters(&mut self) -> Counters {
        self.context.counters(self.device).unwrap_or_default()
    }
}

/// 4444 where texels have alpha, else 565.
fn texture_format(kind: Kind) -> u32 {
    if kind == Kind::Blended { 5 } else { 4 }
}

/// Two texels in a word; half transparent ones for 4444.
fn texels(format: u32) -> Vec<u32> {
    let mut random = Random(77);
    let mut texel = |i: u32| {
        let (x, y) = (i % TEXTURE, i / TEXTURE);
        let noise = (random.bits() >> 8) & 3;
        match format {
            5 => 0x8000 | (x >> 2) << 8 | (y >> 2) << 4 | noise << 2,
            _ => (x >> 1) << 11 | y << 5 | noise << 3,
        }
    };
    (0..TEXTURE * TEXTURE / 2).map(|i| texel(2 * i) | texel(2 * i + 1) << 16).collect()
}

/// The vertex type and the vertices of a workload.
fn vertices(kind: Kind, size: Size) -> (VertexType, Vec<u32>) {
    match kind {
        Kind::Submit | Kind::Small => (VertexType::KXYZ, small(size)),
        Kind::Flat => (VertexType::XY, layers(size, |_, corner, _| corner.to_vec())),
        Kind::Gouraud => {
            (VertexType::KXYZ, layers(size, |layer, [x, y], color| vec![color, x, y, depth(layer)]))
        }
        Kind::Textured => (VertexType::XYZUVQ, layers(size, textured)),
        Kind::Blended => (
            VertexType::XYUVQ,
            layers(size, |layer, corner, color| {
                let mut vertex = textured(layer, corner, color);
                vertex.remove(2);
                vertex
            }),
        ),
    }
}

/// Depth of a layer: each is nearer than the one before.
fn depth(layer: u32) -> u32 {
    (60_000 - layer * 1000) << 16
}

/// A corner of a floor: the upper edge is three times as far. The texture
/// repeats, ten texels for each ten pixels below.
fn textured(layer: u32, [x, y]: [u32; 2], _color: u32) -> Vec<u32> {
    let texels = |at: u32| at / TEXTURE;
    let q = if y == 0 { 0x2a_aaaa } else { 0x7f_ffff };
    vec![x, y, depth(layer), texels(x), texels(y), q]
}

/// Two triangles for each layer; `corner` makes a vertex of a layer's number, a
/// place in 16.16 and a colour.
fn layers(size: Size, corner: impl Fn(u32, [u32; 2], u32) -> Vec<u32>) -> Vec<u32> {
    let mut random = Random(0x1234_5678);
    let (width, height) = (size.width << 16, size.height << 16);
    let mut out = Vec::new();
    for layer in 0..LAYERS {
        let corners = [[0, height], [width, height], [width, 0], [0, 0]];
        let corners = corners.map(|place| corner(layer, place, random.bits() & 0x00ff_ffff));
        for i in [0, 1, 2, 0, 2, 3] {
            out.extend(&corners[i]);
        }
    }
    out
}

/// Triangles of about ten pixels all over the screen.
fn small(size: Size) -> Vec<u32> {
    let mut random = Random(99);
    let mut below = |end: u32| (random.bits() >> 8) % end;
    let mut out = Vec::with_capacity(SMALL * 12);
    for _ in 0..SMALL {
        let (x, y) = (below(size.width - 8), below(size.height - 8));
        for (dx, dy) in [(0, 0), (5, 1), (1, 5)] {
            out.extend([below(1 << 24), (x + dx) << 16, (y + dy) << 16, below(60_000) << 16]);
        }
    }
    out
}
