//! The devices of a program, and the calls on them.

use std::collections::BTreeMap;

use fillrate_engine::Counters;

use crate::board::MICROCODE_BYTES;
use crate::call::{Call, Reply};
use crate::config::RedlineConfig;
use crate::device::{Device, GroupRequest, Shown};
use crate::error::{Failure, Result, VError, VRoutine, VlError, VlRoutine};
use crate::surface::BufferGroup;

/// The most devices at a time.
pub const MAX_DEVICES: usize = 16;

/// What `V_EnumVeriteBoards` says of a board.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct BoardInfo {
    /// Vendor number in the low half, device number in the high one.
    pub verite_id: u32,
    /// Address of the board's registers.
    pub mem_mapped_io_base: u32,
    /// Address of video memory.
    pub mem_base: u32,
    /// Bytes of video memory.
    pub mem_size: u32,
    /// Port number of the board's registers.
    pub io_base: u16,
    /// Whether it reads host memory by itself.
    pub bus_master: u8,
    /// Whether it is the display.
    pub vga_device: u8,
}

/// An RRedline library without global state: devices by number.
///
/// Functions that read and change nothing are methods; everything else is a
/// [`Call`].
#[derive(Debug)]
pub struct Context {
    config: RedlineConfig,
    devices: BTreeMap<u32, Device>,
    made: u32,
    /// Commands lost by devices that are closed.
    lost: u64,
    /// The device that was opened or issued to last.
    current: Option<u32>,
    last_v: Option<(VRoutine, VError)>,
    last_vl: Option<(VlRoutine, VlError)>,
}

impl Context {
    /// A library without devices; opened ones are as `config` says.
    pub fn new(config: RedlineConfig) -> Context {
        Context {
            config,
            devices: BTreeMap::new(),
            made: 0,
            lost: 0,
            current: None,
            last_v: None,
            last_vl: None,
        }
    }

    /// How devices are opened.
    pub fn config(&self) -> &RedlineConfig {
        &self.config
    }

    /// Carries a call out.
    ///
    /// # Errors
    /// The failures of the documented function; the device stays usable.
    pub fn execute(&mut self, call: &Call) -> Result<Reply> {
        let result = self.carry_out(call);
        if let Err(failure) = &result {
            self.note(failure);
        }
        result
    }

    /// Remembers a failure for [`last_v_error`](Self::last_v_error) and
    /// [`last_vl_error`](Self::last_vl_error); recording functions do not.
    pub fn note(&mut self, failure: &Failure) {
        for fault in failure.faults() {
            match fault {
                crate::Fault::V(routine, error) => self.last_v = Some((routine, error)),
                crate::Fault::Vl(routine, error) => self.last_vl = Some((routine, error)),
            }
        }
    }

    /// The last failure in the lower layer (`V_GetLastError`).
    pub fn last_v_error(&self) -> Option<(VRoutine, VError)> {
        self.last_v
    }

    /// The last failure in the upper layer (`VL_GetLastError`).
    pub fn last_vl_error(&self) -> Option<(VlRoutine, VlError)> {
        self.last_vl
    }

    /// What a board is (`V_EnumVeriteBoards`). There is one, number 0 or 1.
    pub fn board_info(&self, board: u32) -> Option<BoardInfo> {
        let chip = self.config.chip;
        (board <= 1).then(|| BoardInfo {
            verite_id: chip.device_number() << 16 | crate::board::VENDOR,
            mem_mapped_io_base: 0xe000_0000,
            mem_base: 0xd000_0000,
            mem_size: self.config.memory_bytes(),
            io_base: 0x6000,
            bus_master: 1,
            vga_device: 1,
        })
    }

    /// Whether a device is open.
    pub fn is_open(&self, device: u32) -> bool {
        self.devices.contains_key(&device)
    }

    /// Whether command buffers are read by the board itself (`V_GetUseDMA`).
    pub fn uses_dma(&self, device: u32) -> bool {
        self.is_open(device)
    }

    /// Names of extensions, with spaces around each (`VL_GetExtensions`).
    pub fn extensions(&self, device: u32) -> Option<&'static str> {
        self.devices.get(&device).map(|device| device.config().chip.extensions())
    }

    /// Whether any device has the extension Specular, which decides what
    /// `VL_GetExtensionFunction` finds.
    pub fn has_specular(&self) -> bool {
        self.config.chip.has_specular()
    }

    /// A buffer group, for its addresses, pitch, size and mask.
    pub fn group(&self, device: u32, group: u32) -> Option<&BufferGroup> {
        self.devices.get(&device)?.group(group)
    }

    /// Pitch in bytes and stride code of a buffer (`V_GetBufferLinebytes`,
    /// `V_GetBufferStride`). The desktop's differ from those of its group.
    pub fn buffer_pitch(&self, device: u32, group: u32, buffer: u32) -> Option<(u32, u32)> {
        self.devices.get(&device)?.pitch(group, buffer)
    }

    /// `V_GetDisplayType`.
    pub fn display_type(&self, device: u32) -> Option<u32> {
        self.devices.get(&device).map(Device::display_type)
    }

    /// `V_GetUserPrivate`, all 64 bits of it.
    pub fn user_private(&self, device: u32) -> Option<u64> {
        self.devices.get(&device).map(|device| device.private)
    }

    /// The pitch of a stride code (`V_Linebytes`).
    pub fn linebytes(&self, code: u32) -> u32 {
        self.config.chip.linebytes(code)
    }

    /// The code of the smallest pitch that fits (`V_Stride`).
    pub fn stride(&self, linebytes: u32) -> Option<u32> {
        self.config.chip.stride(linebytes)
    }

    /// Bytes of video memory that are free, fragmented or not.
    pub fn free_memory(&self, device: u32) -> Option<u32> {
        self.devices.get(&device).map(Device::free_memory)
    }

    /// Bytes of video memory that no buffer may use.
    pub fn reserved_memory(&self) -> u32 {
        MICROCODE_BYTES
    }

    /// Waits until a command buffer is available.
    pub fn wait(&self, device: u32, buffer: u32) {
        if let Some(device) = self.devices.get(&device) {
            device.wait(buffer);
        }
    }

    /// What a device has drawn. Waits until all it was issued is drawn.
    pub fn counters(&self, device: u32) -> Option<Counters> {
        self.devices.get(&device).map(Device::counters)
    }

    /// How many commands were lost so far because something in the library broke
    /// off, which is a defect of it. Devices stay usable; standard error says
    /// which commands.
    pub fn lost_commands(&self) -> u64 {
        self.lost + self.devices.values().map(Device::lost).sum::<u64>()
    }

    /// What a device shows. Waits until all it was issued is drawn.
    pub fn shown_by(&self, device: u32) -> Option<Shown> {
        self.devices.get(&device).map(Device::shown)
    }

    /// What the device in use last shows.
    pub fn shown(&self) -> Option<Shown> {
        self.shown_by(self.current?)
    }

    fn open(&mut self, board: u32) -> Result<u32, VError> {
        if board > 1 {
            return Err(VError::CannotGetBoardInfo);
        }
        if self.devices.len() >= MAX_DEVICES {
            return Err(VError::AllocFailed);
        }
        let device = Device::new(&self.config)?;
        self.made += 1;
        self.devices.insert(self.made, device);
        self.current = Some(self.made);
        Ok(self.made)
    }

    fn close(&mut self, device: u32) -> Result<(), VError> {
        let closed = self.devices.remove(&device).ok_or(VError::ParamError)?;
        self.lost += closed.finish();
        Ok(())
    }

    fn device(&mut self, device: u32) -> Result<&mut Device, VError> {
        self.devices.get_mut(&device).ok_or(VError::ParamError)
    }

    fn carry_out(&mut self, call: &Call) -> Result<Reply> {
        let in_v = |routine| move |error| Failure::v(routine, error);
        match call {
            Call::CreateVerite { board } => {
                self.open(*board).map(Reply::Made).map_err(in_v(VRoutine::CreateVerite))
            }
            Call::DestroyVerite { device } => {
                self.close(*device).map(nothing).map_err(in_v(VRoutine::DestroyVerite))
            }
            Call::OpenVerite {} => self.open(1).map(Reply::Made).map_err(|error| {
                Failure::v(VRoutine::CreateVerite, error)
                    .then(VlRoutine::OpenVerite, VlError::OpenFailed)
            }),
            Call::CloseVerite { device } => self.close(*device).map(nothing).map_err(|error| {
                Failure::v(VRoutine::DestroyVerite, error)
                    .then(VlRoutine::CloseVerite, VlError::ParamError)
            }),
            other => self.on_device(other),
        }
    }

    fn on_device(&mut self, call: &Call) -> Result<Reply> {
        if let Some((request, device, routine)) = upper_request(call) {
            let made = self.create_group(device, &request);
            return made.map_err(|(lower, error)| {
                let upper = upper_error(error);
                Failure::v(lower, error).then(routine, upper)
            });
        }
        if let Some((request, device)) = lower_request(call) {
            let made = self.create_group(device, &request);
            return made.map_err(|(lower, error)| Failure::v(lower, error));
        }
        let (routine, result) = self.other(call);
        let upper = match call {
            Call::DestroySurface { .. } => Some(VlRoutine::DestroySurface),
            Call::RestoreSurface { .. } => Some(VlRoutine::RestoreSurface),
            _ => None,
        };
        result.map_err(|error| {
            let failure = Failure::v(routine, error);
            upper.map_or(failure, |upper| failure.then(upper, upper_error(error)))
        })
    }

    fn create_group(
        &mut self,
        device: u32,
        request: &GroupRequest,
    ) -> Result<Reply, (VRoutine, VError)> {
        let routine = match request.address {
            None => VRoutine::CreateBufferGroup,
            Some(_) => VRoutine::PointBufferGroup,
        };
        let made = self.device(device).and_then(|device| device.create_group(request));
        made.map(|(group, bytes)| Reply::Group(group, bytes)).map_err(|error| (routine, error))
    }

    /// Calls of the lower layer on a device, and the routine that fails.
    fn other(&mut self, call: &Call) -> (VRoutine, Result<Reply, VError>) {
        /// Runs something on a device.
        macro_rules! on {
            ($routine:ident, $device:expr, |$name:ident| $body:expr) => {
                (VRoutine::$routine, self.device(*$device).and_then(|$name| $body))
            };
        }
        match call {
            Call::SetUserPrivate { device, value } => on!(SetUserPrivate, device, |on| {
                on.private = *value;
                Ok(Reply::Nothing)
            }),
            Call::RegisterSyncCmd { device, command } => on!(CurrentRequest, device, |on| {
                on.sync_command = *command;
                Ok(Reply::Nothing)
            }),
            Call::SetDisplayType { device, display_type } => on!(SetDisplayType, device, |on| {
                on.set_display_type(*display_type).map(nothing)
            }),
            Call::SetDisplayMode { device, width, height, bits, .. } => {
                on!(SetDisplayMode, device, |on| {
                    on.set_display_mode(*width, *height, *bits).map(nothing)
                })
            }
            Call::SetDisplayLinebytes { device, linebytes } => {
                on!(SetDisplayLinebytes, device, |on| {
                    on.set_display_linebytes(*linebytes).map(nothing)
                })
            }
            Call::DestroyBufferGroup { device, group } | Call::DestroySurface { device, group } => {
                on!(DestroyBufferGroup, device, |on| on.destroy_group(*group).map(nothing))
            }
            Call::SwapBuffers { device, group, a, b } => {
                on!(SwapBuffers, device, |on| { on.swap_buffers(*group, *a, *b).map(nothing) })
            }
            Call::RestoreBuffer { device, group, buffer } => on!(RestoreBuffer, device, |on| {
                let known = on.group(*group).is_some_and(|group| *buffer < group.count());
                if !known {
                    return Err(VError::InvalidBuffer);
                }
                on.restore(*group).map(nothing)
            }),
            Call::RestoreSurface { device, group } => {
                on!(RestoreBufferGroup, device, |on| on.restore(*group).map(nothing))
            }
            Call::LockBuffer { device, group, buffer } => {
                on!(LockBuffer, device, |on| { on.lock(*group, *buffer).map(Reply::Bytes) })
            }
            Call::UnlockBuffer { device, group, buffer, changes } => {
                on!(UnlockBuffer, device, |on| on.unlock(*group, *buffer, changes).map(nothing))
            }
            Call::ReadBuffer { device, group, buffer, x, y, width, height } => {
                on!(ReadBuffer, device, |on| {
                    on.read(*group, *buffer, [*x, *y], [*width, *height]).map(Reply::Bytes)
                })
            }
            Call::BltDisplayBuffer {
                device,
                dst_group,
                dst_buffer,
                dst,
                src_group,
                src_buffer,
                src,
            } => on!(BltDisplayBuffer, device, |on| {
                let (to, from) = ((*dst_group, *dst_buffer, *dst), (*src_group, *src_buffer, *src));
                on.blit_display(to, from).map(nothing)
            }),
            Call::SetWindow { device, window } => on!(CurrentRequest, device, |on| {
                on.set_window(*window);
                Ok(Reply::Nothing)
            }),
            Call::StoreBuffer { device, group, buffer, changes } => {
                on!(CurrentRequest, device, |on| {
                    on.unlock(*group, *buffer, changes).map(nothing)
                })
            }
            Call::LoseBuffers { device } => on!(CurrentRequest, device, |on| {
                on.lose_buffers();
                Ok(Reply::Nothing)
            }),
            _ => self.on_command_buffer(call),
        }
    }

    fn on_command_buffer(&mut self, call: &Call) -> (VRoutine, Result<Reply, VError>) {
        match call {
            Call::CreateCmdBuffer { device, entries, words } => {
                let made = self.device(*device).and_then(|on| on.create_buffer(*entries, *words));
                (VRoutine::CreateCmdBuffer, made.map(Reply::Made))
            }
            Call::DestroyCmdBuffer { device, buffer } => {
                let done = self.device(*device).and_then(|on| on.destroy_buffer(*buffer));
                (VRoutine::DestroyCmdBuffer, done.map(nothing))
            }
            Call::IssueCmdBuffer { device, buffer, segments, wait } => {
                let issued = self.device(*device).and_then(|on| on.issue(*buffer, segments, *wait));
                if issued.is_ok() {
                    self.current = Some(*device);
                }
                let routine =
                    if *wait { VRoutine::IssueCmdBuffer } else { VRoutine::IssueCmdBufferAsync };
                (routine, issued.map(Reply::Number))
            }
            Call::QueryCmdBuffer { device, buffer } => {
                let used = self.device(*device).and_then(|on| on.is_in_use(*buffer));
                (VRoutine::QueryCmdBuffer, used.map(|used| Reply::Number(used.into())))
            }
            // Every other call was taken before.
            _ => (VRoutine::CurrentRequest, Err(VError::Failed)),
        }
    }
}

fn nothing((): ()) -> Reply {
    Reply::Nothing
}

/// What the upper layer says where the lower one failed.
fn upper_error(error: VError) -> VlError {
    match error {
        VError::ParamError | VError::SubSurfaceError | VError::InvalidBuffer => VlError::ParamError,
        VError::BadPixFmt => VlError::BadPixFmt,
        VError::OutOfVideoMemory => VlError::OutOfVideoMemory,
        VError::AllocFailed => VlError::AllocFailed,
        VError::FullScreenModeOnly => VlError::FullScreenModeOnly,
        _ => VlError::Failed,
    }
}

/// The group that a surface function makes.
fn upper_request(call: &Call) -> Option<(GroupRequest, u32, VlRoutine)> {
    let (device, mask, buffers, format, width, height, address, routine) = match *call {
        Call::CreateSurface { device, mask, buffers, format, width, height } => {
            (device, mask, buffers, format, width, height, None, VlRoutine::CreateSurface)
        }
        Call::PointSurface { device, mask, buffers, format, width, height, address } => {
            (device, mask, buffers, format, width, height, Some(address), VlRoutine::PointSurface)
        }
        _ => return None,
    };
    Some((GroupRequest { mask, buffers, format, width, height, address }, device, routine))
}

/// The group that a group function makes.
fn lower_request(call: &Call) -> Option<(GroupRequest, u32)> {
    let (device, mask, buffers, format, width, height, address) = match *call {
        Call::CreateBufferGroup { device, mask, buffers, format, width, height } => {
            (device, mask, buffers, format, width, height, None)
        }
        Call::PointBufferGroup { device, mask, buffers, format, width, height, address } => {
            (device, mask, buffers, format, width, height, Some(address))
        }
        _ => return None,
    };
    Some((GroupRequest { mask, buffers, format, width, height, address }, device))
}
