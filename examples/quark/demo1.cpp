/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * demo1: lines drawing. A turning star of lines with a depth at each end,
 * over two crossing fans of which the nearer hides the other.
 * DrawLine, LineState.
 */
#include "common.h"

static const int SPOKES = 64;

/* A star whose spokes end at different distances: it is a tilted cone. */
static void draw_star(CVGpu *Gpu, int turn)
{
    int center[3] = {SCR_X / 2, 120, 300};

    for (int i = 0; i < SPOKES; i++) {
        int angle = i * ANGLE2PI / SPOKES + turn;
        int end[3];
        end[0] = center[0] + (100 * COSINUS(angle) >> TRIGO_SHIFT);
        end[1] = center[1] + (100 * SINUS(angle) >> TRIGO_SHIFT);
        end[2] = 300 + (200 * SINUS(angle - turn) >> TRIGO_SHIFT);
        Gpu->LineState.DrawColor = COLOR_RGB(255, i * 4, 255 - i * 4);
        Gpu->LineState.DrawIntensity = (unsigned char)(i % 2 ? 255 : 140);
        Gpu->DrawLine(center, end);
    }
}

/* Lines in parallel from left to right, near at one side. */
static void draw_fan(CVGpu *Gpu, int color, int left, int right, int slope)
{
    Gpu->LineState.DrawColor = (unsigned char)color;
    Gpu->LineState.DrawIntensity = 255;
    for (int i = 0; i < 30; i++) {
        int a[3] = {20, 236 + i + (slope < 0 ? 50 : 0), left};
        int b[3] = {220, 236 + i + (slope > 0 ? 50 : 0), right};
        Gpu->DrawLine(a, b);
    }
}

int main(int argc, char **argv)
{
    static CVGpu Gpu;
    int frames = frames_wanted(argc, argv, 30);

    start(&Gpu);
    for (int frame = 0; frame < frames; frame++) {
        draw_star(&Gpu, frame * 40);
        /* Each band is in front on one side: they cut through each other. */
        draw_fan(&Gpu, COLOR_RGB(0, 220, 0), 100, 1000, 1);
        draw_fan(&Gpu, COLOR_RGB(255, 170, 0), 1000, 100, -1);
        end_frame(&Gpu, frame, "Lines", 0);
    }
    Gpu.Delete();
    return 0;
}
