//! State setters.

use super::{invalid, put};
use crate::command::CommandSink;
use crate::error::{Result, VlRoutine};
use crate::format::PixFmt;
use crate::opcode::{Opcode, Register, SET_CURRENT_TEXTURE, TEXTURE_PALETTE};

#[inline]
fn set<S: CommandSink + ?Sized>(
    sink: &mut S,
    routine: VlRoutine,
    register: Register,
    value: u32,
) -> Result<()> {
    put(sink, routine, &[register.word(), value])
}

/// Declares setters: name, routine, register, and what values are allowed.
macro_rules! setters {
    ($($name:ident $routine:ident $register:ident $allowed:expr;)*) => {$(
        #[doc = concat!("`VL_", stringify!($routine), "`.")]
        ///
        /// # Errors
        /// [`crate::VlError::ParamError`] for a value that is none of the documented ones; those of
        /// the sink.
        pub fn $name<S: CommandSink + ?Sized>(sink: &mut S, value: u32) -> Result<()> {
            let routine = VlRoutine::$routine;
            let allowed: fn(u32) -> bool = $allowed;
            if !allowed(value) {
                return Err(invalid(routine));
            }
            set(sink, routine, Register::$register, value)
        }
    )*};
}

/// All values are allowed.
fn any(_: u32) -> bool {
    true
}

/// Disable or enable: everything but 0 enables.
fn flag(_: u32) -> bool {
    true
}

fn source_format(value: u32) -> bool {
    value == 0 || PixFmt::from_code(value).is_some()
}

fn destination_format(value: u32) -> bool {
    PixFmt::from_code(value).is_some_and(PixFmt::is_destination)
}

setters! {
    set_src_base SetSrcBase SrcBase any;
    set_src_fmt SetSrcFmt SrcFmt source_format;
    set_src_func SetSrcFunc SrcFunc |v| v <= 3;
    set_src_filter SetSrcFilter SrcFilter |v| v <= 1;
    set_src_color_no_pad SetSrcColorNoPad SrcColorNoPad flag;
    set_swap_uv SetSwapUV SwapUv flag;
    set_chroma_key SetChromaKey ChromaKey flag;
    set_z_scissor_enable SetZScissorEnable ZScissor flag;
    set_src_bgr SetSrcBGR SrcBgr flag;
    set_u_clamp SetUClamp UClamp flag;
    set_v_clamp SetVClamp VClamp flag;
    set_u_mask SetUMask UMask any;
    set_v_mask SetVMask VMask any;
    set_u_multiplier SetUMultiplier UMultiplier any;
    set_v_multiplier SetVMultiplier VMultiplier any;
    set_s_offset SetSOffset SOffset any;
    set_t_offset SetTOffset TOffset any;
    set_src_stride SetSrcStride SrcStride any;
    set_dst_stride SetDstStride DstStride any;
    set_z_stride SetZStride ZStride any;
    set_dst_base SetDstBase DstBase any;
    set_alu_mode SetALUMode AluMode |v| v <= 15;
    set_blend_src_func SetBlendSrcFunc BlendSrcFunc |v| v <= 9;
    set_blend_dst_func SetBlendDstFunc BlendDstFunc |v| v <= 7;
    set_z_buf_mode SetZBufMode ZBufMode |v| v <= 6;
    set_z_buf_wr_mode SetZBufWrMode ZBufWrMode flag;
    set_yuv2rgb SetYUV2RGB Yuv2Rgb flag;
    set_blend_enable SetBlendEnable BlendEnable flag;
    set_dither_enable SetDitherEnable DitherEnable flag;
    set_fog_enable SetFogEnable FogEnable flag;
    set_dst_rd_disable SetDstRdDisable DstRdDisable flag;
    set_dst_bgr SetDstBGR DstBgr flag;
    set_transp_reject SetTranspReject TranspReject flag;
    set_dst_fmt SetDstFmt DstFmt destination_format;
    set_p_mask SetPMask PMask any;
    set_pat SetPat Pat any;
    set_pat_enable SetPatEnable PatEnable flag;
    set_pat_opaque SetPatOpaque PatOpaque flag;
    set_pat_offset SetPatOffset PatOffset any;
    set_scissor_x SetScissorX ScissorX any;
    set_scissor_y SetScissorY ScissorY any;
    set_z_base SetZBase ZBase any;
    set_dither_offset SetDitherOffset DitherOffset any;
    set_fg_color_argb SetFGColorARGB FgColorArgb any;
    set_bg_color_argb SetBGColorARGB BgColorArgb any;
    set_fog_color_rgb SetFogColorRGB FogColorRgb any;
    set_dst_color_argb SetDstColorARGB DstColorArgb any;
    set_z SetZ Z any;
    set_r SetR R any;
    set_g SetG G any;
    set_b SetB B any;
    set_a SetA A any;
    set_f SetF F any;
    set_u SetU U any;
    set_v SetV V any;
    set_specular_enable SetSpecularEnable SpecularEnable flag;
    set_specular_color_rgb SetSpecularColorRGB SpecularColorRgb any;
}

/// Exchanges red and blue of a packed colour.
fn swap(color: u32) -> u32 {
    color & 0xff00_ff00 | color >> 16 & 0xff | (color & 0xff) << 16
}

/// Declares setters that take blue first: name, routine, register.
macro_rules! swapped {
    ($($name:ident $routine:ident $register:ident;)*) => {$(
        #[doc = concat!("`VL_", stringify!($routine), "`: blue in bits 23..16, red in 7..0.")]
        ///
        /// # Errors
        /// Those of the sink.
        pub fn $name<S: CommandSink + ?Sized>(sink: &mut S, value: u32) -> Result<()> {
            set(sink, VlRoutine::$routine, Register::$register, swap(value))
        }
    )*};
}

swapped! {
    set_fg_color_abgr SetFGColorABGR FgColorArgb;
    set_bg_color_abgr SetBGColorABGR BgColorArgb;
    set_fog_color_bgr SetFogColorBGR FogColorRgb;
    set_dst_color_abgr SetDstColorABGR DstColorArgb;
    set_specular_color_bgr SetSpecularColorBGR SpecularColorRgb;
}

/// `VL_SetPatLength`: 1 to 32 bits.
///
/// # Errors
/// [`crate::VlError::ParamError`] for other lengths; those of the sink.
pub fn set_pat_length<S: CommandSink + ?Sized>(sink: &mut S, length: u32) -> Result<()> {
    let routine = VlRoutine::SetPatLength;
    match length {
        1..=32 => set(sink, routine, Register::PatLengthM1, length - 1),
        _ => Err(invalid(routine)),
    }
}

/// `VL_SetAlphaThreshold`.
///
/// # Errors
/// Those of the sink.
pub fn set_alpha_threshold<S: CommandSink + ?Sized>(sink: &mut S, threshold: u8) -> Result<()> {
    set(sink, VlRoutine::SetAlphaThreshold, Register::AlphaThreshold, threshold.into())
}

/// `VL_SetChromaColor`: a key in the layout of `pixel_fmt`.
///
/// # Errors
/// [`crate::VlError::BadPixFmt`]; those of the sink.
pub fn set_chroma_color<S: CommandSink + ?Sized>(
    sink: &mut S,
    value: u32,
    pixel_fmt: u32,
) -> Result<()> {
    chroma(sink, VlRoutine::SetChromaColor, Register::ChromaColor, value, pixel_fmt)
}

/// `VL_SetChromaMask`: which bits of the key count.
///
/// # Errors
/// [`crate::VlError::BadPixFmt`]; those of the sink.
pub fn set_chroma_mask<S: CommandSink + ?Sized>(
    sink: &mut S,
    value: u32,
    pixel_fmt: u32,
) -> Result<()> {
    chroma(sink, VlRoutine::SetChromaMask, Register::ChromaMask, value, pixel_fmt)
}

/// The register holds what is compared with the pixel's own bits.
fn chroma<S: CommandSink + ?Sized>(
    sink: &mut S,
    routine: VlRoutine,
    register: Register,
    value: u32,
    pixel_fmt: u32,
) -> Result<()> {
    let bad = crate::Failure::vl(routine, crate::VlError::BadPixFmt);
    let format = PixFmt::from_code(pixel_fmt).ok_or(bad)?;
    set(sink, routine, register, value & format.full_mask())
}

/// `VL_SetCurrentTexture`: base and stride code of the source, masks and
/// multipliers. V's mask comes before U's, as in C.
///
/// # Errors
/// Those of the sink.
pub fn set_current_texture<S: CommandSink + ?Sized>(
    sink: &mut S,
    base: u32,
    stride: u32,
    v_mask: u16,
    u_mask: u16,
    multipliers: [u32; 2],
) -> Result<()> {
    let masks = u32::from(v_mask) << 16 | u32::from(u_mask);
    let [u, v] = multipliers;
    let words = [SET_CURRENT_TEXTURE, base, stride, masks, u, v];
    put(sink, VlRoutine::SetCurrentTexture, &words)
}

/// `VL_SetTexturePalette`: `entries` (0xAARRGGBB) from entry `start` on, in the
/// layout of a 4-bit format's palette. Entries that are not given become 0.
///
/// # Errors
/// [`crate::VlError::BadPixFmt`] for other formats, [`crate::VlError::ParamError`] for entries beyond
/// the 16; those of the sink.
pub fn set_texture_palette<S: CommandSink + ?Sized>(
    sink: &mut S,
    start: u32,
    entries: &[u32],
    pixel_fmt: u32,
) -> Result<()> {
    let routine = VlRoutine::SetTexturePalette;
    let bad = crate::Failure::vl(routine, crate::VlError::BadPixFmt);
    let entry = PixFmt::from_code(pixel_fmt).and_then(PixFmt::palette_entry).ok_or(bad)?;
    let start = usize::try_from(start).unwrap_or(usize::MAX);
    let mut palette = [0; 16];
    let end = start.saturating_add(entries.len());
    let place = palette.get_mut(start..end).ok_or(invalid(routine))?;
    for (place, &argb) in place.iter_mut().zip(entries) {
        *place = crate::format::pack(entry, argb);
    }
    let mut words = [TEXTURE_PALETTE; 9];
    for (word, two) in words[1..].iter_mut().zip(palette.as_chunks::<2>().0) {
        *word = two[0] << 16 | two[1];
    }
    put(sink, routine, &words)
}

/// `VL_SetPalette`: colours 0x00RRGGBB of the display's palette from `start` on.
///
/// # Errors
/// [`crate::VlError::ParamError`] for entries beyond the 256; those of the sink.
pub fn set_palette<S: CommandSink + ?Sized>(
    sink: &mut S,
    start: u16,
    entries: &[u32],
) -> Result<()> {
    let routine = VlRoutine::SetPalette;
    if usize::from(start) + entries.len() > 256 {
        return Err(invalid(routine));
    }
    let out = sink.reserve(3 + entries.len(), 0).map_err(|e| super::unadded(routine, e))?;
    let head = [Opcode::Palette as u32, u32::from(start), entries.len() as u32];
    out[..3].copy_from_slice(&head);
    out[3..].copy_from_slice(entries);
    Ok(())
}

/// `VL_ContextInit`: all state to its defaults.
///
/// # Errors
/// Those of the sink.
pub fn context_init<S: CommandSink + ?Sized>(sink: &mut S) -> Result<()> {
    put(sink, VlRoutine::ContextInit, &[Opcode::ContextInit as u32])
}

/// `VL_SetDisplayBase`: shows another address.
///
/// # Errors
/// Those of the sink.
pub fn set_display_base<S: CommandSink + ?Sized>(sink: &mut S, address: u32) -> Result<()> {
    put(sink, VlRoutine::SetDisplayBase, &[Opcode::Display as u32, address])
}

/// `VL_SetStereoDisplayBase`: shows two addresses, even and odd lines.
///
/// # Errors
/// Those of the sink.
pub fn set_stereo_display_base<S: CommandSink + ?Sized>(
    sink: &mut S,
    even: u32,
    odd: u32,
) -> Result<()> {
    put(sink, VlRoutine::SetStereoDisplayBase, &[Opcode::StereoDisplay as u32, odd, even])
}

/// `VL_WaitForDisplaySwitch`: waits until the last address is shown.
///
/// # Errors
/// Those of the sink.
pub fn wait_for_display_switch<S: CommandSink + ?Sized>(sink: &mut S) -> Result<()> {
    put(sink, VlRoutine::WaitForDisplaySwitch, &[Opcode::WaitDisplaySwitch as u32])
}

/// `VL_FrameMarker`: a number for whoever reads the stream.
///
/// # Errors
/// Those of the sink.
pub fn frame_marker<S: CommandSink + ?Sized>(sink: &mut S, frame: i32) -> Result<()> {
    let words = [crate::opcode::FRAME_MARKER, crate::opcode::FRAME_MARKER_PATTERN, frame as u32];
    put(sink, VlRoutine::FrameMarker, &words)
}
