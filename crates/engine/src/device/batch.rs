//! What is drawn together: commands, and the tiles they are drawn on.
//!
//! Workers set chunks of commands up and sort them into tiles; when all are
//! ready, they take tiles and draw them. Items are handed out whole, each
//! under a lock of its own that nobody else waits for.

use core::ops::Range;
use core::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError, RwLock, RwLockReadGuard};

use fillrate_simd::{Kernel, Level, Simd};

use super::arena::{Arena, BatchState, MAX_COMMANDS};
use crate::bins::{CHUNK, Chunk, Grid};
use crate::crew::Job;
use crate::raster::TilePainter;
use crate::stats::Counters;
use crate::target::{PixelFormat, Surface, TileCell};

/// The most chunks of a batch.
const CHUNKS: usize = MAX_COMMANDS.div_ceil(CHUNK);
/// The most shares of a target; more workers than that start at the same.
const SHARES: usize = 16;

/// A tile of each surface, in cache lines of its own.
#[derive(Debug, Default)]
#[repr(align(64))]
struct Cells {
    color: TileCell,
    aux: Option<TileCell>,
}

/// Commands, their states, and their targets' tiles while they are drawn.
#[derive(Debug)]
pub(super) struct Batch {
    level: Level,
    arena: Arena,
    states: Vec<Arc<BatchState>>,
    grid: Grid,
    format: PixelFormat,
    chunks: [RwLock<Chunk>; CHUNKS],
    /// Chunks in use.
    count: usize,
    /// The next chunk to be built, and how many have been.
    next: AtomicUsize,
    built: Mutex<usize>,
    /// All are built.
    ready: Condvar,
    cells: Vec<Mutex<Cells>>,
    shares: Shares,
    counters: Mutex<Counters>,
}

impl Batch {
    /// A batch of nothing, drawn at a level.
    pub fn new(level: Level) -> Batch {
        Batch {
            level,
            arena: Arena::default(),
            states: Vec::new(),
            grid: Grid::default(),
            format: PixelFormat::Rgb565,
            chunks: core::array::from_fn(|_| RwLock::default()),
            count: 0,
            next: AtomicUsize::new(0),
            built: Mutex::new(0),
            ready: Condvar::new(),
            cells: Vec::new(),
            shares: Shares::default(),
            counters: Mutex::default(),
        }
    }

    /// Takes the commands of an arena, which gets back an empty one, their
    /// states, and the tiles of their targets, to be drawn in shares.
    pub fn take(
        &mut self,
        arena: &mut Arena,
        states: &[Arc<BatchState>],
        color: &mut Surface,
        aux: Option<&mut Surface>,
        shares: usize,
    ) {
        core::mem::swap(&mut self.arena, arena);
        arena.clear();
        states.clone_into(&mut self.states);
        (self.grid, self.format) = (grid(color), color.format());
        self.count = self.arena.commands.len().div_ceil(CHUNK);
        (*self.next.get_mut(), *unlocked(&mut self.built)) = (0, 0);
        self.cells.resize_with(color.cells.len(), Mutex::default);
        self.exchange(color, aux);
        self.shares.cut(self.cells.len(), shares);
    }

    /// Puts the tiles back, and forgets the states; returns what was counted.
    pub fn give_back(&mut self, color: &mut Surface, aux: Option<&mut Surface>) -> Counters {
        self.exchange(color, aux);
        self.states.clear();
        let mut counters = core::mem::take(unlocked(&mut self.counters));
        for chunk in &mut self.chunks[..self.count] {
            counters += chunk.get_mut().unwrap_or_else(PoisonError::into_inner).counters;
        }
        counters
    }

    /// Exchanges the tiles with those of the surfaces.
    fn exchange(&mut self, color: &mut Surface, aux: Option<&mut Surface>) {
        for (cells, color) in self.cells.iter_mut().zip(&mut color.cells) {
            core::mem::swap(&mut unlocked(cells).color, color);
        }
        match aux {
            Some(aux) => {
                for (cells, aux) in self.cells.iter_mut().zip(&mut aux.cells) {
                    let cell = unlocked(cells).aux.get_or_insert_default();
                    core::mem::swap(cell, aux);
                }
            }
            None => self.cells.iter_mut().for_each(|cells| unlocked(cells).aux = None),
        }
    }

    /// Sets chunks up and sorts them into tiles, until none is left.
    #[inline(always)]
    fn build<S: Simd>(&self, s: S) {
        loop {
            let i = self.next.fetch_add(1, Ordering::Relaxed);
            if i >= self.count {
                return;
            }
            // Counted also where it panics: others wait for it.
            let _built = Built(self);
            let commands = i * CHUNK..self.arena.commands.len().min((i + 1) * CHUNK);
            let mut chunk = self.chunks[i].write().unwrap_or_else(PoisonError::into_inner);
            chunk.build(s, &self.arena, &self.states, commands, &self.grid);
        }
    }

    /// Waits until all chunks are built.
    fn wait(&self) {
        let mut built = lock(&self.built);
        while *built < self.count {
            built = self.ready.wait(built).unwrap_or_else(PoisonError::into_inner);
        }
    }

    /// Draws tiles until none is left.
    #[inline(always)]
    fn draw<S: Simd>(&self, s: S, worker: usize) {
        let Some(mut tile) = self.shares.next(worker) else { return };
        let read = |chunk| RwLock::read(chunk).unwrap_or_else(PoisonError::into_inner);
        let guards: [Option<RwLockReadGuard<'_, Chunk>>; CHUNKS] =
            core::array::from_fn(|i| self.chunks[..self.count].get(i).map(read));
        let (arena, states) = (&self.arena, &self.states);
        let mut painter = TilePainter::new(s, arena, states, self.grid, self.format);
        loop {
            let mut cells = lock(&self.cells[tile]);
            let Cells { color, aux } = &mut *cells;
            painter.draw(guards.iter().flatten().map(|chunk| &**chunk), tile, color, aux.as_mut());
            drop(cells);
            match self.shares.next(worker) {
                Some(next) => tile = next,
                None => break,
            }
        }
        *lock(&self.counters) += painter.counters;
    }
}

impl Job for Batch {
    fn work(&self, worker: usize) {
        self.level.dispatch(Build(self));
        self.wait();
        self.level.dispatch(Draw { batch: self, worker });
    }
}

/// A worker's share of the chunks; the level is entered once.
struct Build<'a>(&'a Batch);

impl Kernel for Build<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self, s: S) {
        self.0.build(s);
    }
}

/// A worker's share of the tiles; the level is entered once.
struct Draw<'a> {
    batch: &'a Batch,
    worker: usize,
}

impl Kernel for Draw<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self, s: S) {
        self.batch.draw(s, self.worker);
    }
}

/// Counts a chunk as built when it goes.
struct Built<'a>(&'a Batch);

impl Drop for Built<'_> {
    fn drop(&mut self) {
        let mut built = lock(&self.0.built);
        *built += 1;
        if *built == self.0.count {
            self.0.ready.notify_all();
        }
    }
}

/// The tiles of a target in equal shares. A worker begins with the same share
/// batch after batch, so that most of its tiles are in its core's cache, and
/// then helps with the ends of the others.
#[derive(Debug, Default)]
struct Shares {
    left: [Mutex<Range<usize>>; SHARES],
    /// Shares in use.
    count: usize,
}

impl Shares {
    fn cut(&mut self, tiles: usize, count: usize) {
        self.count = count.clamp(1, SHARES);
        for (i, left) in self.left.iter_mut().enumerate() {
            let [first, end] = [i, i + 1].map(|i| tiles * i.min(self.count) / self.count);
            *unlocked(left) = first..end;
        }
    }

    /// The next tile for a worker.
    fn next(&self, worker: usize) -> Option<usize> {
        let own = worker % self.count.max(1);
        let others = (1..self.count).map(|i| (own + i) % self.count);
        let next = lock(&self.left[own]).next();
        next.or_else(|| others.into_iter().find_map(|i| lock(&self.left[i]).next_back()))
    }
}

fn grid(color: &Surface) -> Grid {
    let bits = color.tile_bits();
    let side = 1u32 << bits;
    Grid {
        bits,
        across: color.width().div_ceil(side),
        down: color.height().div_ceil(side),
        bounds: color.bounds(),
    }
}

/// What a panic may have left half done is drawn over or told of: see
/// [`crate::crew::Crew::finish`].
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

fn unlocked<T>(mutex: &mut Mutex<T>) -> &mut T {
    mutex.get_mut().unwrap_or_else(PoisonError::into_inner)
}
