/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * common.h: what the example programs of the Raw pipeline share.
 */
#ifndef RAW_COMMON_H
#define RAW_COMMON_H

#include <render_client.h>

/* Frames to draw: the number behind -n, or `usual`. */
static int frames_wanted(int argc, char **argv, int usual)
{
    int i;

    for (i = 1; i + 1 < argc; i++) {
        if (strcmp(argv[i], "-n") == 0) {
            int n = atoi(argv[i + 1]);
            return n > 0 ? n : usual;
        }
    }
    return usual;
}

/* Clears back page and depths. */
static void begin_frame(unsigned red, unsigned green, unsigned blue)
{
    RClearFB(R_PAGE_BACK, red, green, blue);
    RClearZ();
    RBeginScene();
}

/* Ends the scene and shows it. */
static void end_frame(void)
{
    REndScene();
    RFlipPage(1);
}

static void identity(float m[4][4])
{
    int i, j;

    for (i = 0; i < 4; i++) {
        for (j = 0; j < 4; j++) {
            m[i][j] = i == j ? 1.0f : 0.0f;
        }
    }
}

#endif
