//! Drawing with the Raw profile.

use super::arena::Command;
use super::{Device, SurfaceId};
use crate::error::EngineError;
use crate::setup::RawPrimitive;
use crate::state::RawDraw;
use crate::target::{PixelFormat, Surface};

impl Device {
    /// Draws a primitive of the Raw profile, later. The colour surface is
    /// [`PixelFormat::Rgbx8888`]; on others nothing is drawn. The aux surface,
    /// where there is one, is [`PixelFormat::Aux32`]; without it there is no
    /// depth test.
    pub fn draw_raw(&mut self, draw: &RawDraw, primitive: RawPrimitive) {
        if !self.is_raw_target() {
            return;
        }
        self.make_room();
        let arena = &mut self.arena;
        if !arena.raws.last().is_some_and(|last| last.same(draw)) {
            arena.raws.push(draw.clone());
        }
        let state = (arena.raws.len() - 1) as u32;
        let index = arena.raw_primitives.len() as u32;
        arena.raw_primitives.push(primitive);
        arena.commands.push(Command::Raw { primitive: index, state });
    }

    fn is_raw_target(&self) -> bool {
        let surface = self.color.and_then(|id| self.peek(id).ok());
        surface.is_some_and(|surface| surface.format() == PixelFormat::Rgbx8888)
    }

    /// Sets every element of a surface, later where nothing reads it before. A
    /// flush if something waits to be drawn on it.
    ///
    /// # Errors
    /// [`EngineError::UnknownSurface`].
    pub fn fill(&mut self, id: SurfaceId, value: u32) -> Result<(), EngineError> {
        self.surface(id)?.fill(value);
        Ok(())
    }

    /// Writes a 32-bit surface's elements out row by row. A flush if something
    /// waits to be drawn on it.
    ///
    /// # Errors
    /// [`EngineError::UnknownSurface`], [`EngineError::WrongFormat`].
    ///
    /// # Panics
    /// Where `to` is not as long as the surface has pixels.
    pub fn read32(&mut self, id: SurfaceId, to: &mut [u32]) -> Result<(), EngineError> {
        let surface = self.surface32(id)?;
        let width = surface.width() as usize;
        assert_eq!(to.len(), width * surface.height() as usize, "one word for each pixel");
        for (y, row) in to.chunks_mut(width).enumerate() {
            surface.read_row(y as u32, row);
        }
        Ok(())
    }

    /// Sets a 32-bit surface's elements row by row. A flush if something waits
    /// to be drawn on it.
    ///
    /// # Errors
    /// [`EngineError::UnknownSurface`], [`EngineError::WrongFormat`].
    ///
    /// # Panics
    /// Where `from` is not as long as the surface has pixels.
    pub fn write32(&mut self, id: SurfaceId, from: &[u32]) -> Result<(), EngineError> {
        let surface = self.surface32(id)?;
        let width = surface.width() as usize;
        assert_eq!(from.len(), width * surface.height() as usize, "one word for each pixel");
        for (y, row) in from.chunks(width).enumerate() {
            surface.write_row(y as u32, row);
        }
        Ok(())
    }

    fn surface32(&mut self, id: SurfaceId) -> Result<&mut Surface, EngineError> {
        let surface = self.surface(id)?;
        match surface.format().bytes() {
            4 => Ok(surface),
            _ => {
                let format = surface.format();
                Err(EngineError::WrongFormat { format, usage: "32-bit elements" })
            }
        }
    }
}
