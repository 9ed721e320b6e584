/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * sprites.c: run-length coding: sprites decoded into textures by
 * ConvertAndDownloadRle, whole and in part, and pictures coded by
 * guEncodeRLE16; a movie, which is only an error.
 */
#include "conformance.h"

#define SIDE 32

static FxU8 sprite[4 + SIDE + SIDE * SIDE * 2];
static FxU16 table[256];

/* A ring on a plain ground: the colour of a pixel. */
static FxU8 sprite_pixel(int x, int y)
{
    int d = (2 * x - 31) * (2 * x - 31) + (2 * y - 31) * (2 * y - 31);

    return (FxU8)(d > 900 ? 0 : d > 400 ? 0xe8 : (x + y) & 31);
}

/* Codes a row: pixels from 0xe0 on need a run, others may be on their own. */
static int code_row(int y, FxU8 *to)
{
    int x = 0, n = 0;

    while (x < SIDE) {
        FxU8 p = sprite_pixel(x, y);
        int run = 1;

        while (run < 31 && x + run < SIDE && sprite_pixel(x + run, y) == p) {
            run++;
        }
        if (run > 1 || p >= 0xe0) {
            to[n++] = (FxU8)(0xe0 | run);
        }
        to[n++] = p;
        x += run;
    }
    to[n++] = 0xe0;
    return n;
}

static void make_sprite(void)
{
    int y, at = 4 + SIDE, i;

    for (y = 0; y < SIDE; y++) {
        int n = code_row(y, sprite + at);
        sprite[4 + y] = (FxU8)n;
        at += n;
    }
    for (i = 0; i < 256; i++) {
        Color c = i == 0xe8 ? rgb(1, 1, 1) : hue((float)i / 32.0f);
        table[i] = i == 0 ? 0 : (FxU16)(0x8000 | (to_byte(c.r) >> 3) << 10 | (to_byte(c.g) >> 3) << 5 | to_byte(c.b) >> 3);
    }
}

static void draw_part(Box box, FxU32 u, FxU32 v, FxU32 wide, FxU32 high, FxU32 to_wide, FxU32 to_high)
{
    static FxU16 gray[SIDE * SIDE];
    Texture t;
    int i;

    for (i = 0; i < SIDE * SIDE; i++) {
        gray[i] = 0x4210 | 0x8000;
    }
    t.info.smallLod = t.info.largeLod = GR_LOD_32;
    t.info.aspectRatio = GR_ASPECT_1x1;
    t.info.format = GR_TEXFMT_ARGB_1555;
    t.info.data = gray;
    t.address = 8192;
    grTexDownloadMipMap(GR_TMU0, t.address, GR_MIPMAPLEVELMASK_BOTH, &t.info);
    ConvertAndDownloadRle(GR_TMU0, t.address, GR_LOD_32, GR_LOD_32, GR_ASPECT_1x1, GR_TEXFMT_ARGB_1555,
                          GR_MIPMAPLEVELMASK_BOTH, sprite, SIDE, u, v, wide, high, to_wide, to_high, table);
    use_texture(GR_TMU0, &t);
    grTexFilterMode(GR_TMU0, GR_TEXTUREFILTER_POINT_SAMPLED, GR_TEXTUREFILTER_POINT_SAMPLED);
    texture_box(box, 0, 0, 256, 256);
    for (i = 0; i < SIDE * SIDE; i++) {
        int x = i % SIDE, y = i / SIDE, row = y;
        FxU16 texel = 0x4210, pixel;

        /* One row more than asked for repeats the last. */
        if (y == (int)high && high < to_high) {
            row = y - 1;
        }
        if (x < (int)to_wide && row < (int)high) {
            texel = x < (int)wide ? table[sprite_pixel(x + (int)u, row + (int)v)] : texel;
            pixel = read_pixel(GR_BUFFER_BACKBUFFER, box.x0 + (2 * x + 1) * 78 / 64, box.y0 + (2 * y + 1) * 78 / 64);
            CHECK(x >= (int)wide || (pixel & 0xffdf) == ((texel & 0x7fe0) << 1 | (texel & 31)));
        }
    }
}

static void check_encoding(void)
{
    static FxU16 picture[64][64];
    static FxU32 words[64 * 64 + 1];
    int i, count, pixels = 0, bytes;

    for (i = 0; i < 64 * 64; i++) {
        picture[i / 64][i % 64] = (FxU16)(i / 100 * 0x1111);
    }
    bytes = guEncodeRLE16(NULL, picture, 64, 64);
    CHECK(bytes == 41 * 4);
    words[bytes / 4] = 0x5a5a5a5aU;
    CHECK(guEncodeRLE16(words, picture, 64, 64) == bytes);
    CHECK(words[bytes / 4] == 0x5a5a5a5aU);
    for (i = 0; i < bytes / 4; i++) {
        for (count = (int)(words[i] >> 16); count > 0; count--, pixels++) {
            CHECK(picture[pixels / 64][pixels % 64] == (words[i] & 0xffff));
        }
    }
    CHECK(pixels == 64 * 64);
    CHECK(guEncodeRLE16(words, picture, 0, 64) == 0);
}

int main(void)
{
    open_small(GR_ORIGIN_UPPER_LEFT);
    make_sprite();
    clear_to(0x203040);
    guColorCombineFunction(GR_COLORCOMBINE_DECAL_TEXTURE);
    draw_part(cell(0, 4, 3), 0, 0, 32, 32, 32, 32);
    draw_part(cell(1, 4, 3), 4, 6, 16, 12, 16, 12);
    draw_part(cell(2, 4, 3), 0, 0, 32, 20, 32, 32);
    draw_part(cell(3, 4, 3), 8, 24, 24, 8, 24, 16);
    check_encoding();
    guMovieSetName("none.mov");
    CHECK(told_once("guMovieSetName: "));
    guMovieStart();
    CHECK(told_once("guMovieStart: "));
    guMovieStop();
    CHECK(told_once("guMovieStop: "));
    grBufferSwap(0);
    return finish();
}
