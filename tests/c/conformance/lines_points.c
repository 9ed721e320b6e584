/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * lines_points.c: points at every sixteenth of a pixel light the pixel that
 * holds them; lines in all directions have a pixel in each column or row; the
 * vertex snap of programs, a bias of 786432, changes nothing.
 */
#include "conformance.h"

int main(void)
{
    static FxU16 shots[2][110][150];
    int i, x, y;

    open_small(GR_ORIGIN_UPPER_LEFT);
    use_vertex_colors();
    clear_to(0);
    for (i = 0; i < 256; i++) {
        GrVertex p = byte_vertex(0, 0, 255, 255, 255, 255);
        int column = 4 + i % 16 * 4, row = 4 + i / 16 * 4;

        p.x = (float)column + (float)(i % 16) / 16.0f;
        p.y = (float)row + (float)(i / 16) / 16.0f;
        grDrawPoint(&p);
        CHECK(read_pixel(GR_BUFFER_BACKBUFFER, column, row) == 0xffff);
        CHECK(read_pixel(GR_BUFFER_BACKBUFFER, column + 1, row) == 0);
        CHECK(read_pixel(GR_BUFFER_BACKBUFFER, column, row + 1) == 0);
    }
    for (i = 0; i < 32; i++) {
        float a = 2.0f * PI * (float)i / 32.0f;
        GrVertex p = vertex(160.5f, 60.5f, rgb(1, 1, 1));
        GrVertex q = vertex(160.5f + 50 * cosine(a), 60.5f + 50 * sine(a), hue((float)i / 32.0f));

        grDrawLine(&p, &q);
    }
    /* A line has a pixel in each column of the longer way. */
    {
        GrVertex p = vertex(220.5f, 20.5f, rgb(1, 1, 1)), q = vertex(300.5f, 50.25f, rgb(1, 1, 1));

        grDrawLine(&p, &q);
        for (x = 221; x < 300; x++) {
            int lit = 0;

            for (y = 15; y < 60; y++) {
                lit += read_pixel(GR_BUFFER_BACKBUFFER, x, y) == 0xffff;
            }
            CHECK(lit == 1);
        }
    }
    for (i = 0; i < 2; i++) {
        float bias = i ? 786432.0f : 0.0f;
        GrVertex v[3];
        int k;

        fill_box(cell(2 + i, 2, 2), 255, 0, 0, 0);
        for (k = 0; k < 3; k++) {
            float a = 2.0f * PI * ((float)k / 3.0f + 0.07f);

            v[k] = vertex(80.0f + 60 * cosine(a), 180.0f + 50 * sine(a), hue((float)k / 3.0f));
            v[k].x += 160.0f * (float)i + bias;
            v[k].y += bias;
        }
        grDrawTriangle(&v[0], &v[1], &v[2]);
        CHECK(grLfbReadRegion(GR_BUFFER_BACKBUFFER, (FxU32)(5 + 160 * i), 125, 150, 110, sizeof shots[0][0], shots[i]));
    }
    CHECK(memcmp(shots[0], shots[1], sizeof shots[0]) == 0);
    grBufferSwap(0);
    return finish();
}
