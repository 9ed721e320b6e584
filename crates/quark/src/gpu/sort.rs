//! Faces that wait to be drawn from far to near.
//!
//! Source: QK, Z sort of triangles.

use std::sync::Arc;

use super::Gpu;
use super::brush::Brush;
use crate::state::Vertex;

/// Distances that are told apart; greater ones count as the last.
const BUCKETS: i64 = 4096;

/// A face that waits.
#[derive(Clone, Debug)]
struct Face {
    /// Mean distance, 0..4095.
    key: u16,
    color: u8,
    brush: Arc<Brush>,
    corners: [Vertex; 3],
}

/// Waiting faces, in the order they came.
#[derive(Debug, Default)]
pub(crate) struct SortTable {
    faces: Vec<Face>,
    capacity: usize,
}

impl SortTable {
    /// A table for `capacity` faces.
    pub fn new(capacity: usize) -> SortTable {
        SortTable { faces: Vec::new(), capacity }
    }

    /// Keeps a face; where the table is full, forgets it.
    pub fn add(&mut self, brush: &Arc<Brush>, color: u8, corners: &[Vertex; 3]) {
        if self.faces.len() >= self.capacity {
            return;
        }
        let mean = corners.iter().map(|c| i64::from(c.z)).sum::<i64>() / 3;
        self.faces.push(Face {
            key: mean.clamp(0, BUCKETS - 1) as u16,
            color,
            brush: Arc::clone(brush),
            corners: *corners,
        });
    }
}

impl Gpu {
    /// Forgets the faces that wait. Source: QK, `SortReset`.
    pub fn sort_reset(&mut self) {
        self.sort.faces.clear();
    }

    /// Draws the faces that wait, the farthest first, equally far ones in the
    /// order they came. Source: QK, `SortDraw`.
    pub fn sort_draw(&mut self) {
        let mut faces = std::mem::take(&mut self.sort.faces);
        faces.sort_by_key(|face| std::cmp::Reverse(face.key));
        for face in &faces {
            self.draw_face(&face.brush, face.color, &face.corners);
        }
        faces.clear();
        self.sort.faces = faces;
    }

    /// How many faces wait.
    pub fn sorted_faces(&self) -> usize {
        self.sort.faces.len()
    }
}
