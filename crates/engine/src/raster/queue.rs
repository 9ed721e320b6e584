//! Stamps waiting to be drawn.

use crate::kernel::block::{Block, SLOTS, STRIP, Slot};

/// Stamps that one triangle may add at a time.
pub(super) const GATHERED: usize = 2 * STRIP;
/// Those, and an incomplete block.
const CAPACITY: usize = GATHERED + SLOTS;

/// Stamps in submission order. Blocks are cut from the front; what is left when
/// a triangle is done is less than a block.
pub(super) struct Queue {
    slots: [Slot; CAPACITY],
    live: [u16; CAPACITY],
    count: usize,
}

impl Queue {
    pub fn new() -> Queue {
        Queue { slots: [Slot::default(); CAPACITY], live: [0; CAPACITY], count: 0 }
    }

    pub fn len(&self) -> usize {
        self.count
    }

    /// Forgets the stamps from `count` on.
    pub fn truncate(&mut self, count: usize) {
        self.count = self.count.min(count);
    }

    /// Adds a stamp, if any of its fragments is left.
    #[inline(always)]
    pub fn push(&mut self, slot: Slot, live: u16) {
        // Without a branch: half of a small triangle's stamps are empty.
        let at = self.count.min(CAPACITY - 1);
        self.slots[at] = slot;
        self.live[at] = live;
        self.count = at + usize::from(live != 0);
    }

    /// Whether a stamp from `first` on also waits before it.
    #[inline(always)]
    pub fn repeats(&self, first: usize) -> bool {
        let (old, new) = self.slots[..self.count].split_at(first.min(self.count));
        let mut repeats = false;
        for new in new {
            for old in old {
                repeats |= new.at == old.at;
            }
        }
        repeats
    }

    /// Fills a block with at most four stamps from `first` on.
    #[inline(always)]
    pub fn fill(&self, first: usize, count: usize, block: &mut Block) {
        let first = first.min(CAPACITY - SLOTS);
        let live = self.live[first..first + SLOTS].iter().rev();
        let live = live.fold(0, |bits, &live| bits << 16 | u64::from(live));
        block.slots.copy_from_slice(&self.slots[first..first + SLOTS]);
        block.live = live & u64::MAX >> (64 - 16 * count.clamp(1, SLOTS));
        block.count = count;
    }

    /// Forgets all stamps before `first`, of which there are less than a block
    /// after it.
    #[inline(always)]
    pub fn keep_from(&mut self, first: usize) {
        let left = (self.count - first).min(SLOTS);
        if first > 0 && left > 0 {
            let first = first.min(CAPACITY - SLOTS);
            self.slots.copy_within(first..first + SLOTS, 0);
            self.live.copy_within(first..first + SLOTS, 0);
        }
        self.count = left;
    }
}
