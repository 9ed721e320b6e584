/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * polygon.c: a rose window of convex polygons. Its panes go through each of
 * the polygon calls: from an index list or a plain vertex list, with gradients
 * computed per triangle or once (planar), and antialiased.
 */
#include "common.h"

#define CX 320.0f
#define CY 240.0f

static GrVertex polar(float radius, float turns, Color c)
{
    float angle = 2.0f * PI * turns;
    return vertex(CX + radius * sine(angle), CY - radius * cosine(angle), c);
}

/* Light comes through the glass stronger towards the upper left. */
static Color glass(Color c, float radius, float turns)
{
    float angle = 2.0f * PI * turns;
    float light = 0.80f - 0.0011f * radius * (sine(angle) - cosine(angle));

    return mix_color(scale_color(c, light), rgb(1.0f, 0.97f, 0.88f), 0.10f * light);
}

static GrVertex pane_corner(float radius, float turns, Color c)
{
    return polar(radius, turns, glass(c, radius, turns));
}

/* A petal with a round end: seven corners, antialiased. */
static void draw_petal(float r0, float r1, float turns, float width, Color c)
{
    GrVertex v[7];

    v[0] = pane_corner(r0, turns, c);
    v[1] = pane_corner(mixf(r0, r1, 0.45f), turns + width * 0.86f, c);
    v[2] = pane_corner(mixf(r0, r1, 0.80f), turns + width * 0.84f, scale_color(c, 1.12f));
    v[3] = pane_corner(mixf(r0, r1, 0.96f), turns + width * 0.48f, scale_color(c, 1.2f));
    v[4] = pane_corner(mixf(r0, r1, 0.96f), turns - width * 0.48f, scale_color(c, 1.2f));
    v[5] = pane_corner(mixf(r0, r1, 0.80f), turns - width * 0.84f, scale_color(c, 1.12f));
    v[6] = pane_corner(mixf(r0, r1, 0.45f), turns - width * 0.86f, c);
    grAADrawPolygonVertexList(7, v);
}

/* A regular polygon; `list` holds all corners, drawn through an index list. */
static void draw_medallion(float radius, float turns, float size, int sides, Color c)
{
    GrVertex list[12], middle = polar(radius, turns, c);
    int indices[12], i;

    for (i = 0; i < sides; i++) {
        float angle = 2.0f * PI * ((float)i / (float)sides + turns);
        Color shade = glass(scale_color(c, 0.85f + 0.3f * cosine(angle + 0.8f)), radius, turns);
        list[i] = vertex(middle.x + size * sine(angle), middle.y - size * cosine(angle), shade);
        indices[i] = sides - 1 - i; /* the other way round: same polygon */
    }
    if (sides & 1) {
        grDrawPolygon(sides, indices, list);
    } else {
        grAADrawPolygon(sides, indices, list);
    }
}

/* A pane between two radii; its colours are planar, so one gradient does. */
static void draw_sector(float r0, float r1, float t0, float t1, Color c)
{
    GrVertex v[4];
    const int indices[4] = {0, 1, 2, 3};

    v[0] = pane_corner(r0, t0, c);
    v[1] = pane_corner(r1, t0, c);
    v[2] = pane_corner(r1, t1, c);
    v[3] = pane_corner(r0, t1, c);
    if (r0 > 200.0f) {
        grDrawPlanarPolygon(4, indices, v);
    } else {
        grDrawPlanarPolygonVertexList(4, v);
    }
}

static void draw_rose(float spin)
{
    static const float jewels[6][3] = {
        {0.80f, 0.07f, 0.12f}, {0.08f, 0.22f, 0.72f}, {0.93f, 0.64f, 0.10f},
        {0.06f, 0.50f, 0.36f}, {0.46f, 0.14f, 0.62f}, {0.10f, 0.55f, 0.76f}
    };
    int i;

    for (i = 0; i < 48; i++) {
        const float *j = jewels[(i * 5 + i / 4) % 6];
        float t = spin + (float)i / 48.0f;
        draw_sector(206.0f, 226.0f, t + 0.0016f, t + 1.0f / 48.0f - 0.0016f, rgb(j[0], j[1], j[2]));
    }
    for (i = 0; i < 12; i++) {
        const float *a = jewels[i & 1 ? 0 : 1], *b = jewels[i & 1 ? 5 : 2];
        float t = spin + (float)i / 12.0f;
        draw_petal(92.0f, 202.0f, t, 1.0f / 27.0f, rgb(a[0], a[1], a[2]));
        draw_medallion(184.0f, t + 1.0f / 24.0f, 19.0f, 8, rgb(b[0], b[1], b[2]));
        draw_medallion(142.0f, t + 1.0f / 24.0f, 8.0f, 5, rgb(0.96f, 0.86f, 0.42f));
    }
    for (i = 0; i < 24; i++) {
        const float *j = jewels[i % 3 == 0 ? 2 : i & 1 ? 4 : 3];
        float t = spin + (float)i / 24.0f;
        draw_sector(66.0f, 88.0f, t + 0.004f, t + 1.0f / 24.0f - 0.004f, rgb(j[0], j[1], j[2]));
    }
    for (i = 0; i < 6; i++) {
        const float *j = jewels[i & 1 ? 1 : 0];
        draw_petal(12.0f, 64.0f, spin + (float)i / 6.0f, 1.0f / 13.5f, rgb(j[0], j[1], j[2]));
    }
    draw_medallion(0.0f, spin, 13.0f, 12, rgb(1.0f, 0.84f, 0.30f));
}

/* Blocks of the wall around the window. */
static void draw_wall(void)
{
    int i, j;

    for (j = 0; j < 12; j++) {
        for (i = -1; i < 9; i++) {
            float x = 80.0f * (float)i + (j & 1 ? 40.0f : 0.0f), y = 40.0f * (float)j;
            float tone = 0.15f + 0.05f * lattice(i + 5, j);
            Color top = rgb(tone * 1.12f, tone * 1.08f, tone), bottom = scale_color(top, 0.72f);
            shade_rectangle(x + 1.0f, y + 1.0f, x + 79.0f, y + 39.0f, top, bottom);
        }
    }
    shade_ellipse(CX, CY, 240.0f, 240.0f, rgb(0.26f, 0.25f, 0.24f), rgb(0.36f, 0.34f, 0.31f));
    shade_ellipse(CX, CY, 231.0f, 231.0f, rgb(0.03f, 0.03f, 0.04f), rgb(0.02f, 0.02f, 0.03f));
}

int main(int argc, char **argv)
{
    int frames = frames_wanted(argc, argv, 1), frame;
    Color glow = {0.62f, 0.50f, 0.80f, 0.22f}, none = {0.62f, 0.40f, 0.70f, 0.0f};

    open_screen(GR_ORIGIN_UPPER_LEFT);
    use_vertex_colors();
    for (frame = 0; frame < frames; frame++) {
        grBufferClear(0xff0a0a0c, 0, 0);
        use_no_blending();
        draw_wall();
        use_blending();
        draw_rose(0.001f * (float)frame);
        use_added_light();
        shade_ellipse(CX, CY, 330.0f, 330.0f, glow, none);
        grBufferSwap(1);
    }
    grGlideShutdown();
    return 0;
}
