//! The one library of the process.

use std::collections::HashMap;
use std::ffi::CString;
use std::sync::{LazyLock, Mutex, MutexGuard, PoisonError};

use fillrate_capture::{Drawn, FrameLog, Recorder};
use fillrate_guard::guard;
use fillrate_player::{Frame, Pixels};
use fillrate_redline::command::stream_words;
use fillrate_redline::{
    BufferGroup, Call, CommandBuffer, Context, Failure, RedlineConfig, Reply, Result, Segment,
    Shown, VError, VRoutine, stream,
};
use fillrate_settings::Settings;
use fillrate_trace::meta::CONFIG_PREFIX;

use crate::commands::Callback;
use crate::errors::Errors;
use crate::handle::{Kind, Opaque, handle, number};
use crate::host_memory::Memories;
use crate::lock::Lock;
use crate::slots::Slots;
use crate::surface::Owned;

/// A command buffer of the program.
pub(crate) struct Buffer {
    /// The device it was made with.
    pub device: u32,
    /// What was recorded.
    pub commands: CommandBuffer,
    /// Words and DMA entries that an empty one has room for.
    pub room: (usize, usize),
    /// Whom to call when it is full.
    pub callback: Option<Callback>,
    /// Flips recorded by functions.
    pub flips: u32,
}

/// The library, and what is known of the program's objects.
pub(crate) struct Session {
    /// The library itself.
    pub context: Context,
    recorder: Option<Recorder>,
    capture: Option<FrameLog>,
    exit_after: Option<u64>,
    frames: u64,
    speed_of_light: bool,
    /// Handlers and the last errors.
    pub errors: Errors,
    /// Opened devices.
    pub devices: Vec<u32>,
    /// Device and number of each group.
    pub groups: Slots<(u32, u32)>,
    /// Surfaces by address.
    pub surfaces: HashMap<usize, Owned>,
    /// Command buffers.
    pub buffers: Slots<Buffer>,
    /// Memory objects.
    pub memories: Memories,
    /// Locked buffers.
    pub locks: Vec<Lock>,
    /// The names of extensions.
    pub extensions: CString,
}

static SESSION: LazyLock<Mutex<Session>> = LazyLock::new(|| Mutex::new(Session::new()));

/// The library of the process.
pub(crate) fn session() -> MutexGuard<'static, Session> {
    SESSION.lock().unwrap_or_else(PoisonError::into_inner)
}

fn recorder(file: &std::path::Path, config: &RedlineConfig) -> Option<Recorder> {
    let pairs = config.describe();
    let pairs: Vec<(String, &str)> = pairs
        .iter()
        .map(|(key, value)| (format!("{}{key}", CONFIG_PREFIX), value.as_str()))
        .collect();
    let pairs: Vec<(&str, &str)> = pairs.iter().map(|(key, value)| (&key[..], *value)).collect();
    let recorder = Recorder::new(file, "redline", &pairs);
    recorder.map_err(|error| eprintln!("fillrate: cannot record: {error}")).ok()
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
        let recorder = settings.trace.and_then(|file| recorder(&file, &settings.redline));
        if recorder.is_some() {
            // SAFETY: the function stays loaded as long as the process.
            unsafe { atexit(end_at_exit) };
        }
        let extensions = CString::new(settings.redline.chip.extensions()).unwrap_or_default();
        Session {
            context: Context::new(settings.redline),
            recorder,
            capture,
            exit_after: settings.exit_after,
            frames: 0,
            speed_of_light: settings.speed_of_light,
            errors: Errors::default(),
            devices: Vec::new(),
            groups: Slots::default(),
            surfaces: HashMap::new(),
            buffers: Slots::default(),
            memories: Memories::default(),
            locks: Vec::new(),
            extensions,
        }
    }

    /// Records a call and carries it out. What the program has stored in locked
    /// buffers is carried out before; what was drawn is shown in them after
    /// calls that wait for the board.
    pub fn call(&mut self, call: &Call) -> Result<Reply> {
        self.store_locked();
        let result = self.carry_out(call);
        match call {
            Call::IssueCmdBuffer { wait, .. } => {
                self.locks.iter_mut().for_each(|lock| lock.stale = true);
                if *wait {
                    self.show_locked();
                }
            }
            Call::UnlockBuffer { .. } | Call::BltDisplayBuffer { .. } => {
                self.locks.iter_mut().for_each(|lock| lock.stale = true);
                self.show_locked();
            }
            Call::LockBuffer { .. } | Call::ReadBuffer { .. } | Call::DestroyCmdBuffer { .. } => {
                self.show_locked();
            }
            _ => {}
        }
        result
    }

    /// Carries out what the program has stored in buffers that it holds.
    fn store_locked(&mut self) {
        for at in 0..self.locks.len() {
            if !self.locks[at].is_changed() {
                continue;
            }
            self.show_lock(at);
            let changes = self.locks[at].take_changes();
            let Some((device, group, buffer)) = self.locked_buffer(at) else { continue };
            // Stores to a buffer that is lost go nowhere.
            let _ = self.carry_out(&Call::StoreBuffer { device, group, buffer, changes });
            let others = self.locks.iter_mut().enumerate().filter(|(other, _)| *other != at);
            others.for_each(|(_, lock)| lock.stale = true);
        }
    }

    /// Shows in all buffers that the program holds what was drawn, once all
    /// that was issued is done.
    pub fn show_locked(&mut self) {
        (0..self.locks.len()).for_each(|at| self.show_lock(at));
    }

    /// Shows what was drawn in a buffer that the program holds.
    pub fn show_lock(&mut self, at: usize) {
        if !self.locks[at].is_held() || !self.locks[at].stale {
            return;
        }
        let Some((device, group, buffer)) = self.locked_buffer(at) else { return };
        if let Ok(bytes) = self.context.execute(&Call::LockBuffer { device, group, buffer }) {
            self.locks[at].show(&bytes.into_bytes());
        }
    }

    /// Device, group and present number of a locked buffer.
    fn locked_buffer(&self, at: usize) -> Option<(u32, u32, u32)> {
        let Lock { owner: (device, group), address, .. } = self.locks[at];
        let known = self.context.group(device, group)?;
        let buffer = known.addresses.iter().position(|&own| own == address)?;
        Some((device, group, buffer as u32))
    }

    fn carry_out(&mut self, call: &Call) -> Result<Reply> {
        if let Some(recorder) = &mut self.recorder
            && let Err(error) = recorder.record(call)
        {
            eprintln!("fillrate: recording stops: {error}");
            self.recorder = None;
        }
        self.context.execute(call)
    }

    /// The number of an open device.
    pub fn device(&self, device: Opaque) -> Option<u32> {
        number(Kind::Device, device).filter(|number| self.devices.contains(number))
    }

    /// Device and number of a group that exists.
    pub fn group_number(&self, group: Opaque) -> Option<(u32, u32)> {
        self.groups.get(number(Kind::Group, group)?).copied()
    }

    /// A group that exists.
    pub fn group(&self, group: Opaque) -> Option<&BufferGroup> {
        let (device, number) = self.group_number(group)?;
        self.context.group(device, number)
    }

    /// Gives a group a handle.
    pub fn name_group(&mut self, device: u32, group: u32) -> Option<Opaque> {
        Some(handle(Kind::Group, self.groups.insert((device, group))?))
    }

    /// Forgets a group's handle and what was locked of it.
    pub fn forget_group(&mut self, group: Opaque) {
        if let Some(owner) = number(Kind::Group, group).and_then(|slot| self.groups.remove(slot)) {
            self.locks.retain(|lock| lock.owner != owner);
        }
    }

    /// Forgets a device and all that was made with it but surfaces' members,
    /// which the program may still read.
    pub fn forget_device(&mut self, device: u32) {
        self.devices.retain(|&open| open != device);
        self.groups.remove_if(|owner| owner.0 == device);
        self.buffers.remove_if(|buffer| buffer.device == device);
        self.memories.remove_if(|memory| memory.device == device);
        self.locks.retain(|lock| lock.owner.0 != device);
    }

    /// Hands a command buffer's contents to the board.
    pub fn issue(&mut self, slot: u32, routine: VRoutine, wait: bool) -> Result<()> {
        let failed = |error| Failure::v(routine, error);
        let Session { buffers, memories, .. } = self;
        let buffer = buffers.get_mut(slot).ok_or(failed(VError::ParamError))?;
        let flips = std::mem::take(&mut buffer.flips);
        if self.speed_of_light {
            // An infinitely fast board: nothing is drawn.
            buffer.commands.reset();
            (0..flips).for_each(|_| self.count_frame());
            return Ok(());
        }
        let segments = buffer.commands.snapshot(memories);
        buffer.commands.reset();
        let to = (buffer.device, buffer.commands.id());
        let segments = segments.map_err(failed)?;
        let watched =
            self.capture.is_some() || self.recorder.is_some() || self.exit_after.is_some();
        if watched && let Some(parts) = self.in_frames(&segments) {
            // All are carried out, whatever becomes of one.
            let mut result = Ok(());
            for part in parts {
                result = result.and(self.issue_segments(to, vec![part], wait));
            }
            return result;
        }
        self.issue_segments(to, segments, wait)
    }

    /// Parts that show a frame each, of a valid stream that shows several.
    fn in_frames(&self, segments: &[Segment]) -> Option<Vec<Segment>> {
        let chip = self.context.config().chip;
        let words = stream_words(segments);
        let several = stream::switches(&words, chip).is_ok_and(|switches| switches > 1);
        several.then(|| stream::frames(&words, chip).into_iter().map(Segment::of).collect())
    }

    fn issue_segments(
        &mut self,
        (device, buffer): (u32, u32),
        segments: Vec<Segment>,
        wait: bool,
    ) -> Result<()> {
        let call = Call::IssueCmdBuffer { device, buffer, segments, wait };
        if self.call(&call)?.number() > 0 {
            self.frame_shown();
        }
        Ok(())
    }

    /// Hands the frame just shown to whoever wants it. Ends the program where
    /// it was the last one.
    pub fn frame_shown(&mut self) {
        if self.capture.is_some() || self.recorder.is_some() {
            self.note_frame();
        }
        self.count_frame();
    }

    fn count_frame(&mut self) {
        self.frames += 1;
        if self.exit_after.is_some_and(|limit| self.frames >= limit) {
            self.end();
            std::process::exit(0);
        }
    }

    fn note_frame(&mut self) {
        let Some(frame) = self.context.shown().and_then(frame_of) else { return };
        let counters = self.devices.last().and_then(|&device| self.context.counters(device));
        let drawn = counters.map_or_else(Drawn::default, |counters| Drawn {
            triangles: counters.triangles_drawn,
            pixels: counters.pixels_in,
        });
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

/// The handle of a device.
pub(crate) fn device_handle(device: u32) -> Opaque {
    handle(Kind::Device, device)
}

/// A shown frame in display colours.
fn frame_of(shown: Shown) -> Option<Frame> {
    Frame::new(shown.width, shown.height, Pixels::Rgb565(shown.pixels)).ok()
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
