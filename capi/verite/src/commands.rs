//! Command buffers of the lower layer.

use std::ffi::c_int;

use fillrate_guard::write;
use fillrate_redline::command::dma_entries;
use fillrate_redline::{
    Call, CommandBuffer, CommandSink, DmaBlock, Failure, Port, VError, VRoutine, add_to_dma_list,
};

use crate::errors::{quiet, state, v, value};
use crate::handle::{Kind, Opaque, handle, number};
use crate::host_memory::block;
use crate::session::{Buffer, device_handle};
use crate::sink::appended;

/// `v_cmdbuffer_callback`.
pub type Callback = unsafe extern "C" fn(Opaque, Opaque) -> Opaque;

/// Makes a command buffer of `dma_entries` entries and `words` words; null on
/// failure.
#[unsafe(no_mangle)]
pub extern "C" fn V_CreateCmdBuffer(device: Opaque, dma_entries: c_int, words: c_int) -> Opaque {
    let none = std::ptr::null_mut();
    value(device, none, |session| {
        let failed = |error| Failure::v(VRoutine::CreateCmdBuffer, error);
        let device = session.device(device).ok_or(failed(VError::ParamError))?;
        let call = Call::CreateCmdBuffer { device, entries: dma_entries, words };
        let id = session.call(&call)?.number();
        // The call has checked both.
        let room = (words.max(0) as usize, dma_entries.max(0) as usize);
        let commands = CommandBuffer::new(id, room.1, room.0).map_err(failed)?;
        let buffer = Buffer { device, commands, room, callback: None, flips: 0 };
        let slot = session.buffers.insert(buffer).ok_or(failed(VError::AllocFailed))?;
        Ok(handle(Kind::CmdBuffer, slot))
    })
}

/// Waits for what was issued, and gives the buffer back.
#[unsafe(no_mangle)]
pub extern "C" fn V_DestroyCmdBuffer(buffer: Opaque) -> c_int {
    v(std::ptr::null_mut(), |session| {
        let slot = number(Kind::CmdBuffer, buffer);
        let known = slot.and_then(|slot| session.buffers.remove(slot));
        let known = known.ok_or(Failure::v(VRoutine::DestroyCmdBuffer, VError::ParamError))?;
        let (device, buffer) = (known.device, known.commands.id());
        session.call(&Call::DestroyCmdBuffer { device, buffer }).map(|_| ())
    })
}

fn issue(device: Opaque, buffer: Opaque, routine: VRoutine, wait: bool) -> c_int {
    v(device, |session| {
        let number = number(Kind::CmdBuffer, buffer);
        let slot = number.filter(|_| session.device(device).is_some());
        let slot = slot.ok_or(Failure::v(routine, VError::ParamError))?;
        session.issue(slot, routine, wait)
    })
}

/// Hands the buffer to the board and waits until it is done.
#[unsafe(no_mangle)]
pub extern "C" fn V_IssueCmdBuffer(device: Opaque, buffer: Opaque) -> c_int {
    issue(device, buffer, VRoutine::IssueCmdBuffer, true)
}

/// Hands the buffer to the board.
#[unsafe(no_mangle)]
pub extern "C" fn V_IssueCmdBufferAsync(device: Opaque, buffer: Opaque) -> c_int {
    issue(device, buffer, VRoutine::IssueCmdBufferAsync, false)
}

/// `V_CMDBUFFER_INUSE` or `V_CMDBUFFER_AVAIL`; `V_VERITE_COMMAND_ERR` once for
/// a buffer that is done and lost commands. Recordings leave it out: it depends
/// on time and changes nothing.
#[unsafe(no_mangle)]
pub extern "C" fn V_QueryCmdBuffer(device: Opaque, buffer: Opaque) -> u32 {
    let failed = Failure::v(VRoutine::QueryCmdBuffer, VError::ParamError);
    state(device, |session| {
        let slot = number(Kind::CmdBuffer, buffer).ok_or(failed)?;
        let known = session.buffers.get(slot).ok_or(failed)?;
        let call = Call::QueryCmdBuffer { device: known.device, buffer: known.commands.id() };
        let in_use = session.context.execute(&call)?.number() != 0;
        if !in_use {
            session.show_locked();
        }
        Ok(if in_use { VError::CmdBufferInUse } else { VError::CmdBufferAvail })
    })
}

/// Drops what was recorded and not issued.
#[unsafe(no_mangle)]
pub extern "C" fn V_ResetCmdBuffer(buffer: Opaque) {
    quiet((), |session| {
        let buffer = session.buffers.get_mut(number(Kind::CmdBuffer, buffer)?)?;
        buffer.flips = 0;
        buffer.commands.reset();
        Some(())
    })
}

/// Sets whom to call when the buffer is full; null for nobody.
#[unsafe(no_mangle)]
pub extern "C" fn V_SetCmdBufferCallBack(buffer: Opaque, callback: Option<Callback>) {
    quiet((), |session| {
        session.buffers.get_mut(number(Kind::CmdBuffer, buffer)?)?.callback = callback;
        Some(())
    })
}

/// Who is called when the buffer is full, or null.
#[unsafe(no_mangle)]
pub extern "C" fn V_GetCmdBufferCallBack(buffer: Opaque) -> Option<Callback> {
    quiet(None, |session| Some(session.buffers.get(number(Kind::CmdBuffer, buffer)?)?.callback))
}

/// The device of a buffer, or null.
#[unsafe(no_mangle)]
pub extern "C" fn V_GetCmdBufferHandle(buffer: Opaque) -> Opaque {
    quiet(std::ptr::null_mut(), |session| {
        let buffer = session.buffers.get(number(Kind::CmdBuffer, buffer)?)?;
        Some(device_handle(buffer.device))
    })
}

/// Words and DMA entries that are free.
///
/// # Safety
/// Each pointer is null or points to a number.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn V_GetCmdBufferFreeSpace(
    buffer: Opaque,
    words: *mut u32,
    dma_entries: *mut u32,
) -> c_int {
    v(std::ptr::null_mut(), |session| {
        let known = number(Kind::CmdBuffer, buffer).and_then(|slot| session.buffers.get(slot));
        // The headers give the function no number of its own.
        let known = known.ok_or(Failure::v(VRoutine::QueryCmdBuffer, VError::ParamError))?;
        let (free_words, free_entries) = known.commands.free_space();
        // SAFETY: the caller's promise.
        unsafe {
            write(words, free_words as u32);
            write(dma_entries, free_entries as u32);
        }
        Ok(())
    })
}

/// DMA entries that a block of memory takes.
#[unsafe(no_mangle)]
pub extern "C" fn V_GetDMAEntries(memory: Opaque, address: *const u32, words: u32) -> u32 {
    quiet(0, |session| {
        let block = block(&session.memories, memory, address)?;
        Some(dma_entries(block.offset, words))
    })
}

/// Room for `words` words, which the program fills before it issues the buffer;
/// null on failure.
///
/// # Safety
/// `buffer` is null or points to a handle.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn V_AddToCmdList(buffer: *mut Opaque, words: u32) -> *mut u32 {
    let routine = VRoutine::AddToCmdList;
    // SAFETY: the caller's promise.
    let place = unsafe {
        appended(buffer, routine, |sink| {
            let words = sink.reserve(words as usize, 0);
            Ok(words.map_err(|error| Failure::v(routine, error))?.as_mut_ptr())
        })
    };
    place.unwrap_or(std::ptr::null_mut())
}

/// Room for words in a buffer that has room for `dma_entries` entries as well;
/// null on failure.
///
/// # Safety
/// `buffer` is null or points to a handle.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn V_AddToCmdAndDMAList(
    buffer: *mut Opaque,
    words: u32,
    dma_entries: u32,
) -> *mut u32 {
    let routine = VRoutine::AddToCmdAndDMAList;
    // SAFETY: the caller's promise.
    let place = unsafe {
        appended(buffer, routine, |sink| {
            let words = sink.reserve(words as usize, dma_entries as usize);
            Ok(words.map_err(|error| Failure::v(routine, error))?.as_mut_ptr())
        })
    };
    place.unwrap_or(std::ptr::null_mut())
}

/// Appends a block of host memory. Returns a code.
///
/// # Safety
/// `buffer` is null or points to a handle.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn V_AddToDMAList(
    buffer: *mut Opaque,
    port: u32,
    memory: Opaque,
    address: *const u32,
    words: u32,
) -> c_int {
    let failed = Failure::v(VRoutine::AddToDMAList, VError::ParamError);
    // SAFETY: the caller's promise.
    let code = unsafe {
        appended(buffer, VRoutine::AddToDMAList, |sink| {
            let port = Port::from_number(port).ok_or(failed)?;
            let from = block(&sink.session().memories, memory, address).ok_or(failed)?;
            let block = DmaBlock { port, words, ..from };
            add_to_dma_list(sink, block)
        })
    };
    code.map_or_else(|code| code, |()| VError::Success.number())
}
