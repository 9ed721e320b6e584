/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * ordertest.c: thirteen overlapping triangles, opaque and transparent by turns.
 * On sixteen tiles they are drawn by four pipelines at once; the picture must
 * be the one that a single tile draws. The last frame is magnified.
 */
#include "common.h"

static const unsigned colors[13] = {
    0xff0000ffu, 0x00ff00ffu, 0x0000ff88u, 0xff00ffffu, 0xffff00ffu, 0x00ffff88u, 0xffffff88u,
    0xff0000ffu, 0x00ff00ffu, 0x0000ffffu, 0xff00ff88u, 0xffff0088u, 0x00ffff88u
};

static void draw(void)
{
    int k;

    for (k = 0; k < 13; k++) {
        float x = -0.8f + 0.1f * (float)k;
        RBeginPrim();
        RColorRGBA(colors[k]);
        RVertex(x, -0.2f, 0.0f, 0.0f, 0.0f);
        RVertex(x + 0.2f, 0.0f, 0.5f, 0.0f, 0.0f);
        RVertex(x, 0.2f, 0.0f, 0.0f, 0.0f);
        REndPrim();
    }
}

int main(int argc, char **argv)
{
    int n = frames_wanted(argc, argv, 2), i;
    float m[4][4];

    RInit();
    RReset();
    for (i = 0; i < n; i++) {
        identity(m);
        if (i > 0) {
            m[0][0] = 1.2f;
            m[1][1] = 3.6f;
            m[0][3] = 0.12f;
        }
        RModelMatrix(m);
        begin_frame(0x28, 0x28, 0x28);
        draw();
        end_frame();
    }
    return 0;
}
