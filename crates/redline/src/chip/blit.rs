//! Copies and fills by pixels of the destination, on the bytes of video memory.
//!
//! Both obey the scissor, the ALU mode and the plane mask; copies also the key.
//! Source function, blending, fog and depth are for drawing.
//!
//! Source: RR, fills and copies.

use super::VeriteChip;
use super::area::Area;
use super::target::{Kind, Place};
use super::texture::Reading;
use super::translate;
use crate::format::{PixFmt, pack, swap_red_blue};
use crate::opcode::Register;

/// The ALU mode that passes the source.
const ALU_SOURCE: u32 = 0xc;

/// A rectangle of the destination that is visible.
#[derive(Clone, Copy, Debug)]
struct Visible {
    x: u32,
    y: u32,
    width: u32,
    height: u32,
    /// How much was cut off on the left and at the top.
    skipped: [u32; 2],
}

/// How source bits meet destination bits.
#[derive(Clone, Copy, Debug)]
struct Operation {
    alu: u32,
    mask: u32,
}

impl Operation {
    fn is_copy(self) -> bool {
        self.alu == ALU_SOURCE && self.mask == u32::MAX
    }

    /// Bit by bit: `alu >> (2 * source + destination) & 1`, where the mask is 1.
    fn apply(self, source: u32, destination: u32) -> u32 {
        let all = |bit: u32| if self.alu >> bit & 1 != 0 { u32::MAX } else { 0 };
        let result = all(0) & !source & !destination
            | all(1) & !source & destination
            | all(2) & source & !destination
            | all(3) & source & destination;
        result & self.mask | destination & !self.mask
    }
}

impl VeriteChip {
    fn operation(&self, format: PixFmt) -> Operation {
        let alu = self.state.get(Register::AluMode) & 15;
        let mask = self.state.get(Register::PMask) | !format.full_mask();
        Operation { alu, mask }
    }

    /// The part of a rectangle of the destination that can be seen.
    fn visible(&self, at: u32, size: u32) -> Option<(Place, PixFmt, Visible)> {
        let (place, _) = self.destination()?;
        let Kind::Color { format, .. } = place.kind else { return None };
        let [left, right, top, bottom] = self.state.scissor();
        let columns = right.min(place.columns());
        let rows = bottom.min(place.rows(columns, self.memory.len()));
        let (x, y) = (at >> 16, at & 0xffff);
        let (x0, y0) = (x.max(left), y.max(top));
        let x1 = (x + (size >> 16)).min(columns);
        let y1 = (y + (size & 0xffff)).min(rows);
        let visible = Visible {
            x: x0,
            y: y0,
            width: x1.checked_sub(x0).filter(|&width| width > 0)?,
            height: y1.checked_sub(y0).filter(|&height| height > 0)?,
            skipped: [x0 - x, y0 - y],
        };
        Some((place, format, visible))
    }

    /// Changes the pixels of a visible rectangle. `pixel` gives the source for a
    /// column and row of it, `None` leaves the destination.
    fn change(
        &mut self,
        place: &Place,
        format: PixFmt,
        visible: &Visible,
        pixel: impl Fn(u32, u32) -> Option<u32>,
    ) {
        let operation = self.operation(format);
        let bytes = format.bytes();
        let mut row = Vec::new();
        for y in 0..visible.height {
            let address = place.base + (visible.y + y) * place.pitch + visible.x * bytes;
            let line = Area::line(address, visible.width * bytes);
            self.targets.sync(&mut self.memory, &line);
            row.clear();
            row.extend_from_slice(self.memory.get(address, visible.width * bytes));
            for (x, out) in row.chunks_exact_mut(bytes as usize).enumerate() {
                let Some(source) = pixel(x as u32, y) else { continue };
                let mut old = [0; 4];
                old[..out.len()].copy_from_slice(out);
                let new = match operation.is_copy() {
                    true => source,
                    false => operation.apply(source, u32::from_le_bytes(old)),
                };
                out.copy_from_slice(&new.to_le_bytes()[..out.len()]);
            }
            self.targets.write(&mut self.memory, address, &row);
        }
        self.invalidate();
    }

    /// `V_FIFO_BITBLT`: pixels are copied as they are between equal formats,
    /// else widened and truncated.
    pub(super) fn bitblt(&mut self, words: &[u32]) {
        let [mut to, size, mut from] = [words[0], words[1], words[2]];
        if self.config.blit_source_first {
            (to, from) = (from, to);
        }
        let Some((place, format, visible)) = self.visible(to, size) else { return };
        let Some(reading) = Reading::new(&self.state) else { return };
        let pitch = self.config.chip.linebytes(self.state.get(Register::SrcStride));
        let [left, top] = [(from >> 16) + visible.skipped[0], (from & 0xffff) + visible.skipped[1]];
        // Pixels that share bytes come in pairs.
        let (skipped, left) = (left & !1, left & 1);
        let columns = (left + visible.width).next_multiple_of(2);
        let base = u64::from(self.state.get(Register::SrcBase))
            + u64::from(top) * u64::from(pitch)
            + reading.format.row_bytes(skipped);
        let base = u32::try_from(base).unwrap_or(u32::MAX);
        let row = reading.format.row_bytes(columns) as u32;
        self.targets.sync(&mut self.memory, &Area { base, pitch, row, rows: visible.height });
        // Taken as a whole before anything is written: the two may overlap.
        let source = self.memory.read_rows(base, pitch, row, visible.height);
        let bgr = self.state.is_set(Register::DstBgr);
        let same = reading.format == format && bgr == self.state.is_set(Register::SrcBgr);
        let pixel = |x: u32, y: u32| {
            let row = &source[y as usize * row as usize..][..row as usize];
            let raw = reading.raw(row, (left + x) as usize);
            if reading.is_key(raw) {
                return None;
            }
            let packed =
                if same { raw } else { pack(format, reading.texel(row, (left + x) as usize).0) };
            Some(if bgr && !same { swap_red_blue(format, packed) } else { packed })
        };
        self.change(&place, format, &visible, pixel);
    }

    /// `V_FIFO_BITFILL`: the foreground colour, or the pattern by columns.
    pub(super) fn bitfill(&mut self, words: &[u32]) {
        let Some((place, format, visible)) = self.visible(words[0], words[1]) else { return };
        let bgr = self.state.is_set(Register::DstBgr);
        let packed = |argb: u32| {
            let pixel = pack(format, argb);
            if bgr { swap_red_blue(format, pixel) } else { pixel }
        };
        let foreground = packed(self.state.get(Register::FgColorArgb));
        let patterned = self.state.is_set(Register::PatEnable);
        if !patterned && self.operation(format).is_copy() {
            let bytes = format.bytes();
            let area = Area {
                base: place.base + visible.y * place.pitch + visible.x * bytes,
                pitch: place.pitch,
                row: visible.width * bytes,
                rows: visible.height,
            };
            return self.fill(&area, crate::record::memory::repeated(format, foreground));
        }
        let background = translate::pattern_background(&self.state).map(packed);
        let state = self.state.clone();
        let pixel = |x: u32, _: u32| match patterned {
            true if !translate::pattern_draws(&state, visible.x + x) => background,
            _ => Some(foreground),
        };
        self.change(&place, format, &visible, pixel);
    }
}
