//! Rasterization states as the engine takes them.

use std::sync::Arc;

use fillrate_engine::state::Compare;
use fillrate_engine::{PaletteDraw, PaletteState};

use crate::color::blend_table;
use crate::state::{DrawMode, RasterState, TriangleMode};
use crate::texture::{KEY_TEXEL, Texture};

/// The key of a texture under a mode.
fn key(mode: DrawMode, texture: Option<&Arc<Texture>>) -> Option<u8> {
    let keyed = mode.is_keyed() && texture.is_some_and(|texture| texture.is_keyed());
    keyed.then_some(KEY_TEXEL)
}

/// Draws by `mode`; `test` is the depth test, `None` where depth does not
/// count at all.
fn draw(mode: DrawMode, texture: Option<&Arc<Texture>>, test: Option<Compare>) -> PaletteDraw {
    PaletteDraw {
        state: PaletteState {
            texel_color: texture.is_some(),
            key: key(mode, texture),
            blend: mode.is_alpha(),
            test,
            depth_write: test.is_some() && !mode.is_alpha(),
        },
        texture: texture.map(|texture| Arc::clone(texture.engine())),
        blend: mode.is_alpha().then(|| Arc::clone(blend_table())),
    }
}

/// Untextured drawing: lines.
pub(crate) fn plain(mode: DrawMode, test: Option<Compare>) -> PaletteDraw {
    draw(mode, None, test)
}

/// Sprites.
pub(crate) fn sprite(mode: DrawMode, texture: &Arc<Texture>, test: Option<Compare>) -> PaletteDraw {
    draw(mode, Some(texture), test)
}

/// One colour where the texels of `mask` are not the key: text.
pub(crate) fn stencil(mode: DrawMode, mask: &Arc<Texture>) -> PaletteDraw {
    let mut stencil = draw(mode, Some(mask), None);
    stencil.state.texel_color = false;
    stencil.state.key = Some(KEY_TEXEL);
    stencil
}

/// How the faces of one state and mode are drawn.
#[derive(Debug)]
pub(crate) struct Brush {
    pub draw: PaletteDraw,
    /// Untextured where there is no texture that triangles can use.
    pub mode: TriangleMode,
    pub culling: bool,
    pub sorted: bool,
    /// What it was made of.
    source: (DrawMode, TriangleMode, Option<Arc<Texture>>),
}

impl Brush {
    pub fn new(state: &RasterState, mode: TriangleMode, test: Compare) -> Brush {
        let usable = |texture: &&Arc<Texture>| mode.is_textured() && texture.fits_triangles();
        let texture = state.texture.as_ref().filter(usable);
        Brush {
            draw: draw(state.draw_mode, texture, Some(test)),
            mode: match texture {
                None if mode.is_textured() => TriangleMode::Untextured,
                _ => mode,
            },
            culling: state.test_culling,
            sorted: state.z_sort,
            source: (state.draw_mode, mode, state.texture.clone()),
        }
    }

    /// Whether it was made of these.
    pub fn is_of(&self, state: &RasterState, mode: TriangleMode) -> bool {
        let pointer = |texture: &Option<Arc<Texture>>| texture.as_ref().map(Arc::as_ptr);
        (self.source.0, self.source.1) == (state.draw_mode, mode)
            && pointer(&self.source.2) == pointer(&state.texture)
            && (self.culling, self.sorted) == (state.test_culling, state.z_sort)
    }
}
