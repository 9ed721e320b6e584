//! Cutting primitives at the borders of the view, with new vertices.
//!
//! Beyond the thesis, which drops a primitive that crosses the near plane (RAW, chapter 6). In clip
//! space every attribute is linear, so new vertices are weighted sums of two old ones.

use super::Vertex;
use super::geometry::MIN_W;
use crate::state::clip;

/// A plane as the signed distance of a vertex from it: positive inside.
type Distance = fn(&Vertex) -> f32;

/// In front of the eye, then the planes in the order near, far, left, right, top, bottom.
const PLANES: [Distance; 7] = [
    |v| v.w1 - MIN_W,
    |v| v.z + v.w1,
    |v| v.w1 - v.z,
    |v| v.x + v.w1,
    |v| v.w1 - v.x,
    |v| v.y + v.w1,
    |v| v.w1 - v.y,
];

fn planes(mode: u32) -> &'static [Distance] {
    match mode {
        clip::DROP => &[],
        clip::NEAR => &PLANES[..2],
        _ => &PLANES,
    }
}

/// Cuts a triangle; returns the corners of the polygon that is left, none if nothing is.
/// `new_vertices` counts the vertices made.
pub fn triangle(corners: [Vertex; 3], mode: u32, new_vertices: &mut u32) -> Vec<Vertex> {
    let mut polygon = corners.to_vec();
    for distance in planes(mode) {
        // Most triangles lie on one side of most planes.
        if polygon.iter().all(|v| distance(v) >= 0.0) {
            continue;
        }
        polygon = cut(&polygon, *distance, new_vertices);
    }
    if polygon.len() < 3 { Vec::new() } else { polygon }
}

fn cut(polygon: &[Vertex], distance: Distance, new_vertices: &mut u32) -> Vec<Vertex> {
    let mut out = Vec::with_capacity(polygon.len() + 1);
    let next = polygon.iter().cycle().skip(1);
    for (a, b) in polygon.iter().zip(next) {
        let (da, db) = (distance(a), distance(b));
        if da >= 0.0 {
            out.push(*a);
        }
        // From the inside out, so that two triangles cut a shared edge in the same point.
        if da >= 0.0 && db < 0.0 {
            out.push(between(a, b, da, db));
            *new_vertices += 1;
        } else if da < 0.0 && db >= 0.0 {
            out.push(between(b, a, db, da));
            *new_vertices += 1;
        }
    }
    out
}

/// Cuts a line; `None` if nothing is left.
pub fn line(ends: [Vertex; 2], mode: u32, new_vertices: &mut u32) -> Option<[Vertex; 2]> {
    let [mut a, mut b] = ends;
    for distance in planes(mode) {
        let (da, db) = (distance(&a), distance(&b));
        if da >= 0.0 && db >= 0.0 {
            continue;
        }
        *new_vertices += 1;
        if da >= 0.0 {
            b = between(&a, &b, da, db);
        } else if db >= 0.0 {
            a = between(&b, &a, db, da);
        } else {
            return None;
        }
    }
    Some([a, b])
}

/// Whether a point is inside.
pub fn point(v: &Vertex, mode: u32) -> bool {
    planes(mode).iter().all(|distance| distance(v) >= 0.0)
}

/// Where the edge from `a` inside to `b` outside meets the plane; `da` and `db` are the distances.
fn between(a: &Vertex, b: &Vertex, da: f32, db: f32) -> Vertex {
    let t = da / (da - db);
    let mix = |p: f32, q: f32| p + t * (q - p);
    Vertex {
        x: mix(a.x, b.x),
        y: mix(a.y, b.y),
        z: mix(a.z, b.z),
        w1: mix(a.w1, b.w1),
        u: mix(a.u, b.u),
        v: mix(a.v, b.v),
        rgba: std::array::from_fn(|i| mix(a.rgba[i], b.rgba[i])),
        intensity: mix(a.intensity, b.intensity),
        more: std::array::from_fn(|i| mix(a.more[i], b.more[i])),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(x: f32, y: f32, z: f32, w: f32) -> Vertex {
        Vertex { x, y, z, w1: w, u: x, ..Vertex::default() }
    }

    #[test]
    fn one_vertex_behind_gives_a_quad_and_two_a_triangle() {
        let mut new = 0;
        let one = [at(0.0, 0.0, -2.0, 1.0), at(1.0, 0.0, 0.5, 1.0), at(0.0, 1.0, 0.5, 1.0)];
        let quad = triangle(one, clip::NEAR, &mut new);
        assert_eq!((quad.len(), new), (4, 2));
        for v in &quad {
            assert!(v.z >= -v.w1 - 1e-6 && (v.u - v.x).abs() < 1e-6, "{v:?}");
        }
        let two = [at(0.0, 0.0, -2.0, 1.0), at(1.0, 0.0, -2.0, 1.0), at(0.0, 1.0, 0.5, 1.0)];
        assert_eq!(triangle(two, clip::NEAR, &mut new).len(), 3);
        let all = [at(0.0, 0.0, -2.0, 1.0), at(1.0, 0.0, -2.0, 1.0), at(0.0, 1.0, -3.0, 1.0)];
        assert!(triangle(all, clip::NEAR, &mut new).is_empty());
    }

    #[test]
    fn the_frustum_cuts_a_huge_triangle_to_the_screen() {
        let huge = [at(-9.0, -9.0, 0.0, 1.0), at(9.0, -9.0, 0.0, 1.0), at(0.0, 9.0, 0.0, 1.0)];
        let left = triangle(huge, clip::FRUSTUM, &mut 0);
        assert!((3..=9).contains(&left.len()));
        assert!(left.iter().all(|v| v.x.abs() <= 1.0001 && v.y.abs() <= 1.0001));
    }

    #[test]
    fn nothing_undefined_survives() {
        let bad =
            [at(f32::NAN, 0.0, f32::NAN, 1.0), at(1.0, 0.0, 0.0, f32::NAN), at(0., 1., 0., 1.)];
        let left = triangle(bad, clip::FRUSTUM, &mut 0);
        assert!(left.len() <= 9);
        assert!(!point(&at(0.0, 0.0, 0.0, f32::NAN), clip::NEAR));
    }
}
