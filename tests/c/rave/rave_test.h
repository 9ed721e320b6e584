/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * rave_test.h: what the conformance programs of RAVE share: a context over
 * memory of the program, vertices in a line, and looking at pixels.
 */
#ifndef RAVE_TEST_H
#define RAVE_TEST_H

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <RAVE.h>

#include "../check.h"

#if defined(__GNUC__)
#define SHARED static __attribute__((unused))
#else
#define SHARED static
#endif

#define MAX_WIDTH 320
#define MAX_HEIGHT 240

/* Memory of the program, with a margin that nobody may touch. */
typedef struct Target {
    TQAUInt32 before[64];
    TQAUInt32 pixels[MAX_WIDTH * MAX_HEIGHT];
    TQAUInt32 after[64];
    TQADevice device;
    TQARect rect;
} Target;

#define MARGIN 0x5a5a5a5au

/* A device of so many pixels, filled with a byte. */
SHARED void init_target(Target *target, TQAImagePixelType type, int width, int height, int fill)
{
    TQADeviceMemory *memory = &target->device.device.memoryDevice;
    int bytes = type == kQAPixel_RGB32 || type == kQAPixel_ARGB32           ? 4
                : type == kQAPixel_RGB24                                    ? 3
                : type == kQAPixel_RGB8_332 || type == kQAPixel_I8          ? 1
                                                                            : 2;
    int i;

    memset(target, 0, sizeof *target);
    memset(target->pixels, fill, sizeof target->pixels);
    for (i = 0; i < 64; i++) {
        target->before[i] = target->after[i] = MARGIN;
    }
    target->device.deviceType = kQADeviceMemory;
    memory->rowBytes = width * bytes;
    memory->pixelType = type;
    memory->width = width;
    memory->height = height;
    memory->baseAddr = target->pixels;
    target->rect.right = width;
    target->rect.bottom = height;
}

/* Whether nobody wrote beside the device. */
SHARED int margin_is_clean(const Target *target)
{
    int i;

    for (i = 0; i < 64; i++) {
        if (target->before[i] != MARGIN || target->after[i] != MARGIN) {
            return 0;
        }
    }
    return 1;
}

SHARED TQAEngine *engine_for(const Target *target)
{
    return QADeviceGetFirstEngine(&target->device);
}

/* A context over the whole device; NULL where there is none. */
SHARED TQADrawContext *open_context(Target *target, TQAUInt32 flags)
{
    TQADrawContext *context = NULL;

    CHECK(QADrawContextNew(&target->device, &target->rect, NULL, engine_for(target), flags,
                           &context) == kQANoErr);
    CHECK(context != NULL);
    if (context == NULL) {
        exit(check_report());
    }
    return context;
}

/* A target of 32-bit pixels and a double-buffered context over it. */
SHARED TQADrawContext *open_usual(Target *target, int width, int height)
{
    init_target(target, kQAPixel_RGB32, width, height, 0);
    return open_context(target, kQAContext_DoubleBuffer);
}

SHARED void background(TQADrawContext *context, float r, float g, float b)
{
    QASetFloat(context, kQATag_ColorBG_a, 1);
    QASetFloat(context, kQATag_ColorBG_r, r);
    QASetFloat(context, kQATag_ColorBG_g, g);
    QASetFloat(context, kQATag_ColorBG_b, b);
}

SHARED TQAVGouraud gv(float x, float y, float z, float r, float g, float b, float a)
{
    TQAVGouraud v;

    v.x = x;
    v.y = y;
    v.z = z;
    v.invW = 1;
    v.r = r;
    v.g = g;
    v.b = b;
    v.a = a;
    return v;
}

/* A textured vertex without perspective: white light, no highlight. */
SHARED TQAVTexture tv(float x, float y, float z, float u, float v)
{
    TQAVTexture t;

    memset(&t, 0, sizeof t);
    t.x = x;
    t.y = y;
    t.z = z;
    t.invW = 1;
    t.a = 1;
    t.uOverW = u;
    t.vOverW = v;
    t.r = t.g = t.b = 1;
    t.kd_r = t.kd_g = t.kd_b = 1;
    return t;
}

/* A rectangle of one colour. */
SHARED void gouraud_rect(const TQADrawContext *context, float x0, float y0, float x1, float y1,
                         float z, float r, float g, float b, float a)
{
    TQAVGouraud v[4];

    v[0] = gv(x0, y0, z, r, g, b, a);
    v[1] = gv(x1, y0, z, r, g, b, a);
    v[2] = gv(x0, y1, z, r, g, b, a);
    v[3] = gv(x1, y1, z, r, g, b, a);
    QADrawVGouraud(context, 4, kQAVertexMode_Strip, v, NULL);
}

/* The corners of a textured rectangle, the image upright. */
SHARED void texture_corners(TQAVTexture *v, float x0, float y0, float x1, float y1, float z)
{
    v[0] = tv(x0, y0, z, 0, 1);
    v[1] = tv(x1, y0, z, 1, 1);
    v[2] = tv(x0, y1, z, 0, 0);
    v[3] = tv(x1, y1, z, 1, 0);
}

SHARED void texture_rect(const TQADrawContext *context, float x0, float y0, float x1, float y1,
                         float z)
{
    TQAVTexture v[4];

    texture_corners(v, x0, y0, x1, y1, z);
    QADrawVTexture(context, 4, kQAVertexMode_Strip, v, NULL);
}

/* A pixel of a 32-bit target, 0xRRGGBB. */
SHARED TQAUInt32 at(const Target *target, int x, int y)
{
    return target->pixels[y * target->device.device.memoryDevice.width + x] & 0xffffff;
}

SHARED int red(TQAUInt32 pixel)
{
    return (int)(pixel >> 16 & 255);
}

SHARED int green(TQAUInt32 pixel)
{
    return (int)(pixel >> 8 & 255);
}

SHARED int blue(TQAUInt32 pixel)
{
    return (int)(pixel & 255);
}

/* Whether a pixel is within a step of a colour of 0..255 in each channel. */
SHARED int is_near(TQAUInt32 pixel, int r, int g, int b, int step)
{
    return abs(red(pixel) - r) <= step && abs(green(pixel) - g) <= step &&
           abs(blue(pixel) - b) <= step;
}

SHARED int is_red(TQAUInt32 pixel)
{
    return red(pixel) > 170 && green(pixel) < 85 && blue(pixel) < 85;
}

SHARED int is_green(TQAUInt32 pixel)
{
    return green(pixel) > 170 && red(pixel) < 85 && blue(pixel) < 85;
}

SHARED int is_blue(TQAUInt32 pixel)
{
    return blue(pixel) > 170 && red(pixel) < 85 && green(pixel) < 85;
}

SHARED int is_purple(TQAUInt32 pixel)
{
    return red(pixel) > 85 && blue(pixel) > 85 && green(pixel) < 85;
}

SHARED TQAImage image_of(int width, int height, int row_bytes, void *pixels)
{
    TQAImage image;

    image.width = width;
    image.height = height;
    image.rowBytes = row_bytes;
    image.pixmap = pixels;
    return image;
}

/* A texture of one level. */
SHARED TQATexture *make_texture(const TQAEngine *engine, TQAUInt32 flags, TQAImagePixelType type,
                                int width, int height, int row_bytes, void *pixels)
{
    TQATexture *texture = NULL;
    TQAImage image = image_of(width, height, row_bytes, pixels);

    CHECK(QATextureNew(engine, flags, type, &image, &texture) == kQANoErr);
    CHECK(texture != NULL);
    return texture;
}

SHARED TQABitmap *make_bitmap(const TQAEngine *engine, TQAUInt32 flags, TQAImagePixelType type,
                              int width, int height, int row_bytes, void *pixels)
{
    TQABitmap *bitmap = NULL;
    TQAImage image = image_of(width, height, row_bytes, pixels);

    CHECK(QABitmapNew(engine, flags, type, &image, &bitmap) == kQANoErr);
    CHECK(bitmap != NULL);
    return bitmap;
}

#endif
