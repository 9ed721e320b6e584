//! Triangle lists: transform, clip, draw.
//!
//! Source: QK, `DrawTriangleList`.

use std::sync::Arc;

use super::brush::Brush;
use super::{Camera, Gpu};
use crate::clip;
use crate::error::ErrorCode;
use crate::list::{Layout, ListView};
use crate::matrix::Matrix;
use crate::state::{RasterState, TriangleMode, Vertex};

/// A transformed vertex.
#[derive(Clone, Copy, Debug, Default)]
struct Transformed {
    world: [i32; 3],
    screen: [i32; 3],
    mask: i32,
}

/// Room for the vertices of a list.
#[derive(Debug, Default)]
pub(crate) struct WorkMemory {
    /// Vertices that fit.
    capacity: usize,
    vertices: Vec<Transformed>,
}

impl WorkMemory {
    pub fn new(capacity: usize) -> WorkMemory {
        WorkMemory { capacity, vertices: Vec::new() }
    }
}

/// A corner of a face before projection.
#[derive(Clone, Copy, Debug, Default)]
struct Corner {
    at: Transformed,
    i: i32,
    u: i32,
    v: i32,
}

impl Corner {
    fn vertex(&self) -> Vertex {
        let [x, y, z] = self.at.screen;
        Vertex { x, y, z, m: self.at.mask, i: self.i, u: self.u, v: self.v }
    }
}

/// What all faces of a command share.
struct Batch<'a> {
    view: &'a ListView<'a>,
    layout: Layout,
    vertices: &'a [Transformed],
    state: &'a RasterState,
    brush: Arc<Brush>,
}

impl Gpu {
    /// Draws a triangle list through the view matrix, by the triangle mode and
    /// the list's states. The triangle state is not used.
    ///
    /// # Errors
    /// [`ErrorCode::WorkMemory`] for more vertices than [`Gpu::set_work_memory`]
    /// made room for; [`ErrorCode::Uv`] for a textured mode without texture
    /// coordinates; those of [`Layout::new`].
    pub fn draw_list(&mut self, view: &ListView<'_>) -> Result<(), ErrorCode> {
        let layout = Layout::new(view.vertex_format, view.index_format)?;
        let count = view.vertices.len() / layout.vertex_stride;
        if count > self.work.capacity {
            return Err(ErrorCode::WorkMemory);
        }
        let Some(mode) = self.triangle_mode else { return Ok(()) };
        if mode.is_textured() && !view.vertex_format.uv && !view.index_format.uv {
            return Err(ErrorCode::Uv);
        }
        let mut vertices = std::mem::take(&mut self.work.vertices);
        let matrix = self.view_matrix.unwrap_or_default();
        transform(view.vertices, &layout, &matrix, &self.camera, &mut vertices);
        self.draw_commands(view, layout, &vertices, mode);
        self.work.vertices = vertices;
        Ok(())
    }

    fn draw_commands(
        &mut self,
        view: &ListView<'_>,
        layout: Layout,
        vertices: &[Transformed],
        mode: TriangleMode,
    ) {
        let mut faces = view.indices.chunks_exact(layout.index_stride);
        for command in view.commands {
            let faces = faces.by_ref().take(usize::from(command.count));
            let Some(state) = view.states.get(usize::from(command.state)) else {
                faces.for_each(drop);
                continue;
            };
            let brush = self.brush(state, mode);
            let batch = Batch { view, layout, vertices, state, brush };
            for face in faces {
                self.list_face(&batch, face);
            }
        }
    }

    fn list_face(&mut self, batch: &Batch<'_>, face: &[u16]) {
        let vertex = |i: usize| batch.vertices.get(usize::from(face[i]));
        let (Some(a), Some(b), Some(c)) = (vertex(0), vertex(1), vertex(2)) else { return };
        let any = a.mask | b.mask | c.mask;
        if a.mask & b.mask & c.mask != 0 || any & clip::FAR != 0 {
            return;
        }
        let corners = batch.corners(face, [*a, *b, *c]);
        let color = batch.color(face);
        if any & clip::NEAR == 0 {
            self.face(&batch.brush, color, &corners.map(|corner| corner.vertex()));
        } else {
            self.truncated_face(batch, color, &corners);
        }
    }

    /// Draws the part of a face beyond the near plane.
    fn truncated_face(&mut self, batch: &Batch<'_>, color: u8, corners: &[Corner; 3]) {
        let (part, count) = truncate(corners, &self.camera);
        for last in 2..count {
            let face = [part[0], part[last - 1], part[last]];
            self.face(&batch.brush, color, &face.map(|corner| corner.vertex()));
        }
    }
}

/// Transforms and projects vertices. Those before the near plane get the near
/// bit, whether they can be projected or not.
fn transform(
    numbers: &[i16],
    layout: &Layout,
    matrix: &Matrix,
    camera: &Camera,
    out: &mut Vec<Transformed>,
) {
    out.clear();
    out.extend(numbers.chunks_exact(layout.vertex_stride).map(|vertex| {
        let at = [vertex[0], vertex[1], vertex[2]].map(i32::from);
        project(matrix.transform_vector(&at), camera)
    }));
}

fn project(world: [i32; 3], camera: &Camera) -> Transformed {
    if world[2] > camera.near {
        return Transformed { world, screen: [0; 3], mask: clip::NEAR };
    }
    let (mask, screen) = camera.project(&world);
    Transformed { world, screen: screen.unwrap_or_default(), mask }
}

impl Batch<'_> {
    /// A face's base colour.
    fn color(&self, face: &[u16]) -> u8 {
        match self.layout.index_color {
            0 => self.state.draw_color,
            at => face[at] as u8,
        }
    }

    /// A face's corners with light and texture coordinates, from wherever the
    /// formats have them.
    fn corners(&self, face: &[u16], at: [Transformed; 3]) -> [Corner; 3] {
        let layout = &self.layout;
        std::array::from_fn(|i| {
            let vertex = &self.view.vertices[usize::from(face[i]) * layout.vertex_stride..];
            let light = match (layout.vertex_intensity, layout.index_intensity) {
                (0, 0) => i32::from(self.state.draw_intensity),
                (0, of_face) => i32::from(face[of_face]),
                (of_vertex, _) => i32::from(vertex[of_vertex]),
            };
            let [u, v] = match (layout.vertex_uv, layout.index_uv) {
                (0, 0) => [0; 2],
                (0, of_face) => [0, 1].map(|k| i32::from(face[of_face + 2 * i + k] as i16)),
                (of_vertex, _) => [0, 1].map(|k| i32::from(vertex[of_vertex + k])),
            };
            Corner { at: at[i], i: light, u, v }
        })
    }
}

/// The part of a face at or beyond the near plane, in the same order from its
/// first visible corner on: none, three or four corners.
fn truncate(corners: &[Corner; 3], camera: &Camera) -> ([Corner; 4], usize) {
    let mut part = [Corner::default(); 4];
    let mut count = 0;
    let mut add = |corner: Corner| {
        part[count] = corner;
        count += 1;
    };
    let is_near = |corner: &Corner| corner.at.mask & clip::NEAR != 0;
    let enters = |i: &usize| !is_near(&corners[*i]) && is_near(&corners[(i + 2) % 3]);
    let first = (0..3).find(enters).unwrap_or(0);
    for i in first..first + 3 {
        let (from, to) = (&corners[i % 3], &corners[(i + 1) % 3]);
        if !is_near(from) {
            add(*from);
        }
        if is_near(from) != is_near(to) {
            add(crossing(from, to, camera));
        }
    }
    (part, count)
}

/// Where the edge between two corners meets the near plane; the same from
/// either end.
fn crossing(a: &Corner, b: &Corner, camera: &Camera) -> Corner {
    // From the visible end to the hidden one, so that neighbours agree.
    let (a, b) = if a.at.mask & clip::NEAR == 0 { (a, b) } else { (b, a) };
    let (from, to) = (i64::from(a.at.world[2]), i64::from(b.at.world[2]));
    let t = ((i64::from(camera.near) - from) << 16) / (to - from).max(1);
    let mix = |a: i32, b: i32| {
        let moved = ((i64::from(b) - i64::from(a)) * t) >> 16;
        (i64::from(a) + moved) as i32
    };
    let [x, y] = [0, 1].map(|k| mix(a.at.world[k], b.at.world[k]));
    let at = project([x, y, camera.near], camera);
    Corner { at, i: mix(a.i, b.i), u: mix(a.u, b.u), v: mix(a.v, b.v) }
}
