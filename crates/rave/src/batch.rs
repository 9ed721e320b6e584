//! Work for the renderer, in the order of the calls.

use std::sync::{Arc, Mutex};

use fillrate_engine::state::{Dither, MAX_TMUS, Rect};
use fillrate_engine::{DrawState, Texture, Vertex, VertexExtra};

use crate::front::Front;
use crate::translate::Plane;

/// A draw state with the textures that it samples.
#[derive(Clone, Debug)]
pub(crate) struct FullState {
    pub draw: DrawState,
    pub textures: [Option<Arc<Texture>>; MAX_TMUS],
}

/// A corner with all that it may carry.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Corner {
    pub vertex: Vertex,
    pub extra: VertexExtra,
}

/// What a clear writes; absent planes stay.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ClearPlanes {
    /// Pixels of the context.
    pub rect: Rect,
    /// 0xAARRGGBB.
    pub color: Option<(u32, Dither)>,
    /// z, 0..=1, and with it the plane of 1/w.
    pub depth: Option<f32>,
}

/// Shows a rectangle of a context.
#[derive(Clone, Debug)]
pub(crate) struct Present {
    pub context: u32,
    /// Pixels of the context.
    pub rect: Rect,
    /// `kQABufferComposite`.
    pub composite: u32,
    /// `kQATag_DrawContextFilter`.
    pub filter: u32,
    pub front: Arc<Mutex<Front>>,
}

/// One step of the renderer.
#[derive(Clone, Debug)]
pub(crate) enum Command {
    /// Draws into a context from here on.
    Target { context: u32, plane: Plane },
    /// Draws by [`Batch::states`] of this index.
    State(u32),
    /// Draws so many of [`Batch::triangles`].
    Triangles(u32),
    /// Draws so many of [`Batch::extended`].
    Extended(u32),
    /// Fills the target.
    Clear(ClearPlanes),
    /// Copies a rectangle of another context of the same size into the target.
    Copy { from: u32, rect: Rect, color: bool, depth: bool },
    /// Shows what was drawn.
    Present(Box<Present>),
}

/// A piece of a frame.
#[derive(Debug, Default)]
pub(crate) struct Batch {
    pub commands: Vec<Command>,
    pub triangles: Vec<[Vertex; 3]>,
    pub extended: Vec<[Corner; 3]>,
    pub states: Vec<FullState>,
}

/// Triangles after which a batch is handed over.
const MAX_TRIANGLES: usize = 1 << 10;

impl Batch {
    /// Adds a triangle without further values.
    #[inline(always)]
    pub fn triangle(&mut self, corners: [Vertex; 3]) {
        self.triangles.push(corners);
        match self.commands.last_mut() {
            Some(Command::Triangles(count)) => *count += 1,
            _ => self.commands.push(Command::Triangles(1)),
        }
    }

    /// Adds a triangle with all values.
    pub fn extended(&mut self, corners: [Corner; 3]) {
        self.extended.push(corners);
        match self.commands.last_mut() {
            Some(Command::Extended(count)) => *count += 1,
            _ => self.commands.push(Command::Extended(1)),
        }
    }

    /// Whether it should be handed over before more is added.
    #[inline]
    pub fn is_full(&self) -> bool {
        self.triangles.len() + self.extended.len() >= MAX_TRIANGLES
            || self.commands.len() >= 4 * MAX_TRIANGLES
    }

    /// Forgets everything and keeps the memory.
    pub fn clear(&mut self) {
        self.commands.clear();
        self.triangles.clear();
        self.extended.clear();
        self.states.clear();
    }
}
