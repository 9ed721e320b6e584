//! What fails, and how.

use fillrate_engine::EngineError;

/// The documented error codes. Source: QK, `eErrorCode`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, thiserror::Error)]
#[repr(i32)]
pub enum ErrorCode {
    /// No error.
    #[default]
    #[error("no error")]
    None = 0,
    /// Memory could not be had.
    #[error("memory could not be had")]
    Memory = 1,
    /// The work memory is too small.
    #[error("the work memory is too small for the list")]
    WorkMemory = 2,
    /// Texture coordinates are undefined.
    #[error("textured drawing of a list without texture coordinates")]
    Uv = 3,
    /// Unknown vertex format.
    #[error("unknown vertex format")]
    VertexFormat = 4,
    /// Unknown index format.
    #[error("unknown index format")]
    IndexFormat = 5,
    /// Intensity both in vertices and indices.
    #[error("intensity both in vertices and in indices")]
    DuplicateIntensity = 6,
    /// Texture coordinates both in vertices and indices.
    #[error("texture coordinates both in vertices and in indices")]
    DuplicateUv = 7,
}

impl ErrorCode {
    /// All codes, in order.
    pub const ALL: [ErrorCode; 8] = [
        ErrorCode::None,
        ErrorCode::Memory,
        ErrorCode::WorkMemory,
        ErrorCode::Uv,
        ErrorCode::VertexFormat,
        ErrorCode::IndexFormat,
        ErrorCode::DuplicateIntensity,
        ErrorCode::DuplicateUv,
    ];

    /// The documented number.
    pub fn code(self) -> i32 {
        self as i32
    }
}

/// Why something cannot be made or set.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum QuarkError {
    /// The engine refused.
    #[error(transparent)]
    Engine(#[from] EngineError),
    /// A documented error.
    #[error(transparent)]
    Code(#[from] ErrorCode),
    /// A side of the frame buffer.
    #[error("a frame buffer of {width} x {height} pixels; sides are 16 to 2048")]
    Size {
        /// Columns.
        width: u32,
        /// Rows.
        height: u32,
    },
    /// Clipping planes.
    #[error("clipping planes at {near} and {far}; they lie in -4095..=-64, near above far")]
    Planes {
        /// Near plane.
        near: i32,
        /// Far plane.
        far: i32,
    },
    /// Field of view.
    #[error("a field of view of {0} degrees; 8 to 120 are possible")]
    FieldOfView(i32),
    /// Texture size or data.
    #[error("a texture of {width} x {height} with {given} texels; sides are 1 to 2048")]
    Texture {
        /// Columns.
        width: i32,
        /// Rows.
        height: i32,
        /// Texels there are.
        given: usize,
    },
}
