/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * flat.c: mountains at dusk, one constant colour per triangle. There is no
 * depth buffer: the rows of the landscape are painted from far to near.
 */
#include "common.h"

#define COLUMNS 44
#define ROWS    34

static float height(int column, int row)
{
    float u = (float)column / COLUMNS, v = (float)row / ROWS;
    float ridge = cloud(u, v * 0.9f, 5) - 0.30f;
    float valley = ramp(0.0f, 0.34f, fabsf(u - 0.47f - 0.12f * sine(5.0f * v)));

    return 44.0f * ridge * (0.12f + 0.88f * valley) * ramp(0.02f, 0.45f, v) * 1.5f
        + 0.6f * lattice(column, row + 90);
}

static Vec ground(int column, int row)
{
    float y = height(column, row);

    return vec(((float)column / COLUMNS - 0.5f) * 150.0f + 1.6f * lattice(column, row),
               y < 0.0f ? 0.0f : y, 6.0f + (float)row * 4.2f);
}

/* Lambert's law, warm from the low sun, blue from the sky; haze far away. */
static Color light(Vec a, Vec b, Vec c)
{
    Vec normal = unit(cross(sub(b, a), sub(c, a)));
    float sun = clampf(dot(normal, unit(vec(0.62f, 0.42f, 0.30f))), 0.0f, 1.0f);
    float top = (a.y + b.y + c.y) / 3.0f, far = (a.z + b.z + c.z) / 3.0f;
    Color rock = mix_color(rgb(0.20f, 0.30f, 0.20f), rgb(0.36f, 0.25f, 0.30f), ramp(3.0f, 14.0f, top));
    Color shade, lake = rgb(0.42f, 0.30f, 0.46f);

    rock = mix_color(rock, rgb(0.96f, 0.93f, 0.98f), ramp(15.0f, 19.0f, top));
    shade = rgb(rock.r * (0.30f + 1.35f * sun), rock.g * (0.30f + 0.95f * sun),
                rock.b * (0.50f + 0.62f * sun));
    if (top < 0.02f) {
        shade = mix_color(lake, rgb(0.98f, 0.62f, 0.42f), ramp(30.0f, 120.0f, far));
    }
    return mix_color(shade, rgb(0.93f, 0.56f, 0.50f), 0.72f * ramp(40.0f, 150.0f, far));
}

static void draw_flat_triangle(const Camera *camera, Vec a, Vec b, Vec c)
{
    Color none = rgb(0, 0, 0);
    Corner corners[3];

    grConstantColorValue(pack_color(light(a, b, c)));
    corners[0] = corner(a, none, 0, 0);
    corners[1] = corner(b, none, 0, 0);
    corners[2] = corner(c, none, 0, 0);
    draw_in_space(camera, corners, 3);
}

static void draw_landscape(const Camera *camera)
{
    int row, column;

    for (row = ROWS - 2; row >= 0; row--) {
        for (column = 0; column < COLUMNS - 1; column++) {
            Vec a = ground(column, row), b = ground(column, row + 1);
            Vec c = ground(column + 1, row + 1), d = ground(column + 1, row);

            if ((row + column) & 1) {
                draw_flat_triangle(camera, a, b, c);
                draw_flat_triangle(camera, a, c, d);
            } else {
                draw_flat_triangle(camera, b, c, d);
                draw_flat_triangle(camera, a, b, d);
            }
        }
    }
}

/* The sky in flat bands and the sun as a fan of one colour. */
static void draw_sky(void)
{
    GrVertex rim[48];
    int i;

    for (i = 0; i < 24; i++) {
        float t = (float)i / 23.0f;
        Color c = mix_color(rgb(0.16f, 0.13f, 0.36f), rgb(0.86f, 0.36f, 0.46f), ramp(0.0f, 0.75f, t));
        c = mix_color(c, rgb(1.0f, 0.76f, 0.48f), ramp(0.55f, 1.0f, t));
        grConstantColorValue(pack_color(c));
        shade_rectangle(0, 10.0f * (float)i, 640, 10.0f * (float)(i + 1), c, c);
    }
    grConstantColorValue(0xfffff2c4);
    for (i = 0; i < 48; i++) {
        float angle = 2.0f * PI * (float)i / 48.0f;
        rim[i] = vertex(430.0f + 38.0f * cosine(angle), 150.0f + 38.0f * sine(angle), rgb(1, 1, 1));
    }
    grDrawPolygonVertexList(48, rim);
}

int main(int argc, char **argv)
{
    int frames = frames_wanted(argc, argv, 1), frame;

    open_screen(GR_ORIGIN_UPPER_LEFT);
    guColorCombineFunction(GR_COLORCOMBINE_CCRGB);
    for (frame = 0; frame < frames; frame++) {
        float sway = 0.05f * (float)frame;
        Camera camera = look_at(vec(sway, 15.0f, -7.0f), vec(-3.0f + sway, 6.0f, 60.0f), 420.0f);

        grBufferClear(0xff5b3f52, 0, 0);
        draw_sky();
        draw_landscape(&camera);
        grBufferSwap(1);
    }
    grGlideShutdown();
    return 0;
}
