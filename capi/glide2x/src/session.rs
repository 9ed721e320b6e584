//! The one library of the process.

use std::sync::{LazyLock, Mutex, MutexGuard, PoisonError};

use fillrate_capture::{FrameLog, Recorder};
use fillrate_glide::{Call, Context, GlideConfig, GrVertex, Report, ScanOut};
use fillrate_settings::Settings;

use crate::capture::{drawn, frame_of, on_monitor};
use crate::manager::Records;

/// The type of an error callback: message, and whether it is fatal.
pub type ErrorCallback = Option<unsafe extern "C" fn(*const std::ffi::c_char, i32)>;

/// The library and what listens to it.
pub struct Session {
    /// The library itself.
    pub context: Context,
    recorder: Option<Recorder>,
    capture: Option<FrameLog>,
    scan_out: ScanOut,
    exit_after: Option<u64>,
    frames: u64,
    /// The program's callback.
    pub callback: ErrorCallback,
    /// The buffers that the calls before 2.4 read and write.
    pub old_buffers: [i32; 2],
    /// Records of mip maps that the program holds pointers to.
    pub records: Records,
}

static SESSION: LazyLock<Mutex<Session>> = LazyLock::new(|| Mutex::new(Session::new()));

/// The library of the process.
pub fn session() -> MutexGuard<'static, Session> {
    SESSION.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Executes a call, records it, and tells the program what went wrong.
pub fn call(call: Call) -> u32 {
    execute(call, None)
}

/// The same for a function that is another one's call: reports have its name.
pub fn call_as(function: &str, call: Call) -> u32 {
    execute(call, Some(function))
}

fn execute(call: Call, function: Option<&str>) -> u32 {
    let mut session = session();
    session.record_before(&call);
    let swaps = session.context.swaps();
    let result = session.context.execute(&call);
    // A register write can swap, too.
    if session.context.swaps() > swaps {
        session.frame_shown();
    }
    if let Call::GrGlideShutdown {} = call {
        session.finish();
    }
    tell(session, function);
    result
}

/// Draws a triangle; the call's value is only made where somebody records.
pub fn draw_triangle(a: &GrVertex, b: &GrVertex, c: &GrVertex) {
    let mut session = session();
    if session.recorder.is_some() {
        session.record_before(&Call::GrDrawTriangle { a: *a, b: *b, c: *c });
    }
    session.context.draw_triangle(a, b, c);
    tell(session, None);
}

/// Asks the library something and tells the program what went wrong. Whoever
/// asks sees what was stored through locks.
pub fn ask<T>(question: impl FnOnce(&mut Context) -> T) -> T {
    let mut session = session();
    session.record_stores();
    let answer = question(&mut session.context);
    tell(session, None);
    answer
}

/// In checking mode, tells of a null pointer.
pub fn null(function: &str) {
    ask(|context| context.null_pointer(function));
}

/// In checking mode, tells of a lock's description without its size.
pub fn wrong_info_size(function: &str) {
    ask(|context| context.wrong_info_size(function));
}

/// Passes reports on, with the library unlocked: a callback may call it.
/// `function` is the name to tell where it is not the call's own.
fn tell(mut session: MutexGuard<'static, Session>, function: Option<&str>) {
    if !session.context.has_reports() {
        return;
    }
    let reports = session.context.take_reports();
    let callback = session.callback;
    drop(session);
    for mut report in reports {
        if let Some(function) = function {
            report.function = function.to_string();
        }
        tell_one(callback, &report);
    }
}

fn tell_one(callback: ErrorCallback, report: &Report) {
    let Some(callback) = callback else {
        eprintln!("fillrate: {report}");
        return;
    };
    if let Ok(text) = std::ffi::CString::new(report.to_string()) {
        // SAFETY: the program gave a function of this type; the text outlives
        // the call.
        unsafe { callback(text.as_ptr(), i32::from(report.fatal)) }
    }
}

impl Session {
    fn new() -> Session {
        let settings = Settings::load_checking(cfg!(feature = "checked"));
        for problem in &settings.problems {
            eprintln!("fillrate: {problem}");
        }
        let described = settings.glide.describe();
        let context = Context::new(settings.glide).or_else(|error| {
            eprintln!("fillrate: {error}; the default board is used");
            Context::new(GlideConfig::default())
        });
        let capture = settings.capture.and_then(|folder| {
            let capture = FrameLog::new(folder, settings.every);
            capture.map_err(|error| eprintln!("fillrate: cannot capture frames: {error}")).ok()
        });
        let recorder = settings.trace.and_then(|file| {
            let config: Vec<(String, &str)> = described
                .iter()
                .map(|(key, value)| (format!("config.{key}"), value.as_str()))
                .collect();
            let config: Vec<(&str, &str)> = config.iter().map(|(k, v)| (k.as_str(), *v)).collect();
            let recorder = Recorder::new(&file, "glide2x", &config);
            recorder.map_err(|error| eprintln!("fillrate: cannot record: {error}")).ok()
        });
        if recorder.is_some() {
            // SAFETY: the function stays loaded as long as the process.
            unsafe { atexit(finish_at_exit) };
        }
        Session {
            context: context.expect("the default board is valid"),
            recorder,
            capture,
            scan_out: settings.scan_out,
            exit_after: settings.exit_after,
            frames: 0,
            callback: None,
            old_buffers: [1, 1],
            records: Records::default(),
        }
    }

    /// Records a call that is about to be carried out.
    fn record_before(&mut self, call: &Call) {
        if self.recorder.is_some() {
            if self.context.shows_stores(call) {
                self.record_stores();
            }
            self.record(call);
        }
    }

    /// Records what was stored through the write lock, and carries it out, all
    /// of it now as it will be when the recording is played.
    fn record_stores(&mut self) {
        if self.recorder.is_some()
            && let Some(changes) = self.context.lfb_stores()
        {
            let stored = Call::GrLfbStored { changes: changes.into() };
            self.record(&stored);
            self.context.execute(&stored);
        }
    }

    fn record(&mut self, call: &Call) {
        let Some(recorder) = &mut self.recorder else { return };
        if let Err(error) = recorder.record(call) {
            eprintln!("fillrate: recording stops: {error}");
            self.recorder = None;
        }
    }

    /// Hands the frame just shown to whoever wants it.
    fn frame_shown(&mut self) {
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
        let Some(shown) = self.context.shown() else { return };
        let Some(frame) = frame_of(&shown) else { return };
        let (counters, board) = (self.context.total_counters(), self.context.current_board());
        if let Some(capture) = &mut self.capture {
            let monitor = on_monitor(&shown, self.scan_out);
            let picture = monitor.as_ref().unwrap_or(&frame);
            let noted =
                capture.frame_of_screen(self.frames, board, &frame, picture, drawn(&counters));
            if let Err(error) = noted {
                eprintln!("fillrate: frames are no longer captured: {error}");
                self.capture = None;
            }
        }
        if let Some(recorder) = &mut self.recorder
            && let Err(error) = recorder.frame(&frame)
        {
            eprintln!("fillrate: recording stops: {error}");
            self.recorder = None;
        }
    }

    /// Ends the files.
    fn finish(&mut self) {
        if let Some(recorder) = &mut self.recorder
            && let Err(error) = recorder.flush()
        {
            eprintln!("fillrate: the trace is cut short: {error}");
        }
    }

    /// Ends the trace for good.
    fn end_trace(&mut self) {
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

extern "C" fn finish_at_exit() {
    // A program that exits inside a callback may hold the lock.
    if let Ok(mut session) = SESSION.try_lock() {
        session.end_trace();
    }
}
