//! Geometry against known values of the technote and naive models.

mod clipping;
mod frustum;
mod projection;
mod support;
