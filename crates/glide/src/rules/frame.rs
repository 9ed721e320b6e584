//! Rules of boards, buffers and the linear frame buffer.

use super::{Rule, rules};
use crate::call::Call;
use crate::card::RESOLUTIONS;
use crate::enums::*;
use crate::registers::fbz;

fn is_lock(kind: i32) -> bool {
    matches!(kind & 0xf, LFB_READ_ONLY | LFB_WRITE_ONLY) && kind & !0x1f == 0
}

/// A write mode, or a source format of a region.
fn is_format(mode: i32) -> bool {
    matches!(mode, 0..=2 | 4 | 5 | 0xc..=0xf)
}

/// ZA16 goes to the auxiliary buffer and nothing else does.
fn fits(mode: i32, buffer: i32) -> bool {
    mode == LFBWRITEMODE_ANY || (mode == LFBWRITEMODE_ZA16) == (buffer >= BUFFER_AUX)
}

fn is_register(register: u32) -> bool {
    matches!(register, 0..=77 | 80..=140 | 192..=224)
}

rules! { at;
    "grSstSelect": GrSstSelect (board) "which_sst" "is not the number of a board" fatal
        if usize::try_from(*board).map_or(true, |board| board >= at.boards);
    "grSstWinOpen": GrSstWinOpen () "" "the library was not started" fatal
        if !at.started;
    "grSstWinOpen": GrSstWinOpen () "" "the board is open already" fatal
        if at.open().is_some() && !at.variables.ignore_reopen;
    "grSstWinOpen": GrSstWinOpen (resolution) "res" "is not a resolution that a board can show" fatal
        if !(0..RESOLUTIONS.len() as i32).contains(resolution);
    "grSstWinOpen": GrSstWinOpen (refresh) "ref" "is not one of GR_REFRESH_*" fatal
        if !matches!(refresh, 0..=8 | 0xff);
    "grSstWinOpen": GrSstWinOpen (color_format) "cformat" "is not one of GR_COLORFORMAT_*" fatal
        if !(0..=3).contains(color_format);
    "grSstWinOpen": GrSstWinOpen (origin) "org_loc" "is not one of GR_ORIGIN_*" fatal
        if !(0..=1).contains(origin);
    "grSstWinOpen": GrSstWinOpen (colors) "num_buffers" "is neither 2 nor 3" fatal
        if !(2..=3).contains(colors);
    "grSstWinOpen": GrSstWinOpen (aux) "num_aux_buffers" "is neither 0 nor 1" fatal
        if !(0..=1).contains(aux);
    "grSstWinOpen": GrSstWinOpen (colors, aux) "num_aux_buffers" "is not 0 beside three colour buffers" fatal
        if *colors == 3 && *aux == 1;
    "grSstWinOpen": GrSstWinOpen (resolution, colors, aux) "res" "does not fit the frame buffer with so many buffers" fatal
        if (2..=3).contains(colors) && (0..=1).contains(aux) && usize::try_from(*resolution)
            .is_ok_and(|r| r < RESOLUTIONS.len() && !at.card.holds(r, (colors + aux) as u32));
    "grSstOpen": GrSstOpen () "" "the library was not started" fatal
        if !at.started;
    "grSstOpen": GrSstOpen () "" "the board is open already" fatal
        if at.open().is_some() && !at.variables.ignore_reopen;
    "grSstOpen": GrSstOpen (resolution) "screen_resolution" "is not a resolution that a board can show" fatal
        if !(0..RESOLUTIONS.len() as i32).contains(resolution);
    "grSstOpen": GrSstOpen (refresh) "refresh_rate" "is not one of GR_REFRESH_*" fatal
        if !matches!(refresh, 0..=8 | 0xff);
    "grSstOpen": GrSstOpen (color_format) "color_format" "is not one of GR_COLORFORMAT_*" fatal
        if !(0..=3).contains(color_format);
    "grSstOpen": GrSstOpen (origin) "origin_location" "is not one of GR_ORIGIN_*" fatal
        if !(0..=1).contains(origin);
    "grSstOpen": GrSstOpen (smoothing) "smoothing_filter" "is not one of GR_SMOOTHING_*" fatal
        if !(0..=1).contains(smoothing);
    "grSstOpen": GrSstOpen (buffers) "num_buffers" "is neither 2 nor 3" fatal
        if !(2..=3).contains(buffers);
    "grSstOpen": GrSstOpen (resolution, buffers) "screen_resolution" "does not fit the frame buffer with so many buffers" fatal
        if (2..=3).contains(buffers) && usize::try_from(*resolution)
            .is_ok_and(|r| r < RESOLUTIONS.len() && !at.card.holds(r, *buffers as u32));
    "grSstOrigin": GrSstOrigin (origin) "origin" "is not one of GR_ORIGIN_*" fatal
        if !(0..=1).contains(origin);
    "grSstConfigPipeline": GrSstConfigPipeline (chip) "chip" "is not one of the board's chips" fatal
        if *chip != GR_FBI && !at.has_unit(*chip);
    "grSstConfigPipeline": GrSstConfigPipeline (register) "reg" "is not a register" fatal
        if !is_register(*register);
    "grHints": GrHints (hint) "type" "is not one of GR_HINT_*" fatal
        if !(0..=6).contains(hint);
    "grHints": GrHints (hint, mask) "hintMask" "has bits that are not one of GR_STWHINT_*" fatal
        if *hint == HINT_STW && mask & !0x7f != 0;
    "grBufferSwap": GrBufferSwap (interval) "swap_interval" "is outside 0..255" fatal
        if !(0..=255).contains(interval);
    "grRenderBuffer": GrRenderBuffer (buffer) "buffer" "is neither the front nor the back buffer" fatal
        if !(0..=1).contains(buffer);
    "grClipWindow": GrClipWindow (x0, x1) "minx" "is beyond maxx" fatal
        if x0 > x1;
    "grClipWindow": GrClipWindow (y0, y1) "miny" "is beyond maxy" fatal
        if y0 > y1;
    "grClipWindow": GrClipWindow (x1) "maxx" "is beyond the screen" warning
        if *x1 > at.size().0;
    "grClipWindow": GrClipWindow (y1) "maxy" "is beyond the screen" warning
        if *y1 > at.size().1;
    "grColorMask": GrColorMask (alpha) "alpha" "is on although depth is buffered" warning
        if *alpha != 0 && at.register(|b| b.fbi.fbz_mode, fbz::DEPTH_ENABLE);
    "grColorMask": GrColorMask (alpha) "alpha" "is on although there are three colour buffers" warning
        if *alpha != 0 && at.has_third_color();
    "grColorMask": GrColorMask (alpha) "alpha" "is on without an auxiliary buffer" warning
        if *alpha != 0 && at.open().is_some() && !at.has_aux() && !at.has_third_color();
    "grDepthMask": GrDepthMask (mask) "enable" "is on without an auxiliary buffer" warning
        if *mask != 0 && at.open().is_some() && !at.has_aux();
    "grLfbLock": GrLfbLock (kind) "type" "is neither a read nor a write lock" fatal
        if !is_lock(*kind);
    "grLfbLock": GrLfbLock (kind) "type" "is a lock that is held already" fatal
        if at.open().is_some_and(|b| match kind & 0xf {
            LFB_READ_ONLY => b.lfb.read.is_some(),
            _ => b.lfb.write.is_some(),
        });
    "grLfbLock": GrLfbLock (kind) "type" "is a read lock, which interleaved boards do not have" fatal
        if kind & 0xf == LFB_READ_ONLY && at.card.interleaved;
    "grLfbLock": GrLfbLock (buffer) "buffer" "is not one of the front, back and auxiliary buffers" fatal
        if !(0..=2).contains(buffer);
    "grLfbLock": GrLfbLock (buffer) "buffer" "is the auxiliary one, which was not opened" fatal
        if *buffer == BUFFER_AUX && at.open().is_some() && !at.has_aux();
    "grLfbLock": GrLfbLock (kind, mode) "writeMode" "is not one of GR_LFBWRITEMODE_*" fatal
        if kind & 0xf == LFB_WRITE_ONLY && !is_format(*mode) && *mode != LFBWRITEMODE_ANY;
    "grLfbLock": GrLfbLock (kind, buffer, mode) "writeMode" "does not fit the buffer" fatal
        if kind & 0xf == LFB_WRITE_ONLY && is_format(*mode) && !fits(*mode, *buffer);
    "grLfbLock": GrLfbLock (origin) "origin" "is not one of GR_ORIGIN_*" fatal
        if !matches!(origin, 0 | 1 | 0xff);
    "grLfbUnlock": GrLfbUnlock (kind, buffer) "type" "is not a lock that is held on this buffer" fatal
        if at.open().is_some_and(|b| {
            let lock = if kind & 0xf == LFB_WRITE_ONLY { &b.lfb.write } else { &b.lfb.read };
            !is_lock(*kind) || lock.as_ref().is_none_or(|lock| lock.buffer != *buffer)
        });
    "grLfbWriteColorFormat": GrLfbWriteColorFormat (format) "colorFormat" "is not one of GR_COLORFORMAT_*" fatal
        if !(0..=3).contains(format);
    "grLfbWriteMode": GrLfbWriteMode (mode) "mode" "is not one of GR_LFBWRITEMODE_*" fatal
        if !is_format(*mode) && *mode != LFBWRITEMODE_ANY;
    "grLfbOrigin": GrLfbOrigin (origin) "origin" "is not one of GR_ORIGIN_*" fatal
        if !(0..=1).contains(origin);
    "grLfbBypassMode": GrLfbBypassMode (mode) "mode" "is not one of GR_LFBBYPASS_*" fatal
        if !(0..=1).contains(mode);
    "grLfbWriteRegion": GrLfbWriteRegion (buffer) "dst_buffer" "is not one of the front, back and auxiliary buffers" fatal
        if !(0..=2).contains(buffer);
    "grLfbWriteRegion": GrLfbWriteRegion (format) "src_format" "is not one of GR_LFB_SRC_FMT_*" fatal
        if !is_format(*format) && *format != LFB_SRC_FMT_RLE16;
    "grLfbWriteRegion": GrLfbWriteRegion (format, buffer) "src_format" "does not fit the buffer" fatal
        if is_format(*format) && (0..=2).contains(buffer) && !fits(*format, *buffer);
    "grLfbWriteRegion": GrLfbWriteRegion (x, y, width, height) "dst_x" "is a region that reaches beyond the screen" warning
        if at.open().is_some()
            && (x.saturating_add(*width) > at.size().0 || y.saturating_add(*height) > at.size().1);
    "grLfbWriteRegion": GrLfbWriteRegion (stride, width) "src_stride" "is shorter than a row" warning
        if i64::from(*stride) < i64::from(*width) * 2;
}
