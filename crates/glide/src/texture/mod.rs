//! Texture memory: layout, formats, and the decoded textures made from it.

mod formats;
pub mod layout;
mod unit;

pub use formats::{NccTable, decode};
pub use unit::TextureMemory;
