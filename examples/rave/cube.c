/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * cube.c: a textured cube: texture with all its levels, modulation by the light
 * on each face, a highlight on the corners that point at the light, perspective
 * correct in every pixel.
 */
#include "common.h"

/* Planks in an iron frame, with rivets. */
static TQAUInt32 crate(int x, int y, int side, int kind)
{
    int edge = side / 12;
    int dx = x < side - 1 - x ? x : side - 1 - x, dy = y < side - 1 - y ? y : side - 1 - y;
    int near = dx < dy ? dx : dy;
    int grain = noise(x, y * 5 % side, side, 8) + noise(x, y, side, 32) / 2;
    int plank = y * 6 / side, seam = y * 6 % side < 8;

    (void)kind;
    if (near < edge) {
        int rivet = (dx + dy) % (side / 8) < 3 && near > edge / 3 && near < edge - 1;
        int shade = 96 + lattice(x, y) / 10 + (near == 0 ? 60 : 0) - (near == edge - 1 ? 50 : 0);

        return argb(255, shade + 70 * rivet, shade + 70 * rivet, shade + 10 + 60 * rivet);
    }
    grain = 96 + grain * 90 / 382 + lattice(plank, 7) / 8 - 46 * seam;
    return argb(255, grain + 26, grain - 22, grain - 70);
}

/* Corners of the six faces, around the middle, seen from outside clockwise. */
static const float faces[6][4][3] = {
    {{-1, 1, -1}, {1, 1, -1}, {1, -1, -1}, {-1, -1, -1}},
    {{1, 1, 1}, {-1, 1, 1}, {-1, -1, 1}, {1, -1, 1}},
    {{1, 1, -1}, {1, 1, 1}, {1, -1, 1}, {1, -1, -1}},
    {{-1, 1, 1}, {-1, 1, -1}, {-1, -1, -1}, {-1, -1, 1}},
    {{-1, 1, 1}, {1, 1, 1}, {1, 1, -1}, {-1, 1, -1}},
    {{-1, -1, -1}, {1, -1, -1}, {1, -1, 1}, {-1, -1, 1}},
};

static float positive(float x)
{
    return x > 0 ? x : 0;
}

static void draw_cube(TQADrawContext *context, float yaw, float pitch)
{
    static const float u[4] = {0, 1, 1, 0}, v[4] = {1, 1, 0, 0};
    int face, i;

    for (face = 0; face < 6; face++) {
        TQAVTexture vertices[4];

        for (i = 0; i < 4; i++) {
            const float *p = faces[face][i];
            Vec3 at = turned(vec3(p[0], p[1], p[2]), yaw, pitch);
            /* Light from the upper left in front; normals of a ball. */
            float facing = (-0.5f * at.x + 0.6f * at.y - 0.62f * at.z) / 1.732f;
            float light = 0.3f + 0.95f * positive(facing), shine = positive(facing);
            Corner corner;

            shine *= shine * shine * 0.55f;
            corner.position = vec3(at.x, at.y, at.z + 3.5f);
            corner.u = u[i];
            corner.v = v[i];
            corner.r = corner.g = corner.b = light;
            vertices[i] = project(context, &corner);
            vertices[i].ks_r = vertices[i].ks_g = shine;
            vertices[i].ks_b = shine * 0.8f;
        }
        if (!shows_back(vertices)) {
            QADrawVTexture(context, 4, kQAVertexMode_Fan, vertices, NULL);
        }
    }
}

int main(int argc, char **argv)
{
    static Screen screen;
    static Picture picture;
    TQATexture *texture;
    int frame, frames = frames_wanted(argc, argv, 8);

    open_screen(&screen, kQAPixel_RGB32, kQAOptional_Texture | kQAOptional_TextureColor,
                kQAContext_DoubleBuffer);
    paint_picture(&picture, 128, crate, 0);
    texture = texture_of(screen.engine, &picture);
    set_background(screen.context, 0.11f, 0.13f, 0.2f);
    QASetInt(screen.context, kQATag_TextureFilter, kQATextureFilter_Best);
    QASetInt(screen.context, kQATag_TextureOp,
             kQATextureOp_Modulate | kQATextureOp_Highlight);
    for (frame = 0; frame < frames; frame++) {
        QARenderStart(screen.context, NULL, NULL);
        QASetPtr(screen.context, kQATag_Texture, texture);
        draw_cube(screen.context, 0.07f + (float)frame / 96, 0.92f);
        need(QARenderEnd(screen.context, NULL), "QARenderEnd");
    }
    QASetPtr(screen.context, kQATag_Texture, NULL);
    QATextureDelete(screen.engine, texture);
    QADrawContextDelete(screen.context);
    return 0;
}
