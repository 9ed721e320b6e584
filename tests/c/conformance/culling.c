/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * culling.c: a fan of triangles of both windings under the three cull modes
 * (columns), with both origins (rows): the sign of the area is that of the
 * numbers, whatever the origin. Points and lines are never culled.
 */
#include "conformance.h"

static int draw_fan(Box box)
{
    float x = (float)(box.x0 + box.x1) / 2.0f, y = (float)(box.y0 + box.y1) / 2.0f;
    FxU32 processed, drawn;
    int i;

    grResetTriStats();
    for (i = 0; i < 16; i++) {
        float a = 2.0f * PI * (float)i / 16.0f, b = 2.0f * PI * ((float)i + 0.7f) / 16.0f;
        Color c = hue((float)i / 16.0f);
        GrVertex p = vertex(x, y, c), q = vertex(x + 50 * cosine(a), y + 50 * sine(a), c);
        GrVertex r = vertex(x + 50 * cosine(b), y + 50 * sine(b), c);

        if (i & 1) {
            grDrawTriangle(&p, &q, &r);
        } else {
            grDrawTriangle(&p, &r, &q);
        }
    }
    grTriStats(&processed, &drawn);
    CHECK(processed == 16);
    return (int)drawn;
}

int main(void)
{
    int i;

    open_small(GR_ORIGIN_UPPER_LEFT);
    use_vertex_colors();
    clear_to(0x202020);
    for (i = 0; i < 6; i++) {
        static const int counts[3] = {16, 8, 8};
        Box box = cell(i % 3, 3, 2);
        GrVertex a = vertex((float)box.x0 + 4, (float)box.y0 + 4, rgb(1, 1, 1));
        GrVertex b = vertex((float)box.x1 - 4, (float)box.y0 + 9, rgb(1, 1, 0));

        grSstOrigin(i / 3 ? GR_ORIGIN_LOWER_LEFT : GR_ORIGIN_UPPER_LEFT);
        grCullMode(i % 3);
        CHECK(draw_fan(box) == counts[i % 3]);
        grDrawLine(&a, &b);
        grDrawLine(&b, &a);
        a.y += 8;
        grDrawPoint(&a);
    }
    /* A triangle without area counts as processed, and is never drawn. */
    {
        GrVertex a = vertex(10, 10, rgb(1, 1, 1)), b = vertex(20, 20, rgb(1, 1, 1));
        GrVertex c = vertex(30, 30, rgb(1, 1, 1));
        FxU32 processed, drawn;

        grCullMode(GR_CULL_DISABLE);
        grResetTriStats();
        grDrawTriangle(&a, &b, &c);
        grTriStats(&processed, &drawn);
        CHECK(processed == 1 && drawn == 0);
    }
    grBufferSwap(0);
    return finish();
}
