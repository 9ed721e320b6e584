use crate::Error;

/// For each leaf of a world the leaves that may be seen from it, as a matrix of
/// bits.
///
/// Source: TN, visibility determination, on Quake's loose sets of visible
/// polygons.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct VisibleSets {
    leaves: usize,
    bits: Vec<u64>,
}

/// The leaves that may be seen from one leaf.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LeafSet<'a> {
    words: &'a [u64],
}

impl VisibleSets {
    /// The most leaves: 32 MiB of bits.
    pub const MAX_LEAVES: usize = 1 << 14;

    /// Sets in which no leaf sees any other, nor itself.
    ///
    /// # Errors
    /// [`Error::Limit`] for more than [`Self::MAX_LEAVES`].
    pub fn new(leaves: usize) -> Result<Self, Error> {
        if leaves > Self::MAX_LEAVES {
            return Err(Error::Limit { what: "leaves" });
        }
        Ok(Self { leaves, bits: vec![0; leaves * leaves.div_ceil(64)] })
    }

    /// Lets `from` see `to`. Leaves that do not exist change nothing.
    pub fn add(&mut self, from: u32, to: u32) {
        let (from, to) = (from as usize, to as usize);
        if from < self.leaves && to < self.leaves {
            self.bits[from * self.leaves.div_ceil(64) + to / 64] |= 1 << (to % 64);
        }
    }

    /// Lets `from` see what a row of Quake's visibility data holds: each byte has
    /// the bits of eight leaves, the lowest first; a byte 0 is followed by the
    /// number of bytes 0 it stands for. `first` is the leaf of the first bit. What
    /// lies past the last leaf is not looked at.
    pub fn add_runs(&mut self, from: u32, first: u32, row: &[u8]) {
        let mut leaf = first as usize;
        let mut bytes = row.iter();
        while let (true, Some(&byte)) = (leaf < self.leaves, bytes.next()) {
            if byte == 0 {
                let Some(&count) = bytes.next() else { return };
                leaf += usize::from(count) * 8;
                continue;
            }
            for bit in (0..8).filter(|bit| byte >> bit & 1 == 1) {
                self.add(from, (leaf + bit) as u32);
            }
            leaf += 8;
        }
    }

    /// What is seen from a leaf; nothing from one that does not exist.
    pub fn from_leaf(&self, leaf: u32) -> LeafSet<'_> {
        let width = self.leaves.div_ceil(64);
        let start = leaf as usize * width;
        LeafSet { words: self.bits.get(start..start + width).unwrap_or_default() }
    }
}

impl LeafSet<'_> {
    /// Whether a leaf is in the set.
    pub fn contains(&self, leaf: u32) -> bool {
        self.words.get(leaf as usize / 64).is_some_and(|word| word >> (leaf % 64) & 1 == 1)
    }
}
