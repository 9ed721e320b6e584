/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * fog_modes.c: every source of the fog factor (columns: none, iterated alpha,
 * table, iterated z) with every combination of flags (rows: none, ADD2, MULT2,
 * both). The two without a table are checked against the arithmetic. The table
 * column runs from near to far; below it the tables that the gu functions make.
 */
#include "conformance.h"

static int fogged(int color, int fog, int factor, int flags)
{
    int difference = (flags & GR_FOG_ADD2 ? 0 : fog) - (flags & GR_FOG_MULT2 ? 0 : color);

    difference *= factor + 1;
    difference = difference < 0 ? -((-difference + 255) / 256) : difference / 256;
    return clamp_byte(difference + (flags & GR_FOG_MULT2 ? 0 : color));
}

/* Sixteen strips, each twice as far as the one before. */
static void far_box(Box box)
{
    int i, wide = (box.x1 - box.x0) / 16;
    float w = 1.0f;

    for (i = 0; i < 16; i++, w *= 2.0f) {
        Box strip = box;

        strip.x0 = box.x0 + i * wide;
        strip.x1 = strip.x0 + wide;
        flat_box(strip, 0, 230, 200, 50, 0.0f, 1.0f / w);
    }
}

int main(void)
{
    static const GrFogMode_t flags[] = {0, GR_FOG_ADD2, GR_FOG_MULT2, GR_FOG_ADD2 | GR_FOG_MULT2};
    GrFog_t table[GR_FOG_TABLE_SIZE], other[GR_FOG_TABLE_SIZE];
    int row, i;

    open_small(GR_ORIGIN_UPPER_LEFT);
    use_vertex_colors();
    grFogColorValue(0x8060a0);
    CHECK(guFogTableIndexToW(0) == 1.0f && guFogTableIndexToW(4) == 2.0f);
    CHECK(guFogTableIndexToW(63) > 52428.0f && guFogTableIndexToW(63) < 52430.0f);
    guFogGenerateExp(table, 0.002f);
    for (i = 1; i < GR_FOG_TABLE_SIZE; i++) {
        CHECK(table[i] >= table[i - 1]);
    }
    grFogTable(table);
    clear_to(0x202020);
    for (row = 0; row < 4; row++) {
        Box box = cell(row * 4, 4, 6);
        FxU16 pixel;

        grFogMode(GR_FOG_DISABLE | flags[row]);
        fill_box(box, 100, 230, 200, 50);
        CHECK(middle(box) == pack565(230, 200, 50));
        box = cell(row * 4 + 1, 4, 6);
        grFogMode(GR_FOG_WITH_ITERATED_ALPHA | flags[row]);
        fill_box(box, 100, 230, 200, 50);
        pixel = middle(box);
        CHECK(pixel == pack565(fogged(230, 0x80, 100, flags[row]), fogged(200, 0x60, 100, flags[row]),
                               fogged(50, 0xa0, 100, flags[row])));
        grFogMode(GR_FOG_WITH_TABLE | flags[row]);
        far_box(cell(row * 4 + 2, 4, 6));
        box = cell(row * 4 + 3, 4, 6);
        grFogMode(GR_FOG_WITH_ITERATED_Z | flags[row]);
        flat_box(box, 0, 230, 200, 50, 150.0f * 256.0f, 1.0f);
        pixel = middle(box);
        CHECK(pixel == pack565(fogged(230, 0x80, 150, flags[row]), fogged(200, 0x60, 150, flags[row]),
                               fogged(50, 0xa0, 150, flags[row])));
    }
    grFogMode(GR_FOG_WITH_TABLE);
    for (i = 0; i < 4; i++) {
        Box box = cell(16 + i, 4, 6);

        if (i == 1) {
            guFogGenerateExp2(other, 0.002f);
            CHECK(memcmp(other, table, sizeof other) != 0);
        } else if (i == 2) {
            guFogGenerateLinear(other, 16.0f, 2000.0f);
            CHECK(other[0] == 0 && other[63] == 255);
        } else {
            memset(other, i == 3 ? 255 : 0, sizeof other);
        }
        grFogTable(other);
        far_box(box);
        if (i == 3) {
            /* All fog; the colour is that of the fog. */
            CHECK(middle(box) == pack565(0x80, 0x60, 0xa0));
        }
    }
    grBufferSwap(0);
    return finish();
}
