//! Memory that programs hold pointers to.

use std::alloc::{Layout, alloc_zeroed, dealloc};
use std::collections::HashMap;

/// Blocks by address. Only these are ever freed, whatever a program's members
/// point to.
#[derive(Debug, Default)]
pub struct Memory {
    blocks: HashMap<usize, Layout>,
}

/// Alignment of every block, enough for all that lies in them.
const ALIGNMENT: usize = 8;

impl Memory {
    /// Zeroed memory for at least `bytes` bytes; `None` where there is none.
    pub fn allocate(&mut self, bytes: usize) -> Option<*mut u8> {
        let layout = Layout::from_size_align(bytes.max(1), ALIGNMENT).ok()?;
        // SAFETY: the size is not 0.
        let block = unsafe { alloc_zeroed(layout) };
        if block.is_null() {
            return None;
        }
        self.blocks.insert(block as usize, layout);
        Some(block)
    }

    /// A block that holds `values`.
    pub fn store<T: Copy>(&mut self, values: &[T]) -> Option<*mut T> {
        const { assert!(align_of::<T>() <= ALIGNMENT) };
        let block = self.allocate(size_of_val(values))?.cast::<T>();
        // SAFETY: the block is new, aligned, and large enough.
        unsafe { block.copy_from_nonoverlapping(values.as_ptr(), values.len()) };
        Some(block)
    }

    /// The size of a block of ours.
    pub fn size_of<T>(&self, block: *const T) -> Option<usize> {
        self.blocks.get(&(block as usize)).map(Layout::size)
    }

    /// Frees a block, if it is one of ours.
    pub fn free<T>(&mut self, block: *const T) {
        if let Some(layout) = self.blocks.remove(&(block as usize)) {
            // SAFETY: it was allocated with this layout and not freed since.
            unsafe { dealloc(block.cast::<u8>().cast_mut(), layout) };
        }
    }
}
