//! The camera's path: a closed way through the players' starting points.

use crate::bsp::Bsp;
use crate::math::{Vec3, add, cross, length, mix, normalize, scale, sub};
use crate::view::Camera;
use crate::way;

/// Eyes are so far above a starting point.
const EYE: f32 = 40.0;
/// Players look so far ahead.
const AHEAD: f32 = 192.0;

/// The path.
#[derive(Clone, Debug)]
pub struct Path {
    /// Points of the closed way, in small steps.
    points: Vec<Vec3>,
    /// Length of the way up to each point, and of all of it.
    lengths: Vec<f32>,
    /// Where the path starts looking, for one of a single point.
    angle: f32,
}

impl Path {
    /// A path through the points, each followed by the nearest one left that
    /// a way leads to. Without points it stays at `otherwise`.
    pub fn new(bsp: &Bsp, spawns: &[(Vec3, f32)], otherwise: Vec3) -> Path {
        let mut left: Vec<Vec3> =
            spawns.iter().map(|&(point, _)| add(point, [0.0, 0.0, EYE])).collect();
        let start = if left.is_empty() { otherwise } else { left.remove(0) };
        let mut corners = vec![start];
        while !left.is_empty() {
            let last = corners[corners.len() - 1];
            let distance = |i: &usize| length(sub(left[*i], last)).to_bits();
            let next = (0..left.len()).min_by_key(distance).unwrap_or(0);
            // A point that nothing leads to is left out.
            if let Some(way) = way::find(bsp, last, left.remove(next)) {
                corners.extend(&way[1..]);
            }
        }
        let last = corners[corners.len() - 1];
        if corners.len() > 1 {
            let home = way::find(bsp, last, start);
            // Where there is no way home, it is the way there.
            let home = home.unwrap_or_else(|| corners.iter().rev().copied().collect());
            corners.extend(&home[1..home.len() - 1]);
        }
        let points = way::smooth(bsp, &corners);
        let mut lengths = vec![0.0];
        for (i, &point) in points.iter().enumerate() {
            let step = length(sub(points[(i + 1) % points.len()], point));
            lengths.push(lengths[i] + step);
        }
        Path { points, lengths, angle: spawns.first().map_or(0.0, |spawn| spawn.1) }
    }

    /// Length of the way.
    pub fn length(&self) -> f32 {
        self.lengths[self.lengths.len() - 1]
    }

    /// The point so far along the way.
    fn point(&self, along: f32) -> Vec3 {
        let all = self.length();
        if all < 1e-3 {
            return self.points[0];
        }
        let along = along.rem_euclid(all);
        let next = self.lengths.partition_point(|&length| length <= along);
        let i = next.clamp(1, self.points.len()) - 1;
        let step = self.lengths[i + 1] - self.lengths[i];
        let t = if step > 0.0 { (along - self.lengths[i]) / step } else { 0.0 };
        mix(self.points[i], self.points[(i + 1) % self.points.len()], t)
    }

    /// The mean of the way around a point: corners come slowly.
    fn around(&self, along: f32, reach: f32) -> Vec3 {
        const COUNT: i32 = 8;
        let at = |i: i32| self.point(along + reach * i as f32 / COUNT as f32);
        let sum = (-COUNT..=COUNT).fold([0.0; 3], |sum, i| add(sum, at(i)));
        scale(sum, 1.0 / (2 * COUNT + 1) as f32)
    }

    /// The camera at `t` of the loop, 0 to 1. It looks where it goes; at a
    /// single point it turns once around.
    pub fn camera(&self, t: f32) -> Camera {
        let turn = (self.angle + 360.0 * t).to_radians();
        let start = [turn.cos(), turn.sin(), 0.0];
        let along = t.rem_euclid(1.0) * self.length();
        let eye = self.point(along);
        let mut way = sub(self.around(along + AHEAD, AHEAD * 0.75), eye);
        // Half as steep: players look straight on.
        way[2] *= 0.5;
        let ahead = normalize(way, start);
        let right = normalize(cross(ahead, [0.0, 0.0, 1.0]), [0.0, -1.0, 0.0]);
        Camera { eye, forward: ahead, right, up: cross(right, ahead) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::entities;
    use crate::math::dot;
    use crate::synthetic;

    #[test]
    fn the_path_goes_through_doors_without_jumps() {
        let bsp = Bsp::parse(&synthetic::level()).expect("the level is valid");
        let spawns = entities::spawn_points(&entities::parse(&bsp.entities));
        let path = Path::new(&bsp, &spawns, [0.0; 3]);
        assert!(path.length() > 2000.0);
        let mut last = path.camera(0.0);
        let mut rooms = [0; 3];
        for i in 1..=2000 {
            let camera = path.camera(i as f32 / 2000.0);
            let between = (0..4).map(|i| mix(last.eye, camera.eye, i as f32 / 3.0));
            assert!(between.into_iter().all(|point| !bsp.is_solid(point)), "{i}: {camera:?}");
            assert!(length(sub(camera.eye, last.eye)) < 5.0);
            assert!(dot(camera.forward, last.forward) > 0.9, "{i}");
            assert!(dot(camera.forward, camera.right).abs() < 1e-3);
            rooms[((camera.eye[0] + 512.0) / 512.0) as usize] += 1;
            last = camera;
        }
        assert!(rooms.iter().all(|&count| count > 100), "{rooms:?}");
    }

    #[test]
    fn one_point_or_none_is_a_path_too() {
        let bsp = Bsp::default();
        for spawns in [&[][..], &[([1.0, 2.0, 3.0], 90.0)][..]] {
            let path = Path::new(&bsp, spawns, [0.0; 3]);
            assert!(path.camera(0.25).eye.iter().all(|v| v.is_finite()));
            assert!(dot(path.camera(0.0).forward, path.camera(0.5).forward) < -0.9);
        }
    }
}
