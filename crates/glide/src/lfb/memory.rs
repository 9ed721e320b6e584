//! Memory that programs read and write: what it holds, what it was made to
//! hold, and so what was stored.

use core::ops::Range;

use crate::registers::replace;

/// Pixels from one row to the next, whatever the resolution.
pub const ROW_PIXELS: usize = 1024;
/// Rows of the address space.
const ROWS: usize = 1024;

/// The address space of one lock: 1024 rows of 1024 pixels, of four bytes or,
/// in its first half, of two. It stays where it is while the board is open.
#[derive(Debug, Default)]
pub(crate) struct Memory {
    /// 32-bit words, the first pixel low.
    pub words: Vec<u32>,
    /// The words as they were before the program stored anything; empty until
    /// a write lock needs them.
    shadow: Vec<u32>,
}

impl Memory {
    /// Makes the memory, zeros where it is new: for pixels of four bytes, and
    /// with what finds stores in so many rows, or for two bytes that are only
    /// read.
    pub fn prepare(&mut self, wide_and_stored: Option<(bool, usize)>) {
        // Pages that nobody touches are never taken.
        if self.words.is_empty() {
            self.words = vec![0; ROWS * words_of_row(wide_and_stored.is_some())];
        }
        if let Some((wide, rows)) = wide_and_stored {
            let words = rows * words_of_row(wide);
            self.shadow.resize(words.max(self.shadow.len()), 0);
        }
    }

    /// Whether pixels of four bytes have room.
    pub fn holds_wide(&self) -> bool {
        self.words.len() == ROWS * ROW_PIXELS
    }

    /// A pixel.
    pub fn get(&self, wide: bool, x: usize, y: usize) -> u32 {
        get(&self.words[y * words_of_row(wide)..], wide, x)
    }

    /// Makes a pixel hold what nobody stored.
    #[inline(always)]
    pub fn show(&mut self, wide: bool, at: usize, value: u32) {
        if wide {
            self.words[at] = value;
            if let Some(shadow) = self.shadow.get_mut(at) {
                *shadow = value;
            }
            return;
        }
        let shift = 16 * (at & 1);
        let word = replace(self.words[at / 2], 0xffff << shift, value << shift);
        self.words[at / 2] = word;
        if let Some(shadow) = self.shadow.get_mut(at / 2) {
            *shadow = replace(*shadow, 0xffff << shift, value << shift);
        }
    }

    /// Stores a pixel so that it counts as stored, whatever was there.
    pub fn store(&mut self, wide: bool, at: usize, value: u32) {
        let (word, mask, shift) = match wide {
            true => (at, u32::MAX, 0),
            false => (at / 2, 0xffff << (16 * (at & 1)), 16 * (at & 1)),
        };
        self.words[word] = replace(self.words[word], mask, value << shift);
        self.shadow[word] = replace(self.shadow[word], mask, !(value << shift));
    }

    /// Everything in these rows counts as not stored.
    pub fn forget_stores(&mut self, wide: bool, rows: Range<usize>) {
        let row = words_of_row(wide);
        let words = rows.start * row..rows.end * row;
        self.shadow[words.clone()].copy_from_slice(&self.words[words]);
    }

    /// Everything that is not 0 counts as stored.
    pub fn expect_zeros(&mut self) {
        self.shadow.fill(0);
    }

    /// The stores in a row, where there are any in these columns.
    pub fn row(&self, wide: bool, y: usize, columns: &Range<usize>) -> Option<Row<'_>> {
        let first = y * words_of_row(wide);
        let row = Row {
            words: &self.words[first..first + words_of_row(wide)],
            shadow: &self.shadow[first..first + words_of_row(wide)],
            wide,
        };
        let part = match wide {
            true => columns.clone(),
            false => columns.start / 2..columns.end.div_ceil(2),
        };
        (row.words[part.clone()] != row.shadow[part]).then_some(row)
    }
}

fn words_of_row(wide: bool) -> usize {
    if wide { ROW_PIXELS } else { ROW_PIXELS / 2 }
}

fn get(words: &[u32], wide: bool, x: usize) -> u32 {
    if wide { words[x] } else { words[x / 2] >> (16 * (x & 1)) & 0xffff }
}

/// A row of memory in which something was stored.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Row<'a> {
    words: &'a [u32],
    shadow: &'a [u32],
    wide: bool,
}

impl<'a> Row<'a> {
    /// A row of other words.
    pub fn map<'b>(&self, to: &'b mut [Vec<u32>; 2], f: impl Fn(u32) -> u32) -> Row<'b> {
        for (to, from) in to.iter_mut().zip([self.words, self.shadow]) {
            to.clear();
            to.extend(from.iter().map(|&word| f(word)));
        }
        Row { words: &to[0], shadow: &to[1], wide: self.wide }
    }

    /// A pixel.
    #[inline(always)]
    pub fn get(&self, x: usize) -> u32 {
        get(self.words, self.wide, x)
    }

    fn is_stored(&self, x: usize) -> bool {
        self.get(x) != get(self.shadow, self.wide, x)
    }

    /// The first run of stored pixels in some columns.
    pub fn next_run(&self, columns: Range<usize>) -> Option<Range<usize>> {
        let start = columns.clone().find(|&x| self.is_stored(x))?;
        let end = (start..columns.end).find(|&x| !self.is_stored(x)).unwrap_or(columns.end);
        Some(start..end)
    }
}
