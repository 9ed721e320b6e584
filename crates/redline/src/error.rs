//! Error and routine numbers of both layers, their names and texts.
//!
//! Success is not zero in either layer. The texts are ours: the original ones
//! are not public.
//!
//! Source: RR, error handling; numbers from the interface headers.

/// Declares an enumeration of numbers with a name in C and a text each.
macro_rules! numbers {
    (
        $(#[$meta:meta])* $name:ident { $($variant:ident = $number:literal $c:literal $text:literal,)* }
    ) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, thiserror::Error)]
        #[repr(i32)]
        pub enum $name {
            $(
                #[doc = concat!("`", $c, "`.")]
                #[error($text)]
                $variant = $number,
            )*
        }

        impl $name {
            /// All of them, by rising number.
            pub const ALL: &'static [$name] = &[$($name::$variant),*];

            /// The documented number.
            pub fn number(self) -> i32 {
                self as i32
            }

            /// What a number stands for.
            pub fn from_number(number: i32) -> Option<$name> {
                match number {
                    $($number => Some($name::$variant),)*
                    _ => None,
                }
            }

            /// The name in C.
            pub fn name(self) -> &'static str {
                match self {
                    $($name::$variant => $c,)*
                }
            }

            /// A short English text.
            pub fn text(self) -> &'static str {
                match self {
                    $($name::$variant => $text,)*
                }
            }
        }
    };
}

numbers! {
    /// Numbers of the lower layer (`V_*`).
    VError {
        Success = 500 "V_SUCCESS" "success",
        ParamError = 501 "V_PARAM_ERROR" "an argument is not valid",
        AllocFailed = 502 "V_ALLOC_FAILED" "host memory could not be had",
        CmdBufferInUse = 503 "V_CMDBUFFER_INUSE" "the command buffer is in use",
        CmdBufferAvail = 504 "V_CMDBUFFER_AVAIL" "the command buffer is available",
        CmdBufferTooSmall = 505 "V_CMDBUFFER_TOO_SMALL" "the command buffer is too small for the command",
        CmdBufferNoDmaEntries = 506 "V_CMDBUFFER_NO_DMAENTRIES" "the command buffer has no DMA entries left",
        LockPagesFailed = 508 "V_LOCK_PAGES_FAILED" "pages could not be locked",
        CannotIssueCommands = 509 "V_CANNOT_ISSUE_COMMANDS" "commands cannot be issued",
        CannotSwapWindowedSurfaces = 510 "V_CANNOT_SWAP_WINDOWED_SURFACES" "surfaces in a window cannot be swapped",
        CannotLoadMicrocode = 511 "V_CANNOT_LOAD_UCODE" "the microcode could not be loaded",
        CannotGetBoardInfo = 512 "V_CANNOT_GET_BOARDINFO" "there is no such board",
        OpenFailVxd = 513 "V_OPEN_FAIL_VXD" "the driver could not be opened",
        NoError = 514 "V_NO_ERROR" "no error has occurred",
        IoctlVeriteLockPages = 515 "V_IOCTL_VERITE_LOCK_PAGES" "the driver could not lock pages",
        IoctlVeriteAllocLockedMem = 516 "V_IOCTL_VERITE_ALLOC_LOCKED_MEM" "the driver could not allocate locked memory",
        PageCheck = 517 "V_PAGE_CHECK" "a page is not locked",
        Failed = 518 "V_FAILED" "the call failed",
        DdDirectDrawCreate = 519 "V_DD_DIRECTDRAWCREATE" "the display system could not be created",
        DdDirectDraw2Create = 520 "V_DD_DIRECTDRAW2CREATE" "the display system is too old",
        DdSetLevel = 521 "V_DD_SETLEVEL" "the cooperative level could not be set",
        DdRestoreDisplayMode = 522 "V_DD_RESTOREDISPLAYMODE" "the display mode could not be restored",
        DdSetDisplayMode = 523 "V_DD_SETDISPLAYMODE" "the display mode could not be set",
        DdCreateClipper = 524 "V_DD_CREATECLIPPER" "a clipper could not be created",
        DdCreateSurface = 525 "V_DD_CREATESURFACE" "a display surface could not be created",
        DdSetClipper = 526 "V_DD_SETCLIPPER" "the clipper could not be set",
        DdIsLost = 530 "V_DD_ISLOST" "the buffer is lost",
        DdRestore = 531 "V_DD_RESTORE" "the buffer could not be restored",
        DdLock = 540 "V_DD_LOCK" "the buffer could not be locked",
        DdBlt = 547 "V_DD_BLT" "the buffer could not be copied",
        IoctlGetVeriteInfo = 548 "V_IOCTL_GET_VERITE_INFO" "the driver gave no information on the board",
        BadPixFmt = 550 "V_BAD_PIXFMT" "the pixel format is not valid",
        VeriteCommandErr = 551 "V_VERITE_COMMAND_ERR" "the command buffer holds an unknown or incomplete command",
        InvalidBuffer = 552 "V_INVALID_BUFFER" "there is no such buffer",
        DdUnlock = 553 "V_DD_UNLOCK" "the buffer could not be unlocked",
        DdGetDc = 554 "V_DD_GETDC" "no device context could be had",
        DdReleaseDc = 555 "V_DD_RELEASEDC" "the device context could not be released",
        SubSurfaceError = 559 "V_SUBSURFACE_ERROR" "the surface cannot be placed there",
        CannotObtainDc = 560 "V_CANNOT_OBTAIN_DC" "buffers have no device context",
        OutOfVideoMemory = 561 "V_OUT_OF_VIDEO_MEMORY" "video memory is used up",
        FullScreenModeOnly = 625 "V_FULLSCREEN_MODE_ONLY" "only possible in full-screen mode",
    }
}

numbers! {
    /// Numbers of the upper layer (`VL_*`).
    VlError {
        Success = 600 "VL_SUCCESS" "success",
        ParamError = 601 "VL_PARAM_ERROR" "an argument is not valid",
        AllocFailed = 602 "VL_ALLOC_FAILED" "host memory could not be had",
        BadPixFmt = 603 "VL_BAD_PIXFMT" "the pixel format is not valid",
        AddToCmdListFailed = 624 "VL_ADDTOCMDLIST_FAILED" "the command could not be added to the command buffer",
        FullScreenModeOnly = 625 "VL_FULLSCREEN_MODE_ONLY" "only possible in full-screen mode",
        RequiresBackBuffer = 627 "VL_REQUIRES_BACK_BUFFER" "the surface has no back buffer",
        NoError = 629 "VL_NO_ERROR" "no error has occurred",
        OpenFailed = 630 "VL_OPEN_FAILED" "the board could not be opened",
        CannotGetBoardInfo = 631 "VL_CANNOT_GET_BOARDINFO" "there is no such board",
        CannotGetHandle = 632 "VL_CANNOT_GET_HANDLE" "no handle could be had",
        OutOfVideoMemory = 633 "VL_OUT_OF_VIDEO_MEMORY" "video memory is used up",
        Failed = 634 "VL_FAILED" "the call failed",
    }
}

numbers! {
    /// Functions of the lower layer, as error handlers name them. The text is the
    /// function's name.
    VRoutine {
        CreateCmdBuffer = 100 "V_R_CreateCmdBuffer" "V_CreateCmdBuffer",
        IssueCmdBuffer = 101 "V_R_IssueCmdBuffer" "V_IssueCmdBuffer",
        IssueCmdBufferAsync = 102 "V_R_IssueCmdBufferAsync" "V_IssueCmdBufferAsync",
        QueryCmdBuffer = 103 "V_R_QueryCmdBuffer" "V_QueryCmdBuffer",
        DestroyCmdBuffer = 104 "V_R_DestroyCmdBuffer" "V_DestroyCmdBuffer",
        ResetCmdBuffer = 105 "V_R_ResetCmdBuffer" "V_ResetCmdBuffer",
        SetCmdBufferCallBack = 106 "V_R_SetCmdBufferCallBack" "V_SetCmdBufferCallBack",
        GetCmdBufferCallBack = 107 "V_R_GetCmdBufferCallBack" "V_GetCmdBufferCallBack",
        AddToCmdList = 108 "V_R_AddToCmdList" "V_AddToCmdList",
        AddToDMAList = 109 "V_R_AddToDMAList" "V_AddToDMAList",
        EnumVeriteBoards = 110 "V_R_EnumVeriteBoards" "V_EnumVeriteBoards",
        CreateVerite = 111 "V_R_CreateVerite" "V_CreateVerite",
        DestroyVerite = 115 "V_R_DestroyVerite" "V_DestroyVerite",
        CurrentRequest = 116 "V_R_CurrentRequest" "V_CurrentRequest",
        AllocMemoryObject = 117 "V_R_AllocMemoryObject" "V_AllocMemoryObject",
        FreeMemoryObject = 118 "V_R_FreeMemoryObject" "V_FreeMemoryObject",
        AllocLockedMem = 119 "V_R_AllocLockedMem" "V_AllocLockedMem",
        FreeLockedMem = 120 "V_R_FreeLockedMem" "V_FreeLockedMem",
        LockPages = 121 "V_R_LockPages" "V_LockPages",
        UnlockPages = 122 "V_R_UnlockPages" "V_UnlockPages",
        Linebytes = 123 "V_R_Linebytes" "V_Linebytes",
        Stride = 124 "V_R_Stride" "V_Stride",
        GetUserPrivate = 125 "V_R_GetUserPrivate" "V_GetUserPrivate",
        SetUserPrivate = 126 "V_R_SetUserPrivate" "V_SetUserPrivate",
        RegisterErrorHandler = 127 "V_R_RegisterErrorHandler" "V_RegisterErrorHandler",
        GetFunctionName = 128 "V_R_GetFunctionName" "V_GetFunctionName",
        GetErrorText = 129 "V_R_GetErrorText" "V_GetErrorText",
        GetLastError = 130 "V_R_GetLastError" "V_GetLastError",
        GetErrorHandler = 133 "V_R_GetErrorHandler" "V_GetErrorHandler",
        CreateBufferGroup = 134 "V_R_CreateBufferGroup" "V_CreateBufferGroup",
        IsBufferLost = 135 "V_R_IsBufferLost" "V_IsBufferLost",
        RestoreBufferGroup = 136 "V_R_RestoreBufferGroup" "V_RestoreBufferGroup",
        PointBufferGroup = 137 "V_R_PointBufferGroup" "V_PointBufferGroup",
        BltDisplayBuffer = 145 "V_R_BltDisplayBuffer" "V_BltDisplayBuffer",
        LockBuffer = 146 "V_R_LockBuffer" "V_LockBuffer",
        UnlockBuffer = 147 "V_R_UnlockBuffer" "V_UnlockBuffer",
        DestroyBufferGroup = 149 "V_R_DestroyBufferGroup" "V_DestroyBufferGroup",
        SetDisplayMode = 150 "V_R_SetDisplayMode" "V_SetDisplayMode",
        SetDisplayType = 151 "V_R_SetDisplayType" "V_SetDisplayType",
        GetDisplayType = 152 "V_R_GetDisplayType" "V_GetDisplayType",
        GetCmdBufferHandle = 153 "V_R_GetCmdBufferHandle" "V_GetCmdBufferHandle",
        GetUseDMA = 154 "V_R_GetUseDMA" "V_GetUseDMA",
        GetBufferLinebytes = 155 "V_R_GetBufferLinebytes" "V_GetBufferLinebytes",
        GetBufferStride = 156 "V_R_GetBufferStride" "V_GetBufferStride",
        GetBufferAddress = 157 "V_R_GetBufferAddress" "V_GetBufferAddress",
        SwapBuffers = 158 "V_R_SwapBuffers" "V_SwapBuffers",
        GetBufferDC = 159 "V_R_GetBufferDC" "V_GetBufferDC",
        ReleaseBufferDC = 160 "V_R_ReleaseBufferDC" "V_ReleaseBufferDC",
        RestoreBuffer = 161 "V_R_RestoreBuffer" "V_RestoreBuffer",
        SetDisplayLinebytes = 162 "V_R_SetDisplayLinebytes" "V_SetDisplayLinebytes",
        ReadBuffer = 163 "V_R_ReadBuffer" "V_ReadBuffer",
        AddToCmdAndDMAList = 164 "V_R_AddToCmdAndDMAList" "V_AddToCmdAndDMAList",
    }
}

numbers! {
    /// Functions of the upper layer, as error handlers name them. The text is the
    /// function's name.
    VlRoutine {
        OpenVerite = 200 "VL_R_OpenVerite" "VL_OpenVerite",
        CloseVerite = 201 "VL_R_CloseVerite" "VL_CloseVerite",
        MemWrite = 204 "VL_R_MemWrite" "VL_MemWrite",
        MemWriteRect = 206 "VL_R_MemWriteRect" "VL_MemWriteRect",
        MemFill = 208 "VL_R_MemFill" "VL_MemFill",
        MemFillRect = 209 "VL_R_MemFillRect" "VL_MemFillRect",
        SetDisplayBase = 210 "VL_R_SetDisplayBase" "VL_SetDisplayBase",
        SetStereoDisplayBase = 211 "VL_R_SetStereoDisplayBase" "VL_SetStereoDisplayBase",
        SetPalette = 212 "VL_R_SetPalette" "VL_SetPalette",
        WaitForDisplaySwitch = 213 "VL_R_WaitForDisplaySwitch" "VL_WaitForDisplaySwitch",
        Sync = 214 "VL_R_Sync" "VL_Sync",
        SetTexturePalette = 226 "VL_R_SetTexturePalette" "VL_SetTexturePalette",
        SwapDisplaySurface = 227 "VL_R_SwapDisplaySurface" "VL_SwapDisplaySurface",
        FillBuffer = 229 "VL_R_FillBuffer" "VL_FillBuffer",
        LoadBuffer = 230 "VL_R_LoadBuffer" "VL_LoadBuffer",
        InstallDstBuffer = 235 "VL_R_InstallDstBuffer" "VL_InstallDstBuffer",
        InstallTextureMap = 236 "VL_R_InstallTextureMap" "VL_InstallTextureMap",
        InstallTextureMapBasic = 237 "VL_R_InstallTextureMapBasic" "VL_InstallTextureMapBasic",
        InstallZBuffer = 238 "VL_R_InstallZBuffer" "VL_InstallZBuffer",
        CopyBuffer = 240 "VL_R_CopyBuffer" "VL_CopyBuffer",
        BitfillNoPat = 241 "VL_R_BitfillNoPat" "VL_BitfillNoPat",
        BitfillPatTransparent = 242 "VL_R_BitfillPatTransparent" "VL_BitfillPatTransparent",
        BitfillPatOpaque = 243 "VL_R_BitfillPatOpaque" "VL_BitfillPatOpaque",
        ContextInit = 244 "VL_R_ContextInit" "VL_ContextInit",
        SetSrcBase = 245 "VL_R_SetSrcBase" "VL_SetSrcBase",
        SetSrcFmt = 246 "VL_R_SetSrcFmt" "VL_SetSrcFmt",
        SetSrcFunc = 247 "VL_R_SetSrcFunc" "VL_SetSrcFunc",
        SetSrcFilter = 248 "VL_R_SetSrcFilter" "VL_SetSrcFilter",
        SetSrcColorNoPad = 249 "VL_R_SetSrcColorNoPad" "VL_SetSrcColorNoPad",
        SetSwapUV = 250 "VL_R_SetSwapUV" "VL_SetSwapUV",
        SetChromaKey = 251 "VL_R_SetChromaKey" "VL_SetChromaKey",
        SetZScissorEnable = 252 "VL_R_SetZScissorEnable" "VL_SetZScissorEnable",
        SetSrcBGR = 253 "VL_R_SetSrcBGR" "VL_SetSrcBGR",
        SetUClamp = 254 "VL_R_SetUClamp" "VL_SetUClamp",
        SetVClamp = 255 "VL_R_SetVClamp" "VL_SetVClamp",
        SetUMask = 256 "VL_R_SetUMask" "VL_SetUMask",
        SetVMask = 257 "VL_R_SetVMask" "VL_SetVMask",
        SetUMultiplier = 258 "VL_R_SetUMultiplier" "VL_SetUMultiplier",
        SetVMultiplier = 259 "VL_R_SetVMultiplier" "VL_SetVMultiplier",
        SetSOffset = 260 "VL_R_SetSOffset" "VL_SetSOffset",
        SetTOffset = 261 "VL_R_SetTOffset" "VL_SetTOffset",
        SetSrcStride = 262 "VL_R_SetSrcStride" "VL_SetSrcStride",
        SetDstStride = 263 "VL_R_SetDstStride" "VL_SetDstStride",
        SetZStride = 264 "VL_R_SetZStride" "VL_SetZStride",
        SetDstBase = 265 "VL_R_SetDstBase" "VL_SetDstBase",
        SetALUMode = 266 "VL_R_SetALUMode" "VL_SetALUMode",
        SetBlendSrcFunc = 267 "VL_R_SetBlendSrcFunc" "VL_SetBlendSrcFunc",
        SetBlendDstFunc = 268 "VL_R_SetBlendDstFunc" "VL_SetBlendDstFunc",
        SetZBufMode = 269 "VL_R_SetZBufMode" "VL_SetZBufMode",
        SetZBufWrMode = 270 "VL_R_SetZBufWrMode" "VL_SetZBufWrMode",
        SetYUV2RGB = 271 "VL_R_SetYUV2RGB" "VL_SetYUV2RGB",
        SetBlendEnable = 272 "VL_R_SetBlendEnable" "VL_SetBlendEnable",
        SetDitherEnable = 273 "VL_R_SetDitherEnable" "VL_SetDitherEnable",
        SetFogEnable = 274 "VL_R_SetFogEnable" "VL_SetFogEnable",
        SetDstRdDisable = 275 "VL_R_SetDstRdDisable" "VL_SetDstRdDisable",
        SetDstBGR = 276 "VL_R_SetDstBGR" "VL_SetDstBGR",
        SetTranspReject = 277 "VL_R_SetTranspReject" "VL_SetTranspReject",
        SetAlphaThreshold = 278 "VL_R_SetAlphaThreshold" "VL_SetAlphaThreshold",
        SetDstFmt = 279 "VL_R_SetDstFmt" "VL_SetDstFmt",
        SetPMask = 280 "VL_R_SetPMask" "VL_SetPMask",
        SetPat = 281 "VL_R_SetPat" "VL_SetPat",
        SetPatLength = 282 "VL_R_SetPatLength" "VL_SetPatLength",
        SetPatEnable = 283 "VL_R_SetPatEnable" "VL_SetPatEnable",
        SetPatOpaque = 284 "VL_R_SetPatOpaque" "VL_SetPatOpaque",
        SetPatOffset = 285 "VL_R_SetPatOffset" "VL_SetPatOffset",
        SetScissorX = 286 "VL_R_SetScissorX" "VL_SetScissorX",
        SetScissorY = 287 "VL_R_SetScissorY" "VL_SetScissorY",
        SetZBase = 288 "VL_R_SetZBase" "VL_SetZBase",
        SetDitherOffset = 289 "VL_R_SetDitherOffset" "VL_SetDitherOffset",
        SetFGColorABGR = 290 "VL_R_SetFGColorABGR" "VL_SetFGColorABGR",
        SetFGColorARGB = 291 "VL_R_SetFGColorARGB" "VL_SetFGColorARGB",
        SetBGColorABGR = 292 "VL_R_SetBGColorABGR" "VL_SetBGColorABGR",
        SetBGColorARGB = 293 "VL_R_SetBGColorARGB" "VL_SetBGColorARGB",
        SetFogColorBGR = 294 "VL_R_SetFogColorBGR" "VL_SetFogColorBGR",
        SetFogColorRGB = 295 "VL_R_SetFogColorRGB" "VL_SetFogColorRGB",
        SetDstColorABGR = 296 "VL_R_SetDstColorABGR" "VL_SetDstColorABGR",
        SetDstColorARGB = 297 "VL_R_SetDstColorARGB" "VL_SetDstColorARGB",
        SetChromaColor = 298 "VL_R_SetChromaColor" "VL_SetChromaColor",
        SetChromaMask = 299 "VL_R_SetChromaMask" "VL_SetChromaMask",
        SetCurrentTexture = 300 "VL_R_SetCurrentTexture" "VL_SetCurrentTexture",
        SetZ = 301 "VL_R_SetZ" "VL_SetZ",
        SetR = 302 "VL_R_SetR" "VL_SetR",
        SetG = 303 "VL_R_SetG" "VL_SetG",
        SetB = 304 "VL_R_SetB" "VL_SetB",
        SetA = 305 "VL_R_SetA" "VL_SetA",
        SetF = 306 "VL_R_SetF" "VL_SetF",
        SetU = 307 "VL_R_SetU" "VL_SetU",
        SetV = 308 "VL_R_SetV" "VL_SetV",
        VertexSize = 309 "VL_R_VertexSize" "VL_VertexSize",
        QOffset = 310 "VL_R_QOffset" "VL_QOffset",
        QNormalize = 311 "VL_R_QNormalize" "VL_QNormalize",
        Dot = 312 "VL_R_Dot" "VL_Dot",
        Line = 313 "VL_R_Line" "VL_Line",
        Polyline = 314 "VL_R_Polyline" "VL_Polyline",
        IntLine = 315 "VL_R_IntLine" "VL_IntLine",
        IntPolyline = 316 "VL_R_IntPolyline" "VL_IntPolyline",
        AALine = 317 "VL_R_AALine" "VL_AALine",
        AAEdge = 318 "VL_R_AAEdge" "VL_AAEdge",
        Span = 319 "VL_R_Span" "VL_Span",
        Square = 320 "VL_R_Square" "VL_Square",
        Rectangle = 321 "VL_R_Rectangle" "VL_Rectangle",
        Triangle = 322 "VL_R_Triangle" "VL_Triangle",
        TriangleNormQ = 323 "VL_R_TriangleNormQ" "VL_TriangleNormQ",
        Tristrip = 324 "VL_R_Tristrip" "VL_Tristrip",
        Trifan = 325 "VL_R_Trifan" "VL_Trifan",
        TriangleFill = 326 "VL_R_TriangleFill" "VL_TriangleFill",
        Affine = 327 "VL_R_Affine" "VL_Affine",
        Warp = 328 "VL_R_Warp" "VL_Warp",
        Bitblt = 330 "VL_R_Bitblt" "VL_Bitblt",
        CompositeRect = 331 "VL_R_CompositeRect" "VL_CompositeRect",
        Bitfill = 333 "VL_R_Bitfill" "VL_Bitfill",
        BitbltMem = 334 "VL_R_BitbltMem" "VL_BitbltMem",
        Lookup = 336 "VL_R_Lookup" "VL_Lookup",
        MemWriteSprite = 338 "VL_R_MemWriteSprite" "VL_MemWriteSprite",
        Particles = 340 "VL_R_Particles" "VL_Particles",
        QSpan = 342 "VL_R_QSpan" "VL_QSpan",
        FrameMarker = 344 "VL_R_FrameMarker" "VL_FrameMarker",
        RegisterErrorHandler = 345 "VL_R_RegisterErrorHandler" "VL_RegisterErrorHandler",
        GetFunctionName = 346 "VL_R_GetFunctionName" "VL_GetFunctionName",
        GetErrorText = 347 "VL_R_GetErrorText" "VL_GetErrorText",
        GetLastError = 348 "VL_R_GetLastError" "VL_GetLastError",
        GetExtensions = 349 "VL_R_GetExtensions" "VL_GetExtensions",
        GetErrorHandler = 350 "VL_R_GetErrorHandler" "VL_GetErrorHandler",
        CreateSurface = 351 "VL_R_CreateSurface" "VL_CreateSurface",
        DestroySurface = 352 "VL_R_DestroySurface" "VL_DestroySurface",
        SetSurfaceChromaKey = 353 "VL_R_SetSurfaceChromaKey" "VL_SetSurfaceChromaKey",
        SetSurfaceChromaColor = 354 "VL_R_SetSurfaceChromaColor" "VL_SetSurfaceChromaColor",
        SetSurfaceChromaMask = 355 "VL_R_SetSurfaceChromaMask" "VL_SetSurfaceChromaMask",
        SetSurfaceColorPad = 356 "VL_R_SetSurfaceColorPad" "VL_SetSurfaceColorPad",
        SetSurfaceBGR = 357 "VL_R_SetSurfaceBGR" "VL_SetSurfaceBGR",
        SetSurfaceClamp = 358 "VL_R_SetSurfaceClamp" "VL_SetSurfaceClamp",
        SetSurfaceTexturePalette = 359 "VL_R_SetSurfaceTexturePalette" "VL_SetSurfaceTexturePalette",
        PointSurface = 360 "VL_R_PointSurface" "VL_PointSurface",
        RestoreSurface = 361 "VL_R_RestoreSurface" "VL_RestoreSurface",
        SetSpecularEnable = 362 "VL_R_SetSpecularEnable" "VL_SetSpecularEnable",
        SetSpecularColorRGB = 363 "VL_R_SetSpecularColorRGB" "VL_SetSpecularColorRGB",
        SetSpecularColorBGR = 364 "VL_R_SetSpecularColorBGR" "VL_SetSpecularColorBGR",
    }
}

/// One failure in one layer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Fault {
    /// In the lower layer.
    V(VRoutine, VError),
    /// In the upper layer.
    Vl(VlRoutine, VlError),
}

impl Fault {
    /// Number of the routine.
    pub fn routine(self) -> i32 {
        match self {
            Fault::V(routine, _) => routine.number(),
            Fault::Vl(routine, _) => routine.number(),
        }
    }

    /// Number of the error.
    pub fn error(self) -> i32 {
        match self {
            Fault::V(_, error) => error.number(),
            Fault::Vl(_, error) => error.number(),
        }
    }
}

impl std::fmt::Display for Fault {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Fault::V(routine, error) => write!(f, "{}: {error}", routine.text()),
            Fault::Vl(routine, error) => write!(f, "{}: {error}", routine.text()),
        }
    }
}

/// Why a call failed: one fault, or one in the lower layer and the one in the
/// upper layer that follows from it.
///
/// The handlers of C programs are told of [`Failure::faults`] in that order;
/// the number of the last one is what the function returns.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Failure {
    first: Fault,
    second: Option<Fault>,
}

/// What functions of the device return.
pub type Result<T, E = Failure> = std::result::Result<T, E>;

impl Failure {
    /// A failure in the lower layer.
    pub fn v(routine: VRoutine, error: VError) -> Failure {
        Failure { first: Fault::V(routine, error), second: None }
    }

    /// A failure in the upper layer.
    pub fn vl(routine: VlRoutine, error: VlError) -> Failure {
        Failure { first: Fault::Vl(routine, error), second: None }
    }

    /// This failure, and what the upper layer says of it.
    pub fn then(self, routine: VlRoutine, error: VlError) -> Failure {
        Failure { second: Some(Fault::Vl(routine, error)), ..self }
    }

    /// The faults in the order in which handlers hear of them.
    pub fn faults(&self) -> impl Iterator<Item = Fault> {
        [Some(self.first), self.second].into_iter().flatten()
    }

    /// The fault that the called function returns.
    pub fn last(&self) -> Fault {
        self.second.unwrap_or(self.first)
    }

    /// The number that the called function returns.
    pub fn number(&self) -> i32 {
        self.last().error()
    }
}

impl std::fmt::Display for Failure {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.second {
            Some(second) => write!(f, "{second} ({})", self.first),
            None => self.first.fmt(f),
        }
    }
}

impl std::error::Error for Failure {}

/// The text of an error number of either layer, for `V_GetErrorText` and
/// `VL_GetErrorText`.
pub fn error_text(number: i32) -> Option<&'static str> {
    let v = VError::from_number(number).map(VError::text);
    v.or_else(|| VlError::from_number(number).map(VlError::text))
}

/// The name of a routine number of either layer, for `V_GetFunctionName` and
/// `VL_GetFunctionName`.
pub fn function_name(number: i32) -> Option<&'static str> {
    let v = VRoutine::from_number(number).map(VRoutine::text);
    v.or_else(|| VlRoutine::from_number(number).map(VlRoutine::text))
}
