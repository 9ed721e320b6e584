/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * demo8: textured cube using a triangle list. The crate of demo7, pixel for
 * pixel, as a list of 8 vertices with texture coordinates in the faces.
 * CTriangleList, BuildCmdList, DrawTriangleList.
 */
#include "cube.h"

int main(int argc, char **argv)
{
    static CVGpu Gpu;
    static CTexture crate;
    static const unsigned short all_the_same[12] = {0};
    CTriangleList cube;
    TRasterState state;
    CMatrix matrix;
    int frames = frames_wanted(argc, argv, 30);

    start(&Gpu);
    make_texture(&crate, crate_texel, -1);
    state = state_of(DRAW_OPAQUE, 0, &crate);
    make_cube(&cube, 100, VF_XYZ, IF_ABC | IF_UV, &state);
    if (!Gpu.SetWorkMemory(8, 0) || !cube.BuildCmdList(all_the_same)) {
        fprintf(stderr, "no memory: error %d\n", (int)cube.ErrorCode);
        return 1;
    }
    Gpu.ViewMatrix = &matrix;
    for (int frame = 0; frame < frames; frame++) {
        Gpu.TriangleMode = frame / 750 % 2 ? TRI_NZC : TRI_ZC;
        place_cube(&matrix, frame);
        Gpu.DrawTriangleList(&cube);
        /* The same text as demo7, so that the pictures can be compared. */
        end_frame(&Gpu, frame, "Textured cube", COLOR_RGB(90, 90, 130) | COLOR_I(90));
    }
    cube.Delete();
    Gpu.Delete();
    return 0;
}
