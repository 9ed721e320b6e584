/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * mipmap.c: a tiled floor to the horizon in four strips: point sampled;
 * bilinear; bilinear with the nearest mip map level; and trilinear, which
 * blends two levels. Trilinear filtering splits the levels over two texture
 * units, or takes two passes on a board with one.
 */
#include "common.h"

/* The level is chosen by the longer of two gradients that leave perspective
 * out, which is too sharp for a floor seen at a low angle. */
#define LOD_BIAS 0.75f

static Color tile(float u, float v)
{
    int i = (int)(u * 4.0f), j = (int)(v * 4.0f);
    float x = u * 4.0f - (float)i - 0.5f, y = v * 4.0f - (float)j - 0.5f;
    float r = sqrtf(x * x + y * y), grain = cloud(u, v, 16);
    Color light = mix_color(rgb(0.96f, 0.92f, 0.82f), rgb(0.84f, 0.78f, 0.66f), grain);
    Color dark = mix_color(rgb(0.16f, 0.24f, 0.34f), rgb(0.08f, 0.12f, 0.20f), grain);
    Color red = mix_color(rgb(0.72f, 0.22f, 0.14f), rgb(0.55f, 0.14f, 0.10f), grain);
    Color c = (i + j) & 1 ? light : dark;

    if ((i + j) % 2 == 0 && (i & 1)) {
        c = mix_color(red, light, ramp(0.26f, 0.28f, r) - ramp(0.36f, 0.38f, r));
    } else {
        c = mix_color(c, (i + j) & 1 ? dark : light, ramp(0.42f, 0.40f, fabsf(x) + fabsf(y)) * 0.85f
                      * ramp(0.28f, 0.30f, fabsf(x) + fabsf(y)));
    }
    return c;
}

static void draw_floor(const Camera *camera)
{
    const float texels = 24.0f; /* per unit of length */
    Color white = rgb(1, 1, 1);
    Corner q[4];

    q[0] = corner(vec(-400.0f, 0.0f, -2.0f), white, -400.0f * texels, 0.0f);
    q[1] = corner(vec(-400.0f, 0.0f, 500.0f), white, -400.0f * texels, 502.0f * texels);
    q[2] = corner(vec(400.0f, 0.0f, 500.0f), white, 400.0f * texels, 502.0f * texels);
    q[3] = corner(vec(400.0f, 0.0f, -2.0f), white, 400.0f * texels, 0.0f);
    draw_in_space(camera, q, 4);
}

static void set_filter(GrChipID_t tmu, GrTextureFilterMode_t filter, GrMipMapMode_t mode, FxBool blend)
{
    grTexFilterMode(tmu, filter, filter);
    grTexMipMapMode(tmu, mode, blend);
}

/* Even levels in TMU 0, odd ones in TMU 1, blended by the LOD fraction. */
static void draw_trilinear_at_once(const Camera *camera, Texture *even, Texture *odd)
{
    use_texture(GR_TMU1, odd);
    grTexLodBiasValue(GR_TMU1, LOD_BIAS);
    grTexSource(GR_TMU0, even->address, GR_MIPMAPLEVELMASK_EVEN, &even->info);
    grTexSource(GR_TMU1, odd->address, GR_MIPMAPLEVELMASK_ODD, &odd->info);
    set_filter(GR_TMU0, GR_TEXTUREFILTER_BILINEAR, GR_MIPMAP_NEAREST, FXTRUE);
    set_filter(GR_TMU1, GR_TEXTUREFILTER_BILINEAR, GR_MIPMAP_NEAREST, FXTRUE);
    grTexCombineFunction(GR_TMU0, GR_TEXTURECOMBINE_TRILINEAR_EVEN);
    draw_floor(camera);
}

/* One pass: the texel times the LOD fraction, or times one minus it. */
static void draw_weighted(const Camera *camera, Texture *texture, FxU32 levels, GrCombineFactor_t factor)
{
    grTexSource(GR_TMU0, texture->address, levels, &texture->info);
    set_filter(GR_TMU0, GR_TEXTUREFILTER_BILINEAR, GR_MIPMAP_NEAREST, FXTRUE);
    grTexCombine(GR_TMU0, GR_COMBINE_FUNCTION_BLEND_LOCAL, factor,
                 GR_COMBINE_FUNCTION_BLEND_LOCAL, factor, FXFALSE, FXFALSE);
    draw_floor(camera);
}

static void draw_trilinear_in_two_passes(const Camera *camera, Texture *even, Texture *odd)
{
    use_no_blending();
    draw_weighted(camera, even, GR_MIPMAPLEVELMASK_EVEN, GR_COMBINE_FACTOR_LOD_FRACTION);
    grAlphaBlendFunction(GR_BLEND_ONE, GR_BLEND_ONE, GR_BLEND_ONE, GR_BLEND_ZERO);
    draw_weighted(camera, odd, GR_MIPMAPLEVELMASK_ODD, GR_COMBINE_FACTOR_ONE_MINUS_LOD_FRACTION);
    use_no_blending();
}

static void draw_strip(const Camera *camera, int strip, Texture *whole, Texture *even, Texture *odd, int units)
{
    grClipWindow((FxU32)(160 * strip + (strip > 0)), 0, (FxU32)(160 * strip + 159), 480);
    use_texture(GR_TMU0, whole);
    grTexLodBiasValue(GR_TMU0, LOD_BIAS);
    switch (strip) {
    case 0:
        set_filter(GR_TMU0, GR_TEXTUREFILTER_POINT_SAMPLED, GR_MIPMAP_DISABLE, FXFALSE);
        draw_floor(camera);
        break;
    case 1:
        set_filter(GR_TMU0, GR_TEXTUREFILTER_BILINEAR, GR_MIPMAP_DISABLE, FXFALSE);
        draw_floor(camera);
        break;
    case 2:
        draw_floor(camera);
        break;
    default:
        if (units > 1) {
            draw_trilinear_at_once(camera, even, odd);
        } else {
            draw_trilinear_in_two_passes(camera, even, odd);
        }
        break;
    }
    grClipWindow(0, 0, SCREEN_WIDTH, SCREEN_HEIGHT);
}

int main(int argc, char **argv)
{
    int frames = frames_wanted(argc, argv, 1), frame, strip, units;
    Texture whole, even, odd;

    units = open_screen(GR_ORIGIN_UPPER_LEFT);
    whole = load_texture(GR_TMU0, tile, GR_TEXFMT_RGB_565, GR_LOD_256);
    even = load_levels(GR_TMU0, GR_MIPMAPLEVELMASK_EVEN, tile, GR_TEXFMT_RGB_565, GR_LOD_256);
    odd = load_levels(units > 1 ? GR_TMU1 : GR_TMU0, GR_MIPMAPLEVELMASK_ODD, tile,
                      GR_TEXFMT_RGB_565, GR_LOD_256);
    for (frame = 0; frame < frames; frame++) {
        float ahead = 0.2f * (float)frame;
        Camera camera = look_at(vec(0.7f, 9.0f, ahead), vec(7.0f, 1.0f, 24.0f + ahead), 420.0f);

        use_vertex_colors();
        shade_rectangle(0, 0, 640, 120, rgb(0.24f, 0.44f, 0.70f), rgb(0.86f, 0.88f, 0.86f));
        shade_rectangle(0, 120, 640, 480, rgb(1, 1, 1), rgb(1, 1, 1));
        guColorCombineFunction(GR_COLORCOMBINE_DECAL_TEXTURE);
        for (strip = 0; strip < 4; strip++) {
            draw_strip(&camera, strip, &whole, &even, &odd, units);
        }
        grBufferSwap(1);
    }
    grGlideShutdown();
    return 0;
}
