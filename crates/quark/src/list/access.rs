//! Reading and writing single vertices and triangles.
//!
//! Numbers outside the list, and things its format lacks, read as 0 and are
//! not written.

use super::TriangleList;

/// Texture coordinates of one corner.
pub type Corner = [i16; 2];

impl TriangleList {
    fn vertex(&self, index: usize) -> Option<&[i16]> {
        self.vertices.chunks_exact(self.layout.vertex_stride).nth(index)
    }

    fn vertex_mut(&mut self, index: usize) -> Option<&mut [i16]> {
        self.vertices.chunks_exact_mut(self.layout.vertex_stride).nth(index)
    }

    fn triangle(&self, index: usize) -> Option<&[u16]> {
        self.indices.chunks_exact(self.layout.index_stride).nth(index)
    }

    fn triangle_mut(&mut self, index: usize) -> Option<&mut [u16]> {
        self.indices.chunks_exact_mut(self.layout.index_stride).nth(index)
    }

    /// Sets a triangle's corners. Source: QK, `SetABC`.
    pub fn set_abc(&mut self, index: usize, abc: [u16; 3]) {
        if let Some(triangle) = self.triangle_mut(index) {
            triangle[..3].copy_from_slice(&abc);
        }
    }

    /// Sets a vertex's position. Source: QK, `SetXYZ`.
    pub fn set_xyz(&mut self, index: usize, xyz: [i16; 3]) {
        if let Some(vertex) = self.vertex_mut(index) {
            vertex[..3].copy_from_slice(&xyz);
        }
    }

    /// Sets the texture coordinates of a vertex (one corner) or a triangle
    /// (three), wherever the format has them; missing corners keep theirs.
    /// Source: QK, `SetUV`.
    pub fn set_uv(&mut self, index: usize, corners: &[Corner]) {
        let layout = self.layout;
        if layout.vertex_uv > 0 {
            if let (Some(vertex), Some(uv)) = (self.vertex_mut(index), corners.first()) {
                vertex[layout.vertex_uv..][..2].copy_from_slice(uv);
            }
        } else if layout.index_uv > 0
            && let Some(triangle) = self.triangle_mut(index)
        {
            let values = corners.iter().flatten().map(|&n| n as u16);
            triangle[layout.index_uv..].iter_mut().zip(values).for_each(|(to, n)| *to = n);
        }
    }

    /// Sets the intensity of a vertex or a triangle, wherever the format has
    /// it. Source: QK, `SetI`.
    pub fn set_i(&mut self, index: usize, intensity: i32) {
        let layout = self.layout;
        if layout.vertex_intensity > 0 {
            if let Some(vertex) = self.vertex_mut(index) {
                vertex[layout.vertex_intensity] = intensity as i16;
            }
        } else if layout.index_intensity > 0
            && let Some(triangle) = self.triangle_mut(index)
        {
            triangle[layout.index_intensity] = intensity as u16;
        }
    }

    /// Sets a triangle's base colour. Source: QK, `SetC`.
    pub fn set_c(&mut self, index: usize, color: i32) {
        let at = self.layout.index_color;
        if at > 0
            && let Some(triangle) = self.triangle_mut(index)
        {
            triangle[at] = color as u16;
        }
    }

    /// A triangle's corners. Source: QK, `GetABC`.
    pub fn abc(&self, index: usize) -> [u16; 3] {
        self.triangle(index).map_or([0; 3], |t| [t[0], t[1], t[2]])
    }

    /// A vertex's position. Source: QK, `GetXYZ`.
    pub fn xyz(&self, index: usize) -> [i16; 3] {
        self.vertex(index).map_or([0; 3], |v| [v[0], v[1], v[2]])
    }

    /// Texture coordinates: of a vertex in the first corner, of a triangle in
    /// all three. Source: QK, `GetUV`.
    pub fn uv(&self, index: usize) -> [Corner; 3] {
        let mut corners = [[0; 2]; 3];
        let layout = &self.layout;
        if layout.vertex_uv > 0 {
            if let Some(vertex) = self.vertex(index) {
                corners[0].copy_from_slice(&vertex[layout.vertex_uv..][..2]);
            }
        } else if layout.index_uv > 0
            && let Some(triangle) = self.triangle(index)
        {
            let values = triangle[layout.index_uv..].iter().map(|&n| n as i16);
            corners.as_flattened_mut().iter_mut().zip(values).for_each(|(to, n)| *to = n);
        }
        corners
    }

    /// The intensity of a vertex or a triangle. Source: QK, `GetI`.
    pub fn i(&self, index: usize) -> i32 {
        let layout = &self.layout;
        if layout.vertex_intensity > 0 {
            self.vertex(index).map_or(0, |v| i32::from(v[layout.vertex_intensity]))
        } else if layout.index_intensity > 0 {
            self.triangle(index).map_or(0, |t| i32::from(t[layout.index_intensity]))
        } else {
            0
        }
    }

    /// A triangle's base colour. Source: QK, `GetC`.
    pub fn c(&self, index: usize) -> i32 {
        match self.layout.index_color {
            0 => 0,
            at => self.triangle(index).map_or(0, |t| i32::from(t[at])),
        }
    }
}
