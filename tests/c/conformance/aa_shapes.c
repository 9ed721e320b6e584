/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * aa_shapes.c: smooth points at sixteenths of a pixel, lines in all
 * directions, triangles with each set of smooth edges, and polygons by index,
 * by list and through the clip window. Edges must have pixels between the two
 * colours.
 */
#include "conformance.h"

static void draw_points(Box box)
{
    int i;

    for (i = 0; i < 64; i++) {
        GrVertex p = vertex((float)(box.x0 + 4 + i % 8 * 12) + (float)(i % 8) / 8.0f,
                            (float)(box.y0 + 4 + i / 8 * 9) + (float)(i / 8) / 8.0f, rgb(1, 1, 1));
        grAADrawPoint(&p);
    }
}

static void draw_lines(Box box)
{
    float x = (float)(box.x0 + box.x1) / 2, y = (float)(box.y0 + box.y1) / 2;
    int i;

    for (i = 0; i < 24; i++) {
        float a = 2.0f * PI * (float)i / 24.0f;
        GrVertex p = vertex(x + 6 * cosine(a), y + 6 * sine(a), rgb(1, 1, 1));
        GrVertex q = vertex(x + 36 * cosine(a), y + 36 * sine(a), hue((float)i / 24.0f));

        grAADrawLine(&p, &q);
    }
}

static void star(Box box, GrVertex *v, int n)
{
    float x = (float)(box.x0 + box.x1) / 2, y = (float)(box.y0 + box.y1) / 2;
    int i;

    for (i = 0; i < n; i++) {
        float a = 2.0f * PI * ((float)i + 0.2f) / (float)n;
        v[i] = vertex(x + 34 * cosine(a), y + 34 * sine(a), hue((float)i / (float)n));
    }
}

/* Pixels that are neither background nor as bright as the shape. */
static int soft_pixels(Box box)
{
    int x, y, count = 0;

    for (y = box.y0; y < box.y1; y++) {
        for (x = box.x0; x < box.x1; x++) {
            int g = green_of(read_pixel(GR_BUFFER_BACKBUFFER, x, y));
            count += g > 60 && g < 225;
        }
    }
    return count;
}

int main(void)
{
    static const int order[6] = {5, 4, 3, 2, 1, 0};
    GrVertex v[6];
    int i, soft[8];

    open_small(GR_ORIGIN_UPPER_LEFT);
    use_vertex_colors();
    use_blending();
    clear_to(0x303030);
    draw_points(cell(0, 3, 3));
    draw_lines(cell(1, 3, 3));
    CHECK(soft_pixels(cell(0, 3, 3)) > 60);
    /* Each set of smooth edges: more soft pixels with more of them. */
    for (i = 0; i < 8; i++) {
        Box box = cell(24 + i, 8, 6);
        GrVertex a, b, c;

        a = vertex((float)box.x0 + 3, (float)box.y1 - 4, rgb(1, 1, 1));
        b = vertex((float)box.x1 - 4.5f, (float)box.y1 - 9, rgb(1, 1, 1));
        c = vertex((float)box.x0 + 14.25f, (float)box.y0 + 3, rgb(1, 1, 1));
        grAADrawTriangle(&a, &b, &c, i & 1, i >> 1 & 1, i >> 2 & 1);
        soft[i] = soft_pixels(box);
        if (i > 0) {
            CHECK(soft[i] > soft[0]);
        }
    }
    CHECK(soft[7] > soft[1] && soft[7] > soft[2] && soft[7] > soft[4]);
    star(cell(6, 3, 3), v, 6);
    grAADrawPolygonVertexList(6, v);
    star(cell(7, 3, 3), v, 6);
    grAADrawPolygon(6, order, v);
    /* Clipped in the middle: the cut edge is hard only where the window ends. */
    {
        Box box = cell(8, 3, 3);

        star(box, v, 6);
        grClipWindow((FxU32)box.x0 + 20, (FxU32)box.y0 + 15, (FxU32)box.x1 - 20, (FxU32)box.y1 - 10);
        for (i = 2; i < 6; i++) {
            guAADrawTriangleWithClip(&v[0], &v[i - 1], &v[i]);
        }
        grClipWindow(0, 0, WIDE, HIGH);
    }
    grBufferSwap(0);
    return finish();
}
