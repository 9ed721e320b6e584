/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * glide.h: the Glide 2.x rasterization API for Voodoo Graphics (SST-1).
 *
 * Types, constants and functions of Glide 2.2 and 2.4x, and at the end the
 * names of Glide 2.0 to 2.3 that later releases dropped. Written from the
 * published description of the interface (Glide 2.2 Programming Guide and
 * Reference Manual, the open-sourced Glide 2.46); plain C89.
 *
 * Units used throughout, unless a comment says otherwise:
 *   x, y          pixels; (0.5, 0.5) is the centre of the first pixel
 *   colour parts  0..255, as float in vertices, as bytes in packed words
 *   depth         0..65535
 *   addresses     bytes of texture memory, multiples of 8
 *   tmu           GR_TMU0, GR_TMU1 or GR_TMU2
 *
 * Define FX_GLIDE_NO_FUNC_PROTO before including to get types and constants
 * only, for programs that look the functions up at run time.
 */
#ifndef FILLRATE_GLIDE_H
#define FILLRATE_GLIDE_H

#ifndef __GLIDE_H__
#define __GLIDE_H__
#endif

#include "3dfx.h"
#include "glidesys.h"
#include "sst1vid.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ------------------------------------------------------------------------
 * Limits and fixed values
 * --------------------------------------------------------------------- */

#define MAX_NUM_SST             4     /* boards in one machine */
#define MAX_MIPMAPS_PER_SST     1024  /* mip maps the gu texture manager can name */
#define GR_FOG_TABLE_SIZE       64    /* entries of a fog table */
#define GR_NULL_MIPMAP_HANDLE   ((GrMipMapId_t)0xffffffffU)

/* Depth values at the two ends of the range. A z buffer holds large numbers
 * near the eye, a w buffer large numbers far away. */
#define GR_ZDEPTHVALUE_NEAREST  0xffff
#define GR_ZDEPTHVALUE_FARTHEST 0x0000
#define GR_WDEPTHVALUE_NEAREST  0x0000
#define GR_WDEPTHVALUE_FARTHEST 0xffff

/* Which levels of a mip map a call works on: those with an even LOD number,
 * those with an odd one, or all. Two TMUs share a trilinear texture this way. */
#define GR_MIPMAPLEVELMASK_EVEN 0x1
#define GR_MIPMAPLEVELMASK_ODD  0x2
#define GR_MIPMAPLEVELMASK_BOTH (GR_MIPMAPLEVELMASK_EVEN | GR_MIPMAPLEVELMASK_ODD)

/* Usual arguments of grTexLodBiasValue. */
#define GR_LODBIAS_BILINEAR     0.5
#define GR_LODBIAS_TRILINEAR    0.0

/* ------------------------------------------------------------------------
 * Scalar types
 * --------------------------------------------------------------------- */

typedef FxU32 GrColor_t;     /* packed in the byte order given at open */
typedef FxU8  GrAlpha_t;     /* 0..255 */
typedef FxU8  GrFog_t;       /* 0 clear .. 255 all fog */
typedef FxU32 GrMipMapId_t;  /* from guTexAllocateMemory */
typedef FxU32 GrSstRegister; /* index of a 32-bit chip register */
typedef int (FX_CALL *GrProc)(void);

/* ------------------------------------------------------------------------
 * Enumerations. Each is a 32-bit integer with named values.
 * --------------------------------------------------------------------- */

typedef FxI32 GrChipID_t;
#define GR_TMU0 0x0
#define GR_TMU1 0x1
#define GR_TMU2 0x2
#define GR_FBI  0x3

/* Combine unit: the arithmetic between "other" and "local". */
typedef FxI32 GrCombineFunction_t;
#define GR_COMBINE_FUNCTION_ZERO                                    0x0
#define GR_COMBINE_FUNCTION_NONE                                    GR_COMBINE_FUNCTION_ZERO
#define GR_COMBINE_FUNCTION_LOCAL                                   0x1
#define GR_COMBINE_FUNCTION_LOCAL_ALPHA                             0x2
#define GR_COMBINE_FUNCTION_SCALE_OTHER                             0x3
#define GR_COMBINE_FUNCTION_BLEND_OTHER                             GR_COMBINE_FUNCTION_SCALE_OTHER
#define GR_COMBINE_FUNCTION_SCALE_OTHER_ADD_LOCAL                   0x4
#define GR_COMBINE_FUNCTION_SCALE_OTHER_ADD_LOCAL_ALPHA             0x5
#define GR_COMBINE_FUNCTION_SCALE_OTHER_MINUS_LOCAL                 0x6
#define GR_COMBINE_FUNCTION_SCALE_OTHER_MINUS_LOCAL_ADD_LOCAL       0x7
#define GR_COMBINE_FUNCTION_BLEND                                   GR_COMBINE_FUNCTION_SCALE_OTHER_MINUS_LOCAL_ADD_LOCAL
#define GR_COMBINE_FUNCTION_SCALE_OTHER_MINUS_LOCAL_ADD_LOCAL_ALPHA 0x8
#define GR_COMBINE_FUNCTION_SCALE_MINUS_LOCAL_ADD_LOCAL             0x9
#define GR_COMBINE_FUNCTION_BLEND_LOCAL                             GR_COMBINE_FUNCTION_SCALE_MINUS_LOCAL_ADD_LOCAL
#define GR_COMBINE_FUNCTION_SCALE_MINUS_LOCAL_ADD_LOCAL_ALPHA       0x10

/* Combine unit: the scale factor. Bit 3 means "one minus". */
typedef FxI32 GrCombineFactor_t;
#define GR_COMBINE_FACTOR_ZERO                    0x0
#define GR_COMBINE_FACTOR_NONE                    GR_COMBINE_FACTOR_ZERO
#define GR_COMBINE_FACTOR_LOCAL                   0x1
#define GR_COMBINE_FACTOR_OTHER_ALPHA             0x2
#define GR_COMBINE_FACTOR_LOCAL_ALPHA             0x3
#define GR_COMBINE_FACTOR_TEXTURE_ALPHA           0x4
#define GR_COMBINE_FACTOR_DETAIL_FACTOR           GR_COMBINE_FACTOR_TEXTURE_ALPHA
#define GR_COMBINE_FACTOR_TEXTURE_RGB             0x5
#define GR_COMBINE_FACTOR_LOD_FRACTION            0x5
#define GR_COMBINE_FACTOR_ONE                     0x8
#define GR_COMBINE_FACTOR_ONE_MINUS_LOCAL         0x9
#define GR_COMBINE_FACTOR_ONE_MINUS_OTHER_ALPHA   0xa
#define GR_COMBINE_FACTOR_ONE_MINUS_LOCAL_ALPHA   0xb
#define GR_COMBINE_FACTOR_ONE_MINUS_TEXTURE_ALPHA 0xc
#define GR_COMBINE_FACTOR_ONE_MINUS_DETAIL_FACTOR GR_COMBINE_FACTOR_ONE_MINUS_TEXTURE_ALPHA
#define GR_COMBINE_FACTOR_ONE_MINUS_LOD_FRACTION  0xd

typedef FxI32 GrCombineLocal_t;
#define GR_COMBINE_LOCAL_ITERATED 0x0
#define GR_COMBINE_LOCAL_CONSTANT 0x1
#define GR_COMBINE_LOCAL_NONE     GR_COMBINE_LOCAL_CONSTANT
#define GR_COMBINE_LOCAL_DEPTH    0x2  /* alpha unit only */

typedef FxI32 GrCombineOther_t;
#define GR_COMBINE_OTHER_ITERATED 0x0
#define GR_COMBINE_OTHER_TEXTURE  0x1
#define GR_COMBINE_OTHER_CONSTANT 0x2
#define GR_COMBINE_OTHER_NONE     GR_COMBINE_OTHER_CONSTANT

/* Ready-made alpha combine set-ups for guAlphaSource. */
typedef FxI32 GrAlphaSource_t;
#define GR_ALPHASOURCE_CC_ALPHA                           0x0
#define GR_ALPHASOURCE_ITERATED_ALPHA                     0x1
#define GR_ALPHASOURCE_TEXTURE_ALPHA                      0x2
#define GR_ALPHASOURCE_TEXTURE_ALPHA_TIMES_ITERATED_ALPHA 0x3

/* Ready-made colour combine set-ups for guColorCombineFunction. CCRGB is the
 * constant colour, ITRGB the iterated (vertex) colour. */
typedef FxI32 GrColorCombineFnc_t;
#define GR_COLORCOMBINE_ZERO                          0x0
#define GR_COLORCOMBINE_CCRGB                         0x1
#define GR_COLORCOMBINE_ITRGB                         0x2
#define GR_COLORCOMBINE_ITRGB_DELTA0                  0x3
#define GR_COLORCOMBINE_DECAL_TEXTURE                 0x4
#define GR_COLORCOMBINE_TEXTURE_TIMES_CCRGB           0x5
#define GR_COLORCOMBINE_TEXTURE_TIMES_ITRGB           0x6
#define GR_COLORCOMBINE_TEXTURE_TIMES_ITRGB_DELTA0    0x7
#define GR_COLORCOMBINE_TEXTURE_TIMES_ITRGB_ADD_ALPHA 0x8
#define GR_COLORCOMBINE_TEXTURE_TIMES_ALPHA           0x9
#define GR_COLORCOMBINE_TEXTURE_TIMES_ALPHA_ADD_ITRGB 0xa
#define GR_COLORCOMBINE_TEXTURE_ADD_ITRGB             0xb
#define GR_COLORCOMBINE_TEXTURE_SUB_ITRGB             0xc
#define GR_COLORCOMBINE_CCRGB_BLEND_ITRGB_ON_TEXALPHA 0xd
#define GR_COLORCOMBINE_DIFF_SPEC_A                   0xe
#define GR_COLORCOMBINE_DIFF_SPEC_B                   0xf
#define GR_COLORCOMBINE_ONE                           0x10

/* Blend factors. The colour factor is the destination colour when used as a
 * source factor and the source colour when used as a destination factor. */
typedef FxI32 GrAlphaBlendFnc_t;
#define GR_BLEND_ZERO                0x0
#define GR_BLEND_SRC_ALPHA           0x1
#define GR_BLEND_SRC_COLOR           0x2
#define GR_BLEND_DST_COLOR           GR_BLEND_SRC_COLOR
#define GR_BLEND_DST_ALPHA           0x3
#define GR_BLEND_ONE                 0x4
#define GR_BLEND_ONE_MINUS_SRC_ALPHA 0x5
#define GR_BLEND_ONE_MINUS_SRC_COLOR 0x6
#define GR_BLEND_ONE_MINUS_DST_COLOR GR_BLEND_ONE_MINUS_SRC_COLOR
#define GR_BLEND_ONE_MINUS_DST_ALPHA 0x7
#define GR_BLEND_RESERVED_8          0x8
#define GR_BLEND_RESERVED_9          0x9
#define GR_BLEND_RESERVED_A          0xa
#define GR_BLEND_RESERVED_B          0xb
#define GR_BLEND_RESERVED_C          0xc
#define GR_BLEND_RESERVED_D          0xd
#define GR_BLEND_RESERVED_E          0xe
#define GR_BLEND_ALPHA_SATURATE      0xf                      /* source factor */
#define GR_BLEND_PREFOG_COLOR        GR_BLEND_ALPHA_SATURATE  /* destination factor */

/* Width : height of a texture. */
typedef FxI32 GrAspectRatio_t;
#define GR_ASPECT_8x1 0x0
#define GR_ASPECT_4x1 0x1
#define GR_ASPECT_2x1 0x2
#define GR_ASPECT_1x1 0x3
#define GR_ASPECT_1x2 0x4
#define GR_ASPECT_1x4 0x5
#define GR_ASPECT_1x8 0x6

typedef FxI32 GrBuffer_t;
#define GR_BUFFER_FRONTBUFFER  0x0
#define GR_BUFFER_BACKBUFFER   0x1
#define GR_BUFFER_AUXBUFFER    0x2
#define GR_BUFFER_DEPTHBUFFER  0x3
#define GR_BUFFER_ALPHABUFFER  0x4
#define GR_BUFFER_TRIPLEBUFFER 0x5

typedef FxI32 GrChromakeyMode_t;
#define GR_CHROMAKEY_DISABLE 0x0
#define GR_CHROMAKEY_ENABLE  0x1

/* Comparison: new value, operator, stored value. */
typedef FxI32 GrCmpFnc_t;
#define GR_CMP_NEVER    0x0
#define GR_CMP_LESS     0x1
#define GR_CMP_EQUAL    0x2
#define GR_CMP_LEQUAL   0x3
#define GR_CMP_GREATER  0x4
#define GR_CMP_NOTEQUAL 0x5
#define GR_CMP_GEQUAL   0x6
#define GR_CMP_ALWAYS   0x7

/* Order of the parts in a packed colour, most significant byte first. */
typedef FxI32 GrColorFormat_t;
#define GR_COLORFORMAT_ARGB 0x0
#define GR_COLORFORMAT_ABGR 0x1
#define GR_COLORFORMAT_RGBA 0x2
#define GR_COLORFORMAT_BGRA 0x3

/* Sign of the triangle area, computed with y as the program gives it. */
typedef FxI32 GrCullMode_t;
#define GR_CULL_DISABLE  0x0
#define GR_CULL_NEGATIVE 0x1
#define GR_CULL_POSITIVE 0x2

typedef FxI32 GrDepthBufferMode_t;
#define GR_DEPTHBUFFER_DISABLE                 0x0
#define GR_DEPTHBUFFER_ZBUFFER                 0x1
#define GR_DEPTHBUFFER_WBUFFER                 0x2
#define GR_DEPTHBUFFER_ZBUFFER_COMPARE_TO_BIAS 0x3
#define GR_DEPTHBUFFER_WBUFFER_COMPARE_TO_BIAS 0x4

typedef FxI32 GrDitherMode_t;
#define GR_DITHER_DISABLE 0x0
#define GR_DITHER_2x2     0x1
#define GR_DITHER_4x4     0x2

/* Source of the fog factor, with optional flags. */
typedef FxI32 GrFogMode_t;
#define GR_FOG_DISABLE             0x0
#define GR_FOG_WITH_ITERATED_ALPHA 0x1
#define GR_FOG_WITH_TABLE          0x2
#define GR_FOG_WITH_ITERATED_Z     0x3
#define GR_FOG_MULT2               0x100  /* leave the incoming colour out */
#define GR_FOG_ADD2                0x200  /* leave the fog colour out */

/* Type of a frame buffer lock, with optional flag. */
typedef FxU32 GrLock_t;
#define GR_LFB_READ_ONLY  0x00
#define GR_LFB_WRITE_ONLY 0x01
#define GR_LFB_IDLE       0x00
#define GR_LFB_NOIDLE     0x10  /* do not wait for pending drawing */

typedef FxI32 GrLfbBypassMode_t;
#define GR_LFBBYPASS_DISABLE 0x0
#define GR_LFBBYPASS_ENABLE  0x1

/* Layout of the pixels a program stores through a lock. */
typedef FxI32 GrLfbWriteMode_t;
#define GR_LFBWRITEMODE_565        0x0
#define GR_LFBWRITEMODE_555        0x1
#define GR_LFBWRITEMODE_1555       0x2
#define GR_LFBWRITEMODE_RESERVED1  0x3
#define GR_LFBWRITEMODE_888        0x4
#define GR_LFBWRITEMODE_8888       0x5
#define GR_LFBWRITEMODE_RESERVED2  0x6
#define GR_LFBWRITEMODE_RESERVED3  0x7
#define GR_LFBWRITEMODE_RESERVED4  0x8
#define GR_LFBWRITEMODE_RESERVED5  0x9
#define GR_LFBWRITEMODE_RESERVED6  0xa
#define GR_LFBWRITEMODE_RESERVED7  0xb
#define GR_LFBWRITEMODE_565_DEPTH  0xc
#define GR_LFBWRITEMODE_555_DEPTH  0xd
#define GR_LFBWRITEMODE_1555_DEPTH 0xe
#define GR_LFBWRITEMODE_ZA16       0xf
#define GR_LFBWRITEMODE_ANY        0xff

/* Layout of the pixels passed to grLfbWriteRegion. */
typedef FxI32 GrLfbSrcFmt_t;
#define GR_LFB_SRC_FMT_565        0x00
#define GR_LFB_SRC_FMT_555        0x01
#define GR_LFB_SRC_FMT_1555       0x02
#define GR_LFB_SRC_FMT_888        0x04
#define GR_LFB_SRC_FMT_8888       0x05
#define GR_LFB_SRC_FMT_565_DEPTH  0x0c
#define GR_LFB_SRC_FMT_555_DEPTH  0x0d
#define GR_LFB_SRC_FMT_1555_DEPTH 0x0e
#define GR_LFB_SRC_FMT_ZA16       0x0f
#define GR_LFB_SRC_FMT_RLE16      0x80

typedef FxI32 GrOriginLocation_t;
#define GR_ORIGIN_UPPER_LEFT 0x0
#define GR_ORIGIN_LOWER_LEFT 0x1
#define GR_ORIGIN_ANY        0xff

/* Longest side of a mip map level. A larger number is a smaller map. */
typedef FxI32 GrLOD_t;
#define GR_LOD_256 0x0
#define GR_LOD_128 0x1
#define GR_LOD_64  0x2
#define GR_LOD_32  0x3
#define GR_LOD_16  0x4
#define GR_LOD_8   0x5
#define GR_LOD_4   0x6
#define GR_LOD_2   0x7
#define GR_LOD_1   0x8

typedef FxI32 GrMipMapMode_t;
#define GR_MIPMAP_DISABLE        0x0
#define GR_MIPMAP_NEAREST        0x1
#define GR_MIPMAP_NEAREST_DITHER 0x2

typedef FxI32 GrSmoothingMode_t;
#define GR_SMOOTHING_DISABLE 0x0
#define GR_SMOOTHING_ENABLE  0x1

typedef FxI32 GrTextureClampMode_t;
#define GR_TEXTURECLAMP_WRAP  0x0
#define GR_TEXTURECLAMP_CLAMP 0x1

/* Ready-made TMU set-ups for grTexCombineFunction and guTexCombineFunction. */
typedef FxI32 GrTextureCombineFnc_t;
#define GR_TEXTURECOMBINE_ZERO           0x0
#define GR_TEXTURECOMBINE_DECAL          0x1
#define GR_TEXTURECOMBINE_OTHER          0x2
#define GR_TEXTURECOMBINE_ADD            0x3
#define GR_TEXTURECOMBINE_MULTIPLY       0x4
#define GR_TEXTURECOMBINE_SUBTRACT       0x5
#define GR_TEXTURECOMBINE_DETAIL         0x6
#define GR_TEXTURECOMBINE_DETAIL_OTHER   0x7
#define GR_TEXTURECOMBINE_TRILINEAR_ODD  0x8
#define GR_TEXTURECOMBINE_TRILINEAR_EVEN 0x9
#define GR_TEXTURECOMBINE_ONE            0xa

typedef FxI32 GrTextureFilterMode_t;
#define GR_TEXTUREFILTER_POINT_SAMPLED 0x0
#define GR_TEXTUREFILTER_BILINEAR      0x1

/* Texel formats: below 8 one byte per texel, from 8 on two bytes. */
typedef FxI32 GrTextureFormat_t;
#define GR_TEXFMT_8BIT               0x0
#define GR_TEXFMT_RGB_332            GR_TEXFMT_8BIT
#define GR_TEXFMT_YIQ_422            0x1
#define GR_TEXFMT_ALPHA_8            0x2
#define GR_TEXFMT_INTENSITY_8        0x3
#define GR_TEXFMT_ALPHA_INTENSITY_44 0x4
#define GR_TEXFMT_P_8                0x5
#define GR_TEXFMT_RSVD0              0x6
#define GR_TEXFMT_RSVD1              0x7
#define GR_TEXFMT_16BIT              0x8
#define GR_TEXFMT_ARGB_8332          GR_TEXFMT_16BIT
#define GR_TEXFMT_AYIQ_8422          0x9
#define GR_TEXFMT_RGB_565            0xa
#define GR_TEXFMT_ARGB_1555          0xb
#define GR_TEXFMT_ARGB_4444          0xc
#define GR_TEXFMT_ALPHA_INTENSITY_88 0xd
#define GR_TEXFMT_AP_88              0xe
#define GR_TEXFMT_RSVD2              0xf

/* Tables of a TMU: two narrow-channel decompression tables, one palette. */
typedef FxU32 GrTexTable_t;
#define GR_TEXTABLE_NCC0    0x0
#define GR_TEXTABLE_NCC1    0x1
#define GR_TEXTABLE_PALETTE 0x2

typedef FxU32 GrNCCTable_t;
#define GR_NCCTABLE_NCC0 0x0
#define GR_NCCTABLE_NCC1 0x1

/* Group of levels that grTexMultibaseAddress gives an address of their own. */
typedef FxU32 GrTexBaseRange_t;
#define GR_TEXBASE_256     0x0
#define GR_TEXBASE_128     0x1
#define GR_TEXBASE_64      0x2
#define GR_TEXBASE_32_TO_1 0x3

typedef FxI32 GrPassthruMode_t;
#define GR_PASSTHRU_SHOW_VGA  0x0
#define GR_PASSTHRU_SHOW_SST1 0x1

/* Hints: what the program promises or asks for. */
typedef FxU32 GrHint_t;
#define GR_HINT_STWHINT             0x0
#define GR_HINT_FIFOCHECKHINT       0x1
#define GR_HINT_FPUPRECISION        0x2
#define GR_HINT_ALLOW_MIPMAP_DITHER 0x3
#define GR_HINT_LFB_WRITE           0x4
#define GR_HINT_LFB_PROTECT         0x5
#define GR_HINT_LFB_RESET           0x6
#define GR_HINTTYPE_MIN             0x0
#define GR_HINTTYPE_MAX             0x6

/* Mask for GR_HINT_STWHINT: which units read their own w or s and t. */
typedef FxU32 GrSTWHint_t;
#define GR_STWHINT_W_DIFF_FBI   0x01
#define GR_STWHINT_W_DIFF_TMU0  0x02
#define GR_STWHINT_ST_DIFF_TMU0 0x04
#define GR_STWHINT_W_DIFF_TMU1  0x08
#define GR_STWHINT_ST_DIFF_TMU1 0x10
#define GR_STWHINT_W_DIFF_TMU2  0x20
#define GR_STWHINT_ST_DIFF_TMU2 0x40

/* Mask for GR_HINT_FIFOCHECKHINT. */
#define GR_GENERATE_FIFOCHECK_HINT_MASK(swHWM, swLWM) \
    ((((FxU32)(swHWM) & 0xffffU) << 16) | ((FxU32)(swLWM) & 0xffffU))

typedef FxU32 GrControl_t;
#define GR_CONTROL_ACTIVATE   0x1
#define GR_CONTROL_DEACTIVATE 0x2
#define GR_CONTROL_RESIZE     0x3
#define GR_CONTROL_MOVE       0x4

typedef FxI32 GrSstType;
#define GR_SSTTYPE_VOODOO  0
#define GR_SSTTYPE_SST96   1
#define GR_SSTTYPE_AT3D    2
#define GR_SSTTYPE_Voodoo2 3
#define GR_SSTTYPE_Banshee 4

/* ------------------------------------------------------------------------
 * Vertices. All fields are 32-bit floats; the order is the binary interface
 * and differs from the one the Programming Guide prints.
 * --------------------------------------------------------------------- */

/* Texture coordinates for one TMU. s and t run over 0..256 along the longer
 * side of the map, whatever its size, and are stored divided by w. */
typedef struct {
    float sow;  /* s / w */
    float tow;  /* t / w */
    float oow;  /* 1 / w for this TMU; read only after a W_DIFF hint */
} GrTmuVertex;

typedef struct {
    float x, y;      /* pixels, -2048..2047, kept to 1/16 pixel */
    float z;         /* never read by the library */
    float r, g, b;   /* 0..255 */
    float ooz;       /* linear in 1/z, 0..65535: the z buffer's value */
    float a;         /* 0..255 */
    float oow;       /* 1 / w: perspective, w buffer, table fog */
    GrTmuVertex tmuvtx[GLIDE_NUM_TMU];
} GrVertex;

/* Position of each field when a GrVertex is seen as an array of floats. */
#define GR_VERTEX_X_OFFSET        0
#define GR_VERTEX_Y_OFFSET        1
#define GR_VERTEX_Z_OFFSET        2
#define GR_VERTEX_R_OFFSET        3
#define GR_VERTEX_G_OFFSET        4
#define GR_VERTEX_B_OFFSET        5
#define GR_VERTEX_OOZ_OFFSET      6
#define GR_VERTEX_A_OFFSET        7
#define GR_VERTEX_OOW_OFFSET      8
#define GR_VERTEX_SOW_TMU0_OFFSET 9
#define GR_VERTEX_TOW_TMU0_OFFSET 10
#define GR_VERTEX_OOW_TMU0_OFFSET 11
#define GR_VERTEX_SOW_TMU1_OFFSET 12
#define GR_VERTEX_TOW_TMU1_OFFSET 13
#define GR_VERTEX_OOW_TMU1_OFFSET 14
#define GR_VERTEX_SOW_TMU2_OFFSET 15
#define GR_VERTEX_TOW_TMU2_OFFSET 16
#define GR_VERTEX_OOW_TMU2_OFFSET 17

/* ------------------------------------------------------------------------
 * Other structures
 * --------------------------------------------------------------------- */

/* Result of grLfbLock. Set `size` to sizeof(GrLfbInfo_t) before the call. */
typedef struct {
    int                size;
    void              *lfbPtr;         /* first pixel of the first row */
    FxU32              strideInBytes;  /* from one row to the next */
    GrLfbWriteMode_t   writeMode;      /* the mode in force (write locks) */
    GrOriginLocation_t origin;
} GrLfbInfo_t;

/* A texture: its range of levels, shape, format, and texels in host memory,
 * largest level first, rows packed without padding. */
typedef struct {
    GrLOD_t           smallLod;  /* numerically >= largeLod */
    GrLOD_t           largeLod;
    GrAspectRatio_t   aspectRatio;
    GrTextureFormat_t format;
    void             *data;
} GrTexInfo;

/* Narrow-channel compression table: texel = Y[7:4] + I[3:2] + Q[1:0]. */
typedef struct {
    FxU8  yRGB[16];
    FxI16 iRGB[4][3];       /* signed 9-bit, order R, G, B */
    FxI16 qRGB[4][3];
    FxU32 packed_data[12];  /* the words sent to the chip */
} GuNccTable;

/* Palette: 256 words 0x00RRGGBB. */
typedef struct {
    FxU32 data[256];
} GuTexPalette;

typedef union {
    GuNccTable   nccTable;
    GuTexPalette palette;
} GuTexTable;

/* What a .3df file says about its texture. */
typedef struct {
    FxU32             width, height;  /* texels of the largest level */
    int               small_lod, large_lod;
    GrAspectRatio_t   aspect_ratio;
    GrTextureFormat_t format;
} Gu3dfHeader;

typedef struct {
    Gu3dfHeader header;
    GuTexTable  table;
    void       *data;
    FxU32       mem_required;  /* bytes to allocate for `data` */
} Gu3dfInfo;

/* Record the gu texture manager keeps of each mip map. */
typedef struct {
    int                   sst;     /* board that holds it */
    FxBool                valid;
    int                   width, height;
    GrAspectRatio_t       aspect_ratio;
    void                 *data;
    GrTextureFormat_t     format;
    GrMipMapMode_t        mipmap_mode;
    GrTextureFilterMode_t magfilter_mode;
    GrTextureFilterMode_t minfilter_mode;
    GrTextureClampMode_t  s_clamp_mode;
    GrTextureClampMode_t  t_clamp_mode;
    FxU32                 tLOD;
    FxU32                 tTextureMode;
    FxU32                 lod_bias;
    GrLOD_t               lod_min, lod_max;
    int                   tmu;
    FxU32                 odd_even_mask;
    FxU32                 tmu_base_address;
    FxBool                trilinear;
    GuNccTable            ncc_table;
} GrMipMapInfo;

/* One texture unit of a board. */
typedef struct {
    int tmuRev;
    int tmuRam;  /* MB */
} GrTMUConfig_t;

typedef struct {
    int           fbRam;     /* MB of frame memory */
    int           fbiRev;
    int           nTexelfx;  /* texture units fitted */
    FxBool        sliDetect; /* two boards sharing the scan lines */
    GrTMUConfig_t tmuConfig[2];  /* two, whatever GLIDE_NUM_TMU says */
} GrVoodooConfig_t;

typedef GrVoodooConfig_t GrVoodoo2Config_t;

typedef struct {
    int           fbRam;     /* MB */
    int           nTexelfx;
    GrTMUConfig_t tmuConfig;
} GrSst96Config_t;

typedef struct {
    int rev;
} GrAT3DConfig_t;

typedef struct {
    GrSstType type;  /* says which member of the union is valid */
    union SstBoard_u {
        GrVoodooConfig_t  VoodooConfig;
        GrSst96Config_t   SST96Config;
        GrAT3DConfig_t    AT3DConfig;
        GrVoodoo2Config_t Voodoo2Config;
    } sstBoard;
} GrSstConfig_t;

typedef struct {
    int           num_sst;
    GrSstConfig_t SSTs[MAX_NUM_SST];
} GrHwConfiguration;

/* Pixel counters since the last reset; 24 bits each. */
typedef struct {
    FxU32 pixelsIn;    /* generated by the rasterizer */
    FxU32 chromaFail;  /* stopped by the chroma key */
    FxU32 zFuncFail;   /* stopped by the depth test */
    FxU32 aFuncFail;   /* stopped by the alpha test */
    FxU32 pixelsOut;   /* reached the frame buffer */
} GrSstPerfStats_t;

/* A saved state: opaque, to be passed back to grGlideSetState. */
#define GLIDE_STATE_PAD_SIZE 312
typedef struct {
    char pad[GLIDE_STATE_PAD_SIZE];
} GrState;

/* Error callback. A plain C function on every platform. */
typedef void (*GrErrorCallbackFnc_t)(const char *string, FxBool fatal);

#ifndef FX_GLIDE_NO_FUNC_PROTO

/* ------------------------------------------------------------------------
 * Library and boards
 * --------------------------------------------------------------------- */

FX_ENTRY void FX_CALL grGlideInit(void);
FX_ENTRY void FX_CALL grGlideShutdown(void);
FX_ENTRY void FX_CALL grGlideGetVersion(char version[80]);
FX_ENTRY void FX_CALL grGlideGetState(GrState *state);
FX_ENTRY void FX_CALL grGlideSetState(const GrState *state);
FX_ENTRY void FX_CALL grGlideShamelessPlug(const FxBool on);
FX_ENTRY void FX_CALL grErrorSetCallback(GrErrorCallbackFnc_t fnc);
FX_ENTRY void FX_CALL grHints(GrHint_t hintType, FxU32 hintMask);
FX_ENTRY void FX_CALL grCheckForRoom(FxI32 n);

/* Position and size in pixels; frames from 1 on, 0 for the finished picture. */
FX_ENTRY void FX_CALL grSplash(float x, float y, float width, float height, FxU32 frame);

FX_ENTRY FxBool FX_CALL grSstQueryBoards(GrHwConfiguration *hwConfig);
FX_ENTRY FxBool FX_CALL grSstQueryHardware(GrHwConfiguration *hwConfig);
FX_ENTRY void   FX_CALL grSstSelect(int which_sst);

/* Opens the selected board: 2 or 3 colour buffers, 0 or 1 auxiliary one. */
FX_ENTRY FxBool FX_CALL grSstWinOpen(
    FxU32 hWnd,
    GrScreenResolution_t screen_resolution,
    GrScreenRefresh_t refresh_rate,
    GrColorFormat_t color_format,
    GrOriginLocation_t origin_location,
    int nColBuffers,
    int nAuxBuffers);
FX_ENTRY void   FX_CALL grSstWinClose(void);
FX_ENTRY FxBool FX_CALL grSstControl(FxU32 code);
FX_ENTRY void   FX_CALL grSstOrigin(GrOriginLocation_t origin);
FX_ENTRY FxU32  FX_CALL grSstScreenWidth(void);
FX_ENTRY FxU32  FX_CALL grSstScreenHeight(void);
FX_ENTRY void   FX_CALL grSstIdle(void);
FX_ENTRY FxBool FX_CALL grSstIsBusy(void);
FX_ENTRY FxU32  FX_CALL grSstStatus(void);
FX_ENTRY FxU32  FX_CALL grSstVideoLine(void);
FX_ENTRY FxBool FX_CALL grSstVRetraceOn(void);
FX_ENTRY void   FX_CALL grSstVidMode(FxU32 whichSst, void *vidTimings);
FX_ENTRY void   FX_CALL grSstConfigPipeline(GrChipID_t chip, GrSstRegister reg, FxU32 value);
FX_ENTRY void   FX_CALL grSstPerfStats(GrSstPerfStats_t *pStats);
FX_ENTRY void   FX_CALL grSstResetPerfStats(void);
FX_ENTRY void   FX_CALL grTriStats(FxU32 *trisProcessed, FxU32 *trisDrawn);
FX_ENTRY void   FX_CALL grResetTriStats(void);

/* ------------------------------------------------------------------------
 * Buffers
 * --------------------------------------------------------------------- */

/* Fills the clip window of the render buffer, as far as the masks allow. */
FX_ENTRY void FX_CALL grBufferClear(GrColor_t color, GrAlpha_t alpha, FxU16 depth);

/* Shows the back buffer after `swap_interval` vertical retraces, 0..255. */
FX_ENTRY void FX_CALL grBufferSwap(int swap_interval);
FX_ENTRY int  FX_CALL grBufferNumPending(void);
FX_ENTRY void FX_CALL grRenderBuffer(GrBuffer_t buffer);

/* Minima belong to the window, maxima do not. */
FX_ENTRY void FX_CALL grClipWindow(FxU32 minx, FxU32 miny, FxU32 maxx, FxU32 maxy);
FX_ENTRY void FX_CALL grColorMask(FxBool rgb, FxBool a);
FX_ENTRY void FX_CALL grDepthMask(FxBool mask);

/* ------------------------------------------------------------------------
 * Pixel state
 * --------------------------------------------------------------------- */

FX_ENTRY void FX_CALL grAlphaBlendFunction(
    GrAlphaBlendFnc_t rgb_sf, GrAlphaBlendFnc_t rgb_df,
    GrAlphaBlendFnc_t alpha_sf, GrAlphaBlendFnc_t alpha_df);
FX_ENTRY void FX_CALL grAlphaCombine(
    GrCombineFunction_t function, GrCombineFactor_t factor,
    GrCombineLocal_t local, GrCombineOther_t other, FxBool invert);
FX_ENTRY void FX_CALL grAlphaControlsITRGBLighting(FxBool enable);
FX_ENTRY void FX_CALL grAlphaTestFunction(GrCmpFnc_t function);
FX_ENTRY void FX_CALL grAlphaTestReferenceValue(GrAlpha_t value);
FX_ENTRY void FX_CALL grChromakeyMode(GrChromakeyMode_t mode);
FX_ENTRY void FX_CALL grChromakeyValue(GrColor_t value);
FX_ENTRY void FX_CALL grColorCombine(
    GrCombineFunction_t function, GrCombineFactor_t factor,
    GrCombineLocal_t local, GrCombineOther_t other, FxBool invert);
FX_ENTRY void FX_CALL grConstantColorValue(GrColor_t value);
FX_ENTRY void FX_CALL grConstantColorValue4(float a, float r, float g, float b);
FX_ENTRY void FX_CALL grCullMode(GrCullMode_t mode);
FX_ENTRY void FX_CALL grDepthBiasLevel(FxI16 level);
FX_ENTRY void FX_CALL grDepthBufferFunction(GrCmpFnc_t function);
FX_ENTRY void FX_CALL grDepthBufferMode(GrDepthBufferMode_t mode);
FX_ENTRY void FX_CALL grDisableAllEffects(void);
FX_ENTRY void FX_CALL grDitherMode(GrDitherMode_t mode);
FX_ENTRY void FX_CALL grFogColorValue(GrColor_t fogcolor);
FX_ENTRY void FX_CALL grFogMode(GrFogMode_t mode);
FX_ENTRY void FX_CALL grFogTable(const GrFog_t ft[GR_FOG_TABLE_SIZE]);
FX_ENTRY void FX_CALL grGammaCorrectionValue(float value);

/* ------------------------------------------------------------------------
 * Primitives
 * --------------------------------------------------------------------- */

FX_ENTRY void FX_CALL grDrawPoint(const GrVertex *pt);
FX_ENTRY void FX_CALL grDrawLine(const GrVertex *v1, const GrVertex *v2);
FX_ENTRY void FX_CALL grDrawTriangle(const GrVertex *a, const GrVertex *b, const GrVertex *c);

/* Convex polygons. Planar ones compute their gradients once. */
FX_ENTRY void FX_CALL grDrawPolygon(int nverts, const int ilist[], const GrVertex vlist[]);
FX_ENTRY void FX_CALL grDrawPolygonVertexList(int nverts, const GrVertex vlist[]);
FX_ENTRY void FX_CALL grDrawPlanarPolygon(int nverts, const int ilist[], const GrVertex vlist[]);
FX_ENTRY void FX_CALL grDrawPlanarPolygonVertexList(int nverts, const GrVertex vlist[]);

/* Antialiased forms: blend with iterated alpha to see their soft edges. */
FX_ENTRY void FX_CALL grAADrawPoint(const GrVertex *pt);
FX_ENTRY void FX_CALL grAADrawLine(const GrVertex *v1, const GrVertex *v2);
FX_ENTRY void FX_CALL grAADrawTriangle(
    const GrVertex *a, const GrVertex *b, const GrVertex *c,
    FxBool ab_antialias, FxBool bc_antialias, FxBool ca_antialias);
FX_ENTRY void FX_CALL grAADrawPolygon(int nverts, const int ilist[], const GrVertex vlist[]);
FX_ENTRY void FX_CALL grAADrawPolygonVertexList(int nverts, const GrVertex vlist[]);

/* ------------------------------------------------------------------------
 * Textures
 * --------------------------------------------------------------------- */

FX_ENTRY FxU32 FX_CALL grTexMinAddress(GrChipID_t tmu);
FX_ENTRY FxU32 FX_CALL grTexMaxAddress(GrChipID_t tmu);
FX_ENTRY FxU32 FX_CALL grTexCalcMemRequired(
    GrLOD_t lodmin, GrLOD_t lodmax, GrAspectRatio_t aspect, GrTextureFormat_t fmt);
FX_ENTRY FxU32 FX_CALL grTexTextureMemRequired(FxU32 evenOdd, GrTexInfo *info);

FX_ENTRY void FX_CALL grTexSource(
    GrChipID_t tmu, FxU32 startAddress, FxU32 evenOdd, GrTexInfo *info);
FX_ENTRY void FX_CALL grTexDownloadMipMap(
    GrChipID_t tmu, FxU32 startAddress, FxU32 evenOdd, GrTexInfo *info);
FX_ENTRY void FX_CALL grTexDownloadMipMapLevel(
    GrChipID_t tmu, FxU32 startAddress, GrLOD_t thisLod, GrLOD_t largeLod,
    GrAspectRatio_t aspectRatio, GrTextureFormat_t format,
    FxU32 evenOdd, void *data);
FX_ENTRY void FX_CALL grTexDownloadMipMapLevelPartial(
    GrChipID_t tmu, FxU32 startAddress, GrLOD_t thisLod, GrLOD_t largeLod,
    GrAspectRatio_t aspectRatio, GrTextureFormat_t format,
    FxU32 evenOdd, void *data, int start, int end);
FX_ENTRY void FX_CALL grTexDownloadTable(GrChipID_t tmu, GrTexTable_t type, void *data);
FX_ENTRY void FX_CALL grTexDownloadTablePartial(
    GrChipID_t tmu, GrTexTable_t type, void *data, int start, int end);
FX_ENTRY void FX_CALL grTexNCCTable(GrChipID_t tmu, GrNCCTable_t table);

FX_ENTRY void FX_CALL grTexClampMode(
    GrChipID_t tmu, GrTextureClampMode_t s_clampmode, GrTextureClampMode_t t_clampmode);
FX_ENTRY void FX_CALL grTexCombine(
    GrChipID_t tmu,
    GrCombineFunction_t rgb_function, GrCombineFactor_t rgb_factor,
    GrCombineFunction_t alpha_function, GrCombineFactor_t alpha_factor,
    FxBool rgb_invert, FxBool alpha_invert);
FX_ENTRY void FX_CALL grTexCombineFunction(GrChipID_t tmu, GrTextureCombineFnc_t fnc);

/* lod_bias -32..31 quarters, detail_scale 0..7, detail_max 0..1. */
FX_ENTRY void FX_CALL grTexDetailControl(
    GrChipID_t tmu, int lod_bias, FxU8 detail_scale, float detail_max);
FX_ENTRY void FX_CALL grTexFilterMode(
    GrChipID_t tmu, GrTextureFilterMode_t minfilter_mode, GrTextureFilterMode_t magfilter_mode);

/* -8.0..7.75 levels, in quarters. */
FX_ENTRY void FX_CALL grTexLodBiasValue(GrChipID_t tmu, float bias);
FX_ENTRY void FX_CALL grTexMipMapMode(GrChipID_t tmu, GrMipMapMode_t mode, FxBool lodBlend);
FX_ENTRY void FX_CALL grTexMultibase(GrChipID_t tmu, FxBool enable);
FX_ENTRY void FX_CALL grTexMultibaseAddress(
    GrChipID_t tmu, GrTexBaseRange_t range, FxU32 startAddress,
    FxU32 evenOdd, GrTexInfo *info);

/* Decodes run-length coded 8-bit sprites through a 256-entry 16-bit table
 * into one texture level. */
FX_ENTRY void FX_CALL ConvertAndDownloadRle(
    GrChipID_t tmu, FxU32 startAddress, GrLOD_t thisLod, GrLOD_t largeLod,
    GrAspectRatio_t aspectRatio, GrTextureFormat_t format, FxU32 evenOdd,
    FxU8 *bm_data, FxI32 bm_h, FxU32 u0, FxU32 v0, FxU32 width, FxU32 height,
    FxU32 dest_width, FxU32 dest_height, FxU16 *tlut);

/* ------------------------------------------------------------------------
 * Linear frame buffer. Rows are 1024 pixels apart at every resolution.
 * --------------------------------------------------------------------- */

FX_ENTRY FxBool FX_CALL grLfbLock(
    GrLock_t type, GrBuffer_t buffer, GrLfbWriteMode_t writeMode,
    GrOriginLocation_t origin, FxBool pixelPipeline, GrLfbInfo_t *info);
FX_ENTRY FxBool FX_CALL grLfbUnlock(GrLock_t type, GrBuffer_t buffer);
FX_ENTRY void   FX_CALL grLfbConstantAlpha(GrAlpha_t alpha);
FX_ENTRY void   FX_CALL grLfbConstantDepth(FxU16 depth);
FX_ENTRY void   FX_CALL grLfbWriteColorFormat(GrColorFormat_t colorFormat);
FX_ENTRY void   FX_CALL grLfbWriteColorSwizzle(FxBool swizzleBytes, FxBool swapWords);

/* Rectangles, counted from the upper left corner; strides in bytes. */
FX_ENTRY FxBool FX_CALL grLfbWriteRegion(
    GrBuffer_t dst_buffer, FxU32 dst_x, FxU32 dst_y, GrLfbSrcFmt_t src_format,
    FxU32 src_width, FxU32 src_height, FxI32 src_stride, void *src_data);
FX_ENTRY FxBool FX_CALL grLfbReadRegion(
    GrBuffer_t src_buffer, FxU32 src_x, FxU32 src_y,
    FxU32 src_width, FxU32 src_height, FxU32 dst_stride, void *dst_data);

/* ------------------------------------------------------------------------
 * Glide 2.0 to 2.3 names that 2.4 dropped
 * --------------------------------------------------------------------- */

/* As grSstWinOpen without a window; num_buffers 2 or 3: two have an auxiliary
 * buffer where memory has room for it, three have none. */
FX_ENTRY FxBool FX_CALL grSstOpen(
    GrScreenResolution_t screen_resolution, GrScreenRefresh_t refresh_rate,
    GrColorFormat_t color_format, GrOriginLocation_t origin_location,
    GrSmoothingMode_t smoothing_filter, int num_buffers);
FX_ENTRY void   FX_CALL grSstPassthruMode(GrPassthruMode_t mode);
FX_ENTRY FxBool FX_CALL grSstDetectResources(void);
FX_ENTRY void   FX_CALL grSstControlMode(FxU32 code);
FX_ENTRY FxU32  FX_CALL grSstVRetraceTicks(void);

/* Frame buffer access between grLfbBegin and grLfbEnd, without a lock. */
FX_ENTRY void   FX_CALL grLfbBegin(void);
FX_ENTRY void   FX_CALL grLfbEnd(void);
FX_ENTRY void   FX_CALL grLfbBypassMode(GrLfbBypassMode_t mode);
FX_ENTRY void   FX_CALL grLfbOrigin(GrOriginLocation_t origin);
FX_ENTRY void   FX_CALL grLfbWriteMode(GrLfbWriteMode_t mode);
FX_ENTRY const FxU32 * FX_CALL grLfbGetReadPtr(GrBuffer_t buffer);
FX_ENTRY void * FX_CALL grLfbGetWritePtr(GrBuffer_t buffer);

#endif /* FX_GLIDE_NO_FUNC_PROTO */

#ifdef __cplusplus
}
#endif

#include "glideutl.h"

#endif /* FILLRATE_GLIDE_H */
