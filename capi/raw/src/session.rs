//! The one client of the process.

use std::sync::{LazyLock, Mutex, MutexGuard, PoisonError};

use fillrate_capture::{Drawn, FrameLog, Recorder};
use fillrate_player::{Frame, Pixels};
use fillrate_raw::call::Call;
use fillrate_raw::client::Client;
use fillrate_raw::{Context, Shown};

use crate::globals::g_RInSceneStream;
use crate::settings::Settings;

/// The client and what listens to it.
pub struct Session {
    context: Context,
    recorder: Option<Recorder>,
    capture: Option<FrameLog>,
    exit_after: Option<u64>,
    frames: u64,
    /// A scene has ended since the last frame was noted.
    unshown: bool,
}

static SESSION: LazyLock<Mutex<Session>> = LazyLock::new(|| Mutex::new(Session::new()));

/// The client of the process.
pub fn session() -> MutexGuard<'static, Session> {
    SESSION.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Executes a call and records it; returns the words that came back.
pub fn call(call: Call) -> Vec<u32> {
    session().call(&call)
}

/// As [`call`], for calls that bring back one word; `fallback` where none may come.
pub fn ask(call: Call, fallback: u32) -> u32 {
    session().call(&call).first().copied().unwrap_or(fallback)
}

/// Asks the client something that sends nothing.
pub fn client<T>(question: impl FnOnce(&mut Client) -> T) -> T {
    question(session().context.client())
}

impl Session {
    fn new() -> Session {
        let settings = Settings::from_environment();
        let config = settings.config;
        let context = if settings.pipe {
            Context::piped(config, Box::new(std::io::stdout()), Box::new(std::io::stdin()))
        } else {
            Context::new(config)
        };
        let capture = settings.capture.filter(|_| !settings.pipe).and_then(|folder| {
            let log = FrameLog::new(folder, settings.every);
            log.map_err(|error| eprintln!("fillrate: cannot capture frames: {error}")).ok()
        });
        let size = format!("{}x{}", config.width, config.height);
        let more = [("size", size.as_str()), ("errata", config.errata.name())];
        let recorder = settings.trace.and_then(|file| {
            let recorder = Recorder::new(&file, "raw", &more);
            recorder.map_err(|error| eprintln!("fillrate: cannot record: {error}")).ok()
        });
        // SAFETY: the function stays loaded as long as the process.
        unsafe { atexit(finish_at_exit) };
        let exit_after = settings.exit_after;
        Session { context, recorder, capture, exit_after, frames: 0, unshown: false }
    }

    fn call(&mut self, call: &Call) -> Vec<u32> {
        self.record(call);
        let words = self.context.execute(call);
        g_RInSceneStream.set(u32::from(self.context.in_scene()));
        for report in self.context.take_reports() {
            eprintln!("fillrate: {report}");
        }
        match call {
            Call::EndScene {} => self.unshown = true,
            Call::FlipPage { .. } if !self.context.in_scene() => self.frame_shown(),
            Call::Halt {} => self.finish(),
            _ => {}
        }
        words
    }

    fn record(&mut self, call: &Call) {
        let Some(recorder) = &mut self.recorder else { return };
        if let Err(error) = recorder.record(call) {
            eprintln!("fillrate: recording stops: {error}");
            self.recorder = None;
        }
    }

    /// Hands the displayed page to whoever wants it.
    fn frame_shown(&mut self) {
        self.unshown = false;
        if self.capture.is_some() || self.recorder.is_some() {
            self.note_frame();
        }
        self.frames += 1;
        if self.exit_after.is_some_and(|limit| self.frames >= limit) {
            self.finish();
            std::process::exit(0);
        }
    }

    fn note_frame(&mut self) {
        let Some(frame) = self.context.shown().and_then(frame_of) else { return };
        let drawn = Drawn {
            triangles: self.context.primitives(),
            pixels: self.context.device().map_or(0, |device| device.fragments()),
        };
        if let Some(log) = &mut self.capture
            && let Err(error) = log.frame(self.frames, &frame, drawn)
        {
            eprintln!("fillrate: frames are no longer captured: {error}");
            self.capture = None;
        }
        if let Some(recorder) = &mut self.recorder
            && let Err(error) = recorder.frame(&frame)
        {
            eprintln!("fillrate: recording stops: {error}");
            self.recorder = None;
        }
    }

    /// Ends the files. What was drawn without a page flip is the last frame.
    fn finish(&mut self) {
        self.context.flush();
        if std::mem::take(&mut self.unshown) {
            self.note_frame();
        }
        self.capture = None;
        if let Some(recorder) = self.recorder.take()
            && let Err(error) = recorder.finish()
        {
            eprintln!("fillrate: the trace is cut short: {error}");
        }
    }
}

/// The displayed page as a frame.
fn frame_of(shown: Shown) -> Option<Frame> {
    Frame::new(shown.width, shown.height, Pixels::Rgba8(shown.rgba)).ok()
}

unsafe extern "C" {
    /// C's `atexit`.
    fn atexit(function: extern "C" fn()) -> i32;
}

extern "C" fn finish_at_exit() {
    fillrate_guard::guard((), || {
        // A program that exits inside a call holds the lock.
        if let Ok(mut session) = SESSION.try_lock() {
            session.finish();
        }
    });
}
