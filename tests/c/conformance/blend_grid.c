/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * blend_grid.c: every source factor (rows) with every destination factor
 * (columns), against the arithmetic, with an alpha buffer. In the second frame
 * with fog, which "prefog colour" leaves out.
 */
#include "conformance.h"

static const GrAlphaBlendFnc_t factors[] = {
    GR_BLEND_ZERO, GR_BLEND_SRC_ALPHA, GR_BLEND_SRC_COLOR, GR_BLEND_DST_ALPHA, GR_BLEND_ONE,
    GR_BLEND_ONE_MINUS_SRC_ALPHA, GR_BLEND_ONE_MINUS_SRC_COLOR, GR_BLEND_ONE_MINUS_DST_ALPHA,
    GR_BLEND_ALPHA_SATURATE
};

/* A factor times a value: of the terms the factors name, `color` is the other
 * one's colour. */
static int term(GrAlphaBlendFnc_t factor, int value, int sa, int da, int color, int last)
{
    int f;

    switch (factor) {
    case GR_BLEND_ZERO: f = 0; break;
    case GR_BLEND_SRC_ALPHA: f = sa + 1; break;
    case GR_BLEND_SRC_COLOR: f = color + 1; break;
    case GR_BLEND_DST_ALPHA: f = da + 1; break;
    case GR_BLEND_ONE: f = 256; break;
    case GR_BLEND_ONE_MINUS_SRC_ALPHA: f = 256 - sa; break;
    case GR_BLEND_ONE_MINUS_SRC_COLOR: f = 256 - color; break;
    case GR_BLEND_ONE_MINUS_DST_ALPHA: f = 256 - da; break;
    default: f = last; break;
    }
    return value * f;
}

static void draw_cell(int row, int column, int fogged)
{
    Box box = cell(row * 9 + column, 9, 9);
    int source[4], prefog[4], under[4], expected[4], c, sa, da;
    FxU16 below, pixel;

    source[0] = sa = 200 - 20 * column;
    source[1] = 240 - 10 * row;
    source[2] = 30 + 20 * column;
    source[3] = 130;
    /* What is there before: colour 0x50, 0xa0, 0xc8 and alpha. */
    grAlphaBlendFunction(GR_BLEND_ONE, GR_BLEND_ZERO, GR_BLEND_ONE, GR_BLEND_ZERO);
    grFogMode(GR_FOG_DISABLE);
    fill_box(box, 40 + 20 * row, 0x50, 0xa0, 0xc8);
    da = 40 + 20 * row;
    below = middle(box);
    under[1] = red_of(below);
    under[2] = green_of(below);
    under[3] = blue_of(below);
    grAlphaBlendFunction(factors[row], factors[column], GR_BLEND_ONE, GR_BLEND_ONE);
    if (fogged) {
        grFogMode(GR_FOG_WITH_ITERATED_ALPHA);
    }
    fill_box(box, source[0], source[1], source[2], source[3]);
    for (c = 1; c < 4; c++) {
        int fog_color = c == 1 ? 0x20 : c == 2 ? 0xff : 0x60, difference, sum;

        prefog[c] = source[c];
        if (fogged) {
            difference = (fog_color - source[c]) * (sa + 1);
            difference = difference < 0 ? -((-difference + 255) / 256) : difference / 256;
            source[c] = clamp_byte(source[c] + difference);
        }
        sum = term(factors[row], source[c], sa, da, under[c],
                   (sa < 256 - da ? sa : 256 - da) + 1)
            + term(factors[column], under[c], sa, da, source[c], prefog[c] + 1);
        expected[c] = clamp_byte(sum >> 8);
    }
    pixel = middle(box);
    CHECK(pixel == pack565(expected[1], expected[2], expected[3]));
    if (pixel != pack565(expected[1], expected[2], expected[3])) {
        printf("source %d destination %d fog %d: %04x, not %04x\n", (int)factors[row],
               (int)factors[column], fogged, pixel, pack565(expected[1], expected[2], expected[3]));
    }
    CHECK(read_pixel(GR_BUFFER_AUXBUFFER, (box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2)
          == clamp_byte(sa + da));
}

int main(void)
{
    int frame, i;

    open_small(GR_ORIGIN_UPPER_LEFT);
    grColorMask(FXTRUE, FXTRUE);
    use_vertex_colors();
    grFogColorValue(0x20ff60);
    for (frame = 0; frame < 2; frame++) {
        grBufferClear(0, 0, 0);
        for (i = 0; i < 81; i++) {
            draw_cell(i / 9, i % 9, frame);
        }
        grBufferSwap(0);
    }
    return finish();
}
