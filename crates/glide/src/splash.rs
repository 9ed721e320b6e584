//! The start-up picture and the mark in the corner of every frame: ours, made
//! of triangles, drawn with the board's own state functions.
//!
//! Source: G22, `grGlideShamelessPlug`; G246, `grSplash`. Both set all state
//! they need and restore it; neither touches texture memory.

use crate::board::Board;
use crate::enums::*;
use crate::vertex::GrVertex;

/// Frames of the whole start-up picture.
pub(crate) const FRAMES: u32 = 48;

/// The mark: rectangles of a letter F over four bars that grow, in a square of
/// side 1 from the upper left: x, y, width, height, and brightness at the top
/// and at the bottom.
const MARK: [([f32; 4], [f32; 2]); 7] = [
    ([0.10, 0.06, 0.16, 0.70], [1.0, 0.75]),
    ([0.26, 0.06, 0.48, 0.15], [1.0, 0.95]),
    ([0.26, 0.33, 0.34, 0.13], [0.9, 0.85]),
    ([0.10, 0.82, 0.12, 0.06], [0.5, 0.5]),
    ([0.28, 0.82, 0.16, 0.09], [0.6, 0.6]),
    ([0.50, 0.82, 0.18, 0.12], [0.8, 0.8]),
    ([0.74, 0.82, 0.20, 0.15], [1.0, 1.0]),
];

/// Colour of the mark at full brightness.
const COLOR: [f32; 3] = [255.0, 176.0, 64.0];

impl Board {
    /// Draws the mark in a rectangle of pixels from its upper left corner.
    fn draw_mark(&mut self, [x, y, width, height]: [f32; 4], alpha: f32, grown: f32) {
        for ([rx, ry, rw, rh], [top, bottom]) in MARK {
            let corner = |u: f32, v: f32, bright: f32| GrVertex {
                // Snapped, so that neighbouring parts meet.
                x: ((x + (rx + rw * u * grown) * width) * 16.0).round() / 16.0,
                y: ((y + (ry + rh * v) * height) * 16.0).round() / 16.0,
                r: COLOR[0] * bright,
                g: COLOR[1] * bright,
                b: COLOR[2] * bright,
                a: alpha,
                oow: 1.0,
                ..GrVertex::default()
            };
            let fan = [
                corner(0.0, 0.0, top),
                corner(1.0, 0.0, top),
                corner(1.0, 1.0, bottom),
                corner(0.0, 1.0, bottom),
            ];
            self.draw_polygon(&fan);
        }
    }

    /// Runs `draw` with a state for flat blended triangles over the whole
    /// screen, rows from the top, and restores the program's state.
    fn with_plain_state(&mut self, draw: impl FnOnce(&mut Board)) {
        // What a lock changes for its time is no part of a saved state.
        let (kept, fbi, write) = (self.save(), self.fbi, self.lfb.write);
        let Some(size) = self.buffers.as_ref().map(|b| (b.width, b.height)) else { return };
        self.set_defaults(0, size);
        self.set_alpha_combine(COMBINE_LOCAL, FACTOR_NONE, LOCAL_ITERATED, OTHER_CONSTANT, false);
        self.set_blend([1, 5, BLEND_ONE, BLEND_ZERO]);
        draw(self);
        self.restore(&kept);
        (self.fbi, self.lfb.write) = (fbi, write);
    }

    /// Draws the mark, half seen through, in the lower right corner.
    pub(crate) fn draw_plug(&mut self) {
        let Some((w, h)) = self.buffers.as_ref().map(|b| (b.width as f32, b.height as f32)) else {
            return;
        };
        let side = (h / 8.0).min(w / 8.0);
        let place = [w - side * 1.1, h - side * 1.1, side, side];
        self.with_plain_state(|board| board.draw_mark(place, 144.0, 1.0));
    }

    /// Draws one frame of the start-up picture in a rectangle of pixels, as a
    /// square in its middle; frame 0 is the last one, complete.
    pub(crate) fn draw_splash(&mut self, [x, y, width, height]: [f32; 4], frame: u32) {
        let values = [x, y, width, height];
        // What does not fit the board's coordinates is not drawn.
        let fits = values.iter().all(|v| (0.0..=2000.0).contains(v));
        if !fits || x + width > 2000.0 || y + height > 2000.0 {
            return;
        }
        let frame = if frame == 0 { FRAMES } else { frame.min(FRAMES) };
        let done = frame as f32 / FRAMES as f32;
        let side = width.min(height);
        let place = [x + (width - side) / 2.0, y + (height - side) / 2.0, side, side];
        let grown = (done * 1.5).min(1.0);
        self.with_plain_state(|board| board.draw_mark(place, 255.0 * done, grown));
    }

    /// The whole start-up picture on black, shown frame by frame.
    pub(crate) fn run_splash(&mut self) {
        let Some((w, h)) = self.buffers.as_ref().map(|b| (b.width as f32, b.height as f32)) else {
            return;
        };
        for frame in 1..=FRAMES {
            self.clear(0, 0, 0);
            let side = (w.min(h) * 0.6).floor();
            self.draw_splash([(w - side) / 2.0, (h - side) / 2.0, side, side], frame);
            self.swap(1);
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::{Call, Context, GlideConfig};

    fn glide(splash: bool) -> Context {
        let config = GlideConfig { splash, ..GlideConfig::default() };
        let mut glide = Context::new(config).expect("a board");
        glide.execute(&Call::GrGlideInit {});
        let open = Call::GrSstWinOpen {
            window: 0,
            resolution: 1,
            refresh: 0,
            color_format: 0,
            origin: 1,
            colors: 2,
            aux: 1,
        };
        assert_eq!(glide.execute(&open), 1);
        glide
    }

    fn swap(glide: &mut Context) -> Vec<u16> {
        glide.execute(&Call::GrBufferClear { color: 0, alpha: 0, depth: 0 });
        glide.execute(&Call::GrBufferSwap { interval: 0 });
        glide.shown().expect("a frame").pixels
    }

    #[test]
    fn the_plug_is_in_the_lower_right_corner_and_leaves_the_state_alone() {
        let mut glide = glide(false);
        assert!(swap(&mut glide).iter().all(|&p| p == 0));
        let before = glide.state();
        glide.execute(&Call::GrGlideShamelessPlug { on: 1 });
        let pixels = swap(&mut glide);
        assert_eq!(glide.state(), before);
        let lit = |at: usize| pixels[at] != 0;
        let (all, corner) = (0..320 * 240, |&at: &usize| at % 320 > 280 && at / 320 > 200);
        let lit: Vec<usize> = all.filter(|&at| lit(at)).collect();
        assert!(lit.len() > 100 && lit.iter().all(corner));
        glide.execute(&Call::GrGlideShamelessPlug { on: 0 });
        assert!(swap(&mut glide).iter().all(|&p| p == 0));
    }

    #[test]
    fn the_start_up_picture_is_shown_where_it_is_asked_for() {
        assert_eq!(glide(false).swaps(), 0);
        let mut glide = glide(true);
        assert_eq!(glide.swaps(), u64::from(super::FRAMES));
        let lit = |p: &[u16]| p.iter().filter(|&&p| p != 0).count();
        assert!(lit(&glide.shown().expect("a frame").pixels) > 2000);
        // By the program itself, one frame.
        let nan = Call::GrSplash { x: f32::NAN, y: 0.0, width: 9.0, height: 9.0, frame: 3 };
        glide.execute(&nan);
        glide.execute(&Call::GrBufferClear { color: 0, alpha: 0, depth: 0 });
        let splash = Call::GrSplash { x: 0.0, y: 0.0, width: 320.0, height: 240.0, frame: 0 };
        glide.execute(&splash);
        let pixels = glide.lfb_read_region(1, (0, 0), (320, 240)).expect("a buffer");
        assert!(lit(&pixels) > 5000);
    }
}
