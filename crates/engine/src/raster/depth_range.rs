//! Depth bounds: dropping a triangle in a tile without looking at fragments.

use crate::kernel::Pipeline;
use crate::kernel::depth::float_w;
use crate::setup::{Triangle, Triangles, Z};
use crate::state::{AuxWrite, Compare, DepthSource, Rect};
use crate::target::TileCell;

/// The depth values that a triangle can have in a part of a tile; `None`
/// where iterators may wrap there.
pub(crate) fn depth_range(
    pipeline: &Pipeline,
    triangles: &Triangles,
    triangle: &Triangle,
    area: &Rect,
) -> Option<(u16, u16)> {
    let (x, y) = (area.x0 as i32, area.y0 as i32);
    let (right, down) = (i64::from(area.x1 - area.x0 - 1), i64::from(area.y1 - area.y0 - 1));
    let (low, high) = match pipeline.state.depth.source {
        DepthSource::Z => {
            let (low, high) = triangle.narrow.range(Z, [x, y], [right, down]);
            if low < 0 || high >= 0x1_0000 << 12 {
                return None;
            }
            (low >> 12, high >> 12)
        }
        DepthSource::FloatW => {
            let w = triangles.w(triangle);
            if !triangle.exact {
                return None;
            }
            // Exact triangles keep within 47 bits over their bounds.
            let (dx, dy) = (w.dx.checked_mul(right)?, w.dy.checked_mul(down)?);
            let low = w.at(x, y) + dx.min(0) + dy.min(0);
            let high = w.at(x, y) + dx.max(0) + dy.max(0);
            if low < 0 || high >> 47 != 0 {
                return None;
            }
            (i64::from(float_w(high)), i64::from(float_w(low)))
        }
        DepthSource::DeepZ | DepthSource::DeepW => return None,
    };
    let bias = i64::from(pipeline.state.depth.bias.unwrap_or(0));
    let limit = |depth: i64| (depth + bias).clamp(0, 0xffff) as u16;
    Some((limit(low), limit(high)))
}

/// Whether every fragment fails against a tile with these bounds.
pub(crate) fn is_hidden(pipeline: &Pipeline, (low, high): (u16, u16), tile: &TileCell) -> bool {
    let depth = &pipeline.state.depth;
    if depth.compare_constant.is_some() {
        return false;
    }
    match depth.test {
        Some(Compare::Less) => low >= tile.high,
        Some(Compare::LessEqual) => low > tile.high,
        Some(Compare::Greater) => high <= tile.low,
        Some(Compare::GreaterEqual) => high < tile.low,
        _ => false,
    }
}

/// Whether nothing can be hidden by a tile's bounds.
#[inline(always)]
pub(crate) fn hides_nothing(pipeline: &Pipeline, tile: &TileCell) -> bool {
    match pipeline.state.depth.test {
        Some(Compare::Less | Compare::LessEqual) => tile.high == 0xffff,
        Some(Compare::Greater | Compare::GreaterEqual) => tile.low == 0,
        _ => true,
    }
}

/// Updates a tile's bounds for a triangle that is drawn; `whole` where every
/// pixel of the tile is covered and none can be dropped except by depth.
pub(crate) fn update_bounds(
    pipeline: &Pipeline,
    range: Option<(u16, u16)>,
    whole: bool,
    tile: &mut TileCell,
) {
    match pipeline.state.aux_write {
        AuxWrite::Nothing => return,
        AuxWrite::Alpha => return tile.include(0, 0xff),
        AuxWrite::Depth => {}
    }
    let Some((low, high)) = range else { return tile.include(0, 0xffff) };
    let depth = &pipeline.state.depth;
    let constant = depth.compare_constant.is_some();
    match depth.test {
        // What passes is on that side of what was there.
        Some(Compare::Less | Compare::LessEqual) if !constant => tile.include(low, tile.high),
        Some(Compare::Greater | Compare::GreaterEqual) if !constant => tile.include(tile.low, high),
        _ => tile.include(low, high),
    }
    if !whole || constant {
        return;
    }
    match depth.test {
        None | Some(Compare::Always) => (tile.low, tile.high) = (low, high),
        Some(Compare::Less | Compare::LessEqual) => tile.high = tile.high.min(high),
        Some(Compare::Greater | Compare::GreaterEqual) => tile.low = tile.low.max(low),
        _ => {}
    }
}
