//! Board memory as addresses: which bytes are taken, by what, and which are free.

use std::collections::BTreeMap;
use std::sync::Arc;

/// The bytes of a board. What lies in them is found by address only, so that
/// whoever reads a freed address finds nothing, or what came there since.
#[derive(Debug)]
pub(super) struct Heap<T> {
    capacity: u64,
    /// Length of each free space by its start. Spaces never touch.
    free: BTreeMap<u64, u64>,
    /// What lies at an address, and its length.
    blocks: BTreeMap<u64, (u64, Arc<T>)>,
}

impl<T> Heap<T> {
    pub(super) fn new(capacity: u64) -> Heap<T> {
        let free = (capacity > 0).then_some((0, capacity)).into_iter().collect();
        Heap { capacity, free, blocks: BTreeMap::new() }
    }

    pub(super) fn capacity(&self) -> u64 {
        self.capacity
    }

    /// Bytes of all free spaces together.
    pub(super) fn free_bytes(&self) -> u64 {
        self.free.values().sum()
    }

    /// Whether one free space is large enough.
    pub(super) fn has_room(&self, bytes: u64) -> bool {
        self.free.values().any(|&length| length >= bytes)
    }

    /// Puts something into the smallest free space that is large enough, the
    /// first of equal ones. `None` where there is none.
    pub(super) fn place(&mut self, bytes: u64, content: Arc<T>) -> Option<u64> {
        let spaces = self.free.iter().filter(|&(_, &length)| length >= bytes);
        let (&start, &length) = spaces.min_by_key(|&(&start, &length)| (length, start))?;
        self.free.remove(&start);
        if length > bytes {
            self.free.insert(start + bytes, length - bytes);
        }
        self.blocks.insert(start, (bytes, content));
        Some(start)
    }

    /// What lies at an address.
    pub(super) fn read(&self, address: u64) -> Option<&Arc<T>> {
        self.blocks.get(&address).map(|(_, content)| content)
    }

    /// Puts something else of the same size where something lies.
    pub(super) fn overwrite(&mut self, address: u64, content: Arc<T>) {
        if let Some(block) = self.blocks.get_mut(&address) {
            block.1 = content;
        }
    }

    /// Frees what lies at an address; the space joins its free neighbours.
    pub(super) fn release(&mut self, address: u64) {
        let Some((bytes, _)) = self.blocks.remove(&address) else { return };
        let (mut start, mut length) = (address, bytes);
        if let Some((&before, &room)) = self.free.range(..start).next_back()
            && before + room == start
        {
            self.free.remove(&before);
            (start, length) = (before, room + length);
        }
        if let Some(room) = self.free.remove(&(start + length)) {
            length += room;
        }
        self.free.insert(start, length);
    }

    /// Spaces and blocks are the whole memory, each byte once.
    #[cfg(test)]
    pub(super) fn check(&self) {
        let mut parts: Vec<(u64, u64, bool)> =
            self.free.iter().map(|(&a, &n)| (a, n, true)).collect();
        parts.extend(self.blocks.iter().map(|(&a, (n, _))| (a, *n, false)));
        parts.sort_unstable();
        let (mut at, mut after_free) = (0, false);
        for (start, length, is_free) in parts {
            assert_eq!(start, at, "parts follow each other");
            assert!(length > 0 && !(after_free && is_free), "free spaces are joined");
            (at, after_free) = (start + length, is_free);
        }
        assert_eq!(at, self.capacity);
    }

    /// Blocks as start and length.
    #[cfg(test)]
    pub(super) fn blocks(&self) -> impl Iterator<Item = (u64, u64)> + '_ {
        self.blocks.iter().map(|(&start, &(length, _))| (start, length))
    }
}
