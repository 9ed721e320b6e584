/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * depth_modes.c: the depth modes (rows: z, w, z and w compared to the bias,
 * off) with the eight functions (columns). In each cell three strips are drawn
 * over a middle depth: nearer, as near, farther. Then a bias, and the mask.
 */
#include "conformance.h"

/* z of the strips, and w as it is in a w buffer: 16-bit floats of 1/w. */
static const float strip_z[3] = {40000.0f, 30000.0f, 20000.0f};
static const float strip_w[3] = {1.0f / 4.0f, 1.0f / 8.0f, 1.0f / 16.0f};
static const int w_buffer[3] = {0x2000, 0x3000, 0x4000};

static void draw_cell(int row, int column)
{
    static const GrDepthBufferMode_t modes[5] = {
        GR_DEPTHBUFFER_ZBUFFER, GR_DEPTHBUFFER_WBUFFER, GR_DEPTHBUFFER_ZBUFFER_COMPARE_TO_BIAS,
        GR_DEPTHBUFFER_WBUFFER_COMPARE_TO_BIAS, GR_DEPTHBUFFER_DISABLE};
    Box box = cell(row * 8 + column, 8, 6), strip;
    int i, w = row == 1 || row == 3, stored;

    /* The middle depth, in dark blue. */
    grDepthMask(FXTRUE);
    grDepthBufferMode(w ? GR_DEPTHBUFFER_WBUFFER : GR_DEPTHBUFFER_ZBUFFER);
    grDepthBufferFunction(GR_CMP_ALWAYS);
    grDepthBiasLevel(0);
    flat_box(box, 255, 0, 0, 100, strip_z[1], strip_w[1]);
    stored = w ? w_buffer[1] : 30000;
    CHECK(read_pixel(GR_BUFFER_AUXBUFFER, box.x0 + 2, box.y0 + 2) == stored);
    grDepthBufferMode(modes[row]);
    grDepthBufferFunction(column);
    /* What the last two modes compare instead of the pixel's depth. */
    grDepthBiasLevel(row == 2 ? 30000 : row == 3 ? 0x3000 : 0);
    for (i = 0; i < 3; i++) {
        int depth = w ? w_buffer[i] : (int)strip_z[i];
        int source = row == 2 ? 30000 : row == 3 ? 0x3000 : depth;
        int passes = row == 4 || compare_as(column, source, stored);
        FxU16 expected = passes ? pack565(255, 80 * i, 0) : pack565(0, 0, 100);

        strip = box;
        strip.x0 = box.x0 + 4 + 10 * i;
        strip.x1 = strip.x0 + 9;
        flat_box(strip, 255, 255, 80 * i, 0, strip_z[i], strip_w[i]);
        CHECK(middle(strip) == expected);
        if (middle(strip) != expected) {
            printf("mode %d function %d strip %d\n", (int)modes[row], column, i);
        }
        /* Depth is written where the test passes; the bias modes write the
         * pixel's depth, not the one compared. */
        CHECK(row == 4 || read_pixel(GR_BUFFER_AUXBUFFER, strip.x0 + 2, strip.y0 + 2)
              == (passes ? depth : stored));
    }
}

/* A bias of the same depth lets one win over the other. */
static void draw_biases(void)
{
    int i;

    grDepthBufferMode(GR_DEPTHBUFFER_ZBUFFER);
    for (i = 0; i < 8; i++) {
        Box box = cell(40 + i, 8, 6), inner = box;
        int level = (i - 4) * 200;

        inner.x0 += 8, inner.x1 -= 8;
        grDepthBufferFunction(GR_CMP_ALWAYS);
        grDepthBiasLevel(0);
        grDepthMask(FXTRUE);
        flat_box(box, 255, 0, 100, 0, 30000.0f, 1.0f);
        grDepthBufferFunction(GR_CMP_GREATER);
        grDepthBiasLevel((FxI16)level);
        grDepthMask(i & 1 ? FXTRUE : FXFALSE);
        flat_box(inner, 255, 255, 255, 0, 30000.0f, 1.0f);
        CHECK(middle(inner) == (level > 0 ? pack565(255, 255, 0) : pack565(0, 100, 0)));
        CHECK(read_pixel(GR_BUFFER_AUXBUFFER, inner.x0 + 2, inner.y0 + 2)
              == (level > 0 && (i & 1) ? 30000 + level : 30000));
    }
}

int main(void)
{
    int i;

    open_small(GR_ORIGIN_UPPER_LEFT);
    use_vertex_colors();
    clear_to(0x202020);
    for (i = 0; i < 40; i++) {
        draw_cell(i / 8, i % 8);
    }
    draw_biases();
    grBufferSwap(0);
    return finish();
}
