//! Set-up and binning: which tile draws what, in submission order.
//!
//! The arena is cut into chunks. Workers take whole chunks, set their
//! triangles up and sort them into tiles; a tile later walks the chunks in
//! order, so submission order is kept whoever worked on what.

mod triangles;

use core::ops::Range;
use std::sync::Arc;

use fillrate_simd::Simd;

use self::triangles::{List, Together};
use crate::device::arena::{Arena, BatchState, Command, Run};
use crate::setup::{
    Edge, Many, RawShape, Shape, Triangle, Triangles, Values, prepare_palette, prepare_raw,
};
use crate::state::Rect;
use crate::stats::Counters;

/// Commands of a chunk.
pub(crate) const CHUNK: usize = 512;

/// Something a tile has to do. The numbers index the chunk's triangles and
/// shapes, or the arena's clears and runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Entry {
    Triangle(u32),
    Shape(u32),
    Raw(u32),
    Clear(u32),
    Pixels(u32),
}

/// The tiles of a target.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Grid {
    /// log2 of a tile's side.
    pub bits: u32,
    pub across: u32,
    pub down: u32,
    /// The target's pixels.
    pub bounds: Rect,
}

impl Grid {
    pub fn len(&self) -> usize {
        (self.across * self.down) as usize
    }

    /// The pixels of a tile, those beyond the target's edge included.
    pub fn tile(&self, index: usize) -> Rect {
        let side = 1 << self.bits;
        let (x, y) = (index as u32 % self.across * side, index as u32 / self.across * side);
        Rect::new(x, y, x + side, y + side)
    }

    /// Tile columns and rows that a rectangle inside the target touches.
    fn touched(&self, rect: &Rect) -> (Range<u32>, Range<u32>) {
        let range = |from: u32, to: u32| from >> self.bits..((to - 1) >> self.bits) + 1;
        (range(rect.x0, rect.x1), range(rect.y0, rect.y1))
    }
}

/// A part of the arena, set up and binned. Its fields change with every triangle,
/// so it shares no cache line with the chunk that another worker builds.
#[derive(Debug, Default)]
#[repr(align(128))]
pub(crate) struct Chunk {
    pub triangles: Triangles,
    pub shapes: Vec<Shape>,
    pub raws: Vec<RawShape>,
    /// What walks of the Raw profile begin rows of tiles with.
    pub raw_rows: Vec<f32>,
    pub counters: Counters,
    /// The triangles that were set up together last, and which they are.
    many: Many,
    together: Option<Together>,
    pairs: Vec<(u32, Entry)>,
    starts: Vec<u32>,
    entries: Vec<Entry>,
}

impl Chunk {
    /// Sets up and bins `commands`.
    #[inline(always)]
    pub fn build<S: Simd>(
        &mut self,
        s: S,
        arena: &Arena,
        states: &[Arc<BatchState>],
        commands: Range<usize>,
        grid: &Grid,
    ) {
        self.triangles.clear();
        self.shapes.clear();
        self.raws.clear();
        self.raw_rows.clear();
        self.pairs.clear();
        self.counters = Counters::default();
        self.together = None;
        let commands = &arena.commands[commands];
        for command in commands {
            match *command {
                Command::Triangle(index) => self.triangle(s, arena, states, index, grid),
                Command::Verite { vertices, state } => {
                    let list = List::Verite(&arena.verites);
                    self.verite(s, list, vertices, (state, &states[state as usize]), grid);
                }
                Command::VeriteExtended { vertices, state } => {
                    let list = List::Extended(&arena.extended_verites);
                    self.verite(s, list, vertices, (state, &states[state as usize]), grid);
                }
                Command::Launch { registers, state } => {
                    let registers = &arena.registers[registers as usize];
                    self.registers(registers, (state, &states[state as usize]), grid);
                }
                Command::Palette { primitive, state } => {
                    self.counters.triangles_in += 1;
                    self.shape(arena, primitive, state, grid);
                }
                Command::Raw { primitive, state } => {
                    self.counters.triangles_in += 1;
                    self.raw(arena, primitive, state, grid);
                }
                Command::Clear(index) => {
                    let rect = arena.clears[index as usize].rect;
                    self.add_rect(&rect, Entry::Clear(index), grid);
                }
                Command::Pixels(index) => {
                    let Run { x, y, count, .. } = arena.runs[index as usize];
                    let rect = Rect::new(x, y, x + count, y + 1);
                    self.add_rect(&rect, Entry::Pixels(index), grid);
                }
            }
        }
        self.sort(grid.len());
    }

    fn shape(&mut self, arena: &Arena, primitive: u32, state: u32, grid: &Grid) {
        let primitive = &arena.primitives[primitive as usize];
        let textured = arena.palettes[state as usize].state.reads_texture();
        let Some(shape) = prepare_palette(primitive, &grid.bounds, state, textured) else { return };
        self.counters.triangles_drawn += 1;
        let entry = Entry::Shape(self.shapes.len() as u32);
        add_edges(&mut self.pairs, &shape.bounds, shape.edges(), entry, grid);
        self.shapes.push(shape);
    }

    #[inline(always)]
    fn raw(&mut self, arena: &Arena, primitive: u32, state: u32, grid: &Grid) {
        let (primitive, draw) =
            (&arena.raw_primitives[primitive as usize], &arena.raws[state as usize]);
        let (screen, side) = (&grid.bounds, 1 << grid.bits);
        let rows = &mut self.raw_rows;
        let Some(shape) = prepare_raw(primitive, draw, state, screen, side, rows) else { return };
        self.counters.triangles_drawn += 1;
        let entry = Entry::Raw(self.raws.len() as u32);
        let (columns, rows) = grid.touched(&shape.bounds);
        for row in rows {
            for tile in columns.clone().map(|column| row * grid.across + column) {
                let missed = match &shape.values {
                    Values::Walk(walk) => walk.misses(&shape.bounds, &grid.tile(tile as usize)),
                    Values::Mix { .. } => false,
                };
                if !missed {
                    self.pairs.push((tile, entry));
                }
            }
        }
        self.raws.push(shape);
    }

    fn add_rect(&mut self, rect: &Rect, entry: Entry, grid: &Grid) {
        let (columns, rows) = grid.touched(rect);
        for row in rows {
            self.pairs.extend(columns.clone().map(|column| (row * grid.across + column, entry)));
        }
    }

    /// Sorts the pairs by tile, keeping their order within one.
    fn sort(&mut self, tiles: usize) {
        self.starts.clear();
        self.starts.resize(tiles + 1, 0);
        for (tile, _) in &self.pairs {
            self.starts[*tile as usize + 1] += 1;
        }
        for tile in 0..tiles {
            self.starts[tile + 1] += self.starts[tile];
        }
        self.entries.clear();
        self.entries.resize(self.pairs.len(), Entry::Clear(0));
        // Fill backwards, so that `starts` ends as the first index of each.
        let mut ends = core::mem::take(&mut self.starts);
        for (tile, entry) in self.pairs.iter().rev() {
            let end = &mut ends[*tile as usize + 1];
            *end -= 1;
            self.entries[*end as usize] = *entry;
        }
        ends.remove(0);
        ends.push(self.pairs.len() as u32);
        self.starts = ends;
    }

    /// What a tile has to do in this chunk, in order.
    pub fn tile(&self, index: usize) -> &[Entry] {
        &self.entries[self.starts[index] as usize..self.starts[index + 1] as usize]
    }
}

fn triangle_edges(triangle: &Triangle) -> &[Edge] {
    &triangle.edges[..triangle.edge_count as usize]
}

/// Sends an entry to the tiles that its bounds and edges reach.
#[inline(always)]
fn add_edges(
    pairs: &mut Vec<(u32, Entry)>,
    bounds: &Rect,
    edges: &[Edge],
    entry: Entry,
    grid: &Grid,
) {
    let (columns, rows) = grid.touched(bounds);
    if columns.len() == 1 && rows.len() == 1 {
        return pairs.push((rows.start * grid.across + columns.start, entry));
    }
    for row in rows {
        for column in columns.clone() {
            let tile = row * grid.across + column;
            if touches(edges, &grid.tile(tile as usize)) {
                pairs.push((tile, entry));
            }
        }
    }
}

/// Whether no edge excludes all of a tile.
fn touches(edges: &[Edge], tile: &Rect) -> bool {
    let last = (tile.x1 - tile.x0) as i32 - 1;
    edges.iter().all(|edge| {
        let corner = edge.at(tile.x0 as i32, tile.y0 as i32);
        let reach = i64::from(edge.a.max(0)) + i64::from(edge.b.max(0));
        corner + reach * i64::from(last) >= 0
    })
}

#[cfg(test)]
mod tests {
    use fillrate_simd::Scalar;

    use super::*;
    use crate::device::ClearValues;
    use crate::device::arena::Clear;

    #[test]
    fn tiles_keep_submission_order() {
        let bounds = Rect::new(0, 0, 100, 70);
        let grid = Grid { bits: 5, across: 4, down: 3, bounds };
        let mut arena = Arena::default();
        let rects = [bounds, Rect::new(40, 40, 41, 41), Rect::new(0, 0, 64, 64)];
        for (i, rect) in rects.into_iter().enumerate() {
            arena.clears.push(Clear { rect, values: ClearValues::default() });
            arena.commands.push(Command::Clear(i as u32));
        }
        let mut chunk = Chunk::default();
        for _ in 0..2 {
            chunk.build(Scalar, &arena, &[], 0..3, &grid);
            assert_eq!(chunk.tile(0), [Entry::Clear(0), Entry::Clear(2)]);
            assert_eq!(chunk.tile(5), [Entry::Clear(0), Entry::Clear(1), Entry::Clear(2)]);
            assert_eq!(chunk.tile(11), [Entry::Clear(0)]);
        }
    }
}
