/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * RAVE.h: the rendering interface of QuickDraw 3D RAVE 1.6, for programs.
 *
 * Types, constants and functions have the documented names, order and values.
 * The library draws into memory; what belongs to a window system takes an
 * untyped pointer and is refused. What the interface calls `long` is 32 bits
 * wide here on every host, pointers have the host's size, enumerations four
 * bytes. Pixels of 16 and 32 bits are integers of the host; for data of another
 * machine there is the variable FILLRATE_RAVE_BIG_ENDIAN. Plain C89.
 *
 *     cc -Iinclude program.c -o program -lrave
 *
 * The drawing calls are macros that call through the context; each is a
 * function too, for programs that take its address or undefine the macro.
 * Engines need RAVE_system.h as well.
 */
#ifndef RAVE_H
#define RAVE_H

#ifdef __cplusplus
extern "C" {
#endif

/* --- platform ----------------------------------------------------------- */

#define kQAMacOS 1
#define kQAGeneric 2 /* memory devices only */
#define kQAWin32 3
#define kQAPlatform kQAGeneric

/* --- scalar types ------------------------------------------------------- */

typedef int TQAInt32;
typedef unsigned int TQAUInt32;
typedef unsigned char TQABoolean; /* 0 false, otherwise true */

typedef struct TQAEngine TQAEngine;
typedef struct TQATexture TQATexture;
typedef struct TQABitmap TQABitmap;
typedef struct TQAColorTable TQAColorTable;
typedef struct TQADrawPrivate TQADrawPrivate; /* belongs to the engine */
typedef struct TQADrawContext TQADrawContext;

/* Results. */
typedef enum TQAError {
    kQANoErr = 0,
    kQAError = 1, /* general failure */
    kQAOutOfMemory = 2, /* host memory */
    kQANotSupported = 3, /* not offered by this engine */
    kQAOutOfDate = 4, /* a newer engine of the same identity is registered */
    kQAParamErr = 5,
    kQAGestaltUnknown = 6,
    kQADisplayModeUnsupported = 7,
    kQAOutOfVideoMemory = 8 /* the board's memory */
} TQAError;

/* What a draw context offers; its member `version`. */
typedef enum TQAVersion {
    kQAVersion_Prerelease = 0,
    kQAVersion_1_0 = 1,
    kQAVersion_1_0_5 = 2, /* meshes, colour tables */
    kQAVersion_1_5 = 3, /* notices, compression */
    kQAVersion_1_1 = 3, /* the older name of 1.5 */
    kQAVersion_1_6 = 4 /* everything here */
} TQAVersion;

/* --- pixels ---------------------------------------------------------------- */

/* Bit 0 is the least significant. */
typedef enum TQAImagePixelType {
    kQAPixel_Alpha1 = 0, /* alpha only, the leftmost pixel in the highest bit */
    kQAPixel_RGB16 = 1, /* R 14..10, G 9..5, B 4..0 */
    kQAPixel_ARGB16 = 2, /* A 15, R, G, B as above */
    kQAPixel_RGB32 = 3, /* R 23..16, G 15..8, B 7..0 */
    kQAPixel_ARGB32 = 4, /* A 31..24, R, G, B as above */
    kQAPixel_CL4 = 5, /* index; the left pixel in the high nibble */
    kQAPixel_CL8 = 6, /* index */
    kQAPixel_RGB16_565 = 7, /* R 15..11, G 10..5, B 4..0 */
    kQAPixel_RGB24 = 8, /* bytes B, G, R */
    kQAPixel_RGB8_332 = 9, /* R 7..5, G 4..2, B 1..0 */
    kQAPixel_ARGB16_4444 = 10,
    kQAPixel_ACL16_88 = 11, /* A 15..8, index 7..0 */
    kQAPixel_I8 = 12, /* intensity */
    kQAPixel_AI16_88 = 13, /* A 15..8, intensity 7..0 */
    kQAPixel_YUVS = 14, /* bytes Y U Y V, unsigned chroma */
    kQAPixel_YUVU = 15, /* bytes Y U Y V, signed chroma */
    kQAPixel_YVYU422 = 16, /* bytes Y V Y U */
    kQAPixel_UYVY422 = 17 /* bytes U Y V Y */
} TQAImagePixelType;

/* Entries are 0x00RRGGBB. */
typedef enum TQAColorTableType {
    kQAColorTable_CL8_RGB32 = 0, /* 256 entries */
    kQAColorTable_CL4_RGB32 = 1 /* 16 entries */
} TQAColorTableType;

/* Rows lie from top to bottom, rowBytes apart. */
typedef struct TQAImage {
    TQAInt32 width;
    TQAInt32 height;
    TQAInt32 rowBytes;
    void *pixmap;
} TQAImage;

/* right and bottom are exclusive. Mind the order. */
typedef struct TQARect {
    TQAInt32 left;
    TQAInt32 right;
    TQAInt32 top;
    TQAInt32 bottom;
} TQARect;

/* --- devices and clips ----------------------------------------------------- */

typedef enum TQADeviceType {
    kQADeviceMemory = 0,
    kQADeviceGDevice = 1, /* refused */
    kQADeviceWin32DC = 2, /* refused */
    kQADeviceDDSurface = 3, /* refused */
    kQADeviceOffscreen = 4 /* extension: no memory of the program */
} TQADeviceType;

/* Which DirectDraw objects a device of that kind would name. */
typedef enum TQADirectDrawObjectSelector {
    kQADirectDrawObject = 1,
    kQADirectDrawObject2 = 2
} TQADirectDrawObjectSelector;

typedef enum TQADirectDrawSurfaceSelector {
    kQADirectDrawSurface = 1,
    kQADirectDrawSurface2 = 2
} TQADirectDrawSurfaceSelector;

/* Memory of the program that is drawn into. */
typedef struct TQADeviceMemory {
    TQAInt32 rowBytes;
    TQAImagePixelType pixelType;
    TQAInt32 width;
    TQAInt32 height;
    void *baseAddr;
} TQADeviceMemory;

typedef TQADeviceMemory TQAPixelBuffer;

typedef struct TQADeviceOffscreen {
    TQAImagePixelType pixelType;
} TQADeviceOffscreen;

typedef struct TQAZBuffer {
    TQAInt32 width;
    TQAInt32 height;
    TQAInt32 rowBytes;
    void *zbuffer;
    TQAInt32 zDepth;      /* bits of a value: 16, 24 or 32 */
    TQAInt32 isBigEndian;
} TQAZBuffer;

typedef union TQAPlatformDevice {
    TQADeviceMemory memoryDevice;
    TQADeviceOffscreen offscreenDevice;
    void *gDevice;
} TQAPlatformDevice;

typedef struct TQADevice {
    TQADeviceType deviceType;
    TQAPlatformDevice device;
} TQADevice;

typedef enum TQAClipType {
    kQAClipRgn = 0, /* refused */
    kQAClipWin32Rgn = 1, /* refused */
    kQAClipRects = 1000 /* extension: a list of rectangles */
} TQAClipType;

/* Extension: the pixels of the device that may be drawn. */
typedef struct TQAClipRectList {
    TQAInt32 count;
    const TQARect *rects;
} TQAClipRectList;

typedef union TQAPlatformClip {
    void *clipRgn;
    const TQAClipRectList *clipRects;
} TQAPlatformClip;

typedef struct TQAClip {
    TQAClipType clipType;
    TQAPlatformClip clip;
} TQAClip;

/* A rectangle of the screen, as QuickDraw has it. */
typedef struct TQAGlobalRect {
    short top;
    short left;
    short bottom;
    short right;
} TQAGlobalRect;

/* Tells of every area of the screen that is about to be drawn. */
typedef void (*TQADrawNotificationProc)(short left, short top, short right, short bottom,
                                        long refCon);
#define TQADrawNotificationProcPtr TQADrawNotificationProc

/* --- vertices -------------------------------------------------------------- */

/* x, y: pixels from the top left of the context. z: 0 near to 1 far. invW:
 * 1 / w. Colours and alpha: 0 to 1. */
typedef struct TQAVGouraud {
    float x;
    float y;
    float z;
    float invW;
    float r;
    float g;
    float b;
    float a;
} TQAVGouraud;

/* u to the right, v upwards, the image from (0, 0) to (1, 1). r, g, b are used
 * with Decal, kd (at least 0, may exceed 1) with Modulate, ks with Highlight. */
typedef struct TQAVTexture {
    float x;
    float y;
    float z;
    float invW;
    float r;
    float g;
    float b;
    float a;
    float uOverW;
    float vOverW;
    float kd_r;
    float kd_g;
    float kd_b;
    float ks_r;
    float ks_g;
    float ks_b;
} TQAVTexture;

typedef struct TQAVMultiTexture {
    float invW;
    float uOverW;
    float vOverW;
} TQAVMultiTexture;

typedef struct TQAIndexedTriangle {
    TQAUInt32 triangleFlags;
    TQAUInt32 vertices[3];
} TQAIndexedTriangle;

typedef enum TQAVertexMode {
    kQAVertexMode_Point = 0,
    kQAVertexMode_Line = 1,
    kQAVertexMode_Polyline = 2,
    kQAVertexMode_Tri = 3,
    kQAVertexMode_Strip = 4,
    kQAVertexMode_Fan = 5,
    kQAVertexMode_NumModes = 6
} TQAVertexMode;

#define kQATriFlags_None 0
#define kQATriFlags_Backfacing (1 << 0) /* says so; the triangle is drawn */

/* --- gestalt --------------------------------------------------------------- */

typedef enum TQAGestaltSelector {
    kQAGestalt_OptionalFeatures = 0,
    kQAGestalt_FastFeatures = 1,
    kQAGestalt_VendorID = 2,
    kQAGestalt_EngineID = 3,
    kQAGestalt_Revision = 4,
    kQAGestalt_ASCIINameLength = 5,
    kQAGestalt_ASCIIName = 6, /* copies the name with its terminator */
    kQAGestalt_TextureMemory = 7,
    kQAGestalt_FastTextureMemory = 8,
    kQAGestalt_DrawContextPixelTypesAllowed = 9,
    kQAGestalt_DrawContextPixelTypesPreferred = 10,
    kQAGestalt_TexturePixelTypesAllowed = 11,
    kQAGestalt_TexturePixelTypesPreferred = 12,
    kQAGestalt_BitmapPixelTypesAllowed = 13,
    kQAGestalt_BitmapPixelTypesPreferred = 14,
    kQAGestalt_OptionalFeatures2 = 15,
    kQAGestalt_MultiTextureMax = 16,
    kQAGestalt_NumSelectors = 17,
    kQAGestalt_EngineSpecific_Minimum = 1000,
    kQAGestalt_TextureLoads = 2000, /* extension: copies of textures to the board so far */
    kQAGestalt_TextureEvictions = 2001 /* extension: copies that left it for others */
} TQAGestaltSelector;

/* Bits of kQAGestalt_OptionalFeatures. */
#define kQAOptional_None 0
#define kQAOptional_DeepZ (1 << 0)
#define kQAOptional_Texture (1 << 1)
#define kQAOptional_TextureHQ (1 << 2)
#define kQAOptional_TextureColor (1 << 3)
#define kQAOptional_Blend (1 << 4)
#define kQAOptional_BlendAlpha (1 << 5)
#define kQAOptional_Antialias (1 << 6)
#define kQAOptional_ZSorted (1 << 7)
#define kQAOptional_PerspectiveZ (1 << 8)
#define kQAOptional_OpenGL (1 << 9)
#define kQAOptional_NoClear (1 << 10)
#define kQAOptional_CSG (1 << 11)
#define kQAOptional_BoundToDevice (1 << 12)
#define kQAOptional_CL4 (1 << 13)
#define kQAOptional_CL8 (1 << 14)
#define kQAOptional_BufferComposite (1 << 15)
#define kQAOptional_NoDither (1 << 16)
#define kQAOptional_FogAlpha (1 << 17)
#define kQAOptional_FogDepth (1 << 18)
#define kQAOptional_MultiTextures (1 << 19)
#define kQAOptional_MipmapBias (1 << 20)
#define kQAOptional_ChannelMask (1 << 21)
#define kQAOptional_ZBufferMask (1 << 22)
#define kQAOptional_AlphaTest (1 << 23)
#define kQAOptional_AccessTexture (1 << 24)
#define kQAOptional_AccessBitmap (1 << 25)
#define kQAOptional_AccessDrawBuffer (1 << 26)
#define kQAOptional_AccessZBuffer (1 << 27)
#define kQAOptional_ClearDrawBuffer (1 << 28)
#define kQAOptional_ClearZBuffer (1 << 29)
#define kQAOptional_OffscreenDrawContexts (1 << 30)

/* Bits of kQAGestalt_OptionalFeatures2. */
#define kQAOptional2_None 0
#define kQAOptional2_TextureDrawContexts (1 << 1)
#define kQAOptional2_BitmapDrawContexts (1 << 2)
#define kQAOptional2_Busy (1 << 3)
#define kQAOptional2_SwapBuffers (1 << 4)
#define kQAOptional2_Chromakey (1 << 5)
#define kQAOptional2_NonRelocatable (1 << 6)
#define kQAOptional2_NoCopy (1 << 7)
#define kQAOptional2_PriorityBits (1 << 8)
#define kQAOptional2_FlipOrigin (1 << 9)
#define kQAOptional2_BitmapScale (1 << 10)
#define kQAOptional2_DrawContextScale (1 << 11)
#define kQAOptional2_DrawContextNonRelocatable (1 << 12)

/* Bits of kQAGestalt_FastFeatures: other numbers than above. */
#define kQAFast_None 0
#define kQAFast_Line (1 << 0)
#define kQAFast_Gouraud (1 << 1)
#define kQAFast_Texture (1 << 2)
#define kQAFast_TextureHQ (1 << 3)
#define kQAFast_Blend (1 << 4)
#define kQAFast_Antialiasing (1 << 5)
#define kQAFast_ZSorted (1 << 6)
#define kQAFast_CL4 (1 << 7)
#define kQAFast_CL8 (1 << 8)
#define kQAFast_FogAlpha (1 << 9)
#define kQAFast_FogDepth (1 << 10)
#define kQAFast_MultiTextures (1 << 11)
#define kQAFast_BitmapScale (1 << 12)
#define kQAFast_DrawContextScale (1 << 13)

/* Vendors and engines. */
#define kQAVendor_BestChoice (-1)
#define kQAVendor_Apple 0
#define kQAVendor_ATI 1
#define kQAVendor_Radius 2
#define kQAVendor_Mentor 3
#define kQAVendor_Matrox 4
#define kQAVendor_Yarc 5
#define kQAEngine_AppleSW 0
#define kQAEngine_AppleHW (-1)
#define kQAEngine_AppleHW2 1

/* --- state variables ------------------------------------------------------- */

typedef enum TQATagInt {
    kQATag_ZFunction = 0,
    kQATag_Antialias = 8,
    kQATag_Blend = 9,
    kQATag_PerspectiveZ = 10,
    kQATag_TextureFilter = 11,
    kQATag_TextureOp = 12,
    kQATag_CSGTag = 14,
    kQATag_CSGEquation = 15,
    kQATag_BufferComposite = 16,
    kQATag_FogMode = 17,
    kQATag_ChannelMask = 27,
    kQATag_ZBufferMask = 28,
    kQATag_ZSortedHint = 29,
    kQATag_ChromakeyEnable = 30,
    kQATag_AlphaTestFunc = 31,
    kQATag_DontSwap = 32,
    kQATag_MultiTextureEnable = 33,
    kQATag_MultiTextureCurrent = 34,
    kQATag_MultiTextureOp = 35,
    kQATag_MultiTextureFilter = 36,
    kQATag_MultiTextureWrapU = 37,
    kQATag_MultiTextureWrapV = 38,
    kQATag_MultiTextureMagFilter = 39,
    kQATag_MultiTextureMinFilter = 40,
    kQATag_BitmapFilter = 54,
    kQATag_DrawContextFilter = 55,
    kQATagGL_DrawBuffer = 100,
    kQATagGL_TextureWrapU = 101,
    kQATagGL_TextureWrapV = 102,
    kQATagGL_TextureMagFilter = 103,
    kQATagGL_TextureMinFilter = 104,
    kQATagGL_ScissorXMin = 105,
    kQATagGL_ScissorYMin = 106,
    kQATagGL_ScissorXMax = 107,
    kQATagGL_ScissorYMax = 108,
    kQATagGL_BlendSrc = 109,
    kQATagGL_BlendDst = 110,
    kQATagGL_LinePattern = 111,
    kQATagGL_AreaPattern0 = 117,
    kQATagGL_AreaPattern1 = 118,
    kQATagGL_AreaPattern2 = 119,
    kQATagGL_AreaPattern3 = 120,
    kQATagGL_AreaPattern4 = 121,
    kQATagGL_AreaPattern5 = 122,
    kQATagGL_AreaPattern6 = 123,
    kQATagGL_AreaPattern7 = 124,
    kQATagGL_AreaPattern8 = 125,
    kQATagGL_AreaPattern9 = 126,
    kQATagGL_AreaPattern10 = 127,
    kQATagGL_AreaPattern11 = 128,
    kQATagGL_AreaPattern12 = 129,
    kQATagGL_AreaPattern13 = 130,
    kQATagGL_AreaPattern14 = 131,
    kQATagGL_AreaPattern15 = 132,
    kQATagGL_AreaPattern16 = 133,
    kQATagGL_AreaPattern17 = 134,
    kQATagGL_AreaPattern18 = 135,
    kQATagGL_AreaPattern19 = 136,
    kQATagGL_AreaPattern20 = 137,
    kQATagGL_AreaPattern21 = 138,
    kQATagGL_AreaPattern22 = 139,
    kQATagGL_AreaPattern23 = 140,
    kQATagGL_AreaPattern24 = 141,
    kQATagGL_AreaPattern25 = 142,
    kQATagGL_AreaPattern26 = 143,
    kQATagGL_AreaPattern27 = 144,
    kQATagGL_AreaPattern28 = 145,
    kQATagGL_AreaPattern29 = 146,
    kQATagGL_AreaPattern30 = 147,
    kQATagGL_AreaPattern31 = 148,
    kQATagGL_LinePatternFactor = 149,
    kQATag_EngineSpecific_Minimum = 1000
} TQATagInt;

typedef enum TQATagPtr {
    kQATag_Texture = 13,
    kQATag_MultiTexture = 26
} TQATagPtr;

/* Of each colour alpha comes first. */
typedef enum TQATagFloat {
    kQATag_ColorBG_a = 1,
    kQATag_ColorBG_r = 2,
    kQATag_ColorBG_g = 3,
    kQATag_ColorBG_b = 4,
    kQATag_Width = 5,
    kQATag_ZMinOffset = 6,
    kQATag_ZMinScale = 7,
    kQATag_FogColor_a = 18,
    kQATag_FogColor_r = 19,
    kQATag_FogColor_g = 20,
    kQATag_FogColor_b = 21,
    kQATag_FogStart = 22,
    kQATag_FogEnd = 23,
    kQATag_FogDensity = 24,
    kQATag_FogMaxDepth = 25,
    kQATag_MipmapBias = 41,
    kQATag_MultiTextureMipmapBias = 42,
    kQATag_Chromakey_r = 43,
    kQATag_Chromakey_g = 44,
    kQATag_Chromakey_b = 45,
    kQATag_AlphaTestRef = 46,
    kQATag_MultiTextureBorder_a = 47,
    kQATag_MultiTextureBorder_r = 48,
    kQATag_MultiTextureBorder_g = 49,
    kQATag_MultiTextureBorder_b = 50,
    kQATag_MultiTextureFactor = 51,
    kQATag_BitmapScale_x = 52,
    kQATag_BitmapScale_y = 53,
    kQATag_MultiTextureEnvColor_a = 56,
    kQATag_MultiTextureEnvColor_r = 57,
    kQATag_MultiTextureEnvColor_g = 58,
    kQATag_MultiTextureEnvColor_b = 59,
    kQATagGL_DepthBG = 112,
    kQATagGL_TextureBorder_a = 113,
    kQATagGL_TextureBorder_r = 114,
    kQATagGL_TextureBorder_g = 115,
    kQATagGL_TextureBorder_b = 116,
    kQATagGL_TextureEnvColor_a = 150,
    kQATagGL_TextureEnvColor_r = 151,
    kQATagGL_TextureEnvColor_g = 152,
    kQATagGL_TextureEnvColor_b = 153
} TQATagFloat;

/* kQATag_ZFunction: None neither tests nor writes, True writes without a test. */
#define kQAZFunction_None 0
#define kQAZFunction_LT 1
#define kQAZFunction_EQ 2
#define kQAZFunction_LE 3
#define kQAZFunction_GT 4
#define kQAZFunction_NE 5
#define kQAZFunction_GE 6
#define kQAZFunction_True 7
#define kQAZFunction_False 8

/* kQATag_Width. */
#define kQAMaxWidth 128.0

/* kQATag_Antialias. */
#define kQAAntiAlias_Off 0
#define kQAAntiAlias_Fast 1
#define kQAAntiAlias_Mid 2
#define kQAAntiAlias_Best 3

/* kQATag_Blend. */
#define kQABlend_PreMultiply 0
#define kQABlend_Interpolate 1
#define kQABlend_OpenGL 2

/* kQATag_PerspectiveZ. */
#define kQAPerspectiveZ_Off 0
#define kQAPerspectiveZ_On 1

/* kQATag_TextureFilter, and those of bitmaps, further textures and scaled contexts. */
#define kQATextureFilter_Fast 0
#define kQATextureFilter_Mid 1
#define kQATextureFilter_Best 2
#define kQAFilter_Fast 0
#define kQAFilter_Mid 1
#define kQAFilter_Best 2

/* kQATag_TextureOp, a mask. */
#define kQATextureOp_None 0
#define kQATextureOp_Modulate (1 << 0)
#define kQATextureOp_Highlight (1 << 1)
#define kQATextureOp_Decal (1 << 2)
#define kQATextureOp_Shrink (1 << 3)
#define kQATextureOp_Blend (1 << 4)

/* kQATag_MultiTextureOp. */
#define kQAMultiTexture_Add 0
#define kQAMultiTexture_Modulate 1
#define kQAMultiTexture_BlendAlpha 2
#define kQAMultiTexture_Fixed 3

/* kQATag_CSGTag and kQATag_CSGEquation. */
#define kQACSGTag_None 0xffffffffU
#define kQACSGTag_0 0
#define kQACSGTag_1 1
#define kQACSGTag_2 2
#define kQACSGTag_3 3
#define kQACSGTag_4 4
#define kQACSG_AandB 0x88888888U
#define kQACSG_AandNotB 0x22222222U
#define kQACSG_NotAandB 0x44444444U
#define kQACSG_AandNotBorNotCandD 0x2f222f22U
#define kQACSG_NotAandBorCandNotD 0x74747474U

/* kQATag_BufferComposite. */
#define kQABufferComposite_None 0
#define kQABufferComposite_PreMultiply 1
#define kQABufferComposite_Interpolate 2

/* kQATag_FogMode. */
#define kQAFogMode_None 0
#define kQAFogMode_Alpha 1
#define kQAFogMode_Linear 2
#define kQAFogMode_Exponential 3
#define kQAFogMode_ExponentialSquared 4

/* kQATag_ChannelMask, a mask. */
#define kQAChannelMask_r (1 << 0)
#define kQAChannelMask_g (1 << 1)
#define kQAChannelMask_b (1 << 2)
#define kQAChannelMask_a (1 << 3)

/* kQATag_ZBufferMask. */
#define kQAZBufferMask_Disable 0
#define kQAZBufferMask_Enable 1

/* kQATag_AlphaTestFunc: a fragment stays if its alpha compares so with the reference. */
#define kQAAlphaTest_None 0
#define kQAAlphaTest_LT 1
#define kQAAlphaTest_EQ 2
#define kQAAlphaTest_LE 3
#define kQAAlphaTest_GT 4
#define kQAAlphaTest_NE 5
#define kQAAlphaTest_GE 6
#define kQAAlphaTest_True 7

/* kQATagGL_TextureWrapU and V, and the filters. */
#define kQAGL_Repeat 0
#define kQAGL_Clamp 1
#define kQAGL_Nearest 0
#define kQAGL_Linear 1

/* kQATagGL_DrawBuffer, a mask. */
#define kQAGL_DrawBuffer_None 0
#define kQAGL_DrawBuffer_FrontLeft (1 << 0)
#define kQAGL_DrawBuffer_FrontRight (1 << 1)
#define kQAGL_DrawBuffer_BackLeft (1 << 2)
#define kQAGL_DrawBuffer_BackRight (1 << 3)
#define kQAGL_DrawBuffer_Front 3
#define kQAGL_DrawBuffer_Back 12

/* --- flags ----------------------------------------------------------------- */

/* QADrawContextNew. */
#define kQAContext_None 0
#define kQAContext_NoZBuffer (1 << 0)
#define kQAContext_DeepZ (1 << 1)
#define kQAContext_DoubleBuffer (1 << 2)
#define kQAContext_Cache (1 << 3)
#define kQAContext_NoDither (1 << 4)
#define kQAContext_Scale (1 << 5)
#define kQAContext_NonRelocatable (1 << 6)
#define kQAContext_EngineSpecific1 0x10000000U
#define kQAContext_EngineSpecific2 0x20000000U
#define kQAContext_EngineSpecific3 0x40000000U
#define kQAContext_EngineSpecific4 0x80000000U

/* QATextureNew. */
#define kQATexture_None 0
#define kQATexture_Lock (1 << 0)
#define kQATexture_Mipmap (1 << 1)
#define kQATexture_NoCompression (1 << 2)
#define kQATexture_HighCompression (1 << 3)
#define kQATexture_NonRelocatable (1 << 4)
#define kQATexture_NoCopy (1 << 5)
#define kQATexture_FlipOrigin (1 << 6)
#define kQATexture_PriorityBits 0xf0000000U

/* QABitmapNew. Lock is not that of textures. */
#define kQABitmap_None 0
#define kQABitmap_Lock (1 << 1)
#define kQABitmap_NoCompression (1 << 2)
#define kQABitmap_HighCompression (1 << 3)
#define kQABitmap_NonRelocatable (1 << 4)
#define kQABitmap_NoCopy (1 << 5)
#define kQABitmap_FlipOrigin (1 << 6)
#define kQABitmap_PriorityBits 0xf0000000U

/* Priorities from 0, the highest and usual one, to 15. */
#define QACalculatePriorityBits(priority) ((TQAUInt32)(priority) << 28)

/* Access calls: the program overwrites everything. */
#define kQANoCopyNeeded (1 << 0)

/* --- notices --------------------------------------------------------------- */

typedef enum TQAMethodSelector {
    kQAMethod_RenderCompletion = 0, /* drawn and shown */
    kQAMethod_DisplayModeChanged = 1,
    kQAMethod_ReloadTextures = 2,
    kQAMethod_ImageBufferInitialize = 3, /* instead of the clear of the colours */
    kQAMethod_BufferInitialize = 3,
    kQAMethod_ImageBuffer2DComposite = 4, /* drawn, not yet shown */
    kQAMethod_BufferComposite = 4,
    kQAMethod_NumSelectors = 5
} TQAMethodSelector;

typedef void (*TQAStandardNoticeMethod)(const TQADrawContext *drawContext, void *refCon);
/* `buffer` is a memory device: the back buffer from the context's top left. */
typedef void (*TQABufferNoticeMethod)(const TQADrawContext *drawContext, const TQADevice *buffer,
                                      const TQARect *dirtyRect, void *refCon);
typedef union TQANoticeMethod {
    TQAStandardNoticeMethod standardNoticeMethod;
    TQABufferNoticeMethod bufferNoticeMethod;
} TQANoticeMethod;

/* --- methods of a draw context --------------------------------------------- */

typedef void (*TQASetFloat)(TQADrawContext *drawContext, TQATagFloat tag, float newValue);
typedef void (*TQASetInt)(TQADrawContext *drawContext, TQATagInt tag, TQAUInt32 newValue);
typedef void (*TQASetPtr)(TQADrawContext *drawContext, TQATagPtr tag, const void *newValue);
typedef float (*TQAGetFloat)(const TQADrawContext *drawContext, TQATagFloat tag);
typedef TQAUInt32 (*TQAGetInt)(const TQADrawContext *drawContext, TQATagInt tag);
typedef void *(*TQAGetPtr)(const TQADrawContext *drawContext, TQATagPtr tag);
typedef void (*TQADrawPoint)(const TQADrawContext *drawContext, const TQAVGouraud *v);
typedef void (*TQADrawLine)(const TQADrawContext *drawContext, const TQAVGouraud *v0,
                            const TQAVGouraud *v1);
typedef void (*TQADrawTriGouraud)(const TQADrawContext *drawContext, const TQAVGouraud *v0,
                                  const TQAVGouraud *v1, const TQAVGouraud *v2, TQAUInt32 flags);
typedef void (*TQADrawTriTexture)(const TQADrawContext *drawContext, const TQAVTexture *v0,
                                  const TQAVTexture *v1, const TQAVTexture *v2, TQAUInt32 flags);
typedef void (*TQADrawVGouraud)(const TQADrawContext *drawContext, TQAUInt32 nVertices,
                                TQAVertexMode vertexMode, const TQAVGouraud vertices[],
                                const TQAUInt32 flags[]);
typedef void (*TQADrawVTexture)(const TQADrawContext *drawContext, TQAUInt32 nVertices,
                                TQAVertexMode vertexMode, const TQAVTexture vertices[],
                                const TQAUInt32 flags[]);
typedef void (*TQADrawBitmap)(const TQADrawContext *drawContext, const TQAVGouraud *v,
                              TQABitmap *bitmap);
typedef void (*TQARenderStart)(const TQADrawContext *drawContext, const TQARect *dirtyRect,
                               const TQADrawContext *initialContext);
typedef TQAError (*TQARenderEnd)(const TQADrawContext *drawContext, const TQARect *modifiedRect);
typedef TQAError (*TQARenderAbort)(const TQADrawContext *drawContext);
typedef TQAError (*TQAFlush)(const TQADrawContext *drawContext);
typedef TQAError (*TQASync)(const TQADrawContext *drawContext);
typedef void (*TQASubmitVerticesGouraud)(const TQADrawContext *drawContext, TQAUInt32 nVertices,
                                         const TQAVGouraud *vertices);
typedef void (*TQASubmitVerticesTexture)(const TQADrawContext *drawContext, TQAUInt32 nVertices,
                                         const TQAVTexture *vertices);
typedef void (*TQADrawTriMeshGouraud)(const TQADrawContext *drawContext, TQAUInt32 nTriangles,
                                      const TQAIndexedTriangle *triangles);
typedef void (*TQADrawTriMeshTexture)(const TQADrawContext *drawContext, TQAUInt32 nTriangles,
                                      const TQAIndexedTriangle *triangles);
typedef TQAError (*TQASetNoticeMethod)(const TQADrawContext *drawContext, TQAMethodSelector method,
                                       TQANoticeMethod completionCallBack, void *refCon);
typedef TQAError (*TQAGetNoticeMethod)(const TQADrawContext *drawContext, TQAMethodSelector method,
                                       TQANoticeMethod *completionCallBack, void **refCon);
typedef void (*TQASubmitMultiTextureParams)(const TQADrawContext *drawContext, TQAUInt32 nParams,
                                            const TQAVMultiTexture *params);
typedef TQAError (*TQAAccessDrawBuffer)(const TQADrawContext *drawContext, TQAPixelBuffer *buffer);
typedef TQAError (*TQAAccessDrawBufferEnd)(const TQADrawContext *drawContext,
                                           const TQARect *dirtyRect);
typedef TQAError (*TQAAccessZBuffer)(const TQADrawContext *drawContext, TQAZBuffer *buffer);
typedef TQAError (*TQAAccessZBufferEnd)(const TQADrawContext *drawContext,
                                        const TQARect *dirtyRect);
typedef TQAError (*TQAClearDrawBuffer)(const TQADrawContext *drawContext, const TQARect *rect,
                                       const TQADrawContext *initialContext);
typedef TQAError (*TQAClearZBuffer)(const TQADrawContext *drawContext, const TQARect *rect,
                                    const TQADrawContext *initialContext);
typedef TQAError (*TQATextureNewFromDrawContext)(const TQADrawContext *drawContext, TQAUInt32 flags,
                                                 TQATexture **newTexture);
typedef TQAError (*TQABitmapNewFromDrawContext)(const TQADrawContext *drawContext, TQAUInt32 flags,
                                                TQABitmap **newBitmap);
typedef TQABoolean (*TQABusy)(const TQADrawContext *drawContext);
typedef TQAError (*TQASwapBuffers)(const TQADrawContext *drawContext, const TQARect *dirtyRect);

/* Programs call through this structure at every call: setting state may
 * replace methods. The order is that of the method tags in RAVE_system.h. */
struct TQADrawContext {
    TQADrawPrivate *drawPrivate;
    TQAVersion version;
    TQASetFloat setFloat;
    TQASetInt setInt;
    TQASetPtr setPtr;
    TQAGetFloat getFloat;
    TQAGetInt getInt;
    TQAGetPtr getPtr;
    TQADrawPoint drawPoint;
    TQADrawLine drawLine;
    TQADrawTriGouraud drawTriGouraud;
    TQADrawTriTexture drawTriTexture;
    TQADrawVGouraud drawVGouraud;
    TQADrawVTexture drawVTexture;
    TQADrawBitmap drawBitmap;
    TQARenderStart renderStart;
    TQARenderEnd renderEnd;
    TQARenderAbort renderAbort;
    TQAFlush flush;
    TQASync sync;
    TQASubmitVerticesGouraud submitVerticesGouraud;
    TQASubmitVerticesTexture submitVerticesTexture;
    TQADrawTriMeshGouraud drawTriMeshGouraud;
    TQADrawTriMeshTexture drawTriMeshTexture;
    TQASetNoticeMethod setNoticeMethod;
    TQAGetNoticeMethod getNoticeMethod;
    TQASubmitMultiTextureParams submitMultiTextureParams;
    TQAAccessDrawBuffer accessDrawBuffer;
    TQAAccessDrawBufferEnd accessDrawBufferEnd;
    TQAAccessZBuffer accessZBuffer;
    TQAAccessZBufferEnd accessZBufferEnd;
    TQAClearDrawBuffer clearDrawBuffer;
    TQAClearZBuffer clearZBuffer;
    TQATextureNewFromDrawContext textureFromContext;
    TQABitmapNewFromDrawContext bitmapFromContext;
    TQABusy busy;
    TQASwapBuffers swapBuffers;
};

/* --- draw contexts and engines --------------------------------------------- */

/* Neither has anything left to do. */
TQAError QAInit(void);
TQAError QAExit(void);

/* With kQAContext_Scale `rect` points to two: the size of the vertices' space,
 * and where it is shown. `*newDrawContext` is NULL after failures. */
TQAError QADrawContextNew(const TQADevice *device, const TQARect *rect, const TQAClip *clip,
                          const TQAEngine *engine, TQAUInt32 flags,
                          TQADrawContext **newDrawContext);
void QADrawContextDelete(TQADrawContext *drawContext);

TQAError QAColorTableNew(const TQAEngine *engine, TQAColorTableType tableType, void *pixelData,
                         TQAInt32 transparentIndexFlag, TQAColorTable **newTable);
void QAColorTableDelete(const TQAEngine *engine, TQAColorTable *colorTable);

TQAError QATextureNew(const TQAEngine *engine, TQAUInt32 flags, TQAImagePixelType pixelType,
                      const TQAImage images[], TQATexture **newTexture);
TQAError QATextureDetach(const TQAEngine *engine, TQATexture *texture);
void QATextureDelete(const TQAEngine *engine, TQATexture *texture);
TQAError QATextureBindColorTable(const TQAEngine *engine, TQATexture *texture,
                                 TQAColorTable *colorTable);

TQAError QABitmapNew(const TQAEngine *engine, TQAUInt32 flags, TQAImagePixelType pixelType,
                     const TQAImage *image, TQABitmap **newBitmap);
TQAError QABitmapDetach(const TQAEngine *engine, TQABitmap *bitmap);
void QABitmapDelete(const TQAEngine *engine, TQABitmap *bitmap);
TQAError QABitmapBindColorTable(const TQAEngine *engine, TQABitmap *bitmap,
                                TQAColorTable *colorTable);

/* NULL for the device lists all engines; NULL is returned after the last. */
TQAEngine *QADeviceGetFirstEngine(const TQADevice *device);
TQAEngine *QADeviceGetNextEngine(const TQADevice *device, const TQAEngine *currentEngine);
TQAError QAEngineCheckDevice(const TQAEngine *engine, const TQADevice *device);
TQAError QAEngineGestalt(const TQAEngine *engine, TQAGestaltSelector selector, void *response);
TQAError QAEngineEnable(TQAInt32 vendorID, TQAInt32 engineID);
TQAError QAEngineDisable(TQAInt32 vendorID, TQAInt32 engineID);

/* `buffer` describes memory until the end of the access. */
TQAError QAAccessTexture(const TQAEngine *engine, TQATexture *texture, TQAInt32 mipmapLevel,
                         TQAInt32 flags, TQAPixelBuffer *buffer);
TQAError QAAccessTextureEnd(const TQAEngine *engine, TQATexture *texture,
                            const TQARect *dirtyRect);
TQAError QAAccessBitmap(const TQAEngine *engine, TQABitmap *bitmap, TQAInt32 flags,
                        TQAPixelBuffer *buffer);
TQAError QAAccessBitmapEnd(const TQAEngine *engine, TQABitmap *bitmap, const TQARect *dirtyRect);

TQAError QARegisterDrawNotificationProc(TQAGlobalRect *globalRect, TQADrawNotificationProc proc,
                                        long refCon, TQAInt32 *refNum);
TQAError QAUnregisterDrawNotificationProc(TQAInt32 refNum);

/* --- drawing --------------------------------------------------------------- */

void QASetFloat(TQADrawContext *drawContext, TQATagFloat tag, float newValue);
void QASetInt(TQADrawContext *drawContext, TQATagInt tag, TQAUInt32 newValue);
void QASetPtr(TQADrawContext *drawContext, TQATagPtr tag, const void *newValue);
float QAGetFloat(const TQADrawContext *drawContext, TQATagFloat tag);
TQAUInt32 QAGetInt(const TQADrawContext *drawContext, TQATagInt tag);
void *QAGetPtr(const TQADrawContext *drawContext, TQATagPtr tag);
void QADrawPoint(const TQADrawContext *drawContext, const TQAVGouraud *v);
void QADrawLine(const TQADrawContext *drawContext, const TQAVGouraud *v0, const TQAVGouraud *v1);
void QADrawTriGouraud(const TQADrawContext *drawContext, const TQAVGouraud *v0,
                      const TQAVGouraud *v1, const TQAVGouraud *v2, TQAUInt32 flags);
void QADrawTriTexture(const TQADrawContext *drawContext, const TQAVTexture *v0,
                      const TQAVTexture *v1, const TQAVTexture *v2, TQAUInt32 flags);
void QADrawVGouraud(const TQADrawContext *drawContext, TQAUInt32 nVertices,
                    TQAVertexMode vertexMode, const TQAVGouraud vertices[],
                    const TQAUInt32 flags[]);
void QADrawVTexture(const TQADrawContext *drawContext, TQAUInt32 nVertices,
                    TQAVertexMode vertexMode, const TQAVTexture vertices[],
                    const TQAUInt32 flags[]);
void QADrawBitmap(const TQADrawContext *drawContext, const TQAVGouraud *v, TQABitmap *bitmap);
void QARenderStart(const TQADrawContext *drawContext, const TQARect *dirtyRect,
                   const TQADrawContext *initialContext);
TQAError QARenderEnd(const TQADrawContext *drawContext, const TQARect *modifiedRect);
TQAError QARenderAbort(const TQADrawContext *drawContext);
TQAError QAFlush(const TQADrawContext *drawContext);
TQAError QASync(const TQADrawContext *drawContext);
void QASubmitVerticesGouraud(const TQADrawContext *drawContext, TQAUInt32 nVertices,
                             const TQAVGouraud *vertices);
void QASubmitVerticesTexture(const TQADrawContext *drawContext, TQAUInt32 nVertices,
                             const TQAVTexture *vertices);
void QADrawTriMeshGouraud(const TQADrawContext *drawContext, TQAUInt32 nTriangles,
                          const TQAIndexedTriangle *triangles);
void QADrawTriMeshTexture(const TQADrawContext *drawContext, TQAUInt32 nTriangles,
                          const TQAIndexedTriangle *triangles);
TQAError QASetNoticeMethod(const TQADrawContext *drawContext, TQAMethodSelector method,
                           TQANoticeMethod completionCallBack, void *refCon);
TQAError QAGetNoticeMethod(const TQADrawContext *drawContext, TQAMethodSelector method,
                           TQANoticeMethod *completionCallBack, void **refCon);
void QASubmitMultiTextureParams(const TQADrawContext *drawContext, TQAUInt32 nParams,
                                const TQAVMultiTexture *params);
TQAError QAAccessDrawBuffer(const TQADrawContext *drawContext, TQAPixelBuffer *buffer);
TQAError QAAccessDrawBufferEnd(const TQADrawContext *drawContext, const TQARect *dirtyRect);
TQAError QAAccessZBuffer(const TQADrawContext *drawContext, TQAZBuffer *buffer);
TQAError QAAccessZBufferEnd(const TQADrawContext *drawContext, const TQARect *dirtyRect);
TQAError QAClearDrawBuffer(const TQADrawContext *drawContext, const TQARect *rect,
                           const TQADrawContext *initialContext);
TQAError QAClearZBuffer(const TQADrawContext *drawContext, const TQARect *rect,
                        const TQADrawContext *initialContext);
TQAError QATextureNewFromDrawContext(const TQADrawContext *drawContext, TQAUInt32 flags,
                                     TQATexture **newTexture);
TQAError QABitmapNewFromDrawContext(const TQADrawContext *drawContext, TQAUInt32 flags,
                                    TQABitmap **newBitmap);
TQABoolean QABusy(const TQADrawContext *drawContext);
TQAError QASwapBuffers(const TQADrawContext *drawContext, const TQARect *dirtyRect);

#ifndef RAVE_NO_MACROS
#define QASetFloat(ctx, tag, newValue) ((ctx)->setFloat(ctx, tag, newValue))
#define QASetInt(ctx, tag, newValue) ((ctx)->setInt(ctx, tag, newValue))
#define QASetPtr(ctx, tag, newValue) ((ctx)->setPtr(ctx, tag, newValue))
#define QAGetFloat(ctx, tag) ((ctx)->getFloat(ctx, tag))
#define QAGetInt(ctx, tag) ((ctx)->getInt(ctx, tag))
#define QAGetPtr(ctx, tag) ((ctx)->getPtr(ctx, tag))
#define QADrawPoint(ctx, v) ((ctx)->drawPoint(ctx, v))
#define QADrawLine(ctx, v0, v1) ((ctx)->drawLine(ctx, v0, v1))
#define QADrawTriGouraud(ctx, v0, v1, v2, flags) ((ctx)->drawTriGouraud(ctx, v0, v1, v2, flags))
#define QADrawTriTexture(ctx, v0, v1, v2, flags) ((ctx)->drawTriTexture(ctx, v0, v1, v2, flags))
#define QADrawVGouraud(ctx, nVertices, vertexMode, vertices, flags) \
    ((ctx)->drawVGouraud(ctx, nVertices, vertexMode, vertices, flags))
#define QADrawVTexture(ctx, nVertices, vertexMode, vertices, flags) \
    ((ctx)->drawVTexture(ctx, nVertices, vertexMode, vertices, flags))
#define QADrawBitmap(ctx, v, bitmap) ((ctx)->drawBitmap(ctx, v, bitmap))
#define QARenderStart(ctx, dirtyRect, initialContext) \
    ((ctx)->renderStart(ctx, dirtyRect, initialContext))
#define QARenderEnd(ctx, modifiedRect) ((ctx)->renderEnd(ctx, modifiedRect))
#define QARenderAbort(ctx) ((ctx)->renderAbort(ctx))
#define QAFlush(ctx) ((ctx)->flush(ctx))
#define QASync(ctx) ((ctx)->sync(ctx))
#define QASubmitVerticesGouraud(ctx, nVertices, vertices) \
    ((ctx)->submitVerticesGouraud(ctx, nVertices, vertices))
#define QASubmitVerticesTexture(ctx, nVertices, vertices) \
    ((ctx)->submitVerticesTexture(ctx, nVertices, vertices))
#define QADrawTriMeshGouraud(ctx, nTriangles, triangles) \
    ((ctx)->drawTriMeshGouraud(ctx, nTriangles, triangles))
#define QADrawTriMeshTexture(ctx, nTriangles, triangles) \
    ((ctx)->drawTriMeshTexture(ctx, nTriangles, triangles))
#define QASetNoticeMethod(ctx, method, completionCallBack, refCon) \
    ((ctx)->setNoticeMethod(ctx, method, completionCallBack, refCon))
#define QAGetNoticeMethod(ctx, method, completionCallBack, refCon) \
    ((ctx)->getNoticeMethod(ctx, method, completionCallBack, refCon))
#define QASubmitMultiTextureParams(ctx, nParams, params) \
    ((ctx)->submitMultiTextureParams(ctx, nParams, params))
#define QAAccessDrawBuffer(ctx, buffer) ((ctx)->accessDrawBuffer(ctx, buffer))
#define QAAccessDrawBufferEnd(ctx, dirtyRect) ((ctx)->accessDrawBufferEnd(ctx, dirtyRect))
#define QAAccessZBuffer(ctx, buffer) ((ctx)->accessZBuffer(ctx, buffer))
#define QAAccessZBufferEnd(ctx, dirtyRect) ((ctx)->accessZBufferEnd(ctx, dirtyRect))
#define QAClearDrawBuffer(ctx, rect, initialContext) \
    ((ctx)->clearDrawBuffer(ctx, rect, initialContext))
#define QAClearZBuffer(ctx, rect, initialContext) ((ctx)->clearZBuffer(ctx, rect, initialContext))
#define QATextureNewFromDrawContext(ctx, flags, newTexture) \
    ((ctx)->textureFromContext(ctx, flags, newTexture))
#define QABitmapNewFromDrawContext(ctx, flags, newBitmap) \
    ((ctx)->bitmapFromContext(ctx, flags, newBitmap))
#define QABusy(ctx) ((ctx)->busy(ctx))
#define QASwapBuffers(ctx, dirtyRect) ((ctx)->swapBuffers(ctx, dirtyRect))
#endif

#ifdef __cplusplus
}
#endif

#endif
