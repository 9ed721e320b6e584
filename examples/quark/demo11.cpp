/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * demo11: a triangle list with several textures. A box of brick, stone and
 * wood, with two keyed grates through which its inside shows; the list is
 * sorted by state once. BuildCmdList with several states, DRAW_KEYED.
 */
#include "common.h"

enum { BRICK, STONE, CRATE, GRATE, STATES };

int main(int argc, char **argv)
{
    static CVGpu Gpu;
    static CTexture textures[STATES];
    static TRasterState states[STATES];
    /* Front, back, right, left, top, bottom: two triangles each. */
    static const unsigned short state_of_face[12] = {GRATE, GRATE, BRICK, BRICK, STONE, STONE,
                                                     GRATE, GRATE, CRATE, CRATE, CRATE, CRATE};
    CTriangleList box;
    CMatrix matrix;
    int frames = frames_wanted(argc, argv, 30);

    start(&Gpu);
    make_texture(&textures[BRICK], brick_texel, -1);
    make_texture(&textures[STONE], stone_texel, -1);
    make_texture(&textures[CRATE], crate_texel, -1);
    make_texture(&textures[GRATE], grate_texel, 0);
    for (int i = 0; i < STATES; i++) {
        states[i] = state_of(i == GRATE ? DRAW_KEYED : DRAW_OPAQUE, 0, &textures[i]);
        /* The inside can be seen. */
        states[i].TestCulling = 0;
    }
    make_cube(&box, 110, VF_XYZ, IF_ABC | IF_UV, states);
    if (!box.BuildCmdList(state_of_face) || !Gpu.SetWorkMemory(8, 0)) {
        fprintf(stderr, "no memory: error %d\n", (int)box.ErrorCode);
        return 1;
    }
    printf("%d commands for %d triangles\n", box.CmdListSize, box.IndexListSize);
    Gpu.TriangleMode = TRI_ZC;
    Gpu.ViewMatrix = &matrix;
    for (int frame = 0; frame < frames; frame++) {
        matrix.LoadIdentity();
        matrix.Translate(0, 0, -520);
        matrix.RotateX(DEGREE(28));
        matrix.RotateY(-DEGREE(40) + frame * 41);
        Gpu.DrawTriangleList(&box);
        end_frame(&Gpu, frame, "Multi textures", COLOR_RGB(80, 120, 200) | COLOR_I(110));
    }
    box.Delete();
    Gpu.Delete();
    return 0;
}
