//! Vertex arrays and meshes.

use super::Pen;
use super::triangle::plain;
use crate::RaveError;
use crate::constants::vertex_mode;
use crate::vertex::{IndexedTriangle, VGouraud, VTexture};

/// The triangles of an array of `count` vertices: the places of their corners.
fn triangles(mode: u32, count: usize) -> impl Iterator<Item = [usize; 3]> {
    let number = match mode {
        vertex_mode::TRI => count / 3,
        _ => count.saturating_sub(2),
    };
    (0..number).map(move |i| match mode {
        vertex_mode::TRI => [3 * i, 3 * i + 1, 3 * i + 2],
        vertex_mode::STRIP => [i, i + 1, i + 2],
        _ => [0, i + 1, i + 2],
    })
}

impl Pen<'_> {
    /// `QADrawVGouraud`.
    pub fn v_gouraud(&mut self, mode: u32, v: &[VGouraud]) {
        match mode {
            vertex_mode::POINT => v.iter().for_each(|v| self.point(v)),
            vertex_mode::LINE => {
                for [a, b] in v.as_chunks().0 {
                    self.line([a, b]);
                }
            }
            vertex_mode::POLYLINE => {
                let mut passed = 0;
                for pair in v.windows(2) {
                    passed = self.line_after([&pair[0], &pair[1]], passed);
                }
            }
            vertex_mode::TRI | vertex_mode::STRIP | vertex_mode::FAN => {
                for at in triangles(mode, v.len()) {
                    self.tri_gouraud(at.map(|i| &v[i]));
                }
            }
            _ => self.context.fail(RaveError::Parameter),
        }
    }

    /// `QADrawVTexture`. Points and lines show their diffuse colour.
    pub fn v_texture(&mut self, mode: u32, v: &[VTexture]) {
        match mode {
            vertex_mode::POINT | vertex_mode::LINE | vertex_mode::POLYLINE => {
                let plain: Vec<VGouraud> = v.iter().map(plain).collect();
                self.v_gouraud(mode, &plain);
            }
            vertex_mode::TRI | vertex_mode::STRIP | vertex_mode::FAN => {
                for at in triangles(mode, v.len()) {
                    self.tri_texture(at.map(|i| &v[i]), at);
                }
            }
            _ => self.context.fail(RaveError::Parameter),
        }
    }

    /// `QADrawTriMeshGouraud`.
    pub fn mesh_gouraud(&mut self, triangles: &[IndexedTriangle]) {
        let vertices = self.context.vertices_gouraud.clone();
        for triangle in triangles {
            match triangle.vertices.map(|i| vertices.get(i as usize)) {
                [Some(a), Some(b), Some(c)] => self.tri_gouraud([a, b, c]),
                _ => self.context.fail(RaveError::Parameter),
            }
        }
    }

    /// `QADrawTriMeshTexture`.
    pub fn mesh_texture(&mut self, triangles: &[IndexedTriangle]) {
        let vertices = self.context.vertices_texture.clone();
        for triangle in triangles {
            let at = triangle.vertices.map(|i| i as usize);
            match at.map(|i| vertices.get(i)) {
                [Some(a), Some(b), Some(c)] => self.tri_texture([a, b, c], at),
                _ => self.context.fail(RaveError::Parameter),
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn modes_number_their_corners() {
        let all = |mode, count| triangles(mode, count).collect::<Vec<_>>();
        assert_eq!(all(vertex_mode::TRI, 8), [[0, 1, 2], [3, 4, 5]]);
        assert_eq!(all(vertex_mode::STRIP, 4), [[0, 1, 2], [1, 2, 3]]);
        assert_eq!(all(vertex_mode::FAN, 4), [[0, 1, 2], [0, 2, 3]]);
        assert!(all(vertex_mode::FAN, 2).is_empty() && all(vertex_mode::STRIP, 0).is_empty());
    }
}
