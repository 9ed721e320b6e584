//! Linear frame buffer access.
//!
//! A lock hands out plain memory of 1024 pixels a row, filled with the buffer.
//! What a program stored through a write lock is found by comparing, and carried
//! out when the lock ends, before the buffers change places, and before anything
//! is read.
//!
//! Comparing cannot see a store of what is there already. In 16-bit formats
//! that hardly matters: the buffer holds it. Memory of 32-bit pixels holds
//! values that no program stores by accident instead, so that every store is
//! seen.
//!
//! Source: G246, `grLfbLock`; SST1, linear frame buffer formats.

use fillrate_engine::state::Rect;
use fillrate_engine::target::{pack, unpack};
use fillrate_engine::{PixelFormat, PixelRun, SurfaceId};

use crate::board::Board;
use crate::enums::*;
use crate::pixel_state::swizzle;
use crate::registers::{fbz, lfb_mode, replace, switch};

/// Pixels from one row to the next, whatever the resolution.
pub const ROW_PIXELS: usize = 1024;

/// One lock.
#[derive(Clone, Debug)]
pub(crate) struct Lock {
    pub buffer: i32,
    pub mode: i32,
    pub origin: i32,
    pub pipeline: bool,
    /// Rows of 1024 pixels as 32-bit words, the first pixel low.
    pub memory: Vec<u32>,
    /// The memory before anything was stored.
    shadow: Vec<u32>,
    /// zaColor and fbzMode to restore.
    saved: (u32, u32),
}

/// The locks of a board: at most one for reading and one for writing.
#[derive(Debug, Default)]
pub(crate) struct Lfb {
    pub read: Option<Lock>,
    pub write: Option<Lock>,
    /// What the calls before 2.4 set: write mode, origin, bypass.
    pub old: OldState,
}

/// Settings of the calls before 2.4.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OldState {
    pub mode: i32,
    pub origin: i32,
    pub pipeline: bool,
}

impl Default for OldState {
    fn default() -> OldState {
        OldState { mode: LFBWRITEMODE_565, origin: 0, pipeline: false }
    }
}

/// What a lock tells the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LfbInfo {
    /// Bytes from one row to the next.
    pub stride: u32,
    /// The resolved write mode.
    pub write_mode: i32,
    /// As asked for.
    pub origin: i32,
}

/// Bytes of a pixel in a write mode, or `None` for a reserved one.
fn pixel_bytes(mode: i32) -> Option<usize> {
    match mode {
        0..=2 | 0xf => Some(2),
        4 | 5 | 0xc..=0xe => Some(4),
        _ => None,
    }
}

/// A pixel in a write mode, taken apart.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Parts {
    /// 0x00RRGGBB, where the mode has colour.
    color: Option<u32>,
    alpha: Option<u8>,
    depth: Option<u16>,
}

/// Takes a pixel apart; `format` is the program's colour format.
fn parts(mode: i32, format: i32, value: u32) -> Parts {
    let five = |c: u32| (c & 31) << 3 | (c >> 2 & 7);
    let low = value & 0xffff;
    // RGBA and BGRA keep alpha in the low bits; red and blue change places in
    // ABGR and BGRA.
    let alpha_low = format >= 2;
    let exchange = |rgb: u32| match format {
        1 | 3 => rgb & 0xff00 | (rgb & 0xff) << 16 | rgb >> 16 & 0xff,
        _ => rgb,
    };
    let rgb565 = unpack(PixelFormat::Rgb565, low) & 0xff_ffff;
    let rgb555 = |v: u32| five(v >> 10) << 16 | five(v >> 5) << 8 | five(v);
    let high = (value >> 16) as u16;
    let color555 = exchange(rgb555(if alpha_low { low >> 1 } else { low }));
    let alpha1 = if low & (if alpha_low { 1 } else { 0x8000 }) != 0 { 255 } else { 0 };
    let color888 = swizzle(format, value);
    match mode {
        0 => Parts { color: Some(exchange(rgb565)), ..Parts::default() },
        1 => Parts { color: Some(color555), ..Parts::default() },
        2 => Parts { color: Some(color555), alpha: Some(alpha1), depth: None },
        4 => Parts { color: Some(color888 & 0xff_ffff), ..Parts::default() },
        5 => Parts {
            color: Some(color888 & 0xff_ffff),
            alpha: Some((color888 >> 24) as u8),
            depth: None,
        },
        0xc => Parts { color: Some(exchange(rgb565)), alpha: None, depth: Some(high) },
        0xd => Parts { color: Some(color555), alpha: None, depth: Some(high) },
        0xe => Parts { color: Some(color555), alpha: Some(alpha1), depth: Some(high) },
        _ => Parts { color: None, alpha: None, depth: Some(low as u16) },
    }
}

impl Lock {
    fn is_wide(&self) -> bool {
        pixel_bytes(self.mode) == Some(4)
    }

    /// The pixel at a column and row of the memory.
    fn get(memory: &[u32], wide: bool, x: usize, y: usize) -> u32 {
        let at = y * ROW_PIXELS + x;
        if wide { memory[at] } else { memory[at / 2] >> (16 * (at & 1)) & 0xffff }
    }

    /// Whether the memory was changed.
    fn is_changed(&self) -> bool {
        self.memory != self.shadow
    }

    /// What was stored where, as data of a call: for each run of pixels in a
    /// row, where it starts (1024 times the row, plus the column) and how many
    /// pixels it has, four bytes each, then the pixels, two or four bytes each.
    fn changes(&self, width: usize) -> Vec<u8> {
        let mut out = Vec::new();
        let bytes = if self.is_wide() { 4 } else { 2 };
        for (y, run) in self.runs(width) {
            let (first, count) = ((y * ROW_PIXELS + run.start) as u32, run.len() as u32);
            out.extend(first.to_le_bytes());
            out.extend(count.to_le_bytes());
            for x in run {
                let pixel = Lock::get(&self.memory, self.is_wide(), x, y).to_le_bytes();
                out.extend(&pixel[..bytes]);
            }
        }
        out
    }

    /// Stores what [`Lock::changes`] found; nothing else counts as stored. Data
    /// that is no such list ends it.
    fn apply(&mut self, changes: &[u8]) {
        self.shadow.copy_from_slice(&self.memory);
        let bytes = if self.is_wide() { 4 } else { 2 };
        let pixels = self.memory.len() * 4 / bytes;
        let mut rest = changes;
        while let Some((head, after)) = rest.split_first_chunk::<8>() {
            let word = |at: usize| {
                u32::from_le_bytes([head[at], head[at + 1], head[at + 2], head[at + 3]])
            };
            let (first, count) = (word(0) as usize, word(4) as usize);
            let end = first.saturating_add(count);
            if end > pixels || after.len() / bytes < count {
                return;
            }
            let (values, after) = after.split_at(count * bytes);
            for (at, value) in (first..end).zip(values.chunks_exact(bytes)) {
                let value = value.iter().rev().fold(0, |word, &byte| word << 8 | u32::from(byte));
                self.store(at, value);
            }
            rest = after;
        }
    }

    /// Stores a pixel so that it counts as stored, whatever was there.
    fn store(&mut self, at: usize, value: u32) {
        let (word, mask, shift) = match self.is_wide() {
            true => (at, u32::MAX, 0),
            false => (at / 2, 0xffff << (16 * (at & 1)), 16 * (at & 1)),
        };
        self.memory[word] = replace(self.memory[word], mask, value << shift);
        self.shadow[word] = replace(self.shadow[word], mask, !(value << shift));
    }

    /// The runs of changed pixels: rows and columns.
    fn runs(&self, width: usize) -> Vec<(usize, core::ops::Range<usize>)> {
        let wide = self.is_wide();
        let words = if wide { ROW_PIXELS } else { ROW_PIXELS / 2 };
        let mut runs = Vec::new();
        let rows = self.memory.chunks_exact(words).zip(self.shadow.chunks_exact(words));
        for (y, (memory, shadow)) in rows.enumerate() {
            let mut x = if memory == shadow { width } else { 0 };
            while x < width {
                let changed =
                    |x: usize| Lock::get(memory, wide, x, 0) != Lock::get(shadow, wide, x, 0);
                let end = (x..width).find(|&x| !changed(x)).unwrap_or(width);
                if end > x {
                    runs.push((y, x..end));
                }
                x = end + 1;
            }
        }
        runs
    }
}

/// What memory of 32-bit pixels holds before anything is stored: never the
/// same twice in a row of pixels, and in the byte that a mode does not use
/// neither all zeros nor all ones.
fn unlikely(at: usize) -> u32 {
    let mixed = (at as u32 ^ 0x5bd1_e995).wrapping_mul(0x9e37_79b1);
    let mixed = (mixed ^ mixed >> 15).wrapping_mul(0x85eb_ca77);
    let byte = |value: u32| 1 + value % 254;
    byte(mixed >> 24) << 24 | mixed & 0x00ff_ff00 | byte(mixed & 0xff)
}

impl Board {
    fn surface_of(&self, buffer: i32) -> Option<SurfaceId> {
        match buffer {
            BUFFER_FRONT | BUFFER_BACK => self.color_surface(buffer as u32),
            // 3 and 4 name the aux buffer by its use.
            2..=4 => self.buffers.as_ref()?.aux,
            _ => None,
        }
    }

    /// Starts a lock; `None` where it is refused.
    pub(crate) fn lock(
        &mut self,
        kind: i32,
        buffer: i32,
        mode: i32,
        origin: i32,
        pipeline: bool,
    ) -> Option<LfbInfo> {
        let writes = match kind & 0xf {
            LFB_READ_ONLY => false,
            LFB_WRITE_ONLY => true,
            _ => return None,
        };
        // Interleaved boards cannot be read.
        if !writes && self.card.interleaved {
            return None;
        }
        if !writes {
            self.commit_stores();
        }
        let taken = if writes { &self.lfb.write } else { &self.lfb.read };
        let surface = self.surface_of(buffer)?;
        if taken.is_some() {
            return None;
        }
        let aux = buffer >= BUFFER_AUX;
        let native = if aux { LFBWRITEMODE_ZA16 } else { LFBWRITEMODE_565 };
        let mode = if !writes || mode == LFBWRITEMODE_ANY { native } else { mode };
        let bytes = pixel_bytes(mode)?;
        if (mode == LFBWRITEMODE_ZA16) != aux {
            return None;
        }
        let rows = self.buffers.as_ref()?.height as usize;
        let mut memory = vec![0; ROW_PIXELS * rows * bytes / 4];
        self.fill_memory(&mut memory, surface, origin, mode);
        let shadow = if writes { memory.clone() } else { Vec::new() };
        let saved = (self.fbi.za_color, self.fbi.fbz_mode);
        let lock = Lock { buffer, mode, origin, pipeline, memory, shadow, saved };
        if writes {
            self.fbi.za_color =
                u32::from(self.settings.lfb_depth) | u32::from(self.settings.lfb_alpha) << 24;
            self.fbi.fbz_mode &= !fbz::DEPTH_BIAS;
            self.dirty = true;
            self.lfb.write = Some(lock);
        } else {
            self.lfb.read = Some(lock);
        }
        Some(LfbInfo { stride: (ROW_PIXELS * bytes) as u32, write_mode: mode, origin })
    }

    /// Fills the memory of a lock: with the buffer, in the lock's format, or
    /// with unlikely values where pixels have 32 bits.
    fn fill_memory(&mut self, memory: &mut [u32], surface: SurfaceId, origin: i32, mode: i32) {
        let Some(buffers) = &self.buffers else { return };
        let (width, height) = (buffers.width as usize, buffers.height as usize);
        if pixel_bytes(mode) == Some(4) {
            memory.iter_mut().enumerate().for_each(|(at, word)| *word = unlikely(at));
            return;
        }
        memory.fill(0);
        let format = self.settings.color_format;
        let mut row = vec![0u16; width];
        for y in 0..height {
            let screen = screen_row(origin, y, height) as u32;
            let rect = Rect::new(0, screen, width as u32, screen + 1);
            // The surface is one of ours, of 16 bits.
            let _ = self.read_pixels(surface, rect, &mut row, width);
            for (x, &pixel) in row.iter().enumerate() {
                let at = y * ROW_PIXELS + x;
                memory[at / 2] |= in_mode(mode, format, pixel) << (16 * (at & 1));
            }
        }
    }

    /// Carries out what was stored through the write lock so far, and shows the
    /// program the buffer as it is then.
    pub(crate) fn commit_stores(&mut self) {
        if self.lfb.write.as_ref().is_some_and(Lock::is_changed) {
            self.commit_lock();
            self.refill();
        }
    }

    /// As [`Board::commit_stores`] for stores that a recording holds.
    pub(crate) fn apply_stores(&mut self, changes: &[u8]) {
        if let Some(lock) = &mut self.lfb.write {
            lock.apply(changes);
        }
        self.commit_stores();
    }

    /// What was stored through the write lock, where anything was.
    pub(crate) fn stores(&self) -> Option<Vec<u8>> {
        let width = self.buffers.as_ref()?.width as usize;
        let lock = self.lfb.write.as_ref().filter(|lock| lock.is_changed())?;
        Some(lock.changes(width)).filter(|changes| !changes.is_empty())
    }

    /// Takes whole memory, as recordings of earlier versions hold it. They
    /// compared with the buffer, or with zeros in formats that are not its own.
    pub(crate) fn take_whole_memory(&mut self, data: &[u8]) {
        let Some(lock) = &mut self.lfb.write else { return };
        let native = matches!(lock.mode, LFBWRITEMODE_565 | LFBWRITEMODE_ZA16);
        if !native {
            lock.shadow.fill(0);
        }
        for (word, bytes) in lock.memory.iter_mut().zip(data.as_chunks().0) {
            *word = u32::from_le_bytes(*bytes);
        }
    }

    fn commit_lock(&mut self) {
        let Some(mut lock) = self.lfb.write.take() else { return };
        self.swizzle(&mut lock);
        self.commit(&lock);
        self.lfb.write = Some(lock);
    }

    /// Shows the program of a write lock what the buffer holds now. Its memory
    /// stays where it is.
    pub(crate) fn refill(&mut self) {
        let Some(mut lock) = self.lfb.write.take() else { return };
        if let Some(surface) = self.surface_of(lock.buffer) {
            self.fill_memory(&mut lock.memory, surface, lock.origin, lock.mode);
            lock.shadow.copy_from_slice(&lock.memory);
        }
        self.lfb.write = Some(lock);
    }

    /// The memory of a lock.
    pub(crate) fn lock_words(&mut self, kind: i32) -> Option<&mut Vec<u32>> {
        let lock =
            if kind & 0xf == LFB_WRITE_ONLY { &mut self.lfb.write } else { &mut self.lfb.read };
        lock.as_mut().map(|lock| &mut lock.memory)
    }

    /// Ends a lock and carries out what was written. False where there is none
    /// of that kind on that buffer.
    pub(crate) fn unlock(&mut self, kind: i32, buffer: i32) -> bool {
        match kind & 0xf {
            LFB_READ_ONLY => self.lfb.read.take_if(|lock| lock.buffer == buffer).is_some(),
            LFB_WRITE_ONLY => {
                if self.lfb.write.as_ref().is_none_or(|lock| lock.buffer != buffer) {
                    return false;
                }
                if self.lfb.write.as_ref().is_some_and(Lock::is_changed) {
                    self.commit_lock();
                }
                let Some(lock) = self.lfb.write.take() else { return false };
                let mask = fbz::DEPTH_BIAS;
                self.fbi.za_color = lock.saved.0;
                self.fbi.fbz_mode = replace(self.fbi.fbz_mode, mask, lock.saved.1);
                self.dirty = true;
                true
            }
            _ => false,
        }
    }

    /// A stored word as it reaches the pixels.
    fn swizzled(&self, word: u32) -> u32 {
        let on = |bit: u32| self.fbi.lfb_mode & bit != 0;
        let word = if on(lfb_mode::SWIZZLE_BYTES) { word.swap_bytes() } else { word };
        if on(lfb_mode::SWAP_WORDS) { word.rotate_left(16) } else { word }
    }

    fn swizzles(&self) -> bool {
        self.fbi.lfb_mode & (lfb_mode::SWIZZLE_BYTES | lfb_mode::SWAP_WORDS) != 0
    }

    /// Exchanges bytes and half words of what was written as the board would
    /// have. The untouched memory goes the same way, so that a store of half a
    /// word changes the pixel it ends up in.
    fn swizzle(&self, lock: &mut Lock) {
        if self.swizzles() {
            for word in lock.memory.iter_mut().chain(&mut lock.shadow) {
                *word = self.swizzled(*word);
            }
        }
    }

    /// As [`Board::swizzle`] for a row of pixels from column `x` on: columns
    /// and values, in order. Pixels of two bytes are stored one by one.
    fn swizzle_row(&self, x: u32, wide: bool, values: &[u32]) -> Vec<(u32, u32)> {
        let columns = (x..).zip(values.iter().copied());
        if wide {
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

    /// Carries out the changes of a write lock, row by row.
    fn commit(&mut self, lock: &Lock) {
        let Some(buffers) = &self.buffers else { return };
        let (width, height) = (buffers.width as usize, buffers.height as usize);
        for (y, run) in lock.runs(width) {
            self.write_run(lock, run, y, height);
        }
    }

    fn write_run(
        &mut self,
        lock: &Lock,
        columns: core::ops::Range<usize>,
        y: usize,
        height: usize,
    ) {
        let values: Vec<u32> =
            columns.clone().map(|x| Lock::get(&lock.memory, lock.is_wide(), x, y)).collect();
        if lock.pipeline {
            self.write_through_pipeline(lock, columns.start, y, &values);
        } else {
            let row = screen_row(lock.origin, y, height);
            self.write_raw(lock.buffer, lock.mode, (columns.start as u32, row as u32), &values);
        }
    }

    /// Pixels through the pixel pipeline: they replace the combine units'
    /// output.
    fn write_through_pipeline(&mut self, lock: &Lock, x: usize, y: usize, values: &[u32]) {
        let kept = self.fbi.fbz_mode;
        let lower_left = lock.origin != 0;
        self.fbi.fbz_mode = switch(self.fbi.fbz_mode, fbz::LOWER_LEFT, lower_left);
        if lock.buffer < BUFFER_AUX {
            let buffer = (lock.buffer as u32) << 14;
            self.fbi.fbz_mode = replace(self.fbi.fbz_mode, fbz::DRAW_BUFFER, buffer);
        }
        self.dirty = true;
        self.update();
        let (alpha, depth) = ((self.fbi.za_color >> 24) as u8, self.fbi.za_color as u16);
        let format = self.settings.color_format;
        let all = values.iter().map(|&value| parts(lock.mode, format, value));
        let colors: Vec<u32> = all
            .clone()
            .map(|p| {
                let rgb = p.color.unwrap_or(self.fbi.color1 & 0xff_ffff);
                u32::from(p.alpha.unwrap_or(alpha)) << 24 | rgb
            })
            .collect();
        let depths: Vec<u16> = all.map(|p| p.depth.unwrap_or(depth)).collect();
        let (x, y) = (x as u32, y as u32);
        let passes = match self.stipple_rotates() {
            true => self.stipple_fragments(x, y, colors.len()),
            false => vec![true; colors.len()],
        };
        // Runs that the stipple lets through; all in one where there is none.
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
        self.fbi.fbz_mode = kept;
        self.dirty = true;
    }

    /// Pixels past the pipeline: only reduced to the buffer's bits, with the
    /// current dithering. Alpha goes to the aux buffer where that holds alpha,
    /// depth where it does not.
    pub(crate) fn write_raw(&mut self, buffer: i32, mode: i32, at: (u32, u32), values: &[u32]) {
        let (x, y) = at;
        let on = |bit: u32| self.fbi.fbz_mode & bit != 0;
        let (dither, surface) = (self.dither(), self.improve.color_format());
        let alpha_planes = on(fbz::ALPHA_PLANES);
        let format = self.settings.color_format;
        let (mut colors, mut aux) = (Vec::new(), Vec::new());
        for (x, &value) in (x..).zip(values) {
            let p = parts(mode, format, value);
            if let Some(rgb) = p.color {
                colors.push(pack(surface, 0xff << 24 | rgb, dither, x, y));
            }
            match (alpha_planes, p.alpha, p.depth) {
                (true, Some(alpha), _) => aux.push(u32::from(alpha)),
                (false, _, Some(depth)) => aux.push(u32::from(depth)),
                // ZA16 writes the aux buffer whatever it holds.
                (true, None, Some(value)) if p.color.is_none() => aux.push(u32::from(value)),
                _ => {}
            }
        }
        self.store(self.surface_of(buffer.min(BUFFER_BACK)), x, y, &colors);
        self.store(self.surface_of(BUFFER_AUX), x, y, &aux);
    }

    fn store(&mut self, surface: Option<SurfaceId>, x: u32, y: u32, elements: &[u32]) {
        if let Some(surface) = surface.filter(|_| !elements.is_empty()) {
            self.write_pixels(surface, (x, y), elements);
        }
    }

    /// Copies a rectangle of pixels of a source format to a buffer. Rows count
    /// from the top; `stride` is in bytes.
    pub(crate) fn write_region(
        &mut self,
        buffer: i32,
        (x, y): (u32, u32),
        format: i32,
        (width, height): (u32, u32),
        stride: usize,
        data: &[u8],
    ) -> bool {
        let Some(bytes) = pixel_bytes(format) else { return false };
        let aux = buffer >= BUFFER_AUX;
        if self.surface_of(buffer).is_none() || (format == LFBWRITEMODE_ZA16) != aux {
            return false;
        }
        let Some(buffers) = &self.buffers else { return false };
        let (columns, rows) = (buffers.width, buffers.height);
        if x >= columns || y >= rows {
            return true;
        }
        let width = width.min(columns - x) as usize;
        let height = height.min(rows - y) as usize;
        for row in 0..height {
            let Some(line) = data.get(row * stride..) else { return true };
            let values: Vec<u32> = line
                .chunks_exact(bytes)
                .take(width)
                .map(|pixel| {
                    pixel.iter().rev().fold(0, |value, &byte| value << 8 | u32::from(byte))
                })
                .collect();
            let y = y + row as u32;
            if !self.swizzles() {
                self.write_raw(buffer, format, (x, y), &values);
                continue;
            }
            for (x, value) in self.swizzle_row(x, bytes == 4, &values) {
                if x < columns {
                    self.write_raw(buffer, format, (x, y), &[value]);
                }
            }
        }
        true
    }

    /// Writes a rectangle of 16-bit pixels as the calls before 2.4 do: through
    /// the pointer that `grLfbGetWritePtr` gave, with the settings of its time.
    /// Columns and rows outside the screen are left out.
    ///
    /// Source: G22, `guFbWriteRegion`; 2.4 has its name only.
    pub(crate) fn write_old_region(
        &mut self,
        buffer: i32,
        (x, y): (i32, i32),
        (width, height): (i32, i32),
        stride: usize,
        data: &[u8],
    ) -> bool {
        let held = self.lfb.write.as_ref().is_some_and(|lock| lock.buffer == buffer);
        let OldState { mode, origin, pipeline } = self.lfb.old;
        let mode = if pixel_bytes(mode) == Some(2) { mode } else { LFBWRITEMODE_ANY };
        if !held && self.lock(LFB_WRITE_ONLY, buffer, mode, origin, pipeline).is_none() {
            return false;
        }
        let columns = self.buffers.as_ref().map_or(0, |buffers| buffers.width as usize);
        let lock = self.lfb.write.as_mut().filter(|lock| !lock.is_wide());
        let Some(memory) = lock.map(|lock| &mut lock.memory) else { return false };
        let rows = memory.len() * 2 / ROW_PIXELS;
        for to in y.max(0)..y.saturating_add(height).min(rows as i32) {
            let row = to.abs_diff(y) as usize;
            let to = to as usize;
            let line = data.get(row.saturating_mul(stride)..).unwrap_or_default();
            let pixels = line.as_chunks().0.iter().take(width.max(0) as usize);
            for (column, &pixel) in (i64::from(x)..).zip(pixels) {
                let column = usize::try_from(column).ok().filter(|&column| column < columns);
                let Some(at) = column.map(|column| to * ROW_PIXELS + column) else { continue };
                let pixel = u32::from(u16::from_le_bytes(pixel));
                let half = 16 * (at & 1);
                memory[at / 2] = replace(memory[at / 2], 0xffff << half, pixel << half);
            }
        }
        held || self.unlock(LFB_WRITE_ONLY, buffer)
    }

    /// Reads a rectangle of 16-bit pixels as the calls before 2.4 do, rows
    /// without gaps: through the pointer that `grLfbGetReadPtr` gave, or from
    /// the buffer. Pixels outside the screen read as 0.
    pub(crate) fn read_old_region(
        &mut self,
        buffer: i32,
        (x, y): (i32, i32),
        (width, height): (i32, i32),
    ) -> Option<Vec<u16>> {
        let held = self.lfb.read.as_ref().is_some_and(|lock| lock.buffer == buffer);
        let origin = self.lfb.old.origin;
        if !held {
            self.lock(LFB_READ_ONLY, buffer, LFBWRITEMODE_ANY, origin, false)?;
        }
        let columns = self.buffers.as_ref().map_or(0, |buffers| buffers.width as usize);
        let memory = self.lfb.read.as_ref().map_or(&[][..], |lock| &lock.memory[..]);
        let rows = memory.len() * 2 / ROW_PIXELS;
        let pixel = |x: i32, y: i32| {
            let x = usize::try_from(x).ok().filter(|&x| x < columns)?;
            let y = usize::try_from(y).ok().filter(|&y| y < rows)?;
            Some(Lock::get(memory, false, x, y) as u16)
        };
        let limit = |length: i32| length.clamp(0, ROW_PIXELS as i32);
        let (width, height) = (limit(width), limit(height));
        let all = (0..height).flat_map(|row| (0..width).map(move |column| (column, row)));
        let at = |from: i32, by: i32| from.saturating_add(by);
        let pixels = all.map(|(c, r)| pixel(at(x, c), at(y, r)).unwrap_or(0)).collect();
        if !held {
            self.unlock(LFB_READ_ONLY, buffer);
        }
        Some(pixels)
    }

    /// Reads a rectangle as 16-bit elements, rows from the top, without gaps.
    /// Pixels outside the buffer read as 0.
    pub(crate) fn read_region(
        &mut self,
        buffer: i32,
        (x, y): (u32, u32),
        (width, height): (u32, u32),
    ) -> Option<Vec<u16>> {
        let surface = self.surface_of(buffer).filter(|_| !self.card.interleaved)?;
        self.commit_stores();
        let (width, height) = (width.min(ROW_PIXELS as u32), height.min(ROW_PIXELS as u32));
        let mut pixels = vec![0; (width * height) as usize];
        let rect = Rect::new(x, y, x.saturating_add(width), y.saturating_add(height));
        self.read_pixels(surface, rect, &mut pixels, width as usize).ok()?;
        Some(pixels)
    }
}

/// An element of a buffer as a pixel of a 16-bit mode, in the program's colour
/// format: 565 and aux elements as they are.
fn in_mode(mode: i32, format: i32, element: u16) -> u32 {
    let element = u32::from(element);
    if !matches!(mode, 1 | 2) {
        return element;
    }
    let (r, g, b) = (element >> 11, element >> 6 & 31, element & 31);
    let (first, last) = if matches!(format, 1 | 3) { (b, r) } else { (r, b) };
    let color = first << 10 | g << 5 | last;
    if format >= 2 { color << 1 } else { color }
}

/// The screen row of a lock's row. Any origin but the upper left counts as
/// lower left.
fn screen_row(origin: i32, y: usize, height: usize) -> usize {
    match origin {
        0 => y,
        _ => height - 1 - y,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pixels_are_taken_apart_by_format() {
        let color = |mode, format, value| parts(mode, format, value).color;
        assert_eq!(color(0, 0, 0xf800), Some(0xff_0000));
        assert_eq!(color(0, 1, 0xf800), Some(0x00_00ff));
        assert_eq!(color(1, 0, 0x7c00), Some(0xff_0000));
        assert_eq!(color(1, 2, 0xf800), Some(0xff_0000));
        assert_eq!(color(4, 2, 0x1122_3344), Some(0x11_2233));
        assert_eq!(parts(5, 0, 0x8011_2233).alpha, Some(0x80));
        assert_eq!(parts(0xc, 0, 0x1234_f800).depth, Some(0x1234));
        assert_eq!(parts(2, 0, 0x8000).alpha, Some(255));
        assert_eq!(parts(0xf, 0, 0xbeef), Parts { color: None, alpha: None, depth: Some(0xbeef) });
    }
}
