/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * htri2: the triangle in a window, on the full screen, and back after another
 * program had the chip. Source: RR, "Switching between full-screen and
 * windowed mode".
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
    Program program = { V_WINDOWED_APP, 0, NULL, set_state, NULL, draw, "..a.lra." };

    return run(&program, argc, argv);
}
