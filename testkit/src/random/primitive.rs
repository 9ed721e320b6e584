//! Random triangles, as vertices and as registers.

use fillrate_engine::{
    Cull, Param, Registers, TmuVertex, VeriteExtra, VeriteVertex, Vertex, VertexExtra, WideParam,
};

use super::Rng;
use crate::reference::{SetUp, set_up_extended};

/// A triangle for a surface of `width` x `height`, of any kind: ordinary,
/// sliver, huge, off-screen, degenerate, sub-pixel, biased, along pixel
/// centres, or of wild numbers.
pub fn vertices(rng: &mut Rng, width: u32, height: u32) -> [Vertex; 3] {
    let corners = corners(rng, width as f32, height as f32);
    let style = Style::random(rng);
    let mut out = corners.map(|(x, y)| style.vertex(rng, x, y));
    if rng.one_in(4) {
        // Of one colour.
        let Vertex { r, g, b, a, .. } = out[0];
        out = out.map(|vertex| Vertex { r, g, b, a, ..vertex });
    }
    if rng.one_in(20) {
        spoil(rng, &mut out);
    }
    out
}

type Corners = [(f32, f32); 3];

fn corners(rng: &mut Rng, width: f32, height: f32) -> Corners {
    let inside = |rng: &mut Rng| (rng.float(0.0, width), rng.float(0.0, height));
    match rng.below(16) {
        0 => sliver(rng, width, height),
        1 => three(rng, |rng| (rng.float(-2100.0, 2100.0), rng.float(-2100.0, 2100.0))),
        2 => three(rng, |rng| (rng.float(-1e6, 1e6), rng.float(-1e6, 1e6))),
        3 => off_screen(rng, width, height),
        4 => degenerate(rng, width, height),
        5 => sub_pixel(rng, width, height),
        6 => three(rng, inside).map(|(x, y)| (x + 786_432.0, y + 786_432.0)),
        7 => on_grid(rng, width, height, 0.5),
        8 => on_grid(rng, width, height, 0.0),
        9 => on_grid(rng, width, height, 0.25),
        10 => three(rng, |rng| (rng.float(-width, 2.0 * width), rng.float(-height, 2.0 * height))),
        11 => three(rng, |rng| (rng.any_float(), rng.any_float())),
        _ => three(rng, inside),
    }
}

fn three(rng: &mut Rng, mut corner: impl FnMut(&mut Rng) -> (f32, f32)) -> Corners {
    [corner(rng), corner(rng), corner(rng)]
}

/// Long, and less than a pixel thick.
fn sliver(rng: &mut Rng, width: f32, height: f32) -> Corners {
    let (x, y) = (rng.float(0.0, width), rng.float(0.0, height));
    let (u, v) = (rng.float(0.0, width), rng.float(0.0, height));
    let thickness = rng.float(0.01, 1.0);
    [(x, y), (u, v), (u + rng.float(-thickness, thickness), v + thickness)]
}

fn off_screen(rng: &mut Rng, width: f32, height: f32) -> Corners {
    let (dx, dy) = rng.pick(&[(-width, 0.0), (width, 0.0), (0.0, -height), (0.0, height)]);
    three(rng, |rng| (rng.float(0.0, width) + dx, rng.float(0.0, height) + dy))
}

/// Two corners the same, three in a line, or nearly so.
fn degenerate(rng: &mut Rng, width: f32, height: f32) -> Corners {
    let (x, y) = (rng.float(0.0, width), rng.float(0.0, height));
    let (dx, dy) = (rng.float(-9.0, 9.0), rng.float(-9.0, 9.0));
    match rng.below(4) {
        0 => [(x, y), (x + dx, y + dy), (x, y)],
        1 => [(x, y); 3],
        2 => [(x, y), (x + dx, y), (x + 2.0 * dx, y)],
        _ => [(x, y), (x + dx, y + dy), (x + 2.0 * dx, y + 2.0 * dy)],
    }
}

fn sub_pixel(rng: &mut Rng, width: f32, height: f32) -> Corners {
    let (x, y) = (rng.float(0.0, width), rng.float(0.0, height));
    three(rng, |rng| (x + rng.float(-0.6, 0.6), y + rng.float(-0.6, 0.6)))
}

/// Corners exactly on a grid of whole pixels plus `offset`.
fn on_grid(rng: &mut Rng, width: f32, height: f32, offset: f32) -> Corners {
    three(rng, |rng| {
        let (x, y) = (rng.float(-4.0, width + 4.0), rng.float(-4.0, height + 4.0));
        (x.floor() + offset, y.floor() + offset)
    })
}

/// How the values of a triangle's vertices are chosen.
struct Style {
    colors: u32,
    depths: u32,
    perspective: u32,
    texture_scale: f32,
}

impl Style {
    fn random(rng: &mut Rng) -> Style {
        Style {
            colors: rng.below(8),
            depths: rng.below(8),
            perspective: rng.below(12),
            texture_scale: rng.pick(&[0.0, 4.0, 64.0, 256.0, 1024.0, 16384.0, 1e9]),
        }
    }

    fn vertex(&self, rng: &mut Rng, x: f32, y: f32) -> Vertex {
        let [r, g, b, a] = [(); 4].map(|()| self.color(rng));
        let w = self.w(rng);
        let tmu = [(); 3].map(|()| self.tmu(rng, w));
        Vertex { x, y, r, g, b, a, z: self.z(rng), w, tmu }
    }

    fn color(&self, rng: &mut Rng) -> f32 {
        match self.colors {
            0 => rng.pick(&[0.0, 255.0]),
            1 => rng.float(-300.0, 600.0),
            2 => rng.any_float(),
            3 => rng.pick(&[-1.0, 0.0, 255.0, 256.0, 255.99]),
            _ => rng.float(0.0, 255.0),
        }
    }

    fn z(&self, rng: &mut Rng) -> f32 {
        match self.depths {
            0 => rng.pick(&[0.0, 65535.0]),
            1 => rng.float(-70000.0, 140_000.0),
            2 => rng.any_float(),
            3 => 30000.0,
            _ => rng.float(0.0, 65535.0),
        }
    }

    fn w(&self, rng: &mut Rng) -> f32 {
        match self.perspective {
            0 => 1.0,
            1 => rng.float(-1.0, 1.0),
            2 => rng.float(-1.0, 0.0),
            3 => 0.0,
            4 => rng.float(0.0, 1e-4),
            5 => rng.float(-1e-9, 1e-9),
            6 => rng.any_float(),
            7 => rng.float(0.5, 70000.0),
            _ => 1.0 / rng.float(1.0, 200.0),
        }
    }

    fn tmu(&self, rng: &mut Rng, w: f32) -> TmuVertex {
        let scale = self.texture_scale;
        let w = if rng.one_in(8) { self.w(rng) } else { w };
        let mut over_w = || rng.float(-0.25 * scale, scale) * w;
        TmuVertex { s: over_w(), t: over_w(), w }
    }
}

/// What the vertices of a triangle have besides.
pub fn extras(rng: &mut Rng) -> [VertexExtra; 3] {
    let style = Style::random(rng);
    let depth = rng.pick(&[1.0, 65536.0, 16_777_216.0, 4e9, 1e19]);
    let color = |rng: &mut Rng| style.color(rng);
    [(); 3].map(|()| VertexExtra {
        specular: [(); 3].map(|()| color(rng)),
        fog: color(rng),
        base: [(); 3].map(|()| color(rng)),
        deep_z: depth * f64::from(if style.depths == 0 { 0.5 } else { rng.float(-0.1, 1.1) }),
    })
}

/// A triangle for the Vérité's set-up, of the same kinds; some have no extras.
pub fn verite_corners(rng: &mut Rng, width: u32, height: u32) -> [(VeriteVertex, VeriteExtra); 3] {
    let corners = corners(rng, width as f32, height as f32);
    let (colors, depths, texels) = (rng.below(8), rng.below(8), rng.below(8));
    let scale = rng.pick(&[4.0, 64.0, 256.0, 1024.0, 16384.0, 1e9]);
    let color = |rng: &mut Rng| match colors {
        0 => rng.pick(&[0, 255 << 12]),
        1 => rng.word() as i32,
        2 => rng.pick(&[-1, 1 << 20, i32::MIN, i32::MAX, 0xf_ffff]),
        _ => rng.below(255 << 12) as i32,
    };
    let depth = |rng: &mut Rng| match depths {
        0 => rng.pick(&[0, 0xffff << 11]),
        1 => rng.word() as i32,
        2 => rng.range(-(70_000 << 11), 140_000 << 11),
        3 => 30_000 << 11,
        _ => rng.below(1 << 27) as i32,
    };
    let texel = |rng: &mut Rng| {
        let unit = |rng: &mut Rng, low: f32, high: f32| f64::from(rng.float(low, high));
        let one = 4_294_967_296.0;
        match texels {
            0 => [(); 3].map(|()| f64::from_bits(rng.bits())),
            1 => [(); 3].map(|()| rng.pick(&[0.0, -0.5, 1e15, -9.3e18, 1e300, f64::NAN])),
            _ => {
                let q = unit(rng, if texels == 2 { -0.1 } else { 0.005 }, 1.0);
                let [s, t] = [(); 2].map(|()| unit(rng, -0.25, 1.0) * scale * q * one);
                [s, t, q * one]
            }
        }
    };
    let (plain, one_color) = (rng.one_in(3), rng.maybe(4, |rng| [(); 4].map(|()| color(rng))));
    corners.map(|(x, y)| {
        let [first, second] = [(); 2].map(|()| [(); 4].map(|()| color(rng)));
        let first = one_color.unwrap_or(first);
        let (x, y) = ((x * 16.0) as i16, (y * 16.0) as i16);
        let vertex = VeriteVertex { color: first, z: depth(rng), x, y };
        let extra = VeriteExtra { specular: second, texel: texel(rng) };
        (vertex, if plain { VeriteExtra::default() } else { extra })
    })
}

/// Puts a wild number into some field.
fn spoil(rng: &mut Rng, vertices: &mut [Vertex; 3]) {
    let bad = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, 1e-45, -0.0, -f32::MAX];
    let vertex = &mut vertices[rng.below(3) as usize];
    let tmu = &mut vertex.tmu[rng.below(3) as usize];
    let fields = [
        &mut vertex.x,
        &mut vertex.y,
        &mut vertex.r,
        &mut vertex.g,
        &mut vertex.b,
        &mut vertex.a,
        &mut vertex.z,
        &mut vertex.w,
        &mut tmu.s,
        &mut tmu.t,
        &mut tmu.w,
    ];
    let index = rng.below(fields.len() as u32) as usize;
    *fields[index] = rng.pick(&bad);
}

/// Registers of a triangle: those of a random one, often changed, or noise.
pub fn registers(rng: &mut Rng, width: u32, height: u32) -> Registers {
    let mut made = || set_up_extended(&vertices(rng, width, height), &extras(rng), Cull::Disabled);
    let drawn = (0..4).find_map(|_| match made() {
        SetUp::Drawn(registers) => Some(*registers),
        SetUp::Empty | SetUp::Culled => None,
    });
    let mut out = drawn.unwrap_or_default();
    match rng.below(6) {
        0 => out.negative = !out.negative,
        1 => noise(rng, &mut out),
        2 => out.y = [(); 3].map(|()| rng.range(-64, height as i32 * 16 + 64)),
        3 => out.x = [(); 3].map(|()| i32::from(rng.word() as i16)),
        _ => {}
    }
    out
}

/// Random iterators, up to all their bits.
fn noise(rng: &mut Rng, out: &mut Registers) {
    let shift = rng.below(32);
    let narrow = |rng: &mut Rng| (rng.word() as i32) >> shift;
    let second = out.specular.iter_mut().chain(&mut out.base);
    for param in out.color.iter_mut().chain([&mut out.z]).chain(second) {
        *param = Param { start: narrow(rng), dx: narrow(rng), dy: narrow(rng) };
    }
    let shift = rng.below(64);
    let wide = |rng: &mut Rng| (rng.bits() as i64) >> shift;
    for param in out.tmu.as_flattened_mut().iter_mut().chain([&mut out.w, &mut out.deep_z]) {
        *param = WideParam { start: wide(rng), dx: wide(rng), dy: wide(rng) };
    }
}
