//! State setters of the upper layer.

use std::ffi::c_int;

use fillrate_redline::{Failure, VlError, VlRoutine, record};

use crate::draw::words;
use crate::handle::Opaque;
use crate::sink::recorded;

/// Declares setters of one word: C name, name, routine, function.
macro_rules! setters {
    ($($c:literal $name:ident $routine:ident $record:ident;)*) => {$(
        #[doc = concat!("Records `", stringify!($name), "`.")]
        ///
        /// # Safety
        /// `cmdbuffer` is null or points to a handle.
        #[unsafe(export_name = $c)]
        pub unsafe extern "C" fn $name(cmdbuffer: *mut Opaque, value: u32) -> c_int {
            // SAFETY: the caller's promise.
            unsafe {
                recorded(cmdbuffer, VlRoutine::$routine, |sink| record::$record(sink, value))
            }
        }
    )*};
}

setters! {
    "redline_SetSrcBase" VL_SetSrcBase SetSrcBase set_src_base;
    "redline_SetSrcFmt" VL_SetSrcFmt SetSrcFmt set_src_fmt;
    "redline_SetSrcFunc" VL_SetSrcFunc SetSrcFunc set_src_func;
    "redline_SetSrcFilter" VL_SetSrcFilter SetSrcFilter set_src_filter;
    "redline_SetSrcColorNoPad" VL_SetSrcColorNoPad SetSrcColorNoPad set_src_color_no_pad;
    "redline_SetSwapUV" VL_SetSwapUV SetSwapUV set_swap_uv;
    "redline_SetChromaKey" VL_SetChromaKey SetChromaKey set_chroma_key;
    "redline_SetZScissorEnable" VL_SetZScissorEnable SetZScissorEnable set_z_scissor_enable;
    "redline_SetSrcBGR" VL_SetSrcBGR SetSrcBGR set_src_bgr;
    "redline_SetUClamp" VL_SetUClamp SetUClamp set_u_clamp;
    "redline_SetVClamp" VL_SetVClamp SetVClamp set_v_clamp;
    "redline_SetUMask" VL_SetUMask SetUMask set_u_mask;
    "redline_SetVMask" VL_SetVMask SetVMask set_v_mask;
    "redline_SetUMultiplier" VL_SetUMultiplier SetUMultiplier set_u_multiplier;
    "redline_SetVMultiplier" VL_SetVMultiplier SetVMultiplier set_v_multiplier;
    "redline_SetSOffset" VL_SetSOffset SetSOffset set_s_offset;
    "redline_SetTOffset" VL_SetTOffset SetTOffset set_t_offset;
    "redline_SetSrcStride" VL_SetSrcStride SetSrcStride set_src_stride;
    "redline_SetDstStride" VL_SetDstStride SetDstStride set_dst_stride;
    "redline_SetZStride" VL_SetZStride SetZStride set_z_stride;
    "redline_SetDstBase" VL_SetDstBase SetDstBase set_dst_base;
    "redline_SetALUMode" VL_SetALUMode SetALUMode set_alu_mode;
    "redline_SetBlendSrcFunc" VL_SetBlendSrcFunc SetBlendSrcFunc set_blend_src_func;
    "redline_SetBlendDstFunc" VL_SetBlendDstFunc SetBlendDstFunc set_blend_dst_func;
    "redline_SetZBufMode" VL_SetZBufMode SetZBufMode set_z_buf_mode;
    "redline_SetZBufWrMode" VL_SetZBufWrMode SetZBufWrMode set_z_buf_wr_mode;
    "redline_SetYUV2RGB" VL_SetYUV2RGB SetYUV2RGB set_yuv2rgb;
    "redline_SetBlendEnable" VL_SetBlendEnable SetBlendEnable set_blend_enable;
    "redline_SetDitherEnable" VL_SetDitherEnable SetDitherEnable set_dither_enable;
    "redline_SetFogEnable" VL_SetFogEnable SetFogEnable set_fog_enable;
    "redline_SetDstRdDisable" VL_SetDstRdDisable SetDstRdDisable set_dst_rd_disable;
    "redline_SetDstBGR" VL_SetDstBGR SetDstBGR set_dst_bgr;
    "redline_SetTranspReject" VL_SetTranspReject SetTranspReject set_transp_reject;
    "redline_SetDstFmt" VL_SetDstFmt SetDstFmt set_dst_fmt;
    "redline_SetPMask" VL_SetPMask SetPMask set_p_mask;
    "redline_SetPat" VL_SetPat SetPat set_pat;
    "redline_SetPatLength" VL_SetPatLength SetPatLength set_pat_length;
    "redline_SetPatEnable" VL_SetPatEnable SetPatEnable set_pat_enable;
    "redline_SetPatOpaque" VL_SetPatOpaque SetPatOpaque set_pat_opaque;
    "redline_SetPatOffset" VL_SetPatOffset SetPatOffset set_pat_offset;
    "redline_SetScissorX" VL_SetScissorX SetScissorX set_scissor_x;
    "redline_SetScissorY" VL_SetScissorY SetScissorY set_scissor_y;
    "redline_SetZBase" VL_SetZBase SetZBase set_z_base;
    "redline_SetDitherOffset" VL_SetDitherOffset SetDitherOffset set_dither_offset;
    "redline_SetFGColorABGR" VL_SetFGColorABGR SetFGColorABGR set_fg_color_abgr;
    "redline_SetFGColorARGB" VL_SetFGColorARGB SetFGColorARGB set_fg_color_argb;
    "redline_SetBGColorABGR" VL_SetBGColorABGR SetBGColorABGR set_bg_color_abgr;
    "redline_SetBGColorARGB" VL_SetBGColorARGB SetBGColorARGB set_bg_color_argb;
    "redline_SetFogColorBGR" VL_SetFogColorBGR SetFogColorBGR set_fog_color_bgr;
    "redline_SetFogColorRGB" VL_SetFogColorRGB SetFogColorRGB set_fog_color_rgb;
    "redline_SetDstColorABGR" VL_SetDstColorABGR SetDstColorABGR set_dst_color_abgr;
    "redline_SetDstColorARGB" VL_SetDstColorARGB SetDstColorARGB set_dst_color_argb;
    "redline_SetZ" VL_SetZ SetZ set_z;
    "redline_SetR" VL_SetR SetR set_r;
    "redline_SetG" VL_SetG SetG set_g;
    "redline_SetB" VL_SetB SetB set_b;
    "redline_SetA" VL_SetA SetA set_a;
    "redline_SetF" VL_SetF SetF set_f;
    "redline_SetU" VL_SetU SetU set_u;
    "redline_SetV" VL_SetV SetV set_v;
    "redline_SetDisplayBase" VL_SetDisplayBase SetDisplayBase set_display_base;
}

/// Records the least alpha that is drawn.
///
/// # Safety
/// `cmdbuffer` is null or points to a handle.
#[unsafe(export_name = "redline_SetAlphaThreshold")]
pub unsafe extern "C" fn VL_SetAlphaThreshold(cmdbuffer: *mut Opaque, threshold: u8) -> c_int {
    // SAFETY: the caller's promise.
    unsafe {
        recorded(cmdbuffer, VlRoutine::SetAlphaThreshold, |sink| {
            record::set_alpha_threshold(sink, threshold)
        })
    }
}

/// Records the key of texels that are left out.
///
/// # Safety
/// `cmdbuffer` is null or points to a handle.
#[unsafe(export_name = "redline_SetChromaColor")]
pub unsafe extern "C" fn VL_SetChromaColor(
    cmdbuffer: *mut Opaque,
    color: u32,
    pixel_fmt: u32,
) -> c_int {
    // SAFETY: the caller's promise.
    unsafe {
        recorded(cmdbuffer, VlRoutine::SetChromaColor, |sink| {
            record::set_chroma_color(sink, color, pixel_fmt)
        })
    }
}

/// Records which bits of the key count.
///
/// # Safety
/// `cmdbuffer` is null or points to a handle.
#[unsafe(export_name = "redline_SetChromaMask")]
pub unsafe extern "C" fn VL_SetChromaMask(
    cmdbuffer: *mut Opaque,
    mask: u32,
    pixel_fmt: u32,
) -> c_int {
    // SAFETY: the caller's promise.
    unsafe {
        recorded(cmdbuffer, VlRoutine::SetChromaMask, |sink| {
            record::set_chroma_mask(sink, mask, pixel_fmt)
        })
    }
}

/// Records where the texture is; V's mask comes before U's.
///
/// # Safety
/// `cmdbuffer` is null or points to a handle.
#[unsafe(export_name = "redline_SetCurrentTexture")]
pub unsafe extern "C" fn VL_SetCurrentTexture(
    cmdbuffer: *mut Opaque,
    base: u32,
    stride: u32,
    v_mask: u16,
    u_mask: u16,
    u_multiplier: u32,
    v_multiplier: u32,
) -> c_int {
    // SAFETY: the caller's promise.
    unsafe {
        recorded(cmdbuffer, VlRoutine::SetCurrentTexture, |sink| {
            let multipliers = [u_multiplier, v_multiplier];
            record::set_current_texture(sink, base, stride, v_mask, u_mask, multipliers)
        })
    }
}

/// Records two addresses to show, line by line.
///
/// # Safety
/// `cmdbuffer` is null or points to a handle.
#[unsafe(export_name = "redline_SetStereoDisplayBase")]
pub unsafe extern "C" fn VL_SetStereoDisplayBase(
    cmdbuffer: *mut Opaque,
    even: u32,
    odd: u32,
) -> c_int {
    // SAFETY: the caller's promise.
    unsafe {
        recorded(cmdbuffer, VlRoutine::SetStereoDisplayBase, |sink| {
            record::set_stereo_display_base(sink, even, odd)
        })
    }
}

/// Entries of a palette, or an error for null.
///
/// # Safety
/// `entries` is null or points to `count` words.
unsafe fn palette<'a>(
    routine: VlRoutine,
    entries: *const u32,
    count: u16,
) -> fillrate_redline::Result<&'a [u32]> {
    // SAFETY: the caller's promise.
    let found = unsafe { words(entries, count.into()) };
    match found.len() == usize::from(count) {
        true => Ok(found),
        false => Err(Failure::vl(routine, VlError::ParamError)),
    }
}

/// Records entries of the display's palette.
///
/// # Safety
/// `cmdbuffer` is null or points to a handle; `entries` is null or points to
/// `count` words.
#[unsafe(export_name = "redline_SetPalette")]
pub unsafe extern "C" fn VL_SetPalette(
    cmdbuffer: *mut Opaque,
    start: u16,
    count: u16,
    entries: *const u32,
) -> c_int {
    let routine = VlRoutine::SetPalette;
    // SAFETY: the caller's promise.
    unsafe {
        recorded(cmdbuffer, routine, |sink| {
            record::set_palette(sink, start, palette(routine, entries, count)?)
        })
    }
}

/// Records entries of the palette of 4-bit textures.
///
/// # Safety
/// `cmdbuffer` is null or points to a handle; `entries` is null or points to
/// `count` words.
#[unsafe(export_name = "redline_SetTexturePalette")]
pub unsafe extern "C" fn VL_SetTexturePalette(
    cmdbuffer: *mut Opaque,
    start: u16,
    count: u16,
    entries: *const u32,
    pixel_fmt: u32,
) -> c_int {
    let routine = VlRoutine::SetTexturePalette;
    // SAFETY: the caller's promise.
    unsafe {
        recorded(cmdbuffer, routine, |sink| {
            let entries = palette(routine, entries, count)?;
            record::set_texture_palette(sink, start.into(), entries, pixel_fmt)
        })
    }
}

/// Records that all state becomes what it was at the start.
///
/// # Safety
/// `cmdbuffer` is null or points to a handle.
#[unsafe(export_name = "redline_ContextInit")]
pub unsafe extern "C" fn VL_ContextInit(cmdbuffer: *mut Opaque) -> c_int {
    // SAFETY: the caller's promise.
    unsafe { recorded(cmdbuffer, VlRoutine::ContextInit, record::context_init) }
}

/// Records a wait until the last flip is seen.
///
/// # Safety
/// `cmdbuffer` is null or points to a handle.
#[unsafe(export_name = "redline_WaitForDisplaySwitch")]
pub unsafe extern "C" fn VL_WaitForDisplaySwitch(cmdbuffer: *mut Opaque) -> c_int {
    let routine = VlRoutine::WaitForDisplaySwitch;
    // SAFETY: the caller's promise.
    unsafe { recorded(cmdbuffer, routine, record::wait_for_display_switch) }
}

/// Records a number for whoever reads the stream.
///
/// # Safety
/// `cmdbuffer` is null or points to a handle.
#[unsafe(export_name = "redline_FrameMarker")]
pub unsafe extern "C" fn VL_FrameMarker(cmdbuffer: *mut Opaque, frame: c_int) -> c_int {
    // SAFETY: the caller's promise.
    unsafe { recorded(cmdbuffer, VlRoutine::FrameMarker, |sink| record::frame_marker(sink, frame)) }
}
