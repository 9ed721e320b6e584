//! The command arena: what was asked for and not drawn yet.

use std::sync::{Arc, OnceLock};

use rustc_hash::FxHashMap;

use super::ClearValues;
use crate::kernel::Pipeline;
use crate::reused::Reused;
use crate::setup::{
    CornerBlocks, PalettePrimitive, RawPrimitive, Registers, Screen, VeriteExtra, VeriteVertex,
};
use crate::state::{DrawState, MAX_TMUS, Origin, PaletteDraw, RawDraw, Rect};
use crate::target::{PixelFormat, Surface};
use crate::texture::Texture;

/// One command; the payloads lie in the arena's own lists.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Command {
    /// Corners to set up.
    Triangle(u32),
    /// Vertices for the Vérité's set-up.
    Verite { vertices: u32, state: u32 },
    /// The same with extras.
    VeriteExtended { vertices: u32, state: u32 },
    /// Registers to launch.
    Launch { registers: u32, state: u32 },
    /// A primitive of the Quark profile.
    Palette { primitive: u32, state: u32 },
    /// A primitive of the Raw profile.
    Raw { primitive: u32, state: u32 },
    /// A rectangle to fill.
    Clear(u32),
    /// Ready-made fragments.
    Pixels(u32),
}

/// A rectangle to fill; screen coordinates, inside the target.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Clear {
    pub rect: Rect,
    pub values: ClearValues,
}

/// A run of fragments on the screen.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Run {
    pub state: u32,
    pub x: u32,
    /// Screen row.
    pub y: u32,
    /// First of its fragments in [`Arena::pixels`].
    pub first: u32,
    pub count: u32,
}

/// A ready-made fragment.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pixel {
    pub argb: u32,
    pub depth: u16,
}

/// A draw state in use.
#[derive(Debug)]
pub(crate) struct BatchState {
    pub pipeline: Pipeline,
    /// The stages for ready-made fragments, once there are any.
    pub pixel_pipeline: OnceLock<Box<Pipeline>>,
    /// Of the colour surface.
    pub format: PixelFormat,
    pub screen: Screen,
    /// The clip window on the screen, inside the target.
    pub clip: Rect,
}

impl BatchState {
    pub fn new(
        state: &DrawState,
        textures: &[Option<Arc<Texture>>; MAX_TMUS],
        target: &Surface,
        aux: Option<PixelFormat>,
        scale: u32,
    ) -> BatchState {
        let (width, height) = (target.width(), target.height());
        let screen = Screen { width, height, origin: state.origin, scale };
        BatchState {
            pipeline: Pipeline::new(state, textures, target.format(), aux),
            pixel_pipeline: OnceLock::new(),
            format: target.format(),
            screen,
            clip: screen_clip(state, &screen),
        }
    }
}

/// The clip window in screen rows, inside the target.
fn screen_clip(state: &DrawState, screen: &Screen) -> Rect {
    let all = Rect::new(0, 0, screen.width, screen.height);
    let Some(clip) = state.clip else { return all };
    let [x0, y0, x1, y1] =
        [clip.x0, clip.y0, clip.x1, clip.y1].map(|v| v.saturating_mul(screen.scale));
    let clip = Rect::new(x0, y0, x1, y1).intersect(&all);
    match state.origin {
        Origin::UpperLeft => clip,
        Origin::LowerLeft => {
            let flip = |y: u32| screen.height - y.min(screen.height);
            Rect::new(clip.x0, flip(clip.y1), clip.x1, flip(clip.y0))
        }
    }
}

/// What a compiled state depends on besides the state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct TargetShape {
    size: (u32, u32),
    format: PixelFormat,
    aux: Option<PixelFormat>,
    scale: u32,
}

/// A state and the addresses of its textures, which the compiled state keeps
/// alive.
type StateKey = (DrawState, [usize; MAX_TMUS]);

/// The draw states in use, each compiled once. Batches share them.
#[derive(Debug, Default)]
pub(crate) struct States {
    list: Vec<Arc<BatchState>>,
    index: FxHashMap<StateKey, u32>,
    shape: Option<TargetShape>,
}

impl States {
    /// The index of a state for drawing on `target`.
    pub fn find(
        &mut self,
        state: &DrawState,
        textures: &[Option<Arc<Texture>>; MAX_TMUS],
        target: &Surface,
        aux: Option<PixelFormat>,
        scale: u32,
    ) -> u32 {
        let size = (target.width(), target.height());
        let shape = TargetShape { size, format: target.format(), aux, scale };
        if self.shape != Some(shape) {
            self.clear();
            self.shape = Some(shape);
        }
        let address = |texture: &Option<Arc<Texture>>| match texture {
            Some(texture) => Arc::as_ptr(texture) as usize,
            None => 0,
        };
        let key = (*state, textures.each_ref().map(address));
        if let Some(&index) = self.index.get(&key) {
            return index;
        }
        let index = self.list.len() as u32;
        self.list.push(Arc::new(BatchState::new(state, textures, target, aux, scale)));
        self.index.insert(key, index);
        index
    }

    /// Forgets all of them; no waiting command may refer to one.
    pub fn clear(&mut self) {
        self.list.clear();
        self.index.clear();
    }

    #[inline]
    pub fn len(&self) -> usize {
        self.list.len()
    }

    /// All of them, by index.
    pub fn list(&self) -> &[Arc<BatchState>] {
        &self.list
    }
}

impl core::ops::Index<u32> for States {
    type Output = BatchState;

    fn index(&self, index: u32) -> &BatchState {
        &self.list[index as usize]
    }
}

/// Commands and their payloads, in submission order.
#[derive(Debug, Default)]
pub(crate) struct Arena {
    pub commands: Vec<Command>,
    pub triangles: CornerBlocks,
    pub verites: Reused<[VeriteVertex; 3]>,
    pub extended_verites: Reused<[(VeriteVertex, VeriteExtra); 3]>,
    pub registers: Vec<Registers>,
    pub clears: Vec<Clear>,
    pub runs: Vec<Run>,
    pub pixels: Vec<Pixel>,
    pub primitives: Vec<PalettePrimitive>,
    pub palettes: Vec<PaletteDraw>,
    pub raw_primitives: Vec<RawPrimitive>,
    pub raws: Vec<RawDraw>,
}

/// Commands after which an arena is drawn without being asked.
pub(super) const MAX_COMMANDS: usize = 1 << 13;
/// Draw states after which it is.
pub(super) const MAX_STATES: usize = 1 << 12;
/// Fragments after which it is.
const MAX_PIXELS: usize = 1 << 20;

impl Arena {
    /// Whether it should be drawn before more is added.
    #[inline]
    pub fn is_full(&self) -> bool {
        self.commands.len() >= MAX_COMMANDS
            || self.pixels.len() >= MAX_PIXELS
            || self.palettes.len() >= MAX_STATES
            || self.raws.len() >= MAX_STATES
    }

    /// Forgets everything, and keeps the memory.
    pub fn clear(&mut self) {
        self.commands.clear();
        self.triangles.clear();
        self.verites.clear();
        self.extended_verites.clear();
        self.registers.clear();
        self.primitives.clear();
        self.raw_primitives.clear();
        self.clears.clear();
        self.runs.clear();
        self.pixels.clear();
        self.palettes.clear();
        self.raws.clear();
    }
}
