//! Drawing a tile: its entries in order, gathered into blocks.

use fillrate_simd::Simd;

use super::coverage::{FULL, TileCoverage, compact_stamp, is_small, rect_mask};
use super::depth_range::{depth_range, is_hidden, update_bounds};
use super::palette::{PaletteTile, draw_shape};
use super::raw::{RawScratch, RawTile, draw_raw};
use crate::bins::{Chunk, Entry, Grid};
use crate::device::arena::{Arena, BatchState, Clear, Pixel, Run};
use crate::kernel::block::{Block, SLOTS, STAMP, Slot};
use crate::kernel::{ColorTile, Pass, Pipeline, StageList, Tile, run, stage_list};
use crate::setup::{Shape, Triangle, Triangles};
use crate::state::{Dither, Rect};
use crate::stats::Counters;
use crate::target::{PixelFormat, Plane, TileCell, pack, stamp_index};

/// How many entries ahead triangles are fetched: a tile's lie far apart.
const AHEAD: usize = 4;

/// What one worker keeps while it draws tiles.
pub(crate) struct TilePainter<'a, S: Simd> {
    s: S,
    arena: &'a Arena,
    grid: Grid,
    format: PixelFormat,
    pub counters: Counters,
    block: Block,
    coverage: TileCoverage,
    list: StageList<S>,
    /// The state that `list` belongs to.
    current: Option<Current<'a>>,
    /// Slots of the block that other triangles than the current one hold.
    foreign: usize,
    raw: RawScratch,
}

/// A draw state in use.
#[derive(Clone, Copy)]
struct Current<'a> {
    state: u32,
    /// Its stages for ready-made fragments.
    pixels: bool,
    pipeline: &'a Pipeline,
    clip: &'a Rect,
}

/// One tile of the target while it is drawn.
struct Target<'a> {
    /// Its pixels, those beyond the target's edge included.
    rect: Rect,
    color: &'a mut TileCell,
    aux: Option<&'a mut TileCell>,
}

impl Target<'_> {
    fn materialize(&mut self) {
        self.color.materialize();
        if let Some(aux) = &mut self.aux {
            aux.materialize();
        }
    }

    /// The planes as the stages see them. They must be materialized.
    fn tile<'t>(&'t mut self, format: PixelFormat, counters: &'t mut Counters) -> Tile<'t> {
        let color = match &mut self.color.plane {
            Plane::Bits16(pixels) => ColorTile::Bits16(pixels, format),
            Plane::Bits32(pixels) => ColorTile::Bits32(pixels, format),
        };
        let aux = match self.aux.as_mut().map(|aux| &mut aux.plane) {
            Some(Plane::Bits16(pixels)) => pixels.as_mut_slice(),
            _ => &mut [],
        };
        Tile { color, aux, counters }
    }
}

impl<'a, S: Simd> TilePainter<'a, S> {
    pub fn new(s: S, arena: &'a Arena, grid: Grid, format: PixelFormat) -> Self {
        TilePainter {
            s,
            arena,
            grid,
            format,
            counters: Counters::default(),
            block: Block::new(),
            coverage: TileCoverage::NONE,
            list: StageList::new(),
            current: None,
            foreign: 0,
            raw: RawScratch::new(),
        }
    }

    /// Draws everything the chunks hold for a tile.
    #[inline(always)]
    pub fn draw(
        &mut self,
        chunks: &[Chunk],
        index: usize,
        color: &mut TileCell,
        aux: Option<&mut TileCell>,
    ) {
        let rect = self.grid.tile(index);
        let mut target = Target { rect, color, aux };
        for chunk in chunks {
            self.block.forget_steps();
            let entries = chunk.tile(index);
            for (i, entry) in entries.iter().enumerate() {
                if let Some(Entry::Triangle(next)) = entries.get(i + AHEAD) {
                    chunk.triangles.prefetch(*next);
                }
                match *entry {
                    Entry::Triangle(i) => self.triangle(chunk, i, &mut target),
                    Entry::Shape(i) => {
                        self.finish(&chunk.triangles, &mut target);
                        self.shape(&chunk.shapes[i as usize], &mut target);
                    }
                    Entry::Raw(i) => {
                        self.finish(&chunk.triangles, &mut target);
                        self.raw(chunk, i, &mut target);
                    }
                    Entry::Clear(i) => {
                        self.finish(&chunk.triangles, &mut target);
                        self.clear(&self.arena.clears[i as usize], &mut target);
                    }
                    Entry::Pixels(i) => {
                        self.finish(&chunk.triangles, &mut target);
                        self.pixels(&self.arena.runs[i as usize], &mut target);
                    }
                }
            }
            self.finish(&chunk.triangles, &mut target);
        }
    }

    fn batch(&self, state: u32) -> &'a BatchState {
        &self.arena.states[state]
    }

    /// Makes `pipeline` and `list` those of a state; what is pending must be
    /// finished.
    fn select(&mut self, state: u32, pixels: bool) {
        let batch = self.batch(state);
        let pipeline = match (&batch.pixel_pipeline, pixels) {
            (Some(pipeline), true) => pipeline,
            _ => &batch.pipeline,
        };
        stage_list(&pipeline.stages, &mut self.list);
        self.block.forget_steps();
        self.current = Some(Current { state, pixels, pipeline, clip: &batch.clip });
    }

    /// Draws the fragments gathered so far.
    #[inline(always)]
    fn finish(&mut self, triangles: &Triangles, target: &mut Target<'_>) {
        let Some(current) = &self.current else { return };
        if self.block.count == 0 {
            return;
        }
        let pass = Pass { pipeline: current.pipeline, triangles };
        let mut tile = target.tile(self.format, &mut self.counters);
        run(self.s, &self.list, &mut self.block, &pass, &mut tile);
        self.foreign = 0;
    }

    /// Adds a stamp's fragments to the block, drawing first what is in the
    /// way: a full block, or other fragments of the same stamp.
    #[inline(always)]
    fn push(&mut self, slot: Slot, mask: u32, triangles: &Triangles, target: &mut Target<'_>) {
        let count = self.block.count;
        // A triangle has a stamp once, so only other triangles can hold it.
        let mut held = false;
        for other in &self.block.slots[..self.foreign.min(SLOTS)] {
            held |= other.at == slot.at;
        }
        if held || count == SLOTS {
            self.finish(triangles, target);
        }
        let block = &mut self.block;
        let count = block.count & (SLOTS - 1);
        block.slots[count] = slot;
        block.live |= u64::from(mask) << (count * STAMP);
        block.count = count + 1;
    }

    #[inline(always)]
    fn triangle(&mut self, chunk: &Chunk, index: u32, target: &mut Target<'_>) {
        let triangle = &chunk.triangles.list[index as usize];
        let s = self.s;
        let area = triangle.bounds.intersect(&target.rect);
        if area.is_empty() {
            return;
        }
        let small = triangle.compact && is_small(&area);
        if !small && !self.coverage.enter(s, triangle, &target.rect) {
            return;
        }
        let current = match self.current {
            Some(current) if current.state == triangle.state && !current.pixels => current,
            _ => {
                self.finish(&chunk.triangles, target);
                self.select(triangle.state, false);
                let Some(current) = self.current else { return };
                current
            }
        };
        let triangles = &chunk.triangles;
        let full = !small && self.coverage.is_full();
        if self.is_hidden(&current, triangles, triangle, (&area, full), target) {
            return match small {
                true => self.count_small(triangle, &area, current.clip),
                false => self.count_hidden(current.clip),
            };
        }
        let clip = (!current.clip.contains(&area)).then_some(current.clip);
        self.foreign = self.block.count;
        if small {
            target.materialize();
            for (x, y) in stamps(&area) {
                let mask = compact_stamp(s, triangle, &area, x, y);
                self.stamp(chunk, index, (x, y), mask, clip, target);
            }
            return;
        }
        if self.replaces_tile(&current, triangles, target) {
            return;
        }
        target.materialize();
        for y in self.coverage.rows() {
            for first in self.coverage.groups() {
                for (x, full) in self.coverage.group(s, first, y).stamps(first) {
                    let mask = if full { FULL } else { self.coverage.stamp(s, x, y) };
                    self.stamp(chunk, index, (x, y), mask, clip, target);
                }
            }
        }
    }

    /// Draws a triangle of one colour over the whole tile as a pending clear,
    /// if that is what it is.
    #[inline(always)]
    fn replaces_tile(
        &mut self,
        current: &Current<'_>,
        triangles: &Triangles,
        target: &mut Target<'_>,
    ) -> bool {
        let Some(stamp) = current.pipeline.flat else { return false };
        let visible = target.rect.intersect(&self.grid.bounds);
        let area = &self.coverage.area;
        let whole = self.coverage.is_full()
            && area.contains(&visible)
            && current.clip.contains(&visible)
            && current.pipeline.replaces_tile();
        if whole {
            self.finish(triangles, target);
            self.counters.pixels_in += visible.area();
            self.counters.pixels_out += visible.area();
            target.color.clear(stamp.map(i32::from));
        }
        whole
    }

    /// Counts and adds the covered fragments of the stamp at a screen position.
    #[inline(always)]
    fn stamp(
        &mut self,
        chunk: &Chunk,
        triangle: u32,
        (x, y): (u32, u32),
        mut mask: u32,
        clip: Option<&Rect>,
        target: &mut Target<'_>,
    ) {
        self.counters.pixels_in += u64::from(mask.count_ones());
        if let Some(clip) = clip {
            mask &= rect_mask(clip, x, y);
        }
        if mask == 0 {
            return;
        }
        let (dx, dy) = (x - target.rect.x0, y - target.rect.y0);
        let at = stamp_index(dx, dy, self.grid.bits) as u32;
        let slot = Slot { triangle, at, x: x as i32, y: y as i32 };
        self.push(slot, mask, &chunk.triangles, target);
    }

    /// Whether depth bounds hide the triangle, which covers all of `area` where
    /// it is `full`. Otherwise the bounds are updated for drawing it.
    #[inline(always)]
    fn is_hidden(
        &mut self,
        current: &Current<'_>,
        triangles: &Triangles,
        triangle: &Triangle,
        (area, full): (&Rect, bool),
        target: &mut Target<'_>,
    ) -> bool {
        let (pipeline, clip) = (current.pipeline, current.clip);
        let Some(aux) = &mut target.aux else { return false };
        if !pipeline.needs.depth && !pipeline.writes_aux() {
            return false;
        }
        let range = depth_range(pipeline, triangles, triangle, area);
        if let Some(range) = range
            && pipeline.state.stipple.is_none()
            && is_hidden(pipeline, range, aux)
        {
            return true;
        }
        let visible = target.rect.intersect(&self.grid.bounds);
        let whole = full
            && area.contains(&visible)
            && clip.contains(&visible)
            && pipeline.state.stipple.is_none()
            && !pipeline.needs.late_depth_write;
        update_bounds(pipeline, range, whole, aux);
        false
    }

    /// Counts the fragments of a small hidden triangle.
    #[inline(always)]
    fn count_small(&mut self, triangle: &Triangle, area: &Rect, clip: &Rect) {
        for (x, y) in stamps(area) {
            let mask = compact_stamp(self.s, triangle, area, x, y);
            let inside = mask & rect_mask(clip, x, y);
            self.counters.pixels_in += u64::from(mask.count_ones());
            self.counters.depth_fail += u64::from(inside.count_ones());
        }
    }

    /// Counts the fragments of a hidden triangle.
    #[inline(always)]
    fn count_hidden(&mut self, clip: &Rect) {
        let coverage = &self.coverage;
        let area = coverage.area;
        if coverage.is_full() {
            self.counters.pixels_in += area.area();
            self.counters.depth_fail += area.intersect(clip).area();
            return;
        }
        for y in coverage.rows() {
            for first in coverage.groups() {
                for (x, _) in coverage.group(self.s, first, y).stamps(first) {
                    let mask = coverage.stamp(self.s, x, y);
                    let inside = mask & rect_mask(clip, x, y);
                    self.counters.pixels_in += u64::from(mask.count_ones());
                    self.counters.depth_fail += u64::from(inside.count_ones());
                }
            }
        }
    }

    /// Draws a shape of the Quark profile.
    #[inline(always)]
    fn shape(&mut self, shape: &Shape, target: &mut Target<'_>) {
        let tile = PaletteTile {
            rect: target.rect,
            visible: target.rect.intersect(&self.grid.bounds),
            bits: self.grid.bits,
            color: &mut *target.color,
            depth: target.aux.as_deref_mut(),
            counters: &mut self.counters,
        };
        draw_shape(self.s, &self.arena.palettes[shape.state as usize], shape, tile);
    }

    /// Draws a shape of the Raw profile.
    #[inline(always)]
    fn raw(&mut self, chunk: &Chunk, index: u32, target: &mut Target<'_>) {
        let shape = &chunk.raws[index as usize];
        let tile = RawTile {
            rect: target.rect,
            bits: self.grid.bits,
            color: &mut *target.color,
            depth: target.aux.as_deref_mut(),
            counters: &mut self.counters,
        };
        let draw = &self.arena.raws[shape.state as usize];
        draw_raw(self.s, draw, shape, &chunk.raw_rows, tile, &mut self.raw);
    }

    /// Fills a part of the tile, or all of it later.
    fn clear(&mut self, clear: &Clear, target: &mut Target<'_>) {
        let visible = target.rect.intersect(&self.grid.bounds);
        let area = visible.intersect(&clear.rect);
        self.counters.pixels_out += area.area();
        let whole = area == visible;
        if let Some((argb, dither)) = clear.values.color {
            let stamp = color_stamp(self.format, argb, dither);
            fill(target.color, stamp, whole, &area, &target.rect, self.grid.bits);
        }
        if let (Some(value), Some(aux)) = (clear.values.aux, &mut target.aux) {
            fill(aux, [i32::from(value); STAMP], whole, &area, &target.rect, self.grid.bits);
        }
    }

    /// Draws the part of a run of ready-made fragments inside the tile.
    #[inline(always)]
    fn pixels(&mut self, run: &Run, target: &mut Target<'_>) {
        if !self.current.is_some_and(|now| now.state == run.state && now.pixels) {
            self.select(run.state, true);
        }
        target.materialize();
        let clip = &self.batch(run.state).clip;
        let from = run.x.max(target.rect.x0);
        let to = (run.x + run.count).min(target.rect.x1);
        self.counters.pixels_in += u64::from(to.saturating_sub(from));
        if let Some(aux) = &mut target.aux {
            aux.include(0, 0xffff);
        }
        let y = run.y & !3;
        let none = Triangles::default();
        for x in (from & !3..to).step_by(4) {
            let row = (run.y & 3) * 4;
            let mut mask = 0;
            for (i, column) in (x..x + 4).enumerate().filter(|(_, c)| (from..to).contains(c)) {
                let lane = row as usize + i;
                mask |= 1 << lane;
                let pixel = self.arena.pixels[(run.first + column - run.x) as usize];
                set_pixel(&mut self.block, lane, pixel);
            }
            let mask = mask & rect_mask(clip, x, y) & FULL;
            if mask != 0 {
                let at = stamp_index(x - target.rect.x0, y - target.rect.y0, self.grid.bits);
                let slot = Slot { triangle: 0, at: at as u32, x: x as i32, y: y as i32 };
                // One stamp a block: the fragments are already in its lanes.
                self.push(slot, mask, &none, target);
                self.finish(&none, target);
            }
        }
    }
}

/// Screen positions of the stamps that an area touches, row by row.
#[inline(always)]
fn stamps(area: &Rect) -> impl Iterator<Item = (u32, u32)> + use<> {
    let Rect { x0, y0, x1, y1 } = *area;
    let (x0, y0) = (x0 & !3, y0 & !3);
    (y0..y1).step_by(4).flat_map(move |y| (x0..x1).step_by(4).map(move |x| (x, y)))
}

/// Puts a ready-made fragment into a lane.
fn set_pixel(block: &mut Block, lane: usize, pixel: Pixel) {
    let c = pixel.argb;
    let rb = ((c >> 16 & 0xff) | (c & 0xff) << 16) as i32;
    let ga = ((c >> 8 & 0xff) | (c >> 24) << 16) as i32;
    for colors in [&mut block.color, &mut block.iterated] {
        colors.rb.0[lane] = rb;
        colors.ga.0[lane] = ga;
    }
    let depth = i32::from(pixel.depth);
    block.z.0[lane] = depth;
    block.w.0[lane] = depth;
    block.depth.0[lane] = depth;
}

/// A stamp of one colour, dithered.
fn color_stamp(format: PixelFormat, argb: u32, dither: Dither) -> [i32; STAMP] {
    core::array::from_fn(|i| pack(format, argb, dither, i as u32 % 4, i as u32 / 4) as i32)
}

/// Fills `area` of a tile at `tile` with a stamp, at once or as a pending
/// clear.
fn fill(
    cell: &mut TileCell,
    stamp: [i32; STAMP],
    whole: bool,
    area: &Rect,
    tile: &Rect,
    bits: u32,
) {
    if whole {
        return cell.clear(stamp);
    }
    for y in area.y0..area.y1 {
        for x in area.x0..area.x1 {
            let value = stamp[((y & 3) * 4 + (x & 3)) as usize];
            cell.set(stamp_index(x - tile.x0, y - tile.y0, bits), value as u32);
        }
    }
}
