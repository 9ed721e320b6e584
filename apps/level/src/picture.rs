//! Pictures to textures: sizes of powers of two up to 256, all levels, and
//! the texel formats of the board.

use std::io::Cursor;

use image::{ImageFormat, ImageReader, Limits};

use crate::assets::Assets;

/// The longest side of a picture file.
const MAX_SIDE: u32 = 4096;

/// A picture in 8-bit channels: red, green, blue, alpha.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Row by row from the top.
    pub pixels: Vec<[u8; 4]>,
}

impl Picture {
    /// Finds a picture by its name: as given, or with another extension.
    pub fn find(assets: &mut Assets, name: &str) -> Option<Picture> {
        let stem = match name.rsplit_once('.') {
            Some((stem, extension)) if extension.len() <= 4 => stem,
            _ => name,
        };
        for (extension, format) in [("tga", ImageFormat::Tga), ("jpg", ImageFormat::Jpeg)] {
            let Some(bytes) = assets.read(&format!("{stem}.{extension}")) else { continue };
            if let Some(picture) = decode(&bytes, format) {
                return Some(picture);
            }
        }
        None
    }

    /// Grey squares, for materials whose picture is missing.
    pub fn missing() -> Picture {
        let square = |i: usize| if (i % 16 / 8) ^ (i / 16 / 8) == 0 { 150 } else { 110 };
        let pixels = (0..256).map(square).map(|v| [v, v, v, 255]).collect();
        Picture { width: 16, height: 16, pixels }
    }

    /// Whether some pixel is not opaque.
    pub fn has_alpha(&self) -> bool {
        self.pixels.iter().any(|p| p[3] < 255)
    }

    /// The picture at another size: each new pixel is the mean of the area it
    /// covers, or lies between its neighbours.
    fn resized(&self, width: usize, height: usize) -> Picture {
        if (width, height) == (self.width, self.height) {
            return self.clone();
        }
        let columns = weights(self.width, width);
        let rows = weights(self.height, height);
        let mut pixels = Vec::with_capacity(width * height);
        for row in &rows {
            for column in &columns {
                let mut sum = [0.0f32; 4];
                for &(y, wy) in row {
                    for &(x, wx) in column {
                        let pixel = self.pixels[y * self.width + x];
                        for (sum, value) in sum.iter_mut().zip(pixel) {
                            *sum += f32::from(value) * wx * wy;
                        }
                    }
                }
                pixels.push(sum.map(|v| (v + 0.5) as u8));
            }
        }
        Picture { width, height, pixels }
    }

    /// Half the size, at least 1: the mean of each square.
    fn halved(&self) -> Picture {
        self.resized((self.width / 2).max(1), (self.height / 2).max(1))
    }
}

/// Source pixels and weights (of sum 1) of each of `to` pixels over `from`.
fn weights(from: usize, to: usize) -> Vec<Vec<(usize, f32)>> {
    let step = from as f32 / to as f32;
    let one = |i: usize| {
        if step < 1.0 {
            let at = ((i as f32 + 0.5) * step - 0.5).clamp(0.0, (from - 1) as f32);
            let low = at as usize;
            let t = at - low as f32;
            return vec![(low, 1.0 - t), ((low + 1).min(from - 1), t)];
        }
        let (start, end) = (i as f32 * step, (i + 1) as f32 * step);
        let cover = |x: usize| (end.min((x + 1) as f32) - start.max(x as f32)).max(0.0) / step;
        let last = (end.ceil() as usize).min(from);
        (start as usize..last).map(|x| (x, cover(x))).collect()
    };
    (0..to).map(one).collect()
}

fn decode(bytes: &[u8], format: ImageFormat) -> Option<Picture> {
    let mut reader = ImageReader::with_format(Cursor::new(bytes), format);
    let mut limits = Limits::default();
    (limits.max_image_width, limits.max_image_height) = (Some(MAX_SIDE), Some(MAX_SIDE));
    reader.limits(limits);
    let image = reader.decode().ok()?.into_rgba8();
    let (width, height) = (image.width() as usize, image.height() as usize);
    let pixels: Vec<[u8; 4]> = image.into_raw().as_chunks::<4>().0.to_vec();
    (width > 0 && height > 0).then_some(Picture { width, height, pixels })
}

/// A texture as it is downloaded.
#[derive(Clone, Debug, PartialEq)]
pub struct Texture {
    /// LOD number of the largest level: 0 for 256 texels, 8 for 1.
    pub large_lod: i32,
    /// 0 (8:1) to 6 (1:8).
    pub aspect: i32,
    /// Texel format.
    pub format: i32,
    /// All levels down to 1x1, largest first.
    pub data: Vec<u8>,
    /// What 1 in s and in t is in texture coordinates of the board.
    pub extent: [f32; 2],
    /// Coordinates are limited to 0..1.
    pub clamp: bool,
}

/// Texel formats in use.
const RGB_565: i32 = 0xa;
const ARGB_1555: i32 = 0xb;
const ARGB_4444: i32 = 0xc;

/// The power of two next to a side, as its exponent, at most that of `largest`.
fn exponent(side: usize, largest: u32) -> u32 {
    let next = side.next_power_of_two();
    // Nearer below than above.
    let next = if next > side && next - side > side - next / 2 { next / 2 } else { next };
    next.max(1).ilog2().min(largest)
}

impl Texture {
    /// A texture with all levels. Sides become powers of two up to `largest`
    /// (256 at most) and up to eight times each other.
    pub fn new(picture: &Picture, largest: usize, clamp: bool, tested: bool) -> Texture {
        let largest = largest.clamp(8, 256).ilog2();
        let (mut w, mut h) = (exponent(picture.width, largest), exponent(picture.height, largest));
        (w, h) = (w.max(h.saturating_sub(3)), h.max(w.saturating_sub(3)));
        let format = match (picture.has_alpha(), tested) {
            (false, _) => RGB_565,
            (true, true) => ARGB_1555,
            (true, false) => ARGB_4444,
        };
        let mut level = picture.resized(1 << w, 1 << h);
        let mut data = Vec::new();
        for _ in 0..=w.max(h) {
            data.extend(level.pixels.iter().flat_map(|&p| texel(format, p).to_le_bytes()));
            level = level.halved();
        }
        let long = w.max(h);
        let side = |bits: u32| 256.0 / (1u32 << (long - bits)) as f32;
        Texture {
            large_lod: 8 - long as i32,
            aspect: 3 - (w as i32 - h as i32),
            format,
            data,
            extent: [side(w), side(h)],
            clamp,
        }
    }

    /// Columns and rows of the largest level.
    pub fn size(&self) -> (usize, usize) {
        let long = 256 >> self.large_lod;
        let short = |bits: i32| long >> bits.max(0);
        (short(self.aspect - 3), short(3 - self.aspect))
    }
}

fn texel(format: i32, [r, g, b, a]: [u8; 4]) -> u16 {
    let [r, g, b, a] = [r, g, b, a].map(u16::from);
    match format {
        ARGB_1555 => (a >> 7) << 15 | (r >> 3) << 10 | (g >> 3) << 5 | b >> 3,
        ARGB_4444 => (a >> 4) << 12 | (r >> 4) << 8 | (g >> 4) << 4 | b >> 4,
        _ => (r >> 3) << 11 | (g >> 2) << 5 | b >> 3,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(width: usize, height: usize) -> Picture {
        let pixels = (0..width * height).map(|i| [(i % width) as u8, 0, 0, 255]).collect();
        Picture { width, height, pixels }
    }

    #[test]
    fn sizes_become_what_the_board_takes() {
        let size = |w, h, largest| Texture::new(&picture(w, h), largest, false, false).size();
        assert_eq!(size(512, 512, 256), (256, 256));
        assert_eq!(size(100, 60, 256), (128, 64));
        assert_eq!(size(90, 64, 256), (64, 64));
        assert_eq!(size(256, 8, 256), (256, 32));
        assert_eq!(size(1, 64, 256), (8, 64));
        assert_eq!(size(256, 128, 64), (64, 64));
        assert_eq!(size(3, 1, 256), (4, 1));
    }

    #[test]
    fn every_level_is_there() {
        for (w, h) in [(256, 256), (64, 16), (8, 64), (1, 1)] {
            let texture = Texture::new(&picture(w, h), 256, false, false);
            let mut texels = 0;
            let (mut w, mut h) = (w, h);
            loop {
                texels += w * h;
                if (w, h) == (1, 1) {
                    break;
                }
                (w, h) = ((w / 2).max(1), (h / 2).max(1));
            }
            assert_eq!(texture.data.len(), texels * 2);
        }
    }

    #[test]
    fn resizing_keeps_the_mean() {
        let from = picture(100, 3);
        for (w, h) in [(64, 2), (128, 4), (1, 1)] {
            let to = from.resized(w, h);
            let mean: f32 = to.pixels.iter().map(|p| f32::from(p[0])).sum::<f32>() / (w * h) as f32;
            assert!((mean - 49.5).abs() < 1.0, "{w}x{h}: {mean}");
            assert!(to.pixels.iter().all(|p| p[3] == 255));
        }
    }
}
