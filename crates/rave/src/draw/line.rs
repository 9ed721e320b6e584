//! Points and lines.
//!
//! A point is a square of whole pixels; a line is as wide along its minor axis
//! as the state says. Neither uses the texture.

use fillrate_engine::state::Axis;

use super::Pen;
use super::triangle::is_finite_gouraud;
use crate::RaveError;
use crate::painter::Corner;
use crate::tags::{float, int};
use crate::translate::{FogSource, Paint, PatternUse, Variant, has_line_pattern};
use crate::vertex::VGouraud;

/// Lines and points beyond are of no screen, and left out.
const FAR: f32 = 1e6;

impl Pen<'_> {
    /// `QADrawPoint`.
    pub fn point(&mut self, v: &VGouraud) {
        let Some((corners, fog, is_extended)) = self.ends([v, v]) else { return };
        let side = self.context.state.float(float::WIDTH).round().max(1.0);
        let left = (v.x - side / 2.0 + 0.5).floor();
        let top = (v.y - side / 2.0 + 0.5).floor();
        self.choose(&variant(self, [v, v], fog, PatternUse::None));
        let at = |x: f32, y: f32| moved(&corners[0], x, y);
        let [a, b] = [at(left, top), at(left + side, top)];
        let [c, d] = [at(left, top + side), at(left + side, top + side)];
        self.add([a, b, c], is_extended);
        self.add([b, d, c], is_extended);
    }

    /// `QADrawLine`; the pattern starts anew.
    pub fn line(&mut self, v: [&VGouraud; 2]) {
        self.line_after(v, 0);
    }

    /// Draws a line whose pattern goes on after so many pixels; returns how
    /// many it has now passed.
    pub fn line_after(&mut self, v: [&VGouraud; 2], passed: i32) -> i32 {
        let Some((corners, fog, is_extended)) = self.ends(v) else { return passed };
        let (dx, dy) = (v[1].x - v[0].x, v[1].y - v[0].y);
        let is_steep = dy.abs() > dx.abs();
        let (from, to) = if is_steep { (v[0].y, v[1].y) } else { (v[0].x, v[1].x) };
        // The first and one past the last pixel whose centre is between.
        let pixel = |at: f32| (at - 0.5).ceil() as i32;
        let (first, last) = (pixel(from.min(to)), pixel(from.max(to)));
        let backwards = to < from;
        let pattern = if has_line_pattern(&self.context.state) {
            let axis = if is_steep { Axis::Y } else { Axis::X };
            let origin = if backwards { last - 1 + passed } else { first - passed };
            PatternUse::Line { axis, origin, backwards }
        } else {
            PatternUse::None
        };
        self.choose(&variant(self, v, fog, pattern));
        let half = self.context.state.float(float::WIDTH).max(1.0) / 2.0;
        let (ox, oy) = if is_steep { (half, 0.0) } else { (0.0, half) };
        let at = |i: usize, sign: f32| moved(&corners[i], v[i].x + sign * ox, v[i].y + sign * oy);
        let [a, b, c, d] = [at(0, -1.0), at(0, 1.0), at(1, -1.0), at(1, 1.0)];
        self.add([a, b, c], is_extended);
        self.add([b, d, c], is_extended);
        // A whole pattern changes nothing.
        let pattern = 16 * self.context.state.int(int::GL_LINE_PATTERN_FACTOR) as i32;
        (passed + last - first) % pattern.max(1)
    }

    /// The ends of a line as corners, where it can be drawn.
    fn ends(&mut self, v: [&VGouraud; 2]) -> Option<([Corner; 2], FogSource, bool)> {
        if !self.may_draw() {
            return None;
        }
        if !v.iter().all(|v| is_finite_gouraud(v)) {
            self.context.fail(RaveError::Parameter);
            return None;
        }
        if v.iter().any(|v| v.x.abs().max(v.y.abs()) > FAR) {
            return None;
        }
        let prepared = self.context.prepared.as_deref()?;
        let fog = prepared.fog_source(v.iter().all(|v| v.inv_w > 0.0));
        let is_extended = prepared.extends(fog);
        let corners = v.map(|v| {
            let extra = prepared.extra(v.z, v.inv_w, v.a);
            Corner { vertex: prepared.gouraud(v), extra }
        });
        Some((corners, fog, is_extended))
    }
}

/// How points and lines are drawn.
fn variant(pen: &Pen<'_>, v: [&VGouraud; 2], fog: FogSource, pattern: PatternUse) -> Variant {
    let is_opaque = pen.context.prepared.as_deref().is_some_and(|prepared| {
        prepared.is_opaque(prepared.alpha_fog || v.iter().all(|v| v.a >= 1.0))
    });
    Variant { paint: Paint::Gouraud, opaque: is_opaque, bright: false, fog, pattern }
}

/// A corner somewhere else.
fn moved(corner: &Corner, x: f32, y: f32) -> Corner {
    let mut corner = *corner;
    (corner.vertex.x, corner.vertex.y) = (x, y);
    corner
}
