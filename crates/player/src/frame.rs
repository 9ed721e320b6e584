//! One picture in memory.

use fillrate_trace::{PixelsRef, hash_frame};

use crate::error::FrameError;

/// The most pixels that a frame has; bounds what a damaged file can make a tool allocate.
pub const MAX_FRAME_PIXELS: u64 = 1 << 26;

/// Pixels row by row from the top left, without gaps between rows.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Pixels {
    /// Four bytes each: red, green, blue, alpha.
    Rgba8(Vec<u8>),
    /// Five bits of red (the highest), six of green, five of blue.
    Rgb565(Vec<u16>),
}

/// A complete picture. Its pixels fill its size exactly.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Frame {
    width: u32,
    height: u32,
    pixels: Pixels,
}

impl Frame {
    /// A frame of `width` x `height` pixels.
    ///
    /// # Errors
    /// [`FrameError::Size`] for an empty frame or more than [`MAX_FRAME_PIXELS`];
    /// [`FrameError::Length`] unless the pixels fill the frame exactly.
    pub fn new(width: u32, height: u32, pixels: Pixels) -> Result<Self, FrameError> {
        let count = pixel_count(width, height)?;
        let (needed, found) = match &pixels {
            Pixels::Rgba8(bytes) => (4 * count, bytes.len()),
            Pixels::Rgb565(words) => (count, words.len()),
        };
        if needed != found {
            return Err(FrameError::Length { needed, found });
        }
        Ok(Self { width, height, pixels })
    }

    /// Width in pixels, at least 1.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Height in pixels, at least 1.
    pub fn height(&self) -> u32 {
        self.height
    }

    /// The pixels.
    pub fn pixels(&self) -> &Pixels {
        &self.pixels
    }

    /// The hash of size, format and pixels, the same on every machine.
    ///
    /// It is the one stored in traces: see [`hash_frame`].
    pub fn hash(&self) -> u64 {
        let pixels = match &self.pixels {
            Pixels::Rgba8(bytes) => PixelsRef::Rgba8(bytes),
            Pixels::Rgb565(words) => PixelsRef::Rgb565(words),
        };
        hash_frame(self.width, self.height, pixels)
    }

    /// Red, green, blue, alpha of the pixel at column `x` from the left, row `y` from the top; `None`
    /// outside. Shorter channels are widened by repeating their high bits; alpha is then 255.
    pub fn rgba(&self, x: u32, y: u32) -> Option<[u8; 4]> {
        if x >= self.width || y >= self.height {
            return None;
        }
        self.rgba_at(y as usize * self.width as usize + x as usize)
    }

    /// All pixels in order as by [`rgba`](Self::rgba).
    pub fn rgba_pixels(&self) -> impl Iterator<Item = [u8; 4]> + '_ {
        (0..).map_while(|index| self.rgba_at(index))
    }

    fn rgba_at(&self, index: usize) -> Option<[u8; 4]> {
        match &self.pixels {
            Pixels::Rgba8(bytes) => bytes.as_chunks().0.get(index).copied(),
            Pixels::Rgb565(words) => words.get(index).copied().map(widen_565),
        }
    }
}

/// How many pixels a frame of this size has.
///
/// # Errors
/// [`FrameError::Size`] if there are none or more than [`MAX_FRAME_PIXELS`].
pub(crate) fn pixel_count(width: u32, height: u32) -> Result<usize, FrameError> {
    let count = u64::from(width) * u64::from(height);
    if count == 0 || count > MAX_FRAME_PIXELS {
        return Err(FrameError::Size { width, height });
    }
    Ok(count as usize)
}

/// Widens each channel to 8 bits by repeating its high bits, so that 0 stays 0 and full stays full.
fn widen_565(pixel: u16) -> [u8; 4] {
    let five = |bits: u16| (bits << 3 | bits >> 2) as u8;
    let six = |bits: u16| (bits << 2 | bits >> 4) as u8;
    [five(pixel >> 11), six(pixel >> 5 & 0x3f), five(pixel & 0x1f), 0xff]
}
