//! The one library of the process.

use std::collections::HashMap;
use std::sync::{LazyLock, Mutex, MutexGuard, PoisonError};

use fillrate_capture::{Drawn, FrameLog, Recorder};
use fillrate_guard::guard;
use fillrate_player::{Frame, Pixels};
use fillrate_quark::{Call, Context, Reply, Shown};
use fillrate_settings::Settings;

use crate::memory::Memory;
use crate::sync::{KnownGpu, KnownTexture};

/// Where frames are copied to.
#[derive(Clone, Copy, Debug)]
pub struct Target {
    /// The first pixel.
    pub base: usize,
    /// Bytes to the right neighbour.
    pub right: i64,
    /// Bytes to the lower neighbour.
    pub down: i64,
}

/// The library and what is known of the program's objects, by address.
#[derive(Default)]
pub struct Session {
    /// The library itself.
    pub context: Context,
    recorder: Option<Recorder>,
    capture: Option<FrameLog>,
    exit_after: Option<u64>,
    frames: u64,
    /// Initialized processors.
    pub gpus: HashMap<usize, KnownGpu>,
    /// Textures that were seen.
    pub textures: HashMap<usize, KnownTexture>,
    /// The number of the processor and of the texture made last.
    pub last_gpu: u32,
    pub last_texture: u32,
    /// Memory of lists, textures and frame buffers.
    pub memory: Memory,
    /// Targets by number; deleted ones are `None`.
    pub targets: Vec<Option<Target>>,
}

static SESSION: LazyLock<Mutex<Session>> = LazyLock::new(|| Mutex::new(Session::new()));

/// The library of the process.
pub fn session() -> MutexGuard<'static, Session> {
    SESSION.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Session {
    fn new() -> Session {
        let settings = Settings::load();
        for problem in &settings.problems {
            eprintln!("fillrate: {problem}");
        }
        let capture = settings.capture.and_then(|folder| {
            let log = FrameLog::new(folder, settings.every);
            log.map_err(|error| eprintln!("fillrate: cannot capture frames: {error}")).ok()
        });
        let recorder = settings.trace.and_then(|file| {
            let recorder = Recorder::new(&file, "quark3d", &[]);
            recorder.map_err(|error| eprintln!("fillrate: cannot record: {error}")).ok()
        });
        if recorder.is_some() {
            // SAFETY: the function stays loaded as long as the process.
            unsafe { atexit(end_at_exit) };
        }
        Session {
            context: Context::new(settings.glide.device),
            recorder,
            capture,
            exit_after: settings.exit_after,
            ..Session::default()
        }
    }

    /// Whether calls are recorded.
    pub fn is_recording(&self) -> bool {
        self.recorder.is_some()
    }

    /// Records a call and carries it out.
    pub fn call(&mut self, call: &Call) -> Reply {
        if let Some(recorder) = &mut self.recorder
            && let Err(error) = recorder.record(call)
        {
            eprintln!("fillrate: recording stops: {error}");
            self.recorder = None;
        }
        self.context.execute(call)
    }

    /// Hands the frame just shown to whoever wants it. Ends the program where
    /// it was the last one.
    pub fn frame_shown(&mut self) {
        if self.capture.is_some() || self.recorder.is_some() {
            self.note_frame();
        }
        self.frames += 1;
        if self.exit_after.is_some_and(|limit| self.frames >= limit) {
            self.end();
            std::process::exit(0);
        }
    }

    fn note_frame(&mut self) {
        let Some(frame) = self.context.shown().and_then(frame_of) else { return };
        let counters = self.context.counters();
        let drawn = Drawn { triangles: counters.triangles_drawn, pixels: counters.pixels_in };
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

    /// Ends the trace for good.
    fn end(&mut self) {
        if let Some(recorder) = self.recorder.take()
            && let Err(error) = recorder.finish()
        {
            eprintln!("fillrate: the trace is cut short: {error}");
        }
    }
}

/// A shown frame in display colours.
fn frame_of(shown: Shown) -> Option<Frame> {
    Frame::new(shown.width, shown.height, Pixels::Rgba8(shown.rgba8888())).ok()
}

unsafe extern "C" {
    /// C's `atexit`.
    fn atexit(function: extern "C" fn()) -> i32;
}

extern "C" fn end_at_exit() {
    guard((), || {
        // A program that exits inside a call holds the lock.
        if let Ok(mut session) = SESSION.try_lock() {
            session.end();
        }
    });
}
