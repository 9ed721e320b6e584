//! Clearing, swapping and showing buffers.

use fillrate_engine::state::{Dither, Origin, Rect};
use fillrate_engine::{ClearValues, FlushReason};

use crate::board::Board;
use crate::registers::fbz;

/// What the board shows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Shown {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// 565, row by row from the top left; before gamma and filter.
    pub pixels: Vec<u16>,
}

impl Board {
    /// Fills the clip window of the buffer drawn to, by the current masks.
    ///
    /// Source: G246, `grBufferClear`; the aux plane takes alpha where it holds
    /// alpha, else depth where depth buffering is on.
    pub(crate) fn clear(&mut self, color: u32, alpha: u8, depth: u16) {
        self.update();
        let Some(buffers) = &self.buffers else { return };
        let on = |bit: u32| self.fbi.fbz_mode & bit != 0;
        let dither = match (on(fbz::DITHER), on(fbz::DITHER_2X2)) {
            (false, _) => Dither::Off,
            (true, true) => Dither::Ordered2x2,
            (true, false) => Dither::Ordered4x4,
        };
        let aux = match (on(fbz::AUX_WRITE), on(fbz::ALPHA_PLANES), on(fbz::DEPTH_ENABLE)) {
            (true, true, _) => Some(u16::from(alpha)),
            (true, false, true) => Some(depth),
            _ => None,
        };
        let values =
            ClearValues { color: on(fbz::RGB_WRITE).then(|| (self.color(color), dither)), aux };
        let rect = self.clip_on_screen(buffers.height);
        self.device.clear(rect, values);
    }

    /// The clip window in screen rows.
    fn clip_on_screen(&self, height: u32) -> Rect {
        let field = |register: u32, shift: u32| register >> shift & 0x3ff;
        let (lr, bt) = (self.fbi.clip_left_right, self.fbi.clip_bottom_top);
        let (y0, y1) = (field(bt, 16), field(bt, 0));
        let (y0, y1) = match self.origin() {
            Origin::UpperLeft => (y0, y1),
            Origin::LowerLeft => (height - y1.min(height), height - y0.min(height)),
        };
        Rect::new(field(lr, 16), y0, field(lr, 0), y1)
    }

    /// Shows the back buffer. Contents change places, nothing is copied.
    pub(crate) fn swap(&mut self) {
        self.device.flush(FlushReason::Swap);
        if let Some(buffers) = &mut self.buffers {
            buffers.colors.rotate_left(1);
            self.swaps += 1;
            self.dirty = true;
        }
    }

    /// The displayed buffer.
    pub(crate) fn shown(&mut self) -> Option<Shown> {
        let buffers = self.buffers.as_ref()?;
        let (width, height, front) = (buffers.width, buffers.height, buffers.colors[0]);
        let mut pixels = vec![0; (width * height) as usize];
        let all = Rect::new(0, 0, width, height);
        self.device.read16(front, all, &mut pixels, width as usize).ok()?;
        Some(Shown { width, height, pixels })
    }

    /// Moves the clock and returns the line being shown, 0 in retrace.
    pub(crate) fn video_line(&mut self) -> u32 {
        let height = self.buffers.as_ref().map_or(0, |buffers| buffers.height);
        // About a tenth of the lines of a frame are retrace.
        let total = height + height / 10 + 1;
        self.ticks = (self.ticks + 7) % total;
        if self.ticks < height { self.ticks } else { 0 }
    }

    /// Whether the beam is in vertical retrace; moves the clock.
    pub(crate) fn in_retrace(&mut self) -> bool {
        self.video_line();
        let height = self.buffers.as_ref().map_or(0, |buffers| buffers.height);
        self.ticks >= height
    }

    /// The idle status register: bit 6 clear in retrace, the displayed buffer
    /// in bits 11..10.
    pub(crate) fn status(&mut self) -> u32 {
        let retrace = if self.in_retrace() { 0 } else { 1 << 6 };
        let count = self.buffers.as_ref().map_or(1, |buffers| buffers.colors.len() as u64);
        let displayed = (self.swaps % count) as u32;
        0x0fff_f03f | retrace | displayed << 10
    }
}
