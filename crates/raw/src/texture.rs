//! The texture memory manager: a table of entries and an allocation list ordered by address.
//!
//! Source: RAW, texture-manager listing.

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
    begin: usize,
}

impl Texture {
    fn words(&self) -> usize {
        self.width as usize * self.height as usize
    }

    /// The word address of a texel; `x` and `y` are inside the texture.
    pub fn address(&self, x: u32, y: u32) -> usize {
        self.begin + x as usize + self.width as usize * y as usize
    }
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
            errata,
        }
    }

    /// Forgets all textures.
    pub fn reset(&mut self) {
        self.entries.fill(None);
        self.order.clear();
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
        let need = u64::from(width) * u64::from(height);
        let slot = self.entries.iter().position(Option::is_none);
        let (Some(id), true) = (slot, need > 0 && need.saturating_mul(4) <= u64::from(self.free))
        else {
            return NO_TEXTURE;
        };
        let Some((rank, begin)) = self.find_gap(need as usize) else { return NO_TEXTURE };
        self.entries[id] = Some(Texture { width, height, begin });
        self.order.insert(rank, id);
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
            self.order.retain(|&other| other != id as usize);
            self.free += texture.words() as u32 * 4;
        }
    }

    /// Writes one texel of an upload, `index` words from the start; surplus words and bad ids are
    /// dropped.
    pub fn upload_word(&mut self, id: u32, index: usize, texel: u32) {
        if let Some(texture) = self.get(id).filter(|t| index < t.words()) {
            self.memory[texture.begin + index] = texel;
        }
    }

    /// Slides all textures down so that the free memory is one gap.
    pub fn compact(&mut self) {
        if self.errata.blocks_do_nothing {
            return;
        }
        let mut next = 0;
        for &id in &self.order {
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
