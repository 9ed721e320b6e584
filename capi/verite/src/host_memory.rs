//! Memory objects: host memory that the board may read.

use std::alloc::{Layout, alloc_zeroed, dealloc};

use fillrate_redline::{DmaBlock, HostMemory, VError};

use crate::handle::{Kind, Opaque, number};
use crate::slots::Slots;

/// The most bytes of one object.
const MAX_BYTES: u32 = 1 << 28;
/// Pages start at multiples of this.
const PAGE: usize = 4096;

/// Whole pages of zeros.
#[derive(Debug)]
struct Pages {
    address: *mut u8,
    layout: Layout,
}

// SAFETY: the pages belong to this value alone.
unsafe impl Send for Pages {}

impl Pages {
    fn new(bytes: u32) -> Option<Pages> {
        if bytes == 0 || bytes > MAX_BYTES {
            return None;
        }
        let layout = Layout::from_size_align((bytes as usize).next_multiple_of(PAGE), PAGE).ok()?;
        // SAFETY: the size is not 0.
        let address = unsafe { alloc_zeroed(layout) };
        (!address.is_null()).then_some(Pages { address, layout })
    }
}

impl Drop for Pages {
    fn drop(&mut self) {
        // SAFETY: it was allocated with this layout.
        unsafe { dealloc(self.address, self.layout) }
    }
}

/// One memory object.
#[derive(Debug)]
pub(crate) struct Memory {
    /// The device it was made with.
    pub device: u32,
    /// Where its bytes are.
    pub address: usize,
    /// How many.
    pub bytes: u32,
    /// Whether its pages are locked.
    pub locked: bool,
    pages: Option<Pages>,
}

impl Memory {
    /// Memory of our own, locked, all zeros; `None` where there is none.
    pub fn locked(device: u32, bytes: u32) -> Option<Memory> {
        let pages = Pages::new(bytes)?;
        let address = pages.address.addr();
        Some(Memory { device, address, bytes, locked: true, pages: Some(pages) })
    }

    /// The program's memory.
    pub fn of(device: u32, address: usize, bytes: u32) -> Memory {
        Memory { device, address, bytes, locked: false, pages: None }
    }

    /// Whether the library allocated it.
    pub fn is_ours(&self) -> bool {
        self.pages.is_some()
    }

    /// Points it elsewhere.
    pub fn point(&mut self, address: usize, bytes: u32) {
        (self.address, self.bytes) = (address, bytes);
    }

    /// Where an address lies in it; the start for null.
    pub fn offset(&self, address: *const u32) -> Option<u64> {
        let offset = match address.addr() {
            0 => 0,
            address => address.checked_sub(self.address)?,
        };
        (offset % 4 == 0 && offset <= self.bytes as usize).then_some(offset as u64)
    }

    /// Whether a block lies in it.
    pub fn holds(&self, block: &DmaBlock) -> bool {
        let end = block.offset.checked_add(u64::from(block.words) * 4);
        end.is_some_and(|end| end <= u64::from(self.bytes))
    }
}

/// All memory objects.
pub(crate) type Memories = Slots<Memory>;

/// The number of a `v_memory` that exists.
pub(crate) fn known(memories: &Memories, memory: Opaque) -> Option<u32> {
    number(Kind::Memory, memory).filter(|number| memories.get(*number).is_some())
}

/// A block of the object from an address on, without length yet.
pub(crate) fn block(memories: &Memories, memory: Opaque, address: *const u32) -> Option<DmaBlock> {
    let number = known(memories, memory)?;
    let offset = memories.get(number)?.offset(address)?;
    Some(DmaBlock { memory: number.into(), offset, ..DmaBlock::default() })
}

impl HostMemory for Memories {
    fn read(&self, block: &DmaBlock, out: &mut Vec<u8>) -> Result<(), VError> {
        let number = u32::try_from(block.memory).map_err(|_| VError::ParamError)?;
        let memory = self.get(number).filter(|memory| memory.holds(block));
        let memory = memory.ok_or(VError::ParamError)?;
        let from = (memory.address + block.offset as usize) as *const u8;
        // SAFETY: the block lies in the object, whose memory is readable by the
        // promise of whoever made it, and nobody writes it during the call.
        let bytes = unsafe { std::slice::from_raw_parts(from, block.words as usize * 4) };
        out.extend_from_slice(bytes);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_stay_inside() {
        let mut memories = Memories::default();
        let memory = Memory::locked(1, 100).unwrap();
        assert_eq!(memory.address % PAGE, 0);
        assert_eq!(memory.offset(std::ptr::null()), Some(0));
        assert_eq!(memory.offset((memory.address + 8) as *const u32), Some(8));
        assert_eq!(memory.offset((memory.address - 4) as *const u32), None);
        assert_eq!(memory.offset((memory.address + 104) as *const u32), None);
        assert!(memory.is_ours());
        let number = memories.insert(memory).unwrap();
        let mut out = Vec::new();
        let mut block =
            DmaBlock { memory: number.into(), offset: 96, words: 1, ..DmaBlock::default() };
        assert_eq!(memories.read(&block, &mut out), Ok(()));
        assert_eq!(out, [0; 4]);
        block.words = 2;
        assert_eq!(memories.read(&block, &mut out), Err(VError::ParamError));
        assert!(Memory::locked(1, 0).is_none());
    }
}
