//! Points.

use crate::board::Board;
use crate::draw::launch::{Ramp, values};
use crate::draw::polygon::round_to_sixteenth;
use crate::vertex::GrVertex;

impl Board {
    /// Exactly one pixel: a small triangle whose first corner is the centre of
    /// the pixel that holds the point.
    ///
    /// Source: G246, `grDrawPoint`.
    pub(crate) fn draw_point(&mut self, point: &GrVertex) {
        self.update();
        let v = self.rules.convert(point);
        let (x, y) = (round_to_sixteenth(v.x).floor(), round_to_sixteenth(v.y).floor());
        let ramp = Ramp::constant(values(&v));
        if self.improve.scale > 1 {
            // All pixels of the pixel: two triangles.
            let [a, b, c, d] = [(x, y), (x + 1.0, y), (x + 1.0, y + 1.0), (x, y + 1.0)];
            self.launch_helper(&ramp.registers([a, b, c], false));
            return self.launch_helper(&ramp.registers([a, d, c], true));
        }
        let corners = [(x + 0.5, y + 0.5), (x + 1.0, y + 0.5), (x + 1.0, y + 1.0)];
        self.launch_helper(&ramp.registers(corners, false));
    }
}
