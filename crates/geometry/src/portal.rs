use crate::vector::is_usable;
use crate::{Clipper, Error, HalfSpace, Plane, Sphere, Vec3, Vertex};

/// An opening through which one room sees another; one way only.
#[derive(Clone, Debug, PartialEq)]
pub struct Portal {
    /// The room it belongs to.
    pub from: u32,
    /// The room behind it.
    pub to: u32,
    /// Its corners, a flat convex polygon of 3 to [`Rooms::MAX_CORNERS`], in
    /// either direction.
    pub corners: Vec<Vec3>,
}

/// A world of convex rooms joined by portals.
///
/// Source: TN, visibility determination, portals.
#[derive(Clone, Debug, Default)]
pub struct Rooms {
    openings: Vec<Vec<Opening>>,
}

#[derive(Clone, Debug)]
struct Opening {
    to: u32,
    corners: Vec<Vertex<0>>,
    plane: Plane,
    bounds: Sphere,
}

/// A walk in progress.
struct Walk<'a, V> {
    eye: Vec3,
    slack: f32,
    first: &'a [Plane],
    path: Vec<u32>,
    budget: u32,
    visit: V,
}

impl Rooms {
    /// The most corners of a portal.
    pub const MAX_CORNERS: usize = 32;
    /// The most rooms, and the most portals.
    pub const MAX_ROOMS: usize = 1 << 20;
    /// The most portals on one line of sight; what is behind more is not seen.
    pub const MAX_DEPTH: usize = 64;
    /// The most rooms visited and portals looked at in one walk, counting again
    /// what is seen again.
    pub const MAX_STEPS: u32 = 1 << 18;

    /// A world of `rooms` rooms.
    ///
    /// # Errors
    /// [`Error::Limit`] for too many rooms or portals, [`Error::Portal`] for a
    /// portal of a room that does not exist or that is no polygon.
    pub fn new(rooms: usize, portals: &[Portal]) -> Result<Self, Error> {
        if rooms.max(portals.len()) > Self::MAX_ROOMS {
            return Err(Error::Limit { what: "rooms" });
        }
        let mut openings = vec![Vec::new(); rooms];
        for (portal, description) in portals.iter().enumerate() {
            let opening = Opening::new(description).filter(|_| (description.to as usize) < rooms);
            let room = openings.get_mut(description.from as usize);
            match (room, opening) {
                (Some(room), Some(opening)) => room.push(opening),
                _ => return Err(Error::Portal { portal }),
            }
        }
        Ok(Self { openings })
    }

    /// Visits the rooms that an eye in `room` sees, each with the planes, first
    /// those of the last portal, between which it is seen; nearer rooms of a line
    /// of sight come first. A room seen through two portals is visited twice.
    ///
    /// `planes` bound the view in the world: the frustum without its hither
    /// plane, which would cut off openings right before the eye. A portal whose
    /// plane passes within `slack` (such as the hither distance) of an eye near it
    /// does not narrow the view. Rooms are convex, so a line of sight enters none
    /// twice.
    ///
    /// Returns false if [`Rooms::MAX_STEPS`] ended the walk. An eye or room that
    /// does not exist sees nothing.
    pub fn visit_visible(
        &self,
        room: u32,
        eye: Vec3,
        slack: f32,
        planes: &[Plane],
        visit: impl FnMut(u32, &[Plane]),
    ) -> bool {
        if !(eye.is_usable() && is_usable(slack) && (room as usize) < self.openings.len()) {
            return true;
        }
        let budget = Self::MAX_STEPS;
        let mut walk = Walk { eye, slack, first: planes, path: Vec::new(), budget, visit };
        self.enter(room, planes, &mut walk)
    }

    fn enter<V: FnMut(u32, &[Plane])>(
        &self,
        room: u32,
        planes: &[Plane],
        walk: &mut Walk<'_, V>,
    ) -> bool {
        if walk.budget == 0 {
            return false;
        }
        walk.budget -= 1;
        (walk.visit)(room, planes);
        walk.path.push(room);
        let mut complete = true;
        if walk.path.len() <= Self::MAX_DEPTH {
            for opening in &self.openings[room as usize] {
                if walk.budget == 0 {
                    complete = false;
                    break;
                }
                walk.budget -= 1;
                if walk.path.contains(&opening.to) {
                    continue;
                }
                if let Some(narrowed) = opening.narrow(planes, walk) {
                    complete &= self.enter(opening.to, &narrowed, walk);
                }
            }
        }
        walk.path.pop();
        complete
    }
}

impl Opening {
    fn new(portal: &Portal) -> Option<Self> {
        let corners = &portal.corners;
        if !(3..=Rooms::MAX_CORNERS).contains(&corners.len())
            || !corners.iter().all(|corner| corner.is_usable())
        {
            return None;
        }
        let plane = corners
            .windows(2)
            .skip(1)
            .find_map(|edge| Plane::of_points(corners[0], edge[0], edge[1]))?;
        let centre = middle(corners.iter().copied());
        let radius = Sphere::of_points(corners.iter().map(|&corner| corner - centre))?.radius;
        let bounds = Sphere { centre, radius };
        let corners = corners.iter().map(|&corner| Vertex::new(corner, [])).collect();
        Some(Self { to: portal.to, corners, plane, bounds })
    }

    /// The planes through the eye and the edges of what is seen of the opening,
    /// then those of the view; `None` if nothing is seen of it.
    fn narrow<V>(&self, planes: &[Plane], walk: &Walk<'_, V>) -> Option<Vec<Plane>> {
        let eye = walk.eye;
        let in_it = self.plane.signed_distance(eye).abs() <= walk.slack
            && (eye - self.bounds.centre).length() <= self.bounds.radius + walk.slack;
        if in_it {
            return Some(planes.to_vec());
        }
        let mut clipper = Clipper::new();
        let seen = clipper.clip(&self.corners, planes);
        if seen.is_empty() {
            return None;
        }
        let towards = middle(seen.iter().map(|corner| corner.position)) - eye;
        let next = seen.iter().cycle().skip(1);
        let edges = seen.iter().zip(next).filter_map(|(a, b)| {
            let (a, b) = ((a.position - eye).normalized()?, (b.position - eye).normalized()?);
            let normal = a.cross(b).normalized()?;
            let side = normal.dot(towards);
            // An edge in line with the eye bounds nothing.
            let normal = if side > 0.0 { normal } else { -normal };
            (side != 0.0).then(|| Plane::through(normal, eye))
        });
        Some(edges.chain(walk.first.iter().copied()).collect())
    }
}

/// The mean of points in range.
fn middle(points: impl Iterator<Item = Vec3> + Clone) -> Vec3 {
    let part = 1.0 / points.clone().count().max(1) as f32;
    points.fold(Vec3::ZERO, |sum, point| sum + point * part)
}
