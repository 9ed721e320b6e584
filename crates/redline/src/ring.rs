//! A ring of command buffers: the guide's way to record while the chip draws.
//!
//! Source: RR, command buffers, overflow callback.

use crate::call::{Call, Reply};
use crate::command::{CommandBuffer, CommandSink, DmaBlock, HostMemory};
use crate::context::Context;
use crate::error::{Result, VError};

/// Command buffers of one device that are filled in turn.
///
/// What does not fit the current buffer goes into the next one: the current one
/// is issued, and the next is waited for, as a program's overflow callback does.
#[derive(Debug)]
pub struct Ring<M> {
    /// The library that the buffers belong to.
    pub context: Context,
    /// The memory that DMA entries refer to.
    pub memory: M,
    device: u32,
    buffers: Vec<CommandBuffer>,
    current: usize,
}

impl<M: HostMemory> Ring<M> {
    /// `count` buffers, at least one, of so many DMA entries and words each.
    ///
    /// # Errors
    /// Those of `V_CreateCmdBuffer`.
    pub fn new(
        mut context: Context,
        device: u32,
        memory: M,
        count: usize,
        entries: usize,
        words: usize,
    ) -> Result<Ring<M>> {
        let size = |size: usize| i32::try_from(size).unwrap_or(-1);
        let create = Call::CreateCmdBuffer { device, entries: size(entries), words: size(words) };
        let mut buffers = Vec::new();
        for _ in 0..count.max(1) {
            let id = context.execute(&create)?.number();
            // The device has checked the sizes.
            buffers.extend(CommandBuffer::new(id, entries, words));
        }
        Ok(Ring { context, memory, device, buffers, current: 0 })
    }

    /// Issues what was recorded and goes on to the next buffer, once that is
    /// available. Replies how many times the display is switched.
    ///
    /// # Errors
    /// Those of `V_IssueCmdBufferAsync` and of the memory; what was recorded is
    /// lost.
    pub fn issue(&mut self) -> Result<u32> {
        let buffer = &mut self.buffers[self.current];
        let segments = buffer.snapshot(&self.memory);
        let id = buffer.id();
        buffer.reset();
        let failed = |error| crate::Failure::v(crate::VRoutine::IssueCmdBufferAsync, error);
        let segments = segments.map_err(failed)?;
        let call = Call::IssueCmdBuffer { device: self.device, buffer: id, segments, wait: false };
        let reply = self.context.execute(&call)?;
        self.current = (self.current + 1) % self.buffers.len();
        self.context.wait(self.device, self.buffers[self.current].id());
        Ok(match reply {
            Reply::Number(switches) => switches,
            _ => 0,
        })
    }
}

impl<M: HostMemory> CommandSink for Ring<M> {
    fn reserve(&mut self, words: usize, entries: usize) -> Result<&mut [u32], VError> {
        let (free, free_entries) = self.buffers[self.current].free_space();
        let empty = self.buffers[self.current].is_empty();
        if !empty && (words > free || entries > free_entries) {
            self.issue().map_err(|failure| match failure.last() {
                crate::Fault::V(_, error) => error,
                crate::Fault::Vl(..) => VError::Failed,
            })?;
        }
        self.buffers[self.current].reserve(words, entries)
    }

    fn add_dma(&mut self, block: DmaBlock) -> Result<(), VError> {
        self.buffers[self.current].add_dma(block)
    }
}
