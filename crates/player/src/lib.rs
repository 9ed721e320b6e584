//! Replaying traces, and the pictures that come out: hashing, comparing, storing.
//!
//! [`Player`] reads a trace and hands its calls to a [`Target`], which is a front end behind a thin
//! adaptor. At each end of a frame it hashes what the target shows and compares the hash with the
//! recorded one. [`Frame`] and [`compare()`](compare::compare) serve tests and tools without a
//! trace as well.
#![forbid(unsafe_code)]

pub mod compare;
mod error;
pub mod frame;
mod picture;
mod play;
mod report;
mod target;

pub use compare::{Comparison, Difference, compare, difference_image};
pub use error::{FrameError, PlayError};
pub use frame::{Frame, MAX_FRAME_PIXELS, Pixels};
pub use play::{Limits, Played, Player, play};
pub use report::{FrameResult, Report, Stop, Verdict};
pub use target::{Target, TargetError};
