/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * common.h: what the example programs share: the command line, opening the
 * board, a little vector arithmetic, a camera, and generated textures.
 *
 * Everything is inline, so that each program still builds from one file:
 *     cc -Iinclude examples/glide/points.c -lglide2x -lm
 *
 * Sines, noise and random numbers are computed here with plain arithmetic,
 * so that a program draws the same picture with every C library.
 */
#ifndef EXAMPLES_COMMON_H
#define EXAMPLES_COMMON_H

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <glide.h>

#define SCREEN_WIDTH  640
#define SCREEN_HEIGHT 480
#define PI 3.14159265358979f

/* --- command line and board ------------------------------------------- */

/* Frames to draw: the number after -n, or `otherwise`. */
static inline int frames_wanted(int argc, char **argv, int otherwise)
{
    if (argc == 1) {
        return otherwise;
    }
    if (argc == 3 && strcmp(argv[1], "-n") == 0 && atoi(argv[2]) > 0) {
        return atoi(argv[2]);
    }
    fprintf(stderr, "usage: %s [-n FRAMES]\n", argv[0]);
    exit(2);
}

/* Opens the first board at 640x480 with a depth buffer; packed colours are
 * 0xAARRGGBB. Returns the number of texture units. */
static inline int open_screen(GrOriginLocation_t origin)
{
    GrHwConfiguration hardware;

    grGlideInit();
    if (!grSstQueryHardware(&hardware)) {
        fprintf(stderr, "no board found\n");
        exit(1);
    }
    grSstSelect(0);
    if (!grSstWinOpen(0, GR_RESOLUTION_640x480, GR_REFRESH_60Hz,
                      GR_COLORFORMAT_ARGB, origin, 2, 1)) {
        fprintf(stderr, "cannot open the board at 640x480\n");
        exit(1);
    }
    return hardware.SSTs[0].sstBoard.VoodooConfig.nTexelfx;
}

/* --- numbers ----------------------------------------------------------- */

/* Sine of an angle in radians, good to single precision. */
static inline float sine(float angle)
{
    double turns = (double)angle / 6.283185307179586;
    double x, square;

    turns -= floor(turns);                       /* 0..1 */
    x = turns < 0.5 ? turns - 0.25 : 0.75 - turns; /* -1/4..1/4, shifted */
    x = x * 6.283185307179586;
    square = x * x;
    /* Shifted by a quarter turn, the sine is the even cosine series. */
    x = 1.0 - square / 2.0 * (1.0 - square / 12.0 * (1.0 - square / 30.0
        * (1.0 - square / 56.0 * (1.0 - square / 90.0 * (1.0 - square / 132.0)))));
    return (float)(turns < 0.5 ? x : -x);
}

static inline float cosine(float angle)
{
    return sine(angle + PI / 2.0f);
}

static inline float clampf(float value, float low, float high)
{
    return value < low ? low : value > high ? high : value;
}

static inline float mixf(float a, float b, float t)
{
    return a + (b - a) * t;
}

/* 0 below `low`, 1 above `high`, a smooth step between. */
static inline float ramp(float low, float high, float x)
{
    float t = clampf((x - low) / (high - low), 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

/* Next of a fixed sequence of numbers in 0..1. */
static inline float random_unit(FxU32 *seed)
{
    *seed = *seed * 1664525U + 1013904223U;
    return (float)(*seed >> 8) / 16777216.0f;
}

/* A fixed random number in 0..1 for each pair of whole numbers. */
static inline float lattice(int x, int y)
{
    FxU32 h = (FxU32)x * 0x9e3779b1U ^ (FxU32)y * 0x85ebca77U;
    h = (h ^ (h >> 15)) * 0x2c1b3c6dU;
    h = (h ^ (h >> 12)) * 0x297a2d39U;
    return (float)((h ^ (h >> 15)) >> 8) / 16777216.0f;
}

/* Smooth noise in 0..1 over the unit square, `cells` to a side, which
 * repeats without a seam. */
static inline float noise(float u, float v, int cells)
{
    float x = u * (float)cells, y = v * (float)cells;
    int ix = (int)floorf(x), iy = (int)floorf(y);
    float fx = x - (float)ix, fy = y - (float)iy;
    int x0 = ((ix % cells) + cells) % cells, y0 = ((iy % cells) + cells) % cells;
    int x1 = (x0 + 1) % cells, y1 = (y0 + 1) % cells;

    fx = fx * fx * (3.0f - 2.0f * fx);
    fy = fy * fy * (3.0f - 2.0f * fy);
    return mixf(mixf(lattice(x0, y0), lattice(x1, y0), fx),
                mixf(lattice(x0, y1), lattice(x1, y1), fx), fy);
}

/* Four octaves of noise, 0..1. */
static inline float cloud(float u, float v, int cells)
{
    return (noise(u, v, cells) * 8.0f + noise(u, v, cells * 2) * 4.0f
            + noise(u, v, cells * 4) * 2.0f + noise(u, v, cells * 8)) / 15.0f;
}

/* --- colours, parts in 0..1 -------------------------------------------- */

typedef struct {
    float r, g, b, a;
} Color;

static inline Color rgb(float r, float g, float b)
{
    Color c = {r, g, b, 1.0f};
    return c;
}

static inline Color mix_color(Color a, Color b, float t)
{
    Color c = {mixf(a.r, b.r, t), mixf(a.g, b.g, t), mixf(a.b, b.b, t), mixf(a.a, b.a, t)};
    return c;
}

static inline Color scale_color(Color c, float by)
{
    Color out = {c.r * by, c.g * by, c.b * by, c.a};
    return out;
}

/* A colour of the rainbow; hue 0..1 goes once round. */
static inline Color hue(float h)
{
    Color c = {0.5f + 0.5f * sine(2.0f * PI * (h + 0.25f)),
               0.5f + 0.5f * sine(2.0f * PI * (h - 0.0833f)),
               0.5f + 0.5f * sine(2.0f * PI * (h - 0.4167f)), 1.0f};
    return c;
}

static inline FxU32 to_byte(float part)
{
    return (FxU32)(clampf(part, 0.0f, 1.0f) * 255.0f + 0.5f);
}

static inline GrColor_t pack_color(Color c)
{
    return to_byte(c.a) << 24 | to_byte(c.r) << 16 | to_byte(c.g) << 8 | to_byte(c.b);
}

/* --- vertices on the screen --------------------------------------------- */

static inline void set_color(GrVertex *v, Color c)
{
    v->r = clampf(c.r, 0.0f, 1.0f) * 255.0f;
    v->g = clampf(c.g, 0.0f, 1.0f) * 255.0f;
    v->b = clampf(c.b, 0.0f, 1.0f) * 255.0f;
    v->a = clampf(c.a, 0.0f, 1.0f) * 255.0f;
}

/* To the nearest sixteenth of a pixel. The board keeps no more of x and y, but
 * computes gradients from what it is given: snapped beforehand the two agree,
 * edges shared by triangles stay shut, and colours do not overshoot. */
static inline float snap(float coordinate)
{
    return floorf(coordinate * 16.0f + 0.5f) * 0.0625f;
}

static inline GrVertex vertex(float x, float y, Color c)
{
    GrVertex v;

    memset(&v, 0, sizeof v);
    v.x = snap(x);
    v.y = snap(y);
    v.oow = 1.0f;
    set_color(&v, c);
    return v;
}

/* Texture coordinates in 0..256 for both texture units. */
static inline void set_texture(GrVertex *v, float s, float t)
{
    v->tmuvtx[0].sow = v->tmuvtx[1].sow = s * v->oow;
    v->tmuvtx[0].tow = v->tmuvtx[1].tow = t * v->oow;
}

static inline void draw_quad(const GrVertex *a, const GrVertex *b,
                             const GrVertex *c, const GrVertex *d)
{
    grDrawTriangle(a, b, c);
    grDrawTriangle(a, c, d);
}

/* A rectangle whose colour runs from `top` to `bottom`. */
static inline void shade_rectangle(float x0, float y0, float x1, float y1,
                                   Color top, Color bottom)
{
    GrVertex a = vertex(x0, y0, top), b = vertex(x1, y0, top);
    GrVertex c = vertex(x1, y1, bottom), d = vertex(x0, y1, bottom);

    draw_quad(&a, &b, &c, &d);
}

/* An ellipse of 64 triangles whose colour runs from the middle to the rim. */
static inline void shade_ellipse(float x, float y, float rx, float ry, Color middle, Color rim)
{
    GrVertex center = vertex(x, y, middle), a, b = vertex(x + rx, y, rim);
    int i;

    for (i = 1; i <= 64; i++) {
        float angle = 2.0f * PI * (float)i / 64.0f;
        a = b;
        b = vertex(x + rx * cosine(angle), y + ry * sine(angle), rim);
        grDrawTriangle(&center, &a, &b);
    }
}

/* Draw with the colours of the vertices, alpha included. */
static inline void use_vertex_colors(void)
{
    guColorCombineFunction(GR_COLORCOMBINE_ITRGB);
    guAlphaSource(GR_ALPHASOURCE_ITERATED_ALPHA);
}

static inline void use_blending(void)
{
    grAlphaBlendFunction(GR_BLEND_SRC_ALPHA, GR_BLEND_ONE_MINUS_SRC_ALPHA,
                         GR_BLEND_ONE, GR_BLEND_ZERO);
}

static inline void use_no_blending(void)
{
    grAlphaBlendFunction(GR_BLEND_ONE, GR_BLEND_ZERO, GR_BLEND_ONE, GR_BLEND_ZERO);
}

static inline void use_added_light(void)
{
    grAlphaBlendFunction(GR_BLEND_SRC_ALPHA, GR_BLEND_ONE, GR_BLEND_ONE, GR_BLEND_ZERO);
}

/* Depth tests on z: the nearer pixel, with the greater value, wins. */
static inline void use_z_buffer(void)
{
    grDepthBufferMode(GR_DEPTHBUFFER_ZBUFFER);
    grDepthBufferFunction(GR_CMP_GREATER);
    grDepthMask(FXTRUE);
}

/* Depth tests on w: the nearer pixel, with the smaller value, wins. */
static inline void use_w_buffer(void)
{
    grDepthBufferMode(GR_DEPTHBUFFER_WBUFFER);
    grDepthBufferFunction(GR_CMP_LESS);
    grDepthMask(FXTRUE);
}

static inline void use_no_depth_buffer(void)
{
    grDepthMask(FXFALSE);
    grDepthBufferMode(GR_DEPTHBUFFER_DISABLE);
}

/* --- space: x right, y up, z away from the viewer ----------------------- */

typedef struct {
    float x, y, z;
} Vec;

static inline Vec vec(float x, float y, float z)
{
    Vec v = {x, y, z};
    return v;
}

static inline Vec add(Vec a, Vec b)
{
    return vec(a.x + b.x, a.y + b.y, a.z + b.z);
}

static inline Vec sub(Vec a, Vec b)
{
    return vec(a.x - b.x, a.y - b.y, a.z - b.z);
}

static inline Vec scale(Vec a, float by)
{
    return vec(a.x * by, a.y * by, a.z * by);
}

static inline float dot(Vec a, Vec b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline Vec cross(Vec a, Vec b)
{
    return vec(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

static inline Vec unit(Vec a)
{
    float length = sqrtf(dot(a, a));
    return length > 0.0f ? scale(a, 1.0f / length) : a;
}

/* Turns by `ax` about the x axis, then by `ay` about the y axis. */
static inline Vec turn(Vec v, float ax, float ay)
{
    float cx = cosine(ax), sx = sine(ax), cy = cosine(ay), sy = sine(ay);
    Vec a = vec(v.x, v.y * cx - v.z * sx, v.y * sx + v.z * cx);

    return vec(a.x * cy + a.z * sy, a.y, a.z * cy - a.x * sy);
}

/* --- camera -------------------------------------------------------------- */

typedef struct {
    Vec eye, right, up, forward;
    float focal;             /* pixels per unit at distance 1 */
    float center_x, center_y;
} Camera;

static inline Camera look_at(Vec eye, Vec target, float focal)
{
    Camera c;

    c.eye = eye;
    c.forward = unit(sub(target, eye));
    c.right = unit(cross(vec(0.0f, 1.0f, 0.0f), c.forward));
    c.up = cross(c.forward, c.right);
    c.focal = focal;
    c.center_x = SCREEN_WIDTH / 2.0f;
    c.center_y = SCREEN_HEIGHT / 2.0f;
    return c;
}

/* A corner of a polygon in space; s and t as in the texture, 0..256. */
typedef struct {
    Vec position;
    Color color;
    float s, t;
} Corner;

static inline Corner corner(Vec position, Color color, float s, float t)
{
    Corner c;

    c.position = position;
    c.color = color;
    c.s = s;
    c.t = t;
    return c;
}

/* Position as the camera sees it; z is the distance w along its axis. */
static inline Vec to_view(const Camera *camera, Vec p)
{
    Vec d = sub(p, camera->eye);
    return vec(dot(d, camera->right), dot(d, camera->up), dot(d, camera->forward));
}

/* From view space (z at least 1) to the screen. The z buffer's value falls
 * from 65535 at distance 1 towards 0. */
static inline GrVertex project_view(const Camera *camera, const Corner *corner_in_view)
{
    Vec p = corner_in_view->position;
    float oow = 1.0f / p.z;
    GrVertex v = vertex(camera->center_x + camera->focal * p.x * oow,
                        camera->center_y - camera->focal * p.y * oow,
                        corner_in_view->color);

    v.oow = oow;
    v.ooz = 65535.0f * oow;
    set_texture(&v, corner_in_view->s, corner_in_view->t);
    return v;
}

static inline GrVertex project(const Camera *camera, Corner c)
{
    c.position = to_view(camera, c.position);
    return project_view(camera, &c);
}

#define NEAR_PLANE  1.0f
#define MAX_CORNERS 12

static inline Corner mix_corner(const Corner *a, const Corner *b, float t)
{
    return corner(add(a->position, scale(sub(b->position, a->position), t)),
                  mix_color(a->color, b->color, t),
                  mixf(a->s, b->s, t), mixf(a->t, b->t, t));
}

/* Cuts off what is nearer than the near plane. Returns the corners left. */
static inline int clip_near(const Corner *in, int n, Corner *out)
{
    int i, kept = 0;

    for (i = 0; i < n; i++) {
        const Corner *a = &in[i], *b = &in[(i + 1) % n];
        float da = a->position.z - NEAR_PLANE, db = b->position.z - NEAR_PLANE;

        if (da >= 0.0f) {
            out[kept++] = *a;
        }
        if ((da >= 0.0f) != (db >= 0.0f)) {
            out[kept] = mix_corner(a, b, da / (da - db));
            out[kept++].position.z = NEAR_PLANE;
        }
    }
    return kept;
}

/* Draws a convex polygon in space: at most MAX_CORNERS - 1 corners, clipped
 * against the near plane here and against the clip window by the library. */
static inline void draw_in_space(const Camera *camera, const Corner *corners, int n)
{
    Corner view[MAX_CORNERS], clipped[MAX_CORNERS];
    GrVertex screen[MAX_CORNERS];
    int i;

    for (i = 0; i < n; i++) {
        view[i] = corners[i];
        view[i].position = to_view(camera, corners[i].position);
    }
    n = clip_near(view, n, clipped);
    for (i = 0; i < n; i++) {
        screen[i] = project_view(camera, &clipped[i]);
    }
    for (i = 2; i < n; i++) {
        guDrawTriangleWithClip(&screen[0], &screen[i - 1], &screen[i]);
    }
}

/* --- textures ------------------------------------------------------------ */

/* Colour at (u, v), both in 0..1. */
typedef Color (*Pattern)(float u, float v);

typedef struct {
    GrTexInfo info;
    FxU32 address;
} Texture;

static inline void store_texel(GrTextureFormat_t format, Color c, FxU8 *at)
{
    FxU32 a = to_byte(c.a), r = to_byte(c.r), g = to_byte(c.g), b = to_byte(c.b);
    FxU32 word = 0;
    FxU16 half;

    switch (format) {
    case GR_TEXFMT_RGB_332: word = (r & 0xe0) | (g >> 5) << 2 | b >> 6; break;
    case GR_TEXFMT_ALPHA_8: word = a; break;
    case GR_TEXFMT_INTENSITY_8: word = g; break;
    case GR_TEXFMT_ALPHA_INTENSITY_44: word = (a & 0xf0) | g >> 4; break;
    case GR_TEXFMT_ARGB_8332: word = a << 8 | (r & 0xe0) | (g >> 5) << 2 | b >> 6; break;
    case GR_TEXFMT_RGB_565: word = (r >> 3) << 11 | (g >> 2) << 5 | b >> 3; break;
    case GR_TEXFMT_ARGB_1555: word = (a >> 7) << 15 | (r >> 3) << 10 | (g >> 3) << 5 | b >> 3; break;
    case GR_TEXFMT_ARGB_4444: word = (a >> 4) << 12 | (r >> 4) << 8 | (g >> 4) << 4 | b >> 4; break;
    case GR_TEXFMT_ALPHA_INTENSITY_88: word = a << 8 | g; break;
    default: break;
    }
    if (format < GR_TEXFMT_16BIT) {
        *at = (FxU8)word;
    } else {
        half = (FxU16)word;
        memcpy(at, &half, 2);
    }
}

/* Reserves texture memory; a mip map must not cross a 2 MB boundary. */
static inline FxU32 reserve_texture(GrChipID_t tmu, FxU32 bytes)
{
    static FxU32 used[3];
    FxU32 start = grTexMinAddress(tmu) + used[tmu];
    const FxU32 bank = 2U << 20;

    if (start / bank != (start + bytes - 1) / bank) {
        start = (start / bank + 1) * bank;
    }
    used[tmu] = start - grTexMinAddress(tmu) + bytes;
    if (used[tmu] > grTexMaxAddress(tmu) + 8) {
        fprintf(stderr, "out of texture memory\n");
        exit(1);
    }
    return start;
}

/* Average of each 2x2 square of a side x side picture, in place. */
static inline void halve(Color *pixels, int side)
{
    int x, y, half = side / 2;

    for (y = 0; y < half; y++) {
        for (x = 0; x < half; x++) {
            const Color *p = &pixels[2 * y * side + 2 * x];
            pixels[y * half + x] = mix_color(mix_color(p[0], p[1], 0.5f),
                                             mix_color(p[side], p[side + 1], 0.5f), 0.5f);
        }
    }
}

/* Texels of a square mip map, largest level first, from a pattern. */
static inline void *paint_texels(Pattern pattern, GrTextureFormat_t format, GrLOD_t large)
{
    int side = 256 >> large, bytes = format < GR_TEXFMT_16BIT ? 1 : 2, x, y, i;
    Color *pixels = malloc((size_t)(side * side) * sizeof *pixels);
    FxU8 *texels = malloc((size_t)(side * side * 2 * bytes));
    FxU8 *at = texels;

    if (pixels == NULL || texels == NULL) {
        fprintf(stderr, "out of memory\n");
        exit(1);
    }
    for (y = 0; y < side; y++) {
        for (x = 0; x < side; x++) {
            pixels[y * side + x] = pattern(((float)x + 0.5f) / (float)side,
                                           ((float)y + 0.5f) / (float)side);
        }
    }
    for (; side > 0; side /= 2) {
        for (i = 0; i < side * side; i++, at += bytes) {
            store_texel(format, pixels[i], at);
        }
        if (side > 1) {
            halve(pixels, side);
        }
    }
    free(pixels);
    return texels;
}

/* Loads a square mip map made of a pattern into one texture unit; `levels`
 * is one of GR_MIPMAPLEVELMASK_*. */
static inline Texture load_levels(GrChipID_t tmu, FxU32 levels, Pattern pattern,
                                  GrTextureFormat_t format, GrLOD_t large)
{
    Texture texture;

    texture.info.smallLod = GR_LOD_1;
    texture.info.largeLod = large;
    texture.info.aspectRatio = GR_ASPECT_1x1;
    texture.info.format = format;
    texture.info.data = paint_texels(pattern, format, large);
    texture.address = reserve_texture(tmu, grTexTextureMemRequired(levels, &texture.info));
    grTexDownloadMipMap(tmu, texture.address, levels, &texture.info);
    free(texture.info.data);
    texture.info.data = NULL;
    return texture;
}

static inline Texture load_texture(GrChipID_t tmu, Pattern pattern,
                                   GrTextureFormat_t format, GrLOD_t large)
{
    return load_levels(tmu, GR_MIPMAPLEVELMASK_BOTH, pattern, format, large);
}

/* Makes the texture current: repeated, bilinear, nearest mip map level. */
static inline void use_texture(GrChipID_t tmu, Texture *texture)
{
    grTexSource(tmu, texture->address, GR_MIPMAPLEVELMASK_BOTH, &texture->info);
    grTexCombineFunction(tmu, GR_TEXTURECOMBINE_DECAL);
    grTexClampMode(tmu, GR_TEXTURECLAMP_WRAP, GR_TEXTURECLAMP_WRAP);
    grTexFilterMode(tmu, GR_TEXTUREFILTER_BILINEAR, GR_TEXTUREFILTER_BILINEAR);
    grTexMipMapMode(tmu, GR_MIPMAP_NEAREST, FXFALSE);
    grTexLodBiasValue(tmu, 0.0f);
}

#endif
