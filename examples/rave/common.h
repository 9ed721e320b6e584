/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * common.h: what the RAVE programs share: a screen in memory, an engine chosen
 * by what it can do, textures from formulas, and a program's half of 3D.
 *
 *     cc -Iinclude examples/rave/triangle.c -o triangle -lrave -lm
 *     ./triangle          draws the usual number of frames
 *     ./triangle -n 100   draws 100
 *
 * Angles are whole turns, and sines are our own, so that every machine draws
 * the same frames.
 */
#ifndef RAVE_COMMON_H
#define RAVE_COMMON_H

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <RAVE.h>

/* Each program uses its part. */
#if defined(__GNUC__)
#define SHARED static __attribute__((unused))
#else
#define SHARED static
#endif

/* --- the loop ----------------------------------------------------------- */

/* Frames to draw: the number after -n, or `otherwise`. */
SHARED int frames_wanted(int argc, char **argv, int otherwise)
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

/* Ends the program where a call has failed. */
SHARED void need(TQAError error, const char *what)
{
    if (error != kQANoErr) {
        fprintf(stderr, "%s failed with error %d\n", what, (int)error);
        exit(1);
    }
}

/* --- the screen --------------------------------------------------------- */

#define SCREEN_WIDTH 320
#define SCREEN_HEIGHT 240

typedef struct Screen {
    TQAUInt32 pixels[SCREEN_WIDTH * SCREEN_HEIGHT]; /* wide enough for any type */
    TQADevice device;
    TQARect rect;
    TQAEngine *engine;
    TQADrawContext *context;
} Screen;

/* The first engine for a device that has all of these features. */
SHARED TQAEngine *choose_engine(const TQADevice *device, TQAUInt32 features)
{
    TQAEngine *engine;
    TQAUInt32 offered = 0;

    for (engine = QADeviceGetFirstEngine(device); engine != NULL;
         engine = QADeviceGetNextEngine(device, engine)) {
        if (QAEngineGestalt(engine, kQAGestalt_OptionalFeatures, &offered) == kQANoErr &&
            (offered & features) == features) {
            return engine;
        }
    }
    fprintf(stderr, "no engine offers what this program needs\n");
    exit(1);
}

/* Opens a context over the whole screen; pixels of 16 bits are dithered. */
SHARED void open_screen(Screen *screen, TQAImagePixelType type, TQAUInt32 features,
                        TQAUInt32 flags)
{
    int bytes = type == kQAPixel_RGB32 || type == kQAPixel_ARGB32 ? 4 : 2;
    TQADeviceMemory *memory = &screen->device.device.memoryDevice;

    memset(screen, 0, sizeof *screen);
    screen->device.deviceType = kQADeviceMemory;
    memory->rowBytes = SCREEN_WIDTH * bytes;
    memory->pixelType = type;
    memory->width = SCREEN_WIDTH;
    memory->height = SCREEN_HEIGHT;
    memory->baseAddr = screen->pixels;
    screen->rect.right = SCREEN_WIDTH;
    screen->rect.bottom = SCREEN_HEIGHT;
    screen->engine = choose_engine(&screen->device, features);
    need(QADrawContextNew(&screen->device, &screen->rect, NULL, screen->engine, flags,
                          &screen->context),
         "QADrawContextNew");
}

/* The colour behind everything. */
SHARED void set_background(TQADrawContext *context, float r, float g, float b)
{
    QASetFloat(context, kQATag_ColorBG_a, 1.0f);
    QASetFloat(context, kQATag_ColorBG_r, r);
    QASetFloat(context, kQATag_ColorBG_g, g);
    QASetFloat(context, kQATag_ColorBG_b, b);
}

SHARED TQAVGouraud gouraud(float x, float y, float z, float r, float g, float b, float a)
{
    TQAVGouraud v;

    v.x = x;
    v.y = y;
    v.z = z;
    v.invW = 1.0f;
    v.r = r;
    v.g = g;
    v.b = b;
    v.a = a;
    return v;
}

/* --- numbers ------------------------------------------------------------ */

/* The sine of an angle in turns. */
SHARED float turn_sin(float turns)
{
    double t = turns, x, x2;

    t -= floor(t);
    if (t > 0.5) {
        return -turn_sin((float)(t - 0.5));
    }
    x = (t > 0.25 ? 0.5 - t : t) * 6.283185307179586;
    x2 = x * x;
    return (float)(x * (1 - x2 / 6 * (1 - x2 / 20 * (1 - x2 / 42 * (1 - x2 / 72)))));
}

SHARED float turn_cos(float turns)
{
    return turn_sin(turns + 0.25f);
}

/* The next of a fixed sequence of numbers, 0..32767. */
SHARED int next_random(TQAUInt32 *seed)
{
    *seed = *seed * 1664525u + 1013904223u;
    return (int)(*seed >> 17);
}

/* A fixed number of 0..255 for each pair of whole numbers. */
SHARED int lattice(int x, int y)
{
    TQAUInt32 h = (TQAUInt32)x * 0x9e3779b1u ^ (TQAUInt32)y * 0x85ebca77u;

    h = (h ^ (h >> 15)) * 0x2c1b3c6du;
    h = (h ^ (h >> 12)) * 0x297a2d39u;
    return (int)((h ^ (h >> 15)) >> 24);
}

/* Smooth noise of 0..255 over a square of `side`, `cells` across, that repeats. */
SHARED int noise(int x, int y, int side, int cells)
{
    int fx = x * cells % side * 256 / side, fy = y * cells % side * 256 / side;
    int x0 = x * cells / side % cells, y0 = y * cells / side % cells;
    int x1 = (x0 + 1) % cells, y1 = (y0 + 1) % cells;
    int top, bottom;

    fx = fx * fx * (768 - 2 * fx) >> 16;
    fy = fy * fy * (768 - 2 * fy) >> 16;
    top = lattice(x0, y0) * (256 - fx) + lattice(x1, y0) * fx;
    bottom = lattice(x0, y1) * (256 - fx) + lattice(x1, y1) * fx;
    return ((top >> 8) * (256 - fy) + (bottom >> 8) * fy) >> 8;
}

/* --- textures ----------------------------------------------------------- */

#define MAX_SIDE 128
#define MAX_LEVELS 8

/* A picture of 0xAARRGGBB with its smaller levels. */
typedef struct Picture {
    int side, levels;
    TQAUInt32 texels[MAX_SIDE * MAX_SIDE * 4 / 3 + MAX_LEVELS];
    TQAImage images[MAX_LEVELS];
} Picture;

/* A texel of a picture: column, row from the top, side, and the caller's kind. */
typedef TQAUInt32 (*Formula)(int x, int y, int side, int kind);

SHARED TQAUInt32 argb(int a, int r, int g, int b)
{
    a = a < 0 ? 0 : a > 255 ? 255 : a;
    r = r < 0 ? 0 : r > 255 ? 255 : r;
    g = g < 0 ? 0 : g > 255 ? 255 : g;
    b = b < 0 ? 0 : b > 255 ? 255 : b;
    return (TQAUInt32)a << 24 | (TQAUInt32)r << 16 | (TQAUInt32)g << 8 | (TQAUInt32)b;
}

/* The mean of four texels, channel by channel. */
SHARED TQAUInt32 mean(TQAUInt32 a, TQAUInt32 b, TQAUInt32 c, TQAUInt32 d)
{
    TQAUInt32 low = (a & 0xff00ff) + (b & 0xff00ff) + (c & 0xff00ff) + (d & 0xff00ff);
    TQAUInt32 high = (a >> 8 & 0xff00ff) + (b >> 8 & 0xff00ff) + (c >> 8 & 0xff00ff) +
                     (d >> 8 & 0xff00ff);

    return ((low + 0x20002) >> 2 & 0xff00ff) | ((high + 0x20002) >> 2 & 0xff00ff) << 8;
}

/* Fills a picture by a formula, and its levels by averaging. */
SHARED void paint_picture(Picture *picture, int side, Formula formula, int kind)
{
    TQAUInt32 *level = picture->texels, *next;
    int x, y, n;

    picture->side = side;
    for (y = 0; y < side; y++) {
        for (x = 0; x < side; x++) {
            level[y * side + x] = formula(x, y, side, kind);
        }
    }
    for (picture->levels = 0, n = side; n > 0; n /= 2) {
        TQAImage *image = &picture->images[picture->levels++];

        image->width = image->height = n;
        image->rowBytes = n * 4;
        image->pixmap = level;
        next = level + n * n;
        for (y = 0; y < n / 2; y++) {
            for (x = 0; x < n / 2; x++) {
                const TQAUInt32 *from = level + 2 * y * n + 2 * x;

                next[y * (n / 2) + x] = mean(from[0], from[1], from[n], from[n + 1]);
            }
        }
        level = next;
    }
}

/* A texture of a picture with all its levels, the engine's own. */
SHARED TQATexture *texture_of(const TQAEngine *engine, const Picture *picture)
{
    TQATexture *texture;

    need(QATextureNew(engine, kQATexture_Mipmap, kQAPixel_ARGB32, picture->images, &texture),
         "QATextureNew");
    need(QATextureDetach(engine, texture), "QATextureDetach");
    return texture;
}

/* --- space: x to the right, y up, z into the screen ---------------------- */

typedef struct Vec3 {
    float x, y, z;
} Vec3;

SHARED Vec3 vec3(float x, float y, float z)
{
    Vec3 v;

    v.x = x;
    v.y = y;
    v.z = z;
    return v;
}

/* Turns about the y axis, then about the x axis. */
SHARED Vec3 turned(Vec3 p, float yaw, float pitch)
{
    float c = turn_cos(yaw), s = turn_sin(yaw);
    Vec3 q = vec3(c * p.x + s * p.z, p.y, c * p.z - s * p.x);

    c = turn_cos(pitch);
    s = turn_sin(pitch);
    return vec3(q.x, c * q.y - s * q.z, s * q.y + c * q.z);
}

/* A corner of a polygon in view space. */
typedef struct Corner {
    Vec3 position;
    float u, v;
    float r, g, b; /* light */
} Corner;

#define MAX_CORNERS 16

/* The distance of the view plane, in pixels, and the planes of depth. */
#define VIEW_DISTANCE 200.0f
#define HITHER 1.0f
#define YON 200.0f

/* How far inside one of the six planes of the view a point is. */
SHARED float inside(Vec3 p, int plane)
{
    switch (plane) {
    case 0: return p.z - HITHER;
    case 1: return YON - p.z;
    case 2: return (SCREEN_WIDTH / 2) * p.z - VIEW_DISTANCE * p.x;
    case 3: return (SCREEN_WIDTH / 2) * p.z + VIEW_DISTANCE * p.x;
    case 4: return (SCREEN_HEIGHT / 2) * p.z - VIEW_DISTANCE * p.y;
    default: return (SCREEN_HEIGHT / 2) * p.z + VIEW_DISTANCE * p.y;
    }
}

SHARED Corner between(const Corner *a, const Corner *b, float t)
{
    Corner c;

    c.position = vec3(a->position.x + t * (b->position.x - a->position.x),
                      a->position.y + t * (b->position.y - a->position.y),
                      a->position.z + t * (b->position.z - a->position.z));
    c.u = a->u + t * (b->u - a->u);
    c.v = a->v + t * (b->v - a->v);
    c.r = a->r + t * (b->r - a->r);
    c.g = a->g + t * (b->g - a->g);
    c.b = a->b + t * (b->b - a->b);
    return c;
}

/* Clips a convex polygon to the view, plane by plane. Returns how many corners
 * are left. */
SHARED int clip_polygon(Corner *corners, int count)
{
    Corner kept[MAX_CORNERS];
    int plane, i;

    for (plane = 0; plane < 6 && count > 0; plane++) {
        int n = 0;

        for (i = 0; i < count; i++) {
            const Corner *a = &corners[i], *b = &corners[(i + 1) % count];
            float da = inside(a->position, plane), db = inside(b->position, plane);

            if (da >= 0 && n < MAX_CORNERS) {
                kept[n++] = *a;
            }
            if ((da >= 0) != (db >= 0) && n < MAX_CORNERS) {
                kept[n++] = between(a, b, da / (da - db));
            }
        }
        memcpy(corners, kept, (size_t)n * sizeof *kept);
        count = n;
    }
    return count;
}

/* Projects a corner: 1/w before z is changed, yon just inside 1. */
SHARED TQAVTexture project(const TQADrawContext *context, const Corner *corner)
{
    TQAVTexture v;
    float inv = 1.0f / corner->position.z;
    float z = YON / (YON - HITHER) * (1.0f - HITHER * inv);

    memset(&v, 0, sizeof v);
    v.x = SCREEN_WIDTH / 2 + corner->position.x * VIEW_DISTANCE * inv;
    v.y = SCREEN_HEIGHT / 2 - corner->position.y * VIEW_DISTANCE * inv;
    v.z = z * QAGetFloat(context, kQATag_ZMinScale) + QAGetFloat(context, kQATag_ZMinOffset);
    v.z = v.z < 0 ? 0 : v.z;
    v.invW = inv;
    v.a = 1.0f;
    v.uOverW = corner->u * inv;
    v.vOverW = corner->v * inv;
    v.r = v.kd_r = corner->r;
    v.g = v.kd_g = corner->g;
    v.b = v.kd_b = corner->b;
    return v;
}

/* Whether a polygon of the screen shows its back: corners turn to the left. */
SHARED int shows_back(const TQAVTexture *v)
{
    return (v[1].x - v[0].x) * (v[2].y - v[0].y) - (v[2].x - v[0].x) * (v[1].y - v[0].y) <= 0;
}

/* Clips, projects and draws a convex polygon of view space with the current
 * texture, as a fan. Returns how many triangles were drawn. */
SHARED int draw_polygon(const TQADrawContext *context, const Corner *corners, int count)
{
    Corner clipped[MAX_CORNERS];
    TQAVTexture vertices[MAX_CORNERS];
    int i;

    memcpy(clipped, corners, (size_t)count * sizeof *corners);
    count = clip_polygon(clipped, count);
    if (count < 3) {
        return 0;
    }
    for (i = 0; i < count; i++) {
        vertices[i] = project(context, &clipped[i]);
    }
    if (shows_back(vertices)) {
        return 0;
    }
    QADrawVTexture(context, (TQAUInt32)count, kQAVertexMode_Fan, vertices, NULL);
    return count - 2;
}

/* --- letters of 5 by 7, for the programs that write ------------------------ */

/* Seven rows of five bits, the left pixel highest. */
SHARED const unsigned char *letter(char c)
{
    static const struct {
        char name;
        unsigned char rows[7];
    } font[] = {
        {'0', {14, 17, 19, 21, 25, 17, 14}}, {'1', {4, 12, 4, 4, 4, 4, 14}},
        {'2', {14, 17, 1, 6, 8, 16, 31}},    {'3', {14, 17, 1, 6, 1, 17, 14}},
        {'4', {2, 6, 10, 18, 31, 2, 2}},     {'5', {31, 16, 30, 1, 1, 17, 14}},
        {'6', {14, 16, 30, 17, 17, 17, 14}}, {'7', {31, 1, 2, 4, 8, 8, 8}},
        {'8', {14, 17, 17, 14, 17, 17, 14}}, {'9', {14, 17, 17, 15, 1, 1, 14}},
        {'A', {14, 17, 17, 31, 17, 17, 17}}, {'E', {31, 16, 16, 30, 16, 16, 31}},
        {'F', {31, 16, 16, 30, 16, 16, 16}}, {'M', {17, 27, 21, 21, 17, 17, 17}},
        {'R', {30, 17, 17, 30, 20, 18, 17}}, {'V', {17, 17, 17, 17, 10, 10, 4}},
    };
    static const unsigned char nothing[7];
    size_t i;

    for (i = 0; i < sizeof font / sizeof *font; i++) {
        if (font[i].name == c) {
            return font[i].rows;
        }
    }
    return nothing;
}

#endif
