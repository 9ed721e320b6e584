//! Rasterization: which fragments of a tile a triangle covers, and the loop
//! that draws a tile.

mod coverage;
mod depth_range;
mod palette;
mod queue;
mod raw;
mod small;
mod tile;

pub(crate) use tile::TilePainter;
