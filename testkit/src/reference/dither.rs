//! Colours as channels, and elements of surfaces as colours.
//!
//! Source: SST1, dithering.

use fillrate_engine::PixelFormat;
use fillrate_engine::state::Dither;

/// The 4x4 matrix, row by row.
const MATRIX: [u32; 16] = [0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5];

/// Red, green, blue, alpha of 0xAARRGGBB.
pub fn channels(argb: u32) -> [i32; 4] {
    [16, 8, 0, 24].map(|shift| (argb >> shift & 0xff) as i32)
}

/// 0xAARRGGBB of channels in 0..=255.
pub fn join([r, g, b, a]: [i32; 4]) -> u32 {
    debug_assert!([r, g, b, a].iter().all(|c| (0..=255).contains(c)), "channels have 8 bits");
    (a << 24 | r << 16 | g << 8 | b) as u32
}

/// The 4x4 matrix' value at a screen position.
pub fn matrix(x: u32, row: u32) -> u32 {
    MATRIX[(row % 4 * 4 + x % 4) as usize]
}

/// The value that dithering adds at a screen position.
fn amount(dither: Dither, x: u32, row: u32) -> Option<u32> {
    match dither {
        Dither::Off => None,
        Dither::Ordered4x4 => Some(matrix(x, row)),
        Dither::Ordered2x2 => Some(match (x % 2, row % 2) {
            (0, 0) => 2,
            (_, 0) => 10,
            (0, _) => 14,
            (_, _) => 6,
        }),
    }
}

/// `bits` of 2 to 4; the channel's top bits and a dithered rest.
fn to_few(bits: u32, value: u32, add: Option<u32>) -> u32 {
    let scaled = (value >> (4 - bits)) - (value >> 4);
    add.map_or(value >> (8 - bits), |add| (scaled + add) >> 4)
}

fn to_4(value: u32, add: Option<u32>) -> u32 {
    to_few(4, value, add)
}

fn to_5(value: u32, add: Option<u32>) -> u32 {
    add.map_or(value >> 3, |add| ((value << 1) - (value >> 4) + (value >> 7) + add) >> 4)
}

fn to_6(value: u32, add: Option<u32>) -> u32 {
    add.map_or(value >> 2, |add| ((value << 2) - (value >> 4) + (value >> 6) + add) >> 4)
}

/// The element for 0xAARRGGBB at a screen position. Alpha is truncated.
pub fn pack(format: PixelFormat, argb: u32, dither: Dither, x: u32, row: u32) -> u32 {
    let [r, g, b, a] = channels(argb).map(|c| c as u32);
    let add = amount(dither, x, row);
    match format {
        PixelFormat::Rgb565 => to_5(r, add) << 11 | to_6(g, add) << 5 | to_5(b, add),
        PixelFormat::Argb1555 => {
            (a >> 7) << 15 | to_5(r, add) << 10 | to_5(g, add) << 5 | to_5(b, add)
        }
        PixelFormat::Argb4444 => {
            (a >> 4) << 12 | to_4(r, add) << 8 | to_4(g, add) << 4 | to_4(b, add)
        }
        PixelFormat::Xrgb1555 => to_5(r, add) << 10 | to_5(g, add) << 5 | to_5(b, add),
        PixelFormat::Rgb332 => to_few(3, r, add) << 5 | to_few(3, g, add) << 2 | to_few(2, b, add),
        PixelFormat::Gray8 => (r * 77 + g * 150 + b * 29 + 128) / 256,
        PixelFormat::Alpha8 => a,
        PixelFormat::Xrgb8888 => argb % (1 << 24),
        PixelFormat::Argb8888
        | PixelFormat::Palette
        | PixelFormat::Rgbx8888
        | PixelFormat::Aux16
        | PixelFormat::Aux32 => argb,
    }
}

/// Red, green, blue, alpha of an element, widened by bit replication; alpha is
/// 255 where the format has none.
pub fn unpack(format: PixelFormat, element: u32) -> [i32; 4] {
    let four = |shift: u32| (element >> shift & 15) * 17;
    let five = |shift: u32| {
        let value = element >> shift & 31;
        value << 3 | value >> 2
    };
    let six = |shift: u32| {
        let value = element >> shift & 63;
        value << 2 | value >> 4
    };
    match format {
        PixelFormat::Rgb565 => [five(11), six(5), five(0), 255].map(|c| c as i32),
        PixelFormat::Argb1555 => {
            [five(10), five(5), five(0), (element >> 15 & 1) * 255].map(|c| c as i32)
        }
        PixelFormat::Argb4444 => [four(8), four(4), four(0), four(12)].map(|c| c as i32),
        PixelFormat::Xrgb1555 => [five(10), five(5), five(0), 255].map(|c| c as i32),
        PixelFormat::Rgb332 => {
            let three = |shift: u32| {
                let value = element >> shift & 7;
                value << 5 | value << 2 | value >> 1
            };
            [three(5), three(2), (element & 3) * 85, 255].map(|c| c as i32)
        }
        PixelFormat::Gray8 => [element, element, element, 255].map(|c| c as i32),
        PixelFormat::Alpha8 => [255, 255, 255, element as i32],
        PixelFormat::Xrgb8888 => {
            let [r, g, b, _] = channels(element);
            [r, g, b, 255]
        }
        PixelFormat::Argb8888
        | PixelFormat::Palette
        | PixelFormat::Rgbx8888
        | PixelFormat::Aux16
        | PixelFormat::Aux32 => channels(element),
    }
}
