//! Triangle set-up: from vertices to the registers of a rasterizer chip.

mod corners;
mod extra;
mod launch;
mod many;
mod palette;
mod planes;
mod raw;
mod registers;
mod sst1;
mod verite;
mod vertex;

pub(crate) use corners::{CornerBlocks, Lane, UsedState};
pub(crate) use extra::{BASE, Extra, ExtraNeeds, SPECULAR};
pub(crate) use launch::{Launch, Z};
pub(crate) use many::Many;
pub use palette::{PALETTE_COORDINATE, PalettePrimitive, PaletteVertex};
pub(crate) use palette::{Plane32, Shape, Texels, prepare_palette};
pub use planes::MAX_SCALE;
pub(crate) use planes::{
    Edge, Narrow, Plane64, PlaneF, Screen, Triangle, Triangles, offset, prepare, prepare_extra,
};
pub(crate) use raw::{ATTRIBUTES, RawShape, Slots, Steps, Values, Walk, prepare_raw, side_range};
pub use raw::{RawPrimitive, RawVertex};
pub use registers::{Param, Registers, WideParam};
pub use sst1::{Cull, Outcome, extended_triangle, triangle};
pub(crate) use sst1::{Fate, Sorted, set_up};
pub(crate) use verite::{VeriteCorners, VeriteSorted, set_up_verite, verite_extra};
pub use verite::{VeriteExtra, VeriteSlopes, VeriteVertex, verite_triangle};
pub use vertex::{TmuVertex, Vertex, VertexExtra};
