//! Drawing shapes of the Quark profile in a tile.

use fillrate_simd::{Kernel, Simd};

use super::coverage::TileCoverage;
use crate::kernel::palette::{Pixels, Place, StampPainter, source};
use crate::setup::{Shape, Texels};
use crate::state::{Compare, PaletteDraw, Rect};
use crate::stats::Counters;
use crate::target::{Plane, TileCell, stamp_index};

/// A tile of the target, and what is counted.
pub(crate) struct PaletteTile<'a> {
    /// Its pixels, those beyond the target's edge included.
    pub rect: Rect,
    /// The part on the target.
    pub visible: Rect,
    /// log2 of its side.
    pub bits: u32,
    pub color: &'a mut TileCell,
    pub depth: Option<&'a mut TileCell>,
    pub counters: &'a mut Counters,
}

/// Draws a shape in a tile.
#[inline(always)]
pub(crate) fn draw_shape<S: Simd>(
    s: S,
    draw: &PaletteDraw,
    shape: &Shape,
    mut tile: PaletteTile<'_>,
) {
    let mut coverage = TileCoverage::NONE;
    if !coverage.enter_edges(s, shape.edges(), &shape.bounds, &tile.rect) {
        return;
    }
    let range = shape.depth_range(&coverage.area);
    if tile.is_hidden(draw, range) {
        return tile.count_hidden(s, &coverage);
    }
    tile.update_bounds(draw, range, &coverage);
    let work = Work { draw, shape, coverage: &coverage, tile };
    match (&shape.texels, draw.state.reads_texture()) {
        (_, false) => s.vectorize(Stamps::<{ source::FLAT }>(work)),
        (Texels::Affine { .. }, _) => s.vectorize(Stamps::<{ source::AFFINE }>(work)),
        (Texels::Perspective { .. }, _) => s.vectorize(Stamps::<{ source::PERSPECTIVE }>(work)),
    }
}

impl PaletteTile<'_> {
    /// Whether every fragment fails the depth test against the tile's bounds.
    fn is_hidden(&self, draw: &PaletteDraw, (low, high): (u16, u16)) -> bool {
        let (Some(depth), Some(test)) = (&self.depth, draw.state.test) else { return false };
        match test {
            Compare::Greater => high <= depth.low,
            Compare::GreaterEqual => high < depth.low,
            Compare::Less => low >= depth.high,
            Compare::LessEqual => low > depth.high,
            _ => false,
        }
    }

    #[inline(always)]
    fn count_hidden<S: Simd>(&mut self, s: S, coverage: &TileCoverage) {
        let count = coverage.count(s);
        self.counters.pixels_in += count;
        self.counters.depth_fail += count;
    }

    /// Keeps the tile's depth bounds true for a shape that is drawn.
    fn update_bounds(
        &mut self,
        draw: &PaletteDraw,
        (low, high): (u16, u16),
        coverage: &TileCoverage,
    ) {
        let Some(depth) = &mut self.depth else { return };
        if !draw.state.depth_write {
            return;
        }
        depth.include(low, high);
        let whole = coverage.is_full() && coverage.area.contains(&self.visible);
        if !whole || draw.state.key.is_some() {
            return;
        }
        match draw.state.test {
            None | Some(Compare::Always) => (depth.low, depth.high) = (low, high),
            Some(Compare::Greater | Compare::GreaterEqual) => depth.low = depth.low.max(low),
            Some(Compare::Less | Compare::LessEqual) => depth.high = depth.high.min(high),
            _ => {}
        }
    }
}

struct Work<'a> {
    draw: &'a PaletteDraw,
    shape: &'a Shape,
    coverage: &'a TileCoverage,
    tile: PaletteTile<'a>,
}

/// All stamps of a shape in a tile, by one source of base colours.
struct Stamps<'a, const SOURCE: u8>(Work<'a>);

impl<const SOURCE: u8> Kernel for Stamps<'_, SOURCE> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self, s: S) {
        let Work { draw, shape, coverage, tile } = self.0;
        let PaletteTile { rect, bits, color, depth, counters, .. } = tile;
        color.materialize();
        let Plane::Bits16(color) = &mut color.plane else { return };
        let depth = depth.map(|cell| {
            cell.materialize();
            &mut cell.plane
        });
        let depth = match depth {
            Some(Plane::Bits16(depth)) => depth.as_mut_slice(),
            _ => &mut [],
        };
        let mut pixels = Pixels { color, depth };
        let painter = StampPainter::<SOURCE>::new(s, draw, shape);
        for y in coverage.rows() {
            for first in coverage.groups() {
                let strip = coverage.strip(s, first, y);
                for (i, mask) in strip.live[..strip.count].iter().enumerate() {
                    let (x, mask) = (strip.first.x as u32 + 4 * i as u32, u32::from(*mask));
                    if mask == 0 {
                        continue;
                    }
                    counters.pixels_in += u64::from(mask.count_ones());
                    let at = stamp_index(x - rect.x0, y - rect.y0, bits);
                    let place = Place { at, x: x as i32, y: y as i32 };
                    painter.stamp(s, place, mask, &mut pixels, counters);
                }
            }
        }
    }
}
