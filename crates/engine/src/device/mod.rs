//! The device: surfaces, the command arena and the flush points.

pub(crate) mod arena;

mod access;
mod batch;
mod flush;
mod palette;
mod raw;

use std::sync::Arc;

use fillrate_simd::Level;

use self::arena::{Arena, Clear, Command, MAX_STATES, Pixel, Run, States};
use self::batch::Batch;
use self::flush::Targets;
use crate::crew::Crew;
use crate::error::EngineError;
use crate::kernel::Pipeline;
use crate::setup::{
    Cull, MAX_SCALE, Outcome, Registers, UsedState, VeriteExtra, VeriteVertex, Vertex, VertexExtra,
    extended_triangle,
};
use crate::state::{Dither, DrawState, MAX_TMUS, Origin, Rect};
use crate::stats::{Counters, FlushStats};
use crate::target::{PixelFormat, Surface, TileSize};
use crate::texture::Texture;

/// How a device works; none of it changes a pixel.
#[derive(Clone, Debug)]
pub struct DeviceConfig {
    /// Threads that draw, the caller's included; at least 1.
    pub threads: usize,
    /// SIMD level.
    pub level: Level,
    /// Side of a tile.
    pub tile: TileSize,
}

impl Default for DeviceConfig {
    /// All cores, the widest level, tiles of 64 pixels.
    fn default() -> DeviceConfig {
        let threads = std::thread::available_parallelism().map_or(1, usize::from);
        DeviceConfig { threads, level: Level::best(), tile: TileSize::Medium }
    }
}

/// Handle of a surface of one device.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct SurfaceId(u32);

/// Why the device had to draw what it had collected.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum FlushReason {
    /// The frame is complete.
    Swap,
    /// Somebody reads or writes pixels.
    Access,
    /// Somebody reads counters.
    Counters,
    /// Drawing goes to other surfaces.
    Target,
    /// The arena is full.
    Full,
    /// The caller asked.
    Explicit,
}

/// What a clear writes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ClearValues {
    /// 0xAARRGGBB, reduced with this dithering; `None` leaves the colours.
    pub color: Option<(u32, Dither)>,
    /// Written whole, the low half into 16 bits; `None` leaves the aux plane.
    pub aux: Option<u32>,
}

/// Ready-made fragments of one row. They skip texturing and combining, and
/// their depth takes no bias.
#[derive(Clone, Copy, Debug)]
pub struct PixelRun<'a> {
    /// Column of the first.
    pub x: u32,
    /// Row, in drawing coordinates.
    pub y: u32,
    /// 0xAARRGGBB of each.
    pub colors: &'a [u32],
    /// Depth of each, also its pseudo-float w for fog; as many as colours.
    pub depths: &'a [u16],
}

/// The draw state as it was last set.
type CurrentState = (DrawState, [Option<Arc<Texture>>; MAX_TMUS]);

/// A set of surfaces and the commands waiting to be drawn on them.
///
/// Drawing goes on behind the caller: [`Device::submit`] starts it, and so does a
/// full arena. Whatever needs its result waits for it.
#[derive(Debug)]
pub struct Device {
    config: DeviceConfig,
    /// The batch that is drawn, and helpers; none with one thread.
    crew: Crew<Batch>,
    /// What that batch is drawn on, while it is.
    in_flight: Option<Targets>,
    /// Batches started so far.
    started: u64,
    surfaces: Vec<Option<Surface>>,
    color: Option<SurfaceId>,
    aux: Option<SurfaceId>,
    arena: Arena,
    states: States,
    current: CurrentState,
    /// Surface pixels of a pixel that coordinates count.
    scale: u32,
    /// The current state in `states`, once something used it.
    state: Option<UsedState>,
    counters: Counters,
    flushes: FlushStats,
}

impl Device {
    /// A device without surfaces.
    ///
    /// # Errors
    /// [`EngineError::Threads`] where workers cannot be started.
    pub fn new(config: DeviceConfig) -> Result<Device, EngineError> {
        let crew = Crew::new(Batch::new(config.level), config.threads.saturating_sub(1))
            .map_err(|error| EngineError::Threads(error.to_string()))?;
        Ok(Device {
            config,
            crew,
            in_flight: None,
            started: 0,
            surfaces: Vec::new(),
            color: None,
            aux: None,
            arena: Arena::default(),
            states: States::default(),
            current: (DrawState::default(), [const { None }; MAX_TMUS]),
            scale: 1,
            state: None,
            counters: Counters::default(),
            flushes: FlushStats::default(),
        })
    }

    /// How the device works.
    pub fn config(&self) -> &DeviceConfig {
        &self.config
    }

    /// Makes a surface of zeros.
    ///
    /// # Errors
    /// [`EngineError::SurfaceSize`].
    pub fn create_surface(
        &mut self,
        width: u32,
        height: u32,
        format: PixelFormat,
    ) -> Result<SurfaceId, EngineError> {
        let surface = Surface::new(width, height, format, self.config.tile)?;
        let id = SurfaceId(self.surfaces.len() as u32);
        self.surfaces.push(Some(surface));
        Ok(id)
    }

    /// Frees a surface. Where it was the target, nothing is drawn until
    /// another is set.
    ///
    /// # Errors
    /// [`EngineError::UnknownSurface`].
    pub fn destroy_surface(&mut self, id: SurfaceId) -> Result<(), EngineError> {
        self.peek(id)?;
        if self.color == Some(id) || self.aux == Some(id) {
            self.submit(FlushReason::Target);
            (self.color, self.aux) = (None, None);
        }
        self.complete_for(id);
        self.surfaces[id.0 as usize] = None;
        Ok(())
    }

    /// Chooses where to draw. A change is a flush.
    ///
    /// # Errors
    /// [`EngineError::UnknownSurface`], [`EngineError::WrongFormat`],
    /// [`EngineError::TargetMismatch`].
    pub fn set_target(
        &mut self,
        color: SurfaceId,
        aux: Option<SurfaceId>,
    ) -> Result<(), EngineError> {
        let surface = self.peek(color)?;
        if !surface.format().is_color() {
            return Err(EngineError::WrongFormat { format: surface.format(), usage: "colour" });
        }
        if let Some(aux) = aux {
            let aux = self.peek(aux)?;
            if aux.format().is_color() {
                return Err(EngineError::WrongFormat { format: aux.format(), usage: "aux" });
            }
            let size = |s: &Surface| (s.width(), s.height());
            if size(surface) != size(aux) {
                return Err(EngineError::TargetMismatch { color: size(surface), aux: size(aux) });
            }
        }
        if self.color != Some(color) || self.aux != aux {
            self.submit(FlushReason::Target);
            (self.color, self.aux) = (Some(color), aux);
            self.state = None;
        }
        Ok(())
    }

    /// Chooses how to draw what follows. A unit of `state` without a texture
    /// samples transparent black.
    pub fn set_state(&mut self, state: &DrawState, textures: [Option<Arc<Texture>>; MAX_TMUS]) {
        let same = |a: &Option<Arc<Texture>>, b: &Option<Arc<Texture>>| match (a, b) {
            (Some(a), Some(b)) => Arc::ptr_eq(a, b),
            (None, None) => true,
            _ => false,
        };
        let unchanged = self.current.0 == *state
            && self.current.1.iter().zip(&textures).all(|(a, b)| same(a, b));
        if !unchanged {
            self.current = (*state, textures);
            self.state = None;
        }
    }

    /// Draws triangles of what follows at `scale` times their coordinates, 1 to
    /// 4, and takes clip windows the same way: a surface that is so much larger
    /// shows the same picture, finer. Clears, ready-made fragments and access to
    /// surfaces count the surface's pixels.
    ///
    /// Out-of-range values count as the nearest one in it.
    pub fn set_scale(&mut self, scale: u32) {
        let scale = scale.clamp(1, MAX_SCALE);
        if self.scale != scale {
            self.submit(FlushReason::Target);
            self.scale = scale;
            self.state = None;
        }
    }

    /// Draws a triangle by the current state, later.
    #[inline]
    pub fn draw_triangle(&mut self, corners: [&Vertex; 3], cull: Cull) {
        self.draw_triangle_made(cull, |i| *corners[i]);
    }

    /// The same with corners, 0 to 2, that are made where they are kept.
    #[inline(always)]
    pub fn draw_triangle_made(&mut self, cull: Cull, corner: impl Fn(usize) -> Vertex) {
        let Some(state) = self.use_state() else { return };
        let index = self.arena.triangles.push(self.config.level, state, cull, corner);
        self.arena.commands.push(Command::Triangle(index));
    }

    /// Draws a triangle by the current state, later, with the second and third
    /// colours, the fog factor and the deep z that the state may read. Those of
    /// [`Device::draw_triangle`] are 0, the fog factor 255.
    ///
    /// Set up by the caller, so that the other way is faster where no state
    /// reads these.
    pub fn draw_extended(&mut self, vertices: [&Vertex; 3], extras: [&VertexExtra; 3], cull: Cull) {
        match extended_triangle(vertices, extras, cull, MAX_TMUS) {
            Outcome::Drawn(registers) => self.launch(&registers),
            Outcome::Empty | Outcome::Culled => self.counters.triangles_in += 1,
        }
    }

    /// Draws a triangle by the current state, later, set up as the Vérité's. What
    /// the state reads besides is 0. The caller writes the corners where they are
    /// kept; until then they are those of another triangle. `None` without a target.
    #[inline(always)]
    pub fn draw_verite(&mut self) -> Option<&mut [VeriteVertex; 3]> {
        let state = self.use_state()?;
        let Arena { commands, verites, .. } = &mut self.arena;
        let vertices = verites.len() as u32;
        commands.push(Command::Verite { vertices, state: state.index });
        Some(verites.add())
    }

    /// The same with what the state reads besides. Texture units after the first
    /// get zeros.
    #[inline(always)]
    pub fn draw_verite_extended(&mut self) -> Option<&mut [(VeriteVertex, VeriteExtra); 3]> {
        let state = self.use_state()?;
        let Arena { commands, extended_verites, .. } = &mut self.arena;
        let vertices = extended_verites.len() as u32;
        commands.push(Command::VeriteExtended { vertices, state: state.index });
        Some(extended_verites.add())
    }

    /// Draws a triangle that was set up elsewhere, later. Of its coordinates
    /// the low 16 bits count, sign-extended, as in the chip.
    pub fn launch(&mut self, registers: &Registers) {
        let Some(state) = self.use_state() else { return };
        let index = self.arena.registers.len() as u32;
        let mut registers = *registers;
        for coordinate in registers.x.iter_mut().chain(&mut registers.y) {
            *coordinate = i32::from(*coordinate as i16);
        }
        self.arena.registers.push(registers);
        self.arena.commands.push(Command::Launch { registers: index, state: state.index });
    }

    /// Draws ready-made fragments, later. Fragments outside the target, and
    /// those without a depth, are dropped.
    pub fn draw_pixels(&mut self, run: &PixelRun<'_>) {
        let Some(UsedState { index: state, .. }) = self.use_state() else { return };
        let aux = self.aux_format();
        let batch = &self.states[state];
        let (width, height) = (batch.screen.width, batch.screen.height);
        if run.x >= width || run.y >= height {
            return;
        }
        let count = run.colors.len().min(run.depths.len()).min((width - run.x) as usize);
        if count == 0 {
            return;
        }
        batch
            .pixel_pipeline
            .get_or_init(|| Box::new(Pipeline::for_pixels(&self.current.0, batch.format, aux)));
        let y = match self.current.0.origin {
            Origin::UpperLeft => run.y,
            Origin::LowerLeft => height - 1 - run.y,
        };
        let arena = &mut self.arena;
        let first = arena.pixels.len() as u32;
        let fragments = run.colors.iter().zip(run.depths).take(count);
        arena.pixels.extend(fragments.map(|(&argb, &depth)| Pixel { argb, depth }));
        arena.commands.push(Command::Pixels(arena.runs.len() as u32));
        arena.runs.push(Run { state, x: run.x, y, first, count: count as u32 });
    }

    /// Fills a rectangle, later; rows count from the top of the screen.
    pub fn clear(&mut self, rect: Rect, values: ClearValues) {
        let Some(color) = self.color else { return };
        let Ok(surface) = self.peek(color) else { return };
        let rect = rect.intersect(&surface.bounds());
        if rect.is_empty() {
            return;
        }
        self.make_room();
        self.arena.commands.push(Command::Clear(self.arena.clears.len() as u32));
        self.arena.clears.push(Clear { rect, values });
    }

    /// What happened since the last reset. A flush.
    pub fn counters(&mut self) -> Counters {
        self.flush(FlushReason::Counters);
        self.counters
    }

    /// Sets all counters to 0. A flush.
    pub fn reset_counters(&mut self) {
        self.flush(FlushReason::Counters);
        self.counters = Counters::default();
    }

    /// How often and why the device flushed.
    pub fn flush_stats(&self) -> FlushStats {
        self.flushes
    }

    /// The arena's entry of the current state; `None` without a target.
    #[inline]
    fn use_state(&mut self) -> Option<UsedState> {
        match self.state {
            Some(state) if !self.is_full() => Some(state),
            _ => self.find_state(),
        }
    }

    #[cold]
    fn find_state(&mut self) -> Option<UsedState> {
        self.make_room();
        if let Some(state) = self.state {
            return Some(state);
        }
        let (state, textures) = &self.current;
        let target = self.surfaces.get(self.color?.0 as usize)?.as_ref()?;
        let aux = self.aux_format();
        let index = self.states.find(state, textures, target, aux, self.scale);
        let units = self.states[index].pipeline.unit_count;
        self.state = Some(UsedState { index, units });
        self.state
    }

    /// Whether a batch should be drawn before more is added to the next.
    #[inline]
    fn is_full(&self) -> bool {
        self.arena.is_full() || self.states.len() >= MAX_STATES
    }

    fn make_room(&mut self) {
        if self.is_full() {
            self.submit(FlushReason::Full);
        }
    }

    /// What the aux surface's elements are, where there is one.
    fn aux_format(&self) -> Option<PixelFormat> {
        self.aux.and_then(|id| self.peek(id).ok()).map(Surface::format)
    }

    /// A surface as it was at the last flush.
    fn peek(&self, id: SurfaceId) -> Result<&Surface, EngineError> {
        self.surfaces.get(id.0 as usize).and_then(Option::as_ref).ok_or(EngineError::UnknownSurface)
    }
}
