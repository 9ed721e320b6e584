//! Pictures of the program, and their pixels as colours.
//!
//! Source: RAVE, pixel types; what the sources leave open is decided in
//! `docs/sources.md`.

use fillrate_call::Data;

use crate::RaveError;
use crate::pixel::PixelType;
use crate::vertex::ImageValue;

/// The longest side of textures and bitmaps.
pub const MAX_IMAGE_SIDE: u32 = 2048;

/// A picture with its pixels as the program gave them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Image {
    pub width: u32,
    pub height: u32,
    pub pixels: Data,
}

impl Image {
    /// Takes a picture of this type.
    ///
    /// # Errors
    /// [`RaveError::Parameter`] for sides that are not positive or missing
    /// pixels, [`RaveError::OutOfVideoMemory`] for sides above
    /// [`MAX_IMAGE_SIDE`].
    pub fn new(value: &ImageValue, pixel_type: PixelType) -> Result<Image, RaveError> {
        let side = |side: i32| u32::try_from(side).ok().filter(|&side| side > 0);
        let sides = side(value.width).zip(side(value.height));
        let (width, height) = sides.ok_or(RaveError::Parameter)?;
        if width.max(height) > MAX_IMAGE_SIDE {
            return Err(RaveError::OutOfVideoMemory);
        }
        if value.pixels.len() < pixel_type.row_bytes(width) * height as usize {
            return Err(RaveError::Parameter);
        }
        Ok(Image { width, height, pixels: value.pixels.clone() })
    }

    /// Bytes of the pixels.
    pub fn bytes(&self, pixel_type: PixelType) -> usize {
        pixel_type.row_bytes(self.width) * self.height as usize
    }

    /// Appends all pixels as 0xAARRGGBB. `table` serves indices; without one
    /// they are shades of grey.
    pub fn decode(&self, pixel_type: PixelType, table: Option<&[u32]>, out: &mut Vec<u32>) {
        let row_bytes = pixel_type.row_bytes(self.width);
        for row in self.pixels.chunks_exact(row_bytes).take(self.height as usize) {
            decode_row(row, self.width as usize, pixel_type, table, out);
        }
    }

    /// Replaces a rectangle inside by rows without padding. Types whose pixels
    /// share bytes take whole rows only.
    ///
    /// # Errors
    /// [`RaveError::Parameter`] where the rectangle or the bytes do not fit.
    pub fn write(
        &mut self,
        pixel_type: PixelType,
        [x, y, width, height]: [u32; 4],
        from: &[u8],
    ) -> Result<(), RaveError> {
        let inside = x.checked_add(width).is_some_and(|end| end <= self.width)
            && y.checked_add(height).is_some_and(|end| end <= self.height);
        let partial = width != self.width;
        let row = pixel_type.row_bytes(width);
        let shared = pixel_type.bits() < 8 || is_yuv(pixel_type);
        let enough = from.len() >= row * height as usize;
        if !inside || partial && shared || !enough {
            return Err(RaveError::Parameter);
        }
        let pitch = pixel_type.row_bytes(self.width);
        let start = pixel_type.row_bytes(x);
        let mut pixels = self.pixels.to_vec();
        for (rows, from) in from.chunks_exact(row.max(1)).take(height as usize).enumerate() {
            let at = (y as usize + rows) * pitch + start;
            pixels[at..at + row].copy_from_slice(from);
        }
        self.pixels = pixels.into();
        Ok(())
    }
}

fn is_yuv(pixel_type: PixelType) -> bool {
    use PixelType::*;
    matches!(pixel_type, Yuvs | Yuvu | Yvyu422 | Uyvy422)
}

/// Appends the first `width` pixels of a row as 0xAARRGGBB.
pub(crate) fn decode_row(
    row: &[u8],
    width: usize,
    pixel_type: PixelType,
    table: Option<&[u32]>,
    out: &mut Vec<u32>,
) {
    use PixelType::*;
    let words = || row.as_chunks::<2>().0.iter().map(|&w| u32::from(u16::from_le_bytes(w)));
    let longs = || row.as_chunks::<4>().0.iter().map(|&l| u32::from_le_bytes(l));
    let bytes = || row.iter().map(|&b| u32::from(b));
    let indexed = |index: u32, last: u32| match table {
        Some(table) => table.get(index as usize).copied().unwrap_or(0),
        None => opaque_grey(index * 255 / last),
    };
    match pixel_type {
        Alpha1 => out.extend((0..width).map(|x| {
            let on = row[x / 8] >> (7 - x % 8) & 1;
            0x00ff_ffff | if on != 0 { 0xff00_0000 } else { 0 }
        })),
        Rgb16 => out.extend(words().take(width).map(|w| 0xff00_0000 | rgb555(w))),
        Argb16 => out.extend(words().take(width).map(|w| ((w >> 15) * 0xff00_0000) | rgb555(w))),
        Rgb32 => out.extend(longs().take(width).map(|l| 0xff00_0000 | l)),
        Argb32 => out.extend(longs().take(width)),
        Cl4 => out.extend((0..width).map(|x| {
            let pair = row[x / 2];
            indexed(u32::from(if x % 2 == 0 { pair >> 4 } else { pair & 15 }), 15)
        })),
        Cl8 => out.extend(bytes().take(width).map(|b| indexed(b, 255))),
        Rgb16_565 => out.extend(words().take(width).map(rgb565)),
        Rgb24 => out.extend(
            row.as_chunks::<3>()
                .0
                .iter()
                .take(width)
                .map(|&[b, g, r]| u32::from_be_bytes([255, r, g, b])),
        ),
        Rgb8_332 => out.extend(bytes().take(width).map(rgb332)),
        Argb16_4444 => out.extend(words().take(width).map(argb4444)),
        Acl16_88 => out.extend(
            words().take(width).map(|w| indexed(w & 255, 255) & 0x00ff_ffff | (w >> 8) << 24),
        ),
        I8 => out.extend(bytes().take(width).map(opaque_grey)),
        Ai16_88 => out.extend(
            words().take(width).map(|w| opaque_grey(w & 255) & 0x00ff_ffff | (w >> 8) << 24),
        ),
        Yuvs => yuv_row(row, width, [0, 1, 2, 3], 0, out),
        Yuvu => yuv_row(row, width, [0, 1, 2, 3], 0x80, out),
        Yvyu422 => yuv_row(row, width, [0, 3, 2, 1], 0, out),
        Uyvy422 => yuv_row(row, width, [1, 0, 3, 2], 0, out),
    }
}

fn opaque_grey(value: u32) -> u32 {
    0xff00_0000 | (value * 0x0001_0101)
}

/// Five bits as eight, by replication.
fn five(value: u32) -> u32 {
    let value = value & 31;
    value << 3 | value >> 2
}

fn rgb555(w: u32) -> u32 {
    five(w >> 10) << 16 | five(w >> 5) << 8 | five(w)
}

fn rgb565(w: u32) -> u32 {
    let green = w >> 5 & 63;
    0xff00_0000 | five(w >> 11) << 16 | (green << 2 | green >> 4) << 8 | five(w)
}

fn rgb332(b: u32) -> u32 {
    let three = |v: u32| {
        let v = v & 7;
        v << 5 | v << 2 | v >> 1
    };
    0xff00_0000 | three(b >> 5) << 16 | three(b >> 2) << 8 | ((b & 3) * 85)
}

fn argb4444(w: u32) -> u32 {
    let four = |shift: u32| (w >> shift & 15) * 17;
    four(12) << 24 | four(8) << 16 | four(4) << 8 | four(0)
}

/// Pairs of pixels that share their chroma; `order` says where Y0, U, Y1 and V
/// are, `flip` is applied to the chroma bytes.
fn yuv_row(row: &[u8], width: usize, order: [usize; 4], flip: u8, out: &mut Vec<u32>) {
    let start = out.len();
    for group in row.as_chunks::<4>().0 {
        let [y0, u, y1, v] = order.map(|at| group[at]);
        let (u, v) = (u ^ flip, v ^ flip);
        out.extend([yuv(y0, u, v), yuv(y1, u, v)]);
    }
    out.truncate(start + width);
}

/// ITU-R BT.601 with luma of 16..=235 and chroma around 128, in 256ths, to the
/// nearest.
fn yuv(y: u8, u: u8, v: u8) -> u32 {
    let y = 298 * (i32::from(y) - 16);
    let (u, v) = (i32::from(u) - 128, i32::from(v) - 128);
    let channel = |sum: i32| ((sum + 128) >> 8).clamp(0, 255) as u8;
    let (r, g, b) = (y + 409 * v, y - 100 * u - 208 * v, y + 516 * u);
    u32::from_be_bytes([255, channel(r), channel(g), channel(b)])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn decoded(pixel_type: PixelType, width: usize, row: &[u8], table: Option<&[u32]>) -> Vec<u32> {
        let mut out = Vec::new();
        decode_row(row, width, pixel_type, table, &mut out);
        out
    }

    #[test]
    fn bits_and_nibbles_start_at_the_left() {
        let alpha = decoded(PixelType::Alpha1, 3, &[0b1010_0000], None);
        assert_eq!(alpha, [0xffff_ffff, 0x00ff_ffff, 0xffff_ffff]);
        let table: Vec<u32> = (0..16).map(|i| 0xff00_0000 | i).collect();
        let nibbles = decoded(PixelType::Cl4, 3, &[0x5a, 0xf0], Some(&table));
        assert_eq!(nibbles, [0xff00_0005, 0xff00_000a, 0xff00_000f]);
        assert_eq!(decoded(PixelType::Cl4, 1, &[0xf0], None), [0xffff_ffff]);
    }

    #[test]
    fn fields_are_replicated() {
        let word = |w: u16| w.to_le_bytes();
        assert_eq!(decoded(PixelType::Rgb16, 1, &word(0x7c10), None), [0xffff_0084]);
        assert_eq!(decoded(PixelType::Argb16, 1, &word(0x03e0), None), [0x0000_ff00]);
        assert_eq!(decoded(PixelType::Rgb16_565, 1, &word(0xf81f), None), [0xffff_00ff]);
        assert_eq!(decoded(PixelType::Argb16_4444, 1, &word(0x8f0a), None), [0x88ff_00aa]);
        assert_eq!(decoded(PixelType::Rgb8_332, 1, &[0xe2], None), [0xffff_00aa]);
        assert_eq!(decoded(PixelType::Rgb24, 1, &[1, 2, 3], None), [0xff03_0201]);
        assert_eq!(decoded(PixelType::Ai16_88, 1, &word(0x4080), None), [0x4080_8080]);
        assert_eq!(decoded(PixelType::Rgb32, 1, &0x11_2233u32.to_le_bytes(), None), [0xff11_2233]);
    }

    #[test]
    fn luma_and_chroma() {
        let white = decoded(PixelType::Yuvs, 2, &[235, 128, 16, 128], None);
        assert_eq!(white, [0xffff_ffff, 0xff00_0000]);
        let red = [81, 90, 81, 240];
        let expected = decoded(PixelType::Yuvs, 1, &red, None);
        assert_eq!(expected[0] >> 16 & 255, 255);
        assert_eq!(decoded(PixelType::Yuvu, 1, &[81, 90 ^ 128, 81, 240 ^ 128], None), expected);
        assert_eq!(decoded(PixelType::Yvyu422, 1, &[81, 240, 81, 90], None), expected);
        assert_eq!(decoded(PixelType::Uyvy422, 1, &[90, 81, 240, 81], None), expected);
    }
}
