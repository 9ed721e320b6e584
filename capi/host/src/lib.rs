//! What the drop-in libraries share beside their APIs: settings from the
//! environment, recording calls, capturing frames, and ending a program after
//! so many frames.

mod capture;
mod record;
mod settings;

use fillrate_call::Value;
use fillrate_engine::Counters;
use fillrate_player::Frame;
use fillrate_trace::{FrameInfo, Meta};

pub use capture::Capture;
pub use settings::{Settings, number, variable};

use record::Recorder;

/// What listens to a library.
#[derive(Default)]
pub struct Host {
    recorder: Option<Recorder>,
    capture: Option<Capture>,
    exit_after: Option<u64>,
    frames: u64,
}

impl Host {
    /// The listeners that the settings ask for; `meta` starts a recording.
    /// What cannot be had is told on standard error.
    pub fn new(settings: &Settings, meta: &Meta) -> Host {
        let capture = settings.capture.clone().and_then(|folder| {
            let capture = Capture::new(folder, settings.every);
            capture.map_err(|error| eprintln!("fillrate: cannot capture frames: {error}")).ok()
        });
        let recorder = settings.trace.as_deref().and_then(|file| {
            let recorder = Recorder::new(file, meta);
            recorder.map_err(|error| eprintln!("fillrate: cannot record: {error}")).ok()
        });
        Host { recorder, capture, exit_after: settings.exit_after, frames: 0 }
    }

    /// Whether calls are recorded.
    pub fn is_recording(&self) -> bool {
        self.recorder.is_some()
    }

    /// Records a call, where somebody records.
    pub fn record(&mut self, call: &impl Value) {
        let Some(recorder) = &mut self.recorder else { return };
        if let Err(error) = recorder.record(call) {
            eprintln!("fillrate: recording stops: {error}");
            self.recorder = None;
        }
    }

    /// Whether [`Host::frame_shown`] does anything with a frame.
    pub fn wants_frames(&self) -> bool {
        self.capture.is_some() || self.recorder.is_some()
    }

    /// Hands a frame that was shown to whoever wants it, with the counters
    /// since the start. Ends the program where it was the last one.
    pub fn frame_shown(&mut self, shown: Option<(Frame, Counters)>) {
        if let Some((frame, counters)) = shown {
            self.note_frame(&frame, counters);
        }
        self.frames += 1;
        if self.exit_after.is_some_and(|limit| self.frames >= limit) {
            self.end();
            std::process::exit(0);
        }
    }

    fn note_frame(&mut self, frame: &Frame, counters: Counters) {
        if let Some(capture) = &mut self.capture
            && let Err(error) = capture.frame(self.frames, frame, counters)
        {
            eprintln!("fillrate: frames are no longer captured: {error}");
            self.capture = None;
        }
        if let Some(recorder) = &mut self.recorder {
            let info = FrameInfo {
                width: frame.width(),
                height: frame.height(),
                hash: Some(frame.hash()),
            };
            if let Err(error) = recorder.end_frame(info) {
                eprintln!("fillrate: recording stops: {error}");
                self.recorder = None;
            }
        }
    }

    /// Ends the recording for good.
    pub fn end(&mut self) {
        if let Some(recorder) = self.recorder.take()
            && let Err(error) = recorder.finish()
        {
            eprintln!("fillrate: the trace is cut short: {error}");
        }
    }
}

unsafe extern "C" {
    /// C's `atexit`.
    fn atexit(function: extern "C" fn()) -> i32;
}

/// Has a function called when the process ends normally.
pub fn at_exit(function: extern "C" fn()) {
    // SAFETY: the function is part of the library, which stays loaded.
    unsafe { atexit(function) };
}
