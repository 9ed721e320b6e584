//! Coverage: stamps of a tile inside a triangle.
//!
//! An edge that lies outside a tile, or leaves all of it inside, is decided
//! once with 64-bit arithmetic. What remains crosses the tile, so its values
//! there fit in 32 bits, however far away the vertices are.

use fillrate_simd::{IntLanes, MaskLanes, Simd};

use crate::kernel::block::STAMP;
use crate::kernel::lanes::{COLUMN, ROW};
use crate::setup::{Edge, Triangle};
use crate::state::Rect;

/// All fragments of a stamp.
pub(crate) const FULL: u32 = 0xffff;

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
    /// Offsets of a stamp's fragments.
    offsets: [i32; STAMP],
}

/// A triangle within one tile.
pub(crate) struct TileCoverage {
    edges: [TileEdge; 3],
    count: usize,
    /// The tile's first pixel.
    x: i32,
    y: i32,
    /// The triangle's bounds inside the tile.
    pub area: Rect,
}

impl TileCoverage {
    /// `None` where the triangle covers nothing of the tile.
    #[inline(always)]
    pub fn new<S: Simd>(s: S, triangle: &Triangle, tile: &Rect) -> Option<TileCoverage> {
        let edges = &triangle.edges[..triangle.edge_count as usize];
        TileCoverage::of_edges(s, edges, &triangle.bounds, tile)
    }

    /// As [`TileCoverage::new`], of at most three edges and bounds.
    #[inline(always)]
    pub fn of_edges<S: Simd>(
        s: S,
        edges: &[Edge],
        bounds: &Rect,
        tile: &Rect,
    ) -> Option<TileCoverage> {
        let area = bounds.intersect(tile);
        if area.is_empty() {
            return None;
        }
        let empty = TileEdge { start: 0, a: 0, b: 0, least: 0, greatest: 0, offsets: [0; STAMP] };
        let (x, y) = (tile.x0 as i32, tile.y0 as i32);
        let mut out = TileCoverage { edges: [empty; 3], count: 0, x, y, area };
        let last = i64::from(tile.x1 - tile.x0 - 1);
        for edge in edges {
            let start = edge.at(x, y);
            let (a, b) = (i64::from(edge.a), i64::from(edge.b));
            if start + (a.max(0) + b.max(0)) * last < 0 {
                return None;
            }
            if start + (a.min(0) + b.min(0)) * last >= 0 {
                continue;
            }
            out.edges[out.count] = tile_edge(s, start as i32, edge.a, edge.b);
            out.count += 1;
        }
        Some(out)
    }

    /// Whether every pixel of `area` is covered.
    pub fn is_full(&self) -> bool {
        self.count == 0
    }

    /// The covered fragments of the stamp at screen position (x, y); `None`
    /// where it and all stamps to its right are beyond an edge.
    ///
    /// An empty stamp alone says nothing of the next: slivers have gaps.
    #[inline(always)]
    pub fn stamp<S: Simd>(&self, s: S, x: u32, y: u32) -> Option<u32> {
        let mut mask = rect_mask(&self.area, x, y);
        let (dx, dy) = (x as i32 - self.x, y as i32 - self.y);
        for edge in &self.edges[..self.count] {
            let value = edge.start + edge.a * dx + edge.b * dy;
            if value + edge.greatest < 0 {
                return if edge.a <= 0 { None } else { Some(0) };
            }
            if value + edge.least < 0 {
                mask &= inside(s, value, &edge.offsets);
            }
        }
        Some(mask)
    }
}

#[inline(always)]
fn tile_edge<S: Simd>(s: S, start: i32, a: i32, b: i32) -> TileEdge {
    let mut offsets = [0; STAMP];
    for j in (0..STAMP).step_by(S::LANES) {
        let offset = s.load(&COLUMN[j..]).mul(s.splat(a)) + s.load(&ROW[j..]).mul(s.splat(b));
        s.store(offset, &mut offsets[j..]);
    }
    let (least, greatest) = (3 * (a.min(0) + b.min(0)), 3 * (a.max(0) + b.max(0)));
    TileEdge { start, a, b, least, greatest, offsets }
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
