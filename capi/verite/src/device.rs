//! Opening, closing and asking devices; the display.

use std::ffi::{c_char, c_int, c_ulong};

use fillrate_guard::write;
use fillrate_redline::{Call, Failure, VError, VRoutine, VlError, VlRoutine};

use crate::errors::{quiet, v, value, vl};
use crate::handle::Opaque;
use crate::session::{Session, device_handle};

/// `v_verite_info`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct VeriteInfo {
    /// Vendor in the low half, device in the high one.
    pub verite_id: c_ulong,
    /// Address of registers.
    pub mem_mapped_io_base: c_ulong,
    /// Address of video memory.
    pub mem_base: c_ulong,
    /// Bytes of video memory.
    pub mem_size: c_ulong,
    /// Port of registers.
    pub io_base: u16,
    /// Whether it reads host memory.
    pub bus_master: u8,
    /// Whether it is the display.
    pub vga_device: u8,
}

/// Opens a board by number; the microcode's name is not used.
///
/// # Safety
/// `device` is null or points to a handle.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn V_CreateVerite(
    board: u32,
    _window: Opaque,
    device: *mut Opaque,
    _microcode: *mut c_char,
) -> c_int {
    v(std::ptr::null_mut(), |session| {
        if device.is_null() {
            return Err(Failure::v(VRoutine::CreateVerite, VError::ParamError));
        }
        let made = session.call(&Call::CreateVerite { board })?.number();
        session.devices.push(made);
        // SAFETY: the caller's promise.
        unsafe { write(device, device_handle(made)) };
        Ok(())
    })
}

/// Opens the first board.
///
/// # Safety
/// `device` is null or points to a handle.
#[unsafe(export_name = "redline_OpenVerite")]
pub unsafe extern "C" fn VL_OpenVerite(_window: Opaque, device: *mut Opaque) -> c_int {
    vl(std::ptr::null_mut(), |session| {
        if device.is_null() {
            return Err(Failure::vl(VlRoutine::OpenVerite, VlError::ParamError));
        }
        let made = session.call(&Call::OpenVerite {})?.number();
        session.devices.push(made);
        // SAFETY: the caller's promise.
        unsafe { write(device, device_handle(made)) };
        Ok(())
    })
}

/// Closes a device; its handles name nothing any more.
#[unsafe(no_mangle)]
pub extern "C" fn V_DestroyVerite(device: Opaque) -> c_int {
    v(device, |session| {
        let open = session.device(device);
        let open = open.ok_or(Failure::v(VRoutine::DestroyVerite, VError::ParamError))?;
        session.call(&Call::DestroyVerite { device: open })?;
        session.forget_device(open);
        Ok(())
    })
}

/// Closes a device.
#[unsafe(export_name = "redline_CloseVerite")]
pub extern "C" fn VL_CloseVerite(device: Opaque) -> c_int {
    vl(device, |session| {
        let open = session.device(device);
        let open = open.ok_or(Failure::vl(VlRoutine::CloseVerite, VlError::ParamError))?;
        session.call(&Call::CloseVerite { device: open })?;
        session.forget_device(open);
        Ok(())
    })
}

/// What a board is.
///
/// # Safety
/// `info` is null or has room.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn V_EnumVeriteBoards(
    _window: Opaque,
    board: u32,
    info: *mut VeriteInfo,
) -> c_int {
    v(std::ptr::null_mut(), |session| {
        let failed = |error| Failure::v(VRoutine::EnumVeriteBoards, error);
        if info.is_null() {
            return Err(failed(VError::ParamError));
        }
        let known = session.context.board_info(board);
        let known = known.ok_or(failed(VError::CannotGetBoardInfo))?;
        let told = VeriteInfo {
            verite_id: known.verite_id.into(),
            mem_mapped_io_base: known.mem_mapped_io_base.into(),
            mem_base: known.mem_base.into(),
            mem_size: known.mem_size.into(),
            io_base: known.io_base,
            bus_master: known.bus_master,
            vga_device: known.vga_device,
        };
        // SAFETY: the caller's promise.
        unsafe { write(info, told) };
        Ok(())
    })
}

/// Whether host memory is read by the board: 1.
#[unsafe(no_mangle)]
pub extern "C" fn V_GetUseDMA(device: Opaque) -> u32 {
    quiet(0, |session| session.device(device).map(|_| 1))
}

/// Keeps a number for the program.
#[unsafe(no_mangle)]
pub extern "C" fn V_SetUserPrivate(device: Opaque, value: u32) {
    quiet((), |session| {
        let device = session.device(device)?;
        session.call(&Call::SetUserPrivate { device, value: value.into() }).ok().map(|_| ())
    })
}

/// The number that was kept.
#[unsafe(no_mangle)]
pub extern "C" fn V_GetUserPrivate(device: Opaque) -> u32 {
    quiet(0, |session| {
        let device = session.device(device)?;
        Some(session.context.user_private(device)? as u32)
    })
}

/// The code of the smallest pitch that holds so many bytes, 0 where none does.
#[unsafe(no_mangle)]
pub extern "C" fn V_Stride(device: Opaque, linebytes: u32) -> u32 {
    value(device, 0, |session| {
        let failed = Failure::v(VRoutine::Stride, VError::ParamError);
        session.device(device).ok_or(failed)?;
        session.context.stride(linebytes).ok_or(failed)
    })
}

/// The pitch of a code, 0 for codes that are none.
#[unsafe(no_mangle)]
pub extern "C" fn V_Linebytes(device: Opaque, stride: u32) -> u32 {
    value(device, 0, |session| {
        let failed = Failure::v(VRoutine::Linebytes, VError::ParamError);
        session.device(device).ok_or(failed)?;
        Ok(session.context.linebytes(stride))
    })
}

impl Session {
    /// Runs a call of the lower layer on a device.
    fn on_device(
        &mut self,
        device: Opaque,
        routine: VRoutine,
        call: impl FnOnce(u32) -> Call,
    ) -> fillrate_redline::Result<()> {
        let open = self.device(device).ok_or(Failure::v(routine, VError::ParamError))?;
        self.call(&call(open)).map(|_| ())
    }
}

/// Which command ends a stream.
#[unsafe(no_mangle)]
pub extern "C" fn V_RegisterSyncCmd(device: Opaque, command: u32) -> c_int {
    v(device, |session| {
        let call = |device| Call::RegisterSyncCmd { device, command };
        session.on_device(device, VRoutine::CurrentRequest, call)
    })
}

/// Windowed or full screen.
#[unsafe(no_mangle)]
pub extern "C" fn V_SetDisplayType(device: Opaque, display_type: u32) -> c_int {
    v(device, |session| {
        let call = |device| Call::SetDisplayType { device, display_type };
        session.on_device(device, VRoutine::SetDisplayType, call)
    })
}

/// The display type, 0 for no device.
#[unsafe(no_mangle)]
pub extern "C" fn V_GetDisplayType(device: Opaque) -> u32 {
    quiet(0, |session| session.context.display_type(session.device(device)?))
}

/// The mode of the full screen.
#[unsafe(no_mangle)]
pub extern "C" fn V_SetDisplayMode(
    device: Opaque,
    width: u32,
    height: u32,
    bits: u32,
    refresh: u32,
) -> c_int {
    v(device, |session| {
        let refresh = refresh as i32;
        let call = |device| Call::SetDisplayMode { device, width, height, bits, refresh };
        session.on_device(device, VRoutine::SetDisplayMode, call)
    })
}

/// The pitch of what is shown.
#[unsafe(no_mangle)]
pub extern "C" fn V_SetDisplayLinebytes(device: Opaque, linebytes: u32) -> c_int {
    v(device, |session| {
        let call = |device| Call::SetDisplayLinebytes { device, linebytes };
        session.on_device(device, VRoutine::SetDisplayLinebytes, call)
    })
}
