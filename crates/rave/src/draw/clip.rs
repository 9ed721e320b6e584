//! Triangles that reach beyond the renderer's coordinates, cut off outside the
//! context.

use fillrate_engine::{TmuVertex, Vertex, VertexExtra};

use crate::painter::Corner;

/// Coordinates have 11 integer bits and a sign.
pub(super) const LIMIT: f32 = 2048.0;

/// Pixels around the context that stay.
const MARGIN: f32 = 32.0;

/// Whether the renderer's coordinates hold a place.
#[inline]
pub(super) fn fits(x: f32, y: f32) -> bool {
    x.abs() < LIMIT && y.abs() < LIMIT
}

/// The polygon's part near a context of this size. No pixel of the context is
/// lost.
pub(super) fn to_guard(corners: &[Corner; 3], (width, height): (u32, u32)) -> Vec<Corner> {
    let mut polygon = corners.to_vec();
    // LIMIT itself is not a coordinate.
    let high = |side: u32| f64::from((side as f32 + MARGIN).min(LIMIT - 0.5));
    let low = f64::from(-MARGIN);
    let x = |corner: &Corner| f64::from(corner.vertex.x);
    let y = |corner: &Corner| f64::from(corner.vertex.y);
    polygon = cut(&polygon, |corner| x(corner) - low);
    polygon = cut(&polygon, |corner| high(width) - x(corner));
    polygon = cut(&polygon, |corner| y(corner) - low);
    cut(&polygon, |corner| high(height) - y(corner))
}

/// The part of a convex polygon where `inside` is not negative.
fn cut(polygon: &[Corner], inside: impl Fn(&Corner) -> f64) -> Vec<Corner> {
    let mut out = Vec::with_capacity(polygon.len() + 1);
    for (i, a) in polygon.iter().enumerate() {
        let b = &polygon[(i + 1) % polygon.len()];
        let (da, db) = (inside(a), inside(b));
        if da >= 0.0 {
            out.push(*a);
        }
        if (da >= 0.0) != (db >= 0.0) {
            out.push(between(a, b, da / (da - db)));
        }
    }
    out
}

/// The corner at part `t` of the way from `a` to `b`.
fn between(a: &Corner, b: &Corner, t: f64) -> Corner {
    let mix64 = |a: f64, b: f64| a + (b - a) * t;
    let mix = |a: f32, b: f32| mix64(f64::from(a), f64::from(b)) as f32;
    let (v, w) = (&a.vertex, &b.vertex);
    let tmu = |i: usize| {
        let (a, b) = (&v.tmu[i], &w.tmu[i]);
        TmuVertex { s: mix(a.s, b.s), t: mix(a.t, b.t), w: mix(a.w, b.w) }
    };
    let vertex = Vertex {
        x: mix(v.x, w.x),
        y: mix(v.y, w.y),
        r: mix(v.r, w.r),
        g: mix(v.g, w.g),
        b: mix(v.b, w.b),
        a: mix(v.a, w.a),
        z: mix(v.z, w.z),
        w: mix(v.w, w.w),
        tmu: core::array::from_fn(tmu),
    };
    let (e, f) = (&a.extra, &b.extra);
    let extra = VertexExtra {
        specular: core::array::from_fn(|i| mix(e.specular[i], f.specular[i])),
        fog: mix(e.fog, f.fog),
        base: core::array::from_fn(|i| mix(e.base[i], f.base[i])),
        deep_z: mix64(e.deep_z, f.deep_z),
    };
    Corner { vertex, extra }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_left_fits() {
        let at = |x: f32, y: f32| Corner {
            vertex: Vertex { x, y, r: x, ..Vertex::default() },
            extra: VertexExtra::default(),
        };
        let polygon = to_guard(&[at(-1e30, 10.0), at(1e30, 0.0), at(100.0, 1e6)], (320, 220));
        assert!(
            polygon.len() >= 3
                && polygon.iter().all(|corner| fits(corner.vertex.x, corner.vertex.y))
        );
        assert!(
            to_guard(&[at(5000.0, 0.0), at(6000.0, 0.0), at(5000.0, 9.0)], (320, 220)).is_empty()
        );
        let cut = to_guard(&[at(0.0, 0.0), at(4000.0, 0.0), at(0.0, 100.0)], (320, 220));
        assert!(cut.iter().all(|corner| (corner.vertex.r - corner.vertex.x).abs() < 0.01));
    }
}
