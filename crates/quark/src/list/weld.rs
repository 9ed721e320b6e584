//! Welding: merging vertices that are nearly the same.

use super::TriangleList;

impl TriangleList {
    /// Merges vertices that differ by no more than `position`, `intensity` and
    /// `uv` in any component from the first of their group; the vertex kept is
    /// the mean of the group, rounded to nearest, at the place of the first.
    /// Negative limits merge nothing. Takes time by the square of the number
    /// of vertices.
    ///
    /// Source: QK, `WeldVertex`.
    pub fn weld(&mut self, position: i32, intensity: i32, uv: i32) {
        let limits = self.limits(position, intensity, uv);
        let groups = self.groups(&limits);
        self.keep_means(&groups);
        for triangle in self.indices.chunks_exact_mut(self.layout.index_stride) {
            for corner in &mut triangle[..3] {
                // Corners outside the list stay outside.
                if let Some(&group) = groups.get(usize::from(*corner)) {
                    *corner = group as u16;
                }
            }
        }
    }

    /// The limit of each component of a vertex.
    fn limits(&self, position: i32, intensity: i32, uv: i32) -> Vec<i32> {
        let mut limits = vec![position; 3];
        if self.vertex_format.intensity {
            limits.push(intensity);
        }
        if self.vertex_format.uv {
            limits.extend([uv; 2]);
        }
        limits
    }

    /// The group of each vertex, groups numbered by their first vertices.
    fn groups(&self, limits: &[i32]) -> Vec<usize> {
        let vertices: Vec<&[i16]> = self.vertices.chunks_exact(self.layout.vertex_stride).collect();
        let mut groups = vec![usize::MAX; vertices.len()];
        let mut count = 0;
        for first in 0..vertices.len() {
            if groups[first] != usize::MAX {
                continue;
            }
            groups[first] = count;
            for other in first + 1..vertices.len() {
                if groups[other] == usize::MAX && near(vertices[first], vertices[other], limits) {
                    groups[other] = count;
                }
            }
            count += 1;
        }
        groups
    }

    /// Replaces the vertices by the means of their groups.
    fn keep_means(&mut self, groups: &[usize]) {
        let stride = self.layout.vertex_stride;
        let count = groups.iter().max().map_or(0, |&last| last + 1);
        let mut sums = vec![0i64; count * stride];
        let mut sizes = vec![0i64; count];
        for (vertex, &group) in self.vertices.chunks_exact(stride).zip(groups) {
            sizes[group] += 1;
            let sum = &mut sums[group * stride..][..stride];
            sum.iter_mut().zip(vertex).for_each(|(sum, &n)| *sum += i64::from(n));
        }
        let sizes = sizes.into_iter().flat_map(|size| std::iter::repeat_n(size, stride));
        let mean = |(sum, size): (i64, i64)| (2 * sum + size).div_euclid(2 * size) as i16;
        self.vertices = sums.into_iter().zip(sizes).map(mean).collect();
    }
}

/// Whether no component differs by more than its limit.
fn near(a: &[i16], b: &[i16], limits: &[i32]) -> bool {
    let differs = |(a, b): (&i16, &i16)| (i32::from(*a) - i32::from(*b)).abs();
    a.iter().zip(b).map(differs).zip(limits).all(|(difference, &limit)| difference <= limit)
}
