//! Set-up of many triangles at once, a lane for each.
//!
//! Only what nearly all triangles are is done here: compact ones whose values fit
//! their formats with room to spare. [`Many::is_plain`] says which lanes these are;
//! the others go one by one by [`super::sst1`] and [`super::planes`], which define
//! every value here.

mod planes;
mod sst1;
#[cfg(test)]
mod tests;
mod verite;

use fillrate_simd::{FloatLanes, IntLanes, MaskLanes, Simd, SingleLanes};

use self::planes::Corrected;
use super::corners::{BLOCK, Lane};
use super::launch::{GROUP, Params, Z, wide_lane};
use super::planes::{COORDINATE_LIMIT, ExactGroup, Narrow, SHIFTS, Screen, W_LIMIT};
use super::sst1::Fate;
use super::verite::VeriteCorners;
use super::{Edge, Triangle, Triangles};
use crate::kernel::texture::lod_base;
use crate::state::{MAX_TMUS, Rect};

/// Four values of each triangle.
type Rows<T> = [[T; 4]; BLOCK];

/// Which corner comes where by rising y: whether it was the second, and the third.
struct Order<S: Simd>([[S::M; 2]; 3]);

impl<S: Simd> Order<S> {
    /// From the corners' numbers, two bits each, the lowest corner's first.
    #[inline(always)]
    fn new(s: S, code: S::I) -> Self {
        let (one, two, three) = (s.splat(1), s.splat(2), s.splat(3));
        let [first, second, third] = [code & three, code.shr(2) & three, code.shr(4) & three];
        Order([
            [first.eq(one), first.eq(two)],
            [second.eq(one), second.eq(two)],
            [third.eq(one), third.eq(two)],
        ])
    }

    /// Corners' values, sorted.
    #[inline(always)]
    fn integers(&self, [a, b, c]: [S::I; 3]) -> [S::I; 3] {
        let [first, second, third] = &self.0;
        [
            c.select(b.select(a, first[0]), first[1]),
            c.select(b.select(a, second[0]), second[1]),
            c.select(b.select(a, third[0]), third[1]),
        ]
    }

    /// The same of floats.
    #[inline(always)]
    fn singles(&self, [a, b, c]: [S::G; 3]) -> [S::G; 3] {
        let [first, second, third] = &self.0;
        [
            c.select(b.select(a, first[0]), first[1]),
            c.select(b.select(a, second[0]), second[1]),
            c.select(b.select(a, third[0]), third[1]),
        ]
    }

    /// The lowest corners' values.
    #[inline(always)]
    fn first(&self, [a, b, c]: [S::F; 3]) -> S::F {
        c.select(b.select(a, self.0[0][0]), self.0[0][1])
    }
}

/// Sorted corners' coordinates in lanes: see [`super::Registers`].
struct Places<S: Simd> {
    x: [S::I; 3],
    y: [S::I; 3],
    /// -1 where the area is negative, else 0.
    negative: S::I,
}

/// What triangles have before their planes. Every set-up has its own. Lanes that are
/// off in a mask do not fit the format of what comes with it.
trait Source<S: Simd> {
    fn places(&self, s: S) -> (Places<S>, S::M);
    /// Red, green, blue, alpha or z.
    fn narrow(&self, s: S, lane: usize) -> (Params<S::I>, S::M);
    /// A lane of a group: see [`super::Launch`]. Those of units after the last one in
    /// use are not asked for.
    fn wide(&self, s: S, group: usize, lane: usize) -> Params<S::F>;
}

/// As many triangles of one state as there are lanes, set up.
#[derive(Debug)]
pub(crate) struct Many {
    /// Bit per lane.
    drawn: u32,
    culled: u32,
    plain: u32,
    /// Those that cover something of the screen.
    visible: u32,
    groups: usize,
    bounds: Rows<i32>,
    edges: [Rows<i32>; 3],
    /// Start values and steps of the colours, and those of z.
    colors: [Rows<i32>; 3],
    depth: Rows<i32>,
    wide: [[Rows<f64>; 3]; MAX_TMUS],
    lod_base: [[i32; BLOCK]; MAX_TMUS],
}

impl Default for Many {
    fn default() -> Many {
        Many {
            drawn: 0,
            culled: 0,
            plain: 0,
            visible: 0,
            groups: 0,
            bounds: [[0; 4]; BLOCK],
            edges: [[[0; 4]; BLOCK]; 3],
            colors: [[[0; 4]; BLOCK]; 3],
            depth: [[0; 4]; BLOCK],
            wide: [[[[0.0; 4]; BLOCK]; 3]; MAX_TMUS],
            lod_base: [[0; BLOCK]; MAX_TMUS],
        }
    }
}

impl Many {
    /// Sets the triangles of the vector up that `one` lies in, as if all were of a
    /// state that reads `units` texture units.
    #[inline(always)]
    pub fn set_up<S: Simd>(&mut self, s: S, one: &Lane<'_>, screen: &Screen, units: usize) {
        let Lane(block, lane) = *one;
        let sorted = sst1::Sorted::new(s, block, lane - lane % S::LANES);
        (self.drawn, self.culled) = (sorted.drawn, sorted.culled);
        self.prepare(s, &sorted, screen, [units, units.max(1)]);
    }

    /// The same for the Vérité's triangles, of the lanes for which there is one.
    #[inline(always)]
    pub fn set_up_verite<'a, S: Simd>(
        &mut self,
        s: S,
        triangle: impl Fn(usize) -> Option<VeriteCorners<'a>>,
        screen: &Screen,
        units: usize,
    ) {
        let sorted = verite::Sorted::new(s, triangle);
        (self.drawn, self.culled) = (sorted.drawn, 0);
        self.prepare(s, &sorted, screen, [units, units.max(1)]);
    }

    /// What became of a triangle.
    #[inline(always)]
    pub fn fate(&self, lane: usize) -> Fate {
        match (self.drawn >> lane & 1, self.culled >> lane & 1) {
            (0, _) => Fate::Empty,
            (_, 1) => Fate::Culled,
            _ => Fate::Drawn,
        }
    }

    /// Whether a triangle's planes are there.
    #[inline(always)]
    pub fn is_plain(&self, lane: usize) -> bool {
        self.plain >> lane & 1 != 0
    }

    #[inline(always)]
    fn prepare<S: Simd, T: Source<S>>(
        &mut self,
        s: S,
        source: &T,
        screen: &Screen,
        [units, groups]: [usize; 2],
    ) {
        let (places, mut plain) = source.places(s);
        let bounds = places.bounds(s, screen);
        let edges = places.edges(s, &bounds, screen);
        let planes = Corrected::new(s, &places, &bounds, screen);
        plain = plain & places.are_compact(s) & bounds.end_at_stamps(s, screen);
        self.visible = bounds.visible(s).bits();
        s.transpose([bounds.x0, bounds.y0, bounds.x1, bounds.y1], &mut self.bounds);
        for (i, rows) in self.edges.iter_mut().enumerate() {
            let edge = &edges[i];
            // c in 64 bits.
            s.transpose([edge.a, edge.b, edge.c, edge.c.sar(31)], rows);
        }
        let zero = s.splat(0);
        let mut narrow = [Params { start: zero, dx: zero, dy: zero }; 5];
        for (lane, narrow) in narrow.iter_mut().enumerate() {
            let (params, fits) = source.narrow(s, lane);
            plain = plain & fits;
            *narrow = planes.narrow(s, params, SHIFTS[lane]);
        }
        let [r, g, b, a, z] = narrow;
        s.transpose([r.start, g.start, b.start, a.start], &mut self.colors[0]);
        s.transpose([r.dx, g.dx, b.dx, a.dx], &mut self.colors[1]);
        s.transpose([r.dy, g.dy, b.dy, a.dy], &mut self.colors[2]);
        s.transpose([z.start, z.dx, z.dy, z.dy], &mut self.depth);
        self.groups = groups;
        for group in 0..groups.min(MAX_TMUS) {
            plain = plain & self.group(s, source, &planes, group, group < units);
        }
        self.plain = plain.bits();
    }

    /// A group's planes, and which lanes iterate them exactly in floats. Without its
    /// unit, w of the pixel pipeline is all there is.
    #[inline(always)]
    fn group<S: Simd, T: Source<S>>(
        &mut self,
        s: S,
        source: &T,
        planes: &Corrected<S>,
        group: usize,
        unit: bool,
    ) -> S::M {
        let zero = s.splat_f(0.0);
        let mut params = [Params { start: zero, dx: zero, dy: zero }; GROUP];
        let mut fits = s.mask(u32::MAX);
        let first = wide_lane(group, 0).1;
        let lanes = if unit { first + 3 } else { 1 };
        for (lane, params) in params[..lanes].iter_mut().enumerate() {
            let limit = if (first..first + 2).contains(&lane) { COORDINATE_LIMIT } else { W_LIMIT };
            let (plane, exact) = planes.exact(s, source.wide(s, group, lane), limit);
            fits = fits & exact;
            *params = plane;
        }
        let [a, b, c, d] = params;
        let [start, dx, dy] = &mut self.wide[group];
        s.transpose_f([a.start, b.start, c.start, d.start], start);
        s.transpose_f([a.dx, b.dx, c.dx, d.dx], dx);
        s.transpose_f([a.dy, b.dy, c.dy, d.dy], dy);
        if unit {
            self.lods(s, group, &params[first], &params[first + 1]);
        }
        fits
    }

    /// The levels of detail at w = 1.
    #[inline(always)]
    fn lods<S: Simd>(&mut self, s: S, unit: usize, u: &Params<S::F>, v: &Params<S::F>) {
        let (mut across, mut down) = ([0.0; BLOCK], [0.0; BLOCK]);
        s.store_f(u.dx * u.dx + v.dx * v.dx, &mut across);
        s.store_f(u.dy * u.dy + v.dy * v.dy, &mut down);
        for (lane, lod) in self.lod_base[unit][..S::LANES].iter_mut().enumerate() {
            *lod = lod_base(across[lane], down[lane]);
        }
    }

    /// Appends a plain triangle to `out`; `None` where it covers no pixel of the
    /// screen.
    #[inline(always)]
    pub fn push<'a, S: Simd>(
        &self,
        lane: usize,
        state: u32,
        out: &'a mut Triangles,
    ) -> Option<&'a Triangle> {
        let lane = lane % BLOCK;
        if self.visible >> lane & 1 == 0 {
            return None;
        }
        out.prefetch_next(S::LEVEL);
        let wide = out.exact.len() as u32;
        let group = |[start, dx, dy]: &[Rows<f64>; 3]| ExactGroup {
            start: start[lane],
            dx: dx[lane],
            dy: dy[lane],
        };
        let [first, others @ ..] = &self.wide;
        out.exact.extend(others[..self.groups.clamp(1, MAX_TMUS) - 1].iter().map(group));
        let extra = out.extras.len() as u32;
        // Written where it stays: what is copied from parts waits for them.
        let triangle = out.list.add();
        let [x0, y0, x1, y1] = self.bounds[lane].map(|v| v as u32);
        triangle.bounds = Rect::new(x0, y0, x1, y1);
        (triangle.state, triangle.wide, triangle.extra) = (state, wide, extra);
        (triangle.edge_count, triangle.exact, triangle.compact) = (3, true, true);
        for (lod, lods) in triangle.lod_base.iter_mut().zip(&self.lod_base) {
            *lod = lods[lane];
        }
        for (edge, rows) in triangle.edges.iter_mut().zip(&self.edges) {
            let [a, b, low, high] = rows[lane];
            *edge = Edge { a, b, c: i64::from(high) << 32 | i64::from(low as u32) };
        }
        let Narrow { c, dx, dy } = &mut triangle.narrow;
        for (i, to) in [c, dx, dy].into_iter().enumerate() {
            to[..4].copy_from_slice(&self.colors[i][lane]);
            to[Z] = self.depth[lane][i];
        }
        triangle.first = group(first);
        Some(triangle)
    }
}
