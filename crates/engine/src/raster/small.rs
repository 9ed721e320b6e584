//! Small triangles: every stamp of the bounds is looked at.
//!
//! Edges and z are values in registers that go from stamp to stamp by a sum.

use fillrate_simd::{IntLanes, MaskLanes, Simd};

use super::queue::Queue;
use crate::kernel::block::{STAMP, Slot, VECTORS};
use crate::kernel::depth::{DepthTest, early};
use crate::kernel::lanes::places;
use crate::setup::{Triangle, Z};
use crate::state::Rect;
use crate::stats::Counters;

/// Stamps across and down that an area touches.
#[inline(always)]
fn stamps(area: &Rect) -> (u32, u32) {
    let stamps = |from: u32, to: u32| to.div_ceil(4) - from / 4;
    (stamps(area.x0, area.x1), stamps(area.y0, area.y1))
}

/// Whether an area is so small that its stamps are not worth classifying.
#[inline(always)]
pub(super) fn is_small<S: Simd>(area: &Rect) -> bool {
    let (across, down) = stamps(area);
    (across * down) as usize <= 2 * S::LANES
}

/// Values of a plane over a stamp.
#[derive(Clone, Copy)]
struct Plane<S: Simd> {
    /// Those of the first vector.
    now: S::I,
    /// From there to each vector.
    rows: [S::I; VECTORS],
    right: S::I,
    down: S::I,
}

impl<S: Simd> Plane<S> {
    /// `c + x * dx + y * dy` from the stamp at (x, y) on; wraps.
    #[inline(always)]
    fn new(s: S, [c, dx, dy]: [i32; 3], x: i32, y: i32) -> Self {
        let (right, down) = (s.splat(dx.wrapping_mul(4)), s.splat(dy.wrapping_mul(4)));
        let [x, y] = places(s, x, y, 0);
        let now = s.splat(c) + (x.mul(s.splat(dx)) + y.mul(s.splat(dy)));
        let mut rows = [s.splat(0); VECTORS];
        for (v, rows) in rows[..STAMP / S::LANES].iter_mut().enumerate() {
            *rows = s.splat(dy.wrapping_mul((v * S::LANES / 4) as i32));
        }
        Plane { now, rows, right, down }
    }

    /// The values of a vector.
    #[inline(always)]
    fn at(&self, v: usize) -> S::I {
        if S::LANES == STAMP { self.now } else { self.now + self.rows[v] }
    }
}

/// Bit per vector of a stamp in row `y`: those that hold rows of an area.
#[inline(always)]
fn vectors<S: Simd>(area: &Rect, y: u32) -> u32 {
    if !S::ONE_BY_ONE {
        return u32::MAX;
    }
    let rows = (S::LANES / 4) as u32;
    let first = area.y0.saturating_sub(y) / rows;
    let end = (area.y1 - y).min(4).div_ceil(rows);
    (1 << end) - (1 << first)
}

/// What is drawn where.
pub(super) struct Small<'a> {
    pub triangle: &'a Triangle,
    /// Its index.
    pub index: u32,
    /// Its part of the tile.
    pub area: &'a Rect,
    /// Index of the first stamp's first element in the tile, and from one row of
    /// stamps to the next.
    pub at: u32,
    pub pitch: u32,
}

impl Small<'_> {
    /// Covers and tests the stamps, and queues those of which something is left.
    #[inline(always)]
    pub fn gather<S: Simd, const EARLY: u8>(
        &self,
        s: S,
        test: &DepthTest,
        aux: &mut [u16],
        queue: &mut Queue,
        counters: &mut Counters,
    ) {
        let (x, y) = ((self.area.x0 & !3) as i32, (self.area.y0 & !3) as i32);
        let (across, down) = stamps(self.area);
        let [e0, e1, e2] = &self.triangle.edges;
        let mut e0 = Plane::new(s, [e0.c as i32, e0.a, e0.b], x, y);
        let mut e1 = Plane::new(s, [e1.c as i32, e1.a, e1.b], x, y);
        let mut e2 = Plane::new(s, [e2.c as i32, e2.a, e2.b], x, y);
        let narrow = &self.triangle.narrow;
        let mut z = Plane::new(s, [narrow.c[Z], narrow.dx[Z], narrow.dy[Z]], x, y);
        let mut slot = Slot { triangle: self.index, at: self.at, x, y };
        for _ in 0..down {
            let (row, mut planes) = (slot, [e0, e1, e2, z]);
            let vectors = vectors::<S>(self.area, slot.y as u32);
            for _ in 0..across {
                let (mut covered, mut left) = (0, 0);
                let aux = match EARLY {
                    early::NONE => &mut [],
                    _ => &mut aux[slot.at as usize..][..STAMP],
                };
                for (v, j) in (0..STAMP).step_by(S::LANES).enumerate() {
                    if S::ONE_BY_ONE && vectors >> v & 1 == 0 {
                        continue;
                    }
                    let [e0, e1, e2, z] =
                        [planes[0].at(v), planes[1].at(v), planes[2].at(v), planes[3].at(v)];
                    let inside = (e0 | e1 | e2).gt(s.splat(-1));
                    covered |= inside.bits() << j;
                    if EARLY != early::NONE {
                        let passed = test.run_iterated::<S, EARLY>(s, z, inside, &mut aux[j..]);
                        left |= passed.bits() << j;
                    }
                }
                counters.pixels_in += u64::from(covered.count_ones());
                if EARLY != early::NONE {
                    counters.depth_fail += u64::from(covered.count_ones() - left.count_ones());
                }
                queue.push(slot, if EARLY == early::NONE { covered } else { left } as u16);
                slot.at += STAMP as u32;
                slot.x += 4;
                for plane in &mut planes {
                    plane.now = plane.now + plane.right;
                }
            }
            slot = Slot { at: row.at + self.pitch, y: row.y + 4, ..row };
            for plane in [&mut e0, &mut e1, &mut e2, &mut z] {
                plane.now = plane.now + plane.down;
            }
        }
    }
}
