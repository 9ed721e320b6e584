/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * fog.c: fog of vertices and of the default, over colours and textures.
 */
#include "conformance.h"

static void ramps(void)
{
    int k, i;

    VL_SetFogEnable(&cb, V_FOG_ENABLE);
    VL_SetFogColorRGB(&cb, 0x00FF8040);
    for (k = 0; k < 2; k++) {
        v_kfxy v[4];

        for (i = 0; i < 4; i++) {
            v[i].rgb = k ? 0xFFFFFF : 0x0000FF;
            v[i].f = i & 1 ? 255 << 16 : 0;
            v[i].x = FIX(32 + (i & 1 ? 256 : 0));
            v[i].y = FIX(10 + k * 50 + (i & 2 ? 40 : 0));
        }
        CHECK(VL_Tristrip(&cb, V_FIFO_KFXY, 2, WORDS(v)) == VL_SUCCESS);
    }
    for (i = 8; i < 256; i += 16) {
        CHECK(near_rgb(pixel(32 + i, 20), 255 * (255 - i) / 255, 0x80 * (255 - i) / 255,
                       (0x40 * (255 - i) + 255 * i) / 255, 10));
        CHECK(near_rgb(pixel(32 + i, 70), 255, (0x80 * (255 - i) + 255 * i) / 255,
                       (0x40 * (255 - i) + 255 * i) / 255, 10));
    }
}

static void defaults(void)
{
    static const int factors[4] = { 0, 100, 200, 255 };
    int i;

    VL_SetFogColorBGR(&cb, 0x00FF0000);
    for (i = 0; i < 4; i++) {
        VL_SetF(&cb, (v_u32)factors[i] << 16);
        quad(10 + i * 40, 120, 36, 36, 0xFFFF0000);
        CHECK(near_rgb(pixel(20 + i * 40, 130), factors[i], 0, 255 - factors[i], 9));
    }
    VL_SetFogEnable(&cb, V_FOG_DISABLE);
    VL_SetF(&cb, 0);
    quad(10 + 4 * 40, 120, 36, 36, 0xFFFF0000);
    CHECK(pixel(180, 130) == 0xF800);
}

/* Fog comes after the source function and leaves alpha alone. */
static void over_textures(void)
{
    v_u32 data[16], i;
    v_surface *surface;

    for (i = 0; i < 16; i++) {
        data[i] = 0x80FF0000;
    }
    surface = texture(V_PIXFMT_8888, 4, 4, 16, data);
    VL_InstallTextureMap(&cb, surface);
    VL_SetSrcFunc(&cb, V_SRCFUNC_REPLACE);
    VL_SetFogEnable(&cb, V_FOG_ENABLE);
    VL_SetFogColorRGB(&cb, 0x0000FF00);
    VL_SetF(&cb, 128 << 16);
    quad_uv(10, 170, 40, 40, 0.0, 0.0, 1.0, 1.0);
    VL_SetBlendEnable(&cb, V_BLEND_ENABLE);
    VL_SetBlendSrcFunc(&cb, V_BLENDSRCALPHA);
    VL_SetBlendDstFunc(&cb, V_BLEND0);
    quad_uv(60, 170, 40, 40, 0.0, 0.0, 1.0, 1.0);
    CHECK(near_rgb(pixel(20, 180), 128, 127, 0, 9));
    CHECK(near_rgb(pixel(70, 180), 64, 64, 0, 9));
    VL_SetFogEnable(&cb, V_FOG_DISABLE);
    CHECK(VL_DestroySurface(verite, surface) == VL_SUCCESS);
}

int main(void)
{
    open_small();
    VL_SetSrcFunc(&cb, V_SRCFUNC_NOTEXTURE);
    ramps();
    defaults();
    over_textures();
    show();
    return finish();
}
