//! From the level to the screen: what is in sight, and where it lands.

use fillrate_glide::{GrTmuVertex, GrVertex};

use crate::level::Vertex;
use crate::math::{Vec3, dot, scale, sub};

/// Nothing nearer is drawn, in units of the level.
pub const NEAR: f32 = 4.0;
/// Pixels from the middle of the screen that coordinates may reach: the board
/// counts to 2047.
const GUARD: f32 = 1400.0;

/// Where the viewer is and looks. The directions are orthogonal, of length
/// one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// The eye.
    pub eye: Vec3,
    /// Ahead.
    pub forward: Vec3,
    /// To the right.
    pub right: Vec3,
    /// Up.
    pub up: Vec3,
}

/// A camera on a screen.
#[derive(Clone, Copy, Debug)]
pub struct View {
    camera: Camera,
    /// Pixels per unit at distance 1.
    focal: f32,
    center: [f32; 2],
    /// Half the screen over the focal length.
    slope: [f32; 2],
    /// The same for the guard band.
    guard: f32,
}

/// A vertex seen from the eye: x to the right, y up, z ahead.
#[derive(Clone, Copy, Debug)]
pub struct Seen {
    /// Position.
    pub at: Vec3,
    /// Texture coordinates.
    pub st: [f32; 2],
    /// Lightmap coordinates.
    pub light: [f32; 2],
    /// Red, green, blue.
    pub color: [f32; 3],
    /// Alpha.
    pub alpha: f32,
    /// Outside which planes: see [`OUTSIDE`] and [`CLIP`].
    pub code: u16,
}

/// Codes of the planes of the picture: all of a triangle's corners outside
/// one of them cannot be seen.
pub const OUTSIDE: u16 = 0b1_1111;
/// Codes of the planes that triangles are clipped against: the near one, and
/// the four of the guard band.
pub const CLIP: u16 = 0b1_1110_0001;

const NEAR_BIT: u16 = 1;
const SIDE_BITS: [u16; 4] = [1 << 1, 1 << 2, 1 << 3, 1 << 4];
const GUARD_BITS: [u16; 4] = [1 << 5, 1 << 6, 1 << 7, 1 << 8];

impl View {
    /// A camera whose picture is 90 degrees wide.
    pub fn new(camera: Camera, width: u32, height: u32) -> View {
        let (width, height) = (width as f32, height as f32);
        let focal = width / 2.0;
        View {
            camera,
            focal,
            center: [width / 2.0, height / 2.0],
            slope: [1.0, height / width],
            guard: GUARD / focal,
        }
    }

    /// Where the viewer is and looks.
    pub fn camera(&self) -> Camera {
        self.camera
    }

    /// The eye.
    pub fn eye(&self) -> Vec3 {
        self.camera.eye
    }

    /// Distance ahead of the eye.
    pub fn depth(&self, point: Vec3) -> f32 {
        dot(sub(point, self.camera.eye), self.camera.forward)
    }

    /// Whether part of a box may be in sight.
    pub fn may_see(&self, [low, high]: [Vec3; 2]) -> bool {
        let center = scale([low[0] + high[0], low[1] + high[1], low[2] + high[2]], 0.5);
        let half = scale(sub(high, low), 0.5);
        let d = sub(center, self.camera.eye);
        // How far the box reaches along a direction.
        let reach = |n: Vec3| half[0] * n[0].abs() + half[1] * n[1].abs() + half[2] * n[2].abs();
        let Camera { forward, right, up, .. } = self.camera;
        if dot(d, forward) + reach(forward) < NEAR {
            return false;
        }
        let sides = [(right, self.slope[0]), (up, self.slope[1])];
        sides.into_iter().all(|(side, slope)| {
            [-1.0, 1.0].into_iter().all(|sign: f32| {
                let plane = sub(scale(forward, slope), scale(side, sign));
                dot(d, plane) + reach(plane) >= 0.0
            })
        })
    }

    /// A vertex as the eye sees it.
    pub fn see(&self, v: &Vertex) -> Seen {
        let Camera { eye, forward, right, up } = self.camera;
        let d = sub(v.position, eye);
        let at = [dot(d, right), dot(d, up), dot(d, forward)];
        let Vertex { st, light, color, alpha, .. } = *v;
        Seen { at, st, light, color, alpha, code: self.code(at) }
    }

    fn code(&self, [x, y, z]: Vec3) -> u16 {
        let mut code = if z < NEAR { NEAR_BIT } else { 0 };
        let limits = [self.slope[0] * z, self.slope[1] * z];
        let outside = [x < -limits[0], x > limits[0], y < -limits[1], y > limits[1]];
        let guard = self.guard * z;
        let beyond = [x < -guard, x > guard, y < -guard, y > guard];
        for i in 0..4 {
            code |= if outside[i] { SIDE_BITS[i] } else { 0 };
            code |= if beyond[i] { GUARD_BITS[i] } else { 0 };
        }
        code
    }

    /// The distance of a point from a clipping plane, positive inside.
    fn distance(&self, plane: u16, [x, y, z]: Vec3) -> f32 {
        let guard = self.guard * z;
        match plane {
            NEAR_BIT => z - NEAR,
            bit if bit == GUARD_BITS[0] => guard + x,
            bit if bit == GUARD_BITS[1] => guard - x,
            bit if bit == GUARD_BITS[2] => guard + y,
            _ => guard - y,
        }
    }

    /// The part of a polygon that can be drawn, with new vertices where it is
    /// cut.
    pub fn clip(&self, polygon: &mut Vec<Seen>, scratch: &mut Vec<Seen>) {
        for plane in [NEAR_BIT].into_iter().chain(GUARD_BITS) {
            if polygon.iter().all(|v| v.code & plane == 0) && plane != NEAR_BIT {
                continue;
            }
            scratch.clear();
            for i in 0..polygon.len() {
                let (a, b) = (polygon[i], polygon[(i + 1) % polygon.len()]);
                let (da, db) = (self.distance(plane, a.at), self.distance(plane, b.at));
                if da >= 0.0 {
                    scratch.push(a);
                }
                if (da >= 0.0) != (db >= 0.0) {
                    scratch.push(self.between(&a, &b, da / (da - db)));
                }
            }
            core::mem::swap(polygon, scratch);
        }
    }

    fn between(&self, a: &Seen, b: &Seen, t: f32) -> Seen {
        let mix = |a: f32, b: f32| a + (b - a) * t;
        let two = |a: [f32; 2], b: [f32; 2]| [mix(a[0], b[0]), mix(a[1], b[1])];
        let three = |a: Vec3, b: Vec3| core::array::from_fn(|i| mix(a[i], b[i]));
        let at = three(a.at, b.at);
        let (st, light) = (two(a.st, b.st), two(a.light, b.light));
        let (color, alpha) = (three(a.color, b.color), mix(a.alpha, b.alpha));
        Seen { at, st, light, color, alpha, code: self.code(at) }
    }

    /// The vertex on the screen, with the lightmap's coordinates for the
    /// first unit and the picture's for the second; `swapped` the other way.
    /// z must be positive.
    pub fn project(&self, v: &Seen, swapped: bool) -> GrVertex {
        let oow = 1.0 / v.at[2];
        // Vertices snap to sixteenths of a pixel, so that edges shared by
        // surfaces stay shared.
        let snap = |v: f32| (v * 16.0).round() / 16.0;
        let tmu = |[s, t]: [f32; 2]| GrTmuVertex { sow: s * oow, tow: t * oow, oow };
        let (first, second) = if swapped { (v.st, v.light) } else { (v.light, v.st) };
        GrVertex {
            x: snap(self.center[0] + v.at[0] * oow * self.focal),
            y: snap(self.center[1] - v.at[1] * oow * self.focal),
            r: v.color[0],
            g: v.color[1],
            b: v.color[2],
            a: v.alpha,
            oow,
            tmuvtx: [tmu(first), tmu(second)],
            ..GrVertex::default()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn view() -> View {
        let camera = Camera {
            eye: [0.0; 3],
            forward: [1.0, 0.0, 0.0],
            right: [0.0, -1.0, 0.0],
            up: [0.0, 0.0, 1.0],
        };
        View::new(camera, 640, 480)
    }

    fn vertex(position: Vec3) -> Vertex {
        let (light, color, normal) = ([0.0; 2], [255.0; 3], [0.0, 0.0, 1.0]);
        Vertex { position, st: [position[0], 0.0], light, color, alpha: 255.0, normal }
    }

    #[test]
    fn points_ahead_land_where_they_should() {
        let v = view().project(&view().see(&vertex([100.0, -50.0, 25.0])), false);
        assert_eq!((v.x, v.y, v.oow), (480.0, 160.0, 0.01));
    }

    #[test]
    fn clipping_makes_new_vertices_at_the_near_plane() {
        let view = view();
        let corners = [[-10.0, 0.0, 0.0], [90.0, 0.0, 10.0], [90.0, 0.0, -10.0]];
        let mut polygon: Vec<Seen> = corners.iter().map(|&c| view.see(&vertex(c))).collect();
        view.clip(&mut polygon, &mut Vec::new());
        assert_eq!(polygon.len(), 4);
        for v in &polygon {
            assert!(v.at[2] >= NEAR - 1e-3, "{v:?}");
            // Attributes are cut at the same place.
            assert!((v.st[0] - v.at[2]).abs() < 1e-3, "{v:?}");
            let on_screen = view.project(v, false);
            assert!(on_screen.x.abs() < 2048.0 && on_screen.y.abs() < 2048.0);
        }
    }

    #[test]
    fn the_guard_band_keeps_coordinates_in_range() {
        let view = view();
        let corners = [[5.0, 9e4, 0.0], [5.0, -9e4, 3.0], [5.0, 0.0, 8e4]];
        let mut polygon: Vec<Seen> = corners.iter().map(|&c| view.see(&vertex(c))).collect();
        view.clip(&mut polygon, &mut Vec::new());
        assert!(polygon.len() >= 3);
        for v in &polygon {
            let v = view.project(v, false);
            assert!(v.x.abs() < 2047.0 && v.y.abs() < 2047.0, "{v:?}");
        }
    }

    #[test]
    fn boxes_out_of_sight_are_left_out() {
        let view = view();
        let around = |c: Vec3| [c.map(|v| v - 1.0), c.map(|v| v + 1.0)];
        assert!(view.may_see(around([100.0, 0.0, 0.0])));
        assert!(view.may_see(around([100.0, 100.0, 0.0])));
        assert!(!view.may_see(around([-100.0, 0.0, 0.0])));
        assert!(!view.may_see(around([100.0, 120.0, 0.0])));
        assert!(!view.may_see(around([100.0, 0.0, 90.0])));
    }
}
