//! Clipping to the clip window by the library.
//!
//! Source: G246, `guDrawTriangleWithClip` and its relatives.

use crate::board::Board;
use crate::draw::polygon::round_to_sixteenth;
use crate::vertex::{GrTmuVertex, GrVertex};

/// A polygon of this many corners at most is clipped.
const MAX_CORNERS: usize = 100;

impl Board {
    pub(crate) fn draw_triangle_clipped(&mut self, corners: [&GrVertex; 3]) {
        if corners.iter().all(|v| self.inside(v)) {
            return self.draw_triangle(corners);
        }
        self.draw_polygon_clipped(&corners.map(|v| *v));
    }

    pub(crate) fn draw_polygon_clipped(&mut self, corners: &[GrVertex]) {
        let clipped = self.clip(corners);
        self.draw_polygon(&clipped);
    }

    pub(crate) fn draw_aa_triangle_clipped(&mut self, corners: [&GrVertex; 3]) {
        if corners.iter().all(|v| self.inside(v)) {
            return self.draw_aa_triangle(corners, [true; 3]);
        }
        let clipped = self.clip(&corners.map(|v| *v));
        self.draw_aa_polygon(&clipped);
    }

    fn inside(&self, v: &GrVertex) -> bool {
        let [x0, y0, x1, y1] = self.settings.clip;
        v.x >= x0 && v.x < x1 && v.y >= y0 && v.y < y1
    }

    /// Clips against right, bottom, left and top; corners exactly on a minimum
    /// count as outside and are replaced in place.
    fn clip(&self, corners: &[GrVertex]) -> Vec<GrVertex> {
        let [x0, y0, x1, y1] = self.settings.clip;
        let mut list = corners[..corners.len().min(MAX_CORNERS)].to_vec();
        list = against(&list, x1, |v| &mut v.x, |a, plane| a < plane);
        list = against(&list, y1, |v| &mut v.y, |a, plane| a < plane);
        list = against(&list, x0, |v| &mut v.x, |a, plane| a > plane);
        list = against(&list, y0, |v| &mut v.y, |a, plane| a > plane);
        for v in &mut list {
            (v.x, v.y) = (round_to_sixteenth(v.x), round_to_sixteenth(v.y));
        }
        list
    }
}

/// One step of Sutherland and Hodgman's algorithm.
fn against(
    corners: &[GrVertex],
    plane: f32,
    axis: fn(&mut GrVertex) -> &mut f32,
    inside: fn(f32, f32) -> bool,
) -> Vec<GrVertex> {
    let mut out = Vec::with_capacity(corners.len() + 1);
    let Some(last) = corners.last() else { return out };
    let mut a = *last;
    for corner in corners {
        let mut b = *corner;
        let (pa, pb) = (*axis(&mut a), *axis(&mut b));
        let (a_in, b_in) = (inside(pa, plane), inside(pb, plane));
        if a_in != b_in {
            let mut cut = between(&a, &b, (plane - pa) / (pb - pa));
            *axis(&mut cut) = plane;
            out.push(cut);
        }
        if b_in {
            out.push(b);
        }
        a = b;
    }
    out.truncate(MAX_CORNERS);
    out
}

/// The point at `t` between a and b, with every parameter.
fn between(a: &GrVertex, b: &GrVertex, t: f32) -> GrVertex {
    let mix = |a: f32, b: f32| a + (b - a) * t;
    let tmu = |a: &GrTmuVertex, b: &GrTmuVertex| GrTmuVertex {
        sow: mix(a.sow, b.sow),
        tow: mix(a.tow, b.tow),
        oow: mix(a.oow, b.oow),
    };
    GrVertex {
        x: mix(a.x, b.x),
        y: mix(a.y, b.y),
        z: a.z,
        r: mix(a.r, b.r),
        g: mix(a.g, b.g),
        b: mix(a.b, b.b),
        ooz: mix(a.ooz, b.ooz),
        a: mix(a.a, b.a),
        oow: mix(a.oow, b.oow),
        tmuvtx: core::array::from_fn(|i| tmu(&a.tmuvtx[i], &b.tmuvtx[i])),
    }
}
