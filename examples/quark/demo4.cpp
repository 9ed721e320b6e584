/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * demo4: 3D sprites. A ring of 24 balls turns around a ring of trees; each is
 * a sprite that always faces the viewer, and they hide one another by depth.
 * ScrProjection, DrawSpriteScaleZb.
 */
#include "common.h"

/* Draws a sprite of `width` x `height` units that stands at a point. */
static void draw_billboard(CVGpu *Gpu, CTexture *texture, const int *at, int width, int height)
{
    int screen[3], corner[2], opposite[2];

    if (Gpu->ScrProjection(at, screen) & (16 | 32)) {
        return;
    }
    corner[0] = screen[0] - width * Gpu->Zoom / (2 * screen[2]);
    corner[1] = screen[1] - height * Gpu->Zoom / screen[2];
    opposite[0] = screen[0] + width * Gpu->Zoom / (2 * screen[2]);
    opposite[1] = screen[1];
    Gpu->SpriteState.Texture = texture;
    /* Farther sprites are darker. */
    int light = 300 - screen[2] / 5;
    Gpu->SpriteState.DrawIntensity = (unsigned char)(light > 255 ? 255 : light);
    Gpu->DrawSpriteScaleZb(corner, opposite, screen[2]);
}

int main(int argc, char **argv)
{
    static CVGpu Gpu;
    static CTexture ball, tree;
    CMatrix view;
    int frames = frames_wanted(argc, argv, 30);

    start(&Gpu);
    make_texture(&ball, ball_texel, 0);
    make_texture(&tree, tree_texel, 0);
    Gpu.SpriteState.DrawMode = DRAW_KEYED;
    for (int frame = 0; frame < frames; frame++) {
        view.LoadIdentity();
        view.Translate(0, -40, -620);
        view.RotateX(DEGREE(24));
        view.RotateY(frame * 30);
        for (int i = 0; i < 24; i++) {
            int angle = i * ANGLE2PI / 24;
            int local[3], world[3];
            local[0] = 280 * COSINUS(angle) >> TRIGO_SHIFT;
            local[1] = 60 * SINUS(angle * 3 + frame * 100) >> TRIGO_SHIFT;
            local[2] = 280 * SINUS(angle) >> TRIGO_SHIFT;
            view.TransformVector(local, world);
            draw_billboard(&Gpu, &ball, world, 70, 70);
        }
        for (int i = 0; i < 6; i++) {
            int angle = i * ANGLE2PI / 6;
            int local[3], world[3];
            local[0] = 120 * COSINUS(angle) >> TRIGO_SHIFT;
            local[1] = -60;
            local[2] = 120 * SINUS(angle) >> TRIGO_SHIFT;
            view.TransformVector(local, world);
            draw_billboard(&Gpu, &tree, world, 120, 180);
        }
        end_frame(&Gpu, frame, "Billboards", COLOR_RGB(80, 120, 200) | COLOR_I(120));
    }
    Gpu.Delete();
    return 0;
}
