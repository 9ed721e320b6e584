//! The texture manager: hands out texture memory and remembers how each mip
//! map is to be sampled.
//!
//! Source: G246, `guTexAllocateMemory` and its relatives; `GrMipMapInfo`.

use crate::board::{Board, UnitSettings};
use crate::context::Context;
use crate::enums::*;
use crate::registers::{replace, texture_mode};
use crate::texture::{layout, words_of};
use crate::texture_state::{TextureInfo, shape_bits};

/// The most mip maps of a board.
pub const MAX_MIP_MAPS: usize = 1024;

/// The handle that names no mip map.
pub const NULL_MIP_MAP: u32 = u32::MAX;

/// Bytes of a compression table as programs lay it out: 16 Y, 12 I and 12 Q
/// numbers, then the 12 words that the hardware takes.
pub const NCC_TABLE_BYTES: usize = 112;

/// Bytes before the twelve words.
const NCC_WORDS_AT: usize = 64;

/// A chain of levels must not cross a multiple of this.
const BANK: u32 = 2 << 20;

/// What the manager keeps of a mip map.
#[derive(Clone, Debug, PartialEq)]
pub struct MipMap {
    /// The board that holds it.
    pub board: i32,
    /// Columns of the largest level, as the program said.
    pub width: i32,
    /// Rows of the largest level, as the program said.
    pub height: i32,
    /// Levels, aspect ratio and format.
    pub info: TextureInfo,
    /// 0 (off) to 2 (nearest, dithered).
    pub mip_map_mode: i32,
    /// Filter of magnified texels, 0 or 1.
    pub magnify: i32,
    /// Filter of minified texels, 0 or 1.
    pub minify: i32,
    /// 1 where s is clamped.
    pub s_clamp: i32,
    /// 1 where t is clamped.
    pub t_clamp: i32,
    /// Level bias in quarters, six bits.
    pub lod_bias: u32,
    /// The texture unit.
    pub tmu: i32,
    /// Even levels (1), odd ones (2) or all (3).
    pub even_odd: u32,
    /// Address of the largest level that is stored.
    pub start: u32,
    /// Whether neighbouring levels are blended.
    pub trilinear: bool,
    /// Compression table of a YIQ texture, [`NCC_TABLE_BYTES`] long.
    pub ncc_table: [u8; NCC_TABLE_BYTES],
}

impl MipMap {
    /// The tLOD register.
    pub fn t_lod(&self) -> u32 {
        let (small, large) = (self.info.small_lod as u32, self.info.large_lod as u32);
        let last = if self.mip_map_mode == MIPMAP_DISABLE { large } else { small };
        let shape = shape_bits(self.info.aspect, self.even_odd);
        (large * 4) | ((last * 4) << 6) | (self.lod_bias << 12) | shape
    }

    /// The textureMode register, without the combine units.
    pub fn texture_mode(&self) -> u32 {
        use texture_mode as bit;
        let on = |holds: bool, bit: u32| if holds { bit } else { 0 };
        bit::PERSPECTIVE
            | bit::CLAMP_W
            | (self.info.format as u32) << bit::FORMAT
            | on(self.minify != 0, bit::MINIFY_BILINEAR)
            | on(self.magnify != 0, bit::MAGNIFY_BILINEAR)
            | on(self.s_clamp != 0, bit::CLAMP_S)
            | on(self.t_clamp != 0, bit::CLAMP_T)
            | on(self.mip_map_mode == MIPMAP_NEAREST_DITHER, bit::LOD_DITHER)
            | on(self.trilinear, bit::TRILINEAR)
    }

    /// Where level 256 would be, wrapping.
    pub fn base_address(&self) -> u32 {
        let info = &self.info;
        let large = info.large_lod as u32;
        layout::base_address(self.start, large, info.aspect, info.format, self.even_odd)
    }

    /// Whether every field is one the hardware knows.
    fn is_valid(&self) -> bool {
        let switch = |value: i32| matches!(value, 0 | 1);
        self.info.is_valid()
            && (1..=3).contains(&self.even_odd)
            && (0..=2).contains(&self.mip_map_mode)
            && [self.magnify, self.minify, self.s_clamp, self.t_clamp].into_iter().all(switch)
    }

    /// Bytes that it takes in texture memory.
    fn memory_bytes(&self) -> u32 {
        let (small, large) = (self.info.small_lod as u32, self.info.large_lod as u32);
        layout::chain_bytes(small, large, self.info.aspect, self.info.format, self.even_odd)
    }

    /// Bytes of a level as a program stores it; 0 for one it does not have.
    pub fn level_bytes(&self, lod: i32) -> usize {
        let info = &self.info;
        if !(info.large_lod..=info.small_lod).contains(&lod) {
            return 0;
        }
        let (width, height) = layout::size(info.aspect, lod as u32);
        (width * height * layout::texel_bytes(info.format)) as usize
    }

    /// Bytes of all levels as a program stores them.
    pub fn all_bytes(&self) -> usize {
        (self.info.large_lod..=self.info.small_lod).map(|lod| self.level_bytes(lod)).sum()
    }

    /// Whether its texels are compressed.
    fn has_ncc_table(&self) -> bool {
        matches!(self.info.format, TEXFMT_YIQ_422 | TEXFMT_AYIQ_8422)
    }
}

/// A texture unit's share of the manager.
#[derive(Clone, Copy, Debug, Default)]
struct UnitUse {
    /// The first free byte.
    free: u32,
    /// The mip map sourced last.
    current: Option<u32>,
    /// Whose table each of the two compression tables holds.
    ncc: [Option<u32>; 2],
    /// The table that was loaded longest ago.
    next_ncc: usize,
}

/// The mip maps of a board.
#[derive(Debug)]
pub(crate) struct MipMaps {
    records: Vec<MipMap>,
    units: Vec<UnitUse>,
}

impl MipMaps {
    pub fn new(units: usize) -> MipMaps {
        MipMaps { records: Vec::new(), units: vec![UnitUse::default(); units] }
    }

    /// Forgets all mip maps.
    pub fn reset(&mut self) {
        *self = MipMaps::new(self.units.len());
    }

    /// The mip map of a handle.
    pub fn get(&self, id: u32) -> Option<&MipMap> {
        self.records.get(id as usize)
    }

    /// The mip map that a unit sourced last.
    pub fn current(&self, unit: usize) -> Option<u32> {
        self.units.get(unit)?.current
    }

    /// Whether its unit sourced a mip map last.
    pub fn is_current(&self, id: u32) -> bool {
        let unit = self.get(id).and_then(|mip_map| usize::try_from(mip_map.tmu).ok());
        unit.is_some_and(|unit| self.current(unit) == Some(id))
    }

    /// As [`MipMaps::current`] after a saved state comes back; handles given
    /// up since then are dropped.
    pub fn set_current(&mut self, unit: usize, id: Option<u32>) {
        let known = id.filter(|&id| self.get(id).is_some());
        if let Some(unit) = self.units.get_mut(unit) {
            unit.current = known;
        }
    }

    /// A compression table was replaced by somebody else.
    pub fn lose_ncc_table(&mut self, unit: usize, table: usize) {
        if let Some(owner) = self.units.get_mut(unit).and_then(|unit| unit.ncc.get_mut(table)) {
            *owner = None;
        }
    }

    /// Free bytes of a unit with that much memory.
    pub fn available(&self, unit: usize, memory: u32) -> u32 {
        self.units.get(unit).map_or(0, |unit| memory.saturating_sub(unit.free))
    }

    /// Finds memory of a mip map and takes it; `None` where memory or handles
    /// are used up, which changes nothing.
    fn add(&mut self, mut mip_map: MipMap, memory: u32) -> Option<u32> {
        let bytes = mip_map.memory_bytes();
        let unit = self.units.get_mut(usize::try_from(mip_map.tmu).ok()?)?;
        let crosses = unit.free / BANK != (unit.free + bytes.max(1) - 1) / BANK;
        let start = if crosses { unit.free.next_multiple_of(BANK) } else { unit.free };
        if self.records.len() >= MAX_MIP_MAPS || start + bytes > memory {
            return None;
        }
        unit.free = start + bytes;
        mip_map.start = start;
        self.records.push(mip_map);
        Some(self.records.len() as u32 - 1)
    }

    /// The compression table for a mip map, and whether it must be loaded:
    /// the one that holds it, or the one loaded longest ago.
    fn ncc_slot(&mut self, unit: usize, id: u32) -> (usize, bool) {
        let unit = &mut self.units[unit];
        if let Some(table) = unit.ncc.iter().position(|&owner| owner == Some(id)) {
            return (table, false);
        }
        let table = unit.next_ncc;
        unit.ncc[table] = Some(id);
        unit.next_ncc = 1 - table;
        (table, true)
    }
}

/// Attributes that a call replaces; -1 keeps a field.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Attributes {
    pub width: i32,
    pub height: i32,
    pub format: i32,
    pub mip_map_mode: i32,
    pub small_lod: i32,
    pub large_lod: i32,
    pub aspect: i32,
    pub s_clamp: i32,
    pub t_clamp: i32,
    pub minify: i32,
    pub magnify: i32,
}

impl Attributes {
    fn apply(&self, mip_map: &mut MipMap) {
        let fields = [
            (&mut mip_map.width, self.width),
            (&mut mip_map.height, self.height),
            (&mut mip_map.info.format, self.format),
            (&mut mip_map.mip_map_mode, self.mip_map_mode),
            (&mut mip_map.info.small_lod, self.small_lod),
            (&mut mip_map.info.large_lod, self.large_lod),
            (&mut mip_map.info.aspect, self.aspect),
            (&mut mip_map.s_clamp, self.s_clamp),
            (&mut mip_map.t_clamp, self.t_clamp),
            (&mut mip_map.minify, self.minify),
            (&mut mip_map.magnify, self.magnify),
        ];
        for (field, value) in fields {
            if value != -1 {
                *field = value;
            }
        }
    }
}

impl Board {
    /// Makes a mip map current on its unit. All of the unit's state but the
    /// combine units and the detail factor comes from the record.
    pub(crate) fn source_mip_map(&mut self, id: u32) {
        let Some(mip_map) = self.mip_maps.get(id).cloned() else { return };
        let unit = mip_map.tmu as usize;
        self.settings.units[unit] = UnitSettings {
            mip_map_mode: mip_map.mip_map_mode,
            small_lod: mip_map.info.small_lod as u32,
            large_lod: mip_map.info.large_lod as u32,
            even_odd: mip_map.even_odd,
        };
        use texture_mode as bit;
        let own = bit::COLOR_UNIT_MASK | bit::ALPHA_UNIT_MASK;
        let mut mode = mip_map.texture_mode();
        if !self.settings.allow_lod_dither {
            mode &= !bit::LOD_DITHER;
        }
        if mip_map.has_ncc_table() && self.load_ncc_table(unit, id, &mip_map) == 1 {
            mode |= bit::NCC_TABLE;
        }
        let tmu = &mut self.tmus[unit];
        tmu.texture_mode = replace(mode, own, tmu.texture_mode);
        tmu.t_lod = mip_map.t_lod();
        tmu.base[0] = mip_map.base_address() >> 3;
        self.mip_maps.set_current(unit, Some(id));
        self.dirty = true;
    }

    /// Sees that a mip map's compression table is loaded; returns which table
    /// holds it.
    fn load_ncc_table(&mut self, unit: usize, id: u32, mip_map: &MipMap) -> usize {
        let (table, missing) = self.mip_maps.ncc_slot(unit, id);
        if missing {
            let words = words_of(&mip_map.ncc_table[NCC_WORDS_AT..]);
            self.memories[unit].set_ncc(table, 0, &words);
        }
        table
    }

    /// Stores a level of a mip map; returns the bytes used.
    fn download_level(&mut self, mip_map: &MipMap, lod: i32, data: &[u8]) -> usize {
        let (unit, start, even_odd) = (mip_map.tmu as usize, mip_map.start, mip_map.even_odd);
        let rows = (0, u32::from(u8::MAX));
        self.download_rows(unit, start, lod as u32, &mip_map.info, even_odd, rows, data)
    }
}

const NO_HANDLE: &str = "there is no mip map with this handle";

impl Context {
    /// The mip map of a handle on the current board.
    pub fn mip_map(&self, id: u32) -> Option<&MipMap> {
        self.boards.get(self.current).filter(|board| board.is_open())?.mip_maps.get(id)
    }

    /// The mip map that a unit sourced last, or [`NULL_MIP_MAP`].
    pub fn current_mip_map(&mut self, tmu: i32) -> u32 {
        let unit = self.unit("guTexGetCurrentMipMap", tmu);
        unit.and_then(|(board, unit)| board.mip_maps.current(unit)).unwrap_or(NULL_MIP_MAP)
    }

    /// Bytes of a unit's memory that the manager can still hand out.
    pub fn available_texture_memory(&mut self, tmu: i32) -> u32 {
        let memory = self.texture_memory(tmu);
        let unit = self.unit("guTexMemQueryAvail", tmu);
        unit.map_or(0, |(board, unit)| board.mip_maps.available(unit, memory))
    }

    /// Takes memory for a mip map; `mip_map.start` and `board` are filled in.
    pub(crate) fn allocate_mip_map(&mut self, mut mip_map: MipMap) -> u32 {
        const NAME: &str = "guTexAllocateMemory";
        let (valid, memory) = (mip_map.is_valid(), self.texture_memory(mip_map.tmu));
        mip_map.board = self.current as i32;
        if self.unit(NAME, mip_map.tmu).is_none() {
            return NULL_MIP_MAP;
        }
        self.check(valid, NAME, "the mip map's description is out of range");
        let board = &mut self.boards[self.current];
        let added = if valid { board.mip_maps.add(mip_map, memory) } else { None };
        added.unwrap_or(NULL_MIP_MAP)
    }

    /// Changes a record; false where that names no mip map or leaves it with
    /// values the hardware does not know.
    pub(crate) fn change_mip_map(&mut self, id: u32, attributes: &Attributes) -> bool {
        const NAME: &str = "guTexChangeAttributes";
        let Some(mut changed) = self.named_mip_map(NAME, id) else { return false };
        attributes.apply(&mut changed);
        let valid = changed.is_valid();
        self.check(valid, NAME, "the mip map's description is out of range");
        if valid {
            let board = &mut self.boards[self.current];
            board.mip_maps.records[id as usize] = changed;
        }
        valid
    }

    /// Stores all levels, and the compression table where the format has one.
    pub(crate) fn download_mip_map(&mut self, id: u32, data: &[u8], table: Option<&[u8]>) {
        const NAME: &str = "guTexDownloadMipMap";
        let Some(mip_map) = self.named_mip_map(NAME, id) else { return };
        self.check(data.len() >= mip_map.all_bytes(), NAME, "levels are missing");
        let table = table.and_then(|table| <[u8; NCC_TABLE_BYTES]>::try_from(table).ok());
        let needs = mip_map.has_ncc_table();
        self.check(!needs || table.is_some(), NAME, "a YIQ texture needs its table");
        if !self.fits(NAME, &mip_map) {
            return;
        }
        let board = &mut self.boards[self.current];
        if let Some(table) = table.filter(|_| needs) {
            board.mip_maps.records[id as usize].ncc_table = table;
            let unit = &mut board.mip_maps.units[mip_map.tmu as usize];
            // Where it is loaded already, it has to be loaded again.
            unit.ncc.iter_mut().filter(|owner| **owner == Some(id)).for_each(|o| *o = None);
        }
        let mut rest = data;
        for lod in mip_map.info.large_lod..=mip_map.info.small_lod {
            rest = &rest[board.download_level(&mip_map, lod, rest)..];
        }
    }

    /// Stores one level.
    pub(crate) fn download_mip_map_level(&mut self, id: u32, lod: i32, data: &[u8]) {
        const NAME: &str = "guTexDownloadMipMapLevel";
        let Some(mip_map) = self.named_mip_map(NAME, id) else { return };
        let bytes = mip_map.level_bytes(lod);
        self.check(bytes > 0, NAME, "the mip map has no such level");
        if bytes > 0 && self.fits(NAME, &mip_map) {
            self.boards[self.current].download_level(&mip_map, lod, data);
        }
    }

    /// Makes a mip map current; the null handle does nothing.
    pub(crate) fn source_mip_map(&mut self, id: u32) {
        const NAME: &str = "guTexSource";
        if id == NULL_MIP_MAP {
            return;
        }
        if let Some(mip_map) = self.named_mip_map(NAME, id)
            && self.fits(NAME, &mip_map)
        {
            self.boards[self.current].source_mip_map(id);
        }
    }

    /// Forgets all mip maps of the current board.
    pub(crate) fn reset_mip_maps(&mut self) {
        if let Some(board) = self.board("guTexMemReset") {
            board.mip_maps.reset();
        }
    }

    /// The record of a handle; tells where there is none.
    fn named_mip_map(&mut self, name: &str, id: u32) -> Option<MipMap> {
        let found = self.board(name)?.mip_maps.get(id).cloned();
        self.check(found.is_some(), name, NO_HANDLE);
        found
    }

    /// Whether a mip map stays within a bank. Changed attributes can make one
    /// larger than the memory it was given.
    fn fits(&mut self, name: &str, mip_map: &MipMap) -> bool {
        let end = mip_map.start + mip_map.memory_bytes().max(1) - 1;
        let fits = mip_map.start / BANK == end / BANK;
        if !fits {
            self.report(name, "the texture crosses a boundary of two megabytes");
        }
        fits
    }
}

/// Texels of a 565 mip map from 256 to 1 whose levels differ in colour: red,
/// green, blue, white, black, and again from red.
///
/// Source: G246, `guTexCreateColorMipMap`.
pub fn color_mip_map() -> Vec<u16> {
    const COLORS: [u16; 5] = [0xf800, 0x07e0, 0x001f, 0xffff, 0x0000];
    let level = |lod: usize| {
        let side = 256usize >> lod;
        std::iter::repeat_n(COLORS[lod % COLORS.len()], side * side)
    };
    (0..=layout::SMALLEST as usize).flat_map(level).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::texture_state::lod_bias_quarters;

    fn mip_map(format: i32, small_lod: i32, large_lod: i32) -> MipMap {
        MipMap {
            board: 0,
            width: 256 >> large_lod,
            height: 256 >> large_lod,
            info: TextureInfo { small_lod, large_lod, aspect: 3, format },
            mip_map_mode: 1,
            magnify: 1,
            minify: 1,
            s_clamp: 0,
            t_clamp: 1,
            lod_bias: 0,
            tmu: 0,
            even_odd: LEVELS_BOTH,
            start: 0,
            trilinear: false,
            ncc_table: [0; NCC_TABLE_BYTES],
        }
    }

    #[test]
    fn handles_and_addresses_follow_each_other() {
        let mut maps = MipMaps::new(1);
        assert_eq!(maps.add(mip_map(10, 8, 0), 2 << 20), Some(0));
        assert_eq!(maps.add(mip_map(3, 8, 8), 2 << 20), Some(1));
        assert_eq!(maps.get(1).unwrap().start, layout::chain_bytes(8, 0, 3, 10, 3));
        assert_eq!(maps.get(2), None);
        assert_eq!(maps.get(NULL_MIP_MAP), None);
    }

    #[test]
    fn memory_ends() {
        let mut maps = MipMaps::new(1);
        let one = layout::chain_bytes(0, 0, 3, 10, LEVELS_BOTH);
        for _ in 0..(1 << 20) / one {
            assert!(maps.add(mip_map(10, 0, 0), 1 << 20).is_some());
        }
        assert_eq!(maps.available(0, 1 << 20), 0);
        assert_eq!(maps.add(mip_map(3, 8, 8), 1 << 20), None);
    }

    #[test]
    fn handles_end() {
        let mut maps = MipMaps::new(1);
        for id in 0..MAX_MIP_MAPS as u32 {
            assert_eq!(maps.add(mip_map(3, 8, 8), 4 << 20), Some(id));
        }
        assert_eq!(maps.add(mip_map(3, 8, 8), 4 << 20), None);
        maps.reset();
        assert_eq!(maps.add(mip_map(3, 8, 8), 4 << 20), Some(0));
    }

    #[test]
    fn banks_are_not_crossed() {
        let mut maps = MipMaps::new(1);
        maps.units[0].free = BANK - 8;
        assert_eq!(maps.add(mip_map(10, 0, 0), 4 << 20), Some(0));
        assert_eq!(maps.get(0).unwrap().start, BANK);
        // A refused one leaves the pointer where it was.
        maps.units[0].free = BANK - 8;
        assert_eq!(maps.add(mip_map(10, 0, 0), BANK), None);
        assert_eq!(maps.available(0, BANK), 8);
    }

    #[test]
    fn tables_take_turns() {
        let mut maps = MipMaps::new(1);
        assert_eq!(maps.ncc_slot(0, 7), (0, true));
        assert_eq!(maps.ncc_slot(0, 8), (1, true));
        assert_eq!(maps.ncc_slot(0, 7), (0, false));
        assert_eq!(maps.ncc_slot(0, 9), (0, true));
        assert_eq!(maps.ncc_slot(0, 8), (1, false));
        maps.lose_ncc_table(0, 1);
        assert_eq!(maps.ncc_slot(0, 8), (1, true));
    }

    #[test]
    fn records_show_registers() {
        let map = MipMap { lod_bias: lod_bias_quarters(-0.75), ..mip_map(10, 8, 2) };
        assert_eq!(map.t_lod(), 8 | (32 << 6) | (0x3e << 12));
        let off = MipMap { mip_map_mode: 0, ..mip_map(10, 8, 2) };
        assert_eq!(off.t_lod(), 8 | (8 << 6));
        assert_eq!(map.texture_mode(), 0b1000_1111 | 10 << 8);
        let above = layout::offset(3, 2, 10, LEVELS_BOTH);
        assert_eq!(map.base_address(), 0u32.wrapping_sub(above));
    }

    #[test]
    fn colored_levels() {
        let texels = color_mip_map();
        assert_eq!(texels.len(), (4usize.pow(9) - 1) / 3);
        assert_eq!((texels[0], texels[65536], texels[87380]), (0xf800, 0x07e0, 0xffff));
    }
}
