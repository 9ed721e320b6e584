/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * htri5: an opaque triangle and a half transparent one over it, by the alpha
 * of their texels. Source: RR, "Alpha blending".
 */
#include "common.h"

static v_surface *textures[2];

static void load(void)
{
    textures[0] = make_texture(make_checker(128, 256, 16, 32, 0xF0F0, 0xF00F), V_PIXFMT_4444, 128,
                               256);
    textures[1] = make_texture(make_checker(200, 100, 10, 10, 0x7F00, 0x7FFF), V_PIXFMT_4444, 200,
                               100);
    VL_SetSurfaceClamp(textures[0], V_UCLAMP_DISABLE, V_VCLAMP_DISABLE);
    VL_SetSurfaceClamp(textures[1], V_UCLAMP_ENABLE, V_VCLAMP_ENABLE);
    VL_SetSurfaceColorPad(textures[0], 1);
    VL_SetSurfaceColorPad(textures[1], 1);
}

static void set_state(void)
{
    VL_SetSrcFunc(&cmdbuffer, V_SRCFUNC_REPLACE);
    VL_SetBlendEnable(&cmdbuffer, V_BLEND_ENABLE);
    VL_SetBlendSrcFunc(&cmdbuffer, V_BLENDSRCALPHA);
    VL_SetBlendDstFunc(&cmdbuffer, V_BLENDSRCALPHAINV);
    set_filter();
}

static void draw(void)
{
    v_xyuv a[3] = {
        { FIX(100.0), FIX(100.0), FIX(0.0), FIX(0.0) },
        { FIX(500.0), FIX(100.0), FIX(2.0), FIX(0.0) },
        { FIX(100.0), FIX(300.0), FIX(0.0), FIX(2.0) },
    };
    v_xyuv b[3] = {
        { FIX(200.0), FIX(150.0), FIX(0.0), FIX(0.0) },
        { FIX(600.0), FIX(150.0), FIX(2.0), FIX(0.0) },
        { FIX(200.0), FIX(350.0), FIX(0.0), FIX(2.0) },
    };

    VL_InstallTextureMap(&cmdbuffer, textures[0]);
    VL_Triangle(&cmdbuffer, V_FIFO_XYUV, (v_u32 *)&a[0], (v_u32 *)&a[1], (v_u32 *)&a[2]);
    VL_InstallTextureMap(&cmdbuffer, textures[1]);
    VL_Triangle(&cmdbuffer, V_FIFO_XYUV, (v_u32 *)&b[0], (v_u32 *)&b[1], (v_u32 *)&b[2]);
}

int main(int argc, char **argv)
{
    Program program = { V_WINDOWED_APP, 0, load, set_state, NULL, draw, ".f.a.f" };

    return run(&program, argc, argv);
}
