//! The recording functions of the upper layer (`VL_*` with a command buffer).
//!
//! They write words into a [`CommandSink`] and check what can be checked
//! without a device. The chip carries out the words: a program that writes the
//! same words itself gets the same picture.
//!
//! Source: RR, function reference; word layouts from FIFO commands.

mod draw;
mod install;
pub(crate) mod memory;
mod state;

pub use draw::*;
pub use install::*;
pub use memory::*;
pub use state::*;

use crate::command::CommandSink;
use crate::error::{Failure, Result, VError, VRoutine, VlError, VlRoutine};

/// An invalid argument of `routine`.
pub(crate) fn invalid(routine: VlRoutine) -> Failure {
    Failure::vl(routine, VlError::ParamError)
}

/// A reservation that failed, as `routine` reports it.
pub(crate) fn unadded(routine: VlRoutine, error: VError) -> Failure {
    Failure::v(VRoutine::AddToCmdList, error).then(routine, VlError::AddToCmdListFailed)
}

/// Appends words.
#[inline]
pub(crate) fn put<S: CommandSink + ?Sized>(
    sink: &mut S,
    routine: VlRoutine,
    words: &[u32],
) -> Result<()> {
    let out = sink.reserve(words.len(), 0).map_err(|error| unadded(routine, error))?;
    out.copy_from_slice(words);
    Ok(())
}

/// Two coordinates or sizes in one word (`V_FIFO_PACK_XY`).
pub(crate) fn pair(high: u32, low: u32) -> u32 {
    high << 16 | low & 0xffff
}
