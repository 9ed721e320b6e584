//! Float triangle set-up as Glide does it for the SST-1.

use super::launch::{GROUP, Launch, NARROW, Params};
use super::{Param, Registers, Vertex, VertexExtra, WideParam};
use crate::fixed;
use crate::state::MAX_TMUS;

/// Which triangles to drop by the sign of their area, in the caller's vertex
/// order and raw coordinates; positive is counter-clockwise where y points up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Cull {
    /// None.
    #[default]
    Disabled,
    /// Those of negative area.
    Negative,
    /// Those of positive area.
    Positive,
}

/// What became of a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(clippy::large_enum_variant)]
pub enum Outcome {
    /// It has no area.
    Empty,
    /// It was culled.
    Culled,
    /// It launches.
    Drawn(Registers),
}

/// Deltas of the sorted triangle, multiplied by 1/area.
struct Deltas {
    dx_ab: f32,
    dy_ab: f32,
    dx_bc: f32,
    dy_bc: f32,
}

impl Deltas {
    /// From x and y of sorted corners.
    #[inline(always)]
    fn new([a, b, c]: [[f32; 2]; 3], inverse: f32) -> Deltas {
        Deltas {
            dx_ab: (a[0] - b[0]) * inverse,
            dy_ab: (a[1] - b[1]) * inverse,
            dx_bc: (b[0] - c[0]) * inverse,
            dy_bc: (b[1] - c[1]) * inverse,
        }
    }

    /// The steps per column and per row of parameters.
    #[inline(always)]
    fn gradients<const N: usize>(&self, [a, b, c]: [[f32; N]; 3]) -> [[f32; N]; 2] {
        let (mut dx, mut dy) = ([0.0; N], [0.0; N]);
        for i in 0..N {
            let (d_ab, d_bc) = (a[i] - b[i], b[i] - c[i]);
            dx[i] = d_ab * self.dy_bc - d_bc * self.dy_ab;
            dy[i] = d_bc * self.dx_ab - d_ab * self.dx_bc;
        }
        [dx, dy]
    }
}

/// A float's bits as an integer that orders like the float, -0 below +0.
#[inline(always)]
fn order_key(value: f32) -> i32 {
    let bits = value.to_bits() as i32;
    bits ^ (((bits >> 31) as u32) >> 1) as i32
}

/// Orders of three vertices and whether they are odd permutations, by the
/// comparisons a < b, b < c, b > c, a < c as bits 3 to 0. Ties are broken as
/// the original's comparisons break them.
const ORDERS: [([u8; 3], bool); 16] = {
    const BCA: ([u8; 3], bool) = ([1, 2, 0], false);
    const BAC: ([u8; 3], bool) = ([1, 0, 2], true);
    const CBA: ([u8; 3], bool) = ([2, 1, 0], true);
    const ABC: ([u8; 3], bool) = ([0, 1, 2], false);
    const CAB: ([u8; 3], bool) = ([2, 0, 1], false);
    const ACB: ([u8; 3], bool) = ([0, 2, 1], true);
    [CBA, CBA, CBA, CBA, BCA, BAC, BCA, BAC, ABC, ABC, CAB, ACB, ABC, ABC, CAB, ACB]
};

/// The same as integers: the indices two bits each, the lowest first, and bit 6 for
/// an odd permutation.
pub(super) static ORDER_CODES: [i32; 16] = {
    let (mut codes, mut i) = ([0; 16], 0);
    while i < 16 {
        let ([a, b, c], odd) = ORDERS[i];
        codes[i] = (a as i32) | (b as i32) << 2 | (c as i32) << 4 | (odd as i32) << 6;
        i += 1;
    }
    codes
};

/// The vertices' indices by rising y, and whether the order is an odd
/// permutation.
#[inline(always)]
fn sort(y: [f32; 3]) -> ([usize; 3], bool) {
    let [a, b, c] = [order_key(y[0]), order_key(y[1]), order_key(y[2])];
    let bit = |on: bool, at: u32| usize::from(on) << at;
    let index = bit(a < b, 3) | bit(b < c, 2) | bit(b > c, 1) | bit(a < c, 0);
    let ([i, j, k], odd) = ORDERS[index];
    ([usize::from(i), usize::from(j), usize::from(k)], odd)
}

/// What became of a triangle, less its registers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Fate {
    #[default]
    Empty,
    Culled,
    Drawn,
}

/// Sets a triangle up: sorts by y, culls, computes gradients in single
/// precision from the raw coordinates, and converts to the chip's formats.
/// `units` is how many texture units need coordinates.
///
/// Source: G246, triangle set-up; SST1, triangle registers.
pub fn triangle(vertices: [&Vertex; 3], cull: Cull, units: usize) -> Outcome {
    let sorted = Sorted::new(&vertices, cull);
    match sorted.fate {
        Fate::Empty => Outcome::Empty,
        Fate::Culled => Outcome::Culled,
        Fate::Drawn => {
            let mut launch = Launch::default();
            set_up(&vertices, &sorted, units, &mut launch);
            Outcome::Drawn(launch.registers(units))
        }
    }
}

/// [`triangle`], with what the vertices have besides. The gradients of
/// `deep_z` are computed in double precision.
pub fn extended_triangle(
    vertices: [&Vertex; 3],
    extras: [&VertexExtra; 3],
    cull: Cull,
    units: usize,
) -> Outcome {
    let mut outcome = triangle(vertices, cull, units);
    if let Outcome::Drawn(registers) = &mut outcome {
        let (order, _) = sort([vertices[0].y, vertices[1].y, vertices[2].y]);
        extend(registers, order.map(|i| vertices[i]), order.map(|i| extras[i]));
    }
    outcome
}

/// Adds the parameters of sorted vertices that have an area.
fn extend(registers: &mut Registers, vertices: [&Vertex; 3], extras: [&VertexExtra; 3]) {
    let [a, b, c] = vertices;
    let area = (a.x - b.x) * (b.y - c.y) - (b.x - c.x) * (a.y - b.y);
    let colors = extras.map(|extra| {
        let ([r, g, b], [u, v, w]) = (extra.specular, extra.base);
        [r, g, b, extra.fog, u, v, w]
    });
    let places = vertices.map(|v| [v.x, v.y]);
    let steps = Deltas::new(places, 1.0 / area).gradients(colors);
    let [start, dx, dy] = [colors[0], steps[0], steps[1]].map(fixed::twelve_bits);
    let param = |i: usize| Param { start: start[i], dx: dx[i], dy: dy[i] };
    registers.specular = [0, 1, 2, 3].map(param);
    registers.base = [4, 5, 6].map(param);
    registers.deep_z = deep_param(vertices, extras);
}

/// The plane of the deep z in double precision.
fn deep_param(vertices: [&Vertex; 3], extras: [&VertexExtra; 3]) -> WideParam {
    let [x, y] = [vertices.map(|v| f64::from(v.x)), vertices.map(|v| f64::from(v.y))];
    let z = extras.map(|extra| extra.deep_z);
    let sides = |v: [f64; 3]| [v[0] - v[1], v[1] - v[2]];
    let ([x_ab, x_bc], [y_ab, y_bc], [z_ab, z_bc]) = (sides(x), sides(y), sides(z));
    let area = x_ab * y_bc - x_bc * y_ab;
    let wide = |value: f64| (value * (1u64 << fixed::WIDE_FRACTION) as f64) as i64;
    WideParam {
        start: wide(z[0]),
        dx: wide((z_ab * y_bc - z_bc * y_ab) / area),
        dy: wide((z_bc * x_ab - z_ab * x_bc) / area),
    }
}

/// A triangle's corners as set-up reads them: numbers 0 to 2.
pub(crate) trait Corners {
    /// x and y.
    fn place(&self, corner: usize) -> [f32; 2];
    /// Colours and z. The last three lanes mean nothing.
    fn narrow(&self, corner: usize) -> [f32; NARROW];
    /// A unit's group of 64-bit parameters; see [`Launch`].
    fn wide(&self, corner: usize, unit: usize) -> [f32; GROUP];
}

impl Corners for [&Vertex; 3] {
    #[inline(always)]
    fn place(&self, corner: usize) -> [f32; 2] {
        [self[corner].x, self[corner].y]
    }

    #[inline(always)]
    fn narrow(&self, corner: usize) -> [f32; NARROW] {
        let v = self[corner];
        [v.r, v.g, v.b, v.a, v.z, 0.0, 0.0, 0.0]
    }

    #[inline(always)]
    fn wide(&self, corner: usize, unit: usize) -> [f32; GROUP] {
        let v = self[corner];
        let [t0, t1, t2] = &v.tmu;
        match unit {
            0 => [v.w, t0.s, t0.t, t0.w],
            1 => [t1.s, t1.t, t1.w, 0.0],
            _ => [t2.s, t2.t, t2.w, 0.0],
        }
    }
}

/// A triangle's corners by rising y, and its area.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Sorted {
    pub fate: Fate,
    order: [u8; 3],
    /// The sorted corners' area is negative.
    negative: bool,
    /// One by that area.
    inverse: f32,
}

impl Sorted {
    #[inline(always)]
    pub fn new(corners: &impl Corners, cull: Cull) -> Sorted {
        let places = [corners.place(0), corners.place(1), corners.place(2)];
        let (order, odd) = sort(places.map(|[_, y]| y));
        let [a, b, c] = order.map(|i| places[i]);
        let (dx_ab, dy_ab) = (a[0] - b[0], a[1] - b[1]);
        let (dx_bc, dy_bc) = (b[0] - c[0], b[1] - c[1]);
        let area = dx_ab * dy_bc - dx_bc * dy_ab;
        let negative = area < 0.0;
        let culled = match cull {
            Cull::Disabled => false,
            Cull::Negative => negative != odd,
            Cull::Positive => negative == odd,
        };
        let fate = match area == 0.0 || !area.is_finite() {
            true => Fate::Empty,
            false if culled => Fate::Culled,
            false => Fate::Drawn,
        };
        Sorted { fate, order: order.map(|i| i as u8), negative, inverse: 1.0 / area }
    }
}

/// [`triangle`], into lanes, of corners that are drawn.
#[inline(always)]
pub(crate) fn set_up(corners: &impl Corners, sorted: &Sorted, units: usize, out: &mut Launch) {
    let [a, b, c] = sorted.order.map(usize::from);
    let places = [corners.place(a), corners.place(b), corners.place(c)];
    let deltas = Deltas::new(places, sorted.inverse);
    out.negative = sorted.negative;
    coordinates(places, out);
    let narrow = [corners.narrow(a), corners.narrow(b), corners.narrow(c)];
    let [dx, dy] = deltas.gradients(narrow);
    out.narrow = Params {
        start: fixed::twelve_bits(narrow[0]),
        dx: fixed::twelve_bits(dx),
        dy: fixed::twelve_bits(dy),
    };
    for (unit, out) in out.wide.iter_mut().enumerate().take(units.clamp(1, MAX_TMUS)) {
        let wide = [corners.wide(a, unit), corners.wide(b, unit), corners.wide(c, unit)];
        let [dx, dy] = deltas.gradients(wide);
        out.convert([wide[0], dx, dy]);
    }
}

#[inline(always)]
fn coordinates([[ax, ay], [bx, by], [cx, cy]]: [[f32; 2]; 3], out: &mut Launch) {
    let [ax, bx, cx, ay, by, cy, ..] = fixed::coordinates([ax, bx, cx, ay, by, cy, 0.0, 0.0]);
    out.x = [ax, bx, cx];
    out.y = [ay, by, cy];
}
