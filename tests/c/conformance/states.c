/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * states.c: a state saved, all of it changed, and restored: what is drawn then
 * equals what was drawn before (left halves and right halves). Not part of it:
 * the fog table, gamma, palettes, textures, the frame buffer.
 */
#include "conformance.h"

static GrMipMapId_t maps[2];

static void load_maps(void)
{
    int i;

    for (i = 0; i < 2; i++) {
        void *texels = paint_texels(test_card, i ? GR_TEXFMT_INTENSITY_8 : GR_TEXFMT_ARGB_1555, GR_LOD_64);

        maps[i] = guTexAllocateMemory(GR_TMU0, GR_MIPMAPLEVELMASK_BOTH, 64, 64,
                                      i ? GR_TEXFMT_INTENSITY_8 : GR_TEXFMT_ARGB_1555, GR_MIPMAP_NEAREST,
                                      GR_LOD_1, GR_LOD_64, GR_ASPECT_1x1, GR_TEXTURECLAMP_WRAP,
                                      GR_TEXTURECLAMP_WRAP, GR_TEXTUREFILTER_BILINEAR,
                                      GR_TEXTUREFILTER_BILINEAR, 0.5f, FXFALSE);
        guTexDownloadMipMap(maps[i], texels, NULL);
        free(texels);
    }
}

/* Something of every chapter. */
static void set_one(void)
{
    guColorCombineFunction(GR_COLORCOMBINE_TEXTURE_TIMES_ITRGB_DELTA0);
    guAlphaSource(GR_ALPHASOURCE_TEXTURE_ALPHA_TIMES_ITERATED_ALPHA);
    grConstantColorValue4(255.0f, 255.0f, 128.0f, 64.0f);
    grConstantColorValue(0x80ff8040);
    use_blending();
    grAlphaTestFunction(GR_CMP_GREATER);
    grAlphaTestReferenceValue(5);
    grChromakeyMode(GR_CHROMAKEY_ENABLE);
    grChromakeyValue(0xffffff);
    grCullMode(GR_CULL_POSITIVE);
    grDepthBufferMode(GR_DEPTHBUFFER_WBUFFER);
    grDepthBufferFunction(GR_CMP_LEQUAL);
    grDepthMask(FXTRUE);
    grDepthBiasLevel(-30);
    grDitherMode(GR_DITHER_2x2);
    grFogMode(GR_FOG_WITH_ITERATED_ALPHA);
    grFogColorValue(0x4040ff);
    guTexSource(maps[0]);
    grTexCombineFunction(GR_TMU0, GR_TEXTURECOMBINE_DECAL);
    grHints(GR_HINT_STWHINT, 0);
    grLfbConstantAlpha(77);
    grLfbConstantDepth(777);
}

static void set_other(void)
{
    GrState ignored;

    grDisableAllEffects();
    use_vertex_colors();
    grCullMode(GR_CULL_NEGATIVE);
    grDitherMode(GR_DITHER_DISABLE);
    grConstantColorValue(0);
    grConstantColorValue4(0, 0, 0, 0);
    grFogColorValue(0);
    guTexSource(maps[1]);
    grTexCombineFunction(GR_TMU0, GR_TEXTURECOMBINE_ZERO);
    grHints(GR_HINT_STWHINT, GR_STWHINT_W_DIFF_TMU0);
    grClipWindow(0, 0, 4, 4);
    grSstOrigin(GR_ORIGIN_LOWER_LEFT);
    grColorMask(FXFALSE, FXFALSE);
    grRenderBuffer(GR_BUFFER_FRONTBUFFER);
    grLfbConstantAlpha(0);
    grLfbWriteColorFormat(GR_COLORFORMAT_BGRA);
    grGlideGetState(&ignored);
}

static void draw(Box box)
{
    GrVertex a = vertex((float)box.x0, (float)box.y1, rgba(1, 1, 1, 0.9f));
    GrVertex b = vertex((float)box.x1, (float)box.y1, rgba(1, 0.4f, 1, 0.9f));
    GrVertex c = vertex((float)(box.x0 + box.x1) / 2, (float)box.y0, rgba(0.2f, 1, 1, 0.2f));

    b.oow = 0.3f;
    c.oow = 0.1f;
    set_texture(&a, 0, 256);
    set_texture(&b, 256, 256);
    set_texture(&c, 128, 0);
    grDrawTriangle(&a, &c, &b);
    grDrawTriangle(&a, &b, &c);
}

int main(void)
{
    static FxU16 shots[2][118][158];
    /* No alignment is promised for a state. */
    static char room[sizeof(GrState) + 9];
    GrState *state = (GrState *)(void *)(room + 1);
    int i;

    CHECK(sizeof(GrState) == 312);
    open_small(GR_ORIGIN_UPPER_LEFT);
    load_maps();
    grDepthBufferMode(GR_DEPTHBUFFER_WBUFFER);
    grDepthMask(FXTRUE);
    grBufferClear(0x303030, 0, GR_WDEPTHVALUE_FARTHEST);
    memset(room, 0x5a, sizeof room);
    set_one();
    grGlideGetState(state);
    CHECK(room[0] == 0x5a && room[1 + sizeof(GrState)] == 0x5a);
    draw(cell(0, 2, 2));
    set_other();
    CHECK(guTexGetCurrentMipMap(GR_TMU0) == maps[1]);
    grGlideSetState(state);
    CHECK(guTexGetCurrentMipMap(GR_TMU0) == maps[0]);
    draw(cell(2, 2, 2));
    /* Both start on an even row and column, so that the dither is the same. */
    for (i = 0; i < 2; i++) {
        Box box = cell(2 * i, 2, 2);
        CHECK(grLfbReadRegion(GR_BUFFER_BACKBUFFER, (FxU32)box.x0, (FxU32)box.y0, 158, 118,
                              sizeof shots[0][0], shots[i]));
    }
    CHECK(memcmp(shots[0], shots[1], sizeof shots[0]) == 0);
    {
        int x, y, touched = 0;

        for (y = 0; y < 118; y++) {
            for (x = 0; x < 158; x++) {
                touched += shots[0][y][x] != pack565(0x30, 0x30, 0x30);
            }
        }
        CHECK(touched > 1000);
    }
    /* Restored again, the same once more. */
    grGlideGetState((GrState *)(void *)room);
    set_other();
    grGlideSetState((GrState *)(void *)room);
    draw(cell(1, 2, 2));
    /* Bytes that no board saved change nothing. */
    memset(room, 0, sizeof room);
    grGlideSetState((GrState *)(void *)room);
    CHECK(told_once("grGlideSetState: "));
    draw(cell(3, 2, 2));
    grBufferSwap(0);
    return finish();
}
