//! Triangle set-up: from vertices to the registers of a rasterizer chip.

mod registers;
mod sst1;
mod vertex;

pub use registers::{Param, Registers, WideParam};
pub use sst1::{Cull, Outcome, triangle};
pub use vertex::{TmuVertex, Vertex};
