/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * dither_modes.c: ramps without dithering, with 2x2 and with 4x4 (columns), as
 * triangles, clears and frame buffer writes (rows). Every pixel of the flat
 * colours is compared with the matrix.
 */
#include "conformance.h"

static const int four[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
static const int two[2][2] = {{2, 10}, {14, 6}};

static FxU16 dithered(GrDitherMode_t mode, int x, int y, int r, int g, int b)
{
    int d = mode == GR_DITHER_4x4 ? four[y & 3][x & 3] : two[y & 1][x & 1];

    if (mode == GR_DITHER_DISABLE) {
        return pack565(r, g, b);
    }
    r = ((r << 1) - (r >> 4) + (r >> 7) + d) >> 4;
    g = ((g << 2) - (g >> 4) + (g >> 6) + d) >> 4;
    b = ((b << 1) - (b >> 4) + (b >> 7) + d) >> 4;
    return (FxU16)(r << 11 | g << 5 | b);
}

static void check_flat(Box box, GrDitherMode_t mode, int r, int g, int b)
{
    int x, y;

    for (y = box.y0; y < box.y1; y++) {
        for (x = box.x0; x < box.x1; x++) {
            CHECK(read_pixel(GR_BUFFER_BACKBUFFER, x, y) == dithered(mode, x, y, r, g, b));
        }
    }
}

/* Strips of greys that differ by less than 565 can say. */
static void write_strips(Box box, int kind, GrDitherMode_t mode)
{
    int i;

    for (i = 0; i < 8; i++) {
        Box strip = box;
        int r = 100 + i, g = 40 + 2 * i, b = 250 - 3 * i;

        strip.x0 = box.x0 + 12 * i;
        strip.x1 = strip.x0 + 12;
        if (kind == 0) {
            fill_box(strip, 255, r, g, b);
        } else if (kind == 1) {
            grClipWindow((FxU32)strip.x0, (FxU32)strip.y0, (FxU32)strip.x1, (FxU32)strip.y1);
            grBufferClear((FxU32)(r << 16 | g << 8 | b), 0, 0);
            grClipWindow(0, 0, WIDE, HIGH);
        } else {
            FxU32 row[12];
            int x, y;

            for (x = 0; x < 12; x++) {
                row[x] = (FxU32)(r << 16 | g << 8 | b);
            }
            for (y = strip.y0; y < strip.y1; y++) {
                CHECK(grLfbWriteRegion(GR_BUFFER_BACKBUFFER, (FxU32)strip.x0, (FxU32)y,
                                       GR_LFB_SRC_FMT_888, 12, 1, sizeof row, row));
            }
        }
        check_flat(strip, mode, r, g, b);
    }
}

int main(void)
{
    int mode, kind;

    open_small(GR_ORIGIN_UPPER_LEFT);
    use_vertex_colors();
    clear_to(0x202020);
    for (mode = GR_DITHER_DISABLE; mode <= GR_DITHER_4x4; mode++) {
        Box ramp = cell(mode, 3, 4), blended = cell(mode, 3, 4);

        grDitherMode(mode);
        ramp.y1 -= 20;
        shaded_box(ramp, rgb(0, 0, 0), rgb(0.3f, 0, 0.3f), rgb(0.3f, 0.3f, 0), rgb(0, 0.3f, 0.1f));
        /* Blended over itself: with 4x4 the destination's dither is taken out. */
        blended.y0 = blended.y1 - 20;
        shaded_box(blended, rgb(0, 0, 0), rgb(0.3f, 0, 0.3f), rgb(0.3f, 0.3f, 0), rgb(0, 0.3f, 0.1f));
        use_blending();
        shaded_box(blended, rgba(1, 1, 1, 0.1f), rgba(0, 0, 0, 0.1f), rgba(1, 1, 1, 0.1f), rgba(0, 0, 0, 0.1f));
        use_no_blending();
        for (kind = 0; kind < 3; kind++) {
            write_strips(cell(3 * (kind + 1) + mode, 3, 4), kind, mode);
        }
    }
    grBufferSwap(0);
    return finish();
}
