/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * demo3: 2D scaled sprites. A house in all four modes, the ghost pulsing from
 * a quarter to four times its size, and sprites that hang over every edge of
 * the screen. DrawSpriteScale.
 */
#include "sprites.h"

static void draw(CVGpu *Gpu, CTexture *texture, int mode, int x, int y, int scale)
{
    Gpu->SpriteState.Texture = texture;
    Gpu->SpriteState.DrawMode = (unsigned char)mode;
    Gpu->DrawSpriteScale(x, y, scale);
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
        /* 64 to 1024: a quarter to four times. */
        int wave = 16384 + SINUS(frame * 190 + 2600);
        int scale = 64 + (960 * (wave >> 3) >> 12);
        draw(&Gpu, &landscape, DRAW_OPAQUE, -120, -160, 512);
        draw(&Gpu, &house, DRAW_OPAQUE, 4, 20, 128);
        draw(&Gpu, &house, DRAW_KEYED, 64, 20, 160);
        draw(&Gpu, &house, DRAW_ALPHA, 126, 20, 128);
        draw(&Gpu, &house, DRAW_ALPHAKEYED, 180, 20, 192);
        draw(&Gpu, &ghost, DRAW_ALPHAKEYED, SCR_X / 2 - (28 * scale >> 8),
             SCR_Y / 2 - (36 * scale >> 8), scale);
        draw(&Gpu, &ghost, DRAW_KEYED, -30, 240, 320);
        draw(&Gpu, &ghost, DRAW_KEYED, SCR_X - 30, 110, 256);
        draw(&Gpu, &pane, DRAW_ALPHA, 90, -20, 256);
        draw(&Gpu, &pane, DRAW_OPAQUE, 100, SCR_Y - 30, 300);
        end_frame(&Gpu, frame, "Scaled sprites", 0);
    }
    Gpu.Delete();
    return 0;
}
