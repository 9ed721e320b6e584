/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * alpha_combine.c: every function of the alpha combine unit with every factor
 * that alpha has, against its arithmetic; in the second frame inverted. Alpha
 * is made visible by writing it to the alpha buffer, and by blending white
 * over blue with it.
 */
#include "conformance.h"

#define CONSTANT_ALPHA 0x60
#define TEXEL_ALPHA 0xaa

static void draw_cell(int row, int column, FxBool invert)
{
    GrCombineFunction_t function = all_functions[row];
    GrCombineFactor_t factor = all_factors[column];
    GrCombineLocal_t local = (row + column) % 3;
    GrCombineOther_t other = (row + column / 2) % 3;
    Box box = cell(row * 12 + column, 12, 11);
    int iterated = 30 + 20 * row, depth = 0x80, l, o, scale[6], expected, pixel;

    l = local == GR_COMBINE_LOCAL_ITERATED ? iterated
        : local == GR_COMBINE_LOCAL_CONSTANT ? CONSTANT_ALPHA : depth;
    o = other == GR_COMBINE_OTHER_TEXTURE ? TEXEL_ALPHA
        : other == GR_COMBINE_OTHER_ITERATED ? iterated : CONSTANT_ALPHA;
    grAlphaCombine(function, factor, local, other, invert);
    fill_box(box, iterated, 255, 255, 255);
    if ((factor & 7) == GR_COMBINE_FACTOR_TEXTURE_RGB) {
        return; /* the chip does not say what alpha takes for it */
    }
    scale[0] = scale[5] = 0;
    scale[1] = scale[3] = l;
    scale[2] = o;
    scale[4] = TEXEL_ALPHA;
    expected = combine_channel(function, factor, o, l, l, scale, invert);
    pixel = read_pixel(GR_BUFFER_AUXBUFFER, (box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2);
    CHECK(pixel == expected);
    if (pixel != expected) {
        printf("function %d factor %d local %d other %d: %d, not %d\n", (int)function, (int)factor,
               (int)local, (int)other, pixel, expected);
    }
}

int main(void)
{
    int frame, i;

    open_small(GR_ORIGIN_UPPER_LEFT);
    grColorMask(FXTRUE, FXTRUE);
    grConstantColorValue(0x60000000);
    guColorCombineFunction(GR_COLORCOMBINE_ITRGB);
    solid_texel(GR_TMU0, grTexMinAddress(GR_TMU0), 0xa, 0xf, 0x8, 0x3);
    grTexCombineFunction(GR_TMU0, GR_TEXTURECOMBINE_DECAL);
    use_blending();
    for (frame = 0; frame < 2; frame++) {
        grBufferClear(0x000080, 0, 0);
        for (i = 0; i < 11 * 12; i++) {
            draw_cell(i / 12, i % 12, frame);
        }
        grBufferSwap(0);
    }
    return finish();
}
