//! Whole rows and whole surfaces.

use super::surface::{STAMP, Surface, stamp_index};

impl Surface {
    /// Sets every element, later where nothing reads it before.
    pub(crate) fn fill(&mut self, value: u32) {
        for cell in &mut self.cells {
            cell.clear([value as i32; (STAMP * STAMP) as usize]);
        }
    }

    /// The elements of a row from column `x` on, `count` of them, in parts that lie
    /// together: the cell, the index in it of the first, and how many.
    fn parts(
        &self,
        x: u32,
        y: u32,
        count: usize,
    ) -> impl Iterator<Item = (usize, usize, usize)> + use<> {
        let (bits, across) = (self.tile_bits(), self.tiles_across());
        let mask = (1 << bits) - 1;
        let end = self.width().min(x.saturating_add(u32::try_from(count).unwrap_or(u32::MAX)));
        let mut next = x;
        core::iter::from_fn(move || {
            let x = next;
            next = end.min((x | (STAMP - 1)) + 1);
            let cell = (y >> bits) * across + (x >> bits);
            let at = stamp_index(x & mask, y & mask, bits);
            (x < end).then(|| (cell as usize, at, (next - x) as usize))
        })
    }

    /// Copies a row's elements out, from the left, as many as `to` has and the
    /// surface holds. Much faster than asking for each.
    ///
    /// # Panics
    /// Where there is no row `y`.
    pub fn read_row(&self, y: u32, to: &mut [u32]) {
        self.read_run(0, y, to);
    }

    /// The same from column `x` on.
    ///
    /// # Panics
    /// Where there is no row `y`.
    pub fn read_run(&self, x: u32, y: u32, mut to: &mut [u32]) {
        for (cell, at, count) in self.parts(x, y, to.len()) {
            let (part, rest) = to.split_at_mut(count);
            self.cells[cell].read(at, part);
            to = rest;
        }
    }

    /// Sets a row.
    pub(crate) fn write_row(&mut self, y: u32, from: &[u32]) {
        self.write_run(0, y, from);
    }

    /// Sets elements of a row from column `x` on, as many as `from` has and the
    /// surface holds.
    ///
    /// # Panics
    /// Where there is no row `y`.
    pub fn write_run(&mut self, x: u32, y: u32, mut from: &[u32]) {
        for (cell, at, count) in self.parts(x, y, from.len()) {
            let (part, rest) = from.split_at(count);
            self.cells[cell].write(at, part);
            from = rest;
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

    #[test]
    fn runs_begin_and_end_anywhere() {
        for format in [PixelFormat::Aux16, PixelFormat::Aux32] {
            for (x, count) in [(0, 1), (3, 2), (5, 60), (30, 4), (66, 9), (69, 1), (70, 3)] {
                let mut surface = Surface::new(70, 37, format, TileSize::Small).unwrap();
                surface.fill(9);
                let run: Vec<u32> = (0..count).map(|i| 100 + i).collect();
                surface.write_run(x, 31, &run);
                let inside = |at: u32| at >= x && at < (x + count).min(70);
                for at in 0..70 {
                    let expected = if inside(at) { 100 + at - x } else { 9 };
                    assert_eq!(surface.get(at, 31), expected, "{x}, {count}: {at}");
                    assert_eq!(surface.get(at, 30), 9);
                }
                let mut read = vec![7; run.len()];
                surface.read_run(x, 31, &mut read);
                let held = 70u32.saturating_sub(x).min(count) as usize;
                assert_eq!(read[..held], run[..held]);
                assert!(read[held..].iter().all(|&left| left == 7));
            }
        }
    }
}
