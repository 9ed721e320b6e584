//! Triangles.

use fillrate_engine::Cull;

use crate::board::Board;
use crate::vertex::{GrVertex, VertexRules};

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
        if self.bounds_check && !corners.iter().all(|v| is_in_range(v)) {
            return;
        }
        let cull = self.cull();
        if self.stipples_in_pieces() {
            let [a, b, c] = corners.map(|v| self.rules.convert(v));
            return self.draw_triangle_stippled([&a, &b, &c], cull);
        }
        // Most often nothing has to be asked for each corner.
        if self.rules == VertexRules::PLAIN {
            return self
                .device
                .draw_triangle_made(cull, |i| VertexRules::PLAIN.convert(corners[i]));
        }
        let rules = &self.rules;
        self.device.draw_triangle_made(cull, |i| rules.convert(corners[i]));
    }
}

/// Whether the board can hold a vertex's coordinates, with or without the bias
/// that programs add to snap vertices.
///
/// Source: G246, triangle set-up: 12.4 coordinates; 3 << 18 as a bias vanishes.
pub(crate) fn is_in_range(v: &GrVertex) -> bool {
    const BIAS: f32 = (3 << 18) as f32;
    let fits = |value: f32| (-2048.0..2048.0).contains(&value);
    [v.x, v.y].into_iter().all(|value| fits(value) || fits(value - BIAS))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_snapping_bias_is_in_range() {
        let at = |x: f32, y: f32| GrVertex { x, y, ..GrVertex::default() };
        assert!(is_in_range(&at(-2048.0, 2047.9)));
        assert!(is_in_range(&at(786_432.0 + 320.5, 786_432.0 - 3.0)));
        assert!(!is_in_range(&at(2048.0, 0.0)));
        assert!(!is_in_range(&at(0.0, f32::NAN)));
    }
}
