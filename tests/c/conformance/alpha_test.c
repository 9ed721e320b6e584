/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * alpha_test.c: the eight functions (rows) with references from 0 to 255
 * (columns), on boxes whose alpha runs from 0 to 255. Every pixel of a row is
 * checked.
 */
#include "conformance.h"

int main(void)
{
    static const GrAlpha_t references[5] = {0, 64, 128, 200, 255};
    int i, x;

    open_small(GR_ORIGIN_UPPER_LEFT);
    use_vertex_colors();
    clear_to(0x302050);
    for (i = 0; i < 40; i++) {
        Box box = cell(i, 5, 8);
        int function = i / 5, reference = references[i % 5];

        grAlphaTestFunction(function);
        grAlphaTestReferenceValue((GrAlpha_t)reference);
        for (x = box.x0; x < box.x1; x++) {
            Box column = box;
            int alpha = (x - box.x0) * 255 / (box.x1 - box.x0 - 1);
            int passes = compare_as(function, alpha, reference);

            column.x0 = x;
            column.x1 = x + 1;
            fill_box(column, alpha, 255, alpha, 40);
            CHECK(read_pixel(GR_BUFFER_BACKBUFFER, x, box.y0 + 5)
                  == (passes ? pack565(255, alpha, 40) : pack565(0x30, 0x20, 0x50)));
        }
    }
    grBufferSwap(0);
    return finish();
}
