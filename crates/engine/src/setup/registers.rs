//! The registers that launch a triangle.

use crate::state::MAX_TMUS;

/// A 32-bit iterator: value at the first vertex and its steps.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Param {
    /// At the first vertex.
    pub start: i32,
    /// Per column.
    pub dx: i32,
    /// Per row, in drawing coordinates.
    pub dy: i32,
}

/// A 64-bit iterator with 32 fraction bits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WideParam {
    /// At the first vertex.
    pub start: i64,
    /// Per column.
    pub dx: i64,
    /// Per row, in drawing coordinates.
    pub dy: i64,
}

/// A triangle as the chip sees it: vertices sorted by rising y, start values
/// and steps of every iterator.
///
/// Start values are at the first vertex; the engine moves them to the centre
/// of that vertex's pixel: `start += ((8 - (x & 15)) * dx + (8 - (y & 15)) *
/// dy) >> 4`, wrapping.
///
/// Source: SST1, triangle registers; G246, triangle set-up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Registers {
    /// Columns of A, B, C, 12.4.
    pub x: [i32; 3],
    /// Rows of A, B, C, 12.4, in drawing coordinates.
    pub y: [i32; 3],
    /// Sign bit of the area: true where B lies left of edge A-C.
    pub negative: bool,
    /// 12.12, red, green, blue, alpha.
    pub color: [Param; 4],
    /// 20.12.
    pub z: Param,
    /// 1/w of the pixel pipeline, 32 fraction bits, 48 bits used.
    pub w: WideParam,
    /// s/w, t/w and 1/w of each texture unit.
    pub tmu: [[WideParam; 3]; MAX_TMUS],
    /// 12.12, a second colour, red, green and blue, and the part of the colour
    /// that fog leaves, 255 all of it: see [`crate::state::Shade::specular`] and
    /// [`crate::state::FogAmount::Iterated`]. They wrap as `color` does.
    pub specular: [Param; 4],
    /// 12.12, a third colour: see [`crate::state::DecalBase::Base`].
    pub base: [Param; 3],
    /// Depth, 32 fraction bits: see [`crate::state::DepthSource::DeepZ`].
    pub deep_z: WideParam,
}

impl Registers {
    /// The fog factor, the fourth value of `specular`, of triangles without fog.
    pub const NO_FOG: Param = Param { start: 255 << 12, dx: 0, dy: 0 };
}
