//! Corners of triangles as they wait for set-up: field by field, a lane for each
//! triangle, so that set-up loads many triangles at once and a batch holds only
//! what its states read.

use fillrate_simd::{Level, prefetch_write};

use super::launch::{GROUP, NARROW};
use super::sst1::Corners;
use super::{Cull, TmuVertex, Vertex};
use crate::reused::Reused;
use crate::state::MAX_TMUS;

/// Triangles of a block, the most that set-up takes at once.
pub(crate) const BLOCK: usize = fillrate_simd::MAX_LANES;

/// A field of three corners of each triangle.
pub(super) type Field = [[f32; BLOCK]; 3];

/// Fields besides the texture coordinates: x, y, red, green, blue, alpha, z, w.
const FIXED: usize = 8;
pub(super) const X: usize = 0;
pub(super) const Y: usize = 1;
/// Red; green, blue, alpha and z follow.
pub(super) const RED: usize = 2;
pub(super) const W: usize = 7;

/// The field of parameter 0, 1, 2 (s, t, w) of a unit.
pub(super) const fn tmu_field(unit: usize, param: usize) -> usize {
    FIXED + 3 * unit + param
}

/// What a block's triangles are besides corners.
#[derive(Clone, Debug, Default)]
pub(super) struct Marks {
    /// Index of the draw state.
    pub state: [i32; BLOCK],
    /// The [`Cull`] as an integer.
    pub cull: [i32; BLOCK],
}

/// Corners of sixteen triangles.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
pub(crate) struct CornerBlock {
    pub(super) marks: Marks,
    pub(super) fields: [Field; FIXED + 3 * MAX_TMUS],
}

impl Default for CornerBlock {
    fn default() -> CornerBlock {
        let fields = [Field::default(); FIXED + 3 * MAX_TMUS];
        CornerBlock { marks: Marks::default(), fields }
    }
}

impl CornerBlock {
    /// Tells the processor that a part of a block is written soon: all of it, once it
    /// was told for every lane.
    #[inline(always)]
    fn prefetch(&mut self, level: Level, lane: usize, units: usize) {
        match self.fields.get_mut(lane) {
            Some(field) if lane < tmu_field(units, 0) => prefetch_write(level, field),
            Some(_) => prefetch_write(level, &mut self.marks),
            None => {}
        }
    }

    /// Writes a corner of a triangle, with the texture coordinates of `units` units.
    #[inline(always)]
    fn put(&mut self, lane: usize, corner: usize, units: usize, v: &Vertex) {
        let fixed = [v.x, v.y, v.r, v.g, v.b, v.a, v.z, v.w];
        for (field, value) in self.fields[..FIXED].iter_mut().zip(fixed) {
            field[corner][lane] = value;
        }
        for (unit, TmuVertex { s, t, w }) in v.tmu.iter().enumerate() {
            if unit < units {
                self.fields[tmu_field(unit, 0)][corner][lane] = *s;
                self.fields[tmu_field(unit, 1)][corner][lane] = *t;
                self.fields[tmu_field(unit, 2)][corner][lane] = *w;
            }
        }
    }
}

/// A triangle of a block.
pub(crate) struct Lane<'a>(pub &'a CornerBlock, pub usize);

impl Lane<'_> {
    /// The index of its draw state.
    #[inline(always)]
    pub fn state(&self) -> u32 {
        self.0.marks.state[self.1] as u32
    }

    /// Which way of facing drops it.
    #[inline(always)]
    pub fn cull(&self) -> Cull {
        match self.0.marks.cull[self.1] {
            CULL_NEGATIVE => Cull::Negative,
            CULL_POSITIVE => Cull::Positive,
            _ => Cull::Disabled,
        }
    }

    #[inline(always)]
    fn get(&self, field: usize, corner: usize) -> f32 {
        self.0.fields[field][corner][self.1]
    }
}

impl Corners for Lane<'_> {
    #[inline(always)]
    fn place(&self, corner: usize) -> [f32; 2] {
        [self.get(X, corner), self.get(Y, corner)]
    }

    #[inline(always)]
    fn narrow(&self, corner: usize) -> [f32; NARROW] {
        let get = |i: usize| self.get(RED + i, corner);
        [get(0), get(1), get(2), get(3), get(4), 0.0, 0.0, 0.0]
    }

    #[inline(always)]
    fn wide(&self, corner: usize, unit: usize) -> [f32; GROUP] {
        let get = |param: usize| self.get(tmu_field(unit, param), corner);
        match unit {
            0 => [self.get(W, corner), get(0), get(1), get(2)],
            _ => [get(0), get(1), get(2), 0.0],
        }
    }
}

const CULL_NEGATIVE: i32 = Cull::Negative as i32;
const CULL_POSITIVE: i32 = Cull::Positive as i32;

/// A draw state in use.
#[derive(Clone, Copy, Debug)]
pub(crate) struct UsedState {
    pub index: u32,
    /// Texture units that it reads.
    pub units: usize,
}

/// Triangles in blocks.
#[derive(Debug, Default)]
pub(crate) struct CornerBlocks {
    list: Reused<CornerBlock>,
    used: usize,
}

impl CornerBlocks {
    /// Adds a triangle of corners 0 to 2, and returns its index.
    #[inline(always)]
    pub fn push(
        &mut self,
        level: Level,
        state: UsedState,
        cull: Cull,
        corner: impl Fn(usize) -> Vertex,
    ) -> u32 {
        let (index, lane) = (self.used, self.used % BLOCK);
        if lane == 0 {
            self.list.add();
        }
        self.used += 1;
        // What is written next was read by another core for the batch before last.
        if let Some(next) = self.list.ahead(0) {
            next.prefetch(level, lane, state.units);
        }
        if let Some(block) = self.list.last_mut() {
            block.marks.state[lane] = state.index as i32;
            block.marks.cull[lane] = cull as i32;
            // One after the other, so that each one's values fit into registers.
            block.put(lane, 0, state.units, &corner(0));
            block.put(lane, 1, state.units, &corner(1));
            block.put(lane, 2, state.units, &corner(2));
        }
        index as u32
    }

    #[inline(always)]
    pub fn get(&self, index: u32) -> Lane<'_> {
        Lane(&self.list[index / BLOCK as u32], index as usize % BLOCK)
    }

    pub fn clear(&mut self) {
        self.list.clear();
        self.used = 0;
    }
}
