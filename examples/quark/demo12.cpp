/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * demo12: alpha transparency and face sort. The glass sides of three nested
 * boxes around a wooden crate, drawn from both sides and sorted by depth.
 * DRAW_ALPHA, ZSort, SortReset, SortDraw.
 *
 * After every 250 frames sorting is switched off, to show what it is for.
 */
#include "common.h"

static const int BOXES = 3;

/* The four sides of a cube, open at the top and the bottom, each side with an
 * intensity of its own. */
static void make_box(CTriangleList *box, int half, TRasterState *state)
{
    box->Init(VF_XYZ, 8, IF_ABC | IF_I, 8, state);
    for (int i = 0; i < 8; i++) {
        short at[3] = {(short)(CUBE[i][0] * half), (short)(CUBE[i][1] * half),
                       (short)(CUBE[i][2] * half)};
        box->SetXYZ(i, at);
    }
    for (int i = 0; i < 8; i++) {
        const unsigned short *quad = CUBE_FACES[i / 2];
        unsigned short face[3] = {quad[0], quad[1 + i % 2], quad[2 + i % 2]};
        box->SetABC(i, face);
        box->SetI(i, 255 - i / 2 * 24);
    }
}

int main(int argc, char **argv)
{
    static CVGpu Gpu;
    static CTexture crate;
    static const unsigned short one_state[12] = {0};
    static const int colors[BOXES] = {COLOR_RGB(255, 60, 60), COLOR_RGB(60, 255, 60),
                                      COLOR_RGB(80, 80, 255)};
    CTriangleList wood, glass[BOXES];
    TRasterState wooden, glassy[BOXES];
    CMatrix matrix;
    int frames = frames_wanted(argc, argv, 30);

    start(&Gpu);
    make_texture(&crate, crate_texel, -1);
    wooden = state_of(DRAW_OPAQUE, 0, &crate);
    make_cube(&wood, 50, VF_XYZ, IF_ABC | IF_UV, &wooden);
    wood.BuildCmdList(one_state);
    for (int i = 0; i < BOXES; i++) {
        glassy[i] = state_of(DRAW_ALPHA, colors[i], 0);
        glassy[i].TestCulling = 0;
        glassy[i].ZSort = 1;
        make_box(&glass[i], 75 + 32 * i, &glassy[i]);
    }
    if (!Gpu.SetWorkMemory(8, 200)) {
        fprintf(stderr, "no memory\n");
        return 1;
    }
    Gpu.SortReset();
    Gpu.ViewMatrix = &matrix;
    for (int frame = 0; frame < frames; frame++) {
        matrix.LoadIdentity();
        matrix.Translate(0, 0, -560);
        matrix.RotateX(DEGREE(38));
        matrix.RotateY(DEGREE(-5) + frame * 30);
        Gpu.TriangleMode = TRI_ZC;
        Gpu.DrawTriangleList(&wood);
        Gpu.TriangleMode = TRI_UT;
        for (int i = 0; i < BOXES; i++) {
            glassy[i].ZSort = frame / 250 % 2 == 0;
            Gpu.DrawTriangleList(&glass[i]);
        }
        Gpu.SortDraw();
        end_frame(&Gpu, frame, "Alpha and sort", COLOR_RGB(60, 60, 130) | COLOR_I(120));
    }
    wood.Delete();
    for (int i = 0; i < BOXES; i++) {
        glass[i].Delete();
    }
    Gpu.Delete();
    return 0;
}
