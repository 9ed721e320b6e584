//! The rotating stipple: a register of 32 bits that turns by one for every
//! fragment inside the clip window, and drops it where its top bit is 0.
//!
//! Which bit a fragment meets depends on all fragments before it, so the
//! fragments are counted here: a triangle is drawn in pieces of eight pixels
//! of a row at most, each with the fixed pattern that the register holds at
//! that place. Exact, and slow; nothing but raw register writes gets here.
//!
//! Source: SST1, stipple register. The order within a triangle is rows by
//! rising y, and from left to right.

use fillrate_engine::setup::{Outcome, triangle};
use fillrate_engine::state::{MAX_TMUS, Rect};
use fillrate_engine::{Cull, Registers, Vertex};

use crate::board::Board;
use crate::registers::fbz;

impl Board {
    /// Whether the stipple is on and turns.
    pub(crate) fn stipple_rotates(&self) -> bool {
        self.fbi.fbz_mode & (fbz::STIPPLE | fbz::STIPPLE_PATTERN) == fbz::STIPPLE
    }

    /// Draws a triangle that was set up.
    pub(crate) fn launch(&mut self, registers: &Registers) {
        if self.stipple_rotates() {
            self.launch_stippled(registers);
        } else {
            self.device.launch(registers);
        }
    }

    /// Draws a triangle as [`Board::launch`] does: pieces need it set up.
    pub(crate) fn draw_triangle_stippled(&mut self, corners: [&Vertex; 3], cull: Cull) {
        match triangle(corners, cull, MAX_TMUS) {
            Outcome::Drawn(registers) => self.launch_stippled(&registers),
            Outcome::Empty | Outcome::Culled => self.correction.submitted += 1,
        }
    }

    fn launch_stippled(&mut self, registers: &Registers) {
        let Some(buffers) = &self.buffers else { return };
        let screen = Rect::new(0, 0, buffers.width, buffers.height);
        let clip = self.drawing_clip(screen);
        let kept = (self.fbi.fbz_mode, self.fbi.stipple);
        let kept_clip = (self.fbi.clip_left_right, self.fbi.clip_bottom_top);
        self.fbi.fbz_mode |= fbz::STIPPLE_PATTERN | fbz::CLIP;
        let mut stipple = kept.1;
        let mut launches = 0;
        for (y, x0, x1) in rows(registers, clip) {
            let mut x = x0;
            while x < x1 {
                let end = (x | 7).min(x1 - 1) + 1;
                let mut pattern = 0u32;
                for column in x..end {
                    pattern |= (stipple >> 31) << (!column & 7);
                    stipple = stipple.rotate_left(1);
                }
                if pattern != 0 {
                    self.launch_piece(registers, y, (x, end), pattern);
                    launches += 1;
                }
                x = end;
            }
        }
        (self.fbi.fbz_mode, self.fbi.stipple) = (kept.0, stipple);
        (self.fbi.clip_left_right, self.fbi.clip_bottom_top) = kept_clip;
        self.dirty = true;
        self.count_once(registers, screen, launches);
    }

    /// One piece: the same pattern on every row, of which one is drawn.
    fn launch_piece(&mut self, registers: &Registers, y: u32, (x0, x1): (u32, u32), pattern: u32) {
        self.fbi.stipple = pattern * 0x0101_0101;
        self.fbi.clip_left_right = x0 << 16 | x1;
        self.fbi.clip_bottom_top = y << 16 | (y + 1);
        self.dirty = true;
        self.update();
        self.device.launch(registers);
    }

    /// The clip window in drawing coordinates, inside the screen.
    fn drawing_clip(&self, screen: Rect) -> Rect {
        if self.fbi.fbz_mode & fbz::CLIP == 0 {
            return screen;
        }
        let field = |register: u32, shift: u32| register >> shift & 0x3ff;
        let (lr, bt) = (self.fbi.clip_left_right, self.fbi.clip_bottom_top);
        screen.intersect(&Rect::new(field(lr, 16), field(bt, 16), field(lr, 0), field(bt, 0)))
    }

    /// Every launch counts the whole triangle: all but one are taken off.
    fn count_once(&mut self, registers: &Registers, screen: Rect, launches: i64) {
        if launches == 1 {
            return;
        }
        let covered: u32 = rows(registers, screen).map(|(_, x0, x1)| x1 - x0).sum();
        self.correction.pixels_in += (1 - launches) * i64::from(covered);
        self.correction.submitted += 1 - launches;
        self.correction.drawn += 1 - launches;
    }

    /// Ready-made fragments of a row: which of them the stipple lets through.
    /// Turns the register for each one inside the clip window.
    pub(crate) fn stipple_fragments(&mut self, x: u32, y: u32, count: usize) -> Vec<bool> {
        let Some(buffers) = &self.buffers else { return vec![true; count] };
        let clip = self.drawing_clip(Rect::new(0, 0, buffers.width, buffers.height));
        let inside_row = (clip.y0..clip.y1).contains(&y);
        (x..)
            .take(count)
            .map(|x| {
                if !inside_row || !(clip.x0..clip.x1).contains(&x) {
                    return false;
                }
                let passes = self.fbi.stipple >> 31 != 0;
                self.fbi.stipple = self.fbi.stipple.rotate_left(1);
                passes
            })
            .collect()
    }
}

/// The covered columns of each row inside `clip`, in drawing coordinates: row,
/// first column, one past the last.
///
/// Exact: pixel centres on the left or lower-y edge are in, others out.
fn rows(registers: &Registers, clip: Rect) -> impl Iterator<Item = (u32, u32, u32)> + use<> {
    let low = |v: i32| i64::from(v as i16);
    let (x, y) = (registers.x.map(low), registers.y.map(low));
    let b_is_left = registers.negative;
    // Centres at or below y: the first row whose centre is not above it.
    let first_row = |y: i64| (y + 7) >> 4;
    let (top, bottom) = (first_row(y[0]), first_row(y[2]));
    (i64::from(clip.y0)..i64::from(clip.y1))
        .filter(move |row| (top..bottom).contains(row))
        .filter_map(move |row| {
            let center = 16 * row + 8;
            let short = if center < y[1] || y[1] == y[2] { (0, 1) } else { (1, 2) };
            let long_edge = first_column((x[0], y[0]), (x[2], y[2]), center)?;
            let short_edge =
                first_column((x[short.0], y[short.0]), (x[short.1], y[short.1]), center)?;
            let (left, right) =
                if b_is_left { (short_edge, long_edge) } else { (long_edge, short_edge) };
            let x0 = left.max(i64::from(clip.x0));
            let x1 = right.min(i64::from(clip.x1));
            (x0 < x1).then_some((row as u32, x0 as u32, x1 as u32))
        })
}

/// The first column whose centre is not left of an edge at a height, all in
/// sixteenths of pixels.
fn first_column((ax, ay): (i64, i64), (bx, by): (i64, i64), center: i64) -> Option<i64> {
    let dy = by - ay;
    if dy <= 0 {
        return None;
    }
    // ceil((x - 8) / 16) with x = ax + (bx - ax) * (center - ay) / dy.
    let numerator = (ax - 8) * dy + (bx - ax) * (center - ay);
    Some((numerator + 16 * dy - 1).div_euclid(16 * dy))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Call, Context, GlideConfig, GrVertex};
    use fillrate_engine::{Counters, DeviceConfig};

    fn glide(origin: i32) -> Context {
        let device = DeviceConfig { threads: 1, ..DeviceConfig::default() };
        let mut glide =
            Context::new(GlideConfig { device, ..GlideConfig::default() }).expect("a board");
        glide.execute(&Call::GrGlideInit {});
        let open = Call::GrSstWinOpen {
            window: 0,
            resolution: 1,
            refresh: 0,
            color_format: 0,
            origin,
            colors: 2,
            aux: 1,
        };
        assert_eq!(glide.execute(&open), 1);
        glide.execute(&Call::GrColorMask { rgb: 1, alpha: 0 });
        glide.execute(&Call::GrBufferClear { color: 0, alpha: 0, depth: 0 });
        glide.execute(&Call::GrSstResetPerfStats {});
        glide.execute(&Call::GrResetTriStats {});
        glide
    }

    fn stipple(glide: &mut Context, bits: u32) {
        let mode = glide.boards[0].fbi.fbz_mode | fbz::STIPPLE;
        for (register, value) in [(68, mode), (80, bits)] {
            glide.execute(&Call::GrSstConfigPipeline { chip: 3, register, value });
        }
    }

    fn corner(x: f32, y: f32) -> GrVertex {
        GrVertex { x, y, r: x, g: y, b: 255.0, a: 255.0, oow: 1.0, ..GrVertex::default() }
    }

    fn draw(glide: &mut Context) -> (Vec<u16>, Counters) {
        let triangles = [
            [(10.3, 5.0), (100.7, 60.2), (40.1, 110.9)],
            [(200.0, 20.0), (150.0, 20.0), (170.5, 90.0)],
            [(310.0, 200.0), (330.0, 260.0), (280.0, 230.0)],
        ];
        for corners in triangles {
            let [a, b, c] = corners.map(|(x, y)| corner(x, y));
            glide.execute(&Call::GrDrawTriangle { a, b, c });
        }
        glide.execute(&Call::GrDrawLine { a: corner(5.0, 150.0), b: corner(100.0, 190.0) });
        let pixels = glide.lfb_read_region(1, (0, 0), (320, 240)).expect("a buffer");
        (pixels, glide.counters())
    }

    /// All ones let everything through, piece by piece.
    #[test]
    fn pieces_add_up_to_the_triangle() {
        for origin in [0, 1] {
            let whole = draw(&mut glide(origin));
            let mut pieces = glide(origin);
            stipple(&mut pieces, u32::MAX);
            assert_eq!(draw(&mut pieces), whole);
            assert!(whole.1.pixels_out > 5000);
        }
    }

    #[test]
    fn every_other_fragment_is_dropped_across_rows() {
        let mut glide = glide(0);
        stipple(&mut glide, 0xaaaa_aaaa);
        // Rows of five pixels: the phase changes from row to row.
        for corners in
            [[(10.0, 10.0), (15.0, 10.0), (15.0, 14.0)], [(10.0, 10.0), (15.0, 14.0), (10.0, 14.0)]]
        {
            let [a, b, c] = corners.map(|(x, y)| corner(x, y));
            glide.execute(&Call::GrDrawTriangle { a, b, c });
        }
        assert_eq!(glide.counters().pixels_out, 10);
        assert_eq!(glide.counters().pixels_in, 20);
        assert_eq!(glide.counters().triangles_drawn, 2);
        assert_eq!(glide.boards[0].fbi.stipple, 0xaaaa_aaaa);
    }
}
