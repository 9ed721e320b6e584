/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * demo2: 2D sprites. An opaque landscape, a keyed house, a pane at half
 * transparency, and a ghost that is keyed and half transparent. None of the
 * sizes is a power of two. DrawSprite, SpriteState.
 */
#include "sprites.h"

static void draw(CVGpu *Gpu, CTexture *texture, int mode, int x, int y)
{
    Gpu->SpriteState.Texture = texture;
    Gpu->SpriteState.DrawMode = (unsigned char)mode;
    Gpu->DrawSprite(x, y);
}

int main(int argc, char **argv)
{
    static CVGpu Gpu;
    static CTexture landscape, house, ghost, pane;
    int frames = frames_wanted(argc, argv, 30);

    start(&Gpu);
    make_landscape(&landscape);
    make_house(&house);
    make_ghost(&ghost);
    make_pane(&pane);
    for (int frame = 0; frame < frames; frame++) {
        int sway = 20 * SINUS(frame * 200) >> TRIGO_SHIFT;
        Gpu.SpriteState.DrawIntensity = 255;
        draw(&Gpu, &landscape, DRAW_OPAQUE, 0, 0);
        draw(&Gpu, &house, DRAW_KEYED, 24, 190);
        Gpu.SpriteState.DrawIntensity = 150;
        draw(&Gpu, &house, DRAW_KEYED, 160, 232);
        Gpu.SpriteState.DrawIntensity = 255;
        draw(&Gpu, &pane, DRAW_ALPHA, 150, 110 + sway / 2);
        draw(&Gpu, &ghost, DRAW_ALPHAKEYED, 60 + frame * 2, 130 + sway);
        draw(&Gpu, &ghost, DRAW_ALPHAKEYED, -20 + frame, 30 - sway);
        end_frame(&Gpu, frame, "Sprites", 0);
    }
    Gpu.Delete();
    return 0;
}
