//! Installing surfaces as destination, depth buffer and texture.

use super::{
    invalid, put, set_chroma_color, set_chroma_key, set_chroma_mask, set_current_texture,
    set_src_bgr, set_src_color_no_pad, set_src_fmt, set_texture_palette, set_u_clamp, set_u_mask,
    set_v_clamp, set_v_mask, set_yuv2rgb,
};
use crate::command::CommandSink;
use crate::error::{Failure, Result, VlError, VlRoutine};
use crate::format::PixFmt;
use crate::opcode::{Opcode, Register};
use crate::surface::{BufferGroup, PRIMARY, Surface, UCLAMP, VCLAMP};

fn registers<S: CommandSink + ?Sized, const N: usize>(
    sink: &mut S,
    routine: VlRoutine,
    values: [(Register, u32); N],
) -> Result<()> {
    let out = sink.reserve(2 * N, 0).map_err(|error| super::unadded(routine, error))?;
    for (out, (register, value)) in out.as_chunks_mut().0.iter_mut().zip(values) {
        *out = [register.word(), value];
    }
    Ok(())
}

/// `VL_InstallDstBuffer`: draws into the back buffer, or buffer 0 where there
/// is none. Sets base, stride, format, channel order and the scissor.
///
/// # Errors
/// [`VlError::BadPixFmt`] for formats that cannot be drawn into; those of the
/// sink.
pub fn install_dst_buffer<S: CommandSink + ?Sized>(
    sink: &mut S,
    surface: &Surface,
    group: &BufferGroup,
) -> Result<()> {
    let routine = VlRoutine::InstallDstBuffer;
    if !group.format.is_destination() {
        return Err(Failure::vl(routine, VlError::BadPixFmt));
    }
    let base = group.address(group.drawing_buffer()).ok_or(invalid(routine))?;
    registers(
        sink,
        routine,
        [
            (Register::DstBase, base),
            (Register::DstStride, group.stride),
            (Register::DstFmt, group.format.code()),
            (Register::DstBgr, u32::from(surface.bgr != 0)),
            (Register::ScissorX, group.width & 0xffff),
            (Register::ScissorY, group.height & 0xffff),
        ],
    )
}

/// `VL_InstallZBuffer`: depth base and stride.
///
/// # Errors
/// [`VlError::ParamError`] where the surface has no depth buffer; those of the
/// sink.
pub fn install_z_buffer<S: CommandSink + ?Sized>(sink: &mut S, group: &BufferGroup) -> Result<()> {
    let routine = VlRoutine::InstallZBuffer;
    let base = group.z_buffer().and_then(|buffer| group.address(buffer)).ok_or(invalid(routine))?;
    registers(sink, routine, [(Register::ZBase, base), (Register::ZStride, group.stride)])
}

/// The clamp flags, masks, address and multipliers, in the documented order.
fn install_texture<S: CommandSink + ?Sized>(
    sink: &mut S,
    routine: VlRoutine,
    surface: &Surface,
    group: &BufferGroup,
) -> Result<()> {
    let base = group.address(0).ok_or(invalid(routine))?;
    let [v_mask, u_mask] = surface.masks();
    set_u_clamp(sink, u32::from(surface.clamp & UCLAMP != 0))?;
    set_u_mask(sink, u_mask)?;
    set_v_clamp(sink, u32::from(surface.clamp & VCLAMP != 0))?;
    set_v_mask(sink, v_mask)?;
    let multipliers = [surface.width << 16, surface.height << 16];
    set_current_texture(sink, base, group.stride, v_mask as u16, u_mask as u16, multipliers)
}

/// `VL_InstallTextureMap`: buffer 0 as texture, with all that the surface says.
/// Filter, offsets, source function, fog, blending and depth are left alone.
///
/// # Errors
/// [`VlError::BadPixFmt`]; those of the sink.
pub fn install_texture_map<S: CommandSink + ?Sized>(
    sink: &mut S,
    surface: &Surface,
    group: &BufferGroup,
) -> Result<()> {
    let routine = VlRoutine::InstallTextureMap;
    let bad = Failure::vl(routine, VlError::BadPixFmt);
    let format = PixFmt::from_code(surface.pixel_fmt).ok_or(bad)?;
    install_texture(sink, routine, surface, group)?;
    if let (Some(palette), Some(_)) = (&surface.palette, format.palette_entry()) {
        let start = surface.start_index.min(16);
        let end = start.saturating_add(surface.num_entries).min(16);
        let entries = &palette[start as usize..end as usize];
        set_texture_palette(sink, start, entries, surface.pixel_fmt)?;
    }
    set_src_fmt(sink, surface.pixel_fmt)?;
    set_src_color_no_pad(sink, u32::from(surface.color_pad == 0))?;
    set_chroma_key(sink, u32::from(surface.chromakey != 0))?;
    set_yuv2rgb(sink, u32::from(format == PixFmt::Yuv422))?;
    set_src_bgr(sink, u32::from(surface.bgr != 0))?;
    set_chroma_color(sink, surface.chroma_color, surface.pixel_fmt)?;
    set_chroma_mask(sink, surface.chroma_mask, surface.pixel_fmt)
}

/// `VL_InstallTextureMapBasic`: address, masks, multipliers and clamp flags
/// only.
///
/// # Errors
/// Those of the sink.
pub fn install_texture_map_basic<S: CommandSink + ?Sized>(
    sink: &mut S,
    surface: &Surface,
    group: &BufferGroup,
) -> Result<()> {
    install_texture(sink, VlRoutine::InstallTextureMapBasic, surface, group)
}

/// The commands of `VL_SwapDisplaySurface`: shows what is the back buffer now,
/// and draws into what is the front buffer now.
///
/// The caller then exchanges buffers 0 and 1 with [`crate::Call::SwapBuffers`].
///
/// # Errors
/// [`VlError::RequiresBackBuffer`], [`VlError::FullScreenModeOnly`] where the
/// front buffer is a desktop; those of the sink.
pub fn swap_display_surface<S: CommandSink + ?Sized>(
    sink: &mut S,
    group: &BufferGroup,
) -> Result<()> {
    let routine = VlRoutine::SwapDisplaySurface;
    if group.mask & PRIMARY == 0 {
        return Err(invalid(routine));
    }
    if !group.has_back_buffer() {
        return Err(Failure::vl(routine, VlError::RequiresBackBuffer));
    }
    if group.on_desktop {
        let lower =
            Failure::v(crate::VRoutine::SwapBuffers, crate::VError::CannotSwapWindowedSurfaces);
        return Err(lower.then(routine, VlError::FullScreenModeOnly));
    }
    let [front, back] = [group.addresses[0], group.addresses[1]];
    let words = [Opcode::Display as u32, back, Register::DstBase.word(), front];
    put(sink, routine, &words)
}
