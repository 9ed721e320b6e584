/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * lfb.c: writing pixels straight into the frame buffer. A Julia set is
 * computed and stored through a write lock, row by row, then read back
 * through a read lock and compared. Fails (exit code 1) if a pixel differs.
 */
#include "common.h"

static FxU16 picture[SCREEN_HEIGHT][SCREEN_WIDTH];

/* Smoothed number of steps until z*z + c leaves the circle; 0 when it stays. */
static float escape_time(double x, double y, double cx, double cy)
{
    int i;

    for (i = 1; i < 220; i++) {
        double xx = x * x, yy = y * y;
        if (xx + yy > 64.0) {
            /* 1 at radius 8, 0 at radius 64: close to the usual log log. */
            double r = sqrt(xx + yy), part = (64.0 - r) / 56.0;
            return (float)i + (float)(part * part);
        }
        y = 2.0 * x * y + cy;
        x = xx - yy + cx;
    }
    return 0.0f;
}

static Color julia_color(float steps)
{
    float t = sqrtf(steps / 70.0f);
    Color c = rgb(0.02f, 0.03f, 0.10f);

    if (steps == 0.0f) {
        return rgb(0.01f, 0.01f, 0.03f);
    }
    c = mix_color(c, rgb(0.08f, 0.28f, 0.55f), ramp(0.16f, 0.50f, t));
    c = mix_color(c, rgb(0.94f, 0.88f, 0.66f), ramp(0.42f, 0.75f, t));
    c = mix_color(c, rgb(0.92f, 0.42f, 0.12f), ramp(0.68f, 1.00f, t));
    return mix_color(c, rgb(0.35f, 0.04f, 0.12f), ramp(0.95f, 1.60f, t));
}

static void paint(double cx, double cy)
{
    int x, y;

    for (y = 0; y < SCREEN_HEIGHT; y++) {
        for (x = 0; x < SCREEN_WIDTH; x++) {
            double px = (x - 319.5) / 205.0, py = (y - 239.5) / 205.0;
            Color c = julia_color(escape_time(px, py, cx, cy));
            picture[y][x] = (FxU16)((to_byte(c.r) >> 3) << 11 | (to_byte(c.g) >> 2) << 5 | to_byte(c.b) >> 3);
        }
    }
}

static FxBool write_picture(void)
{
    GrLfbInfo_t info;
    int y;

    info.size = sizeof info;
    if (!grLfbLock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER, GR_LFBWRITEMODE_565,
                   GR_ORIGIN_UPPER_LEFT, FXFALSE, &info)) {
        return FXFALSE;
    }
    for (y = 0; y < SCREEN_HEIGHT; y++) {
        memcpy((char *)info.lfbPtr + (size_t)y * info.strideInBytes, picture[y], sizeof picture[y]);
    }
    return grLfbUnlock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER);
}

/* The number of pixels that differ, or -1 if the buffer cannot be locked. */
static int compare_picture(void)
{
    GrLfbInfo_t info;
    int x, y, wrong = 0;

    info.size = sizeof info;
    if (!grLfbLock(GR_LFB_READ_ONLY, GR_BUFFER_BACKBUFFER, GR_LFBWRITEMODE_ANY,
                   GR_ORIGIN_UPPER_LEFT, FXFALSE, &info)) {
        return -1;
    }
    for (y = 0; y < SCREEN_HEIGHT; y++) {
        const FxU16 *row = (const FxU16 *)(const void *)
            ((const char *)info.lfbPtr + (size_t)y * info.strideInBytes);
        for (x = 0; x < SCREEN_WIDTH; x++) {
            wrong += row[x] != picture[y][x];
        }
    }
    grLfbUnlock(GR_LFB_READ_ONLY, GR_BUFFER_BACKBUFFER);
    return wrong;
}

int main(int argc, char **argv)
{
    int frames = frames_wanted(argc, argv, 1), frame, wrong = 0;

    open_screen(GR_ORIGIN_UPPER_LEFT);
    /* 16-bit pixels pass the dither unit too, and it would change them. */
    grDitherMode(GR_DITHER_DISABLE);
    for (frame = 0; frame < frames && wrong == 0; frame++) {
        paint(-0.7454 + 0.0005 * frame, 0.1130);
        if (!write_picture()) {
            fprintf(stderr, "cannot lock the back buffer for writing\n");
            return 1;
        }
        wrong = compare_picture();
        grBufferSwap(1);
    }
    grGlideShutdown();
    if (wrong < 0) {
        fprintf(stderr, "cannot lock the back buffer for reading\n");
    } else if (wrong > 0) {
        fprintf(stderr, "%d pixels differ\n", wrong);
    } else {
        printf("%d pixels written and read back\n", SCREEN_WIDTH * SCREEN_HEIGHT);
    }
    return wrong == 0 ? 0 : 1;
}
