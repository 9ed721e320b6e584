/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * formats.c: texels of every format, with and without padding, BGR; and
 * destinations of every format that can be drawn to.
 */
#include "conformance.h"

static int drawn;

/* Draws a surface's first texel over 32x32 pixels; the pixel that results. */
static v_u16 show_texel(v_surface *surface)
{
    int x = 8 + drawn % 8 * 38, y = 8 + drawn / 8 * 38;

    drawn++;
    CHECK(VL_InstallTextureMap(&cb, surface) == VL_SUCCESS);
    quad_uv(x, y, 32, 32, 0.0, 0.0, 1.0, 1.0);
    return pixel(x + 2, y + 2);
}

static v_surface *solid(v_u32 format, v_u32 texel)
{
    static v_u32 data[8 * 8];
    v_u32 bytes = V_PIXEL_SIZE(format), i;
    v_u32 word = bytes == 1 ? texel * 0x01010101u : bytes == 2 ? texel * 0x10001u : texel;

    for (i = 0; i < COUNT_OF(data); i++) {
        data[i] = word;
    }
    return texture(format, 8, 8, 8 * bytes, data);
}

static void whole_bytes(void)
{
    static const struct {
        v_u32 format, texel;
        int r, g, b;
    } cases[] = {
        { V_PIXFMT_332, 0xE0, 255, 0, 0 },       { V_PIXFMT_332, 0x1C, 0, 255, 0 },
        { V_PIXFMT_332, 0x03, 0, 0, 255 },       { V_PIXFMT_332, 0x92, 146, 146, 170 },
        { V_PIXFMT_8I, 0x80, 128, 128, 128 },    { V_PIXFMT_8A, 0x80, 255, 255, 255 },
        { V_PIXFMT_565, 0xF800, 255, 0, 0 },     { V_PIXFMT_565, 0x8410, 132, 130, 132 },
        { V_PIXFMT_4444, 0xF8C4, 136, 204, 68 }, { V_PIXFMT_1555, 0xFC00, 255, 0, 0 },
        { V_PIXFMT_1555, 0x03E0, 0, 255, 0 },    { V_PIXFMT_8888, 0xFF204060, 32, 64, 96 },
    };
    size_t i;

    for (i = 0; i < COUNT_OF(cases); i++) {
        v_surface *surface = solid(cases[i].format, cases[i].texel);

        CHECK(VL_SetSurfaceColorPad(surface, 1) == VL_SUCCESS);
        CHECK(near_rgb(show_texel(surface), cases[i].r, cases[i].g, cases[i].b, 8));
        CHECK(VL_DestroySurface(verite, surface) == VL_SUCCESS);
    }
}

/* Padding repeats high bits; without it they are zero. */
static void padding(void)
{
    v_surface *surface = solid(V_PIXFMT_4444, 0xFFFF), *wide = NULL;
    v_u32 pixel32;

    CHECK(VL_CreateSurface(verite, &wide, 0, 1, V_PIXFMT_8888, 16, 16) == VL_SUCCESS);
    for (surface->color_pad = 0; surface->color_pad < 2; surface->color_pad++) {
        CHECK(VL_InstallTextureMap(&cb, surface) == VL_SUCCESS);
        CHECK(VL_InstallDstBuffer(&cb, wide) == VL_SUCCESS);
        CHECK(VL_SetDstFmt(&cb, V_PIXFMT_8888) == VL_SUCCESS);
        quad_uv(0, 0, 16, 16, 0.0, 0.0, 1.0, 1.0);
        lock(wide, 0);
        pixel32 = *at32(3, 3);
        unlock();
        CHECK((pixel32 & 0xFFFFFF) == (surface->color_pad ? 0xFFFFFFu : 0xF0F0F0u));
    }
    CHECK(VL_InstallDstBuffer(&cb, display) == VL_SUCCESS);
    CHECK(VL_SetDstFmt(&cb, V_PIXFMT_565) == VL_SUCCESS);
    CHECK(VL_DestroySurface(verite, surface) == VL_SUCCESS);
    surface = solid(V_PIXFMT_565, 0xF800);
    CHECK(VL_SetSurfaceBGR(surface, 1) == VL_SUCCESS);
    CHECK(show_texel(surface) == 0x001F);
    CHECK(VL_DestroySurface(verite, surface) == VL_SUCCESS);
    CHECK(VL_DestroySurface(verite, wide) == VL_SUCCESS);
}

/* Four bits of index; the even texel is in the low half of a byte. */
static void palettes(void)
{
    static const v_u32 formats[3] = { V_PIXFMT_4I_565, V_PIXFMT_4I_4444, V_PIXFMT_4I_1555 };
    v_u32 entries[16], data[8], i, k;

    for (i = 0; i < 16; i++) {
        entries[i] = 0xFF000000 | (i * 17) << 16 | (255 - i * 17) << 8 | (i & 1 ? 255 : 0);
    }
    for (i = 0; i < 8; i++) {
        data[i] = 0x76543210;
    }
    for (k = 0; k < 3; k++) {
        v_surface *surface = texture(formats[k], 8, 8, 4, data);
        int x = 8 + (int)k * 72;

        CHECK(VL_SetSurfaceTexturePalette(surface, 0, 16, entries) == VL_SUCCESS);
        CHECK(VL_SetSurfaceColorPad(surface, 1) == VL_SUCCESS);
        CHECK(VL_InstallTextureMap(&cb, surface) == VL_SUCCESS);
        quad_uv(x, 90, 64, 32, 0.0, 0.0, 1.0, 1.0);
        for (i = 0; i < 8; i++) {
            CHECK(near_rgb(pixel(x + (int)i * 8 + 4, 100), (int)(i * 17), (int)(255 - i * 17),
                           i & 1 ? 255 : 0, 16));
        }
        CHECK(VL_DestroySurface(verite, surface) == VL_SUCCESS);
    }
}

/* Two pixels of four bytes share their colour differences. */
static void video(void)
{
    static const unsigned char white[4] = { 235, 128, 235, 128 }, black[4] = { 16, 128, 16, 128 };
    static const unsigned char gray[4] = { 126, 128, 126, 128 }, red[4] = { 81, 240, 81, 90 };
    const unsigned char *patterns[4] = { white, black, gray, red };
    static const int expected[4][3]
        = { { 255, 255, 255 }, { 0, 0, 0 }, { 128, 128, 128 }, { 255, 0, 0 } };
    int i, k;

    for (k = 0; k < 4; k++) {
        unsigned char data[8 * 16];
        v_surface *surface;

        for (i = 0; i < 8 * 4; i++) {
            memcpy(data + 4 * i, patterns[k], 4);
        }
        surface = texture(V_PIXFMT_Y0CRY1CB, 8, 8, 16, data);
        CHECK(VL_InstallTextureMap(&cb, surface) == VL_SUCCESS);
        quad_uv(8 + 40 * k, 130, 32, 32, 0.0, 0.0, 1.0, 1.0);
        CHECK(near_rgb(pixel(20 + 40 * k, 140), expected[k][0], expected[k][1], expected[k][2],
                       9));
        CHECK(VL_DestroySurface(verite, surface) == VL_SUCCESS);
    }
}

/* Drawing to every format, then using the result as a texture. */
static void destinations(void)
{
    static const v_u32 formats[6] = { V_PIXFMT_332,  V_PIXFMT_8I,   V_PIXFMT_565,
                                      V_PIXFMT_4444, V_PIXFMT_1555, V_PIXFMT_8888 };
    int k;

    for (k = 0; k < 6; k++) {
        v_surface *target = NULL;
        int x = 8 + 50 * k;
        v_u16 p;

        CHECK(VL_CreateSurface(verite, &target, 0, 1, formats[k], 32, 32) == VL_SUCCESS);
        CHECK(VL_SetSurfaceColorPad(target, 1) == VL_SUCCESS);
        CHECK(VL_InstallDstBuffer(&cb, target) == VL_SUCCESS);
        VL_SetSrcFunc(&cb, V_SRCFUNC_NOTEXTURE);
        quad(0, 0, 32, 32, 0xFF404040);
        quad(8, 8, 16, 16, 0xFFFFFFFF);
        CHECK(VL_InstallDstBuffer(&cb, display) == VL_SUCCESS);
        VL_SetSrcFunc(&cb, V_SRCFUNC_REPLACE);
        CHECK(VL_InstallTextureMap(&cb, target) == VL_SUCCESS);
        quad_uv(x, 180, 32, 32, 0.0, 0.0, 1.0, 1.0);
        p = pixel(x + 16, 196);
        CHECK(near_rgb(p, 255, 255, 255, 8));
        CHECK(near_rgb(pixel(x + 3, 183), 64, 64, 64, 32));
        CHECK(VL_DestroySurface(verite, target) == VL_SUCCESS);
    }
}

int main(void)
{
    open_small();
    VL_SetSrcFunc(&cb, V_SRCFUNC_REPLACE);
    whole_bytes();
    padding();
    palettes();
    video();
    destinations();
    show();
    return finish();
}
