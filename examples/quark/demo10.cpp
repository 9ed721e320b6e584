/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * demo10: vertex lightening. A ring of 512 faces and a ball, shaded smoothly
 * by an intensity for each vertex. VF_I, BuildVNormalList.
 */
#include "common.h"

/* An object with the normals of its vertices. */
struct Lit
{
    CTriangleList list;
    TRasterState state;
    short normals[3 * 600];
};

static void draw(CVGpu *Gpu, Lit *object, CMatrix *matrix)
{
    int light[3];

    local_light(matrix, 3, 3, 4, light);
    for (int i = 0; i < object->list.VertexListSize; i++) {
        object->list.SetI(i, lit(&object->normals[3 * i], light, 20));
    }
    Gpu->ViewMatrix = matrix;
    Gpu->DrawTriangleList(&object->list);
}

int main(int argc, char **argv)
{
    static CVGpu Gpu;
    static Lit ring, ball;
    CMatrix matrix;
    int frames = frames_wanted(argc, argv, 30);

    start(&Gpu);
    ring.state = state_of(DRAW_OPAQUE, COLOR_RGB(60, 220, 120), 0);
    ball.state = state_of(DRAW_OPAQUE, COLOR_RGB(255, 80, 60), 0);
    make_ring(&ring.list, 140, 50, 32, 8, VF_XYZ | VF_I, IF_ABC, &ring.state);
    make_sphere(&ball.list, 70, 12, 16, VF_XYZ | VF_I, IF_ABC, &ball.state);
    /* The seam of the ball has each vertex twice. */
    ball.list.WeldVertex(0, 255, 0);
    if (!ring.list.BuildVNormalList(ring.normals, 3) || !ball.list.BuildVNormalList(ball.normals, 3)
        || !Gpu.SetWorkMemory(600, 0)) {
        fprintf(stderr, "no memory\n");
        return 1;
    }
    Gpu.TriangleMode = TRI_UT;
    for (int frame = 0; frame < frames; frame++) {
        matrix.LoadIdentity();
        matrix.Translate(0, 0, -520);
        matrix.RotateX(-DEGREE(50) + frame * 20);
        matrix.RotateZ(frame * 33);
        draw(&Gpu, &ring, &matrix);
        draw(&Gpu, &ball, &matrix);
        end_frame(&Gpu, frame, "Vertex light", COLOR_RGB(60, 60, 120) | COLOR_I(60));
    }
    ring.list.Delete();
    ball.list.Delete();
    Gpu.Delete();
    return 0;
}
