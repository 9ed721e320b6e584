//! Single triangles on the screen.
//!
//! Source: QK, `DrawTriangle`, `ZcErrorMax`.

use std::sync::Arc;

use fillrate_engine::{PalettePrimitive, PaletteVertex};

use super::brush::Brush;
use super::{Gpu, inverse_z};
use crate::clip;
use crate::math::common_repeats;
use crate::state::{RasterState, TriangleMode, Vertex};

/// A light value within what the planes hold; fragments are limited to
/// 0..=255 later.
fn light(intensity: i32) -> i16 {
    intensity.clamp(-32_000, 32_000) as i16
}

/// Twice the area on the screen; negative where the corners run
/// counter-clockwise in the world.
pub(crate) fn area([a, b, c]: &[Vertex; 3]) -> i128 {
    let from_a =
        |p: &Vertex| [i128::from(p.x) - i128::from(a.x), i128::from(p.y) - i128::from(a.y)];
    let (b, c) = (from_a(b), from_a(c));
    b[0] * c[1] - c[0] * b[1]
}

/// Texture coordinates of three corners along one axis, without the repeats
/// they have in common.
fn coordinates(values: [i32; 3]) -> [u16; 3] {
    let offset = common_repeats(values);
    values.map(|value| (i64::from(value) - offset).min(u16::MAX.into()) as u16)
}

/// How far affine texture coordinates are off in the middle of the worst edge,
/// in 1/256 pixel.
fn affine_error(corners: &[Vertex; 3]) -> i64 {
    let edge = |i: usize| {
        let (a, b) = (&corners[i], &corners[(i + 1) % 3]);
        let distance = |a: i32, b: i32| (i64::from(a) - i64::from(b)).abs();
        let length = distance(a.x, b.x).max(distance(a.y, b.y)).min(1 << 22);
        let sum = (i64::from(a.z) + i64::from(b.z)).max(1);
        256 * length * distance(a.z, b.z).min(1 << 31) / (2 * sum)
    };
    (0..3).map(edge).max().unwrap_or(0)
}

impl Gpu {
    /// Draws a triangle given on the screen, by the triangle state and mode.
    pub fn draw_triangle(&mut self, a: &Vertex, b: &Vertex, c: &Vertex) {
        let Some(mode) = self.triangle_mode else { return };
        let Some(state) = self.triangle_state.take() else { return };
        let brush = self.brush(&state, mode);
        self.face(&brush, state.draw_color, &[*a, *b, *c]);
        self.triangle_state = Some(state);
    }

    /// The brush of a state and mode; that of the last time where it can.
    pub(super) fn brush(&mut self, state: &RasterState, mode: TriangleMode) -> Arc<Brush> {
        if let Some(brush) = &self.brush
            && brush.is_of(state, mode)
        {
            return Arc::clone(brush);
        }
        let brush = Arc::new(Brush::new(state, mode, self.depth_test));
        self.brush = Some(Arc::clone(&brush));
        brush
    }

    /// Draws a face, or keeps it for the sorted pass, unless it is hidden or
    /// turned away.
    pub(super) fn face(&mut self, brush: &Arc<Brush>, color: u8, corners: &[Vertex; 3]) {
        let [a, b, c] = corners;
        if a.m & b.m & c.m != 0 || (a.m | b.m | c.m) & clip::NEAR != 0 {
            return;
        }
        let area = area(corners);
        if area == 0 || (brush.culling && area > 0) {
            return;
        }
        if brush.sorted {
            self.sort.add(brush, color, corners);
        } else {
            self.draw_face(brush, color, corners);
        }
    }

    /// Draws a face that is known to be visible.
    pub(super) fn draw_face(&mut self, brush: &Brush, color: u8, corners: &[Vertex; 3]) {
        if brush.mode == TriangleMode::Wireframe {
            for i in 0..3 {
                self.draw_edge(brush, color, &corners[i], &corners[(i + 1) % 3]);
            }
            return;
        }
        let (u, v) = if brush.mode.is_textured() {
            (coordinates(corners.map(|c| c.u)), coordinates(corners.map(|c| c.v)))
        } else {
            ([0; 3], [0; 3])
        };
        // Errors are never below 0, and looking for them takes three divisions.
        let perspective = brush.mode == TriangleMode::Perspective
            && (self.zc_error_max <= 0 || affine_error(corners) >= i64::from(self.zc_error_max));
        let corner = |i: usize| PaletteVertex {
            x: corners[i].x,
            y: corners[i].y,
            depth: inverse_z(corners[i].z),
            intensity: light(corners[i].i),
            u: u[i],
            v: v[i],
        };
        let corners = [corner(0), corner(1), corner(2)];
        let triangle = PalettePrimitive::Triangle { corners, color, perspective };
        self.device.draw_palette(&brush.draw, triangle);
    }

    /// An edge of a wire frame, at the mean light of its ends.
    fn draw_edge(&mut self, brush: &Brush, color: u8, a: &Vertex, b: &Vertex) {
        let mean = (i64::from(a.i) + i64::from(b.i)).div_euclid(2).clamp(0, 255);
        let end = |v: &Vertex| PaletteVertex {
            x: v.x,
            y: v.y,
            depth: inverse_z(v.z),
            intensity: mean as i16,
            ..PaletteVertex::default()
        };
        let ends = [end(a), end(b)];
        self.device.draw_palette(&brush.draw, PalettePrimitive::Line { ends, color });
    }
}
