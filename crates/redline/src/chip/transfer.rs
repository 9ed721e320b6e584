//! Commands that move bytes: writes, fills, sprites.
//!
//! Source: RR, memory commands.

use super::VeriteChip;
use super::area::Area;

/// The bytes of words, the low byte first.
pub(super) fn bytes_of(words: &[u32]) -> Vec<u8> {
    crate::command::word_bytes(words)
}

impl VeriteChip {
    /// `V_FIFO_MEM_WRITE`.
    pub(super) fn mem_write(&mut self, words: &[u32]) {
        let bytes = bytes_of(&words[2..]);
        self.write_bytes(words[0], &bytes[..words[1] as usize]);
    }

    /// `V_FIFO_MEM_WRITE_RECT`: rows padded to words.
    pub(super) fn mem_write_rect(&mut self, words: &[u32]) {
        let [base, pitch, row, _] = [words[0], words[1], words[2], words[3]];
        if row == 0 {
            return;
        }
        let data = bytes_of(&words[4..]);
        let Some(padded) = row.checked_next_multiple_of(4) else { return };
        for (y, bytes) in data.chunks_exact(padded as usize).enumerate() {
            let Some(at) = row_address(base, pitch, y as u32) else { return };
            self.write_bytes(at, &bytes[..row as usize]);
        }
    }

    /// `V_FIFO_MEM_CLEAR_RECT`: every row starts with the value's low byte.
    pub(super) fn mem_clear_rect(&mut self, words: &[u32]) {
        let [base, pitch, row, rows, value] = [words[0], words[1], words[2], words[3], words[4]];
        let row = row.min(self.memory.len());
        // Rows beyond the memory cannot be written, however many there are.
        let room = self.memory.len().saturating_sub(base);
        let rows = if pitch == 0 { rows.min(1) } else { rows.min(room.div_ceil(pitch)) };
        self.fill(&Area { base, pitch, row, rows }, value);
    }

    /// Fills rows with a word's bytes: through the engine where they are part of
    /// what it draws into.
    pub(super) fn fill(&mut self, area: &Area, value: u32) {
        if area.is_empty() {
            return;
        }
        if self.clear(area, value) {
            return;
        }
        let mut line = Vec::with_capacity(area.row as usize + 3);
        while line.len() < area.row as usize {
            line.extend_from_slice(&value.to_le_bytes());
        }
        for y in 0..area.rows {
            // Of rows that overlap, the next one covers all but the first bytes.
            let last = y + 1 == area.rows;
            let count = if last { area.row } else { area.row.min(area.pitch) };
            self.write_bytes(area.base + y * area.pitch, &line[..count as usize]);
        }
    }

    /// Fills through the engine; false where that cannot be.
    fn clear(&mut self, area: &Area, value: u32) -> bool {
        // A frame often begins with a fill, before anything has chosen its target.
        let cleared = self.targets.clear(area, value)
            || (self.aims_at(area) && self.enter() && self.targets.clear(area, value));
        if cleared && self.texture_area().is_some_and(|texture| texture.overlaps(area)) {
            self.invalidate();
        }
        cleared
    }

    /// `V_FIFO_MEM_WRITE_SPRITE`: runs of bytes with gaps between them.
    pub(super) fn mem_write_sprite(&mut self, words: &[u32]) {
        let (mut at, mut rest) = (words[0], &words[2..]);
        while let Some((&head, data)) = rest.split_first().filter(|(head, _)| **head != 0) {
            let (skip, run) = (head >> 16, head & 0xffff);
            let (data, more) = data.split_at(run.div_ceil(4) as usize);
            at = at.saturating_add(skip);
            self.write_bytes(at, &bytes_of(data)[..run as usize]);
            at = at.saturating_add(run);
            rest = more;
        }
    }
}

/// Address of a row; `None` where addresses end.
fn row_address(base: u32, pitch: u32, row: u32) -> Option<u32> {
    base.checked_add(pitch.checked_mul(row)?)
}
