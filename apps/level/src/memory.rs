//! Texture memory of one unit: which textures lie where, and which one makes
//! room. The least recently used go first.

/// A texture, by the caller's number.
pub type Key = usize;

/// Chains of levels must not cross a boundary of two megabytes.
const BANK: u32 = 2 << 20;

#[derive(Clone, Copy, Debug)]
struct Block {
    start: u32,
    bytes: u32,
    key: Key,
    used: u64,
}

/// What [`TextureMemory::place`] did.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Placed {
    /// The texture is there, at this address.
    Resident(u32),
    /// It has to be downloaded, to this address.
    Download(u32),
}

/// The allocator of a unit's memory. Addresses are multiples of eight.
#[derive(Debug)]
pub struct TextureMemory {
    size: u32,
    /// By rising address.
    blocks: Vec<Block>,
    clock: u64,
    /// Downloads asked for so far.
    pub downloads: u64,
}

impl TextureMemory {
    /// An empty memory of `size` bytes.
    pub fn new(size: u32) -> TextureMemory {
        TextureMemory { size, blocks: Vec::new(), clock: 0, downloads: 0 }
    }

    /// Whether a texture is there. Does not count as use.
    pub fn is_resident(&self, key: Key) -> bool {
        self.blocks.iter().any(|block| block.key == key)
    }

    /// Finds a texture, or a place for it. `None` where it can never fit.
    pub fn place(&mut self, key: Key, bytes: u32) -> Option<Placed> {
        self.clock += 1;
        let bytes = bytes.max(1).next_multiple_of(8);
        if let Some(block) = self.blocks.iter_mut().find(|block| block.key == key) {
            block.used = self.clock;
            return Some(Placed::Resident(block.start));
        }
        if bytes > self.size.min(BANK) {
            return None;
        }
        loop {
            if let Some((at, start)) = self.gap(bytes) {
                self.blocks.insert(at, Block { start, bytes, key, used: self.clock });
                self.downloads += 1;
                return Some(Placed::Download(start));
            }
            let oldest = (0..self.blocks.len()).min_by_key(|&i| self.blocks[i].used)?;
            self.blocks.remove(oldest);
        }
    }

    /// The first gap that holds so many bytes within one bank: its place in
    /// the list and its address.
    fn gap(&self, bytes: u32) -> Option<(usize, u32)> {
        let mut start = 0;
        for i in 0..=self.blocks.len() {
            let end = self.blocks.get(i).map_or(self.size, |block| block.start);
            let crosses = start / BANK != (start + bytes - 1) / BANK;
            let from = if crosses { start.next_multiple_of(BANK) } else { start };
            if from + bytes <= end {
                return Some((i, from));
            }
            start = self.blocks.get(i).map_or(self.size, |block| block.start + block.bytes);
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_never_overlap_or_cross_banks() {
        let mut memory = TextureMemory::new(4 << 20);
        let mut random = 12345u32;
        for _ in 0..20_000 {
            random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let key = (random >> 8) as usize % 200;
            let bytes = (key as u32 * 977 % 175_000) + 8;
            assert!(memory.place(key, bytes).is_some());
            for pair in memory.blocks.windows(2) {
                assert!(pair[0].start + pair[0].bytes <= pair[1].start);
            }
        }
        for block in &memory.blocks {
            let last = block.start + block.bytes - 1;
            assert!(last < memory.size && block.start / BANK == last / BANK);
            assert!(block.start.is_multiple_of(8));
        }
    }

    #[test]
    fn the_least_recently_used_makes_room() {
        let mut memory = TextureMemory::new(1024);
        for key in 0..4 {
            assert_eq!(memory.place(key, 256), Some(Placed::Download(key as u32 * 256)));
        }
        assert_eq!(memory.place(0, 256), Some(Placed::Resident(0)));
        assert_eq!(memory.place(4, 256), Some(Placed::Download(256)));
        assert!(!memory.is_resident(1) && memory.is_resident(0));
        assert_eq!(memory.place(5, 2048), None);
        assert_eq!(memory.downloads, 5);
    }
}
