/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * demo6: cube drawing. A turning cube of six colours, side 200, twelve
 * triangles; faces that are turned away are dropped. CMatrix, TestCulling.
 */
#include "cube.h"

int main(int argc, char **argv)
{
    static CVGpu Gpu;
    static const unsigned char colors[6] = {
        COLOR_RGB(255, 60, 60),  COLOR_RGB(60, 220, 60),   COLOR_RGB(60, 90, 255),
        COLOR_RGB(255, 220, 0),  COLOR_RGB(255, 255, 255), COLOR_RGB(255, 120, 255)};
    TRasterState state;
    CMatrix matrix;
    int frames = frames_wanted(argc, argv, 30);

    start(&Gpu);
    state = state_of(DRAW_OPAQUE, 0, 0);
    Gpu.TriangleState = &state;
    Gpu.TriangleMode = TRI_UT;
    for (int frame = 0; frame < frames; frame++) {
        place_cube(&matrix, frame);
        draw_cube(&Gpu, &matrix, 100, colors);
        end_frame(&Gpu, frame, "Cube", COLOR_RGB(90, 90, 130) | COLOR_I(90));
    }
    Gpu.Delete();
    return 0;
}
