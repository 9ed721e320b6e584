/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * texturetest.c: colour as a decal over a texture. The left triangle takes the
 * nearest texels, the right one filters them; colour alpha below the threshold
 * lets the texture through.
 */
#include "common.h"

static void box(unsigned *texels, int x0, int y0, int x1, int y1, unsigned rgba)
{
    int x, y;

    for (y = y0; y < y1; y++) {
        for (x = x0; x < x1; x++) {
            texels[16 * y + x] = rgba;
        }
    }
}

static int make_texture(void)
{
    static const unsigned stripes[3] = { 0xff0000ffu, 0x00ff00ffu, 0x0000ffffu };
    static const unsigned fading[4] = { 0xcc, 0x88, 0x44, 0x00 };
    unsigned texels[256];
    int i, id;

    box(texels, 0, 0, 16, 16, 0xffffffffu);
    for (i = 0; i < 15; i++) {
        texels[16 * i] = stripes[i % 3];
    }
    box(texels, 1, 0, 4, 3, 0xff0000ffu);
    for (i = 0; i < 4; i++) {
        box(texels, 2 + i, 6, 3 + i, 8, 0xffffff00u | fading[i]);
    }
    box(texels, 2, 9, 7, 14, 0x0000ffffu);
    box(texels, 3, 10, 6, 13, 0xffff00ffu);
    texels[16 * 9 + 2] = texels[16 * 9 + 6] = 0x00ff00ffu;
    texels[16 * 13 + 2] = texels[16 * 13 + 6] = 0x00ff00ffu;
    box(texels, 9, 9, 11, 13, 0xffffff00u);
    id = RAllocateTexture(16, 16);
    RUploadTexture(id, 256, texels);
    return id;
}

static void draw(unsigned bilinear, float shift)
{
    RBeginPrim();
    RSetTexInterp(bilinear);
    RColor(0xff, 0x00, 0x00, 0xff);
    RVertex(0.0f + shift, 0.0f, 0.0f, 0.0f, 1.0f);
    RColor(0x00, 0xff, 0x00, 0xcc);
    RVertex(0.0f + shift, -0.5f, 0.0f, 0.0f, 0.0f);
    RColor(0x00, 0x00, 0xff, 0xcc);
    RVertex(0.5f + shift, 0.0f, 0.0f, 1.0f, 1.0f);
    REndPrim();
}

int main(int argc, char **argv)
{
    int n = frames_wanted(argc, argv, 2), i;
    float m[4][4];

    RInit();
    RReset();
    RSetTextureID((unsigned)make_texture());
    RSetNoUseZ(1);
    RSetNoWriteZ(1);
    RSetOutOfOrder(1);
    RSetTexMode(R_TEXMODE_COLDECAL);
    RSetTexAlpha(R_ALPHA_NONE);
    RSetColAlpha(R_ALPHA_HARD);
    RAlphaThresh(0xdd);
    for (i = 0; i < n; i++) {
        identity(m);
        if (i > 0) { /* the second frame is magnified and centred */
            m[0][0] = m[1][1] = 1.9f;
            m[1][3] = 0.48f;
        }
        RModelMatrix(m);
        begin_frame(0x30, 0x30, 0x38);
        draw(1, 0.0f);
        draw(0, -0.5f);
        end_frame();
    }
    return 0;
}
