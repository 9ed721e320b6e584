//! The experiment of the thesis: speed-up and utilisation over modes and sizes.
//!
//! [`vectors`] lists the matrix, [`run`] measures, [`bands`] compares with the
//! published numbers, [`figures`] draws.
//!
//! Source: RAW, chapter 5.

pub mod bands;
pub mod figures;
pub mod gains;
pub mod run;
pub mod vectors;

/// The clock of the chip in the published rates.
pub const HERTZ: f64 = 300e6;
