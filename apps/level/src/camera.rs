//! The camera's path: a closed curve through the players' starting points.

use crate::math::{Vec3, add, cross, length, mix, normalize, scale, sub};
use crate::view::Camera;

/// Eyes are so far above a starting point.
const EYE: f32 = 40.0;

/// The path.
#[derive(Clone, Debug)]
pub struct Path {
    points: Vec<Vec3>,
    /// The middle of the points.
    middle: Vec3,
    /// Where the curve starts looking, for a path of one point.
    angle: f32,
}

impl Path {
    /// A path through the points, each followed by the nearest one left.
    /// Without points it stays at `otherwise`.
    pub fn new(spawns: &[(Vec3, f32)], otherwise: Vec3) -> Path {
        let mut left: Vec<Vec3> =
            spawns.iter().map(|&(point, _)| add(point, [0.0, 0.0, EYE])).collect();
        let mut points = vec![if left.is_empty() { otherwise } else { left.remove(0) }];
        while !left.is_empty() {
            let last = points[points.len() - 1];
            let distance = |i: &usize| length(sub(left[*i], last)).to_bits();
            let next = (0..left.len()).min_by_key(distance).unwrap_or(0);
            points.push(left.remove(next));
        }
        let sum = points.iter().fold([0.0; 3], |sum, &point| add(sum, point));
        let middle = scale(sum, 1.0 / points.len() as f32);
        Path { points, middle, angle: spawns.first().map_or(0.0, |spawn| spawn.1) }
    }

    /// The point at `t` of the loop, 0 to 1: a Catmull-Rom spline.
    fn point(&self, t: f32) -> Vec3 {
        let count = self.points.len();
        let at = t.rem_euclid(1.0) * count as f32;
        let (i, t) = (at as usize % count, at.fract());
        let p = |offset: usize| self.points[(i + count - 1 + offset) % count];
        let tangent = |a: Vec3, b: Vec3| scale(sub(b, a), 0.5);
        let (a, b) = (p(1), p(2));
        let (ta, tb) = (tangent(p(0), b), tangent(a, p(3)));
        let (t2, t3) = (t * t, t * t * t);
        let sum = add(scale(a, 2.0 * t3 - 3.0 * t2 + 1.0), scale(b, -2.0 * t3 + 3.0 * t2));
        add(sum, add(scale(ta, t3 - 2.0 * t2 + t), scale(tb, t3 - t2)))
    }

    /// The camera at `t` of the loop, 0 to 1. It looks where it goes, and a
    /// little to the middle; at a single point it turns once around.
    pub fn camera(&self, t: f32) -> Camera {
        let eye = self.point(t);
        let turn = (self.angle + 360.0 * t).to_radians();
        let start = [turn.cos(), turn.sin(), 0.0];
        let ahead = match self.points.len() {
            1 => start,
            // A stretch ahead, half as steep: players look straight on.
            count => {
                let step = 0.35 / count as f32;
                let there = mix(self.point(t + step * 0.5), self.point(t + step), 0.5);
                let mut way = sub(there, eye);
                let inwards = sub(self.middle, eye);
                way = add(way, scale(inwards, 0.3 * length(way) / (length(inwards) + 200.0)));
                way[2] *= 0.5;
                normalize(way, start)
            }
        };
        let right = normalize(cross(ahead, [0.0, 0.0, 1.0]), [0.0, -1.0, 0.0]);
        Camera { eye, forward: ahead, right, up: cross(right, ahead) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::dot;

    #[test]
    fn the_path_goes_through_its_points_without_jumps() {
        let spawns = [([0.0, 0.0, 0.0], 0.0), ([500.0, 0.0, 0.0], 0.0), ([0.0, 400.0, 64.0], 0.0)];
        let path = Path::new(&spawns, [0.0; 3]);
        assert_eq!(path.point(0.0), [0.0, 0.0, 40.0]);
        let mut last = path.camera(0.0);
        for i in 1..=1000 {
            let camera = path.camera(i as f32 / 1000.0);
            assert!(length(sub(camera.eye, last.eye)) < 5.0);
            assert!(dot(camera.forward, last.forward) > 0.9, "{i}");
            assert!(dot(camera.forward, camera.right).abs() < 1e-3);
            last = camera;
        }
    }

    #[test]
    fn one_point_or_none_is_a_path_too() {
        for spawns in [&[][..], &[([1.0, 2.0, 3.0], 90.0)][..]] {
            let path = Path::new(spawns, [0.0; 3]);
            assert!(path.camera(0.25).eye.iter().all(|v| v.is_finite()));
            assert!(dot(path.camera(0.0).forward, path.camera(0.5).forward) < -0.9);
        }
    }
}
