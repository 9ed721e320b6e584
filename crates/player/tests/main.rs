//! Frames, their comparison, and replays of a toy system.

mod comparison;
mod pictures;
mod replay;
mod toy;

use fillrate_player::{Frame, Pixels};

/// A frame of 8-bit RGBA pixels.
pub fn rgba(width: u32, height: u32, bytes: Vec<u8>) -> Frame {
    Frame::new(width, height, Pixels::Rgba8(bytes)).expect("pixels fill the frame")
}

/// A frame of 565 pixels.
pub fn rgb565(width: u32, height: u32, words: Vec<u16>) -> Frame {
    Frame::new(width, height, Pixels::Rgb565(words)).expect("pixels fill the frame")
}
