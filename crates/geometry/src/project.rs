use crate::{Error, Vertex, View};

/// How a z of view space becomes a depth from 0 at hither to 1 at yon.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum DepthMap {
    /// (z - hither) / (yon - hither). Not linear on the screen: good where
    /// polygons are small.
    Linear,
    /// (yon / (yon - hither)) (1 - hither / z). Linear on the screen, as engines
    /// interpolate it.
    #[default]
    Projective,
}

/// What an engine wants done to depths so that the yon plane shows, which
/// buffers cleared to 1 and a test for less would hide: depth * scale + offset.
///
/// Source: the engine's tags ZMinScale and ZMinOffset; TN, what does RAVE
/// expect.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DepthScale {
    scale: f32,
    offset: f32,
}

impl DepthScale {
    /// Leaves depths as they are: for engines whose yon plane shows anyway.
    pub const NONE: Self = Self { scale: 1.0, offset: 0.0 };
    /// One step of a 16-bit depth buffer below 1.
    pub const BITS_16: Self = Self { scale: 1.0, offset: -1.0 / 65536.0 };
    /// One step of a 24-bit depth buffer below 1.
    pub const BITS_24: Self = Self { scale: 1.0, offset: -1.0 / 16_777_216.0 };

    /// The values of the two tags.
    ///
    /// # Errors
    /// [`Error::DepthScale`] unless the yon plane goes above 0 and to at most 1.
    pub fn new(scale: f32, offset: f32) -> Result<Self, Error> {
        let yon = scale + offset;
        if scale.is_finite() && offset.is_finite() && yon > 0.0 && yon <= 1.0 {
            Ok(Self { scale, offset })
        } else {
            Err(Error::DepthScale)
        }
    }

    /// depth * scale + offset, kept within 0 to 1; 0 if that is no number.
    pub fn apply(&self, depth: f32) -> f32 {
        let depth = depth * self.scale + self.offset;
        if depth > 0.0 { depth.min(1.0) } else { 0.0 }
    }
}

/// A vertex on the screen, as a rasterizer takes it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScreenVertex<const N: usize> {
    /// Pixels from the left edge: 0 <= x < width.
    pub x: f32,
    /// Pixels from the top edge: 0 <= y < height.
    pub y: f32,
    /// Depth, 0 (near) to 1 (far).
    pub z: f32,
    /// 1 / z of view space, taken before z became a depth; above 0.
    pub inv_w: f32,
    /// As they came, not divided by w.
    pub attributes: [f32; N],
}

impl<const N: usize> ScreenVertex<N> {
    /// An attribute times `inv_w`: uOverW and vOverW of u and v. 0 for an
    /// attribute that does not exist.
    pub fn over_w(&self, attribute: usize) -> f32 {
        self.attributes.get(attribute).map_or(0.0, |value| value * self.inv_w)
    }
}

/// Takes clipped vertices of view space to the screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projection {
    /// What is seen.
    pub view: View,
    /// How depths are made.
    pub map: DepthMap,
    /// What the engine wants done to them.
    pub scale: DepthScale,
}

impl Projection {
    /// Projects a vertex that lies within the view's frustum.
    ///
    /// x = X0 + (X / Z) Z0 and y = Y0 - (Y / Z) Z0, in this order. What rounding
    /// moved off the screen, or what was not clipped, is put on its edge, since
    /// rasterizers of the time draw outside. `None` unless z is above 0 and all
    /// values are in range.
    ///
    /// Source: TN, projecting a point.
    pub fn project<const N: usize>(&self, vertex: &Vertex<N>) -> Option<ScreenVertex<N>> {
        let p = vertex.position;
        if !(vertex.is_usable() && p.z > 0.0) {
            return None;
        }
        // A point before the hither plane cannot be seen, and its 1 / z could
        // overflow; only rounding puts one here.
        let z = p.z.max(self.view.hither());
        let view = &self.view;
        Some(ScreenVertex {
            x: on_screen(view.half_width() + p.x / z * view.distance(), view.half_width()),
            y: on_screen(view.half_height() - p.y / z * view.distance(), view.half_height()),
            z: self.depth(z),
            inv_w: 1.0 / z,
            attributes: vertex.attributes,
        })
    }

    /// The depth of a z of view space, from 0 to 1.
    ///
    /// Source: TN, what does RAVE expect.
    pub fn depth(&self, z: f32) -> f32 {
        let (hither, yon) = (self.view.hither(), self.view.yon());
        let depth = match self.map {
            DepthMap::Linear => (z - hither) / (yon - hither),
            DepthMap::Projective => yon / (yon - hither) * (1.0 - hither / z),
        };
        self.scale.apply(depth.clamp(0.0, 1.0))
    }
}

/// A screen position kept at or above 0 and below twice `half`.
pub(crate) fn on_screen(position: f32, half: f32) -> f32 {
    let size = half + half;
    if position >= size {
        size.next_down()
    } else if position > 0.0 {
        position
    } else {
        0.0
    }
}
