/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * multi_pass.c: the six ways of putting two textures together in two passes,
 * each with flat colours checked, plain (left) and with fog (right); then under
 * the depth test, and what cannot be done.
 */
#include "conformance.h"

static GrMipMapId_t solid(int r, int g, int b)
{
    FxU16 texel = (FxU16)(0xf000 | r << 8 | g << 4 | b);
    GrMipMapId_t id = guTexAllocateMemory(
        GR_TMU0, GR_MIPMAPLEVELMASK_BOTH, 1, 1, GR_TEXFMT_ARGB_4444, GR_MIPMAP_DISABLE, GR_LOD_1,
        GR_LOD_1, GR_ASPECT_1x1, GR_TEXTURECLAMP_CLAMP, GR_TEXTURECLAMP_CLAMP,
        GR_TEXTUREFILTER_POINT_SAMPLED, GR_TEXTUREFILTER_POINT_SAMPLED, 0.0f, FXFALSE);

    guTexDownloadMipMap(id, &texel, NULL);
    return id;
}

static GrMipMapId_t painted(Pattern pattern)
{
    void *texels = paint_texels(pattern, GR_TEXFMT_RGB_565, GR_LOD_64);
    GrMipMapId_t id = guTexAllocateMemory(
        GR_TMU0, GR_MIPMAPLEVELMASK_BOTH, 64, 64, GR_TEXFMT_RGB_565, GR_MIPMAP_NEAREST, GR_LOD_1,
        GR_LOD_64, GR_ASPECT_1x1, GR_TEXTURECLAMP_WRAP, GR_TEXTURECLAMP_WRAP,
        GR_TEXTUREFILTER_BILINEAR, GR_TEXTUREFILTER_BILINEAR, 0.0f, FXFALSE);

    guTexDownloadMipMap(id, texels, NULL);
    free(texels);
    return id;
}

static Color spots(float u, float v)
{
    float x = u * 4.0f - floorf(u * 4.0f) - 0.5f, y = v * 4.0f - floorf(v * 4.0f) - 0.5f;
    return mix_color(rgb(0.2f, 0.2f, 0.3f), rgb(1, 0.9f, 0.6f), ramp(0.2f, 0.1f, x * x + y * y));
}

static void draw_twice(Box box, float ooz)
{
    GrVertex v[4];
    int i;

    for (i = 0; i < 4; i++) {
        v[i] = vertex((float)(i == 1 || i == 2 ? box.x1 : box.x0), (float)(i >= 2 ? box.y1 : box.y0), rgb(1, 1, 1));
        v[i].a = 80.0f;
        v[i].ooz = ooz;
        set_texture(&v[i], i == 1 || i == 2 ? 256.0f : 0.0f, i >= 2 ? 256.0f : 0.0f);
    }
    guMPDrawTriangle(&v[0], &v[1], &v[2]);
    guMPDrawTriangle(&v[0], &v[2], &v[3]);
}

static void check_solids(void)
{
    /* Sums and products of 0x66 0xaa 0x33 and 0x55 0x88 0xff, and what the
     * detail factor of 127 leaves of them. */
    static const int expected[4][3] = {{0xbb, 0xff, 0xff}, {0x22, 0x5b, 0x33}, {0x5d, 0x99, 0x99}, {0x5d, 0x99, 0x98}};
    GrMipMapId_t a = solid(6, 10, 3), b = solid(5, 8, 15);
    int i;

    guMPTexSource(GR_TMU0, a);
    guMPTexSource(GR_TMU1, b);
    grTexDetailControl(GR_TMU0, 31, 7, 0.5f);
    for (i = 0; i < 4; i++) {
        FxU16 pixel;
        int k, part[3];

        guMPTexCombineFunction(i);
        draw_twice(cell(i, 8, 6), 1.0f);
        pixel = middle(cell(i, 8, 6));
        part[0] = red_of(pixel), part[1] = green_of(pixel), part[2] = blue_of(pixel);
        for (k = 0; k < 3; k++) {
            /* Each pass may lose a step of the 565 buffer. */
            int off = part[k] - expected[i][k];
            CHECK(off <= 8 && off >= -16);
            if (off > 8 || off < -16) {
                printf("function %d part %d: %d, not %d\n", i, k, part[k], expected[i][k]);
            }
        }
    }
}

int main(void)
{
    static const GrMPTextureCombineFnc_t functions[6] = {
        GR_MPTEXTURECOMBINE_ADD, GR_MPTEXTURECOMBINE_MULTIPLY, GR_MPTEXTURECOMBINE_DETAIL0,
        GR_MPTEXTURECOMBINE_DETAIL1, GR_MPTEXTURECOMBINE_TRILINEAR0, GR_MPTEXTURECOMBINE_TRILINEAR1};
    GrMipMapId_t card, spot;
    GrVertex v;
    int i;

    open_small(GR_ORIGIN_UPPER_LEFT);
    clear_to(0x202020);
    guColorCombineFunction(GR_COLORCOMBINE_DECAL_TEXTURE);
    guAlphaSource(GR_ALPHASOURCE_ITERATED_ALPHA);
    guMPInit();
    check_solids();
    card = painted(test_card);
    spot = painted(spots);
    guMPTexSource(GR_TMU0, card);
    guMPTexSource(GR_TMU1, spot);
    grFogColorValue(0x3050c0);
    for (i = 0; i < 6; i++) {
        guMPTexCombineFunction(functions[i]);
        draw_twice(cell(6 + i, 6, 5), 1.0f);
        grFogMode(GR_FOG_WITH_ITERATED_ALPHA);
        draw_twice(cell(12 + i, 6, 5), 1.0f);
        grFogMode(GR_FOG_DISABLE);
    }
    /* The second pass goes where the first one went. */
    guMPTexCombineFunction(GR_MPTEXTURECOMBINE_ADD);
    use_z_buffer();
    for (i = 0; i < 3; i++) {
        Box box = cell(18 + i, 6, 5), half = box;

        half.x1 = (box.x0 + box.x1) / 2;
        guColorCombineFunction(GR_COLORCOMBINE_ITRGB);
        flat_box(half, 80, 100, 0, 0, 30000.0f, 1.0f);
        guColorCombineFunction(GR_COLORCOMBINE_DECAL_TEXTURE);
        draw_twice(box, i == 0 ? 20000.0f : 40000.0f);
        CHECK((read_pixel(GR_BUFFER_BACKBUFFER, box.x0 + 5, box.y0 + 30) == pack565(100, 0, 0)) == (i == 0));
        CHECK(read_pixel(GR_BUFFER_AUXBUFFER, box.x0 + 5, box.y0 + 30) == (i == 0 ? 30000 : 40000));
    }
    use_no_depth_buffer();
    /* A single pass afterwards is as it was. */
    grTexCombineFunction(GR_TMU0, GR_TEXTURECOMBINE_DECAL);
    guTexSource(card);
    texture_box(cell(24, 6, 5), 0, 0, 256, 256);
    CHECK(errors_told == 0);

    v = vertex(0, 0, rgb(1, 1, 1));
    guMPTexCombineFunction(GR_MPTEXTURECOMBINE_SUBTRACT);
    guMPDrawTriangle(&v, &v, &v);
    CHECK(told_once("guMPDrawTriangle: "));
    guMPTexCombineFunction(GR_MPTEXTURECOMBINE_ADD);
    use_blending();
    guMPDrawTriangle(&v, &v, &v);
    CHECK(told_once("guMPDrawTriangle: "));
    use_no_blending();
    guMPTexSource(GR_TMU0, 4000);
    guMPDrawTriangle(&v, &v, &v);
    CHECK(told_once("guMPDrawTriangle: "));
    guMPTexSource(GR_TMU2, card);
    CHECK(told_once("guMPTexSource: "));
    grBufferSwap(0);
    return finish();
}
