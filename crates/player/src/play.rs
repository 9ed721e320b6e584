//! Playing a trace.

use std::collections::HashMap;
use std::io::Read;

use fillrate_call::{BlobId, Data};
use fillrate_trace::{CallBatch, Counts, Ending, Event, FrameEnd, Meta, TraceReader};

use crate::error::PlayError;
use crate::frame::Frame;
use crate::report::{FrameResult, Report, Stop};
use crate::target::Target;

/// What a replay may use.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Stop after this many frames; `None` plays all.
    pub frames: Option<u64>,
    /// The most bytes of blobs held in memory.
    pub blob_bytes: u64,
}

impl Default for Limits {
    /// All frames, 1 GiB of blobs.
    fn default() -> Self {
        Self { frames: None, blob_bytes: 1 << 30 }
    }
}

/// One step of a replay.
#[derive(Debug)]
pub enum Played {
    /// A frame is complete.
    Frame {
        /// How it compares with what was recorded.
        result: FrameResult,
        /// The pixels.
        frame: Option<Frame>,
    },
    /// The trace ends, or the frame limit is reached. Every further step says so again.
    Stop(Stop),
}

/// Plays a trace frame by frame.
pub struct Player<R: Read, T: Target> {
    events: TraceReader<R>,
    target: T,
    limits: Limits,
    blobs: HashMap<BlobId, Data>,
    blob_bytes: u64,
    calls: u64,
    frames: u64,
    started: bool,
    ending: Option<Ending>,
}

impl<R: Read, T: Target> Player<R, T> {
    /// A player at the start of a trace.
    pub fn new(events: TraceReader<R>, target: T, limits: Limits) -> Self {
        Self {
            events,
            target,
            limits,
            blobs: HashMap::new(),
            blob_bytes: 0,
            calls: 0,
            frames: 0,
            started: false,
            ending: None,
        }
    }

    /// What draws.
    pub fn target(&mut self) -> &mut T {
        &mut self.target
    }

    /// What has been read from the trace.
    pub fn counts(&self) -> Counts {
        self.events.counts()
    }

    /// Plays up to the end of the next frame.
    ///
    /// # Errors
    /// [`PlayError`]; the frames before stay valid, and playing on is of no use.
    pub fn step(&mut self) -> Result<Played, PlayError> {
        if let Some(ending) = self.ending {
            return Ok(Played::Stop(Stop::End(ending)));
        }
        if self.limits.frames.is_some_and(|limit| self.frames >= limit) {
            return Ok(Played::Stop(Stop::FrameLimit));
        }
        while let Some(event) = self.events.next() {
            match event? {
                Event::Meta(meta) => self.start(&meta)?,
                Event::Blob { id, data } => self.keep(id, data)?,
                Event::Calls(batch) => self.execute(&batch)?,
                Event::FrameEnd(end) => return Ok(self.end_frame(end)),
                Event::End(ending) => return Ok(self.end(ending)),
                // Events of later versions of the reader say nothing that must be drawn.
                _ => {}
            }
        }
        // The reader ends without an end only after an error, which has been passed on.
        let last_frame = self.frames.checked_sub(1).and_then(|frame| u32::try_from(frame).ok());
        let counts = self.events.counts();
        Ok(self.end(Ending::Truncated { counts, last_frame, lost_bytes: 0 }))
    }

    /// Starts the target; metadata that comes later describes, but does not start again.
    fn start(&mut self, meta: &Meta) -> Result<(), PlayError> {
        if !self.started {
            self.started = true;
            self.target.start(meta).map_err(|source| PlayError::Start { source })?;
        }
        Ok(())
    }

    fn keep(&mut self, id: BlobId, data: Data) -> Result<(), PlayError> {
        if self.blobs.contains_key(&id) {
            return Ok(());
        }
        self.blob_bytes += data.len() as u64;
        let limit = self.limits.blob_bytes;
        if self.blob_bytes > limit {
            return Err(PlayError::Limit { size: self.blob_bytes, limit });
        }
        self.blobs.insert(id, data);
        Ok(())
    }

    fn execute(&mut self, batch: &CallBatch) -> Result<(), PlayError> {
        self.start(&Meta::new())?;
        for bytes in batch {
            let (frame, call) = (self.frames, self.calls);
            self.target.execute(bytes, &self.blobs).map_err(|source| PlayError::Call {
                frame,
                call,
                source,
            })?;
            self.calls += 1;
        }
        Ok(())
    }

    fn end_frame(&mut self, end: FrameEnd) -> Played {
        self.frames += 1;
        let frame = self.target.frame();
        Played::Frame { result: FrameResult::new(end, frame.as_ref()), frame }
    }

    fn end(&mut self, ending: Ending) -> Played {
        self.ending = Some(ending);
        Played::Stop(Stop::End(ending))
    }
}

/// Plays a whole trace. `on_frame` sees each frame as it is complete, with its pixels if there are any.
///
/// A failure is part of the report, next to the frames that were played before it.
pub fn play<R: Read, T: Target>(
    player: &mut Player<R, T>,
    mut on_frame: impl FnMut(&FrameResult, Option<&Frame>),
) -> Report {
    let mut frames = Vec::new();
    let stop = loop {
        match player.step() {
            Ok(Played::Frame { result, frame }) => {
                on_frame(&result, frame.as_ref());
                frames.push(result);
            }
            Ok(Played::Stop(stop)) => break stop,
            Err(error) => break Stop::Failed(error),
        }
    };
    Report { frames, counts: player.counts(), stop }
}
