//! Rasterization states and vertices.

use std::sync::Arc;

use fillrate_call::value_struct;

use crate::texture::Texture;

/// How a primitive meets what is already there. Source: QK, `eDrawMode`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum DrawMode {
    /// Replaces; depth is tested and written.
    #[default]
    Opaque = 0,
    /// As opaque, except where the texel is the key.
    Keyed = 1,
    /// Half and half; depth is tested, not written.
    Alpha = 2,
    /// As alpha, except where the texel is the key.
    AlphaKeyed = 3,
}

impl DrawMode {
    /// All modes, in order.
    pub const ALL: [DrawMode; 4] =
        [DrawMode::Opaque, DrawMode::Keyed, DrawMode::Alpha, DrawMode::AlphaKeyed];

    /// The mode of a documented number; unknown numbers are opaque.
    pub fn from_number(number: u8) -> DrawMode {
        DrawMode::ALL.get(usize::from(number)).copied().unwrap_or_default()
    }

    /// Whether texels are compared with the key.
    pub fn is_keyed(self) -> bool {
        matches!(self, DrawMode::Keyed | DrawMode::AlphaKeyed)
    }

    /// Whether colours are mixed with what is there.
    pub fn is_alpha(self) -> bool {
        matches!(self, DrawMode::Alpha | DrawMode::AlphaKeyed)
    }
}

/// How triangles are drawn. Source: QK, `eTriangleMode`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[repr(i32)]
pub enum TriangleMode {
    /// Textured, without perspective correction.
    #[default]
    Affine = 0,
    /// Textured, with perspective correction.
    Perspective = 1,
    /// In one base colour.
    Untextured = 2,
    /// Outlines.
    Wireframe = 3,
}

impl TriangleMode {
    /// All modes, in order.
    pub const ALL: [TriangleMode; 4] = [
        TriangleMode::Affine,
        TriangleMode::Perspective,
        TriangleMode::Untextured,
        TriangleMode::Wireframe,
    ];

    /// The mode of a documented number; `None` for others, in which nothing
    /// is drawn.
    pub fn from_number(number: i32) -> Option<TriangleMode> {
        usize::try_from(number).ok().and_then(|i| TriangleMode::ALL.get(i)).copied()
    }

    /// Whether texture coordinates are needed.
    pub fn is_textured(self) -> bool {
        matches!(self, TriangleMode::Affine | TriangleMode::Perspective)
    }
}

/// A rasterization state. Source: QK, `TRasterState`.
#[derive(Clone, Debug)]
pub struct RasterState {
    /// How to meet what is there.
    pub draw_mode: DrawMode,
    /// Base colour where there is no texture.
    pub draw_color: u8,
    /// Intensity where vertices and faces have none, 0..=255.
    pub draw_intensity: u8,
    /// Drops triangles seen from behind.
    pub test_culling: bool,
    /// Keeps triangles for the sorted pass.
    pub z_sort: bool,
    /// The texture.
    pub texture: Option<Arc<Texture>>,
}

impl Default for RasterState {
    /// Opaque, white at full intensity, culling, unsorted, without texture.
    fn default() -> RasterState {
        RasterState {
            draw_mode: DrawMode::Opaque,
            draw_color: 0xff,
            draw_intensity: 0xff,
            test_culling: true,
            z_sort: false,
            texture: None,
        }
    }
}

value_struct! {
    /// A corner of a triangle on the screen. Source: QK, `TVertex`.
    #[derive(Copy, Default, Eq)]
    #[repr(C)]
    pub struct Vertex {
        /// Column.
        pub x: i32,
        /// Row, from the top.
        pub y: i32,
        /// Distance, 64 or more; nearer ones count as 64.
        pub z: i32,
        /// Clip mask: see [`crate::clip`].
        pub m: i32,
        /// Light, 0..=255.
        pub i: i32,
        /// Texture column; 256 is one repeat.
        pub u: i32,
        /// Texture row.
        pub v: i32,
    }
}
