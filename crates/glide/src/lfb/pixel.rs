//! Pixels of the write modes.

use fillrate_engine::PixelFormat;
use fillrate_engine::target::{pack, unpack};

use crate::pixel_state::swizzle;

/// Bytes of a pixel in a write mode, or `None` for a reserved one.
pub(super) fn pixel_bytes(mode: i32) -> Option<usize> {
    match mode {
        0..=2 | 0xf => Some(2),
        4 | 5 | 0xc..=0xe => Some(4),
        _ => None,
    }
}

/// A pixel in a write mode, taken apart.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Parts {
    /// 0x00RRGGBB, where the mode has colour.
    pub color: Option<u32>,
    pub alpha: Option<u8>,
    pub depth: Option<u16>,
}

/// 5 bits as 8.
fn five(c: u32) -> u32 {
    (c & 31) << 3 | (c >> 2 & 7)
}

/// 6 bits as 8.
fn six(c: u32) -> u32 {
    (c & 63) << 2 | (c >> 4 & 3)
}

/// Red and blue change places in ABGR and BGRA.
fn exchange(format: i32, rgb: u32) -> u32 {
    match format {
        1 | 3 => rgb & 0xff00 | (rgb & 0xff) << 16 | rgb >> 16 & 0xff,
        _ => rgb,
    }
}

/// Takes a pixel apart; `format` is the program's colour format.
#[inline(always)]
pub(super) fn parts(mode: i32, format: i32, value: u32) -> Parts {
    let low = value & 0xffff;
    // RGBA and BGRA keep alpha in the low bits.
    let alpha_low = format >= 2;
    let high = Some((value >> 16) as u16);
    let color565 =
        || Some(exchange(format, five(low >> 11) << 16 | six(low >> 5) << 8 | five(low)));
    let color555 = || {
        let v = if alpha_low { low >> 1 } else { low };
        Some(exchange(format, five(v >> 10) << 16 | five(v >> 5) << 8 | five(v)))
    };
    let alpha1 = || Some(if low & (if alpha_low { 1 } else { 0x8000 }) != 0 { 255 } else { 0 });
    let color888 = || swizzle(format, value);
    match mode {
        0 => Parts { color: color565(), ..Parts::default() },
        1 => Parts { color: color555(), ..Parts::default() },
        2 => Parts { color: color555(), alpha: alpha1(), depth: None },
        4 => Parts { color: Some(color888() & 0xff_ffff), ..Parts::default() },
        5 => {
            let argb = color888();
            let (color, alpha) = (argb & 0xff_ffff, (argb >> 24) as u8);
            Parts { color: Some(color), alpha: Some(alpha), depth: None }
        }
        0xc => Parts { color: color565(), alpha: None, depth: high },
        0xd => Parts { color: color555(), alpha: None, depth: high },
        0xe => Parts { color: color555(), alpha: alpha1(), depth: high },
        _ => Parts { color: None, alpha: None, depth: Some(low as u16) },
    }
}

/// A pixel of the buffers in a write mode, so that storing it changes nothing,
/// or at most the lowest bit of a channel that the mode has fewer bits for.
/// `color` is a 565 pixel, `high` what bits get that such a store ignores: 32
/// of them, of which modes with alpha or depth take those from the aux buffer.
pub(super) fn in_mode(mode: i32, format: i32, color: u16, high: u32) -> u32 {
    let element = u32::from(color);
    let (r, g, b) = (element >> 11, element >> 5 & 63, element & 31);
    let (first, last) = if matches!(format, 1 | 3) { (b, r) } else { (r, b) };
    let in_565 = first << 11 | g << 5 | last;
    let in_555 = (first << 10 | g >> 1 << 5 | last) << u32::from(format >= 2);
    let above = high << 16;
    match mode {
        0 => in_565,
        1 | 2 => in_555,
        4 | 5 => {
            let argb = high << 24 | unpack(PixelFormat::Rgb565, element) & 0xff_ffff;
            match format {
                2 => argb.rotate_left(8),
                // The other exchanges are their own inverses.
                other => swizzle(other, argb),
            }
        }
        0xc => above | in_565,
        0xd | 0xe => above | in_555,
        _ => high & 0xffff,
    }
}

/// What memory holds where no store may go unnoticed: the half words of a word
/// differ from place to place and from one `round` to the next, and their bytes
/// are neither all zeros nor all ones.
pub(super) fn noise(at: usize, round: u32) -> u32 {
    let mixed = (at as u32 ^ round.rotate_left(20) ^ 0x5bd1_e995).wrapping_mul(0x9e37_79b1);
    let mixed = (mixed ^ mixed >> 15).wrapping_mul(0x85eb_ca77);
    let mixed = mixed ^ mixed >> 13;
    let byte = |shift: u32| (1 + (mixed >> shift & 0xff) * 254 / 256) << shift;
    byte(24) | byte(16) | byte(8) | byte(0)
}

/// The pixel of a 16-bit mode that is the chroma key; `None` where no pixel of
/// the mode is.
pub(super) fn key_pixel(mode: i32, format: i32, key: u32) -> Option<u16> {
    let element = pack(PixelFormat::Rgb565, key, fillrate_engine::state::Dither::Off, 0, 0);
    let pixel = in_mode(mode, format, element as u16, 0);
    let exact = parts(mode, format, pixel).color == Some(key & 0xff_ffff);
    (exact && pixel_bytes(mode) == Some(2)).then_some(pixel as u16)
}

#[cfg(test)]
mod tests {
    use super::*;
    use fillrate_engine::state::Dither;

    #[test]
    fn pixels_are_taken_apart_by_format() {
        let color = |mode, format, value| parts(mode, format, value).color;
        assert_eq!(color(0, 0, 0xf800), Some(0xff_0000));
        assert_eq!(color(0, 1, 0xf800), Some(0x00_00ff));
        assert_eq!(color(1, 0, 0x7c00), Some(0xff_0000));
        assert_eq!(color(1, 2, 0xf800), Some(0xff_0000));
        assert_eq!(color(4, 2, 0x1122_3344), Some(0x11_2233));
        assert_eq!(parts(5, 0, 0x8011_2233).alpha, Some(0x80));
        assert_eq!(parts(0xc, 0, 0x1234_f800).depth, Some(0x1234));
        assert_eq!(parts(2, 0, 0x8000).alpha, Some(255));
        assert_eq!(parts(0xf, 0, 0xbeef), Parts { color: None, alpha: None, depth: Some(0xbeef) });
    }

    /// Every pixel in every mode and format comes back, but for the green bit
    /// that 555 lacks.
    #[test]
    fn shown_pixels_store_themselves() {
        for mode in [0, 1, 2, 4, 5, 0xc, 0xd, 0xe] {
            let lost = if matches!(mode, 0 | 4 | 5 | 0xc) { 0 } else { 0x20 };
            for format in 0..4 {
                for pixel in (0..=0xffffu16).step_by(7) {
                    let shown = parts(mode, format, in_mode(mode, format, pixel, 0x1234));
                    let back = pack(PixelFormat::Rgb565, shown.color.unwrap(), Dither::Off, 0, 0);
                    assert_eq!(back as u16 & !lost, pixel & !lost, "mode {mode} format {format}");
                    assert!(shown.depth.is_none_or(|depth| depth == 0x1234));
                }
            }
        }
        assert_eq!(parts(5, 3, in_mode(5, 3, 0, 0x77)).alpha, Some(0x77));
    }

    #[test]
    fn noise_differs_and_is_never_black_or_white() {
        let all: Vec<u32> = (0..4096).flat_map(|at| [noise(at, 1), noise(at, 2)]).collect();
        let same = all.windows(3).filter(|w| w[0] == w[1] || w[0] as u16 == w[2] as u16).count();
        assert!(same < 5, "{same}");
        assert!(all.iter().flat_map(|v| v.to_le_bytes()).all(|b| b != 0 && b != 255));
    }

    #[test]
    fn keys_are_pixels_where_the_mode_has_them() {
        assert_eq!(key_pixel(0, 0, 0x00ff_00ff), Some(0xf81f));
        assert_eq!(key_pixel(0, 1, 0x00ff_0000), Some(0x001f));
        assert_eq!(key_pixel(0, 0, 0x0001_0000), None);
        assert_eq!(key_pixel(4, 0, 0x00ff_00ff), None);
    }
}
