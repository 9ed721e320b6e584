//! What can go wrong when the engine is asked for something.

use crate::target::PixelFormat;

/// An engine request that cannot be met. Drawing itself never fails.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum EngineError {
    /// A surface side is 0 or above [`crate::target::MAX_SIDE`].
    #[error("surface of {width}x{height} pixels is outside 1..={max}", max = crate::target::MAX_SIDE)]
    SurfaceSize {
        /// Columns asked for.
        width: u32,
        /// Rows asked for.
        height: u32,
    },
    /// Colour and aux surface of one target differ in size.
    #[error("colour is {color:?} pixels, aux is {aux:?}")]
    TargetMismatch {
        /// Columns and rows of the colour surface.
        color: (u32, u32),
        /// Columns and rows of the aux surface.
        aux: (u32, u32),
    },
    /// A surface of this format cannot be used that way.
    #[error("a {format:?} surface cannot be used as {usage}")]
    WrongFormat {
        /// The surface's format.
        format: PixelFormat,
        /// The use that was asked for.
        usage: &'static str,
    },
    /// The surface was destroyed or belongs to another device.
    #[error("no such surface")]
    UnknownSurface,
    /// A texture level's data does not have the size its shape needs.
    #[error("texture level of {width}x{height} texels was given {given} texels")]
    TextureData {
        /// Columns.
        width: u32,
        /// Rows.
        height: u32,
        /// Texels given.
        given: usize,
    },
    /// A texture has no level, too many, or a side that is no power of two.
    #[error("texture shape is not allowed: {0}")]
    TextureShape(&'static str),
    /// The worker threads could not be started.
    #[error("cannot start worker threads: {0}")]
    Threads(String),
}
