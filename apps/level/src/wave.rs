//! Functions of time, and what they move.

use std::f32::consts::TAU;

use crate::math::{Vec3, add, cross, dot, length, normalize, scale, sub};
use crate::script::{Deform, Gen, Move};

/// The form of a function, of period 1 and between -1 and 1, or 0 and 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Shape {
    /// Sine.
    #[default]
    Sine,
    /// Up, down, and up again.
    Triangle,
    /// 1, then -1.
    Square,
    /// From 0 to 1.
    Sawtooth,
    /// From 1 to 0.
    InverseSawtooth,
    /// Anything.
    Noise,
}

/// base + amplitude * shape(phase + frequency * time).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wave {
    /// The form.
    pub shape: Shape,
    /// What is added.
    pub base: f32,
    /// What it is multiplied with.
    pub amplitude: f32,
    /// Where it starts, in periods.
    pub phase: f32,
    /// Periods a second.
    pub frequency: f32,
}

impl Wave {
    /// Its value at a time in seconds, `ahead` periods later.
    pub fn at(&self, time: f32, ahead: f32) -> f32 {
        let periods = self.phase + ahead + self.frequency * time;
        let t = periods.rem_euclid(1.0);
        let value = match self.shape {
            Shape::Sine => (t * TAU).sin(),
            Shape::Triangle if t < 0.25 => 4.0 * t,
            Shape::Triangle if t < 0.75 => 2.0 - 4.0 * t,
            Shape::Triangle => 4.0 * t - 4.0,
            Shape::Square if t < 0.5 => 1.0,
            Shape::Square => -1.0,
            Shape::Sawtooth => t,
            Shape::InverseSawtooth => 1.0 - t,
            Shape::Noise => {
                let step = (periods * 8.0).floor() as i64 as u32;
                let mixed = (step ^ step >> 7).wrapping_mul(0x9e37_79b1);
                ((mixed ^ mixed >> 15) & 0xffff) as f32 / 32768.0 - 1.0
            }
        };
        self.base + self.amplitude * value
    }
}

impl Gen {
    /// Whether it is everywhere all.
    pub fn is_identity(&self) -> bool {
        *self == Gen::Identity
    }

    /// The colour (or alpha, the same three times), 0 to 255.
    pub fn at(&self, vertex: Vec3, time: f32) -> Vec3 {
        match self {
            Gen::Identity => [255.0; 3],
            Gen::Vertex => vertex,
            Gen::OneMinusVertex => vertex.map(|v| 255.0 - v),
            Gen::Const(color) => color.map(|v| v.clamp(0.0, 1.0) * 255.0),
            Gen::Wave(wave) => [wave.at(time, 0.0).clamp(0.0, 1.0) * 255.0; 3],
        }
    }
}

/// Texture coordinates of a place after everything that moves them.
pub fn moved(moves: &[Move], st: [f32; 2], place: Vec3, time: f32) -> [f32; 2] {
    moves.iter().fold(st, |[s, t], moving| match moving {
        Move::Scale(by_s, by_t) => [s * by_s, t * by_t],
        // Whole repetitions are nothing, and large numbers are coarse.
        Move::Scroll(by_s, by_t) => [s + (by_s * time).fract(), t + (by_t * time).fract()],
        Move::Rotate(degrees) => {
            let (sin, cos) = (-degrees * time).rem_euclid(360.0).to_radians().sin_cos();
            let (s, t) = (s - 0.5, t - 0.5);
            [s * cos - t * sin + 0.5, s * sin + t * cos + 0.5]
        }
        Move::Stretch(wave) => {
            let by = wave.at(time, 0.0);
            let by = if by.abs() > 1e-3 { 1.0 / by } else { 0.0 };
            [(s - 0.5) * by + 0.5, (t - 0.5) * by + 0.5]
        }
        Move::Turbulence(wave) => {
            let swim = |at: f32| Wave { base: 0.0, ..*wave }.at(time, at);
            [s + swim((place[0] + place[2]) / 1024.0), t + swim(place[1] / 1024.0)]
        }
        Move::Transform([ss, st, ts, tt], [os, ot]) => [s * ss + t * ts + os, s * st + t * tt + ot],
    })
}

/// Coordinates of what a place with this normal reflects to the eye.
pub fn reflected(place: Vec3, normal: Vec3, eye: Vec3) -> [f32; 2] {
    let way = normalize(sub(eye, place), normal);
    let back = sub(scale(normal, 2.0 * dot(normal, way)), way);
    [0.5 + back[1] * 0.5, 0.5 - back[2] * 0.5]
}

/// A vertex that may move: its place, normal, and texture coordinates.
#[derive(Clone, Copy, Debug)]
pub struct Point {
    /// Place.
    pub at: Vec3,
    /// Normal.
    pub normal: Vec3,
    /// Coordinates.
    pub st: [f32; 2],
}

/// Moves a surface's vertices. Rectangles are four vertices each; `right` and
/// `up` are the viewer's.
pub fn deform(deforms: &[Deform], points: &mut [Point], time: f32, right: Vec3, up: Vec3) {
    for deform in deforms {
        match *deform {
            Deform::Sprite => {
                points.as_chunks_mut::<4>().0.iter_mut().for_each(|p| face(p, right, up));
            }
            Deform::Axis => {
                points.as_chunks_mut::<4>().0.iter_mut().for_each(|p| turn(p, cross(right, up)));
            }
            Deform::Wave(spread, wave) => {
                for p in points.iter_mut() {
                    let ahead = (p.at[0] + p.at[1] + p.at[2]) * spread;
                    p.at = add(p.at, scale(p.normal, wave.at(time, ahead)));
                }
            }
            Deform::Bulge(width, height, speed) => {
                for p in points.iter_mut() {
                    let angle = p.st[0] * width + time * speed;
                    p.at = add(p.at, scale(p.normal, angle.sin() * height));
                }
            }
            Deform::Move(way, wave) => {
                let by = scale(way, wave.at(time, 0.0));
                points.iter_mut().for_each(|p| p.at = add(p.at, by));
            }
        }
    }
}

fn middle(corners: &[Point; 4]) -> Vec3 {
    scale(corners.iter().fold([0.0; 3], |sum, p| add(sum, p.at)), 0.25)
}

/// A square of the same size around the same middle, seen from in front.
fn face(corners: &mut [Point; 4], right: Vec3, up: Vec3) {
    let center = middle(corners);
    let radius = length(sub(corners[0].at, center)) * core::f32::consts::FRAC_1_SQRT_2;
    for corner in corners {
        let side = |v: f32| if v < 0.5 { -radius } else { radius };
        let (x, y) = (side(corner.st[0]), side(1.0 - corner.st[1]));
        corner.at = add(center, add(scale(right, x), scale(up, y)));
    }
}

/// Turns a rectangle around its longer axis to the viewer, who looks along
/// -`back`.
fn turn(corners: &mut [Point; 4], back: Vec3) {
    // The two shorter sides; their middles end the axis.
    let long = length(sub(corners[1].at, corners[0].at));
    let across = length(sub(corners[2].at, corners[1].at));
    let shorter = if long < across { [[0, 1], [2, 3]] } else { [[1, 2], [3, 0]] };
    let ends = shorter.map(|[a, b]| scale(add(corners[a].at, corners[b].at), 0.5));
    let axis = normalize(sub(ends[1], ends[0]), [0.0, 0.0, 1.0]);
    let half = long.min(across) / 2.0;
    let side = scale(normalize(cross(axis, back), axis), half);
    // Corners keep their order around the rectangle.
    for ([a, b], (end, sign)) in shorter.into_iter().zip(ends.into_iter().zip([1.0, -1.0])) {
        corners[a].at = add(end, scale(side, sign));
        corners[b].at = sub(end, scale(side, sign));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shapes_have_their_corners() {
        let value = |shape: Shape, t: f32| {
            Wave { shape, base: 1.0, amplitude: 2.0, phase: t, frequency: 0.0 }.at(3.0, 0.0)
        };
        assert!((value(Shape::Sine, 0.25) - 3.0).abs() < 1e-5);
        assert_eq!(
            [0.0, 0.25, 0.5, 0.75].map(|t| value(Shape::Triangle, t)),
            [1.0, 3.0, 1.0, -1.0]
        );
        assert_eq!([0.1, 0.6].map(|t| value(Shape::Square, t)), [3.0, -1.0]);
        assert_eq!(value(Shape::Sawtooth, 0.5), 2.0);
        assert_eq!(value(Shape::InverseSawtooth, 0.25), 2.5);
        assert!((0..100).map(|i| value(Shape::Noise, i as f32 / 7.0)).all(|v| v.abs() <= 3.0));
    }

    #[test]
    fn coordinates_move_in_order() {
        let at = |moves: &[Move], time| moved(moves, [0.25, 0.5], [0.0; 3], time);
        assert_eq!(at(&[Move::Scroll(1.0, 0.5), Move::Scale(2.0, 2.0)], 0.5), [1.5, 1.5]);
        let [s, t] = at(&[Move::Rotate(90.0)], 1.0);
        assert!((s - 0.5).abs() < 1e-5 && (t - 0.75).abs() < 1e-5, "{s} {t}");
        let still = Wave { base: 2.0, ..Wave::default() };
        assert_eq!(at(&[Move::Stretch(still)], 1.0), [0.375, 0.5]);
    }

    #[test]
    fn sprites_face_the_viewer() {
        let st = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let mut corners = st.map(|st| Point {
            at: [st[0] * 10.0, 0.0, 20.0 - st[1] * 10.0],
            normal: [0.0, -1.0, 0.0],
            st,
        });
        let (right, up) = ([0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
        deform(&[Deform::Sprite], &mut corners, 0.0, right, up);
        for (corner, st) in corners.iter().zip(st) {
            let expected = [5.0, st[0] * 10.0 - 5.0, 20.0 - st[1] * 10.0];
            assert!(length(sub(corner.at, expected)) < 1e-3, "{corner:?}");
        }
        // A tall beam keeps its ends and its width.
        let tall = [[0.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 2.0, 50.0], [0.0, 0.0, 50.0]];
        let mut beam = tall.map(|at| Point { at, normal: [1.0, 0.0, 0.0], st: [0.0; 2] });
        deform(&[Deform::Axis], &mut beam, 0.0, [1.0, 0.0, 0.0], up);
        assert!((length(sub(beam[0].at, beam[1].at)) - 2.0).abs() < 1e-3);
        assert!((beam[0].at[0] - beam[1].at[0]).abs() > 1.9);
        assert!(beam.iter().all(|p| p.at[2] == 0.0 || p.at[2] == 50.0));
    }
}
