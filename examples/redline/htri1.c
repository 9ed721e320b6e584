/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * htri1: one red triangle on the full screen. Source: RR, "Hello Triangle".
 */
#include "common.h"

static void set_state(void)
{
    VL_SetSrcFunc(&cmdbuffer, V_SRCFUNC_NOTEXTURE);
}

static void draw(void)
{
    v_xy a = { FIX(100.0), FIX(100.0) };
    v_xy b = { FIX(400.0), FIX(100.0) };
    v_xy c = { FIX(250.0), FIX(300.0) };

    VL_SetFGColorARGB(&cmdbuffer, ARGB(255, 255, 0, 0));
    VL_Triangle(&cmdbuffer, V_FIFO_XY, (v_u32 *)&a, (v_u32 *)&b, (v_u32 *)&c);
}

int main(int argc, char **argv)
{
    Program program = { V_FULLSCREEN_APP, 0, NULL, set_state, NULL, draw, "..." };

    return run(&program, argc, argv);
}
