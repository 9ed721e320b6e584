//! Texture memory: layout, formats, and the decoded textures made from it.

mod formats;
pub mod layout;
mod unit;

pub use formats::{NccTable, decode};
pub use unit::TextureMemory;

/// Little-endian words of bytes; what is left over is dropped.
pub(crate) fn words_of(bytes: &[u8]) -> Vec<u32> {
    bytes.as_chunks().0.iter().map(|&word| u32::from_le_bytes(word)).collect()
}
