//! A texture unit's memory and tables, and the textures decoded from them.

use std::sync::Arc;

use fillrate_engine::{Texture, TextureDesc};

use super::formats::{NccTable, decode};
use super::layout;
use crate::enums::{LEVELS_BOTH, LEVELS_EVEN, LEVELS_ODD};
use crate::enums::{TEXFMT_AP_88, TEXFMT_AYIQ_8422, TEXFMT_P_8, TEXFMT_YIQ_422};
use crate::registers::{TmuRegisters, t_lod, texture_mode};
use crate::translate::has_parity;

/// What a decoded texture was made from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Source {
    format: i32,
    aspect: i32,
    /// Levels as numbers: first and last in use.
    levels: (u32, u32),
    even_odd: u32,
    /// Bytes where level 256 of each group would be.
    base: [u32; 4],
    ncc: bool,
    clamp_s: bool,
}

#[derive(Debug)]
struct Cached {
    source: Source,
    /// Address ranges read, start and length.
    ranges: Vec<(u32, u32)>,
    texture: Arc<Texture>,
}

/// Decoded textures that are kept.
const CACHE_LIMIT: usize = 512;

/// Texture memory of one unit.
#[derive(Debug)]
pub struct TextureMemory {
    bytes: Vec<u8>,
    palette: [u32; 256],
    ncc: [NccTable; 2],
    cache: Vec<Cached>,
}

impl TextureMemory {
    /// Memory of a power-of-two size in bytes, zeros.
    pub fn new(size: usize) -> TextureMemory {
        TextureMemory {
            bytes: vec![0; size.next_power_of_two()],
            palette: [0; 256],
            ncc: [NccTable::default(); 2],
            cache: Vec::new(),
        }
    }

    /// Bytes of the memory.
    pub fn size(&self) -> u32 {
        self.bytes.len() as u32
    }

    /// Stores bytes at an address, which wraps at the memory's end.
    pub fn write(&mut self, address: u32, data: &[u8]) {
        let mask = self.bytes.len() - 1;
        for (i, &byte) in data.iter().enumerate() {
            self.bytes[(address as usize).wrapping_add(i) & mask] = byte;
        }
        self.forget_range(address, data.len() as u32);
    }

    /// Replaces palette entries from `start` on, 0x00RRGGBB each; entries past
    /// the end are dropped.
    pub fn set_palette(&mut self, start: usize, entries: &[u32]) {
        for (to, from) in self.palette.iter_mut().skip(start).zip(entries) {
            *to = from & 0x00ff_ffff;
        }
        self.cache.retain(|c| !matches!(c.source.format, TEXFMT_P_8 | TEXFMT_AP_88));
    }

    /// Replaces words of an NCC table (0 or 1) from `start` on.
    pub fn set_ncc(&mut self, table: usize, start: usize, words: &[u32]) {
        for (i, &word) in words.iter().enumerate() {
            self.ncc[table & 1].set_word(start + i, word);
        }
        self.cache.retain(|c| !matches!(c.source.format, TEXFMT_YIQ_422 | TEXFMT_AYIQ_8422));
    }

    fn forget_range(&mut self, address: u32, length: u32) {
        let size = self.size();
        // Distances are taken around the wrap.
        let overlaps = |&(start, bytes): &(u32, u32)| {
            let to = start.wrapping_sub(address) & (size - 1);
            let from = address.wrapping_sub(start) & (size - 1);
            to < length || from < bytes
        };
        self.cache.retain(|cached| !cached.ranges.iter().any(overlaps));
    }

    /// The texture that the registers describe.
    pub fn texture(&mut self, registers: &TmuRegisters) -> Arc<Texture> {
        let source = source(registers);
        if let Some(at) = self.cache.iter().position(|cached| cached.source == source) {
            // The front of the list is looked at first.
            self.cache.swap(0, at);
            return self.cache[0].texture.clone();
        }
        let (texture, ranges) = self.build(&source);
        let texture = Arc::new(texture);
        self.make_room(texels(&source, &ranges));
        self.cache.push(Cached { source, ranges, texture: texture.clone() });
        texture
    }

    /// Drops decoded textures until there is room for so many more texels: twice
    /// what the memory can hold is kept, since one place can be read in several
    /// ways.
    fn make_room(&mut self, wanted: usize) {
        let kept = |cached: &Cached| texels(&cached.source, &cached.ranges);
        let mut all: usize = self.cache.iter().map(kept).sum();
        while self.cache.len() >= CACHE_LIMIT || all + wanted > 2 * self.bytes.len() {
            let Some(dropped) = self.cache.pop() else { break };
            all -= kept(&dropped);
        }
    }

    fn build(&self, source: &Source) -> (Texture, Vec<(u32, u32)>) {
        let (bits, wide) = layout::aspect_bits(source.aspect);
        let short = (8 - bits) as u8;
        let (first, last) = source.levels;
        let desc = TextureDesc {
            s_bits: if wide { 8 } else { short },
            t_bits: if wide { short } else { 8 },
            first: first as u8,
            last: last as u8,
            clamp_s: source.clamp_s,
        };
        let mut ranges = Vec::new();
        let texture = Texture::build(desc, |level, out| {
            ranges.push(self.read_level(source, u32::from(level), out));
        });
        (texture.expect("levels of 256 texels and less have valid shapes"), ranges)
    }

    /// Decodes a level; returns the address range it lies in. A level that the
    /// chain does not have reads as zeros: it is never sampled.
    fn read_level(&self, source: &Source, lod: u32, out: &mut Vec<u32>) -> (u32, u32) {
        let (width, height) = layout::size(source.aspect, lod);
        let texels = width * height;
        if !layout::is_selected(source.even_odd, lod) {
            out.extend((0..texels).map(|_| 0));
            return (0, 0);
        }
        let group = lod.min(3) as usize;
        let offset = layout::offset(source.aspect, lod, source.format, source.even_odd);
        let start = source.base[group].wrapping_add(offset);
        let mask = self.bytes.len() - 1;
        let byte = |at: u32| u16::from(self.bytes[start.wrapping_add(at) as usize & mask]);
        let ncc = &self.ncc[usize::from(source.ncc)];
        let wide = layout::texel_bytes(source.format) == 2;
        out.extend((0..texels).map(|i| {
            let texel = if wide { byte(2 * i) | byte(2 * i + 1) << 8 } else { byte(i) };
            decode(source.format, texel, &self.palette, ncc)
        }));
        (start & mask as u32, texels * layout::texel_bytes(source.format))
    }
}

/// Texels that a decoded texture holds.
fn texels(source: &Source, ranges: &[(u32, u32)]) -> usize {
    let bytes: u32 = ranges.iter().map(|&(_, length)| length).sum();
    (bytes / layout::texel_bytes(source.format)) as usize
}

/// Decodes the registers that say where texels are.
fn source(registers: &TmuRegisters) -> Source {
    let (mode, lod) = (registers.texture_mode, registers.t_lod);
    let bits = (lod >> t_lod::ASPECT & 3) as i32;
    let aspect = if lod & t_lod::S_IS_WIDER != 0 { 3 - bits } else { 3 + bits };
    let even_odd = match (lod & t_lod::SPLIT != 0, lod & t_lod::ODD != 0) {
        (false, _) => LEVELS_BOTH,
        (true, false) => LEVELS_EVEN,
        (true, true) => LEVELS_ODD,
    };
    let last = (lod >> 6 & 63).div_ceil(4).min(layout::SMALLEST);
    let first = ((lod & 63) / 4).min(last);
    // The level after the last replaces it where only some are sampled.
    let chooses = even_odd != LEVELS_BOTH || has_parity(registers);
    let last = if chooses { (last + 1).min(layout::SMALLEST) } else { last };
    let base = if lod & t_lod::MULTIBASE != 0 { registers.base } else { [registers.base[0]; 4] };
    Source {
        format: (mode >> texture_mode::FORMAT & 15) as i32,
        aspect,
        levels: (first, last),
        even_odd,
        base: base.map(|eights| eights.wrapping_mul(8)),
        ncc: mode & texture_mode::NCC_TABLE != 0,
        clamp_s: mode & texture_mode::CLAMP_S != 0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn registers(format: u32) -> TmuRegisters {
        // A square chain of one 1x1 level.
        TmuRegisters {
            texture_mode: format << texture_mode::FORMAT,
            t_lod: 32 | 32 << 6,
            ..TmuRegisters::default()
        }
    }

    #[test]
    fn downloads_replace_cached_textures() {
        let mut memory = TextureMemory::new(1 << 20);
        let at = layout::offset(3, 8, 3, LEVELS_BOTH);
        memory.write(at, &[7]);
        assert_eq!(memory.texture(&registers(3)).texel(8, 0, 0), 0xff07_0707);
        memory.write(at + 100, &[9]);
        assert_eq!(memory.texture(&registers(3)).texel(8, 0, 0), 0xff07_0707);
        memory.write(at - 1, &[1, 9]);
        assert_eq!(memory.texture(&registers(3)).texel(8, 0, 0), 0xff09_0909);
    }

    /// However many ways there are to read the memory.
    #[test]
    fn decoded_textures_stay_within_twice_the_memory() {
        let mut memory = TextureMemory::new(1 << 20);
        for base in 0..400 {
            // A square of 256 texels a side, in a format of eight bits.
            let registers = TmuRegisters { base: [base; 4], t_lod: 0, ..registers(3) };
            memory.texture(&registers);
            let kept: usize = memory.cache.iter().map(|c| texels(&c.source, &c.ranges)).sum();
            assert!(kept <= 2 << 20, "{kept}");
        }
        assert!(memory.cache.len() >= 16);
    }

    #[test]
    fn palettes_replace_cached_textures() {
        let mut memory = TextureMemory::new(1 << 20);
        memory.set_palette(0, &[0xff12_3456]);
        assert_eq!(memory.texture(&registers(5)).texel(8, 0, 0), 0xff12_3456);
        memory.set_palette(0, &[0x11]);
        assert_eq!(memory.texture(&registers(5)).texel(8, 0, 0), 0xff00_0011);
    }

    #[test]
    fn addresses_wrap_at_the_end() {
        let mut memory = TextureMemory::new(1 << 10);
        memory.write(0xffff_fffe, &[1, 2, 3]);
        assert_eq!((memory.bytes[1022], memory.bytes[1023], memory.bytes[0]), (1, 2, 3));
    }
}
