//! Stipples that the engine does not draw.
//!
//! The rotating stipple is a register of 32 bits that turns by one for every
//! fragment inside the clip window, and drops it where its top bit is 0. Which
//! bit a fragment meets depends on all fragments before it, so the fragments
//! are counted here: a triangle is drawn in pieces of eight pixels of a row at
//! most, each with the fixed pattern that the register holds at that place.
//!
//! Where pixels are drawn as several by several, both kinds of stipple count
//! the board's pixels: pieces are then the runs of a row that pass. Pixels that
//! only the finer triangle touches, but not with their centre, meet the bit
//! that is next and do not turn the register.
//!
//! Exact, and slow; nothing but raw register writes gets here.
//!
//! Source: SST1, stipple register. The order within a triangle is rows by
//! rising y, and from left to right.

use fillrate_engine::setup::{Outcome, triangle};
use fillrate_engine::state::{MAX_TMUS, Origin, Rect};
use fillrate_engine::{Cull, Registers, Vertex};

use crate::board::Board;
use crate::registers::fbz;

impl Board {
    /// Whether the stipple is on and is not the engine's.
    pub(crate) fn stipples_in_pieces(&self) -> bool {
        let rotates = self.fbi.fbz_mode & fbz::STIPPLE_PATTERN == 0;
        self.fbi.fbz_mode & fbz::STIPPLE != 0 && (rotates || self.improve.scale > 1)
    }

    /// Whether the stipple lets a fragment through; `y` is a screen row. The
    /// rotating one turns where the board counts the fragment.
    fn stipple_passes(&mut self, x: u32, y: u32, counts: bool) -> bool {
        if self.fbi.fbz_mode & fbz::STIPPLE_PATTERN != 0 {
            return self.fbi.stipple >> ((y & 3) << 3 | !x & 7) & 1 != 0;
        }
        let passes = self.fbi.stipple >> 31 != 0;
        self.fbi.stipple = self.fbi.stipple.rotate_left(u32::from(counts));
        passes
    }

    /// Draws a triangle that was set up.
    pub(crate) fn launch(&mut self, registers: &Registers) {
        if self.stipples_in_pieces() {
            self.launch_stippled(registers);
        } else {
            self.device.launch(registers);
        }
    }

    /// Draws a part of a point, a line or a smooth edge.
    pub(crate) fn launch_helper(&mut self, registers: &Registers) {
        self.helpers[0] += 1;
        self.launch(registers);
    }

    /// Draws a triangle as [`Board::launch`] does: pieces need it set up.
    pub(crate) fn draw_triangle_stippled(&mut self, corners: [&Vertex; 3], cull: Cull) {
        match triangle(corners, cull, MAX_TMUS) {
            Outcome::Drawn(registers) => self.launch_stippled(&registers),
            Outcome::Empty | Outcome::Culled => self.correction.submitted += 1,
        }
    }

    fn launch_stippled(&mut self, registers: &Registers) {
        let screen = self.screen();
        let clip = self.drawing_clip(screen);
        let kept_mode = self.fbi.fbz_mode;
        let kept_clip = (self.fbi.clip_left_right, self.fbi.clip_bottom_top);
        let corners = Corners::new(registers, 1);
        let launches = match self.improve.scale {
            1 => self.launch_patterns(registers, &corners, clip),
            _ => self.launch_runs(registers, &corners, clip),
        };
        self.fbi.fbz_mode = kept_mode;
        (self.fbi.clip_left_right, self.fbi.clip_bottom_top) = kept_clip;
        self.dirty = true;
        self.count_once(registers, launches);
    }

    /// Pieces of eight pixels with the pattern that the register makes there.
    fn launch_patterns(&mut self, registers: &Registers, corners: &Corners, clip: Rect) -> i64 {
        let mut stipple = self.fbi.stipple;
        let mut launches = 0;
        self.fbi.fbz_mode |= fbz::STIPPLE_PATTERN;
        for (y, x0, x1) in corners.rows(clip) {
            let mut x = x0;
            while x < x1 {
                let end = (x | 7).min(x1 - 1) + 1;
                let mut pattern = 0u32;
                for column in x..end {
                    pattern |= (stipple >> 31) << (!column & 7);
                    stipple = stipple.rotate_left(1);
                }
                if pattern != 0 {
                    self.fbi.stipple = pattern * 0x0101_0101;
                    self.launch_piece(registers, y, (x, end));
                    launches += 1;
                }
                x = end;
            }
        }
        self.fbi.stipple = stipple;
        launches
    }

    /// Pieces of whole pixels that pass, for pixels drawn as several.
    fn launch_runs(&mut self, registers: &Registers, corners: &Corners, clip: Rect) -> i64 {
        let kept = self.fbi.fbz_mode;
        let mut launches = 0;
        for y in clip.y0..clip.y1 {
            let Some((x0, x1)) = corners.touched(y, &clip) else { continue };
            let counted = corners.row(y, &clip).unwrap_or((0, 0));
            let row = match self.origin() {
                Origin::UpperLeft => y,
                Origin::LowerLeft => self.screen().y1 - 1 - y,
            };
            let mut start = None;
            for x in x0..=x1 {
                let counts = (counted.0..counted.1).contains(&x);
                let passes = x < x1 && self.stipple_passes(x, row, counts);
                match (start, passes) {
                    (None, true) => start = Some(x),
                    (Some(first), false) => {
                        self.fbi.fbz_mode = kept & !fbz::STIPPLE;
                        self.launch_piece(registers, y, (first, x));
                        self.fbi.fbz_mode = kept;
                        (start, launches) = (None, launches + 1);
                    }
                    _ => {}
                }
            }
        }
        launches
    }

    /// One piece: what a row has between two columns.
    fn launch_piece(&mut self, registers: &Registers, y: u32, (x0, x1): (u32, u32)) {
        self.fbi.fbz_mode |= fbz::CLIP;
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
    fn count_once(&mut self, registers: &Registers, launches: i64) {
        if launches == 1 {
            return;
        }
        let corners = Corners::new(registers, self.improve.scale);
        let surface = self.on_surface(self.screen());
        let covered: u32 = corners.rows(surface).map(|(_, x0, x1)| x1 - x0).sum();
        self.correction.pixels_in += (1 - launches) * i64::from(covered);
        self.correction.submitted += 1 - launches;
        self.correction.drawn += 1 - launches;
    }

    /// Ready-made fragments of a row: which of them the stipple lets through.
    /// Turns the register for each one inside the clip window.
    pub(crate) fn stipple_fragments(&mut self, x: u32, y: u32, count: usize) -> Vec<bool> {
        let screen = self.screen();
        let clip = self.drawing_clip(screen);
        let inside_row = (clip.y0..clip.y1).contains(&y);
        let row = match self.origin() {
            Origin::UpperLeft => y,
            Origin::LowerLeft => (screen.y1 - 1).saturating_sub(y),
        };
        let inside = |x: &u32| inside_row && (clip.x0..clip.x1).contains(x);
        (x..).take(count).map(|x| inside(&x) && self.stipple_passes(x, row, true)).collect()
    }
}

/// A triangle's corners in sixteenths of pixels, by rising y.
struct Corners {
    x: [i64; 3],
    y: [i64; 3],
    b_is_left: bool,
}

impl Corners {
    /// Those of registers, where pixels are `scale` pixels wide and high.
    fn new(registers: &Registers, scale: u32) -> Corners {
        let low = |v: i32| i64::from(v as i16) * i64::from(scale);
        Corners { x: registers.x.map(low), y: registers.y.map(low), b_is_left: registers.negative }
    }

    /// The covered columns of each row inside `clip`, in drawing coordinates:
    /// row, first column, one past the last.
    fn rows(&self, clip: Rect) -> impl Iterator<Item = (u32, u32, u32)> + use<'_> {
        let rows = clip.y0..clip.y1;
        rows.filter_map(move |y| self.row(y, &clip).map(|(x0, x1)| (y, x0, x1)))
    }

    /// The covered columns of a row.
    ///
    /// Exact: pixel centres on the left or lower-y edge are in, others out.
    fn row(&self, row: u32, clip: &Rect) -> Option<(u32, u32)> {
        let (x, y) = (self.x, self.y);
        // Centres at or below y: the first row whose centre is not above it.
        let first_row = |y: i64| (y + 7) >> 4;
        let row = i64::from(row);
        if !(first_row(y[0])..first_row(y[2])).contains(&row) {
            return None;
        }
        let center = 16 * row + 8;
        let short = if center < y[1] || y[1] == y[2] { (0, 1) } else { (1, 2) };
        let long_edge = first_column((x[0], y[0]), (x[2], y[2]), center)?;
        let short_edge = first_column((x[short.0], y[short.0]), (x[short.1], y[short.1]), center)?;
        let (left, right) =
            if self.b_is_left { (short_edge, long_edge) } else { (long_edge, short_edge) };
        let x0 = left.max(i64::from(clip.x0));
        let x1 = right.min(i64::from(clip.x1));
        (x0 < x1).then_some((x0 as u32, x1 as u32))
    }

    /// Columns of a row that have all that the triangle touches of it.
    fn touched(&self, row: u32, clip: &Rect) -> Option<(u32, u32)> {
        let (top, bottom) = (16 * i64::from(row), 16 * i64::from(row) + 16);
        let (mut low, mut high) = (i64::MAX, i64::MIN);
        let mut reach = |x0: i64, x1: i64| (low, high) = (low.min(x0), high.max(x1));
        for i in 0..3 {
            let (a, b) = ((self.x[i], self.y[i]), (self.x[(i + 1) % 3], self.y[(i + 1) % 3]));
            if (top..=bottom).contains(&a.1) {
                reach(a.0, a.0);
            }
            for line in [top, bottom] {
                if (a.1 < line) != (b.1 < line) {
                    let x = a.0 + ((b.0 - a.0) * (line - a.1)).div_euclid(b.1 - a.1);
                    reach(x - 1, x + 1);
                }
            }
        }
        if low > high {
            return None;
        }
        let x0 = (low >> 4).max(i64::from(clip.x0));
        let x1 = ((high >> 4) + 1).min(i64::from(clip.x1));
        (x0 < x1).then_some((x0 as u32, x1 as u32))
    }
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
    use crate::{Call, Context, GlideConfig, GrVertex, Improvements};
    use fillrate_engine::{Counters, DeviceConfig};

    fn glide(origin: i32) -> Context {
        scaled(origin, 1)
    }

    fn scaled(origin: i32, scale: u32) -> Context {
        let device = DeviceConfig { threads: 1, ..DeviceConfig::default() };
        let improve = Improvements { scale, ..Improvements::default() };
        let config = GlideConfig { device, improve, ..GlideConfig::default() };
        let mut glide = Context::new(config).expect("a board");
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

    /// With any scale a stipple drops the pixels that it drops without, all of
    /// each or nothing, and the register turns as far.
    #[test]
    fn scaled_stipples_count_the_boards_pixels() {
        for (origin, pattern) in [(0, false), (1, false), (0, true), (1, true)] {
            let bits = if pattern { 0x1e_87_63_4b } else { 0xd00f_53a9 };
            let set_up = |glide: &mut Context| {
                stipple(glide, bits);
                if pattern {
                    let value = glide.boards[0].fbi.fbz_mode | fbz::STIPPLE_PATTERN;
                    let register = 68;
                    glide.execute(&Call::GrSstConfigPipeline { chip: 3, register, value });
                }
            };
            let mut plain = glide(origin);
            set_up(&mut plain);
            let expected = draw(&mut plain).0;
            for scale in 2..=4 {
                let mut glide = scaled(origin, scale);
                set_up(&mut glide);
                let pixels = draw(&mut glide).0;
                let different =
                    expected.iter().zip(&pixels).filter(|(a, b)| (**a == 0) != (**b == 0)).count();
                // Where an even scale has no middle, pixels at edges differ.
                assert!(different <= if scale == 3 { 0 } else { 120 }, "{scale}: {different}");
                assert_eq!(glide.boards[0].fbi.stipple, plain.boards[0].fbi.stipple);
                glide.execute(&Call::GrBufferSwap { interval: 0 });
                let picture = glide.shown().expect("a frame").detail.expect("a fine picture");
                // Inside a triangle pixels are there as a whole.
                for (x, y) in (30..60).flat_map(|x| (40..60).map(move |y| (x, y))) {
                    let y = if origin == 0 { y } else { 239 - y };
                    let at = |i: u32| {
                        let (x, y) = (x * scale + i % scale, y * scale + i / scale);
                        picture.pixels[(y * picture.width + x) as usize] != [0; 3]
                    };
                    assert!((0..scale * scale).all(|i| at(i) == at(0)), "{x} {y}");
                }
            }
        }
    }

    /// Pixels stored through the pipeline meet the pattern of the board's
    /// pixels, too.
    #[test]
    fn scaled_stores_are_stippled() {
        let written = |scale: u32| {
            let mut glide = scaled(0, scale);
            glide.execute(&Call::GrDitherMode { mode: 0 });
            stipple(&mut glide, 0x1e_87_63_4b);
            let value = glide.boards[0].fbi.fbz_mode | fbz::STIPPLE_PATTERN;
            glide.execute(&Call::GrSstConfigPipeline { chip: 3, register: 68, value });
            glide.lfb_lock(1, 1, 0, 0, true).expect("a lock");
            for row in glide.lfb_memory(1).expect("memory")[..32 * 512].chunks_exact_mut(512) {
                row[..40].fill(0x0102_0304);
            }
            glide.execute(&Call::GrLfbUnlock { kind: 1, buffer: 1, written: None });
            glide.lfb_read_region(1, (0, 0), (320, 240)).expect("a buffer")
        };
        let plain = written(1);
        assert!(plain.iter().filter(|&&p| p != 0).count() > 500);
        assert!((2..=4).all(|scale| written(scale) == plain));
    }
}
