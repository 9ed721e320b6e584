//! Buffer groups of the lower layer.

use std::ffi::{c_int, c_long, c_void};

use fillrate_guard::{read, write};
use fillrate_redline::surface::PRIMARY;
use fillrate_redline::{BufferGroup, Call, Failure, Rect, Reply, Result, VError, VRoutine};

use crate::errors::{quiet, v, value};
use crate::handle::Opaque;
use crate::lock::Lock;
use crate::session::Session;

/// `v_rect`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct RawRect {
    left: c_long,
    top: c_long,
    right: c_long,
    bottom: c_long,
}

impl RawRect {
    fn rect(self) -> Rect {
        let side = |value: c_long| value.clamp(i32::MIN.into(), i32::MAX.into()) as i32;
        Rect {
            left: side(self.left),
            top: side(self.top),
            right: side(self.right),
            bottom: side(self.bottom),
        }
    }
}

impl Session {
    /// Makes a group and its handle.
    fn make_group(
        &mut self,
        device: Opaque,
        routine: VRoutine,
        call: impl FnOnce(u32) -> Call,
    ) -> Result<(Opaque, u32)> {
        let failed = |error| Failure::v(routine, error);
        let open = self.device(device).ok_or(failed(VError::ParamError))?;
        let Reply::Group(number, bytes) = self.call(&call(open))? else {
            return Err(failed(VError::Failed));
        };
        let handle = self.name_group(open, number).ok_or(failed(VError::AllocFailed))?;
        Ok((handle, bytes))
    }

    /// Runs a call on a group that belongs to the device.
    pub fn on_group(
        &mut self,
        device: Opaque,
        group: Opaque,
        routine: VRoutine,
        call: impl FnOnce(u32, u32) -> Call,
    ) -> Result<Reply> {
        let owner =
            self.group_number(group).filter(|(owner, _)| self.device(device) == Some(*owner));
        let (device, group) = owner.ok_or(Failure::v(routine, VError::ParamError))?;
        self.call(&call(device, group))
    }

    /// What is known of one of a group's buffers.
    fn buffer<T>(
        &self,
        group: Opaque,
        buffer: u32,
        routine: VRoutine,
        ask: impl FnOnce(&Session, &BufferGroup, (u32, u32)) -> Option<T>,
    ) -> Result<T> {
        let failed = |error| Failure::v(routine, error);
        let owner = self.group_number(group).ok_or(failed(VError::ParamError))?;
        let known = self.group(group).ok_or(failed(VError::ParamError))?;
        let answer = if buffer < known.count() { ask(self, known, owner) } else { None };
        answer.ok_or(failed(VError::InvalidBuffer))
    }
}

/// Makes buffers of one size in video memory.
///
/// # Safety
/// `group` and `memsize` are null or point to a handle and a number.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn V_CreateBufferGroup(
    device: Opaque,
    group: *mut Opaque,
    memsize: *mut u32,
    mask: u32,
    buffers: u32,
    format: u32,
    width: u32,
    height: u32,
) -> c_int {
    v(device, |session| {
        let routine = VRoutine::CreateBufferGroup;
        if group.is_null() {
            return Err(Failure::v(routine, VError::ParamError));
        }
        let (handle, bytes) = session.make_group(device, routine, |device| {
            Call::CreateBufferGroup { device, mask, buffers, format, width, height }
        })?;
        // SAFETY: the caller's promise.
        unsafe {
            write(group, handle);
            write(memsize, bytes);
        }
        Ok(())
    })
}

/// Makes buffers over video memory that exists.
///
/// # Safety
/// `group` and `memsize` are null or point to a handle and a number.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn V_PointBufferGroup(
    device: Opaque,
    group: *mut Opaque,
    memsize: *mut u32,
    mask: u32,
    buffers: u32,
    format: u32,
    width: u32,
    height: u32,
    address: u32,
) -> c_int {
    v(device, |session| {
        let routine = VRoutine::PointBufferGroup;
        if group.is_null() {
            return Err(Failure::v(routine, VError::ParamError));
        }
        let (handle, bytes) = session.make_group(device, routine, |device| {
            Call::PointBufferGroup { device, mask, buffers, format, width, height, address }
        })?;
        // SAFETY: the caller's promise.
        unsafe {
            write(group, handle);
            write(memsize, bytes);
        }
        Ok(())
    })
}

/// Gives buffers back.
#[unsafe(no_mangle)]
pub extern "C" fn V_DestroyBufferGroup(device: Opaque, group: Opaque) -> c_int {
    v(device, |session| {
        let call = |device, group| Call::DestroyBufferGroup { device, group };
        session.on_group(device, group, VRoutine::DestroyBufferGroup, call)?;
        session.forget_group(group);
        Ok(())
    })
}

/// Copies a part of a buffer to a part of another, stretched where sizes
/// differ. A copy of a whole buffer to the display shows where the program's
/// window is.
///
/// # Safety
/// Each rectangle is null, which is the whole buffer, or can be read.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn V_BltDisplayBuffer(
    device: Opaque,
    dst: Opaque,
    dst_buffer: u32,
    dst_rect: *const RawRect,
    src: Opaque,
    src_buffer: u32,
    src_rect: *const RawRect,
) -> c_int {
    v(device, |session| {
        let routine = VRoutine::BltDisplayBuffer;
        // SAFETY: the caller's promise.
        let (to, from) = unsafe { (read(dst_rect), read(src_rect)) };
        let (to, from) = (to.map(RawRect::rect), from.map(RawRect::rect));
        let source = session.group_number(src);
        let (_, src_group) = source.ok_or(Failure::v(routine, VError::ParamError))?;
        let shows =
            dst_buffer == 0 && session.group(dst).is_some_and(|group| group.mask & PRIMARY != 0);
        if shows && from.is_none() && to.is_some() {
            let call = |device, _| Call::SetWindow { device, window: to };
            session.on_group(device, dst, routine, call)?;
        }
        session.on_group(device, dst, routine, |device, dst_group| Call::BltDisplayBuffer {
            device,
            dst_group,
            dst_buffer,
            dst: to,
            src_group,
            src_buffer,
            src: from,
        })?;
        if shows {
            session.frame_shown();
        }
        Ok(())
    })
}

/// Copies pixels out of a buffer.
///
/// # Safety
/// `data` is null or has room for `height` rows of `linebytes` bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn V_ReadBuffer(
    device: Opaque,
    group: Opaque,
    buffer: u32,
    x: u32,
    y: u32,
    width: u32,
    height: u32,
    linebytes: u32,
    data: *mut u32,
) -> c_int {
    v(device, |session| {
        let failed = Failure::v(VRoutine::ReadBuffer, VError::ParamError);
        if data.is_null() {
            return Err(failed);
        }
        let pixels = session.on_group(device, group, VRoutine::ReadBuffer, |device, group| {
            Call::ReadBuffer { device, group, buffer, x, y, width, height }
        })?;
        let pixels = pixels.into_bytes();
        if pixels.is_empty() {
            return Ok(());
        }
        let row = pixels.len() / height as usize;
        if row > linebytes as usize {
            return Err(failed);
        }
        for (y, bytes) in pixels.chunks_exact(row).enumerate() {
            // SAFETY: the caller gives room for all rows, and a row is not
            // longer than was said.
            unsafe {
                let to = data.cast::<u8>().add(y * linebytes as usize);
                to.copy_from_nonoverlapping(bytes.as_ptr(), row);
            }
        }
        Ok(())
    })
}

/// The bytes of a buffer, once all that was issued is done; null on failure.
#[unsafe(no_mangle)]
pub extern "C" fn V_LockBuffer(device: Opaque, group: Opaque, buffer: u32) -> *mut c_void {
    value(device, std::ptr::null_mut(), |session| {
        let routine = VRoutine::LockBuffer;
        let call = |device, group| Call::LockBuffer { device, group, buffer };
        let bytes = session.on_group(device, group, routine, call)?.into_bytes();
        let (owner, address, room) =
            session.buffer(group, buffer, routine, |session, known, owner| {
                let (pitch, _) = session.context.buffer_pitch(owner.0, owner.1, buffer)?;
                Some((owner, known.address(buffer)?, pitch as usize * known.height as usize))
            })?;
        let known = session.locks.iter().position(|l| (l.owner, l.address) == (owner, address));
        let at = known.unwrap_or_else(|| {
            session.locks.push(Lock::new(owner, address));
            session.locks.len() - 1
        });
        Ok(session.locks[at].lock(room, || bytes).cast())
    })
}

/// Brings what was changed back.
#[unsafe(no_mangle)]
pub extern "C" fn V_UnlockBuffer(device: Opaque, group: Opaque, buffer: u32) -> c_int {
    v(device, |session| {
        let routine = VRoutine::UnlockBuffer;
        let (owner, address) = session.buffer(group, buffer, routine, |_, known, owner| {
            Some((owner, known.address(buffer)?))
        })?;
        let same = |l: &Lock| (l.owner, l.address) == (owner, address) && l.is_held();
        let at = session.locks.iter().position(same);
        let at = at.ok_or(Failure::v(routine, VError::InvalidBuffer))?;
        session.show_lock(at);
        let Some(changes) = session.locks[at].unlock() else { return Ok(()) };
        let call = |device, group| Call::UnlockBuffer { device, group, buffer, changes };
        session.on_group(device, group, routine, call).map(|_| ())
    })
}

/// The board address of a pointer into a locked buffer.
///
/// # Safety
/// `board_address` is null or points to a number.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn V_GetBoardAddress(
    device: Opaque,
    address: *const u32,
    board_address: *mut u32,
) -> c_int {
    v(device, |session| {
        let open = session.device(device);
        let mut mine = session.locks.iter().filter(|lock| Some(lock.owner.0) == open);
        let found = mine.find_map(|lock| lock.board_address(address.addr()));
        let found = found.ok_or(Failure::v(VRoutine::GetBufferAddress, VError::ParamError))?;
        // SAFETY: the caller's promise.
        unsafe { write(board_address, found) };
        Ok(())
    })
}

/// Whether a buffer's memory was taken away: 1 or 0.
#[unsafe(no_mangle)]
pub extern "C" fn V_IsBufferLost(device: Opaque, group: Opaque, buffer: u32) -> u32 {
    value(device, 1, |session| {
        session.buffer(group, buffer, VRoutine::IsBufferLost, |_, known, _| {
            Some(u32::from(known.lost))
        })
    })
}

/// Takes memory for a lost buffer again.
#[unsafe(no_mangle)]
pub extern "C" fn V_RestoreBuffer(device: Opaque, group: Opaque, buffer: u32) -> c_int {
    v(device, |session| {
        let call = |device, group| Call::RestoreBuffer { device, group, buffer };
        session.on_group(device, group, VRoutine::RestoreBuffer, call).map(|_| ())
    })
}

/// Bytes from one row to the next.
#[unsafe(no_mangle)]
pub extern "C" fn V_GetBufferLinebytes(group: Opaque, buffer: u32) -> u32 {
    value(std::ptr::null_mut(), 0, |session| {
        session.buffer(
            group,
            buffer,
            VRoutine::GetBufferLinebytes,
            |session, _, (device, group)| {
                Some(session.context.buffer_pitch(device, group, buffer)?.0)
            },
        )
    })
}

/// The code of the pitch.
#[unsafe(no_mangle)]
pub extern "C" fn V_GetBufferStride(group: Opaque, buffer: u32) -> u32 {
    value(std::ptr::null_mut(), 0, |session| {
        session.buffer(group, buffer, VRoutine::GetBufferStride, |session, _, (device, group)| {
            Some(session.context.buffer_pitch(device, group, buffer)?.1)
        })
    })
}

/// The board address of a buffer.
#[unsafe(no_mangle)]
pub extern "C" fn V_GetBufferAddress(group: Opaque, buffer: u32) -> u32 {
    value(std::ptr::null_mut(), 0, |session| {
        session
            .buffer(group, buffer, VRoutine::GetBufferAddress, |_, known, _| known.address(buffer))
    })
}

/// How many buffers a group has.
#[unsafe(no_mangle)]
pub extern "C" fn V_GetNumBuffers(group: Opaque) -> u32 {
    quiet(0, |session| session.group(group).map(BufferGroup::count))
}

/// The flags that a group was granted.
#[unsafe(no_mangle)]
pub extern "C" fn V_GetBufferMask(group: Opaque) -> u32 {
    quiet(0, |session| session.group(group).map(|group| group.mask))
}

/// Exchanges the numbers of two buffers.
#[unsafe(no_mangle)]
pub extern "C" fn V_SwapBuffers(group: Opaque, a: u32, b: u32) -> c_int {
    v(std::ptr::null_mut(), |session| {
        let owner = session.group_number(group);
        let failed = Failure::v(VRoutine::SwapBuffers, VError::ParamError);
        let (device, group) = owner.ok_or(failed)?;
        session.call(&Call::SwapBuffers { device, group, a, b }).map(|_| ())
    })
}

/// There are no drawing contexts of another system: fails.
#[unsafe(no_mangle)]
pub extern "C" fn V_GetBufferDC(_group: Opaque, _buffer: u32, _context: *mut Opaque) -> c_int {
    v(std::ptr::null_mut(), |_| Err(Failure::v(VRoutine::GetBufferDC, VError::CannotObtainDc)))
}

/// There are no drawing contexts of another system: fails.
#[unsafe(no_mangle)]
pub extern "C" fn V_ReleaseBufferDC(_group: Opaque, _buffer: u32, _context: Opaque) -> c_int {
    v(std::ptr::null_mut(), |_| Err(Failure::v(VRoutine::ReleaseBufferDC, VError::CannotObtainDc)))
}
