use crate::{HalfSpace, Vec3};

/// A plane N.P = D. Points with N.P >= D are inside.
///
/// The distance has the unit of the world if the normal has length 1; signs,
/// and so clipping, are right with any length.
///
/// Source: TN, clipping a point to an arbitrary plane, which leaves points on
/// the plane open.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// N: points to the inside.
    pub normal: Vec3,
    /// D: N.P of every point P on the plane.
    pub distance: f32,
}

impl Plane {
    /// The plane with normal N that holds `point`: D = N.point.
    pub fn through(normal: Vec3, point: Vec3) -> Self {
        Self { normal, distance: normal.dot(point) }
    }

    /// The plane of three points, of normal length 1; its inside is the side
    /// from which, in left-handed space, the points turn clockwise.
    ///
    /// `None` if they lie on a line.
    pub fn of_points(a: Vec3, b: Vec3, c: Vec3) -> Option<Self> {
        let normal = (b - a).normalized()?.cross((c - a).normalized()?).normalized()?;
        Some(Self::through(normal, a))
    }

    /// The same plane with a normal of length 1.
    ///
    /// `None` if the plane has no normal or holds values out of range.
    pub fn normalized(&self) -> Option<Self> {
        let length = self.normal.length();
        if !self.is_usable() || length == 0.0 {
            return None;
        }
        Some(Self { normal: self.normal.normalized()?, distance: self.distance / length })
    }

    /// The plane with inside and outside exchanged.
    pub fn flipped(&self) -> Self {
        Self { normal: -self.normal, distance: -self.distance }
    }

    /// Whether a point is inside or on the plane.
    pub fn contains(&self, point: Vec3) -> bool {
        self.signed_distance(point) >= 0.0
    }
}

impl HalfSpace for Plane {
    fn signed_distance(&self, point: Vec3) -> f32 {
        self.normal.dot(point) - self.distance
    }

    fn is_usable(&self) -> bool {
        const MAX_DISTANCE: f32 = crate::MAX_MAGNITUDE * crate::MAX_MAGNITUDE * 4.0;
        self.normal.is_usable() && self.normal != Vec3::ZERO && self.distance.abs() <= MAX_DISTANCE
    }
}
