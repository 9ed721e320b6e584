//! The experiment of the thesis: speed-up and utilisation over modes and sizes.
//!
//! [`vectors`] lists the matrix, [`run`] measures, `bands` compares with the published numbers.
//!
//! Source: RAW, chapter 5.

pub mod run;
pub mod vectors;

/// The clock of the chip in the published rates.
pub const HERTZ: f64 = 300e6;
