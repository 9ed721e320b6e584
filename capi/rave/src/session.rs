//! The one library of the process.

use std::collections::{BTreeMap, HashMap};
use std::ffi::c_void;
use std::sync::{LazyLock, Mutex, MutexGuard, PoisonError};

use fillrate_capture::{Drawn, FrameLog, Recorder};
use fillrate_guard::guard;
use fillrate_player::{Frame, Pixels};
use fillrate_rave::gestalt::{Answer, selector};
use fillrate_rave::{
    Call, Context, DrawContextId, EngineId, RaveConfig, RaveRect, Reply, Shown, VGouraud,
    VMultiTexture, VTexture,
};
use fillrate_settings::Settings;

use crate::access::Staging;
use crate::engine::Engine;
use crate::layout::{Raw, RawImage, RawMemory, values};
use crate::manager::Engines;
use crate::notice::{DrawNotice, Notice};

/// The program's array that meshes refer to: read when they are drawn.
pub struct Lent<T: Raw> {
    pointer: usize,
    count: u32,
    /// What the library knows of it.
    sent: Option<Vec<T>>,
}

impl<T: Raw> Default for Lent<T> {
    fn default() -> Lent<T> {
        Lent { pointer: 0, count: 0, sent: None }
    }
}

impl<T: Raw + PartialEq> Lent<T> {
    /// An array that was just submitted.
    pub fn new(pointer: *const T::Layout, count: u32) -> Lent<T> {
        Lent { pointer: pointer as usize, count, sent: None }
    }

    /// What the array holds, where the library does not know it yet.
    ///
    /// # Safety
    /// The array is as it was submitted.
    pub unsafe fn news(&mut self) -> Option<Vec<T>> {
        // SAFETY: the caller's promise.
        let now = unsafe { values(self.pointer as *const T::Layout, self.count) };
        // What cannot be read holds no vertices.
        let now = now.unwrap_or_default();
        if self.sent.as_ref() == Some(&now) {
            return None;
        }
        self.sent = Some(now.clone());
        Some(now)
    }
}

/// A draw context of the built-in engine.
#[derive(Default)]
pub struct Known {
    /// Its number at the border.
    pub number: u32,
    /// The program's memory that it shows its pixels in, from the device's
    /// first pixel.
    pub device: Option<RawMemory>,
    /// Where on the device.
    pub rect: RaveRect,
    /// The parts of the device that may change; `None`: all.
    pub clip: Option<Vec<RaveRect>>,
    pub is_cache: bool,
    /// Which of the process's screens it is, for pictures of frames.
    pub screen: usize,
    /// A frame that ended is not in the program's memory yet.
    pub has_late_frame: bool,
    pub notices: [Notice; 5],
    pub gouraud: Lent<VGouraud>,
    pub texture: Lent<VTexture>,
    pub params: BTreeMap<u32, Lent<VMultiTexture>>,
    pub draw_access: Option<Staging>,
    pub z_access: Option<Staging>,
}

// SAFETY: addresses of the program's memory, used by one thread at a time.
unsafe impl Send for Known {}

/// A draw context of an engine of the program.
pub struct Foreign {
    pub engine: Engine,
    /// Submitted vertices, pointer and count: Gouraud and texture.
    pub submitted: [(usize, u32); 2],
}

/// A texture or bitmap whose memory the program lends.
pub struct LentPicture {
    pub number: u32,
    pub is_bitmap: bool,
    pub flags: u32,
    pub pixel_type: u32,
    pub images: Vec<RawImage>,
    /// What the library knows of it.
    pub sent: Vec<fillrate_rave::ImageValue>,
}

// SAFETY: as above.
unsafe impl Send for LentPicture {}

/// The library and what is known of the program's objects, by address.
pub struct Session {
    /// The library itself.
    pub context: Context,
    recorder: Option<Recorder>,
    capture: Option<FrameLog>,
    exit_after: Option<u64>,
    frames: u64,
    /// RenderEnd does not wait for the frame.
    pub late_frames: bool,
    pub engines: Engines,
    pub contexts: HashMap<usize, Known>,
    pub foreign: HashMap<usize, Foreign>,
    pub lent: Vec<LentPicture>,
    /// Open accesses to textures and bitmaps.
    pub accesses: HashMap<(bool, u32), Staging>,
    pub draw_notices: BTreeMap<i32, DrawNotice>,
    pub last_draw_notice: i32,
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
        let mut config = RaveConfig { device: settings.glide.device, ..RaveConfig::default() };
        crate::settings::apply(&mut config);
        let capture = settings.capture.and_then(|folder| {
            let log = FrameLog::new(folder, settings.every);
            log.map_err(|error| eprintln!("fillrate: cannot capture frames: {error}")).ok()
        });
        let recorder = settings.trace.and_then(|file| {
            let pairs = config.description();
            let pairs = pairs.each_ref().map(|(key, value)| (*key, value.as_str()));
            let recorder = Recorder::new(&file, "rave", &pairs);
            recorder.map_err(|error| eprintln!("fillrate: cannot record: {error}")).ok()
        });
        if recorder.is_some() {
            // SAFETY: the function stays loaded as long as the process.
            unsafe { atexit(end_at_exit) };
        }
        let mut context = Context::new(config);
        let mut ask = |question| match context.gestalt(EngineId::BUILT_IN, question) {
            Ok(Answer::Number(number)) => number,
            _ => 0,
        };
        let identity = [selector::VENDOR_ID, selector::ENGINE_ID, selector::REVISION];
        let engines = Engines::new(identity.map(&mut ask), crate::settings::preferred_engine());
        Session {
            context,
            recorder,
            capture,
            exit_after: settings.exit_after,
            frames: 0,
            late_frames: crate::settings::late_frames(),
            engines,
            contexts: HashMap::new(),
            foreign: HashMap::new(),
            lent: Vec::new(),
            accesses: HashMap::new(),
            draw_notices: BTreeMap::new(),
            last_draw_notice: 0,
        }
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

    /// The number of a screen for a new context: the first that is free.
    pub fn new_screen(&self) -> usize {
        let is_taken = |n: &usize| {
            let mut shown = self.contexts.values().filter(|known| !known.is_cache);
            shown.any(|known| known.screen == *n)
        };
        (0..).find(|n| !is_taken(n)).unwrap_or(0)
    }

    /// Whether somebody besides the program looks at frames.
    pub fn is_watched(&self) -> bool {
        self.capture.is_some() || self.recorder.is_some() || self.exit_after.is_some()
    }

    /// Hands a frame of a context to whoever wants it. Ends the program where it
    /// was the last one.
    pub fn frame_shown(&mut self, number: u32, screen: usize) {
        if self.capture.is_some() || self.recorder.is_some() {
            self.note_frame(number, screen);
        }
        self.frames += 1;
        if self.exit_after.is_some_and(|limit| self.frames >= limit) {
            self.end();
            std::process::exit(0);
        }
    }

    fn note_frame(&mut self, number: u32, screen: usize) {
        let Some(frame) = self.context.shown_by(DrawContextId(number)).and_then(frame_of) else {
            return;
        };
        let counters = self.context.counters();
        let drawn = Drawn { triangles: counters.triangles_drawn, pixels: counters.pixels_in };
        if let Some(log) = &mut self.capture
            && let Err(error) = log.frame_of_screen(self.frames, screen, &frame, &frame, drawn)
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

    /// Ends the trace for good. Frames that nobody waited for are noted.
    fn end(&mut self) {
        let late = self.contexts.values_mut().filter(|known| known.has_late_frame);
        let late: Vec<_> = late
            .map(|known| {
                known.has_late_frame = false;
                (known.number, known.screen)
            })
            .collect();
        for (number, screen) in late {
            if self.is_watched() {
                self.note_frame(number, screen);
            }
        }
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

/// The number behind a pointer of the program; none of ours where it is too
/// large.
pub fn number_of(pointer: *const c_void) -> u32 {
    u32::try_from(pointer as usize).unwrap_or(u32::MAX)
}

/// A number as the program holds it.
pub fn as_pointer(number: u32) -> *mut c_void {
    number as usize as *mut c_void
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
