//! Multi-pass texturing: a second, virtual texture unit by drawing each
//! triangle twice.
//!
//! Source: G246, `guMPDrawTriangle`. Where the original wrote the depth
//! comparison into the wrong bits of fbzMode, its comment is followed.

use crate::board::Board;
use crate::context::Context;
use crate::enums::*;
use crate::gu::NULL_MIP_MAP;
use crate::registers::{alpha, color_path, fbz, fog, replace, texture_mode, unit};
use crate::vertex::GrVertex;

/// Add.
const ADD: i32 = 0;
/// Multiply.
const MULTIPLY: i32 = 1;

/// What the multi-pass calls set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct MultiPass {
    /// The mip map of each virtual unit.
    pub sources: [u32; 2],
    /// How they are put together.
    pub function: i32,
}

impl Default for MultiPass {
    fn default() -> MultiPass {
        MultiPass { sources: [NULL_MIP_MAP; 2], function: ADD }
    }
}

/// Function and factor of the texture unit in each pass; `None` where two
/// passes cannot do it.
fn unit_passes(function: i32) -> Option<[(i32, i32); 2]> {
    let scaled = |factor: i32| (COMBINE_BLEND_LOCAL, factor);
    let local = (COMBINE_LOCAL, FACTOR_NONE);
    Some(match function {
        ADD | MULTIPLY => [local; 2],
        2 => [scaled(FACTOR_DETAIL), scaled(FACTOR_ONE_MINUS_DETAIL)],
        3 => [scaled(FACTOR_ONE_MINUS_DETAIL), scaled(FACTOR_DETAIL)],
        4 => [scaled(FACTOR_LOD_FRACTION), scaled(FACTOR_ONE_MINUS_LOD_FRACTION)],
        5 => [scaled(FACTOR_ONE_MINUS_LOD_FRACTION), scaled(FACTOR_LOD_FRACTION)],
        _ => return None,
    })
}

impl Board {
    /// Whether a state is on that two passes cannot honour.
    fn forbids_passes(&self) -> bool {
        self.fbi.alpha_mode & (alpha::BLEND | alpha::TEST) != 0
            || self.fbi.fbz_color_path & color_path::LOCAL_BY_TEXTURE_ALPHA != 0
            || self.fbi.fbz_mode & fbz::CHROMA_KEY != 0
    }

    fn source_pass(&mut self, id: u32, (function, factor): (i32, i32)) {
        self.source_mip_map(id);
        self.set_texture_combine(0, [function, factor, function, factor], [false; 2]);
    }

    /// Leaves out what a pass adds to the scaled texture: it must count once.
    fn drop_biases(&mut self) {
        let adds = unit::ADD_LOCAL | unit::ADD_ALPHA | unit::SUB_LOCAL;
        self.fbi.fbz_color_path &= !(adds << color_path::COLOR_UNIT);
        if self.fbi.fog_mode & fog::ENABLE != 0 {
            self.fbi.fog_mode |= fog::ADD;
        }
    }

    /// Blends the second pass over the first, where that was drawn.
    fn blend_second_pass(&mut self, [source, destination, als, ald]: [i32; 4]) {
        let factors = (source << 8 | destination << 12 | als << 16 | ald << 20) as u32;
        let mask = 0xffff << 8 | alpha::BLEND;
        self.fbi.alpha_mode = replace(self.fbi.alpha_mode, mask, factors | alpha::BLEND);
        if self.fbi.fbz_mode & fbz::DEPTH_ENABLE != 0 {
            self.fbi.fbz_mode &= !fbz::AUX_WRITE;
            self.set_depth_function(CMP_EQUAL);
        }
    }

    /// A third pass adds the fog colour, which must not be multiplied.
    fn add_fog(&mut self, mode: u32) {
        self.blend_second_pass([BLEND_ONE; 4]);
        self.fbi.fog_mode = mode | fog::MULT;
        let path = unit::ALL << color_path::COLOR_UNIT | 3 | 1 << 4;
        self.fbi.fbz_color_path &= !(path | color_path::TEXTURE_ENABLE);
        self.dirty = true;
    }

    /// Both passes. The registers come back; the units keep the second source.
    fn draw_passes(
        &mut self,
        passes: [(i32, i32); 2],
        setting: &MultiPass,
        corners: [&GrVertex; 3],
    ) {
        let (kept, combine) = (self.fbi, self.tmus[0].texture_mode);
        self.source_pass(setting.sources[0], passes[0]);
        if setting.function == MULTIPLY {
            self.drop_biases();
        }
        self.dirty = true;
        self.draw_triangle(corners);
        self.source_pass(setting.sources[1], passes[1]);
        if setting.function == MULTIPLY {
            self.blend_second_pass([BLEND_COLOR, BLEND_ZERO, BLEND_ONE, BLEND_ZERO]);
            // The texture as it is: it scales what the first pass left.
            self.fbi.fog_mode = 0;
            let path = unit::ALL << color_path::COLOR_UNIT | 3 | 1 << 4;
            self.fbi.fbz_color_path = replace(self.fbi.fbz_color_path, path, OTHER_TEXTURE as u32)
                | color_path::TEXTURE_ENABLE;
        } else {
            self.blend_second_pass([BLEND_ONE; 4]);
            self.drop_biases();
        }
        self.dirty = true;
        self.draw_triangle(corners);
        if setting.function == MULTIPLY && kept.fog_mode & fog::ENABLE != 0 {
            self.add_fog(kept.fog_mode);
            self.draw_triangle(corners);
        }
        self.fbi = kept;
        let own = texture_mode::COLOR_UNIT_MASK | texture_mode::ALPHA_UNIT_MASK;
        self.tmus[0].texture_mode = replace(self.tmus[0].texture_mode, own, combine);
        self.dirty = true;
    }
}

impl Context {
    /// Chooses the mip map of a virtual unit.
    pub(crate) fn set_pass_source(&mut self, tmu: i32, id: u32) {
        let index = usize::try_from(tmu).ok().filter(|&index| index < 2);
        self.check(index.is_some(), "guMPTexSource", "there is no such virtual texture unit");
        if let Some(index) = index {
            self.multipass.sources[index] = id;
        }
    }

    /// Draws a triangle with the textures of both virtual units.
    pub(crate) fn draw_multipass(&mut self, corners: [&GrVertex; 3]) {
        const NAME: &str = "guMPDrawTriangle";
        let setting = self.multipass;
        let Some(passes) = unit_passes(setting.function) else {
            return self.warn(NAME, "this texture combine function is not supported");
        };
        let Some(board) = self.board(NAME) else { return };
        let known = setting.sources.iter().all(|&id| {
            id == NULL_MIP_MAP || board.mip_maps.get(id).is_some_and(|map| map.tmu == 0)
        });
        let forbidden = board.forbids_passes();
        if forbidden {
            self.warn(NAME, "blending, alpha test, chroma key or lighting by alpha is on");
        }
        self.check(known, NAME, "a virtual texture unit has no mip map of unit 0");
        if known {
            self.boards[self.current].draw_passes(passes, &setting, corners);
        }
    }
}
