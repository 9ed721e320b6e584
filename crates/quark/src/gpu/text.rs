//! Text and the frame rate.
//!
//! Source: QK, text drawing.

use fillrate_engine::PalettePrimitive;

use super::{Gpu, brush};
use crate::font::{GLYPH, font_texture, glyph_at};

/// The most characters of a text that are drawn.
const MAX_TEXT: usize = 1 << 16;

/// Counts frames over whole seconds.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct FrameRate {
    /// Clock at the start of the second.
    start: Option<u32>,
    frames: u32,
    rate: u32,
}

impl FrameRate {
    /// Counts a frame at a clock of milliseconds; the rate of the last full
    /// second, 0 in the first.
    pub fn frame(&mut self, ticks: u32) -> u32 {
        let Some(start) = self.start else {
            self.start = Some(ticks);
            return 0;
        };
        self.frames = self.frames.saturating_add(1);
        let elapsed = ticks.wrapping_sub(start);
        if elapsed >= 1000 {
            let rate = u64::from(self.frames) * 1000 / u64::from(elapsed);
            *self = FrameRate { start: Some(ticks), frames: 0, rate: rate as u32 };
        }
        self.rate
    }
}

impl Gpu {
    /// Draws text in glyphs of 8x8 pixels, the first with its top-left corner
    /// at (x, y), by the text state. A line feed starts a line below. Other
    /// bytes outside ASCII's printable ones are blanks. Depth does not count.
    pub fn print_xy(&mut self, text: &[u8], x: i32, y: i32) {
        let state = &self.text_state;
        let draw = brush::stencil(state.draw_mode, font_texture());
        let (color, intensity) = (state.draw_color, state.draw_intensity);
        let (mut column, mut row) = (x, y);
        for &byte in text.iter().take(MAX_TEXT) {
            if byte == b'\n' {
                (column, row) = (x, row.saturating_add(GLYPH));
                continue;
            }
            if let Some([s, t]) = glyph_at(byte) {
                let glyph = PalettePrimitive::Rect {
                    at: [column, row],
                    size: [GLYPH as u32; 2],
                    texel: [s << 16, t << 16],
                    step: [1 << 16; 2],
                    depth: 0,
                    intensity,
                    color,
                };
                if self.on_screen(column, row) {
                    self.device.draw_palette(&draw, glyph);
                }
            }
            column = column.saturating_add(GLYPH);
        }
    }

    fn on_screen(&self, column: i32, row: i32) -> bool {
        let reaches = |at: i32, size: i32| at > -GLYPH && at < size;
        reaches(column, self.camera.size[0]) && reaches(row, self.camera.size[1])
    }

    /// Counts a frame and draws the frame rate at the top left; `ticks` is a
    /// clock of milliseconds, which may wrap.
    pub fn print_fps(&mut self, ticks: u32) {
        let rate = self.rate.frame(ticks);
        self.print_xy(rate.to_string().as_bytes(), 0, 0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rate_of_the_last_full_second() {
        let mut rate = FrameRate::default();
        let start = u32::MAX - 500;
        let shown: Vec<u32> = (0..60).map(|i| rate.frame(start.wrapping_add(i * 40))).collect();
        assert!(shown[..25].iter().all(|&rate| rate == 0));
        assert!(shown[25..].iter().all(|&rate| rate == 25));
    }
}
