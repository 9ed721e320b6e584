//! Saving and restoring the state as 312 opaque bytes.
//!
//! Source: G246, `GrState`: registers and settings; not the fog table, gamma,
//! palettes, texture memory or frame buffer.

use crate::board::{Board, Settings, UnitSettings};
use crate::enums::{LEVELS_BOTH, LEVELS_EVEN, LEVELS_ODD};
use crate::registers::{FbiRegisters, TmuRegisters, t_lod};

/// Bytes of a saved state.
pub const STATE_BYTES: usize = 312;

/// The first word of a saved state, so that other bytes are told apart.
const MAGIC: u32 = 0x3253_4c46;

/// The same of releases that kept the levels of textures in tLOD alone.
/// Recordings hold such states.
const EARLIER: u32 = 0x3153_4c46;

/// Words written and read in order.
struct Words {
    bytes: [u8; STATE_BYTES],
    at: usize,
}

impl Words {
    fn put(&mut self, word: u32) {
        if let Some(to) = self.bytes.get_mut(self.at..self.at + 4) {
            to.copy_from_slice(&word.to_le_bytes());
        }
        self.at += 4;
    }

    fn take(&mut self) -> u32 {
        let word =
            self.bytes.get(self.at..self.at + 4).map_or([0; 4], |b| [b[0], b[1], b[2], b[3]]);
        self.at += 4;
        u32::from_le_bytes(word)
    }
}

impl Board {
    /// The state as bytes.
    pub(crate) fn save(&self) -> [u8; STATE_BYTES] {
        let mut out = Words { bytes: [0; STATE_BYTES], at: 0 };
        out.put(MAGIC);
        let f = &self.lasting_registers();
        [
            f.fbz_color_path,
            f.fog_mode,
            f.alpha_mode,
            f.fbz_mode,
            f.lfb_mode,
            f.clip_left_right,
            f.clip_bottom_top,
            f.fog_color,
            f.za_color,
            f.chroma_key,
            f.stipple,
            f.color0,
            f.color1,
        ]
        .into_iter()
        .for_each(|word| out.put(word));
        let s = &self.settings;
        let flags = u32::from(s.allow_lod_dither) | u32::from(s.delta0) << 1;
        let lfb = u32::from(s.lfb_alpha) << 16 | u32::from(s.lfb_depth);
        [s.cull as u32, s.stw_hints, flags, lfb, s.color_format as u32]
            .into_iter()
            .chain(s.constant.map(f32::to_bits))
            .chain(s.clip.map(f32::to_bits))
            .for_each(|word| out.put(word));
        for (unit, tmu) in self.tmus.iter().enumerate() {
            let own = s.units[unit];
            [tmu.texture_mode, tmu.t_lod, tmu.t_detail].into_iter().for_each(|w| out.put(w));
            tmu.base.into_iter().for_each(|word| out.put(word));
            let lods = own.even_odd << 16 | own.small_lod << 8 | own.large_lod;
            [own.mip_map_mode as u32, lods].into_iter().for_each(|w| out.put(w));
        }
        for unit in 0..self.tmus.len() {
            // One more than the handle, so that zeros name none.
            out.put(self.mip_maps.current(unit).map_or(0, |id| id + 1));
        }
        debug_assert!(out.at <= STATE_BYTES, "three units take 252 bytes");
        out.bytes
    }

    /// Restores saved bytes; false for bytes that no board saved.
    pub(crate) fn restore(&mut self, bytes: &[u8]) -> bool {
        let Ok(bytes) = <[u8; STATE_BYTES]>::try_from(bytes) else { return false };
        let mut from = Words { bytes, at: 0 };
        let magic = from.take();
        if !matches!(magic, MAGIC | EARLIER) {
            return false;
        }
        self.fbi = FbiRegisters {
            fbz_color_path: from.take(),
            fog_mode: from.take(),
            alpha_mode: from.take(),
            fbz_mode: from.take(),
            lfb_mode: from.take(),
            clip_left_right: from.take(),
            clip_bottom_top: from.take(),
            fog_color: from.take(),
            za_color: from.take(),
            chroma_key: from.take(),
            stipple: from.take(),
            color0: from.take(),
            color1: from.take(),
        };
        let (cull, stw_hints, flags, lfb, color_format) =
            (from.take() as i32, from.take(), from.take(), from.take(), from.take() as i32);
        let mut floats = || core::array::from_fn(|_| f32::from_bits(from.take()));
        let (constant, clip) = (floats(), floats());
        self.settings = Settings {
            cull,
            stw_hints,
            allow_lod_dither: flags & 1 != 0,
            delta0: flags & 2 != 0,
            constant,
            lfb_alpha: (lfb >> 16) as u8,
            lfb_depth: lfb as u16,
            color_format,
            clip,
            units: self.settings.units,
        };
        for (unit, tmu) in self.tmus.iter_mut().enumerate() {
            *tmu = TmuRegisters {
                texture_mode: from.take(),
                t_lod: from.take(),
                t_detail: from.take(),
                base: core::array::from_fn(|_| from.take()),
            };
            let (mip_map_mode, lods) = (from.take() as i32, from.take());
            let (small_lod, large_lod) = ((lods >> 8 & 0xff).min(8), (lods & 0xff).min(8));
            let even_odd = match (magic, tmu.t_lod & (t_lod::SPLIT | t_lod::ODD)) {
                (MAGIC, _) => lods >> 16 & LEVELS_BOTH,
                (_, t_lod::SPLIT) => LEVELS_EVEN,
                (_, bits) if bits & t_lod::SPLIT != 0 => LEVELS_ODD,
                _ => LEVELS_BOTH,
            };
            self.settings.units[unit] =
                UnitSettings { mip_map_mode, small_lod, large_lod, even_odd };
        }
        for unit in 0..self.tmus.len() {
            self.mip_maps.set_current(unit, from.take().checked_sub(1));
        }
        if let Some(lock) = &mut self.lfb.write {
            lock.keep(&self.fbi);
        }
        self.dirty = true;
        true
    }
}
