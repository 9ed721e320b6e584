//! Texture coordinates to texel addresses and weights.

use fillrate_simd::{FloatLanes, IntLanes, Simd};

use super::UnitPlan;
use super::lod::{level_at, linear_lods, lod_at, smallest_w, smallest_w_below};
use crate::kernel::Pass;
use crate::kernel::block::{BLOCK, Block, Lanes, STAMP, Slot, any_live};
use crate::kernel::lanes::{Stamp, ramp_wide};
use crate::setup::{Plane64, PlaneF, Triangle, offset};
use crate::state::Filter;

/// How one level is addressed, lane by lane.
#[derive(Clone, Copy)]
struct LevelLanes<S: Simd> {
    base: S::I,
    pitch: S::I,
    s_mask: S::I,
    t_mask: S::I,
    shift: S::I,
    /// Subtracted from coordinates: half a texel where filtered.
    half: S::I,
    /// Which of the four fraction bits count.
    fraction: S::I,
}

/// What a triangle's stamps share: the planes, the steps within a stamp, and its
/// level of detail.
#[derive(Clone, Debug)]
pub(crate) struct TextureSteps {
    pub(in crate::kernel) triangle: u32,
    /// What follows is not set beyond `base` where it is not.
    exact: bool,
    /// Level of detail of the triangle at w = 1, with the bias.
    base: i32,
    /// See [`Triangle::origin`].
    origin: (i32, i32),
    /// s and t times [`COORDINATE`], and w.
    planes: [PlaneF; 3],
    /// How they differ from a stamp's corner at each of its fragments.
    ramps: [Stamp<f64>; 3],
    /// The most that w rises and falls within a stamp.
    rise: f64,
    fall: f64,
    /// [`quotients_by_reciprocal`] is exact all over the triangle; s and t are half
    /// more then.
    by_reciprocal: bool,
    /// And the unit upstream has the same reciprocals.
    shared: bool,
    /// The level of the last stamp that had only one.
    last: Level,
}

/// One level, and the range of w that selects it.
#[derive(Clone, Copy, Debug)]
struct Level {
    number: usize,
    least: f64,
    limit: f64,
}

/// Coordinates have 8 fraction bits.
const COORDINATE: f64 = 256.0;
/// Numerators below which a reciprocal gives exact quotients: see
/// [`quotients_by_reciprocal`].
const RECIPROCAL_LIMIT: f64 = (1u64 << 51) as f64;

/// 1 / w of a block's fragments, kept for the next unit.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub(crate) struct Reciprocals(pub [f64; BLOCK]);

/// A plane of texture coordinates times [`COORDINATE`].
fn scaled(plane: &PlaneF) -> PlaneF {
    let PlaneF { start, dx, dy } = plane;
    PlaneF { start: start * COORDINATE, dx: dx * COORDINATE, dy: dy * COORDINATE }
}

/// s and t times [`COORDINATE`], and w, of an exact triangle.
#[inline(always)]
fn planes(pass: &Pass<'_>, plan: &UnitPlan, triangle: &Triangle) -> [PlaneF; 3] {
    let [ps, pt, w] = pass.triangles.exact_unit(triangle, plan.index);
    let w = if plan.unit.perspective { w } else { NO_PERSPECTIVE_F };
    [scaled(&ps), scaled(&pt), w]
}

/// Whether w is positive and s and t are small enough for
/// [`quotients_by_reciprocal`] wherever a triangle may have stamps.
#[inline(always)]
fn takes_reciprocal(triangle: &Triangle, [ps, pt, w]: &[PlaneF; 3]) -> bool {
    let (x, y) = triangle.origin();
    let right = f64::from(triangle.bounds.x1 as i32 + 3 - x);
    let down = f64::from(triangle.bounds.y1 as i32 + 3 - y);
    let largest = |p: &PlaneF| p.start.abs() + p.dx.abs() * right + p.dy.abs() * down;
    let smallest = w.start + (w.dx * right).min(0.0) + (w.dy * down).min(0.0);
    smallest > 0.0 && largest(ps) < RECIPROCAL_LIMIT && largest(pt) < RECIPROCAL_LIMIT
}

impl TextureSteps {
    pub const NONE: TextureSteps = TextureSteps {
        triangle: u32::MAX,
        exact: false,
        base: 0,
        origin: (0, 0),
        planes: [PlaneF { start: 0.0, dx: 0.0, dy: 0.0 }; 3],
        ramps: [const { Stamp([0.0; STAMP]) }; 3],
        rise: 0.0,
        fall: 0.0,
        by_reciprocal: false,
        shared: false,
        last: Level { number: 0, least: 0.0, limit: 0.0 },
    };

    /// Goes to a triangle.
    #[inline(always)]
    fn enter<S: Simd>(&mut self, s: S, pass: &Pass<'_>, plan: &UnitPlan, at: &Slot) {
        let triangle = pass.triangle(at);
        self.triangle = at.triangle;
        self.exact = triangle.exact;
        self.base = triangle.lod_base[plan.index] + i32::from(plan.unit.lod.bias);
        if !triangle.exact {
            return;
        }
        self.origin = triangle.origin();
        self.planes = planes(pass, plan, triangle);
        self.by_reciprocal = takes_reciprocal(triangle, &self.planes);
        let upstream = pass.pipeline.units.get(plan.index + 1).and_then(Option::as_deref);
        self.shared = false;
        if let Some(upstream) = upstream {
            let upstream = planes(pass, upstream, triangle);
            self.shared = self.by_reciprocal
                && upstream[2] == self.planes[2]
                && takes_reciprocal(triangle, &upstream);
        }
        for (plane, ramp) in self.planes.iter().zip(&mut self.ramps) {
            ramp_wide(s, plane, &mut ramp.0);
        }
        if self.by_reciprocal {
            self.planes[0].start += 0.5;
            self.planes[1].start += 0.5;
        }
        let w = &self.planes[2];
        let (right, down) = (w.dx * 3.0, w.dy * 3.0);
        self.rise = right.max(0.0) + down.max(0.0);
        self.fall = right.min(0.0) + down.min(0.0);
        self.last = Level { number: 0, least: 0.0, limit: 0.0 };
    }

    /// The planes' values at a stamp's corner.
    #[inline(always)]
    fn corner(&self, at: &Slot) -> [f64; 3] {
        let offset = offset(self.origin, at.x, at.y);
        let [ps, pt, w] = &self.planes;
        [ps.at(offset), pt.at(offset), w.at(offset)]
    }

    /// The level of a stamp with w from `smallest` to `largest`; `None` where
    /// it has several.
    #[inline(always)]
    fn level(&mut self, plan: &UnitPlan, smallest: f64, largest: f64) -> Option<usize> {
        if self.last.least <= smallest && largest < self.last.limit {
            return Some(self.last.number);
        }
        let levels = plan.levels();
        let level = level_at(levels, self.base, largest);
        if level != level_at(levels, self.base, smallest) {
            return None;
        }
        let least = smallest_w_below(self.base, level + 1);
        let limit = smallest_w_below(self.base, level);
        // The finest and the coarsest have no end.
        let least = if level == levels.1 { f64::NEG_INFINITY } else { least };
        let limit = if level == levels.0 { f64::INFINITY } else { limit };
        let number = level as usize;
        self.last = Level { number, least, limit };
        Some(number)
    }
}

/// w where there is no perspective: one everywhere.
const NO_PERSPECTIVE: Plane64 = Plane64 { c: 1 << 32, dx: 0, dy: 0 };
/// The same.
const NO_PERSPECTIVE_F: PlaneF = PlaneF { start: (1u64 << 32) as f64, dx: 0.0, dy: 0.0 };

/// Coordinates of every fragment of the block for `plan`'s unit: texel
/// addresses of both rows, and the weights.
#[inline(always)]
pub(crate) fn address<S: Simd>(s: S, block: &mut Block, pass: &Pass<'_>, plan: &UnitPlan) {
    let Block { live, count, slots, lod, row0, row1, weight_s, weight_t, .. } = block;
    let (steps, reciprocals) = (&mut block.steps.units[plan.index], &mut block.reciprocals);
    let mut out = Samples { row0, row1, weight_s, weight_t, reciprocals };
    for (slot, &at) in slots[..*count].iter().enumerate() {
        if at.triangle != steps.triangle {
            steps.enter(s, pass, plan, &at);
        }
        let lod = &mut lod.0[slot * STAMP..][..STAMP];
        if plan.needs_lod || !steps.exact {
            lods_of_stamp(lod, plan, &integer_w(pass, plan, &at), steps.base, at);
        }
        if !steps.exact {
            inexact_stamp(s, &mut out, pass, plan, (slot, at), lod);
            continue;
        }
        let (live, corner) = ((*live >> (slot * STAMP)) as u32, steps.corner(&at));
        if plan.needs_lod {
            stamp::<S, true>(s, &mut out, plan, corner, (slot, live), lod, steps);
        } else {
            stamp::<S, false>(s, &mut out, plan, corner, (slot, live), lod, steps);
        }
    }
}

/// w where floats will not do.
#[inline(always)]
fn integer_w(pass: &Pass<'_>, plan: &UnitPlan, at: &Slot) -> Plane64 {
    match plan.unit.perspective {
        true => pass.triangles.unit_w(pass.triangle(at), plan.index),
        false => NO_PERSPECTIVE,
    }
}

/// Where a unit's samples are described.
struct Samples<'a> {
    row0: &'a mut Lanes,
    row1: &'a mut Lanes,
    weight_s: &'a mut Lanes,
    weight_t: &'a mut Lanes,
    reciprocals: &'a mut Reciprocals,
}

/// Levels of detail of a stamp's fragments, one by one.
#[inline(always)]
fn lods_of_stamp(out: &mut [i32], plan: &UnitPlan, w: &Plane64, base: i32, at: Slot) {
    if plan.is_next {
        // Those of the finer level are there.
        return;
    }
    if plan.unit.mix_levels {
        return linear_lods(out, plan, w, base, at);
    }
    for (i, out) in out[..STAMP].iter_mut().enumerate() {
        let (x, y) = (at.x + (i & 3) as i32, at.y + (i >> 2) as i32);
        *out = lod_at(plan, base, w.at(x, y), x, y);
    }
}

/// floor(256 * s / w), in the range of `i32`; 0 where w is 0, or not positive
/// and the unit says so.
fn quotient(s: i64, w: i64, clamp_negative_w: bool) -> i32 {
    if w == 0 || (w < 0 && clamp_negative_w) {
        return 0;
    }
    let (mut above, mut below) = (i128::from(s) * 256, i128::from(w));
    if below < 0 {
        (above, below) = (-above, -below);
    }
    above.div_euclid(below).clamp(i128::from(i32::MIN), i128::from(i32::MAX)) as i32
}

/// A stamp whose iterators are too large for floats, one fragment at a time.
#[inline(always)]
fn inexact_stamp<S: Simd>(
    s: S,
    out: &mut Samples<'_>,
    pass: &Pass<'_>,
    plan: &UnitPlan,
    (slot, at): (usize, Slot),
    lods: &[i32],
) {
    let [ps, pt, _] = pass.triangles.unit(pass.triangle(&at), plan.index);
    let pw = integer_w(pass, plan, &at);
    let (mut qs, mut qt) = ([0; STAMP], [0; STAMP]);
    for i in 0..STAMP {
        let (x, y) = (at.x + (i & 3) as i32, at.y + (i >> 2) as i32);
        let (w, clamp) = (pw.at(x, y), plan.unit.clamp_negative_w);
        qs[i] = quotient(ps.at(x, y), w, clamp);
        qt[i] = quotient(pt.at(x, y), w, clamp);
    }
    for j in (0..STAMP).step_by(S::LANES) {
        let k = slot * STAMP + j;
        let levels = levels_by_lod(s, plan, s.load(&lods[j..]));
        let at = [s.load(&qs[j..]), s.load(&qt[j..])];
        if plan.has_border {
            store_address::<S, true>(s, out, plan, k, at, &levels);
        } else {
            store_address::<S, false>(s, out, plan, k, at, &levels);
        }
    }
}

/// A stamp in float lanes, from the planes' values at its corner; `LODS` where
/// levels come from `lods`. What is not live keeps what was there.
#[inline(always)]
fn stamp<S: Simd, const LODS: bool>(
    s: S,
    out: &mut Samples<'_>,
    plan: &UnitPlan,
    [corner_s, corner_t, corner_w]: [f64; 3],
    (slot, live): (usize, u32),
    lods: &[i32],
    steps: &mut TextureSteps,
) {
    // w is linear, so its extremes are at corners.
    let (smallest, largest) = (corner_w + steps.fall, corner_w + steps.rise);
    let level = if LODS { None } else { steps.level(plan, smallest, largest) };
    let (base_s, base_t) = (s.splat_f(corner_s), s.splat_f(corner_t));
    let (base_w, [ramp_s, ramp_t, ramp_w]) = (s.splat_f(corner_w), &steps.ramps);
    for j in (0..STAMP).step_by(S::LANES) {
        if S::ONE_BY_ONE && !any_live::<S>(live, j) {
            continue;
        }
        let k = slot * STAMP + j;
        let w = base_w + s.load_f(&ramp_w.0[j..]);
        let coordinates = [base_s + s.load_f(&ramp_s.0[j..]), base_t + s.load_f(&ramp_t.0[j..])];
        let quotients = if steps.by_reciprocal {
            let kept = &mut out.reciprocals.0[k..];
            let reciprocal = if steps.shared { s.load_f(kept) } else { s.splat_f(1.0) / w };
            if plan.index > 0 {
                s.store_f(reciprocal, kept);
            }
            quotients_by_reciprocal(coordinates, reciprocal)
        } else {
            signed_quotients(s, coordinates, w, plan.unit.clamp_negative_w)
        };
        let lanes = match level {
            Some(level) => one_level(s, plan, level, bilinear_lanes(s, plan, steps.base, w)),
            None if LODS => levels_by_lod(s, plan, s.load(&lods[j..])),
            None => levels_by_w(s, plan, steps, w),
        };
        if LODS && plan.has_border {
            store_address::<S, true>(s, out, plan, k, quotients, &lanes);
        } else {
            store_address::<S, false>(s, out, plan, k, quotients, &lanes);
        }
    }
}

/// [`quotient`] of a + 1/2 where w is positive, from the reciprocal of w as
/// division rounds it; a, the coordinate times [`COORDINATE`], is below
/// [`RECIPROCAL_LIMIT`] in magnitude.
///
/// It is exact: (a + 1/2) / w is 1 / 2w or more from every integer, and its floor is
/// that of a / w. Reciprocal and product are rounded by 2^-53 each, so the product errs
/// by |a + 1/2| / w * (2^-52 + 2^-106) at most, which is less for |a| < 2^51.
#[inline(always)]
fn quotients_by_reciprocal<F: FloatLanes>([a, b]: [F; 2], reciprocal: F) -> [F::I; 2] {
    [(a * reciprocal).floor_i32(), (b * reciprocal).floor_i32()]
}

/// [`quotient`] of coordinates times [`COORDINATE`].
#[inline(always)]
fn quotients<F: FloatLanes>([a, b]: [F; 2], w: F) -> [F::I; 2] {
    [(a / w).floor_i32(), (b / w).floor_i32()]
}

/// The same of any w.
#[inline(always)]
fn signed_quotients<S: Simd>(
    s: S,
    coordinates: [S::F; 2],
    w: S::F,
    clamp_negative_w: bool,
) -> [S::I; 2] {
    let (zero, none) = (s.splat_f(0.0), s.splat(0));
    let mut valid = zero.lt(w);
    if !clamp_negative_w {
        valid = valid | w.lt(zero);
    }
    let [a, b] = quotients(coordinates, w);
    [a.select(none, valid), b.select(none, valid)]
}

/// Address lanes of one level.
#[inline(always)]
fn one_level<S: Simd>(s: S, plan: &UnitPlan, level: usize, bilinear: S::I) -> LevelLanes<S> {
    let (n, t) = (level & 15, &plan.tables);
    LevelLanes {
        base: s.splat(t.base[n]),
        pitch: s.splat(t.pitch[n]),
        s_mask: s.splat(t.s_mask[n]),
        t_mask: s.splat(t.t_mask[n]),
        shift: s.splat(t.shift[n]),
        half: bilinear & s.splat(0x80),
        fraction: bilinear & s.splat(15),
    }
}

/// Address lanes of the levels that `w` selects.
#[inline(always)]
fn levels_by_w<S: Simd>(s: S, plan: &UnitPlan, steps: &TextureSteps, w: S::F) -> LevelLanes<S> {
    let (finest, coarsest) = plan.levels();
    let mut level = s.splat(finest);
    // Half the w is one level more.
    let mut threshold = smallest_w_below(steps.base, finest + 1);
    for coarser in finest + 1..=coarsest {
        level = s.splat(coarser).select(level, w.lt(s.splat_f(threshold)));
        threshold *= 0.5;
    }
    lookup(s, plan, level, bilinear_lanes(s, plan, steps.base, w))
}

/// All ones for a filter of four texels, zero for a single one.
#[inline(always)]
fn ones<S: Simd>(s: S, filter: Filter) -> S::I {
    s.splat(if filter == Filter::Bilinear { -1 } else { 0 })
}

/// All ones where the fragment is filtered. The magnification filter serves
/// the finest level of detail allowed, the other one everything coarser.
#[inline(always)]
fn bilinear_lanes<S: Simd>(s: S, plan: &UnitPlan, base: i32, w: S::F) -> S::I {
    let (minify, magnify) = (ones(s, plan.unit.minify), ones(s, plan.unit.magnify));
    if plan.unit.minify == plan.unit.magnify || plan.lod_min == plan.lod_max {
        return magnify;
    }
    minify.select(magnify, w.lt(s.splat_f(smallest_w(base, plan.lod_min))))
}

/// Address lanes of the levels that levels of detail select.
#[inline(always)]
fn levels_by_lod<S: Simd>(s: S, plan: &UnitPlan, lod: S::I) -> LevelLanes<S> {
    let finest = lod.eq(s.splat(plan.lod_min));
    let bilinear = ones(s, plan.unit.magnify).select(ones(s, plan.unit.minify), finest);
    lookup(s, plan, lod.sar(8), bilinear)
}

#[inline(always)]
fn lookup<S: Simd>(s: S, plan: &UnitPlan, level: S::I, bilinear: S::I) -> LevelLanes<S> {
    let t = &plan.tables;
    LevelLanes {
        base: s.lookup16(&t.base, level),
        pitch: s.lookup16(&t.pitch, level),
        s_mask: s.lookup16(&t.s_mask, level),
        t_mask: s.lookup16(&t.t_mask, level),
        shift: s.lookup16(&t.shift, level),
        half: bilinear & s.splat(0x80),
        fraction: bilinear & s.splat(15),
    }
}

/// Stores addresses and weights of lanes `k..` from their coordinates, which
/// have 8 fraction bits at level 0.
#[inline(always)]
fn store_address<S: Simd, const BORDER: bool>(
    s: S,
    out: &mut Samples<'_>,
    plan: &UnitPlan,
    k: usize,
    [qs, qt]: [S::I; 2],
    level: &LevelLanes<S>,
) {
    let one = s.splat(1);
    let x = qs.sar_each(level.shift) - level.half;
    let y = qt.sar_each(level.shift) - level.half;
    // Half a texel outside, the border is half of the sample.
    let edge = if BORDER { level.half } else { s.splat(0) };
    let x = confine::<S, BORDER>(s, x, level.s_mask, edge, plan.unit.clamp_s);
    let y = confine::<S, BORDER>(s, y, level.t_mask, edge, plan.unit.clamp_t);
    let (column, row) = (x.sar(8), y.sar(8));
    let next = if !plan.unit.clamp_t {
        (row + one) & level.t_mask
    } else if BORDER {
        row + one
    } else {
        (row + one).min(level.t_mask)
    };
    let start = level.base + column;
    s.store(start + row.mul(level.pitch), &mut out.row0.0[k..]);
    s.store(start + next.mul(level.pitch), &mut out.row1.0[k..]);
    // Weights of the texel and its right neighbour as bytes, 16 together.
    let ds = x.sar(4) & level.fraction;
    let pair = ds.shl(8) - ds + s.splat(16);
    s.store(pair | pair.shl(16), &mut out.weight_s.0[k..]);
    let dt = y.sar(4) & level.fraction;
    s.store(dt | dt.shl(16), &mut out.weight_t.0[k..]);
}

/// Clamps or wraps a coordinate of 8 fraction bits to a side of mask + 1
/// texels, and `edge` on either side where it is clamped. Without an edge the
/// fraction is 0 below the first and above the last texel, since both neighbours
/// are the same texel there.
#[inline(always)]
fn confine<S: Simd, const BORDER: bool>(
    s: S,
    x: S::I,
    mask: S::I,
    edge: S::I,
    clamp: bool,
) -> S::I {
    match (clamp, BORDER) {
        (false, _) => x & (mask.shl(8) | s.splat(0xff)),
        (true, false) => x.max(s.splat(0)).min(mask.shl(8)),
        (true, true) => x.max(s.splat(0) - edge).min(mask.shl(8) + edge),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use fillrate_simd::{Kernel, Level};

    struct ByReciprocal(Vec<[i64; 2]>);

    impl Kernel for ByReciprocal {
        type Output = Vec<i32>;
        #[inline(always)]
        fn run<S: Simd>(self, s: S) -> Vec<i32> {
            let mut out = vec![0; self.0.len()];
            for (pairs, out) in self.0.chunks_exact(16).zip(out.chunks_exact_mut(16)) {
                let (mut a, mut w) = ([0.0; 16], [0.0; 16]);
                for (i, pair) in pairs.iter().enumerate() {
                    (a[i], w[i]) = (pair[0] as f64 + 0.5, pair[1] as f64);
                }
                for j in (0..16).step_by(S::LANES) {
                    let a = s.load_f(&a[j..]);
                    let reciprocal = s.splat_f(1.0) / s.load_f(&w[j..]);
                    s.store(quotients_by_reciprocal([a, a], reciprocal)[0], &mut out[j..]);
                }
            }
            out
        }
    }

    /// Quotients that are whole, or miss that by one part, are where a reciprocal
    /// would err.
    #[test]
    fn reciprocals_give_exact_quotients() {
        let limit = RECIPROCAL_LIMIT as i64 - 1;
        let mut seed = 1u64;
        let mut random = |bits: u32| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (seed >> 11) as i64 & ((1 << bits) - 1)
        };
        let mut pairs = Vec::new();
        while pairs.len() < 960_000 {
            let bits = 1 + random(6) as u32 % 46;
            let w = random(bits) + 1;
            let most = limit / w;
            let whole = (random(51) % (most + 1)) * w;
            let near = [whole, whole + 1, whole - 1, most * w, most * w - 1, limit];
            for a in near.map(|a| a.clamp(0, limit)) {
                pairs.extend([[a, w], [-a, w]]);
            }
        }
        let floor = |&[a, w]: &[i64; 2]| {
            a.div_euclid(w).clamp(i64::from(i32::MIN), i64::from(i32::MAX)) as i32
        };
        let expected: Vec<i32> = pairs.iter().map(floor).collect();
        for level in Level::available() {
            assert_eq!(level.dispatch(ByReciprocal(pairs.clone())), expected, "{level}");
        }
    }
}
