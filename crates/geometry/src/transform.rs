use crate::{Plane, Vec3, sin_cos};

/// A map of space: turn, stretch and shear, then shift.
///
/// A point p becomes (`rows[i]` . p) + `shift`, coordinate by coordinate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transform {
    /// What each coordinate of the result is of a point's coordinates.
    pub rows: [Vec3; 3],
    /// Added last.
    pub shift: Vec3,
}

impl Default for Transform {
    fn default() -> Self {
        Self::IDENTITY
    }
}

impl Transform {
    /// Changes nothing.
    pub const IDENTITY: Self = Self {
        rows: [Vec3::new(1.0, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.0), Vec3::new(0.0, 0.0, 1.0)],
        shift: Vec3::ZERO,
    };

    /// Moves by `shift`.
    pub const fn translation(shift: Vec3) -> Self {
        Self { shift, ..Self::IDENTITY }
    }

    /// Stretches each axis by its factor.
    pub const fn scaling(factors: Vec3) -> Self {
        Self {
            rows: [
                Vec3::new(factors.x, 0.0, 0.0),
                Vec3::new(0.0, factors.y, 0.0),
                Vec3::new(0.0, 0.0, factors.z),
            ],
            shift: Vec3::ZERO,
        }
    }

    /// Turns about the y axis by `angle` radians: from z towards x.
    pub fn turn_y(angle: f32) -> Self {
        let (sine, cosine) = sin_cos(angle);
        Self {
            rows: [
                Vec3::new(cosine, 0.0, sine),
                Vec3::new(0.0, 1.0, 0.0),
                Vec3::new(-sine, 0.0, cosine),
            ],
            shift: Vec3::ZERO,
        }
    }

    /// Turns about the x axis by `angle` radians: from y towards z.
    pub fn turn_x(angle: f32) -> Self {
        let (sine, cosine) = sin_cos(angle);
        Self {
            rows: [
                Vec3::new(1.0, 0.0, 0.0),
                Vec3::new(0.0, cosine, -sine),
                Vec3::new(0.0, sine, cosine),
            ],
            shift: Vec3::ZERO,
        }
    }

    /// World to view space for an eye at `eye` that looks along `forward`, with
    /// `up` pointing up on the screen (TN, camera coordinates).
    ///
    /// `None` if there is no such view: a direction without length, or both on
    /// one line.
    pub fn camera(eye: Vec3, forward: Vec3, up: Vec3) -> Option<Self> {
        if !eye.is_usable() {
            return None;
        }
        let ahead = forward.normalized()?;
        let right = up.normalized()?.cross(ahead).normalized()?;
        let up = ahead.cross(right);
        let shift = Vec3::new(-right.dot(eye), -up.dot(eye), -ahead.dot(eye));
        Some(Self { rows: [right, up, ahead], shift })
    }

    /// Where a point goes.
    pub fn point(&self, point: Vec3) -> Vec3 {
        self.direction(point) + self.shift
    }

    /// Where a direction goes: as a point, without the shift.
    pub fn direction(&self, direction: Vec3) -> Vec3 {
        let [x, y, z] = self.rows.map(|row| row.dot(direction));
        Vec3::new(x, y, z)
    }

    /// This map, then `next`.
    pub fn then(&self, next: &Self) -> Self {
        let column = |pick: fn(Vec3) -> f32| {
            let [x, y, z] = self.rows.map(pick);
            next.direction(Vec3::new(x, y, z))
        };
        let (a, b, c) = (column(|row| row.x), column(|row| row.y), column(|row| row.z));
        Self {
            rows: [Vec3::new(a.x, b.x, c.x), Vec3::new(a.y, b.y, c.y), Vec3::new(a.z, b.z, c.z)],
            shift: next.point(self.shift),
        }
    }

    /// The plane that this map takes to `plane`: a view's plane in the world,
    /// where `self` is the camera. N.(Mp + s) = D is (N M).p = D - N.s.
    ///
    /// Source: TN, checking the bounding sphere against the frustum, which
    /// advises to test objects in the world.
    pub fn plane_before(&self, plane: &Plane) -> Plane {
        let [a, b, c] = self.rows;
        let n = plane.normal;
        Plane { normal: a * n.x + b * n.y + c * n.z, distance: plane.distance - n.dot(self.shift) }
    }
}
