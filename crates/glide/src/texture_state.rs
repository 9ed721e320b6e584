//! State of the texture units.

use crate::board::Board;
use crate::combine::{Channel, unit_bits};
use crate::enums::*;
use crate::registers::{replace, switch, t_lod, texture_mode, unit};
use crate::texture::layout;

/// A texture as the program describes it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct TextureInfo {
    /// LOD number of the smallest level, 0 (256) to 8 (1).
    pub small_lod: i32,
    /// LOD number of the largest level, not above `small_lod`.
    pub large_lod: i32,
    /// 0 (8:1) to 6 (1:8).
    pub aspect: i32,
    /// Texel format, 0 to 14.
    pub format: i32,
}

impl TextureInfo {
    /// Whether every field is one the hardware knows.
    pub fn is_valid(&self) -> bool {
        let lods = 0..=layout::SMALLEST as i32;
        lods.contains(&self.small_lod)
            && lods.contains(&self.large_lod)
            && self.large_lod <= self.small_lod
            && (0..=6).contains(&self.aspect)
            && matches!(self.format, 0..=5 | 8..=14)
    }
}

/// The bits of tLOD that say which levels a texture has.
fn split_bits(even_odd: u32) -> u32 {
    match even_odd {
        LEVELS_EVEN => t_lod::SPLIT,
        LEVELS_ODD => t_lod::SPLIT | t_lod::ODD,
        _ => 0,
    }
}

/// The bits of tLOD that say a texture's shape and which levels it has.
pub(crate) fn shape_bits(aspect: i32, even_odd: u32) -> u32 {
    let (aspect, wide) = layout::aspect_bits(aspect);
    let wide = if wide { t_lod::S_IS_WIDER } else { 0 };
    split_bits(even_odd) | wide | aspect << t_lod::ASPECT
}

/// A level bias as six bits of quarters, truncated toward zero after adding an
/// eighth.
pub(crate) fn lod_bias_quarters(bias: f32) -> u32 {
    ((bias + 0.125) / 0.25) as i32 as u32 & 0x3f
}

/// Whether a chain of textures would cross a boundary of two megabytes.
pub(crate) fn crosses_bank(start: u32, info: &TextureInfo, even_odd: u32) -> bool {
    let (small, large) = (info.small_lod as u32, info.large_lod as u32);
    let bytes = layout::chain_bytes(small, large, info.aspect, info.format, even_odd);
    bytes > 0 && start >> 21 != (start.saturating_add(bytes - 1)) >> 21
}

impl Board {
    fn mode(&mut self, unit: usize, bit: u32, on: bool) {
        let mode = &mut self.tmus[unit].texture_mode;
        *mode = switch(*mode, bit, on);
        self.dirty = true;
    }

    /// Points a unit at a texture.
    pub(crate) fn set_source(
        &mut self,
        unit: usize,
        start: u32,
        even_odd: u32,
        info: &TextureInfo,
    ) {
        let (small, large) = (info.small_lod as u32, info.large_lod as u32);
        let settings = &mut self.settings.units[unit];
        (settings.small_lod, settings.large_lod) = (small, large);
        settings.even_odd = even_odd;
        let tmu = &mut self.tmus[unit];
        let format = (info.format as u32) << texture_mode::FORMAT;
        tmu.texture_mode = replace(tmu.texture_mode, 15 << texture_mode::FORMAT, format)
            | texture_mode::PERSPECTIVE
            | texture_mode::CLAMP_W;
        let kept = tmu.t_lod & (63 << 12 | t_lod::MULTIBASE);
        tmu.t_lod = kept | shape_bits(info.aspect, even_odd);
        tmu.base[0] = layout::base_address(start, large, info.aspect, info.format, even_odd) >> 3;
        self.update_lod_range(unit);
    }

    /// Writes the level range: all levels, or the largest alone without mip
    /// mapping.
    fn update_lod_range(&mut self, unit: usize) {
        let settings = self.settings.units[unit];
        let small = match settings.mip_map_mode {
            MIPMAP_DISABLE => settings.large_lod,
            _ => settings.small_lod,
        };
        let bits = (settings.large_lod * 4) | ((small * 4) << 6);
        let tmu = &mut self.tmus[unit];
        tmu.t_lod = replace(tmu.t_lod, 0xfff, bits);
        self.dirty = true;
    }

    pub(crate) fn set_multibase_address(
        &mut self,
        unit: usize,
        range: i32,
        start: u32,
        even_odd: u32,
        info: &TextureInfo,
    ) -> bool {
        if !(0..=3).contains(&range) {
            return false;
        }
        let level = range as u32;
        let base = layout::base_address(start, level, info.aspect, info.format, even_odd);
        self.tmus[unit].base[range as usize] = base >> 3;
        self.dirty = true;
        true
    }

    pub(crate) fn set_multibase(&mut self, unit: usize, on: bool) {
        let tmu = &mut self.tmus[unit];
        tmu.t_lod = switch(tmu.t_lod, t_lod::MULTIBASE, on);
        self.dirty = true;
    }

    pub(crate) fn set_clamp(&mut self, unit: usize, s: i32, t: i32) -> bool {
        self.mode(unit, texture_mode::CLAMP_S, s != 0);
        self.mode(unit, texture_mode::CLAMP_T, t != 0);
        matches!((s, t), (0 | 1, 0 | 1))
    }

    pub(crate) fn set_filter(&mut self, unit: usize, minify: i32, magnify: i32) -> bool {
        self.mode(unit, texture_mode::MINIFY_BILINEAR, minify != 0);
        self.mode(unit, texture_mode::MAGNIFY_BILINEAR, magnify != 0);
        matches!((minify, magnify), (0 | 1, 0 | 1))
    }

    pub(crate) fn set_mip_map_mode(&mut self, unit: usize, mode: i32, blend: bool) -> bool {
        if !(0..=2).contains(&mode) {
            return false;
        }
        let dither = mode == MIPMAP_NEAREST_DITHER && self.settings.allow_lod_dither;
        self.settings.units[unit].mip_map_mode = mode;
        self.mode(unit, texture_mode::LOD_DITHER, dither);
        self.mode(unit, texture_mode::TRILINEAR, blend);
        self.update_lod_range(unit);
        self.update_parity(unit);
        true
    }

    /// Writes which levels a unit samples: those that its texture was sourced
    /// with. The second of two passes over a whole texture, which the factor
    /// tells, takes the odd ones.
    ///
    /// Source: G246, `grTexCombine` and `grTexMipMapMode`, which test for any of
    /// these bits.
    fn update_parity(&mut self, unit: usize) {
        const BLENDS: u32 = unit::SUB_LOCAL | unit::ADD_LOCAL | 5 << unit::SELECT_SHIFT;
        let own = split_bits(self.settings.units[unit].even_odd);
        let tmu = &mut self.tmus[unit];
        let color = tmu.texture_mode >> texture_mode::COLOR_UNIT;
        let second = tmu.texture_mode & texture_mode::TRILINEAR != 0
            && color & unit::ZERO_OTHER != 0
            && color & BLENDS != 0
            && color & unit::REVERSE_BLEND == 0;
        let parity = own | if second { t_lod::ODD } else { 0 };
        tmu.t_lod = replace(tmu.t_lod, t_lod::SPLIT | t_lod::ODD, parity);
        self.dirty = true;
    }

    pub(crate) fn set_lod_bias(&mut self, unit: usize, bias: f32) {
        let tmu = &mut self.tmus[unit];
        tmu.t_lod = replace(tmu.t_lod, 0x3f << 12, lod_bias_quarters(bias) << 12);
        self.dirty = true;
    }

    pub(crate) fn set_detail(&mut self, unit: usize, bias: i32, scale: u8, max: f32) {
        let max = (max * 255.0) as i32 as u32 & 0xff;
        let bits = max | (bias as u32 & 0x3f) << 8 | (u32::from(scale) & 7) << 14;
        self.tmus[unit].t_detail = bits;
        self.dirty = true;
    }

    /// Function and factor of colour and of alpha; inversion of each.
    pub(crate) fn set_texture_combine(
        &mut self,
        index: usize,
        [rgb, rgb_factor, alpha, alpha_factor]: [i32; 4],
        [rgb_invert, alpha_invert]: [bool; 2],
    ) -> bool {
        let color = unit_bits(rgb, rgb_factor, rgb_invert, Channel::Color);
        let alpha = unit_bits(alpha, alpha_factor, alpha_invert, Channel::Alpha);
        let (Some(color), Some(alpha)) = (color, alpha) else { return false };
        let tmu = &mut self.tmus[index];
        let bits = color << texture_mode::COLOR_UNIT | alpha << texture_mode::ALPHA_UNIT;
        let mask = unit::ALL << texture_mode::COLOR_UNIT | unit::ALL << texture_mode::ALPHA_UNIT;
        tmu.texture_mode = replace(tmu.texture_mode, mask, bits);
        self.update_parity(index);
        true
    }

    pub(crate) fn set_ncc_table(&mut self, unit: usize, table: i32) -> bool {
        self.mode(unit, texture_mode::NCC_TABLE, table == 1);
        matches!(table, 0 | 1)
    }

    /// Stores rows `first..=last` of a level; `data` starts with the first of
    /// them. Returns how many bytes were used.
    pub(crate) fn download_rows(
        &mut self,
        unit: usize,
        start: u32,
        lod: u32,
        info: &TextureInfo,
        even_odd: u32,
        rows: (u32, u32),
        data: &[u8],
    ) -> usize {
        let (width, height) = layout::size(info.aspect, lod);
        let pitch = width * layout::texel_bytes(info.format);
        let (first, last) = (rows.0.min(height), (rows.1 + 1).min(height));
        let bytes = (last.saturating_sub(first) * pitch) as usize;
        let used = bytes.min(data.len());
        if layout::is_selected(even_odd, lod) {
            let level = level_address(start, lod, info, even_odd);
            self.memories[unit].write(level.wrapping_add(first * pitch), &data[..used]);
            self.dirty = true;
        }
        used
    }

    /// Stores the first 16-bit texels of a row of a level.
    pub(crate) fn download_row_start(
        &mut self,
        unit: usize,
        start: u32,
        lod: u32,
        info: &TextureInfo,
        even_odd: u32,
        row: u32,
        texels: &[u16],
    ) {
        let (width, height) = layout::size(info.aspect, lod);
        if row >= height || !layout::is_selected(even_odd, lod) {
            return;
        }
        let texels = texels.iter().take(width as usize);
        let bytes: Vec<u8> = texels.flat_map(|texel| texel.to_le_bytes()).collect();
        let level = level_address(start, lod, info, even_odd);
        self.memories[unit].write(level.wrapping_add(row * width * 2), &bytes);
        self.dirty = true;
    }
}

/// Where a level of a texture at `start` lies, wrapping.
fn level_address(start: u32, lod: u32, info: &TextureInfo, even_odd: u32) -> u32 {
    let large = info.large_lod as u32;
    let base = layout::base_address(start, large, info.aspect, info.format, even_odd);
    base.wrapping_add(layout::offset(info.aspect, lod, info.format, even_odd))
}
