//! Showing frames, and access to the frame buffer.
//!
//! Source: QK, frame buffer; `FlushFB`.

use fillrate_engine::state::{Dither, Rect};
use fillrate_engine::{ClearValues, EngineError, FlushReason, SurfaceId};

use super::Gpu;
use crate::color::{COLOR_MASK, display_tables};

/// A frame as it was shown: 13-bit colours, row by row from the top left.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Shown {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Base colour in bits 0..7, intensity in bits 8..12.
    pub colors: Vec<u16>,
}

impl Shown {
    /// The frame as 565.
    pub fn rgb565(&self) -> Vec<u16> {
        let table = &display_tables().rgb565;
        self.colors.iter().map(|&c| table[usize::from(c & COLOR_MASK)]).collect()
    }

    /// The frame as red, green, blue, alpha of 8 bits each.
    pub fn rgba8888(&self) -> Vec<u8> {
        let table = &display_tables().rgb888;
        let pixel = |&c: &u16| {
            let [r, g, b] = table[usize::from(c & COLOR_MASK)];
            [r, g, b, 255]
        };
        self.colors.iter().flat_map(pixel).collect()
    }

    /// The frame's 565 pixels and where each belongs in a display's memory:
    /// bytes from its first pixel, given the bytes from a pixel to its right
    /// and to its lower neighbour, which may be negative.
    pub fn placed(&self, right: i64, down: i64) -> impl Iterator<Item = (i64, u16)> + '_ {
        let table = &display_tables().rgb565;
        let width = i64::from(self.width);
        self.colors.iter().enumerate().map(move |(i, &c)| {
            let (x, y) = (i as i64 % width, i as i64 / width);
            (x * right + y * down, table[usize::from(c & COLOR_MASK)])
        })
    }
}

impl Gpu {
    /// Shows the frame and clears the frame buffer to a 13-bit colour at
    /// infinite distance. Source: QK, `FlushFB`.
    pub fn flush_frame(&mut self, clear_color: u16) {
        self.device.submit(FlushReason::Swap);
        std::mem::swap(&mut self.back, &mut self.front);
        // Both surfaces were made by this device, of one size.
        let _ = self.device.set_target(self.back, Some(self.depth));
        self.clear(clear_color);
        self.frame_counter = self.frame_counter.wrapping_add(1);
    }

    /// Clears the frame buffer without showing it.
    pub fn clear(&mut self, color: u16) {
        let (width, height) = self.size();
        let color = u32::from(color & COLOR_MASK);
        self.device.clear(
            Rect::new(0, 0, width, height),
            ClearValues { color: Some((color, Dither::Off)), aux: Some(0) },
        );
    }

    /// The frame shown last; black before the first.
    pub fn shown(&mut self) -> Shown {
        let (width, height) = self.size();
        Shown { width, height, colors: self.colors(self.front).unwrap_or_default() }
    }

    /// The frame buffer's words, row by row: colour in bits 0..12, 1/z in bits
    /// 16..31.
    pub fn frame_buffer(&mut self) -> Vec<u32> {
        let colors = self.colors(self.back).unwrap_or_default();
        let depths = self.colors(self.depth).unwrap_or_default();
        let word = |(color, depth): (u16, u16)| u32::from(color) | u32::from(depth) << 16;
        colors.into_iter().zip(depths).map(word).collect()
    }

    /// Replaces words of the frame buffer, given by their indices; indices
    /// outside are ignored. Bits 13..15 are dropped.
    pub fn write_frame_buffer(&mut self, words: impl IntoIterator<Item = (usize, u32)>) {
        let (width, height) = self.size();
        for (index, word) in words {
            let Ok(index) = u32::try_from(index) else { continue };
            if index >= width * height {
                continue;
            }
            let (x, y) = (index % width, index / width);
            for (id, value) in [(self.back, word & u32::from(COLOR_MASK)), (self.depth, word >> 16)]
            {
                if let Ok(surface) = self.device.surface(id) {
                    surface.set(x, y, value);
                }
            }
        }
    }

    fn colors(&mut self, id: SurfaceId) -> Result<Vec<u16>, EngineError> {
        let (width, height) = self.size();
        let mut out = vec![0; (width * height) as usize];
        let all = Rect::new(0, 0, width, height);
        self.device.read16(id, all, &mut out, width as usize)?;
        Ok(out)
    }
}
