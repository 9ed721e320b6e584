//! Frames as PNG files.

use std::fs::File;
use std::io::{self, BufRead, BufReader, BufWriter, Seek, Write};
use std::path::Path;

use png::{BitDepth, ColorType, Transformations};

use crate::error::FrameError;
use crate::frame::{Frame, Pixels, pixel_count};

impl Frame {
    /// Writes the frame as a PNG of 8 bits per channel: RGB for a frame without alpha, else RGBA.
    ///
    /// No pixel is lost: widening a 565 pixel is reversible.
    ///
    /// # Errors
    /// [`FrameError::Encode`], mostly because writing failed.
    pub fn write_png<W: Write>(&self, file: W) -> Result<(), FrameError> {
        let mut encoder = png::Encoder::new(file, self.width(), self.height());
        encoder.set_depth(BitDepth::Eight);
        encoder.set_color(match self.pixels() {
            Pixels::Rgba8(_) => ColorType::Rgba,
            Pixels::Rgb565(_) => ColorType::Rgb,
        });
        let mut writer = encoder.write_header()?;
        match self.pixels() {
            Pixels::Rgba8(bytes) => writer.write_image_data(bytes)?,
            Pixels::Rgb565(_) => {
                let bytes: Vec<u8> =
                    self.rgba_pixels().flat_map(|[r, g, b, _]| [r, g, b]).collect();
                writer.write_image_data(&bytes)?;
            }
        }
        Ok(writer.finish()?)
    }

    /// Writes a PNG file, replacing one that exists.
    ///
    /// # Errors
    /// As [`write_png`](Self::write_png).
    pub fn save_png(&self, path: &Path) -> Result<(), FrameError> {
        let io = |error: io::Error| FrameError::Encode(error.into());
        let mut file = BufWriter::new(File::create(path).map_err(io)?);
        self.write_png(&mut file)?;
        file.flush().map_err(io)
    }

    /// Reads a PNG of any kind as an RGBA frame. 16-bit channels lose their low bits.
    ///
    /// # Errors
    /// [`FrameError::Decode`], and [`FrameError::Size`] for more than
    /// [`MAX_FRAME_PIXELS`](crate::MAX_FRAME_PIXELS), found before memory is taken.
    pub fn read_png<R: BufRead + Seek>(file: R) -> Result<Self, FrameError> {
        let mut decoder = png::Decoder::new(file);
        decoder
            .set_transformations(Transformations::normalize_to_color8() | Transformations::ALPHA);
        let mut reader = decoder.read_info()?;
        let (width, height) = (reader.info().width, reader.info().height);
        let channels = reader.output_color_type().0.samples();
        let mut bytes = vec![0; pixel_count(width, height)? * channels];
        reader.next_frame(&mut bytes)?;
        Self::new(width, height, Pixels::Rgba8(with_four_channels(bytes, channels)))
    }

    /// Reads a PNG file.
    ///
    /// # Errors
    /// As [`read_png`](Self::read_png).
    pub fn load_png(path: &Path) -> Result<Self, FrameError> {
        let file = File::open(path).map_err(|error| FrameError::Decode(error.into()))?;
        Self::read_png(BufReader::new(file))
    }
}

/// Grey and alpha become red, green, blue and alpha; other pixels have four channels already.
fn with_four_channels(bytes: Vec<u8>, channels: usize) -> Vec<u8> {
    match channels {
        2 => bytes
            .as_chunks()
            .0
            .iter()
            .flat_map(|&[grey, alpha]| [grey, grey, grey, alpha])
            .collect(),
        _ => bytes,
    }
}
