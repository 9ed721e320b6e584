/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * triangletest.c: the six triangles that the pipeline was measured with, once
 * in every way of colouring them: from flat colour to everything on, opaque
 * and transparent, at falling sizes and growing angles.
 */
#include "common.h"

struct corner {
    float x, y, u, v;
    unsigned rgb;
    int fades; /* alpha follows the frame's, else it is opaque */
};

static const struct corner pattern[6][3] = {
    { { 0.0f, 0.0f, 0.0f, 0.0f, 0xff0000, 1 },
      { 0.5f, 0.0f, 1.0f, 0.0f, 0x00ff00, 0 },
      { 0.0f, 0.5f, 0.0f, 1.0f, 0x0000ff, 0 } },
    { { 0.9f, 0.5f, 1.0f, 0.0f, 0xffff00, 1 },
      { 0.9f, 0.75f, 1.0f, 1.0f, 0xff00ff, 1 },
      { 0.75f, 0.75f, 0.0f, 1.0f, 0x00ffff, 1 } },
    { { -0.5f, -0.5f, 0.0f, 1.0f, 0xffffff, 1 },
      { -0.4f, -0.7f, 0.5f, 0.0f, 0xffffff, 1 },
      { -0.3f, -0.5f, 1.0f, 1.0f, 0xffffff, 1 } },
    { { -0.5f, 0.0f, 0.0f, 0.0f, 0xffffff, 1 },
      { -0.4f, 0.0f, 1.0f, 0.0f, 0xffffff, 1 },
      { -0.4f, 0.1f, 1.0f, 1.0f, 0xff0000, 1 } },
    { { -0.7f, 0.9f, 0.0f, 1.0f, 0x5000c0, 1 },
      { -0.7f, 0.01f, 0.0f, 0.0f, 0x5000c0, 1 },
      { -0.4f, 0.45f, 1.0f, 0.5f, 0x00ffcc, 0 } },
    { { 0.0f, 0.0f, 0.0f, 1.0f, 0xffc040, 0 },
      { 0.0f, -1.0f, 0.0f, 0.0f, 0x00ff88, 1 },
      { 1.0f, 0.0f, 1.0f, 1.0f, 0xffffff, 1 } }
};

/* A face: y yellow, c cyan, k black. */
static int make_texture(void)
{
    static const char *const face[8] = { "yyyyyyyy", "yyyyyyyy", "yycyycyy", "ykyyyyky",
                                         "ykyyyyky", "yykyykyy", "yyykkyyy", "yyyyyyyy" };
    unsigned texels[64];
    int i, id;

    for (i = 0; i < 64; i++) {
        char c = face[i / 8][i % 8];
        texels[i] = c == 'c' ? 0x00ffffffu : c == 'k' ? 0x000000ffu : 0xffff00ffu;
    }
    id = RAllocateTexture(8, 8);
    RUploadTexture(id, 64, texels);
    return id;
}

static void draw_pattern(unsigned alpha)
{
    int t, k;

    for (t = 0; t < 6; t++) {
        RBeginPrim();
        for (k = 0; k < 3; k++) {
            const struct corner *c = &pattern[t][k];
            RColor(c->rgb >> 16, c->rgb >> 8, c->rgb, c->fades ? alpha : 0xff);
            RVertex(c->x, c->y, 0.0f, c->u, c->v);
        }
        REndPrim();
    }
}

struct look {
    unsigned texmode, bilinear, smooth, lit, alpha;
    float scale, angle;
};

static const struct look looks[] = {
    { R_TEXMODE_COLOR, 0, 0, 0, 0xff, 1.0f, 0.0f },
    { R_TEXMODE_COLOR, 0, 1, 0, 0xff, 0.95f, 0.1f },
    { R_TEXMODE_COLOR, 0, 1, 1, 0xff, 0.9f, 0.2f },
    { R_TEXMODE_TEXTURE, 0, 0, 0, 0xff, 0.85f, 0.3f },
    { R_TEXMODE_TEXTURE, 1, 0, 0, 0xff, 0.8f, 0.4f },
    { R_TEXMODE_BLEND, 1, 1, 0, 0xff, 0.8f, 0.5f },
    { R_TEXMODE_TEXDECAL, 0, 1, 0, 0x88, 0.8f, 0.6f },
    { R_TEXMODE_COLDECAL, 1, 1, 0, 0x88, 0.8f, 0.7f },
    { R_TEXMODE_MODULATE, 1, 1, 1, 0xff, 0.8f, 0.8f },
    { R_TEXMODE_COLOR, 0, 1, 0, 0x88, 0.8f, 0.9f },
    { R_TEXMODE_BLEND, 1, 1, 1, 0xff, 0.9f, 0.25f }
};

static void choose(const struct look *look)
{
    float m[4][4];

    identity(m);
    m[0][0] = m[1][1] = look->scale * (float)cos(look->angle);
    m[1][0] = look->scale * (float)sin(look->angle);
    m[0][1] = -m[1][0];
    RModelMatrix(m);
    RSetTexMode(look->texmode);
    RSetTexInterp(look->bilinear);
    RSetColInterp(look->smooth);
    RSetLit(look->lit);
    RSetLitInterp(look->lit);
}

int main(int argc, char **argv)
{
    int count = (int)(sizeof looks / sizeof looks[0]);
    int n = frames_wanted(argc, argv, count), i;

    RInit();
    RReset();
    RSetTextureID((unsigned)make_texture());
    RSetTexAlpha(R_ALPHA_NONE);
    RSetUseAmb(1);
    RSetUseDir(1);
    RAmbColor(0xff, 0xff, 0xff, 0x60);
    RDirColor(0xff, 0xff, 0xff, 0xa0);
    RNormal(0.0f, 0.0f, -1.0f);
    RDirLight(0.0f, 0.0f, 1.0f);
    for (i = 0; i < n; i++) {
        const struct look *look = &looks[i % count];
        choose(look);
        begin_frame(0x20, 0x24, 0x30);
        draw_pattern(look->alpha);
        end_frame();
    }
    return 0;
}
