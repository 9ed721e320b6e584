/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * gu_textures.c: the texture manager: memory and handles, records, attributes
 * that change, compression tables that take turns, levels that are loaded
 * apart. Handles that are none are answered with an error in checking mode and
 * otherwise change nothing.
 */
#include "conformance.h"

#define BOTH GR_MIPMAPLEVELMASK_BOTH

static GrMipMapId_t allocate(GrTextureFormat_t format, GrLOD_t small, GrLOD_t large)
{
    return guTexAllocateMemory(GR_TMU0, BOTH, 256 >> large, 256 >> large, format, GR_MIPMAP_NEAREST,
                               small, large, GR_ASPECT_1x1, GR_TEXTURECLAMP_WRAP, GR_TEXTURECLAMP_CLAMP,
                               GR_TEXTUREFILTER_POINT_SAMPLED, GR_TEXTUREFILTER_BILINEAR, -0.75f, FXFALSE);
}

static void check_memory(void)
{
    FxU32 all = grTexMaxAddress(GR_TMU0) + 8, chain = grTexCalcMemRequired(GR_LOD_1, GR_LOD_256, GR_ASPECT_1x1, GR_TEXFMT_RGB_565);
    GrMipMapId_t id = 0;
    FxU32 count = 0;

    guTexMemReset();
    CHECK(guTexMemQueryAvail(GR_TMU0) == all);
    CHECK(guTexGetCurrentMipMap(GR_TMU0) == GR_NULL_MIPMAP_HANDLE);
    while ((id = allocate(GR_TEXFMT_RGB_565, GR_LOD_1, GR_LOD_256)) != GR_NULL_MIPMAP_HANDLE) {
        CHECK(id == count);
        count++;
        /* None crosses two megabytes. */
        CHECK(guTexMemQueryAvail(GR_TMU0) == all - (count / 11 * (2U << 20) + count % 11 * chain)
              || count % 11 == 0);
    }
    CHECK(count == all / (2U << 20) * ((2U << 20) / chain));
    /* What is smaller may still fit. */
    CHECK(allocate(GR_TEXFMT_INTENSITY_8, GR_LOD_8, GR_LOD_8) == count);
    guTexMemReset();
    for (count = 0; count < MAX_MIPMAPS_PER_SST; count++) {
        CHECK(allocate(GR_TEXFMT_INTENSITY_8, GR_LOD_1, GR_LOD_1) == count);
    }
    CHECK(allocate(GR_TEXFMT_INTENSITY_8, GR_LOD_1, GR_LOD_1) == GR_NULL_MIPMAP_HANDLE);
    guTexMemReset();
    CHECK(guTexMemQueryAvail(GR_TMU0) == all);
    CHECK(guTexGetMipMapInfo(0) == NULL);
}

static void check_record(GrMipMapId_t id, const void *data)
{
    const GrMipMapInfo *m = guTexGetMipMapInfo(id);

    CHECK(m != NULL);
    if (m == NULL) {
        return;
    }
    CHECK(m->sst == 0 && m->valid && m->width == 64 && m->height == 64);
    CHECK(m->aspect_ratio == GR_ASPECT_1x1 && m->data == data && m->format == GR_TEXFMT_ARGB_4444);
    CHECK(m->mipmap_mode == GR_MIPMAP_NEAREST);
    CHECK(m->magfilter_mode == GR_TEXTUREFILTER_BILINEAR);
    CHECK(m->minfilter_mode == GR_TEXTUREFILTER_POINT_SAMPLED);
    CHECK(m->s_clamp_mode == GR_TEXTURECLAMP_WRAP && m->t_clamp_mode == GR_TEXTURECLAMP_CLAMP);
    /* Levels 2 to 8 in quarters, and a bias of -3 quarters. */
    CHECK(m->tLOD == (8U | 32U << 6 | 0x3eU << 12) && m->lod_bias == 0x3e);
    /* Perspective, magnified bilinear, clamped w and t, the format. */
    CHECK(m->tTextureMode == (1U | 4U | 8U | 0x80U | 12U << 8));
    CHECK(m->lod_min == GR_LOD_1 && m->lod_max == GR_LOD_64 && m->tmu == GR_TMU0);
    CHECK(m->odd_even_mask == BOTH && !m->trilinear);
    /* Where level 256 would be: two levels of 16-bit texels before the first. */
    CHECK(m->tmu_base_address == 0U - 2U * (65536U + 16384U));
}

static void draw_maps(void)
{
    FxU16 *texels = paint_texels(test_card, GR_TEXFMT_ARGB_4444, GR_LOD_64);
    const void *at = texels;
    GrMipMapId_t id = allocate(GR_TEXFMT_ARGB_4444, GR_LOD_1, GR_LOD_64), narrow;
    const GrMipMapInfo *record;
    void *other;
    int lod;

    guTexDownloadMipMap(id, texels, NULL);
    check_record(id, texels);
    guTexSource(id);
    CHECK(guTexGetCurrentMipMap(GR_TMU0) == id);
    grTexCombineFunction(GR_TMU0, GR_TEXTURECOMBINE_DECAL);
    texture_box(cell(0, 4, 3), 0, 0, 256, 256);
    /* Wrapped in s, clamped in t. */
    texture_box(cell(1, 4, 3), -128, -128, 384, 384);
    /* A record that is held shows what changes. */
    record = guTexGetMipMapInfo(id);
    CHECK(guTexChangeAttributes(id, -1, -1, -1, -1, -1, -1, -1, GR_TEXTURECLAMP_CLAMP, GR_TEXTURECLAMP_WRAP,
                                GR_TEXTUREFILTER_BILINEAR, -1));
    CHECK(record->s_clamp_mode == GR_TEXTURECLAMP_CLAMP && record->width == 64);
    CHECK(record->tTextureMode == (1U | 2U | 4U | 8U | 0x40U | 12U << 8));
    guTexSource(id);
    texture_box(cell(2, 4, 3), -128, -128, 384, 384);
    CHECK(guTexChangeAttributes(id, 32, 32, -1, GR_MIPMAP_DISABLE, -1, GR_LOD_32, -1, -1, -1, -1, -1));
    CHECK(record->lod_max == GR_LOD_32 && record->tLOD == (12U | 12U << 6 | 0x3eU << 12));
    CHECK(guTexChangeAttributes(id, 64, 64, -1, GR_MIPMAP_NEAREST, -1, GR_LOD_64, -1, -1, -1, -1, -1));
    CHECK(!guTexChangeAttributes(id, -1, -1, 7, -1, -1, -1, -1, -1, -1, -1, -1));
    errors_told = 0;
    CHECK(record->format == GR_TEXFMT_ARGB_4444);
    free(texels);

    /* Level by level, the pointer moves on. */
    other = paint_texels(test_card, GR_TEXFMT_RGB_332, GR_LOD_32);
    at = other;
    narrow = allocate(GR_TEXFMT_RGB_332, GR_LOD_1, GR_LOD_32);
    for (lod = GR_LOD_32; lod <= GR_LOD_1; lod++) {
        guTexDownloadMipMapLevel(narrow, lod, &at);
    }
    CHECK((const char *)at - (const char *)other == 1024 + 256 + 64 + 16 + 4 + 1);
    guTexSource(narrow);
    texture_box(cell(3, 4, 3), 0, 0, 256, 256);
    free(other);
}

/* Three compressed textures on two tables. */
static void draw_compressed(void)
{
    GrMipMapId_t ids[3];
    GuNccTable tables[3];
    FxU8 codes[256];
    int i, k;

    for (i = 0; i < 256; i++) {
        codes[i] = (FxU8)i;
    }
    memset(tables, 0, sizeof tables);
    for (k = 0; k < 3; k++) {
        for (i = 0; i < 16; i++) {
            tables[k].packed_data[i / 4] |= (FxU32)(17 * i) << (8 * (i % 4));
        }
        for (i = 0; i < 4; i++) {
            tables[k].packed_data[4 + i] = (FxU32)(40 * i) << (9 * k);
        }
        ids[k] = allocate(GR_TEXFMT_YIQ_422, GR_LOD_16, GR_LOD_16);
        guTexDownloadMipMap(ids[k], codes, &tables[k]);
        CHECK(memcmp(&guTexGetMipMapInfo(ids[k])->ncc_table, &tables[k], sizeof tables[k]) == 0);
        guTexChangeAttributes(ids[k], -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, GR_TEXTUREFILTER_POINT_SAMPLED);
    }
    for (i = 0; i < 8; i++) {
        static const int order[8] = {0, 1, 2, 0, 1, 1, 2, 0};
        Box box = cell(4 + i % 4 + 4 * (i / 4), 4, 3);
        FxU16 pixel;

        k = order[i];
        guTexSource(ids[k]);
        texture_box(box, 0, 0, 256, 256);
        /* Code 0x8c: Y 136, and 120 more in the channel of the table. */
        pixel = read_pixel(GR_BUFFER_BACKBUFFER, box.x0 + 78 * 25 / 32, box.y0 + 78 * 17 / 32);
        CHECK(pixel == pack565(k == 2 ? 255 : 136, k == 1 ? 255 : 136, k == 0 ? 255 : 136));
        if (i == 5) {
            /* A table that the program loads itself takes a place away. */
            GuNccTable black;
            memset(&black, 0, sizeof black);
            grTexDownloadTable(GR_TMU0, GR_TEXTABLE_NCC0, &black);
            grTexDownloadTable(GR_TMU0, GR_TEXTABLE_NCC1, &black);
        }
    }
    /* A new table of a texture that is loaded replaces the old one. */
    guTexDownloadMipMap(ids[0], codes, &tables[1]);
    guTexSource(ids[0]);
    texture_box(cell(24 + 7, 8, 6), 0, 0, 256, 256);
}

static void check_bad_handles(void)
{
    const void *at = error_text;
    GrMipMapId_t before = guTexGetCurrentMipMap(GR_TMU0);

    errors_told = 0;
    guTexSource(GR_NULL_MIPMAP_HANDLE);
    CHECK(errors_told == 0);
    guTexSource(500);
    CHECK(told_once("guTexSource: "));
    CHECK(!guTexChangeAttributes(500, 1, 1, -1, -1, -1, -1, -1, -1, -1, -1, -1));
    CHECK(told_once("guTexChangeAttributes: "));
    guTexDownloadMipMap(GR_NULL_MIPMAP_HANDLE, error_text, NULL);
    CHECK(told_once("guTexDownloadMipMap: "));
    guTexDownloadMipMapLevel(500, GR_LOD_1, &at);
    CHECK(told_once("guTexDownloadMipMapLevel: ") && at == error_text);
    guTexDownloadMipMapLevel(0, GR_LOD_256, &at);
    CHECK(told_once("guTexDownloadMipMapLevel: ") && at == error_text);
    CHECK(guTexGetMipMapInfo(500) == NULL && guTexGetMipMapInfo(GR_NULL_MIPMAP_HANDLE) == NULL);
    CHECK(guTexGetCurrentMipMap(17) == GR_NULL_MIPMAP_HANDLE);
    CHECK(told_once("guTexGetCurrentMipMap: "));
    CHECK(guTexMemQueryAvail(-1) == 0);
    CHECK(told_once("guTexMemQueryAvail: "));
    CHECK(allocate(GR_TEXFMT_RSVD0, GR_LOD_1, GR_LOD_1) == GR_NULL_MIPMAP_HANDLE);
    CHECK(told_once("guTexAllocateMemory: "));
    CHECK(allocate(GR_TEXFMT_P_8, GR_LOD_256, GR_LOD_1) == GR_NULL_MIPMAP_HANDLE);
    CHECK(told_once("guTexAllocateMemory: "));
    CHECK(guTexGetCurrentMipMap(GR_TMU0) == before);
}

int main(void)
{
    open_small(GR_ORIGIN_UPPER_LEFT);
    check_memory();
    guColorCombineFunction(GR_COLORCOMBINE_DECAL_TEXTURE);
    clear_to(0x202020);
    draw_maps();
    draw_compressed();
    check_bad_handles();
    grBufferSwap(0);
    return finish();
}
