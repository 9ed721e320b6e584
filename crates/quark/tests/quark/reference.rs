//! The pixel rules of Quark 3D, slow and obvious: what the engine must draw.
//!
//! Written from `docs/sources.md`, Quark 3D, and sharing nothing with the
//! crate but its public types. All numbers are wide enough never to wrap.

use std::sync::Arc;

use fillrate_quark::{DrawMode, RasterState, Texture, TriangleMode, Vertex};

/// A frame buffer of words: base 0..7, intensity 8..12, 1/z 16..31.
pub struct Reference {
    pub width: i128,
    pub height: i128,
    pub words: Vec<u32>,
    pub zc_error_max: i128,
    /// Palette colour nearest to each 15-bit colour, once it was looked for.
    nearest: Vec<Option<u32>>,
}

/// What a fragment brings along.
struct Fragment {
    depth: u32,
    /// Base colour and intensity.
    color: u32,
}

/// Whether and how depth counts.
#[derive(Clone, Copy, PartialEq)]
enum Depth {
    Ignored,
    Tested,
}

fn base_channels(base: u32) -> [u32; 3] {
    let three = |v: u32| v * 32 + v * 4 + v / 2;
    [base / 64 * 85, three(base / 8 % 8), three(base % 8)]
}

/// 8-bit red, green and blue of a 13-bit colour.
pub fn channels(color: u32) -> [u32; 3] {
    base_channels(color % 256).map(|c| (c * (color / 256 % 32) + 15) / 31)
}

fn inverse_z(z: i32) -> i128 {
    if z < 64 { 65535 } else { 4_194_303 / i128::from(z) }
}

fn ceil_div(a: i128, b: i128) -> i128 {
    -(-a).div_euclid(b)
}

/// A plane through three corners: its value at a reference pixel and its
/// gradients, rounded down to 16 fraction bits.
struct Plane {
    value: i128,
    dx: i128,
    dy: i128,
    reference: [i128; 2],
}

impl Plane {
    fn new(at: [[i128; 2]; 3], values: [i128; 3], reference: [i128; 2]) -> Plane {
        let d = |i: usize, k: usize| at[i][k] - at[0][k];
        let mut area = d(1, 0) * d(2, 1) - d(2, 0) * d(1, 1);
        let (v1, v2) = (values[1] - values[0], values[2] - values[0]);
        let (mut dx, mut dy) = (v1 * d(2, 1) - v2 * d(1, 1), v2 * d(1, 0) - v1 * d(2, 0));
        if area < 0 {
            (area, dx, dy) = (-area, -dx, -dy);
        }
        let [x, y] = [reference[0] - at[0][0], reference[1] - at[0][1]];
        let fixed = |n: i128| (n << 16).div_euclid(area);
        let value = fixed(values[0] * area + dx * x + dy * y);
        Plane { value, dx: fixed(dx), dy: fixed(dy), reference }
    }

    /// With 16 fraction bits.
    fn at(&self, x: i128, y: i128) -> i128 {
        self.value + self.dx * (x - self.reference[0]) + self.dy * (y - self.reference[1])
    }
}

impl Reference {
    pub fn new(width: u32, height: u32) -> Reference {
        Reference {
            width: width.into(),
            height: height.into(),
            words: vec![0; (width * height) as usize],
            zc_error_max: 0,
            nearest: vec![None; 1 << 15],
        }
    }

    /// The palette colour for half of each.
    fn average(&mut self, a: u32, b: u32) -> u32 {
        let (a, b) = (channels(a), channels(b));
        let five: [u32; 3] = std::array::from_fn(|i| (a[i] + b[i]) / 2 / 8);
        let index = five[0] * 1024 + five[1] * 32 + five[2];
        *self.nearest[index as usize].get_or_insert_with(|| {
            let wanted = five.map(|c| c * 8 + c / 4);
            let distance = |color: &u32| -> u32 {
                channels(*color).iter().zip(wanted).map(|(c, w)| c.abs_diff(w).pow(2)).sum()
            };
            (0..8192).min_by_key(distance).expect("there are colours")
        })
    }

    /// Draws a fragment; `texel` where it has one, and the texture's key.
    fn fragment(
        &mut self,
        (x, y): (i128, i128),
        mode: DrawMode,
        depth: Depth,
        is_key: bool,
        fragment: Fragment,
    ) {
        if x < 0 || y < 0 || x >= self.width || y >= self.height {
            return;
        }
        let at = (y * self.width + x) as usize;
        let old = self.words[at];
        if depth == Depth::Tested && fragment.depth <= old >> 16 {
            return;
        }
        let keyed = matches!(mode, DrawMode::Keyed | DrawMode::AlphaKeyed);
        let alpha = matches!(mode, DrawMode::Alpha | DrawMode::AlphaKeyed);
        if keyed && is_key {
            return;
        }
        let color = if alpha { self.average(fragment.color, old & 0x1fff) } else { fragment.color };
        let written = if depth == Depth::Tested && !alpha { fragment.depth } else { old >> 16 };
        self.words[at] = written << 16 | color;
    }

    pub fn put_pixel(&mut self, x: i32, y: i32, color: u16) {
        let fragment = Fragment { depth: 0, color: u32::from(color) & 0x1fff };
        self.fragment((x.into(), y.into()), DrawMode::Opaque, Depth::Ignored, false, fragment);
    }

    /// Bresenham's line between points of column, row and distance.
    pub fn line(&mut self, mode: DrawMode, color: u32, mut a: [i32; 3], mut b: [i32; 3]) {
        if a.iter().chain(&b).any(|_| [a[0], a[1], b[0], b[1]].iter().any(|n| n.abs() > 1 << 20)) {
            return;
        }
        let major = usize::from((b[0] - a[0]).abs() < (b[1] - a[1]).abs());
        let minor = 1 - major;
        if a[major] > b[major] {
            std::mem::swap(&mut a, &mut b);
        }
        let length = i128::from(b[major] - a[major]);
        let rise = i128::from(b[minor] - a[minor]);
        let (za, zb) = (inverse_z(a[2]), inverse_z(b[2]));
        // Depth starts where the line's rectangle starts on the screen.
        let size = [self.width, self.height];
        let start = i128::from(a[major]).clamp(0, size[major]) - i128::from(a[major]);
        let step = if length == 0 { 0 } else { ((zb - za) << 16).div_euclid(length) };
        let value = match length {
            0 => za << 16,
            _ => ((za * length + (zb - za) * start) << 16).div_euclid(length) + 0x8000,
        };
        // The error term counts half lengths past the pixel below.
        let (mut along, mut across, mut error) = (0, i128::from(a[minor]), length);
        while along <= length {
            while error < 0 {
                across -= 1;
                error += 2 * length;
            }
            while length > 0 && error >= 2 * length {
                across += 1;
                error -= 2 * length;
            }
            let depth = (value + step * (along - start)) >> 16;
            let mut at = [0; 2];
            (at[major], at[minor]) = (i128::from(a[major]) + along, across);
            let fragment = Fragment { depth: depth as u32, color };
            self.fragment((at[0], at[1]), mode, Depth::Tested, false, fragment);
            along += 1;
            error += 2 * rise;
        }
    }

    /// A texture over a rectangle; `distance` where depth counts.
    pub fn sprite(
        &mut self,
        state: &RasterState,
        at: [i32; 2],
        size: [i128; 2],
        distance: Option<i32>,
    ) {
        let Some(texture) = &state.texture else { return };
        let texture = Arc::clone(texture);
        let sides = [i128::from(texture.width()), i128::from(texture.height())];
        let step = [0, 1].map(|i: usize| (sides[i] << 16) / size[i]);
        let depth = if distance.is_some() { Depth::Tested } else { Depth::Ignored };
        let [x0, y0] = at.map(i128::from);
        for y in y0.max(0)..(y0 + size[1]).min(self.height) {
            for x in x0.max(0)..(x0 + size[0]).min(self.width) {
                let (column, row) = (((x - x0) * step[0]) >> 16, ((y - y0) * step[1]) >> 16);
                let texel = texture.texels()[(row * sides[0] + column) as usize];
                let color = u32::from(texel) + u32::from(state.draw_intensity) / 8 * 256;
                let fragment = Fragment { depth: distance.map_or(0, inverse_z) as u32, color };
                let is_key = texture.is_keyed() && texel == 0;
                self.fragment((x, y), state.draw_mode, depth, is_key, fragment);
            }
        }
    }

    /// A triangle; the state's `z_sort` does not count.
    pub fn triangle(&mut self, state: &RasterState, mode: TriangleMode, corners: [Vertex; 3]) {
        let masks = corners.map(|c| c.m);
        if masks[0] & masks[1] & masks[2] != 0 || masks.iter().any(|m| m & 32 != 0) {
            return;
        }
        let at = corners.map(|c| [i128::from(c.x), i128::from(c.y)]);
        let d = |i: usize, k: usize| at[i][k] - at[0][k];
        let area = d(1, 0) * d(2, 1) - d(2, 0) * d(1, 1);
        if area == 0 || (state.test_culling && area > 0) {
            return;
        }
        if mode == TriangleMode::Wireframe {
            return self.wireframe(state, &corners);
        }
        if at.iter().flatten().any(|n| n.abs() > 1 << 20) {
            return;
        }
        let textured = matches!(mode, TriangleMode::Affine | TriangleMode::Perspective);
        let texture = state.texture.clone().filter(|t| textured && t.fits_triangles());
        let perspective = mode == TriangleMode::Perspective && !self.small_error(&corners);
        self.fill(state, texture.as_deref(), perspective, &corners, at);
    }

    fn wireframe(&mut self, state: &RasterState, corners: &[Vertex; 3]) {
        for i in 0..3 {
            let (a, b) = (&corners[i], &corners[(i + 1) % 3]);
            let mean = (i64::from(a.i) + i64::from(b.i)).div_euclid(2).clamp(0, 255) as u32;
            let color = u32::from(state.draw_color) + mean / 8 * 256;
            self.line(state.draw_mode, color, [a.x, a.y, a.z], [b.x, b.y, b.z]);
        }
    }

    fn small_error(&self, corners: &[Vertex; 3]) -> bool {
        let error = |i: usize| {
            let (a, b) = (&corners[i], &corners[(i + 1) % 3]);
            let distance = |a: i32, b: i32| (i128::from(a) - i128::from(b)).abs();
            let length = distance(a.x, b.x).max(distance(a.y, b.y));
            256 * length * distance(a.z, b.z) / (2 * (i128::from(a.z) + i128::from(b.z)).max(1))
        };
        (0..3).map(error).max().unwrap_or(0) < self.zc_error_max
    }

    fn fill(
        &mut self,
        state: &RasterState,
        texture: Option<&Texture>,
        perspective: bool,
        corners: &[Vertex; 3],
        at: [[i128; 2]; 3],
    ) {
        let range = |k: usize, end: i128| {
            let low = at.iter().map(|p| p[k]).min().unwrap_or(0).clamp(0, end);
            let high = at.iter().map(|p| p[k]).max().unwrap_or(0).clamp(0, end);
            low..high
        };
        let (columns, rows) = (range(0, self.width), range(1, self.height));
        let reference = [columns.start, rows.start];
        let plane = |values: [i128; 3]| Plane::new(at, values, reference);
        let iz = corners.map(|c| inverse_z(c.z));
        let depth = plane(iz);
        let light = plane(corners.map(|c| c.i.clamp(-32_000, 32_000).into()));
        let [u, v] = [corners.map(|c| c.u), corners.map(|c| c.v)].map(|values| {
            let least = values.iter().map(|&n| i128::from(n)).min().unwrap_or(0);
            values.map(|n| (i128::from(n) - least.div_euclid(256) * 256).min(65535))
        });
        let over_z = |c: [i128; 3]| std::array::from_fn(|i| c[i] * iz[i]);
        let coordinates = match perspective {
            true => [plane(over_z(u)), plane(over_z(v))],
            false => [plane(u), plane(v)],
        };
        for y in rows {
            let Some((left, right)) = span(&at, y) else { continue };
            for x in left.max(columns.start)..right.min(columns.end) {
                let mut base = u32::from(state.draw_color);
                let mut is_key = false;
                if let Some(texture) = texture {
                    let w = if perspective { depth.at(x, y) } else { 1 << 16 };
                    let texel = texel(texture, [&coordinates[0], &coordinates[1]], w, x, y);
                    base = u32::from(texel);
                    is_key = texture.is_keyed() && texel == 0;
                }
                let light = (light.at(x, y) >> 16).clamp(0, 255) as u32;
                let fragment = Fragment {
                    depth: ((depth.at(x, y) + 0x8000) >> 16) as u32,
                    color: base + light / 8 * 256,
                };
                self.fragment((x, y), state.draw_mode, Depth::Tested, is_key, fragment);
            }
        }
    }
}

/// The texel at a fragment: both coordinates over `w`, all with 16 fraction
/// bits, 256 units to a repeat.
fn texel(texture: &Texture, planes: [&Plane; 2], w: i128, x: i128, y: i128) -> u8 {
    let sides = [i128::from(texture.width()), i128::from(texture.height())];
    let place = |axis: usize| match w {
        ..=0 => 0,
        w => (planes[axis].at(x, y) * sides[axis]).div_euclid(w * 256).rem_euclid(sides[axis]),
    };
    texture.texels()[(place(1) * sides[0] + place(0)) as usize]
}

/// The columns of a row: from the first at or right of the left edge to the
/// last left of the right edge.
fn span(at: &[[i128; 2]; 3], y: i128) -> Option<(i128, i128)> {
    let mut columns = Vec::new();
    for i in 0..3 {
        let (mut a, mut b) = (at[i], at[(i + 1) % 3]);
        if a[1] > b[1] {
            std::mem::swap(&mut a, &mut b);
        }
        if (a[1]..b[1]).contains(&y) {
            columns.push(a[0] + ceil_div((b[0] - a[0]) * (y - a[1]), b[1] - a[1]));
        }
    }
    Some((*columns.iter().min()?, *columns.iter().max()?))
}
