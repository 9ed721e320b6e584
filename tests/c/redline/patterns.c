/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * patterns.c: patterns of fills and lines, operations, the plane mask, the
 * scissor, dithering.
 */
#include "conformance.h"

/* Bit 31 comes first. */
static int bit_at(v_u32 pattern, int length, int place)
{
    return pattern >> (31 - place % length) & 1;
}

static void fills(void)
{
    v_u32 pattern = 0xF0C00000;
    int x;

    CHECK(VL_BitfillPatTransparent(&cb, display, 1, 0x00FF0000, pattern, 12, 0, 0, 10, 300, 20)
          == VL_SUCCESS);
    CHECK(VL_BitfillPatOpaque(&cb, display, 1, 0x0000FF00, 0x000000FF, pattern, 12, 3, 0, 40, 300,
                              20) == VL_SUCCESS);
    lock(display, 1);
    for (x = 0; x < 300; x++) {
        CHECK(*at16(x, 20) == (bit_at(pattern, 12, x) ? 0xF800 : 0));
        CHECK(*at16(x, 50) == (bit_at(pattern, 12, x + 3) ? 0x07E0 : 0x001F));
    }
    unlock();
}

static void lines(void)
{
    v_kxy a = { 0xFFFFFF, FIX(0.5), FIX(70.5) }, b = { 0xFFFFFF, FIX(300.5), FIX(70.5) };
    int x, on = 0;

    VL_SetPat(&cb, 0xAAAAAAAA);
    VL_SetPatLength(&cb, 2);
    VL_SetPatOffset(&cb, 0);
    VL_SetPatEnable(&cb, V_PAT_ENABLE);
    VL_Line(&cb, V_FIFO_KXY, WORDS(a), WORDS(b));
    VL_SetPatEnable(&cb, V_PAT_DISABLE);
    lock(display, 1);
    for (x = 0; x < 300; x++) {
        on += *at16(x, 70) == 0xFFFF;
        CHECK(x < 2 || *at16(x, 70) == *at16(x - 2, 70));
    }
    unlock();
    CHECK(abs(on - 150) <= 1);
}

/* All sixteen operations of 0xFF00 and 0xF0F0, bit by bit. */
static void operations(void)
{
    v_u32 mode;

    for (mode = 0; mode < 16; mode++) {
        int x = 4 + (int)mode * 19, bit;
        v_u16 p, expected = 0;

        VL_FillBuffer(&cb, display, 1, (v_u32)x, 90, 16, 30, 0xF81F);
        VL_SetALUMode(&cb, mode);
        quad(x, 90, 16, 30, 0xFFFFFF00);
        p = pixel(x + 4, 100);
        for (bit = 0; bit < 16; bit++) {
            int s = 0xFFE0 >> bit & 1, d = 0xF81F >> bit & 1;

            expected |= (v_u16)((mode >> (2 * s + d) & 1) << bit);
        }
        CHECK(p == expected);
    }
    VL_SetALUMode(&cb, V_ALUMODE_SRC);
}

static void plane_mask(void)
{
    VL_FillBuffer(&cb, display, 1, 10, 130, 40, 30, 0x0000);
    VL_SetPMask(&cb, 0x001FF800);
    quad(10, 130, 40, 30, 0xFFFFFFFF);
    CHECK(pixel(20, 140) == 0xF800 || pixel(20, 140) == 0x001F || pixel(20, 140) == 0xF81F);
    VL_SetPMask(&cb, 0xF800F800);
    quad(60, 130, 40, 30, 0xFFFFFFFF);
    CHECK(pixel(70, 140) == 0xF800);
    VL_SetPMask(&cb, 0xFFFFFFFF);
}

static void scissor(void)
{
    VL_SetScissorX(&cb, V_SCISSORX(120, 150));
    VL_SetScissorY(&cb, V_SCISSORY(135, 155));
    quad(110, 130, 60, 40, 0xFF00FF00);
    VL_SetScissorX(&cb, WIDE);
    VL_SetScissorY(&cb, HIGH);
    CHECK(pixel(120, 135) == 0x07E0 && pixel(149, 154) == 0x07E0);
    CHECK(pixel(119, 140) == 0 && pixel(150, 140) == 0);
    CHECK(pixel(130, 134) == 0 && pixel(130, 155) == 0);
}

/* Dithering keeps the mean of 4x4 pixels. */
static void dither(void)
{
    int x, y, sum = 0;

    VL_SetDitherEnable(&cb, V_DITHER_ENABLE);
    quad(180, 130, 64, 40, 0xFF848484);
    VL_SetDitherEnable(&cb, V_DITHER_DISABLE);
    lock(display, 1);
    for (y = 140; y < 144; y++) {
        for (x = 200; x < 204; x++) {
            sum += *at16(x, y) >> 11;
            CHECK(*at16(x, y) == *at16(x + 4, y + 4));
        }
    }
    unlock();
    /* 0x84 is 16.05 of 31 steps. */
    CHECK(abs(sum - 0x84 * 31 * 16 / 255) <= 1);
    VL_SetDitherOffset(&cb, V_DITHEROFFSET(0, 0));
}

static void bgr(void)
{
    VL_SetDstBGR(&cb, V_DSTBGR_ENABLE);
    quad(260, 130, 40, 40, 0xFFFF0000);
    VL_SetDstBGR(&cb, V_DSTBGR_DISABLE);
    CHECK(pixel(270, 140) == 0x001F);
}

int main(void)
{
    open_small();
    VL_SetSrcFunc(&cb, V_SRCFUNC_NOTEXTURE);
    fills();
    lines();
    operations();
    plane_mask();
    scissor();
    dither();
    bgr();
    show();
    return finish();
}
