/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * cubetest.c: nine cubes seen in perspective, flat at first, then textured and
 * lit, while the camera goes round.
 */
#include "common.h"

struct face {
    unsigned rgb;
    float corner[4][3]; /* bottom left, top left, top right, bottom right: signs */
};

static const struct face faces[6] = {
    { 0xff0000, { { -1, 1, -1 }, { -1, 1, 1 }, { 1, 1, 1 }, { 1, 1, -1 } } },
    { 0x00ff00, { { -1, -1, -1 }, { -1, 1, -1 }, { 1, 1, -1 }, { 1, -1, -1 } } },
    { 0x0000ff, { { 1, -1, -1 }, { 1, 1, -1 }, { 1, 1, 1 }, { 1, -1, 1 } } },
    { 0xff00ff, { { -1, -1, 1 }, { -1, -1, -1 }, { 1, -1, -1 }, { 1, -1, 1 } } },
    { 0xffff00, { { 1, -1, 1 }, { 1, 1, 1 }, { -1, 1, 1 }, { -1, -1, 1 } } },
    { 0x00ffff, { { -1, -1, 1 }, { -1, 1, 1 }, { -1, 1, -1 }, { -1, -1, -1 } } }
};

static void draw_cube(void)
{
    static const float uv[4][2] = { { 0, 1 }, { 0, 0 }, { 1, 0 }, { 1, 1 } };
    static const int corners[2][3] = { { 0, 1, 2 }, { 0, 2, 3 } };
    const float normal = 0.57735027f;
    int f, t, k;

    for (f = 0; f < 6; f++) {
        RColor(faces[f].rgb >> 16, faces[f].rgb >> 8, faces[f].rgb, 0xff);
        for (t = 0; t < 2; t++) {
            RBeginPrim();
            for (k = 0; k < 3; k++) {
                const float *c = faces[f].corner[corners[t][k]];
                const float *at = uv[corners[t][k]];
                RNormal(c[0] * normal, c[1] * normal, c[2] * normal);
                RVertex(c[0] * 0.5f, c[1] * 0.5f, c[2] * 0.5f, at[0], at[1]);
            }
            REndPrim();
        }
    }
}

static void draw_cubes(void)
{
    static const float places[3] = { 0.0f, -1.5f, 1.5f };
    float m[4][4];
    int x, z;

    for (x = 0; x < 3; x++) {
        for (z = 0; z < 3; z++) {
            identity(m);
            m[0][3] = places[x];
            m[2][3] = places[z];
            RModelMatrix(m);
            draw_cube();
        }
    }
}

/* A chequered texture with a bright frame. */
static int make_texture(void)
{
    unsigned texels[32 * 32];
    int x, y, id;

    for (y = 0; y < 32; y++) {
        for (x = 0; x < 32; x++) {
            int edge = x < 2 || y < 2 || x > 29 || y > 29;
            unsigned grey = edge ? 0xff : ((x / 4 + y / 4) & 1) ? 0xd0 : 0x70;
            texels[32 * y + x] = grey << 24 | grey << 16 | grey << 8 | 0xff;
        }
    }
    id = RAllocateTexture(32, 32);
    RUploadTexture(id, 32 * 32, texels);
    return id;
}

static void look_from(float angle)
{
    float eye[3], focus[3] = { 0.0f, 0.0f, 0.0f }, up[3] = { 0.0f, 10.0f, 0.0f };

    /* The first frame's camera stands at (2, 2, -3). */
    eye[0] = (float)(2.0 * cos(angle) - 3.0 * sin(angle));
    eye[1] = 2.0f;
    eye[2] = (float)(-3.0 * cos(angle) - 2.0 * sin(angle));
    RCameraMatrix(eye, focus, up);
}

int main(int argc, char **argv)
{
    int n = frames_wanted(argc, argv, 4), i;

    RInit();
    RReset();
    RSetTextureID((unsigned)make_texture());
    RProjMatrixUV(0.78539816f, 0.78539816f, 0.1f, 100.0f);
    RSetUseAmb(1);
    RSetUseDir(1);
    RAmbColor(0xff, 0xff, 0xff, 0x50);
    RDirColor(0xff, 0xff, 0xf0, 0xc0);
    RDirLight(-0.3f, -0.8f, 0.5f);
    for (i = 0; i < n; i++) {
        if (i > 0) {
            RSetTexMode(R_TEXMODE_MODULATE);
            RSetTexAlpha(R_ALPHA_NONE);
            RSetTexInterp(1);
            RSetLit(1);
            RSetLitInterp(1);
        }
        look_from(0.05f * (float)i);
        begin_frame(0x18, 0x1c, 0x28);
        draw_cubes();
        end_frame();
    }
    return 0;
}
