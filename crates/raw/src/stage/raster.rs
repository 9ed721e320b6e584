//! Stage 2: rasterisation. A triangle becomes fragments, row by row.
//!
//! Source: RAW, rasterisation listing: edge functions and attribute planes evaluated by
//! incremental addition in f32 over the bounding box, in that order of operations.

pub use super::emit::Interpolants;
use super::emit::{Emitter, LANES, THESIS_LANES, lane};
use super::thin::Thin;
use super::{Shape, TransPrim, UntexFragment, Vertex, trunc_i32};
use crate::errata::Errata;

/// Size of the screen in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Screen {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
}

impl Screen {
    /// Where a vertex after the divide lies on the screen, in pixels.
    pub fn place(&self, v: &Vertex) -> [f32; 2] {
        let (w, h) = (self.width as f32, self.height as f32);
        [v.x * (w / 2.0) + w / 2.0, v.y * (h / 2.0) + h / 2.0]
    }
}

/// The solver of attribute planes for one triangle: everything that does not depend on the
/// attribute.
struct PlaneSetup {
    x: [f32; 3],
    y: [f32; 3],
    me: f32,
    d: f32,
}

impl PlaneSetup {
    fn new(x: [f32; 3], y: [f32; 3]) -> Self {
        let me = x[1] * y[2] - x[2] * y[1];
        let d = 1.0 / (x[0] * (y[1] - y[2]) - y[0] * (x[1] - x[2]) + me);
        Self { x, y, me, d }
    }

    /// The coefficients of the plane through three values: per column, per row, constant.
    fn coefficients(&self, p: [f32; 3]) -> [f32; 3] {
        let (x, y) = (&self.x, &self.y);
        let b1 = p[1] * y[2] - p[2] * y[1];
        let b2 = x[1] * p[2] - x[2] * p[1];
        let dx = self.d * (p[0] * (y[1] - y[2]) - y[0] * (p[1] - p[2]) + b1);
        let dy = self.d * (x[0] * (p[1] - p[2]) - p[0] * (x[1] - x[2]) + b2);
        let c = self.d * (p[0] * self.me - x[0] * b1 - y[0] * b2);
        [dx, dy, c]
    }
}

/// Linear functions of the pixel, stepped by addition: the value at the start of the row and the
/// steps along both axes.
#[derive(Clone, Copy, Debug)]
pub struct Planes<const N: usize> {
    /// Per column.
    pub dx: [f32; N],
    /// Per row.
    pub dy: [f32; N],
    /// At the first column of the row.
    pub row: [f32; N],
}

impl<const N: usize> Planes<N> {
    const NONE: Self = Self { dx: [0.0; N], dy: [0.0; N], row: [0.0; N] };

    fn set(&mut self, lane: usize, [dx, dy, c]: [f32; 3], start: [f32; 2]) {
        self.dx[lane] = dx;
        self.dy[lane] = dy;
        self.row[lane] = dx * start[0] + dy * start[1] + c;
    }

    /// Goes to the next row.
    #[inline(always)]
    pub fn step_down(&mut self) {
        for (value, step) in self.row.iter_mut().zip(self.dy) {
            *value += step;
        }
    }
}

/// The inclusive pixel box a triangle may cover, as the listing computes it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bounds {
    /// First column.
    pub left: i32,
    /// First row.
    pub top: i32,
    /// Last column.
    pub right: i32,
    /// Last row.
    pub bottom: i32,
}

impl Bounds {
    fn of(x: [f32; 3], y: [f32; 3], width: u32, height: u32, errata: &Errata) -> Self {
        let (left, right) = Self::axis(x, width, errata);
        let (top, bottom) = Self::axis(y, height, errata);
        Self { left, top, right, bottom }
    }

    fn axis(c: [f32; 3], size: u32, errata: &Errata) -> (i32, i32) {
        let last = size as i32 - 1;
        let first = |v: f32| {
            if errata.box_skips_exact_centre { trunc_i32(v + 0.5) } else { ceil_i32(v - 0.5) }
        };
        let end = |v: f32| {
            if errata.box_clamp_moves { trunc_i32(v - 0.5) } else { floor_i32(v - 0.5) }
        };
        let low = c.map(first).into_iter().min().unwrap_or(0);
        let high = c.map(end).into_iter().max().unwrap_or(0).min(last);
        match (errata.box_clamp_moves, high < 0, low > last) {
            (true, true, _) => (0, 0),
            (true, _, true) => (last, last),
            (false, true, _) | (false, _, true) => OFF_SCREEN,
            _ => (low.max(0), high),
        }
    }

    /// Rows that are entered in vain, because the box lies between the centres of two columns.
    fn rows_without_columns(&self) -> u32 {
        let between = self.left == self.right.saturating_add(1);
        if between { (self.bottom - self.top + 1).max(0) as u32 } else { 0 }
    }

    /// Whether no pixel can be covered.
    pub fn is_empty(&self) -> bool {
        self.left > self.right || self.top > self.bottom
    }
}

/// Bounds along an axis that nothing of a triangle reaches.
const OFF_SCREEN: (i32, i32) = (1, -1);

fn ceil_i32(v: f32) -> i32 {
    v.ceil() as i32
}

fn floor_i32(v: f32) -> i32 {
    v.floor() as i32
}

/// What the walker did since the cost model last asked.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RasterWork {
    /// Rows entered.
    pub rows: u32,
    /// Pixels tested against the edges.
    pub visited: u32,
    /// Pixels covered.
    pub covered: u32,
}

/// A triangle set up for walking: its box, its edges and its attribute planes at the first row.
#[derive(Clone, Debug)]
pub struct Setup {
    /// The pixels it may cover.
    pub bounds: Bounds,
    /// The edge functions of the sides 0-1, 1-2, 2-0: negative inside.
    pub edges: Planes<3>,
    /// Whether a pixel centre on this edge counts as covered.
    inclusive: [bool; 3],
    /// The attribute planes.
    pub lanes: Planes<LANES>,
    /// Lanes that are stepped.
    pub used: usize,
    /// The depth plane: per column, per row, constant.
    pub z: [f32; 3],
    /// Makes the fragments.
    pub emitter: Emitter,
}

impl Setup {
    /// Sets a transformed triangle up for a screen.
    pub fn new(prim: &TransPrim, screen: Screen, errata: &Errata) -> Self {
        let v = &prim.vertices;
        let places = v.each_ref().map(|v| screen.place(v));
        let (x, y) = (places.map(|p| p[0]), places.map(|p| p[1]));
        let bounds = Bounds::of(x, y, screen.width, screen.height, errata);
        let start = [bounds.left as f32 + 0.5, bounds.top as f32 + 0.5];
        let emitter = Emitter::new(v, prim.info.mode, errata);
        let needs = emitter.needs;
        let setup = PlaneSetup::new(x, y);
        let mut lanes = Planes::NONE;
        for index in (0..LANES).filter(|index| needs.has(*index)) {
            let values = v.each_ref().map(|v| lane(v, index));
            lanes.set(index, setup.coefficients(values), start);
        }
        Self {
            bounds,
            edges: edges(x, y, start),
            inclusive: inclusive_edges(x, y, errata),
            lanes,
            used: if needs.more { LANES } else { THESIS_LANES },
            z: if needs.z { setup.coefficients(v.each_ref().map(|v| v.z)) } else { [0.0; 3] },
            emitter,
        }
    }

    /// Whether a pixel with these edge values is covered.
    #[inline(always)]
    pub fn covers(&self, edges: &[f32; 3]) -> bool {
        edges.iter().zip(self.inclusive).all(|(value, on)| *value < 0.0 || (on && *value == 0.0))
    }

    /// The depth at the centre of a pixel, -1 near to 1 far.
    #[inline(always)]
    pub fn depth(&self, x: i32, y: i32) -> f32 {
        self.z[0] * (x as f32 + 0.5) + self.z[1] * (y as f32 + 0.5) + self.z[2]
    }

    /// The depth at the centre of a pixel as a word; 0 where the mode has no use for it.
    #[inline(always)]
    pub fn depth_word(&self, x: i32, y: i32) -> i32 {
        if self.emitter.needs.z { self.emitter.depth(self.depth(x, y)) } else { 0 }
    }

    /// The fragment at a pixel, from the lanes there.
    #[inline(always)]
    pub fn fragment(&self, x: i32, y: i32, lanes: &[f32; LANES]) -> UntexFragment {
        let z = if self.emitter.needs.z { self.depth(x, y) } else { 0.0 };
        let steps = Some([&self.lanes.dx, &self.lanes.dy]);
        self.emitter.fragment(x as u32, y as u32, z, lanes, steps)
    }

    /// Goes one column to the right.
    #[inline(always)]
    pub fn step_right(&self, edges: &mut [f32; 3], lanes: &mut [f32; LANES]) {
        for (value, step) in edges.iter_mut().zip(self.edges.dx) {
            *value += step;
        }
        let (thesis, more) = lanes.split_at_mut(THESIS_LANES);
        let (thesis_steps, more_steps) = self.lanes.dx.split_at(THESIS_LANES);
        for (value, step) in thesis.iter_mut().zip(thesis_steps) {
            *value += step;
        }
        if self.used > THESIS_LANES {
            for (value, step) in more.iter_mut().zip(more_steps) {
                *value += step;
            }
        }
    }
}

/// Walks one triangle; [`Iterator::next`] gives its fragments in row order.
#[derive(Clone, Debug)]
struct TriangleWalker {
    setup: Setup,
    edges: [f32; 3],
    lanes: [f32; LANES],
    x: i32,
    y: i32,
    entered: bool,
    in_row: bool,
    work: RasterWork,
}

impl TriangleWalker {
    fn new(setup: Setup) -> Self {
        let (edges, lanes) = (setup.edges.row, setup.lanes.row);
        let (x, y) = (setup.bounds.left, setup.bounds.top);
        let rows = setup.bounds.rows_without_columns();
        let work = RasterWork { rows, ..RasterWork::default() };
        Self { setup, edges, lanes, x, y, entered: false, in_row: false, work }
    }

    fn step_down(&mut self) {
        self.x = self.setup.bounds.left;
        self.y += 1;
        self.entered = false;
        self.in_row = false;
        self.setup.edges.step_down();
        self.setup.lanes.step_down();
        self.edges = self.setup.edges.row;
        self.lanes = self.setup.lanes.row;
    }
}

impl Iterator for TriangleWalker {
    type Item = UntexFragment;

    fn next(&mut self) -> Option<UntexFragment> {
        let bounds = self.setup.bounds;
        if bounds.is_empty() {
            return None;
        }
        while self.y <= bounds.bottom {
            if !self.in_row {
                self.in_row = true;
                self.work.rows += 1;
            }
            while self.x <= bounds.right {
                self.work.visited += 1;
                let hit = self.setup.covers(&self.edges);
                if !hit && self.entered {
                    break;
                }
                let fragment = hit.then(|| self.setup.fragment(self.x, self.y, &self.lanes));
                self.entered |= hit;
                self.x += 1;
                self.setup.step_right(&mut self.edges, &mut self.lanes);
                if fragment.is_some() {
                    self.work.covered += 1;
                    return fragment;
                }
            }
            self.step_down();
        }
        None
    }
}

/// Walks a primitive of any shape; gives its fragments in order.
#[derive(Clone, Debug)]
pub struct Rasterizer(Walker);

#[derive(Clone, Debug)]
enum Walker {
    Triangle(Box<TriangleWalker>),
    Thin(Box<Thin>),
}

impl Rasterizer {
    /// Sets a transformed primitive up for a screen of `width` x `height` pixels.
    pub fn new(prim: &TransPrim, width: u32, height: u32, errata: &Errata) -> Self {
        let screen = Screen { width, height };
        let [a, b, _] = prim.vertices;
        let (mode, size) = (prim.info.mode, prim.info.point_size);
        Self(match prim.shape {
            Shape::Triangle => {
                Walker::Triangle(Box::new(TriangleWalker::new(Setup::new(prim, screen, errata))))
            }
            Shape::Line => {
                let emitter = Emitter::new(&[a, b], mode, errata);
                Walker::Thin(Box::new(Thin::line(emitter, [a, b], screen)))
            }
            Shape::Point => {
                let emitter = Emitter::new(&[a], mode, errata);
                Walker::Thin(Box::new(Thin::point(emitter, a, size, screen)))
            }
        })
    }

    /// Which attributes are interpolated.
    pub fn needs(&self) -> Interpolants {
        match &self.0 {
            Walker::Triangle(walker) => walker.setup.emitter.needs,
            Walker::Thin(walker) => walker.emitter().needs,
        }
    }

    /// Returns and clears the work done so far.
    pub fn take_work(&mut self) -> RasterWork {
        match &mut self.0 {
            Walker::Triangle(walker) => std::mem::take(&mut walker.work),
            Walker::Thin(walker) => walker.take_work(),
        }
    }
}

impl Iterator for Rasterizer {
    type Item = UntexFragment;

    fn next(&mut self) -> Option<UntexFragment> {
        match &mut self.0 {
            Walker::Triangle(walker) => walker.next(),
            Walker::Thin(walker) => walker.next(),
        }
    }
}

/// The edge functions of the sides 0-1, 1-2, 2-0: negative inside.
fn edges(x: [f32; 3], y: [f32; 3], start: [f32; 2]) -> Planes<3> {
    let mut planes = Planes::NONE;
    for (side, (a, b)) in [(0, 1), (1, 2), (2, 0)].into_iter().enumerate() {
        let (dx, dy) = (y[b] - y[a], x[a] - x[b]);
        planes.set(side, [dx, dy, y[a] * x[b] - y[b] * x[a]], start);
    }
    planes
}

/// Which edges include their pixel centres: all of them, or with the optional rule only the top and
/// left ones.
fn inclusive_edges(x: [f32; 3], y: [f32; 3], errata: &Errata) -> [bool; 3] {
    [(0, 1), (1, 2), (2, 0)].map(|(a, b)| {
        let (right, down) = (x[b] - x[a], y[b] - y[a]);
        // Clockwise with y down: a top edge runs right and level, a left edge runs up.
        !errata.top_left_rule || down < 0.0 || (down == 0.0 && right > 0.0)
    })
}
