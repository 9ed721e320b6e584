/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * htri3: two textured triangles, one repeating its texture, one clamping it.
 * Source: RR, "Drawing a texture mapped triangle".
 */
#include "common.h"

static v_memory pictures[2];
static v_surface *textures[2];

static void load(void)
{
    pictures[0] = make_checker(128, 256, 16, 32, 0x07E0, 0x001F);
    pictures[1] = make_checker(200, 100, 10, 10, 0xF81F, 0x07FF);
    textures[0] = make_texture(pictures[0], V_PIXFMT_565, 128, 256);
    textures[1] = make_texture(pictures[1], V_PIXFMT_565, 200, 100);
    VL_SetSurfaceClamp(textures[0], V_UCLAMP_DISABLE, V_VCLAMP_DISABLE);
    VL_SetSurfaceClamp(textures[1], V_UCLAMP_ENABLE, V_VCLAMP_ENABLE);
}

static void restore(void)
{
    int i;

    for (i = 0; i < 2; i++) {
        VL_RestoreSurface(verite, textures[i]);
        VL_LoadBuffer(&cmdbuffer, textures[i], 0, textures[i]->width * 2, textures[i]->width,
                      textures[i]->height, pictures[i], NULL);
    }
}

static void set_state(void)
{
    VL_SetSrcFunc(&cmdbuffer, V_SRCFUNC_REPLACE);
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
    Program program = { V_WINDOWED_APP, 0, load, set_state, restore, draw, ".f.a.fa.lrf" };

    return run(&program, argc, argv);
}
