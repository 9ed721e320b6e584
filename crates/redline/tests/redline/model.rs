//! The pixel pipeline again, one pixel at a time, straight from the document's
//! equations; multiplications round as the engine's do.

use fillrate_redline::PixFmt;

/// What one state register each says.
#[derive(Clone, Debug, Default)]
pub struct Model {
    pub source: u32,
    pub pad: bool,
    pub bgr: bool,
    pub yuv: bool,
    pub key: Option<(u32, u32)>,
    pub palette: [u32; 16],
    /// Default colour, 0xAARRGGBB, and fog.
    pub color: u32,
    pub fog: Option<(u32, u32)>,
    pub specular: Option<u32>,
    pub threshold: Option<u32>,
    /// Source and destination factor.
    pub blend: Option<(u32, u32)>,
    pub constant: Option<u32>,
    pub alu: u32,
    pub dither: Option<(u32, u32)>,
    pub planes: u32,
    pub dst_bgr: bool,
    /// Comparison, write, the fragment's z.
    pub depth: (u32, bool, u32),
    /// Bits, length, offset, background.
    pub pattern: Option<(u32, u32, u32, Option<u32>)>,
}

fn widen(v: u32, bits: u32, pad: bool) -> u32 {
    if bits == 0 {
        return 255;
    }
    let mut out = v << (8 - bits);
    let mut have = bits;
    while pad && have < 8 {
        out |= v << (8 - bits) >> have;
        have += bits;
    }
    out & 255
}

fn fields(format: PixFmt) -> [u32; 4] {
    match format {
        PixFmt::Rgb332 => [0, 3, 3, 2],
        PixFmt::Alpha8 => [8, 0, 0, 0],
        PixFmt::Rgb565 | PixFmt::Palette565 => [0, 5, 6, 5],
        PixFmt::Argb4444 | PixFmt::Palette4444 => [4; 4],
        PixFmt::Argb1555 | PixFmt::Palette1555 => [1, 5, 5, 5],
        _ => [8; 4],
    }
}

/// Alpha, red, green, blue of a pixel.
pub fn unpack(format: PixFmt, pixel: u32, pad: bool) -> [u32; 4] {
    if format == PixFmt::Gray8 {
        return [255, pixel, pixel, pixel];
    }
    let mut out = [0; 4];
    let mut shift = 0;
    for (i, bits) in fields(format).into_iter().enumerate().rev() {
        let v = if bits == 0 { 0 } else { pixel >> shift & ((1u64 << bits) - 1) as u32 };
        out[i] = widen(v, bits, pad);
        shift += bits;
    }
    out
}

/// A pixel of alpha, red, green, blue, dithered with 0 to 15.
fn pack(format: PixFmt, [a, r, g, b]: [u32; 4], dither: Option<u32>) -> u32 {
    let reduce = |c: u32, bits: u32| match dither {
        None => c >> (8 - bits),
        Some(d) => match bits {
            8 => c,
            6 => ((c << 2) - (c >> 4) + (c >> 6) + d) >> 4,
            5 => ((c << 1) - (c >> 4) + (c >> 7) + d) >> 4,
            _ => ((c >> (4 - bits)) - (c >> 4) + d) >> 4,
        },
    };
    match format {
        PixFmt::Gray8 => (77 * r + 150 * g + 29 * b + 128) >> 8,
        PixFmt::Alpha8 => a,
        _ => {
            let [ab, rb, gb, bb] = fields(format);
            let alpha = if ab == 0 { 0 } else { a >> (8 - ab) };
            ((alpha << rb | reduce(r, rb)) << gb | reduce(g, gb)) << bb | reduce(b, bb)
        }
    }
}

const MATRIX: [[u32; 4]; 4] = [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]];

fn split(argb: u32) -> [u32; 4] {
    argb.to_be_bytes().map(u32::from)
}

impl Model {
    /// The texel of a raw pixel; `pair` are the four bytes of a YUV pair and
    /// which of its pixels is meant.
    pub fn texel(&self, format: PixFmt, raw: u32, pair: ([u32; 4], usize)) -> ([u32; 4], bool) {
        let keyed = self.key.is_some_and(|(key, mask)| raw & mask == key & mask);
        let mut out = match format {
            PixFmt::Yuv422 => self.yuv_texel(pair),
            PixFmt::Palette565 | PixFmt::Palette4444 | PixFmt::Palette1555 => {
                unpack(format, self.palette[raw as usize], self.pad)
            }
            _ => unpack(format, raw, self.pad),
        };
        if self.bgr {
            out.swap(1, 3);
        }
        if keyed {
            out[0] = 0;
        }
        (out, keyed)
    }

    fn yuv_texel(&self, ([y0, cr, y1, cb], which): ([u32; 4], usize)) -> [u32; 4] {
        let y = [y0, y1][which];
        if !self.yuv {
            return [255, y, cr, cb];
        }
        let (y, cr, cb) = (298 * (y as i32 - 16), cr as i32 - 128, cb as i32 - 128);
        let channel = |sum: i32| ((sum + 128) >> 8).clamp(0, 255) as u32;
        [255, channel(y + 409 * cr), channel(y - 208 * cr - 100 * cb), channel(y + 516 * cb)]
    }

    /// The pixel and depth that a fragment leaves.
    pub fn draw(
        &self,
        texel: ([u32; 4], bool),
        format: PixFmt,
        (old, old_z): (u32, u32),
        (x, y): (u32, u32),
    ) -> (u32, u32) {
        let kept = (old, old_z);
        let pattern = self.pattern.map(|(bits, length, offset, background)| {
            (bits << ((x + offset) % length) >> 31 != 0, background)
        });
        if pattern == Some((false, None)) || !self.depth_passes(old_z) || texel.1 {
            return kept;
        }
        let mut color = self.source(texel.0);
        if let Some((false, Some(background))) = pattern {
            color = split(background);
        }
        if self.threshold.is_some_and(|threshold| color[0] <= threshold) {
            return kept;
        }
        if let Some((factor, fog)) = self.fog {
            for (c, fog) in color.iter_mut().zip(split(fog)).skip(1) {
                *c = (*c * factor + fog * (255 - factor) + 127) / 255;
            }
        }
        let swapped = |mut c: [u32; 4]| {
            if self.dst_bgr && format != PixFmt::Gray8 && format != PixFmt::Rgb332 {
                c.swap(1, 3);
            }
            c
        };
        let destination = swapped(unpack(format, old, true));
        let color = self.blended(color, self.constant.map_or(destination, split));
        let dither =
            self.dither.map(|(ox, oy)| MATRIX[((y + oy) & 3) as usize][((x + ox) & 3) as usize]);
        let new = self.merged(pack(format, swapped(color), dither), old, format);
        let (_, write, z) = self.depth;
        (new, if write { z } else { old_z })
    }

    fn depth_passes(&self, old: u32) -> bool {
        let (mode, _, z) = self.depth;
        mode == 0
            || mode & 1 != 0 && z < old
            || mode & 2 != 0 && z == old
            || mode & 4 != 0 && z > old
    }

    fn source(&self, t: [u32; 4]) -> [u32; 4] {
        let c = split(self.color);
        let mut out = match self.source {
            0 => c,
            1 => t,
            2 => {
                let decal = |c: u32, texel: u32| {
                    let (c, texel, a) = (c as i32, texel as i32, t[0] as i32);
                    ((((texel - c) * (a + 1)) >> 8) + c).clamp(0, 255) as u32
                };
                [c[0], decal(c[1], t[1]), decal(c[2], t[2]), decal(c[3], t[3])]
            }
            _ => [0, 1, 2, 3].map(|i| (t[i] * (c[i] + 1)) >> 8),
        };
        if let Some(specular) = self.specular {
            for (c, s) in out.iter_mut().zip(split(specular)).skip(1) {
                *c = (*c + s).min(255);
            }
        }
        out
    }

    fn blended(&self, s: [u32; 4], d: [u32; 4]) -> [u32; 4] {
        let Some((by_source, by_destination)) = self.blend else { return s };
        let factor = |code: u32, other: u32| match code {
            0 => other + 1,
            1 => 256 - other,
            2 => s[0] + 1,
            3 => 256 - s[0],
            4 => d[0] + 1,
            5 => 256 - d[0],
            6 => 0,
            7 => 256,
            8 => s[0].min(256 - d[0]) + 1,
            _ => 256 - s[0].min(255 - d[0]),
        };
        [0, 1, 2, 3].map(|i| {
            let sum = s[i] * factor(by_source, d[i]) + d[i] * factor(by_destination, s[i]);
            (sum >> 8).min(255)
        })
    }

    /// Bit by bit.
    fn merged(&self, new: u32, old: u32, format: PixFmt) -> u32 {
        let mut out = 0;
        for bit in 0..format.bits() {
            let (s, d) = (new >> bit & 1, old >> bit & 1);
            let result = if self.blend.is_some() { s } else { self.alu >> (2 * s + d) & 1 };
            let written = self.planes >> bit & 1 != 0;
            out |= if written { result } else { d } << bit;
        }
        out
    }
}
