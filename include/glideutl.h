/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * glideutl.h: the Glide utility library (gu functions): ready-made combine
 * modes, fog tables, clipping, the texture manager, .3df files.
 */
#ifndef FILLRATE_GLIDEUTL_H
#define FILLRATE_GLIDEUTL_H

#ifndef __GLIDEUTL_H__
#define __GLIDEUTL_H__
#endif

#include "glide.h"

#ifndef FX_GLIDE_NO_FUNC_PROTO

#ifdef __cplusplus
extern "C" {
#endif

/* Combine units by name. */
FX_ENTRY void FX_CALL guAlphaSource(GrAlphaSource_t mode);
FX_ENTRY void FX_CALL guColorCombineFunction(GrColorCombineFnc_t fnc);
FX_ENTRY void FX_CALL guTexCombineFunction(GrChipID_t tmu, GrTextureCombineFnc_t fnc);

/* Fog tables over eye distance w. guFogTableIndexToW gives the distance, from
 * 1 to about 52429, that entry i (0..63) stands for. */
FX_ENTRY float FX_CALL guFogTableIndexToW(int i);
FX_ENTRY void  FX_CALL guFogGenerateExp(GrFog_t fogtable[GR_FOG_TABLE_SIZE], float density);
FX_ENTRY void  FX_CALL guFogGenerateExp2(GrFog_t fogtable[GR_FOG_TABLE_SIZE], float density);
FX_ENTRY void  FX_CALL guFogGenerateLinear(
    GrFog_t fogtable[GR_FOG_TABLE_SIZE], float nearZ, float farZ);

/* Clips to the window of grClipWindow, then draws. No clipping in z. */
FX_ENTRY void FX_CALL guDrawTriangleWithClip(
    const GrVertex *a, const GrVertex *b, const GrVertex *c);
FX_ENTRY void FX_CALL guAADrawTriangleWithClip(
    const GrVertex *a, const GrVertex *b, const GrVertex *c);
FX_ENTRY void FX_CALL guDrawPolygonVertexListWithClip(int nverts, const GrVertex vlist[]);

/* Texture manager: hands out texture memory and remembers how each mip map
 * is to be sampled. */
FX_ENTRY GrMipMapId_t FX_CALL guTexAllocateMemory(
    GrChipID_t tmu, FxU8 odd_even_mask, int width, int height,
    GrTextureFormat_t fmt, GrMipMapMode_t mm_mode,
    GrLOD_t smallest_lod, GrLOD_t largest_lod, GrAspectRatio_t aspect,
    GrTextureClampMode_t s_clamp_mode, GrTextureClampMode_t t_clamp_mode,
    GrTextureFilterMode_t minfilter_mode, GrTextureFilterMode_t magfilter_mode,
    float lod_bias, FxBool trilinear);

/* -1 in a field keeps what is there. */
FX_ENTRY FxBool FX_CALL guTexChangeAttributes(
    GrMipMapId_t mmid, int width, int height,
    GrTextureFormat_t fmt, GrMipMapMode_t mm_mode,
    GrLOD_t smallest_lod, GrLOD_t largest_lod, GrAspectRatio_t aspect,
    GrTextureClampMode_t s_clamp_mode, GrTextureClampMode_t t_clamp_mode,
    GrTextureFilterMode_t minFilterMode, GrTextureFilterMode_t magFilterMode);
FX_ENTRY void FX_CALL guTexDownloadMipMap(
    GrMipMapId_t mmid, const void *src, const GuNccTable *table);
FX_ENTRY void FX_CALL guTexDownloadMipMapLevel(
    GrMipMapId_t mmid, GrLOD_t lod, const void **src);
FX_ENTRY void FX_CALL guTexSource(GrMipMapId_t id);
FX_ENTRY GrMipMapId_t   FX_CALL guTexGetCurrentMipMap(GrChipID_t tmu);
FX_ENTRY GrMipMapInfo * FX_CALL guTexGetMipMapInfo(GrMipMapId_t mmid);
FX_ENTRY FxU32          FX_CALL guTexMemQueryAvail(GrChipID_t tmu);
FX_ENTRY void           FX_CALL guTexMemReset(void);

/* A malloc'ed 565 mip map, 256 to 1, one plain colour per level. */
FX_ENTRY FxU16 * FX_CALL guTexCreateColorMipMap(void);

/* .3df texture files: ask for the size, allocate info->data, load. */
FX_ENTRY FxBool FX_CALL gu3dfGetInfo(const char *filename, Gu3dfInfo *info);
FX_ENTRY FxBool FX_CALL gu3dfLoad(const char *filename, Gu3dfInfo *info);

/* Byte order, and run-length coding of a 565 picture: returns the bytes
 * written, or only counts them when dst is null. */
FX_ENTRY FxU32 FX_CALL guEndianSwapWords(FxU32 value);
FX_ENTRY FxU16 FX_CALL guEndianSwapBytes(FxU16 value);
FX_ENTRY int   FX_CALL guEncodeRLE16(void *dst, void *src, FxU32 width, FxU32 height);

/* Movie playback: named, never provided. */
FX_ENTRY void FX_CALL guMovieStart(void);
FX_ENTRY void FX_CALL guMovieStop(void);
FX_ENTRY void FX_CALL guMovieSetName(const char *name);

/* Glide 2.0 to 2.3: 16-bit rectangles from and to the frame buffer chosen
 * with grLfbGetReadPtr and grLfbGetWritePtr. */
FX_ENTRY void FX_CALL guFbReadRegion(
    int src_x, int src_y, int src_width, int src_height,
    void *dst_data, int dst_stride);
FX_ENTRY void FX_CALL guFbWriteRegion(
    int dst_x, int dst_y, int src_width, int src_height,
    const void *src_data, int src_stride);

#ifdef __cplusplus
}
#endif

#endif /* FX_GLIDE_NO_FUNC_PROTO */

#include "gump.h"

#endif /* FILLRATE_GLIDEUTL_H */
