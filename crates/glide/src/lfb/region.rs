//! Rectangles of pixels, and those of the calls before 2.4.

use fillrate_engine::state::Rect;

use super::memory::ROW_PIXELS;
use super::pixel::pixel_bytes;
use super::{OldState, screen_row};
use crate::board::Board;
use crate::enums::*;

/// Pixels of two or four bytes.
fn values(bytes: usize, line: &[u8], count: usize, to: &mut Vec<u32>) {
    to.clear();
    match bytes {
        2 => {
            let pixels = line.as_chunks().0.iter().take(count);
            to.extend(pixels.map(|&pixel| u32::from(u16::from_le_bytes(pixel))));
        }
        _ => to.extend(line.as_chunks().0.iter().take(count).map(|&p| u32::from_le_bytes(p))),
    }
}

impl Board {
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
        let screen = self.screen();
        if x >= screen.x1 || y >= screen.y1 {
            return true;
        }
        let width = width.min(screen.x1 - x) as usize;
        let height = height.min(screen.y1 - y) as usize;
        let mut pixels = Vec::with_capacity(width);
        for row in 0..height {
            let Some(line) = data.get(row.saturating_mul(stride)..) else { return true };
            values(bytes, line, width, &mut pixels);
            let y = y + row as u32;
            if self.swizzle_bits() == 0 {
                self.write_raw(buffer, format, (x, y), &pixels);
                continue;
            }
            for (x, value) in self.swizzle_row(x, format, &pixels) {
                if x < screen.x1 {
                    self.write_raw(buffer, format, (x, y), &[value]);
                }
            }
        }
        true
    }

    /// Reads a rectangle as 16-bit elements, rows from the top, without gaps.
    /// Pixels outside the buffer read as 0.
    pub(crate) fn read_region(
        &mut self,
        buffer: i32,
        (x, y): (u32, u32),
        (width, height): (u32, u32),
    ) -> Option<Vec<u16>> {
        let surface = self.surface_of(buffer)?;
        self.commit_stores();
        let (width, height) = (width.min(ROW_PIXELS as u32), height.min(ROW_PIXELS as u32));
        let mut pixels = vec![0; (width * height) as usize];
        let rect = Rect::new(x, y, x.saturating_add(width), y.saturating_add(height));
        self.read_pixels(surface, rect, &mut pixels, width as usize).ok()?;
        Some(pixels)
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
        self.commit_stores();
        let held = self.lfb.write.is_some_and(|lock| lock.buffer == buffer);
        let OldState { mode, origin, pipeline } = self.lfb.old;
        let mode = if pixel_bytes(mode) == Some(2) { mode } else { LFBWRITEMODE_ANY };
        if !held && self.lock(LFB_WRITE_ONLY, buffer, mode, origin, pipeline).is_none() {
            return false;
        }
        let screen = self.screen();
        let Some(lock) = self.lfb.write.filter(|lock| !lock.is_wide()) else { return false };
        let memory = &mut self.lfb.memories[lock.memory];
        for to in y.max(0)..y.saturating_add(height).min(screen.y1 as i32) {
            let row = to.abs_diff(y) as usize;
            let line = data.get(row.saturating_mul(stride)..).unwrap_or_default();
            let pixels = line.as_chunks().0.iter().take(width.max(0) as usize);
            for (column, &pixel) in (i64::from(x)..).zip(pixels) {
                let inside = (0..i64::from(screen.x1)).contains(&column);
                if inside {
                    let at = to as usize * ROW_PIXELS + column as usize;
                    memory.store(false, at, u32::from(u16::from_le_bytes(pixel)));
                }
            }
        }
        self.commit_stores();
        held || self.unlock(LFB_WRITE_ONLY, buffer)
    }

    /// Reads a rectangle of 16-bit pixels as the calls before 2.4 do, rows
    /// without gaps, in their row order. Pixels outside the screen read as 0.
    pub(crate) fn read_old_region(
        &mut self,
        buffer: i32,
        (x, y): (i32, i32),
        (width, height): (i32, i32),
    ) -> Option<Vec<u16>> {
        let held = self.lfb.read.filter(|lock| lock.buffer == buffer);
        let origin = held.map_or(self.lfb.old.origin, |lock| lock.origin);
        let surface = self.surface_of(buffer)?;
        self.commit_stores();
        let screen = self.screen();
        let limit = |length: i32| length.clamp(0, ROW_PIXELS as i32) as usize;
        let (width, height) = (limit(width), limit(height));
        let mut pixels = vec![0; width * height];
        let mut line = vec![0; screen.x1 as usize];
        for (row, to) in (0i64..).zip(pixels.chunks_exact_mut(width.max(1))) {
            let y = i64::from(y) + row;
            if !(0..i64::from(screen.y1)).contains(&y) {
                continue;
            }
            let y = screen_row(origin, y as usize, screen.y1 as usize) as u32;
            let all = Rect::new(0, y, screen.x1, y + 1);
            self.read_pixels(surface, all, &mut line, screen.x1 as usize).ok()?;
            for (column, to) in (i64::from(x)..).zip(to) {
                let column = usize::try_from(column).ok();
                *to = column.and_then(|column| line.get(column)).copied().unwrap_or(0);
            }
        }
        Some(pixels)
    }
}
