//! Drawing with the Quark profile.

use super::Device;
use super::arena::Command;
use crate::setup::PalettePrimitive;
use crate::state::PaletteDraw;

impl Device {
    /// Draws a primitive of the Quark profile, later. The colour surface holds
    /// palette colours: see [`crate::PixelFormat::Palette`]; on others nothing
    /// is drawn.
    pub fn draw_palette(&mut self, draw: &PaletteDraw, primitive: PalettePrimitive) {
        if !self.is_palette_target() {
            return;
        }
        self.make_room();
        let arena = &mut self.arena;
        if !arena.palettes.last().is_some_and(|last| last.same(draw)) {
            arena.palettes.push(draw.clone());
        }
        let state = (arena.palettes.len() - 1) as u32;
        let index = arena.primitives.len() as u32;
        arena.primitives.push(primitive);
        arena.commands.push(Command::Palette { primitive: index, state });
    }

    fn is_palette_target(&self) -> bool {
        let surface = self.color.and_then(|id| self.peek(id).ok());
        surface.is_some_and(|surface| surface.format() == crate::PixelFormat::Palette)
    }
}
