//! `libredline`: the upper layer under the names that programs know.
//!
//! Each function goes on to `redline_...` of `libverite`, which this library is
//! linked with, so that a process has one device whichever way it finds the
//! functions. What the functions do is told there.
// C programs know the functions by these names.
#![allow(non_snake_case)]

use std::ffi::{c_int, c_void};

/// A pointer of any type.
type Any = *mut c_void;

/// Declares functions: name, the function of `libverite`, types of arguments,
/// and of what it returns.
macro_rules! forward {
    ($($name:ident $real:literal ($($a:ident: $t:ty),*) -> $r:ty;)*) => {$(
        #[doc = concat!("`", stringify!($name), "`.")]
        ///
        /// # Safety
        /// That of the function in `libverite`.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $name($($a: $t),*) -> $r {
            unsafe extern "C" {
                #[link_name = $real]
                fn real($($a: $t),*) -> $r;
            }
            // SAFETY: it has these arguments, and the caller's promise is its.
            unsafe { real($($a),*) }
        }
    )*};
}

forward! {
    VL_OpenVerite "redline_OpenVerite" (a: Any, b: Any) -> c_int;
    VL_CloseVerite "redline_CloseVerite" (a: Any) -> c_int;
    VL_GetExtensions "redline_GetExtensions" (a: Any) -> Any;
    VL_GetExtensionFunction "redline_GetExtensionFunction" (a: Any) -> Any;
    VL_CreateSurface "redline_CreateSurface" (a: Any, b: Any, c: u32, d: u32, e: u32, f: u32, g: u32) -> c_int;
    VL_PointSurface "redline_PointSurface" (a: Any, b: Any, c: u32, d: u32, e: u32, f: u32, g: u32, h: u32) -> c_int;
    VL_DestroySurface "redline_DestroySurface" (a: Any, b: Any) -> c_int;
    VL_RestoreSurface "redline_RestoreSurface" (a: Any, b: Any) -> c_int;
    VL_SetSurfaceChromaKey "redline_SetSurfaceChromaKey" (a: Any, b: u32) -> c_int;
    VL_SetSurfaceChromaColor "redline_SetSurfaceChromaColor" (a: Any, b: u32) -> c_int;
    VL_SetSurfaceChromaMask "redline_SetSurfaceChromaMask" (a: Any, b: u32) -> c_int;
    VL_SetSurfaceColorPad "redline_SetSurfaceColorPad" (a: Any, b: u32) -> c_int;
    VL_SetSurfaceBGR "redline_SetSurfaceBGR" (a: Any, b: u32) -> c_int;
    VL_SetSurfaceClamp "redline_SetSurfaceClamp" (a: Any, b: u32, c: u32) -> c_int;
    VL_SetSurfaceTexturePalette "redline_SetSurfaceTexturePalette" (a: Any, b: c_int, c: c_int, d: Any) -> c_int;
    VL_InstallDstBuffer "redline_InstallDstBuffer" (a: Any, b: Any) -> c_int;
    VL_InstallTextureMap "redline_InstallTextureMap" (a: Any, b: Any) -> c_int;
    VL_InstallTextureMapBasic "redline_InstallTextureMapBasic" (a: Any, b: Any) -> c_int;
    VL_InstallZBuffer "redline_InstallZBuffer" (a: Any, b: Any) -> c_int;
    VL_SwapDisplaySurface "redline_SwapDisplaySurface" (a: Any, b: Any) -> c_int;
    VL_WaitForDisplaySwitch "redline_WaitForDisplaySwitch" (a: Any) -> c_int;
    VL_ContextInit "redline_ContextInit" (a: Any) -> c_int;
    VL_FrameMarker "redline_FrameMarker" (a: Any, b: c_int) -> c_int;
    VL_SetSrcBase "redline_SetSrcBase" (a: Any, b: u32) -> c_int;
    VL_SetSrcFmt "redline_SetSrcFmt" (a: Any, b: u32) -> c_int;
    VL_SetSrcFunc "redline_SetSrcFunc" (a: Any, b: u32) -> c_int;
    VL_SetSrcFilter "redline_SetSrcFilter" (a: Any, b: u32) -> c_int;
    VL_SetSrcColorNoPad "redline_SetSrcColorNoPad" (a: Any, b: u32) -> c_int;
    VL_SetSwapUV "redline_SetSwapUV" (a: Any, b: u32) -> c_int;
    VL_SetChromaKey "redline_SetChromaKey" (a: Any, b: u32) -> c_int;
    VL_SetZScissorEnable "redline_SetZScissorEnable" (a: Any, b: u32) -> c_int;
    VL_SetSrcBGR "redline_SetSrcBGR" (a: Any, b: u32) -> c_int;
    VL_SetUClamp "redline_SetUClamp" (a: Any, b: u32) -> c_int;
    VL_SetVClamp "redline_SetVClamp" (a: Any, b: u32) -> c_int;
    VL_SetUMask "redline_SetUMask" (a: Any, b: u32) -> c_int;
    VL_SetVMask "redline_SetVMask" (a: Any, b: u32) -> c_int;
    VL_SetUMultiplier "redline_SetUMultiplier" (a: Any, b: u32) -> c_int;
    VL_SetVMultiplier "redline_SetVMultiplier" (a: Any, b: u32) -> c_int;
    VL_SetSOffset "redline_SetSOffset" (a: Any, b: u32) -> c_int;
    VL_SetTOffset "redline_SetTOffset" (a: Any, b: u32) -> c_int;
    VL_SetSrcStride "redline_SetSrcStride" (a: Any, b: u32) -> c_int;
    VL_SetDstStride "redline_SetDstStride" (a: Any, b: u32) -> c_int;
    VL_SetZStride "redline_SetZStride" (a: Any, b: u32) -> c_int;
    VL_SetDstBase "redline_SetDstBase" (a: Any, b: u32) -> c_int;
    VL_SetALUMode "redline_SetALUMode" (a: Any, b: u32) -> c_int;
    VL_SetBlendSrcFunc "redline_SetBlendSrcFunc" (a: Any, b: u32) -> c_int;
    VL_SetBlendDstFunc "redline_SetBlendDstFunc" (a: Any, b: u32) -> c_int;
    VL_SetZBufMode "redline_SetZBufMode" (a: Any, b: u32) -> c_int;
    VL_SetZBufWrMode "redline_SetZBufWrMode" (a: Any, b: u32) -> c_int;
    VL_SetYUV2RGB "redline_SetYUV2RGB" (a: Any, b: u32) -> c_int;
    VL_SetBlendEnable "redline_SetBlendEnable" (a: Any, b: u32) -> c_int;
    VL_SetDitherEnable "redline_SetDitherEnable" (a: Any, b: u32) -> c_int;
    VL_SetFogEnable "redline_SetFogEnable" (a: Any, b: u32) -> c_int;
    VL_SetDstRdDisable "redline_SetDstRdDisable" (a: Any, b: u32) -> c_int;
    VL_SetDstBGR "redline_SetDstBGR" (a: Any, b: u32) -> c_int;
    VL_SetTranspReject "redline_SetTranspReject" (a: Any, b: u32) -> c_int;
    VL_SetDstFmt "redline_SetDstFmt" (a: Any, b: u32) -> c_int;
    VL_SetPMask "redline_SetPMask" (a: Any, b: u32) -> c_int;
    VL_SetPat "redline_SetPat" (a: Any, b: u32) -> c_int;
    VL_SetPatLength "redline_SetPatLength" (a: Any, b: u32) -> c_int;
    VL_SetPatEnable "redline_SetPatEnable" (a: Any, b: u32) -> c_int;
    VL_SetPatOpaque "redline_SetPatOpaque" (a: Any, b: u32) -> c_int;
    VL_SetPatOffset "redline_SetPatOffset" (a: Any, b: u32) -> c_int;
    VL_SetScissorX "redline_SetScissorX" (a: Any, b: u32) -> c_int;
    VL_SetScissorY "redline_SetScissorY" (a: Any, b: u32) -> c_int;
    VL_SetZBase "redline_SetZBase" (a: Any, b: u32) -> c_int;
    VL_SetDitherOffset "redline_SetDitherOffset" (a: Any, b: u32) -> c_int;
    VL_SetFGColorABGR "redline_SetFGColorABGR" (a: Any, b: u32) -> c_int;
    VL_SetFGColorARGB "redline_SetFGColorARGB" (a: Any, b: u32) -> c_int;
    VL_SetBGColorABGR "redline_SetBGColorABGR" (a: Any, b: u32) -> c_int;
    VL_SetBGColorARGB "redline_SetBGColorARGB" (a: Any, b: u32) -> c_int;
    VL_SetFogColorBGR "redline_SetFogColorBGR" (a: Any, b: u32) -> c_int;
    VL_SetFogColorRGB "redline_SetFogColorRGB" (a: Any, b: u32) -> c_int;
    VL_SetDstColorABGR "redline_SetDstColorABGR" (a: Any, b: u32) -> c_int;
    VL_SetDstColorARGB "redline_SetDstColorARGB" (a: Any, b: u32) -> c_int;
    VL_SetZ "redline_SetZ" (a: Any, b: u32) -> c_int;
    VL_SetR "redline_SetR" (a: Any, b: u32) -> c_int;
    VL_SetG "redline_SetG" (a: Any, b: u32) -> c_int;
    VL_SetB "redline_SetB" (a: Any, b: u32) -> c_int;
    VL_SetA "redline_SetA" (a: Any, b: u32) -> c_int;
    VL_SetF "redline_SetF" (a: Any, b: u32) -> c_int;
    VL_SetU "redline_SetU" (a: Any, b: u32) -> c_int;
    VL_SetV "redline_SetV" (a: Any, b: u32) -> c_int;
    VL_SetDisplayBase "redline_SetDisplayBase" (a: Any, b: u32) -> c_int;
    VL_SetAlphaThreshold "redline_SetAlphaThreshold" (a: Any, b: u8) -> c_int;
    VL_SetChromaColor "redline_SetChromaColor" (a: Any, b: u32, c: u32) -> c_int;
    VL_SetChromaMask "redline_SetChromaMask" (a: Any, b: u32, c: u32) -> c_int;
    VL_SetCurrentTexture "redline_SetCurrentTexture" (a: Any, b: u32, c: u32, d: u16, e: u16, f: u32, g: u32) -> c_int;
    VL_SetStereoDisplayBase "redline_SetStereoDisplayBase" (a: Any, b: u32, c: u32) -> c_int;
    VL_SetPalette "redline_SetPalette" (a: Any, b: u16, c: u16, d: Any) -> c_int;
    VL_SetTexturePalette "redline_SetTexturePalette" (a: Any, b: u16, c: u16, d: Any, e: u32) -> c_int;
    VL_Dot "redline_Dot" (a: Any, b: u32, c: Any) -> c_int;
    VL_Line "redline_Line" (a: Any, b: u32, c: Any, d: Any) -> c_int;
    VL_Polyline "redline_Polyline" (a: Any, b: u32, c: u32, d: Any) -> c_int;
    VL_IntLine "redline_IntLine" (a: Any, b: u32, c: u16, d: u16, e: u16, f: u16) -> c_int;
    VL_IntPolyline "redline_IntPolyline" (a: Any, b: u32, c: u32, d: Any) -> c_int;
    VL_AALine "redline_AALine" (a: Any, b: u32, c: Any, d: Any) -> c_int;
    VL_AAEdge "redline_AAEdge" (a: Any, b: u32, c: Any, d: Any) -> c_int;
    VL_Span "redline_Span" (a: Any, b: u32, c: Any, d: Any) -> c_int;
    VL_Square "redline_Square" (a: Any, b: u32, c: u32, d: Any) -> c_int;
    VL_Rectangle "redline_Rectangle" (a: Any, b: u32, c: u32, d: u32, e: Any) -> c_int;
    VL_Triangle "redline_Triangle" (a: Any, b: u32, c: Any, d: Any, e: Any) -> c_int;
    VL_TriangleNormQ "redline_TriangleNormQ" (a: Any, b: u32, c: Any, d: Any, e: Any) -> c_int;
    VL_Triangle3 "redline_TriangleNormQ" (a: Any, b: u32, c: Any, d: Any, e: Any) -> c_int;
    VL_Tristrip "redline_Tristrip" (a: Any, b: u32, c: u32, d: Any) -> c_int;
    VL_Trifan "redline_Trifan" (a: Any, b: u32, c: u32, d: Any) -> c_int;
    VL_TriangleFill "redline_TriangleFill" (a: Any, b: u32, c: u32, d: u32, e: u32, f: u32, g: u32) -> c_int;
    VL_Affine "redline_Affine" (a: Any, b: u32, c: u32, d: u32, e: u32, f: u32, g: u32, h: u32, i: u32, j: u32, k: u32) -> c_int;
    VL_Warp "redline_Warp" (a: Any, b: u16, c: u16, d: u16, e: u16, f: u32, g: u32, h: Any) -> c_int;
    VL_Particles "redline_Particles" (a: Any, b: u32, c: Any) -> c_int;
    VL_VertexSize "redline_VertexSize" (a: u32) -> u32;
    VL_QOffset "redline_QOffset" (a: u32) -> u32;
    VL_QNormalize "redline_QNormalize" (a: Any, b: Any, c: Any) -> ();
    VL_FillBuffer "redline_FillBuffer" (a: Any, b: Any, c: u32, d: u32, e: u32, f: u32, g: u32, h: u32) -> c_int;
    VL_LoadBuffer "redline_LoadBuffer" (a: Any, b: Any, c: u32, d: u32, e: u32, f: u32, g: Any, h: Any) -> c_int;
    VL_CopyBuffer "redline_CopyBuffer" (a: Any, b: Any, c: u32, d: u32, e: u16, f: u16, g: u16, h: u16, i: u16, j: u16) -> c_int;
    VL_MemFill "redline_MemFill" (a: Any, b: u32, c: u32, d: u32, e: u32) -> c_int;
    VL_MemFillRect "redline_MemFillRect" (a: Any, b: u32, c: u32, d: u32, e: u32, f: u32, g: u32) -> c_int;
    VL_MemWrite "redline_MemWrite" (a: Any, b: u32, c: Any, d: Any, e: u32, f: u32) -> c_int;
    VL_MemWriteRect "redline_MemWriteRect" (a: Any, b: u32, c: u32, d: Any, e: Any, f: u32, g: u32, h: u32, i: u32) -> c_int;
    VL_MemWriteSprite "redline_MemWriteSprite" (a: Any, b: u32, c: u32, d: u32, e: Any) -> c_int;
    VL_Bitblt "redline_Bitblt" (a: Any, b: u16, c: u16, d: u16, e: u16, f: u16, g: u16) -> c_int;
    VL_BitBlt "redline_Bitblt" (a: Any, b: u16, c: u16, d: u16, e: u16, f: u16, g: u16) -> c_int;
    VL_BitbltMem "redline_BitbltMem" (a: Any, b: u16, c: u16, d: u16, e: u16, f: u32, g: Any, h: Any) -> c_int;
    VL_Bitfill "redline_Bitfill" (a: Any, b: u16, c: u16, d: u16, e: u16) -> c_int;
    VL_BitfillNoPat "redline_BitfillNoPat" (a: Any, b: Any, c: u32, d: u32, e: u16, f: u16, g: u16, h: u16) -> c_int;
    VL_BitfillPatTransparent "redline_BitfillPatTransparent" (a: Any, b: Any, c: u32, d: u32, e: u32, f: u32, g: u32, h: u16, i: u16, j: u16, k: u16) -> c_int;
    VL_BitfillPatOpaque "redline_BitfillPatOpaque" (a: Any, b: Any, c: u32, d: u32, e: u32, f: u32, g: u32, h: u32, i: u16, j: u16, k: u16, l: u16) -> c_int;
    VL_CompositeRect "redline_CompositeRect" (a: Any, b: u32, c: u16, d: u16, e: u16, f: u16, g: u32, h: u32, i: u32, j: u32, k: Any) -> c_int;
    VL_Lookup "redline_Lookup" (a: Any, b: u16, c: u16, d: u16, e: u16, f: Any, g: Any) -> c_int;
    VL_RegisterErrorHandler "redline_RegisterErrorHandler" (a: Any) -> c_int;
    VL_GetErrorHandler "redline_GetErrorHandler" () -> Any;
    VL_GetFunctionName "redline_GetFunctionName" (a: c_int, b: Any, c: c_int) -> c_int;
    VL_GetErrorText "redline_GetErrorText" (a: c_int, b: Any, c: c_int) -> c_int;
    VL_GetLastError "redline_GetLastError" (a: Any, b: Any, c: Any) -> c_int;
}
