//! What is shown of a context: the pixels that its device holds.

use fillrate_engine::PixelFormat;
use fillrate_engine::state::Dither;
use fillrate_engine::target::{pack, unpack};

use crate::pixel::PixelType;
use crate::vertex::RaveRect;

/// The engine's format for pixels of a type; `None` where nothing can be drawn
/// in it.
pub(crate) fn surface_format(pixel_type: PixelType) -> Option<PixelFormat> {
    Some(match pixel_type {
        PixelType::Rgb16 => PixelFormat::Xrgb1555,
        PixelType::Argb16 => PixelFormat::Argb1555,
        PixelType::Rgb32 | PixelType::Rgb24 => PixelFormat::Xrgb8888,
        PixelType::Argb32 => PixelFormat::Argb8888,
        PixelType::Rgb16_565 => PixelFormat::Rgb565,
        PixelType::Rgb8_332 => PixelFormat::Rgb332,
        PixelType::Argb16_4444 => PixelFormat::Argb4444,
        PixelType::I8 => PixelFormat::Gray8,
        _ => return None,
    })
}

/// A context's picture as its device holds it.
#[derive(Clone, Debug)]
pub(crate) struct Front {
    pub width: u32,
    pub height: u32,
    pub format: PixelFormat,
    /// The parts of the picture that are shown; `None`: all of it.
    pub clip: Option<Vec<RaveRect>>,
    /// Rows from the top, one element each.
    pub elements: Vec<u32>,
    /// The rectangle of what was shown since this was taken last.
    pub fresh: Option<RaveRect>,
}

impl Front {
    /// A picture of zeros.
    pub fn new(width: u32, height: u32, format: PixelFormat, clip: Option<Vec<RaveRect>>) -> Front {
        let elements = vec![0; (width * height) as usize];
        Front { width, height, format, clip, elements, fresh: None }
    }

    /// Whether the clip shows a pixel.
    pub fn shows(&self, x: u32, y: u32) -> bool {
        let inside = |rect: &RaveRect| rect.contains(x as i32, y as i32);
        self.clip.as_ref().is_none_or(|clip| clip.iter().any(inside))
    }

    /// Replaces, or composes with, the pixel that is there.
    pub fn put(&mut self, x: u32, y: u32, element: u32, composite: u32) {
        let place = &mut self.elements[(y * self.width + x) as usize];
        *place = match composite {
            0 => element,
            mode => compose(self.format, element, *place, mode == 2),
        };
    }

    /// Adds to what was shown.
    pub fn note(&mut self, rect: RaveRect) {
        self.fresh = Some(self.fresh.map_or(rect, |old| RaveRect {
            left: old.left.min(rect.left),
            right: old.right.max(rect.right),
            top: old.top.min(rect.top),
            bottom: old.bottom.max(rect.bottom),
        }));
    }
}

/// The source over the destination by its alpha; `interpolates`: its colour is
/// not multiplied by alpha yet.
fn compose(format: PixelFormat, source: u32, destination: u32, interpolates: bool) -> u32 {
    let [sa, s @ ..] = unpack(format, source).to_be_bytes().map(u32::from);
    let [da, d @ ..] = unpack(format, destination).to_be_bytes().map(u32::from);
    let rounded = |product: u32| (product + 127) / 255;
    let mix = |i: usize| {
        let s = if interpolates { rounded(s[i] * sa) } else { s[i] };
        (s + rounded(d[i] * (255 - sa))).min(255)
    };
    let alpha = 255 - rounded((255 - sa) * (255 - da));
    let argb = alpha << 24 | mix(0) << 16 | mix(1) << 8 | mix(2);
    pack(format, argb, Dither::Off, 0, 0)
}

/// A picture that was shown.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Shown {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// What a pixel is.
    pub pixel_type: PixelType,
    /// Rows from the top, without padding, in the pixel type.
    pub pixels: Vec<u8>,
}

impl Shown {
    /// The elements of a picture as bytes.
    pub(crate) fn new(width: u32, height: u32, pixel_type: PixelType, elements: &[u32]) -> Shown {
        let bytes = pixel_type.bits() as usize / 8;
        let pixels = match bytes {
            2 => elements.iter().flat_map(|&e| (e as u16).to_le_bytes()).collect(),
            4 => elements.iter().flat_map(|&e| e.to_le_bytes()).collect(),
            _ => elements.iter().flat_map(|e| e.to_le_bytes().into_iter().take(bytes)).collect(),
        };
        Shown { width, height, pixel_type, pixels }
    }

    /// The pixels as red, green, blue and alpha.
    pub fn rgba8888(&self) -> Vec<u8> {
        let mut argb = Vec::with_capacity((self.width * self.height) as usize);
        let row = self.pixel_type.row_bytes(self.width).max(1);
        for row in self.pixels.chunks_exact(row) {
            crate::image::decode_row(row, self.width as usize, self.pixel_type, None, &mut argb);
        }
        argb.iter().flat_map(|p| [p >> 16, p >> 8, *p, p >> 24].map(|c| c as u8)).collect()
    }

    /// A pixel as 0xAARRGGBB; transparent black outside.
    pub fn argb(&self, x: u32, y: u32) -> u32 {
        if x >= self.width || y >= self.height {
            return 0;
        }
        let bytes = self.pixel_type.bits() as usize / 8;
        let at = (y * self.width + x) as usize * bytes;
        let mut argb = Vec::new();
        crate::image::decode_row(&self.pixels[at..at + bytes], 1, self.pixel_type, None, &mut argb);
        argb[0]
    }
}
