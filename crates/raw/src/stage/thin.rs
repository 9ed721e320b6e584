//! Lines and points; beyond the thesis (RAW, chapter 6).
//!
//! A line has one pixel per step along its longer axis, from the first end (included) to the
//! second (not included), so that lines of a strip do not share a pixel. A point is a square.
//! Values along a line are interpolated with perspective, those of a point are its vertex's.

use super::emit::{Emitter, LANES, lane};
use super::raster::{RasterWork, Screen};
use super::{UntexFragment, Vertex};

/// Walks a line or a point.
#[derive(Clone, Debug)]
pub struct Thin {
    emitter: Emitter,
    ends: [Vertex; 2],
    kind: Kind,
    work: RasterWork,
}

#[derive(Clone, Debug)]
enum Kind {
    Line(Line),
    Square { left: i32, right: i32, x: i32, y: i32, bottom: i32 },
}

/// A line in steps along its longer axis.
#[derive(Clone, Debug)]
struct Line {
    along_x: bool,
    /// Where it begins, and how far it goes, along the longer axis.
    start: f32,
    length: f32,
    /// The same along the other axis.
    side: [f32; 2],
    /// The next step and the last.
    next: i32,
    last: i32,
    /// Size of the screen along the other axis.
    side_size: i32,
}

impl Thin {
    /// A line between two vertices after the divide.
    pub fn line(emitter: Emitter, ends: [Vertex; 2], screen: Screen) -> Self {
        let [a, b] = ends.each_ref().map(|v| screen.place(v));
        let along_x = (b[0] - a[0]).abs() >= (b[1] - a[1]).abs();
        let (main, side) = if along_x { (0, 1) } else { (1, 0) };
        let sizes = [screen.width as i32, screen.height as i32];
        // Pixel centres between the ends, whichever way the line runs; the second end is open.
        let (low, high) = if a[main] <= b[main] {
            (ceil(a[main] - 0.5), ceil(b[main] - 0.5).saturating_sub(1))
        } else {
            (floor(b[main] - 0.5).saturating_add(1), floor(a[main] - 0.5))
        };
        let line = Line {
            along_x,
            start: a[main],
            length: b[main] - a[main],
            side: [a[side], b[side] - a[side]],
            next: low.max(0),
            last: high.min(sizes[main] - 1),
            side_size: sizes[side],
        };
        Self { emitter, ends, kind: Kind::Line(line), work: RasterWork::default() }
    }

    /// A square of `size` pixels around a vertex after the divide.
    pub fn point(emitter: Emitter, at: Vertex, size: u32, screen: Screen) -> Self {
        let corner = screen.place(&at).map(|c| floor(c - size as f32 * 0.5 + 0.5));
        let end = |from: i32| from.saturating_add(size as i32 - 1);
        let kind = Kind::Square {
            left: corner[0].max(0),
            right: end(corner[0]).min(screen.width as i32 - 1),
            x: corner[0].max(0),
            y: corner[1].max(0),
            bottom: end(corner[1]).min(screen.height as i32 - 1),
        };
        Self { emitter, ends: [at, at], kind, work: RasterWork { rows: 1, ..Default::default() } }
    }

    /// What is interpolated.
    pub fn emitter(&self) -> &Emitter {
        &self.emitter
    }

    /// Returns and clears the work done so far.
    pub fn take_work(&mut self) -> RasterWork {
        std::mem::take(&mut self.work)
    }

    fn emit(&mut self, x: i32, y: i32, t: f32) -> UntexFragment {
        self.work.covered += 1;
        let [a, b] = &self.ends;
        let mix = |p: f32, q: f32| p + t * (q - p);
        let lanes: [f32; LANES] = std::array::from_fn(|i| mix(lane(a, i), lane(b, i)));
        self.emitter.fragment(x as u32, y as u32, mix(a.z, b.z), &lanes, None)
    }
}

impl Iterator for Thin {
    type Item = UntexFragment;

    fn next(&mut self) -> Option<UntexFragment> {
        let (x, y, t) = loop {
            self.work.visited += 1;
            match &mut self.kind {
                Kind::Line(line) => {
                    let (main, side, t) = line.step()?;
                    let inside = (0..line.side_size).contains(&side);
                    if inside {
                        break if line.along_x { (main, side, t) } else { (side, main, t) };
                    }
                }
                Kind::Square { left, right, x, y, bottom } => {
                    if *y > *bottom || *left > *right {
                        return None;
                    }
                    let here = (*x, *y, 0.0);
                    *x += 1;
                    if *x > *right {
                        (*x, *y) = (*left, *y + 1);
                    }
                    break here;
                }
            }
        };
        Some(self.emit(x, y, t))
    }
}

impl Line {
    /// The next pixel: along the longer axis, along the other, and how far along the line it is.
    fn step(&mut self) -> Option<(i32, i32, f32)> {
        if self.next > self.last {
            return None;
        }
        let main = self.next;
        self.next += 1;
        let t = (main as f32 + 0.5 - self.start) / self.length;
        Some((main, floor(self.side[0] + t * self.side[1]), t))
    }
}

fn floor(v: f32) -> i32 {
    v.floor() as i32
}

fn ceil(v: f32) -> i32 {
    v.ceil() as i32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::errata::Errata;
    use crate::state::ModeBits;

    const SCREEN: Screen = Screen { width: 16, height: 16 };

    /// A vertex at a place of the screen.
    fn at(x: f32, y: f32) -> Vertex {
        let ndc = |c: f32| c / 8.0 - 1.0;
        Vertex { x: ndc(x), y: ndc(y), w1: 1.0, rgba: [255.0; 4], ..Vertex::default() }
    }

    fn pixels(ends: [Vertex; 2]) -> Vec<(u32, u32)> {
        let emitter = Emitter::new(&ends, ModeBits::default(), &Errata::CORRECT);
        Thin::line(emitter, ends, SCREEN).map(|f| (f.x, f.y)).collect()
    }

    #[test]
    fn lines_are_half_open_and_cut_at_the_screen() {
        assert_eq!(pixels([at(1.5, 2.5), at(4.5, 2.5)]), [(1, 2), (2, 2), (3, 2)]);
        assert_eq!(pixels([at(4.5, 2.5), at(1.5, 2.5)]), [(2, 2), (3, 2), (4, 2)]);
        assert_eq!(pixels([at(2.5, 1.5), at(2.5, 3.5)]), [(2, 1), (2, 2)]);
        assert_eq!(pixels([at(0.5, 0.5), at(3.5, 3.5)]), [(0, 0), (1, 1), (2, 2)]);
        assert_eq!(pixels([at(-99.0, 4.5), at(99.0, 4.5)]).len(), 16);
        assert!(pixels([at(3.5, 3.5), at(3.5, 3.5)]).is_empty());
        assert!(pixels([at(f32::NAN, 3.5), at(3.5, f32::INFINITY)]).len() <= 16);
    }

    #[test]
    fn points_are_squares() {
        let squares = |size, v: Vertex| {
            let emitter = Emitter::new(&[v], ModeBits::default(), &Errata::CORRECT);
            Thin::point(emitter, v, size, SCREEN).map(|f| (f.x, f.y)).collect::<Vec<_>>()
        };
        assert_eq!(squares(1, at(3.2, 4.9)), [(3, 4)]);
        assert_eq!(squares(2, at(3.0, 3.0)), [(2, 2), (3, 2), (2, 3), (3, 3)]);
        assert_eq!(squares(64, at(8.0, 8.0)).len(), 256);
        assert!(squares(3, at(-8.0, 8.0)).is_empty());
    }
}
