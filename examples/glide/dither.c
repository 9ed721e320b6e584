/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * dither.c: from 24 bits to 16. The same picture without dithering, with the
 * 2x2 and with the 4x4 pattern, and below each a magnified piece of it, read
 * back from the frame buffer, with the contrast raised.
 */
#include "common.h"

#define ZOOM   10
#define SAMPLE 20

static void draw_sphere(float x, float y, float radius)
{
    int ring, i;

    for (ring = 0; ring < 24; ring++) {
        for (i = 0; i < 48; i++) {
            GrVertex q[4];
            int k;
            for (k = 0; k < 4; k++) {
                float r = (float)(ring + (k == 1 || k == 2)) / 24.0f;
                float b = 2.0f * PI * (float)(i + (k >= 2)) / 48.0f;
                float nx = r * cosine(b), ny = r * sine(b), nz = sqrtf(1.0f - r * r);
                float sun = clampf(-0.5f * nx - 0.6f * ny + 0.62f * nz, 0.0f, 1.0f);
                q[k] = vertex(x + radius * nx, y + radius * ny,
                              rgb(0.05f + 0.80f * sun, 0.09f + 0.42f * sun, 0.17f + 0.28f * sun));
            }
            draw_quad(&q[0], &q[1], &q[2], &q[3]);
        }
    }
}

static void draw_picture(float x0)
{
    shade_rectangle(x0, 0, x0 + 213.0f, 236, rgb(0.05f, 0.07f, 0.14f), rgb(0.20f, 0.27f, 0.36f));
    draw_sphere(x0 + 106.0f, 118.0f, 84.0f);
    shade_rectangle(x0 + 8.0f, 216, x0 + 205.0f, 228, rgb(0.25f, 0.25f, 0.28f), rgb(0.05f, 0.05f, 0.08f));
}

static Color unpack_565(FxU16 pixel)
{
    return rgb((float)(pixel >> 11) / 31.0f, (float)(pixel >> 5 & 63) / 63.0f,
               (float)(pixel & 31) / 31.0f);
}

/* Three times the contrast around a mean colour. */
static Color contrast(Color c, Color mean)
{
    return rgb(mean.r + 3.0f * (c.r - mean.r), mean.g + 3.0f * (c.g - mean.g),
               mean.b + 3.0f * (c.b - mean.b));
}

/* Magnifies a SAMPLE x SAMPLE square of the back buffer, with a frame. */
static void magnify(int from_x, int from_y, int to_x, int to_y)
{
    FxU16 pixels[SAMPLE * SAMPLE];
    Color mean;
    int x, y;

    memset(pixels, 0, sizeof pixels);
    if (!grLfbReadRegion(GR_BUFFER_BACKBUFFER, (FxU32)from_x, (FxU32)from_y,
                         SAMPLE, SAMPLE, SAMPLE * 2, pixels)) {
        fprintf(stderr, "cannot read the back buffer\n");
        exit(1);
    }
    mean = unpack_565(pixels[SAMPLE * SAMPLE / 2 + SAMPLE / 2]);
    for (y = 0; y < SAMPLE; y++) {
        for (x = 0; x < SAMPLE; x++) {
            Color c = contrast(unpack_565(pixels[y * SAMPLE + x]), mean);
            shade_rectangle((float)(to_x + ZOOM * x), (float)(to_y + ZOOM * y),
                            (float)(to_x + ZOOM * (x + 1)), (float)(to_y + ZOOM * (y + 1)), c, c);
        }
    }
}

static void frame_square(float x, float y, float size)
{
    GrVertex a = vertex(x, y, rgb(1.0f, 0.9f, 0.5f)), b = a, c = a, d = a;

    b.x += size;
    c.x += size;
    c.y += size;
    d.y += size;
    grDrawLine(&a, &b);
    grDrawLine(&b, &c);
    grDrawLine(&c, &d);
    grDrawLine(&d, &a);
}

int main(int argc, char **argv)
{
    static const GrDitherMode_t modes[3] = {GR_DITHER_DISABLE, GR_DITHER_2x2, GR_DITHER_4x4};
    int frames = frames_wanted(argc, argv, 1), frame, i;

    open_screen(GR_ORIGIN_UPPER_LEFT);
    use_vertex_colors();
    for (frame = 0; frame < frames; frame++) {
        grClipWindow(0, 0, SCREEN_WIDTH, SCREEN_HEIGHT);
        grDitherMode(GR_DITHER_DISABLE);
        grBufferClear(0xff10121a, 0, 0);
        for (i = 0; i < 3; i++) {
            FxU32 x0 = (FxU32)(214 * i);

            grClipWindow(x0, 0, x0 + 212, 236);
            grDitherMode(modes[i]);
            draw_picture((float)x0);
            grClipWindow(0, 0, SCREEN_WIDTH, SCREEN_HEIGHT);
            grDitherMode(GR_DITHER_DISABLE);
            magnify((int)x0 + 116, 128, (int)x0 + 6, 256);
            frame_square((float)x0 + 115.5f, 127.5f, SAMPLE + 1.0f);
        }
        grBufferSwap(1);
    }
    grGlideShutdown();
    return 0;
}
