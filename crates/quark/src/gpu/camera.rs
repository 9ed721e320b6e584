//! Projection and the view frustum.
//!
//! Source: QK, 3D to 2D transform; frustrum clipping; clipping test.

use crate::clip;
use crate::error::QuarkError;
use crate::math::{ANGLE2PI, TRIGO_MUL, cosinus, sinus};

/// The nearest z that can be drawn; the camera looks along -z.
pub const CLIPZ_NEAR: i32 = -64;
/// The farthest z that can be drawn.
pub const CLIPZ_FAR: i32 = -4095;

/// How points of the world become points of the screen. Plain numbers, as the
/// original shows them; [`Camera::set_field_of_view`] and
/// [`Camera::set_planes`] keep them consistent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Camera {
    /// Columns and rows of the screen.
    pub size: [i32; 2],
    /// Distance of the screen from the eye, in pixels.
    pub zoom: i32,
    /// z of the near plane.
    pub near: i32,
    /// z of the far plane.
    pub far: i32,
    /// Unit normals of the bottom, top, left and right planes, inwards.
    pub frustum: [[i32; 3]; 4],
}

impl Camera {
    /// A camera for a screen.
    ///
    /// # Errors
    /// Those of [`Camera::set_planes`] and [`Camera::set_field_of_view`].
    pub fn new(size: [i32; 2], near: i32, far: i32, degrees: i32) -> Result<Camera, QuarkError> {
        let mut camera = Camera { size, zoom: 0, near: 0, far: 0, frustum: [[0; 3]; 4] };
        camera.set_planes(near, far)?;
        camera.set_field_of_view(degrees)?;
        Ok(camera)
    }

    /// Sets the horizontal field of view; returns half of it as an angle.
    ///
    /// # Errors
    /// [`QuarkError::FieldOfView`] outside 8 to 120 degrees; nothing changes.
    pub fn set_field_of_view(&mut self, degrees: i32) -> Result<i32, QuarkError> {
        if !(8..=120).contains(&degrees) {
            return Err(QuarkError::FieldOfView(degrees));
        }
        let half = degrees * ANGLE2PI / 720;
        let (sine, cosine) = (i32::from(sinus(half)), i32::from(cosinus(half)));
        self.zoom = cosine * (self.size[0] / 2) / sine;
        let [down, ahead] = self.vertical_half();
        self.frustum =
            [[0, down, -ahead], [0, -down, -ahead], [cosine, 0, -sine], [-cosine, 0, -sine]];
        Ok(half)
    }

    /// Cosine and sine of half the vertical field of view.
    fn vertical_half(&self) -> [i32; 2] {
        let half = i64::from(self.size[1] / 2);
        let zoom = i64::from(self.zoom);
        let length = (zoom * zoom + half * half).isqrt().max(1);
        [zoom, half].map(|side| (side * i64::from(TRIGO_MUL) / length) as i32)
    }

    /// Sets the near and far planes.
    ///
    /// # Errors
    /// [`QuarkError::Planes`] unless both lie in -4095..=-64, near above far;
    /// nothing changes.
    pub fn set_planes(&mut self, near: i32, far: i32) -> Result<(), QuarkError> {
        let allowed = CLIPZ_FAR..=CLIPZ_NEAR;
        if !allowed.contains(&near) || !allowed.contains(&far) || near <= far {
            return Err(QuarkError::Planes { near, far });
        }
        (self.near, self.far) = (near, far);
        Ok(())
    }

    /// The screen position and distance of a point, and its clip mask; `None`,
    /// with mask [`clip::NEAR`], where it is nearer than [`CLIPZ_NEAR`].
    pub fn project(&self, point: &[i32; 3]) -> (i32, Option<[i32; 3]>) {
        let [x, y, z] = point.map(i64::from);
        if z > i64::from(CLIPZ_NEAR) {
            return (clip::NEAR, None);
        }
        let zoom = i64::from(self.zoom);
        let limit = |n: i64| n.clamp(i32::MIN.into(), i32::MAX.into()) as i32;
        let column = limit(i64::from(self.size[0] / 2) + x * zoom / -z);
        let row = limit(i64::from(self.size[1] / 2) - y * zoom / -z);
        let bit = |hidden: bool, bit: i32| if hidden { bit } else { 0 };
        let mask = bit(row >= self.size[1], clip::BOTTOM)
            | bit(row < 0, clip::TOP)
            | bit(column < 0, clip::LEFT)
            | bit(column >= self.size[0], clip::RIGHT)
            | bit(point[2] < self.far, clip::FAR);
        (mask, Some([column, row, limit(-z)]))
    }

    /// The clip mask of a point, from the planes alone.
    pub fn clip_mask(&self, point: &[i32; 3]) -> i32 {
        let outside = |normal: &[i32; 3]| {
            let products = normal.iter().zip(point).map(|(&n, &p)| i128::from(n) * i128::from(p));
            products.sum::<i128>() < 0
        };
        let sides = [clip::BOTTOM, clip::TOP, clip::LEFT, clip::RIGHT];
        let mask = self.frustum.iter().zip(sides).filter(|(normal, _)| outside(normal));
        let mut mask = mask.fold(0, |mask, (_, bit)| mask | bit);
        if point[2] < self.far {
            mask |= clip::FAR;
        }
        if point[2] > self.near {
            mask |= clip::NEAR;
        }
        mask
    }

    /// Whether a box, given by its corners, may be visible.
    pub fn crosses_frustum(&self, corners: &[[i32; 3]; 8]) -> bool {
        corners.iter().fold(!0, |mask, corner| mask & self.clip_mask(corner)) == 0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn camera(degrees: i32) -> Camera {
        Camera::new([240, 320], -64, -4095, degrees).unwrap()
    }

    #[test]
    fn zooms_of_some_angles() {
        for (degrees, half, zoom) in
            [(8, 91, 1715), (45, 512, 289), (60, 682, 208), (90, 1024, 120), (120, 1365, 69)]
        {
            let mut camera = camera(90);
            assert_eq!(camera.set_field_of_view(degrees), Ok(half));
            assert_eq!(camera.zoom, zoom, "{degrees}");
        }
        for degrees in [7, 121, 0, -60, i32::MAX] {
            let mut camera = camera(90);
            assert!(camera.set_field_of_view(degrees).is_err());
            assert_eq!(camera.zoom, 120);
        }
    }

    #[test]
    fn planes_have_their_range() {
        let mut camera = camera(60);
        for (near, far) in [(-63, -100), (-64, -4096), (-100, -100), (-200, -100), (1, i32::MIN)] {
            assert!(camera.set_planes(near, far).is_err());
            assert_eq!((camera.near, camera.far), (-64, -4095));
        }
        assert_eq!(camera.set_planes(-400, -401), Ok(()));
    }

    #[test]
    fn points_of_the_screen() {
        let camera = camera(90);
        assert_eq!(camera.project(&[0, 0, -64]), (0, Some([120, 160, 64])));
        assert_eq!(camera.project(&[0, 0, -63]), (clip::NEAR, None));
        assert_eq!(camera.project(&[100, 50, -120]), (0, Some([220, 110, 120])));
        assert_eq!(camera.project(&[-200, 0, -100]).0, clip::LEFT);
        assert_eq!(camera.project(&[200, 0, -4096]).0, clip::FAR);
        assert_eq!(camera.project(&[120, -160, -120]).0, clip::RIGHT | clip::BOTTOM);
        for n in [i32::MIN, i32::MAX] {
            camera.project(&[n, n, i32::MIN]);
            camera.clip_mask(&[n, n, n]);
        }
    }

    /// Away from the borders both ways to a mask agree.
    #[test]
    fn planes_agree_with_the_projection() {
        let camera = camera(60);
        for z in [-64, -100, -800, -4000, -5000] {
            for x in (-6000..6000).step_by(173) {
                for y in (-6000..6000).step_by(191) {
                    let (mask, at) = camera.project(&[x, y, z]);
                    let [column, row, _] = at.unwrap();
                    let edges = [column, 239 - column, row, 319 - row];
                    if edges.iter().all(|distance| distance.abs() > 2) {
                        assert_eq!(camera.clip_mask(&[x, y, z]), mask, "{x} {y} {z}");
                    }
                }
            }
        }
    }

    #[test]
    fn boxes() {
        let camera = camera(60);
        let cube = |at: [i32; 3], side: i32| -> [[i32; 3]; 8] {
            std::array::from_fn(|i| std::array::from_fn(|k| at[k] + side * (i >> k & 1) as i32))
        };
        assert!(camera.crosses_frustum(&cube([-50, -50, -500], 100)));
        assert!(camera.crosses_frustum(&cube([-5000, -5000, -9000], 10000)));
        assert!(!camera.crosses_frustum(&cube([-50, -50, 100], 100)));
        assert!(!camera.crosses_frustum(&cube([5000, 0, -500], 100)));
    }
}
