//! What a replay found.

use fillrate_trace::{Counts, Ending, FrameEnd};

use crate::error::PlayError;
use crate::frame::Frame;

/// Whether a frame is what it was when it was recorded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Size and hash are the recorded ones.
    Same,
    /// Size or hash differs, or there is no frame although one was recorded.
    Differs,
    /// No hash was recorded.
    Unchecked,
}

/// One replayed frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FrameResult {
    /// What was recorded: number, size, hash.
    pub recorded: FrameEnd,
    /// Width and height in pixels now; `None` if the target showed nothing.
    pub size: Option<(u32, u32)>,
    /// The hash of the pixels now.
    pub hash: Option<u64>,
    /// How the two compare.
    pub verdict: Verdict,
}

impl FrameResult {
    /// Judges what the target shows at the end of a recorded frame.
    pub(crate) fn new(recorded: FrameEnd, frame: Option<&Frame>) -> Self {
        let size = frame.map(|frame| (frame.width(), frame.height()));
        let hash = frame.map(Frame::hash);
        let same_size = size == Some((recorded.info.width, recorded.info.height));
        let verdict = match recorded.info.hash {
            None => Verdict::Unchecked,
            Some(_) if same_size && hash == recorded.info.hash => Verdict::Same,
            Some(_) => Verdict::Differs,
        };
        Self { recorded, size, hash, verdict }
    }
}

/// Why a replay is over.
#[derive(Debug)]
pub enum Stop {
    /// The trace has been played as far as it goes, which may be less than was recorded.
    End(Ending),
    /// As many frames as were asked for have been played.
    FrameLimit,
    /// It could not go on.
    Failed(PlayError),
}

/// A whole replay.
#[derive(Debug)]
pub struct Report {
    /// Every complete frame in order.
    pub frames: Vec<FrameResult>,
    /// What was read from the trace.
    pub counts: Counts,
    /// Why it is over.
    pub stop: Stop,
}

impl Report {
    /// The first frame that is not what was recorded.
    pub fn first_difference(&self) -> Option<&FrameResult> {
        self.frames.iter().find(|frame| frame.verdict == Verdict::Differs)
    }

    /// How many frames have this verdict.
    pub fn count(&self, verdict: Verdict) -> usize {
        self.frames.iter().filter(|frame| frame.verdict == verdict).count()
    }
}
