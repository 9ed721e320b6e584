//! Triangle set-up: from vertices to the registers of a rasterizer chip.

mod palette;
mod planes;
mod registers;
mod sst1;
mod vertex;

pub use palette::{PALETTE_COORDINATE, PalettePrimitive, PaletteVertex};
pub(crate) use palette::{Shape, Texels, prepare_palette};
pub(crate) use planes::{Edge, Plane32, Plane64, Screen, Triangle, prepare};
pub use registers::{Param, Registers, WideParam};
pub use sst1::{Cull, Outcome, triangle};
pub use vertex::{TmuVertex, Vertex};
