//! Random sequences of commands.

use std::sync::Arc;

use fillrate_engine::state::{DepthSource, Dither, DrawState, Rect};
use fillrate_engine::{
    ClearValues, Cull, PixelFormat, PixelRun, Registers, VeriteExtra, VeriteVertex, Vertex,
    VertexExtra,
};

use super::{Rng, draw_state, extras, registers, textures, verite_corners, vertices};
use crate::canvas::Canvas;
use crate::reference::{Reference, Textures};

/// One drawing command with all it needs.
#[derive(Clone, Debug)]
#[expect(missing_docs, reason = "the fields are the arguments of Canvas")]
pub enum Command {
    /// [`Canvas::set_state`].
    State { state: Box<DrawState>, textures: Textures },
    /// [`Canvas::triangle`].
    Triangle { vertices: Box<[Vertex; 3]>, cull: Cull },
    /// [`Canvas::extended`].
    Extended { vertices: Box<[Vertex; 3]>, extras: Box<[VertexExtra; 3]>, cull: Cull },
    /// [`Canvas::verite`].
    Verite { corners: Box<[(VeriteVertex, VeriteExtra); 3]> },
    /// [`Canvas::launch`].
    Launch { registers: Box<Registers> },
    /// [`Canvas::pixels`].
    Pixels { x: u32, y: u32, colors: Arc<[u32]>, depths: Arc<[u16]> },
    /// [`Canvas::clear`].
    Clear { rect: Rect, values: ClearValues },
}

impl Command {
    /// Carries the command out.
    pub fn draw(&self, canvas: &mut dyn Canvas) {
        match self {
            Command::State { state, textures } => canvas.set_state(state, textures),
            Command::Triangle { vertices, cull } => canvas.triangle(vertices, *cull),
            Command::Extended { vertices, extras, cull } => {
                canvas.extended(vertices, extras, *cull);
            }
            Command::Verite { corners } => canvas.verite(corners),
            Command::Launch { registers } => canvas.launch(registers),
            Command::Pixels { x, y, colors, depths } => {
                canvas.pixels(&PixelRun { x: *x, y: *y, colors, depths });
            }
            Command::Clear { rect, values } => canvas.clear(*rect, *values),
        }
    }
}

/// Surfaces and what is drawn on them.
#[derive(Clone, Debug)]
pub struct Case {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Format of the colour surface.
    pub format: PixelFormat,
    /// Format of the aux surface, where there is one.
    pub aux: Option<PixelFormat>,
    /// Seed of the surfaces' first contents; zeros without.
    pub contents: Option<u64>,
    /// In order.
    pub commands: Vec<Command>,
}

impl Case {
    /// The surfaces before the first command.
    pub fn surfaces(&self) -> Reference {
        let mut out = Reference::new(self.width, self.height, self.format, self.aux);
        let Some(seed) = self.contents else { return out };
        let mut rng = Rng::new(seed);
        let mask = self.format.element_mask();
        out.color.fill_with(|| rng.word() & mask);
        if let Some(aux) = &mut out.aux {
            let mask = self.aux.map_or(0, PixelFormat::element_mask);
            aux.fill_with(|| rng.word() & mask);
        }
        out
    }
}

/// Commands of a state that draws many: more than a worker takes at once.
const MANY: u32 = 700;

/// The case of a seed.
pub fn case(seed: u64) -> Case {
    let rng = &mut Rng::new(seed);
    let (width, height) = size(rng);
    let formats = [
        PixelFormat::Rgb565,
        PixelFormat::Rgb565,
        PixelFormat::Rgb565,
        PixelFormat::Rgb565,
        PixelFormat::Rgb565,
        PixelFormat::Argb1555,
        PixelFormat::Argb4444,
        PixelFormat::Argb8888,
        PixelFormat::Xrgb1555,
        PixelFormat::Xrgb8888,
        PixelFormat::Rgb332,
        PixelFormat::Gray8,
        PixelFormat::Alpha8,
    ];
    let format = rng.pick(&formats);
    let aux = match rng.below(8) {
        0 => None,
        1 | 2 => Some(PixelFormat::Aux32),
        _ => Some(PixelFormat::Aux16),
    };
    let contents = rng.maybe(2, Rng::bits);
    let states = 1 + rng.below(3);
    let mut commands = Vec::new();
    for _ in 0..states {
        let mut state = draw_state(rng, width, height);
        if aux == Some(PixelFormat::Aux32) && rng.coin() {
            state.depth.source = rng.pick(&[DepthSource::DeepZ, DepthSource::DeepW]);
        }

        let textures = textures(rng, &state);
        commands.push(Command::State { state: Box::new(state), textures });
        let count = if rng.one_in(400) { MANY } else { 1 + rng.below(4) };
        commands.extend((0..count).map(|_| command(rng, width, height)));
    }
    Case { width, height, format, aux, contents, commands }
}

fn size(rng: &mut Rng) -> (u32, u32) {
    match rng.below(8) {
        0 => (160, 100),
        1 => (1 + rng.below(150), 1 + rng.below(100)),
        2 => (130, 37),
        _ => (64, 64),
    }
}

fn command(rng: &mut Rng, width: u32, height: u32) -> Command {
    match rng.below(12) {
        0 => Command::Clear { rect: rect(rng, width, height), values: clear_values(rng) },
        1 => pixels(rng, width, height),
        4..=6 => Command::Extended {
            vertices: Box::new(vertices(rng, width, height)),
            extras: Box::new(extras(rng)),
            cull: rng.pick(&[Cull::Disabled, Cull::Disabled, Cull::Negative, Cull::Positive]),
        },
        7 | 8 => Command::Verite { corners: Box::new(verite_corners(rng, width, height)) },
        2 | 3 => Command::Launch { registers: Box::new(registers(rng, width, height)) },
        _ => Command::Triangle {
            vertices: Box::new(vertices(rng, width, height)),
            cull: rng.pick(&[Cull::Disabled, Cull::Disabled, Cull::Negative, Cull::Positive]),
        },
    }
}

fn rect(rng: &mut Rng, width: u32, height: u32) -> Rect {
    let (x, y) = (rng.below(width), rng.below(height));
    match rng.below(6) {
        0 => Rect::new(0, 0, width, height),
        1 => Rect::new(rng.word(), rng.word(), rng.word(), rng.word()),
        2 => Rect::new(x, y, u32::MAX, u32::MAX),
        _ => Rect::new(x, y, x + rng.below(70), y + rng.below(70)),
    }
}

fn clear_values(rng: &mut Rng) -> ClearValues {
    let dithers = [Dither::Off, Dither::Ordered2x2, Dither::Ordered4x4];
    let color = if rng.one_in(4) { None } else { Some((rng.word(), rng.pick(&dithers))) };
    let aux = if rng.one_in(4) { None } else { Some(rng.word()) };
    ClearValues { color, aux }
}

fn pixels(rng: &mut Rng, width: u32, height: u32) -> Command {
    let count = rng.below(width + 20);
    let uneven = if rng.one_in(8) { count / 2 } else { count };
    Command::Pixels {
        x: if rng.coin() { 0 } else { rng.below(width + 2) },
        y: if rng.one_in(16) { rng.word() } else { rng.below(height + 1) },
        colors: (0..count).map(|_| rng.word()).collect(),
        depths: (0..uneven).map(|_| rng.word() as u16).collect(),
    }
}
