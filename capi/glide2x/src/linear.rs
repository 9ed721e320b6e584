//! Linear frame buffer access.

use std::borrow::Cow;
use std::ffi::c_void;

use fillrate_glide::{Call, ROW_PIXELS};
use fillrate_guard::{bytes, guard, write};

use crate::library::calls;
use crate::session::{ask, call, call_as, null, session, wrong_info_size};

/// `GrLfbInfo_t`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct LfbInfo {
    size: i32,
    pointer: *mut c_void,
    stride: u32,
    write_mode: i32,
    origin: i32,
}

calls! {
    /// Sets the alpha of writes without alpha.
    grLfbConstantAlpha(alpha: u8) = Call::GrLfbConstantAlpha { alpha };
    /// Sets the depth of writes without depth.
    grLfbConstantDepth(depth: u16) = Call::GrLfbConstantDepth { depth };
    /// Sets the colour format of writes.
    grLfbWriteColorFormat(format: i32) = Call::GrLfbWriteColorFormat { format };
    /// Exchanges the bytes or half words of what is written.
    grLfbWriteColorSwizzle(bytes: i32, words: i32) = Call::GrLfbWriteColorSwizzle { bytes, words };
    /// Sets the write mode of the calls before 2.4.
    grLfbWriteMode(mode: i32) = Call::GrLfbWriteMode { mode };
    /// Sets the row order of the calls before 2.4.
    grLfbOrigin(origin: i32) = Call::GrLfbOrigin { origin };
    /// Sets the pixel pipeline's bypass of the calls before 2.4.
    grLfbBypassMode(mode: i32) = Call::GrLfbBypassMode { mode };
}

/// A rectangle's rows from the first one down, and bytes from one to the next.
///
/// # Safety
/// `data` points to the first of `height` rows of `width` bytes, each `stride`
/// bytes after the one before: upside-down pictures have negative strides.
unsafe fn rectangle<'a>(
    data: *const u8,
    stride: i32,
    width: usize,
    height: usize,
) -> (Cow<'a, [u8]>, i32) {
    if height == 0 {
        return (Cow::default(), stride);
    }
    if let Ok(stride) = usize::try_from(stride) {
        // SAFETY: the caller's promise.
        let rows = unsafe { bytes(data, (height - 1) * stride + width) };
        return (Cow::Borrowed(rows), stride as i32);
    }
    let mut rows = Vec::with_capacity(width * height);
    for row in 0..height as isize {
        let row = data.wrapping_offset(row * stride as isize);
        // SAFETY: the caller's promise.
        rows.extend_from_slice(unsafe { bytes(row, width) });
    }
    (Cow::Owned(rows), width as i32)
}

/// The start of a lock's memory. It does not move until the unlock.
fn memory(kind: i32) -> *mut c_void {
    let mut session = session();
    session.context.lfb_memory(kind).map_or(std::ptr::null_mut(), |words| words.as_mut_ptr().cast())
}

/// Starts frame buffer access.
///
/// # Safety
/// `info` is null or points to a `GrLfbInfo_t`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn grLfbLock(
    kind: i32,
    buffer: i32,
    mode: i32,
    origin: i32,
    pipeline: i32,
    info: *mut LfbInfo,
) -> i32 {
    guard(0, || {
        if info.is_null() {
            null("grLfbLock");
            return 0;
        }
        // SAFETY: the caller gives a description.
        if unsafe { (&raw const (*info).size).read_unaligned() } != size_of::<LfbInfo>() as i32 {
            wrong_info_size("grLfbLock");
        }
        if call(Call::GrLfbLock { kind, buffer, mode, origin, pipeline }) == 0 {
            return 0;
        }
        let wide = matches!(mode, 4 | 5 | 0xc..=0xe) && kind & 0xf == 1;
        let native = if buffer >= 2 { 0xf } else { 0 };
        let resolved = if mode == 0xff { native } else { mode };
        let stride = (ROW_PIXELS * if wide { 4 } else { 2 }) as u32;
        // SAFETY: the caller gives room for the description.
        unsafe {
            write(&raw mut (*info).pointer, memory(kind));
            write(&raw mut (*info).stride, stride);
            write(&raw mut (*info).origin, origin);
            // Nothing is written through a read lock: its mode stays as it is.
            if kind & 0xf == 1 {
                write(&raw mut (*info).write_mode, resolved);
            }
        }
        1
    })
}

/// Ends frame buffer access.
#[unsafe(no_mangle)]
pub extern "C" fn grLfbUnlock(kind: i32, buffer: i32) -> i32 {
    guard(0, || call(Call::GrLfbUnlock { kind, buffer, written: None }) as i32)
}

/// Writes a rectangle.
///
/// # Safety
/// `data` is null or points to the first of `height` rows, each `stride` bytes
/// after the one before.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn grLfbWriteRegion(
    buffer: i32,
    x: u32,
    y: u32,
    format: i32,
    width: u32,
    height: u32,
    stride: i32,
    data: *const u8,
) -> i32 {
    guard(0, || {
        if data.is_null() {
            null("grLfbWriteRegion");
            return 0;
        }
        let pixel = if matches!(format, 4 | 5 | 0xc..=0xe) { 4 } else { 2 };
        let (width, height) = (width.min(ROW_PIXELS as u32), height.min(ROW_PIXELS as u32));
        // SAFETY: the caller's data holds the rectangle.
        let (data, stride) =
            unsafe { rectangle(data, stride, width as usize * pixel, height as usize) };
        let data = data[..].into();
        call(Call::GrLfbWriteRegion { buffer, x, y, format, width, height, stride, data }) as i32
    })
}

/// Reads a rectangle as 16-bit pixels.
///
/// # Safety
/// `to` is null or the first of `height` rows with room for `width` pixels, each
/// `stride` bytes after the one before.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn grLfbReadRegion(
    buffer: i32,
    x: u32,
    y: u32,
    width: u32,
    height: u32,
    stride: u32,
    to: *mut u8,
) -> i32 {
    guard(0, || {
        if to.is_null() {
            null("grLfbReadRegion");
            return 0;
        }
        let read = ask(|context| context.lfb_read_region(buffer, (x, y), (width, height)));
        let Some(pixels) = read else { return 0 };
        if width == 0 || height == 0 {
            return 1;
        }
        let columns = (width as usize).min(ROW_PIXELS);
        for (row, line) in pixels.chunks_exact(columns).enumerate() {
            // A number of 32 bits, which old programs could wrap around.
            let at = to.wrapping_offset(row as isize * (stride as i32) as isize).cast::<u16>();
            for (column, &pixel) in line.iter().enumerate() {
                // SAFETY: inside the caller's rectangle.
                unsafe { at.wrapping_add(column).write_unaligned(pixel) }
            }
        }
        1
    })
}

/// Starts access by pointer, before 2.4.
#[unsafe(no_mangle)]
pub extern "C" fn grLfbBegin() {
    guard((), || {
        call(Call::GrSstIdle {});
    })
}

/// Ends access by pointer, before 2.4: carries out what was written.
#[unsafe(no_mangle)]
pub extern "C" fn grLfbEnd() {
    guard((), || {
        for kind in 0..=1 {
            end(kind);
        }
    })
}

/// The pixels of a buffer for reading, until `grLfbEnd`.
#[unsafe(no_mangle)]
pub extern "C" fn grLfbGetReadPtr(buffer: i32) -> *const u32 {
    pointer(0, buffer).cast()
}

/// The pixels of a buffer for writing, until `grLfbEnd`.
#[unsafe(no_mangle)]
pub extern "C" fn grLfbGetWritePtr(buffer: i32) -> *mut c_void {
    pointer(1, buffer)
}

/// Ends the lock of a kind, where there is one.
fn end(kind: i32) {
    // Asked for on its own: the unlock locks the library again.
    let locked = session().context.lfb_locked(kind);
    if let Some(buffer) = locked {
        grLfbUnlock(kind, buffer);
    }
}

fn pointer(kind: i32, buffer: i32) -> *mut c_void {
    guard(std::ptr::null_mut(), || {
        let (mode, origin, pipeline) = session().context.old_lfb_settings();
        end(kind);
        let pipeline = i32::from(pipeline);
        let name = if kind == 0 { "grLfbGetReadPtr" } else { "grLfbGetWritePtr" };
        let lock = |mode| Call::GrLfbLock { kind, buffer, mode, origin, pipeline };
        // A mode that does not fit the buffer must not leave the program without
        // a pointer: it may set the right one before it writes.
        if call_as(name, lock(mode)) == 0 && kind == 1 {
            call_as(name, lock(0xff));
        }
        session().old_buffers[kind as usize] = buffer;
        memory(kind)
    })
}

/// Pixels that a rectangle can reach past the screen and still be of use.
const MAX_SIDE: i32 = 4096;

/// Reads a rectangle of 16-bit pixels from the buffer that was chosen with
/// `grLfbGetReadPtr`, before 2.4.
///
/// # Safety
/// `to` is null or has room for `height` rows, `stride` bytes apart.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn guFbReadRegion(
    x: i32,
    y: i32,
    width: i32,
    height: i32,
    to: *mut u8,
    stride: i32,
) {
    guard((), || {
        if to.is_null() {
            return null("guFbReadRegion");
        }
        let buffer = session().old_buffers[0];
        let read = ask(|context| context.lfb_read_old_region(buffer, (x, y), (width, height)));
        let Some(pixels) = read.filter(|_| width > 0) else { return };
        let columns = (width as usize).min(ROW_PIXELS);
        for (row, line) in pixels.chunks_exact(columns).enumerate() {
            let at = to.wrapping_offset(row as isize * stride as isize).cast::<u16>();
            for (column, &pixel) in line.iter().enumerate() {
                // SAFETY: inside the caller's rectangle.
                unsafe { at.wrapping_add(column).write_unaligned(pixel) }
            }
        }
    })
}

/// Writes a rectangle of 16-bit pixels to the buffer that was chosen with
/// `grLfbGetWritePtr`, before 2.4.
///
/// # Safety
/// `data` is null or points to the first of `height` rows, each `stride` bytes
/// after the one before.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn guFbWriteRegion(
    x: i32,
    y: i32,
    width: i32,
    height: i32,
    data: *const u8,
    stride: i32,
) {
    guard((), || {
        if data.is_null() {
            return null("guFbWriteRegion");
        }
        let (width, height) = (width.clamp(0, MAX_SIDE), height.clamp(0, MAX_SIDE));
        // SAFETY: the caller's data holds the rectangle.
        let (data, stride) =
            unsafe { rectangle(data, stride, width as usize * 2, height as usize) };
        let (buffer, data) = (session().old_buffers[1], data[..].into());
        call(Call::GuFbWriteRegion { buffer, x, y, width, height, stride, data });
    })
}
