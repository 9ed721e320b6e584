use crate::{Sphere, View};

/// The radius in pixels that a ball in view space has on the screen, taken at
/// its middle but no nearer than the hither plane. 0 for a ball that cannot be
/// used or whose middle is behind the eye by more than its radius.
///
/// Source: TN, projecting a point.
pub fn projected_radius(view: &View, sphere: &Sphere) -> f32 {
    if !sphere.is_usable() || sphere.centre.z + sphere.radius < 0.0 {
        return 0.0;
    }
    sphere.radius / sphere.centre.z.max(view.hither()) * view.distance()
}

/// The level of detail for a size in pixels: the number of `thresholds`, from
/// the largest to the smallest, that the size falls short of. 0 is the finest;
/// a size that is no number gets the coarsest.
///
/// Source: TN, level of detail.
pub fn choose_level(thresholds: &[f32], size: f32) -> usize {
    thresholds.iter().position(|&threshold| size >= threshold).unwrap_or(thresholds.len())
}

/// [`choose_level`] for an object that had level `previous` in the frame
/// before. It changes only when the size is past the threshold by the part
/// `margin` (0 to 1, such as 0.1), so that objects near one do not flicker.
pub fn keep_or_choose_level(thresholds: &[f32], size: f32, previous: usize, margin: f32) -> usize {
    let margin = if margin > 0.0 { margin.min(1.0) } else { 0.0 };
    let finest = choose_level(thresholds, size * (1.0 + margin));
    let coarsest = choose_level(thresholds, size * (1.0 - margin));
    if finest <= coarsest { previous.clamp(finest, coarsest) } else { coarsest }
}
