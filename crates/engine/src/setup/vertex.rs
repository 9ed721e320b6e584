//! Vertices as the engine takes them.

use crate::state::MAX_TMUS;

/// Texture coordinates of one vertex for one texture unit.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct TmuVertex {
    /// s/w; s runs over 256 units along the longer side of the texture.
    pub s: f32,
    /// t/w.
    pub t: f32,
    /// 1/w of this unit.
    pub w: f32,
}

/// What a vertex has besides a [`Vertex`], for draw states that read it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct VertexExtra {
    /// Red, green and blue of the second colour, 0..255.
    pub specular: [f32; 3],
    /// What fog leaves of the colour, 0..255; 255 is no fog.
    pub fog: f32,
    /// Red, green and blue of the third colour, 0..255.
    pub base: [f32; 3],
    /// Depth, 0..2^31.
    pub deep_z: f64,
}

/// A vertex in screen space.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct Vertex {
    /// Column, in pixels.
    pub x: f32,
    /// Row, in pixels, counted from the [`crate::state::Origin`].
    pub y: f32,
    /// Red, 0..255.
    pub r: f32,
    /// Green, 0..255.
    pub g: f32,
    /// Blue, 0..255.
    pub b: f32,
    /// Alpha, 0..255.
    pub a: f32,
    /// Depth, 0..65535.
    pub z: f32,
    /// 1/w of the pixel pipeline (w-buffer and fog).
    pub w: f32,
    /// Texture coordinates.
    pub tmu: [TmuVertex; MAX_TMUS],
}
