//! Tests of RAVE through its calls.

mod calls;
mod conformance;
mod engines;
mod frames;
mod model;
mod pixels;
mod primitives;
mod replay;
mod scene;
mod shown;
mod textures;
