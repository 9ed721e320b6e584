//! Unpleasant triangles, lines and textures.

use std::sync::Arc;

use fillrate_quark::{Texture, Vertex};

/// A xorshift generator of 64 bits, and the texture it made last.
pub struct Random(u64, Option<Arc<Texture>>);

impl Random {
    /// A generator; seeds near each other give different numbers.
    pub fn new(seed: u64) -> Random {
        Random(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1, None)
    }

    pub fn bits(&mut self) -> u32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 24) as u32
    }

    /// A number of `low..=high`.
    pub fn range(&mut self, low: i32, high: i32) -> i32 {
        let span = u64::from(high.abs_diff(low)) + 1;
        (i64::from(low) + (u64::from(self.bits()) % span) as i64) as i32
    }

    pub fn one_in(&mut self, n: u32) -> bool {
        self.bits().is_multiple_of(n)
    }

    /// Mostly near the screen, sometimes far away or beyond all limits.
    fn coordinate(&mut self, size: i32) -> i32 {
        match self.bits() % 64 {
            0 => self.range(-(1 << 20), 1 << 20),
            1 => self.range(-5000, 5000),
            2 => self.range(i32::MIN, i32::MAX),
            3..=20 => self.range(-size, 2 * size),
            _ => self.range(-4, size + 4),
        }
    }

    fn distance(&mut self) -> i32 {
        match self.bits() % 32 {
            0 => self.range(i32::MIN, i32::MAX),
            1 => self.range(0, 70),
            2..=8 => self.range(64, 300),
            _ => self.range(64, 4095),
        }
    }

    fn light(&mut self) -> i32 {
        if self.one_in(30) { self.range(i32::MIN, i32::MAX) } else { self.range(0, 255) }
    }

    fn uv(&mut self) -> i32 {
        match self.bits() % 32 {
            0 => self.range(i32::MIN, i32::MAX),
            1 => self.range(-40_000, 40_000),
            2..=8 => self.range(-600, 2000),
            _ => self.range(0, 256),
        }
    }

    pub fn point(&mut self, width: i32, height: i32) -> [i32; 3] {
        [self.coordinate(width), self.coordinate(height), self.distance()]
    }

    pub fn triangle(&mut self, width: i32, height: i32) -> [Vertex; 3] {
        let small = self.one_in(3);
        let mut corners = [0; 3].map(|_| {
            let [x, y, z] = self.point(width, height);
            let m = if self.one_in(60) { self.range(0, 63) } else { 0 };
            Vertex { x, y, z, m, i: self.light(), u: self.uv(), v: self.uv() }
        });
        if small {
            // Slivers and triangles of few pixels.
            let (x, y) = (self.range(0, width), self.range(0, height));
            for corner in &mut corners {
                (corner.x, corner.y) = (x + self.range(-6, 6), y + self.range(-6, 6));
            }
        }
        if self.one_in(8) {
            let z = self.range(64, 4095);
            corners.iter_mut().for_each(|c| c.z = z);
        }
        corners
    }

    /// A texture for triangles with a fair share of key texels; often the one
    /// of the last time.
    pub fn texture(&mut self) -> Arc<Texture> {
        if self.1.is_none() || self.one_in(8) {
            self.1 = Some(self.new_texture());
        }
        self.1.clone().expect("it was just made")
    }

    fn new_texture(&mut self) -> Arc<Texture> {
        let side = |random: &mut Random| 16 << (random.bits() % 4);
        let (width, height) = (side(self), side(self));
        self.sized_texture(width, height)
    }

    pub fn sized_texture(&mut self, width: i32, height: i32) -> Arc<Texture> {
        let mut texel = || if self.one_in(4) { 7 } else { self.bits() as u8 };
        let texels: Vec<u8> = (0..width * height).map(|_| texel()).collect();
        let key = if self.one_in(5) { -1 } else { 7 };
        Arc::new(Texture::new(&texels, width, height, key).expect("a valid size"))
    }
}
