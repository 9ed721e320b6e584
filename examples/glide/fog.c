/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * fog.c: a forest in the morning mist. Trees and snow carry their own colours
 * only; the fog table, looked up by distance at every pixel, does the rest.
 */
#include "common.h"

#define TREES 260
#define FOG_COLOR rgb(0.80f, 0.78f, 0.80f)

static float snow_height(float x, float z)
{
    return 1.6f * cloud(x / 160.0f + 0.5f, z / 160.0f, 4) + 0.6f * sine(0.05f * x) - 1.0f;
}

static void draw_snow(const Camera *camera)
{
    int row, column, k;

    for (row = 0; row < 40; row++) {
        for (column = 0; column < 40; column++) {
            static const int at[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
            Corner q[4];
            for (k = 0; k < 4; k++) {
                float x = ((float)(column + at[k][0]) - 20.0f) * 5.0f;
                float z = (float)(row + at[k][1]) * 4.0f;
                float slope = snow_height(x + 1.0f, z) - snow_height(x - 1.0f, z);
                Color c = mix_color(rgb(0.93f, 0.90f, 0.90f), rgb(0.50f, 0.57f, 0.74f),
                                    clampf(0.45f - 1.8f * slope, 0.0f, 1.0f));
                q[k] = corner(vec(x, snow_height(x, z), z), c, 0, 0);
            }
            draw_in_space(camera, q, 4);
        }
    }
}

/* One tier of a tree: a cone of eight sides, snow on the light side. */
static void draw_cone(const Camera *camera, Vec base, float radius, float rise, Color dark, Color light)
{
    int i;

    for (i = 0; i < 8; i++) {
        float p = 2.0f * PI * (float)i / 8.0f, q = 2.0f * PI * (float)(i + 1) / 8.0f;
        float sun = clampf(0.5f + 0.5f * sine(p + 0.8f), 0.0f, 1.0f);
        Color side = mix_color(dark, light, sun * sun);
        Corner c[3];
        c[0] = corner(add(base, vec(0.0f, rise, 0.0f)), mix_color(side, rgb(0.93f, 0.93f, 0.96f), 0.55f), 0, 0);
        c[1] = corner(add(base, vec(radius * cosine(p), 0.0f, radius * sine(p))), side, 0, 0);
        c[2] = corner(add(base, vec(radius * cosine(q), 0.0f, radius * sine(q))), side, 0, 0);
        draw_in_space(camera, c, 3);
    }
}

static void draw_tree(const Camera *camera, float x, float z, float size, float tint)
{
    Vec foot = vec(x, snow_height(x, z) - 0.1f, z);
    Color needle = mix_color(rgb(0.03f, 0.12f, 0.11f), rgb(0.07f, 0.18f, 0.10f), tint);
    Color lit = mix_color(rgb(0.16f, 0.40f, 0.30f), rgb(0.30f, 0.42f, 0.20f), tint);
    Color bark = rgb(0.20f, 0.12f, 0.08f);
    int tier;

    draw_cone(camera, foot, 0.16f * size, 1.2f * size, bark, bark);
    for (tier = 0; tier < 4; tier++) {
        draw_cone(camera, add(foot, vec(0.0f, size * (0.55f + 0.62f * (float)tier), 0.0f)),
                  size * (0.95f - 0.20f * (float)tier), size * 1.05f, needle, lit);
    }
}

static void draw_forest(const Camera *camera)
{
    FxU32 seed = 11;
    int i;

    for (i = 0; i < TREES; i++) {
        float z = 9.0f + 140.0f * random_unit(&seed);
        float x = (random_unit(&seed) - 0.5f) * (20.0f + 1.5f * z);
        float size = 1.5f + 1.4f * random_unit(&seed), tint = random_unit(&seed);
        if (fabsf(x - 4.0f * sine(0.05f * z)) > 3.6f) { /* keep the path clear */
            draw_tree(camera, x, z, size, tint);
        }
    }
}

static void draw_sky(void)
{
    Color sun = {1.0f, 0.93f, 0.78f, 0.95f}, none = {1.0f, 0.90f, 0.76f, 0.0f};

    shade_rectangle(0, 0, 640, 250, rgb(0.50f, 0.60f, 0.76f), FOG_COLOR);
    shade_rectangle(0, 250, 640, 480, FOG_COLOR, FOG_COLOR);
    use_blending();
    shade_ellipse(420, 120, 190, 190, sun, none);
    use_no_blending();
}

int main(int argc, char **argv)
{
    int frames = frames_wanted(argc, argv, 1), frame;
    GrFog_t table[GR_FOG_TABLE_SIZE];

    open_screen(GR_ORIGIN_UPPER_LEFT);
    use_vertex_colors();
    guFogGenerateExp2(table, 0.018f);
    grFogTable(table);
    grFogColorValue(pack_color(FOG_COLOR));
    for (frame = 0; frame < frames; frame++) {
        float ahead = 0.12f * (float)frame;
        Camera camera = look_at(vec(0.0f, 2.9f, -3.0f + ahead), vec(0.6f, 3.1f, 20.0f + ahead), 520.0f);

        use_w_buffer();
        grBufferClear(0xffffffff, 0, GR_WDEPTHVALUE_FARTHEST);
        use_no_depth_buffer();
        draw_sky();
        use_w_buffer();
        grFogMode(GR_FOG_WITH_TABLE);
        draw_snow(&camera);
        draw_forest(&camera);
        grFogMode(GR_FOG_DISABLE);
        grBufferSwap(1);
    }
    grGlideShutdown();
    return 0;
}
