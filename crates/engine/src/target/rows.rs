//! Whole rows and whole surfaces.

use super::surface::{STAMP, Surface, stamp_index};

impl Surface {
    /// Sets every element, later where nothing reads it before.
    pub(crate) fn fill(&mut self, value: u32) {
        for cell in &mut self.cells {
            cell.clear([value as i32; (STAMP * STAMP) as usize]);
        }
    }

    /// The cell, and the index in it, of each four pixels that a row's
    /// elements lie in.
    fn row(&self, y: u32) -> impl Iterator<Item = (usize, usize)> + use<> {
        let (bits, across) = (self.tile_bits(), self.tiles_across());
        let mask = (1 << bits) - 1;
        (0..self.width()).step_by(STAMP as usize).map(move |x| {
            let cell = (y >> bits) * across + (x >> bits);
            (cell as usize, stamp_index(x & mask, y & mask, bits))
        })
    }

    /// Copies a row's elements out, from the left, as many as `to` has and the
    /// surface holds. Much faster than asking for each.
    ///
    /// # Panics
    /// Where there is no row `y`.
    pub fn read_row(&self, y: u32, to: &mut [u32]) {
        for (to, (cell, at)) in to.chunks_mut(STAMP as usize).zip(self.row(y)) {
            self.cells[cell].read(at, to);
        }
    }

    /// Sets a row.
    pub(crate) fn write_row(&mut self, y: u32, from: &[u32]) {
        for (from, (cell, at)) in from.chunks(STAMP as usize).zip(self.row(y)) {
            for (i, &value) in from.iter().enumerate() {
                self.cells[cell].set(at + i, value);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::target::{PixelFormat, Surface, TileSize};

    #[test]
    fn rows_are_where_pixels_are() {
        let mut surface = Surface::new(70, 37, PixelFormat::Aux32, TileSize::Small).unwrap();
        surface.fill(9);
        let row: Vec<u32> = (0..70).map(|x| x * 0x0101_0101).collect();
        surface.write_row(33, &row);
        let mut read = vec![0; 70];
        for y in 0..37 {
            surface.read_row(y, &mut read);
            let expected: Vec<u32> = (0..70).map(|x| surface.get(x, y)).collect();
            assert_eq!(read, expected);
            assert_eq!(read == row, y == 33);
        }
    }
}
