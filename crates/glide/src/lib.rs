//! 3Dfx Glide 2.x on the pixel engine.
//!
//! A [`Context`] is a whole library without global state. Calls are values of
//! [`Call`], carried out by [`Context::execute`]; what returns data has a
//! method of its own. State is kept as the board's registers hold it and
//! decoded in one place into the engine's draw state; no pixel is touched
//! here.
//!
//! Source tags: G22, G246, SST1; see `docs/sources.md`.

#![forbid(unsafe_code)]

pub mod card;
pub mod enums;
pub mod gu;
pub mod rules;
pub mod texture;

mod board;
mod buffers;
mod call;
mod clock;
mod combine;
mod context;
mod defaults;
mod draw;
mod error;
mod execute;
mod improve;
mod lfb;
mod pixel_state;
mod register_access;
mod registers;
mod scanout;
mod splash;
mod state;
mod texture_state;
mod translate;
mod variables;
mod vertex;

pub use buffers::Shown;
pub use call::Call;
pub use context::{Context, GlideConfig, MAX_BOARDS};
pub use error::{GlideError, Report};
pub use improve::{Improvements, MAX_SCALE};
pub use lfb::{LfbInfo, ROW_PIXELS};
pub use scanout::{GammaTable, Picture, ScanOut};
pub use state::STATE_BYTES;
pub use texture_state::TextureInfo;
pub use vertex::{GrTmuVertex, GrVertex};
