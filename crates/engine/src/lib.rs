//! The pixel engine: triangles in, exact pixels out.
//!
//! The engine knows no API. It knows [`Surface`]s of pixels in tiles, immutable
//! [`Texture`]s, a [`DrawState`] as a plain value, and triangles given either
//! as triples of [`Vertex`] or [`VeriteVertex`] (the engine does the set-up of
//! that chip) or as [`Registers`] (the caller did it). A [`Device`] collects commands and draws
//! them in batches, tile by tile on all its threads and behind the caller, with
//! the same bits and counts for every thread count, tile size and SIMD level.
//!
//! Data flows one way: command arena -> set-up -> bins -> tiles -> stages of
//! the fragment pipeline -> surface. Reading a surface or a counter is a flush.

#![forbid(unsafe_code)]

pub mod fixed;
pub mod setup;
pub mod state;
pub mod target;
pub mod texture;

mod bins;
mod crew;
mod device;
mod error;
mod kernel;
mod log2;
mod raster;
mod reused;
mod stats;

pub use device::{ClearValues, Device, DeviceConfig, FlushReason, PixelRun, SurfaceId};
pub use error::EngineError;
pub use setup::{
    Cull, Outcome, PALETTE_COORDINATE, PalettePrimitive, PaletteVertex, Param, RawPrimitive,
    RawVertex, Registers, TmuVertex, VeriteExtra, VeriteVertex, Vertex, VertexExtra, WideParam,
};
pub use state::{
    DrawState, PaletteBlend, PaletteDraw, PaletteState, RawDraw, RawState, RawTexture,
};
pub use stats::{Counters, FlushStats};
pub use target::{PixelFormat, Surface};
pub use texture::{Level, Texture, TextureDesc};
