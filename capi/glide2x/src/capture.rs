//! Frames of a board as the log and the trace keep them.

use fillrate_capture::Drawn;
use fillrate_engine::Counters;
use fillrate_glide::{ScanOut, Shown};
use fillrate_player::{Frame, Pixels};

/// What a board's buffer holds, as a frame.
pub fn frame_of(shown: &Shown) -> Option<Frame> {
    Frame::new(shown.width, shown.height, Pixels::Rgb565(shown.pixels.clone())).ok()
}

/// What its monitor shows; `None` where that is what the buffer holds.
pub fn on_monitor(shown: &Shown, scan_out: ScanOut) -> Option<Frame> {
    if scan_out == ScanOut::default() && shown.detail.is_none() {
        return None;
    }
    let picture = shown.on_monitor(scan_out);
    let (width, height) = (picture.width, picture.height);
    let rgba = picture.pixels.into_iter().flat_map(|[r, g, b]| [r, g, b, 255]).collect();
    Frame::new(width, height, Pixels::Rgba8(rgba)).ok()
}

/// What the engine has drawn.
pub fn drawn(counters: &Counters) -> Drawn {
    Drawn { triangles: counters.triangles_drawn, pixels: counters.pixels_in }
}
