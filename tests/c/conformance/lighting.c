/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * lighting.c: the texel's alpha chooses between the constant and the iterated
 * colour (grAlphaControlsITRGBLighting), in 1555 and 4444; and detail textures
 * whose factor falls with the level.
 */
#include "conformance.h"

static Color windows(float u, float v)
{
    int lit = ((int)(u * 4.0f) * 3 + (int)(v * 4.0f) * 5) % 4 == 0;
    float x = u * 4.0f - floorf(u * 4.0f), y = v * 4.0f - floorf(v * 4.0f);
    int pane = x > 0.25f && x < 0.75f && y > 0.2f && y < 0.8f;

    return pane && lit ? rgba(1, 1, 1, 1) : rgba(0.8f, 0.8f, 0.9f, 0);
}

static Color grain(float u, float v)
{
    float n = cloud(u, v, 8);
    return rgb(n, n, n);
}

int main(void)
{
    static const GrTextureFormat_t formats[2] = {GR_TEXFMT_ARGB_1555, GR_TEXFMT_ARGB_4444};
    Texture t, detail, base;
    int i, units = open_small(GR_ORIGIN_UPPER_LEFT);

    clear_to(0x101018);
    grConstantColorValue(0xffffe060);
    for (i = 0; i < 2; i++) {
        Box box = cell(i, 4, 2);

        t = load_texture(GR_TMU0, windows, formats[i], GR_LOD_64);
        use_texture(GR_TMU0, &t);
        grTexFilterMode(GR_TMU0, GR_TEXTUREFILTER_POINT_SAMPLED, GR_TEXTUREFILTER_POINT_SAMPLED);
        grColorCombine(GR_COMBINE_FUNCTION_SCALE_OTHER, GR_COMBINE_FACTOR_LOCAL,
                       GR_COMBINE_LOCAL_ITERATED, GR_COMBINE_OTHER_TEXTURE, FXFALSE);
        grAlphaControlsITRGBLighting(FXTRUE);
        shaded_box(box, rgb(0.1f, 0.1f, 0.4f), rgb(0.1f, 0.1f, 0.4f), rgb(0.2f, 0, 0.2f), rgb(0.2f, 0, 0.2f));
        /* A lit pane: the texel, white, times the constant colour. */
        CHECK(read_pixel(GR_BUFFER_BACKBUFFER, box.x0 + 10, box.y0 + 15) == pack565(255, 0xe0, 0x60));
        grAlphaControlsITRGBLighting(FXFALSE);
        shaded_box(cell(2 + i, 4, 2), rgb(0.1f, 0.1f, 0.4f), rgb(0.1f, 0.1f, 0.4f), rgb(0.2f, 0, 0.2f), rgb(0.2f, 0, 0.2f));
    }
    if (units > 1) {
        base = load_texture(GR_TMU1, test_card, GR_TEXFMT_RGB_565, GR_LOD_64);
        detail = load_texture(GR_TMU0, grain, GR_TEXFMT_INTENSITY_8, GR_LOD_64);
        use_texture(GR_TMU1, &base);
        use_texture(GR_TMU0, &detail);
        guColorCombineFunction(GR_COLORCOMBINE_DECAL_TEXTURE);
        for (i = 0; i < 8; i++) {
            Box box = cell(16 + i, 8, 4);
            Box small = cell(24 + i, 8, 4);

            grTexDetailControl(GR_TMU0, -8 + 4 * i, (FxU8)i, 0.25f + 0.1f * (float)i);
            grTexCombineFunction(GR_TMU0, i & 1 ? GR_TEXTURECOMBINE_DETAIL_OTHER : GR_TEXTURECOMBINE_DETAIL);
            texture_box(box, 0, 0, 60, 60);
            texture_box(small, 0, 0, 600, 600);
        }
    }
    grBufferSwap(0);
    return finish();
}
