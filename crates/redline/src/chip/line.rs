//! Lines, dots and spans: pixels one by one along the longer axis, each a
//! triangle that covers that pixel alone, so that they pass the whole pipeline
//! with exact values.
//!
//! Source: RR, primitives; which pixels is ours.

use super::VeriteChip;
use super::draw::Mode;
use super::setup::{ALPHA, Corner, Values};
use super::translate;
use crate::vertex::{Attribute, Layout, VertexType};

/// Half a pixel in 16.16.
const HALF: i64 = 0x8000;
/// A pixel in 16.16.
const ONE: i64 = 0x1_0000;

/// A line seen along its longer axis.
#[derive(Clone, Copy, Debug)]
struct Walk {
    /// Along the longer axis and across it, 16.16.
    from: [i64; 2],
    to: [i64; 2],
    /// The longer axis is y.
    steep: bool,
}

impl Walk {
    fn new(from: [i64; 2], to: [i64; 2]) -> Walk {
        let [dx, dy] = [to[0] - from[0], to[1] - from[1]].map(i64::abs);
        let steep = dy > dx;
        let turn = |[x, y]: [i64; 2]| if steep { [y, x] } else { [x, y] };
        Walk { from: turn(from), to: turn(to), steep }
    }

    fn forward(&self) -> bool {
        self.to[0] >= self.from[0]
    }

    /// The pixels along the longer axis whose centres lie from the start, which
    /// counts, to the end, which does not: the first, and how many.
    fn pixels(&self) -> (i64, i64) {
        let (from, to) = (self.from[0], self.to[0]);
        // The first pixel whose centre is at or after a place.
        let at_or_after = |place: i64| (place - HALF + ONE - 1).div_euclid(ONE);
        if self.forward() {
            let first = at_or_after(from);
            (first, at_or_after(to) - first)
        } else {
            let first = (from - HALF).div_euclid(ONE);
            (first, first - (to - HALF).div_euclid(ONE))
        }
    }

    /// The steps whose pixels lie from `low` to before `high`.
    fn visible(&self, low: u32, high: u32) -> std::ops::Range<i64> {
        let (first, count) = self.pixels();
        let (low, high) = (i64::from(low), i64::from(high));
        let (start, end) = match self.forward() {
            true => (low - first, high - first),
            false => (first - high + 1, first - low + 1),
        };
        start.clamp(0, count.max(0))..end.clamp(0, count.max(0))
    }

    /// The pixel of a step along the longer axis.
    fn pixel(&self, step: i64) -> i64 {
        let (first, _) = self.pixels();
        if self.forward() { first + step } else { first - step }
    }

    /// How far along the line a pixel's centre is, as a fraction.
    fn fraction(&self, pixel: i64) -> f64 {
        let (along, whole) = (pixel * ONE + HALF - self.from[0], self.to[0] - self.from[0]);
        along as f64 / whole as f64
    }

    /// Where the line is across, at the centre of a pixel along.
    fn across(&self, pixel: i64) -> i64 {
        let (along, whole) = (pixel * ONE + HALF - self.from[0], self.to[0] - self.from[0]);
        // Both have 17 bits before and 16 behind the point.
        let change = i128::from(self.to[1] - self.from[1]) * i128::from(along * whole.signum());
        match whole.abs() {
            0 => self.from[1],
            whole => self.from[1] + change.div_euclid(i128::from(whole)) as i64,
        }
    }

    /// Column and row of a pixel along and across.
    fn turned(&self, along: i64, across: i64) -> [i64; 2] {
        if self.steep { [across, along] } else { [along, across] }
    }
}

/// A vertex's place, 16.16.
fn place(layout: &Layout, words: &[u32]) -> [i64; 2] {
    let at = |attribute| i64::from(layout.get(words, attribute).unwrap_or(0) as i32);
    [at(Attribute::X), at(Attribute::Y)]
}

impl VeriteChip {
    /// Ends of a line, read.
    fn ends(&self, layout: &Layout, words: [&[u32]; 2]) -> Option<[Corner; 2]> {
        let prepared = self.prepared.as_ref()?;
        Some(words.map(|words| prepared.attributes.read(layout, words, true)))
    }

    /// The visible steps of a walk.
    fn steps(&self, walk: &Walk) -> std::ops::Range<i64> {
        let Some(prepared) = &self.prepared else { return 0..0 };
        let scissor = prepared.scissor;
        match walk.steep {
            true => walk.visible(scissor.y0, scissor.y1),
            false => walk.visible(scissor.x0, scissor.x1),
        }
    }

    /// Draws a pixel, or what the pattern has in its place: `step` counts along
    /// the line.
    fn patterned(&mut self, mode: Mode, [x, y]: [i64; 2], step: i64, values: &Values) {
        use crate::opcode::Register::PatEnable;
        if !self.state.is_set(PatEnable) || translate::pattern_draws(&self.state, step as u32) {
            return self.pixel(mode, x, y, values);
        }
        let Some(argb) = translate::pattern_background(&self.state) else { return };
        let mut values = *values;
        for (channel, shift) in [16, 8, 0, 24].into_iter().enumerate() {
            values.narrow[channel] = f64::from((argb >> shift & 0xff) << 12);
        }
        self.pixel(Mode::Plain { textured: false, perspective: false }, x, y, &values);
    }

    /// `V_FIFO_DOT`: the pixel that holds the vertex.
    pub(super) fn dot(&mut self, layout: &'static Layout, words: &[u32]) {
        if self.prepare().is_none() {
            return;
        }
        let mode = self.stepped_mode(layout, false);
        let Some(prepared) = &self.prepared else { return };
        let values = Values::from(&prepared.attributes.read(layout, words, true));
        let [x, y] = place(layout, words).map(|v| v >> 16);
        self.pixel(mode, x, y, &values);
    }

    /// `V_FIFO_LINE`: a pixel for each column, or row of steep lines, whose
    /// centre lies between the ends; the first end counts, the second does not.
    pub(super) fn line(&mut self, layout: &'static Layout, words: [&[u32]; 2]) {
        if self.prepare().is_none() {
            return;
        }
        let mode = self.stepped_mode(layout, false);
        let Some([a, b]) = self.ends(layout, words) else { return };
        let walk = Walk::new(place(layout, words[0]), place(layout, words[1]));
        for step in self.steps(&walk) {
            let along = walk.pixel(step);
            let values = Values::between(&a, &b, walk.fraction(along));
            let at = walk.turned(along, walk.across(along) >> 16);
            self.patterned(mode, at, step, &values);
        }
    }

    /// `V_FIFO_INTLINE`: Bresenham between pixels; halves round away from the
    /// start.
    pub(super) fn int_line(&mut self, last: bool, from: u32, to: u32) {
        let Some(prepared) = self.prepare() else { return };
        let values = Values::from(&prepared.attributes.corner([0, 0], [0, 0]));
        let scissor = prepared.scissor;
        let mode = Mode::Plain { textured: false, perspective: false };
        let point = |word: u32| [i64::from(word >> 16), i64::from(word & 0xffff)];
        let ([x0, y0], [x1, y1]) = (point(from), point(to));
        let (dx, dy) = (x1 - x0, y1 - y0);
        let steps = dx.abs().max(dy.abs());
        let at = |start: i64, d: i64, step: i64| match steps {
            0 => start,
            _ => start + d.signum() * ((2 * step * d.abs() + steps) / (2 * steps)),
        };
        let beyond = |v: i64, d: i64, low: u32, high: u32| {
            (v >= i64::from(high) && d >= 0) || (v < i64::from(low) && d <= 0)
        };
        for step in 0..steps + i64::from(last) {
            let (x, y) = (at(x0, dx, step), at(y0, dy, step));
            if beyond(x, dx, scissor.x0, scissor.x1) || beyond(y, dy, scissor.y0, scissor.y1) {
                return;
            }
            self.patterned(mode, [x, y], step, &values);
        }
    }

    /// `V_FIFO_INTPOLYLINE`: the flag says whether the last pixel of the last
    /// line is drawn; joints are drawn once.
    pub(super) fn int_polyline(&mut self, last: bool, points: &[u32]) {
        for (i, two) in points.windows(2).enumerate() {
            self.int_line(last && i + 2 == points.len(), two[0], two[1]);
        }
    }

    /// Draws a pixel whose alpha is multiplied by its coverage.
    fn covered(&mut self, mode: Mode, [x, y]: [i64; 2], coverage: f64, values: &Values) {
        use translate::SourceFunction;
        let replaced = matches!(mode, Mode::Coverage { textured: true, .. })
            && self.prepared.as_ref().is_some_and(|p| p.function == SourceFunction::Replace);
        let mut values = *values;
        // The texture's alpha is the only one there: the iterated one is free.
        let alpha = if replaced { f64::from(255 << 12) } else { values.narrow[ALPHA] };
        values.narrow[ALPHA] = alpha * coverage;
        self.pixel(mode, x, y, &values);
    }

    /// `V_FIFO_AALINE`: one pixel wide, shared by the two pixels across.
    pub(super) fn antialiased_line(&mut self, layout: &'static Layout, words: [&[u32]; 2]) {
        if self.prepare().is_none() {
            return;
        }
        let mode = self.stepped_mode(layout, true);
        let Some([a, b]) = self.ends(layout, words) else { return };
        let walk = Walk::new(place(layout, words[0]), place(layout, words[1]));
        for step in self.steps(&walk) {
            let along = walk.pixel(step);
            let values = Values::between(&a, &b, walk.fraction(along));
            let across = walk.across(along) - HALF;
            let (first, share) = (across >> 16, (across & 0xffff) as f64 / 65536.0);
            self.covered(mode, walk.turned(along, first), 1.0 - share, &values);
            if share > 0.0 {
                self.covered(mode, walk.turned(along, first + 1), share, &values);
            }
        }
    }

    /// `V_FIFO_AAEDGE`: the polygon is on the right of the edge's direction. Of
    /// pixels whose centre is outside it, the part inside is blended over what
    /// is there.
    pub(super) fn antialiased_edge(&mut self, layout: &'static Layout, words: [&[u32]; 2]) {
        if self.prepare().is_none() {
            return;
        }
        let mode = self.stepped_mode(layout, true);
        let Some([a, b]) = self.ends(layout, words) else { return };
        let walk = Walk::new(place(layout, words[0]), place(layout, words[1]));
        // To the right of rightwards is down, of downwards left.
        let inside_after = walk.forward() != walk.steep;
        for step in self.steps(&walk) {
            let along = walk.pixel(step);
            let edge = walk.across(along);
            let (pixel, inside) = match inside_after {
                true => {
                    let pixel = (edge - HALF - 1).div_euclid(ONE);
                    (pixel, (pixel + 1) * ONE - edge)
                }
                false => {
                    let pixel = (edge - HALF).div_euclid(ONE) + 1;
                    (pixel, edge - pixel * ONE)
                }
            };
            if inside > 0 {
                let values = Values::between(&a, &b, walk.fraction(along));
                let at = walk.turned(along, pixel);
                self.covered(mode, at, inside as f64 / ONE as f64, &values);
            }
        }
    }

    /// `V_FIFO_SPAN`: pixels to the right of the start vertex; X of the second
    /// vertex says how many, its other words are the steps, channel by channel
    /// for packed colours.
    pub(super) fn span(&mut self, layout: &'static Layout, start: &[u32], delta: &[u32]) {
        let Some(prepared) = self.prepare() else { return };
        let scissor = prepared.scissor;
        let mode = self.stepped_mode(layout, false);
        let [x, y] = place(layout, start).map(|v| v >> 16);
        let [count, _] = place(layout, delta).map(|v| v >> 16);
        let first = (i64::from(scissor.x0) - x).max(0);
        let end = (i64::from(scissor.x1) - x).min(count);
        let mut words = start.to_vec();
        for step in first..end {
            advance(layout, &mut words, start, delta, step as u32);
            let Some(prepared) = &self.prepared else { return };
            let values = Values::from(&prepared.attributes.read(layout, &words, true));
            self.pixel(mode, x + step, y, &values);
        }
    }

    /// `V_FIFO_WARP`: every pixel has its own U and V.
    pub(super) fn warp(&mut self, words: &[u32]) {
        if self.prepare().is_none() {
            return;
        }
        let mode = self.stepped_mode(VertexType::XYUV.layout(), false);
        let [at, size, u, v] = [words[0], words[1], words[2], words[3]];
        let (x, y) = (i64::from(at >> 16), i64::from(at & 0xffff));
        let width = (size >> 16) as usize;
        let pairs = words[4..].as_chunks::<2>().0;
        for (row, pairs) in pairs.chunks(width.max(1)).enumerate() {
            for (column, [pu, pv]) in pairs.iter().enumerate() {
                let Some(prepared) = &self.prepared else { return };
                let (u, v) = (u.wrapping_add(*pu), v.wrapping_add(*pv));
                let values = Values::from(&prepared.attributes.corner([0, 0], [u, v]));
                self.pixel(mode, x + column as i64, y + row as i64, &values);
            }
        }
    }
}

/// The words of a span's pixel: start plus so many steps.
fn advance(layout: &Layout, words: &mut [u32], start: &[u32], delta: &[u32], step: u32) {
    let packed = [Attribute::K, Attribute::Ka, Attribute::S, Attribute::Sf];
    let packed = packed.map(|attribute| layout.word(attribute));
    for (i, word) in words.iter_mut().enumerate() {
        *word = if packed.contains(&Some(i)) {
            let channel = |at: usize| {
                let (start, delta) = (start[i].to_le_bytes()[at], delta[i].to_le_bytes()[at] as i8);
                (i64::from(start) + i64::from(delta) * i64::from(step)).clamp(0, 255) as u8
            };
            u32::from_le_bytes([0, 1, 2, 3].map(channel))
        } else {
            start[i].wrapping_add(delta[i].wrapping_mul(step))
        };
    }
}
