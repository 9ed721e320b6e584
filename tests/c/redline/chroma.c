/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * chroma.c: texels that are left out by their colour, and fragments by their
 * alpha.
 */
#include "conformance.h"

/* Stripes of the key and of another colour, four texels wide. */
static v_surface *stripes(v_u16 key, v_u16 other)
{
    v_u16 data[32 * 32];
    int i;

    for (i = 0; i < 32 * 32; i++) {
        data[i] = i % 8 < 4 ? key : other;
    }
    return texture(V_PIXFMT_565, 32, 32, 64, data);
}

static void keyed(void)
{
    v_surface *surface = stripes(0x07E0, 0xF800);

    CHECK(VL_SetSurfaceChromaColor(surface, 0x07E0) == VL_SUCCESS);
    CHECK(VL_SetSurfaceChromaMask(surface, 0xFFFF) == VL_SUCCESS);
    quad(0, 0, 320, 80, 0xFF0000FF);
    VL_SetSrcFunc(&cb, V_SRCFUNC_REPLACE);
    VL_InstallTextureMap(&cb, surface);
    quad_uv(10, 10, 64, 64, 0.0, 0.0, 1.0, 1.0);
    CHECK(VL_SetSurfaceChromaKey(surface, 1) == VL_SUCCESS);
    VL_SetTranspReject(&cb, V_TRANSPREJECT_ENABLE);
    VL_InstallTextureMap(&cb, surface);
    quad_uv(90, 10, 64, 64, 0.0, 0.0, 1.0, 1.0);
    CHECK(pixel(12, 20) == 0x07E0 && pixel(20, 20) == 0xF800);
    CHECK(pixel(92, 20) == 0x001F && pixel(100, 20) == 0xF800);
    /* A mask compares some bits only. */
    CHECK(VL_SetSurfaceChromaColor(surface, 0x07C0) == VL_SUCCESS);
    VL_InstallTextureMap(&cb, surface);
    quad_uv(170, 10, 64, 64, 0.0, 0.0, 1.0, 1.0);
    CHECK(VL_SetSurfaceChromaMask(surface, 0x07C0) == VL_SUCCESS);
    VL_InstallTextureMap(&cb, surface);
    quad_uv(245, 10, 64, 64, 0.0, 0.0, 1.0, 1.0);
    CHECK(pixel(172, 20) == 0x07E0);
    CHECK(pixel(247, 20) == 0x001F && pixel(255, 20) == 0xF800);
    VL_SetChromaKey(&cb, V_CHROMAKEY_DISABLE);
    VL_SetTranspReject(&cb, V_TRANSPREJECT_DISABLE);
    CHECK(VL_DestroySurface(verite, surface) == VL_SUCCESS);
}

/* A rejected texel leaves the depth as well. */
static void key_and_depth(void)
{
    v_surface *surface = stripes(0x0000, 0xFFFF);

    VL_SetSrcFunc(&cb, V_SRCFUNC_REPLACE);
    surface->chromakey = 1;
    VL_SetTranspReject(&cb, V_TRANSPREJECT_ENABLE);
    VL_SetZ(&cb, 500u << 16);
    VL_SetZBufWrMode(&cb, V_ZBUFWRMODE_ENABLE);
    VL_InstallTextureMap(&cb, surface);
    quad_uv(10, 100, 64, 64, 0.0, 0.0, 1.0, 1.0);
    VL_SetZBufWrMode(&cb, V_ZBUFWRMODE_DISABLE);
    CHECK(depth(12, 110) == 0xFFFF && depth(20, 110) == 500);
    VL_SetChromaKey(&cb, V_CHROMAKEY_DISABLE);
    CHECK(VL_DestroySurface(verite, surface) == VL_SUCCESS);
}

/* Alpha from 0 to 255 across, with rising thresholds. */
static void threshold(void)
{
    int i;

    VL_SetSrcFunc(&cb, V_SRCFUNC_NOTEXTURE);
    VL_SetTranspReject(&cb, V_TRANSPREJECT_ENABLE);
    for (i = 0; i < 4; i++) {
        v_axy v[4];
        int k;

        for (k = 0; k < 4; k++) {
            v[k].a = k & 1 ? 256 << 16 : 0;
            v[k].x = FIX(100 + (k & 1 ? 128 : 0));
            v[k].y = FIX(100 + i * 30 + (k & 2 ? 26 : 0));
        }
        VL_SetFGColorARGB(&cb, 0xFFFFFF00);
        CHECK(VL_SetAlphaThreshold(&cb, (v_u8)(i * 64)) == VL_SUCCESS);
        VL_Tristrip(&cb, V_FIFO_AXY, 2, WORDS(v));
    }
    for (i = 1; i < 4; i++) {
        CHECK(pixel(100 + i * 32 - 3, 110 + i * 30) == 0);
        CHECK(pixel(100 + i * 32 + 3, 110 + i * 30) == 0xFFE0);
    }
    VL_SetTranspReject(&cb, V_TRANSPREJECT_DISABLE);
}

int main(void)
{
    open_small();
    VL_SetSrcFunc(&cb, V_SRCFUNC_NOTEXTURE);
    keyed();
    key_and_depth();
    threshold();
    show();
    return finish();
}
