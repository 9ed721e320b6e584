/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * cache.c: a background that never changes is drawn once, into a cache context
 * with its colours and its depths. Every frame starts from the cache, and draws
 * only what moves: kites that fly behind the near hills and before the far ones.
 */
#include "common.h"

#define STEPS 80

/* The upper edge of a range of hills. */
static float ridge(int range, float x)
{
    float k = (float)range;

    return 118 + 26 * k + 12 * turn_sin(x / (170 - 25 * k) + 0.3f * k) +
           7 * turn_sin(x / (61 - 7 * k) + 0.7f * k) + 2 * turn_sin(x / 17 + k);
}

static void draw_background(const TQADrawContext *context)
{
    TQAVGouraud strip[2 * (STEPS + 1)], sky[4];
    int range, i;

    sky[0] = gouraud(0, 0, 0.95f, 0.10f, 0.16f, 0.38f, 1);
    sky[1] = gouraud(SCREEN_WIDTH, 0, 0.95f, 0.12f, 0.18f, 0.40f, 1);
    sky[2] = gouraud(0, 170, 0.95f, 0.96f, 0.62f, 0.44f, 1);
    sky[3] = gouraud(SCREEN_WIDTH, 170, 0.95f, 0.98f, 0.72f, 0.46f, 1);
    QADrawVGouraud(context, 4, kQAVertexMode_Strip, sky, NULL);
    strip[0] = gouraud(236, 92, 0.94f, 1, 0.95f, 0.78f, 1);
    for (i = 0; i <= STEPS; i++) {
        float turns = (float)i / STEPS;

        strip[i + 1] = gouraud(236 + 22 * turn_sin(turns), 92 - 22 * turn_cos(turns), 0.94f, 1,
                               0.86f, 0.55f, 1);
    }
    QADrawVGouraud(context, STEPS + 2, kQAVertexMode_Fan, strip, NULL);
    for (range = 0; range < 4; range++) {
        float k = (float)range, z = 0.8f - 0.2f * k;

        for (i = 0; i <= STEPS; i++) {
            float x = (float)i * SCREEN_WIDTH / STEPS, top = ridge(range, x);

            strip[2 * i] = gouraud(x, top, z, 0.46f - 0.1f * k, 0.36f - 0.06f * k,
                                   0.46f - 0.11f * k, 1);
            strip[2 * i + 1] = gouraud(x, SCREEN_HEIGHT, z, 0.3f - 0.06f * k, 0.28f - 0.04f * k,
                                       0.3f - 0.07f * k, 1);
        }
        QADrawVGouraud(context, 2 * (STEPS + 1), kQAVertexMode_Strip, strip, NULL);
    }
}

/* A kite that flies between two ranges. */
static void draw_kite(const TQADrawContext *context, int number, int frame)
{
    static const float colors[3][3] = {{0.95f, 0.25f, 0.2f}, {0.98f, 0.85f, 0.2f},
                                       {0.3f, 0.75f, 0.95f}};
    float k = (float)number, t = (float)frame, size = 26 + 8 * k;
    float x = 52 + 100 * k + 3 * t, y = 112 + 20 * k + 10 * turn_sin(t / 24 + k / 3);
    float z = 0.7f - 0.2f * k;
    const float *c = colors[number];
    TQAVGouraud v[4];

    v[0] = gouraud(x, y - size, z, c[0], c[1], c[2], 1);
    v[1] = gouraud(x + size * 0.6f, y, z, c[0] * 0.6f, c[1] * 0.6f, c[2] * 0.6f, 1);
    v[2] = gouraud(x - size * 0.6f, y, z, c[0], c[1], c[2], 1);
    v[3] = gouraud(x, y + size * 1.5f, z, c[0] * 0.4f, c[1] * 0.4f, c[2] * 0.4f, 1);
    QADrawVGouraud(context, 4, kQAVertexMode_Strip, v, NULL);
}

int main(int argc, char **argv)
{
    static Screen screen;
    TQADrawContext *cache;
    int frame, i, frames = frames_wanted(argc, argv, 8);

    open_screen(&screen, kQAPixel_RGB16_565, 0, kQAContext_DoubleBuffer);
    need(QADrawContextNew(&screen.device, &screen.rect, NULL, screen.engine,
                          kQAContext_DoubleBuffer | kQAContext_Cache, &cache),
         "QADrawContextNew of a cache");
    QARenderStart(cache, NULL, NULL);
    draw_background(cache);
    need(QARenderEnd(cache, NULL), "QARenderEnd of the cache");
    for (frame = 0; frame < frames; frame++) {
        QARenderStart(screen.context, NULL, cache);
        for (i = 0; i < 3; i++) {
            draw_kite(screen.context, i, frame);
        }
        need(QARenderEnd(screen.context, NULL), "QARenderEnd");
    }
    QADrawContextDelete(cache);
    QADrawContextDelete(screen.context);
    return 0;
}
