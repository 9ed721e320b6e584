/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * htri4: the triangles of htri3 with depth, so that the one drawn first is in
 * front, and with perspective. Source: RR, "Z buffering and perspective
 * correction".
 */
#include "common.h"

static v_surface *textures[2];

static void load(void)
{
    textures[0] = make_texture(make_checker(128, 256, 16, 32, 0x07E0, 0x001F), V_PIXFMT_565, 128,
                               256);
    textures[1] = make_texture(make_checker(200, 100, 10, 10, 0xF81F, 0x07FF), V_PIXFMT_565, 200,
                               100);
    VL_SetSurfaceClamp(textures[0], V_UCLAMP_DISABLE, V_VCLAMP_DISABLE);
    VL_SetSurfaceClamp(textures[1], V_UCLAMP_ENABLE, V_VCLAMP_ENABLE);
}

static void set_state(void)
{
    VL_SetSrcFunc(&cmdbuffer, V_SRCFUNC_REPLACE);
    VL_SetZBufMode(&cmdbuffer, V_ZBUFMODE_LT);
    VL_SetZBufWrMode(&cmdbuffer, V_ZBUFWRMODE_ENABLE);
    set_filter();
}

static void draw(void)
{
    v_xyzuvq a[3] = {
        { FIX(100.0), FIX(100.0), FIX(2.0), FIX(0.0), FIX(0.0), QFIX(1.0 / 2.0) },
        { FIX(500.0), FIX(100.0), FIX(4.0), FIX(2.0), FIX(0.0), QFIX(1.0 / 4.0) },
        { FIX(100.0), FIX(300.0), FIX(2.0), FIX(0.0), FIX(2.0), QFIX(1.0 / 2.0) },
    };
    v_xyzuvq b[3] = {
        { FIX(200.0), FIX(150.0), FIX(6.0), FIX(0.0), FIX(0.0), QFIX(1.0 / 3.0) },
        { FIX(600.0), FIX(150.0), FIX(8.0), FIX(2.0), FIX(0.0), QFIX(1.0 / 5.0) },
        { FIX(200.0), FIX(350.0), FIX(6.0), FIX(0.0), FIX(2.0), QFIX(1.0 / 3.0) },
    };

    VL_InstallTextureMap(&cmdbuffer, textures[0]);
    VL_Triangle(&cmdbuffer, V_FIFO_XYZUVQ, (v_u32 *)&a[0], (v_u32 *)&a[1], (v_u32 *)&a[2]);
    VL_InstallTextureMap(&cmdbuffer, textures[1]);
    VL_Triangle(&cmdbuffer, V_FIFO_XYZUVQ, (v_u32 *)&b[0], (v_u32 *)&b[1], (v_u32 *)&b[2]);
}

int main(int argc, char **argv)
{
    Program program = { V_WINDOWED_APP, 1, load, set_state, NULL, draw, ".f.a.f" };

    return run(&program, argc, argv);
}
