//! Rectangles of bytes in video memory.

/// Rows of bytes, a pitch apart.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub(crate) struct Area {
    /// Address of the first row.
    pub base: u32,
    /// Bytes from one row to the next.
    pub pitch: u32,
    /// Bytes of a row.
    pub row: u32,
    /// Rows.
    pub rows: u32,
}

impl Area {
    /// Bytes that follow one another.
    pub fn line(base: u32, bytes: u32) -> Area {
        Area { base, pitch: 0, row: bytes, rows: 1 }
    }

    /// One past the last byte.
    pub fn end(&self) -> u64 {
        let last = u64::from(self.rows.saturating_sub(1)) * u64::from(self.pitch);
        u64::from(self.base) + last + u64::from(self.row)
    }

    /// Bytes from the first to one past the last.
    pub fn span(&self) -> u32 {
        u32::try_from(self.end() - u64::from(self.base)).unwrap_or(u32::MAX)
    }

    /// Whether no byte lies inside.
    pub fn is_empty(&self) -> bool {
        self.row == 0 || self.rows == 0
    }

    /// Whether some byte may belong to both. Exact for areas of one pitch, whose
    /// columns may lie side by side; others overlap where their ends do.
    pub fn overlaps(&self, other: &Area) -> bool {
        if self.is_empty() || other.is_empty() {
            return false;
        }
        let apart = self.end() <= u64::from(other.base) || other.end() <= u64::from(self.base);
        if apart {
            return false;
        }
        let (a, b) = if self.base <= other.base { (self, other) } else { (other, self) };
        let pitch = if b.rows == 1 { a.pitch } else { b.pitch };
        if pitch == 0 || pitch != a.pitch || a.row > pitch || b.row > pitch {
            return true;
        }
        let column = (b.base - a.base) % pitch;
        column < a.row || column + b.row > pitch
    }

    /// How many rows the lower of two areas may have to end before the other
    /// begins; `None` where they lie apart as they are.
    pub fn rows_before(&self, other: &Area) -> Option<u32> {
        if !self.overlaps(other) {
            return None;
        }
        let (a, b) = if self.base <= other.base { (self, other) } else { (other, self) };
        let room = (b.base - a.base).checked_sub(a.row);
        Some(match (room, a.pitch) {
            (None, _) => 0,
            (Some(_), 0) => 1,
            (Some(room), pitch) => room / pitch + 1,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn areas_side_by_side_do_not_overlap() {
        let left = Area { base: 1000, pitch: 2048, row: 640, rows: 100 };
        let right = Area { base: 1640, ..left };
        assert!(!left.overlaps(&right) && !right.overlaps(&left));
        assert!(left.overlaps(&Area { base: 1639, ..left }));
        assert!(left.overlaps(&Area { base: 1000 + 2048 * 3 + 639, ..Area::line(0, 1) }));
        assert!(!left.overlaps(&Area { base: 1000 + 2048 * 3 + 640, ..Area::line(0, 1) }));
        assert!(left.overlaps(&Area { base: 1640, pitch: 100, row: 10, rows: 5 }));
        assert!(!left.overlaps(&Area::line(0, 1000)));
        assert_eq!(left.rows_before(&right), None);
        let below = Area { base: 1000 + 2048 * 50 + 639, ..left };
        assert_eq!((left.rows_before(&below), below.rows_before(&left)), (Some(50), Some(50)));
        assert_eq!(left.rows_before(&Area { base: 1001, ..left }), Some(0));
        // The last column wraps into the next row's first.
        assert!(left.overlaps(&Area { base: 1000 + 2040, ..Area::line(0, 9) }));
    }
}
