//! The device: surfaces, the command arena and the flush points.

use std::sync::Arc;

use fillrate_simd::Level;

use crate::error::EngineError;
use crate::setup::{Cull, Registers, Vertex};
use crate::state::{Dither, DrawState, MAX_TMUS, Rect};
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
    /// Written whole; `None` leaves the aux plane.
    pub aux: Option<u16>,
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

/// A set of surfaces and the commands waiting to be drawn on them.
#[derive(Debug)]
pub struct Device {
    config: DeviceConfig,
}

#[allow(unused_variables)]
impl Device {
    /// A device without surfaces.
    ///
    /// # Errors
    /// [`EngineError::Threads`] where workers cannot be started.
    pub fn new(config: DeviceConfig) -> Result<Device, EngineError> {
        Ok(Device { config })
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
        Err(EngineError::SurfaceSize { width, height })
    }
    /// Frees a surface.
    ///
    /// # Errors
    /// [`EngineError::UnknownSurface`].
    pub fn destroy_surface(&mut self, id: SurfaceId) -> Result<(), EngineError> {
        Err(EngineError::UnknownSurface)
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
        Err(EngineError::UnknownSurface)
    }
    /// Chooses how to draw what follows. A unit of `state` without a texture
    /// samples transparent black.
    pub fn set_state(&mut self, state: &DrawState, textures: [Option<Arc<Texture>>; MAX_TMUS]) {}
    /// Draws a triangle by the current state, later.
    pub fn draw_triangle(&mut self, vertices: [&Vertex; 3], cull: Cull) {}
    /// Draws a triangle that was set up elsewhere, later.
    pub fn launch(&mut self, registers: &Registers) {}
    /// Draws ready-made fragments, later.
    pub fn draw_pixels(&mut self, run: &PixelRun<'_>) {}
    /// Fills a rectangle, later; rows count from the top of the screen.
    pub fn clear(&mut self, rect: Rect, values: ClearValues) {}
    /// Draws everything collected so far.
    pub fn flush(&mut self, reason: FlushReason) {}
    /// What happened since the last reset. A flush.
    pub fn counters(&mut self) -> Counters {
        Counters::default()
    }
    /// Sets all counters to 0. A flush.
    pub fn reset_counters(&mut self) {}
    /// How often and why the device flushed.
    pub fn flush_stats(&self) -> FlushStats {
        FlushStats::default()
    }
    /// A surface, up to date. A flush.
    ///
    /// # Errors
    /// [`EngineError::UnknownSurface`].
    pub fn surface(&mut self, id: SurfaceId) -> Result<&mut Surface, EngineError> {
        Err(EngineError::UnknownSurface)
    }
    /// Copies a rectangle of a 16-bit surface out; rows are `stride` elements
    /// apart. Parts outside the surface or beyond `to` are left alone. A flush.
    ///
    /// # Errors
    /// [`EngineError::UnknownSurface`], [`EngineError::WrongFormat`].
    pub fn read16(
        &mut self,
        id: SurfaceId,
        rect: Rect,
        to: &mut [u16],
        stride: usize,
    ) -> Result<(), EngineError> {
        Err(EngineError::UnknownSurface)
    }
    /// Copies a rectangle into a 16-bit surface; see [`Device::read16`].
    ///
    /// # Errors
    /// [`EngineError::UnknownSurface`], [`EngineError::WrongFormat`].
    pub fn write16(
        &mut self,
        id: SurfaceId,
        rect: Rect,
        from: &[u16],
        stride: usize,
    ) -> Result<(), EngineError> {
        Err(EngineError::UnknownSurface)
    }
}
