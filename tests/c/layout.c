/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * layout.c: size and field offsets of every type of the Glide 2.x interface,
 * for 32-bit and 64-bit pointers. The numbers are those of the original
 * binary interface; on 64-bit targets pointers grow and align to 8.
 */
#include <stddef.h>

#include <glide.h>

#include "check.h"

/* The value that applies to this build's pointer size. */
#define BITS(v32, v64) (sizeof(void *) == 4 ? (size_t)(v32) : (size_t)(v64))
#define SIZE(type, v32, v64) CHECK(sizeof(type) == BITS(v32, v64))
#define FIELD(type, field, v32, v64) CHECK(offsetof(type, field) == BITS(v32, v64))
#define FLOAT(field, index) \
    CHECK(offsetof(GrVertex, field) == sizeof(float) * (index))

static void scalars(void)
{
    CHECK(sizeof(FxU8) == 1 && sizeof(FxI8) == 1);
    CHECK(sizeof(FxU16) == 2 && sizeof(FxI16) == 2);
    CHECK(sizeof(FxU32) == 4 && sizeof(FxI32) == 4);
    CHECK((FxU8)-1 > 0 && (FxU16)-1 > 0 && (FxU32)-1 > 0);
    CHECK((FxI8)-1 < 0 && (FxI16)-1 < 0 && (FxI32)-1 < 0);
    CHECK(sizeof(FxBool) == 4 && (FxBool)-1 < 0);
    CHECK(sizeof(FxFloat) == 4 && sizeof(FxDouble) == 8);
    CHECK(sizeof(GrColor_t) == 4 && (GrColor_t)-1 > 0);
    CHECK(sizeof(GrAlpha_t) == 1 && sizeof(GrFog_t) == 1);
    CHECK(sizeof(GrMipMapId_t) == 4 && (GrMipMapId_t)-1 > 0);
    CHECK(sizeof(GrProc) == sizeof(void (*)(void)));
    CHECK(sizeof(GrErrorCallbackFnc_t) == sizeof(void (*)(void)));
    CHECK(FXBIT(31) == 0x80000000U);
    SIZE(FxColor4, 16, 16);
    FIELD(FxColor4, r, 0, 0);
    FIELD(FxColor4, g, 4, 4);
    FIELD(FxColor4, b, 8, 8);
    FIELD(FxColor4, a, 12, 12);
}

static void enumerations(void)
{
    CHECK(sizeof(GrChipID_t) == 4 && sizeof(GrSstRegister) == 4);
    CHECK(sizeof(GrCombineFunction_t) == 4 && sizeof(GrCombineFactor_t) == 4);
    CHECK(sizeof(GrCombineLocal_t) == 4 && sizeof(GrCombineOther_t) == 4);
    CHECK(sizeof(GrAlphaSource_t) == 4 && sizeof(GrColorCombineFnc_t) == 4);
    CHECK(sizeof(GrAlphaBlendFnc_t) == 4 && sizeof(GrAspectRatio_t) == 4);
    CHECK(sizeof(GrBuffer_t) == 4 && sizeof(GrChromakeyMode_t) == 4);
    CHECK(sizeof(GrCmpFnc_t) == 4 && sizeof(GrColorFormat_t) == 4);
    CHECK(sizeof(GrCullMode_t) == 4 && sizeof(GrDepthBufferMode_t) == 4);
    CHECK(sizeof(GrDitherMode_t) == 4 && sizeof(GrFogMode_t) == 4);
    CHECK(sizeof(GrLock_t) == 4 && sizeof(GrLfbBypassMode_t) == 4);
    CHECK(sizeof(GrLfbWriteMode_t) == 4 && sizeof(GrLfbSrcFmt_t) == 4);
    CHECK(sizeof(GrOriginLocation_t) == 4 && sizeof(GrLOD_t) == 4);
    CHECK(sizeof(GrMipMapMode_t) == 4 && sizeof(GrSmoothingMode_t) == 4);
    CHECK(sizeof(GrTextureClampMode_t) == 4 && sizeof(GrTextureCombineFnc_t) == 4);
    CHECK(sizeof(GrTextureFilterMode_t) == 4 && sizeof(GrTextureFormat_t) == 4);
    CHECK(sizeof(GrTexTable_t) == 4 && sizeof(GrNCCTable_t) == 4);
    CHECK(sizeof(GrTexBaseRange_t) == 4 && sizeof(GrPassthruMode_t) == 4);
    CHECK(sizeof(GrHint_t) == 4 && sizeof(GrSTWHint_t) == 4);
    CHECK(sizeof(GrControl_t) == 4 && sizeof(GrSstType) == 4);
    CHECK(sizeof(GrScreenRefresh_t) == 4 && sizeof(GrScreenResolution_t) == 4);
    CHECK(sizeof(GrMPTextureCombineFnc_t) == 4);
}

static void vertices(void)
{
    SIZE(GrTmuVertex, 12, 12);
    FIELD(GrTmuVertex, sow, 0, 0);
    FIELD(GrTmuVertex, tow, 4, 4);
    FIELD(GrTmuVertex, oow, 8, 8);
    CHECK(sizeof(GrVertex) == 36 + 12 * GLIDE_NUM_TMU);
    FLOAT(x, GR_VERTEX_X_OFFSET);
    FLOAT(y, GR_VERTEX_Y_OFFSET);
    FLOAT(z, GR_VERTEX_Z_OFFSET);
    FLOAT(r, GR_VERTEX_R_OFFSET);
    FLOAT(g, GR_VERTEX_G_OFFSET);
    FLOAT(b, GR_VERTEX_B_OFFSET);
    FLOAT(ooz, GR_VERTEX_OOZ_OFFSET);
    FLOAT(a, GR_VERTEX_A_OFFSET);
    FLOAT(oow, GR_VERTEX_OOW_OFFSET);
    FLOAT(tmuvtx[0].sow, GR_VERTEX_SOW_TMU0_OFFSET);
    FLOAT(tmuvtx[0].tow, GR_VERTEX_TOW_TMU0_OFFSET);
    FLOAT(tmuvtx[0].oow, GR_VERTEX_OOW_TMU0_OFFSET);
#if GLIDE_NUM_TMU > 1
    FLOAT(tmuvtx[1].sow, GR_VERTEX_SOW_TMU1_OFFSET);
    FLOAT(tmuvtx[1].tow, GR_VERTEX_TOW_TMU1_OFFSET);
    FLOAT(tmuvtx[1].oow, GR_VERTEX_OOW_TMU1_OFFSET);
#endif
#if GLIDE_NUM_TMU > 2
    FLOAT(tmuvtx[2].sow, GR_VERTEX_SOW_TMU2_OFFSET);
    FLOAT(tmuvtx[2].tow, GR_VERTEX_TOW_TMU2_OFFSET);
    FLOAT(tmuvtx[2].oow, GR_VERTEX_OOW_TMU2_OFFSET);
#endif
    FIELD(GrVertex, r, 12, 12);
    FIELD(GrVertex, ooz, 24, 24);
    FIELD(GrVertex, a, 28, 28);
    FIELD(GrVertex, oow, 32, 32);
    FIELD(GrVertex, tmuvtx, 36, 36);
}

static void frame_buffer_and_textures(void)
{
    SIZE(GrLfbInfo_t, 20, 32);
    FIELD(GrLfbInfo_t, size, 0, 0);
    FIELD(GrLfbInfo_t, lfbPtr, 4, 8);
    FIELD(GrLfbInfo_t, strideInBytes, 8, 16);
    FIELD(GrLfbInfo_t, writeMode, 12, 20);
    FIELD(GrLfbInfo_t, origin, 16, 24);

    SIZE(GrTexInfo, 20, 24);
    FIELD(GrTexInfo, smallLod, 0, 0);
    FIELD(GrTexInfo, largeLod, 4, 4);
    FIELD(GrTexInfo, aspectRatio, 8, 8);
    FIELD(GrTexInfo, format, 12, 12);
    FIELD(GrTexInfo, data, 16, 16);

    SIZE(GuNccTable, 112, 112);
    FIELD(GuNccTable, yRGB, 0, 0);
    FIELD(GuNccTable, iRGB, 16, 16);
    FIELD(GuNccTable, qRGB, 40, 40);
    FIELD(GuNccTable, packed_data, 64, 64);
    SIZE(GuTexPalette, 1024, 1024);
    SIZE(GuTexTable, 1024, 1024);

    SIZE(Gu3dfHeader, 24, 24);
    FIELD(Gu3dfHeader, width, 0, 0);
    FIELD(Gu3dfHeader, height, 4, 4);
    FIELD(Gu3dfHeader, small_lod, 8, 8);
    FIELD(Gu3dfHeader, large_lod, 12, 12);
    FIELD(Gu3dfHeader, aspect_ratio, 16, 16);
    FIELD(Gu3dfHeader, format, 20, 20);
    SIZE(Gu3dfInfo, 1056, 1064);
    FIELD(Gu3dfInfo, header, 0, 0);
    FIELD(Gu3dfInfo, table, 24, 24);
    FIELD(Gu3dfInfo, data, 1048, 1048);
    FIELD(Gu3dfInfo, mem_required, 1052, 1056);
}

static void mip_map_record(void)
{
    SIZE(GrMipMapInfo, 196, 208);
    FIELD(GrMipMapInfo, sst, 0, 0);
    FIELD(GrMipMapInfo, valid, 4, 4);
    FIELD(GrMipMapInfo, width, 8, 8);
    FIELD(GrMipMapInfo, height, 12, 12);
    FIELD(GrMipMapInfo, aspect_ratio, 16, 16);
    FIELD(GrMipMapInfo, data, 20, 24);
    FIELD(GrMipMapInfo, format, 24, 32);
    FIELD(GrMipMapInfo, mipmap_mode, 28, 36);
    FIELD(GrMipMapInfo, magfilter_mode, 32, 40);
    FIELD(GrMipMapInfo, minfilter_mode, 36, 44);
    FIELD(GrMipMapInfo, s_clamp_mode, 40, 48);
    FIELD(GrMipMapInfo, t_clamp_mode, 44, 52);
    FIELD(GrMipMapInfo, tLOD, 48, 56);
    FIELD(GrMipMapInfo, tTextureMode, 52, 60);
    FIELD(GrMipMapInfo, lod_bias, 56, 64);
    FIELD(GrMipMapInfo, lod_min, 60, 68);
    FIELD(GrMipMapInfo, lod_max, 64, 72);
    FIELD(GrMipMapInfo, tmu, 68, 76);
    FIELD(GrMipMapInfo, odd_even_mask, 72, 80);
    FIELD(GrMipMapInfo, tmu_base_address, 76, 84);
    FIELD(GrMipMapInfo, trilinear, 80, 88);
    FIELD(GrMipMapInfo, ncc_table, 84, 92);

    SIZE(GrMPState, 12, 12);
    FIELD(GrMPState, mmid, 0, 0);
    FIELD(GrMPState, tc_fnc, 8, 8);
}

static void boards(void)
{
    SIZE(GrTMUConfig_t, 8, 8);
    FIELD(GrTMUConfig_t, tmuRev, 0, 0);
    FIELD(GrTMUConfig_t, tmuRam, 4, 4);
    SIZE(GrVoodooConfig_t, 32, 32);
    FIELD(GrVoodooConfig_t, fbRam, 0, 0);
    FIELD(GrVoodooConfig_t, fbiRev, 4, 4);
    FIELD(GrVoodooConfig_t, nTexelfx, 8, 8);
    FIELD(GrVoodooConfig_t, sliDetect, 12, 12);
    FIELD(GrVoodooConfig_t, tmuConfig, 16, 16);
    SIZE(GrVoodoo2Config_t, 32, 32);
    SIZE(GrSst96Config_t, 16, 16);
    FIELD(GrSst96Config_t, fbRam, 0, 0);
    FIELD(GrSst96Config_t, nTexelfx, 4, 4);
    FIELD(GrSst96Config_t, tmuConfig, 8, 8);
    SIZE(GrAT3DConfig_t, 4, 4);
    FIELD(GrAT3DConfig_t, rev, 0, 0);

    SIZE(GrSstConfig_t, 36, 36);
    SIZE(GrHwConfiguration, 148, 148);
    FIELD(GrHwConfiguration, num_sst, 0, 0);
    FIELD(GrHwConfiguration, SSTs[0].type, 4, 4);
    FIELD(GrHwConfiguration, SSTs[0].sstBoard.VoodooConfig.fbRam, 8, 8);
    FIELD(GrHwConfiguration, SSTs[0].sstBoard.VoodooConfig.fbiRev, 12, 12);
    FIELD(GrHwConfiguration, SSTs[0].sstBoard.VoodooConfig.nTexelfx, 16, 16);
    FIELD(GrHwConfiguration, SSTs[0].sstBoard.VoodooConfig.sliDetect, 20, 20);
    FIELD(GrHwConfiguration, SSTs[0].sstBoard.VoodooConfig.tmuConfig[0].tmuRev, 24, 24);
    FIELD(GrHwConfiguration, SSTs[0].sstBoard.SST96Config, 8, 8);
    FIELD(GrHwConfiguration, SSTs[0].sstBoard.AT3DConfig, 8, 8);
    FIELD(GrHwConfiguration, SSTs[1].type, 40, 40);

    SIZE(GrSstPerfStats_t, 20, 20);
    FIELD(GrSstPerfStats_t, pixelsIn, 0, 0);
    FIELD(GrSstPerfStats_t, chromaFail, 4, 4);
    FIELD(GrSstPerfStats_t, zFuncFail, 8, 8);
    FIELD(GrSstPerfStats_t, aFuncFail, 12, 12);
    FIELD(GrSstPerfStats_t, pixelsOut, 16, 16);

    SIZE(GrState, 312, 312);
}

int main(void)
{
    scalars();
    enumerations();
    vertices();
    frame_buffer_and_textures();
    mip_map_record();
    boards();
    return CHECK_REPORT();
}
