//! Scenes compared with stored pictures, exactly.
//!
//! Pictures lie in `tests/golden/NAME.png`. A mismatch writes the expected
//! picture, the actual one and their difference into `target/golden-failures/`
//! and names the first pixel that differs. With `BLESS=1` in the environment
//! the stored picture is replaced by the reference's, and everything else must
//! equal that.

use std::fs;
use std::path::{Path, PathBuf};

use fillrate_engine::target::TileSize;
use fillrate_engine::{DeviceConfig, PixelFormat};
use fillrate_player::{Comparison, Frame, FrameError, Pixels, compare, difference_image};

use crate::canvas::{Canvas, DeviceCanvas, ReferenceCanvas};
use crate::compare::{cell_name, cells};
use crate::reference::{Reference, unpack};

/// Thread counts that scenes are drawn with.
const THREADS: [usize; 4] = [1, 2, 3, 8];
/// Tile sizes that scenes are drawn with.
const TILES: [TileSize; 2] = [TileSize::Small, TileSize::Medium];

/// Every way of working that scenes are drawn in: all SIMD levels, 1, 2, 3 and
/// 8 threads, two tile sizes.
pub fn golden_cells() -> Vec<DeviceConfig> {
    cells(&THREADS, &TILES)
}

/// Draws a scene on a 565 colour surface and an aux surface with the reference
/// and in every way of working; colour, aux and counters must agree
/// everywhere, and the colours equal the stored picture.
///
/// # Panics
/// Where something differs, naming the way of working and the first pixel.
pub fn golden(name: &str, width: u32, height: u32, scene: impl Fn(&mut dyn Canvas)) {
    let (format, aux) = (PixelFormat::Rgb565, Some(PixelFormat::Aux16));
    let mut canvas = ReferenceCanvas::new(Reference::new(width, height, format, aux));
    scene(&mut canvas);
    let expected = canvas.reference;
    check_picture(name, "reference", &picture(&expected));
    for config in golden_cells() {
        let cell = cell_name(&config);
        let canvas = DeviceCanvas::new(config, (width, height), format, aux);
        let mut canvas = canvas.expect("a device of any configuration can be made");
        scene(&mut canvas);
        let actual = canvas.result();
        if actual.color != expected.color {
            fail(name, &cell, &picture(&expected), &picture(&actual));
        }
        assert_eq!(actual.aux, expected.aux, "{name}: {cell}: aux differs from the reference");
        assert_eq!(actual.counters, expected.counters, "{name}: {cell}: counters differ");
    }
}

/// Draws a scene that cannot be drawn by the reference, such as a front end's,
/// in every way of working; all pictures must equal the stored one. `BLESS=1`
/// stores that of the first way, which has the scalar level and one thread.
///
/// # Panics
/// As [`golden`].
pub fn golden_frames(name: &str, mut scene: impl FnMut(&DeviceConfig) -> Frame) {
    let mut first = None;
    for config in golden_cells() {
        let frame = scene(&config);
        let cell = cell_name(&config);
        match &first {
            None => {
                check_picture(name, &cell, &frame);
                first = Some(frame);
            }
            Some(first) if compare(first, &frame).is_same() => {}
            Some(first) => fail(name, &cell, first, &frame),
        }
    }
}

/// The colours of a result as a picture: 565 as it is, other formats widened.
pub fn picture(result: &Reference) -> Frame {
    let pixels = match result.format {
        PixelFormat::Rgb565 => {
            Pixels::Rgb565(result.color.iter().map(|&element| element as u16).collect())
        }
        format => Pixels::Rgba8(
            result
                .color
                .iter()
                .flat_map(|&element| unpack(format, element).map(|channel| channel as u8))
                .collect(),
        ),
    };
    Frame::new(result.width, result.height, pixels).expect("a result fills its size")
}

/// Compares a frame with the stored picture, or stores it under `BLESS=1`.
fn check_picture(name: &str, cell: &str, frame: &Frame) {
    let path = stored(name);
    if std::env::var_os("BLESS").is_some_and(|value| value == "1") {
        save(frame, &path).expect("the golden picture can be written");
        return;
    }
    match Frame::load_png(&path) {
        Ok(expected) if compare(&expected, frame).is_same() => {}
        Ok(expected) => fail(name, cell, &expected, frame),
        Err(error) => {
            let place = failures(name).with_extension("actual.png");
            let saved = save(frame, &place).map_or_else(|e| e.to_string(), |()| String::new());
            panic!(
                "{name}: no golden picture ({error}); BLESS=1 stores it; actual in {} {saved}",
                place.display()
            );
        }
    }
}

/// Writes expected, actual and difference pictures and panics.
fn fail(name: &str, cell: &str, expected: &Frame, actual: &Frame) -> ! {
    let place = failures(name);
    let written = write_failure(&place, expected, actual)
        .map_or_else(|e| format!("pictures not written: {e}"), |()| place.display().to_string());
    let what: Comparison = compare(expected, actual);
    panic!("{name}: {cell}: {what}; see {written}.*.png");
}

fn write_failure(place: &Path, expected: &Frame, actual: &Frame) -> Result<(), FrameError> {
    save(expected, &place.with_extension("expected.png"))?;
    save(actual, &place.with_extension("actual.png"))?;
    match difference_image(expected, actual) {
        Ok(difference) => save(&difference, &place.with_extension("difference.png")),
        // Sizes differ: there is no picture of that.
        Err(FrameError::SizesDiffer { .. }) => Ok(()),
        Err(error) => Err(error),
    }
}

fn save(frame: &Frame, path: &Path) -> Result<(), FrameError> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).map_err(|error| FrameError::Encode(error.into()))?;
    }
    frame.save_png(path)
}

/// The workspace's root.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn stored(name: &str) -> PathBuf {
    root().join("tests/golden").join(name).with_extension("png")
}

fn failures(name: &str) -> PathBuf {
    root().join("target/golden-failures").join(name)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whatever was stored before, a wrong picture is refused with its place.
    #[test]
    fn a_wrong_pixel_is_named_and_shown() {
        let frame = |value: u16| {
            let mut pixels = vec![0u16; 12];
            pixels[6] = value;
            Frame::new(4, 3, Pixels::Rgb565(pixels)).unwrap()
        };
        let caught = std::panic::catch_unwind(|| {
            fail("self-test/wrong_pixel", "scalar", &frame(0), &frame(0xf800));
        });
        let message = *caught.unwrap_err().downcast::<String>().unwrap();
        assert!(message.contains("scalar: first pixel (2, 1)"), "{message}");
        let place = failures("self-test/wrong_pixel");
        for kind in ["expected", "actual", "difference"] {
            let path = place.with_extension(format!("{kind}.png"));
            assert_eq!(Frame::load_png(&path).unwrap().width(), 4, "{}", path.display());
        }
    }
}
