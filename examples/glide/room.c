/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * room.c: a furnished hall seen from a camera that walks a circle, looking at
 * the middle. Textures are bilinear and mip mapped, lit at the vertices, depth
 * is in a w buffer, the far end lies in fog. The program clips against the
 * near plane itself; the sides are left to guDrawTriangleWithClip.
 */
#include "common.h"

#define HALF_X 14.0f
#define HALF_Z 14.0f
#define HEIGHT 8.0f

/* --- the textures ---------------------------------------------------------- */

static Color boards(float u, float v)
{
    int plank = (int)(u * 8.0f);
    float x = u * 8.0f - (float)plank, start = lattice(plank, 7);
    float along = v + start, seam = along - floorf(along);
    float grain = cloud(u * 6.0f + 0.31f * (float)plank, v * 0.5f + start, 16);
    float gap = ramp(0.00f, 0.05f, x) * ramp(0.00f, 0.05f, 1.0f - x) * ramp(0.0f, 0.008f, seam);
    Color wood = mix_color(rgb(0.52f, 0.33f, 0.18f), rgb(0.76f, 0.54f, 0.32f), grain);

    return scale_color(wood, (0.35f + 0.65f * gap) * (0.86f + 0.26f * lattice(plank, 3)));
}

static Color plaster(float u, float v)
{
    float tone = 0.86f + 0.16f * (cloud(u, v, 8) - 0.5f);
    float panel = fabsf(u * 2.0f - floorf(u * 2.0f) - 0.5f);
    Color wall = scale_color(rgb(0.84f, 0.80f, 0.70f), tone);
    Color wood = mix_color(rgb(0.20f, 0.38f, 0.34f), rgb(0.27f, 0.46f, 0.41f), cloud(u, v, 16));

    if (v > 0.62f) { /* panelling below */
        float frame = ramp(0.36f, 0.38f, panel) + ramp(0.69f, 0.67f, v) + ramp(0.93f, 0.95f, v);
        wood = scale_color(wood, 0.82f + 0.30f * clampf(frame, 0.0f, 1.0f));
        return v < 0.64f ? scale_color(wood, 1.5f) : v > 0.97f ? scale_color(wood, 0.6f) : wood;
    }
    return v < 0.05f ? scale_color(wall, 0.80f) : wall;
}

static Color ceiling(float u, float v)
{
    float x = fabsf(u * 4.0f - floorf(u * 4.0f) - 0.5f), y = fabsf(v * 4.0f - floorf(v * 4.0f) - 0.5f);
    float edge = x > y ? x : y;
    Color beam = mix_color(rgb(0.36f, 0.24f, 0.15f), rgb(0.46f, 0.32f, 0.20f), cloud(u, v, 16));
    return mix_color(rgb(0.72f, 0.68f, 0.60f), beam, ramp(0.36f, 0.40f, edge));
}

static Color crate(float u, float v)
{
    float x = fabsf(u - 0.5f), y = fabsf(v - 0.5f), edge = x > y ? x : y;
    float brace = fabsf(u - v), slat = v * 6.0f - floorf(v * 6.0f);
    Color wood = mix_color(rgb(0.58f, 0.40f, 0.20f), rgb(0.84f, 0.64f, 0.36f), cloud(u * 0.5f, v * 4.0f, 8));
    float depth = 0.62f * (0.6f + 0.4f * ramp(0.0f, 0.10f, slat));

    if (edge > 0.39f || brace < 0.085f) {
        depth = 1.0f;
    }
    if (fabsf(edge - 0.39f) < 0.012f || (edge < 0.39f && fabsf(brace - 0.09f) < 0.012f)) {
        depth = 0.40f;
    }
    return scale_color(wood, depth);
}

static Color carpet(float u, float v)
{
    float x = fabsf(u - 0.5f), y = fabsf(v - 0.5f), edge = x > y ? x : y, sum = x + y;
    float weave = 0.85f + 0.30f * lattice((int)(u * 128.0f), (int)(v * 128.0f));
    float wave = sine(40.0f * PI * sum) > 0.0f ? 1.0f : 0.0f;
    Color c = rgb(0.72f, 0.13f, 0.15f);

    if (edge > 0.47f) {
        c = rgb(0.86f, 0.70f, 0.38f);
    } else if (edge > 0.40f) {
        c = sine(64.0f * PI * (x + y)) > 0.0f ? rgb(0.12f, 0.16f, 0.34f) : rgb(0.80f, 0.62f, 0.30f);
    } else if (sum < 0.30f) {
        c = mix_color(rgb(0.12f, 0.18f, 0.38f), rgb(0.84f, 0.68f, 0.40f), wave * 0.8f);
    } else if (edge > 0.38f) {
        c = rgb(0.10f, 0.08f, 0.10f);
    }
    return scale_color(c, weave);
}

static Color marble(float u, float v)
{
    float vein = fabsf(sine(2.0f * PI * (u + v) + 8.0f * cloud(u, v, 4)));
    return mix_color(rgb(0.46f, 0.52f, 0.55f), rgb(0.93f, 0.93f, 0.90f), ramp(0.0f, 0.35f, vein));
}

/* --- light ------------------------------------------------------------------ */

static const float LAMPS[3][6] = { /* position, colour */
    {-7.0f, 6.6f, 6.0f, 1.00f, 0.80f, 0.52f},
    {8.0f, 6.6f, 7.0f, 1.00f, 0.76f, 0.48f},
    {0.0f, 7.0f, -8.0f, 0.66f, 0.80f, 1.00f}
};

static Color light_at(Vec p, Vec normal)
{
    Color sum = rgb(0.30f, 0.29f, 0.32f);
    int i;

    for (i = 0; i < 3; i++) {
        Vec to = sub(vec(LAMPS[i][0], LAMPS[i][1], LAMPS[i][2]), p);
        float square = dot(to, to), facing = clampf(dot(unit(to), normal), 0.0f, 1.0f);
        float strength = (0.25f + 0.75f * facing) * 48.0f / (18.0f + square);
        sum.r += strength * LAMPS[i][3];
        sum.g += strength * LAMPS[i][4];
        sum.b += strength * LAMPS[i][5];
    }
    return rgb(clampf(sum.r, 0.0f, 1.0f), clampf(sum.g, 0.0f, 1.0f), clampf(sum.b, 0.0f, 1.0f));
}

/* --- geometry --------------------------------------------------------------- */

/* A rectangle from `origin` along `u` and `v`, cut into cells so that the
 * light at the corners is smooth; `repeat_u`, `repeat_v` count textures. */
static void draw_wall(const Camera *camera, Vec origin, Vec u, Vec v, int cells,
                      float repeat_u, float repeat_v)
{
    static const int at[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    Vec normal = unit(cross(v, u));
    int i, j, k;

    for (j = 0; j < cells; j++) {
        for (i = 0; i < cells; i++) {
            Corner q[4];
            for (k = 0; k < 4; k++) {
                float a = (float)(i + at[k][0]) / (float)cells, b = (float)(j + at[k][1]) / (float)cells;
                Vec p = add(origin, add(scale(u, a), scale(v, b)));
                q[k] = corner(p, light_at(p, normal), 256.0f * repeat_u * a, 256.0f * repeat_v * b);
            }
            draw_in_space(camera, q, 4);
        }
    }
}

/* An upright box turned by `angle`; top and four sides. */
static void draw_box(const Camera *camera, Vec center, Vec half, float angle, float repeat)
{
    Vec x = scale(turn(vec(1, 0, 0), 0.0f, angle), half.x);
    Vec z = scale(turn(vec(0, 0, 1), 0.0f, angle), half.z);
    Vec y = vec(0.0f, half.y, 0.0f);
    Vec sides[4][2];
    int i;

    sides[0][0] = x;
    sides[0][1] = scale(z, -1.0f);
    sides[1][0] = z;
    sides[1][1] = x;
    sides[2][0] = scale(x, -1.0f);
    sides[2][1] = z;
    sides[3][0] = scale(z, -1.0f);
    sides[3][1] = scale(x, -1.0f);
    for (i = 0; i < 4; i++) {
        Vec along = sides[i][0], out = sides[i][1];
        draw_wall(camera, add(center, add(sub(out, along), y)), scale(along, 2.0f),
                  scale(y, -2.0f), 2, 1.0f, repeat);
    }
    draw_wall(camera, add(center, add(y, sub(z, x))), scale(x, 2.0f), scale(z, -2.0f), 2, 1.0f, 1.0f);
}

static void draw_pillar(const Camera *camera, float x, float z)
{
    int i;

    for (i = 0; i < 12; i++) {
        float p = 2.0f * PI * (float)i / 12.0f, q = 2.0f * PI * (float)(i + 1) / 12.0f;
        Vec a = vec(x + 0.7f * cosine(p), HEIGHT, z + 0.7f * sine(p));
        Vec b = vec(x + 0.7f * cosine(q), HEIGHT, z + 0.7f * sine(q));
        Vec down = vec(0.0f, -HEIGHT, 0.0f);
        Corner c[4];
        Vec out = vec(cosine(p), 0.0f, sine(p)), next = vec(cosine(q), 0.0f, sine(q));
        c[0] = corner(a, light_at(a, out), 64.0f * (float)i, 0.0f);
        c[1] = corner(b, light_at(b, next), 64.0f * (float)(i + 1), 0.0f);
        b = add(b, down);
        a = add(a, down);
        c[2] = corner(b, light_at(b, next), 64.0f * (float)(i + 1), 768.0f);
        c[3] = corner(a, light_at(a, out), 64.0f * (float)i, 768.0f);
        draw_in_space(camera, c, 4);
    }
}

typedef struct {
    Texture boards, plaster, ceiling, crate, carpet, marble;
} Textures;

static void draw_shell(const Camera *camera, Textures *t)
{
    float w = 2.0f * HALF_X, d = 2.0f * HALF_Z;

    use_texture(GR_TMU0, &t->boards);
    draw_wall(camera, vec(-HALF_X, 0.0f, HALF_Z), vec(w, 0, 0), vec(0, 0, -d), 8, 4.0f, 4.0f);
    use_texture(GR_TMU0, &t->ceiling);
    draw_wall(camera, vec(-HALF_X, HEIGHT, -HALF_Z), vec(w, 0, 0), vec(0, 0, d), 8, 2.0f, 2.0f);
    use_texture(GR_TMU0, &t->plaster);
    draw_wall(camera, vec(-HALF_X, HEIGHT, HALF_Z), vec(w, 0, 0), vec(0, -HEIGHT, 0), 8, 4.0f, 1.0f);
    draw_wall(camera, vec(HALF_X, HEIGHT, -HALF_Z), vec(-w, 0, 0), vec(0, -HEIGHT, 0), 8, 4.0f, 1.0f);
    draw_wall(camera, vec(HALF_X, HEIGHT, HALF_Z), vec(0, 0, -d), vec(0, -HEIGHT, 0), 8, 4.0f, 1.0f);
    draw_wall(camera, vec(-HALF_X, HEIGHT, -HALF_Z), vec(0, 0, d), vec(0, -HEIGHT, 0), 8, 4.0f, 1.0f);
}

static void draw_furniture(const Camera *camera, Textures *t)
{
    static const float crates[6][5] = { /* x, y, z, half side, angle */
        {-6.6f, 1.3f, 5.6f, 1.3f, 0.30f}, {-8.9f, 0.9f, 3.6f, 0.9f, 1.10f}, {-6.9f, 3.3f, 5.8f, 0.7f, 0.75f},
        {7.2f, 1.5f, 6.4f, 1.5f, -0.35f}, {4.7f, 0.8f, 7.6f, 0.8f, 0.20f}, {6.4f, 0.7f, -7.4f, 0.7f, 0.9f}
    };
    int i;

    use_texture(GR_TMU0, &t->carpet);
    draw_wall(camera, vec(-4.5f, 0.04f, 4.5f), vec(9, 0, 0), vec(0, 0, -9), 4, 1.0f, 1.0f);
    use_texture(GR_TMU0, &t->crate);
    for (i = 0; i < 6; i++) {
        const float *c = crates[i];
        draw_box(camera, vec(c[0], c[1], c[2]), vec(c[3], c[3], c[3]), c[4], 1.0f);
    }
    use_texture(GR_TMU0, &t->marble);
    draw_box(camera, vec(0.0f, 0.5f, 0.0f), vec(1.5f, 0.5f, 1.5f), 0.6f, 0.5f);
    draw_box(camera, vec(0.0f, 2.2f, 0.0f), vec(0.7f, 1.2f, 0.7f), 1.4f, 1.5f);
    for (i = 0; i < 8; i++) {
        draw_pillar(camera, i & 1 ? 10.5f : -10.5f, -10.5f + 7.0f * (float)(i / 2));
    }
}

int main(int argc, char **argv)
{
    int frames = frames_wanted(argc, argv, 60), frame;
    GrFog_t table[GR_FOG_TABLE_SIZE];
    Textures t;

    open_screen(GR_ORIGIN_UPPER_LEFT);
    t.boards = load_texture(GR_TMU0, boards, GR_TEXFMT_RGB_565, GR_LOD_256);
    t.plaster = load_texture(GR_TMU0, plaster, GR_TEXFMT_RGB_565, GR_LOD_256);
    t.ceiling = load_texture(GR_TMU0, ceiling, GR_TEXFMT_RGB_565, GR_LOD_128);
    t.crate = load_texture(GR_TMU0, crate, GR_TEXFMT_RGB_565, GR_LOD_256);
    t.carpet = load_texture(GR_TMU0, carpet, GR_TEXFMT_RGB_565, GR_LOD_256);
    t.marble = load_texture(GR_TMU0, marble, GR_TEXFMT_RGB_565, GR_LOD_128);

    guColorCombineFunction(GR_COLORCOMBINE_TEXTURE_TIMES_ITRGB);
    use_w_buffer();
    grCullMode(GR_CULL_NEGATIVE);
    guFogGenerateExp2(table, 0.020f);
    grFogTable(table);
    grFogColorValue(0xff8c8f98);
    grFogMode(GR_FOG_WITH_TABLE);
    for (frame = 0; frame < frames; frame++) {
        float angle = -0.5f + 2.0f * PI * (float)frame / 60.0f;
        Camera camera = look_at(vec(8.6f * sine(angle), 3.6f + 0.6f * sine(2.0f * angle), -8.6f * cosine(angle)),
                                vec(0.6f * sine(angle), 2.5f, 0.0f), 400.0f);

        grBufferClear(0xff8c8f98, 0, GR_WDEPTHVALUE_FARTHEST);
        draw_shell(&camera, &t);
        draw_furniture(&camera, &t);
        grBufferSwap(1);
    }
    grGlideShutdown();
    return 0;
}
