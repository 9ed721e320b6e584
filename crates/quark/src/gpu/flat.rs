//! Pixels, lines and sprites.
//!
//! Source: QK, pixel, line and sprite drawing.

use std::sync::Arc;

use fillrate_engine::state::Compare;
use fillrate_engine::{PaletteDraw, PalettePrimitive, PaletteVertex};

use super::{CLIPZ_NEAR, Gpu, brush, inverse_z};
use crate::color::INTENSITY_SHIFT;
use crate::state::DrawMode;
use crate::texture::Texture;

/// A place and size on the screen, and the depth of what is drawn there.
struct Area {
    at: [i32; 2],
    size: [u32; 2],
    step: [u32; 2],
    depth: u16,
}

/// Texels for each of `count` pixels, 16 fraction bits.
fn step(texels: i32, count: i64) -> u32 {
    ((i64::from(texels) << 16) / count) as u32
}

/// A count of pixels as far as surfaces can need it.
fn limited(count: i64) -> u32 {
    count.min(u32::MAX.into()) as u32
}

impl Gpu {
    /// Sets a pixel's base colour and intensity; its depth stays.
    pub fn put_pixel(&mut self, x: i32, y: i32, color: u16) {
        let draw = brush::plain(DrawMode::Opaque, None);
        let intensity = (color >> INTENSITY_SHIFT & 31) as u8;
        self.device.draw_palette(
            &draw,
            PalettePrimitive::Rect {
                at: [x, y],
                size: [1, 1],
                texel: [0; 2],
                step: [0; 2],
                depth: 0,
                intensity: intensity << 3,
                color: color as u8,
            },
        );
    }

    /// Draws a line between two points (column, row, distance), both included.
    pub fn draw_line(&mut self, a: &[i32; 3], b: &[i32; 3]) {
        let state = &self.line_state;
        let draw = brush::plain(state.draw_mode, Some(self.depth_test));
        let (color, intensity) = (state.draw_color, i16::from(state.draw_intensity));
        let end = |p: &[i32; 3]| PaletteVertex {
            x: p[0],
            y: p[1],
            depth: inverse_z(p[2]),
            intensity,
            ..PaletteVertex::default()
        };
        let line = PalettePrimitive::Line { ends: [end(a), end(b)], color };
        self.device.draw_palette(&draw, line);
    }

    /// Draws the sprite state's texture in its own size, its top-left corner
    /// at (x, y). Depth is neither tested nor changed.
    pub fn draw_sprite(&mut self, x: i32, y: i32) {
        self.draw_sprite_scale(x, y, 256);
    }

    /// As [`Gpu::draw_sprite`], scaled; 256 is 1. At least one pixel is drawn
    /// in each direction, and nothing for scales below 1.
    pub fn draw_sprite_scale(&mut self, x: i32, y: i32, scale: i32) {
        let Some(texture) = self.sprite_state.texture.clone().filter(|_| scale > 0) else {
            return;
        };
        let sides = [texture.width(), texture.height()];
        let counts = sides.map(|side| ((i64::from(side) * i64::from(scale)) >> 8).max(1));
        let area = Area {
            at: [x, y],
            size: counts.map(limited),
            step: [step(sides[0], counts[0]), step(sides[1], counts[1])],
            depth: 0,
        };
        self.sprite(&texture, area, None);
    }

    /// Draws the sprite state's texture over columns and rows from `top_left`
    /// (included) to `bottom_right` (excluded), at distance `z`; nearer than
    /// 64 nothing is drawn. Depth is tested, and written by modes that are
    /// not alpha.
    pub fn draw_sprite_scale_zb(&mut self, top_left: [i32; 2], bottom_right: [i32; 2], z: i32) {
        let Some(texture) = self.sprite_state.texture.clone() else { return };
        let count = |i: usize| i64::from(bottom_right[i]) - i64::from(top_left[i]);
        let counts = [count(0), count(1)];
        if z < -CLIPZ_NEAR || counts[0] <= 0 || counts[1] <= 0 {
            return;
        }
        let area = Area {
            at: top_left,
            size: counts.map(limited),
            step: [step(texture.width(), counts[0]), step(texture.height(), counts[1])],
            depth: inverse_z(z),
        };
        self.sprite(&texture, area, Some(self.depth_test));
    }

    fn sprite(&mut self, texture: &Arc<Texture>, area: Area, test: Option<Compare>) {
        let draw = brush::sprite(self.sprite_state.draw_mode, texture, test);
        self.rect(&draw, &area, self.sprite_state.draw_intensity);
    }

    fn rect(&mut self, draw: &PaletteDraw, area: &Area, intensity: u8) {
        let Area { at, size, step, depth } = *area;
        let texel = [0; 2];
        self.device.draw_palette(
            draw,
            PalettePrimitive::Rect { at, size, texel, step, depth, intensity, color: 0 },
        );
    }
}
