//! The one library of the process.

use std::collections::HashMap;
use std::sync::{LazyLock, Mutex, MutexGuard, PoisonError};

use fillrate_host::{Host, Settings, at_exit};
use fillrate_player::{Frame, Pixels};
use fillrate_quark::{Call, Context, Reply};
use fillrate_trace::Meta;

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
    /// Recording and capture.
    pub host: Host,
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
        let settings = Settings::from_environment();
        let program = std::env::args().next().unwrap_or_default();
        let meta = Meta::new()
            .with("api", "quark3d")
            .with("program", program)
            .with("creator", concat!("fillrate ", env!("CARGO_PKG_VERSION")));
        let host = Host::new(&settings, &meta);
        if host.is_recording() {
            at_exit(end_trace);
        }
        Session { context: Context::new(settings.device), host, ..Session::default() }
    }

    /// Records a call and carries it out.
    pub fn call(&mut self, call: &Call) -> Reply {
        self.host.record(call);
        self.context.execute(call)
    }

    /// Hands the frame just shown to whoever wants it.
    pub fn frame_shown(&mut self) {
        let frame = if self.host.wants_frames() { self.shown() } else { None };
        let counters = self.context.counters();
        self.host.frame_shown(frame.map(|frame| (frame, counters)));
    }

    fn shown(&mut self) -> Option<Frame> {
        let shown = self.context.shown()?;
        Frame::new(shown.width, shown.height, Pixels::Rgba8(shown.rgba8888())).ok()
    }
}

extern "C" fn end_trace() {
    // A program that exits inside a call holds the lock.
    if let Ok(mut session) = SESSION.try_lock() {
        session.host.end();
    }
}
