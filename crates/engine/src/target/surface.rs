//! Pixel storage in tiles of 4x4 stamps.
//!
//! A surface is a grid of square tiles; a tile's pixels are stamps of 4x4,
//! rows of stamps from the top, and a stamp's sixteen pixels lie together. A
//! vector of the engine is one stamp, so that every load and store is
//! contiguous, a tile stays in L1, and the dither matrix is one constant.
//! Linear rows exist only where somebody reads or writes rows.

use super::PixelFormat;
use crate::error::EngineError;
use crate::state::Rect;

/// Side of a stamp in pixels.
pub const STAMP: u32 = 4;
/// Pixels of a stamp.
pub(crate) const STAMP_PIXELS: usize = (STAMP * STAMP) as usize;
/// The longest side of a surface, in pixels.
pub const MAX_SIDE: u32 = 8192;

/// Side of a tile. It changes no pixel, only how work is cut up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum TileSize {
    /// 32 pixels.
    Small,
    /// 64 pixels.
    #[default]
    Medium,
    /// 128 pixels.
    Large,
}

impl TileSize {
    /// log2 of the side.
    pub fn bits(self) -> u32 {
        match self {
            TileSize::Small => 5,
            TileSize::Medium => 6,
            TileSize::Large => 7,
        }
    }

    /// The side in pixels.
    pub fn side(self) -> u32 {
        1 << self.bits()
    }
}

/// One tile's pixels.
#[derive(Clone, Debug)]
pub(crate) enum Plane {
    /// 16-bit elements.
    Bits16(Vec<u16>),
    /// 32-bit elements.
    Bits32(Vec<i32>),
}

/// One tile: its pixels, a clear that has not been carried out yet, and what
/// is known of its values.
#[derive(Clone, Debug, Default)]
pub(crate) struct TileCell {
    pub plane: Plane,
    /// The stamp that every stamp of the tile equals; `plane` is stale.
    pub pending: Option<[i32; STAMP_PIXELS]>,
    /// No element is below.
    pub low: u16,
    /// No element is above. Bounds are kept for aux planes.
    pub high: u16,
}

impl Default for Plane {
    /// No pixels: what stands for those of a tile that is being drawn.
    fn default() -> Plane {
        Plane::Bits16(Vec::new())
    }
}

impl TileCell {
    fn new(format: PixelFormat, side: u32) -> TileCell {
        let len = (side * side) as usize;
        let plane = match format.bytes() {
            4 => Plane::Bits32(vec![0; len]),
            _ => Plane::Bits16(vec![0; len]),
        };
        TileCell { plane, pending: None, low: 0, high: 0 }
    }

    /// Tells the processor that a stamp is needed soon; `at` is its first element.
    #[inline(always)]
    pub fn prefetch(&self, at: usize) {
        match &self.plane {
            Plane::Bits16(pixels) => {
                pixels.get(at).inspect(|pixel| fillrate_simd::prefetch(*pixel));
            }
            Plane::Bits32(pixels) => {
                pixels.get(at).inspect(|pixel| fillrate_simd::prefetch(*pixel));
            }
        }
    }

    /// Fills the whole tile, later.
    pub fn clear(&mut self, stamp: [i32; STAMP_PIXELS]) {
        self.pending = Some(stamp);
        let values = stamp.map(|v| v as u16);
        self.low = values.into_iter().min().unwrap_or(0);
        self.high = values.into_iter().max().unwrap_or(0);
    }

    /// Carries out a pending clear.
    #[inline(always)]
    pub fn materialize(&mut self) {
        if self.pending.is_some() {
            self.fill_pending();
        }
    }

    #[inline(never)]
    fn fill_pending(&mut self) {
        let Some(stamp) = self.pending.take() else { return };
        match &mut self.plane {
            Plane::Bits16(pixels) => {
                let stamp = stamp.map(|v| v as u16);
                pixels.as_chunks_mut::<STAMP_PIXELS>().0.fill(stamp);
            }
            Plane::Bits32(pixels) => pixels.as_chunks_mut::<STAMP_PIXELS>().0.fill(stamp),
        }
    }

    /// Whether its bounds mean something: those of 32-bit elements do not.
    pub fn has_bounds(&self) -> bool {
        matches!(self.plane, Plane::Bits16(_))
    }

    /// Widens the bounds to include a value.
    pub fn include(&mut self, low: u16, high: u16) {
        self.low = self.low.min(low);
        self.high = self.high.max(high);
    }

    pub fn get(&self, at: usize) -> u32 {
        match (&self.pending, &self.plane) {
            (Some(stamp), Plane::Bits16(_)) => stamp[at % STAMP_PIXELS] as u16 as u32,
            (Some(stamp), Plane::Bits32(_)) => stamp[at % STAMP_PIXELS] as u32,
            (None, Plane::Bits16(pixels)) => u32::from(pixels[at]),
            (None, Plane::Bits32(pixels)) => pixels[at] as u32,
        }
    }

    /// Copies consecutive elements of one stamp out.
    pub fn read(&self, at: usize, to: &mut [u32]) {
        for (to, at) in to.iter_mut().zip(at..) {
            *to = self.get(at);
        }
    }

    /// Sets consecutive elements of one stamp.
    pub fn write(&mut self, at: usize, from: &[u32]) {
        self.materialize();
        for &value in from {
            self.include(value as u16, value as u16);
        }
        let part = at..at + from.len();
        match &mut self.plane {
            Plane::Bits16(pixels) => {
                pixels[part].iter_mut().zip(from).for_each(|(to, &from)| *to = from as u16);
            }
            Plane::Bits32(pixels) => {
                pixels[part].iter_mut().zip(from).for_each(|(to, &from)| *to = from as i32);
            }
        }
    }

    pub fn set(&mut self, at: usize, value: u32) {
        self.materialize();
        self.include(value as u16, value as u16);
        match &mut self.plane {
            Plane::Bits16(pixels) => pixels[at] = value as u16,
            Plane::Bits32(pixels) => pixels[at] = value as i32,
        }
    }
}

/// A rectangle of pixels. Contents start as zeros.
#[derive(Clone, Debug)]
pub struct Surface {
    width: u32,
    height: u32,
    format: PixelFormat,
    tile: TileSize,
    pub(crate) cells: Vec<TileCell>,
}

impl Surface {
    /// A surface of `width` x `height` pixels.
    ///
    /// # Errors
    /// [`EngineError::SurfaceSize`] where a side is 0 or above [`MAX_SIDE`].
    pub fn new(
        width: u32,
        height: u32,
        format: PixelFormat,
        tile: TileSize,
    ) -> Result<Surface, EngineError> {
        let allowed = 1..=MAX_SIDE;
        if !allowed.contains(&width) || !allowed.contains(&height) {
            return Err(EngineError::SurfaceSize { width, height });
        }
        let count = width.div_ceil(tile.side()) * height.div_ceil(tile.side());
        let cells = (0..count).map(|_| TileCell::new(format, tile.side())).collect();
        Ok(Surface { width, height, format, tile, cells })
    }

    /// Columns.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Rows.
    pub fn height(&self) -> u32 {
        self.height
    }

    /// What an element is.
    pub fn format(&self) -> PixelFormat {
        self.format
    }

    /// log2 of a tile's side.
    pub(crate) fn tile_bits(&self) -> u32 {
        self.tile.bits()
    }

    /// Tiles in a row of tiles.
    pub(crate) fn tiles_across(&self) -> u32 {
        self.width.div_ceil(self.tile.side())
    }

    /// All pixels.
    pub fn bounds(&self) -> Rect {
        Rect::new(0, 0, self.width, self.height)
    }

    /// The tile and the index in it of a pixel inside the surface.
    fn locate(&self, x: u32, y: u32) -> (usize, usize) {
        let bits = self.tile.bits();
        let tile = (y >> bits) * self.tiles_across() + (x >> bits);
        let mask = self.tile.side() - 1;
        (tile as usize, stamp_index(x & mask, y & mask, bits))
    }

    /// One element; the position must be inside.
    pub fn get(&self, x: u32, y: u32) -> u32 {
        let (tile, at) = self.locate(x, y);
        self.cells[tile].get(at)
    }

    /// Writes one element; the position must be inside.
    pub fn set(&mut self, x: u32, y: u32, value: u32) {
        let (tile, at) = self.locate(x, y);
        self.cells[tile].set(at, value);
    }
}

/// Index within a tile of side 2^`bits` of the pixel at (x, y) in it.
pub(crate) fn stamp_index(x: u32, y: u32, bits: u32) -> usize {
    let stamp = ((y >> 2) << (bits - 2)) + (x >> 2);
    ((stamp << 4) | ((y & 3) << 2) | (x & 3)) as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_pixel_has_its_own_element() {
        let mut surface = Surface::new(70, 37, PixelFormat::Aux16, TileSize::Small).unwrap();
        for y in 0..37 {
            for x in 0..70 {
                surface.set(x, y, y * 70 + x);
            }
        }
        for y in 0..37 {
            for x in 0..70 {
                assert_eq!(surface.get(x, y), y * 70 + x);
            }
        }
    }

    #[test]
    fn a_pending_clear_reads_like_a_done_one() {
        let mut cell = TileCell::new(PixelFormat::Aux16, 32);
        cell.clear(core::array::from_fn(|i| i as i32));
        assert_eq!((cell.get(17), cell.low, cell.high), (1, 0, 15));
        cell.set(17, 40);
        assert_eq!((cell.get(16), cell.get(17), cell.get(18), cell.high), (0, 40, 2, 40));
    }
}
