//! Surfaces: pixels in tiles, owned by one worker at a time.

mod format;
mod rows;
mod surface;

pub use format::{PixelFormat, pack, unpack};
pub use surface::{MAX_SIDE, STAMP, Surface, TileSize};
pub(crate) use surface::{Plane, STAMP_PIXELS, TileCell, stamp_index};
