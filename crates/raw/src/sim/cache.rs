//! The data cache of a tile: 32 KB, two ways, lines of eight words; only its tags.

const SETS: usize = 512;
/// Words in a cache line.
pub const LINE_WORDS: u64 = 8;

/// Which lines a tile holds.
#[derive(Clone, Debug)]
pub struct Cache {
    /// Two line numbers per set, most recently used first; `u64::MAX` is empty.
    sets: Vec<[u64; 2]>,
}

impl Default for Cache {
    fn default() -> Self {
        Self { sets: vec![[u64::MAX; 2]; SETS] }
    }
}

impl Cache {
    /// Touches a word address. Returns whether it was a miss.
    pub fn touch(&mut self, word: u64) -> bool {
        let line = word / LINE_WORDS;
        let ways = &mut self.sets[line as usize % SETS];
        match ways.iter().position(|w| *w == line) {
            Some(0) => false,
            hit => {
                *ways = [line, ways[0]];
                hit.is_none()
            }
        }
    }

    /// Drops the lines of a range of word addresses.
    pub fn drop_words(&mut self, words: std::ops::Range<usize>) {
        let lines = words.start as u64 / LINE_WORDS..(words.end as u64).div_ceil(LINE_WORDS);
        for ways in &mut self.sets {
            for way in ways.iter_mut().filter(|way| lines.contains(way)) {
                *way = u64::MAX;
            }
            if ways[0] == u64::MAX {
                ways.swap(0, 1);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_ways_hold_two_lines_of_a_set() {
        let mut cache = Cache::default();
        let stride = SETS as u64 * LINE_WORDS;
        assert!(cache.touch(0) && !cache.touch(7) && cache.touch(stride));
        assert!(!cache.touch(1));
        cache.drop_words(1..2);
        assert!(cache.touch(0) && !cache.touch(stride));
        assert!(cache.touch(2 * stride) && !cache.touch(stride) && cache.touch(0));
    }
}
