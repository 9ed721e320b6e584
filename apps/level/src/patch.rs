//! Quadratic Bezier patches to triangles.

use crate::bsp::Vertex;
use crate::math::{add, length, scale, sub};

/// The most control points along a side.
const MAX_SIDE: usize = 129;
/// The most segments a curve of three control points is cut into.
const MAX_SEGMENTS: usize = 16;

/// Vertices and triangles (three indices each).
pub type Mesh = (Vec<Vertex>, Vec<u32>);

/// The point at t of the curve with these control points.
fn curve([a, b, c]: [Vertex; 3], t: f32) -> Vertex {
    let (wa, wb, wc) = ((1.0 - t) * (1.0 - t), 2.0 * t * (1.0 - t), t * t);
    let two = |a: [f32; 2], b: [f32; 2], c: [f32; 2]| {
        core::array::from_fn(|i| a[i] * wa + b[i] * wb + c[i] * wc)
    };
    let channel = |i: usize| {
        let sum = f32::from(a.color[i]) * wa + f32::from(b.color[i]) * wb;
        (sum + f32::from(c.color[i]) * wc) as u8
    };
    Vertex {
        position: add(add(scale(a.position, wa), scale(b.position, wb)), scale(c.position, wc)),
        st: two(a.st, b.st, c.st),
        light: two(a.light, b.light, c.light),
        normal: add(add(scale(a.normal, wa), scale(b.normal, wb)), scale(c.normal, wc)),
        color: core::array::from_fn(channel),
    }
}

/// How far the middle of a curve is from the line between its ends.
fn bulge([a, b, c]: &[Vertex; 3]) -> f32 {
    let middle = scale(add(a.position, c.position), 0.5);
    length(sub(b.position, middle)) / 2.0
}

/// Segments that keep a curve within `error` units of itself.
fn segments(bulge: f32, error: f32) -> usize {
    ((bulge / error).sqrt().ceil() as usize).clamp(1, MAX_SEGMENTS)
}

/// The triangles of a grid of control points, within about `error` units of
/// the surface. Neighbouring patches of one grid share their points. `None`
/// for a grid whose sides are not odd and 3 or more.
pub fn tessellate(points: &[Vertex], width: usize, height: usize, error: f32) -> Option<Mesh> {
    let side = |n: usize| n % 2 == 1 && (3..=MAX_SIDE).contains(&n);
    if !side(width) || !side(height) || points.len() != width * height {
        return None;
    }
    let at = |x: usize, y: usize| points[y * width + x];
    let rows = |y: usize| (0..width / 2).map(move |p| core::array::from_fn(|i| at(2 * p + i, y)));
    let columns =
        |x: usize| (0..height / 2).map(move |p| core::array::from_fn(|i| at(x, 2 * p + i)));
    let most = |curves: &mut dyn Iterator<Item = [Vertex; 3]>| {
        curves.map(|curve| bulge(&curve)).fold(0.0, f32::max)
    };
    let across = segments(most(&mut (0..height).flat_map(rows)), error);
    let down = segments(most(&mut (0..width).flat_map(columns)), error);
    let (columns, rows) = (width / 2 * across + 1, height / 2 * down + 1);
    let mut vertices = Vec::with_capacity(columns * rows);
    for row in 0..rows {
        let (py, v) = part(row, down, height / 2);
        for column in 0..columns {
            let (px, u) = part(column, across, width / 2);
            let line = |i: usize| curve(core::array::from_fn(|j| at(2 * px + j, 2 * py + i)), u);
            vertices.push(curve(core::array::from_fn(line), v));
        }
    }
    Some((vertices, grid_triangles(columns, rows)))
}

/// The patch and the place in it of a point of the fine grid.
fn part(index: usize, segments: usize, patches: usize) -> (usize, f32) {
    let patch = (index / segments).min(patches - 1);
    (patch, (index - patch * segments) as f32 / segments as f32)
}

fn grid_triangles(columns: usize, rows: usize) -> Vec<u32> {
    let mut triangles = Vec::with_capacity((columns - 1) * (rows - 1) * 6);
    for y in 0..rows - 1 {
        for x in 0..columns - 1 {
            let a = (y * columns + x) as u32;
            let (b, c) = (a + 1, a + columns as u32);
            triangles.extend([a, c, b, b, c, c + 1]);
        }
    }
    triangles
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(x: f32, y: f32, z: f32) -> Vertex {
        Vertex { position: [x, y, z], st: [x, y], ..Vertex::default() }
    }

    #[test]
    fn a_flat_patch_is_two_triangles() {
        let points: Vec<Vertex> =
            (0..9).map(|i| point((i % 3) as f32, (i / 3) as f32, 0.0)).collect();
        let (vertices, triangles) = tessellate(&points, 3, 3, 1.0).unwrap();
        assert_eq!((vertices.len(), triangles.len()), (4, 6));
    }

    #[test]
    fn a_curved_patch_passes_through_its_corners_and_middle() {
        let z = |i: usize| if i % 3 == 1 { 32.0 } else { 0.0 };
        let points: Vec<Vertex> =
            (0..15).map(|i| point((i % 3) as f32, (i / 3) as f32, z(i))).collect();
        let (vertices, triangles) = tessellate(&points, 3, 5, 1.0).unwrap();
        // 16 units of bulge at one unit of error: four segments.
        assert_eq!(vertices.len(), 5 * 3);
        assert_eq!(triangles.len(), 4 * 2 * 6);
        assert_eq!(vertices[0].position, [0.0, 0.0, 0.0]);
        assert_eq!(vertices[2].position, [1.0, 0.0, 16.0]);
        assert_eq!(vertices[14].position, [2.0, 4.0, 0.0]);
        assert!(triangles.iter().all(|&i| (i as usize) < vertices.len()));
    }

    #[test]
    fn bad_grids_are_refused() {
        let points = vec![Vertex::default(); 16];
        for (width, height) in [(4, 4), (3, 3), (1, 16), (0, 0), (usize::MAX, 3)] {
            assert!(tessellate(&points, width, height, 1.0).is_none());
        }
    }
}
