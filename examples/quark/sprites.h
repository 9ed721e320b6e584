/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * sprites.h: the pictures of demo2 and demo3.
 */
#ifndef QUARK_SPRITES_H
#define QUARK_SPRITES_H

#include "common.h"

/* A night sky with hills, as large as the screen. */
static inline void make_landscape(CTexture *texture)
{
    static unsigned char texels[SCR_X * SCR_Y];

    for (int y = 0; y < SCR_Y; y++) {
        for (int x = 0; x < SCR_X; x++) {
            int far_hill = 190 + (24 * SINUS(x * 40) >> TRIGO_SHIFT)
                + (10 * SINUS(x * 130) >> TRIGO_SHIFT);
            int near_hill = 250 + (30 * COSINUS(x * 27 + 900) >> TRIGO_SHIFT);
            int dx = x - 190, dy = y - 50;
            unsigned char texel = dithered(y / 4, y / 3, 70 + y / 2, x, y);
            if (dx * dx + dy * dy < 600) {
                texel = dithered(255, 240, 190 + cloud(x, y, 64, 8) / 4, x, y);
            } else if (y < 170 && lattice(x, y) > 254) {
                texel = COLOR_RGB(255, 255, 255);
            }
            if (y > far_hill) {
                texel = dithered(40, 70, 90, x, y);
            }
            if (y > near_hill) {
                texel = dithered(10, 50 + (y - near_hill), 30, x, y);
            }
            texels[y * SCR_X + x] = texel;
        }
    }
    texture->Init(texels, SCR_X, SCR_Y, -1);
}

/* A house of 90x80, keyed by pure blue around it. */
static inline void make_house(CTexture *texture)
{
    static unsigned char texels[90 * 80];
    const unsigned char key = COLOR_RGB(0, 0, 255);

    for (int y = 0; y < 80; y++) {
        for (int x = 0; x < 90; x++) {
            unsigned char texel = key;
            if (y < 34 && abs(x - 45) < y * 44 / 34) {
                texel = dithered(170 + (y / 4 % 2) * 40, 40, 30, x, y);
            } else if (y >= 34 && x > 8 && x < 82) {
                texel = dithered(210, 200, 160 + cloud(x, y, 64, 8) / 8, x, y);
                if (x > 38 && x < 54 && y > 48) {
                    texel = dithered(100, 60, 20, x, y);
                }
                if (y > 44 && y < 60 && ((x > 16 && x < 30) || (x > 60 && x < 74))) {
                    texel = COLOR_RGB(255, 230, 80);
                    if (y == 52 || x == 23 || x == 67) {
                        texel = COLOR_RGB(90, 60, 20);
                    }
                }
            }
            texels[y * 90 + x] = texel;
        }
    }
    texture->Init(texels, 90, 80, key);
}

/* A ghost of 56x72, keyed by 0 around it. */
static inline void make_ghost(CTexture *texture)
{
    static unsigned char texels[56 * 72];

    for (int y = 0; y < 72; y++) {
        for (int x = 0; x < 56; x++) {
            int dx = x - 28, dy = y - 28;
            int inside = y < 28 ? dx * dx + dy * dy < 26 * 26 : abs(dx) < 26;
            int hem = 62 + (8 * SINUS(x * 650) >> TRIGO_SHIFT);
            unsigned char texel = 0;
            if (inside && y < hem) {
                int light = 255 - abs(dx + 6) * 3;
                texel = dithered(light, light, 255, x, y) | 1;
                int eye = (abs(dx) - 10) * (abs(dx) - 10) + (y - 24) * (y - 24);
                if (eye < 26) {
                    texel = COLOR_RGB(0, 0, 80);
                }
                if (dx * dx / 2 + (y - 42) * (y - 42) < 22) {
                    texel = COLOR_RGB(80, 0, 80);
                }
            }
            texels[y * 56 + x] = texel;
        }
    }
    texture->Init(texels, 56, 72, 0);
}

/* A pane of coloured glass, 70x50, without key. */
static inline void make_pane(CTexture *texture)
{
    static unsigned char texels[70 * 50];

    for (int y = 0; y < 50; y++) {
        for (int x = 0; x < 70; x++) {
            int frame = x < 3 || y < 3 || x > 66 || y > 46;
            texels[y * 70 + x] = frame ? COLOR_RGB(255, 255, 255)
                                       : dithered(255, 140 + (x + y) % 40, 0, x, y);
        }
    }
    texture->Init(texels, 70, 50, -1);
}

#endif
