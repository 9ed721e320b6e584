//! Vertices to the engine's registers.
//!
//! Gradients come from coordinates in sixteenths of a pixel, as coverage does,
//! in double precision; iterators have the engine's formats: colours 12.12, z
//! 21.11, texture coordinates and Q 32 fraction bits.
//!
//! Source: RR, vertex types and attribute formats.

use fillrate_engine::state::Rect;
use fillrate_engine::{Param, Registers, WideParam};

use super::state::State;
use crate::opcode::Register;
use crate::vertex::{Attribute, Layout};

/// Colour, alpha, z, specular colour, fog.
pub(crate) const NARROW: usize = 9;
/// Index of z among them.
const Z: usize = 4;
/// 1.0 with 32 fraction bits.
const ONE: f64 = 4_294_967_296.0;
/// Places around the centre of a pixel, and around no other, in sixteenths.
const AROUND_CENTER: [[i32; 2]; 3] = [[4, 4], [12, 4], [8, 12]];
/// The farthest coordinate that the engine takes, in sixteenths.
const LIMIT: i32 = 2047 * 16;

/// A vertex ready for set-up.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Corner {
    /// Column in sixteenths.
    pub x: i32,
    /// Row in sixteenths.
    pub y: i32,
    /// Red, green, blue, alpha (12.12), z (21.11), specular red, green, blue
    /// and fog (12.12).
    pub narrow: [f64; NARROW],
    /// Column and row of the texture times Q, and Q, with 32 fraction bits.
    pub wide: [f64; 3],
}

impl Corner {
    /// The same corner where pixel `at` is the first one.
    pub fn moved(&self, [x, y]: [u32; 2]) -> Corner {
        Corner { x: self.x - (x << 4) as i32, y: self.y - (y << 4) as i32, ..*self }
    }
}

/// What vertices are read with: defaults of attributes that a type lacks, and
/// what becomes of texture coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Attributes {
    narrow: [f64; NARROW],
    /// Default U and V.
    coordinates: [u32; 2],
    multipliers: [f64; 2],
    /// Added to texture coordinates, in texels.
    offsets: [f64; 2],
    /// U addresses rows.
    swap: bool,
    /// Whether specular colour and fog are needed.
    pub extended: bool,
}

/// A channel of 16.16, 0 to 255, as 12.12.
fn channel(word: u32) -> f64 {
    f64::from((word as i32).clamp(0, 0xff_ffff) >> 4)
}

/// A byte of a packed colour as 12.12.
fn byte(word: u32, shift: u32) -> f64 {
    f64::from((word >> shift & 0xff) << 12)
}

/// Red, green and blue of a packed colour.
fn packed(word: u32) -> [f64; 3] {
    [byte(word, 16), byte(word, 8), byte(word, 0)]
}

/// 16.16 to sixteenths, to the nearest.
pub(crate) fn sixteenths(word: u32) -> i32 {
    ((i64::from(word as i32) + 0x800) >> 12) as i32
}

impl Attributes {
    /// What a state says. `filtered`: samples lie between texels.
    pub fn new(state: &State, filtered: bool, extended: bool) -> Attributes {
        let get = |register| state.get(register);
        let [r, g, b, a, f] = [Register::R, Register::G, Register::B, Register::A, Register::F]
            .map(|register| channel(get(register)));
        let [sr, sg, sb] = packed(get(Register::SpecularColorRgb));
        let z = f64::from(get(Register::Z) >> 5);
        // The engine takes half a texel off where it filters; the chip does not.
        let half = if filtered { 0.5 } else { 0.0 };
        let offset = |register| f64::from(get(register) as i32) / 65536.0 + half;
        let multiplier = |register| f64::from(get(register)) / 65536.0;
        Attributes {
            narrow: [r, g, b, a, z, sr, sg, sb, f],
            coordinates: [get(Register::U), get(Register::V)],
            multipliers: [multiplier(Register::UMultiplier), multiplier(Register::VMultiplier)],
            offsets: [offset(Register::SOffset), offset(Register::TOffset)],
            swap: state.is_set(Register::SwapUv),
            extended,
        }
    }

    /// A vertex of the default attributes at a place.
    pub fn corner(&self, x: i32, y: i32, u: u32, v: u32) -> Corner {
        Corner { x, y, narrow: self.narrow, wide: self.texel(u, v, ONE) }
    }

    /// Column and row times Q, and Q; `q` has 32 fraction bits.
    fn texel(&self, u: u32, v: u32, q: f64) -> [f64; 3] {
        let along = |word: u32, axis: usize| {
            let coordinate = f64::from(word as i32) / 65536.0;
            (coordinate * self.multipliers[axis] + self.offsets[axis]) * q
        };
        let (s, t) = (along(u, 0), along(v, 1));
        if self.swap { [t, s, q] } else { [s, t, q] }
    }

    /// Reads a vertex; `textured` where its coordinates are needed.
    #[inline]
    pub fn read(&self, layout: &Layout, words: &[u32], textured: bool) -> Corner {
        let get = |attribute| layout.get(words, attribute);
        let mut narrow = self.narrow;
        if let Some(k) = get(Attribute::K) {
            narrow[..3].copy_from_slice(&packed(k));
        } else if let Some(r) = get(Attribute::R) {
            narrow[0] = channel(r);
            narrow[1] = get(Attribute::G).map_or(narrow[1], channel);
            narrow[2] = get(Attribute::B).map_or(narrow[2], channel);
        } else if let Some(i) = get(Attribute::I) {
            narrow[..3].fill(channel(i));
        } else if let Some(ka) = get(Attribute::Ka) {
            narrow[..3].copy_from_slice(&packed(ka));
            narrow[3] = byte(ka, 24);
        }
        if let Some(a) = get(Attribute::A) {
            narrow[3] = channel(a);
        }
        if let Some(z) = get(Attribute::Z) {
            narrow[Z] = f64::from(z >> 5);
        }
        if self.extended {
            self.read_extended(layout, words, &mut narrow);
        }
        let place = |attribute| sixteenths(get(attribute).unwrap_or(0));
        let (x, y) = (place(Attribute::X), place(Attribute::Y));
        let wide = if textured { self.read_texel(layout, words) } else { [0.0; 3] };
        Corner { x, y, narrow, wide }
    }

    fn read_extended(&self, layout: &Layout, words: &[u32], narrow: &mut [f64; NARROW]) {
        if let Some(s) = layout.get(words, Attribute::S) {
            narrow[5..8].copy_from_slice(&packed(s));
        } else if let Some(sf) = layout.get(words, Attribute::Sf) {
            narrow[5..8].copy_from_slice(&packed(sf));
            narrow[8] = byte(sf, 24);
        } else if let Some(fog) = layout.get(words, Attribute::Fp) {
            narrow[8] = byte(fog, 24);
        }
        if let Some(f) = layout.get(words, Attribute::F) {
            narrow[8] = channel(f);
        }
    }

    fn read_texel(&self, layout: &Layout, words: &[u32]) -> [f64; 3] {
        let u = layout.get(words, Attribute::U).unwrap_or(self.coordinates[0]);
        let v = layout.get(words, Attribute::V).unwrap_or(self.coordinates[1]);
        // 8.24 to 32 fraction bits.
        let q = layout.get(words, Attribute::Q).map_or(ONE, |q| f64::from(q) * 256.0);
        self.texel(u, v, q)
    }
}

/// A plane: value at a corner and steps.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Planes {
    /// Of a pixel to the right and below.
    narrow: [[f64; NARROW]; 2],
    wide: [[f64; 3]; 2],
}

/// Where a triangle's pixels are.
pub(crate) fn bounds(corners: &[&Corner; 3]) -> Rect {
    let [a, b, c] = corners;
    let low = |a: i32, b: i32, c: i32| (a.min(b).min(c) >> 4).max(0) as u32;
    let high = |a: i32, b: i32, c: i32| ((a.max(b).max(c) >> 4) + 1).max(0) as u32;
    Rect::new(low(a.x, b.x, c.x), low(a.y, b.y, c.y), high(a.x, b.x, c.x), high(a.y, b.y, c.y))
}

/// Steps of `N` values per pixel.
#[inline(always)]
fn steps<const N: usize>(
    [a, b, c]: [&[f64; N]; 3],
    [dx_ab, dy_ab, dx_bc, dy_bc]: [f64; 4],
) -> [[f64; N]; 2] {
    let mut out = [[0.0; N]; 2];
    for i in 0..N {
        let (d_ab, d_bc) = (a[i] - b[i], b[i] - c[i]);
        out[0][i] = d_ab * dy_bc - d_bc * dy_ab;
        out[1][i] = d_bc * dx_ab - d_ab * dx_bc;
    }
    out
}

impl Planes {
    /// The planes through three corners; `None` where they lie on a line.
    #[inline]
    fn new([a, b, c]: &[&Corner; 3], textured: bool) -> Option<Planes> {
        let [dx_ab, dy_ab] = [a.x - b.x, a.y - b.y].map(f64::from);
        let [dx_bc, dy_bc] = [b.x - c.x, b.y - c.y].map(f64::from);
        let area = dx_ab * dy_bc - dx_bc * dy_ab;
        if area == 0.0 {
            return None;
        }
        // Sixteen sixteenths are a pixel.
        let scale = 16.0 / area;
        let sides = [dx_ab, dy_ab, dx_bc, dy_bc].map(|side| side * scale);
        let narrow = steps([&a.narrow, &b.narrow, &c.narrow], sides);
        let wide = match textured {
            true => steps([&a.wide, &b.wide, &c.wide], sides),
            false => [[0.0; 3]; 2],
        };
        Some(Planes { narrow, wide })
    }

    /// The corner that lies on these planes through `from` at a place.
    fn corner_at(&self, from: &Corner, x: i32, y: i32) -> Corner {
        let (columns, rows) = (f64::from(x - from.x) / 16.0, f64::from(y - from.y) / 16.0);
        let at = |start: f64, dx: f64, dy: f64| start + dx * columns + dy * rows;
        let mut corner = Corner { x, y, ..*from };
        for (i, value) in corner.narrow.iter_mut().enumerate() {
            *value = at(*value, self.narrow[0][i], self.narrow[1][i]);
        }
        for (i, value) in corner.wide.iter_mut().enumerate() {
            *value = at(*value, self.wide[0][i], self.wide[1][i]);
        }
        corner
    }

    fn param(&self, from: &Corner, i: usize) -> Param {
        let fixed = |value: f64| value as i32;
        let (start, [dx, dy]) = (from.narrow[i], self.narrow);
        Param { start: fixed(start), dx: fixed(dx[i]), dy: fixed(dy[i]) }
    }

    /// z: 21.11 in iterators of 20.12.
    fn depth(&self, from: &Corner) -> Param {
        let fixed = |value: f64| ((value as i64) << 1) as i32;
        let (start, [dx, dy]) = (from.narrow[Z], self.narrow);
        Param { start: fixed(start), dx: fixed(dx[Z]), dy: fixed(dy[Z]) }
    }

    fn wide(&self, from: &Corner, i: usize) -> WideParam {
        let fixed = |value: f64| value as i64;
        let (start, [dx, dy]) = (from.wide[i], self.wide);
        WideParam { start: fixed(start), dx: fixed(dx[i]), dy: fixed(dy[i]) }
    }

    /// The registers of the triangle of three places, values from `from`.
    #[inline]
    fn registers(&self, places: [[i32; 2]; 3], from: &Corner, extended: bool) -> Registers {
        let mut registers = Registers {
            x: places.map(|place| place[0]),
            y: places.map(|place| place[1]),
            negative: twice_area(&places) < 0,
            color: [0, 1, 2, 3].map(|i| self.param(from, i)),
            z: self.depth(from),
            ..Registers::default()
        };
        registers.tmu[0] = [0, 1, 2].map(|i| self.wide(from, i));
        if extended {
            registers.specular = [5, 6, 7, 8].map(|i| self.param(from, i));
        }
        registers
    }
}

/// The registers of a triangle that covers one pixel, with the values of a
/// corner.
pub(crate) fn pixel(x: u32, y: u32, values: &Corner, extended: bool) -> Registers {
    let (x, y) = (x as i32 * 16, y as i32 * 16);
    let places = AROUND_CENTER.map(|[dx, dy]| [x + dx, y + dy]);
    Planes::default().registers(places, values, extended)
}

/// The sign says which side the second of three places lies on.
fn twice_area(places: &[[i32; 2]; 3]) -> i64 {
    let [a, b, c] = places.map(|place| place.map(i64::from));
    (a[0] - b[0]) * (b[1] - c[1]) - (b[0] - c[0]) * (a[1] - b[1])
}

/// The order of three rows, from the top.
#[inline]
fn sorted(y: [i32; 3]) -> [usize; 3] {
    let mut order = [0, 1, 2];
    if y[order[0]] > y[order[1]] {
        order.swap(0, 1);
    }
    if y[order[1]] > y[order[2]] {
        order.swap(1, 2);
    }
    if y[order[0]] > y[order[1]] {
        order.swap(0, 1);
    }
    order
}

/// Sets a triangle up and passes it on, in several parts where its corners lie
/// too far away for the engine.
#[inline]
pub(crate) fn launch(
    corners: &[&Corner; 3],
    textured: bool,
    extended: bool,
    mut out: impl FnMut(&Registers),
) {
    let Some(planes) = Planes::new(corners, textured) else { return };
    let near = |v: i32| (-LIMIT..=LIMIT).contains(&v);
    if corners.iter().all(|corner| near(corner.x) && near(corner.y)) {
        let order = sorted(corners.map(|corner| corner.y));
        let places = order.map(|i| [corners[i].x, corners[i].y]);
        out(&planes.registers(places, corners[order[0]], extended));
        return;
    }
    let polygon = clipped(corners.map(|corner| [corner.x, corner.y]));
    for i in 2..polygon.len() {
        let places = [polygon[0], polygon[i - 1], polygon[i]];
        let places = sorted(places.map(|place| place[1])).map(|i| places[i]);
        if twice_area(&places) != 0 {
            let first = planes.corner_at(corners[0], places[0][0], places[0][1]);
            out(&planes.registers(places, &first, extended));
        }
    }
}

/// The part of a triangle that the engine can take, as a polygon.
fn clipped(triangle: [[i32; 2]; 3]) -> Vec<[i32; 2]> {
    let mut polygon = triangle.to_vec();
    // Nothing left of or above the first pixel is ever drawn.
    for (axis, limit, sign) in [(0, -16, 1), (0, LIMIT, -1), (1, -16, 1), (1, LIMIT, -1)] {
        let from = std::mem::take(&mut polygon);
        let inside = |p: &[i32; 2]| (p[axis] - limit) * sign >= 0;
        for (i, &a) in from.iter().enumerate() {
            let b = from[(i + 1) % from.len()];
            if inside(&a) {
                polygon.push(a);
            }
            if inside(&a) != inside(&b) {
                polygon.push(crossing(a, b, axis, limit));
            }
        }
    }
    polygon
}

/// Where the side from `a` to `b` meets a limit, to the nearest sixteenth.
fn crossing(a: [i32; 2], b: [i32; 2], axis: usize, limit: i32) -> [i32; 2] {
    let other = 1 - axis;
    // From the lower end, so that both neighbours of a side get one point.
    let (a, b) = if a[axis] <= b[axis] { (a, b) } else { (b, a) };
    let [along, whole] = [limit - a[axis], b[axis] - a[axis]].map(i64::from);
    let change = i64::from(b[other] - a[other]) * along;
    let mut place = [limit; 2];
    place[other] = a[other] + ((2 * change + whole).div_euclid(2 * whole)) as i32;
    place
}

#[cfg(test)]
mod tests {
    use super::*;

    fn corner(x: i32, y: i32, red: f64) -> Corner {
        let mut narrow = [0.0; NARROW];
        narrow[0] = red;
        Corner { x: x * 16, y: y * 16, narrow, wide: [0.0; 3] }
    }

    #[test]
    fn steps_are_per_pixel() {
        let (a, b, c) =
            (corner(10, 10, 0.0), corner(20, 10, 4096.0 * 10.0), corner(10, 30, 4096.0));
        let mut found = Vec::new();
        launch(&[&a, &b, &c], false, false, |registers| found.push(*registers));
        let [registers] = found[..] else { panic!("one triangle") };
        assert_eq!(registers.color[0], Param { start: 0, dx: 4096, dy: 204 });
        assert_eq!((registers.x, registers.y), ([160, 320, 160], [160, 160, 480]));
    }

    #[test]
    fn far_corners_are_cut_off() {
        let (a, b, c) = (corner(-9000, 5, 0.0), corner(9000, 5, 0.0), corner(0, 30000, 0.0));
        let mut count = 0;
        launch(&[&a, &b, &c], false, false, |registers| {
            count += 1;
            assert!(registers.x.iter().chain(&registers.y).all(|v| v.abs() <= LIMIT));
        });
        assert!(count >= 2);
        launch(&[&a, &a, &c], false, false, |_| panic!("it has no area"));
    }
}
