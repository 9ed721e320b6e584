use crate::{Error, tan};

/// A horizontal field of view of 110 degrees, in radians, which TN finds good.
pub const TECHNOTE_FIELD_OF_VIEW: f32 = 110.0 * std::f32::consts::PI / 180.0;

/// What of view space is seen, and how large.
///
/// Half the width and height of the screen are X0 and Y0, in pixels; the view
/// plane lies at Z0, where a unit of view space is a pixel wide (TN, choosing
/// the viewing distance).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    x0: f32,
    y0: f32,
    z0: f32,
    hither: f32,
    yon: f32,
}

impl View {
    /// A screen of `width` by `height` pixels, at most 16384, with the view plane
    /// at `distance` (2^-20 to 2^30), which shows z from `hither` to `yon`
    /// (2^-20 to 2^40).
    ///
    /// # Errors
    /// [`Error::View`] for values out of range, or unless `hither` < `yon`.
    pub fn new(
        width: f32,
        height: f32,
        distance: f32,
        hither: f32,
        yon: f32,
    ) -> Result<Self, Error> {
        const SMALLEST: f32 = 1.0 / 1_048_576.0;
        const FARTHEST: f32 = (1_u64 << 40) as f32;
        let check = |what, value: f32, least: f32, most: f32| {
            if (least..=most).contains(&value) { Ok(value) } else { Err(Error::View { what }) }
        };
        let view = Self {
            x0: check("width", width, 1.0, 16384.0)? / 2.0,
            y0: check("height", height, 1.0, 16384.0)? / 2.0,
            z0: check("distance", distance, SMALLEST, 1_073_741_824.0)?,
            hither: check("hither", hither, SMALLEST, FARTHEST)?,
            yon: check("yon", yon, SMALLEST, FARTHEST)?,
        };
        if hither < yon { Ok(view) } else { Err(Error::View { what: "yon" }) }
    }

    /// The same with the distance from the horizontal field of view, in radians
    /// between 0 and pi: Z0 = X0 / tan(angle / 2).
    ///
    /// # Errors
    /// As [`View::new`]; angles out of range are [`Error::View`].
    pub fn with_field_of_view(
        width: f32,
        height: f32,
        angle: f32,
        hither: f32,
        yon: f32,
    ) -> Result<Self, Error> {
        if !(angle > 0.0 && angle < std::f32::consts::PI) {
            return Err(Error::View { what: "field of view" });
        }
        Self::new(width, height, width / 2.0 / tan(angle / 2.0), hither, yon)
    }

    /// X0: half the width in pixels.
    pub fn half_width(&self) -> f32 {
        self.x0
    }

    /// Y0: half the height in pixels.
    pub fn half_height(&self) -> f32 {
        self.y0
    }

    /// Z0: the distance of the view plane.
    pub fn distance(&self) -> f32 {
        self.z0
    }

    /// The least z that is seen.
    pub fn hither(&self) -> f32 {
        self.hither
    }

    /// The greatest z that is seen.
    pub fn yon(&self) -> f32 {
        self.yon
    }
}
