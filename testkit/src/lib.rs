//! What the tests of the pixel engine are made of.
//!
//! [`reference`](mod@reference) is the definition of the fragment pipeline: slow, scalar and as
//! obvious as possible. [`random`] makes unpleasant cases, [`compare`] draws
//! them with the reference and with the engine and demands the same bits and
//! counts, [`golden`](mod@golden) compares scenes with stored pictures.
//!
//! The reference shares the engine's data types and nothing else: no set-up,
//! no iterator, no kernel, no packing.

#![forbid(unsafe_code)]

pub mod canvas;
pub mod compare;
pub mod fuzz;
pub mod golden;
pub mod random;
pub mod reference;

pub use canvas::{Canvas, DeviceCanvas};
pub use golden::{golden, golden_frames};
pub use reference::Reference;
