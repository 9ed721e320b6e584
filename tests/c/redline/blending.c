/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * blending.c: every pair of factors, the constant destination, source
 * functions.
 */
#include "conformance.h"

static const int destination[3] = { 0x84, 0x41, 0xC6 };
static const v_u32 source = 0x80C8A042;

/* Factor times 255 of channel c. Values 0 and 1 are the other's colour. */
static double factor(v_u32 f, int is_source, int c)
{
    double s[4] = { 0xC8, 0xA0, 0x42, 0x80 }, d[4] = { 0x84, 0x41, 0xC6, 255 };

    switch (f) {
    case 0: return is_source ? d[c] : s[c];
    case 1: return 255 - (is_source ? d[c] : s[c]);
    case V_BLENDSRCALPHA: return s[3];
    case V_BLENDSRCALPHAINV: return 255 - s[3];
    case V_BLENDDSTALPHA: return d[3];
    case V_BLENDDSTALPHAINV: return 255 - d[3];
    case V_BLEND0: return 0;
    case V_BLEND1: return 255;
    case V_BLENDSRCALPHASAT: return 0;    /* the destination's alpha is 255 */
    default: return 255;
    }
}

static int expected(v_u32 bs, v_u32 bd, int c)
{
    int s[3] = { 0xC8, 0xA0, 0x42 };
    double sum = (s[c] * factor(bs, 1, c) + destination[c] * factor(bd, 0, c)) / 255.0;

    return sum > 255.0 ? 255 : (int)sum;
}

static void all_pairs(void)
{
    v_u32 bs, bd;

    for (bs = 0; bs < 10; bs++) {
        for (bd = 0; bd < 8; bd++) {
            int x = 4 + (int)bs * 22, y = 4 + (int)bd * 22;

            VL_SetBlendEnable(&cb, V_BLEND_DISABLE);
            quad(x, y, 20, 20, 0xFF8441C6);
            VL_SetBlendEnable(&cb, V_BLEND_ENABLE);
            CHECK(VL_SetBlendSrcFunc(&cb, bs) == VL_SUCCESS);
            CHECK(VL_SetBlendDstFunc(&cb, bd) == VL_SUCCESS);
            quad(x, y, 20, 20, source);
        }
    }
    for (bs = 0; bs < 10; bs++) {
        for (bd = 0; bd < 8; bd++) {
            v_u16 p = pixel(10 + (int)bs * 22, 10 + (int)bd * 22);
            int right = near_rgb(p, expected(bs, bd, 0), expected(bs, bd, 1), expected(bs, bd, 2),
                                 10);

            if (!right) {
                printf("source %u, destination %u\n", bs, bd);
            }
            CHECK(right);
        }
    }
    CHECK(VL_SetBlendDstFunc(&cb, V_BLENDSRCALPHASAT) == VL_PARAM_ERROR);
    CHECK(vl_told_once(VL_R_SetBlendDstFunc, VL_PARAM_ERROR));
}

/* Without reading the destination a constant takes its place. */
static void constant_destination(void)
{
    VL_SetBlendSrcFunc(&cb, V_BLEND1);
    VL_SetBlendDstFunc(&cb, V_BLENDSRCALPHA);
    VL_SetDstRdDisable(&cb, V_DSTRD_DISABLE);
    VL_SetDstColorARGB(&cb, 0xFFFF0000);
    quad(230, 4, 40, 40, 0x80004000);
    CHECK(near_rgb(pixel(240, 10), 128, 64, 0, 8));
    VL_SetDstColorABGR(&cb, 0xFFFF0000);
    quad(274, 4, 40, 40, 0x80004000);
    CHECK(near_rgb(pixel(280, 10), 0, 64, 128, 8));
    VL_SetDstRdDisable(&cb, V_DSTRD_ENABLE);
}

/* REPLACE, DECAL and MODULATE of a half transparent texel and a colour. */
static void source_functions(void)
{
    v_u32 data[16], i;
    v_surface *surface;
    v_u16 p;

    for (i = 0; i < 16; i++) {
        data[i] = 0x8000FF00;
    }
    surface = texture(V_PIXFMT_8888, 4, 4, 16, data);
    VL_InstallTextureMap(&cb, surface);
    VL_SetBlendEnable(&cb, V_BLEND_DISABLE);
    for (i = V_SRCFUNC_NOTEXTURE; i <= V_SRCFUNC_MODULATE; i++) {
        VL_SetSrcFunc(&cb, i);
        VL_SetFGColorARGB(&cb, 0xFFC08000);
        quad_uv(230 + (int)i * 20, 60, 18, 40, 0.0, 0.0, 1.0, 1.0);
    }
    CHECK(near_rgb(pixel(235, 70), 0xC0, 0x80, 0, 8));
    CHECK(near_rgb(pixel(255, 70), 0, 0xFF, 0, 8));
    p = pixel(275, 70);
    CHECK(near_rgb(p, 0xC0 / 2, (0x80 + 0xFF) / 2, 0, 10));
    CHECK(near_rgb(pixel(295, 70), 0, 0x80, 0, 8));
    /* The alpha of each: that of the vertex, the texel, the vertex, both. */
    VL_SetBlendEnable(&cb, V_BLEND_ENABLE);
    VL_SetBlendSrcFunc(&cb, V_BLENDSRCALPHA);
    VL_SetBlendDstFunc(&cb, V_BLEND0);
    for (i = V_SRCFUNC_NOTEXTURE; i <= V_SRCFUNC_MODULATE; i++) {
        VL_SetSrcFunc(&cb, i);
        VL_SetFGColorARGB(&cb, 0x80FFFFFF);
        quad_uv(230 + (int)i * 20, 110, 18, 40, 0.0, 0.0, 1.0, 1.0);
    }
    CHECK(near_rgb(pixel(235, 120), 128, 128, 128, 8));
    CHECK(near_rgb(pixel(255, 120), 0, 128, 0, 8));
    CHECK(near_rgb(pixel(275, 120), 64, 128, 64, 10));
    CHECK(near_rgb(pixel(295, 120), 0, 64, 0, 8));
    CHECK(VL_DestroySurface(verite, surface) == VL_SUCCESS);
}

int main(void)
{
    open_small();
    VL_SetSrcFunc(&cb, V_SRCFUNC_NOTEXTURE);
    all_pairs();
    constant_destination();
    source_functions();
    show();
    return finish();
}
