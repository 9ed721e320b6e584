/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * points.c: a thousand points of light, as in the Programming Guide, and a
 * spiral galaxy of antialiased points added up in front of them.
 */
#include "common.h"

/* The guide's loop: constant white, coordinates from 0..1023, so that about
 * half of the points fall outside the clip window and are not drawn. */
static void draw_thousand_points(FxU32 *seed)
{
    GrVertex p = vertex(0.0f, 0.0f, rgb(1.0f, 1.0f, 1.0f));
    int n;

    grColorCombine(GR_COMBINE_FUNCTION_LOCAL, GR_COMBINE_FACTOR_NONE,
                   GR_COMBINE_LOCAL_CONSTANT, GR_COMBINE_OTHER_NONE, FXFALSE);
    for (n = 0; n < 1000; n++) {
        FxU32 grey = 70 + (FxU32)(185.0f * random_unit(seed) * random_unit(seed));
        grConstantColorValue(0xff000000U | grey << 16 | grey << 8 | (grey + 255) / 2);
        p.x = (float)(int)(random_unit(seed) * 1024.0f);
        p.y = (float)(int)(random_unit(seed) * 1024.0f);
        grDrawPoint(&p);
    }
}

/* Random in -1..1, most often near 0. */
static float bell(FxU32 *seed)
{
    return (random_unit(seed) + random_unit(seed) + random_unit(seed)) / 1.5f - 1.0f;
}

/* One star of the galaxy's plane: two arms wound around the centre. */
static void draw_star(FxU32 *seed, float turn_by)
{
    float spread = random_unit(seed), distance = spread * sqrtf(spread);
    float scatter = (random_unit(seed) + random_unit(seed) - 1.0f) * (1.1f - 0.7f * distance);
    float arm = random_unit(seed) < 0.5f ? 0.0f : PI;
    float angle = arm + 5.2f * distance + scatter + turn_by;
    float blur = 24.0f + 22.0f * distance; /* the core is a ball, the arms are soft */
    float x = 300.0f * distance * cosine(angle) + blur * bell(seed);
    float y = 300.0f * distance * sine(angle) + blur * bell(seed);
    float height = (26.0f - 18.0f * distance) * bell(seed);
    float glow = 0.22f + 0.50f * (1.0f - distance) * random_unit(seed);
    Color warm = rgb(1.0f, 0.78f, 0.46f), cool = rgb(0.42f, 0.6f, 1.0f);
    Color pink = rgb(1.0f, 0.36f, 0.62f);
    Color c = mix_color(warm, cool, ramp(0.05f, 0.6f, distance));
    GrVertex p;

    if (random_unit(seed) < 0.06f && distance > 0.2f) {
        c = pink;
        glow = 0.7f;
    }
    c.a = glow;
    /* The plane is tilted towards the viewer and turned a little. */
    p = vertex(320.0f + 0.94f * x + 0.20f * y, 240.0f - 0.26f * x + 0.40f * y - height, c);
    grAADrawPoint(&p);
}

/* A star with four rays. */
static void draw_bright_star(FxU32 *seed)
{
    float x = 640.0f * random_unit(seed), y = 480.0f * random_unit(seed);
    float size = 3.0f + 7.0f * random_unit(seed);
    Color c = mix_color(rgb(1.0f, 0.85f, 0.7f), rgb(0.7f, 0.82f, 1.0f), random_unit(seed));
    static const float way[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    GrVertex middle, tip;
    int i;

    middle = vertex(x, y, c);
    c.a = 0.0f;
    for (i = 0; i < 4; i++) {
        tip = vertex(x + size * way[i][0], y + size * way[i][1], c);
        grAADrawLine(&middle, &tip);
    }
    grAADrawPoint(&middle);
}

int main(int argc, char **argv)
{
    int frames = frames_wanted(argc, argv, 1), frame, i;

    open_screen(GR_ORIGIN_UPPER_LEFT);
    for (frame = 0; frame < frames; frame++) {
        FxU32 seed = 1997;

        grBufferClear(0xff020308, 0, 0);
        use_no_blending();
        draw_thousand_points(&seed);

        use_vertex_colors();
        use_added_light();
        for (i = 0; i < 20000; i++) {
            draw_star(&seed, 0.02f * (float)frame);
        }
        for (i = 0; i < 24; i++) {
            draw_bright_star(&seed);
        }
        grBufferSwap(1);
    }
    grGlideShutdown();
    return 0;
}
