//! Fills and copies of the upper layer.

use std::ffi::c_int;

use fillrate_redline::record::{self, Composite, FillPattern, Pattern};
use fillrate_redline::{DmaBlock, Failure, Result, VlError, VlRoutine};

use crate::handle::Opaque;
use crate::host_memory::block;
use crate::install::with_surface;
use crate::sink::{Sink, recorded};
use crate::surface::RawSurface;

/// An invalid argument.
pub(crate) fn invalid(routine: VlRoutine) -> Failure {
    Failure::vl(routine, VlError::ParamError)
}

/// A block of host memory from an address on.
fn data(
    sink: &mut Sink,
    routine: VlRoutine,
    memory: Opaque,
    address: *const u32,
) -> Result<DmaBlock> {
    block(&sink.session().memories, memory, address).ok_or(invalid(routine))
}

/// Fills a rectangle of a buffer with a pixel value.
///
/// # Safety
/// `cmdbuffer` is null or points to a handle, `surface` to a surface.
#[unsafe(export_name = "redline_FillBuffer")]
pub unsafe extern "C" fn VL_FillBuffer(
    cmdbuffer: *mut Opaque,
    surface: *const RawSurface,
    buffer: u32,
    x: u32,
    y: u32,
    width: u32,
    height: u32,
    pixel: u32,
) -> c_int {
    // SAFETY: the caller's promise.
    unsafe {
        with_surface(cmdbuffer, surface, VlRoutine::FillBuffer, |sink, _, group| {
            record::fill_buffer(sink, group, buffer, [x, y], [width, height], pixel)
        })
    }
}

/// Host pixels to a buffer's origin.
///
/// # Safety
/// `cmdbuffer` is null or points to a handle, `surface` to a surface.
#[unsafe(export_name = "redline_LoadBuffer")]
pub unsafe extern "C" fn VL_LoadBuffer(
    cmdbuffer: *mut Opaque,
    surface: *const RawSurface,
    buffer: u32,
    linebytes: u32,
    width: u32,
    height: u32,
    memory: Opaque,
    address: *const u32,
) -> c_int {
    let routine = VlRoutine::LoadBuffer;
    // SAFETY: the caller's promise.
    unsafe {
        with_surface(cmdbuffer, surface, routine, |sink, _, group| {
            let data = data(sink, routine, memory, address)?;
            record::load_buffer(sink, group, buffer, linebytes, [width, height], data)
        })
    }
}

/// A rectangle of a buffer to the destination by an operation.
///
/// # Safety
/// `cmdbuffer` is null or points to a handle, `surface` to a surface.
#[unsafe(export_name = "redline_CopyBuffer")]
pub unsafe extern "C" fn VL_CopyBuffer(
    cmdbuffer: *mut Opaque,
    surface: *const RawSurface,
    buffer: u32,
    alu_mode: u32,
    dst_x: u16,
    dst_y: u16,
    width: u16,
    height: u16,
    src_x: u16,
    src_y: u16,
) -> c_int {
    // SAFETY: the caller's promise.
    unsafe {
        with_surface(cmdbuffer, surface, VlRoutine::CopyBuffer, |sink, _, group| {
            let (to, size, from) = ([dst_x, dst_y], [width, height], [src_x, src_y]);
            record::copy_buffer(sink, group, buffer, alu_mode, to, size, from)
        })
    }
}

/// Fills pixels of video memory.
///
/// # Safety
/// `cmdbuffer` is null or points to a handle.
#[unsafe(export_name = "redline_MemFill")]
pub unsafe extern "C" fn VL_MemFill(
    cmdbuffer: *mut Opaque,
    dest: u32,
    pixel: u32,
    format: u32,
    width: u32,
) -> c_int {
    // SAFETY: the caller's promise.
    unsafe {
        recorded(cmdbuffer, VlRoutine::MemFill, |sink| {
            record::mem_fill(sink, dest, pixel, format, width)
        })
    }
}

/// Fills rows of video memory.
///
/// # Safety
/// `cmdbuffer` is null or points to a handle.
#[unsafe(export_name = "redline_MemFillRect")]
pub unsafe extern "C" fn VL_MemFillRect(
    cmdbuffer: *mut Opaque,
    dest: u32,
    dest_linebytes: u32,
    pixel: u32,
    format: u32,
    width: u32,
    height: u32,
) -> c_int {
    // SAFETY: the caller's promise.
    unsafe {
        recorded(cmdbuffer, VlRoutine::MemFillRect, |sink| {
            record::mem_fill_rect(sink, [dest, dest_linebytes], pixel, format, [width, height])
        })
    }
}

/// Host pixels to video memory.
///
/// # Safety
/// `cmdbuffer` is null or points to a handle.
#[unsafe(export_name = "redline_MemWrite")]
pub unsafe extern "C" fn VL_MemWrite(
    cmdbuffer: *mut Opaque,
    dest: u32,
    memory: Opaque,
    address: *const u32,
    format: u32,
    width: u32,
) -> c_int {
    let routine = VlRoutine::MemWrite;
    // SAFETY: the caller's promise.
    unsafe {
        recorded(cmdbuffer, routine, |sink| {
            let data = data(sink, routine, memory, address)?;
            record::mem_write(sink, dest, data, format, width)
        })
    }
}

/// Host rows to video memory.
///
/// # Safety
/// `cmdbuffer` is null or points to a handle.
#[unsafe(export_name = "redline_MemWriteRect")]
pub unsafe extern "C" fn VL_MemWriteRect(
    cmdbuffer: *mut Opaque,
    dest: u32,
    dest_linebytes: u32,
    memory: Opaque,
    address: *const u32,
    format: u32,
    linebytes: u32,
    width: u32,
    height: u32,
) -> c_int {
    let routine = VlRoutine::MemWriteRect;
    // SAFETY: the caller's promise.
    unsafe {
        recorded(cmdbuffer, routine, |sink| {
            let data = data(sink, routine, memory, address)?;
            let (dest, size) = ([dest, dest_linebytes], [width, height]);
            record::mem_write_rect(sink, dest, data, linebytes, format, size)
        })
    }
}

/// Runs of host pixels to video memory.
///
/// # Safety
/// `cmdbuffer` is null or points to a handle.
#[unsafe(export_name = "redline_MemWriteSprite")]
pub unsafe extern "C" fn VL_MemWriteSprite(
    cmdbuffer: *mut Opaque,
    dest: u32,
    format: u32,
    bytes: u32,
    memory: Opaque,
) -> c_int {
    let routine = VlRoutine::MemWriteSprite;
    // SAFETY: the caller's promise.
    unsafe {
        recorded(cmdbuffer, routine, |sink| {
            let data = data(sink, routine, memory, std::ptr::null())?;
            record::mem_write_sprite(sink, dest, format, bytes, data)
        })
    }
}

/// From the source to the destination; also `VL_BitBlt`.
///
/// # Safety
/// `cmdbuffer` is null or points to a handle.
#[unsafe(export_name = "redline_Bitblt")]
pub unsafe extern "C" fn VL_Bitblt(
    cmdbuffer: *mut Opaque,
    dst_x: u16,
    dst_y: u16,
    width: u16,
    height: u16,
    src_x: u16,
    src_y: u16,
) -> c_int {
    // SAFETY: the caller's promise.
    unsafe {
        recorded(cmdbuffer, VlRoutine::Bitblt, |sink| {
            record::bitblt(sink, [dst_x, dst_y], [width, height], [src_x, src_y])
        })
    }
}

/// Fills in the foreground colour or the pattern.
///
/// # Safety
/// `cmdbuffer` is null or points to a handle.
#[unsafe(export_name = "redline_Bitfill")]
pub unsafe extern "C" fn VL_Bitfill(
    cmdbuffer: *mut Opaque,
    x: u16,
    y: u16,
    width: u16,
    height: u16,
) -> c_int {
    // SAFETY: the caller's promise.
    unsafe {
        recorded(cmdbuffer, VlRoutine::Bitfill, |sink| {
            record::bitfill(sink, [x, y], [width, height])
        })
    }
}

/// Fills a rectangle of a buffer.
///
/// # Safety
/// `cmdbuffer` is null or points to a handle, `surface` to a surface.
unsafe fn fill(
    cmdbuffer: *mut Opaque,
    surface: *const RawSurface,
    routine: VlRoutine,
    buffer: u32,
    fill: FillPattern,
    at: [u16; 2],
    size: [u16; 2],
) -> c_int {
    // SAFETY: the caller's promise.
    unsafe {
        with_surface(cmdbuffer, surface, routine, |sink, _, group| {
            record::bitfill_buffer(sink, group, buffer, &fill, at, size)
        })
    }
}

/// Fills a rectangle of a buffer in one colour.
///
/// # Safety
/// `cmdbuffer` is null or points to a handle, `surface` to a surface.
#[unsafe(export_name = "redline_BitfillNoPat")]
pub unsafe extern "C" fn VL_BitfillNoPat(
    cmdbuffer: *mut Opaque,
    surface: *const RawSurface,
    buffer: u32,
    foreground: u32,
    x: u16,
    y: u16,
    width: u16,
    height: u16,
) -> c_int {
    let how = FillPattern { foreground, ..FillPattern::default() };
    let routine = VlRoutine::BitfillNoPat;
    // SAFETY: the caller's promise.
    unsafe { fill(cmdbuffer, surface, routine, buffer, how, [x, y], [width, height]) }
}

/// Fills the ones of a pattern.
///
/// # Safety
/// `cmdbuffer` is null or points to a handle, `surface` to a surface.
#[unsafe(export_name = "redline_BitfillPatTransparent")]
pub unsafe extern "C" fn VL_BitfillPatTransparent(
    cmdbuffer: *mut Opaque,
    surface: *const RawSurface,
    buffer: u32,
    foreground: u32,
    bits: u32,
    length: u32,
    offset: u32,
    x: u16,
    y: u16,
    width: u16,
    height: u16,
) -> c_int {
    let pattern = Some(Pattern { bits, length, offset });
    let how = FillPattern { foreground, background: None, pattern };
    let routine = VlRoutine::BitfillPatTransparent;
    // SAFETY: the caller's promise.
    unsafe { fill(cmdbuffer, surface, routine, buffer, how, [x, y], [width, height]) }
}

/// Fills ones and zeros of a pattern.
///
/// # Safety
/// `cmdbuffer` is null or points to a handle, `surface` to a surface.
#[unsafe(export_name = "redline_BitfillPatOpaque")]
pub unsafe extern "C" fn VL_BitfillPatOpaque(
    cmdbuffer: *mut Opaque,
    surface: *const RawSurface,
    buffer: u32,
    foreground: u32,
    background: u32,
    bits: u32,
    length: u32,
    offset: u32,
    x: u16,
    y: u16,
    width: u16,
    height: u16,
) -> c_int {
    let pattern = Some(Pattern { bits, length, offset });
    let how = FillPattern { foreground, background: Some(background), pattern };
    let routine = VlRoutine::BitfillPatOpaque;
    // SAFETY: the caller's promise.
    unsafe { fill(cmdbuffer, surface, routine, buffer, how, [x, y], [width, height]) }
}

/// Host pixels through the pixel pipeline. `bytes` is what a pixel takes; 0 is
/// taken for the two bytes of the display's.
///
/// # Safety
/// `cmdbuffer` is null or points to a handle.
#[unsafe(export_name = "redline_BitbltMem")]
pub unsafe extern "C" fn VL_BitbltMem(
    cmdbuffer: *mut Opaque,
    x: u16,
    y: u16,
    width: u16,
    height: u16,
    bytes: u32,
    memory: Opaque,
    address: *const u32,
) -> c_int {
    let routine = VlRoutine::BitbltMem;
    // SAFETY: the caller's promise.
    unsafe {
        recorded(cmdbuffer, routine, |sink| {
            let data = data(sink, routine, memory, address)?;
            let bytes = if bytes == 0 { 2 } else { bytes };
            record::bitblt_mem(sink, [x, y], [width, height], bytes, data)
        })
    }
}

/// Host pixels times the texture.
///
/// # Safety
/// `cmdbuffer` is null or points to a handle.
#[unsafe(export_name = "redline_CompositeRect")]
pub unsafe extern "C" fn VL_CompositeRect(
    cmdbuffer: *mut Opaque,
    pixel_fmt: u32,
    x: u16,
    y: u16,
    width: u16,
    height: u16,
    u_start: u32,
    v_start: u32,
    u_stop: u32,
    v_stop: u32,
    memory: Opaque,
) -> c_int {
    let routine = VlRoutine::CompositeRect;
    let what = Composite {
        pixel_fmt,
        at: [x, y],
        size: [width, height],
        start: [u_start, v_start],
        stop: [u_stop, v_stop],
    };
    // SAFETY: the caller's promise.
    unsafe {
        recorded(cmdbuffer, routine, |sink| {
            let data = data(sink, routine, memory, std::ptr::null())?;
            record::composite_rect(sink, &what, data)
        })
    }
}

/// Texels by index from host memory.
///
/// # Safety
/// `cmdbuffer` is null or points to a handle.
#[unsafe(export_name = "redline_Lookup")]
pub unsafe extern "C" fn VL_Lookup(
    cmdbuffer: *mut Opaque,
    x: u16,
    y: u16,
    width: u16,
    height: u16,
    memory: Opaque,
    address: *const u32,
) -> c_int {
    let routine = VlRoutine::Lookup;
    // SAFETY: the caller's promise.
    unsafe {
        recorded(cmdbuffer, routine, |sink| {
            let data = data(sink, routine, memory, address)?;
            record::lookup(sink, [x, y], [width, height], data)
        })
    }
}
