/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * glide_immediate: workload W9 through the C library: 200,000 textured, gouraud
 * shaded, depth tested triangles of ten pixels a frame, a call for each. Prints
 * the median, least and greatest rate of seven runs, to be compared with W9 of
 * `fillrate bench`, which draws the same triangles through the Rust API.
 *
 *     cc -O2 -Iinclude benches/glide_immediate.c -o immediate -Ltarget/release \
 *         -lglide2x -lm
 *     FILLRATE_THREADS=2 LD_LIBRARY_PATH=target/release ./immediate
 */
#define _POSIX_C_SOURCE 200809L
#include <glide.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#define COUNT 200000
#define RUNS 7
#define WIDTH 640
#define HEIGHT 480

static GrVertex vertices[COUNT][3];
static unsigned random_state = 0x00C0FFEE;

static unsigned bits(void)
{
    random_state ^= random_state << 13;
    random_state ^= random_state >> 17;
    random_state ^= random_state << 5;
    return random_state;
}

static float between(float low, float high)
{
    return low + (high - low) * (float)(bits() >> 8) * (1.0f / 16777216.0f);
}

static void set_corner(GrVertex *v, float x, float y, float z, float w, float s, float t)
{
    unsigned color;

    v->x = x;
    v->y = y;
    v->ooz = z * 65535.0f;
    v->oow = 1.0f / w;
    color = (bits() & 0xffffff) | 0x808080;
    v->r = (float)(color & 0xff);
    v->g = (float)(color >> 8 & 0xff);
    v->b = (float)(color >> 16 & 0xff);
    v->a = 255.0f;
    v->tmuvtx[0].sow = s * 256.0f * v->oow;
    v->tmuvtx[0].tow = t * 256.0f * v->oow;
    v->tmuvtx[0].oow = v->oow;
    v->tmuvtx[1] = v->tmuvtx[0];
}

static void make_triangles(void)
{
    float cx = 0, cy = 0, cz = 0, cw = 1, ou = 0, ov = 0;
    int i, k;

    for (i = 0; i < COUNT; i++) {
        float angle, aspect, skew, a, b, sine, cosine, ox, oy, local[3][2];

        if (i % 64 == 0) {
            cx = between(60.0f, WIDTH - 60.0f);
            cy = between(60.0f, HEIGHT - 60.0f);
            cz = between(0.1f, 0.9f);
            cw = between(1.0f, 4.0f);
            ou = between(0.0f, 1.0f);
            ov = between(0.0f, 1.0f);
        }
        angle = between(0.0f, 6.28318530718f);
        aspect = between(0.6f, 1.6f);
        skew = between(-0.4f, 0.4f);
        a = sqrtf(20.0f) * aspect;
        b = sqrtf(20.0f) / aspect;
        local[0][0] = local[0][1] = local[1][1] = 0.0f;
        local[1][0] = a;
        local[2][0] = a * (0.3f + skew);
        local[2][1] = b;
        sine = sinf(angle);
        cosine = cosf(angle);
        ox = cx + between(-40.0f, 40.0f);
        oy = cy + between(-40.0f, 40.0f);
        for (k = 0; k < 3; k++) {
            float x = ox + local[k][0] * cosine - local[k][1] * sine;
            float y = oy + local[k][0] * sine + local[k][1] * cosine;
            float z = cz + between(-0.02f, 0.02f), w = cw * between(0.97f, 1.03f);

            set_corner(&vertices[i][k], x, y, z, w, ou + (x - cx) / 256.0f, ov + (y - cy) / 256.0f);
        }
    }
}

/* 256x256 texels of noise and their mip maps, which are noise as well. */
static void set_texture(void)
{
    static FxU16 texels[87381];
    GrTexInfo info = {GR_LOD_1, GR_LOD_256, GR_ASPECT_1x1, GR_TEXFMT_RGB_565, texels};
    size_t i;

    for (i = 0; i < sizeof texels / sizeof *texels; i++)
        texels[i] = (FxU16)bits();
    grTexDownloadMipMap(GR_TMU0, 0, GR_MIPMAPLEVELMASK_BOTH, &info);
    grTexSource(GR_TMU0, 0, GR_MIPMAPLEVELMASK_BOTH, &info);
    grTexFilterMode(GR_TMU0, GR_TEXTUREFILTER_BILINEAR, GR_TEXTUREFILTER_BILINEAR);
    grTexClampMode(GR_TMU0, GR_TEXTURECLAMP_WRAP, GR_TEXTURECLAMP_WRAP);
    grTexMipMapMode(GR_TMU0, GR_MIPMAP_NEAREST, FXFALSE);
    guTexCombineFunction(GR_TMU0, GR_TEXTURECOMBINE_DECAL);
}

static void draw_frame(void)
{
    int i;

    grBufferClear(0, 0, GR_WDEPTHVALUE_FARTHEST);
    for (i = 0; i < COUNT; i++)
        grDrawTriangle(&vertices[i][0], &vertices[i][1], &vertices[i][2]);
    grBufferSwap(0);
}

static double seconds(void)
{
    struct timespec now;

    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Millions of triangles a second over a third of a second. */
static double run(void)
{
    double start = seconds();
    int frames = 0;
    FxU16 pixel;

    do {
        draw_frame();
        frames++;
    } while (seconds() - start < 0.3);
    /* Waits for the last frame, which may still be drawn behind our back. */
    grLfbReadRegion(GR_BUFFER_FRONTBUFFER, 0, 0, 1, 1, 2, &pixel);
    return 1e-6 * COUNT * frames / (seconds() - start);
}

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

int main(void)
{
    GrHwConfiguration hardware;
    double rates[RUNS];
    int i;

    grGlideInit();
    if (!grSstQueryHardware(&hardware))
        return 1;
    grSstSelect(0);
    if (!grSstWinOpen(0, GR_RESOLUTION_640x480, GR_REFRESH_60Hz, GR_COLORFORMAT_ARGB,
                      GR_ORIGIN_UPPER_LEFT, 2, 1))
        return 1;
    make_triangles();
    set_texture();
    grDitherMode(GR_DITHER_4x4);
    grDepthBufferMode(GR_DEPTHBUFFER_ZBUFFER);
    grDepthBufferFunction(GR_CMP_LEQUAL);
    grDepthMask(FXTRUE);
    guColorCombineFunction(GR_COLORCOMBINE_TEXTURE_TIMES_ITRGB);
    run();
    for (i = 0; i < RUNS; i++)
        rates[i] = run();
    qsort(rates, RUNS, sizeof *rates, compare);
    printf("W9 in C  %.2f  (%.2f to %.2f) Mtri/s\n", rates[RUNS / 2], rates[0], rates[RUNS - 1]);
    grGlideShutdown();
    return 0;
}
