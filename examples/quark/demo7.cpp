/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * demo7: textured cube. The cube of demo6 as a crate, 64x64 texels, with
 * perspective correction; every second half minute without. CTexture, TRI_ZC.
 */
#include "cube.h"

int main(int argc, char **argv)
{
    static CVGpu Gpu;
    static CTexture crate;
    TRasterState state;
    CMatrix matrix;
    int frames = frames_wanted(argc, argv, 30);

    start(&Gpu);
    make_texture(&crate, crate_texel, -1);
    state = state_of(DRAW_OPAQUE, 0, &crate);
    Gpu.TriangleState = &state;
    for (int frame = 0; frame < frames; frame++) {
        Gpu.TriangleMode = frame / 750 % 2 ? TRI_NZC : TRI_ZC;
        place_cube(&matrix, frame);
        draw_cube(&Gpu, &matrix, 100, 0);
        end_frame(&Gpu, frame, "Textured cube", COLOR_RGB(90, 90, 130) | COLOR_I(90));
    }
    Gpu.Delete();
    return 0;
}
