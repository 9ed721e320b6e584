//! Geometry against known values of the technote and naive models.

mod clipping;
mod culling;
mod detail;
mod frustum;
mod preflight;
mod projection;
mod support;
