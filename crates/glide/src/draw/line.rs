//! Lines: parallelograms one pixel wide.

use fillrate_engine::fixed;

use crate::board::Board;
use crate::draw::launch::{Ramp, after_launch, values, zip};
use crate::vertex::GrVertex;

impl Board {
    /// Two triangles, half a pixel to each side along the minor axis. The
    /// second is launched without new start values.
    ///
    /// Source: G246, `grDrawLine`.
    pub(crate) fn draw_line(&mut self, v1: &GrVertex, v2: &GrVertex) {
        self.update();
        let [v1, v2] = [v1, v2].map(|v| self.rules.convert(v));
        let (a, b) = if v2.y < v1.y { (v2, v1) } else { (v1, v2) };
        let (dx, dy) = (b.x - a.x, b.y - a.y);
        let (start, end) = (values(&a), values(&b));
        let mut ramp = Ramp::constant(start);
        let (first, second, signs);
        if dx.abs() >= dy {
            if dx == 0.0 {
                return;
            }
            let m = 1.0 / dx;
            ramp.dx = zip(&end, &start, |b, a| (b - a) * m);
            first = [(a.x, a.y - 0.5), (b.x, b.y - 0.5), (b.x, b.y + 0.5)];
            second = [first[0], (a.x, a.y + 0.5), first[2]];
            signs = [dx < 0.0, dx > 0.0];
        } else {
            let m = 1.0 / dy;
            ramp.dy = zip(&end, &start, |b, a| (b - a) * m);
            first = [(a.x - 0.5, a.y), (b.x - 0.5, b.y), (b.x + 0.5, b.y)];
            second = [first[0], (a.x + 0.5, a.y), first[2]];
            signs = [true, false];
        }
        let launched = ramp.registers(first, signs[0]);
        self.launch_helper(&launched);
        // The steps are the same; converting them costs more than the rest.
        let mut again = after_launch(&launched);
        again.x = second.map(|(x, _)| fixed::coord(x));
        again.y = second.map(|(_, y)| fixed::coord(y));
        again.negative = signs[1];
        self.launch_helper(&again);
    }
}
