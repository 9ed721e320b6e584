//! What every C library of ours keeps of a run: frames with their log, and a trace of the calls.
#![forbid(unsafe_code)]

mod frames;
mod recorder;
mod variable;

pub use frames::{Drawn, FrameLog};
pub use recorder::Recorder;
pub use variable::{number, variable};
