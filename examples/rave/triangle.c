/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * triangle.c: the shortest RAVE program: one triangle with a colour at each
 * corner, in a double-buffered context of 16-bit pixels. Behind it turns a
 * dimmer one: a z buffer decides who is in front.
 */
#include "common.h"

int main(int argc, char **argv)
{
    static Screen screen;
    int frame, frames = frames_wanted(argc, argv, 8);

    open_screen(&screen, kQAPixel_RGB16, 0, kQAContext_DoubleBuffer);
    set_background(screen.context, 0.06f, 0.07f, 0.12f);
    for (frame = 0; frame < frames; frame++) {
        TQAVGouraud v[3];
        int i;

        QARenderStart(screen.context, NULL, NULL);
        for (i = 0; i < 3; i++) {
            float turns = (float)i / 3 + (float)frame / 64;

            v[i] = gouraud(160 + 112 * turn_sin(turns), 124 - 112 * turn_cos(turns), 0.8f,
                           0.15f + 0.35f * (float)(i == 1), 0.2f + 0.2f * (float)(i == 2), 0.45f,
                           1);
        }
        QADrawTriGouraud(screen.context, &v[0], &v[1], &v[2], kQATriFlags_None);
        v[0] = gouraud(160, 30, 0.4f, 1, 0.1f, 0.1f, 1);
        v[1] = gouraud(262, 200, 0.4f, 0.1f, 1, 0.1f, 1);
        v[2] = gouraud(58, 200, 0.4f, 0.15f, 0.2f, 1, 1);
        QADrawTriGouraud(screen.context, &v[0], &v[1], &v[2], kQATriFlags_None);
        need(QARenderEnd(screen.context, NULL), "QARenderEnd");
    }
    QADrawContextDelete(screen.context);
    return 0;
}
