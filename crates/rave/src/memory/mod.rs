//! Texture memory: who refers to a texture, what is resident, when it is freed.
//!
//! Source: RAVE technote, texture memory manager.

use crate::RaveError;

/// The renderer, as the texture memory sees it.
pub trait Renderer {
    /// Waits until some queued polygons are drawn, and says for which textures
    /// how many. `false`: nothing was queued.
    fn step(&mut self, retired: &mut Vec<(Slot, u32)>) -> bool;
}

/// A texture's place in the books.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Slot(pub u32);

/// The books of all textures of an engine.
#[derive(Debug, Default)]
pub struct TextureMemory {
    next: u32,
}

impl TextureMemory {
    /// Books of a board with `budget` bytes for textures.
    pub fn new(budget: u64) -> TextureMemory {
        let _ = budget;
        TextureMemory::default()
    }

    /// `QATextureNew`: a texture of `bytes`, owned by the program.
    ///
    /// # Errors
    /// [`RaveError::OutOfVideoMemory`], [`RaveError::OutOfMemory`].
    pub fn create(
        &mut self,
        bytes: u64,
        lock: bool,
        renderer: &mut dyn Renderer,
    ) -> Result<Slot, RaveError> {
        let _ = (bytes, lock, renderer);
        self.next += 1;
        Ok(Slot(self.next))
    }

    /// `QATextureDetach`.
    ///
    /// # Errors
    /// [`RaveError::OutOfMemory`].
    pub fn detach(&mut self, slot: Slot, renderer: &mut dyn Renderer) -> Result<(), RaveError> {
        let _ = (slot, renderer);
        Ok(())
    }

    /// A polygon with this texture is queued.
    #[inline]
    pub fn submit(&mut self, slot: Slot) {
        let _ = slot;
    }

    /// The renderer drew polygons with this texture.
    pub fn retire(&mut self, slot: Slot, polygons: u32) {
        let _ = (slot, polygons);
    }

    /// `QATextureDelete`.
    pub fn delete(&mut self, slot: Slot) {
        let _ = slot;
    }

    /// `QASync`: all queued work is done.
    pub fn sync(&mut self, renderer: &mut dyn Renderer) {
        let _ = renderer;
    }

    /// Free bytes, once all deferred deletions are done.
    pub fn free_bytes(&mut self, renderer: &mut dyn Renderer) -> u64 {
        let _ = renderer;
        0
    }
}
