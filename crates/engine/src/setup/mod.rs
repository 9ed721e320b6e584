//! Triangle set-up: from vertices to the registers of a rasterizer chip.

mod planes;
mod registers;
mod sst1;
mod vertex;

pub(crate) use planes::{NARROW, Plane64, Screen, Triangle, Triangles, Z, prepare};
pub use registers::{Param, Registers, WideParam};
pub use sst1::{Cull, Outcome, triangle};
pub use vertex::{TmuVertex, Vertex};
