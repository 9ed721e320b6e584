//! Drawing shapes of the Raw profile in a tile.
//!
//! A triangle's values are sums along its rows, so a tile begins with the sums
//! of its first row, makes those of its other rows, and goes along all of them
//! at once: four rows of edges or attributes are a vector. Where a stamp is
//! drawn, each attribute becomes a vector of its own.

use fillrate_simd::{IntLanes, Kernel, MaskLanes, Simd, SingleLanes};

use super::coverage::rect_mask;
use crate::kernel::block::STAMP;
use crate::kernel::lanes::places;
use crate::kernel::raw::{Pixels, Place, RawPainter, StampValues, floor};
use crate::setup::{ATTRIBUTES, RawShape, Steps, Values, Walk, side_range};
use crate::state::{RawDraw, Rect};
use crate::stats::Counters;
use crate::target::{Plane, TileCell, stamp_index};

/// Stamps along the side of the largest tile.
const STAMPS: usize = 32;
/// Numbers of four edges in four rows.
const EDGES: usize = 16;
/// Numbers of all slots in four rows.
const SLOTS: usize = 64;
/// Bit `4 * i` for each bit `i`.
const SPREAD: [u16; 16] = spread();
/// Adding it leaves every number as it is.
const NOTHING: f32 = -0.0;

const fn spread() -> [u16; 16] {
    let mut table = [0; 16];
    let mut i = 0;
    while i < 16 {
        table[i] = (i & 1 | (i & 2) << 3 | (i & 4) << 6 | (i & 8) << 9) as u16;
        i += 1;
    }
    table
}

/// What a worker draws shapes in.
pub(crate) struct RawScratch {
    /// Edges at the first column of each row of stamps, four rows each.
    edges: [[f32; EDGES]; STAMPS],
    /// The same of slots.
    slots: [[f32; SLOTS]; STAMPS],
    /// Covered pixels of each stamp.
    masks: [[u16; STAMPS]; STAMPS],
    /// The slots at the first column of a stamp, a row's four times.
    current: [[f32; STAMP]; ATTRIBUTES],
    values: StampValues,
    depths: [i32; STAMP],
}

impl RawScratch {
    pub fn new() -> RawScratch {
        RawScratch {
            edges: [[0.0; EDGES]; STAMPS],
            slots: [[0.0; SLOTS]; STAMPS],
            masks: [[0; STAMPS]; STAMPS],
            current: [[0.0; STAMP]; ATTRIBUTES],
            values: [[0.0; STAMP]; ATTRIBUTES + 1],
            depths: [0; STAMP],
        }
    }
}

/// A tile of the target, and what is counted.
pub(crate) struct RawTile<'a> {
    /// Its pixels, those beyond the target's edge included.
    pub rect: Rect,
    /// log2 of its side.
    pub bits: u32,
    pub color: &'a mut TileCell,
    pub depth: Option<&'a mut TileCell>,
    pub counters: &'a mut Counters,
}

/// Draws a shape in a tile. `rows` is the list that the shape's walk is in.
#[inline(always)]
pub(crate) fn draw_raw<S: Simd>(
    s: S,
    draw: &RawDraw,
    shape: &RawShape,
    rows: &[f32],
    tile: RawTile<'_>,
    scratch: &mut RawScratch,
) {
    let area = shape.bounds.intersect(&tile.rect);
    if area.is_empty() {
        return;
    }
    s.vectorize(Shape { draw, shape, rows, area, tile, scratch });
}

struct Shape<'a, 't> {
    draw: &'a RawDraw,
    shape: &'a RawShape,
    rows: &'a [f32],
    area: Rect,
    tile: RawTile<'t>,
    scratch: &'a mut RawScratch,
}

impl Kernel for Shape<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self, s: S) {
        let Shape { draw, shape, rows, area, tile, scratch } = self;
        match &shape.values {
            Values::Walk(walk) => {
                let painter = RawPainter::new(draw, shape, Some(walk));
                let mut run = WalkRun { painter, walk, area, rect: tile.rect, scratch };
                let numbers = run.numbers(shape, rows, tile.bits);
                if run.cover(s, shape, numbers) {
                    run.place_slots(s, shape, numbers);
                    let mut target = Target::new(tile);
                    run.draw(s, &mut target);
                }
            }
            Values::Mix { steps, ends } => {
                let painter = RawPainter::new(draw, shape, None);
                let mix = MixRun { painter, steps: steps.as_ref(), ends, area };
                mix.draw(s, &mut Target::new(tile), scratch);
            }
        }
    }
}

/// A tile's planes while a shape is drawn.
struct Target<'a> {
    rect: Rect,
    bits: u32,
    pixels: Pixels<'a>,
    counters: &'a mut Counters,
}

impl<'a> Target<'a> {
    fn new(tile: RawTile<'a>) -> Self {
        fn words(cell: &mut TileCell) -> &mut [i32] {
            cell.materialize();
            match &mut cell.plane {
                Plane::Bits32(words) => words,
                Plane::Bits16(_) => &mut [],
            }
        }
        let pixels = Pixels { color: words(tile.color), depth: tile.depth.map_or(&mut [], words) };
        Target { rect: tile.rect, bits: tile.bits, pixels, counters: tile.counters }
    }

    fn place(&self, x: u32, y: u32) -> Place {
        Place { at: stamp_index(x - self.rect.x0, y - self.rect.y0, self.bits), x, y }
    }

    /// The fragments of `mask` that pass the depth test.
    #[inline(always)]
    fn test<S: Simd>(
        &mut self,
        s: S,
        painter: &RawPainter<'_>,
        place: Place,
        mask: u32,
        scratch: &mut RawScratch,
    ) -> u32 {
        let RawScratch { values, depths, .. } = scratch;
        let live = painter.test(s, place, mask, values, &self.pixels, depths);
        self.counters.pixels_in += u64::from(mask.count_ones());
        self.counters.depth_fail += u64::from((mask & !live).count_ones());
        live
    }
}

/// A triangle in a tile.
struct WalkRun<'a> {
    painter: RawPainter<'a>,
    walk: &'a Walk,
    area: Rect,
    rect: Rect,
    scratch: &'a mut RawScratch,
}

impl WalkRun<'_> {
    /// The numbers at the first column of the area's first row.
    fn numbers<'r>(&self, shape: &RawShape, rows: &'r [f32], bits: u32) -> &'r [f32] {
        let count = 3 + self.painter.slots().count;
        let above = (self.area.y0 >> bits) - (shape.bounds.y0 >> bits);
        let first = self.walk.rows as usize + above as usize * count;
        &rows[first..first + count]
    }

    /// Rows of stamps that the area touches, counted from the tile's top.
    fn stamp_rows(&self) -> core::ops::Range<usize> {
        let row = |y: u32| (y - self.rect.y0) as usize / 4;
        row(self.area.y0)..row(self.area.y1 - 1) + 1
    }

    /// Columns from the shape's first to the area's.
    fn skipped(&self, shape: &RawShape) -> u32 {
        self.area.x0 - shape.bounds.x0
    }

    /// Finds the covered pixels; false where there are none.
    #[inline(always)]
    fn cover<S: Simd>(&mut self, s: S, shape: &RawShape, numbers: &[f32]) -> bool {
        let (columns, rows) = (self.skipped(shape), self.stamp_rows());
        let (mut value, mut limit, mut step) = ([0.0; 3], [1.0; EDGES], [0.0; EDGES]);
        value.copy_from_slice(&numbers[..3]);
        for i in 0..3 {
            limit[i * 4..i * 4 + 4].fill(self.walk.limit[i]);
            step[i * 4..i * 4 + 4].fill(self.walk.edge_dx[i]);
        }
        for y in self.area.y0..self.area.y1 {
            let to = &mut self.scratch.edges[(y - self.rect.y0) as usize / 4];
            for i in 0..3 {
                to[i * 4 + (y & 3) as usize] = value[i];
                value[i] += self.walk.edge_dy[i];
            }
        }
        advance(s, &mut self.scratch.edges[rows.clone()], &step, EDGES, columns);
        let mut any = 0;
        for row in rows {
            any |= self.cover_row(s, row, &limit, &step);
        }
        any != 0
    }

    /// Finds the covered pixels of a row of stamps; not 0 where there are some.
    #[inline(always)]
    fn cover_row<S: Simd>(
        &mut self,
        s: S,
        row: usize,
        limit: &[f32; EDGES],
        step: &[f32; EDGES],
    ) -> u16 {
        let Rect { x0, y0, x1, y1 } = self.area;
        let top = self.rect.y0 + 4 * row as u32;
        let inside = (0..4).filter(|r| (y0..y1).contains(&(top + r)));
        let inside = inside.fold(0, |bits, r| bits | 1 << r);
        let masks = &mut self.scratch.masks[row];
        *masks = [0; STAMPS];
        let numbers = &self.scratch.edges[row];
        // Four edges are 4, 2 or 1 vectors; the fourth is none.
        let vectors = (EDGES / S::LANES).min(3);
        let mut lanes = [s.splat_g(0.0); 3];
        let (mut limits, mut steps) = (lanes, lanes);
        for i in 0..vectors {
            lanes[i] = s.load_g(&numbers[i * S::LANES..]);
            limits[i] = s.load_g(&limit[i * S::LANES..]);
            steps[i] = s.load_g(&step[i * S::LANES..]);
        }
        let mut any = 0;
        for x in x0 - self.rect.x0..x1 - self.rect.x0 {
            let mut bits = 0;
            for i in 0..vectors {
                bits |= lanes[i].lt(limits[i]).bits() << (i * S::LANES);
                lanes[i] = lanes[i] + steps[i];
            }
            let column = bits & bits >> 4 & bits >> 8 & inside;
            let mask = SPREAD[column as usize & 15] << (x & 3);
            masks[(x / 4) as usize & (STAMPS - 1)] |= mask;
            any |= mask;
        }
        any
    }

    /// Makes the slots at the area's first column.
    #[inline(always)]
    fn place_slots<S: Simd>(&mut self, s: S, shape: &RawShape, numbers: &[f32]) {
        let count = self.painter.slots().count;
        let (columns, rows) = (self.skipped(shape), self.stamp_rows());
        let mut value = [0.0; ATTRIBUTES];
        value[..count].copy_from_slice(&numbers[3..3 + count]);
        for y in self.area.y0..self.area.y1 {
            let to = &mut self.scratch.slots[(y - self.rect.y0) as usize / 4];
            for i in 0..count {
                to[i * 4 + (y & 3) as usize] = value[i];
            }
            for (value, step) in value.iter_mut().zip(&self.walk.dy) {
                *value += step;
            }
        }
        let steps = self.slot_steps();
        advance(s, &mut self.scratch.slots[rows], &steps, 4 * count, columns);
    }

    /// The slots' steps from column to column, four times each.
    fn slot_steps(&self) -> [f32; SLOTS] {
        let mut steps = [0.0; SLOTS];
        for (to, step) in steps.as_chunks_mut::<4>().0.iter_mut().zip(&self.walk.dx) {
            *to = [*step; 4];
        }
        steps
    }

    #[inline(always)]
    fn draw<S: Simd>(&mut self, s: S, target: &mut Target<'_>) {
        let steps = self.slot_steps();
        for row in self.stamp_rows() {
            let masks = self.scratch.masks[row];
            let first = masks.iter().position(|&mask| mask != 0);
            let (Some(first), Some(last)) = (first, masks.iter().rposition(|&mask| mask != 0))
            else {
                continue;
            };
            let y = self.rect.y0 + 4 * row as u32;
            let mut lead = self.enter_row(s, row, first, &steps);
            for (i, &mask) in masks.iter().enumerate().take(last + 1).skip(first) {
                let place = target.place(self.rect.x0 + 4 * i as u32, y);
                let live = match mask {
                    0 => 0,
                    _ => target.test(s, &self.painter, place, mask.into(), self.scratch),
                };
                if live == 0 {
                    self.step::<S, false>(s, lead);
                } else {
                    self.step::<S, true>(s, lead);
                    let values = (&self.scratch.values, &self.scratch.depths);
                    let Target { pixels, counters, .. } = target;
                    self.painter.draw(s, place, live, values, pixels, counters);
                }
                lead = 0;
            }
        }
    }

    /// Makes the slots at the first column of a stamp of a row, or at the
    /// area's first column if that lies in the stamp. Returns how many columns
    /// of the stamp are left of that.
    #[inline(always)]
    fn enter_row<S: Simd>(&mut self, s: S, row: usize, first: usize, steps: &[f32; SLOTS]) -> u32 {
        let count = self.painter.slots().count;
        let (x, from) = (4 * first as u32, self.area.x0 - self.rect.x0);
        let slots = &mut self.scratch.slots[row];
        let columns = x.saturating_sub(from);
        advance(s, core::slice::from_mut(slots), steps, 4 * count, columns);
        for (to, rows) in self.scratch.current.iter_mut().zip(slots.as_chunks::<4>().0).take(count)
        {
            for (to, value) in to.as_chunks_mut::<4>().0.iter_mut().zip(rows) {
                *to = [*value; 4];
            }
        }
        from.saturating_sub(x)
    }

    /// Goes from the first column of a stamp to that of the next; keeps the
    /// values in between where `KEEP` says so. The first `lead` columns are not
    /// gone.
    #[inline(always)]
    fn step<S: Simd, const KEEP: bool>(&mut self, s: S, lead: u32) {
        let (column1, column2, column3) = (s.mask(0x2222), s.mask(0x4444), s.mask(0x8888));
        let RawScratch { current, values, .. } = &mut *self.scratch;
        for i in 0..self.painter.slots().count {
            let dx = self.walk.dx[i];
            let by1 = s.splat_g(if lead < 1 { dx } else { NOTHING });
            let by2 = s.splat_g(if lead < 2 { dx } else { NOTHING });
            let by3 = s.splat_g(if lead < 3 { dx } else { NOTHING });
            let by4 = s.splat_g(dx);
            for j in (0..STAMP).step_by(S::LANES) {
                let at0 = s.load_g(&current[i][j..]);
                let at1 = at0 + by1;
                let at2 = at1 + by2;
                let at3 = at2 + by3;
                s.store_g(at3 + by4, &mut current[i][j..]);
                if KEEP {
                    let kept = at1.select(at0, column1);
                    let kept = at3.select(at2.select(kept, column2), column3);
                    s.store_g(kept, &mut values[i][j..]);
                }
            }
        }
    }
}

/// Goes `columns` columns along rows of stamps: adds the steps so often, each
/// sum rounded. Of each row the first `used` numbers count.
#[inline(always)]
fn advance<S: Simd, const N: usize>(
    s: S,
    rows: &mut [[f32; N]],
    steps: &[f32; N],
    used: usize,
    columns: u32,
) {
    if columns == 0 {
        return;
    }
    for at in (0..used).step_by(S::LANES) {
        let step = s.load_g(&steps[at..]);
        // Sums of four rows are under way at a time.
        let (fours, rest) = rows.as_chunks_mut::<4>();
        for four in fours {
            let mut lanes0 = s.load_g(&four[0][at..]);
            let mut lanes1 = s.load_g(&four[1][at..]);
            let mut lanes2 = s.load_g(&four[2][at..]);
            let mut lanes3 = s.load_g(&four[3][at..]);
            for _ in 0..columns {
                lanes0 = lanes0 + step;
                lanes1 = lanes1 + step;
                lanes2 = lanes2 + step;
                lanes3 = lanes3 + step;
            }
            s.store_g(lanes0, &mut four[0][at..]);
            s.store_g(lanes1, &mut four[1][at..]);
            s.store_g(lanes2, &mut four[2][at..]);
            s.store_g(lanes3, &mut four[3][at..]);
        }
        for row in rest {
            let mut lanes = s.load_g(&row[at..]);
            for _ in 0..columns {
                lanes = lanes + step;
            }
            s.store_g(lanes, &mut row[at..]);
        }
    }
}

/// A line or a point in a tile.
struct MixRun<'a> {
    painter: RawPainter<'a>,
    /// None of a point.
    steps: Option<&'a Steps>,
    ends: &'a [[f32; ATTRIBUTES + 1]; 2],
    area: Rect,
}

impl MixRun<'_> {
    #[inline(always)]
    fn draw<S: Simd>(&self, s: S, target: &mut Target<'_>, scratch: &mut RawScratch) {
        let area = &self.area;
        let along_x = self.steps.is_none_or(|steps| steps.along_x);
        let (columns, rows) = ([area.x0, area.x1], [area.y0, area.y1]);
        let (main, side) = if along_x { (columns, rows) } else { (rows, columns) };
        for at in (main[0] & !3..main[1]).step_by(4) {
            let part = [at.max(main[0]), (at + 4).min(main[1])];
            let reached = match self.steps {
                Some(steps) => side_range(steps, part, side[1]),
                None => Some(side),
            };
            let Some([low, high]) = reached else { continue };
            for other in (low.max(side[0]) & !3..high).step_by(4) {
                let (x, y) = if along_x { (at, other) } else { (other, at) };
                let mask = self.stamp(s, x, y, scratch);
                let place = target.place(x, y);
                let live = match mask {
                    0 => 0,
                    _ => target.test(s, &self.painter, place, mask, scratch),
                };
                if live != 0 {
                    let values = (&scratch.values, &scratch.depths);
                    let Target { pixels, counters, .. } = target;
                    self.painter.draw(s, place, live, values, pixels, counters);
                }
            }
        }
    }

    /// Makes the values of the stamp at (x, y); returns the covered pixels.
    #[inline(always)]
    fn stamp<S: Simd>(&self, s: S, x: u32, y: u32, scratch: &mut RawScratch) -> u32 {
        let mut mask = 0;
        for j in (0..STAMP).step_by(S::LANES) {
            let mut t = s.splat_g(0.0);
            let mut covered = u32::MAX;
            if let Some(steps) = self.steps {
                let [columns, rows] = places(s, x as i32, y as i32, j);
                let (main, side) = if steps.along_x { (columns, rows) } else { (rows, columns) };
                let along = S::G::from_i32(main) + s.splat_g(0.5) - s.splat_g(steps.start);
                t = along / s.splat_g(steps.length);
                let there = s.splat_g(steps.side[0]) + t * s.splat_g(steps.side[1]);
                covered = floor(s, there).to_i32().eq(side).bits();
            }
            mask |= covered << j;
            self.mix(s, t, scratch, j);
        }
        mask & rect_mask(&self.area, x, y)
    }

    /// Makes values of fragments `j..` of a stamp, which are `t` along the way
    /// from one end to the other.
    #[inline(always)]
    fn mix<S: Simd>(&self, s: S, t: S::G, scratch: &mut RawScratch, j: usize) {
        let count = self.painter.slots().count;
        for i in (0..count).chain([ATTRIBUTES]) {
            let (from, rise) = (self.ends[0][i], self.ends[1][i] - self.ends[0][i]);
            let value = s.splat_g(from) + t * s.splat_g(rise);
            s.store_g(value, &mut scratch.values[i][j..]);
        }
    }
}
