//! Memory and 2D commands.

use super::{invalid, pair, put, unadded};
use crate::command::{CommandSink, DmaBlock};
use crate::error::{Failure, Result, VlError, VlRoutine};
use crate::format::PixFmt;
use crate::opcode::{Opcode, Register};
use crate::surface::BufferGroup;

/// Words, then a block of host memory that must stay together with them.
pub(crate) fn put_with_data<S: CommandSink + ?Sized>(
    sink: &mut S,
    routine: VlRoutine,
    head: &[u32],
    data: DmaBlock,
    words: u32,
) -> Result<()> {
    if words > crate::command::MAX_BLOCK_WORDS {
        return Err(invalid(routine));
    }
    let data = DmaBlock { words, ..data };
    let failed = |error| unadded(routine, error);
    let out = sink.reserve(head.len(), data.entries() as usize).map_err(failed)?;
    out.copy_from_slice(head);
    if words == 0 { Ok(()) } else { sink.add_dma(data).map_err(failed) }
}

/// The format with this code, which must not be one of less than a byte where
/// bytes are addressed.
fn format(routine: VlRoutine, code: u32) -> Result<PixFmt> {
    PixFmt::from_code(code).ok_or(Failure::vl(routine, VlError::BadPixFmt))
}

/// A pixel value repeated in a word.
pub(crate) fn repeated(format: PixFmt, value: u32) -> u32 {
    match format.bits() {
        4 => (value & 0xf) * 0x1111_1111,
        8 => (value & 0xff) * 0x0101_0101,
        16 => (value & 0xffff) * 0x1_0001,
        _ => value,
    }
}

/// Bytes of `width` pixels.
fn row_bytes(routine: VlRoutine, format: PixFmt, width: u32) -> Result<u32> {
    u32::try_from(format.row_bytes(width)).map_err(|_| invalid(routine))
}

fn clear_rect<S: CommandSink + ?Sized>(
    sink: &mut S,
    routine: VlRoutine,
    [destination, linebytes]: [u32; 2],
    format: PixFmt,
    [width, height]: [u32; 2],
    value: u32,
) -> Result<()> {
    let row = row_bytes(routine, format, width)?;
    let head = [Opcode::MemClearRect as u32, destination, linebytes, row, height];
    let [a, b, c, d, e] = head;
    put(sink, routine, &[a, b, c, d, e, repeated(format, value)])
}

/// `VL_MemFill`: `width` pixels.
///
/// # Errors
/// [`VlError::BadPixFmt`]; those of the sink.
pub fn mem_fill<S: CommandSink + ?Sized>(
    sink: &mut S,
    destination: u32,
    value: u32,
    pixel_fmt: u32,
    width: u32,
) -> Result<()> {
    let routine = VlRoutine::MemFill;
    let format = format(routine, pixel_fmt)?;
    clear_rect(sink, routine, [destination, 0], format, [width, 1], value)
}

/// `VL_MemFillRect`: rows of pixels.
///
/// # Errors
/// [`VlError::BadPixFmt`]; those of the sink.
pub fn mem_fill_rect<S: CommandSink + ?Sized>(
    sink: &mut S,
    destination: [u32; 2],
    value: u32,
    pixel_fmt: u32,
    size: [u32; 2],
) -> Result<()> {
    let routine = VlRoutine::MemFillRect;
    let format = format(routine, pixel_fmt)?;
    clear_rect(sink, routine, destination, format, size, value)
}

/// The address of a pixel of a buffer, checked against the buffer's size.
fn place(
    routine: VlRoutine,
    group: &BufferGroup,
    buffer: u32,
    [x, y]: [u32; 2],
    [width, height]: [u32; 2],
) -> Result<u32> {
    let base = group.address(buffer).ok_or(invalid(routine))?;
    let inside =
        |at: u32, size: u32, side: u32| at.checked_add(size).is_some_and(|end| end <= side);
    if !inside(x, width, group.width) || !inside(y, height, group.height) {
        return Err(invalid(routine));
    }
    let format = group.buffer_format(buffer);
    if format.bits() == 4 && x % 2 != 0 {
        return Err(invalid(routine));
    }
    Ok(base + y * group.linebytes + format.row_bytes(x) as u32)
}

/// `VL_FillBuffer`: a rectangle of a buffer in a raw pixel value.
///
/// # Errors
/// [`VlError::ParamError`] for a rectangle or buffer outside; those of the
/// sink.
pub fn fill_buffer<S: CommandSink + ?Sized>(
    sink: &mut S,
    group: &BufferGroup,
    buffer: u32,
    at: [u32; 2],
    size: [u32; 2],
    value: u32,
) -> Result<()> {
    let routine = VlRoutine::FillBuffer;
    let address = place(routine, group, buffer, at, size)?;
    let format = group.buffer_format(buffer);
    clear_rect(sink, routine, [address, group.linebytes], format, size, value)
}

/// Words of `height` rows of `bytes` bytes, padded.
fn padded_words(routine: VlRoutine, bytes: u32, height: u32) -> Result<u32> {
    bytes.div_ceil(4).checked_mul(height).ok_or(invalid(routine))
}

/// `VL_MemWrite` with the pixels in host memory; the block's length is set
/// here.
///
/// # Errors
/// [`VlError::BadPixFmt`], [`VlError::ParamError`] for too many pixels; those
/// of the sink.
pub fn mem_write<S: CommandSink + ?Sized>(
    sink: &mut S,
    destination: u32,
    data: DmaBlock,
    pixel_fmt: u32,
    width: u32,
) -> Result<()> {
    let routine = VlRoutine::MemWrite;
    let bytes = row_bytes(routine, format(routine, pixel_fmt)?, width)?;
    let head = [Opcode::MemWrite as u32, destination, bytes];
    put_with_data(sink, routine, &head, data, bytes.div_ceil(4))
}

/// Rows of host memory to video memory. Host rows are `data_linebytes` apart;
/// where that is not the padded row, each row is a block of its own.
fn write_rect<S: CommandSink + ?Sized>(
    sink: &mut S,
    routine: VlRoutine,
    [destination, linebytes]: [u32; 2],
    data: DmaBlock,
    data_linebytes: u32,
    [bytes, height]: [u32; 2],
) -> Result<()> {
    let words = padded_words(routine, bytes, height)?;
    let head = |height| [Opcode::MemWriteRect as u32, destination, linebytes, bytes, height];
    let row_words = bytes.div_ceil(4);
    if data_linebytes == row_words * 4 || height <= 1 {
        return put_with_data(sink, routine, &head(height), data, words);
    }
    if !data_linebytes.is_multiple_of(4) {
        return Err(invalid(routine));
    }
    if words > crate::command::MAX_BLOCK_WORDS {
        return Err(invalid(routine));
    }
    let row = |y: u32| DmaBlock {
        offset: data.offset + u64::from(y) * u64::from(data_linebytes),
        words: row_words,
        ..data
    };
    // All rows are data of one command, so their entries are reserved at once.
    let entries: usize = (0..height).map(|y| row(y).entries() as usize).sum();
    let failed = |error| unadded(routine, error);
    let whole = sink.reserve(5, entries);
    match whole {
        Ok(out) => {
            out.copy_from_slice(&head(height));
            (0..height).filter(|_| row_words > 0).try_for_each(|y| sink.add_dma(row(y)))
        }
        .map_err(failed),
        // More rows than DMA entries: one command for each row.
        Err(_) => (0..height).try_for_each(|y| {
            let at = destination.wrapping_add(y.wrapping_mul(linebytes));
            let head = [Opcode::MemWrite as u32, at, bytes];
            put_with_data(sink, routine, &head, row(y), row_words)
        }),
    }
}

/// `VL_MemWriteRect`: `destination` is address and pitch, `data_linebytes` the
/// pitch in host memory, a multiple of 4.
///
/// # Errors
/// [`VlError::BadPixFmt`], [`VlError::ParamError`]; those of the sink.
pub fn mem_write_rect<S: CommandSink + ?Sized>(
    sink: &mut S,
    destination: [u32; 2],
    data: DmaBlock,
    data_linebytes: u32,
    pixel_fmt: u32,
    [width, height]: [u32; 2],
) -> Result<()> {
    let routine = VlRoutine::MemWriteRect;
    let bytes = row_bytes(routine, format(routine, pixel_fmt)?, width)?;
    write_rect(sink, routine, destination, data, data_linebytes, [bytes, height])
}

/// `VL_LoadBuffer`: host pixels to a buffer's origin.
///
/// # Errors
/// [`VlError::ParamError`] for a size beyond the buffer's; those of the sink.
pub fn load_buffer<S: CommandSink + ?Sized>(
    sink: &mut S,
    group: &BufferGroup,
    buffer: u32,
    data_linebytes: u32,
    size: [u32; 2],
    data: DmaBlock,
) -> Result<()> {
    let routine = VlRoutine::LoadBuffer;
    let address = place(routine, group, buffer, [0, 0], size)?;
    let bytes = row_bytes(routine, group.buffer_format(buffer), size[0])?;
    let destination = [address, group.linebytes];
    write_rect(sink, routine, destination, data, data_linebytes, [bytes, size[1]])
}

/// Host rows with their bytes in the stream, padded to words: the form of
/// [`mem_write_rect`] without DMA. `row_bytes` bytes of each row count.
///
/// # Errors
/// [`VlError::ParamError`] for too few words; those of the sink.
pub fn mem_write_rect_inline<S: CommandSink + ?Sized>(
    sink: &mut S,
    [destination, linebytes]: [u32; 2],
    [row_bytes, height]: [u32; 2],
    words: &[u32],
) -> Result<()> {
    let routine = VlRoutine::MemWriteRect;
    let count = padded_words(routine, row_bytes, height)? as usize;
    let words = words.get(..count).ok_or(invalid(routine))?;
    let out = sink.reserve(5 + count, 0).map_err(|error| unadded(routine, error))?;
    let head = [Opcode::MemWriteRect as u32, destination, linebytes, row_bytes, height];
    out[..5].copy_from_slice(&head);
    out[5..].copy_from_slice(words);
    Ok(())
}

/// `VL_MemWriteSprite`: records of a head (bytes to skip in the high half,
/// bytes that follow in the low one) and bytes padded to words; a head of 0
/// ends them. `bytes` is the length of all, the closing head included.
///
/// # Errors
/// [`VlError::BadPixFmt`]; those of the sink.
pub fn mem_write_sprite<S: CommandSink + ?Sized>(
    sink: &mut S,
    destination: u32,
    pixel_fmt: u32,
    bytes: u32,
    data: DmaBlock,
) -> Result<()> {
    let routine = VlRoutine::MemWriteSprite;
    format(routine, pixel_fmt)?;
    let head = [Opcode::MemWriteSprite as u32, destination, pixel_fmt];
    put_with_data(sink, routine, &head, data, bytes.div_ceil(4))
}

/// `VL_CopyBuffer`: a rectangle of a buffer to the destination with an ALU
/// mode. The source registers are left pointing to the buffer.
///
/// # Errors
/// [`VlError::ParamError`] for a rectangle outside the buffer or an unknown
/// mode; those of the sink.
pub fn copy_buffer<S: CommandSink + ?Sized>(
    sink: &mut S,
    group: &BufferGroup,
    buffer: u32,
    alu_mode: u32,
    [dst_x, dst_y]: [u16; 2],
    [width, height]: [u16; 2],
    [src_x, src_y]: [u16; 2],
) -> Result<()> {
    let routine = VlRoutine::CopyBuffer;
    let (at, size) = ([src_x, src_y].map(u32::from), [width, height].map(u32::from));
    place(routine, group, buffer, at, size)?;
    let base = group.address(buffer).filter(|_| alu_mode <= 15).ok_or(invalid(routine))?;
    let format = group.buffer_format(buffer).code();
    let words = [
        Register::SrcBase.word(),
        base,
        Register::SrcStride.word(),
        group.stride,
        Register::SrcFmt.word(),
        format,
        Register::AluMode.word(),
        alu_mode,
        Opcode::Bitblt as u32,
        pair(dst_x.into(), dst_y.into()),
        pair(size[0], size[1]),
        pair(at[0], at[1]),
    ];
    put(sink, routine, &words)
}

/// `VL_Bitblt`: from the source to the destination.
///
/// # Errors
/// Those of the sink.
pub fn bitblt<S: CommandSink + ?Sized>(
    sink: &mut S,
    destination: [u16; 2],
    size: [u16; 2],
    source: [u16; 2],
) -> Result<()> {
    let [d, s, o] = [destination, size, source].map(|[x, y]| pair(x.into(), y.into()));
    put(sink, VlRoutine::Bitblt, &[Opcode::Bitblt as u32, d, s, o])
}

/// `VL_Bitfill`: in the foreground colour, or the pattern where it is enabled.
///
/// # Errors
/// Those of the sink.
pub fn bitfill<S: CommandSink + ?Sized>(sink: &mut S, at: [u16; 2], size: [u16; 2]) -> Result<()> {
    let [at, size] = [at, size].map(|[x, y]| pair(x.into(), y.into()));
    put(sink, VlRoutine::Bitfill, &[Opcode::Bitfill as u32, at, size])
}

/// Colours and pattern of a fill.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FillPattern {
    /// Colour of ones, 0x00RRGGBB.
    pub foreground: u32,
    /// Colour of zeros; `None` leaves them out.
    pub background: Option<u32>,
    /// Bits, the highest first; `None` fills in the foreground colour.
    pub pattern: Option<Pattern>,
}

/// A pattern of 1 to 32 bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pattern {
    /// The bits; bit 31 comes first.
    pub bits: u32,
    /// How many count.
    pub length: u32,
    /// Which comes first in column 0.
    pub offset: u32,
}

/// `VL_BitfillNoPat`, `VL_BitfillPatTransparent`, `VL_BitfillPatOpaque`: fills
/// a rectangle of a buffer. Destination, foreground and background colour, and
/// pattern are left as they were set for it; the pattern is switched off.
///
/// # Errors
/// [`VlError::ParamError`] for a rectangle outside or a length that is not 1
/// to 32; those of the sink.
pub fn bitfill_buffer<S: CommandSink + ?Sized>(
    sink: &mut S,
    group: &BufferGroup,
    buffer: u32,
    fill: &FillPattern,
    at: [u16; 2],
    size: [u16; 2],
) -> Result<()> {
    let routine = match (fill.pattern, fill.background) {
        (None, _) => VlRoutine::BitfillNoPat,
        (Some(_), None) => VlRoutine::BitfillPatTransparent,
        (Some(_), Some(_)) => VlRoutine::BitfillPatOpaque,
    };
    place(routine, group, buffer, at.map(u32::from), size.map(u32::from))?;
    let base = group.address(buffer).ok_or(invalid(routine))?;
    let opaque = |color: u32| color | 0xff00_0000;
    let mut words = vec![
        (Register::DstBase, base),
        (Register::DstStride, group.stride),
        (Register::DstFmt, group.buffer_format(buffer).code()),
        (Register::FgColorArgb, opaque(fill.foreground)),
    ];
    if let Some(color) = fill.background {
        words.push((Register::BgColorArgb, opaque(color)));
    }
    if let Some(Pattern { bits, length, offset }) = fill.pattern {
        if !(1..=32).contains(&length) {
            return Err(invalid(routine));
        }
        let background = u32::from(fill.background.is_some());
        words.extend([
            (Register::Pat, bits),
            (Register::PatLengthM1, length - 1),
            (Register::PatOffset, offset),
            (Register::PatOpaque, background),
        ]);
    }
    words.push((Register::PatEnable, u32::from(fill.pattern.is_some())));
    let mut words: Vec<u32> = words.iter().flat_map(|(r, value)| [r.word(), *value]).collect();
    let [at, size] = [at, size].map(|[x, y]| pair(x.into(), y.into()));
    words.extend([Opcode::Bitfill as u32, at, size, Register::PatEnable.word(), 0]);
    put(sink, routine, &words)
}

/// `VL_BitbltMem`: host pixels of the source format through the pixel pipeline.
/// `bytes` is what a pixel takes. The block's length is set here.
///
/// # Errors
/// [`VlError::ParamError`] for pixels that take not 1, 2 or 4 bytes; those of
/// the sink.
pub fn bitblt_mem<S: CommandSink + ?Sized>(
    sink: &mut S,
    at: [u16; 2],
    [width, height]: [u16; 2],
    bytes: u32,
    data: DmaBlock,
) -> Result<()> {
    let routine = VlRoutine::BitbltMem;
    if !matches!(bytes, 1 | 2 | 4) {
        return Err(invalid(routine));
    }
    // The size counts whole words, so that the last pixels of an odd width are
    // cut off by the width in the fourth word.
    let row = (u32::from(width) * bytes).div_ceil(4);
    let at = pair(at[0].into(), at[1].into());
    let width = u32::from(width) << 16 | bytes;
    let head = [Opcode::BitbltMem as u32, at, pair(row, height.into()), width];
    let words = padded_words(routine, row * 4, height.into())?;
    put_with_data(sink, routine, &head, data, words)
}

/// `VL_Lookup`: each host byte selects a texel of the current texture's first
/// row. Host rows are padded to words; the block's length is set here.
///
/// # Errors
/// Those of the sink.
pub fn lookup<S: CommandSink + ?Sized>(
    sink: &mut S,
    at: [u16; 2],
    size: [u16; 2],
    data: DmaBlock,
) -> Result<()> {
    let routine = VlRoutine::Lookup;
    let words = padded_words(routine, size[0].into(), size[1].into())?;
    let [at, size] = [at, size].map(|[x, y]| pair(x.into(), y.into()));
    put_with_data(sink, routine, &[Opcode::Lookup as u32, at, size], data, words)
}

/// What `VL_CompositeRect` composes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Composite {
    /// Format of the host pixels.
    pub pixel_fmt: u32,
    /// Upper left pixel.
    pub at: [u16; 2],
    /// Columns and rows.
    pub size: [u16; 2],
    /// U and V at the upper left corner, as in vertices.
    pub start: [u32; 2],
    /// U and V at the lower right corner.
    pub stop: [u32; 2],
}

/// `VL_CompositeRect`: host pixels times the texture. Host rows are padded to
/// words; the block's length is set here.
///
/// # Errors
/// [`VlError::BadPixFmt`]; those of the sink.
pub fn composite_rect<S: CommandSink + ?Sized>(
    sink: &mut S,
    what: &Composite,
    data: DmaBlock,
) -> Result<()> {
    let routine = VlRoutine::CompositeRect;
    let row = row_bytes(routine, format(routine, what.pixel_fmt)?, what.size[0].into())?;
    let words = padded_words(routine, row, what.size[1].into())?;
    let [at, size] = [what.at, what.size].map(|[x, y]| pair(x.into(), y.into()));
    let ([u0, v0], [u1, v1]) = (what.start, what.stop);
    let head = [Opcode::CompositeRect as u32, what.pixel_fmt, at, size, u0, v0, u1, v1];
    put_with_data(sink, routine, &head, data, words)
}
