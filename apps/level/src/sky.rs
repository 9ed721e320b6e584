//! The sky: a box of pictures far away, and clouds on a dome above it.
//!
//! Coordinates of the clouds are angles: where the line from the eye meets a
//! sphere of radius 4096 that is so much above the eye as the clouds are high,
//! seen from the sphere's middle.

use crate::math::{Vec3, add, normalize, scale};

/// What names of the six pictures end with: +x, -x, +y, -y, up, down.
pub const SIDES: [&str; 6] = ["rt", "lf", "bk", "ft", "up", "dn"];

/// The radius of the world under the clouds.
const RADIUS: f32 = 4096.0;
/// How far away the sky is drawn; nothing is compared with it.
const FAR: f32 = 256.0;
/// Parts of a side that clouds are drawn in.
const PARTS: usize = 8;

/// A corner of the sky: direction and distance from the eye, and coordinates.
pub type Corner = (Vec3, [f32; 2]);

/// The place on a side, x to the right and y up, -1 to 1, as a direction.
fn on_side(side: usize, x: f32, y: f32) -> Vec3 {
    match side {
        0 => [1.0, -x, y],
        1 => [-1.0, x, y],
        2 => [x, 1.0, y],
        3 => [-x, -1.0, y],
        4 => [-y, -x, 1.0],
        _ => [y, -x, -1.0],
    }
}

/// One side of the box, its picture upright. The outermost texels are left
/// out: their neighbours are on another side.
pub fn side(side: usize) -> [Corner; 4] {
    const EDGE: f32 = 1.0 / 512.0;
    let corner = |x: f32, y: f32| {
        let st = [(x + 1.0) / 2.0, (1.0 - y) / 2.0].map(|v| v.clamp(EDGE, 1.0 - EDGE));
        (scale(on_side(side, x, y), FAR), st)
    };
    [corner(-1.0, 1.0), corner(1.0, 1.0), corner(1.0, -1.0), corner(-1.0, -1.0)]
}

/// Coordinates of the clouds in a direction, 0 to 1 from one horizon to the
/// other.
fn cloud_coordinates(way: Vec3, height: f32) -> [f32; 2] {
    let way = normalize(way, [0.0, 0.0, 1.0]);
    // From the eye on the world's surface to the sphere `height` above it.
    let up = way[2] * RADIUS;
    let reach = (up * up + 2.0 * RADIUS * height + height * height).sqrt() - up;
    let seen = normalize(add(scale(way, reach), [0.0, 0.0, RADIUS]), way);
    [seen[0], seen[1]].map(|v| v.clamp(-1.0, 1.0).acos())
}

/// The clouds as rectangles: everything above the horizon, and a little below.
pub fn clouds(height: f32) -> Vec<[Corner; 4]> {
    let mut out = Vec::new();
    for side in 0..5 {
        // Sides start where their lower half ends.
        let first = if side < 4 { PARTS / 2 - 1 } else { 0 };
        for (row, column) in (first..PARTS).flat_map(|r| (0..PARTS).map(move |c| (r, c))) {
            let corner = |column: usize, row: usize| {
                let at = |i: usize| i as f32 * 2.0 / PARTS as f32 - 1.0;
                let way = on_side(side, at(column), at(row));
                (scale(way, FAR), cloud_coordinates(way, height))
            };
            out.push([
                corner(column, row + 1),
                corner(column + 1, row + 1),
                corner(column + 1, row),
                corner(column, row),
            ]);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{cross, dot, sub};

    #[test]
    fn sides_are_seen_from_inside_and_meet() {
        for (i, name) in SIDES.into_iter().enumerate() {
            let [a, b, c, _] = side(i);
            // Right times down points away from the eye.
            let away = cross(sub(b.0, a.0), sub(c.0, b.0));
            assert!(dot(away, a.0) > 0.0, "{name}");
        }
        // The upper edge of the right side is an edge of the upper one.
        let up: Vec<Vec3> = side(4).iter().map(|corner| corner.0).collect();
        assert!(side(0)[..2].iter().all(|corner| up.contains(&corner.0)));
    }

    #[test]
    fn clouds_are_denser_at_the_horizon() {
        let [top, slanted] =
            [[0.0, 0.0, 1.0], [1.0, 0.0, 1.0]].map(|way| cloud_coordinates(way, 512.0));
        assert!((top[0] - core::f32::consts::FRAC_PI_2).abs() < 1e-5);
        let [low, lower] =
            [[1.0, 0.0, 0.1], [1.0, 0.0, 0.0]].map(|way| cloud_coordinates(way, 512.0));
        assert!(top[0] - slanted[0] > 0.05 && slanted[0] > low[0] && low[0] > lower[0]);
        let all = clouds(512.0);
        assert_eq!(all.len(), 4 * 40 + 64);
        assert!(all.iter().flatten().all(|(at, _)| at[2] >= -FAR * 0.26));
    }
}
