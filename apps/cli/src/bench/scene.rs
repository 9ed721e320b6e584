//! Vertices and textures of the workloads: a fixed generator, so that every
//! renderer measured draws the same fragments.

use fillrate_glide::{GrTmuVertex, GrVertex};

/// A xorshift generator.
pub struct Random(pub u32);

impl Random {
    /// The next 32 bits.
    pub fn bits(&mut self) -> u32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        self.0
    }

    /// A float between `low` and `high`.
    fn float(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * (self.bits() >> 8) as f32 * (1.0 / 16_777_216.0)
    }
}

/// Texels of a texture in each direction; coordinates run to 256.
pub const TEXTURE: f32 = 256.0;
/// Side of the base texture in texels.
pub const BASE_SIDE: usize = 256;
/// Seed of its noise.
pub const BASE_SEED: u32 = 11;
/// Side of the light map in texels.
pub const LIGHT_SIDE: usize = 64;
/// Seed of its noise.
pub const LIGHT_SEED: u32 = 77;

/// A corner in the workloads' terms.
pub struct Corner {
    /// Column and row in pixels, rows from the top.
    pub at: (f32, f32),
    /// Depth, 0 (near) to 1.
    pub z: f32,
    /// Distance.
    pub w: f32,
    /// Red in the low byte, alpha in the high one.
    pub color: u32,
    /// Texture coordinates in repeats, of both units.
    pub st: [(f32, f32); 2],
}

impl Corner {
    /// The vertex; smaller `ooz` is nearer, so LEQUAL passes what is nearer.
    fn vertex(&self) -> GrVertex {
        let oow = 1.0 / self.w;
        let byte = |shift: u32| (self.color >> shift & 0xff) as f32;
        let tmu = |(s, t): (f32, f32)| GrTmuVertex {
            sow: s * TEXTURE * oow,
            tow: t * TEXTURE * oow,
            oow,
        };
        GrVertex {
            x: self.at.0,
            y: self.at.1,
            z: 0.0,
            r: byte(0),
            g: byte(8),
            b: byte(16),
            ooz: self.z * 65535.0,
            a: byte(24),
            oow,
            tmuvtx: self.st.map(tmu),
        }
    }
}

/// What differs between full-screen quads.
pub struct Quad {
    /// Depth at the bottom, 0 to 1; 0.01 more at the top.
    pub near: f32,
    /// Four colours instead of one.
    pub gouraud: bool,
    /// A floor from w = 1 at the bottom to 3 at the top; 1 everywhere without.
    pub perspective: bool,
    /// 0..=255.
    pub alpha: u32,
    /// Of the colours and the texture's place.
    pub seed: u32,
}

/// A full-screen quad as two triangles, its texture turned by 30 degrees.
pub fn quad((width, height): (f32, f32), quad: &Quad) -> [GrVertex; 6] {
    let alpha = quad.alpha << 24;
    let mut random = Random(quad.seed.wrapping_mul(2_654_435_761).wrapping_add(1));
    random.bits();
    random.bits();
    let flat = random.bits() & 0xff_ffff | alpha;
    let mut color = || match quad.gouraud {
        true => (random.bits() | 0x40_4040) & 0xff_ffff | alpha,
        false => flat,
    };
    let colors = [color(), color(), color(), color()];
    let offset = (random.bits() & 255) as f32 / 256.0;
    // Rows count from the bottom in the workloads, from the top here.
    let corners = [(0.0, height), (width, height), (width, 0.0), (0.0, 0.0)];
    [0, 1, 2, 0, 2, 3].map(|i: usize| {
        let top = i >= 2;
        let w = if quad.perspective && top { 3.0 } else { 1.0 };
        let z = if top { quad.near + 0.01 } else { quad.near };
        let (x, y) = ((corners[i].0 - width * 0.5) * w * 0.5 / TEXTURE, w * height / 480.0);
        let (cosine, sine) = (0.866_025_4, 0.5);
        let s = x * cosine - y * sine + offset;
        let t = x * sine + y * cosine + offset;
        let st = [(s, t), (s * 0.5, t * 0.5)];
        Corner { at: corners[i], z, w, color: colors[i], st }.vertex()
    })
}

/// A triangle over the first pixel of every `step` x `step` pixels.
pub fn dots((width, height): (f32, f32), step: u32) -> Vec<GrVertex> {
    let places = |side: f32| (0..side as u32).step_by(step as usize).map(|at| at as f32);
    let dot = |(x, y): (f32, f32)| {
        [(0.0, 0.0), (1.5, 0.0), (0.0, 1.5)].map(|(dx, dy)| {
            let at = (x + dx, y + dy);
            Corner { at, z: 0.5, w: 1.0, color: u32::MAX, st: [(0.0, 0.0); 2] }.vertex()
        })
    };
    let all = places(height).flat_map(|y| places(width).map(move |x| (x, y)));
    all.flat_map(dot).collect()
}

/// `count` triangles of `area` pixels each, in objects of 64.
pub fn triangles(count: usize, (width, height): (f32, f32), area: f32) -> Vec<GrVertex> {
    let mut r = Random(0x00C0_FFEE);
    let mut out = Vec::with_capacity(count * 3);
    let (mut cx, mut cy, mut cz, mut cw) = (0.0, 0.0, 0.0, 1.0);
    let (mut ou, mut ov) = (0.0, 0.0);
    for i in 0..count {
        if i % 64 == 0 {
            (cx, cy) = (r.float(60.0, width - 60.0), r.float(60.0, height - 60.0));
            (cz, cw) = (r.float(0.1, 0.9), r.float(1.0, 4.0));
            (ou, ov) = (r.float(0.0, 1.0), r.float(0.0, 1.0));
        }
        let angle = r.float(0.0, std::f32::consts::TAU);
        let (aspect, skew) = (r.float(0.6, 1.6), r.float(-0.4, 0.4));
        let (a, b) = ((2.0 * area).sqrt() * aspect, (2.0 * area).sqrt() / aspect);
        let local = [(0.0, 0.0), (a, 0.0), (a * (0.3 + skew), b)];
        let (sine, cosine) = angle.sin_cos();
        let (ox, oy) = (cx + r.float(-40.0, 40.0), cy + r.float(-40.0, 40.0));
        for (px, py) in local {
            let at = (ox + px * cosine - py * sine, oy + px * sine + py * cosine);
            let (z, w) = (cz + r.float(-0.02, 0.02), cw * r.float(0.97, 1.03));
            let st = (ou + (at.0 - cx) / TEXTURE, ov + (at.1 - cy) / TEXTURE);
            let color = r.bits() & 0xff_ffff | 0xff80_8080;
            out.push(Corner { at, z, w, color, st: [st, st] }.vertex());
        }
    }
    out
}

/// A chain of 565 levels: noise over a ramp, box-filtered down to one texel.
pub fn texture(side: usize, seed: u32) -> Vec<u8> {
    let mut random = Random(seed | 1);
    let mut level: Vec<[u32; 3]> = Vec::with_capacity(side * side);
    for y in 0..side {
        for x in 0..side {
            let noise = random.bits();
            level.push([
                (x * 255 / side / 2) as u32 + (noise & 127),
                (y * 255 / side / 2) as u32 + (noise >> 8 & 127),
                64 + (noise >> 16 & 127),
            ]);
        }
    }
    let mut bytes = Vec::new();
    let mut size = side;
    loop {
        for [r, g, b] in &level {
            let texel = (r >> 3 << 11 | g >> 2 << 5 | b >> 3) as u16;
            bytes.extend(texel.to_le_bytes());
        }
        if size == 1 {
            return bytes;
        }
        level = half(&level, size);
        size /= 2;
    }
}

/// A level of half the size: each texel the mean of four.
fn half(level: &[[u32; 3]], size: usize) -> Vec<[u32; 3]> {
    let at = |x: usize, y: usize| level[y * size + x];
    let mean = |x: usize, y: usize, c: usize| {
        let sum = at(x, y)[c] + at(x + 1, y)[c] + at(x, y + 1)[c] + at(x + 1, y + 1)[c];
        (sum + 2) >> 2
    };
    let places = (0..size / 2).flat_map(|y| (0..size / 2).map(move |x| (2 * x, 2 * y)));
    places.map(|(x, y)| core::array::from_fn(|c| mean(x, y, c))).collect()
}
