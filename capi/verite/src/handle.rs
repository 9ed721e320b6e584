//! Handles: what they name and its number, as a pointer.

use std::ffi::c_void;

/// An opaque pointer of the interface.
pub type Opaque = *mut c_void;

/// What a handle names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// `v_handle`.
    Device = 0x56,
    /// `v_cmdbuffer`.
    CmdBuffer = 0x57,
    /// `v_memory`.
    Memory = 0x58,
    /// `v_buffer_group`.
    Group = 0x59,
}

/// Bits of a number.
const BITS: u32 = 24;

/// The handle of a number, which has at most 24 bits.
pub(crate) fn handle(kind: Kind, number: u32) -> Opaque {
    let number = number as usize & ((1 << BITS) - 1);
    std::ptr::without_provenance_mut((kind as usize) << BITS | number)
}

/// The number of a handle; `None` for null and what is no handle of this kind.
pub(crate) fn number(kind: Kind, handle: Opaque) -> Option<u32> {
    let address = handle.addr();
    (address >> BITS == kind as usize).then_some((address & ((1 << BITS) - 1)) as u32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn handles_know_their_kind() {
        let group = handle(Kind::Group, 77);
        assert_eq!(number(Kind::Group, group), Some(77));
        assert_eq!(number(Kind::Memory, group), None);
        assert_eq!(number(Kind::Device, std::ptr::null_mut()), None);
        let mut on_the_stack = 0u32;
        assert_eq!(number(Kind::Device, (&raw mut on_the_stack).cast()), None);
    }
}
