//! Set-up of the Raw profile: edges and attribute planes in single precision.
//!
//! The value of a plane is what additions make of it: down the rows from the
//! first one, then along the row from the first column, each sum rounded. So
//! set-up keeps the value that each row of tiles begins with, and a tile makes
//! the same additions from there; no value is ever computed another way.
//!
//! Source: RAW, rasterisation.

use crate::state::{RawAlpha, RawDraw, RawQuirks, RawState, Rect};

/// Attributes that vertices carry, in order: red, green, blue, alpha, u, v,
/// intensity, 1/w, and two colours of further light.
pub(crate) const ATTRIBUTES: usize = 14;
const ALPHA: usize = 3;
const UV: usize = 4;
const INTENSITY: usize = 6;
const W1: usize = 7;
const MORE: usize = 8;

/// A corner of a primitive of the Raw profile, after the divide by w. What is
/// interpolated is already times 1/w.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RawVertex {
    /// -1..1 across the target.
    pub x: f32,
    /// -1..1 down the target.
    pub y: f32,
    /// -1 near to 1 far.
    pub z: f32,
    /// 1/w.
    pub w1: f32,
    /// Texture column over w; 1 is one repeat.
    pub u: f32,
    /// Texture row over w.
    pub v: f32,
    /// Red, green, blue and alpha over w, 0..=255 times that.
    pub rgba: [f32; 4],
    /// Intensity of the direct light over w.
    pub intensity: f32,
    /// Further light over w: what falls on the surface, then highlights; red,
    /// green, blue each.
    pub more: [f32; 6],
}

impl RawVertex {
    fn attributes(&self) -> [f32; ATTRIBUTES] {
        let [r, g, b, a] = self.rgba;
        let [d0, d1, d2, s0, s1, s2] = self.more;
        [r, g, b, a, self.u, self.v, self.intensity, self.w1, d0, d1, d2, s0, s1, s2]
    }
}

/// Something to draw with the Raw profile.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RawPrimitive {
    /// A triangle, clockwise on the screen; the other way round it covers
    /// nothing.
    Triangle([RawVertex; 3]),
    /// A pixel for each step along the longer axis; the second end is left out.
    Line([RawVertex; 2]),
    /// A square around a corner.
    Point {
        /// Its middle.
        at: RawVertex,
        /// Its side in pixels.
        size: u32,
    },
}

/// Which attributes a state interpolates. Those have a slot each, in the order
/// of the attributes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Slots {
    pub count: usize,
    attribute: [u8; ATTRIBUTES],
    slot: [u8; ATTRIBUTES],
}

impl Slots {
    pub fn of(draw: &RawDraw) -> Slots {
        let state = &draw.state;
        let color = state.combine.uses_color() && state.smooth_color;
        let alpha = color && state.color_alpha != RawAlpha::Opaque;
        let uv = draw.read_texture().is_some();
        let intensity = state.light.is_some_and(|l| l.smooth && l.direct.is_some());
        let more = state.light.is_some_and(|l| l.more);
        let mut slots = Slots { count: 0, attribute: [0; ATTRIBUTES], slot: [u8::MAX; ATTRIBUTES] };
        for i in 0..ATTRIBUTES {
            let used = match i {
                0..ALPHA => color,
                ALPHA => alpha,
                UV..INTENSITY => uv,
                INTENSITY => intensity,
                W1 => color || uv || intensity || more,
                _ => more,
            };
            if used {
                slots.attribute[slots.count] = i as u8;
                slots.slot[i] = slots.count as u8;
                slots.count += 1;
            }
        }
        slots
    }

    fn get(&self, attribute: usize) -> Option<usize> {
        let slot = usize::from(self.slot[attribute]);
        (slot < ATTRIBUTES).then_some(slot)
    }

    /// Of red, where colours are interpolated; green and blue follow.
    pub fn red(&self) -> Option<usize> {
        self.get(0)
    }

    pub fn alpha(&self) -> Option<usize> {
        self.get(ALPHA)
    }

    /// Of u; v follows.
    pub fn u(&self) -> Option<usize> {
        self.get(UV)
    }

    pub fn intensity(&self) -> Option<usize> {
        self.get(INTENSITY)
    }

    pub fn w1(&self) -> Option<usize> {
        self.get(W1)
    }

    /// Of the first channel of further light; five follow.
    pub fn more(&self) -> Option<usize> {
        self.get(MORE)
    }

    /// Attributes in the order of their slots.
    fn pick(&self, attributes: &[f32; ATTRIBUTES]) -> [f32; ATTRIBUTES] {
        core::array::from_fn(|i| match i < self.count {
            true => attributes[usize::from(self.attribute[i])],
            false => 0.0,
        })
    }
}

/// Edges and planes of a triangle.
#[derive(Clone, Debug)]
pub(crate) struct Walk {
    /// An edge's pixels have values below this.
    pub limit: [f32; 3],
    /// Steps of the edges from column to column.
    pub edge_dx: [f32; 3],
    /// From row to row.
    pub edge_dy: [f32; 3],
    /// Steps of the slots from column to column.
    pub dx: [f32; ATTRIBUTES],
    /// From row to row.
    pub dy: [f32; ATTRIBUTES],
    /// Depth for each column, for each row, and the rest.
    pub z: [f32; 3],
    /// First of its numbers in the chunk's list: the edges, then the slots, at
    /// the first row and at the first row of each further row of tiles.
    pub rows: u32,
    /// The edges at the first pixel.
    edge_start: [f32; 3],
}

impl Walk {
    /// Whether an edge leaves out all of a tile. Never true where a pixel of it
    /// is covered: as many sums as there are steps are off by half a unit of
    /// the greatest value each, and twice that is allowed for.
    pub fn misses(&self, bounds: &Rect, tile: &Rect) -> bool {
        let area = bounds.intersect(tile);
        let (left, top) = (f64::from(bounds.x0), f64::from(bounds.y0));
        let size = [f64::from(bounds.x1) - left, f64::from(bounds.y1) - top];
        (0..3).any(|i| {
            let [start, dx, dy] =
                [self.edge_start[i], self.edge_dx[i], self.edge_dy[i]].map(f64::from);
            let x = if dx > 0.0 { area.x0 } else { area.x1 - 1 };
            let y = if dy > 0.0 { area.y0 } else { area.y1 - 1 };
            let least = start + dx * (f64::from(x) - left) + dy * (f64::from(y) - top);
            let greatest = start.abs() + dx.abs() * size[0] + dy.abs() * size[1];
            least > greatest * (size[0] + size[1]) * f64::from(f32::EPSILON)
        })
    }
}

/// Steps of a line.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Steps {
    /// Whether x is the longer axis.
    pub along_x: bool,
    /// Where it begins along the longer axis, in pixels, and how far it goes.
    pub start: f32,
    pub length: f32,
    /// The same along the other axis.
    pub side: [f32; 2],
}

impl Steps {
    /// How far along the line a pixel of the longer axis is, 0 to 1.
    pub fn t(&self, main: u32) -> f32 {
        (main as i32 as f32 + 0.5 - self.start) / self.length
    }

    /// The pixel of the other axis there.
    pub fn side_at(&self, main: u32) -> i32 {
        (self.side[0] + self.t(main) * self.side[1]).floor() as i32
    }
}

/// How the values of a shape's pixels are found.
#[derive(Clone, Debug)]
pub(crate) enum Values {
    /// By walking edges and planes.
    Walk(Walk),
    /// By mixing the values of two ends: the slots, then the depth.
    Mix { steps: Option<Steps>, ends: [[f32; ATTRIBUTES + 1]; 2] },
}

/// A primitive ready for the tiles.
#[derive(Clone, Debug)]
pub(crate) struct RawShape {
    /// Index of its state in the arena.
    pub state: u32,
    /// The part of the screen that can be covered; not empty.
    pub bounds: Rect,
    /// The vertices' average colour.
    pub color: u32,
    /// The vertices' average intensity.
    pub intensity: f32,
    pub values: Values,
}

/// Sets a primitive up; `None` where it covers nothing of `screen`. `rows`
/// takes what a walk begins the rows of tiles of `side` with.
pub(crate) fn prepare_raw(
    primitive: &RawPrimitive,
    draw: &RawDraw,
    state: u32,
    screen: &Rect,
    side: u32,
    rows: &mut Vec<f32>,
) -> Option<RawShape> {
    let slots = Slots::of(draw);
    let (bounds, values, flat) = match primitive {
        RawPrimitive::Triangle(corners) => {
            let (bounds, walk) = triangle(corners, draw, &slots, screen, side, rows)?;
            (bounds, Values::Walk(walk), Flat::of(corners, &draw.state))
        }
        RawPrimitive::Line(ends) => {
            let (bounds, steps) = line(ends, screen)?;
            let ends_at = ends.map(|end| mixed_values(&end, &slots));
            let values = Values::Mix { steps: Some(steps), ends: ends_at };
            (bounds, values, Flat::of(ends, &draw.state))
        }
        RawPrimitive::Point { at, size } => {
            let values = Values::Mix { steps: None, ends: [mixed_values(at, &slots); 2] };
            (square(at, *size, screen)?, values, Flat::of(&[*at], &draw.state))
        }
    };
    Some(RawShape { state, bounds, color: flat.color, intensity: flat.intensity, values })
}

/// Where a vertex lies on the screen, in pixels.
fn place(v: &RawVertex, screen: &Rect) -> [f32; 2] {
    let (w, h) = (screen.x1 as f32, screen.y1 as f32);
    [v.x * (w / 2.0) + w / 2.0, v.y * (h / 2.0) + h / 2.0]
}

fn mixed_values(v: &RawVertex, slots: &Slots) -> [f32; ATTRIBUTES + 1] {
    let mut values = [0.0; ATTRIBUTES + 1];
    values[..ATTRIBUTES].copy_from_slice(&slots.pick(&v.attributes()));
    values[ATTRIBUTES] = v.z;
    values
}

/// What is not interpolated: averages over the vertices, undivided by w.
#[derive(Clone, Copy, Default)]
struct Flat {
    color: u32,
    intensity: f32,
}

impl Flat {
    fn of(corners: &[RawVertex], state: &RawState) -> Flat {
        let average = |f: &dyn Fn(&RawVertex) -> f32| {
            let sum = corners.iter().map(|v| f(v) * (1.0 / v.w1)).reduce(|a, b| a + b);
            sum.unwrap_or(0.0) / corners.len() as f32
        };
        let mut flat = Flat::default();
        if state.combine.uses_color() && !state.smooth_color {
            let byte = |i: usize| byte(average(&|v| v.rgba[i]), &state.quirks);
            let alpha = if state.color_alpha == RawAlpha::Opaque { 0 } else { byte(3) };
            flat.color = byte(0) << 24 | byte(1) << 16 | byte(2) << 8 | alpha;
        }
        if state.light.is_some_and(|l| l.direct.is_some() && !l.smooth) {
            flat.intensity = average(&|v| v.intensity);
        }
        flat
    }
}

/// A channel rounded to a byte.
fn byte(value: f32, quirks: &RawQuirks) -> u32 {
    let rounded = (value + 0.5) as i32;
    if quirks.channels_wrap { rounded as u32 & 0xff } else { rounded.clamp(0, 255) as u32 }
}

#[inline(always)]
fn triangle(
    corners: &[RawVertex; 3],
    draw: &RawDraw,
    slots: &Slots,
    screen: &Rect,
    side: u32,
    rows: &mut Vec<f32>,
) -> Option<(Rect, Walk)> {
    let quirks = &draw.state.quirks;
    let places = corners.each_ref().map(|v| place(v, screen));
    let (x, y) = (places.map(|p| p[0]), places.map(|p| p[1]));
    let (columns, lines) = (axis(x, screen.x1, quirks)?, axis(y, screen.y1, quirks)?);
    let bounds = Rect::new(columns[0], lines[0], columns[1] + 1, lines[1] + 1);
    let start = [columns[0] as f32 + 0.5, lines[0] as f32 + 0.5];
    let solver = Solver::new(x, y);
    let attributes = corners.each_ref().map(|v| slots.pick(&v.attributes()));
    let mut walk = Walk {
        limit: limits(x, y, quirks),
        edge_dx: [0.0; 3],
        edge_dy: [0.0; 3],
        dx: [0.0; ATTRIBUTES],
        dy: [0.0; ATTRIBUTES],
        z: [0.0; 3],
        rows: rows.len() as u32,
        edge_start: [0.0; 3],
    };
    if draw.state.uses_depth() {
        walk.z = solver.plane(corners.each_ref().map(|v| v.z));
    }
    let mut first = Row::default();
    for (i, (a, b)) in SIDES.into_iter().enumerate() {
        let (dx, dy) = (y[b] - y[a], x[a] - x[b]);
        let value = dx * start[0] + dy * start[1] + (y[a] * x[b] - y[b] * x[a]);
        (walk.edge_dx[i], walk.edge_dy[i], walk.edge_start[i]) = (dx, dy, value);
        (first.value[i], first.step[i]) = (value, dy);
    }
    for i in 0..slots.count {
        let [dx, dy, c] = solver.plane(attributes.each_ref().map(|values| values[i]));
        (walk.dx[i], walk.dy[i]) = (dx, dy);
        first.value[3 + i] = dx * start[0] + dy * start[1] + c;
        first.step[3 + i] = dy;
    }
    first.rows_of_tiles(&bounds, side, 3 + slots.count, rows);
    Some((bounds, walk))
}

/// The corners of each side.
const SIDES: [(usize, usize); 3] = [(0, 1), (1, 2), (2, 0)];

/// Edges and slots at the first column of a row.
#[derive(Default)]
struct Row {
    value: [f32; 20],
    step: [f32; 20],
}

impl Row {
    /// Appends the first `count` values at the first row of `bounds` in each
    /// row of tiles.
    #[inline(always)]
    fn rows_of_tiles(mut self, bounds: &Rect, side: u32, count: usize, to: &mut Vec<f32>) {
        to.extend_from_slice(&self.value[..count]);
        let last = (bounds.y1 - 1) & !(side - 1);
        for y in bounds.y0 + 1..=last {
            for (value, step) in self.value.iter_mut().zip(&self.step) {
                *value += step;
            }
            if y & (side - 1) == 0 {
                to.extend_from_slice(&self.value[..count]);
            }
        }
    }
}

/// The first and the last pixel that a triangle may cover along an axis of
/// `size` pixels.
fn axis(c: [f32; 3], size: u32, quirks: &RawQuirks) -> Option<[u32; 2]> {
    let last = size as i32 - 1;
    let first = |v: f32| match quirks.box_skips_exact_centre {
        true => (v + 0.5) as i32,
        false => (v - 0.5).ceil() as i32,
    };
    let end = |v: f32| match quirks.box_clamp_moves {
        true => (v - 0.5) as i32,
        false => (v - 0.5).floor() as i32,
    };
    let low = c.map(first).into_iter().min().unwrap_or(0);
    let high = c.map(end).into_iter().max().unwrap_or(0).min(last);
    let (low, high) = match quirks.box_clamp_moves {
        true if high < 0 => (0, 0),
        true if low > last => (last, last),
        _ => (low.max(0), high),
    };
    (low <= high).then_some([low as u32, high as u32])
}

/// What the values of each edge are below inside. An edge's own pixels count
/// where the limit is not 0 but the least number above.
fn limits(x: [f32; 3], y: [f32; 3], quirks: &RawQuirks) -> [f32; 3] {
    SIDES.map(|(a, b)| {
        let (right, down) = (x[b] - x[a], y[b] - y[a]);
        // Clockwise with y down: a top edge runs right and level, a left edge
        // runs up.
        let own = !quirks.top_left_rule || down < 0.0 || (down == 0.0 && right > 0.0);
        if own { f32::from_bits(1) } else { 0.0 }
    })
}

/// The solver of planes: all that does not depend on the attribute.
struct Solver {
    x: [f32; 3],
    y: [f32; 3],
    me: f32,
    d: f32,
}

impl Solver {
    fn new(x: [f32; 3], y: [f32; 3]) -> Solver {
        let me = x[1] * y[2] - x[2] * y[1];
        let d = 1.0 / (x[0] * (y[1] - y[2]) - y[0] * (x[1] - x[2]) + me);
        Solver { x, y, me, d }
    }

    /// The plane through three values: for each column, for each row, and the
    /// rest.
    fn plane(&self, p: [f32; 3]) -> [f32; 3] {
        let (x, y) = (&self.x, &self.y);
        let b1 = p[1] * y[2] - p[2] * y[1];
        let b2 = x[1] * p[2] - x[2] * p[1];
        let dx = self.d * (p[0] * (y[1] - y[2]) - y[0] * (p[1] - p[2]) + b1);
        let dy = self.d * (x[0] * (p[1] - p[2]) - p[0] * (x[1] - x[2]) + b2);
        let c = self.d * (p[0] * self.me - x[0] * b1 - y[0] * b2);
        [dx, dy, c]
    }
}

fn line(ends: &[RawVertex; 2], screen: &Rect) -> Option<(Rect, Steps)> {
    let [a, b] = ends.each_ref().map(|v| place(v, screen));
    let along_x = (b[0] - a[0]).abs() >= (b[1] - a[1]).abs();
    let (main, side) = if along_x { (0, 1) } else { (1, 0) };
    let sizes = [screen.x1 as i32, screen.y1 as i32];
    // Pixel centres between the ends, whichever way the line runs.
    let (low, high) = if a[main] <= b[main] {
        let last = (b[main] - 0.5).ceil() as i32;
        ((a[main] - 0.5).ceil() as i32, last.saturating_sub(1))
    } else {
        let first = (b[main] - 0.5).floor() as i32;
        (first.saturating_add(1), (a[main] - 0.5).floor() as i32)
    };
    let (low, high) = (low.max(0), high.min(sizes[main] - 1));
    if low > high {
        return None;
    }
    let steps = Steps {
        along_x,
        start: a[main],
        length: b[main] - a[main],
        side: [a[side], b[side] - a[side]],
    };
    let (low, high) = (low as u32, high as u32 + 1);
    let [side0, side1] = side_range(&steps, [low, high], sizes[side] as u32)?;
    let bounds = match along_x {
        true => Rect::new(low, side0, high, side1),
        false => Rect::new(side0, low, side1, high),
    };
    Some((bounds, steps))
}

/// The pixels of the other axis that a part of a line reaches, the last
/// excluded. Rounded sums and products do not turn back, so the ends of the
/// part decide, unless a number is not finite.
pub(crate) fn side_range(steps: &Steps, [low, high]: [u32; 2], size: u32) -> Option<[u32; 2]> {
    let numbers = [steps.start, steps.length, steps.side[0], steps.side[1]];
    if !numbers.iter().all(|n| n.is_finite()) {
        return Some([0, size]);
    }
    let (a, b) = (steps.side_at(low), steps.side_at(high - 1));
    let first = a.min(b).clamp(0, size as i32) as u32;
    let end = a.max(b).saturating_add(1).clamp(0, size as i32) as u32;
    (first < end).then_some([first, end])
}

fn square(at: &RawVertex, size: u32, screen: &Rect) -> Option<Rect> {
    let size = size.min(1 << 20);
    let corner = place(at, screen).map(|c| (c - size as f32 * 0.5 + 0.5).floor() as i32);
    let end = |from: i32| from.saturating_add(size as i32 - 1);
    let first = |i: usize| corner[i].max(0);
    let last = |i: usize, size: u32| end(corner[i]).min(size as i32 - 1);
    let (right, bottom) = (last(0, screen.x1), last(1, screen.y1));
    let any = first(0) <= right && first(1) <= bottom;
    any.then(|| Rect::new(first(0) as u32, first(1) as u32, right as u32 + 1, bottom as u32 + 1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::state::{RawCombine, RawLight};

    const SCREEN: Rect = Rect::new(0, 0, 640, 480);

    fn at(x: f32, y: f32) -> RawVertex {
        RawVertex { x: x / 320.0 - 1.0, y: y / 240.0 - 1.0, w1: 1.0, ..RawVertex::default() }
    }

    fn prepared(primitive: RawPrimitive, rows: &mut Vec<f32>) -> Option<RawShape> {
        prepare_raw(&primitive, &RawDraw::default(), 0, &SCREEN, 64, rows)
    }

    #[test]
    fn slots_follow_the_state() {
        let mut draw = RawDraw::default();
        assert_eq!(Slots::of(&draw).count, 0);
        draw.state.smooth_color = true;
        let slots = Slots::of(&draw);
        assert_eq!(
            (slots.count, slots.red(), slots.alpha(), slots.w1()),
            (5, Some(0), Some(3), Some(4))
        );
        draw.state.combine = RawCombine::Texture;
        assert_eq!(Slots::of(&draw).count, 0, "no texture is there");
        let direct = RawLight { direct: Some(0), smooth: true, ..RawLight::default() };
        draw.state.light = Some(direct);
        assert_eq!(Slots::of(&draw).intensity(), Some(0));
        draw.state.light = Some(RawLight { more: true, ..direct });
        assert_eq!((Slots::of(&draw).count, Slots::of(&draw).more()), (8, Some(2)));
    }

    #[test]
    fn a_row_of_tiles_begins_with_its_own_sums() {
        let mut rows = Vec::new();
        let corners = [at(100.3, 50.7), at(300.1, 52.9), at(99.2, 200.4)];
        let shape = prepared(RawPrimitive::Triangle(corners), &mut rows).unwrap();
        assert_eq!(shape.bounds, Rect::new(99, 51, 300, 200));
        let Values::Walk(walk) = shape.values else { panic!("a triangle") };
        // Rows 51, 64, 128 and 192.
        assert_eq!(rows.len(), 4 * 3);
        for i in 0..3 {
            let mut value = walk.edge_start[i];
            for y in 51..200 {
                if let Some(tile) = [51, 64, 128, 192].iter().position(|&first| first == y) {
                    assert_eq!(rows[tile * 3 + i], value, "{y}");
                }
                value += walk.edge_dy[i];
            }
        }
    }

    #[test]
    fn tiles_are_missed_only_outside() {
        let mut rows = Vec::new();
        let corners = [at(10.0, 10.0), at(630.0, 20.0), at(20.0, 470.0)];
        let shape = prepared(RawPrimitive::Triangle(corners), &mut rows).unwrap();
        let Values::Walk(walk) = &shape.values else { panic!("a triangle") };
        let misses = |x: u32, y: u32| {
            walk.misses(&shape.bounds, &Rect::new(x * 64, y * 64, x * 64 + 64, y * 64 + 64))
        };
        assert!(misses(9, 6) && misses(5, 5) && !misses(0, 0) && !misses(4, 3) && !misses(9, 0));
    }

    #[test]
    fn nothing_outside() {
        let mut rows = Vec::new();
        for [x, y] in [[-90.0, 5.0], [900.0, 5.0], [5.0, -90.0], [5.0, 900.0]] {
            let corners = [at(x, y), at(x + 9.0, y), at(x, y + 9.0)];
            assert!(prepared(RawPrimitive::Triangle(corners), &mut rows).is_none());
            assert!(prepared(RawPrimitive::Line([corners[0], corners[1]]), &mut rows).is_none());
            let point = RawPrimitive::Point { at: corners[0], size: 9 };
            assert!(prepared(point, &mut rows).is_none());
        }
        let broken = RawVertex { x: f32::NAN, ..at(3.0, 3.0) };
        let corners = [broken, at(30.0, 3.0), at(3.0, 30.0)];
        prepared(RawPrimitive::Triangle(corners), &mut rows);
    }
}
