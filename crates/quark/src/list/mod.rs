//! Triangle lists: vertices, triangles, and the commands that draw them.
//!
//! Source: QK, `CTriangleList`.

mod access;
mod commands;
mod format;
mod normals;
mod weld;

pub use access::Corner;
pub use format::{IndexFormat, Layout, VertexFormat};

use crate::error::ErrorCode;
use crate::state::RasterState;

/// The most vertices, and the most triangles, of a list.
pub const MAX_COUNT: usize = 65_535;

/// Draws `count` triangles, in the list's order, by one state.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(C)]
pub struct Command {
    /// Triangles.
    pub count: u16,
    /// Number of the state.
    pub state: u16,
}

/// Vertices and triangles in flexible formats. All numbers are 16 bits.
#[derive(Clone, Debug)]
pub struct TriangleList {
    pub(crate) vertex_format: VertexFormat,
    pub(crate) index_format: IndexFormat,
    pub(crate) layout: Layout,
    pub(crate) vertices: Vec<i16>,
    pub(crate) indices: Vec<u16>,
    pub(crate) commands: Vec<Command>,
    /// The states that commands refer to.
    pub states: Vec<RasterState>,
}

impl TriangleList {
    /// A list of zeros, with one command that draws all by state 0.
    /// Source: QK, `CTriangleList::Init`.
    ///
    /// # Errors
    /// Those of [`Layout::new`]; [`ErrorCode::Memory`] for more than 65,535
    /// vertices or triangles.
    pub fn new(
        vertex_format: VertexFormat,
        vertices: usize,
        index_format: IndexFormat,
        triangles: usize,
        states: Vec<RasterState>,
    ) -> Result<TriangleList, ErrorCode> {
        let layout = Layout::new(vertex_format, index_format)?;
        if vertices > MAX_COUNT || triangles > MAX_COUNT {
            return Err(ErrorCode::Memory);
        }
        Ok(TriangleList {
            vertex_format,
            index_format,
            layout,
            vertices: vec![0; vertices * layout.vertex_stride],
            indices: vec![0; triangles * layout.index_stride],
            commands: vec![Command { count: triangles as u16, state: 0 }],
            states,
        })
    }

    /// A list from numbers in its layout; what does not fill a whole vertex or
    /// triangle is dropped.
    ///
    /// # Errors
    /// As [`TriangleList::new`].
    pub fn from_parts(
        vertex_format: VertexFormat,
        mut vertices: Vec<i16>,
        index_format: IndexFormat,
        mut indices: Vec<u16>,
        states: Vec<RasterState>,
    ) -> Result<TriangleList, ErrorCode> {
        let layout = Layout::new(vertex_format, index_format)?;
        let count = vertices.len() / layout.vertex_stride;
        let triangles = indices.len() / layout.index_stride;
        if count > MAX_COUNT || triangles > MAX_COUNT {
            return Err(ErrorCode::Memory);
        }
        vertices.truncate(count * layout.vertex_stride);
        indices.truncate(triangles * layout.index_stride);
        let commands = vec![Command { count: triangles as u16, state: 0 }];
        Ok(TriangleList {
            vertex_format,
            index_format,
            layout,
            vertices,
            indices,
            commands,
            states,
        })
    }

    /// What vertices hold.
    pub fn vertex_format(&self) -> VertexFormat {
        self.vertex_format
    }

    /// What triangles hold.
    pub fn index_format(&self) -> IndexFormat {
        self.index_format
    }

    /// Strides and offsets.
    pub fn layout(&self) -> &Layout {
        &self.layout
    }

    /// All numbers of the vertices.
    pub fn vertices(&self) -> &[i16] {
        &self.vertices
    }

    /// All numbers of the vertices.
    pub fn vertices_mut(&mut self) -> &mut [i16] {
        &mut self.vertices
    }

    /// All numbers of the triangles.
    pub fn indices(&self) -> &[u16] {
        &self.indices
    }

    /// All numbers of the triangles.
    pub fn indices_mut(&mut self) -> &mut [u16] {
        &mut self.indices
    }

    /// How many vertices there are.
    pub fn vertex_count(&self) -> usize {
        self.vertices.len() / self.layout.vertex_stride
    }

    /// How many triangles there are.
    pub fn triangle_count(&self) -> usize {
        self.indices.len() / self.layout.index_stride
    }

    /// The commands.
    pub fn commands(&self) -> &[Command] {
        &self.commands
    }

    /// The list as drawing reads it.
    pub fn view(&self) -> ListView<'_> {
        ListView {
            vertex_format: self.vertex_format,
            index_format: self.index_format,
            vertices: &self.vertices,
            indices: &self.indices,
            commands: &self.commands,
            states: &self.states,
        }
    }
}

/// A list as drawing reads it, wherever it lies.
#[derive(Clone, Copy, Debug)]
pub struct ListView<'a> {
    /// What vertices hold.
    pub vertex_format: VertexFormat,
    /// What triangles hold.
    pub index_format: IndexFormat,
    /// All numbers of the vertices.
    pub vertices: &'a [i16],
    /// All numbers of the triangles.
    pub indices: &'a [u16],
    /// The commands. Triangles beyond the list, and states beyond `states`,
    /// are not drawn.
    pub commands: &'a [Command],
    /// The states.
    pub states: &'a [RasterState],
}
