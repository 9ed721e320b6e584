//! State of the pixel pipeline, and buffers.

use fillrate_glide::Call;
use fillrate_guard::{guard, read};

use crate::library::calls;
use crate::session::{ask, call, null};

calls! {
    /// Fills the clip window.
    grBufferClear(color: u32, alpha: u8, depth: u16) = Call::GrBufferClear { color, alpha, depth };
    /// Shows the back buffer.
    grBufferSwap(interval: i32) = Call::GrBufferSwap { interval };
    /// Chooses the buffer to draw into.
    grRenderBuffer(buffer: i32) = Call::GrRenderBuffer { buffer };
    /// Sets the clip window.
    grClipWindow(x0: u32, y0: u32, x1: u32, y1: u32) = Call::GrClipWindow { x0, y0, x1, y1 };
    /// Sets the colour and alpha masks.
    grColorMask(rgb: i32, alpha: i32) = Call::GrColorMask { rgb, alpha };
    /// Sets the depth mask.
    grDepthMask(mask: i32) = Call::GrDepthMask { mask };
    /// Sets the blend factors.
    grAlphaBlendFunction(
        rgb_source: i32, rgb_destination: i32, alpha_source: i32, alpha_destination: i32
    ) = Call::GrAlphaBlendFunction {
        rgb_source, rgb_destination, alpha_source, alpha_destination
    };
    /// Sets the alpha combine unit.
    grAlphaCombine(function: i32, factor: i32, local: i32, other: i32, invert: i32) =
        Call::GrAlphaCombine { function, factor, local, other, invert };
    /// Lets texture alpha choose the local colour.
    grAlphaControlsITRGBLighting(enable: i32) = Call::GrAlphaControlsItrgbLighting { enable };
    /// Sets the alpha test.
    grAlphaTestFunction(function: i32) = Call::GrAlphaTestFunction { function };
    /// Sets the alpha test's reference.
    grAlphaTestReferenceValue(value: u8) = Call::GrAlphaTestReferenceValue { value };
    /// Switches the chroma key.
    grChromakeyMode(mode: i32) = Call::GrChromakeyMode { mode };
    /// Sets the chroma key.
    grChromakeyValue(value: u32) = Call::GrChromakeyValue { value };
    /// Sets the colour combine unit.
    grColorCombine(function: i32, factor: i32, local: i32, other: i32, invert: i32) =
        Call::GrColorCombine { function, factor, local, other, invert };
    /// Sets the constant colour.
    grConstantColorValue(value: u32) = Call::GrConstantColorValue { value };
    /// Sets the delta-0 colour.
    grConstantColorValue4(a: f32, r: f32, g: f32, b: f32) =
        Call::GrConstantColorValue4 { a, r, g, b };
    /// Sets culling.
    grCullMode(mode: i32) = Call::GrCullMode { mode };
    /// Sets the depth bias.
    grDepthBiasLevel(level: i16) = Call::GrDepthBiasLevel { level };
    /// Sets the depth comparison.
    grDepthBufferFunction(function: i32) = Call::GrDepthBufferFunction { function };
    /// Sets depth buffering.
    grDepthBufferMode(mode: i32) = Call::GrDepthBufferMode { mode };
    /// Switches effects off.
    grDisableAllEffects() = Call::GrDisableAllEffects {};
    /// Sets dithering.
    grDitherMode(mode: i32) = Call::GrDitherMode { mode };
    /// Sets the fog colour.
    grFogColorValue(color: u32) = Call::GrFogColorValue { color };
    /// Sets fog.
    grFogMode(mode: i32) = Call::GrFogMode { mode };
    /// Sets gamma.
    grGammaCorrectionValue(value: f32) = Call::GrGammaCorrectionValue { value };
    /// Sets the colour combine unit by a preset.
    guColorCombineFunction(function: i32) = Call::GuColorCombineFunction { function };
    /// Sets the alpha combine unit by a preset.
    guAlphaSource(mode: i32) = Call::GuAlphaSource { mode };
}

/// Sets the fog table; null is ignored.
///
/// # Safety
/// `table` is null or points to 64 bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn grFogTable(table: *const [u8; 64]) {
    guard((), || {
        // SAFETY: the caller gives 64 entries.
        let Some(table) = (unsafe { read(table) }) else { return null("grFogTable") };
        call(Call::GrFogTable { table });
    })
}

/// Swaps that wait for their retrace.
#[unsafe(no_mangle)]
pub extern "C" fn grBufferNumPending() -> i32 {
    guard(0, || ask(|context| context.pending_swaps()) as i32)
}
