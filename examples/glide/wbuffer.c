/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * wbuffer.c: buoys adrift from 8 to 300 units away on a rough sea. The w
 * buffer is a floating point depth: it stays sharp near the eye and still
 * tells wave from buoy at the horizon.
 */
#include "common.h"

#define SEA_ROWS    90
#define SEA_COLUMNS 64

static const float BUOYS[][4] = { /* x, z, radius, hue */
    {-4.2f, 13.0f, 2.3f, 0.01f}, {5.0f, 20.0f, 2.6f, 0.12f}, {-13.0f, 38.0f, 4.0f, 0.52f},
    {16.0f, 55.0f, 5.0f, 0.93f}, {-14.0f, 95.0f, 7.0f, 0.08f}, {52.0f, 150.0f, 12.0f, 0.56f},
    {-92.0f, 210.0f, 14.0f, 0.98f}, {40.0f, 300.0f, 16.0f, 0.14f}
};

static float wave(float x, float z, float time)
{
    return 0.62f * sine(0.33f * x + 0.21f * z + time) + 0.42f * sine(0.47f * z - 0.16f * x + 1.3f * time)
        + 0.20f * sine(0.91f * x - 0.73f * z + 2.1f * time);
}

/* A point of the sea: rows get longer towards the horizon. */
static Corner sea_corner(int row, int column, float time)
{
    float z = -1.5f + 0.13f * (float)row + 0.00058f * (float)(row * row * row);
    float x = ((float)column / SEA_COLUMNS - 0.5f) * (10.0f + 2.1f * z);
    float h = wave(x, z, time), e = 0.4f;
    Vec normal = unit(vec(wave(x - e, z, time) - wave(x + e, z, time), 2.0f * e,
                          wave(x, z - e, time) - wave(x, z + e, time)));
    Vec view = unit(vec(x, -4.0f, z));
    float mirror = 1.0f - clampf(-dot(view, normal), 0.0f, 1.0f);
    float glint = clampf(dot(normal, unit(vec(0.30f, 0.55f, 0.78f))), 0.0f, 1.0f);
    Color c = mix_color(rgb(0.01f, 0.13f, 0.20f), rgb(0.28f, 0.52f, 0.60f), mirror * mirror);

    glint = glint * glint;
    glint = glint * glint;
    glint = glint * glint;
    c = mix_color(c, rgb(1.0f, 0.86f, 0.62f), 0.9f * glint * glint);
    c = mix_color(c, rgb(0.92f, 0.80f, 0.66f), 0.75f * ramp(80.0f, 420.0f, z));
    return corner(vec(x, h, z), c, 0, 0);
}

static void draw_sea(const Camera *camera, float time)
{
    int row, column;

    for (row = 0; row < SEA_ROWS; row++) {
        for (column = 0; column < SEA_COLUMNS; column++) {
            Corner q[4];
            q[0] = sea_corner(row, column, time);
            q[1] = sea_corner(row, column + 1, time);
            q[2] = sea_corner(row + 1, column + 1, time);
            q[3] = sea_corner(row + 1, column, time);
            draw_in_space(camera, q, 4);
        }
    }
}

static Corner buoy_corner(const float *buoy, int stack, int slice, float time)
{
    float a = PI * (float)stack / 16.0f, b = 2.0f * PI * (float)slice / 24.0f;
    Vec n = turn(vec(sine(a) * cosine(b), cosine(a), sine(a) * sine(b)),
                 0.25f * sine(time + buoy[0]), 0.0f);
    float sun = clampf(dot(n, unit(vec(0.55f, 0.65f, -0.35f))), 0.0f, 1.0f);
    Color paint = stack / 3 % 2 == 0 ? rgb(0.97f, 0.95f, 0.90f) : hue(buoy[3]);
    Vec p = vec(buoy[0] + buoy[2] * n.x, 0.25f * buoy[2] + wave(buoy[0], buoy[1], time) + buoy[2] * n.y,
                buoy[1] + buoy[2] * n.z);
    Color c = scale_color(paint, 0.30f + 0.80f * sun);

    return corner(p, mix_color(c, rgb(0.92f, 0.80f, 0.66f), 0.6f * ramp(80.0f, 420.0f, p.z)), 0, 0);
}

static void draw_buoy(const Camera *camera, const float *buoy, float time)
{
    int stack, slice;

    for (stack = 0; stack < 16; stack++) {
        for (slice = 0; slice < 24; slice++) {
            Corner q[4];
            q[0] = buoy_corner(buoy, stack, slice, time);
            q[1] = buoy_corner(buoy, stack, slice + 1, time);
            q[2] = buoy_corner(buoy, stack + 1, slice + 1, time);
            q[3] = buoy_corner(buoy, stack + 1, slice, time);
            draw_in_space(camera, q, 4);
        }
    }
}

static void draw_sky(void)
{
    Color high = rgb(0.20f, 0.42f, 0.66f), low = rgb(0.95f, 0.84f, 0.70f);
    Color glow = {1.0f, 0.95f, 0.80f, 0.9f}, none = {1.0f, 0.85f, 0.60f, 0.0f};

    shade_rectangle(0, 0, 640, 215, high, low);
    shade_rectangle(0, 215, 640, 480, low, low);
    use_blending();
    shade_ellipse(436, 120, 210, 210, glow, none);
    use_no_blending();
    shade_ellipse(436, 120, 24, 24, rgb(1, 1, 0.95f), rgb(1, 1, 0.9f));
}

int main(int argc, char **argv)
{
    int frames = frames_wanted(argc, argv, 1), frame;
    size_t i;

    open_screen(GR_ORIGIN_UPPER_LEFT);
    use_vertex_colors();
    for (frame = 0; frame < frames; frame++) {
        float time = 0.7f + 0.04f * (float)frame;
        Camera camera = look_at(vec(0.0f, 5.0f, -3.0f), vec(1.0f, 2.0f, 20.0f), 480.0f);

        use_w_buffer();
        grBufferClear(0xff000000, 0, GR_WDEPTHVALUE_FARTHEST);
        use_no_depth_buffer();
        draw_sky();
        use_w_buffer();
        for (i = 0; i < sizeof BUOYS / sizeof BUOYS[0]; i++) {
            draw_buoy(&camera, BUOYS[i], time);
        }
        draw_sea(&camera, time);
        grBufferSwap(1);
    }
    grGlideShutdown();
    return 0;
}
