//! Recording into the program's command buffer.

use std::ffi::c_int;
use std::sync::MutexGuard;

use fillrate_guard::{guard, read, write};
use fillrate_redline::command::Mark;
use fillrate_redline::{
    CommandSink, DmaBlock, Failure, Result, VError, VRoutine, VlError, VlRoutine,
};

use crate::errors::report;
use crate::handle::{Kind, Opaque, number};
use crate::session::{Buffer, Session, device_handle, session};

/// The buffer that a program's `v_cmdbuffer` variable names. When it is full,
/// the program's callback is asked for another, and the variable changes.
pub(crate) struct Sink {
    variable: *mut Opaque,
    slot: u32,
    /// What was in the buffer before the call.
    before: Mark,
    /// Held but while the callback runs.
    session: Option<MutexGuard<'static, Session>>,
}

impl Sink {
    /// The sink of a variable; `None` where that is null or holds no buffer.
    ///
    /// # Safety
    /// `variable` is null or points to a handle that stays there while the
    /// sink is used.
    pub unsafe fn open(variable: *mut Opaque) -> Option<Sink> {
        // SAFETY: the caller's promise.
        let handle = unsafe { read(variable) }?;
        let slot = number(Kind::CmdBuffer, handle)?;
        let session = session();
        let before = session.buffers.get(slot)?.commands.mark();
        Some(Sink { variable, slot, before, session: Some(session) })
    }

    /// The library.
    pub fn session(&mut self) -> &mut Session {
        self.session.get_or_insert_with(session)
    }

    /// The buffer; a callback may have destroyed it.
    #[inline]
    pub fn buffer(&mut self) -> Result<&mut Buffer, VError> {
        let slot = self.slot;
        self.session().buffers.get_mut(slot).ok_or(VError::ParamError)
    }

    /// The device of the buffer.
    pub fn device(&mut self) -> u32 {
        self.buffer().map_or(0, |buffer| buffer.device)
    }

    /// Takes back what the call has recorded in this buffer.
    fn rewind(&mut self) {
        let before = self.before;
        if let Ok(buffer) = self.buffer() {
            buffer.commands.rewind(before);
        }
    }

    /// Whether so much fits, or else what is lacking.
    #[inline]
    fn room(&mut self, words: usize, entries: usize) -> Result<(), VError> {
        let (free_words, free_entries) = self.buffer()?.commands.free_space();
        match () {
            () if words > free_words => Err(VError::CmdBufferTooSmall),
            () if entries > free_entries => Err(VError::CmdBufferNoDmaEntries),
            () => Ok(()),
        }
    }

    /// Asks the program for a buffer with room.
    #[cold]
    fn overflow(&mut self, words: usize, entries: usize, lacking: VError) -> Result<(), VError> {
        let Buffer { device, room, callback, .. } = *self.buffer()?;
        let callback = callback.filter(|_| words <= room.0 && entries <= room.1).ok_or(lacking)?;
        // SAFETY: it pointed to a handle when the sink was opened.
        let full = unsafe { read(self.variable) }.ok_or(VError::ParamError)?;
        self.session = None;
        // SAFETY: the program registered it to be called so.
        let next = unsafe { callback(device_handle(device), full) };
        // SAFETY: as above.
        unsafe { write(self.variable, next) };
        self.slot = number(Kind::CmdBuffer, next).ok_or(VError::ParamError)?;
        self.before = self.buffer()?.commands.mark();
        self.room(words, entries)
    }
}

impl CommandSink for Sink {
    #[inline]
    fn reserve(&mut self, words: usize, entries: usize) -> Result<&mut [u32], VError> {
        if let Err(lacking) = self.room(words, entries) {
            self.overflow(words, entries, lacking)?;
        }
        self.buffer()?.commands.reserve(words, entries)
    }

    fn add_dma(&mut self, block: DmaBlock) -> Result<(), VError> {
        let memories = &self.session().memories;
        let memory = u32::try_from(block.memory).ok().and_then(|number| memories.get(number));
        memory.filter(|memory| memory.holds(&block)).ok_or(VError::ParamError)?;
        self.buffer()?.commands.add_dma(block)
    }

    fn has_specular(&self) -> bool {
        self.session.as_ref().is_none_or(|session| session.context.has_specular())
    }
}

/// Runs a recording call of the upper layer.
///
/// # Safety
/// `variable` is null or points to a handle.
#[inline]
pub(crate) unsafe fn recorded(
    variable: *mut Opaque,
    routine: VlRoutine,
    body: impl FnOnce(&mut Sink) -> Result<()>,
) -> c_int {
    guard(VlError::Failed.number(), || {
        // SAFETY: the caller's promise.
        let Some(mut sink) = (unsafe { Sink::open(variable) }) else {
            let failure = Failure::vl(routine, VlError::ParamError);
            return report(std::ptr::null_mut(), &failure);
        };
        match body(&mut sink) {
            Ok(()) => VlError::Success.number(),
            Err(failure) => {
                let device = device_handle(sink.device());
                sink.rewind();
                drop(sink);
                report(device, &failure)
            }
        }
    })
}

/// Runs a recording call of the lower layer.
///
/// # Safety
/// `variable` is null or points to a handle.
pub(crate) unsafe fn appended<T: Copy>(
    variable: *mut Opaque,
    routine: VRoutine,
    body: impl FnOnce(&mut Sink) -> Result<T>,
) -> Result<T, c_int> {
    guard(Err(VError::Failed.number()), || {
        // SAFETY: the caller's promise.
        let Some(mut sink) = (unsafe { Sink::open(variable) }) else {
            let failure = Failure::v(routine, VError::ParamError);
            return Err(report(std::ptr::null_mut(), &failure));
        };
        body(&mut sink).map_err(|failure| {
            let device = device_handle(sink.device());
            sink.rewind();
            drop(sink);
            report(device, &failure)
        })
    })
}
