//! Normals for lighting.

use super::TriangleList;
use crate::math::{def_u_normal, normalize};

impl TriangleList {
    /// The unit normal of each triangle, towards whoever sees it
    /// counter-clockwise; zeros where it has none.
    ///
    /// Source: QK, `BuildFNormalList`.
    pub fn face_normals(&self) -> Vec<[i16; 3]> {
        (0..self.triangle_count()).map(|i| self.face_normal(i).map(|n| n as i16)).collect()
    }

    /// The unit normal of each vertex: the mean direction of the triangles
    /// that use it; zeros where none does.
    ///
    /// Source: QK, `BuildVNormalList`.
    pub fn vertex_normals(&self) -> Vec<[i16; 3]> {
        let mut sums = vec![[0i32; 3]; self.vertex_count()];
        for i in 0..self.triangle_count() {
            let normal = self.face_normal(i);
            for corner in self.abc(i) {
                if let Some(sum) = sums.get_mut(usize::from(corner)) {
                    sum.iter_mut().zip(normal).for_each(|(sum, n)| *sum = sum.saturating_add(n));
                }
            }
        }
        sums.into_iter()
            .map(|mut sum| {
                normalize(&mut sum);
                sum.map(|n| n as i16)
            })
            .collect()
    }

    fn face_normal(&self, index: usize) -> [i32; 3] {
        let abc = self.abc(index).map(usize::from);
        if abc.iter().any(|&corner| corner >= self.vertex_count()) {
            return [0; 3];
        }
        let [a, b, c] = abc.map(|corner| self.xyz(corner).map(i32::from));
        let mut normal = def_u_normal(&a, &b, &c);
        normalize(&mut normal);
        normal
    }
}
