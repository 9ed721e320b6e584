/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * multitexture.c: a vault of bricks, lit by a light map. With two texture
 * units the map in the second multiplies the bricks of the first in one pass;
 * with one unit the light is multiplied in with a second pass of blending.
 */
#include "common.h"

#define SEGMENTS 10 /* flat pieces of the arch */
#define BAYS     14

static Color bricks(float u, float v)
{
    int row = (int)(v * 16.0f);
    float shift = row & 1 ? 0.5f : 0.0f;
    float x = u * 8.0f + shift, y = v * 16.0f - (float)row;
    int column = (int)x;
    float fx = x - (float)column, grain = cloud(u, v, 16);
    float edge = fx < 0.5f ? fx * 2.0f : (1.0f - fx) * 2.0f, rim = y < 0.5f ? y : 1.0f - y;
    float joint = ramp(0.06f, 0.14f, edge) * ramp(0.06f, 0.14f, rim);
    Color clay = mix_color(rgb(0.95f, 0.60f, 0.42f), rgb(0.76f, 0.42f, 0.30f), lattice(column & 7, row));

    clay = scale_color(clay, 0.78f + 0.5f * grain);
    return mix_color(scale_color(rgb(0.66f, 0.62f, 0.56f), 0.6f + 0.5f * grain), clay, joint);
}

static Color flags(float u, float v)
{
    float x = u * 4.0f, y = v * 4.0f, fx = x - floorf(x), fy = y - floorf(y);
    float joint = ramp(0.02f, 0.06f, fx) * ramp(0.02f, 0.06f, 1.0f - fx)
        * ramp(0.02f, 0.06f, fy) * ramp(0.02f, 0.06f, 1.0f - fy);
    float tone = 0.45f + 0.22f * lattice((int)x, (int)y + 40) + 0.30f * (cloud(u, v, 8) - 0.5f);
    return mix_color(rgb(0.16f, 0.15f, 0.15f), rgb(tone, tone * 0.97f, tone * 0.90f), joint);
}

/* Light falls off around (x, y), repeating with the map. */
static float glow(float u, float v, float x, float y, float reach)
{
    float dx = fabsf(u - x), dy = fabsf(v - y);
    dx = dx > 0.5f ? 1.0f - dx : dx;
    dy = dy > 0.5f ? 1.0f - dy : dy;
    return reach / (reach + dx * dx + dy * dy);
}

/* u runs along the vault, one map per bay; v from one wall's foot over the
 * arch to the other's. Torches hang on both walls. */
static Color wall_light(float u, float v)
{
    float torch = glow(u, v, 0.5f, 0.20f, 0.030f), other = glow(u, v, 0.0f, 0.80f, 0.024f);
    float rib = 1.0f - 0.35f * ramp(0.42f, 0.50f, fabsf(u - 0.5f));

    return rgb(rib * (0.10f + 1.10f * torch + 0.24f * other), rib * (0.09f + 0.76f * torch + 0.52f * other),
               rib * (0.15f + 0.40f * torch + 0.95f * other));
}

static Color floor_light(float u, float v)
{
    float warm = glow(u, v, 0.5f, 0.0f, 0.16f) * ramp(0.9f, 0.0f, v);
    float cool = glow(u, v, 0.0f, 1.0f, 0.13f) * ramp(0.1f, 1.0f, v);

    return rgb(0.12f + 1.00f * warm + 0.16f * cool, 0.12f + 0.70f * warm + 0.44f * cool,
               0.18f + 0.34f * warm + 0.92f * cool);
}

typedef struct {
    Texture surface, light;
    int units;
} Material;

/* A board with one unit keeps the light map next to the bricks. */
static Material load_material(Pattern surface, Pattern light, int units)
{
    Material m;

    m.units = units;
    m.surface = load_texture(GR_TMU0, surface, GR_TEXFMT_RGB_565, GR_LOD_256);
    m.light = load_texture(units > 1 ? GR_TMU1 : GR_TMU0, light, GR_TEXFMT_RGB_565, GR_LOD_64);
    return m;
}

static void draw_fan(const GrVertex *v, int n)
{
    int i;

    for (i = 2; i < n; i++) {
        guDrawTriangleWithClip(&v[0], &v[i - 1], &v[i]);
    }
}

/* The light map's coordinates are carried in each corner's colour, r and g. */
static void draw_lit(const Camera *camera, const Material *m, const Corner *corners)
{
    Corner view[8], clipped[8];
    GrVertex screen[8];
    Texture surface = m->surface, light = m->light;
    int i, n;

    for (i = 0; i < 4; i++) {
        view[i] = corners[i];
        view[i].position = to_view(camera, corners[i].position);
    }
    n = clip_near(view, 4, clipped);
    for (i = 0; i < n; i++) {
        screen[i] = project_view(camera, &clipped[i]);
        screen[i].tmuvtx[1].sow = 256.0f * clipped[i].color.r * screen[i].oow;
        screen[i].tmuvtx[1].tow = 256.0f * clipped[i].color.g * screen[i].oow;
    }
    use_texture(GR_TMU0, &surface);
    if (m->units > 1) {
        use_texture(GR_TMU1, &light);
        grTexCombineFunction(GR_TMU0, GR_TEXTURECOMBINE_MULTIPLY);
        draw_fan(screen, n);
        return;
    }
    draw_fan(screen, n);
    for (i = 0; i < n; i++) {
        screen[i].tmuvtx[0] = screen[i].tmuvtx[1];
    }
    use_texture(GR_TMU0, &light);
    grAlphaBlendFunction(GR_BLEND_DST_COLOR, GR_BLEND_ZERO, GR_BLEND_ONE, GR_BLEND_ZERO);
    draw_fan(screen, n);
    use_no_blending();
}

/* Profile of the vault at v = 0..1: walls 3.2 high, then a half circle. */
static Vec profile(int i)
{
    float a;

    if (i == 0) {
        return vec(-4.0f, 0.0f, 0.0f);
    }
    if (i == SEGMENTS + 2) {
        return vec(4.0f, 0.0f, 0.0f);
    }
    a = PI * (float)(i - 1) / SEGMENTS;
    return vec(-4.0f * cosine(a), 3.2f + 4.0f * sine(a), 0.0f);
}

/* Share of the way around the profile, 0..1. */
static float around(int i)
{
    const float length = 2.0f * 3.2f + PI * 4.0f;
    float arc = PI * 4.0f / SEGMENTS;

    return i == 0 ? 0.0f : i == SEGMENTS + 2 ? 1.0f : (3.2f + arc * (float)(i - 1)) / length;
}

static void draw_bay(const Camera *camera, int bay, const Material *wall, const Material *ground)
{
    float z0 = 7.0f * (float)bay, z1 = z0 + 7.0f;
    Corner q[4];
    int i;

    for (i = 0; i < SEGMENTS + 2; i++) {
        Vec p = profile(i), r = profile(i + 1);
        float v = around(i), w = around(i + 1);
        q[0] = corner(vec(p.x, p.y, z0), rgb(0.0f, v, 0.0f), 0.0f, 900.0f * v);
        q[1] = corner(vec(p.x, p.y, z1), rgb(1.0f, v, 0.0f), 340.0f, 900.0f * v);
        q[2] = corner(vec(r.x, r.y, z1), rgb(1.0f, w, 0.0f), 340.0f, 900.0f * w);
        q[3] = corner(vec(r.x, r.y, z0), rgb(0.0f, w, 0.0f), 0.0f, 900.0f * w);
        draw_lit(camera, wall, q);
    }
    q[0] = corner(vec(-4.0f, 0.0f, z0), rgb(0.0f, 0.0f, 0.0f), 0.0f, 0.0f);
    q[1] = corner(vec(-4.0f, 0.0f, z1), rgb(1.0f, 0.0f, 0.0f), 448.0f, 0.0f);
    q[2] = corner(vec(4.0f, 0.0f, z1), rgb(1.0f, 1.0f, 0.0f), 448.0f, 512.0f);
    q[3] = corner(vec(4.0f, 0.0f, z0), rgb(0.0f, 1.0f, 0.0f), 0.0f, 512.0f);
    draw_lit(camera, ground, q);
}

int main(int argc, char **argv)
{
    int frames = frames_wanted(argc, argv, 1), frame, bay, units;
    Material wall, ground;

    units = open_screen(GR_ORIGIN_UPPER_LEFT);
    wall = load_material(bricks, wall_light, units);
    ground = load_material(flags, floor_light, units);
    guColorCombineFunction(GR_COLORCOMBINE_DECAL_TEXTURE);
    grHints(GR_HINT_STWHINT, GR_STWHINT_ST_DIFF_TMU1);
    for (frame = 0; frame < frames; frame++) {
        float ahead = 0.06f * (float)frame;
        Camera camera = look_at(vec(-1.1f, 2.5f, 0.4f + ahead), vec(0.7f, 3.0f, 12.0f + ahead), 400.0f);

        grBufferClear(0xff06070c, 0, 0);
        for (bay = BAYS - 1; bay >= 0; bay--) {
            draw_bay(&camera, bay, &wall, &ground);
        }
        grBufferSwap(1);
    }
    grGlideShutdown();
    return 0;
}
