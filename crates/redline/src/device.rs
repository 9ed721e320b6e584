//! A board as a program holds it: groups, display modes, command buffers.
//!
//! What is here is the library's bookkeeping; pixels are the chip's.
//!
//! Source: RR, device and display, buffers and surfaces, windowed mode.

use std::collections::BTreeMap;

use fillrate_engine::Counters;

use crate::allocate::{Allocator, End};
use crate::board::MICROCODE_BYTES;
use crate::call::Rect;
use crate::chip::{Scanout, VeriteChip};
use crate::command::{Segment, stream_words};
use crate::config::RedlineConfig;
use crate::error::VError;
use crate::format::PixFmt;
use crate::opcode::Opcode;
use crate::surface::{BufferGroup, INTERLEAVED, MAX_BUFFERS, PRIMARY, Z_BUFFER};
use crate::worker::Worker;

/// `V_WINDOWED_APP`.
pub const WINDOWED: u32 = 1;
/// `V_FULLSCREEN_APP`.
pub const FULL_SCREEN: u32 = 2;
/// The most groups and command buffers of a device, each.
const MAX_OBJECTS: usize = 1 << 16;

/// The most rows of a buffer: the scissor has 16 bits.
const MAX_HEIGHT: u32 = 0xffff;

/// What a new group is to be.
#[derive(Clone, Copy, Debug)]
pub(crate) struct GroupRequest {
    pub mask: u32,
    pub buffers: u32,
    pub format: u32,
    pub width: u32,
    pub height: u32,
    /// Where it lies, for groups over memory that exists.
    pub address: Option<u32>,
}

/// A picture on the screen, or of a window.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Shown {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// 565, row by row.
    pub pixels: Vec<u16>,
}

/// The display in windowed mode.
#[derive(Clone, Copy, Debug)]
struct Desktop {
    width: u32,
    height: u32,
    linebytes: u32,
    stride: u32,
    address: u32,
}

impl Desktop {
    fn bytes(&self) -> u32 {
        self.linebytes * self.height
    }
}

/// One opened board.
#[derive(Debug)]
pub(crate) struct Device {
    config: RedlineConfig,
    worker: Worker,
    allocator: Allocator,
    desktop: Desktop,
    display_type: u32,
    mode: Option<(u32, u32)>,
    window: Option<Rect>,
    groups: BTreeMap<u32, BufferGroup>,
    primary: Option<u32>,
    /// Command buffers, and the number of their last issue.
    buffers: BTreeMap<u32, u64>,
    /// Numbers given out so far.
    made: u32,
    pub private: u64,
    pub sync_command: u32,
}

impl Device {
    /// Opens a board, in windowed mode.
    ///
    /// # Errors
    /// [`VError::Failed`] where the engine cannot start.
    pub fn new(config: &RedlineConfig) -> Result<Device, VError> {
        let chip = VeriteChip::new(config).map_err(|_| VError::Failed)?;
        let (width, height) = config.desktop_size();
        let stride = config.chip.stride(width * 2).ok_or(VError::Failed)?;
        let linebytes = config.chip.linebytes(stride);
        let mut device = Device {
            config: config.clone(),
            worker: Worker::new(chip, config.background),
            allocator: Allocator::new(MICROCODE_BYTES, config.memory_bytes()),
            desktop: Desktop { width, height, linebytes, stride, address: MICROCODE_BYTES },
            display_type: WINDOWED,
            mode: None,
            window: None,
            groups: BTreeMap::new(),
            primary: None,
            buffers: BTreeMap::new(),
            made: 0,
            private: 0,
            sync_command: Opcode::SyncAndRespond as u32,
        };
        device.take_desktop();
        Ok(device)
    }

    /// How it was opened.
    pub fn config(&self) -> &RedlineConfig {
        &self.config
    }

    /// The display type.
    pub fn display_type(&self) -> u32 {
        self.display_type
    }

    /// Bytes of video memory that are free.
    pub fn free_memory(&self) -> u32 {
        self.allocator.free_bytes()
    }

    /// A group.
    pub fn group(&self, group: u32) -> Option<&BufferGroup> {
        self.groups.get(&group)
    }

    fn number(&mut self) -> u32 {
        self.made += 1;
        self.made
    }

    // Display.

    /// Gives the desktop its memory; groups that lie in it are lost.
    fn take_desktop(&mut self) {
        let (from, size) = (self.desktop.address, self.desktop.bytes());
        let overlaps = |&(at, bytes): &(u32, u32)| at < from + size && at + bytes > from;
        for group in self.groups.values_mut() {
            if let Some((at, bytes)) = group.owned.filter(overlaps) {
                self.allocator.release(at, bytes);
                (group.owned, group.lost) = (None, true);
            }
        }
        self.allocator.reserve(from, size);
        self.show(Scanout { base: from, odd: None, linebytes: self.desktop.linebytes });
    }

    fn show(&self, scanout: Scanout) {
        // Nothing in there can break off.
        let _ = self.worker.with(|chip| chip.scanout = scanout);
    }

    /// `V_SetDisplayType`.
    pub fn set_display_type(&mut self, display_type: u32) -> Result<(), VError> {
        if !matches!(display_type, WINDOWED | FULL_SCREEN) {
            return Err(VError::ParamError);
        }
        if display_type == self.display_type {
            return Ok(());
        }
        self.display_type = display_type;
        // A display surface of the other kind is of no use any more.
        if let Some(primary) = self.primary.and_then(|group| self.groups.get_mut(&group)) {
            primary.lost = true;
            if let Some((at, bytes)) = primary.owned.take() {
                self.allocator.release(at, bytes);
            }
        }
        if display_type == WINDOWED {
            self.mode = None;
            self.take_desktop();
        } else {
            self.allocator.release(self.desktop.address, self.desktop.bytes());
        }
        Ok(())
    }

    /// `V_SetDisplayMode`.
    pub fn set_display_mode(&mut self, width: u32, height: u32, bits: u32) -> Result<(), VError> {
        if self.display_type != FULL_SCREEN {
            return Err(VError::FullScreenModeOnly);
        }
        let fits = (1..=self.config.chip.max_pitch() / 2).contains(&width)
            && (1..=MAX_HEIGHT).contains(&height);
        if !fits || bits != 16 {
            return Err(VError::DdSetDisplayMode);
        }
        self.mode = Some((width, height));
        Ok(())
    }

    /// `V_SetDisplayLinebytes`.
    pub fn set_display_linebytes(&mut self, linebytes: u32) -> Result<(), VError> {
        if linebytes == 0
            || linebytes > self.config.chip.max_pitch()
            || !linebytes.is_multiple_of(4)
        {
            return Err(VError::ParamError);
        }
        self.worker.with(|chip| chip.scanout.linebytes = linebytes)
    }

    /// Where the window is on the desktop.
    pub fn set_window(&mut self, window: Option<Rect>) {
        self.window = window;
    }

    /// The visible part of the desktop: the window, or as much of the desktop
    /// as the primary surface has pixels.
    fn window(&self) -> Rect {
        let (width, height) = (self.desktop.width as i32, self.desktop.height as i32);
        let primary = self.primary.and_then(|group| self.groups.get(&group));
        let whole =
            primary.map_or((width, height), |group| (group.width as i32, group.height as i32));
        let window =
            self.window.unwrap_or(Rect { right: whole.0, bottom: whole.1, ..Rect::default() });
        Rect {
            left: window.left.clamp(0, width),
            top: window.top.clamp(0, height),
            right: window.right.clamp(0, width),
            bottom: window.bottom.clamp(0, height),
        }
    }

    /// What is on the screen, or in the window.
    pub fn shown(&self) -> Shown {
        self.worker.with(|chip| self.shown_by(chip)).unwrap_or_default()
    }

    fn shown_by(&self, chip: &mut VeriteChip) -> Shown {
        let scanout = chip.scanout;
        let (origin, width, height) = if self.display_type == WINDOWED {
            let window = self.window();
            let size = |from: i32, to: i32| (to - from).max(0) as u32;
            let origin = window.top as u32 * scanout.linebytes + window.left as u32 * 2;
            (origin, size(window.left, window.right), size(window.top, window.bottom))
        } else {
            let primary = self.primary.and_then(|group| self.groups.get(&group));
            let size = primary.map(|group| (group.width, group.height)).or(self.mode);
            let (width, height) = size.unwrap_or_default();
            (0, width, height)
        };
        let base = scanout.base.saturating_add(origin);
        let mut bytes = chip.read_rows(base, scanout.linebytes, width * 2, height);
        if let Some(odd) = scanout.odd.filter(|_| width > 0) {
            let other =
                chip.read_rows(odd.saturating_add(origin), scanout.linebytes, width * 2, height);
            let row = width as usize * 2;
            let rows = bytes.chunks_exact_mut(row).zip(other.chunks_exact(row));
            rows.skip(1).step_by(2).for_each(|(to, from)| to.copy_from_slice(from));
        }
        let pixels = bytes.as_chunks().0.iter().map(|&two| u16::from_le_bytes(two)).collect();
        Shown { width, height, pixels }
    }

    /// What the chip has drawn.
    pub fn counters(&self) -> Counters {
        self.worker.with(VeriteChip::counters).unwrap_or_default()
    }

    /// Waits for the chip for the last time: how often it broke off.
    pub fn finish(&self) -> u64 {
        self.worker.finish();
        self.lost()
    }

    /// How often the chip broke off.
    pub fn lost(&self) -> u64 {
        self.worker.lost()
    }

    // Buffer groups.

    /// Checks a request and works out the pitch and what is granted.
    fn plan(&self, request: &GroupRequest) -> Result<BufferGroup, VError> {
        let GroupRequest { mask, buffers, width, height, .. } = *request;
        let chip = self.config.chip;
        let sized = width > 0 && height > 0 && height <= MAX_HEIGHT && width <= chip.max_pitch();
        if !(1..=MAX_BUFFERS).contains(&buffers) || mask > 7 || !sized {
            return Err(VError::ParamError);
        }
        let format = PixFmt::from_code(request.format).ok_or(VError::BadPixFmt)?;
        if mask & PRIMARY != 0 && format != PixFmt::Rgb565 {
            return Err(VError::BadPixFmt);
        }
        if mask & Z_BUFFER != 0 && format.bits() != 16 {
            return Err(VError::BadPixFmt);
        }
        self.check_size(request)?;
        let row = (format.row_bytes(width) as u32).next_multiple_of(4);
        let stride = chip.stride(row).ok_or(VError::ParamError)?;
        Ok(BufferGroup {
            width,
            height,
            format,
            mask: mask & !INTERLEAVED,
            linebytes: chip.linebytes(stride),
            stride,
            addresses: Vec::new(),
            bytes: 0,
            lost: false,
            owned: None,
            on_desktop: false,
        })
    }

    /// Primary surfaces have the size of the display, others are no wider.
    fn check_size(&self, request: &GroupRequest) -> Result<(), VError> {
        let (width, height) = (request.width, request.height);
        let fits = if request.mask & PRIMARY != 0 {
            let one = self.primary.is_none();
            one && match (self.display_type, self.mode) {
                (FULL_SCREEN, Some(mode)) => mode == (width, height),
                (FULL_SCREEN, None) => true,
                _ => width <= self.desktop.width && height <= self.desktop.height,
            }
        } else {
            let primary = self.primary.and_then(|group| self.groups.get(&group));
            primary.is_none_or(|primary| width <= primary.width)
        };
        if fits { Ok(()) } else { Err(VError::ParamError) }
    }

    /// Places a planned group's buffers.
    fn place(&mut self, group: &mut BufferGroup, request: &GroupRequest) -> Result<(), VError> {
        let primary = request.mask & PRIMARY != 0;
        group.on_desktop = primary && self.display_type == WINDOWED && request.address.is_none();
        if group.on_desktop {
            // All buffers share the desktop's pitch where the front buffer is
            // the desktop; the others have their own.
            return self.place_on_desktop(group, request);
        }
        if self.interleave(group, request)? {
            return Ok(());
        }
        let size = group.linebytes.checked_mul(group.height).ok_or(VError::OutOfVideoMemory)?;
        let bytes = size.checked_mul(request.buffers).ok_or(VError::OutOfVideoMemory)?;
        let base = self.take(group, bytes, request)?;
        group.addresses = (0..request.buffers).map(|i| base + i * size).collect();
        Ok(())
    }

    /// Takes memory for a group, or checks the memory that it is to lie in.
    fn take(
        &mut self,
        group: &mut BufferGroup,
        bytes: u32,
        request: &GroupRequest,
    ) -> Result<u32, VError> {
        if let Some(address) = request.address {
            let end = address.checked_add(bytes);
            let inside = end.is_some_and(|end| end <= self.config.memory_bytes());
            return if inside && address % 4 == 0 {
                Ok(address)
            } else {
                Err(VError::SubSurfaceError)
            };
        }
        let end = if request.mask & PRIMARY != 0 { End::Low } else { End::High };
        let base = self.allocator.allocate(bytes, end).ok_or(VError::OutOfVideoMemory)?;
        (group.owned, group.bytes) = (Some((base, bytes)), bytes);
        Ok(base)
    }

    /// Buffer 0 is the desktop; the others are in memory of their own.
    fn place_on_desktop(
        &mut self,
        group: &mut BufferGroup,
        request: &GroupRequest,
    ) -> Result<(), VError> {
        let size = group.linebytes * group.height;
        let mut addresses = vec![self.desktop.address];
        if request.buffers > 1 {
            let bytes = size.checked_mul(request.buffers - 1).ok_or(VError::OutOfVideoMemory)?;
            let base = self.take(group, bytes, request)?;
            addresses.extend((0..request.buffers - 1).map(|i| base + i * size));
        }
        group.addresses = addresses;
        Ok(())
    }

    /// Lays rows of all buffers side by side, where that was asked for, the
    /// mode allows it, and they fit a page of memory.
    fn interleave(
        &mut self,
        group: &mut BufferGroup,
        request: &GroupRequest,
    ) -> Result<bool, VError> {
        let wanted = INTERLEAVED | PRIMARY;
        if request.mask & wanted != wanted || self.display_type != FULL_SCREEN {
            return Ok(false);
        }
        let row = (group.format.row_bytes(group.width) as u32).next_multiple_of(4);
        let chip = self.config.chip;
        let all = row.saturating_mul(request.buffers);
        let pitch = [2048, 4096].into_iter().find(|&pitch| all <= pitch);
        let Some((pitch, stride)) = pitch.and_then(|pitch| Some((pitch, chip.stride(pitch)?)))
        else {
            return Ok(false);
        };
        let bytes = pitch.checked_mul(group.height).ok_or(VError::OutOfVideoMemory)?;
        let base = self.take(group, bytes, request)?;
        (group.linebytes, group.stride) = (pitch, stride);
        group.mask |= INTERLEAVED;
        group.addresses = (0..request.buffers).map(|i| base + i * row).collect();
        Ok(true)
    }

    /// `V_CreateBufferGroup`, `V_PointBufferGroup`: the group and its bytes.
    pub fn create_group(&mut self, request: &GroupRequest) -> Result<(u32, u32), VError> {
        let mut group = self.plan(request)?;
        if self.groups.len() >= MAX_OBJECTS {
            return Err(VError::AllocFailed);
        }
        self.place(&mut group, request)?;
        let number = self.number();
        let bytes = group.bytes;
        if group.mask & PRIMARY != 0 {
            self.primary = Some(number);
            self.show_front(&group);
        }
        self.groups.insert(number, group);
        Ok((number, bytes))
    }

    fn show_front(&self, group: &BufferGroup) {
        if !group.on_desktop {
            let base = group.addresses.first().copied().unwrap_or(0);
            self.show(Scanout { base, odd: None, linebytes: group.linebytes });
        }
    }

    /// `V_DestroyBufferGroup`: waits until nothing draws there any more.
    pub fn destroy_group(&mut self, number: u32) -> Result<(), VError> {
        let group = self.groups.remove(&number).ok_or(VError::ParamError)?;
        self.worker.finish();
        if let Some((at, bytes)) = group.owned {
            self.allocator.release(at, bytes);
        }
        if self.primary == Some(number) {
            self.primary = None;
        }
        Ok(())
    }

    /// `V_SwapBuffers`.
    pub fn swap_buffers(&mut self, group: u32, a: u32, b: u32) -> Result<(), VError> {
        let group = self.groups.get_mut(&group).ok_or(VError::ParamError)?;
        if a >= group.count() || b >= group.count() {
            return Err(VError::InvalidBuffer);
        }
        if group.on_desktop && a != b && a.min(b) == 0 {
            return Err(VError::CannotSwapWindowedSurfaces);
        }
        group.addresses.swap(a as usize, b as usize);
        Ok(())
    }

    /// All buffers are lost; their memory is free.
    pub fn lose_buffers(&mut self) {
        self.worker.finish();
        for group in self.groups.values_mut() {
            group.lost = true;
            if let Some((at, bytes)) = group.owned.take() {
                self.allocator.release(at, bytes);
            }
        }
    }

    /// `V_RestoreBuffer`: memory for a lost group. Its contents are undefined.
    pub fn restore(&mut self, number: u32) -> Result<(), VError> {
        let group = self.groups.get(&number).ok_or(VError::ParamError)?;
        if !group.lost {
            return Ok(());
        }
        let mut group = group.clone();
        let pointed = group.bytes == 0 && !group.on_desktop && group.mask & PRIMARY == 0;
        if pointed {
            // It lies over somebody else's memory, which is where it was.
            group.lost = false;
        } else {
            let request = GroupRequest {
                mask: group.mask,
                buffers: group.count(),
                format: group.format.code(),
                width: group.width,
                height: group.height,
                address: None,
            };
            self.place(&mut group, &request)?;
            group.lost = false;
            if group.mask & PRIMARY != 0 {
                self.show_front(&group);
            }
        }
        self.groups.insert(number, group);
        Ok(())
    }

    /// A buffer that is there: its group, its address and pitch.
    fn buffer(&self, group: u32, buffer: u32) -> Result<(&BufferGroup, u32, u32), VError> {
        let group = self.groups.get(&group).ok_or(VError::ParamError)?;
        let address = group.address(buffer).ok_or(VError::InvalidBuffer)?;
        if group.lost {
            return Err(VError::DdIsLost);
        }
        let pitch =
            if group.on_desktop && buffer == 0 { self.desktop.linebytes } else { group.linebytes };
        Ok((group, address, pitch))
    }

    /// Pitch and stride code of a buffer: the desktop has its own.
    pub fn pitch(&self, group: u32, buffer: u32) -> Option<(u32, u32)> {
        let group = self.groups.get(&group).filter(|group| buffer < group.count())?;
        let desktop = group.on_desktop && buffer == 0;
        let own = (group.linebytes, group.stride);
        Some(if desktop { (self.desktop.linebytes, self.desktop.stride) } else { own })
    }

    /// `V_LockBuffer`: the buffer's bytes at its pitch.
    pub fn lock(&self, group: u32, buffer: u32) -> Result<Vec<u8>, VError> {
        let (group, address, pitch) = self.buffer(group, buffer)?;
        let size = pitch * (group.height - 1) + row_bytes(group, buffer);
        self.worker.with(|chip| chip.read_rows(address, 0, size, 1))
    }

    /// `V_UnlockBuffer`: brings changed bytes back.
    pub fn unlock(&self, group: u32, buffer: u32, changes: &[u8]) -> Result<(), VError> {
        let (group, address, pitch) = self.buffer(group, buffer)?;
        let size = (pitch * (group.height - 1) + row_bytes(group, buffer)) as usize;
        self.worker.with(|chip| {
            for (offset, bytes) in crate::lock::runs(changes) {
                let Some(room) = size.checked_sub(offset) else { continue };
                let count = room.min(bytes.len());
                chip.write_bytes(address + offset as u32, &bytes[..count]);
            }
        })
    }

    /// `V_ReadBuffer`: rows of pixels without padding.
    pub fn read(
        &self,
        group: u32,
        buffer: u32,
        at: [u32; 2],
        size: [u32; 2],
    ) -> Result<Vec<u8>, VError> {
        let (group, address, pitch) = self.buffer(group, buffer)?;
        let fits =
            |at: u32, size: u32, side: u32| at.checked_add(size).is_some_and(|end| end <= side);
        if !fits(at[0], size[0], group.width) || !fits(at[1], size[1], group.height) {
            return Err(VError::ParamError);
        }
        let format = group.buffer_format(buffer);
        if format.bits() == 4 && !at[0].is_multiple_of(2) {
            return Err(VError::ParamError);
        }
        let row = format.row_bytes(size[0]) as u32;
        let from = address + at[1] * pitch + format.row_bytes(at[0]) as u32;
        self.worker.with(|chip| chip.read_rows(from, pitch, row, size[1]))
    }

    /// `V_BltDisplayBuffer`: clips to the window, stretches to the nearest
    /// pixel.
    pub fn blit_display(
        &self,
        (dst_group, dst_buffer, dst): (u32, u32, Option<Rect>),
        (src_group, src_buffer, src): (u32, u32, Option<Rect>),
    ) -> Result<(), VError> {
        let (to, to_address, to_pitch) = self.buffer(dst_group, dst_buffer)?;
        let (from, from_address, from_pitch) = self.buffer(src_group, src_buffer)?;
        if to.format != from.format || to.format.bits() < 8 {
            return Err(VError::DdBlt);
        }
        let whole = |group: &BufferGroup| Rect {
            right: group.width as i32,
            bottom: group.height as i32,
            ..Rect::default()
        };
        let on_desktop = to.on_desktop && dst_buffer == 0;
        let visible = if on_desktop { self.window() } else { whole(to) };
        let (dst, src) = (dst.unwrap_or(whole(to)), src.unwrap_or(whole(from)));
        let stretch = Stretch::new(dst, src, visible, whole(from)).ok_or(VError::ParamError)?;
        let bytes = to.format.bytes();
        let row = row_bytes(from, src_buffer);
        let copy = |chip: &mut VeriteChip| {
            let pixels = chip.read_rows(from_address, from_pitch, row, from.height);
            let mut line = Vec::new();
            for y in stretch.rows.clone() {
                let source = (stretch.row(y) * row) as usize;
                line.clear();
                for x in stretch.columns.clone() {
                    let at = source + (stretch.column(x) * bytes) as usize;
                    line.extend_from_slice(&pixels[at..at + bytes as usize]);
                }
                let left = *stretch.columns.start() as u32;
                chip.write_bytes(to_address + y as u32 * to_pitch + left * bytes, &line);
            }
        };
        self.worker.with(copy)
    }

    // Command buffers.

    /// `V_CreateCmdBuffer`.
    pub fn create_buffer(&mut self, entries: i32, words: i32) -> Result<u32, VError> {
        let within =
            |count: i32, most: usize| usize::try_from(count).is_ok_and(|count| count <= most);
        let fits = within(entries, crate::command::MAX_DMA_ENTRIES)
            && within(words, crate::command::MAX_CMD_WORDS);
        if !fits {
            return Err(VError::ParamError);
        }
        if self.buffers.len() >= MAX_OBJECTS {
            return Err(VError::AllocFailed);
        }
        let number = self.number();
        self.buffers.insert(number, 0);
        Ok(number)
    }

    /// `V_DestroyCmdBuffer`: waits for what was issued.
    pub fn destroy_buffer(&mut self, buffer: u32) -> Result<(), VError> {
        let issued = self.buffers.remove(&buffer).ok_or(VError::ParamError)?;
        self.worker.wait(issued);
        Ok(())
    }

    /// `V_IssueCmdBuffer`: how many times the display is switched in it. Waiting
    /// for a buffer that lost commands is [`VError::VeriteCommandErr`].
    pub fn issue(&mut self, buffer: u32, segments: &[Segment], wait: bool) -> Result<u32, VError> {
        let last = self.buffers.get_mut(&buffer).ok_or(VError::ParamError)?;
        let words = stream_words(segments);
        let switches = crate::stream::switches(&words, self.config.chip);
        let switches = switches.map_err(|_| VError::VeriteCommandErr)?;
        if words.is_empty() {
            return Ok(0);
        }
        *last = self.worker.issue(words);
        let last = *last;
        if wait {
            self.worker.wait(last);
            self.whole(last)?;
        }
        Ok(switches)
    }

    fn whole(&self, stream: u64) -> Result<(), VError> {
        if self.worker.take_loss(stream) { Err(VError::VeriteCommandErr) } else { Ok(()) }
    }

    /// `V_QueryCmdBuffer`: whether it is in use. The first time that a buffer
    /// is found done that lost commands, [`VError::VeriteCommandErr`].
    pub fn is_in_use(&self, buffer: u32) -> Result<bool, VError> {
        let issued = *self.buffers.get(&buffer).ok_or(VError::ParamError)?;
        let done = self.worker.is_done(issued);
        if done {
            self.whole(issued)?;
        }
        Ok(!done)
    }

    /// Waits until a command buffer is available.
    pub fn wait(&self, buffer: u32) {
        if let Some(&issued) = self.buffers.get(&buffer) {
            self.worker.wait(issued);
        }
    }
}

/// Bytes of a row of a buffer.
fn row_bytes(group: &BufferGroup, buffer: u32) -> u32 {
    group.buffer_format(buffer).row_bytes(group.width) as u32
}

/// Which source pixel each visible pixel of a stretched copy shows.
struct Stretch {
    columns: std::ops::RangeInclusive<i64>,
    rows: std::ops::RangeInclusive<i64>,
    dst: [i64; 4],
    src: [i64; 4],
}

impl Stretch {
    /// `None` for rectangles without pixels, or sources outside their buffer.
    fn new(dst: Rect, src: Rect, visible: Rect, source: Rect) -> Option<Stretch> {
        let inside = src.left >= 0 && src.top >= 0;
        if !inside || src.right > source.right || src.bottom > source.bottom {
            return None;
        }
        let sides = |r: Rect| [r.left, r.top, r.right, r.bottom].map(i64::from);
        let (d, s, v) = (sides(dst), sides(src), sides(visible));
        if d[2] <= d[0] || d[3] <= d[1] || s[2] <= s[0] || s[3] <= s[1] {
            return None;
        }
        Some(Stretch {
            columns: d[0].max(v[0])..=d[2].min(v[2]) - 1,
            rows: d[1].max(v[1])..=d[3].min(v[3]) - 1,
            dst: d,
            src: s,
        })
    }

    fn column(&self, x: i64) -> u32 {
        let [d, s] = [&self.dst, &self.src];
        (s[0] + (x - d[0]) * (s[2] - s[0]) / (d[2] - d[0])) as u32
    }

    fn row(&self, y: i64) -> u32 {
        let [d, s] = [&self.dst, &self.src];
        (s[1] + (y - d[1]) * (s[3] - s[1]) / (d[3] - d[1])) as u32
    }
}
