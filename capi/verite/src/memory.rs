//! Memory objects of the lower layer.

use std::ffi::c_int;

use fillrate_redline::{Failure, VError, VRoutine};

use crate::errors::{quiet, v, value};
use crate::handle::{Kind, Opaque, handle, number};
use crate::host_memory::{Memory, known};

/// `V_PAGES_LOCKED`.
const LOCKED: u32 = 0x101;
/// `V_PAGES_UNLOCKED`.
const UNLOCKED: u32 = 0x102;

/// An object over the program's memory; null on failure. The memory must stay
/// until the object is freed or pointed elsewhere.
#[unsafe(no_mangle)]
pub extern "C" fn V_AllocMemoryObject(device: Opaque, address: *mut u32, bytes: u32) -> Opaque {
    value(device, std::ptr::null_mut(), |session| {
        let failed = |error| Failure::v(VRoutine::AllocMemoryObject, error);
        let open = session.device(device).ok_or(failed(VError::ParamError))?;
        if address.is_null() || !address.addr().is_multiple_of(4) {
            return Err(failed(VError::ParamError));
        }
        let memory = Memory::of(open, address.addr(), bytes);
        let slot = session.memories.insert(memory).ok_or(failed(VError::AllocFailed))?;
        Ok(handle(Kind::Memory, slot))
    })
}

/// Points an object to other memory of the program.
#[unsafe(no_mangle)]
pub extern "C" fn V_SetMemoryObject(memory: Opaque, address: *mut u32, bytes: u32) -> c_int {
    v(std::ptr::null_mut(), |session| {
        let number = number(Kind::Memory, memory);
        let known = number.and_then(|number| session.memories.get_mut(number));
        let known = known.filter(|memory| !memory.is_ours());
        let known = known.filter(|_| !address.is_null() && address.addr().is_multiple_of(4));
        let failed = Failure::v(VRoutine::AllocMemoryObject, VError::ParamError);
        known.ok_or(failed)?.point(address.addr(), bytes);
        Ok(())
    })
}

/// Where an object's bytes are, or null.
#[unsafe(no_mangle)]
pub extern "C" fn V_GetMemoryObjectAddress(memory: Opaque) -> *mut u32 {
    quiet(std::ptr::null_mut(), |session| {
        let memory = session.memories.get(number(Kind::Memory, memory)?)?;
        Some(std::ptr::with_exposed_provenance_mut(memory.address))
    })
}

/// How many bytes an object has.
#[unsafe(no_mangle)]
pub extern "C" fn V_GetMemoryObjectSize(memory: Opaque) -> u32 {
    quiet(0, |session| Some(session.memories.get(number(Kind::Memory, memory)?)?.bytes))
}

/// Whether an object's pages are locked.
#[unsafe(no_mangle)]
pub extern "C" fn V_GetMemoryObjectStatus(memory: Opaque) -> u32 {
    quiet(0, |session| {
        let memory = session.memories.get(number(Kind::Memory, memory)?)?;
        Some(if memory.locked { LOCKED } else { UNLOCKED })
    })
}

/// Frees an object, and its bytes where the library allocated them. Returns a
/// code, which programs that know it as a function without one never see.
#[unsafe(no_mangle)]
pub extern "C" fn V_FreeMemoryObject(device: Opaque, memory: Opaque) -> c_int {
    free(device, memory, VRoutine::FreeMemoryObject)
}

fn free(device: Opaque, memory: Opaque, routine: VRoutine) -> c_int {
    v(device, |session| {
        let number = known(&session.memories, memory);
        let number = number.filter(|_| session.device(device).is_some());
        let freed = number.and_then(|number| session.memories.remove(number));
        freed.map(drop).ok_or(Failure::v(routine, VError::ParamError))
    })
}

/// Locked memory, all zeros; null on failure.
#[unsafe(no_mangle)]
pub extern "C" fn V_AllocLockedMem(device: Opaque, bytes: u32) -> Opaque {
    value(device, std::ptr::null_mut(), |session| {
        let failed = |error| Failure::v(VRoutine::AllocLockedMem, error);
        let open = session.device(device).ok_or(failed(VError::ParamError))?;
        let memory = Memory::locked(open, bytes).ok_or(failed(VError::AllocFailed))?;
        let slot = session.memories.insert(memory).ok_or(failed(VError::AllocFailed))?;
        Ok(handle(Kind::Memory, slot))
    })
}

/// Frees locked memory.
#[unsafe(no_mangle)]
pub extern "C" fn V_FreeLockedMem(device: Opaque, memory: Opaque) -> c_int {
    free(device, memory, VRoutine::FreeLockedMem)
}

fn set_locked(device: Opaque, memory: Opaque, routine: VRoutine, locked: bool) -> c_int {
    v(device, |session| {
        let failed = Failure::v(routine, VError::ParamError);
        session.device(device).ok_or(failed)?;
        let number = number(Kind::Memory, memory).ok_or(failed)?;
        session.memories.get_mut(number).ok_or(failed)?.locked = locked;
        Ok(())
    })
}

/// Locks an object's pages.
#[unsafe(no_mangle)]
pub extern "C" fn V_LockPages(device: Opaque, memory: Opaque) -> c_int {
    set_locked(device, memory, VRoutine::LockPages, true)
}

/// Unlocks an object's pages.
#[unsafe(no_mangle)]
pub extern "C" fn V_UnlockPages(device: Opaque, memory: Opaque) -> c_int {
    set_locked(device, memory, VRoutine::UnlockPages, false)
}
