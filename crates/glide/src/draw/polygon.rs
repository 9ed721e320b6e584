//! Convex polygons as fans.

use fillrate_engine::setup::{Outcome, triangle};
use fillrate_engine::state::MAX_TMUS;
use fillrate_engine::{Cull, Registers, Vertex, fixed};

use crate::board::Board;
use crate::vertex::GrVertex;

impl Board {
    /// Source: G246, `grDrawPolygonVertexList`.
    pub(crate) fn draw_polygon(&mut self, corners: &[GrVertex]) {
        let [first, rest @ ..] = corners else { return };
        for pair in rest.windows(2) {
            self.draw_triangle([first, &pair[0], &pair[1]]);
        }
    }

    /// A fan whose gradients come from its first triangle that has an area;
    /// where that one is culled, nothing is drawn.
    ///
    /// Source: G246, `grDrawPlanarPolygonVertexList`.
    pub(crate) fn draw_planar_polygon(&mut self, corners: &[GrVertex]) {
        self.update();
        let corners: Vec<Vertex> = corners.iter().map(|v| self.rules.convert(v)).collect();
        let [first, rest @ ..] = corners.as_slice() else { return };
        let mut plane: Option<Registers> = None;
        for pair in rest.windows(2) {
            let fan = [first, &pair[0], &pair[1]];
            let Some(plane) = &plane else {
                match triangle(fan, self.cull(), MAX_TMUS) {
                    Outcome::Culled => {
                        self.correction.submitted += 1;
                        return;
                    }
                    Outcome::Empty => self.correction.submitted += 1,
                    Outcome::Drawn(registers) => {
                        self.launch(&registers);
                        plane = Some(registers);
                    }
                }
                continue;
            };
            match triangle(fan, Cull::Disabled, MAX_TMUS) {
                Outcome::Drawn(own) => self.launch(&with_gradients(own, plane)),
                Outcome::Empty | Outcome::Culled => self.correction.submitted += 1,
            }
        }
    }
}

/// A triangle's own corners and starts with another's gradients.
fn with_gradients(own: Registers, plane: &Registers) -> Registers {
    let mut out = own;
    for (out, plane) in out.color.iter_mut().zip(&plane.color) {
        (out.dx, out.dy) = (plane.dx, plane.dy);
    }
    (out.z.dx, out.z.dy) = (plane.z.dx, plane.z.dy);
    (out.w.dx, out.w.dy) = (plane.w.dx, plane.w.dy);
    for (out, plane) in out.tmu.iter_mut().flatten().zip(plane.tmu.iter().flatten()) {
        (out.dx, out.dy) = (plane.dx, plane.dy);
    }
    out
}

/// Rounds to a sixteenth of a pixel by adding and subtracting 2^19, where one
/// unit in the last place is a sixteenth.
///
/// Source: G246, `guDrawPolygonVertexListWithClip`.
pub(super) fn round_to_sixteenth(value: f32) -> f32 {
    const SNAP: f32 = (1 << fixed::COORD_FRACTION << 15) as f32;
    (value + SNAP) - SNAP
}
