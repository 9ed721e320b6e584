//! Float triangle set-up as Glide does it for the SST-1.

use super::{Param, Registers, Vertex, WideParam};
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
    /// The steps per column and per row of a parameter.
    fn gradient(&self, [a, b, c]: [f32; 3]) -> (f32, f32) {
        let (d_ab, d_bc) = (a - b, b - c);
        (d_ab * self.dy_bc - d_bc * self.dy_ab, d_bc * self.dx_ab - d_ab * self.dx_bc)
    }

    fn param(&self, values: [f32; 3], convert: fn(f32) -> i32) -> Param {
        let (dx, dy) = self.gradient(values);
        Param { start: convert(values[0]), dx: convert(dx), dy: convert(dy) }
    }

    fn wide(&self, values: [f32; 3]) -> WideParam {
        let (dx, dy) = self.gradient(values);
        WideParam { start: fixed::wide(values[0]), dx: fixed::wide(dx), dy: fixed::wide(dy) }
    }
}

/// A float's bits as an integer that orders like the float, -0 below +0.
fn order_key(value: f32) -> i32 {
    let bits = value.to_bits() as i32;
    if bits < 0 { bits ^ 0x7fff_ffff } else { bits }
}

/// The vertices' indices by rising y, and whether the order is an odd
/// permutation. Ties are broken as the original's comparisons break them.
fn sort(y: [f32; 3]) -> ([usize; 3], bool) {
    let [a, b, c] = y.map(order_key);
    if a < b {
        match (b > c, a < c) {
            (true, true) => ([0, 2, 1], true),
            (true, false) => ([2, 0, 1], false),
            (false, _) => ([0, 1, 2], false),
        }
    } else {
        match (b < c, a < c) {
            (true, true) => ([1, 0, 2], true),
            (true, false) => ([1, 2, 0], false),
            (false, _) => ([2, 1, 0], true),
        }
    }
}

/// Sets a triangle up: sorts by y, culls, computes gradients in single
/// precision from the raw coordinates, and converts to the chip's formats.
/// `units` is how many texture units need coordinates.
///
/// Source: G246, triangle set-up; SST1, triangle registers.
pub fn triangle(vertices: [&Vertex; 3], cull: Cull, units: usize) -> Outcome {
    let (order, odd) = sort(vertices.map(|v| v.y));
    let [a, b, c] = order.map(|i| vertices[i]);
    let (dx_ab, dy_ab) = (a.x - b.x, a.y - b.y);
    let (dx_bc, dy_bc) = (b.x - c.x, b.y - c.y);
    let area = dx_ab * dy_bc - dx_bc * dy_ab;
    if area == 0.0 || !area.is_finite() {
        return Outcome::Empty;
    }
    let negative = area < 0.0;
    match (cull, negative != odd) {
        (Cull::Negative, true) | (Cull::Positive, false) => return Outcome::Culled,
        _ => {}
    }
    let inverse = 1.0 / area;
    let deltas = Deltas {
        dx_ab: dx_ab * inverse,
        dy_ab: dy_ab * inverse,
        dx_bc: dx_bc * inverse,
        dy_bc: dy_bc * inverse,
    };
    Outcome::Drawn(registers([a, b, c], negative, &deltas, units))
}

fn registers(sorted: [&Vertex; 3], negative: bool, deltas: &Deltas, units: usize) -> Registers {
    let each = |field: fn(&Vertex) -> f32| sorted.map(field);
    let mut out = Registers {
        x: sorted.map(|v| fixed::coord(v.x)),
        y: sorted.map(|v| fixed::coord(v.y)),
        negative,
        color: [
            deltas.param(each(|v| v.r), fixed::color),
            deltas.param(each(|v| v.g), fixed::color),
            deltas.param(each(|v| v.b), fixed::color),
            deltas.param(each(|v| v.a), fixed::color),
        ],
        z: deltas.param(each(|v| v.z), fixed::depth),
        w: deltas.wide(each(|v| v.w)),
        ..Registers::default()
    };
    for unit in 0..units.min(MAX_TMUS) {
        let field = |pick: fn(&super::TmuVertex) -> f32| sorted.map(|v| pick(&v.tmu[unit]));
        out.tmu[unit] =
            [deltas.wide(field(|t| t.s)), deltas.wide(field(|t| t.t)), deltas.wide(field(|t| t.w))];
    }
    out
}
