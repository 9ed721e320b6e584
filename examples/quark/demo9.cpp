/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * demo9: face lightening. A faceted ball with one intensity for each face,
 * computed from the faces' normals. IF_I, BuildFNormalList, InvRotateVector.
 */
#include "common.h"

int main(int argc, char **argv)
{
    static CVGpu Gpu;
    static short normals[3 * 1000];
    static unsigned short states[1000];
    CTriangleList ball;
    TRasterState state;
    CMatrix matrix;
    int frames = frames_wanted(argc, argv, 30);

    start(&Gpu);
    state = state_of(DRAW_OPAQUE, COLOR_RGB(255, 200, 60), 0);
    make_sphere(&ball, 150, 10, 16, VF_XYZ, IF_ABC | IF_I, &state);
    if (!ball.BuildCmdList(states) || !ball.BuildFNormalList(normals, 3)
        || !Gpu.SetWorkMemory(ball.VertexListSize, 0)) {
        fprintf(stderr, "no memory: error %d\n", (int)ball.ErrorCode);
        return 1;
    }
    Gpu.TriangleMode = TRI_UT;
    Gpu.ViewMatrix = &matrix;
    for (int frame = 0; frame < frames; frame++) {
        int light[3];
        matrix.LoadIdentity();
        matrix.Translate(0, 0, -480);
        matrix.RotateX(DEGREE(20));
        matrix.RotateY(frame * 40);
        local_light(&matrix, -2, 3, 3, light);
        for (int i = 0; i < ball.IndexListSize; i++) {
            ball.SetI(i, lit(&normals[3 * i], light, 30));
        }
        Gpu.DrawTriangleList(&ball);
        end_frame(&Gpu, frame, "Face light", COLOR_RGB(60, 60, 120) | COLOR_I(60));
    }
    ball.Delete();
    Gpu.Delete();
    return 0;
}
