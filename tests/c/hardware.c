/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * hardware.c: what a program sees of the boards beside pixels: several boards
 * with a state each, the video clock, waiting swaps, status and counters.
 * Runs with FILLRATE_BOARDS=2.
 */
#include <stdio.h>
#include <string.h>

#include <glide.h>

static int failures;

static void expect(int holds, const char *what)
{
    if (!holds) {
        printf("failed: %s\n", what);
        failures++;
    }
}

static GrVertex vertex(float x, float y)
{
    GrVertex v;

    memset(&v, 0, sizeof v);
    v.x = x;
    v.y = y;
    v.r = v.g = v.b = v.a = 255.0f;
    v.oow = 1.0f;
    return v;
}

static FxU16 pixel(FxU32 x, FxU32 y)
{
    FxU16 value = 0;

    grLfbReadRegion(GR_BUFFER_BACKBUFFER, x, y, 1, 1, 2, &value);
    return value;
}

/* Each board keeps what was set and drawn while it was the current one. */
static void boards(void)
{
    static const FxU32 color[2] = { 0x00ff0000, 0x000000ff };
    GrVertex a = vertex(10, 10), b = vertex(100, 10), c = vertex(10, 100);
    GrHwConfiguration hardware;
    int i;

    expect(grSstQueryBoards(&hardware) && hardware.num_sst == 2, "two boards");
    grGlideInit();
    for (i = 0; i < 2; i++) {
        grSstSelect(i);
        expect(grSstWinOpen(0, i == 0 ? GR_RESOLUTION_320x240 : GR_RESOLUTION_512x384,
                            GR_REFRESH_60Hz, GR_COLORFORMAT_ARGB, GR_ORIGIN_UPPER_LEFT, 2, 1),
               "both open");
        grDitherMode(GR_DITHER_DISABLE);
        guColorCombineFunction(GR_COLORCOMBINE_CCRGB);
        grConstantColorValue(color[i]);
    }
    for (i = 0; i < 4; i++) {
        grSstSelect(i & 1);
        expect(grSstScreenWidth() == (i & 1 ? 512u : 320u), "its own size");
        grBufferClear(0, 0, 0);
        grDrawTriangle(&a, &b, &c);
        expect(pixel(20, 20) == (i & 1 ? 0x001f : 0xf800), "its own colour");
        grBufferSwap(0);
    }
}

/* The beam moves by looking, and a swap waits for it. */
static void video(void)
{
    FxU32 status, line, last = 0, seen = 0, swaps = 0;
    int i;

    grSstSelect(0);
    grSstIdle();
    for (i = 0; i < 2000 && !grSstVRetraceOn(); i++) {
        line = grSstVideoLine();
        seen += line > last;
        last = line;
    }
    expect(i < 2000 && seen > 50, "lines rise until retrace");
    expect(grSstVideoLine() == 0, "no line in retrace");
    while (grSstVRetraceOn() && i < 4000) i++;
    expect(i < 4000, "retrace ends");
    status = grSstStatus();
    expect((status & 0x3f) == 0x3f && (status >> 12 & 0xffff) == 0xffff, "queues are empty");
    expect((status >> 6 & 1) == 1 && (status >> 28) == 0, "not in retrace, nothing waits");
    for (i = 0; i < 3; i++) grBufferSwap(2);
    expect(grBufferNumPending() == 3 && grSstIsBusy(), "three swaps wait");
    expect(grSstStatus() >> 28 == 3, "status says so");
    for (i = 0; i < 100000 && grBufferNumPending() > 0; i++) swaps++;
    expect(grBufferNumPending() == 0 && swaps > 500, "waiting ends after six frames");
    expect(!grSstIsBusy(), "then it is idle");
    for (i = 0; i < 100; i++) grBufferSwap(1);
    expect(grBufferNumPending() <= 7, "seven wait at most");
    grSstIdle();
    expect(grBufferNumPending() == 0, "idle waits for all");
}

/* The two kinds of counters are reset on their own. */
static void counters(void)
{
    GrVertex a = vertex(0, 0), b = vertex(16, 0), c = vertex(16, 16), d = vertex(0, 16);
    GrSstPerfStats_t stats;
    FxU32 in, out;

    grSstSelect(1);
    grSstResetPerfStats();
    grResetTriStats();
    grDrawTriangle(&a, &b, &c);
    grDrawTriangle(&a, &c, &d);
    grDrawTriangle(&a, &a, &d);
    grSstPerfStats(&stats);
    expect(stats.pixelsIn == 256 && stats.pixelsOut == 256, "256 pixels");
    grSstResetPerfStats();
    grSstPerfStats(&stats);
    expect(stats.pixelsIn == 0, "pixels are reset");
    grTriStats(&in, &out);
    expect(in == 3 && out == 2, "triangles are not");
    grResetTriStats();
    grTriStats(&in, &out);
    expect(in == 0 && out == 0, "now they are");
    grBufferClear(0, 0, 0);
    grSstPerfStats(&stats);
    expect(stats.pixelsIn == 0 && stats.pixelsOut == 512 * 384, "a clear writes pixels");
}

int main(void)
{
    boards();
    video();
    counters();
    grGlideShutdown();
    return failures != 0;
}
