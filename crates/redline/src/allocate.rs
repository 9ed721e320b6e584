//! Video memory: free blocks, kept sorted and joined with their neighbours, so
//! that freeing restores what allocating took.
//!
//! Source: RR, video memory.

/// Alignment of addresses, in bytes.
const ALIGN: u32 = 4;

/// Which end of free memory a block is taken from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum End {
    /// The lowest block that fits: display buffers.
    Low,
    /// The highest one: everything else, so that it stays where it is when
    /// display buffers change.
    High,
}

/// Free blocks as address and size, by rising address; no two touch.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Allocator {
    free: Vec<(u32, u32)>,
}

impl Allocator {
    /// Memory from `start` to `end`, all of it free.
    pub fn new(start: u32, end: u32) -> Allocator {
        Allocator { free: if start < end { vec![(start, end - start)] } else { Vec::new() } }
    }

    /// Bytes that are free.
    pub fn free_bytes(&self) -> u32 {
        self.free.iter().map(|block| block.1).sum()
    }

    /// Takes a block of at least `size` bytes; gives its address.
    pub fn allocate(&mut self, size: u32, end: End) -> Option<u32> {
        let size = rounded(size)?;
        let fits = |block: &(u32, u32)| block.1 >= size;
        let at = match end {
            End::Low => self.free.iter().position(fits)?,
            End::High => self.free.iter().rposition(fits)?,
        };
        let (address, free) = self.free[at];
        let taken = match end {
            End::Low => address,
            End::High => address + free - size,
        };
        self.reserve(taken, size);
        Some(taken)
    }

    /// Takes whatever is free in a range out.
    pub fn reserve(&mut self, address: u32, size: u32) {
        let end = address + size;
        let cut = |(from, size): (u32, u32)| {
            let to = from + size;
            let below = (from, address.clamp(from, to) - from);
            let above = (end.clamp(from, to), to - end.clamp(from, to));
            if end <= from || address >= to { [(from, size), (0, 0)] } else { [below, above] }
        };
        let blocks = std::mem::take(&mut self.free);
        self.free = blocks.into_iter().flat_map(cut).filter(|block| block.1 > 0).collect();
    }

    /// Gives a block back.
    pub fn release(&mut self, address: u32, size: u32) {
        let Some(size) = rounded(size).filter(|&size| size > 0) else { return };
        let at = self.free.partition_point(|block| block.0 < address);
        self.free.insert(at, (address, size));
        self.join(at);
        if at > 0 {
            self.join(at - 1);
        }
    }

    /// Joins a block with the next one where they touch.
    fn join(&mut self, at: usize) {
        let (address, size) = self.free[at];
        if let Some(&(next, more)) = self.free.get(at + 1)
            && address + size >= next
        {
            self.free[at].1 = size.max(next + more - address);
            self.free.remove(at + 1);
        }
    }
}

fn rounded(size: u32) -> Option<u32> {
    size.checked_next_multiple_of(ALIGN)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn freeing_restores_what_was_there() {
        let whole = Allocator::new(1000, 9000);
        let mut memory = whole.clone();
        let sizes = [10, 400, 3, 1024, 77, 5];
        let blocks: Vec<_> = sizes
            .iter()
            .enumerate()
            .map(|(i, &size)| {
                let end = if i % 2 == 0 { End::Low } else { End::High };
                (memory.allocate(size, end).unwrap(), size)
            })
            .collect();
        assert_eq!(memory.free_bytes(), 8000 - 12 - 400 - 4 - 1024 - 80 - 8);
        for at in [3, 0, 5, 1, 4, 2] {
            memory.release(blocks[at].0, blocks[at].1);
        }
        assert_eq!(memory, whole);
    }

    #[test]
    fn what_does_not_fit_changes_nothing() {
        let mut memory = Allocator::new(0, 100);
        assert_eq!(memory.allocate(101, End::Low), None);
        assert_eq!(memory.allocate(u32::MAX, End::High), None);
        assert_eq!(memory.allocate(100, End::High), Some(0));
        assert_eq!(memory.allocate(4, End::Low), None);
        memory.release(0, 100);
        memory.reserve(40, 20);
        assert_eq!(memory.free_bytes(), 80);
        assert_eq!(memory.allocate(40, End::High), Some(60));
    }
}
