/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * depth.c: all comparisons, test and write by themselves, what is stored.
 */
#include "conformance.h"

static int compares(v_u32 mode, int new_z, int stored)
{
    return mode == V_ZBUFMODE_ALWAYS || (mode & 1 && new_z < stored)
           || (mode & 2 && new_z == stored) || (mode & 4 && new_z > stored);
}

/* Three depths against one, without and with writing. */
static void modes(void)
{
    v_u32 mode, write;
    int k, x, y, pass = 0;

    for (write = 0; write < 2; write++) {
        for (mode = 0; mode < 7; mode++) {
            VL_SetZBufMode(&cb, V_ZBUFMODE_ALWAYS);
            VL_SetZBufWrMode(&cb, V_ZBUFWRMODE_ENABLE);
            quad_z(4 + (int)mode * 44, 4 + (int)write * 44, 40, 40, 0x404040, 1000);
            VL_SetZBufMode(&cb, mode);
            VL_SetZBufWrMode(&cb, write);
            for (k = 0; k < 3; k++) {
                quad_z(6 + (int)mode * 44 + k * 12, 10 + (int)write * 44, 10, 28, 0xFFFF00,
                       999 + k);
            }
        }
    }
    issue(verite, cb);
    for (write = 0; write < 2; write++) {
        for (mode = 0; mode < 7; mode++) {
            for (k = 0; k < 3; k++) {
                int passes = compares(mode, 999 + k, 1000);

                x = 10 + (int)mode * 44 + k * 12;
                y = 20 + (int)write * 44;
                CHECK((pixel(x, y) == 0xFFE0) == passes);
                CHECK(depth(x, y) == (passes && write ? 999 + k : 1000));
                pass += passes;
            }
        }
    }
    CHECK(pass > 0);
}

/* Depths are interpolated and the whole part is stored. */
static void gradient(void)
{
    v_kxyz v[3] = { { 0xFFFFFF, FIX(10), FIX(110), 0 },
                    { 0xFF0000, FIX(266), FIX(110), 256u << 16 },
                    { 0x0000FF, FIX(10), FIX(230), 0 } };
    int x;

    VL_SetZBufMode(&cb, V_ZBUFMODE_ALWAYS);
    VL_SetZBufWrMode(&cb, V_ZBUFWRMODE_ENABLE);
    VL_Triangle(&cb, V_FIFO_KXYZ, WORDS(v[0]), WORDS(v[1]), WORDS(v[2]));
    lock(display, 2);
    for (x = 10; x < 230; x += 7) {
        CHECK(abs(*at16(x, 112) - (x - 10)) <= 1);
    }
    unlock();
}

/* What has no depth of its own has the default one; the largest are kept. */
static void defaults(void)
{
    VL_SetZ(&cb, 40000u << 16);
    quad(280, 110, 30, 30, 0xFF00FF00);
    CHECK(depth(290, 120) == 40000);
    quad_z(280, 150, 30, 30, 0xFF00FF, 65535);
    CHECK(depth(290, 160) == 65535);
    VL_SetZBufMode(&cb, V_ZBUFMODE_LT);
    quad_z(280, 190, 30, 30, 0x00FFFF, 65534);
    CHECK(pixel(290, 200) == 0x07FF);
    VL_SetZBufMode(&cb, V_ZBUFMODE_ALWAYS);
    VL_SetZBufWrMode(&cb, V_ZBUFWRMODE_DISABLE);
}

int main(void)
{
    open_small();
    VL_SetSrcFunc(&cb, V_SRCFUNC_NOTEXTURE);
    modes();
    gradient();
    defaults();
    show();
    return finish();
}
