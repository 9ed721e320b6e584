//! The four stages of the pipeline, each a plain function or walker over values.
//!
//! The single-tile reference and every tile of the simulator call the same code, so their pixels
//! can only differ by the order in which fragments meet the frame buffer.
//!
//! [`geometry`] (stage 1) turns input vertices into [`TransPrim`]s, with [`clip`] cutting and
//! [`lighting`] shading them; [`ordering`] numbers primitives; [`raster`] (stage 2) walks a `TransPrim` into [`UntexFragment`]s; [`sample`] and
//! [`combine`] (stage 3) turn those into [`Fragment`]s; [`composite`] (stage 4) draws them.

pub mod assembly;
pub mod clip;
pub mod combine;
pub mod composite;
pub mod emit;
pub mod geometry;
pub mod lighting;
pub mod ordering;
pub mod raster;
pub mod sample;
pub mod thin;

use crate::state::PrimInfo;

/// A vertex as the host sends it, with the colour and normal current at that moment: 9 words.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InputVertex {
    /// Position in model space.
    pub position: [f32; 3],
    /// Normal in model space.
    pub normal: [f32; 3],
    /// Texture coordinates, 0..1 across the texture.
    pub uv: [f32; 2],
    /// Colour with alpha.
    pub rgba: u32,
}

impl Default for InputVertex {
    fn default() -> Self {
        Self { position: [0.0; 3], normal: [1.0, 0.0, 0.0], uv: [0.0; 2], rgba: 0 }
    }
}

/// A transformed vertex: 11 words. Attributes the mode interpolates are already times 1/w.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vertex {
    /// x in clip space before the divide, -1..1 across the screen after it.
    pub x: f32,
    /// y, downwards.
    pub y: f32,
    /// z, -1 near to 1 far after the divide.
    pub z: f32,
    /// 1/w (w itself until the divide).
    pub w1: f32,
    /// Texture coordinate u.
    pub u: f32,
    /// Texture coordinate v.
    pub v: f32,
    /// Red, green, blue, alpha, 0..=255 before the division by w.
    pub rgba: [f32; 4],
    /// Directional light intensity, nominally 0..1.
    pub intensity: f32,
    /// Beyond the thesis: light of further lights (red, green, blue, 0..=255), then of highlights.
    pub more: [f32; 6],
}

/// What a primitive between stages 1 and 2 is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Shape {
    /// A triangle of all three vertices.
    #[default]
    Triangle,
    /// A line between the first two.
    Line,
    /// A square around the first.
    Point,
}

/// A primitive, or a part of one, between stages 1 and 2: 40 words in the thesis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TransPrim {
    /// Mode and state of the primitive.
    pub info: PrimInfo,
    /// What it is.
    pub shape: Shape,
    /// The three vertices.
    pub vertices: [Vertex; 3],
}

/// A fragment between stages 2 and 3: 7 words. Fields the mode does not need are zero.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct UntexFragment {
    /// Column.
    pub x: u32,
    /// Row.
    pub y: u32,
    /// Signed fixed-point depth.
    pub z: i32,
    /// Texture coordinate u.
    pub u: f32,
    /// Texture coordinate v.
    pub v: f32,
    /// Interpolated or average colour.
    pub rgba: u32,
    /// Directional light intensity.
    pub intensity: f32,
    /// Beyond the thesis: how far the texture coordinates move in one pixel, at most.
    pub footprint: [f32; 2],
    /// Beyond the thesis: light of further lights, rgb.
    pub diffuse: u32,
    /// Beyond the thesis: light of highlights, rgb.
    pub specular: u32,
}

/// A fragment between stages 3 and 4: 4 words.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Fragment {
    /// Column.
    pub x: u32,
    /// Row.
    pub y: u32,
    /// Signed fixed-point depth.
    pub z: i32,
    /// Final colour; alpha 0 is never drawn.
    pub rgba: u32,
}

/// Converts a float to a word, truncating towards zero and saturating; not-a-number gives 0.
#[inline(always)]
pub(crate) fn trunc_i32(value: f32) -> i32 {
    value as i32
}

/// Rounds a float towards zero. The target's base level has no instruction for it, so that the
/// library's function would be called for each texel.
#[inline(always)]
pub(crate) fn trunc_f32(value: f32) -> f32 {
    // From 2^23 on every float is whole; not-a-number is passed on as well.
    if value.abs() < 8_388_608.0 { value as i32 as f32 } else { value }
}

/// Rounds a float down.
#[inline(always)]
pub(crate) fn floor_f32(value: f32) -> f32 {
    let whole = trunc_f32(value);
    if whole > value { whole - 1.0 } else { whole }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_is_that_of_the_library() {
        let edges = [0.0, 0.5, 0.999_999_94, 1.0, 8_388_607.5, 8_388_608.0, 3e38, f32::INFINITY];
        for value in
            edges.into_iter().flat_map(|v| [v, -v]).chain((0..4096).map(|i| i as f32 / 7.0 - 300.0))
        {
            assert_eq!(trunc_f32(value), value.trunc(), "{value}");
            assert_eq!(floor_f32(value), value.floor(), "{value}");
        }
        assert!(trunc_f32(f32::NAN).is_nan() && floor_f32(f32::NAN).is_nan());
    }
}
