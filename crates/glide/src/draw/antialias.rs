//! Antialiasing: alpha ramps around primitives. The chip has no coverage; the
//! program blends by iterated alpha.
//!
//! Each table row is a triangle with corners A, B, C, its alpha at A, alpha
//! steps and sign.
//!
//! Source: G246, `grAADraw*`.

use fillrate_engine::Cull;
use fillrate_engine::Vertex;
use fillrate_engine::setup::{Outcome, triangle};
use fillrate_engine::state::MAX_TMUS;

use crate::board::Board;
use crate::draw::launch::{ALPHA, Ramp, values, zip};
use crate::registers::fbz;
use crate::vertex::GrVertex;

/// A ramp triangle: corners, alpha at A, alpha steps, whether the sign is
/// negative.
type Row = ([(f32, f32); 3], [f32; 3], bool);

/// A row of an edge's table: a [`Row`], and whether parameters start at b's.
type EdgeRow = ([(f32, f32); 3], [f32; 3], bool, bool);

/// The direction in which an edge's ramp falls.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Side {
    Left,
    Right,
    /// Toward larger y.
    Top,
    /// Toward smaller y.
    Bottom,
}

impl Board {
    fn launch_rows(&mut self, ramp: &mut Ramp, rows: &[Row]) {
        for (corners, [a0, dx, dy], negative) in rows {
            (ramp.start[ALPHA], ramp.dx[ALPHA], ramp.dy[ALPHA]) = (*a0, *dx, *dy);
            self.launch_helper(&ramp.registers(*corners, *negative));
        }
    }

    /// A diamond of four triangles, full in the middle.
    pub(crate) fn draw_aa_point(&mut self, point: &GrVertex) {
        self.update();
        let e = self.rules.convert(point);
        let (x, y, a) = (e.x, e.y, e.a);
        let rows = [
            ([(x, y), (x - 1.0, y + 1.0), (x + 1.0, y + 1.0)], [a, 0.0, -a], true),
            ([(x + 1.0, y - 1.0), (x, y), (x + 1.0, y + 1.0)], [0.0, -a, 0.0], true),
            ([(x - 1.0, y - 1.0), (x, y), (x - 1.0, y + 1.0)], [0.0, a, 0.0], false),
            ([(x - 1.0, y - 1.0), (x + 1.0, y - 1.0), (x, y)], [0.0, 0.0, a], false),
        ];
        self.launch_rows(&mut Ramp::constant(values(&e)), &rows);
    }

    /// Four triangles, full along the line.
    pub(crate) fn draw_aa_line(&mut self, v1: &GrVertex, v2: &GrVertex) {
        self.update();
        let [v1, v2] = [v1, v2].map(|v| self.rules.convert(v));
        let (v1, v2) = if v1.y <= v2.y { (v1, v2) } else { (v2, v1) };
        let (dx, dy) = (v1.x - v2.x, v2.y - v1.y);
        let (start, end) = (values(&v1), values(&v2));
        let mut ramp = Ramp::constant(start);
        if dx.abs() >= dy {
            if dx == 0.0 {
                return;
            }
            let k = 1.0 / dx;
            ramp.dx = zip(&start, &end, |p1, p2| (p1 - p2) * k);
            self.launch_rows(&mut ramp, &flat_line(&v1, &v2, dx, dy));
        } else {
            let k = -1.0 / dy;
            ramp.dy = zip(&start, &end, |p1, p2| (p1 - p2) * k);
            self.launch_rows(&mut ramp, &steep_line(&v1, &v2, dx, dy));
        }
    }

    /// The triangle, and a ramp outside of every edge asked for. Depth is not
    /// written by the ramps.
    pub(crate) fn draw_aa_triangle(&mut self, corners: [&GrVertex; 3], edges: [bool; 3]) {
        self.update();
        let [a, b, c] = corners.map(|v| self.rules.convert(v));
        if !self.draw_main(&a, &b, &c) {
            return;
        }
        let mask = self.fbi.fbz_mode;
        self.fbi.fbz_mode &= !fbz::AUX_WRITE;
        self.dirty = true;
        self.update();
        for (wanted, [p, q, r]) in edges.into_iter().zip([[a, b, c], [b, c, a], [c, a, b]]) {
            if wanted {
                self.edge(&p, &q, &r, [&a, &b, &c]);
            }
        }
        self.fbi.fbz_mode = mask;
        self.dirty = true;
    }

    /// A fan with ramps along its outline. As in the original, the last edge
    /// of a single triangle gets none, and the ramps write depth.
    pub(crate) fn draw_aa_polygon(&mut self, corners: &[GrVertex]) {
        self.update();
        let corners: Vec<Vertex> = corners.iter().map(|v| self.rules.convert(v)).collect();
        let [a, rest @ ..] = corners.as_slice() else { return };
        let count = rest.len().saturating_sub(1);
        for (i, pair) in rest.windows(2).enumerate() {
            let [b, c] = [&pair[0], &pair[1]];
            if !self.draw_main(a, b, c) {
                continue;
            }
            if i == 0 {
                self.edge(a, b, c, [a, b, c]);
            } else if i + 1 == count {
                self.edge(c, a, b, [a, b, c]);
            }
            self.edge(b, c, a, [a, b, c]);
        }
    }

    /// Draws the triangle itself; false where it was culled or empty.
    fn draw_main(&mut self, a: &Vertex, b: &Vertex, c: &Vertex) -> bool {
        match triangle([a, b, c], self.cull(), MAX_TMUS) {
            Outcome::Drawn(registers) => {
                self.launch(&registers);
                true
            }
            Outcome::Empty | Outcome::Culled => {
                self.correction.submitted += 1;
                false
            }
        }
    }

    /// The ramp outside of edge a-b; c is the third corner, `main` the
    /// triangle whose gradients the other parameters keep.
    fn edge(&mut self, a: &Vertex, b: &Vertex, c: &Vertex, main: [&Vertex; 3]) {
        let Outcome::Drawn(plane) = triangle(main, Cull::Disabled, MAX_TMUS) else { return };
        let (a, b) = if a.y >= b.y { (b, a) } else { (a, b) };
        let (dx, dy) = (a.x - b.x, a.y - b.y);
        let Some(side) = side(a, b, c, dx, dy) else { return };
        for (corners, [a0, dadx, dady], negative, from_b) in edge_rows(side, a, b, dx, dy) {
            let mut alpha = Ramp::constant(values(if from_b { b } else { a }));
            (alpha.start[ALPHA], alpha.dx[ALPHA], alpha.dy[ALPHA]) = (a0, dadx, dady);
            let mut registers = alpha.registers(corners, negative);
            // Gradients of everything but alpha stay those of the triangle.
            for i in (0..4).filter(|&i| i != ALPHA) {
                let (dx, dy) = (plane.color[i].dx, plane.color[i].dy);
                (registers.color[i].dx, registers.color[i].dy) = (dx, dy);
            }
            (registers.z.dx, registers.z.dy) = (plane.z.dx, plane.z.dy);
            (registers.w.dx, registers.w.dy) = (plane.w.dx, plane.w.dy);
            for (own, plane) in registers.tmu.iter_mut().flatten().zip(plane.tmu.iter().flatten()) {
                (own.dx, own.dy) = (plane.dx, plane.dy);
            }
            self.launch_helper(&registers);
        }
    }
}

fn flat_line(v1: &Vertex, v2: &Vertex, dx: f32, dy: f32) -> [Row; 4] {
    let k = 1.0 / dx;
    let (a1, a2) = (v1.a, v2.a);
    let (p1, p2) = ((v1.x, v1.y), (v2.x, v2.y));
    let (up1, up2) = ((v1.x, v1.y - 1.0), (v2.x, v2.y - 1.0));
    let (down1, down2) = ((v1.x, v1.y + 1.0), (v2.x, v2.y + 1.0));
    [
        ([up1, up2, p2], [0.0, a2 * dy * k, a2], -dx < 0.0),
        ([up1, p1, p2], [0.0, (a1 - a2 + a1 * dy) * k, a1], dx < 0.0),
        ([p1, down1, down2], [a1, -a1 * dy * k, -a1], dx < 0.0),
        ([p1, p2, down2], [a1, (a1 - a2 - a2 * dy) * k, -a2], -dx < 0.0),
    ]
}

fn steep_line(v1: &Vertex, v2: &Vertex, dx: f32, dy: f32) -> [Row; 4] {
    let k = -1.0 / dy;
    let (a1, a2) = (v1.a, v2.a);
    let (p1, p2) = ((v1.x, v1.y), (v2.x, v2.y));
    let (left1, left2) = ((v1.x - 1.0, v1.y), (v2.x - 1.0, v2.y));
    let (right1, right2) = ((v1.x + 1.0, v1.y), (v2.x + 1.0, v2.y));
    [
        ([p1, p2, left2], [a1, a2, (a1 - a2 * dx - a2) * k], false),
        // The original starts at a1 although the first corner is v1: right on
        // the line itself.
        ([p1, left1, left2], [a1, a1, -a1 * dx * k], true),
        ([right1, p1, p2], [0.0, -a1, (a1 - a2 + a1 * dx) * k], true),
        ([right1, right2, p2], [0.0, -a2, a2 * dx * k], false),
    ]
}

/// On which side of the edge a-b the outside is.
fn side(a: &Vertex, b: &Vertex, c: &Vertex, dx: f32, dy: f32) -> Option<Side> {
    if dx == 0.0 {
        return Some(if c.x > a.x { Side::Left } else { Side::Right });
    }
    if dy == 0.0 {
        return Some(if c.y > a.y { Side::Bottom } else { Side::Top });
    }
    let cp = (a.x - c.x) * (b.y - c.y) - (a.y - c.y) * (b.x - c.x);
    let choose = |first: bool, yes: Side, no: Side| Some(if first { yes } else { no });
    if dx > 0.0 {
        if dx >= -dy {
            choose(cp > 0.0, Side::Top, Side::Bottom)
        } else {
            choose(cp > 0.0, Side::Right, Side::Left)
        }
    } else if dx < 0.0 {
        if dx <= dy {
            choose(cp < 0.0, Side::Top, Side::Bottom)
        } else {
            choose(cp < 0.0, Side::Left, Side::Right)
        }
    } else {
        None
    }
}

/// The two ramp triangles of an edge; the last field says that parameters
/// start at b's values.
fn edge_rows(side: Side, a: &Vertex, b: &Vertex, dx: f32, dy: f32) -> [EdgeRow; 2] {
    let (pa, pb, aa, ab) = ((a.x, a.y), (b.x, b.y), a.a, b.a);
    let at = |v: &Vertex, x: f32, y: f32| (v.x + x, v.y + y);
    match side {
        Side::Top => {
            let (ua, ub) = (at(a, 0.0, 1.0), at(b, 0.0, 1.0));
            [
                ([pa, ua, ub], [aa, aa * dy / dx, -aa], dx < 0.0, false),
                ([pa, pb, ub], [aa, (aa - ab + ab * dy) / dx, -ab], -dx < 0.0, false),
            ]
        }
        Side::Left => {
            let (la, lb) = (at(a, -1.0, 0.0), at(b, -1.0, 0.0));
            [
                ([la, pa, lb], [0.0, aa, -aa * dx / dy], -dy < 0.0, false),
                ([pa, pb, lb], [aa, ab, (aa - ab * dx - ab) / dy], -dy < 0.0, false),
            ]
        }
        Side::Right => {
            let (ra, rb) = (at(a, 1.0, 0.0), at(b, 1.0, 0.0));
            [
                ([ra, pa, rb], [0.0, -aa, aa * dx / dy], dy < 0.0, false),
                ([pa, pb, rb], [aa, -ab, (ab * dx + aa - ab) / dy], dy < 0.0, false),
            ]
        }
        Side::Bottom => {
            let (da, db) = (at(a, 0.0, -1.0), at(b, 0.0, -1.0));
            if dy < -1.0 {
                [
                    ([da, pa, db], [0.0, -aa * dy / dx, aa], dx < 0.0, false),
                    ([pa, db, pb], [aa, (aa - ab - ab * dy) / dx, ab], -dx < 0.0, false),
                ]
            } else if dy == 0.0 {
                [
                    ([da, db, pb], [0.0, 0.0, ab], -dx < 0.0, false),
                    ([da, pa, pb], [0.0, (aa - ab) / dx, aa], dx < 0.0, false),
                ]
            } else {
                [
                    ([da, db, pa], [0.0, -aa * dy / dx, aa], -dx < 0.0, false),
                    ([db, pa, pb], [0.0, (aa - ab * dy - ab) / dx, ab], dx < 0.0, true),
                ]
            }
        }
    }
}
