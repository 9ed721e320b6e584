//! Coverage: stamps of a tile inside a triangle.
//!
//! An edge that lies outside a tile, or leaves all of it inside, is decided
//! once with 64-bit arithmetic. What remains crosses the tile, so its values
//! there fit in 32 bits, however far away the vertices are. A row of sixteen
//! stamps is then classified at once: outside, inside, or crossed by an edge.

use fillrate_simd::{IntLanes, MaskLanes, Simd};

use crate::kernel::block::{STAMP, STRIP, Slot, Strip};
use crate::kernel::lanes::ramp;
use crate::setup::{Edge, Triangle};
use crate::state::Rect;

/// All fragments of a stamp.
pub(crate) const FULL: u32 = 0xffff;
/// Stamps that are classified together.
const GROUP: usize = STRIP;
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
struct GroupCoverage {
    /// Stamps of which every fragment is covered.
    full: u32,
    /// Others that may have covered fragments.
    partial: u32,
}

/// Drops a strip's fragments outside a rectangle.
#[inline(always)]
pub(crate) fn clip_strip(strip: &mut Strip, rect: &Rect) {
    let (x, y) = (strip.first.x as u32, strip.first.y as u32);
    for (i, live) in strip.live[..strip.count].iter_mut().enumerate() {
        *live &= rect_mask(rect, x + 4 * i as u32, y) as u16;
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
    fn group<S: Simd>(&self, s: S, x: u32, y: u32) -> GroupCoverage {
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
                count += self.strip(s, first, y).len();
            }
        }
        count
    }

    /// What is covered of the group of stamps at screen position (x, y). The
    /// strip knows its place on the screen, but neither triangle nor tile.
    #[inline(always)]
    pub fn strip<S: Simd>(&self, s: S, x: u32, y: u32) -> Strip {
        let GroupCoverage { full, partial } = self.group(s, x, y);
        let stamps = full | partial;
        if stamps == 0 {
            return Strip::NONE;
        }
        let (first, end) = (stamps.trailing_zeros(), 32 - stamps.leading_zeros());
        let count = (end - first) as usize;
        let x = x + 4 * first;
        let slot = Slot { x: x as i32, y: y as i32, ..Slot::default() };
        let mut strip = Strip { first: slot, count, live: [0; STRIP] };
        for (i, live) in strip.live.iter_mut().enumerate() {
            *live = if i < count { FULL as u16 } else { 0 };
        }
        // Bits of stamps that are not covered whole.
        let mut rest = !full >> first & ((1 << count) - 1);
        while rest != 0 {
            let i = rest.trailing_zeros();
            strip.live[i as usize] = self.stamp(s, x + 4 * i, y) as u16;
            rest &= rest - 1;
        }
        strip
    }

    /// The covered fragments of the stamp at screen position (x, y).
    #[inline(always)]
    fn stamp<S: Simd>(&self, s: S, x: u32, y: u32) -> u32 {
        let mut mask = rect_mask(&self.area, x, y);
        for (edge, offsets) in self.edges.iter().zip(&self.offsets).take(self.count) {
            let at = edge.start + edge.a * (x as i32 - self.x) + edge.b * (y as i32 - self.y);
            mask &= inside(s, at, offsets);
        }
        mask
    }
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
