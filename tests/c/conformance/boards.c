/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * boards.c: several boards, each with its own state, textures and picture; run
 * it with FILLRATE_BOARDS=2 or more. With one board it checks that a second
 * cannot be chosen.
 */
#include "conformance.h"

static void open_board(int which, GrScreenResolution_t resolution)
{
    grSstSelect(which);
    CHECK(grSstWinOpen(0, resolution, GR_REFRESH_60Hz, GR_COLORFORMAT_ARGB, GR_ORIGIN_UPPER_LEFT, 2, 1));
    grDitherMode(GR_DITHER_DISABLE);
    use_vertex_colors();
}

static GrMipMapId_t load(int shade)
{
    static FxU8 texels[256];
    GrMipMapId_t id;

    memset(texels, shade, sizeof texels);
    id = guTexAllocateMemory(GR_TMU0, GR_MIPMAPLEVELMASK_BOTH, 16, 16, GR_TEXFMT_INTENSITY_8,
                             GR_MIPMAP_DISABLE, GR_LOD_16, GR_LOD_16, GR_ASPECT_1x1,
                             GR_TEXTURECLAMP_WRAP, GR_TEXTURECLAMP_WRAP,
                             GR_TEXTUREFILTER_POINT_SAMPLED, GR_TEXTUREFILTER_POINT_SAMPLED, 0.0f, FXFALSE);
    guTexDownloadMipMap(id, texels, NULL);
    return id;
}

int main(void)
{
    GrHwConfiguration hardware;
    GrMipMapId_t first, second;
    int i;

    grErrorSetCallback(note_error);
    grGlideInit();
    memset(&hardware, 0, sizeof hardware);
    CHECK(grSstQueryBoards(&hardware));
    CHECK(hardware.num_sst >= 1 && hardware.num_sst <= MAX_NUM_SST);
    CHECK(grSstQueryHardware(&hardware));
    for (i = 0; i < hardware.num_sst; i++) {
        CHECK(hardware.SSTs[i].type == GR_SSTTYPE_VOODOO);
        CHECK(hardware.SSTs[i].sstBoard.VoodooConfig.nTexelfx >= 1);
    }
    grSstSelect(hardware.num_sst);
    CHECK(told_once("grSstSelect: "));
    open_board(0, GR_RESOLUTION_320x240);
    first = load(200);
    guTexSource(first);
    clear_to(0x800000);
    if (hardware.num_sst > 1) {
        open_board(1, GR_RESOLUTION_320x200);
        CHECK(grSstScreenHeight() == 200);
        clear_to(0x000080);
        /* Handles and memory are each board's own. */
        CHECK(guTexGetCurrentMipMap(GR_TMU0) == GR_NULL_MIPMAP_HANDLE);
        CHECK(guTexGetMipMapInfo(first) == NULL);
        second = load(90);
        CHECK(second == first);
        CHECK(guTexGetMipMapInfo(second)->sst == 1);
        guTexSource(second);
        grTexCombineFunction(GR_TMU0, GR_TEXTURECOMBINE_DECAL);
        guColorCombineFunction(GR_COLORCOMBINE_DECAL_TEXTURE);
        texture_box(cell(1, 2, 2), 0, 0, 256, 256);
        CHECK(read_pixel(GR_BUFFER_BACKBUFFER, 200, 20) == pack565(90, 90, 90));
        grBufferSwap(0);
        grSstSelect(0);
        CHECK(grSstScreenHeight() == HIGH && guTexGetMipMapInfo(first)->sst == 0);
    }
    /* The first board has kept everything. */
    CHECK(read_pixel(GR_BUFFER_BACKBUFFER, 200, 20) == pack565(0x80, 0, 0));
    CHECK(guTexGetCurrentMipMap(GR_TMU0) == first);
    grTexCombineFunction(GR_TMU0, GR_TEXTURECOMBINE_DECAL);
    fill_box(cell(0, 2, 2), 255, 255, 200, 0);
    guColorCombineFunction(GR_COLORCOMBINE_DECAL_TEXTURE);
    texture_box(cell(3, 2, 2), 0, 0, 256, 256);
    CHECK(middle(cell(3, 2, 2)) == pack565(200, 200, 200));
    grBufferSwap(0);
    if (hardware.num_sst > 1) {
        grSstSelect(1);
        grSstWinClose();
        grSstSelect(0);
        CHECK(grSstScreenWidth() == WIDE);
    }
    return finish();
}
