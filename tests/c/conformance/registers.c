/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * registers.c: grSstConfigPipeline: a stipple pattern, the constant colours
 * apart, a clip window, a texture's base and mode, written as raw registers,
 * act as the functions do.
 */
#include "conformance.h"

enum {
    FBZ_COLOR_PATH = 65, FBZ_MODE = 68, CLIP_LEFT_RIGHT = 70, CLIP_LOW_Y = 71, STIPPLE = 80,
    COLOR0 = 81, COLOR1 = 82
};

/* fbzMode as the functions leave it: clip, colour mask, back buffer. */
#define MODE 0x4201U

int main(void)
{
    Box box;
    int x, y;

    open_small(GR_ORIGIN_UPPER_LEFT);
    use_vertex_colors();
    clear_to(0x202020);
    grSstConfigPipeline(GR_FBI, STIPPLE, 0xf00f5aa5U);
    grSstConfigPipeline(GR_FBI, FBZ_MODE, MODE | 1U << 2 | 1U << 12);
    box = cell(0, 3, 2);
    fill_box(box, 255, 255, 255, 0);
    for (y = box.y0; y < box.y1; y += 3) {
        for (x = box.x0; x < box.x1; x++) {
            int bit = (y & 3) << 3 | (~x & 7);

            CHECK(read_pixel(GR_BUFFER_BACKBUFFER, x, y)
                  == (0xf00f5aa5U >> bit & 1 ? pack565(255, 255, 0) : pack565(32, 32, 32)));
        }
    }
    grSstConfigPipeline(GR_FBI, FBZ_MODE, MODE);
    /* Two constants: one as "local", one as "other". */
    grConstantColorValue(0xff102030);
    grSstConfigPipeline(GR_FBI, COLOR1, 0xffc0a080U);
    grColorCombine(GR_COMBINE_FUNCTION_SCALE_OTHER_ADD_LOCAL, GR_COMBINE_FACTOR_ONE,
                   GR_COMBINE_LOCAL_CONSTANT, GR_COMBINE_OTHER_CONSTANT, FXFALSE);
    box = cell(1, 3, 2);
    fill_box(box, 255, 0, 0, 0);
    CHECK(middle(box) == pack565(0xd0, 0xc0, 0xb0));
    grSstConfigPipeline(GR_FBI, COLOR0, 0xff3f0000U);
    box = cell(2, 3, 2);
    fill_box(box, 255, 0, 0, 0);
    CHECK(middle(box) == pack565(0xff, 0xa0, 0x80));
    grSstConfigPipeline(GR_FBI, CLIP_LEFT_RIGHT, 30U << 16 | 90U);
    grSstConfigPipeline(GR_FBI, CLIP_LOW_Y, 150U << 16 | 200U);
    use_vertex_colors();
    fill_box(cell(0, 1, 1), 255, 0, 128, 255);
    CHECK(read_pixel(GR_BUFFER_BACKBUFFER, 30, 150) == pack565(0, 128, 255));
    CHECK(read_pixel(GR_BUFFER_BACKBUFFER, 90, 150) != pack565(0, 128, 255));
    CHECK(read_pixel(GR_BUFFER_BACKBUFFER, 29, 150) != pack565(0, 128, 255));
    CHECK(read_pixel(GR_BUFFER_BACKBUFFER, 30, 200) != pack565(0, 128, 255));
    grClipWindow(0, 0, WIDE, HIGH);
    fill_box(cell(5, 3, 2), 255, 0, 128, 255);
    grBufferSwap(0);
    return finish();
}
