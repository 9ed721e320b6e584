//! Frames of a board as the log and the trace keep them.

use fillrate_capture::Drawn;
use fillrate_engine::Counters;
use fillrate_player::{Frame, Pixels};

/// What a board shows, as a frame.
pub fn frame_of(shown: fillrate_glide::Shown) -> Option<Frame> {
    Frame::new(shown.width, shown.height, Pixels::Rgb565(shown.pixels)).ok()
}

/// What the engine has drawn.
pub fn drawn(counters: &Counters) -> Drawn {
    Drawn { triangles: counters.triangles_drawn, pixels: counters.pixels_in }
}
