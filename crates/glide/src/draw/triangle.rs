//! Triangles.

use fillrate_engine::Cull;

use crate::board::Board;
use crate::vertex::GrVertex;

impl Board {
    /// The culling mode as the engine knows it.
    pub(crate) fn cull(&self) -> Cull {
        match self.settings.cull {
            1 => Cull::Negative,
            2 => Cull::Positive,
            _ => Cull::Disabled,
        }
    }

    /// Source: G246, `grDrawTriangle`.
    pub(crate) fn draw_triangle(&mut self, corners: [&GrVertex; 3]) {
        self.update();
        let [a, b, c] = corners.map(|v| self.rules.convert(v));
        let cull = self.cull();
        if self.stipple_rotates() {
            return self.draw_triangle_stippled([&a, &b, &c], cull);
        }
        self.device.draw_triangle([&a, &b, &c], cull);
    }
}
