//! A naive model of the pixel pipeline, for fragments whose values are known.
//!
//! Source: RAVE, pixel pipeline; docs/sources.md for the arithmetic.

/// A fragment with its values as the interface names them.
#[derive(Clone, Copy, Debug)]
pub struct Fragment {
    /// Red, green, blue and alpha of the vertices, 0..=255.
    pub v: [u32; 4],
    /// The texel, or none where it is not textured: red, green, blue, alpha.
    pub texel: Option<[u32; 4]>,
    /// Diffuse colour, 255 is 1.
    pub kd: [u32; 3],
    /// Specular colour.
    pub ks: [u32; 3],
    /// z, 0..=65535.
    pub z: u32,
}

/// The state that the model knows.
#[derive(Clone, Copy, Debug)]
pub struct Model {
    pub op: u32,
    pub blend: u32,
    pub gl: (u32, u32),
    pub alpha_test: (u32, u32),
    pub z_function: u32,
    pub z_mask: bool,
    pub channels: u32,
    /// Vertex alpha is fog of this colour.
    pub alpha_fog: Option<[u32; 3]>,
    pub env: [u32; 3],
}

/// A pixel of the buffer: red, green, blue, alpha; and its depth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pixel {
    pub rgba: [u32; 4],
    pub z: u32,
}

fn rounded(n: u32) -> u32 {
    (n + 127) / 255
}

fn compare(function: u32, a: u32, b: u32) -> bool {
    match function {
        1 => a < b,
        2 => a == b,
        3 => a <= b,
        4 => a > b,
        5 => a != b,
        6 => a >= b,
        8 => false,
        _ => true,
    }
}

impl Model {
    /// Colour and alpha before fog.
    fn shade(&self, f: &Fragment) -> ([u32; 3], u32) {
        let v = [f.v[0], f.v[1], f.v[2]];
        let va = if self.alpha_fog.is_some() { 255 } else { f.v[3] };
        let Some([tr, tg, tb, ta]) = f.texel else { return (v, va) };
        let t = [tr, tg, tb];
        let on = |bit: u32| self.op & bit != 0;
        let bright = f.kd.iter().any(|&k| k > 255);
        let alpha = if on(4) { va } else { (ta * (va + 1)) >> 8 };
        let mut c = t;
        if on(4) {
            c = [0, 1, 2].map(|i| rounded(ta * t[i] + (255 - ta) * v[i]));
        } else if on(16) {
            let from = if on(1) { f.kd.map(|k| k.min(255)) } else { v };
            c = [0, 1, 2].map(|i| {
                let (local, other) = (self.env[i] as i32, from[i] as i32);
                ((((other - local) * (t[i] as i32 + 1)) >> 8) + local).clamp(0, 255) as u32
            });
        }
        if on(1) && (on(4) || !on(16)) {
            c = [0, 1, 2].map(|i| match on(4) || bright {
                true => rounded(c[i] * f.kd[i].min(2047)).min(255),
                false => (c[i] * (f.kd[i] + 1)) >> 8,
            });
        }
        if on(2) {
            c = [0, 1, 2].map(|i| (c[i] + f.ks[i]).min(255));
        }
        (c, alpha)
    }

    /// Draws a fragment onto a pixel whose buffer may hold alpha.
    pub fn draw(&self, f: &Fragment, to: &mut Pixel, has_alpha: bool) {
        let (mut c, a) = self.shade(f);
        if self.alpha_test.0 != 0 && !compare(self.alpha_test.0, a, self.alpha_test.1) {
            return;
        }
        if self.z_function != 0 && !compare(self.z_function, f.z, to.z) {
            return;
        }
        if self.z_function != 0 && self.z_mask {
            to.z = f.z;
        }
        if let Some(fog) = self.alpha_fog {
            let stays = f.v[3];
            c = [0, 1, 2].map(|i| rounded(c[i] * stays + fog[i] * (255 - stays)));
        }
        let d = to.rgba;
        let da = if has_alpha { d[3] } else { 255 };
        let mut out = [0, 1, 2].map(|i| self.blend(c[i], d[i], a, da)).to_vec();
        out.push(match self.blend {
            2 => self.blend(a, da, a, da),
            _ => 255 - rounded((255 - a) * (255 - da)),
        });
        for (i, (to, out)) in to.rgba.iter_mut().zip(out).enumerate() {
            if self.channels >> i & 1 != 0 && (i < 3 || has_alpha) {
                *to = out;
            }
        }
    }

    /// One channel, with factors in 256ths.
    fn blend(&self, s: u32, d: u32, sa: u32, da: u32) -> u32 {
        let of = |v: u32| v + 1;
        let less = |v: u32| 256 - v;
        let factor = |number: u32, other: u32| match number {
            1 => 256,
            0x300 | 0x306 => of(other),
            0x301 | 0x307 => less(other),
            0x302 => of(sa),
            0x303 => less(sa),
            0x304 => of(da),
            0x305 => less(da),
            0x308 => of(sa.min(255 - da)),
            _ => 0,
        };
        let (fs, fd) = match self.blend {
            0 => (256, less(sa)),
            1 => (of(sa), less(sa)),
            _ => (factor(self.gl.0, d), factor(self.gl.1, s)),
        };
        ((s * fs + d * fd) >> 8).min(255)
    }
}
