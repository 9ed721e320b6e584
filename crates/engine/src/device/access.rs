//! Reading and writing surfaces. Every access but one is a flush.

use super::{Device, FlushReason, SurfaceId};
use crate::error::EngineError;
use crate::state::Rect;
use crate::target::Surface;

impl Device {
    /// A surface, up to date. A flush.
    ///
    /// # Errors
    /// [`EngineError::UnknownSurface`].
    pub fn surface(&mut self, id: SurfaceId) -> Result<&mut Surface, EngineError> {
        if self.color == Some(id) || self.aux == Some(id) {
            self.submit(FlushReason::Access);
        }
        self.complete_for(id);
        let surface = self.surfaces.get_mut(id.0 as usize).and_then(Option::as_mut);
        surface.ok_or(EngineError::UnknownSurface)
    }

    /// A surface without what is still collected for it. Waits only where it is
    /// being drawn on.
    ///
    /// # Errors
    /// [`EngineError::UnknownSurface`].
    pub fn drawn_surface(&mut self, id: SurfaceId) -> Result<&Surface, EngineError> {
        self.complete_for(id);
        self.peek(id)
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
        let surface = self.surface16(id)?;
        let inside = rect.intersect(&surface.bounds());
        for y in inside.y0..inside.y1 {
            let row = (y - rect.y0) as usize * stride + (inside.x0 - rect.x0) as usize;
            for (x, to) in (inside.x0..inside.x1).zip(to.iter_mut().skip(row)) {
                *to = surface.get(x, y) as u16;
            }
        }
        Ok(())
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
        let surface = self.surface16(id)?;
        let inside = rect.intersect(&surface.bounds());
        for y in inside.y0..inside.y1 {
            let row = (y - rect.y0) as usize * stride + (inside.x0 - rect.x0) as usize;
            for (x, &from) in (inside.x0..inside.x1).zip(from.iter().skip(row)) {
                surface.set(x, y, u32::from(from));
            }
        }
        Ok(())
    }

    fn surface16(&mut self, id: SurfaceId) -> Result<&mut Surface, EngineError> {
        let surface = self.surface(id)?;
        match surface.format() {
            format if format.bytes() == 4 => {
                Err(EngineError::WrongFormat { format, usage: "16-bit elements" })
            }
            _ => Ok(surface),
        }
    }
}
