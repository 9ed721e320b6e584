//! Stage 2: rasterisation. A triangle becomes fragments, row by row.
//!
//! Source: RAW, rasterisation listing: edge functions and attribute planes evaluated by
//! incremental addition in f32 over the bounding box, in that order of operations.

use super::{TransPrim, UntexFragment, Vertex, trunc_i32};
use crate::color;
use crate::errata::Errata;
use crate::state::ModeBits;

/// A linear function of the pixel: value at the walker's place plus the steps.
#[derive(Clone, Copy, Debug, Default)]
struct Plane {
    dx: f32,
    dy: f32,
    row: f32,
    value: f32,
}

impl Plane {
    fn step_right(&mut self) {
        self.value += self.dx;
    }

    fn step_down(&mut self) {
        self.row += self.dy;
        self.value = self.row;
    }
}

/// The solver of attribute planes for one triangle: everything that does not depend on the
/// attribute.
struct PlaneSetup {
    x: [f32; 3],
    y: [f32; 3],
    me: f32,
    d: f32,
    start: [f32; 2],
}

impl PlaneSetup {
    fn new(x: [f32; 3], y: [f32; 3], start: [f32; 2]) -> Self {
        let me = x[1] * y[2] - x[2] * y[1];
        let d = 1.0 / (x[0] * (y[1] - y[2]) - y[0] * (x[1] - x[2]) + me);
        Self { x, y, me, d, start }
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

    fn plane(&self, p: [f32; 3]) -> Plane {
        let [dx, dy, c] = self.coefficients(p);
        let row = dx * self.start[0] + dy * self.start[1] + c;
        Plane { dx, dy, row, value: row }
    }
}

/// Which attributes the mode interpolates, derived once per primitive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Interpolants {
    /// Depth.
    pub z: bool,
    /// Red, green and blue.
    pub color: bool,
    /// Alpha of the colour.
    pub alpha: bool,
    /// Texture coordinates.
    pub uv: bool,
    /// Directional intensity.
    pub intensity: bool,
    /// The flat average of the colour is needed.
    pub flat_color: bool,
    /// The flat average of the intensity is needed.
    pub flat_intensity: bool,
}

impl Interpolants {
    /// Reads the needs off the mode.
    pub fn of(mode: ModeBits) -> Self {
        let smooth = mode.uses_color() && mode.col_interp() == 1;
        let lit = mode.uses_intensity();
        Self {
            z: mode.touches_z(),
            color: smooth,
            alpha: smooth && mode.col_alpha() != 0,
            uv: mode.uses_texture(),
            intensity: lit && mode.lit_interp() == 1,
            flat_color: mode.uses_color() && !smooth,
            flat_intensity: lit && mode.lit_interp() == 0,
        }
    }

    /// Whether 1/w has to be interpolated, and w recovered per fragment.
    pub fn perspective(&self) -> bool {
        self.color || self.uv || self.intensity
    }

    /// Number of planes that have to be set up.
    pub fn planes(&self) -> u32 {
        u32::from(self.z)
            + 3 * u32::from(self.color)
            + u32::from(self.alpha)
            + 2 * u32::from(self.uv)
            + u32::from(self.intensity)
            + u32::from(self.perspective())
    }
}

/// The inclusive pixel box a triangle may cover, as the listing computes it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Bounds {
    left: i32,
    top: i32,
    right: i32,
    bottom: i32,
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
        if errata.box_clamp_moves && high < 0 {
            return (0, 0);
        }
        if low > last {
            return (
                if errata.box_clamp_moves { last } else { 1 },
                if errata.box_clamp_moves { last } else { 0 },
            );
        }
        (low.max(0), high)
    }

    fn is_empty(&self) -> bool {
        self.left > self.right || self.top > self.bottom
    }
}

fn ceil_i32(v: f32) -> i32 {
    v.ceil() as i32
}

fn floor_i32(v: f32) -> i32 {
    v.floor() as i32
}

/// Values without interpolation: the average of the vertices.
#[derive(Clone, Copy, Debug, Default)]
struct Flat {
    rgba: u32,
    intensity: f32,
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

/// Walks one triangle; [`Iterator::next`] gives its fragments in row order.
#[derive(Clone, Debug)]
pub struct Rasterizer {
    bounds: Bounds,
    needs: Interpolants,
    edges: [Plane; 3],
    /// Whether a pixel centre on this edge counts as covered.
    inclusive: [bool; 3],
    z: [f32; 3],
    rgb: [Plane; 3],
    alpha: Plane,
    uv: [Plane; 2],
    intensity: Plane,
    w1: Plane,
    flat: Flat,
    mask_channels: bool,
    overflow_depth: bool,
    x: i32,
    y: i32,
    entered: bool,
    in_row: bool,
    work: RasterWork,
}

impl Rasterizer {
    /// Sets a transformed primitive up for a screen of `width` x `height` pixels.
    ///
    /// An invisible primitive yields no fragment.
    pub fn new(prim: &TransPrim, width: u32, height: u32, errata: &Errata) -> Self {
        let (w, h) = (width as f32, height as f32);
        let v = &prim.vertices;
        let mode = prim.info.mode;
        let needs = Interpolants::of(mode);
        let x = v.each_ref().map(|v| v.x * (w / 2.0) + w / 2.0);
        let y = v.each_ref().map(|v| v.y * (h / 2.0) + h / 2.0);
        let mut bounds = Bounds::of(x, y, width, height, errata);
        if mode.draw() == 0 {
            bounds = Bounds { left: 1, right: 0, top: 1, bottom: 0 };
        }
        let start = [bounds.left as f32 + 0.5, bounds.top as f32 + 0.5];
        let setup = PlaneSetup::new(x, y, start);
        let plane = |wanted: bool, f: fn(&Vertex) -> f32| match wanted {
            true => setup.plane(v.each_ref().map(f)),
            false => Plane::default(),
        };
        Self {
            bounds,
            needs,
            edges: edges(x, y, start),
            inclusive: inclusive_edges(x, y, errata),
            z: if needs.z { setup.coefficients(v.each_ref().map(|v| v.z)) } else { [0.0; 3] },
            rgb: [
                plane(needs.color, |v| v.rgba[0]),
                plane(needs.color, |v| v.rgba[1]),
                plane(needs.color, |v| v.rgba[2]),
            ],
            alpha: plane(needs.alpha, |v| v.rgba[3]),
            uv: [plane(needs.uv, |v| v.u), plane(needs.uv, |v| v.v)],
            intensity: plane(needs.intensity, |v| v.intensity),
            w1: plane(needs.perspective(), |v| v.w1),
            flat: flat_values(v, mode, needs, errata),
            mask_channels: errata.channels_wrap,
            overflow_depth: errata.depth_overflows,
            x: bounds.left,
            y: bounds.top,
            entered: false,
            in_row: false,
            work: RasterWork::default(),
        }
    }

    /// Which attributes are interpolated.
    pub fn needs(&self) -> Interpolants {
        self.needs
    }

    /// Returns and clears the work done so far.
    pub fn take_work(&mut self) -> RasterWork {
        std::mem::take(&mut self.work)
    }

    fn covered(&self) -> bool {
        self.edges
            .iter()
            .zip(self.inclusive)
            .all(|(edge, on_edge)| edge.value < 0.0 || (on_edge && edge.value == 0.0))
    }

    fn step_right(&mut self) {
        self.x += 1;
        self.planes().for_each(Plane::step_right);
    }

    fn step_down(&mut self) {
        self.x = self.bounds.left;
        self.y += 1;
        self.entered = false;
        self.in_row = false;
        self.planes().for_each(Plane::step_down);
    }

    fn planes(&mut self) -> impl Iterator<Item = &mut Plane> {
        let own = [&mut self.alpha, &mut self.intensity, &mut self.w1];
        self.edges.iter_mut().chain(&mut self.rgb).chain(&mut self.uv).chain(own)
    }

    fn fragment(&self) -> UntexFragment {
        let w = if self.needs.perspective() { 1.0 / self.w1.value } else { 0.0 };
        UntexFragment {
            x: self.x as u32,
            y: self.y as u32,
            z: if self.needs.z { self.depth() } else { 0 },
            u: if self.needs.uv { self.uv[0].value * w } else { 0.0 },
            v: if self.needs.uv { self.uv[1].value * w } else { 0.0 },
            rgba: if self.needs.color { self.color(w) } else { self.flat.rgba },
            intensity: match self.needs.intensity {
                true => self.intensity.value * w,
                false => self.flat.intensity,
            },
        }
    }

    fn depth(&self) -> i32 {
        let (x, y) = (self.x as f32 + 0.5, self.y as f32 + 0.5);
        let z = self.z[0] * x + self.z[1] * y + self.z[2];
        // As f32 the scale is 2^31, one more than the largest depth.
        let scaled = z * 2_147_483_648.0;
        if self.overflow_depth && scaled >= 2_147_483_648.0 { i32::MIN } else { trunc_i32(scaled) }
    }

    fn color(&self, w: f32) -> u32 {
        let byte = |plane: &Plane| channel(plane.value * w, self.mask_channels);
        let alpha = if self.needs.alpha { byte(&self.alpha) } else { 0 };
        color::pack(byte(&self.rgb[0]), byte(&self.rgb[1]), byte(&self.rgb[2]), alpha)
    }
}

impl Iterator for Rasterizer {
    type Item = UntexFragment;

    fn next(&mut self) -> Option<UntexFragment> {
        if self.bounds.is_empty() {
            return None;
        }
        while self.y <= self.bounds.bottom {
            if !self.in_row {
                self.in_row = true;
                self.work.rows += 1;
            }
            while self.x <= self.bounds.right {
                self.work.visited += 1;
                let hit = self.covered();
                if !hit && self.entered {
                    break;
                }
                let fragment = hit.then(|| self.fragment());
                self.entered |= hit;
                self.step_right();
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

/// The edge functions of the sides 0-1, 1-2, 2-0: negative inside.
fn edges(x: [f32; 3], y: [f32; 3], start: [f32; 2]) -> [Plane; 3] {
    [(0, 1), (1, 2), (2, 0)].map(|(a, b)| {
        let (dx, dy) = (y[b] - y[a], x[a] - x[b]);
        let c = y[a] * x[b] - y[b] * x[a];
        let row = dx * start[0] + dy * start[1] + c;
        Plane { dx, dy, row, value: row }
    })
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

/// Rounds a channel to a byte; `mask` keeps the low byte instead of clamping.
fn channel(value: f32, mask: bool) -> u32 {
    let rounded = trunc_i32(value + 0.5);
    if mask { rounded as u32 & 0xff } else { rounded.clamp(0, 255) as u32 }
}

fn flat_values(v: &[Vertex; 3], mode: ModeBits, needs: Interpolants, errata: &Errata) -> Flat {
    let w = v.each_ref().map(|v| 1.0 / v.w1);
    let average = |p: [f32; 3]| (p[0] * w[0] + p[1] * w[1] + p[2] * w[2]) / 3.0;
    let mut flat = Flat::default();
    if needs.flat_color {
        let byte =
            |i: usize| channel(average(v.each_ref().map(|v| v.rgba[i])), errata.channels_wrap);
        let alpha = if mode.col_alpha() != 0 { byte(3) } else { 0 };
        flat.rgba = color::pack(byte(0), byte(1), byte(2), alpha);
    }
    if needs.flat_intensity {
        flat.intensity = average(v.each_ref().map(|v| v.intensity));
    }
    flat
}
