/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * flips.c: several flips in one command buffer; each shows a frame. Given an
 * argument, every flip is issued on its own, which shows the same frames.
 */
#include "conformance.h"

int main(int argc, char **argv)
{
    static const v_u32 colors[] = { 0xFFFF0000, 0xFF00FF00, 0xFF0000FF };
    int i;

    (void)argv;
    open_small();
    VL_SetSrcFunc(&cb, V_SRCFUNC_NOTEXTURE);
    for (i = 0; i < 3; i++) {
        quad(20 + 90 * i, 30, 80, 120, colors[i]);
        CHECK(VL_SwapDisplaySurface(&cb, display) == VL_SUCCESS);
        /* Without a wait between them the chip shows one after another, too. */
        if (i != 1) {
            CHECK(VL_WaitForDisplaySwitch(&cb) == VL_SUCCESS);
        }
        /* Drawn after the flip, and so part of the next frame. */
        quad(20 + 90 * i, 160, 40, 40, 0xFFFFFF00);
        if (argc > 1) {
            issue(verite, cb);
        }
    }
    issue(verite, cb);
    CHECK(pixel(25, 35) == 0 && pixel(115, 35) == 0x07E0 && pixel(205, 35) == 0);
    return finish();
}
