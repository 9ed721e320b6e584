//! Vertices to the engine's registers.
//!
//! Gradients come from coordinates in sixteenths of a pixel, as coverage does,
//! in double precision; iterators have the engine's formats: colours 12.12, z
//! 21.11, texture coordinates and Q 32 fraction bits.
//!
//! Source: RR, vertex types and attribute formats.

use fillrate_engine::setup::{VeriteSlopes, verite_triangle};
use fillrate_engine::state::Rect;
use fillrate_engine::{Param, Registers, VeriteExtra, VeriteVertex, WideParam};

use super::state::State;
use crate::opcode::Register;
use crate::vertex::{Attribute, Layout};

/// Colour, alpha, z, specular colour, fog.
const NARROW: usize = 9;
/// Index of alpha among them.
pub(crate) const ALPHA: usize = 3;
/// Index of fog in [`VeriteExtra::specular`].
const FOG: usize = 3;
/// Index of z among them.
const Z: usize = 4;
/// 1.0 with 32 fraction bits.
const ONE: f64 = 4_294_967_296.0;
/// Places around the centre of a pixel, and around no other, in sixteenths.
const AROUND_CENTER: [[i32; 2]; 3] = [[4, 4], [12, 4], [8, 12]];
/// The farthest coordinate that the engine takes, in sixteenths.
const LIMIT: i32 = 2047 * 16;

/// A vertex as it was read.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Corner {
    /// Column and row in sixteenths.
    pub place: [i32; 2],
    /// As the engine takes it; its place counts within [`LIMIT`].
    pub vertex: VeriteVertex,
    /// What states may read besides.
    pub extra: VeriteExtra,
}

impl Corner {
    /// The same corner at another place.
    pub fn at(&self, place: [i32; 2]) -> Corner {
        let mut corner = Corner { place, ..*self };
        put(place, &mut corner.vertex);
        corner
    }

    /// The same corner where pixel `at` is the first one.
    pub fn moved(&self, [x, y]: [u32; 2]) -> Corner {
        self.at([self.place[0] - (x << 4) as i32, self.place[1] - (y << 4) as i32])
    }

    /// The same corner of a texture that begins with another texel.
    pub fn beginning_at(&self, at: [f64; 2]) -> Corner {
        self.with_texel(texel_beginning_at(self.extra.texel, at))
    }

    /// The same corner with another texel.
    pub fn with_texel(&self, texel: [f64; 3]) -> Corner {
        Corner { extra: VeriteExtra { texel, ..self.extra }, ..*self }
    }
}

/// Puts a vertex at a place.
#[inline(always)]
fn put([x, y]: [i32; 2], vertex: &mut VeriteVertex) {
    (vertex.x, vertex.y) = (x as i16, y as i16);
}

fn texel_beginning_at([u, v, q]: [f64; 3], [s, t]: [f64; 2]) -> [f64; 3] {
    [u - s * q, v - t * q, q]
}

/// What a vertex has but its place, for what lies between two of them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Values {
    /// Red, green, blue, alpha (12.12), z (21.11), specular red, green, blue
    /// and fog (12.12).
    pub narrow: [f64; NARROW],
    /// Column and row of the texture times Q, and Q, with 32 fraction bits.
    pub texel: [f64; 3],
}

impl From<&Corner> for Values {
    fn from(Corner { vertex, extra, .. }: &Corner) -> Values {
        let ([r, g, b, a], [sr, sg, sb, fog]) = (vertex.color, extra.specular);
        let narrow = [r, g, b, a, vertex.z, sr, sg, sb, fog].map(f64::from);
        Values { narrow, texel: extra.texel }
    }
}

impl Values {
    /// Values between two corners.
    pub fn between(a: &Corner, b: &Corner, fraction: f64) -> Values {
        let (a, b) = (Values::from(a), Values::from(b));
        let mix = |a: f64, b: f64| a + (b - a) * fraction;
        Values {
            narrow: std::array::from_fn(|i| mix(a.narrow[i], b.narrow[i])),
            texel: std::array::from_fn(|i| mix(a.texel[i], b.texel[i])),
        }
    }

    /// See [`Corner::beginning_at`].
    pub fn beginning_at(&self, at: [f64; 2]) -> Values {
        Values { texel: texel_beginning_at(self.texel, at), ..*self }
    }
}

/// What vertices are read with: defaults of attributes that a type lacks, and
/// what becomes of texture coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Attributes {
    /// Default attributes; place and texel mean nothing.
    defaults: Corner,
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
#[inline]
fn channel(word: u32) -> i32 {
    (word as i32).clamp(0, 0xff_ffff) >> 4
}

/// Red, green, blue and alpha of a packed colour as 12.12.
#[inline]
fn packed(word: u32) -> [i32; 4] {
    let [b, g, r, a] = word.to_le_bytes().map(|byte| i32::from(byte) << 12);
    [r, g, b, a]
}

/// The same with another alpha.
#[inline]
fn packed_with(word: u32, alpha: i32) -> [i32; 4] {
    let [r, g, b, _] = packed(word);
    [r, g, b, alpha]
}

/// z of 16.16 as 21.11.
#[inline]
fn depth(word: u32) -> i32 {
    (word >> 5) as i32
}

/// 16.16 to sixteenths, to the nearest.
#[inline]
pub(crate) fn sixteenths(word: u32) -> i32 {
    ((word as i32 >> 11) + 1) >> 1
}

/// A vertex's place in sixteenths.
#[inline(always)]
pub(crate) fn place(layout: &Layout, words: &[u32]) -> [i32; 2] {
    let [x, y] = [layout.get(words, Attribute::X), layout.get(words, Attribute::Y)];
    [sixteenths(x.unwrap_or(0)), sixteenths(y.unwrap_or(0))]
}

impl Attributes {
    /// What a state says. `filtered`: samples lie between texels.
    pub fn new(state: &State, filtered: bool, extended: bool) -> Attributes {
        let get = |register| state.get(register);
        let [r, g, b, a, f] = [Register::R, Register::G, Register::B, Register::A, Register::F]
            .map(|register| channel(get(register)));
        let specular = packed_with(get(Register::SpecularColorRgb), f);
        // The engine takes half a texel off where it filters; the chip does not.
        let half = if filtered { 0.5 } else { 0.0 };
        let offset = |register| f64::from(get(register) as i32) / 65536.0 + half;
        let multiplier = |register| f64::from(get(register)) / 65536.0;
        let (color, z) = ([r, g, b, a], depth(get(Register::Z)));
        Attributes {
            defaults: Corner {
                vertex: VeriteVertex { color, z, ..VeriteVertex::default() },
                extra: VeriteExtra { specular, ..VeriteExtra::default() },
                ..Corner::default()
            },
            coordinates: [get(Register::U), get(Register::V)],
            multipliers: [multiplier(Register::UMultiplier), multiplier(Register::VMultiplier)],
            offsets: [offset(Register::SOffset), offset(Register::TOffset)],
            swap: state.is_set(Register::SwapUv),
            extended,
        }
    }

    /// A vertex of the default attributes at a place, in sixteenths.
    pub fn corner(&self, place: [i32; 2], [u, v]: [u32; 2]) -> Corner {
        self.defaults.at(place).with_texel(self.texel(u, v, ONE))
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
    pub fn read(&self, layout: &Layout, words: &[u32], textured: bool) -> Corner {
        let place = place(layout, words);
        let Corner { mut vertex, mut extra, .. } = self.defaults;
        self.read_to(layout, words, place, &mut vertex);
        self.read_extra_to(layout, words, textured, &mut extra);
        Corner { place, vertex, extra }
    }

    /// What a vertex has for every state, to where it is kept: faster than making
    /// it and moving it there.
    #[inline(always)]
    pub fn read_to(&self, layout: &Layout, words: &[u32], place: [i32; 2], to: &mut VeriteVertex) {
        let get = |attribute| layout.get(words, attribute);
        let VeriteVertex { mut color, z, .. } = self.defaults.vertex;
        put(place, to);
        to.z = get(Attribute::Z).map_or(z, depth);
        if let Some(k) = get(Attribute::K) {
            color = packed_with(k, color[ALPHA]);
        } else if let Some(r) = get(Attribute::R) {
            color[0] = channel(r);
            color[1] = get(Attribute::G).map_or(color[1], channel);
            color[2] = get(Attribute::B).map_or(color[2], channel);
        } else if let Some(i) = get(Attribute::I) {
            color[..3].fill(channel(i));
        } else if let Some(ka) = get(Attribute::Ka) {
            color = packed(ka);
        }
        to.color = color;
        if let Some(a) = get(Attribute::A) {
            to.color[ALPHA] = channel(a);
        }
    }

    /// What it has besides.
    #[inline]
    pub fn read_extra_to(
        &self,
        layout: &Layout,
        words: &[u32],
        textured: bool,
        to: &mut VeriteExtra,
    ) {
        *to = self.defaults.extra;
        if self.extended {
            to.specular = self.read_extended(layout, words);
        }
        if textured {
            to.texel = self.read_texel(layout, words);
        }
    }

    #[inline(never)]
    fn read_extended(&self, layout: &Layout, words: &[u32]) -> [i32; 4] {
        let mut specular = self.defaults.extra.specular;
        if let Some(s) = layout.get(words, Attribute::S) {
            specular = packed_with(s, specular[FOG]);
        } else if let Some(sf) = layout.get(words, Attribute::Sf) {
            specular = packed(sf);
        } else if let Some(fog) = layout.get(words, Attribute::Fp) {
            specular[FOG] = packed(fog)[FOG];
        }
        if let Some(f) = layout.get(words, Attribute::F) {
            specular[FOG] = channel(f);
        }
        specular
    }

    #[inline]
    fn read_texel(&self, layout: &Layout, words: &[u32]) -> [f64; 3] {
        let u = layout.get(words, Attribute::U).unwrap_or(self.coordinates[0]);
        let v = layout.get(words, Attribute::V).unwrap_or(self.coordinates[1]);
        // 8.24 to 32 fraction bits.
        let q = layout.get(words, Attribute::Q).map_or(ONE, |q| f64::from(q) * 256.0);
        self.texel(u, v, q)
    }
}

/// How far a triangle reaches, in sixteenths.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Extent {
    low: [i32; 2],
    high: [i32; 2],
}

impl Extent {
    #[inline]
    pub fn new([a, b, c]: [[i32; 2]; 3]) -> Extent {
        let low = |axis: usize| a[axis].min(b[axis]).min(c[axis]);
        let high = |axis: usize| a[axis].max(b[axis]).max(c[axis]);
        Extent { low: [low(0), low(1)], high: [high(0), high(1)] }
    }

    /// Where the triangle's pixels are.
    #[inline]
    pub fn pixels(&self) -> Rect {
        let [x0, y0] = self.low.map(|v| (v >> 4).max(0) as u32);
        let [x1, y1] = self.high.map(|v| ((v >> 4) + 1).max(0) as u32);
        Rect::new(x0, y0, x1, y1)
    }

    /// Whether the engine takes it as it is.
    #[inline]
    pub fn is_near(&self) -> bool {
        self.low[0].min(self.low[1]) >= -LIMIT && self.high[0].max(self.high[1]) <= LIMIT
    }
}

/// The planes of a triangle that is cut: values at a corner, and steps.
#[derive(Clone, Copy, Debug)]
struct Planes {
    place: [i32; 2],
    start: Values,
    /// Of a pixel to the right and below.
    narrow: [[f64; NARROW]; 2],
    texel: [[f64; 3]; 2],
}

impl Planes {
    /// The planes through three corners; `None` where they lie on a line.
    fn new([a, b, c]: [&Corner; 3]) -> Option<Planes> {
        let slopes = VeriteSlopes::new([a.place, b.place, c.place])?;
        let values = [a, b, c].map(Values::from);
        Some(Planes {
            place: a.place,
            start: values[0],
            narrow: slopes.steps(values.each_ref().map(|values| &values.narrow)),
            texel: slopes.steps(values.each_ref().map(|values| &values.texel)),
        })
    }

    /// The values at a place.
    fn at(&self, [x, y]: [i32; 2]) -> Values {
        let columns = f64::from(x - self.place[0]) / 16.0;
        let rows = f64::from(y - self.place[1]) / 16.0;
        let at = |start: f64, dx: f64, dy: f64| start + dx * columns + dy * rows;
        let Planes { start, narrow, texel, .. } = self;
        Values {
            narrow: std::array::from_fn(|i| at(start.narrow[i], narrow[0][i], narrow[1][i])),
            texel: std::array::from_fn(|i| at(start.texel[i], texel[0][i], texel[1][i])),
        }
    }

    /// The registers of the part of three places, the first of them the upper one.
    fn registers(&self, places: [[i32; 2]; 3]) -> Registers {
        let first = self.at(places[0]);
        registers(
            places,
            &first,
            [&self.narrow[0], &self.narrow[1]],
            [&self.texel[0], &self.texel[1]],
        )
    }
}

/// The registers of the triangle of three places with values at the first of them,
/// and steps.
fn registers(
    places: [[i32; 2]; 3],
    first: &Values,
    narrow: [&[f64; NARROW]; 2],
    texel: [&[f64; 3]; 2],
) -> Registers {
    let param = |i: usize| {
        let [start, dx, dy] = [first.narrow[i], narrow[0][i], narrow[1][i]].map(|v| v as i32);
        Param { start, dx, dy }
    };
    // 21.11 in iterators of 20.12.
    let [start, dx, dy] =
        [first.narrow[Z], narrow[0][Z], narrow[1][Z]].map(|v| ((v as i64) << 1) as i32);
    let wide = |i: usize| {
        let [start, dx, dy] = [first.texel[i], texel[0][i], texel[1][i]].map(|v| v as i64);
        WideParam { start, dx, dy }
    };
    Registers {
        x: places.map(|place| place[0]),
        y: places.map(|place| place[1]),
        negative: twice_area(&places) < 0,
        color: [0, 1, 2, ALPHA].map(param),
        z: Param { start, dx, dy },
        tmu: [[0, 1, 2].map(wide), Default::default(), Default::default()],
        specular: [5, 6, 7, 8].map(param),
        ..Registers::default()
    }
}

/// The registers of a triangle that covers one pixel, with the same values all
/// over it.
pub(crate) fn pixel(x: u32, y: u32, values: &Values) -> Registers {
    let (x, y) = (x as i32 * 16, y as i32 * 16);
    let places = AROUND_CENTER.map(|[dx, dy]| [x + dx, y + dy]);
    registers(places, values, [&[0.0; NARROW]; 2], [&[0.0; 3]; 2])
}

/// The sign says which side the second of three places lies on.
fn twice_area(places: &[[i32; 2]; 3]) -> i64 {
    let [a, b, c] = places.map(|place| place.map(i64::from));
    (a[0] - b[0]) * (b[1] - c[1]) - (b[0] - c[0]) * (a[1] - b[1])
}

/// The registers of a triangle: of several parts of it where its corners lie too
/// far away for the engine.
pub(crate) fn parts(corners: [&Corner; 3]) -> Vec<Registers> {
    let places = corners.map(|corner| corner.place);
    if Extent::new(places).is_near() {
        let (vertices, extras) = (corners.map(|c| &c.vertex), corners.map(|c| &c.extra));
        return verite_triangle(vertices, extras).into_iter().collect();
    }
    let Some(planes) = Planes::new(corners) else { return Vec::new() };
    let polygon = clipped(places);
    let fan = (2..polygon.len()).map(|i| [polygon[0], polygon[i - 1], polygon[i]]);
    let parts = fan.map(|mut places| {
        places.sort_by_key(|place| place[1]);
        places
    });
    parts.filter(|places| twice_area(places) != 0).map(|places| planes.registers(places)).collect()
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

    fn corner(x: i32, y: i32, red: i32) -> Corner {
        let vertex = VeriteVertex { color: [red, 0, 0, 0], ..VeriteVertex::default() };
        Corner { vertex, ..Corner::default() }.at([x * 16, y * 16])
    }

    #[test]
    fn far_corners_are_cut_off() {
        let (a, b, c) = (corner(-9000, 5, 0), corner(9000, 5, 1 << 20), corner(0, 30000, 0));
        let found = parts([&a, &b, &c]);
        assert!(found.len() >= 2);
        for registers in found {
            assert!(registers.x.iter().chain(&registers.y).all(|v| v.abs() <= LIMIT));
            assert_eq!(registers.color[0].dx, (1 << 20) / 18000);
        }
        assert_eq!(parts([&a, &a, &c]), []);
    }

    /// What is cut has the planes of what is not.
    #[test]
    fn parts_lie_in_one_plane() {
        let corners = [corner(10, 10, 0), corner(20, 10, 4096 * 10), corner(10, 30, 4096)];
        let [a, b, c] = corners.each_ref();
        let [whole] = parts([a, b, c])[..] else { panic!("one triangle") };
        let planes = Planes::new([a, b, c]).unwrap();
        assert_eq!(planes.registers([a.place, b.place, c.place]), whole);
    }
}
