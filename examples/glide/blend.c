/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * blend.c: what alpha blending can do. On the left, three lamps: light adds
 * up to white. On the right, three panes of glass: each takes its share away
 * by multiplying with what is behind. Below, panes over a chequered board
 * whose alpha runs from 0 to 1.
 */
#include "common.h"

/* A disc of one colour; only the outer edge of each triangle is antialiased. */
static void draw_disc(float x, float y, float radius, Color c)
{
    GrVertex middle = vertex(x, y, c), a, b = vertex(x + radius, y, c);
    int i;

    for (i = 1; i <= 72; i++) {
        float angle = 2.0f * PI * (float)i / 72.0f;
        a = b;
        b = vertex(x + radius * cosine(angle), y + radius * sine(angle), c);
        grAADrawTriangle(&middle, &a, &b, FXFALSE, FXTRUE, FXFALSE);
    }
}

static void draw_lamps(float x, float y, float time)
{
    int i;

    use_added_light();
    for (i = 0; i < 3; i++) {
        float angle = time + 2.0f * PI * ((float)i / 3.0f - 0.25f);
        Color c = rgb(i == 0 ? 0.93f : 0.04f, i == 1 ? 0.90f : 0.06f, i == 2 ? 0.96f : 0.06f);
        Color halo = c;
        float cx = x + 52.0f * cosine(angle), cy = y + 52.0f * sine(angle);

        draw_disc(cx, cy, 82.0f, c);
        c.a = 0.30f;
        halo.a = 0.0f;
        shade_ellipse(cx, cy, 150.0f, 150.0f, c, halo);
    }
}

static void draw_panes(float x, float y, float time)
{
    static const float tint[3][3] = {{0.16f, 0.78f, 0.92f}, {0.94f, 0.22f, 0.62f}, {0.98f, 0.87f, 0.14f}};
    int i;

    use_no_blending();
    draw_disc(x, y, 158.0f, rgb(0.97f, 0.96f, 0.93f));
    grAlphaBlendFunction(GR_BLEND_DST_COLOR, GR_BLEND_ZERO, GR_BLEND_ONE, GR_BLEND_ZERO);
    for (i = 0; i < 3; i++) {
        float angle = time + 2.0f * PI * ((float)i / 3.0f - 0.25f);
        GrVertex rim[72];
        int k;

        for (k = 0; k < 72; k++) {
            float turn_by = 2.0f * PI * (float)k / 72.0f;
            rim[k] = vertex(x + 52.0f * cosine(angle) + 82.0f * cosine(turn_by),
                            y + 52.0f * sine(angle) + 82.0f * sine(turn_by),
                            rgb(tint[i][0], tint[i][1], tint[i][2]));
        }
        grDrawPolygonVertexList(72, rim);
    }
}

static void draw_board(float x0, float y0, float x1, float y1)
{
    int i, j;

    use_no_blending();
    for (j = 0; (float)j * 16.0f < y1 - y0; j++) {
        for (i = 0; (float)i * 16.0f < x1 - x0; i++) {
            Color c = (i + j) & 1 ? rgb(0.85f, 0.85f, 0.88f) : rgb(0.35f, 0.36f, 0.42f);
            shade_rectangle(x0 + 16.0f * (float)i, y0 + 16.0f * (float)j,
                            x0 + 16.0f * (float)(i + 1), y0 + 16.0f * (float)(j + 1), c, c);
        }
    }
}

/* Four panes, alpha 0 at the left edge and 1 at the right. */
static void draw_ramps(float x0, float y0, float x1)
{
    int i;

    use_blending();
    for (i = 0; i < 4; i++) {
        Color c = hue(0.55f + 0.16f * (float)i), clear = c;
        float y = y0 + 6.0f + 22.0f * (float)i;
        GrVertex a, b, d, e;

        clear.a = 0.0f;
        a = vertex(x0, y, clear);
        b = vertex(x1, y, c);
        d = vertex(x1, y + 16.0f, c);
        e = vertex(x0, y + 16.0f, clear);
        draw_quad(&a, &b, &d, &e);
    }
}

int main(int argc, char **argv)
{
    int frames = frames_wanted(argc, argv, 1), frame;

    open_screen(GR_ORIGIN_UPPER_LEFT);
    use_vertex_colors();
    for (frame = 0; frame < frames; frame++) {
        float time = 0.05f * (float)frame;

        use_no_blending();
        shade_rectangle(0, 0, 640, 480, rgb(0.06f, 0.06f, 0.09f), rgb(0.11f, 0.11f, 0.16f));
        draw_lamps(168.0f, 176.0f, time);
        draw_panes(472.0f, 176.0f, time);
        draw_board(32.0f, 364.0f, 608.0f, 460.0f);
        draw_ramps(32.0f, 364.0f, 608.0f);
        grBufferSwap(1);
    }
    grGlideShutdown();
    return 0;
}
