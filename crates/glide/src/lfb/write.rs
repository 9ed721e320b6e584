//! Carrying out stores: past the pixel pipeline, or through it.

use std::sync::LazyLock;

use fillrate_engine::state::{Dither, Rect};
use fillrate_engine::target::pack;
use fillrate_engine::{PixelFormat, PixelRun, SurfaceId};

use super::memory::Row;
use super::pixel::{Parts, parts, pixel_bytes};
use super::{Lock, screen_row};
use crate::board::Board;
use crate::enums::*;
use crate::registers::{fbz, lfb_mode, replace, switch};

/// Calls `f` with every pixel, taken apart. The mode is known to each loop.
#[inline(always)]
fn each(mode: i32, format: i32, values: &[u32], mut f: impl FnMut(Parts)) {
    macro_rules! with {
        ($mode:literal) => {
            values.iter().for_each(|&value| f(parts($mode, format, value)))
        };
    }
    match mode {
        0 => with!(0),
        1 => with!(1),
        2 => with!(2),
        4 => with!(4),
        5 => with!(5),
        0xc => with!(0xc),
        0xd => with!(0xd),
        0xe => with!(0xe),
        _ => with!(0xf),
    }
}

/// 8-bit channels reduced to five and to six bits.
#[derive(Clone, Copy)]
struct Reduced {
    five: [u8; 256],
    six: [u8; 256],
}

/// [`Reduced`] for each place of each dither matrix; see [`place`].
static REDUCED: LazyLock<Vec<Reduced>> = LazyLock::new(|| {
    let kinds = [(Dither::Off, 1), (Dither::Ordered2x2, 2), (Dither::Ordered4x4, 4)];
    let places = |side: u32| (0..side).flat_map(move |y| (0..side).map(move |x| (x, y)));
    let all = kinds.into_iter().flat_map(|(dither, side)| {
        places(side).map(move |(x, y)| {
            let pixel = |c: usize| pack(PixelFormat::Rgb565, c as u32 * 0x01_0101, dither, x, y);
            Reduced {
                five: core::array::from_fn(|c| (pixel(c) & 31) as u8),
                six: core::array::from_fn(|c| (pixel(c) >> 5 & 63) as u8),
            }
        })
    });
    all.collect()
});

/// Where [`REDUCED`] has a screen position.
fn place(dither: Dither, x: u32, y: u32) -> usize {
    let at = |first: u32, mask: u32| first + (y & mask) * (mask + 1) + (x & mask);
    let place = match dither {
        Dither::Off => 0,
        Dither::Ordered2x2 => at(1, 1),
        Dither::Ordered4x4 => at(5, 3),
    };
    place as usize
}

/// Nothing.
const NOWHERE: Rect = Rect::new(u32::MAX, u32::MAX, 0, 0);

fn union(a: Rect, b: Rect) -> Rect {
    Rect::new(a.x0.min(b.x0), a.y0.min(b.y0), a.x1.max(b.x1), a.y1.max(b.y1))
}

impl Board {
    /// Carries out what was stored through the write lock so far, and shows the
    /// program the buffer as it is then.
    pub(crate) fn commit_stores(&mut self) {
        let stored = self.commit(self.screen());
        self.show_all(stored);
    }

    /// Carries out what was stored into a rectangle of the screen; returns the
    /// rectangle that has all of it. The memory still holds what was stored.
    pub(crate) fn commit(&mut self, rect: Rect) -> Rect {
        let screen = self.screen();
        let rect = rect.intersect(&screen);
        let Some(lock) = self.lfb.write.filter(|_| !rect.is_empty()) else { return NOWHERE };
        let memory = core::mem::take(&mut self.lfb.memories[lock.memory]);
        let (columns, rows) = lock.place(rect, screen.y1);
        // Exchanged half words stay in their word.
        let columns = columns.start & !1..columns.end.next_multiple_of(2).min(screen.x1 as usize);
        let mut stored = NOWHERE;
        let mut swizzled = [Vec::new(), Vec::new()];
        let mut kept_mode = None;
        for y in rows {
            let Some(row) = memory.row(lock.is_wide(), y, &columns) else { continue };
            if lock.pipeline && kept_mode.is_none() {
                kept_mode = Some(self.enter_pipeline(&lock));
            }
            let row = match self.swizzle_bits() {
                0 => row,
                _ => row.map(&mut swizzled, |word| self.swizzled(word)),
            };
            let part = self.commit_row(&lock, &row, y, &columns);
            stored = union(stored, part);
        }
        if let Some(mode) = kept_mode {
            self.fbi.fbz_mode = mode;
            self.dirty = true;
        }
        self.lfb.memories[lock.memory] = memory;
        stored
    }

    fn commit_row(
        &mut self,
        lock: &Lock,
        row: &Row<'_>,
        y: usize,
        columns: &core::ops::Range<usize>,
    ) -> Rect {
        let screen = screen_row(lock.origin, y, self.screen().y1 as usize) as u32;
        let mut stored = NOWHERE;
        let mut next = columns.start;
        let mut values = Vec::new();
        while let Some(run) = row.next_run(next..columns.end) {
            next = run.end;
            values.clear();
            values.extend(run.clone().map(|x| row.get(x)));
            let (x0, x1) = (run.start as u32, run.end as u32);
            if lock.pipeline {
                self.write_through_pipeline(lock.mode, (x0, y as u32), &values);
            } else {
                self.write_raw(lock.buffer, lock.mode, (x0, screen), &values);
            }
            stored = union(stored, Rect::new(x0, screen, x1, screen + 1));
        }
        stored
    }

    /// As [`Board::commit_stores`] for stores that a recording holds: for each
    /// run of pixels in a row, where it starts (1024 times the row, plus the
    /// column) and how many pixels it has, four bytes each, then the pixels, two
    /// or four bytes each. Nothing else counts as stored. Data that is no such
    /// list ends it.
    pub(crate) fn apply_stores(&mut self, changes: &[u8]) {
        let (Some(lock), rows) = (self.lfb.write, self.screen().y1 as usize) else { return };
        let memory = &mut self.lfb.memories[lock.memory];
        memory.forget_stores(lock.is_wide(), 0..rows);
        let bytes = if lock.is_wide() { 4 } else { 2 };
        let mut rest = changes;
        while let Some((head, after)) = rest.split_first_chunk::<8>() {
            let word = |at: usize| {
                u32::from_le_bytes([head[at], head[at + 1], head[at + 2], head[at + 3]])
            };
            let (first, count) = (word(0) as usize, word(4) as usize);
            let end = first.saturating_add(count);
            if end > rows * super::ROW_PIXELS || after.len() / bytes < count {
                break;
            }
            let (values, after) = after.split_at(count * bytes);
            for (at, value) in (first..end).zip(values.chunks_exact(bytes)) {
                let value = value.iter().rev().fold(0, |word, &byte| word << 8 | u32::from(byte));
                memory.store(lock.is_wide(), at, value);
            }
            rest = after;
        }
        self.commit_stores();
    }

    /// What was stored through the write lock, as [`Board::apply_stores`] takes
    /// it, where anything was.
    pub(crate) fn stores(&self) -> Option<Vec<u8>> {
        let (lock, screen) = (self.lfb.write?, self.screen());
        let memory = &self.lfb.memories[lock.memory];
        let (columns, rows) = lock.place(screen, screen.y1);
        let bytes = if lock.is_wide() { 4 } else { 2 };
        let mut out = Vec::new();
        for y in rows {
            let Some(row) = memory.row(lock.is_wide(), y, &columns) else { continue };
            let mut next = columns.start;
            while let Some(run) = row.next_run(next..columns.end) {
                next = run.end;
                let (first, count) = ((y * super::ROW_PIXELS + run.start) as u32, run.len() as u32);
                out.extend(first.to_le_bytes());
                out.extend(count.to_le_bytes());
                run.for_each(|x| out.extend(&row.get(x).to_le_bytes()[..bytes]));
            }
        }
        Some(out).filter(|changes| !changes.is_empty())
    }

    /// Takes whole memory, as recordings of earlier versions hold it. They
    /// compared with the buffer, or with zeros in formats that are not its own.
    pub(crate) fn take_whole_memory(&mut self, data: &[u8]) {
        let Some(mut lock) = self.lfb.write else { return };
        let native = matches!(lock.mode, LFBWRITEMODE_565 | LFBWRITEMODE_ZA16);
        lock.showing = super::Showing::READ;
        self.show(&lock, self.screen());
        let memory = &mut self.lfb.memories[lock.memory];
        if !native {
            memory.expect_zeros();
        }
        for (word, bytes) in memory.words.iter_mut().zip(data.as_chunks().0) {
            *word = u32::from_le_bytes(*bytes);
        }
    }

    /// A stored word as it reaches the pixels.
    fn swizzled(&self, word: u32) -> u32 {
        let on = |bit: u32| self.fbi.lfb_mode & bit != 0;
        let word = if on(lfb_mode::SWIZZLE_BYTES) { word.swap_bytes() } else { word };
        if on(lfb_mode::SWAP_WORDS) { word.rotate_left(16) } else { word }
    }

    /// Exchanges bytes and half words of a row of pixels from column `x` on as
    /// the board would have: columns and values, in order. Pixels of two bytes
    /// are stored one by one.
    pub(super) fn swizzle_row(&self, x: u32, mode: i32, values: &[u32]) -> Vec<(u32, u32)> {
        let columns = (x..).zip(values.iter().copied());
        if pixel_bytes(mode) == Some(4) {
            return columns.map(|(x, value)| (x, self.swizzled(value))).collect();
        }
        let mut row: Vec<(u32, u32)> = columns
            .map(|(x, value)| {
                let half = 16 * (x & 1);
                // Which half the store ends up in.
                let to = 16 * u32::from(self.swizzled(0xffff << half) > 0xffff);
                (x & !1 | to >> 4, self.swizzled(value << half) >> to & 0xffff)
            })
            .collect();
        row.sort_unstable_by_key(|&(x, _)| x);
        row
    }

    /// Draws into the lock's buffer, with its row order. Returns fbzMode as it
    /// was.
    fn enter_pipeline(&mut self, lock: &Lock) -> u32 {
        let kept = self.fbi.fbz_mode;
        self.fbi.fbz_mode = switch(kept, fbz::LOWER_LEFT, lock.origin != 0);
        if lock.buffer < BUFFER_AUX {
            let buffer = (lock.buffer as u32) << 14;
            self.fbi.fbz_mode = replace(self.fbi.fbz_mode, fbz::DRAW_BUFFER, buffer);
        }
        // What the engine does not stipple is left out run by run.
        let mode = self.fbi.fbz_mode;
        let pieces = self.stipples_in_pieces();
        self.fbi.fbz_mode = switch(mode, fbz::STIPPLE, mode & fbz::STIPPLE != 0 && !pieces);
        self.dirty = true;
        self.update();
        self.fbi.fbz_mode = mode;
        kept
    }

    /// Pixels through the pixel pipeline: they replace the combine units'
    /// output.
    fn write_through_pipeline(&mut self, mode: i32, (x, y): (u32, u32), values: &[u32]) {
        let (alpha, depth) = ((self.fbi.za_color >> 24) as u8, self.fbi.za_color as u16);
        let constant = self.fbi.color1 & 0xff_ffff;
        let mut colors = Vec::with_capacity(values.len());
        let mut depths = Vec::with_capacity(values.len());
        each(mode, self.lfb_format(), values, |p| {
            let rgb = p.color.unwrap_or(constant);
            colors.push(u32::from(p.alpha.unwrap_or(alpha)) << 24 | rgb);
            depths.push(p.depth.unwrap_or(depth));
        });
        if !self.stipples_in_pieces() {
            return self.draw_run(&PixelRun { x, y, colors: &colors, depths: &depths });
        }
        // Runs that the stipple lets through.
        let passes = self.stipple_fragments(x, y, colors.len());
        let mut start = 0;
        for run in passes.chunk_by(|a, b| a == b) {
            let range = start..start + run.len();
            start = range.end;
            if run[0] {
                let x = x + range.start as u32;
                let (colors, depths) = (&colors[range.clone()], &depths[range]);
                self.draw_run(&PixelRun { x, y, colors, depths });
            }
        }
    }

    /// Pixels past the pipeline: only reduced to the buffer's bits, with the
    /// current dithering. Alpha goes to the aux buffer where that holds alpha,
    /// depth where it does not.
    pub(crate) fn write_raw(&mut self, buffer: i32, mode: i32, at: (u32, u32), values: &[u32]) {
        let (x, y) = at;
        let alpha_planes = self.fbi.fbz_mode & fbz::ALPHA_PLANES != 0;
        let wide = self.improve.color_format() == PixelFormat::Argb8888;
        let tables = &REDUCED[..];
        let dither = self.dither();
        let row: [&Reduced; 4] = core::array::from_fn(|x| &tables[place(dither, x as u32, y)]);
        let (mut colors, mut aux) = (Vec::with_capacity(values.len()), Vec::new());
        let mut column = x as usize;
        each(mode, self.lfb_format(), values, |p| {
            if let Some(rgb) = p.color {
                let [_, r, g, b] = rgb.to_be_bytes().map(usize::from);
                let Reduced { five, six } = row[column & 3];
                let narrow = u32::from(five[r]) << 11 | u32::from(six[g]) << 5 | u32::from(five[b]);
                colors.push(if wide { 0xff << 24 | rgb } else { narrow });
            }
            column += 1;
            match (alpha_planes, p.alpha, p.depth) {
                (true, Some(alpha), _) => aux.push(u32::from(alpha)),
                (false, _, Some(depth)) => aux.push(u32::from(depth)),
                // ZA16 writes the aux buffer whatever it holds.
                (true, None, Some(value)) if p.color.is_none() => aux.push(u32::from(value)),
                _ => {}
            }
        });
        self.store(self.surface_of(buffer.min(BUFFER_BACK)), x, y, &colors);
        self.store(self.surface_of(BUFFER_AUX), x, y, &aux);
    }

    fn store(&mut self, surface: Option<SurfaceId>, x: u32, y: u32, elements: &[u32]) {
        if let Some(surface) = surface.filter(|_| !elements.is_empty()) {
            self.write_pixels(surface, (x, y), elements);
        }
    }
}
