//! Drawing a tile: its entries in order, gathered into blocks.

use std::sync::Arc;

use fillrate_simd::Simd;

use super::coverage::{FULL, TileCoverage, clip_strip, rect_mask};
use super::depth_range::{depth_range, hides_nothing, is_hidden, update_bounds};
use super::palette::{PaletteTile, draw_shape};
use super::queue::Queue;
use super::raw::{RawScratch, RawTile, draw_raw};
use super::small::{Small, is_small};
use crate::bins::{Chunk, Entry, Grid};
use crate::device::arena::{Arena, BatchState, Clear, Pixel, Run};
use crate::kernel::block::{Block, SLOTS, STAMP, Slot, Strip};
use crate::kernel::depth::{DepthTest, early, test_strip};
use crate::kernel::{
    self as stages, ColorTile, Pass, Pipeline, StageList, StripFn, Tile, one_stamp, run,
    stage_list, strip_function,
};
use crate::setup::{Shape, Triangle, Triangles};
use crate::state::{Dither, Rect};
use crate::stats::Counters;
use crate::target::{PixelFormat, Plane, TileCell, pack, stamp_index};

/// How many entries ahead triangles are fetched, and then their planes: a tile's
/// lie far apart, and half of them in another core's cache.
const AHEAD: usize = 8;
const PLANES_AHEAD: usize = 3;

/// What one worker keeps while it draws tiles.
pub(crate) struct TilePainter<'a, S: Simd> {
    s: S,
    arena: &'a Arena,
    states: &'a [Arc<BatchState>],
    grid: Grid,
    format: PixelFormat,
    pub counters: Counters,
    block: Block,
    queue: Queue,
    coverage: TileCoverage,
    list: StageList<S>,
    /// Draws strips without queueing their stamps, where the state allows it.
    strip: Option<StripFn<S>>,
    /// The state that `list` and `strip` belong to.
    current: Option<Current<'a>>,
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

/// A triangle in a tile.
#[derive(Clone, Copy)]
struct Job<'a> {
    current: Current<'a>,
    triangles: &'a Triangles,
    triangle: &'a Triangle,
    index: u32,
    /// Its part of the tile.
    area: Rect,
    /// Whether it goes by [`Small`].
    small: bool,
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

    /// Tells the processor that a triangle's first stamp is needed soon: the tile's
    /// pixels have been in this core's cache for the batch before, if at all.
    #[inline(always)]
    fn prefetch(&self, triangles: &Triangles, index: u32, bits: u32) {
        let Some(triangle) = triangles.list.get(index as usize) else { return };
        let x = triangle.bounds.x0.max(self.rect.x0) - self.rect.x0;
        let y = triangle.bounds.y0.max(self.rect.y0) - self.rect.y0;
        let at = stamp_index(x & !3, y & !3, bits);
        self.color.prefetch(at);
        if let Some(aux) = &self.aux {
            aux.prefetch(at);
        }
    }

    /// The aux elements; none where there is no aux surface. They must be
    /// materialized.
    fn aux(&mut self) -> &mut [u16] {
        match self.aux.as_mut().map(|aux| &mut aux.plane) {
            Some(Plane::Bits16(pixels)) => pixels,
            _ => &mut [],
        }
    }

    /// The planes as the stages see them. They must be materialized.
    fn tile<'t>(&'t mut self, format: PixelFormat, counters: &'t mut Counters) -> Tile<'t> {
        let color = match &mut self.color.plane {
            Plane::Bits16(pixels) => ColorTile::Bits16(pixels, format),
            Plane::Bits32(pixels) => ColorTile::Bits32(pixels, format),
        };
        let (aux, aux32) = match self.aux.as_mut().map(|aux| &mut aux.plane) {
            Some(Plane::Bits16(pixels)) => (pixels.as_mut_slice(), &mut [][..]),
            Some(Plane::Bits32(pixels)) => (&mut [][..], pixels.as_mut_slice()),
            None => (&mut [][..], &mut [][..]),
        };
        Tile { color, aux, aux32, counters }
    }
}

impl<'a, S: Simd> TilePainter<'a, S> {
    pub fn new(
        s: S,
        arena: &'a Arena,
        states: &'a [Arc<BatchState>],
        grid: Grid,
        format: PixelFormat,
    ) -> Self {
        TilePainter {
            s,
            arena,
            states,
            grid,
            format,
            counters: Counters::default(),
            block: Block::new(),
            queue: Queue::new(),
            coverage: TileCoverage::NONE,
            list: StageList::new(),
            strip: None,
            current: None,
            raw: RawScratch::new(),
        }
    }

    /// Draws everything the chunks hold for a tile.
    #[inline(always)]
    pub fn draw(
        &mut self,
        chunks: impl Iterator<Item = &'a Chunk>,
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
                if let Some(Entry::Triangle(next)) = entries.get(i + PLANES_AHEAD) {
                    chunk.triangles.prefetch_planes(*next);
                    target.prefetch(&chunk.triangles, *next, self.grid.bits);
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
        &self.states[state as usize]
    }

    /// Makes `pipeline` and `list` those of a state; what is pending must be
    /// finished.
    fn select(&mut self, state: u32, pixels: bool) {
        let batch = self.batch(state);
        let pipeline = match (batch.pixel_pipeline.get(), pixels) {
            (Some(pipeline), true) => pipeline,
            _ => &batch.pipeline,
        };
        stage_list(&pipeline.stages, &mut self.list);
        self.strip = strip_function(&pipeline.stages);
        self.block.forget_steps();
        self.current = Some(Current { state, pixels, pipeline, clip: &batch.clip });
    }

    /// Draws the stamps that wait.
    #[inline(always)]
    fn finish(&mut self, triangles: &Triangles, target: &mut Target<'_>) {
        if self.queue.len() > 0 {
            self.drain(0, 1, triangles, target);
        }
    }

    /// Draws the first `foreign` stamps that wait, then the others while there
    /// are at least `least` of them.
    #[inline(always)]
    fn drain(
        &mut self,
        foreign: usize,
        least: usize,
        triangles: &Triangles,
        target: &mut Target<'_>,
    ) {
        let Some(current) = &self.current else { return };
        let pass = Pass { pipeline: current.pipeline, triangles };
        let mut tile = target.tile(self.format, &mut self.counters);
        let (mut first, len) = (0, self.queue.len());
        while first < foreign || len - first >= least {
            let end = if first < foreign { foreign } else { len };
            let count = (end - first).min(SLOTS);
            self.queue.fill(first, count, &mut self.block);
            run(self.s, &self.list, &mut self.block, &pass, &mut tile);
            first += count;
        }
        self.queue.keep_from(first);
    }

    /// Draws what can be drawn of the stamps that wait, the first `foreign` of
    /// which are of other triangles than the others.
    #[inline(always)]
    fn gathered(
        &mut self,
        pipeline: &Pipeline,
        foreign: usize,
        triangles: &Triangles,
        target: &mut Target<'_>,
    ) {
        let foreign = if pipeline.in_order && self.queue.repeats(foreign) { foreign } else { 0 };
        if foreign > 0 || self.queue.len() >= SLOTS {
            self.drain(foreign, SLOTS, triangles, target);
        }
    }

    #[inline(always)]
    fn triangle(&mut self, chunk: &'a Chunk, index: u32, target: &mut Target<'_>) {
        let triangles = &chunk.triangles;
        let triangle = &triangles.list[index];
        let area = triangle.bounds.intersect(&target.rect);
        if area.is_empty() {
            return;
        }
        let current = match self.current {
            Some(current) if current.state == triangle.state && !current.pixels => current,
            _ => {
                self.finish(triangles, target);
                self.select(triangle.state, false);
                let Some(current) = self.current else { return };
                current
            }
        };
        let small = triangle.compact && is_small::<S>(&area) && current.clip.contains(&area);
        if !small && !self.coverage.enter(self.s, triangle, &target.rect) {
            return;
        }
        let job = Job { current, triangles, triangle, index, area, small };
        if self.is_hidden(&job, target) {
            return if small { self.count_small(&job, target) } else { self.count_hidden(&job) };
        }
        if !small && self.replaces_tile(&job, target) {
            return;
        }
        target.materialize();
        match current.pipeline.early {
            early::NONE => self.stamps::<{ early::NONE }>(&job, target),
            early::LESS => self.stamps::<{ early::LESS }>(&job, target),
            early::LESS_EQUAL => self.stamps::<{ early::LESS_EQUAL }>(&job, target),
            _ => self.stamps::<{ early::ANY }>(&job, target),
        }
    }

    /// Draws a triangle's stamps; `EARLY` is one of [`early`].
    #[inline(always)]
    fn stamps<const EARLY: u8>(&mut self, job: &Job<'a>, target: &mut Target<'_>) {
        if job.small {
            self.small::<EARLY>(job, target);
        } else {
            self.large::<EARLY>(job, target);
        }
    }

    /// The small triangle of a job.
    fn as_small<'j>(&self, job: &'j Job<'a>, target: &Target<'_>) -> Small<'j> {
        let (x, y) = (job.area.x0 - target.rect.x0, job.area.y0 - target.rect.y0);
        let at = stamp_index(x & !3, y & !3, self.grid.bits) as u32;
        let pitch = 4 << self.grid.bits;
        Small { triangle: job.triangle, index: job.index, area: &job.area, at, pitch }
    }

    #[inline(always)]
    fn small<const EARLY: u8>(&mut self, job: &Job<'a>, target: &mut Target<'_>) {
        let small = self.as_small(job, target);
        let pipeline = job.current.pipeline;
        let test = DepthTest::new(pipeline);
        let waiting = self.queue.len();
        let aux = target.aux();
        small.gather::<S, EARLY>(self.s, &test, aux, &mut self.queue, &mut self.counters);
        self.gathered(pipeline, waiting, job.triangles, target);
    }

    #[inline(always)]
    fn large<const EARLY: u8>(&mut self, job: &Job<'a>, target: &mut Target<'_>) {
        let (s, Current { pipeline, clip, .. }) = (self.s, job.current);
        let clip = (!clip.contains(&job.area)).then_some(clip);
        let test = DepthTest::new(pipeline);
        if self.strip.is_some() {
            self.finish(job.triangles, target);
        }
        for y in self.coverage.rows() {
            for first in self.coverage.groups() {
                let mut strip = self.coverage.strip(s, first, y);
                if strip.count == 0 {
                    continue;
                }
                let (dx, dy) = (strip.first.x as u32 - target.rect.x0, y - target.rect.y0);
                strip.first.at = stamp_index(dx, dy, self.grid.bits) as u32;
                strip.first.triangle = job.index;
                let mut left = strip.len();
                self.counters.pixels_in += left;
                if let Some(clip) = clip {
                    clip_strip(&mut strip, clip);
                    left = strip.len();
                }
                if EARLY != early::NONE {
                    self.counters.depth_fail += left;
                    let narrow = &job.triangle.narrow;
                    test_strip::<S, EARLY>(s, &test, narrow, &mut strip, target.aux());
                    left = strip.len();
                    self.counters.depth_fail -= left;
                }
                if left > 0 {
                    self.strip(job, &strip, target);
                }
            }
        }
    }

    /// Draws a strip, or queues its stamps.
    #[inline(always)]
    fn strip(&mut self, job: &Job<'a>, strip: &Strip, target: &mut Target<'_>) {
        if let Some(draw) = self.strip {
            let pass = Pass { pipeline: job.current.pipeline, triangles: job.triangles };
            let mut tile = target.tile(self.format, &mut self.counters);
            return draw(self.s, strip, &pass, &mut tile);
        }
        let waiting = self.queue.len();
        let mut slot = strip.first;
        for &live in &strip.live[..strip.count] {
            self.queue.push(slot, live);
            slot.at += STAMP as u32;
            slot.x += 4;
        }
        self.gathered(job.current.pipeline, waiting, job.triangles, target);
    }

    /// Draws a triangle of one colour over the whole tile as a pending clear,
    /// if that is what it is.
    #[inline(always)]
    fn replaces_tile(&mut self, job: &Job<'a>, target: &mut Target<'_>) -> bool {
        let pipeline = job.current.pipeline;
        let visible = target.rect.intersect(&self.grid.bounds);
        let area = &self.coverage.area;
        let whole = self.coverage.is_full()
            && area.contains(&visible)
            && job.current.clip.contains(&visible)
            && pipeline.replaces_tile();
        if !whole {
            return false;
        }
        let pass = Pass { pipeline, triangles: job.triangles };
        let (x, y) = (area.x0 as i32, area.y0 as i32);
        let at = Slot { triangle: job.index, at: 0, x, y };
        let Some(stamp) = one_stamp(self.s, &pass, &at) else { return false };
        self.finish(job.triangles, target);
        self.counters.pixels_in += visible.area();
        self.counters.pixels_out += visible.area();
        target.color.clear(stamp.map(i32::from));
        true
    }

    /// Whether depth bounds hide a triangle. Otherwise the bounds are updated for
    /// drawing it.
    #[inline(always)]
    fn is_hidden(&mut self, job: &Job<'a>, target: &mut Target<'_>) -> bool {
        let Current { pipeline, clip, .. } = job.current;
        let Some(aux) = &mut target.aux else { return false };
        if !pipeline.needs.depth && !pipeline.writes_aux() || !aux.has_bounds() {
            return false;
        }
        if job.small && hides_nothing(pipeline, aux) {
            // Its range is not worth working out.
            if pipeline.writes_aux() {
                aux.include(0, 0xffff);
            }
            return false;
        }
        let range = depth_range(pipeline, job.triangles, job.triangle, &job.area);
        if let Some(range) = range
            && !pipeline.drops_by_place()
            && is_hidden(pipeline, range, aux)
        {
            return true;
        }
        let visible = target.rect.intersect(&self.grid.bounds);
        let whole = !job.small
            && self.coverage.is_full()
            && job.area.contains(&visible)
            && clip.contains(&visible)
            && !pipeline.drops_by_place()
            && !pipeline.needs.late_depth_write;
        update_bounds(pipeline, range, whole, aux);
        false
    }

    /// Counts the fragments of a small hidden triangle.
    fn count_small(&mut self, job: &Job<'a>, target: &Target<'_>) {
        let small = self.as_small(job, target);
        let (waiting, before) = (self.queue.len(), self.counters.pixels_in);
        let (queue, counters) = (&mut self.queue, &mut self.counters);
        small.gather::<S, { early::NONE }>(self.s, &DepthTest::NONE, &mut [], queue, counters);
        self.queue.truncate(waiting);
        self.counters.depth_fail += self.counters.pixels_in - before;
    }

    /// Counts the fragments of a hidden triangle.
    #[inline(always)]
    fn count_hidden(&mut self, job: &Job<'a>) {
        let (coverage, clip) = (&self.coverage, job.current.clip);
        if coverage.is_full() {
            self.counters.pixels_in += job.area.area();
            self.counters.depth_fail += job.area.intersect(clip).area();
            return;
        }
        for y in coverage.rows() {
            for first in coverage.groups() {
                let mut strip = coverage.strip(self.s, first, y);
                self.counters.pixels_in += strip.len();
                clip_strip(&mut strip, clip);
                self.counters.depth_fail += strip.len();
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
            fill(aux, [value as i32; STAMP], whole, &area, &target.rect, self.grid.bits);
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
        let Some(current) = &self.current else { return };
        let pass = Pass { pipeline: current.pipeline, triangles: &Triangles::default() };
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
                (self.block.slots[0], self.block.count) = (slot, 1);
                self.block.live = u64::from(mask);
                let mut tile = target.tile(self.format, &mut self.counters);
                stages::run(self.s, &self.list, &mut self.block, &pass, &mut tile);
            }
        }
    }
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
