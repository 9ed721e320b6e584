//! The state a board has after it is opened.
//!
//! Source: G246, the default state of `grSstWinOpen`; the programming guide
//! says the constant colour is 0 and depth writes are on.

use crate::board::{Board, default_settings};
use crate::enums::*;
use crate::registers::{FbiRegisters, TmuRegisters, color_path, fbz, texture_mode};

impl Board {
    /// Pushes the default state through the state functions.
    pub(crate) fn set_defaults(&mut self, origin: i32, size: (u32, u32)) {
        let color_format = self.settings.color_format;
        self.settings = default_settings(color_format, size);
        self.fbi = FbiRegisters {
            fbz_color_path: color_path::PARAMETER_ADJUST,
            fbz_mode: fbz::CLIP | fbz::DEPTH_BIAS | fbz::DRAW_BACK | fbz::RGB_WRITE,
            color0: 0xffff_ffff,
            color1: 0xffff_ffff,
            ..FbiRegisters::default()
        };
        self.set_origin(origin);
        self.set_clip([0, 0, size.0, size.1]);
        self.set_color_combine(
            COMBINE_SCALE_OTHER,
            FACTOR_ONE,
            LOCAL_ITERATED,
            OTHER_ITERATED,
            false,
        );
        self.set_alpha_combine(
            COMBINE_SCALE_OTHER,
            FACTOR_ONE,
            LOCAL_CONSTANT,
            OTHER_CONSTANT,
            false,
        );
        self.set_blend([BLEND_ONE, BLEND_ZERO, BLEND_ONE, BLEND_ZERO]);
        self.set_alpha_test(CMP_ALWAYS);
        self.set_depth_function(CMP_LESS);
        self.set_depth_mode(0);
        self.set_dither(2);
        for unit in 0..self.tmus.len() {
            self.tmus[unit] = TmuRegisters {
                texture_mode: texture_mode::PERSPECTIVE
                    | texture_mode::CLAMP_W
                    | texture_mode::CLAMP_S
                    | texture_mode::CLAMP_T,
                ..TmuRegisters::default()
            };
            self.set_texture_combine(
                unit,
                [COMBINE_ZERO, FACTOR_NONE, COMBINE_ZERO, FACTOR_NONE],
                [false; 2],
            );
            self.set_detail(unit, 0, 1, 1.0);
        }
        self.dirty = true;
    }
}
