/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * demo0: pixel drawing. The palette pixel by pixel: 256 base colours as a
 * chart, the 32 intensities of some of them as ramps, and a star field that
 * moves. PutPixel, COLOR_RGB, COLOR_I, FlushFB.
 */
#include "common.h"

struct Star
{
    int x, y, z;
};

static void fill(CVGpu *Gpu, int x, int y, int width, int height, int color)
{
    for (int row = 0; row < height; row++) {
        for (int column = 0; column < width; column++) {
            Gpu->PutPixel(x + column, y + row, color);
        }
    }
}

/* 16x16 cells, one for each base colour. */
static void draw_chart(CVGpu *Gpu)
{
    for (int base = 0; base < 256; base++) {
        fill(Gpu, 56 + base % 16 * 8, 20 + base / 16 * 8, 7, 7, base | COLOR_I(255));
    }
}

/* Every one of the 8192 colours: a column for each base colour, a row for each
 * intensity; the chart in miniature. */
static void draw_all(CVGpu *Gpu)
{
    for (int color = 0; color < 8192; color++) {
        Gpu->PutPixel(color % 256 * 15 / 16, 160 + color / 256, color);
    }
}

/* Ramps from dark to bright. */
static void draw_ramps(CVGpu *Gpu)
{
    static const int colors[6] = {
        COLOR_RGB(255, 0, 0),   COLOR_RGB(255, 255, 0), COLOR_RGB(0, 255, 0),
        COLOR_RGB(0, 255, 255), COLOR_RGB(0, 0, 255),   COLOR_RGB(255, 0, 255)};

    for (int i = 0; i < 6; i++) {
        for (int intensity = 0; intensity < 32; intensity++) {
            fill(Gpu, 8 + intensity * 7, 198 + i * 7, 7, 6, colors[i] | COLOR_I(intensity * 8));
        }
    }
}

static void move_star(Star *star, unsigned int *seed)
{
    star->z -= 12;
    if (star->z < 64) {
        star->x = next_random(seed) % 2000 - 1000;
        star->y = next_random(seed) % 640 - 320;
        star->z += 900;
    }
}

int main(int argc, char **argv)
{
    static CVGpu Gpu;
    static Star stars[300];
    unsigned int seed = 1;
    int frames = frames_wanted(argc, argv, 30);

    start(&Gpu);
    for (int i = 0; i < 300; i++) {
        stars[i].z = 0;
        move_star(&stars[i], &seed);
        stars[i].z = 64 + next_random(&seed) % 900;
    }
    for (int frame = 0; frame < frames; frame++) {
        draw_chart(&Gpu);
        draw_all(&Gpu);
        draw_ramps(&Gpu);
        for (int i = 0; i < 300; i++) {
            int x = SCR_X / 2 + stars[i].x * 100 / stars[i].z;
            int y = 280 + stars[i].y * 12 / stars[i].z;
            int light = 255 - stars[i].z / 4;
            if (y >= 244 && y < SCR_Y) {
                Gpu.PutPixel(x, y, COLOR_RGB(255, 255, 255) | COLOR_I(light));
                Gpu.PutPixel(x + 1, y, COLOR_RGB(255, 255, 255) | COLOR_I(light / 2));
            }
            move_star(&stars[i], &seed);
        }
        end_frame(&Gpu, frame, "Pixels", 0);
    }
    Gpu.Delete();
    return 0;
}
