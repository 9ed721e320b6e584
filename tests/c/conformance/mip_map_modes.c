/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * mip_map_modes.c: a wall that recedes to the right, whose levels differ in
 * colour: no mip mapping; nearest; dithered nearest without and with the hint
 * that allows it; blended over split levels in one unit (two passes) and in two
 * units; bilinear with minified and magnified texels told apart.
 */
#include "conformance.h"

static Color level_color(int lod)
{
    return hue(0.13f * (float)lod + 0.02f);
}

/* Levels of 256 to 1, checked in the colour of the level. */
static Texture levels(GrChipID_t tmu, FxU32 mask)
{
    static FxU16 texels[87381];
    FxU16 *at = texels;
    Texture t;
    int lod, i;

    for (lod = 0; lod <= 8; lod++) {
        int side = 256 >> lod;
        for (i = 0; i < side * side; i++, at++) {
            int check = (i / side * 8 / side + i % side * 8 / side) & 1;
            FxU8 bytes[2];
            store_texel(GR_TEXFMT_RGB_565, scale_color(level_color(lod), check && side >= 8 ? 0.6f : 1.0f), bytes);
            memcpy(at, bytes, 2);
        }
    }
    t.info.smallLod = GR_LOD_1;
    t.info.largeLod = GR_LOD_256;
    t.info.aspectRatio = GR_ASPECT_1x1;
    t.info.format = GR_TEXFMT_RGB_565;
    t.info.data = texels;
    t.address = reserve_texture(tmu, grTexTextureMemRequired(mask, &t.info));
    grTexDownloadMipMap(tmu, t.address, mask, &t.info);
    t.info.data = NULL;
    return t;
}

static void wall(int row)
{
    Box box = cell(row, 1, 8);
    GrVertex v[4];
    int i;

    for (i = 0; i < 4; i++) {
        int far_end = i == 1 || i == 2;
        v[i] = vertex((float)(far_end ? box.x1 : box.x0), (float)(i >= 2 ? box.y1 : box.y0), rgb(1, 1, 1));
        v[i].oow = far_end ? 1.0f / 256.0f : 1.0f;
        set_texture(&v[i], far_end ? 40000.0f : 0.0f,
                    (i >= 2 ? 26.0f : 0.0f) * (far_end ? 256.0f : 1.0f));
    }
    draw_quad(&v[0], &v[1], &v[2], &v[3]);
}

static int colors_in_row(int row)
{
    FxU16 seen[64];
    int x, i, count = 0;
    Box box = cell(row, 1, 8);

    for (x = box.x0; x < box.x1; x++) {
        FxU16 p = read_pixel(GR_BUFFER_BACKBUFFER, x, box.y0 + 3);
        for (i = 0; i < count && seen[i] != p; i++) {
        }
        if (i == count && count < 64) {
            seen[count++] = p;
        }
    }
    return count;
}

int main(void)
{
    Texture whole, even, odd, other;
    int units = open_small(GR_ORIGIN_UPPER_LEFT), hard, dithered;

    whole = levels(GR_TMU0, GR_MIPMAPLEVELMASK_BOTH);
    even = levels(GR_TMU0, GR_MIPMAPLEVELMASK_EVEN);
    odd = levels(GR_TMU0, GR_MIPMAPLEVELMASK_ODD);
    clear_to(0);
    guColorCombineFunction(GR_COLORCOMBINE_DECAL_TEXTURE);
    use_texture(GR_TMU0, &whole);
    grTexFilterMode(GR_TMU0, GR_TEXTUREFILTER_POINT_SAMPLED, GR_TEXTUREFILTER_POINT_SAMPLED);
    grTexMipMapMode(GR_TMU0, GR_MIPMAP_DISABLE, FXFALSE);
    wall(0);
    CHECK(colors_in_row(0) == 2);
    grTexMipMapMode(GR_TMU0, GR_MIPMAP_NEAREST, FXFALSE);
    wall(1);
    hard = colors_in_row(1);
    CHECK(hard > 4);
    grTexMipMapMode(GR_TMU0, GR_MIPMAP_NEAREST_DITHER, FXFALSE);
    wall(2);
    CHECK(colors_in_row(2) == hard); /* the hint is missing */
    grHints(GR_HINT_ALLOW_MIPMAP_DITHER, 1);
    grTexMipMapMode(GR_TMU0, GR_MIPMAP_NEAREST_DITHER, FXFALSE);
    wall(3);
    dithered = colors_in_row(3);
    CHECK(dithered >= hard);
    grHints(GR_HINT_ALLOW_MIPMAP_DITHER, 0);

    /* Two passes of one unit. */
    grTexMipMapMode(GR_TMU0, GR_MIPMAP_NEAREST, FXTRUE);
    grTexSource(GR_TMU0, even.address, GR_MIPMAPLEVELMASK_EVEN, &even.info);
    grTexCombine(GR_TMU0, GR_COMBINE_FUNCTION_BLEND_LOCAL, GR_COMBINE_FACTOR_LOD_FRACTION,
                 GR_COMBINE_FUNCTION_BLEND_LOCAL, GR_COMBINE_FACTOR_LOD_FRACTION, FXFALSE, FXFALSE);
    wall(4);
    grAlphaBlendFunction(GR_BLEND_ONE, GR_BLEND_ONE, GR_BLEND_ONE, GR_BLEND_ZERO);
    grTexSource(GR_TMU0, odd.address, GR_MIPMAPLEVELMASK_ODD, &odd.info);
    grTexCombine(GR_TMU0, GR_COMBINE_FUNCTION_BLEND_LOCAL, GR_COMBINE_FACTOR_ONE_MINUS_LOD_FRACTION,
                 GR_COMBINE_FUNCTION_BLEND_LOCAL, GR_COMBINE_FACTOR_ONE_MINUS_LOD_FRACTION, FXFALSE, FXFALSE);
    wall(4);
    use_no_blending();
    CHECK(colors_in_row(4) > hard);
    if (units > 1) {
        other = levels(GR_TMU1, GR_MIPMAPLEVELMASK_ODD);
        use_texture(GR_TMU1, &other);
        grTexSource(GR_TMU1, other.address, GR_MIPMAPLEVELMASK_ODD, &other.info);
        grTexMipMapMode(GR_TMU1, GR_MIPMAP_NEAREST, FXTRUE);
        grTexSource(GR_TMU0, even.address, GR_MIPMAPLEVELMASK_EVEN, &even.info);
        grTexCombineFunction(GR_TMU0, GR_TEXTURECOMBINE_TRILINEAR_EVEN);
        wall(5);
        CHECK(colors_in_row(5) > hard);
        /* The same with the odd levels in front. */
        other = levels(GR_TMU1, GR_MIPMAPLEVELMASK_EVEN);
        grTexSource(GR_TMU1, other.address, GR_MIPMAPLEVELMASK_EVEN, &other.info);
        grTexSource(GR_TMU0, odd.address, GR_MIPMAPLEVELMASK_ODD, &odd.info);
        grTexCombineFunction(GR_TMU0, GR_TEXTURECOMBINE_TRILINEAR_ODD);
        wall(6);
    }
    use_texture(GR_TMU0, &whole);
    grTexFilterMode(GR_TMU0, GR_TEXTUREFILTER_BILINEAR, GR_TEXTUREFILTER_POINT_SAMPLED);
    wall(7);
    grBufferSwap(0);
    return finish();
}
