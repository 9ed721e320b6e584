use crate::project::on_screen;
use crate::{Clipper, DepthScale, HalfSpace, ScreenVertex, Transform, Vec3, Vertex, View};

/// A side of the normalized frustum: inside or out is one comparison.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NormalizedSide {
    /// z >= this.
    Hither(f32),
    /// z <= this.
    Yon(f32),
    /// x <= z.
    Right,
    /// x >= -z.
    Left,
    /// y <= z.
    Top,
    /// y >= -z.
    Bottom,
}

impl HalfSpace for NormalizedSide {
    fn signed_distance(&self, p: Vec3) -> f32 {
        match *self {
            Self::Hither(hither) => p.z - hither,
            Self::Yon(yon) => yon - p.z,
            Self::Right => p.z - p.x,
            Self::Left => p.z + p.x,
            Self::Top => p.z - p.y,
            Self::Bottom => p.z + p.y,
        }
    }
}

/// A frustum stretched so that its sides stand at 45 degrees and z runs to
/// about 1: clipping against it needs sums only, and z is a depth already.
///
/// Source: TN, normalized clipping frustum. The text prints the factors as
/// `Z0/Zyon * X0`; they divide by X0 and Y0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NormalizedFrustum {
    view: View,
    factors: Vec3,
    sides: [NormalizedSide; 6],
}

impl NormalizedFrustum {
    /// The normalized frustum of a view. z is divided by a little more than yon,
    /// so that the yon plane comes where the engine wants it: at
    /// [`DepthScale::apply`] of 1.
    pub fn new(view: &View, scale: DepthScale) -> Self {
        // Above 0 and at most 1: that is what a depth scale is.
        let yon = scale.apply(1.0);
        let divisor = view.yon() / yon;
        let factors = Vec3::new(
            view.distance() / (divisor * view.half_width()),
            view.distance() / (divisor * view.half_height()),
            1.0 / divisor,
        );
        let sides = [
            NormalizedSide::Hither(view.hither() * factors.z),
            NormalizedSide::Yon(yon),
            NormalizedSide::Right,
            NormalizedSide::Left,
            NormalizedSide::Top,
            NormalizedSide::Bottom,
        ];
        Self { view: *view, factors, sides }
    }

    /// The factors (Sx, Sy, Sz) of the camera.
    pub fn factors(&self) -> Vec3 {
        self.factors
    }

    /// The six sides, in the order hither, yon, right, left, top, bottom.
    pub fn sides(&self) -> &[NormalizedSide; 6] {
        &self.sides
    }

    /// A camera into view space, made one into the normalized frustum.
    pub fn camera(&self, camera: &Transform) -> Transform {
        camera.then(&Transform::scaling(self.factors))
    }

    /// Whether a point of normalized space is seen.
    pub fn contains(&self, point: Vec3) -> bool {
        crate::clip_point(point, self.sides)
    }

    /// Clips a polygon of normalized space.
    pub fn clip<'a, const N: usize>(
        &self,
        clipper: &'a mut Clipper<N>,
        polygon: &[Vertex<N>],
    ) -> &'a [Vertex<N>] {
        clipper.clip(polygon, self.sides)
    }

    /// Projects a clipped vertex of normalized space: invW = 1 / Zc,
    /// x = X0 + (Xc X0) invW, y = Y0 - (Yc Y0) invW, depth = Zc.
    ///
    /// The same promises as [`crate::Projection::project`]. `inv_w` is that of
    /// normalized space, the view's times the divisor of z, which is the same
    /// perspective.
    pub fn project<const N: usize>(&self, vertex: &Vertex<N>) -> Option<ScreenVertex<N>> {
        let p = vertex.position;
        if !(vertex.is_usable() && p.z > 0.0) {
            return None;
        }
        let z = p.z.max(self.view.hither() * self.factors.z);
        let inv_w = 1.0 / z;
        let (x0, y0) = (self.view.half_width(), self.view.half_height());
        Some(ScreenVertex {
            x: on_screen(x0 + p.x * x0 * inv_w, x0),
            y: on_screen(y0 - p.y * y0 * inv_w, y0),
            z: z.min(1.0),
            inv_w,
            attributes: vertex.attributes,
        })
    }
}
