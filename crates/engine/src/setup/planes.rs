//! From registers to what the tiles iterate: edges and attribute planes in
//! screen coordinates.

use fillrate_simd::Level;

use super::extra::{BASE, Extra, ExtraNeeds, SPECULAR};
use super::launch::{GROUP, Launch, NARROW, Params, Z, wide_lane};
use crate::fixed::COORD_FRACTION;
use crate::kernel::texture::lod_base;
use crate::reused::Reused;
use crate::state::{MAX_TMUS, Origin, Rect};
use crate::target::STAMP;

/// A line of a triangle: a pixel is inside where `a * x + b * y + c >= 0`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Edge {
    pub a: i32,
    pub b: i32,
    pub c: i64,
}

impl Edge {
    /// The edge from `from` to `to` (12.4, rising y), pixels to its right
    /// inside (a centre on the line counts) or to its left (it does not).
    #[inline(always)]
    fn new(from: [i32; 2], to: [i32; 2], left: bool) -> Edge {
        let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
        let product = |a: i32, b: i32| i64::from(a) * i64::from(b);
        // (xs - px) * dy - (ys - py) * dx at centres xs = 16x + 8, ys = 16y + 8.
        let c = product(8 - from[0], dy) - product(8 - from[1], dx);
        // To its left all signs turn and c loses one: which side is a matter of
        // chance, so there is no branch.
        let turn = i32::from(left) - 1;
        let turned = |value: i32| (value ^ turn) - turn;
        Edge { a: turned(16 * dy), b: turned(-16 * dx), c: c ^ i64::from(turn) }
    }

    /// The same edge with rows counted from the other end.
    fn flip(self, height: u32) -> Edge {
        let last = i64::from(height) - 1;
        Edge { a: self.a, b: -self.b, c: self.c + last * i64::from(self.b) }
    }

    pub fn at(&self, x: i32, y: i32) -> i64 {
        i64::from(self.a) * i64::from(x) + i64::from(self.b) * i64::from(y) + self.c
    }
}

/// The 32-bit attributes: red, green, blue, alpha (12.12 in the top 24 bits)
/// and z (20.12). The value at screen pixel (x, y) is `c + x * dx + y * dy`,
/// wrapping.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Narrow {
    pub c: [i32; USED],
    pub dx: [i32; USED],
    pub dy: [i32; USED],
}

/// Lanes of them with a meaning.
pub(super) const USED: usize = Z + 1;

impl Narrow {
    fn new(params: &Params<[i32; NARROW]>) -> Narrow {
        let used = |lanes: &[i32; NARROW]| core::array::from_fn(|i| lanes[i]);
        Narrow { c: used(&params.start), dx: used(&params.dx), dy: used(&params.dy) }
    }

    /// One attribute at a pixel.
    #[inline(always)]
    pub fn value(&self, lane: usize, x: i32, y: i32) -> i32 {
        self.c[lane]
            .wrapping_add(self.dx[lane].wrapping_mul(x))
            .wrapping_add(self.dy[lane].wrapping_mul(y))
    }

    /// Whether red, green and blue are the same everywhere.
    #[inline(always)]
    pub fn has_one_color(&self) -> bool {
        let [r, g, b, ..] = self.dx;
        let [r_down, g_down, b_down, ..] = self.dy;
        r | g | b | r_down | g_down | b_down == 0
    }

    /// The least and the greatest value of an attribute between a pixel and the
    /// one so many columns to its right and rows below; right where nothing wraps
    /// between them.
    #[inline(always)]
    pub fn range(&self, lane: usize, [x, y]: [i32; 2], [right, down]: [i64; 2]) -> (i64, i64) {
        let corner = i64::from(self.value(lane, x, y));
        let (dx, dy) = (i64::from(self.dx[lane]) * right, i64::from(self.dy[lane]) * down);
        (corner + dx.min(0) + dy.min(0), corner + dx.max(0) + dy.max(0))
    }
}

/// A 64-bit attribute with 32 fraction bits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Plane64 {
    pub c: i64,
    pub dx: i64,
    pub dy: i64,
}

impl Plane64 {
    #[inline(always)]
    pub fn at(&self, x: i32, y: i32) -> i64 {
        self.c
            .wrapping_add(self.dx.wrapping_mul(i64::from(x)))
            .wrapping_add(self.dy.wrapping_mul(i64::from(y)))
    }
}

/// The same in floats that hold integers, so that sums are exact: see
/// [`Triangle::exact`]. The value at screen pixel (x, y) is `start + (x - x0) *
/// dx + (y - y0) * dy` from the triangle's [`Triangle::origin`] on.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct PlaneF {
    pub start: f64,
    pub dx: f64,
    pub dy: f64,
}

/// 64-bit attributes of a group: see [`Launch`].
#[derive(Clone, Copy, Debug)]
pub(super) struct WideGroup {
    c: [i64; GROUP],
    dx: [i64; GROUP],
    dy: [i64; GROUP],
}

impl WideGroup {
    #[inline(always)]
    fn plane(&self, lane: usize) -> Plane64 {
        Plane64 { c: self.c[lane], dx: self.dx[lane], dy: self.dy[lane] }
    }
}

/// The same of an exact triangle.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct ExactGroup {
    pub start: [f64; GROUP],
    pub dx: [f64; GROUP],
    pub dy: [f64; GROUP],
}

impl ExactGroup {
    #[inline(always)]
    fn plane(&self, lane: usize) -> PlaneF {
        PlaneF { start: self.start[lane], dx: self.dx[lane], dy: self.dy[lane] }
    }
}

impl PlaneF {
    /// The value at an [`offset`].
    #[inline(always)]
    pub fn at(&self, [x, y]: [f64; 2]) -> f64 {
        self.start + x * self.dx + y * self.dy
    }

    /// The same from the screen's first pixel on.
    #[inline(always)]
    fn integers(&self, (x, y): (i32, i32)) -> Plane64 {
        let (start, dx, dy) = (self.start as i64, self.dx as i64, self.dy as i64);
        let c = start.wrapping_sub(times(dx, x)).wrapping_sub(times(dy, y));
        Plane64 { c, dx, dy }
    }
}

/// A triangle ready for the tiles. Coordinates are screen pixels.
///
/// Four cache lines: half of them come from another core's cache.
#[derive(Clone, Debug, Default)]
#[repr(align(64))]
pub(crate) struct Triangle {
    /// Every covered pixel of the surface lies inside; not empty.
    pub bounds: Rect,
    /// Index of the pipeline in the batch.
    pub state: u32,
    /// Edges in use.
    pub edge_count: u8,
    /// Whether w, and s, t, w of the units in use, are small enough over the
    /// stamps of `bounds` to be iterated in floats exactly.
    pub exact: bool,
    /// Whether three edges alone tell its pixels, those beyond the screen's end
    /// included, and it is so small that 32 bits hold their values at and around
    /// its pixels.
    pub compact: bool,
    /// First of its groups of 64-bit planes in [`Triangles`]: of the exact after
    /// `first`, or of the others.
    pub(super) wide: u32,
    /// First of its groups of what states read besides.
    pub(super) extra: u32,
    /// Level of detail of each unit at w = 1, without bias.
    pub lod_base: [i32; MAX_TMUS],
    pub edges: [Edge; 3],
    /// Colours and z.
    pub narrow: Narrow,
    /// The first group of an exact triangle, or anything.
    pub(super) first: ExactGroup,
}

const _: () = assert!(size_of::<Triangle>() == 4 * 64);

impl Triangle {
    /// The first pixel of the first stamp that its bounds touch.
    #[inline(always)]
    pub fn origin(&self) -> (i32, i32) {
        let down = |v: u32| (v & !(STAMP - 1)) as i32;
        (down(self.bounds.x0), down(self.bounds.y0))
    }
}

/// From a triangle's [`Triangle::origin`] to a pixel.
#[inline(always)]
pub(crate) fn offset((x0, y0): (i32, i32), x: i32, y: i32) -> [f64; 2] {
    [f64::from(x - x0), f64::from(y - y0)]
}

/// Triangles ready for the tiles, with their 64-bit planes, a group for each
/// unit in use and at least one. The first of an exact triangle is its own.
#[derive(Debug, Default)]
pub(crate) struct Triangles {
    pub list: Reused<Triangle>,
    pub(super) exact: Vec<ExactGroup>,
    /// Of triangles that are not exact.
    wides: Vec<WideGroup>,
    /// What states read besides.
    pub(super) extras: Vec<WideGroup>,
}

/// How many triangles ahead memory is fetched to be written.
const WRITTEN_AHEAD: usize = 8;

impl Triangles {
    pub fn clear(&mut self) {
        self.list.clear();
        self.exact.clear();
        self.wides.clear();
        self.extras.clear();
    }

    /// A group of an exact triangle.
    #[inline(always)]
    fn exact_group<'a>(&'a self, triangle: &'a Triangle, group: usize) -> &'a ExactGroup {
        match group {
            0 => &triangle.first,
            _ => &self.exact[triangle.wide as usize + group - 1],
        }
    }

    #[inline(always)]
    fn plane(&self, triangle: &Triangle, group: usize, lane: usize) -> Plane64 {
        if triangle.exact {
            let group = self.exact_group(triangle, group);
            return group.plane(lane).integers(triangle.origin());
        }
        self.wides[triangle.wide as usize + group].plane(lane)
    }

    /// w of the pixel pipeline.
    #[inline(always)]
    pub fn w(&self, triangle: &Triangle) -> Plane64 {
        self.plane(triangle, 0, 0)
    }

    /// The same of an exact triangle.
    #[inline(always)]
    pub fn exact_w(&self, triangle: &Triangle) -> PlaneF {
        triangle.first.plane(0)
    }

    /// s, t and w of a unit in use.
    #[inline(always)]
    pub fn unit(&self, triangle: &Triangle, unit: usize) -> [Plane64; 3] {
        let first = wide_lane(unit, 0).1;
        let plane = |param| self.plane(triangle, unit, first + param);
        [plane(0), plane(1), plane(2)]
    }

    /// w of a unit in use.
    #[inline(always)]
    pub fn unit_w(&self, triangle: &Triangle, unit: usize) -> Plane64 {
        self.plane(triangle, unit, wide_lane(unit, 2).1)
    }

    /// s, t and w of a unit of an exact triangle.
    #[inline(always)]
    pub fn exact_unit(&self, triangle: &Triangle, unit: usize) -> [PlaneF; 3] {
        let group = self.exact_group(triangle, unit);
        let first = wide_lane(unit, 0).1;
        [group.plane(first), group.plane(first + 1), group.plane(first + 2)]
    }

    /// A colour of a triangle whose state reads it, 12.12 in the top 24 bits of
    /// the low halves; `lane` is [`SPECULAR`] or [`BASE`].
    #[inline(always)]
    pub fn extra_color(&self, triangle: &Triangle, lane: usize) -> [Plane64; 4] {
        let group = &self.extras[triangle.extra as usize + lane / GROUP];
        [group.plane(0), group.plane(1), group.plane(2), group.plane(3)]
    }

    /// Deep z of a triangle whose state reads it.
    #[inline(always)]
    pub fn deep_z(&self, triangle: &Triangle, needs: ExtraNeeds) -> Plane64 {
        let colors = if needs.colors { NARROW / GROUP } else { 0 };
        self.extras[triangle.extra as usize + colors].plane(0)
    }

    /// Tells the processor which memory is written soon: for the batch before, other
    /// cores have read half of it.
    #[inline(always)]
    pub(super) fn prefetch_next(&mut self, level: Level) {
        if let Some(place) = self.list.ahead(WRITTEN_AHEAD) {
            fillrate_simd::prefetch_write(level, place);
        }
        if let Some(place) = self.exact.spare_capacity_mut().get_mut(WRITTEN_AHEAD) {
            fillrate_simd::prefetch_write(level, place);
        }
    }

    /// Tells the processor that a triangle is needed soon.
    #[inline(always)]
    pub fn prefetch(&self, index: u32) {
        if let Some(triangle) = self.list.get(index as usize) {
            fillrate_simd::prefetch(triangle);
        }
    }

    /// The same of its planes besides the first, once the triangle itself is there.
    #[inline(always)]
    pub fn prefetch_planes(&self, index: u32) {
        let Some(triangle) = self.list.get(index as usize) else { return };
        if let Some(group) = self.exact.get(triangle.wide as usize) {
            fillrate_simd::prefetch(group);
        }
    }
}

/// Coordinates of a compact triangle span less.
pub(super) const COMPACT: i32 = 256 << COORD_FRACTION;

/// How far 32-bit parameters are shifted left: colours go to the top 24 bits.
pub(super) const SHIFTS: [u32; NARROW] = [8, 8, 8, 8, 0, 0, 0, 0];

/// Where a triangle is drawn.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Screen {
    pub width: u32,
    pub height: u32,
    pub origin: Origin,
    /// Surface pixels of a pixel that coordinates count, 1 to [`MAX_SCALE`].
    pub scale: u32,
}

/// The largest scale: the products of an edge still fit.
pub const MAX_SCALE: u32 = 4;

/// Limits below which f64 iteration and division are exact: s and t are
/// multiplied by 256 and must stay below 2^53, w keeps to the 48 bits it has.
pub(super) const COORDINATE_LIMIT: f64 = (1u64 << 44) as f64;
pub(super) const W_LIMIT: f64 = (1u64 << 46) as f64;
/// The limits of a group's lanes. The lane without meaning has none.
const FIRST_LIMITS: [f64; GROUP] = [W_LIMIT, COORDINATE_LIMIT, COORDINATE_LIMIT, W_LIMIT];
const OTHER_LIMITS: [f64; GROUP] = [COORDINATE_LIMIT, COORDINATE_LIMIT, W_LIMIT, f64::INFINITY];
/// Where only w counts.
const W_LIMITS: [f64; GROUP] = [W_LIMIT, f64::INFINITY, f64::INFINITY, f64::INFINITY];
/// Sums of integers below it in magnitude are exact in floats, and so are
/// conversions from and to integers by adding [`TO_INTEGER`].
pub(super) const EXACT_LIMIT: f64 = (1u64 << 50) as f64;
/// A float whose mantissa's last bit is one: that of a sum with it is an integer.
const TO_INTEGER: f64 = (3u64 << 51) as f64;

/// Converts a launched triangle and appends it to `out`; `None` where it covers
/// no pixel of the screen. `units` is how many texture units iterate, `groups` how
/// many groups of 64-bit parameters have values, as many or one more; without any
/// all are zero.
#[inline(always)]
pub(crate) fn prepare<'a>(
    launch: &Launch,
    screen: &Screen,
    state: u32,
    [units, groups]: [usize; 2],
    out: &'a mut Triangles,
) -> Option<&'a Triangle> {
    let bounds = bounds(launch, screen)?;
    let planes = Corrected::new(launch, screen, &bounds);
    let (mut wide, mut exact) = (out.exact.len(), true);
    let mut own = ExactGroup::default();
    let mut lods = [0; MAX_TMUS];
    for (unit, params) in launch.wide.iter().enumerate().take(groups) {
        let limits = match (unit, units) {
            (_, 0) => &W_LIMITS,
            (0, _) => &FIRST_LIMITS,
            _ => &OTHER_LIMITS,
        };
        let (group, fits) = planes.exact(&params.floats, limits);
        exact &= fits;
        if unit < units {
            let first = wide_lane(unit, 0).1;
            lods[unit] = level_of_detail(&group.plane(first), &group.plane(first + 1));
        }
        match unit {
            0 => own = group,
            _ => out.exact.push(group),
        }
    }
    if !exact {
        out.exact.truncate(wide);
        wide = out.wides.len();
        large_planes(launch, &planes, units, &mut lods, &mut out.wides);
    }
    let wide = wide as u32;
    let (edges, edge_count, compact) = edges(launch, screen, &bounds);
    let triangle = out.list.add();
    *triangle = Triangle {
        bounds,
        state,
        edge_count,
        exact,
        compact,
        wide,
        extra: out.extras.len() as u32,
        lod_base: lods,
        edges,
        narrow: Narrow::new(&planes.narrow(&launch.narrow)),
        first: own,
    };
    Some(triangle)
}

/// The level of detail at w = 1 of the planes of s and t.
#[inline(always)]
fn level_of_detail(s: &PlaneF, t: &PlaneF) -> i32 {
    lod_base(s.dx * s.dx + t.dx * t.dx, s.dy * s.dy + t.dy * t.dy)
}

/// The planes of a triangle that floats do not hold.
#[cold]
fn large_planes(
    launch: &Launch,
    planes: &Corrected,
    units: usize,
    lods: &mut [i32; MAX_TMUS],
    out: &mut Vec<WideGroup>,
) {
    for (unit, params) in launch.wide.iter().enumerate().take(units.max(1)) {
        let group = planes.wide(&params.integers());
        if unit < units {
            let first = wide_lane(unit, 0).1;
            let steps = [first, first + 1].map(|lane| {
                let Plane64 { dx, dy, .. } = group.plane(lane);
                PlaneF { start: 0.0, dx: dx as f64, dy: dy as f64 }
            });
            lods[unit] = level_of_detail(&steps[0], &steps[1]);
        }
        out.push(group);
    }
}

/// Appends the parameters that a state reads besides to the planes of the
/// triangle prepared last.
pub(crate) fn prepare_extra(
    extra: &Extra,
    launch: &Launch,
    screen: &Screen,
    needs: ExtraNeeds,
    out: &mut Triangles,
) {
    let Some(triangle) = out.list.last() else { return };
    let planes = Corrected::new(launch, screen, &triangle.bounds);
    if needs.colors {
        let narrow = planes.narrow(&extra.colors);
        out.extras.push(color_group(&narrow, SPECULAR, 0));
        // The lanes that hold no colour of a launch are not in the top bits.
        out.extras.push(color_group(&narrow, BASE, 8));
    }
    if needs.deep_z {
        out.extras.push(planes.wide(&extra.deep_z));
    }
}

/// Four 32-bit parameters as a group.
fn color_group(narrow: &Params<[i32; NARROW]>, first: usize, shift: u32) -> WideGroup {
    let lanes = |from: &[i32; NARROW]| {
        core::array::from_fn(|i| i64::from(from[first + i].wrapping_shl(shift)))
    };
    WideGroup { c: lanes(&narrow.start), dx: lanes(&narrow.dx), dy: lanes(&narrow.dy) }
}

/// A triangle's edges, how many are in use, and [`Triangle::compact`].
#[inline(always)]
fn edges(launch: &Launch, screen: &Screen, bounds: &Rect) -> ([Edge; 3], u8, bool) {
    let [a, b, c] = core::array::from_fn(|i| [launch.x[i], launch.y[i]]);
    let compact = is_compact(launch) && ends_at_stamps(bounds, screen);
    // B left of A-C: A-C is the right edge, A-B and B-C are left ones.
    let minor_is_left = launch.negative;
    let edge = |from: [i32; 2], to: [i32; 2], left: bool| {
        let edge = Edge::new(from, to, left);
        if screen.origin == Origin::LowerLeft { edge.flip(screen.height) } else { edge }
    };
    let all = [edge(a, c, !minor_is_left), edge(a, b, minor_is_left), edge(b, c, minor_is_left)];
    let rises = [a[1] < c[1], a[1] < b[1], b[1] < c[1]];
    if rises == [true; 3] {
        return (all, 3, compact);
    }
    let (mut edges, mut count) = ([Edge::default(); 3], 0);
    for (edge, _) in all.into_iter().zip(rises).filter(|(_, rises)| *rises) {
        edges[count] = edge;
        count += 1;
    }
    if compact && count == 2 {
        edges[2] = level_edge(bounds, (a[1] == b[1]) == (screen.origin == Origin::UpperLeft));
        count = 3;
    }
    (edges, count as u8, compact && count == 3)
}

/// A level side: the bounds' first or last row.
fn level_edge(bounds: &Rect, first: bool) -> Edge {
    match first {
        true => Edge { a: 0, b: 1, c: -i64::from(bounds.y0) },
        false => Edge { a: 0, b: -1, c: i64::from(bounds.y1) - 1 },
    }
}

/// Whether a triangle fits in 256 pixels each way, and its corners' order and
/// the sign of its area are as they should be: registers can say anything.
#[inline(always)]
fn is_compact(launch: &Launch) -> bool {
    let ([ax, bx, cx], [ay, by, cy]) = (launch.x, launch.y);
    let width = ax.max(bx).max(cx) - ax.min(bx).min(cx);
    let small = width.max(cy - ay) < COMPACT;
    let sorted = ay <= by && by <= cy;
    // Below 2^13 each, where it counts.
    let area = (bx - ax).wrapping_mul(cy - ay).wrapping_sub((cx - ax).wrapping_mul(by - ay));
    small & sorted & ((area < 0) == launch.negative)
}

/// Whether no stamp that bounds touch reaches beyond the screen.
#[inline(always)]
fn ends_at_stamps(bounds: &Rect, screen: &Screen) -> bool {
    let inside = |end: u32, size: u32| (end + STAMP - 1) & !(STAMP - 1) <= size;
    inside(bounds.x1, screen.width) && inside(bounds.y1, screen.height)
}

/// The part of the screen that can be covered, or `None`.
#[inline(always)]
fn bounds(launch: &Launch, screen: &Screen) -> Option<Rect> {
    let [ay, _, cy] = launch.y;
    let rows = [(ay + 7) >> COORD_FRACTION, (cy + 7) >> COORD_FRACTION];
    let [ax, bx, cx] = launch.x;
    let (left, right) = (ax.min(bx).min(cx), ax.max(bx).max(cx));
    let columns = [(left + 7) >> COORD_FRACTION, (right + 7) >> COORD_FRACTION];
    let limit =
        |[from, to]: [i32; 2], size: u32| [from.clamp(0, size as i32), to.clamp(0, size as i32)];
    let [x0, x1] = limit(columns, screen.width);
    let height = screen.height as i32;
    let [y0, y1] = match screen.origin {
        Origin::UpperLeft => limit(rows, screen.height),
        Origin::LowerLeft => limit([height - rows[1], height - rows[0]], screen.height),
    };
    (x0 < x1 && y0 < y1).then(|| Rect::new(x0 as u32, y0 as u32, x1 as u32, y1 as u32))
}

/// The sub-pixel correction, the reference pixel of a launch, and the area
/// where values are needed.
struct Corrected {
    /// Sixteenths from the first vertex to its pixel's centre.
    dx: i32,
    dy: i32,
    /// The first vertex's pixel, on the screen.
    x: i32,
    y: i32,
    /// -1 where rows are counted from the other end, else 1.
    row_sign: i32,
    /// From that pixel to the first pixel of the area's first stamp, and from
    /// there to the last pixel of its last stamp.
    origin: [f64; 2],
    reach: [f64; 2],
}

impl Corrected {
    #[inline(always)]
    fn new(launch: &Launch, screen: &Screen, bounds: &Rect) -> Corrected {
        let (vx, vy) = (launch.x[0], launch.y[0]);
        let row = vy >> COORD_FRACTION;
        let flipped = screen.origin == Origin::LowerLeft;
        let x = vx >> COORD_FRACTION;
        let y = if flipped { screen.height as i32 - 1 - row } else { row };
        // Whole stamps are iterated.
        let down = |v: u32| (v & !(STAMP - 1)) as i32;
        let [x0, y0] = [down(bounds.x0), down(bounds.y0)];
        let [x1, y1] = [bounds.x1, bounds.y1].map(|v| down(v + STAMP - 1) - 1);
        Corrected {
            dx: 8 - (vx & 15),
            dy: 8 - (vy & 15),
            x,
            y,
            row_sign: if flipped { -1 } else { 1 },
            origin: [f64::from(x0 - x), f64::from(y0 - y)],
            reach: [f64::from(x1 - x0), f64::from(y1 - y0)],
        }
    }

    #[inline(always)]
    fn narrow(&self, params: &Params<[i32; NARROW]>) -> Params<[i32; NARROW]> {
        let mut out = Params::<[i32; NARROW]>::default();
        #[allow(clippy::needless_range_loop, reason = "one lane of six arrays")]
        for lane in 0..NARROW {
            let (dx, dy) = (params.dx[lane], params.dy[lane]);
            let moved =
                dx.wrapping_mul(self.dx).wrapping_add(dy.wrapping_mul(self.dy)) >> COORD_FRACTION;
            let dy = dy.wrapping_mul(self.row_sign);
            let c = params.start[lane]
                .wrapping_add(moved)
                .wrapping_sub(dx.wrapping_mul(self.x))
                .wrapping_sub(dy.wrapping_mul(self.y));
            out.start[lane] = c << SHIFTS[lane];
            out.dx[lane] = dx << SHIFTS[lane];
            out.dy[lane] = dy << SHIFTS[lane];
        }
        out
    }

    /// The planes as floats, and whether these are exact and stay below their
    /// limits over the area; where a lane has no limit it does not count.
    #[inline(always)]
    fn exact(&self, params: &Params<[f64; GROUP]>, limits: &[f64; GROUP]) -> (ExactGroup, bool) {
        let (from_x, from_y) = (f64::from(self.dx), f64::from(self.dy));
        let ([ox, oy], [rx, ry]) = (self.origin, self.reach);
        let row_sign = f64::from(self.row_sign);
        let mut out = ExactGroup { start: [0.0; GROUP], dx: [0.0; GROUP], dy: [0.0; GROUP] };
        let mut fits = [false; GROUP];
        #[allow(clippy::needless_range_loop, reason = "one lane of eight arrays")]
        for lane in 0..GROUP {
            let (start, dx, dy) = (params.start[lane], params.dx[lane], params.dy[lane]);
            let sixteenths = dx * from_x + dy * from_y;
            let dy = dy * row_sign;
            let (across, down) = (dx * ox, dy * oy);
            let corner = start + floor(sixteenths * (1.0 / 16.0)) + across + down;
            // Nothing on the way may have been rounded. Not-a-number does not pass.
            let largest = start.abs() + 16.0 * (dx.abs() + dy.abs()) + across.abs() + down.abs();
            let value = corner.abs() + (dx * rx).abs() + (dy * ry).abs();
            let within = (largest < EXACT_LIMIT) & (value < limits[lane]);
            fits[lane] = within | (limits[lane] == f64::INFINITY);
            (out.start[lane], out.dx[lane], out.dy[lane]) = (corner, dx, dy);
        }
        (out, fits == [true; GROUP])
    }

    /// The planes as integers.
    fn wide(&self, params: &Params<[i64; GROUP]>) -> WideGroup {
        let mut out = WideGroup { c: [0; GROUP], dx: [0; GROUP], dy: [0; GROUP] };
        for lane in 0..GROUP {
            let (start, dx, dy) = (params.start[lane], params.dx[lane], params.dy[lane]);
            let moved = times(dx, self.dx).wrapping_add(times(dy, self.dy)) >> COORD_FRACTION;
            let dy = times(dy, self.row_sign);
            out.c[lane] = start
                .wrapping_add(moved)
                .wrapping_sub(times(dx, self.x))
                .wrapping_sub(times(dy, self.y));
            out.dx[lane] = dx;
            out.dy[lane] = dy;
        }
        out
    }
}

/// The greatest integer that is not above `value`, for values below 2^51 in
/// magnitude.
#[inline(always)]
fn floor(value: f64) -> f64 {
    let nearest = (value + TO_INTEGER) - TO_INTEGER;
    if nearest > value { nearest - 1.0 } else { nearest }
}

#[inline(always)]
fn times(value: i64, factor: i32) -> i64 {
    value.wrapping_mul(i64::from(factor))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::setup::{Param, Registers};

    const SCREEN: Screen = Screen { width: 64, height: 64, origin: Origin::UpperLeft, scale: 1 };

    fn right_triangle() -> Registers {
        // (8.5, 8.5), (16.5, 8.5), (16.5, 16.5): the centres on the left edge
        // are in, on the right edge out.
        Registers {
            x: [136, 264, 264],
            y: [136, 136, 264],
            color: [Param { start: 7 << 12, dx: 16 << 12, dy: 0 }; 4],
            ..Registers::default()
        }
    }

    fn prepared(screen: &Screen) -> Triangle {
        let mut triangles = Triangles::default();
        prepare(&Launch::from(&right_triangle()), screen, 0, [0, 1], &mut triangles)
            .unwrap()
            .clone()
    }

    fn covered(triangle: &Triangle) -> u32 {
        let inside = |x: u32, y: u32| {
            triangle.edges[..triangle.edge_count as usize]
                .iter()
                .all(|edge| edge.at(x as i32, y as i32) >= 0)
        };
        let b = triangle.bounds;
        (b.y0..b.y1).map(|y| (b.x0..b.x1).filter(|&x| inside(x, y)).count() as u32).sum()
    }

    #[test]
    fn top_left_rule() {
        let triangle = prepared(&SCREEN);
        assert_eq!(triangle.bounds, Rect::new(8, 8, 16, 16));
        assert_eq!(covered(&triangle), 8 + 7 + 6 + 5 + 4 + 3 + 2 + 1);
    }

    #[test]
    fn planes_pass_through_the_first_vertex() {
        let triangle = prepared(&SCREEN);
        assert_eq!(triangle.narrow.value(0, 8, 8), 7 << 20);
        assert_eq!(triangle.narrow.value(0, 9, 30), (7 + 16) << 20);
    }

    #[test]
    fn lower_left_mirrors_rows() {
        let screen = Screen { origin: Origin::LowerLeft, ..SCREEN };
        let triangle = prepared(&screen);
        assert_eq!(triangle.bounds, Rect::new(8, 48, 16, 56));
        assert_eq!(covered(&triangle), 36);
        assert!(triangle.edges[0].at(8, 55) >= 0 && triangle.edges[0].at(8, 54) < 0);
    }
}
