use crate::Vec3;
use crate::vector::is_usable;

/// The most vertices of a polygon. A convex polygon gains at most one at each
/// plane, so this leaves room for any portal; more come only from polygons that
/// are not convex, which are clipped away.
pub const MAX_VERTICES: usize = 256;

/// A point with values that vary linearly over a line or polygon: colours, u
/// and v, alpha. They must not be divided by w yet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vertex<const N: usize> {
    /// Where it is.
    pub position: Vec3,
    /// What varies.
    pub attributes: [f32; N],
}

/// One side of a plane: what clipping needs to know of it.
pub trait HalfSpace {
    /// Above 0 inside, 0 on the plane, below 0 outside; linear in the point.
    fn signed_distance(&self, point: Vec3) -> f32;

    /// Whether the plane is one. Nothing is inside a plane that is none.
    fn is_usable(&self) -> bool {
        true
    }
}

impl<H: HalfSpace> HalfSpace for &H {
    fn signed_distance(&self, point: Vec3) -> f32 {
        (**self).signed_distance(point)
    }

    fn is_usable(&self) -> bool {
        (**self).is_usable()
    }
}

impl<const N: usize> Vertex<N> {
    /// A vertex of its parts.
    pub const fn new(position: Vec3, attributes: [f32; N]) -> Self {
        Self { position, attributes }
    }

    /// Whether all values are numbers of at most [`crate::MAX_MAGNITUDE`].
    pub fn is_usable(&self) -> bool {
        self.position.is_usable() && self.attributes.iter().all(|&value| is_usable(value))
    }

    /// The vertex at `t` (0 to 1) on the way to `other`.
    fn towards(&self, other: &Self, t: f32) -> Self {
        let mut attributes = self.attributes;
        for (value, &end) in attributes.iter_mut().zip(&other.attributes) {
            *value = between(*value, end, t);
        }
        let (a, b) = (self.position, other.position);
        let position = Vec3::new(between(a.x, b.x, t), between(a.y, b.y, t), between(a.z, b.z, t));
        Self { position, attributes }
    }
}

/// `a + t (b - a)`, kept between both, so that rounding lifts no colour over 1.
fn between(a: f32, b: f32, t: f32) -> f32 {
    let value = a + t * (b - a);
    if a <= b { value.clamp(a, b) } else { value.clamp(b, a) }
}

/// Where the edge from a vertex inside to one outside crosses the plane.
///
/// Always from the inside out, so that polygons which share an edge, and walk it
/// in opposite directions, get the same vertex.
///
/// Source: TN, clipping a line to the 3D plane: t = (D - D1) / (D2 - D1), here
/// with distances from the plane.
fn crossing<const N: usize>(inside: (&Vertex<N>, f32), outside: (&Vertex<N>, f32)) -> Vertex<N> {
    let t = inside.1 / (inside.1 - outside.1);
    let t = if t > 0.0 && t <= 1.0 { t } else { 0.0 };
    inside.0.towards(outside.0, t)
}

/// Whether a point is inside all planes.
///
/// Source: TN, clipping a point.
pub fn clip_point<H: HalfSpace>(point: Vec3, planes: impl IntoIterator<Item = H>) -> bool {
    point.is_usable()
        && planes.into_iter().all(|plane| plane.is_usable() && plane.signed_distance(point) >= 0.0)
}

/// The part of a line inside all planes, or `None`.
///
/// The ends keep their order. An end on a plane is inside.
///
/// Source: TN, clipping a line.
pub fn clip_line<H: HalfSpace, const N: usize>(
    mut line: [Vertex<N>; 2],
    planes: impl IntoIterator<Item = H>,
) -> Option<[Vertex<N>; 2]> {
    if !line.iter().all(Vertex::is_usable) {
        return None;
    }
    for plane in planes {
        if !plane.is_usable() {
            return None;
        }
        let sides = [0, 1].map(|end| plane.signed_distance(line[end].position));
        match sides.map(|side| side >= 0.0) {
            [true, true] => {}
            [false, false] => return None,
            [true, false] => line[1] = crossing((&line[0], sides[0]), (&line[1], sides[1])),
            [false, true] => line[0] = crossing((&line[1], sides[1]), (&line[0], sides[0])),
        }
    }
    Some(line)
}

/// Clips convex polygons. It keeps its memory from one polygon to the next.
#[derive(Clone, Debug, Default)]
pub struct Clipper<const N: usize> {
    polygon: Vec<Vertex<N>>,
    clipped: Vec<Vertex<N>>,
    sides: Vec<f32>,
}

impl<const N: usize> Clipper<N> {
    /// A clipper without memory.
    pub const fn new() -> Self {
        Self { polygon: Vec::new(), clipped: Vec::new(), sides: Vec::new() }
    }

    /// The part of a convex polygon inside all planes, in the polygon's order of
    /// corners; at most one corner more for each plane.
    ///
    /// Empty if nothing is left, which includes polygons that only touch a plane
    /// from outside, polygons with fewer than three or more than
    /// [`MAX_VERTICES`] corners, and values or planes that cannot be used.
    ///
    /// Source: TN, clipping a convex polygon against the plane.
    pub fn clip<H: HalfSpace>(
        &mut self,
        polygon: &[Vertex<N>],
        planes: impl IntoIterator<Item = H>,
    ) -> &[Vertex<N>] {
        self.polygon.clear();
        if polygon.len() <= MAX_VERTICES && polygon.iter().all(Vertex::is_usable) {
            self.polygon.extend_from_slice(polygon);
        }
        for plane in planes {
            self.clip_one(&plane);
            if self.polygon.is_empty() {
                break;
            }
        }
        if !(3..=MAX_VERTICES).contains(&self.polygon.len()) {
            self.polygon.clear();
        }
        &self.polygon
    }

    fn clip_one(&mut self, plane: &impl HalfSpace) {
        if !plane.is_usable() {
            self.polygon.clear();
            return;
        }
        self.sides.clear();
        self.sides.extend(self.polygon.iter().map(|corner| plane.signed_distance(corner.position)));
        if self.sides.iter().all(|&side| side >= 0.0) {
            return;
        }
        self.walk_edges();
        if !(3..=MAX_VERTICES).contains(&self.clipped.len()) {
            self.clipped.clear();
        }
        std::mem::swap(&mut self.polygon, &mut self.clipped);
    }

    /// A corner inside is kept; an edge that changes sides adds its crossing. A
    /// corner on the plane is its own crossing and is not added twice.
    fn walk_edges(&mut self) {
        self.clipped.clear();
        let corners = self.polygon.iter().zip(self.sides.iter().copied());
        let next = corners.clone().cycle().skip(1);
        for (first, second) in corners.zip(next) {
            let (first_in, second_in) = (first.1 >= 0.0, second.1 >= 0.0);
            if first_in {
                self.clipped.push(*first.0);
            }
            if first_in && !second_in && first.1 > 0.0 {
                self.clipped.push(crossing(first, second));
            } else if second_in && !first_in && second.1 > 0.0 {
                self.clipped.push(crossing(second, first));
            }
        }
    }
}
