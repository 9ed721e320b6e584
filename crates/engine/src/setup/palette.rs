//! Set-up of the Quark profile: whole pixels, exact edges, planes with 16
//! fraction bits.
//!
//! Samples are taken at whole coordinates. Rows run from the least y to below
//! the greatest, columns from the left edge, included, to the right edge,
//! excluded. A plane's value at the top-left pixel of the part on the screen
//! and its two gradients are rounded down from the exact quotients; all other
//! values are sums of these.
//!
//! Source: QK, triangles; `docs/sources.md`, Quark 3D.

use super::planes::{Edge, Plane64};
use crate::state::Rect;

/// Greatest magnitude of a coordinate, in pixels; what reaches further is not
/// drawn.
pub const PALETTE_COORDINATE: i32 = 1 << 20;
/// Fraction bits of the planes.
const FRACTION: u32 = 16;
/// Added to depth, so that what truncation of the gradients takes never leads
/// out of the 16 bits.
const HALF: i64 = 1 << (FRACTION - 1);

/// A 32-bit attribute: its value at screen pixel (x, y) is `c + x * dx +
/// y * dy`, wrapping.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Plane32 {
    pub c: i32,
    pub dx: i32,
    pub dy: i32,
}

impl Plane32 {
    pub fn at(&self, x: i32, y: i32) -> i32 {
        self.c.wrapping_add(self.dx.wrapping_mul(x)).wrapping_add(self.dy.wrapping_mul(y))
    }
}

/// A corner of a primitive of the Quark profile.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PaletteVertex {
    /// Column.
    pub x: i32,
    /// Row, from the top.
    pub y: i32,
    /// Depth; greater is nearer.
    pub depth: u16,
    /// Light, limited to 0..=255 fragment by fragment.
    pub intensity: i16,
    /// Texture column; 256 is one repeat.
    pub u: u16,
    /// Texture row.
    pub v: u16,
}

/// Something to draw with the Quark profile.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PalettePrimitive {
    /// A triangle, either way round.
    Triangle {
        /// The corners.
        corners: [PaletteVertex; 3],
        /// Base colour, where it is not the texel's.
        color: u8,
        /// Whether texture coordinates are divided by depth at each fragment.
        perspective: bool,
    },
    /// A line of one pixel across, both ends included, at the intensity of the
    /// first; half-way cases go to the greater coordinate. Untextured.
    Line {
        /// The ends.
        ends: [PaletteVertex; 2],
        /// Base colour.
        color: u8,
    },
    /// A rectangle of constant depth and intensity.
    Rect {
        /// First column and row.
        at: [i32; 2],
        /// Columns and rows.
        size: [u32; 2],
        /// Texel of the first fragment, 16 fraction bits.
        texel: [u32; 2],
        /// Texels from column to column and from row to row, 16 fraction bits.
        step: [u32; 2],
        /// Depth.
        depth: u16,
        /// Light, 0..=255.
        intensity: u8,
        /// Base colour, where it is not the texel's.
        color: u8,
    },
}

/// How a shape finds its texels.
#[derive(Clone, Debug)]
pub(crate) enum Texels {
    /// Coordinate planes, 16 fraction bits, of 1/2^scale repeats; scale 0 is
    /// texels.
    Affine { planes: [Plane32; 2], scale: u32 },
    /// u and v over z, and 1/z; `exact` where floats hold them over the bounds.
    Perspective { planes: [Plane64; 3], exact: bool },
}

/// A primitive ready for the tiles.
#[derive(Clone, Debug)]
pub(crate) struct Shape {
    /// Index of its state in the arena.
    pub state: u32,
    pub edge_count: u32,
    pub edges: [Edge; 3],
    /// The part on the screen that can be covered; not empty.
    pub bounds: Rect,
    /// Base colour, where it is not the texel's.
    pub color: u8,
    /// 16.16, unsigned.
    pub depth: Plane32,
    /// The same without wrapping, for bounds.
    depth_plane: Plane64,
    /// Least and greatest depth of all fragments.
    depth_range: (u16, u16),
    /// 16.16.
    pub intensity: Plane32,
    pub texels: Texels,
}

impl Shape {
    pub fn edges(&self) -> &[Edge] {
        &self.edges[..self.edge_count as usize]
    }

    /// Least and greatest depth that fragments inside `area` can have.
    pub fn depth_range(&self, area: &Rect) -> (u16, u16) {
        let (low, high) = self.depth_range;
        let plane = &self.depth_plane;
        if low == high {
            return (low, high);
        }
        let corner = plane.at(area.x0 as i32, area.y0 as i32);
        let (right, down) = (i64::from(area.x1 - area.x0 - 1), i64::from(area.y1 - area.y0 - 1));
        // Gradients of slivers can be anything.
        let (dx, dy) = (plane.dx.saturating_mul(right), plane.dy.saturating_mul(down));
        let least = corner.saturating_add(dx.min(0)).saturating_add(dy.min(0)) >> FRACTION;
        let most = corner.saturating_add(dx.max(0)).saturating_add(dy.max(0)) >> FRACTION;
        let limit = |depth: i64| depth.clamp(low.into(), high.into()) as u16;
        (limit(least), limit(most))
    }

    fn set_depth(&mut self, plane: Plane64, range: (u16, u16)) {
        self.depth = Plane32 { c: plane.c as i32, dx: plane.dx as i32, dy: plane.dy as i32 };
        self.depth_plane = plane;
        self.depth_range = range;
    }

    fn add_edge(&mut self, a: i64, b: i64, c: i64) {
        self.edges[self.edge_count as usize] = Edge { a: a as i32, b: b as i32, c };
        self.edge_count += 1;
    }

    /// A shape without edges, with the same value everywhere.
    fn rect(state: u32, bounds: Rect, depth: u16, intensity: i16) -> Shape {
        let constant = |value: i64| Plane32 { c: value as i32, dx: 0, dy: 0 };
        Shape {
            state,
            edge_count: 0,
            edges: [Edge::default(); 3],
            bounds,
            color: 0,
            depth: constant(i64::from(depth) << FRACTION),
            depth_plane: Plane64 { c: i64::from(depth) << FRACTION, dx: 0, dy: 0 },
            depth_range: (depth, depth),
            intensity: constant(i64::from(intensity) << FRACTION),
            texels: Texels::Affine { planes: [Plane32::default(); 2], scale: 0 },
        }
    }
}

/// Sets a primitive up; `None` where it covers nothing of `screen`.
pub(crate) fn prepare_palette(
    primitive: &PalettePrimitive,
    screen: &Rect,
    state: u32,
    textured: bool,
) -> Option<Shape> {
    match primitive {
        PalettePrimitive::Triangle { corners, color, perspective } => {
            let shape = triangle(corners, textured, *perspective, screen, state)?;
            Some(Shape { color: *color, ..shape })
        }
        PalettePrimitive::Line { ends, color } => {
            Some(Shape { color: *color, ..line(ends, screen, state)? })
        }
        PalettePrimitive::Rect { at, size, texel, step, depth, intensity, color } => {
            let end = |i: usize| i64::from(at[i]) + i64::from(size[i]);
            let bounds = visible([at[0].into(), at[1].into()], [end(0), end(1)], screen)?;
            let mut shape = Shape::rect(state, bounds, *depth, i16::from(*intensity));
            let plane = |axis: usize, dx: i32, dy: i32| {
                let moved = (step[axis] as i32).wrapping_mul(at[axis]);
                Plane32 { c: (texel[axis] as i32).wrapping_sub(moved), dx, dy }
            };
            let planes = [plane(0, step[0] as i32, 0), plane(1, 0, step[1] as i32)];
            shape.texels = Texels::Affine { planes, scale: 0 };
            shape.color = *color;
            Some(shape)
        }
    }
}

/// The part of a rectangle (last column and row excluded) on the screen.
fn visible(first: [i64; 2], end: [i64; 2], screen: &Rect) -> Option<Rect> {
    let x = |x: i64| x.clamp(screen.x0.into(), screen.x1.into()) as u32;
    let y = |y: i64| y.clamp(screen.y0.into(), screen.y1.into()) as u32;
    let rect = Rect::new(x(first[0]), y(first[1]), x(end[0]), y(end[1]));
    (!rect.is_empty()).then_some(rect)
}

/// The position of a vertex that is not too far away.
fn position(vertex: &PaletteVertex) -> Option<[i64; 2]> {
    let allowed = -PALETTE_COORDINATE..=PALETTE_COORDINATE;
    let inside = allowed.contains(&vertex.x) && allowed.contains(&vertex.y);
    inside.then(|| [vertex.x.into(), vertex.y.into()])
}

fn least_and_greatest(values: impl Iterator<Item = i64> + Clone) -> (i64, i64) {
    (values.clone().min().unwrap_or(0), values.max().unwrap_or(0))
}

fn triangle(
    corners: &[PaletteVertex; 3],
    textured: bool,
    perspective: bool,
    screen: &Rect,
    state: u32,
) -> Option<Shape> {
    let at = [position(&corners[0])?, position(&corners[1])?, position(&corners[2])?];
    let (left, right) = least_and_greatest(at.iter().map(|p| p[0]));
    let (top, bottom) = least_and_greatest(at.iter().map(|p| p[1]));
    let bounds = visible([left, top], [right, bottom], screen)?;
    let planes = Planes::new(&at, &bounds)?;
    let mut shape = Shape::rect(state, bounds, 0, 0);
    let depths = corners.map(|v| i64::from(v.depth));
    let (low, high) = least_and_greatest(depths.into_iter());
    let mut plane = planes.plane_from(planes.solve(depths));
    plane.c = plane.c.wrapping_add(HALF);
    shape.set_depth(plane, (low as u16, high as u16));
    shape.intensity = planes.plane32(corners.map(|v| v.intensity.into()));
    if textured {
        let (u, v) = (corners.map(|v| i64::from(v.u)), corners.map(|v| i64::from(v.v)));
        shape.texels = if perspective {
            let over_z = |c: [i64; 3]| core::array::from_fn(|i| c[i] * depths[i]);
            let made = [over_z(u), over_z(v), depths].map(|values| planes.plane64(values));
            let exact = made.iter().all(|(_, exact)| *exact);
            Texels::Perspective { planes: made.map(|(plane, _)| plane), exact }
        } else {
            Texels::Affine { planes: [planes.plane32(u), planes.plane32(v)], scale: 8 }
        };
    }
    add_edges(&mut shape, &at);
    Some(shape)
}

fn add_edges(shape: &mut Shape, at: &[[i64; 2]; 3]) {
    for i in 0..3 {
        let (from, to, other) = (at[i], at[(i + 1) % 3], at[(i + 2) % 3]);
        let (from, to) = if from[1] < to[1] { (from, to) } else { (to, from) };
        if from[1] == to[1] {
            // Rows are limited by the bounds.
            continue;
        }
        let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
        let c = dx * from[1] - dy * from[0];
        // At least 0 to the right of the edge.
        let side = dy * other[0] - dx * other[1] + c;
        if side > 0 { shape.add_edge(dy, -dx, c) } else { shape.add_edge(-dy, dx, -c - 1) }
    }
}

/// What all planes of a triangle share.
struct Planes {
    /// From the first corner to the two others.
    d1: [i64; 2],
    d2: [i64; 2],
    /// Twice the area, made positive by `sign`, and about one over it.
    area: i64,
    inverse: f64,
    sign: i64,
    /// From the first corner to the reference pixel.
    to_reference: [i64; 2],
    reference: [i64; 2],
    /// The bounds' size.
    extent: [f64; 2],
    /// Whether all products fit 64 bits.
    narrow: bool,
}

impl Planes {
    fn new(at: &[[i64; 2]; 3], bounds: &Rect) -> Option<Planes> {
        let from_first = |p: [i64; 2]| [p[0] - at[0][0], p[1] - at[0][1]];
        let (d1, d2) = (from_first(at[1]), from_first(at[2]));
        let area = d1[0] * d2[1] - d2[0] * d1[1];
        let reference = [i64::from(bounds.x0), i64::from(bounds.y0)];
        let narrow = at.iter().flatten().all(|n| (-4096..=4096).contains(n))
            && reference.iter().all(|&n| n <= 4096);
        let size = |a: u32, b: u32| f64::from(b - a) + 8.0;
        (area != 0).then(|| Planes {
            d1,
            d2,
            area: area.abs(),
            inverse: 1.0 / area.abs() as f64,
            sign: area.signum(),
            to_reference: from_first(reference),
            reference,
            extent: [size(bounds.x0, bounds.x1), size(bounds.y0, bounds.y1)],
            narrow,
        })
    }

    /// Value at the reference pixel and both gradients, rounded down to 16
    /// fraction bits; the low 64 bits of each. Values of the corners are below
    /// 2^32 in magnitude.
    fn solve(&self, [a, b, c]: [i64; 3]) -> [i64; 3] {
        if a == b && a == c {
            return [a << FRACTION, 0, 0];
        }
        let (ab, ac) = (b - a, c - a);
        let dx = (ab * self.d2[1] - ac * self.d1[1]) * self.sign;
        let dy = (ac * self.d1[0] - ab * self.d2[0]) * self.sign;
        let [x, y] = self.to_reference;
        if self.narrow {
            // Products of 2^33, 2^13 and 2^13, two of them, and a of 2^32
            // times an area of 2^27: below 2^62.
            return [self.ratio(a * self.area + dx * x + dy * y), self.ratio(dx), self.ratio(dy)];
        }
        let wide = |n: i64, by: i64| i128::from(n) * i128::from(by);
        let value = wide(a, self.area) + wide(dx, x) + wide(dy, y);
        [self.wide_ratio(value), self.wide_ratio(dx.into()), self.wide_ratio(dy.into())]
    }

    /// `floor(2^16 * n / area)`, the low 64 bits.
    fn ratio(&self, n: i64) -> i64 {
        if n.abs() < 1 << (62 - FRACTION) {
            return self.floor_quotient(n << FRACTION);
        }
        let rest = (n.rem_euclid(self.area) << FRACTION) / self.area;
        (n.div_euclid(self.area) << FRACTION).wrapping_add(rest)
    }

    /// `floor(n / area)`: an estimate in floats, which is off by one at most
    /// where the quotient has fewer bits than a float, and its remainder.
    fn floor_quotient(&self, n: i64) -> i64 {
        let estimate = (n as f64 * self.inverse) as i64;
        let rest = n.wrapping_sub(estimate.wrapping_mul(self.area));
        if (0..self.area).contains(&rest) {
            estimate
        } else if (-self.area..0).contains(&rest) {
            estimate - 1
        } else {
            n.div_euclid(self.area)
        }
    }

    fn wide_ratio(&self, n: i128) -> i64 {
        let area = i128::from(self.area);
        let rest = (n.rem_euclid(area) << FRACTION) / area;
        (n.div_euclid(area) << FRACTION).wrapping_add(rest) as i64
    }

    /// A plane from its value at the reference pixel and its gradients.
    fn plane_from(&self, [value, dx, dy]: [i64; 3]) -> Plane64 {
        let [x, y] = self.reference;
        let c = value.wrapping_sub(dx.wrapping_mul(x)).wrapping_sub(dy.wrapping_mul(y));
        Plane64 { c, dx, dy }
    }

    /// The low 32 bits of a plane. Values at covered fragments fit, so that
    /// wrapping on the way there does no harm.
    fn plane32(&self, corners: [i64; 3]) -> Plane32 {
        let Plane64 { c, dx, dy } = self.plane_from(self.solve(corners));
        Plane32 { c: c as i32, dx: dx as i32, dy: dy as i32 }
    }

    /// A plane, and whether its sums are exact in floats over the bounds.
    fn plane64(&self, corners: [i64; 3]) -> (Plane64, bool) {
        let solved = self.solve(corners);
        let [value, dx, dy] = solved.map(|n| (n as f64).abs());
        let most = value + dx * self.extent[0] + dy * self.extent[1];
        (self.plane_from(solved), most < (1u64 << 52) as f64)
    }
}

fn line(ends: &[PaletteVertex; 2], screen: &Rect, state: u32) -> Option<Shape> {
    let intensity = ends[0].intensity;
    let (mut a, mut b) = (ends[0], ends[1]);
    let (pa, pb) = (position(&a)?, position(&b)?);
    let flat = (pb[0] - pa[0]).abs() >= (pb[1] - pa[1]).abs();
    let major = usize::from(!flat);
    let (pa, pb) = if pa[major] <= pb[major] {
        (pa, pb)
    } else {
        core::mem::swap(&mut a, &mut b);
        (pb, pa)
    };
    let (left, right) = least_and_greatest([pa[0], pb[0]].into_iter());
    let (top, bottom) = least_and_greatest([pa[1], pb[1]].into_iter());
    let bounds = visible([left, top], [right + 1, bottom + 1], screen)?;
    let mut shape = Shape::rect(state, bounds, a.depth, intensity);
    let length = pb[major] - pa[major];
    if length == 0 {
        return Some(shape);
    }
    let depth = line_depth([a.depth, b.depth], length, pa[major], major, &bounds);
    shape.set_depth(depth, (a.depth.min(b.depth), a.depth.max(b.depth)));
    // Twice the distance from the line, in units of 1/length, along the minor
    // axis: at least -length, below length.
    let rise = pb[1 - major] - pa[1 - major];
    let (x, y) = if flat { (2 * rise, -2 * length) } else { (-2 * length, 2 * rise) };
    let c = -(x * pa[0] + y * pa[1]);
    shape.add_edge(x, y, c + length);
    shape.add_edge(-x, -y, -c + length - 1);
    Some(shape)
}

/// The depth plane of a line from `from` on along axis `major`.
fn line_depth([a, b]: [u16; 2], length: i64, from: i64, major: usize, bounds: &Rect) -> Plane64 {
    let rise = i64::from(b) - i64::from(a);
    let reference = i64::from([bounds.x0, bounds.y0][major]);
    let value = i64::from(a) * length + rise * (reference - from);
    let value = (value << FRACTION).div_euclid(length) + HALF;
    let step = (rise << FRACTION).div_euclid(length);
    let c = value.wrapping_sub(step.wrapping_mul(reference));
    if major == 0 { Plane64 { c, dx: step, dy: 0 } } else { Plane64 { c, dx: 0, dy: step } }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SCREEN: Rect = Rect::new(0, 0, 64, 48);

    fn vertex(x: i32, y: i32, depth: u16) -> PaletteVertex {
        PaletteVertex { x, y, depth, ..PaletteVertex::default() }
    }

    fn covered(shape: &Shape) -> Vec<(i32, i32)> {
        let b = shape.bounds;
        let pixels = (b.y0..b.y1).flat_map(|y| (b.x0..b.x1).map(move |x| (x as i32, y as i32)));
        pixels.filter(|&(x, y)| shape.edges().iter().all(|e| e.at(x, y) >= 0)).collect()
    }

    fn draw(primitive: PalettePrimitive) -> Option<Shape> {
        prepare_palette(&primitive, &SCREEN, 0, false)
    }

    fn draw_triangle(corners: [PaletteVertex; 3]) -> Option<Shape> {
        draw(PalettePrimitive::Triangle { corners, color: 0, perspective: false })
    }

    #[test]
    fn halves_of_a_square_cover_it_once() {
        let (a, b, c, d) = (vertex(3, 2, 9), vertex(13, 2, 9), vertex(13, 12, 9), vertex(3, 12, 9));
        let one = covered(&draw_triangle([a, b, c]).unwrap());
        let two = covered(&draw_triangle([d, a, c]).unwrap());
        assert_eq!(one.len() + two.len(), 100);
        assert!(one.iter().all(|p| !two.contains(p)));
        assert!(one.contains(&(3, 2)) && !one.contains(&(13, 2)) && !two.contains(&(3, 12)));
    }

    #[test]
    fn lines_have_a_pixel_for_each_step() {
        for (x, y) in [(20, 7), (7, 20), (-20, 7), (5, -20), (9, 9), (0, 9), (-9, 0), (0, 0)] {
            let ends = [vertex(30, 24, 100), vertex(30 + x, 24 + y, 2000)];
            let line = covered(&draw(PalettePrimitive::Line { ends, color: 0 }).unwrap());
            assert_eq!(line.len() as i32, x.abs().max(y.abs()) + 1, "{x} {y}");
            assert!(line.contains(&(30, 24)) && line.contains(&(30 + x, 24 + y)));
            let back = covered(
                &draw(PalettePrimitive::Line { ends: [ends[1], ends[0]], color: 0 }).unwrap(),
            );
            assert_eq!(line, back);
        }
    }

    #[test]
    fn planes_pass_through_corners_near_and_far() {
        let corners = [vertex(0, 0, 65535), vertex(40, 0, 1024), vertex(0, 40, 30000)];
        let shape = draw_triangle(corners).unwrap();
        for v in corners {
            let depth = shape.depth.at(v.x, v.y) as u32 >> 16;
            assert!(depth.abs_diff(v.depth.into()) <= 1, "{depth} {}", v.depth);
        }
        // A plane through far corners is exact on the screen.
        let far = 1 << 20;
        let corners = [vertex(-far, -far, 0), vertex(far, -far, 0), vertex(0, far, 65535)];
        let shape = draw_triangle(corners).unwrap();
        assert_eq!(shape.depth.at(5, 0) as u32 >> 16, 32768);
    }

    #[test]
    fn nothing_outside_or_without_area() {
        let flat = [vertex(0, 0, 1), vertex(5, 5, 1), vertex(10, 10, 1)];
        assert!(draw_triangle(flat).is_none());
        let outside = [vertex(64, 0, 1), vertex(99, 5, 1), vertex(70, 10, 1)];
        assert!(draw_triangle(outside).is_none());
        let far = [vertex(i32::MIN, 0, 1), vertex(i32::MAX, 5, 1), vertex(0, 10, 1)];
        assert!(draw_triangle(far).is_none());
        let (at, size) = ([i32::MIN, i32::MAX], [u32::MAX; 2]);
        let (texel, step) = ([0; 2], [1; 2]);
        let rect =
            PalettePrimitive::Rect { at, size, texel, step, depth: 0, intensity: 0, color: 0 };
        assert!(draw(rect).is_none());
    }
}
