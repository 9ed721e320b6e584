//! The MIT Raw 3D pipeline (2004): a slave renderer driven by command words, and a simulator of the
//! 16-tile machine it ran on.
//!
//! Reading order: [`opcode`] (what a host may say), [`stage`] (the four pipeline stages, each as a
//! plain function), [`device`] (the single-tile reference renderer), then [`sim`] (the same stages
//! on a grid of tiles with networks, tokens and caches) and [`mod@bench`] (the published experiment).
//!
//! Where the thesis documents an error of its own, [`Errata`] decides whether to keep it.
#![forbid(unsafe_code)]

pub mod bench;
pub mod call;
pub mod client;
pub mod color;
mod context;
pub mod device;
mod errata;
mod error;
mod follower;
pub mod framebuffer;
pub mod host;
#[doc(hidden)]
pub mod hostile;
pub mod matrix;
pub mod observer;
pub mod opcode;
mod painter;
pub mod protocol;
pub mod scenes;
pub mod serve;
pub mod sim;
pub mod stage;
pub mod state;
pub mod stream;
pub mod texture;

pub use fillrate_engine::target::TileSize;
pub use fillrate_simd::Level;

pub use context::{Context, Report, Shown, shown};
pub use device::{Config, Device};
pub use errata::Errata;
pub use error::StreamError;
