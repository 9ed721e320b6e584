//! Coverage: stamps of a tile inside a triangle.
//!
//! An edge that lies outside a tile, or leaves all of it inside, is decided
//! once with 64-bit arithmetic. What remains crosses the tile, so its values
//! there fit in 32 bits, however far away the vertices are. A row of sixteen
//! stamps is then classified at once: outside, inside, or crossed by an edge.

use fillrate_simd::{IntLanes, MaskLanes, Simd};

use crate::kernel::block::STAMP;
use crate::kernel::lanes::{places, ramp};
use crate::setup::{Edge, Triangle};
use crate::state::Rect;

/// All fragments of a stamp.
pub(crate) const FULL: u32 = 0xffff;
/// Stamps that are classified together.
const GROUP: usize = 16;
/// Screen columns of a group.
const GROUP_WIDTH: u32 = 4 * GROUP as u32;

/// 4, 8, ... : columns from a group's first stamp to each of its stamps.
static STAMP_COLUMNS: [i32; GROUP] = [0, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40, 44, 48, 52, 56, 60];

/// An edge within one tile.
#[derive(Clone, Copy)]
struct TileEdge {
    /// Value at the tile's first pixel, and its steps.
    start: i32,
    a: i32,
    b: i32,
    /// Least and greatest offset within a stamp.
    least: i32,
    greatest: i32,
}

/// A triangle within one tile.
pub(crate) struct TileCoverage {
    edges: [TileEdge; 3],
    /// Offsets of a stamp's fragments, for each edge.
    offsets: [[i32; STAMP]; 3],
    count: usize,
    /// The tile's first pixel.
    x: i32,
    y: i32,
    /// The triangle's bounds inside the tile.
    pub area: Rect,
}

/// The covered stamps of a group, as bits from the left.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct GroupCoverage {
    /// Stamps of which every fragment is covered.
    pub full: u32,
    /// Others that may have covered fragments.
    pub partial: u32,
}

impl GroupCoverage {
    /// Screen columns of the covered stamps of a group that begins at `first`,
    /// and whether each is covered whole.
    #[inline(always)]
    pub fn stamps(self, first: u32) -> Stamps {
        Stamps { group: self, first }
    }
}

/// See [`GroupCoverage::stamps`].
pub(crate) struct Stamps {
    group: GroupCoverage,
    first: u32,
}

impl Iterator for Stamps {
    type Item = (u32, bool);

    #[inline(always)]
    fn next(&mut self) -> Option<(u32, bool)> {
        let GroupCoverage { full, partial } = &mut self.group;
        let stamps = *full | *partial;
        if stamps == 0 {
            return None;
        }
        let bit = stamps & stamps.wrapping_neg();
        let is_full = *full & bit != 0;
        *full &= !bit;
        *partial &= !bit;
        Some((self.first + 4 * bit.trailing_zeros(), is_full))
    }
}

impl TileCoverage {
    pub const NONE: TileCoverage = TileCoverage {
        edges: [TileEdge { start: 0, a: 0, b: 0, least: 0, greatest: 0 }; 3],
        offsets: [[0; STAMP]; 3],
        count: 0,
        x: 0,
        y: 0,
        area: Rect::new(0, 0, 0, 0),
    };

    /// Becomes a triangle's coverage of a tile; false where it covers nothing
    /// of it.
    #[inline(always)]
    pub fn enter<S: Simd>(&mut self, s: S, triangle: &Triangle, tile: &Rect) -> bool {
        let edges = &triangle.edges[..usize::from(triangle.edge_count)];
        self.enter_edges(s, edges, &triangle.bounds, tile)
    }

    /// As [`TileCoverage::enter`], of at most three edges and bounds.
    #[inline(always)]
    pub fn enter_edges<S: Simd>(
        &mut self,
        s: S,
        edges: &[Edge],
        bounds: &Rect,
        tile: &Rect,
    ) -> bool {
        self.area = bounds.intersect(tile);
        if self.area.is_empty() {
            return false;
        }
        let (x, y) = (tile.x0 as i32, tile.y0 as i32);
        (self.x, self.y, self.count) = (x, y, 0);
        let last = i64::from(tile.x1 - tile.x0 - 1);
        for edge in edges {
            let start = edge.at(x, y);
            let (a, b) = (i64::from(edge.a), i64::from(edge.b));
            if start + (a.max(0) + b.max(0)) * last < 0 {
                return false;
            }
            if start + (a.min(0) + b.min(0)) * last >= 0 {
                continue;
            }
            let (a, b) = (edge.a, edge.b);
            ramp(s, a, b, &mut self.offsets[self.count]);
            let (least, greatest) = (3 * (a.min(0) + b.min(0)), 3 * (a.max(0) + b.max(0)));
            self.edges[self.count] = TileEdge { start: start as i32, a, b, least, greatest };
            self.count += 1;
        }
        true
    }

    /// Whether every pixel of `area` is covered.
    pub fn is_full(&self) -> bool {
        self.count == 0
    }

    /// Screen columns where the groups of a row of stamps begin.
    pub fn groups(&self) -> impl Iterator<Item = u32> + use<> {
        let first = self.area.x0 & !(GROUP_WIDTH - 1);
        (first..self.area.x1).step_by(GROUP_WIDTH as usize)
    }

    /// Screen rows where the rows of stamps begin.
    pub fn rows(&self) -> impl Iterator<Item = u32> + use<> {
        (self.area.y0 & !3..self.area.y1).step_by(4)
    }

    /// Classifies the group of stamps at screen position (x, y).
    #[inline(always)]
    pub fn group<S: Simd>(&self, s: S, x: u32, y: u32) -> GroupCoverage {
        let area = &self.area;
        let bits = |from: u32, to: u32| {
            let column = |at: u32| (at.saturating_sub(x) / 4).min(GROUP as u32);
            (1u32 << column(to)).wrapping_sub(1) & !((1u32 << column(from)) - 1)
        };
        let mut touched = bits(area.x0, area.x1 + 3);
        let whole_rows = area.y0 <= y && y + 4 <= area.y1;
        let mut full = if whole_rows { bits(area.x0 + 3, area.x1) } else { 0 };
        for edge in &self.edges[..self.count] {
            let at = edge.start + edge.a * (x as i32 - self.x) + edge.b * (y as i32 - self.y);
            for j in (0..GROUP).step_by(S::LANES) {
                let value = s.splat(at) + s.load(&STAMP_COLUMNS[j..]).mul(s.splat(edge.a));
                let outside = s.splat(-edge.greatest).gt(value).bits() << j;
                let crossed = s.splat(-edge.least).gt(value).bits() << j;
                touched &= !outside;
                full &= !crossed;
            }
        }
        GroupCoverage { full, partial: touched & !full }
    }

    /// Fragments that are covered.
    #[inline(always)]
    pub fn count<S: Simd>(&self, s: S) -> u64 {
        if self.is_full() {
            return self.area.area();
        }
        let mut count = 0;
        for y in self.rows() {
            for first in self.groups() {
                for (x, _) in self.group(s, first, y).stamps(first) {
                    count += u64::from(self.stamp(s, x, y).count_ones());
                }
            }
        }
        count
    }

    /// The covered fragments of the stamp at screen position (x, y).
    #[inline(always)]
    pub fn stamp<S: Simd>(&self, s: S, x: u32, y: u32) -> u32 {
        let mut mask = rect_mask(&self.area, x, y);
        for (edge, offsets) in self.edges.iter().zip(&self.offsets).take(self.count) {
            let at = edge.start + edge.a * (x as i32 - self.x) + edge.b * (y as i32 - self.y);
            mask &= inside(s, at, offsets);
        }
        mask
    }
}

/// Whether an area is so small that its stamps are not worth classifying.
#[inline(always)]
pub(crate) fn is_small(area: &Rect) -> bool {
    let stamps = |from: u32, to: u32| to.div_ceil(4) - from / 4;
    stamps(area.x0, area.x1) * stamps(area.y0, area.y1) <= 6
}

/// The fragments of the stamp at screen position (x, y) that a compact triangle
/// covers inside `area`.
#[inline(always)]
pub(crate) fn compact_stamp<S: Simd>(
    s: S,
    triangle: &Triangle,
    area: &Rect,
    x: u32,
    y: u32,
) -> u32 {
    let mut mask = 0;
    for j in (0..STAMP).step_by(S::LANES) {
        let [px, py] = places(s, x as i32, y as i32, j);
        // Outside any border the sign is set.
        let columns = (px - s.splat(area.x0 as i32)) | (s.splat(area.x1 as i32 - 1) - px);
        let rows = (py - s.splat(area.y0 as i32)) | (s.splat(area.y1 as i32 - 1) - py);
        let mut outside = columns | rows;
        // An edge that is not in use is zero everywhere. The low 32 bits of a
        // value are those of the sum of the low 32 bits.
        for edge in &triangle.edges {
            let rise = px.mul(s.splat(edge.a)) + py.mul(s.splat(edge.b));
            outside = outside | (s.splat(edge.c as i32) + rise);
        }
        mask |= outside.gt(s.splat(-1)).bits() << j;
    }
    mask
}

/// Fragments whose edge value is not negative.
#[inline(always)]
fn inside<S: Simd>(s: S, value: i32, offsets: &[i32; STAMP]) -> u32 {
    let mut mask = 0;
    for j in (0..STAMP).step_by(S::LANES) {
        let lanes = s.splat(value) + s.load(&offsets[j..]);
        mask |= lanes.gt(s.splat(-1)).bits() << j;
    }
    mask
}

/// The fragments of the stamp at (x, y) that lie in a rectangle.
#[inline(always)]
pub(crate) fn rect_mask(rect: &Rect, x: u32, y: u32) -> u32 {
    if rect.x0 <= x && rect.y0 <= y && x + 4 <= rect.x1 && y + 4 <= rect.y1 {
        return FULL;
    }
    let range = |from: u32, to: u32, at: u32| {
        let low = from.saturating_sub(at).min(4);
        let high = to.saturating_sub(at).min(4);
        (1u32 << high).wrapping_sub(1) & !((1 << low) - 1)
    };
    let columns = range(rect.x0, rect.x1, x);
    let rows = range(rect.y0, rect.y1, y);
    // Each row bit becomes the columns at that row.
    let spread = (rows & 1) | (rows & 2) << 3 | (rows & 4) << 6 | (rows & 8) << 9;
    spread * columns
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rect_masks() {
        assert_eq!(rect_mask(&Rect::new(0, 0, 8, 8), 4, 4), FULL);
        assert_eq!(rect_mask(&Rect::new(5, 6, 7, 8), 4, 4), 0x6600);
        assert_eq!(rect_mask(&Rect::new(9, 0, 12, 8), 4, 4), 0);
        assert_eq!(rect_mask(&Rect::new(0, 0, 4, 8), 4, 4), 0);
        assert_eq!(rect_mask(&Rect::new(0, 3, 1, 4), 0, 0), 0x1000);
    }
}
