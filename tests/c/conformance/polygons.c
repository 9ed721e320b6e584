/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * polygons.c: polygons by list and by index draw what their fans of triangles
 * draw; planar ones take the gradients of their first triangle; clipped ones
 * draw what the clip window leaves.
 */
#include "conformance.h"

static FxU16 shots[2][80][106];

static void corners(Box box, GrVertex *v, int n)
{
    float x = (float)(box.x0 + box.x1) / 2, y = (float)(box.y0 + box.y1) / 2;
    int i;

    for (i = 0; i < n; i++) {
        float a = 2.0f * PI * ((float)i + 0.3f) / (float)n;
        v[i] = vertex(x + 46 * cosine(a), y + 36 * sine(a), hue((float)i / (float)n));
        v[i].oow = 1.0f / (1.0f + 0.2f * (float)(i % 3));
        set_texture(&v[i], 128 + 128 * cosine(a), 128 + 128 * sine(a));
    }
}

static void shoot(Box box, int which)
{
    CHECK(grLfbReadRegion(GR_BUFFER_BACKBUFFER, (FxU32)box.x0, (FxU32)box.y0, 104, 78,
                          sizeof shots[0][0], shots[which]));
}

int main(void)
{
    static const int order[9] = {0, 1, 2, 3, 4, 5, 6, 7, 8}, back[9] = {8, 7, 6, 5, 4, 3, 2, 1, 0};
    GrVertex v[9];
    Box box;
    int i;

    broken_on_purpose = "grDraw";
    open_small(GR_ORIGIN_UPPER_LEFT);
    use_vertex_colors();
    memset(shots, 0, sizeof shots);
    clear_to(0x202020);
    box = cell(0, 3, 3);
    corners(box, v, 9);
    for (i = 2; i < 9; i++) {
        grDrawTriangle(&v[0], &v[i - 1], &v[i]);
    }
    shoot(box, 0);
    fill_box(box, 255, 0x20, 0x20, 0x20);
    grDrawPolygonVertexList(9, v);
    shoot(box, 1);
    CHECK(memcmp(shots[0], shots[1], sizeof shots[0]) == 0);
    fill_box(box, 255, 0x20, 0x20, 0x20);
    grDrawPolygon(9, order, v);
    shoot(box, 1);
    CHECK(memcmp(shots[0], shots[1], sizeof shots[0]) == 0);

    corners(cell(1, 3, 3), v, 9);
    grDrawPolygon(9, back, v);
    /* Planar: colours that are no plane continue that of the first triangle. */
    corners(cell(3, 3, 3), v, 9);
    grDrawPlanarPolygonVertexList(9, v);
    corners(cell(4, 3, 3), v, 9);
    grDrawPlanarPolygon(9, back, v);
    /* Where they are one, the fan draws nearly the same. */
    corners(cell(5, 3, 3), v, 9);
    for (i = 0; i < 9; i++) {
        v[i].r = v[i].x * 0.7f;
        v[i].g = v[i].y * 0.9f;
        v[i].b = 255.0f - v[i].x * 0.3f - v[i].y * 0.3f;
    }
    grDrawPlanarPolygonVertexList(9, v);
    shoot(cell(5, 3, 3), 0);
    grDrawPolygonVertexList(9, v);
    shoot(cell(5, 3, 3), 1);
    {
        int x, y, far_off = 0;

        for (y = 0; y < 78; y++) {
            for (x = 0; x < 104; x++) {
                int d = green_of(shots[0][y][x]) - green_of(shots[1][y][x]);
                far_off += d > 4 || d < -4;
            }
        }
        CHECK(far_off == 0);
    }
    /* Few corners draw nothing, whatever the form. */
    grDrawPolygonVertexList(2, v);
    grDrawPolygon(0, order, v);
    grDrawPlanarPolygonVertexList(1, v);
    grDrawPlanarPolygon(-1, order, v);

    for (i = 0; i < 2; i++) {
        Box half;

        box = cell(6 + i, 3, 3), half = box;
        corners(box, v, 9);
        half.x0 += 30, half.y0 += 20, half.x1 -= 25, half.y1 -= 15;
        grClipWindow((FxU32)half.x0, (FxU32)half.y0, (FxU32)half.x1, (FxU32)half.y1);
        if (i == 0) {
            guDrawPolygonVertexListWithClip(9, v);
        } else {
            guDrawTriangleWithClip(&v[0], &v[3], &v[6]);
        }
        /* Clipped by geometry: with the window open nothing was drawn outside. */
        grClipWindow(0, 0, WIDE, HIGH);
        CHECK(read_pixel(GR_BUFFER_BACKBUFFER, half.x0 - 1, half.y0 + 20) == pack565(32, 32, 32));
        CHECK(read_pixel(GR_BUFFER_BACKBUFFER, half.x0 + 25, half.y0 + 20) != pack565(32, 32, 32));
    }
    grBufferSwap(0);
    return finish();
}
