/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * viewtest.c: what lies beyond the thesis in one view: a floor that runs under
 * the viewer (cut at the near plane, texture levels), balls as indexed strips
 * in three lights with highlights, a cage of lines, points as stars.
 */
#include "common.h"

#define RINGS 12
#define SIDES 20

/* A chequered texture with all its levels. */
static int make_texture(void)
{
    static unsigned texels[64 * 64];
    int x, y, id;

    for (y = 0; y < 64; y++) {
        for (x = 0; x < 64; x++) {
            int dark = (x / 32 + y / 32) & 1, line = x % 32 < 2 || y % 32 < 2;
            texels[64 * y + x] = line ? 0xc0c8d0ffu : dark ? 0x305070ffu : 0x90a0a8ffu;
        }
    }
    id = RXAllocateMipMapped(64, 64);
    RUploadTexture(id, 64 * 64, texels);
    RXMakeMipMaps(id);
    return id;
}

/* A ball of radius 1 around the origin as stored vertices, ring by ring. */
static void store_ball(void)
{
    const double pi = 3.14159265358979;
    int i, k;

    RColor(0xe0, 0xe0, 0xe0, 0xff);
    for (i = 0; i <= RINGS; i++) {
        for (k = 0; k <= SIDES; k++) {
            double a = pi * i / RINGS, b = 2.0 * pi * k / SIDES;
            float x = (float)(sin(a) * cos(b)), y = (float)cos(a), z = (float)(sin(a) * sin(b));
            RNormal(x, y, z);
            RXStoreVertex((unsigned)(i * (SIDES + 1) + k), x, y, z, 0.0f, 0.0f);
        }
    }
}

static void draw_ball(float x, float y, float z, float radius)
{
    float m[4][4];
    int i, k;

    identity(m);
    m[0][0] = m[1][1] = m[2][2] = radius;
    m[0][3] = x;
    m[1][3] = y;
    m[2][3] = z;
    RModelMatrix(m);
    RXSetPrimitive(RX_PRIM_STRIP);
    RSetTexMode(R_TEXMODE_COLOR);
    RSetLit(1);
    for (i = 0; i < RINGS; i++) {
        RBeginPrim();
        for (k = 0; k <= SIDES; k++) {
            RXIndex((unsigned)((i + 1) * (SIDES + 1) + k));
            RXIndex((unsigned)(i * (SIDES + 1) + k));
        }
        REndPrim();
    }
    RSetLit(0);
}

static void draw_floor(void)
{
    float m[4][4];

    identity(m);
    RModelMatrix(m);
    RSetTexMode(R_TEXMODE_TEXTURE);
    RXSetPrimitive(RX_PRIM_FAN);
    RBeginPrim();
    RVertex(-40.0f, 0.0f, -40.0f, 0.0f, 0.0f);
    RVertex(-40.0f, 0.0f, 40.0f, 0.0f, 40.0f);
    RVertex(40.0f, 0.0f, 40.0f, 40.0f, 40.0f);
    RVertex(40.0f, 0.0f, -40.0f, 40.0f, 0.0f);
    REndPrim();
    RSetTexMode(R_TEXMODE_COLOR);
}

static void draw_cage(float s)
{
    static const int edges[12][2] = { { 0, 1 }, { 1, 3 }, { 3, 2 }, { 2, 0 }, { 4, 5 }, { 5, 7 },
                                      { 7, 6 }, { 6, 4 }, { 0, 4 }, { 1, 5 }, { 2, 6 }, { 3, 7 } };
    float m[4][4];
    int i, k;

    identity(m);
    RModelMatrix(m);
    RXSetPrimitive(RX_PRIM_LINES);
    RBeginPrim();
    for (i = 0; i < 12; i++) {
        for (k = 0; k < 2; k++) {
            int c = edges[i][k];
            RColor(c & 1 ? 0xff : 0x40, c & 2 ? 0xff : 0x40, c & 4 ? 0xff : 0x40, 0xff);
            RVertex(c & 1 ? s : -s, c & 2 ? 2.0f * s : 0.05f, c & 4 ? s : -s, 0.0f, 0.0f);
        }
    }
    REndPrim();
}

static void draw_stars(void)
{
    unsigned seed = 7;
    int i;

    RXSetPrimitive(RX_PRIM_POINTS);
    for (i = 0; i < 3; i++) {
        int k;
        RXSetPointSize((unsigned)(i + 1));
        RBeginPrim();
        for (k = 0; k < 60; k++) {
            float c[3];
            int j;
            for (j = 0; j < 3; j++) {
                seed = seed * 1664525u + 1013904223u;
                c[j] = (float)(seed >> 16) / 65536.0f;
            }
            RColor(0xc0 + (seed >> 26), 0xc0 + (seed >> 27), 0xff, 0xff);
            RVertex(60.0f * c[0] - 30.0f, 2.0f + 30.0f * c[1], 20.0f + 10.0f * c[2], 0.0f, 0.0f);
        }
        REndPrim();
    }
}

int main(int argc, char **argv)
{
    int n = frames_wanted(argc, argv, 2), i;
    float focus[3] = { 0.0f, 1.0f, 0.0f }, up[3] = { 0.0f, 20.0f, 0.0f };

    RInit();
    RReset();
    RXResize(512, 384);
    RSetTextureID((unsigned)make_texture());
    RSetTexAlpha(R_ALPHA_NONE);
    RSetTexInterp(1);
    RSetColAlpha(R_ALPHA_NONE);
    RXSetMipMap(RX_MIPMAP_BLEND);
    RXSetClip(RX_CLIP_FRUSTUM);
    store_ball();
    RProjMatrixUV(0.72f, 0.58f, 0.2f, 100.0f);
    RSetUseAmb(1);
    RSetUseDir(1);
    RSetLitInterp(1);
    RAmbColor(0xff, 0xff, 0xff, 0x28);
    RDirColor(0xff, 0xf0, 0xd0, 0xb0);
    RDirLight(0.5f, -0.7f, 0.5f);
    RXLight(1, 0xff2020a0u, 0.9f, 0.2f, 0.3f);
    RXLight(2, 0x2040ffc0u, -0.9f, 0.1f, 0.3f);
    RXSpecular(0xffffffffu, 40);
    for (i = 0; i < n; i++) {
        float eye[3];
        eye[0] = 1.5f - 0.4f * (float)i;
        eye[1] = 1.7f;
        eye[2] = -5.0f;
        RCameraMatrix(eye, focus, up);
        RXEye(eye[0], eye[1], eye[2]);
        begin_frame(0x08, 0x0a, 0x18);
        draw_stars();
        draw_floor();
        draw_ball(0.0f, 1.0f, 0.0f, 1.0f);
        draw_ball(-2.4f, 0.6f, 1.0f, 0.6f);
        draw_ball(2.2f, 0.7f, 2.0f, 0.7f);
        draw_cage(1.25f);
        end_frame();
    }
    return 0;
}
