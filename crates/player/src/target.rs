//! What a replay draws with.

use std::error::Error;

use fillrate_call::BlobSource;
use fillrate_trace::Meta;

use crate::frame::Frame;

/// Why a target cannot go on; its own error type is its own business.
pub type TargetError = Box<dyn Error + Send + Sync>;

/// A front end as the player sees it: encoded calls in, frames out.
pub trait Target {
    /// Prepares for a trace that says this of itself. Called once, before any call.
    ///
    /// # Errors
    /// If calls of this API, or the configuration, are not understood.
    fn start(&mut self, meta: &Meta) -> Result<(), TargetError>;

    /// Decodes and executes one call. `blobs` holds the data that it may refer to.
    ///
    /// # Errors
    /// If the bytes are no call. What the historic system reports as a failure is no error here.
    fn execute(&mut self, call: &[u8], blobs: &dyn BlobSource) -> Result<(), TargetError>;

    /// The frame that was shown last, complete; `None` before the first or if nothing is shown.
    ///
    /// Called at each end of a frame.
    fn frame(&mut self) -> Option<Frame>;
}
