//! Primitives.

mod antialias;
mod clip;
mod launch;
mod line;
mod point;
mod polygon;
mod raw;
mod stipple;
mod triangle;

pub(crate) use triangle::is_in_range;
