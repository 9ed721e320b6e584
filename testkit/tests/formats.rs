//! The engine's packing and widening against the reference's.

use fillrate_engine::PixelFormat;
use fillrate_engine::state::Dither;
use fillrate_engine::target;
use fillrate_testkit::random::Rng;
use fillrate_testkit::reference::{pack, unpack};

const FORMATS: [PixelFormat; 9] = [
    PixelFormat::Rgb565,
    PixelFormat::Argb1555,
    PixelFormat::Xrgb1555,
    PixelFormat::Argb4444,
    PixelFormat::Argb8888,
    PixelFormat::Xrgb8888,
    PixelFormat::Rgb332,
    PixelFormat::Gray8,
    PixelFormat::Alpha8,
];

#[test]
fn packing_agrees_at_every_position_and_channel_value() {
    for format in FORMATS {
        for dither in [Dither::Off, Dither::Ordered2x2, Dither::Ordered4x4] {
            for value in 0..256u32 {
                // Channels that differ, so that none takes another's place.
                let argb = (value * 0x0101_0101) ^ 0x5a00_a53c;
                for position in 0..16 {
                    let (x, y) = (position % 4 + 640, position / 4 + 32);
                    let expected = pack(format, argb, dither, x, y);
                    let actual = target::pack(format, argb, dither, x, y);
                    assert_eq!(actual, expected, "{format:?} {dither:?} {argb:#x} ({x}, {y})");
                }
            }
        }
    }
}

#[test]
fn widening_agrees_on_every_element() {
    let mut rng = Rng::new(5);
    for format in FORMATS {
        for element in 0..0x1_0000 {
            let element = match format {
                PixelFormat::Argb8888 | PixelFormat::Xrgb8888 => rng.word(),
                _ => element & format.element_mask(),
            };
            let [r, g, b, a] = unpack(format, element).map(|channel| channel as u32);
            let expected = a << 24 | r << 16 | g << 8 | b;
            assert_eq!(target::unpack(format, element), expected, "{format:?} {element:#x}");
        }
    }
}
