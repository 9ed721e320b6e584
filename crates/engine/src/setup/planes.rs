//! From registers to what the tiles iterate: edges and attribute planes in
//! screen coordinates.

use super::{Param, Registers, WideParam};
use crate::fixed::COORD_FRACTION;
use crate::kernel::texture::lod_base;
use crate::state::{MAX_TMUS, Origin, Rect};
use crate::target::STAMP;

/// A line of a triangle: a pixel is inside where `a * x + b * y + c >= 0`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Edge {
    pub a: i32,
    pub b: i32,
    pub c: i64,
}

impl Edge {
    /// The edge from `from` to `to` (12.4, rising y), pixels to its right
    /// inside (a centre on the line counts) or to its left (it does not).
    fn new(from: [i32; 2], to: [i32; 2], left: bool) -> Edge {
        let [dx, dy] = [to[0] - from[0], to[1] - from[1]].map(i64::from);
        let [px, py] = from.map(i64::from);
        // (xs - px) * dy - (ys - py) * dx at centres xs = 16x + 8, ys = 16y + 8.
        let constant = (8 - px) * dy - (8 - py) * dx;
        if left {
            Edge { a: (16 * dy) as i32, b: (-16 * dx) as i32, c: constant }
        } else {
            Edge { a: (-16 * dy) as i32, b: (16 * dx) as i32, c: -constant - 1 }
        }
    }

    /// The same edge with rows counted from the other end.
    fn flip(self, height: u32) -> Edge {
        let last = i64::from(height) - 1;
        Edge { a: self.a, b: -self.b, c: self.c + last * i64::from(self.b) }
    }

    pub fn at(&self, x: i32, y: i32) -> i64 {
        i64::from(self.a) * i64::from(x) + i64::from(self.b) * i64::from(y) + self.c
    }
}

/// How many 32-bit attributes are iterated together: the five that exist,
/// padded to a vector.
pub(crate) const NARROW: usize = 8;
/// Lane of z; red, green, blue and alpha are lanes 0 to 3.
pub(crate) const Z: usize = 4;

/// The 32-bit attributes: red, green, blue, alpha (12.12 in the top 24 bits)
/// and z (20.12). The value at screen pixel (x, y) is `c + x * dx + y * dy`,
/// wrapping.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Narrow {
    pub c: [i32; NARROW],
    pub dx: [i32; NARROW],
    pub dy: [i32; NARROW],
}

impl Narrow {
    /// All attributes at a pixel.
    #[inline(always)]
    pub fn at(&self, x: i32, y: i32) -> [i32; NARROW] {
        let mut out = self.c;
        for (i, out) in out.iter_mut().enumerate() {
            *out = out
                .wrapping_add(self.dx[i].wrapping_mul(x))
                .wrapping_add(self.dy[i].wrapping_mul(y));
        }
        out
    }

    /// One attribute at a pixel.
    #[inline(always)]
    pub fn value(&self, lane: usize, x: i32, y: i32) -> i32 {
        self.c[lane]
            .wrapping_add(self.dx[lane].wrapping_mul(x))
            .wrapping_add(self.dy[lane].wrapping_mul(y))
    }

    fn set(&mut self, lane: usize, [c, dx, dy]: [i32; 3]) {
        (self.c[lane], self.dx[lane], self.dy[lane]) = (c, dx, dy);
    }
}

/// A 64-bit attribute with 32 fraction bits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Plane64 {
    pub c: i64,
    pub dx: i64,
    pub dy: i64,
}

impl Plane64 {
    pub fn at(&self, x: i32, y: i32) -> i64 {
        self.c
            .wrapping_add(self.dx.wrapping_mul(i64::from(x)))
            .wrapping_add(self.dy.wrapping_mul(i64::from(y)))
    }

    /// Whether all values over `area` are below `limit` in magnitude, wrapping
    /// excluded.
    fn is_below(&self, start: f64, [x, y]: [f64; 2], area: &Rect, limit: f64) -> bool {
        let half = |a: u32, b: u32| (f64::from(b) - f64::from(a)) * 0.5;
        let (hx, hy) = (half(area.x0, area.x1), half(area.y0, area.y1));
        let (mx, my) = (f64::from(area.x0) + hx - x, f64::from(area.y0) + hy - y);
        let (dx, dy) = (self.dx as f64, self.dy as f64);
        (start + mx * dx + my * dy).abs() + dx.abs() * hx + dy.abs() * hy < limit
    }
}

/// A triangle ready for the tiles. Coordinates are screen pixels.
#[derive(Clone, Debug)]
pub(crate) struct Triangle {
    /// Every covered pixel of the surface lies inside; not empty.
    pub bounds: Rect,
    /// Index of the pipeline in the batch.
    pub state: u32,
    /// Edges in use.
    pub edge_count: u8,
    /// Whether w, and s, t, w of the units in use, are small enough over
    /// `bounds` to be iterated in floats exactly.
    pub exact: bool,
    /// First of its 64-bit planes in [`Triangles`].
    wide: u32,
    /// Level of detail of each unit at w = 1, without bias.
    pub lod_base: [i32; MAX_TMUS],
    pub edges: [Edge; 3],
    /// Colours and z.
    pub narrow: Narrow,
}

/// Triangles ready for the tiles, with their 64-bit planes: w of the pixel
/// pipeline, then s, t and w of each unit in use.
#[derive(Debug, Default)]
pub(crate) struct Triangles {
    pub list: Vec<Triangle>,
    wides: Vec<Plane64>,
}

impl Triangles {
    pub fn clear(&mut self) {
        self.list.clear();
        self.wides.clear();
    }

    /// w of the pixel pipeline.
    #[inline(always)]
    pub fn w(&self, triangle: &Triangle) -> &Plane64 {
        &self.wides[triangle.wide as usize]
    }

    /// s, t and w of a unit in use.
    #[inline(always)]
    pub fn unit<'a>(&'a self, triangle: &Triangle, unit: usize) -> [&'a Plane64; 3] {
        let first = triangle.wide as usize + 1 + 3 * unit;
        let [s, t, w] = &self.wides[first..first + 3] else { unreachable!("three planes") };
        [s, t, w]
    }

    /// Tells the processor that a triangle is needed soon.
    #[inline(always)]
    pub fn prefetch(&self, index: u32) {
        if let Some(triangle) = self.list.get(index as usize) {
            fillrate_simd::prefetch(triangle);
        }
    }
}

/// Where a triangle is drawn.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Screen {
    pub width: u32,
    pub height: u32,
    pub origin: Origin,
}

/// Limits below which f64 iteration and division are exact: s and t are
/// multiplied by 256 and must stay below 2^53, w keeps to the 48 bits it has.
const COORDINATE_LIMIT: f64 = (1u64 << 44) as f64;
const W_LIMIT: f64 = (1u64 << 46) as f64;

/// Converts a launched triangle and appends it to `out`; `None` where it covers
/// no pixel of the screen. `units` is how many texture units iterate.
pub(crate) fn prepare<'a>(
    registers: &Registers,
    screen: &Screen,
    state: u32,
    units: usize,
    out: &'a mut Triangles,
) -> Option<&'a Triangle> {
    let bounds = bounds(registers, screen)?;
    let planes = Corrected::new(registers, screen);
    let area = stamp_aligned(&bounds);
    let wide = out.wides.len() as u32;
    let mut exact = true;
    let mut add = |param: &WideParam, limit: f64| {
        let (plane, below) = planes.plane64(param, &area, limit);
        exact &= below;
        out.wides.push(plane);
        plane
    };
    add(&registers.w, W_LIMIT);
    let mut lod_base_of_unit = [0; MAX_TMUS];
    for (lod, [s, t, w]) in lod_base_of_unit.iter_mut().zip(&registers.tmu).take(units) {
        let (s, t) = (add(s, COORDINATE_LIMIT), add(t, COORDINATE_LIMIT));
        add(w, W_LIMIT);
        *lod = lod_base(&s, &t);
    }
    let mut triangle = Triangle {
        bounds,
        state,
        edge_count: 0,
        exact,
        wide,
        lod_base: lod_base_of_unit,
        edges: [Edge::default(); 3],
        narrow: planes.narrow(registers),
    };
    add_edges(&mut triangle, registers, screen);
    out.list.push(triangle);
    out.list.last()
}

fn add_edges(triangle: &mut Triangle, registers: &Registers, screen: &Screen) {
    let [a, b, c] = core::array::from_fn(|i| [registers.x[i], registers.y[i]]);
    // B left of A-C: A-C is the right edge, A-B and B-C are left ones.
    let minor_is_left = registers.negative;
    for (from, to, left) in [(a, c, !minor_is_left), (a, b, minor_is_left), (b, c, minor_is_left)] {
        if from[1] < to[1] {
            let edge = Edge::new(from, to, left);
            let edge =
                if screen.origin == Origin::LowerLeft { edge.flip(screen.height) } else { edge };
            triangle.edges[triangle.edge_count as usize] = edge;
            triangle.edge_count += 1;
        }
    }
}

/// The part of the screen that can be covered, or `None`.
fn bounds(registers: &Registers, screen: &Screen) -> Option<Rect> {
    let [ay, _, cy] = registers.y;
    let rows = [(ay + 7) >> COORD_FRACTION, (cy + 7) >> COORD_FRACTION];
    let left = registers.x.into_iter().min().unwrap_or(0);
    let right = registers.x.into_iter().max().unwrap_or(0);
    let columns = [(left + 7) >> COORD_FRACTION, (right + 7) >> COORD_FRACTION];
    let limit =
        |[from, to]: [i32; 2], size: u32| [from.clamp(0, size as i32), to.clamp(0, size as i32)];
    let [x0, x1] = limit(columns, screen.width);
    let height = screen.height as i32;
    let [y0, y1] = match screen.origin {
        Origin::UpperLeft => limit(rows, screen.height),
        Origin::LowerLeft => limit([height - rows[1], height - rows[0]], screen.height),
    };
    (x0 < x1 && y0 < y1).then(|| Rect::new(x0 as u32, y0 as u32, x1 as u32, y1 as u32))
}

/// The smallest rectangle of whole stamps around `area`.
fn stamp_aligned(area: &Rect) -> Rect {
    let down = |v: u32| v & !(STAMP - 1);
    let up = |v: u32| down(v + STAMP - 1);
    Rect::new(down(area.x0), down(area.y0), up(area.x1), up(area.y1))
}

/// The sub-pixel correction and the reference pixel of a launch.
struct Corrected {
    /// Sixteenths from the first vertex to its pixel's centre.
    dx: i32,
    dy: i32,
    /// The first vertex's pixel, on the screen.
    x: i32,
    y: i32,
    flipped: bool,
}

impl Corrected {
    fn new(registers: &Registers, screen: &Screen) -> Corrected {
        let (x, y) = (registers.x[0], registers.y[0]);
        let row = y >> COORD_FRACTION;
        let flipped = screen.origin == Origin::LowerLeft;
        Corrected {
            dx: 8 - (x & 15),
            dy: 8 - (y & 15),
            x: x >> COORD_FRACTION,
            y: if flipped { screen.height as i32 - 1 - row } else { row },
            flipped,
        }
    }

    fn narrow(&self, registers: &Registers) -> Narrow {
        let mut narrow = Narrow::default();
        for (lane, param) in registers.color.iter().enumerate() {
            narrow.set(lane, self.plane32(param).map(|value| value << 8));
        }
        narrow.set(Z, self.plane32(&registers.z));
        narrow
    }

    /// Constant and steps of a 32-bit attribute.
    fn plane32(&self, param: &Param) -> [i32; 3] {
        let moved = param.dx.wrapping_mul(self.dx).wrapping_add(param.dy.wrapping_mul(self.dy))
            >> COORD_FRACTION;
        let dy = if self.flipped { param.dy.wrapping_neg() } else { param.dy };
        let c = param
            .start
            .wrapping_add(moved)
            .wrapping_sub(param.dx.wrapping_mul(self.x))
            .wrapping_sub(dy.wrapping_mul(self.y));
        [c, param.dx, dy]
    }

    /// The plane, and whether it stays below `limit` over `area`.
    fn plane64(&self, param: &WideParam, area: &Rect, limit: f64) -> (Plane64, bool) {
        let moved = param
            .dx
            .wrapping_mul(i64::from(self.dx))
            .wrapping_add(param.dy.wrapping_mul(i64::from(self.dy)))
            >> COORD_FRACTION;
        let dy = if self.flipped { param.dy.wrapping_neg() } else { param.dy };
        let start = param.start.wrapping_add(moved);
        let c = start
            .wrapping_sub(param.dx.wrapping_mul(i64::from(self.x)))
            .wrapping_sub(dy.wrapping_mul(i64::from(self.y)));
        let plane = Plane64 { c, dx: param.dx, dy };
        let at = [f64::from(self.x), f64::from(self.y)];
        (plane, plane.is_below(start as f64, at, area, limit))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SCREEN: Screen = Screen { width: 64, height: 64, origin: Origin::UpperLeft };

    fn right_triangle() -> Registers {
        // (8.5, 8.5), (16.5, 8.5), (16.5, 16.5): the centres on the left edge
        // are in, on the right edge out.
        Registers {
            x: [136, 264, 264],
            y: [136, 136, 264],
            color: [Param { start: 7 << 12, dx: 16 << 12, dy: 0 }; 4],
            ..Registers::default()
        }
    }

    fn prepared(screen: &Screen) -> Triangle {
        let mut triangles = Triangles::default();
        prepare(&right_triangle(), screen, 0, 0, &mut triangles).unwrap().clone()
    }

    fn covered(triangle: &Triangle) -> u32 {
        let inside = |x: u32, y: u32| {
            triangle.edges[..triangle.edge_count as usize]
                .iter()
                .all(|edge| edge.at(x as i32, y as i32) >= 0)
        };
        let b = triangle.bounds;
        (b.y0..b.y1).map(|y| (b.x0..b.x1).filter(|&x| inside(x, y)).count() as u32).sum()
    }

    #[test]
    fn top_left_rule() {
        let triangle = prepared(&SCREEN);
        assert_eq!(triangle.bounds, Rect::new(8, 8, 16, 16));
        assert_eq!(covered(&triangle), 8 + 7 + 6 + 5 + 4 + 3 + 2 + 1);
    }

    #[test]
    fn planes_pass_through_the_first_vertex() {
        let triangle = prepared(&SCREEN);
        assert_eq!(triangle.narrow.value(0, 8, 8), 7 << 20);
        assert_eq!(triangle.narrow.value(0, 9, 30), (7 + 16) << 20);
    }

    #[test]
    fn lower_left_mirrors_rows() {
        let screen = Screen { origin: Origin::LowerLeft, ..SCREEN };
        let triangle = prepared(&screen);
        assert_eq!(triangle.bounds, Rect::new(8, 48, 16, 56));
        assert_eq!(covered(&triangle), 36);
        assert!(triangle.edges[0].at(8, 55) >= 0 && triangle.edges[0].at(8, 54) < 0);
    }
}
