/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * clip.c: moving clip windows. A rosette is drawn in night colours over the
 * whole screen, then again in day colours through each of three windows. The
 * clip window also limits the clear, which lays each window's ground.
 */
#include "common.h"

#define PETALS 24

static Color petal_color(int ring, int i, int day)
{
    float t = (float)i / PETALS + 0.08f * (float)ring;
    Color c = hue(0.95f + 0.5f * fabsf(2.0f * (t - floorf(t)) - 1.0f));

    if (day) {
        return mix_color(c, rgb(1.0f, 0.96f, 0.84f), 0.18f + 0.12f * (float)(i & 1));
    }
    return rgb(0.06f + 0.07f * c.g, 0.08f + 0.09f * c.g, 0.20f + 0.15f * c.r);
}

/* A ring of kites around the middle of the screen. */
static void draw_ring(int ring, float time, int day)
{
    float inner = 40.0f + 62.0f * (float)ring, outer = inner + 118.0f;
    float offset = time * (ring & 1 ? -1.0f : 1.0f);
    int i;

    for (i = 0; i < PETALS; i++) {
        float a = 2.0f * PI * ((float)i + 0.5f * (float)(ring & 1)) / PETALS + offset;
        float half = 0.86f * PI / PETALS, middle = inner + 70.0f;
        Color c = petal_color(ring, i, day), dark = scale_color(c, 0.55f);
        GrVertex p = vertex(320.0f + inner * cosine(a), 240.0f + inner * sine(a), dark);
        GrVertex q = vertex(320.0f + middle * cosine(a + half), 240.0f + middle * sine(a + half), c);
        GrVertex r = vertex(320.0f + outer * cosine(a), 240.0f + outer * sine(a), mix_color(c, rgb(1, 1, 1), day ? 0.55f : 0.1f));
        GrVertex s = vertex(320.0f + middle * cosine(a - half), 240.0f + middle * sine(a - half), scale_color(c, 0.8f));
        draw_quad(&p, &q, &r, &s);
    }
}

static void draw_rosette(float time, int day)
{
    int ring;

    for (ring = 5; ring >= 0; ring--) {
        draw_ring(ring, time, day);
    }
    shade_ellipse(320, 240, 58, 58, day ? rgb(1.0f, 0.98f, 0.86f) : rgb(0.25f, 0.28f, 0.45f),
                  day ? rgb(0.98f, 0.66f, 0.20f) : rgb(0.06f, 0.07f, 0.16f));
}

/* Shows the day through one window, with a light frame around it. */
static void draw_window(float x, float y, float w, float h, float time)
{
    FxU32 x0 = (FxU32)clampf(x, 0.0f, 640.0f), y0 = (FxU32)clampf(y, 0.0f, 480.0f);
    FxU32 x1 = (FxU32)clampf(x + w, 0.0f, 640.0f), y1 = (FxU32)clampf(y + h, 0.0f, 480.0f);

    grClipWindow(x0, y0, x1, y1);
    grBufferClear(0xfff6efe0, 0, 0);
    if (x1 - x0 > 8 && y1 - y0 > 8) {
        grClipWindow(x0 + 4, y0 + 4, x1 - 4, y1 - 4);
        grBufferClear(0xff8fc1d9, 0, 0);
        draw_rosette(time, 1);
    }
    grClipWindow(0, 0, SCREEN_WIDTH, SCREEN_HEIGHT);
}

int main(int argc, char **argv)
{
    int frames = frames_wanted(argc, argv, 60), frame;

    open_screen(GR_ORIGIN_UPPER_LEFT);
    use_vertex_colors();
    for (frame = 0; frame < frames; frame++) {
        float time = 2.0f * PI * (float)frame / 60.0f, spin = 0.1f + 0.04f * time;

        grBufferClear(0xff05060f, 0, 0);
        draw_rosette(spin, 0);
        draw_window(60.0f + 90.0f * sine(time), 46.0f, 190.0f, 150.0f, spin);
        draw_window(330.0f - 40.0f * sine(time), 120.0f + 70.0f * cosine(time), 240.0f, 180.0f, spin);
        draw_window(120.0f + 120.0f * cosine(time), 318.0f, 150.0f, 118.0f, spin);
        grBufferSwap(1);
    }
    grGlideShutdown();
    return 0;
}
