//! Flexible vertex and index formats.

use crate::error::ErrorCode;

/// What a vertex holds besides its position. Source: QK, `eVextexFormat`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct VertexFormat {
    /// Light intensity (`VF_I`).
    pub intensity: bool,
    /// Texture coordinates (`VF_UV`).
    pub uv: bool,
}

/// What a triangle holds besides its corners' numbers. Source: QK,
/// `eIndexFormat`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct IndexFormat {
    /// Light intensity (`IF_I`).
    pub intensity: bool,
    /// Base colour (`IF_C`).
    pub color: bool,
    /// Texture coordinates of its corners (`IF_UV`).
    pub uv: bool,
}

impl VertexFormat {
    /// A format from the documented bits.
    ///
    /// # Errors
    /// [`ErrorCode::VertexFormat`] for other bits.
    pub fn from_bits(bits: i32) -> Result<VertexFormat, ErrorCode> {
        if bits & !3 != 0 {
            return Err(ErrorCode::VertexFormat);
        }
        Ok(VertexFormat { intensity: bits & 1 != 0, uv: bits & 2 != 0 })
    }

    /// The documented bits.
    pub fn bits(self) -> i32 {
        i32::from(self.intensity) | i32::from(self.uv) << 1
    }
}

impl IndexFormat {
    /// A format from the documented bits.
    ///
    /// # Errors
    /// [`ErrorCode::IndexFormat`] for other bits.
    pub fn from_bits(bits: i32) -> Result<IndexFormat, ErrorCode> {
        if bits & !7 != 0 {
            return Err(ErrorCode::IndexFormat);
        }
        Ok(IndexFormat { intensity: bits & 1 != 0, color: bits & 2 != 0, uv: bits & 4 != 0 })
    }

    /// The documented bits.
    pub fn bits(self) -> i32 {
        i32::from(self.intensity) | i32::from(self.color) << 1 | i32::from(self.uv) << 2
    }
}

/// Where things lie in a list, counted in 16-bit numbers. Offsets are 0 where
/// the thing is absent.
///
/// Optional things follow in the order intensity, colour, texture coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layout {
    /// From one vertex to the next.
    pub vertex_stride: usize,
    /// Texture coordinates of a vertex (`VuOfs`).
    pub vertex_uv: usize,
    /// Intensity of a vertex (`ViOfs`).
    pub vertex_intensity: usize,
    /// From one triangle to the next.
    pub index_stride: usize,
    /// Texture coordinates of a triangle (`IuOfs`).
    pub index_uv: usize,
    /// Intensity of a triangle (`IiOfs`).
    pub index_intensity: usize,
    /// Colour of a triangle (`IcOfs`).
    pub index_color: usize,
}

impl Layout {
    /// The layout of a pair of formats.
    ///
    /// # Errors
    /// [`ErrorCode::DuplicateIntensity`], [`ErrorCode::DuplicateUv`] where
    /// both formats hold the same thing.
    pub fn new(vertex: VertexFormat, index: IndexFormat) -> Result<Layout, ErrorCode> {
        if vertex.intensity && index.intensity {
            return Err(ErrorCode::DuplicateIntensity);
        }
        if vertex.uv && index.uv {
            return Err(ErrorCode::DuplicateUv);
        }
        let (mut vertex_stride, mut index_stride) = (3, 3);
        let place = |stride: &mut usize, present: bool, size: usize| {
            let at = *stride;
            *stride += if present { size } else { 0 };
            if present { at } else { 0 }
        };
        let vertex_intensity = place(&mut vertex_stride, vertex.intensity, 1);
        let vertex_uv = place(&mut vertex_stride, vertex.uv, 2);
        let index_intensity = place(&mut index_stride, index.intensity, 1);
        let index_color = place(&mut index_stride, index.color, 1);
        let index_uv = place(&mut index_stride, index.uv, 6);
        Ok(Layout {
            vertex_stride,
            vertex_uv,
            vertex_intensity,
            index_stride,
            index_uv,
            index_intensity,
            index_color,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn layout(vertex: i32, index: i32) -> Result<Layout, ErrorCode> {
        Layout::new(VertexFormat::from_bits(vertex)?, IndexFormat::from_bits(index)?)
    }

    #[test]
    fn strides_and_offsets() {
        let vertex = |bits: i32| {
            let l = layout(bits, 0).unwrap();
            (l.vertex_stride, l.vertex_intensity, l.vertex_uv)
        };
        assert_eq!([0, 1, 2, 3].map(vertex), [(3, 0, 0), (4, 3, 0), (5, 0, 3), (6, 3, 4)]);
        let index = |bits: i32| {
            let l = layout(0, bits).unwrap();
            (l.index_stride, l.index_intensity, l.index_color, l.index_uv)
        };
        let expected = [
            (3, 0, 0, 0),
            (4, 3, 0, 0),
            (4, 0, 3, 0),
            (5, 3, 4, 0),
            (9, 0, 0, 3),
            (10, 3, 0, 4),
            (10, 0, 3, 4),
            (11, 3, 4, 5),
        ];
        assert_eq!([0, 1, 2, 3, 4, 5, 6, 7].map(index), expected);
    }

    #[test]
    fn bad_formats() {
        assert_eq!(layout(4, 0), Err(ErrorCode::VertexFormat));
        assert_eq!(layout(-1, 0), Err(ErrorCode::VertexFormat));
        assert_eq!(layout(0, 8), Err(ErrorCode::IndexFormat));
        assert_eq!(layout(1, 1), Err(ErrorCode::DuplicateIntensity));
        assert_eq!(layout(2, 4), Err(ErrorCode::DuplicateUv));
        assert_eq!(layout(3, 5), Err(ErrorCode::DuplicateIntensity));
    }

    #[test]
    fn bits_round_trip() {
        assert!((0..4).all(|bits| VertexFormat::from_bits(bits).unwrap().bits() == bits));
        assert!((0..8).all(|bits| IndexFormat::from_bits(bits).unwrap().bits() == bits));
    }
}
