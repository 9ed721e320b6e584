/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * color_combine.c: every function of the colour combine unit with every
 * factor, against its arithmetic; in the second frame inverted. Rows are
 * functions, columns factors; locals and others take turns.
 */
#include "conformance.h"

/* Alpha, red, green, blue. */
static const int constant[4] = {0x60, 0xd8, 0x30, 0x90};
static const int texel[4] = {0xaa, 0xff, 0x88, 0x33};

static void draw_cell(int row, int column, FxBool invert)
{
    GrCombineFunction_t function = all_functions[row];
    GrCombineFactor_t factor = all_factors[column];
    GrCombineLocal_t local = (row + column) % 2;
    GrCombineOther_t other = (row + column / 2) % 3;
    Box box = cell(row * 12 + column, 12, 11);
    int iterated[4], expected[4], channel;
    const int *l = local == GR_COMBINE_LOCAL_ITERATED ? iterated : constant;
    const int *o = other == GR_COMBINE_OTHER_TEXTURE ? texel
        : other == GR_COMBINE_OTHER_ITERATED ? iterated : constant;
    FxU16 pixel;

    iterated[0] = 40 + 15 * column;
    iterated[1] = 20 + 20 * row;
    iterated[2] = 250 - 18 * column;
    iterated[3] = 128;
    grColorCombine(function, factor, local, other, invert);
    /* The alpha unit's sources are what "alpha of local and other" mean. */
    grAlphaCombine(GR_COMBINE_FUNCTION_SCALE_OTHER, GR_COMBINE_FACTOR_ONE, local, other, FXFALSE);
    fill_box(box, iterated[0], iterated[1], iterated[2], iterated[3]);
    for (channel = 1; channel < 4; channel++) {
        int scale[6];

        scale[0] = 0;
        scale[1] = l[channel];
        scale[2] = o[0];
        scale[3] = l[0];
        /* Without texturing the texture reads as 0. */
        scale[4] = texel[0];
        scale[5] = texel[channel];
        expected[channel] = combine_channel(function, factor, o[channel], l[channel], l[0],
                                            scale, invert);
    }
    pixel = middle(box);
    CHECK(pixel == pack565(expected[1], expected[2], expected[3]));
    if (pixel != pack565(expected[1], expected[2], expected[3])) {
        printf("function %d factor %d local %d other %d: %04x\n", (int)function, (int)factor,
               (int)local, (int)other, pixel);
    }
}

int main(void)
{
    int frame, i;

    open_small(GR_ORIGIN_UPPER_LEFT);
    grConstantColorValue(0x60d83090);
    solid_texel(GR_TMU0, grTexMinAddress(GR_TMU0), 0xa, 0xf, 0x8, 0x3);
    grTexCombineFunction(GR_TMU0, GR_TEXTURECOMBINE_DECAL);
    for (frame = 0; frame < 2; frame++) {
        clear_to(0x202020);
        for (i = 0; i < 11 * 12; i++) {
            draw_cell(i / 12, i % 12, frame);
        }
        grBufferSwap(0);
    }
    return finish();
}
