//! What can go wrong with frames and replays.

use fillrate_trace::TraceError;

use crate::frame::MAX_FRAME_PIXELS;
use crate::target::TargetError;

/// Why pixels are no frame, or a frame cannot be stored or loaded.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FrameError {
    /// A width or height of 0, or more pixels than [`MAX_FRAME_PIXELS`].
    #[error("a frame of {width} x {height} pixels is empty or exceeds {MAX_FRAME_PIXELS} pixels")]
    Size {
        /// Width in pixels.
        width: u32,
        /// Height in pixels.
        height: u32,
    },
    /// The pixels do not fill the frame exactly.
    #[error("{found} elements given for the pixels of a frame that takes {needed}")]
    Length {
        /// Bytes or 16-bit words that the frame takes.
        needed: usize,
        /// How many were given.
        found: usize,
    },
    /// The two frames to compare have no common size.
    #[error("frames of {} x {} and {} x {} pixels have no difference image", .expected.0, .expected.1, .actual.0, .actual.1)]
    SizesDiffer {
        /// Width and height of the one.
        expected: (u32, u32),
        /// Width and height of the other.
        actual: (u32, u32),
    },
    /// The picture file could not be written.
    #[error("png cannot be written")]
    Encode(#[from] png::EncodingError),
    /// The picture file could not be read.
    #[error("png cannot be read")]
    Decode(#[from] png::DecodingError),
}

/// Why a replay stopped before its end.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum PlayError {
    /// The trace could not be read further.
    #[error(transparent)]
    Trace(#[from] TraceError),
    /// The target refuses the trace.
    #[error("trace cannot be replayed")]
    Start {
        /// Why.
        source: TargetError,
    },
    /// The target failed to execute a call.
    #[error("frame {frame}: call {call} cannot be executed")]
    Call {
        /// The frame that the call belongs to, from 0.
        frame: u64,
        /// The call within the trace, from 0.
        call: u64,
        /// Why.
        source: TargetError,
    },
    /// The blobs of the trace exceed [`Limits::blob_bytes`](crate::Limits::blob_bytes).
    #[error("blobs of {size} bytes exceed the limit of {limit} bytes")]
    Limit {
        /// Their size in bytes so far.
        size: u64,
        /// The limit in bytes.
        limit: u64,
    },
}
