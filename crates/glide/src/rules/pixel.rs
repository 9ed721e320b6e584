//! Rules of the pixel pipeline's state.

use super::{Rule, Situation, rules};
use crate::call::Call;
use crate::enums::*;
use crate::registers::fbz;

fn is_function(function: i32) -> bool {
    matches!(function, 0..=9 | 0x10)
}

fn is_factor(factor: i32) -> bool {
    matches!(factor, 0..=5 | 8..=0xd)
}

fn is_blend_factor(factor: i32) -> bool {
    matches!(factor, 0..=7 | 0xf)
}

fn is_zero_or_one(factor: i32) -> bool {
    matches!(factor, BLEND_ZERO | BLEND_ONE)
}

/// A factor that reads destination alpha where none is kept.
fn lacks_alpha(at: &Situation<'_>, factor: i32) -> bool {
    let depth = at.register(|b| b.fbi.fbz_mode, fbz::DEPTH_ENABLE);
    matches!(factor, 3 | 7) && at.open().is_some() && (depth || !at.has_aux())
}

fn is_color(value: f32) -> bool {
    (0.0..=255.0).contains(&value)
}

rules! { at;
    "grDepthBufferMode": GrDepthBufferMode (mode) "mode" "is not one of GR_DEPTHBUFFER_*" fatal
        if !(0..=4).contains(mode);
    "grDepthBufferMode": GrDepthBufferMode (mode) "mode" "needs an auxiliary buffer" fatal
        if *mode != 0 && at.open().is_some() && !at.has_aux();
    "grDepthBufferMode": GrDepthBufferMode (mode) "mode" "is on although alpha is buffered" warning
        if *mode != 0 && at.register(|b| b.fbi.fbz_mode, fbz::ALPHA_PLANES);
    "grDepthBufferFunction": GrDepthBufferFunction (function) "func" "is not one of GR_CMP_*" fatal
        if !(0..=7).contains(function);
    "grAlphaBlendFunction": GrAlphaBlendFunction (rgb_source) "rgb_sf" "is not one of GR_BLEND_*" fatal
        if !is_blend_factor(*rgb_source);
    "grAlphaBlendFunction": GrAlphaBlendFunction (rgb_destination) "rgb_df" "is not one of GR_BLEND_*" fatal
        if !is_blend_factor(*rgb_destination);
    "grAlphaBlendFunction": GrAlphaBlendFunction (alpha_source) "alpha_sf" "is neither zero nor one" warning
        if !is_zero_or_one(*alpha_source);
    "grAlphaBlendFunction": GrAlphaBlendFunction (alpha_destination) "alpha_df" "is neither zero nor one" warning
        if !is_zero_or_one(*alpha_destination);
    "grAlphaBlendFunction": GrAlphaBlendFunction (rgb_source) "rgb_sf" "reads alpha, which is not buffered" warning
        if lacks_alpha(at, *rgb_source);
    "grAlphaBlendFunction": GrAlphaBlendFunction (rgb_destination) "rgb_df" "reads alpha, which is not buffered" warning
        if lacks_alpha(at, *rgb_destination);
    "grAlphaCombine": GrAlphaCombine (function) "function" "is not one of GR_COMBINE_FUNCTION_*" fatal
        if !is_function(*function);
    "grAlphaCombine": GrAlphaCombine (factor) "factor" "is not one of GR_COMBINE_FACTOR_*" fatal
        if !is_factor(*factor);
    "grAlphaCombine": GrAlphaCombine (local) "local" "is not one of GR_COMBINE_LOCAL_*" fatal
        if !(0..=2).contains(local);
    "grAlphaCombine": GrAlphaCombine (other) "other" "is not one of GR_COMBINE_OTHER_*" fatal
        if !(0..=2).contains(other);
    "grColorCombine": GrColorCombine (function) "function" "is not one of GR_COMBINE_FUNCTION_*" fatal
        if !is_function(*function);
    "grColorCombine": GrColorCombine (factor) "factor" "is not one of GR_COMBINE_FACTOR_*" fatal
        if !is_factor(*factor);
    "grColorCombine": GrColorCombine (local) "local" "is not one of GR_COMBINE_LOCAL_* for colour" fatal
        if !(0..=1).contains(local);
    "grColorCombine": GrColorCombine (other) "other" "is not one of GR_COMBINE_OTHER_*" fatal
        if !(0..=2).contains(other);
    "grAlphaTestFunction": GrAlphaTestFunction (function) "function" "is not one of GR_CMP_*" fatal
        if !(0..=7).contains(function);
    "grChromakeyMode": GrChromakeyMode (mode) "mode" "is not one of GR_CHROMAKEY_*" fatal
        if !(0..=1).contains(mode);
    "grConstantColorValue4": GrConstantColorValue4 (a) "a" "is outside 0..255" fatal
        if !is_color(*a);
    "grConstantColorValue4": GrConstantColorValue4 (r) "r" "is outside 0..255" fatal
        if !is_color(*r);
    "grConstantColorValue4": GrConstantColorValue4 (g) "g" "is outside 0..255" fatal
        if !is_color(*g);
    "grConstantColorValue4": GrConstantColorValue4 (b) "b" "is outside 0..255" fatal
        if !is_color(*b);
    "grCullMode": GrCullMode (mode) "mode" "is not one of GR_CULL_*" fatal
        if !(0..=2).contains(mode);
    "grDitherMode": GrDitherMode (mode) "mode" "is not one of GR_DITHER_*" fatal
        if !(0..=2).contains(mode);
    "grFogMode": GrFogMode (mode) "mode" "is not one of GR_FOG_*" fatal
        if mode & 0xff > 3 || mode & !(0xff | FOG_MULT2 | FOG_ADD2) != 0;
    "grFogTable": GrFogTable (table) "ft" "has neighbours that differ by 64 or more" warning
        if table.windows(2).any(|pair| pair[0].abs_diff(pair[1]) >= 64);
    "grGammaCorrectionValue": GrGammaCorrectionValue (value) "value" "is not above 0" fatal
        if !(*value > 0.0 && value.is_finite());
    "guColorCombineFunction": GuColorCombineFunction (function) "func" "is not one of GR_COLORCOMBINE_*" fatal
        if !(0..=0x10).contains(function);
    "guAlphaSource": GuAlphaSource (mode) "mode" "is not one of GR_ALPHASOURCE_*" fatal
        if !(0..=3).contains(mode);
}
