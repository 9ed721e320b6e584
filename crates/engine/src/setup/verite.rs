//! Triangle set-up in double precision, as the Vérité's is modelled: gradients
//! come from the coordinates in sixteenths that coverage comes from.
//!
//! Source: RR, primitives and pixel pipeline. It gives no formats below those of
//! its words: those here are ours, see `docs/sources.md`.

use super::extra::{Extra, SPECULAR};
use super::launch::{GROUP, Launch, NARROW, Params, Z};
use super::{Param, Registers};
use crate::state::MAX_TMUS;

/// A vertex of the Vérité's set-up, in screen space. It is small, because a batch
/// of them stays in the cache then.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct VeriteVertex {
    /// Red, green, blue and alpha, 12.12.
    pub color: [i32; 4],
    /// Depth, 21.11.
    pub z: i32,
    /// Column in sixteenths of a pixel.
    pub x: i16,
    /// Row in sixteenths, in drawing coordinates.
    pub y: i16,
}

/// What a vertex has besides a [`VeriteVertex`], for draw states that read it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct VeriteExtra {
    /// Red, green and blue of the second colour and what fog leaves of the
    /// colour, 12.12: see [`Registers::specular`].
    pub specular: [i32; 4],
    /// s/w, t/w and 1/w of the first texture unit, 32 fraction bits.
    pub texel: [f64; 3],
}

/// Three of each.
pub(crate) type Vertices<'a> = [&'a VeriteVertex; 3];
pub(crate) type Extras<'a> = [&'a VeriteExtra; 3];
/// Three corners, with extras or without.
pub(crate) type VeriteCorners<'a> = (Vertices<'a>, Option<Extras<'a>>);

/// Differences of three places from one to the next.
#[inline(always)]
fn differences([a, b, c]: [[i32; 2]; 3]) -> [f64; 4] {
    [a[0] - b[0], a[1] - b[1], b[0] - c[0], b[1] - c[1]].map(f64::from)
}

/// How values change along the plane through three places: sides by the area.
///
/// [`verite_triangle`] uses them, and who cuts triangles that are too large for a
/// [`VeriteVertex`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct VeriteSlopes([f64; 4]);

impl VeriteSlopes {
    /// Those of three places in sixteenths, less than 2^31 apart; `None` where
    /// they lie on a line.
    #[inline(always)]
    pub fn new(places: [[i32; 2]; 3]) -> Option<VeriteSlopes> {
        let sides = differences(places);
        let area = area(sides);
        (area != 0.0).then(|| VeriteSlopes::divided(sides, SIXTEENTHS / area))
    }

    #[inline(always)]
    fn divided(sides: [f64; 4], scale: f64) -> VeriteSlopes {
        VeriteSlopes(sides.map(|side| side * scale))
    }

    /// Steps of values, per column and per row of pixels, from what the three
    /// places have.
    #[inline(always)]
    pub fn steps<const N: usize>(&self, [a, b, c]: [&[f64; N]; 3]) -> [[f64; N]; 2] {
        let [dx_ab, dy_ab, dx_bc, dy_bc] = self.0;
        let mut out = [[0.0; N]; 2];
        for i in 0..N {
            let (d_ab, d_bc) = (a[i] - b[i], b[i] - c[i]);
            out[0][i] = d_ab * dy_bc - d_bc * dy_ab;
            out[1][i] = d_bc * dx_ab - d_ab * dx_bc;
        }
        out
    }
}

/// Sixteen of them are a pixel.
pub(super) const SIXTEENTHS: f64 = 16.0;

/// Twice the area of a triangle with these differences.
#[inline(always)]
fn area([dx_ab, dy_ab, dx_bc, dy_bc]: [f64; 4]) -> f64 {
    dx_ab * dy_bc - dx_bc * dy_ab
}

/// Orders of three vertices by rising y and whether they are odd permutations, by
/// the comparisons a > b, b > c, a > c as bits 2 to 0. Equal ones keep their order.
const ORDERS: [([u8; 3], bool); 8] = {
    const ABC: ([u8; 3], bool) = ([0, 1, 2], false);
    const ACB: ([u8; 3], bool) = ([0, 2, 1], true);
    const CAB: ([u8; 3], bool) = ([2, 0, 1], false);
    const BAC: ([u8; 3], bool) = ([1, 0, 2], true);
    const BCA: ([u8; 3], bool) = ([1, 2, 0], false);
    const CBA: ([u8; 3], bool) = ([2, 1, 0], true);
    [ABC, ABC, ACB, CAB, BAC, BCA, CBA, CBA]
};

/// The same as integers: the indices two bits each, the lowest first, and bit 6 for
/// an odd permutation.
pub(super) static ORDER_CODES: [i32; 16] = {
    let (mut codes, mut i) = ([0; 16], 0);
    while i < 16 {
        let ([a, b, c], odd) = ORDERS[i % 8];
        codes[i] = (a as i32) | (b as i32) << 2 | (c as i32) << 4 | (odd as i32) << 6;
        i += 1;
    }
    codes
};

/// A triangle's corners by rising y, and its area.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct VeriteSorted {
    /// It has an area.
    pub drawn: bool,
    order: [u8; 3],
    /// The sorted corners' area is negative.
    negative: bool,
    /// A pixel's sixteenths by the area of the corners as they came.
    scale: f64,
}

impl VeriteSorted {
    #[inline(always)]
    pub fn new(vertices: Vertices<'_>) -> VeriteSorted {
        let area = area(differences(vertices.map(place)));
        let [a, b, c] = vertices.map(|v| v.y);
        let bit = |on: bool, at: u32| usize::from(on) << at;
        let (order, odd) = ORDERS[bit(a > b, 2) | bit(b > c, 1) | bit(a > c, 0)];
        let negative = (area < 0.0) != odd;
        VeriteSorted { drawn: area != 0.0, order, negative, scale: SIXTEENTHS / area }
    }

    #[inline(always)]
    fn slopes(&self, vertices: Vertices<'_>) -> VeriteSlopes {
        VeriteSlopes::divided(differences(vertices.map(place)), self.scale)
    }
}

#[inline(always)]
fn place(v: &VeriteVertex) -> [i32; 2] {
    [i32::from(v.x), i32::from(v.y)]
}

/// Sets a triangle up, by name; `None` where it has no area. All steps are
/// truncated toward zero and kept within their registers, but for those of z, of
/// which the low bits are kept.
pub fn verite_triangle(
    vertices: [&VeriteVertex; 3],
    extras: [&VeriteExtra; 3],
) -> Option<Registers> {
    let sorted = VeriteSorted::new(vertices);
    if !sorted.drawn {
        return None;
    }
    let mut launch = Launch::default();
    set_up_verite(vertices, Some(extras), &sorted, 1, &mut launch);
    let mut registers = launch.registers(1);
    let second = verite_extra(vertices, Some(extras), &sorted).colors;
    registers.specular = [0, 1, 2, 3].map(|lane| Param {
        start: second.start[SPECULAR + lane],
        dx: second.dx[SPECULAR + lane],
        dy: second.dy[SPECULAR + lane],
    });
    Some(registers)
}

/// [`verite_triangle`] into lanes, of corners that have an area. `units` is how
/// many texture units need coordinates; those that have none get zeros.
#[inline(always)]
pub(crate) fn set_up_verite(
    vertices: Vertices<'_>,
    extras: Option<Extras<'_>>,
    sorted: &VeriteSorted,
    units: usize,
    out: &mut Launch,
) {
    let slopes = sorted.slopes(vertices);
    let order = sorted.order.map(usize::from);
    let sorted_vertices = order.map(|i| vertices[i]);
    out.negative = sorted.negative;
    out.x = sorted_vertices.map(|v| i32::from(v.x));
    out.y = sorted_vertices.map(|v| i32::from(v.y));
    let [first, ..] = sorted_vertices;
    let colors = vertices.map(|v| v.color.map(f64::from));
    put_steps(&mut out.narrow, 0, first.color, slopes.steps(colors.each_ref()));
    let [[dx], [dy]] = slopes.steps(vertices.map(|v| [f64::from(v.z)]).each_ref());
    // 21.11 in iterators of 20.12.
    out.narrow.start[Z] = first.z << 1;
    out.narrow.dx[Z] = ((dx as i64) << 1) as i32;
    out.narrow.dy[Z] = ((dy as i64) << 1) as i32;
    out.wide[0].clear();
    if let (Some(extras), true) = (extras, units > 0) {
        let wide = extras.map(wide_lanes);
        let [dx, dy] = slopes.steps(wide.each_ref());
        out.wide[0].truncate([wide[order[0]], dx, dy]);
    }
    for out in &mut out.wide[1..units.clamp(1, MAX_TMUS)] {
        out.clear();
    }
}

/// The second colour and the fog factor.
#[inline(always)]
pub(crate) fn verite_extra(
    vertices: Vertices<'_>,
    extras: Option<Extras<'_>>,
    sorted: &VeriteSorted,
) -> Extra {
    let mut out = Extra::default();
    if let Some(extras) = extras {
        let values = extras.map(|extra| extra.specular.map(f64::from));
        let steps = sorted.slopes(vertices).steps(values.each_ref());
        let first = extras[usize::from(sorted.order[0])];
        put_steps(&mut out.colors, SPECULAR, first.specular, steps);
    }
    out
}

/// Puts four parameters into the lanes from `first` on, steps truncated.
#[inline(always)]
fn put_steps(
    to: &mut Params<[i32; NARROW]>,
    first: usize,
    start: [i32; 4],
    [dx, dy]: [[f64; 4]; 2],
) {
    to.start[first..first + 4].copy_from_slice(&start);
    to.dx[first..first + 4].copy_from_slice(&dx.map(|step| step as i32));
    to.dy[first..first + 4].copy_from_slice(&dy.map(|step| step as i32));
}

/// The first unit's group of 64-bit parameters; see [`Launch`].
#[inline(always)]
fn wide_lanes(extra: &VeriteExtra) -> [f64; GROUP] {
    let [s, t, w] = extra.texel;
    [0.0, s, t, w]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn corner(x: i16, y: i16, red: i32) -> VeriteVertex {
        VeriteVertex { x: x * 16, y: y * 16, color: [red, 0, 0, 0], ..VeriteVertex::default() }
    }

    fn set_up(corners: &[VeriteVertex; 3]) -> Option<Registers> {
        verite_triangle(corners.each_ref(), [&VeriteExtra::default(); 3])
    }

    #[test]
    fn steps_are_per_pixel() {
        let corners = [corner(10, 10, 0), corner(20, 10, 4096 * 10), corner(10, 30, 4096)];
        let registers = set_up(&corners).unwrap();
        assert_eq!(registers.color[0], Param { start: 0, dx: 4096, dy: 204 });
        assert_eq!((registers.x, registers.y), ([160, 320, 160], [160, 160, 480]));
        assert_eq!(set_up(&[corners[0], corners[0], corners[1]]), None);
    }

    /// Equal rows keep their order, and the sign is that of the sorted corners.
    #[test]
    fn corners_are_sorted() {
        for ys in 0..27 {
            let y = [ys % 3, ys / 3 % 3, ys / 9];
            let corners = [0, 1, 2].map(|i| corner([0, 7, 3][i], y[i], 0));
            let Some(registers) = set_up(&corners) else { continue };
            let mut places = corners.map(|v| [i32::from(v.x), i32::from(v.y)]);
            places.sort_by_key(|place| place[1]);
            assert_eq!(registers.x, places.map(|place| place[0]));
            assert_eq!(registers.y, places.map(|place| place[1]));
            assert_eq!(registers.negative, area(differences(places)) < 0.0);
        }
    }
}
