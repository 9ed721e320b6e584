/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * lines.c: string art. The corners are gouraud shaded grDrawLine chords; the
 * heart in the middle is the envelope of antialiased lines that join each
 * point k of a circle with point 2k.
 */
#include "common.h"

#define CHORDS 240

/* Chords between two edges that meet in a corner of the screen. */
static void draw_corner(float cx, float cy, float dx, float dy, Color from, Color to)
{
    const int strings = 22;
    int i;

    for (i = 0; i <= strings; i++) {
        float t = (float)i / (float)strings;
        GrVertex a = vertex(cx + dx * t, cy, mix_color(from, to, t));
        GrVertex b = vertex(cx, cy + dy * (1.0f - t), mix_color(to, from, t));
        grDrawLine(&a, &b);
    }
}

static GrVertex on_circle(float turns, Color c)
{
    float angle = 2.0f * PI * turns;
    return vertex(320.0f - 214.0f * sine(angle), 240.0f + 214.0f * cosine(angle), c);
}

static void draw_envelope(float factor)
{
    int i;

    for (i = 0; i < CHORDS; i++) {
        float turns = (float)i / (float)CHORDS;
        Color c = mix_color(hue(0.58f + 0.45f * sine(PI * turns)), rgb(1, 1, 1), 0.12f);
        GrVertex a, b;

        c.a = 0.62f;
        a = on_circle(turns, c);
        b = on_circle(turns * factor, c);
        grAADrawLine(&a, &b);
    }
}

static void draw_rim(void)
{
    int i;

    for (i = 0; i < CHORDS; i++) {
        GrVertex a = on_circle((float)i / CHORDS, rgb(0.85f, 0.9f, 1.0f));
        GrVertex b = on_circle((float)(i + 1) / CHORDS, rgb(0.85f, 0.9f, 1.0f));
        grAADrawLine(&a, &b);
    }
}

int main(int argc, char **argv)
{
    int frames = frames_wanted(argc, argv, 1), frame;
    Color teal = rgb(0.10f, 0.75f, 0.72f), violet = rgb(0.50f, 0.22f, 0.85f);
    Color amber = rgb(0.98f, 0.62f, 0.16f), rose = rgb(0.90f, 0.20f, 0.42f);

    open_screen(GR_ORIGIN_UPPER_LEFT);
    for (frame = 0; frame < frames; frame++) {
        use_no_blending();
        use_vertex_colors();
        shade_rectangle(0, 0, 640, 480, rgb(0.04f, 0.05f, 0.12f), rgb(0.01f, 0.01f, 0.04f));
        draw_corner(0.5f, 0.5f, 210.0f, 210.0f, teal, violet);
        draw_corner(638.5f, 0.5f, -210.0f, 210.0f, amber, rose);
        draw_corner(0.5f, 478.5f, 210.0f, -210.0f, amber, rose);
        draw_corner(638.5f, 478.5f, -210.0f, -210.0f, teal, violet);
        use_blending();
        draw_envelope(2.0f + 0.01f * (float)frame);
        draw_rim();
        grBufferSwap(1);
    }
    grGlideShutdown();
    return 0;
}
