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
pub mod notice;
pub mod tags;

mod access;
mod call;
mod color_table;
mod context;
mod description;
mod draw;
mod draw_context;
mod engine;
mod error;
mod fog;
mod foreign;
mod frame;
mod front;
mod handle;
mod image;
mod manager;
mod objects;
mod painter;
mod pixel;
mod present;
mod state;
mod texture;
mod translate;
mod vertex;

pub use access::ZBuffer;
pub use call::{Call, Reply};
pub use context::{Context, MAX_CONTEXTS, RaveConfig};
pub use draw_context::MAX_CONTEXT_SIDE;
pub use engine::Engine;
pub use error::{RaveError, status_code};
pub use front::Shown;
pub use handle::{BitmapId, ColorTableId, DrawContextId, EngineId, TextureId};
pub use image::MAX_IMAGE_SIDE;
pub use manager::{APPLE_SOFTWARE, BEST_CHOICE, FILLRATE};
pub use pixel::PixelType;
pub use state::MAX_LAYERS;
pub use vertex::{
    DeviceValue, ImageValue, IndexedTriangle, RaveRect, VGouraud, VMultiTexture, VTexture,
};
