/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * demo5: simple triangle drawing. One turning triangle in each of the four
 * modes, with an intensity for each corner. DrawTriangle, TVertex,
 * ScrProjection, TriangleMode.
 */
#include "common.h"

static const int CORNERS[3][3] = {{-110, -90, 0}, {110, -90, 0}, {0, 110, 0}};
static const int UV[3][2] = {{0, 255}, {255, 255}, {128, 0}};

/* Draws the triangle around (x, y) of the world, turned. */
static void draw(CVGpu *Gpu, int mode, int x, int y, int turn)
{
    TVertex vertex[3];
    CMatrix matrix;

    matrix.LoadIdentity();
    matrix.Translate(x, y, -600);
    matrix.RotateY(turn);
    matrix.RotateZ(turn / 3);
    for (int i = 0; i < 3; i++) {
        int world[3], screen[3] = {0, 0, 64};
        matrix.TransformVector(CORNERS[i], world);
        vertex[i].m = Gpu->ScrProjection(world, screen);
        vertex[i].x = screen[0];
        vertex[i].y = screen[1];
        vertex[i].z = screen[2];
        vertex[i].i = i == 0 ? 255 : i == 1 ? 60 : 160;
        vertex[i].u = UV[i][0];
        vertex[i].v = UV[i][1];
    }
    Gpu->TriangleMode = mode;
    Gpu->DrawTriangle(&vertex[0], &vertex[1], &vertex[2]);
}

int main(int argc, char **argv)
{
    static CVGpu Gpu;
    static CTexture brick;
    TRasterState state;
    int frames = frames_wanted(argc, argv, 30);

    start(&Gpu);
    make_texture(&brick, brick_texel, -1);
    state = state_of(DRAW_OPAQUE, COLOR_RGB(80, 220, 255), &brick);
    state.TestCulling = 0;
    Gpu.TriangleState = &state;
    for (int frame = 0; frame < frames; frame++) {
        int turn = frame * 24;
        draw(&Gpu, TRI_UT, -160, 200, turn);
        draw(&Gpu, TRI_WF, 160, 200, turn);
        draw(&Gpu, TRI_NZC, -160, -180, turn);
        draw(&Gpu, TRI_ZC, 160, -180, turn);
        Gpu.PrintXY((char *)"UT", 52, 160);
        Gpu.PrintXY((char *)"WF", 172, 160);
        Gpu.PrintXY((char *)"NZC", 48, 300);
        Gpu.PrintXY((char *)"ZC", 172, 300);
        end_frame(&Gpu, frame, "Triangle", COLOR_RGB(0, 0, 120) | COLOR_I(100));
    }
    Gpu.Delete();
    return 0;
}
