//! Drawing what was collected: set-up and binning, then the tiles.
//!
//! The caller works along with the crew's helpers; with one thread it works
//! alone, through the same code. Work is handed out as exclusive references
//! from shared iterators, so nothing is locked while a tile is drawn.

use std::slice::IterMut;
use std::sync::{Mutex, MutexGuard, PoisonError};

use fillrate_simd::{Crew, Kernel, Level, Simd};

use super::arena::Arena;
use super::{Device, FlushReason};
use crate::bins::{CHUNK, Chunk, Grid};
use crate::raster::TilePainter;
use crate::stats::Counters;
use crate::target::{PixelFormat, Surface, TileCell};

/// States that are kept from one batch to the next before they are dropped.
const KEPT_STATES: usize = 256;

impl Device {
    /// Draws everything collected so far.
    pub fn flush(&mut self, reason: FlushReason) {
        if self.arena.commands.is_empty() {
            return;
        }
        self.flushes.by_reason[reason as usize] += 1;
        self.flushes.commands += self.arena.commands.len() as u64;
        if let Some((color, aux)) = self.take_targets() {
            let grid = grid(&color, self.config.tile.bits());
            self.bin(&grid);
            let aux = self.draw(&grid, color, aux);
            self.put_targets(aux);
        }
        self.arena.clear_commands();
        if self.arena.states.len() > KEPT_STATES {
            self.arena.states.clear();
            self.state = None;
        }
        if self.arena.palettes.len() > KEPT_STATES {
            self.arena.palettes.clear();
        }
        if self.arena.raws.len() > KEPT_STATES {
            self.arena.raws.clear();
        }
    }

    /// Takes the target's surfaces out of their places while they are drawn.
    fn take_targets(&mut self) -> Option<(Surface, Option<Surface>)> {
        let color = self.surfaces.get_mut(self.color?.0 as usize)?.take()?;
        let aux = self.aux.and_then(|id| self.surfaces.get_mut(id.0 as usize)?.take());
        Some((color, aux))
    }

    fn put_targets(&mut self, (color, aux): (Surface, Option<Surface>)) {
        if let Some(id) = self.color {
            self.surfaces[id.0 as usize] = Some(color);
        }
        if let Some(id) = self.aux {
            self.surfaces[id.0 as usize] = aux;
        }
    }

    /// Sets up and bins all commands, chunk by chunk.
    fn bin(&mut self, grid: &Grid) {
        let commands = self.arena.commands.len();
        let count = commands.div_ceil(CHUNK);
        self.chunks.resize_with(count.max(self.chunks.len()), Chunk::default);
        let queue = Mutex::new(self.chunks[..count].iter_mut().enumerate());
        let arena = &self.arena;
        let helpers = self.crew.as_ref().filter(|_| count > 1);
        let level = self.config.level;
        let next = || lock(&queue).next();
        together(helpers, &|_| level.dispatch(BinWork { arena, grid, next: &next }));
    }

    /// Draws all tiles.
    fn draw(
        &mut self,
        grid: &Grid,
        mut color: Surface,
        mut aux: Option<Surface>,
    ) -> (Surface, Option<Surface>) {
        let count = self.arena.commands.len().div_ceil(CHUNK);
        let chunks = &self.chunks[..count];
        let format = color.format();
        let total = Mutex::new(Counters::default());
        let aux_cells = aux.as_mut().map(|aux| &mut aux.cells[..]);
        let shares = self.crew.as_ref().map_or(1, |_| self.config.threads.min(SHARES));
        let queue = TileQueue::new(&mut color.cells, aux_cells, shares);
        let (arena, level) = (&self.arena, self.config.level);
        together(self.crew.as_ref(), &|worker| {
            let next = || queue.next(worker);
            let counters = TileWork { level, arena, grid, format, chunks, next: &next }.run();
            *lock(&total) += counters;
        });
        self.counters += total.into_inner().unwrap_or_else(PoisonError::into_inner);
        for chunk in chunks {
            self.counters += chunk.counters;
        }
        (color, aux)
    }
}

fn grid(color: &Surface, bits: u32) -> Grid {
    let side = 1u32 << bits;
    Grid {
        bits,
        across: color.width().div_ceil(side),
        down: color.height().div_ceil(side),
        bounds: color.bounds(),
    }
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Runs `work` on the caller and on the helpers, and waits for all.
fn together(crew: Option<&Crew>, work: &(dyn Fn(usize) + Sync)) {
    match crew {
        Some(crew) => crew.together(work),
        None => work(0),
    }
}

/// The most shares of a target; more workers than that start at the same.
const SHARES: usize = 16;

/// The tiles of a target in equal shares. A worker begins with the same share
/// batch after batch, so that most of its tiles are in its core's cache, and
/// then helps with the ends of the others.
struct TileQueue<'t> {
    shares: [Mutex<Share<'t>>; SHARES],
    /// Shares in use.
    count: usize,
}

/// Tiles that wait.
#[derive(Default)]
struct Share<'t> {
    /// Index of the first one.
    first: usize,
    color: IterMut<'t, TileCell>,
    aux: Option<IterMut<'t, TileCell>>,
}

impl<'t> TileQueue<'t> {
    fn new(
        mut color: &'t mut [TileCell],
        mut aux: Option<&'t mut [TileCell]>,
        count: usize,
    ) -> TileQueue<'t> {
        let (tiles, count) = (color.len(), count.clamp(1, SHARES));
        let shares = core::array::from_fn(|i| {
            let [first, end] = [i, i + 1].map(|i| tiles * i.min(count) / count);
            let color = color.split_off_mut(..end - first).unwrap_or_default();
            let aux = aux.as_mut().and_then(|aux| aux.split_off_mut(..end - first));
            Mutex::new(Share { first, color: color.iter_mut(), aux: aux.map(|aux| aux.iter_mut()) })
        });
        TileQueue { shares, count }
    }

    /// The next tile for a worker.
    fn next(&self, worker: usize) -> Option<TileItem<'t>> {
        let own = worker % self.count;
        let others = (1..self.count).map(|i| (own + i) % self.count);
        let next = lock(&self.shares[own]).next();
        next.or_else(|| others.into_iter().find_map(|i| lock(&self.shares[i]).next_back()))
    }
}

impl<'t> Share<'t> {
    fn next(&mut self) -> Option<TileItem<'t>> {
        let color = self.color.next()?;
        self.first += 1;
        Some((self.first - 1, (color, self.aux.as_mut().and_then(IterMut::next))))
    }

    fn next_back(&mut self) -> Option<TileItem<'t>> {
        let color = self.color.next_back()?;
        let aux = self.aux.as_mut().and_then(IterMut::next_back);
        Some((self.first + self.color.len(), (color, aux)))
    }
}

/// One worker's share of the chunks; the level is entered once.
struct BinWork<'a, 'c> {
    arena: &'a Arena,
    grid: &'a Grid,
    next: &'a dyn Fn() -> Option<(usize, &'c mut Chunk)>,
}

impl Kernel for BinWork<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self, _: S) {
        let commands = self.arena.commands.len();
        while let Some((i, chunk)) = (self.next)() {
            chunk.build(self.arena, i * CHUNK..commands.min((i + 1) * CHUNK), self.grid);
        }
    }
}

/// A tile to draw: its index, colour and aux cells.
type TileItem<'t> = (usize, (&'t mut TileCell, Option<&'t mut TileCell>));

/// One worker's share of the tiles; the level is entered once.
struct TileWork<'a, 't> {
    level: Level,
    arena: &'a Arena,
    grid: &'a Grid,
    format: PixelFormat,
    chunks: &'a [Chunk],
    next: &'a dyn Fn() -> Option<TileItem<'t>>,
}

impl TileWork<'_, '_> {
    fn run(self) -> Counters {
        self.level.dispatch(self)
    }
}

impl Kernel for TileWork<'_, '_> {
    type Output = Counters;

    #[inline(always)]
    fn run<S: Simd>(self, s: S) -> Counters {
        let mut painter = TilePainter::new(s, self.arena, *self.grid, self.format);
        while let Some((index, (color, aux))) = (self.next)() {
            painter.draw(self.chunks, index, color, aux);
        }
        painter.counters
    }
}
