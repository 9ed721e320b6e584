/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * lod_bias.c: levels of different colours, biased from -8 to 7.75 (rows of
 * strips) on squares of all sizes (columns): which level is drawn where is
 * checked against size and bias.
 */
#include "conformance.h"

static FxU16 *levels;

static int level_of(FxU16 pixel, int largest)
{
    static const FxU16 colors[9] = {0xf800, 0x07e0, 0x001f, 0xffff, 0x0000, 0xf800, 0x07e0, 0x001f, 0xffff};
    int i;

    for (i = largest; i < 9; i++) {
        if (colors[i] == pixel) {
            return i;
        }
    }
    return -1;
}

int main(void)
{
    static const float biases[12] = {-8.0f, -4.0f, -2.0f, -1.0f, -0.5f, -0.25f, 0.0f, 0.25f, 0.5f, 1.0f, 4.0f, 7.75f};
    Texture t;
    int row, column;

    open_small(GR_ORIGIN_UPPER_LEFT);
    levels = guTexCreateColorMipMap();
    CHECK(levels != NULL && levels[0] == 0xf800 && levels[65536] == 0x07e0);
    t.info.smallLod = GR_LOD_1;
    t.info.largeLod = GR_LOD_256;
    t.info.aspectRatio = GR_ASPECT_1x1;
    t.info.format = GR_TEXFMT_RGB_565;
    t.info.data = levels;
    t.address = 0;
    grTexDownloadMipMap(GR_TMU0, 0, GR_MIPMAPLEVELMASK_BOTH, &t.info);
    free(levels);
    use_texture(GR_TMU0, &t);
    grTexFilterMode(GR_TMU0, GR_TEXTUREFILTER_POINT_SAMPLED, GR_TEXTUREFILTER_POINT_SAMPLED);
    guColorCombineFunction(GR_COLORCOMBINE_DECAL_TEXTURE);
    clear_to(0x404040);
    for (row = 0; row < 12; row++) {
        grTexLodBiasValue(GR_TMU0, biases[row]);
        for (column = 0; column < 16; column++) {
            Box box = cell(row * 16 + column, 16, 12);
            /* Texels of the largest level a pixel steps: 2^(column / 2). */
            float step = powf(2.0f, (float)column / 2.0f), wide = (float)(box.x1 - box.x0);
            /* The bias as the board keeps it: quarters, towards zero. */
            float kept = 0.25f * (float)(int)((biases[row] + 0.125f) / 0.25f);
            float level = (float)column / 2.0f + kept;
            int expected = (int)floorf(level);
            FxU16 pixel;

            expected = expected < 0 ? 0 : expected > 8 ? 8 : expected;
            texture_box(box, 0, 0, step * wide, step * wide);
            pixel = middle(box);
            if (level != floorf(level)) {
                /* Between two levels there is no doubt. */
                if (level_of(pixel, expected) != expected) {
                    printf("bias %g, step %g: %04x\n", (double)biases[row], (double)step, pixel);
                }
                CHECK(level_of(pixel, expected) == expected);
            }
        }
    }
    grBufferSwap(0);
    return finish();
}
