//! Random input from a seed, and naive measures.

use fillrate_geometry::{Plane, Vec3, Vertex};

/// SplitMix64.
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        let base = std::env::var("FILLRATE_SEED").ok().and_then(|text| text.parse().ok());
        Self(base.unwrap_or(1_u64).wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(seed))
    }

    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    pub fn below(&mut self, end: usize) -> usize {
        (self.bits() % end as u64) as usize
    }

    pub fn range(&mut self, low: f32, high: f32) -> f32 {
        low + (self.bits() >> 40) as f32 / 16_777_216.0 * (high - low)
    }

    pub fn vector(&mut self, size: f32) -> Vec3 {
        Vec3::new(self.range(-size, size), self.range(-size, size), self.range(-size, size))
    }

    /// A plane that passes near the origin.
    pub fn plane(&mut self) -> Plane {
        let distance = self.range(-4.0, 4.0);
        let normal = self.vector(1.0);
        Plane { normal: normal.normalized().unwrap_or(Vec3::new(1.0, 0.0, 0.0)), distance }
    }

    /// A convex polygon of 3 to 9 corners on an ellipse; its attributes are
    /// [`linear`] in the position.
    pub fn polygon(&mut self) -> Vec<Vertex<2>> {
        let (centre, a, b) = (self.vector(3.0), self.vector(5.0), self.vector(5.0));
        let mut angles: Vec<f32> =
            (0..3 + self.below(7)).map(|_| self.range(0.0, std::f32::consts::TAU)).collect();
        angles.sort_by(f32::total_cmp);
        angles
            .into_iter()
            .map(|angle| centre + a * angle.cos() + b * angle.sin())
            .map(|position| Vertex::new(position, linear(position)))
            .collect()
    }

    /// Values that hurt: not-a-number, infinities, zeros, huge and tiny.
    pub fn nasty(&mut self) -> f32 {
        match self.below(6) {
            0 => f32::from_bits(self.bits() as u32),
            1 => [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX][self.below(4)],
            2 => 0.0,
            3 => self.range(-1e30, 1e30),
            4 => f32::MIN_POSITIVE,
            _ => self.range(-10.0, 10.0),
        }
    }

    pub fn nasty_vector(&mut self) -> Vec3 {
        Vec3::new(self.nasty(), self.nasty(), self.nasty())
    }
}

/// The number of random cases: `FILLRATE_CASES` or `usual`.
pub fn cases(usual: usize) -> usize {
    std::env::var("FILLRATE_CASES").ok().and_then(|text| text.parse().ok()).unwrap_or(usual)
}

pub fn linear(p: Vec3) -> [f32; 2] {
    [0.5 + 0.25 * p.x - 0.5 * p.y, p.z + 0.125 * p.x]
}

pub fn area<const N: usize>(polygon: &[Vertex<N>]) -> f64 {
    let Some((first, rest)) = polygon.split_first() else { return 0.0 };
    rest.windows(2)
        .map(|pair| {
            let (a, b) = (pair[0].position - first.position, pair[1].position - first.position);
            f64::from(a.cross(b).length()) / 2.0
        })
        .sum()
}

pub fn close(a: f32, b: f32, tolerance: f32) -> bool {
    (a - b).abs() <= tolerance
}

pub fn near(a: Vec3, b: Vec3, tolerance: f32) -> bool {
    (a - b).length() <= tolerance
}
