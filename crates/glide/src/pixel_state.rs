//! State of the pixel pipeline: each function changes register bits.
//!
//! Every setter returns false for an enumerant it does not know, and then
//! changes nothing; what is a switch is on for any number but 0.

use fillrate_engine::state::FogTable;

use crate::board::Board;
use crate::combine::{Channel, unit_bits};
use crate::enums::*;
use crate::registers::{FbiRegisters, alpha, color_path, fbz, fog, replace, switch, unit};

/// A colour of the program's format as 0xAARRGGBB.
///
/// Source: G246, `GrColorFormat_t`.
pub(crate) fn swizzle(format: i32, c: u32) -> u32 {
    match format {
        1 => c & 0xff00_ff00 | (c & 0xff) << 16 | c >> 16 & 0xff,
        2 => c.rotate_right(8),
        3 => c.swap_bytes(),
        _ => c,
    }
}

impl Board {
    pub(crate) fn color(&self, c: u32) -> u32 {
        swizzle(self.settings.color_format, c)
    }

    fn fbz(&mut self, bit: u32, on: bool) {
        self.fbi.fbz_mode = switch(self.fbi.fbz_mode, bit, on);
        self.dirty = true;
    }

    pub(crate) fn set_origin(&mut self, origin: i32) -> bool {
        self.fbz(fbz::LOWER_LEFT, origin != 0);
        matches!(origin, 0 | 1)
    }

    /// Minimum inclusive, maximum exclusive; the maximum is limited to the
    /// screen, the minimum to the maximum.
    pub(crate) fn set_clip(&mut self, [x0, y0, x1, y1]: [u32; 4]) {
        self.settings.clip = [x0, y0, x1, y1].map(|v| v as f32);
        let (width, height) =
            self.buffers.as_ref().map_or((0, 0), |buffers| (buffers.width, buffers.height));
        let (x1, y1) = (x1.min(width), y1.min(height));
        self.fbi.clip_left_right = x0.min(x1) << 16 | x1;
        self.fbi.clip_bottom_top = y0.min(y1) << 16 | y1;
        self.dirty = true;
    }

    pub(crate) fn set_color_combine(
        &mut self,
        function: i32,
        factor: i32,
        local: i32,
        other: i32,
        invert: bool,
    ) -> bool {
        let Some(bits) = unit_bits(function, factor, invert, Channel::Color) else { return false };
        if !matches!(local, 0 | 1) || !matches!(other, 0..=2) {
            return false;
        }
        let path = &mut self.fbi.fbz_color_path;
        *path = replace(*path, unit::ALL << color_path::COLOR_UNIT, bits << color_path::COLOR_UNIT);
        *path = replace(*path, 3 | 1 << 4, other as u32 | (local as u32) << 4);
        self.settings.delta0 = false;
        self.update_texture_enable();
        true
    }

    pub(crate) fn set_alpha_combine(
        &mut self,
        function: i32,
        factor: i32,
        local: i32,
        other: i32,
        invert: bool,
    ) -> bool {
        let Some(bits) = unit_bits(function, factor, invert, Channel::Alpha) else { return false };
        if !matches!(local, 0..=2) || !matches!(other, 0..=2) {
            return false;
        }
        let path = &mut self.fbi.fbz_color_path;
        *path = replace(*path, unit::ALL << color_path::ALPHA_UNIT, bits << color_path::ALPHA_UNIT);
        *path = replace(*path, 3 << 2 | 3 << 5, (other as u32) << 2 | (local as u32) << 5);
        self.update_texture_enable();
        true
    }

    /// Texturing is on where either unit names the texture.
    ///
    /// Source: G246, `grColorCombine`, `grAlphaCombine`; choosing the local colour
    /// by texture alpha does not turn it on.
    fn update_texture_enable(&mut self) {
        let path = self.fbi.fbz_color_path;
        let select = |at: u32| path >> (at + unit::SELECT_SHIFT) & 7;
        let on = path & 3 == 1
            || path >> 2 & 3 == 1
            || matches!(select(color_path::COLOR_UNIT), 4 | 5)
            || select(color_path::ALPHA_UNIT) == 4;
        self.fbi.fbz_color_path = switch(path, color_path::TEXTURE_ENABLE, on);
        self.dirty = true;
    }

    pub(crate) fn set_local_by_texture_alpha(&mut self, on: bool) {
        let path = self.fbi.fbz_color_path;
        self.fbi.fbz_color_path = switch(path, color_path::LOCAL_BY_TEXTURE_ALPHA, on);
        self.dirty = true;
    }

    /// Colour source and destination, alpha source and destination. The alpha
    /// factors know only zero and one; others count as one and zero.
    pub(crate) fn set_blend(&mut self, [rs, rd, mut als, mut ald]: [i32; 4]) -> bool {
        let known = |f: i32| matches!(f, 0..=7 | 0xf);
        if ![rs, rd, als, ald].into_iter().all(known) {
            return false;
        }
        if !matches!(als, BLEND_ZERO | BLEND_ONE) {
            als = BLEND_ONE;
        }
        if !matches!(ald, BLEND_ZERO | BLEND_ONE) {
            ald = BLEND_ZERO;
        }
        let off = [rs, rd, als, ald] == [BLEND_ONE, BLEND_ZERO, BLEND_ONE, BLEND_ZERO];
        let bits = (rs << 8 | rd << 12 | als << 16 | ald << 20) as u32;
        let enable = if off { 0 } else { alpha::BLEND };
        let mask = 0xffff << 8 | alpha::BLEND;
        self.fbi.alpha_mode = replace(self.fbi.alpha_mode, mask, bits | enable);
        self.dirty = true;
        true
    }

    pub(crate) fn set_alpha_test(&mut self, function: i32) -> bool {
        if !matches!(function, 0..=7) {
            return false;
        }
        let enable = if function == CMP_ALWAYS { 0 } else { alpha::TEST };
        let bits = (function as u32) << 1 | enable;
        self.fbi.alpha_mode = replace(self.fbi.alpha_mode, 15, bits);
        self.dirty = true;
        true
    }

    pub(crate) fn set_alpha_reference(&mut self, reference: u8) {
        let bits = u32::from(reference) << 24;
        self.fbi.alpha_mode = replace(self.fbi.alpha_mode, 0xff << 24, bits);
        self.dirty = true;
    }

    pub(crate) fn set_chroma_mode(&mut self, mode: i32) -> bool {
        self.fbz(fbz::CHROMA_KEY, mode != 0);
        matches!(mode, 0 | 1)
    }

    pub(crate) fn set_chroma_value(&mut self, color: u32) {
        self.fbi.chroma_key = self.color(color);
        self.dirty = true;
    }

    pub(crate) fn set_constant_color(&mut self, color: u32) {
        let color = self.color(color);
        (self.fbi.color0, self.fbi.color1) = (color, color);
        self.dirty = true;
    }

    /// Alpha planes share the aux buffer with depth, so the alpha part acts
    /// only while depth buffering is off and there is no third colour buffer.
    pub(crate) fn set_color_mask(&mut self, rgb: bool, alpha: bool) {
        self.fbz(fbz::RGB_WRITE, rgb);
        let triple = self.buffers.as_ref().is_some_and(|buffers| buffers.colors.len() > 2);
        if self.fbi.fbz_mode & fbz::DEPTH_ENABLE == 0 && !triple {
            self.fbz(fbz::ALPHA_PLANES, alpha);
            self.fbz(fbz::AUX_WRITE, alpha);
        }
    }

    pub(crate) fn set_depth_mask(&mut self, on: bool) {
        self.fbz(fbz::AUX_WRITE, on);
    }

    pub(crate) fn set_cull(&mut self, mode: i32) -> bool {
        if !matches!(mode, 0..=2) {
            return false;
        }
        self.settings.cull = mode;
        true
    }

    pub(crate) fn set_depth_mode(&mut self, mode: i32) -> bool {
        if !matches!(mode, 0..=4) {
            return false;
        }
        let w = matches!(mode, DEPTHBUFFER_WBUFFER | DEPTHBUFFER_WBUFFER_COMPARE_TO_BIAS);
        let constant = matches!(
            mode,
            DEPTHBUFFER_ZBUFFER_COMPARE_TO_BIAS | DEPTHBUFFER_WBUFFER_COMPARE_TO_BIAS
        );
        self.fbz(fbz::DEPTH_ENABLE, mode != 0);
        self.fbz(fbz::W_BUFFER, w);
        self.fbz(fbz::COMPARE_CONSTANT, constant);
        self.fbz(fbz::DEPTH_BIAS, mode != 0 && !constant);
        let (za_color, fbz_mode) = (self.lasting_registers().za_color, self.fbi.fbz_mode);
        if let Some(lock) = &mut self.lfb.write {
            lock.keep(&FbiRegisters { za_color, fbz_mode, ..self.fbi });
        }
        true
    }

    pub(crate) fn set_depth_function(&mut self, function: i32) -> bool {
        if !matches!(function, 0..=7) {
            return false;
        }
        let at = fbz::DEPTH_FUNCTION;
        self.fbi.fbz_mode = replace(self.fbi.fbz_mode, 7 << at, (function as u32) << at);
        self.dirty = true;
        true
    }

    pub(crate) fn set_depth_bias(&mut self, level: i16) {
        // During a write lock the register holds its constants; the level then
        // takes their place, as on the board, and stays.
        let lasting = self.lasting_registers();
        let za_color = replace(lasting.za_color, 0xffff, level as u16 as u32);
        if let Some(lock) = &mut self.lfb.write {
            lock.keep(&FbiRegisters { za_color, ..lasting });
        }
        self.fbi.za_color = za_color;
        self.dirty = true;
    }

    pub(crate) fn set_dither(&mut self, mode: i32) -> bool {
        if !matches!(mode, 0..=2) {
            return false;
        }
        self.fbz(fbz::DITHER, mode != 0);
        self.fbz(fbz::DITHER_2X2, mode == 1);
        self.fbz(fbz::SUBTRACT_DITHER, mode == 2 && self.dither_subtract);
        true
    }

    pub(crate) fn set_fog_mode(&mut self, mode: i32) -> bool {
        let source = match mode & 0xff {
            0 => 0,
            1 => fog::ENABLE | fog::ITERATED_ALPHA,
            2 => fog::ENABLE,
            3 => fog::ENABLE | fog::ITERATED_Z,
            _ => return false,
        };
        let mult = if mode & FOG_MULT2 != 0 { fog::MULT } else { 0 };
        let add = if mode & FOG_ADD2 != 0 { fog::ADD } else { 0 };
        self.fbi.fog_mode = source | mult | add;
        self.dirty = true;
        true
    }

    pub(crate) fn set_fog_color(&mut self, color: u32) {
        self.fbi.fog_color = self.color(color);
        self.dirty = true;
    }

    /// Entries, and slopes of four times the step to the next one, kept in
    /// eight bits; the last slope is 0.
    pub(crate) fn set_fog_table(&mut self, table: &[u8; 64]) {
        let delta = |i: usize| match table.get(i + 1) {
            Some(&next) => next.wrapping_sub(table[i]).wrapping_mul(4),
            None => 0,
        };
        self.fog_table = FogTable { value: *table, delta: core::array::from_fn(delta) };
        self.dirty = true;
    }

    pub(crate) fn set_render_buffer(&mut self, buffer: i32) -> bool {
        if !matches!(buffer, BUFFER_FRONT | BUFFER_BACK) {
            return false;
        }
        self.fbi.fbz_mode = replace(self.fbi.fbz_mode, fbz::DRAW_BUFFER, (buffer as u32) << 14);
        self.dirty = true;
        true
    }

    /// Source: G246, `grDisableAllEffects`.
    pub(crate) fn disable_all_effects(&mut self) {
        self.set_blend([BLEND_ONE, BLEND_ZERO, BLEND_ONE, BLEND_ZERO]);
        self.set_alpha_test(CMP_ALWAYS);
        self.set_chroma_mode(0);
        self.set_depth_bias(0);
        self.set_depth_mode(0);
        self.set_fog_mode(0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn color_formats() {
        assert_eq!(swizzle(0, 0x1122_3344), 0x1122_3344);
        assert_eq!(swizzle(1, 0x1122_3344), 0x1144_3322);
        assert_eq!(swizzle(2, 0x1122_3344), 0x4411_2233);
        assert_eq!(swizzle(3, 0x1122_3344), 0x4433_2211);
    }
}
