//! Memory objects: host memory that DMA entries refer to.
//!
//! For programs in Rust; those in C have memory of their own, at addresses.
//!
//! Source: RR, memory objects.

use std::collections::BTreeMap;

use crate::command::{DmaBlock, HostMemory, Port};
use crate::error::VError;

/// The most bytes of one object.
pub const MAX_OBJECT_BYTES: usize = 1 << 28;

/// `V_PAGES_LOCKED`.
pub const PAGES_LOCKED: u32 = 0x101;
/// `V_PAGES_UNLOCKED`.
pub const PAGES_UNLOCKED: u32 = 0x102;

/// Memory objects by number, from 1 on; numbers of freed ones are not used
/// again.
///
/// A command buffer that refers to an object must be issued before the object
/// is freed, and while its pages are locked; what it holds then is what counts.
#[derive(Clone, Debug, Default)]
pub struct MemoryObjects {
    objects: BTreeMap<u64, Object>,
    made: u64,
}

#[derive(Clone, Debug)]
struct Object {
    bytes: Vec<u8>,
    locked: bool,
}

impl MemoryObjects {
    /// Memory of so many zeros, unlocked (`V_AllocMemoryObject`).
    ///
    /// # Errors
    /// [`VError::AllocFailed`] for more than [`MAX_OBJECT_BYTES`].
    pub fn alloc(&mut self, bytes: usize) -> Result<u64, VError> {
        if bytes > MAX_OBJECT_BYTES {
            return Err(VError::AllocFailed);
        }
        self.made += 1;
        let bytes = vec![0; bytes.next_multiple_of(4)];
        self.objects.insert(self.made, Object { bytes, locked: false });
        Ok(self.made)
    }

    /// Memory with its pages locked (`V_AllocLockedMem`).
    ///
    /// # Errors
    /// Those of [`alloc`](Self::alloc).
    pub fn alloc_locked(&mut self, bytes: usize) -> Result<u64, VError> {
        let object = self.alloc(bytes)?;
        self.set_locked(object, true)?;
        Ok(object)
    }

    /// Locks or unlocks pages (`V_LockPages`, `V_UnlockPages`).
    ///
    /// # Errors
    /// [`VError::ParamError`] where there is no such object.
    pub fn set_locked(&mut self, object: u64, locked: bool) -> Result<(), VError> {
        self.objects.get_mut(&object).ok_or(VError::ParamError)?.locked = locked;
        Ok(())
    }

    /// [`PAGES_LOCKED`] or [`PAGES_UNLOCKED`] (`V_GetMemoryObjectStatus`).
    pub fn status(&self, object: u64) -> Option<u32> {
        let object = self.objects.get(&object)?;
        Some(if object.locked { PAGES_LOCKED } else { PAGES_UNLOCKED })
    }

    /// Its bytes (`V_GetMemoryObjectAddress`, `V_GetMemoryObjectSize`): the size
    /// asked for, up to the next word.
    pub fn bytes(&mut self, object: u64) -> Option<&mut [u8]> {
        self.objects.get_mut(&object).map(|object| &mut object.bytes[..])
    }

    /// Frees it (`V_FreeMemoryObject`, `V_FreeLockedMem`).
    ///
    /// # Errors
    /// [`VError::ParamError`] where there is no such object (any more).
    pub fn free(&mut self, object: u64) -> Result<(), VError> {
        self.objects.remove(&object).map(drop).ok_or(VError::ParamError)
    }

    /// A reference to all of an object.
    pub fn block(&self, object: u64, port: Port) -> Option<DmaBlock> {
        let words = self.objects.get(&object)?.bytes.len() / 4;
        Some(DmaBlock { port, memory: object, offset: 0, words: u32::try_from(words).ok()? })
    }
}

impl HostMemory for MemoryObjects {
    /// # Errors
    /// Also [`VError::PageCheck`] where the object's pages are not locked.
    fn read(&self, block: &DmaBlock, out: &mut Vec<u8>) -> Result<(), VError> {
        let object = self.objects.get(&block.memory).ok_or(VError::ParamError)?;
        if !object.locked {
            return Err(VError::PageCheck);
        }
        let from = usize::try_from(block.offset).map_err(|_| VError::ParamError)?;
        let end = from.checked_add(block.words as usize * 4).ok_or(VError::ParamError)?;
        out.extend_from_slice(object.bytes.get(from..end).ok_or(VError::ParamError)?);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn freed_and_unlocked_memory_cannot_be_read() {
        let mut memory = MemoryObjects::default();
        let object = memory.alloc_locked(6).unwrap();
        assert_eq!(memory.status(object), Some(PAGES_LOCKED));
        memory.bytes(object).unwrap()[0] = 9;
        let block = memory.block(object, Port::Word).unwrap();
        assert_eq!((block.words, block.entries()), (2, 1));
        let read = |memory: &MemoryObjects, block: DmaBlock| {
            let mut out = Vec::new();
            memory.read(&block, &mut out).map(|()| out)
        };
        assert_eq!(read(&memory, block), Ok(vec![9, 0, 0, 0, 0, 0, 0, 0]));
        assert_eq!(read(&memory, DmaBlock { words: 3, ..block }), Err(VError::ParamError));
        let far = DmaBlock { offset: u64::MAX - 3, ..block };
        assert_eq!(read(&memory, far), Err(VError::ParamError));
        memory.set_locked(object, false).unwrap();
        assert_eq!(read(&memory, block), Err(VError::PageCheck));
        assert_eq!(memory.free(object), Ok(()));
        assert_eq!(memory.free(object), Err(VError::ParamError));
        assert_eq!(read(&memory, block), Err(VError::ParamError));
        assert_eq!(memory.alloc(MAX_OBJECT_BYTES + 1), Err(VError::AllocFailed));
    }
}
