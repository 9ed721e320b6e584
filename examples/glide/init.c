/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * init.c: the Programming Guide's start-up sequence, step by step: initialise,
 * ask for hardware, select and open a board, clear, swap, shut down. The
 * picture, a test card, is made of clears of ever smaller clip windows.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <glide.h>

static void fill(FxU32 x0, FxU32 y0, FxU32 x1, FxU32 y1, GrColor_t color)
{
    grClipWindow(x0, y0, x1, y1);
    grBufferClear(color, 0, 0);
}

static void draw_test_card(void)
{
    static const GrColor_t bars[8] = {
        0xfff4f1e8, 0xffe8c547, 0xff4fc1c0, 0xff5aa469,
        0xffb565a7, 0xffc8553d, 0xff3f5da8, 0xff20222e
    };
    FxU32 i;

    fill(0, 0, 640, 480, 0xff14161f);
    for (i = 0; i < 8; i++) {
        fill(32 + 72 * i, 32, 104 + 72 * i, 288, bars[i]);
        fill(32 + 72 * i, 296, 104 + 72 * i, 320, bars[7 - i]);
    }
    for (i = 0; i < 64; i++) { /* the grey ramp: shows the dithering */
        fill(32 + 9 * i, 328, 41 + 9 * i, 384, 0xff000000U | (i * 4) * 0x010101U);
    }
    for (i = 0; i < 32; i++) { /* 32 steps of each primary */
        fill(32 + 18 * i, 392, 50 + 18 * i, 408, 0xff000000U | (i * 8) << 16);
        fill(32 + 18 * i, 412, 50 + 18 * i, 428, 0xff000000U | (i * 8) << 8);
        fill(32 + 18 * i, 432, 50 + 18 * i, 448, 0xff000000U | (i * 8));
    }
    grClipWindow(0, 0, 640, 480);
}

int main(int argc, char **argv)
{
    int frames = argc == 3 && strcmp(argv[1], "-n") == 0 ? atoi(argv[2]) : 1;
    GrHwConfiguration hardware;
    char version[80];

    grGlideGetVersion(version);
    printf("Glide %s\n", version);

    grGlideInit();
    if (!grSstQueryHardware(&hardware)) {
        printf("ERROR: no Voodoo Graphics!\n");
        return 1;
    }
    printf("%d board(s); the first has %d MB of frame memory and %d texture unit(s)\n",
           hardware.num_sst, hardware.SSTs[0].sstBoard.VoodooConfig.fbRam,
           hardware.SSTs[0].sstBoard.VoodooConfig.nTexelfx);

    grSstSelect(0);
    if (!grSstWinOpen(0, GR_RESOLUTION_640x480, GR_REFRESH_60Hz,
                      GR_COLORFORMAT_ARGB, GR_ORIGIN_UPPER_LEFT, 2, 1)) {
        printf("ERROR: cannot open 640x480!\n");
        return 1;
    }
    while (frames-- > 0) {
        draw_test_card();
        grBufferSwap(1);
    }
    grGlideShutdown();
    return 0;
}
