use std::ops::BitOr;

use crate::{HalfSpace, Plane, Transform, Vec3, Vertex, View};

/// A set of the planes of a [`Frustum`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct PlaneMask(u8);

impl PlaneMask {
    /// No plane.
    pub const NONE: Self = Self(0);
    /// z >= hither.
    pub const HITHER: Self = Self(1);
    /// z <= yon.
    pub const YON: Self = Self(2);
    /// The side at greater x.
    pub const RIGHT: Self = Self(4);
    /// The side at smaller x.
    pub const LEFT: Self = Self(8);
    /// The side at greater y.
    pub const TOP: Self = Self(16);
    /// The side at smaller y.
    pub const BOTTOM: Self = Self(32);
    /// All six.
    pub const ALL: Self = Self(63);

    /// Whether all planes of `other` are in the set.
    pub const fn contains(self, other: Self) -> bool {
        self.0 & other.0 == other.0
    }

    /// Whether the set is empty.
    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// The number of planes.
    pub const fn len(self) -> u32 {
        self.0.count_ones()
    }

    fn indices(self) -> impl Iterator<Item = usize> + Clone {
        (0..6).filter(move |index| self.0 >> index & 1 == 1)
    }
}

impl BitOr for PlaneMask {
    type Output = Self;
    fn bitor(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
}

/// A ball around an object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// Its middle.
    pub centre: Vec3,
    /// From the middle to the surface; at least 0.
    pub radius: f32,
}

impl Sphere {
    /// The ball around the origin of a model that holds all its points: the
    /// radius is the distance of the farthest (TN).
    ///
    /// `None` without points or with points out of range.
    pub fn of_points(points: impl IntoIterator<Item = Vec3>) -> Option<Self> {
        let mut radius = None;
        for point in points {
            if !point.is_usable() {
                return None;
            }
            let length = point.length();
            radius = Some(radius.map_or(length, |most: f32| most.max(length)));
        }
        Some(Self { centre: Vec3::ZERO, radius: radius? })
    }

    /// Whether centre and radius are numbers in range, and the radius is none
    /// below 0.
    pub fn is_usable(&self) -> bool {
        self.centre.is_usable() && (0.0..=crate::MAX_MAGNITUDE).contains(&self.radius)
    }
}

/// How an object lies to a frustum.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Containment {
    /// Nothing of it is seen.
    Outside,
    /// It may cross these planes, and no others; none if it is wholly inside.
    Within(PlaneMask),
}

/// The planes between which things are seen, with normals of length 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frustum {
    planes: [Plane; 6],
    used: PlaneMask,
}

impl Frustum {
    /// The six planes of a view, in view space.
    ///
    /// Source: TN, the clipping frustum.
    pub fn new(view: &View) -> Self {
        Self::with_apex(view, 0.0, PlaneMask::ALL)
    }

    /// The frustum without the hither plane: the sides meet at (0, 0, hither)
    /// rather than at the eye, which shows a little less along the edges of the
    /// screen.
    ///
    /// Source: TN, optimizing out the hither plane.
    pub fn without_hither(view: &View) -> Self {
        let five = PlaneMask(PlaneMask::ALL.0 & !PlaneMask::HITHER.0);
        Self::with_apex(view, view.hither(), five)
    }

    fn with_apex(view: &View, apex: f32, used: PlaneMask) -> Self {
        let (x0, y0, z0) = (view.half_width(), view.half_height(), view.distance());
        let apex = Vec3::new(0.0, 0.0, apex);
        let side = |x: f32, y: f32, z: f32| {
            let normal = Vec3::new(x, y, z);
            Plane::through(normal.normalized().unwrap_or(normal), apex)
        };
        let planes = [
            Plane { normal: Vec3::new(0.0, 0.0, 1.0), distance: view.hither() },
            Plane { normal: Vec3::new(0.0, 0.0, -1.0), distance: -view.yon() },
            side(-z0, 0.0, x0),
            side(z0, 0.0, x0),
            side(0.0, -z0, y0),
            side(0.0, z0, y0),
        ];
        Self { planes, used }
    }

    /// The same frustum in the space before `camera`, which must not stretch:
    /// the normals keep their length.
    pub fn in_world(&self, camera: &Transform) -> Self {
        Self { planes: self.planes.map(|plane| camera.plane_before(&plane)), used: self.used }
    }

    /// The planes that bound this frustum.
    pub fn used(&self) -> PlaneMask {
        self.used
    }

    /// The planes of a set, in the order hither, yon, right, left, top, bottom.
    pub fn planes(&self, mask: PlaneMask) -> impl Iterator<Item = &Plane> + Clone {
        let both = PlaneMask(mask.0 & self.used.0);
        both.indices().map(|index| &self.planes[index])
    }

    /// Whether a point is inside all planes.
    pub fn contains(&self, point: Vec3) -> bool {
        crate::clip_point(point, self.planes(self.used))
    }

    /// How a ball lies to the frustum, of which only the planes in `mask` count:
    /// those that the thing around it crosses. At most six inner products.
    ///
    /// A ball that cannot be used is outside. One near an edge may be called
    /// within although nothing of it is seen.
    ///
    /// Source: TN, checking the bounding sphere against the frustum.
    pub fn test_sphere(&self, sphere: &Sphere, mask: PlaneMask) -> Containment {
        if !sphere.is_usable() {
            return Containment::Outside;
        }
        let mut crossed = PlaneMask::NONE;
        for index in PlaneMask(mask.0 & self.used.0).indices() {
            let distance = self.planes[index].signed_distance(sphere.centre);
            // Written so that planes that are not numbers leave nothing.
            let touches = distance + sphere.radius >= 0.0;
            if !touches {
                return Containment::Outside;
            }
            let clear = distance - sphere.radius > 0.0;
            if !clear {
                crossed = crossed | PlaneMask(1 << index);
            }
        }
        Containment::Within(crossed)
    }

    /// Clips a polygon of an object against the planes it crosses.
    pub fn clip<'a, const N: usize>(
        &self,
        clipper: &'a mut crate::Clipper<N>,
        polygon: &[Vertex<N>],
        crossed: PlaneMask,
    ) -> &'a [Vertex<N>] {
        clipper.clip(polygon, self.planes(crossed))
    }
}
