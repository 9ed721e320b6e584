/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * texture_combine.c: every function of a texture combine unit with every
 * factor, against its arithmetic: unit 1 gives "other", unit 0 "local". Detail
 * factor and level fraction are those of the largest level: the detail factor
 * at its maximum, the fraction 0. In the second frame inverted.
 */
#include "conformance.h"

static const int local[4] = {0x99, 0xff, 0x66, 0x11};
static const int other[4] = {0x44, 0x77, 0xee, 0xbb};

static void draw_cell(int row, int column, FxBool invert, const int *o)
{
    GrCombineFunction_t function = all_functions[row];
    GrCombineFactor_t factor = all_factors[column];
    Box box = cell(row * 12 + column, 12, 11);
    int expected[4], channel;
    FxU16 pixel;

    grTexCombine(GR_TMU0, function, factor, function, factor, invert, invert);
    fill_box(box, 255, 255, 255, 255);
    for (channel = 1; channel < 4; channel++) {
        int scale[6];

        scale[0] = scale[5] = 0;
        scale[1] = local[channel];
        scale[2] = o[0];
        scale[3] = local[0];
        scale[4] = 127; /* the maximum of 0.5 */
        expected[channel] = combine_channel(function, factor, o[channel], local[channel], local[0],
                                            scale, invert);
    }
    pixel = middle(box);
    CHECK(pixel == pack565(expected[1], expected[2], expected[3]));
    if (pixel != pack565(expected[1], expected[2], expected[3])) {
        printf("function %d factor %d: %04x\n", (int)function, (int)factor, pixel);
    }
}

int main(void)
{
    static const int nothing[4] = {0, 0, 0, 0};
    int frame, i, units = open_small(GR_ORIGIN_UPPER_LEFT);

    guColorCombineFunction(GR_COLORCOMBINE_DECAL_TEXTURE);
    solid_texel(GR_TMU0, grTexMinAddress(GR_TMU0), 0x9, 0xf, 0x6, 0x1);
    /* A bias above every level leaves the maximum. */
    grTexDetailControl(GR_TMU0, 31, 7, 0.5f);
    if (units > 1) {
        solid_texel(GR_TMU1, grTexMinAddress(GR_TMU1), 0x4, 0x7, 0xe, 0xb);
        grTexCombineFunction(GR_TMU1, GR_TEXTURECOMBINE_DECAL);
    }
    for (frame = 0; frame < 2; frame++) {
        clear_to(0x202020);
        for (i = 0; i < 11 * 12; i++) {
            draw_cell(i / 12, i % 12, frame, units > 1 ? other : nothing);
        }
        grBufferSwap(0);
    }
    return finish();
}
