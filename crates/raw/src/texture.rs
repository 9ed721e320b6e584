//! The texture memory manager: a table of entries and an allocation list ordered by address.
//!
//! Source: RAW, texture-manager listing.

use crate::color;
use crate::errata::Errata;

/// Texture memory in bytes, by default. The thesis does not record its value.
pub const DEFAULT_MEMORY: u32 = 1 << 20;
/// Entries in the table, by default. The thesis does not record its value.
pub const DEFAULT_ENTRIES: usize = 64;
/// The id that means "no texture".
pub const NO_TEXTURE: u32 = u32::MAX;

/// A texture: its size in texels and the word address of its first texel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Texture {
    /// Width in texels.
    pub width: u32,
    /// Height in texels.
    pub height: u32,
    /// Levels, at least 1; each has half the size of the one before, rounded down, at least 1.
    pub levels: u32,
    begin: usize,
}

impl Texture {
    fn words(&self) -> usize {
        (0..self.levels).map(|level| self.level_words(level)).sum()
    }

    fn level_words(&self, level: u32) -> usize {
        let [width, height] = level_size(self.width, self.height, level);
        width as usize * height as usize
    }

    /// A level as a texture of its own; the coarsest one where there are fewer.
    pub fn level(&self, level: u32) -> Texture {
        let level = level.min(self.levels - 1);
        let [width, height] = level_size(self.width, self.height, level);
        let skipped: usize = (0..level).map(|finer| self.level_words(finer)).sum();
        Texture { width, height, levels: 1, begin: self.begin + skipped }
    }

    /// The word address of a texel; `x` and `y` are inside the texture.
    pub fn address(&self, x: u32, y: u32) -> usize {
        self.begin + x as usize + self.width as usize * y as usize
    }
}

/// Size of a level, the finest being 0.
fn level_size(width: u32, height: u32, level: u32) -> [u32; 2] {
    [width, height].map(|side| side.checked_shr(level).unwrap_or(0).max(1))
}

/// Texture memory and who owns which part of it.
#[derive(Clone, Debug)]
pub struct TextureManager {
    memory: Vec<u32>,
    entries: Vec<Option<Texture>>,
    /// Ids by ascending address.
    order: Vec<usize>,
    budget: u32,
    free: u32,
    /// Counts changes, and the count at the last change of each entry.
    changes: u64,
    versions: Vec<u64>,
    errata: Errata,
}

impl TextureManager {
    /// A manager of `bytes` bytes and `entries` table entries.
    pub fn new(bytes: u32, entries: usize, errata: Errata) -> Self {
        // The faithful accounting calls N words N bytes.
        let words = if errata.texture_bytes_as_words { bytes } else { bytes / 4 } as usize;
        Self {
            memory: vec![0; words],
            entries: vec![None; entries],
            order: Vec::new(),
            budget: bytes,
            free: bytes,
            changes: 0,
            versions: vec![0; entries],
            errata,
        }
    }

    /// Forgets all textures.
    pub fn reset(&mut self) {
        self.entries.fill(None);
        self.order.clear();
        self.changes += 1;
        if !self.errata.uploads_stay_cached {
            (0..self.versions.len()).for_each(|id| self.touch(id));
        }
        self.free = self.budget;
    }

    /// The texture with that id, if there is one.
    pub fn get(&self, id: u32) -> Option<Texture> {
        *self.entries.get(id as usize)?
    }

    /// The word at an address; 0 outside the memory.
    pub fn word(&self, address: usize) -> u32 {
        self.memory.get(address).copied().unwrap_or(0)
    }

    /// Free memory in bytes, over all gaps.
    pub fn available(&self) -> u32 {
        self.free
    }

    /// Allocates `width` x `height` texels in the gap with the highest address that fits.
    ///
    /// Returns the lowest free id, or [`NO_TEXTURE`] when the table or the memory is full or a
    /// size is zero.
    pub fn allocate(&mut self, width: u32, height: u32) -> u32 {
        self.allocate_levels(width, height, 1)
    }

    /// As [`TextureManager::allocate`], with levels down to a single texel. Beyond the thesis.
    pub fn allocate_mipmapped(&mut self, width: u32, height: u32) -> u32 {
        let levels = 32 - width.max(height).max(1).leading_zeros();
        self.allocate_levels(width, height, levels)
    }

    fn allocate_levels(&mut self, width: u32, height: u32, levels: u32) -> u32 {
        let sizes = (0..levels).map(|level| level_size(width, height, level));
        let need = match width.min(height) {
            0 => 0,
            _ => sizes.fold(0u64, |sum, [w, h]| sum.saturating_add(u64::from(w) * u64::from(h))),
        };
        let slot = self.entries.iter().position(Option::is_none);
        let (Some(id), true) = (slot, need > 0 && need.saturating_mul(4) <= u64::from(self.free))
        else {
            return NO_TEXTURE;
        };
        let Some((rank, begin)) = self.find_gap(need as usize) else { return NO_TEXTURE };
        self.entries[id] = Some(Texture { width, height, levels, begin });
        self.order.insert(rank, id);
        self.touch(id);
        self.free -= need as u32 * 4;
        id as u32
    }

    /// The highest gap of at least `need` words: its place in the list and its address.
    fn find_gap(&self, need: usize) -> Option<(usize, usize)> {
        let mut limit = self.memory.len();
        for (rank, &id) in self.order.iter().enumerate().rev() {
            let texture = self.entries[id].expect("listed textures are allocated");
            let end = texture.begin + texture.words();
            if limit - end >= need {
                return Some((rank + 1, end));
            }
            limit = texture.begin;
        }
        (limit >= need).then_some((0, 0))
    }

    /// Frees a texture; ids that name none are ignored.
    pub fn deallocate(&mut self, id: u32) {
        if let Some(texture) = self.get(id) {
            self.entries[id as usize] = None;
            self.touch(id as usize);
            self.order.retain(|&other| other != id as usize);
            self.free += texture.words() as u32 * 4;
        }
    }

    /// Writes one texel of an upload, `index` words from the start; surplus words and bad ids are
    /// dropped.
    pub fn upload_word(&mut self, id: u32, index: usize, texel: u32) {
        if let Some(texture) = self.get(id).filter(|t| index < t.words()) {
            self.memory[texture.begin + index] = texel;
            self.changes += 1;
            if !self.errata.uploads_stay_cached {
                self.touch(id as usize);
            }
        }
    }

    /// Notes a change of an entry.
    fn touch(&mut self, id: usize) {
        self.changes += 1;
        self.versions[id] = self.changes;
    }

    /// When an entry last changed, and which words of the memory are its texture's.
    pub fn version(&self, id: u32) -> (u64, std::ops::Range<usize>) {
        let version = self.versions.get(id as usize).copied().unwrap_or(0);
        let words = self.get(id).map_or(0..0, |t| t.begin..t.begin + t.words());
        (version, words)
    }

    /// Counts what may have changed texels or where they are.
    pub fn changes(&self) -> u64 {
        self.changes
    }

    /// Width and height of each level of a texture, and its texels level after level.
    pub fn texels(&self, id: u32) -> Option<(Vec<[u32; 2]>, &[u32])> {
        let texture = self.get(id)?;
        let sizes = (0..texture.levels)
            .map(|level| level_size(texture.width, texture.height, level))
            .collect();
        Some((sizes, &self.memory[texture.begin..texture.begin + texture.words()]))
    }

    /// Takes the table of another manager, but none of its texels.
    pub fn adopt_table(&mut self, other: &Self) {
        self.changes += 1;
        self.entries.clone_from(&other.entries);
    }

    /// Takes the cache line around a word from another manager.
    pub fn copy_line(&mut self, other: &Self, word: usize) {
        self.changes += 1;
        let from = word & !7;
        let to = (from + 8).min(self.memory.len()).min(other.memory.len());
        self.memory[from..to].copy_from_slice(&other.memory[from..to]);
    }

    /// Makes the levels of a texture from its finest one: each texel is the average of up to four
    /// of the level before, rounded to nearest. Bad ids are ignored. Beyond the thesis.
    pub fn make_levels(&mut self, id: u32) {
        let Some(texture) = self.get(id) else { return };
        self.touch(id as usize);
        for level in 1..texture.levels {
            let (from, to) = (texture.level(level - 1), texture.level(level));
            for (x, y) in (0..to.height).flat_map(|y| (0..to.width).map(move |x| (x, y))) {
                let texel = self.average(&from, x, y);
                self.memory[to.address(x, y)] = texel;
            }
        }
    }

    fn average(&self, from: &Texture, x: u32, y: u32) -> u32 {
        let column = |i: u32| (2 * x + i).min(from.width - 1);
        let row = |i: u32| (2 * y + i).min(from.height - 1);
        let four = [(0, 0), (1, 0), (0, 1), (1, 1)];
        let texels = four.map(|(i, j)| color::unpack(self.memory[from.address(column(i), row(j))]));
        let channel = |c: usize| (texels.iter().map(|t| t[c]).sum::<u32>() + 2) / 4;
        color::pack(channel(0), channel(1), channel(2), channel(3))
    }

    /// Slides all textures down so that the free memory is one gap.
    pub fn compact(&mut self) {
        if self.errata.blocks_do_nothing {
            return;
        }
        let mut next = 0;
        for &id in &self.order {
            self.changes += 1;
            self.versions[id] = self.changes;
            let texture = self.entries[id].as_mut().expect("listed textures are allocated");
            let from = texture.begin;
            texture.begin = next;
            let words = texture.words();
            self.memory.copy_within(from..from + words, next);
            next += words;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn manager(words: u32) -> TextureManager {
        TextureManager::new(words * 4, 4, Errata::CORRECT)
    }

    #[test]
    fn highest_gap_wins_and_blocks_sit_at_its_low_end() {
        let mut m = manager(100);
        let [a, b, c] = [10, 20, 30].map(|w| m.allocate(w, 1));
        assert_eq!([a, b, c], [0, 1, 2]);
        m.deallocate(a);
        assert_eq!(m.allocate(5, 1), 0);
        assert_eq!(m.get(0).map(|t| t.address(0, 0)), Some(60));
        assert_eq!(m.available(), (100 - 55) * 4);
    }

    #[test]
    fn compaction_joins_the_gaps_and_keeps_texels() {
        let mut m = manager(100);
        let ids = [40, 40, 20].map(|w| m.allocate(w, 1));
        m.upload_word(ids[2], 3, 0xabcd);
        m.deallocate(ids[0]);
        m.deallocate(ids[1]);
        assert_eq!(m.allocate(81, 1), NO_TEXTURE);
        m.compact();
        let moved = m.get(ids[2]).expect("kept");
        assert_eq!(m.word(moved.address(3, 0)), 0xabcd);
        assert_eq!(m.allocate(80, 1), 0);
    }

    #[test]
    fn levels_are_averages_down_to_one_texel() {
        let mut m = manager(64);
        let id = m.allocate_mipmapped(4, 2);
        let texture = m.get(id).expect("allocated");
        assert_eq!((texture.levels, m.available()), (3, (64 - 8 - 2 - 1) * 4));
        for i in 0..8 {
            m.upload_word(id, i, i as u32 * 4);
        }
        m.make_levels(id);
        m.make_levels(99);
        let (half, one) = (texture.level(1), texture.level(7));
        assert_eq!((half.width, half.height, one.width), (2, 1, 1));
        assert_eq!(m.word(half.address(0, 0)), (4 + 16 + 20 + 2) / 4);
        assert_eq!(m.word(one.address(0, 0)), 14);
        assert_eq!(m.allocate_mipmapped(u32::MAX, u32::MAX), NO_TEXTURE);
        assert_eq!(m.allocate_mipmapped(0, 7), NO_TEXTURE);
    }

    #[test]
    fn bad_sizes_and_ids_are_refused() {
        let mut m = manager(16);
        assert_eq!(m.allocate(0, 4), NO_TEXTURE);
        assert_eq!(m.allocate(u32::MAX, u32::MAX), NO_TEXTURE);
        m.deallocate(77);
        m.upload_word(NO_TEXTURE, 0, 1);
        for _ in 0..4 {
            assert_ne!(m.allocate(1, 1), NO_TEXTURE);
        }
        assert_eq!(m.allocate(1, 1), NO_TEXTURE);
    }

    #[test]
    fn faithful_accounting_wastes_three_quarters() {
        let mut m = TextureManager::new(64, 4, Errata::FAITHFUL);
        assert_eq!(m.memory.len(), 64);
        assert_eq!(m.allocate(17, 1), NO_TEXTURE);
        assert_eq!(m.allocate(16, 1), 0);
    }
}
