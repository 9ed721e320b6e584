//! Apple QuickDraw 3D RAVE on the pixel engine.
//!
//! A [`Context`] is a whole library without global state: the manager with its
//! engines, and all draw contexts, textures, bitmaps and colour tables by
//! number. Calls are values of [`Call`], carried out by [`Context::execute`];
//! what returns data has a method of its own. State is kept as the program set
//! it and translated in one place into the engine's draw state; no pixel is
//! touched here.
//!
//! Source tag: RAVE; see `docs/sources.md`.

#![forbid(unsafe_code)]

pub mod constants;
pub mod gestalt;
pub mod memory;
pub mod tags;

mod call;
mod context;
mod error;
mod handle;
mod pixel;
mod vertex;

pub use call::{Call, Reply};
pub use context::{Context, RaveConfig};
pub use error::{RaveError, status_code};
pub use handle::{BitmapId, ColorTableId, DrawContextId, EngineId, TextureId};
pub use pixel::PixelType;
pub use vertex::{
    DeviceValue, ImageValue, IndexedTriangle, RaveRect, VGouraud, VMultiTexture, VTexture,
};
