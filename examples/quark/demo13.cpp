/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * demo13: clipping planes. The camera flies through a corridor whose walls
 * cross the near plane, which moves back and forth: what is nearer is cut off.
 * Sections that reach beyond the far plane are left out. SetNFClip, ClipMsk.
 */
#include "common.h"

static const int SECTIONS = 14;
static const int DEPTH = 400;

enum { FLOOR, WALL, CEILING, STATES };

/* A section of the corridor: floor, two walls and a ceiling, seen from inside. */
static void make_section(CTriangleList *list, TRasterState *states)
{
    static const short at[8][3] = {{-150, -110, 0}, {150, -110, 0}, {150, 130, 0}, {-150, 130, 0},
                                   {-150, -110, -DEPTH}, {150, -110, -DEPTH},
                                   {150, 130, -DEPTH}, {-150, 130, -DEPTH}};
    static const unsigned short quads[4][4] = {
        {0, 1, 5, 4}, {1, 2, 6, 5}, {3, 0, 4, 7}, {2, 3, 7, 6}};
    static const unsigned short state_of_face[8] = {FLOOR, FLOOR, WALL, WALL,
                                                    WALL, WALL, CEILING, CEILING};
    static const short uv[2][6] = {{0, 0, 256, 0, 256, 512}, {0, 0, 256, 512, 0, 512}};

    list->Init(VF_XYZ, 8, IF_ABC | IF_UV, 8, states);
    for (int i = 0; i < 8; i++) {
        list->SetXYZ(i, at[i]);
    }
    for (int i = 0; i < 8; i++) {
        unsigned short face[3] = {quads[i / 2][0], quads[i / 2][1 + i % 2],
                                  quads[i / 2][2 + i % 2]};
        short turned[6];
        list->SetABC(i, face);
        /* Along the walls the bricks lie flat. */
        for (int k = 0; k < 6; k += 2) {
            int wall = i >= 2 && i < 6;
            turned[k] = uv[i % 2][wall ? k + 1 : k];
            turned[k + 1] = uv[i % 2][wall ? k : k + 1];
        }
        list->SetUV(i, turned);
    }
    list->BuildCmdList(state_of_face);
}

/* The bits of a clip mask as letters. */
static void show_mask(CVGpu *Gpu, int mask, int x, int y)
{
    static const char letters[] = "BTLRFN";
    char text[7] = "------";

    for (int bit = 0; bit < 6; bit++) {
        if (mask >> bit & 1) {
            text[bit] = letters[bit];
        }
    }
    Gpu->PrintXY(text, x, y);
}

int main(int argc, char **argv)
{
    static CVGpu Gpu;
    static CTexture textures[STATES], crate;
    static TRasterState states[STATES], wooden;
    static const unsigned short one_state[12] = {0};
    CTriangleList section, box;
    CMatrix matrix;
    int frames = frames_wanted(argc, argv, 60);

    start(&Gpu);
    make_texture(&textures[FLOOR], stone_texel, -1);
    make_texture(&textures[WALL], brick_texel, -1);
    make_texture(&textures[CEILING], crate_texel, -1);
    make_texture(&crate, crate_texel, -1);
    for (int i = 0; i < STATES; i++) {
        states[i] = state_of(DRAW_OPAQUE, 0, &textures[i]);
        states[i].TestCulling = 0;
    }
    wooden = state_of(DRAW_OPAQUE, 0, &crate);
    wooden.TestCulling = 0;
    make_section(&section, states);
    make_cube(&box, 60, VF_XYZ, IF_ABC | IF_UV, &wooden);
    box.BuildCmdList(one_state);
    if (!Gpu.SetWorkMemory(8, 0)) {
        fprintf(stderr, "no memory\n");
        return 1;
    }
    Gpu.TriangleMode = TRI_ZC;
    Gpu.ViewMatrix = &matrix;
    for (int frame = 0; frame < frames; frame++) {
        int sway = 60 * SINUS(frame * 90) >> TRIGO_SHIFT;
        int plane = -232 + (168 * COSINUS(frame * 36) >> TRIGO_SHIFT);
        char number[12];
        Gpu.SetNFClip(plane, -3600);
        for (int i = 0; i < SECTIONS; i++) {
            matrix.LoadIdentity();
            matrix.RotateZ(sway * 3);
            matrix.Translate(-sway, 0, 300 - i * DEPTH + frame * 12 % DEPTH);
            for (int k = 0; k < STATES; k++) {
                int light = 255 - i * 26;
                states[k].DrawIntensity = (unsigned char)(light < 16 ? 16 : light);
            }
            Gpu.DrawTriangleList(&section);
        }
        /* A box that the near plane cuts open. */
        matrix.LoadIdentity();
        matrix.RotateZ(sway * 3);
        matrix.Translate(50 - sway, -40, -260);
        matrix.RotateY(frame * 50);
        matrix.RotateX(DEGREE(30));
        Gpu.DrawTriangleList(&box);
        Itoa(Gpu.ClipNear, number);
        Gpu.PrintXY((char *)"near", 4, 296);
        Gpu.PrintXY(number, 44, 296);
        Gpu.PrintXY((char *)"box", 4, 308);
        show_mask(&Gpu, Gpu.ClipMsk(matrix.Pos()), 44, 308);
        end_frame(&Gpu, frame, "Clipping", 0);
    }
    section.Delete();
    box.Delete();
    Gpu.Delete();
    return 0;
}
