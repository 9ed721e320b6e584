//! Comparing two frames, pixel by pixel.

use std::fmt;

use crate::error::FrameError;
use crate::frame::{Frame, Pixels};

/// The weakest channel that a difference image shows for a channel that differs.
const MIN_SHOWN: u32 = 64;

/// The result of a comparison.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Comparison {
    /// Same size, same pixels.
    Same,
    /// The sizes differ, so that no pixel has a counterpart.
    Sizes {
        /// Width and height of the expected frame.
        expected: (u32, u32),
        /// Width and height of the actual frame.
        actual: (u32, u32),
    },
    /// Some pixels differ.
    Pixels(Difference),
}

/// How two frames of the same size differ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Difference {
    /// Column from the left and row from the top of the first pixel that differs, row by row.
    pub first: (u32, u32),
    /// Red, green, blue, alpha that were expected there.
    pub expected: [u8; 4],
    /// Red, green, blue, alpha that were found there.
    pub actual: [u8; 4],
    /// How many pixels differ.
    pub count: u64,
    /// The largest difference of one channel over all pixels, in steps of 8 bits: 1 to 255.
    pub max_channel: u8,
}

impl Comparison {
    /// Whether nothing differs.
    pub fn is_same(&self) -> bool {
        *self == Self::Same
    }
}

impl fmt::Display for Comparison {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Same => f.write_str("same"),
            Self::Sizes { expected: (ew, eh), actual: (aw, ah) } => {
                write!(f, "size {aw} x {ah}, expected {ew} x {eh}")
            }
            Self::Pixels(difference) => difference.fmt(f),
        }
    }
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { first: (x, y), expected, actual, count, max_channel } = self;
        let s = if *count == 1 { "" } else { "s" };
        write!(
            f,
            "first pixel ({x}, {y}): {actual:?}, expected {expected:?}; \
             {count} pixel{s}, largest difference {max_channel}"
        )
    }
}

/// Compares two frames as 8-bit RGBA. Frames of different pixel formats may be the same.
pub fn compare(expected: &Frame, actual: &Frame) -> Comparison {
    let (expected_size, actual_size) = (size(expected), size(actual));
    if expected_size != actual_size {
        return Comparison::Sizes { expected: expected_size, actual: actual_size };
    }
    let width = u64::from(expected.width());
    let mut difference: Option<Difference> = None;
    for ((wanted, found), index) in expected.rgba_pixels().zip(actual.rgba_pixels()).zip(0u64..) {
        if wanted == found {
            continue;
        }
        let entry = difference.get_or_insert(Difference {
            first: ((index % width) as u32, (index / width) as u32),
            expected: wanted,
            actual: found,
            count: 0,
            max_channel: 0,
        });
        entry.count += 1;
        entry.max_channel = entry.max_channel.max(largest(distance(wanted, found)));
    }
    difference.map_or(Comparison::Same, Comparison::Pixels)
}

/// A picture of where two frames differ: black where they are the same, elsewhere each channel's
/// difference, stretched so that the largest of the picture is 255 and none is below 64. A
/// difference in alpha alone is shown as grey.
///
/// # Errors
/// [`FrameError::SizesDiffer`].
pub fn difference_image(expected: &Frame, actual: &Frame) -> Result<Frame, FrameError> {
    let max = match compare(expected, actual) {
        Comparison::Same => 1,
        Comparison::Pixels(difference) => u32::from(difference.max_channel),
        Comparison::Sizes { expected, actual } => {
            return Err(FrameError::SizesDiffer { expected, actual });
        }
    };
    let stretch = |channel: u8| match channel {
        0 => 0,
        _ => (u32::from(channel) * 255 / max).max(MIN_SHOWN) as u8,
    };
    let pixels = expected.rgba_pixels().zip(actual.rgba_pixels()).flat_map(|(wanted, found)| {
        let [r, g, b, a] = distance(wanted, found).map(stretch);
        if [r, g, b] == [0; 3] { [a, a, a, 255] } else { [r, g, b, 255] }
    });
    Frame::new(expected.width(), expected.height(), Pixels::Rgba8(pixels.collect()))
}

fn size(frame: &Frame) -> (u32, u32) {
    (frame.width(), frame.height())
}

/// The difference of each channel.
fn distance(a: [u8; 4], b: [u8; 4]) -> [u8; 4] {
    std::array::from_fn(|channel| a[channel].abs_diff(b[channel]))
}

fn largest(channels: [u8; 4]) -> u8 {
    channels.into_iter().fold(0, u8::max)
}
