/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * conformance.h: what the conformance programs share. Each draws one topic of
 * the interface as a small picture, which is compared with a stored one, and
 * checks in C what can be computed: the arithmetic of the combine units, the
 * blender, fog, and what comes back from the frame buffer.
 */
#ifndef FILLRATE_CONFORMANCE_H
#define FILLRATE_CONFORMANCE_H

#include "../../../examples/glide/common.h"
#include "../check.h"

#define WIDE 320
#define HIGH 240

#define COUNT_OF(array) (sizeof(array) / sizeof((array)[0]))

/* --- errors -------------------------------------------------------------- */

static int errors_told;
static char error_text[160];
/* A function whose rules the program breaks on purpose: what checking says of
 * it does not count. */
static const char *broken_on_purpose;

static inline void note_error(const char *text, FxBool fatal)
{
    (void)fatal;
    if (broken_on_purpose != NULL
        && strncmp(text, broken_on_purpose, strlen(broken_on_purpose)) == 0) {
        return;
    }
    errors_told++;
    strncpy(error_text, text, sizeof error_text - 1);
}

/* Whether exactly one message came since the last call, from that function. */
static inline int told_once(const char *function)
{
    int right = errors_told == 1 && strncmp(error_text, function, strlen(function)) == 0;

    if (!right) {
        printf("%s: %d messages, last \"%s\"\n", function, errors_told, error_text);
    }
    errors_told = 0;
    error_text[0] = '\0';
    return right;
}

/* --- opening and ending --------------------------------------------------- */

/* Opens the first board at 320x240 with a depth buffer and colours as
 * 0xAARRGGBB; without dithering, so that pixels can be computed. */
static inline int open_small(GrOriginLocation_t origin)
{
    GrHwConfiguration hardware;

    grErrorSetCallback(note_error);
    grGlideInit();
    memset(&hardware, 0, sizeof hardware);
    CHECK(grSstQueryHardware(&hardware));
    grSstSelect(0);
    CHECK(grSstWinOpen(0, GR_RESOLUTION_320x240, GR_REFRESH_60Hz, GR_COLORFORMAT_ARGB,
                       origin, 2, 1));
    grDitherMode(GR_DITHER_DISABLE);
    return hardware.SSTs[0].sstBoard.VoodooConfig.nTexelfx;
}

/* Ends the program: no message may be left that no check asked for. */
static inline int finish(void)
{
    CHECK(errors_told == 0);
    if (errors_told != 0) {
        printf("unexpected: %s\n", error_text);
    }
    grGlideShutdown();
    return CHECK_REPORT();
}

/* --- pixels ---------------------------------------------------------------- */

static inline FxU16 read_pixel(GrBuffer_t buffer, int x, int y)
{
    FxU16 pixel = 0xdead;

    CHECK(grLfbReadRegion(buffer, (FxU32)x, (FxU32)y, 1, 1, 2, &pixel));
    return pixel;
}

static inline FxU16 pack565(int r, int g, int b)
{
    return (FxU16)((r >> 3) << 11 | (g >> 2) << 5 | b >> 3);
}

/* 565 to 8 bits by repeating the high bits. */
static inline int red_of(FxU16 p) { return (p >> 11) << 3 | p >> 13; }
static inline int green_of(FxU16 p) { return ((p >> 5) & 63) << 2 | ((p >> 9) & 3); }
static inline int blue_of(FxU16 p) { return (p & 31) << 3 | ((p >> 2) & 7); }

static inline int clamp_byte(int v)
{
    return v < 0 ? 0 : v > 255 ? 255 : v;
}

/* A comparison of the eight functions. */
static inline int compare_as(GrCmpFnc_t function, int a, int b)
{
    switch (function) {
    case GR_CMP_NEVER: return 0;
    case GR_CMP_LESS: return a < b;
    case GR_CMP_EQUAL: return a == b;
    case GR_CMP_LEQUAL: return a <= b;
    case GR_CMP_GREATER: return a > b;
    case GR_CMP_NOTEQUAL: return a != b;
    case GR_CMP_GEQUAL: return a >= b;
    default: return 1;
    }
}

/* --- shapes ---------------------------------------------------------------- */

typedef struct {
    int x0, y0, x1, y1;
} Box;

/* Cell i of a grid that fills the screen, less a border. */
static inline Box cell(int i, int columns, int rows)
{
    Box b;
    int wide = WIDE / columns, high = HIGH / rows;

    b.x0 = i % columns * wide + 1;
    b.y0 = i / columns * high + 1;
    b.x1 = b.x0 + wide - 2;
    b.y1 = b.y0 + high - 2;
    return b;
}

static inline Color rgba(float r, float g, float b, float a)
{
    Color c = {r, g, b, a};
    return c;
}

/* A colour of bytes. */
static inline Color bytes_color(int a, int r, int g, int b)
{
    Color c = {(float)r / 255.0f, (float)g / 255.0f, (float)b / 255.0f, (float)a / 255.0f};
    return c;
}

static inline GrVertex byte_vertex(float x, float y, int a, int r, int g, int b)
{
    GrVertex v = vertex(x, y, rgb(0, 0, 0));

    v.r = (float)r;
    v.g = (float)g;
    v.b = (float)b;
    v.a = (float)a;
    return v;
}

/* A box of one colour, given in bytes; texture coordinates over the whole
 * map; depth values as given. */
static inline void flat_box(Box box, int a, int r, int g, int b, float ooz, float oow)
{
    float x[4], y[4];
    GrVertex v[4];
    int i;

    x[0] = x[3] = (float)box.x0;
    x[1] = x[2] = (float)box.x1;
    y[0] = y[1] = (float)box.y0;
    y[2] = y[3] = (float)box.y1;
    for (i = 0; i < 4; i++) {
        v[i] = byte_vertex(x[i], y[i], a, r, g, b);
        v[i].ooz = ooz;
        v[i].oow = oow;
        set_texture(&v[i], i == 1 || i == 2 ? 256.0f : 0.0f, i >= 2 ? 256.0f : 0.0f);
    }
    draw_quad(&v[0], &v[1], &v[2], &v[3]);
}

static inline void fill_box(Box box, int a, int r, int g, int b)
{
    flat_box(box, a, r, g, b, 32768.0f, 0.5f);
}

/* A box whose corners have colours of their own, from the upper left round. */
static inline void shaded_box(Box box, Color c0, Color c1, Color c2, Color c3)
{
    GrVertex a = vertex((float)box.x0, (float)box.y0, c0), b = vertex((float)box.x1, (float)box.y0, c1);
    GrVertex c = vertex((float)box.x1, (float)box.y1, c2), d = vertex((float)box.x0, (float)box.y1, c3);

    set_texture(&a, 0, 0);
    set_texture(&b, 256, 0);
    set_texture(&c, 256, 256);
    set_texture(&d, 0, 256);
    draw_quad(&a, &b, &c, &d);
}

/* A white box with texture coordinates from (s0, t0) to (s1, t1). */
static inline void texture_box(Box box, float s0, float t0, float s1, float t1)
{
    float x[4], y[4];
    GrVertex v[4];
    int i;

    x[0] = x[3] = (float)box.x0;
    x[1] = x[2] = (float)box.x1;
    y[0] = y[1] = (float)box.y0;
    y[2] = y[3] = (float)box.y1;
    for (i = 0; i < 4; i++) {
        v[i] = vertex(x[i], y[i], rgb(1, 1, 1));
        set_texture(&v[i], i == 1 || i == 2 ? s1 : s0, i >= 2 ? t1 : t0);
    }
    draw_quad(&v[0], &v[1], &v[2], &v[3]);
}

/* The pixel in the middle of a box of the back buffer. */
static inline FxU16 middle(Box box)
{
    return read_pixel(GR_BUFFER_BACKBUFFER, (box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2);
}

static inline void clear_to(GrColor_t color)
{
    grBufferClear(color, 0, GR_ZDEPTHVALUE_FARTHEST);
}

/* --- textures ---------------------------------------------------------------- */

/* A 1x1 texture of format ARGB_4444 in a unit: parts are 0..15, and seen as
 * 17 times that. Each call takes eight bytes from `address` on. */
static inline void solid_texel(GrChipID_t tmu, FxU32 address, int a, int r, int g, int b)
{
    FxU16 texel = (FxU16)(a << 12 | r << 8 | g << 4 | b);
    GrTexInfo info;

    info.smallLod = info.largeLod = GR_LOD_1;
    info.aspectRatio = GR_ASPECT_1x1;
    info.format = GR_TEXFMT_ARGB_4444;
    info.data = &texel;
    grTexDownloadMipMap(tmu, address, GR_MIPMAPLEVELMASK_BOTH, &info);
    grTexSource(tmu, address, GR_MIPMAPLEVELMASK_BOTH, &info);
}

/* A pattern that shows position, direction and transparency. */
static inline Color test_card(float u, float v)
{
    int i = (int)(u * 8.0f), j = (int)(v * 8.0f);
    Color c = hue(u * 0.75f);
    float x = u - 0.5f, y = v - 0.5f;

    c = mix_color(c, (i + j) & 1 ? rgb(1, 1, 1) : rgb(0.05f, 0.05f, 0.1f), 0.25f + 0.5f * v);
    if (u < 0.25f && v < 0.25f) {
        c = rgb(1, 0.1f, 0.1f);
    }
    c.a = x * x + y * y < 0.2f ? 1.0f : 0.3f;
    return c;
}

/* --- arithmetic ---------------------------------------------------------------- */

static const GrCombineFunction_t all_functions[] = {
    GR_COMBINE_FUNCTION_ZERO, GR_COMBINE_FUNCTION_LOCAL, GR_COMBINE_FUNCTION_LOCAL_ALPHA,
    GR_COMBINE_FUNCTION_SCALE_OTHER, GR_COMBINE_FUNCTION_SCALE_OTHER_ADD_LOCAL,
    GR_COMBINE_FUNCTION_SCALE_OTHER_ADD_LOCAL_ALPHA, GR_COMBINE_FUNCTION_SCALE_OTHER_MINUS_LOCAL,
    GR_COMBINE_FUNCTION_SCALE_OTHER_MINUS_LOCAL_ADD_LOCAL,
    GR_COMBINE_FUNCTION_SCALE_OTHER_MINUS_LOCAL_ADD_LOCAL_ALPHA,
    GR_COMBINE_FUNCTION_SCALE_MINUS_LOCAL_ADD_LOCAL,
    GR_COMBINE_FUNCTION_SCALE_MINUS_LOCAL_ADD_LOCAL_ALPHA
};

static const GrCombineFactor_t all_factors[] = {
    GR_COMBINE_FACTOR_ZERO, GR_COMBINE_FACTOR_LOCAL, GR_COMBINE_FACTOR_OTHER_ALPHA,
    GR_COMBINE_FACTOR_LOCAL_ALPHA, GR_COMBINE_FACTOR_TEXTURE_ALPHA, GR_COMBINE_FACTOR_TEXTURE_RGB,
    GR_COMBINE_FACTOR_ONE, GR_COMBINE_FACTOR_ONE_MINUS_LOCAL,
    GR_COMBINE_FACTOR_ONE_MINUS_OTHER_ALPHA, GR_COMBINE_FACTOR_ONE_MINUS_LOCAL_ALPHA,
    GR_COMBINE_FACTOR_ONE_MINUS_TEXTURE_ALPHA, GR_COMBINE_FACTOR_ONE_MINUS_LOD_FRACTION
};

/* One channel of a combine unit. `scale` holds the factors by their low three
 * bits: nothing, local, other alpha, local alpha, texture alpha or detail,
 * texture colour or level fraction. */
static inline int combine_channel(GrCombineFunction_t function, GrCombineFactor_t factor,
                                  int other, int local, int local_alpha,
                                  const int scale[6], FxBool invert)
{
    int zero_other, minus, add, f, x;

    zero_other = function <= 2 || function == 9 || function == 0x10;
    minus = function == 6 || function == 7 || function == 8 || function == 9 || function == 0x10;
    switch (function) {
    case 1: case 4: case 7: case 9: add = local; break;
    case 2: case 5: case 8: case 0x10: add = local_alpha; break;
    default: add = 0; break;
    }
    x = (zero_other ? 0 : other) - (minus ? local : 0);
    f = scale[factor & 7];
    if (factor & 8) {
        f = 255 - f;
    }
    x *= f + 1;
    x = x < 0 ? -((-x + 255) / 256) : x / 256; /* towards minus infinity */
    x = clamp_byte(x + add);
    return invert ? 255 - x : x;
}

#endif
