/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * fog.c: every mode at several distances, against the formulas.
 */
#include "rave_test.h"

#define CELL 16
#define STEPS 16

static Target target;
static TQADrawContext *context;

/* A cell at view depth `w`, orange, with an alpha. */
static void draw_cell(int x, int row, float w, float alpha)
{
    TQAVGouraud v[4];
    int i;

    for (i = 0; i < 4; i++) {
        v[i] = gv((float)(x * CELL + i % 2 * CELL), (float)(row * CELL + i / 2 * CELL), 0.5f, 1,
                  0.5f, 0, alpha);
        v[i].invW = w > 0 ? 1 / w : 0;
    }
    QADrawVGouraud(context, 4, kQAVertexMode_Strip, v, NULL);
}

static float clamp(float f)
{
    return f < 0 ? 0 : f > 1 ? 1 : f;
}

/* The part that is not fog, by mode: start 2, end 10, density 0.2. */
static float clear_part(int mode, float w, float alpha)
{
    switch (mode) {
    case kQAFogMode_Alpha: return alpha;
    case kQAFogMode_Linear: return clamp((10 - w) / 8);
    case kQAFogMode_Exponential: return clamp((float)exp(-0.2 * w));
    case kQAFogMode_ExponentialSquared: return clamp((float)exp(-0.04 * w * w));
    default: return 1;
    }
}

static void check_cell(int x, int row, float f)
{
    /* Fog is (0.2, 0.4, 0.8). */
    int r = (int)(255 * (f + (1 - f) * 0.2f) + 0.5f);
    int g = (int)(255 * (f * 0.5f + (1 - f) * 0.4f) + 0.5f);
    int b = (int)(255 * (1 - f) * 0.8f + 0.5f);

    CHECK(is_near(at(&target, x * CELL + CELL / 2, row * CELL + CELL / 2), r, g, b, 4));
}

int main(void)
{
    int mode, i;

    context = open_usual(&target, STEPS * CELL, 6 * CELL);
    background(context, 0, 0, 0);
    QASetFloat(context, kQATag_FogColor_a, 1);
    QASetFloat(context, kQATag_FogColor_r, 0.2f);
    QASetFloat(context, kQATag_FogColor_g, 0.4f);
    QASetFloat(context, kQATag_FogColor_b, 0.8f);
    QASetFloat(context, kQATag_FogStart, 2);
    QASetFloat(context, kQATag_FogEnd, 10);
    QASetFloat(context, kQATag_FogDensity, 0.2f);
    QASetFloat(context, kQATag_FogMaxDepth, 16);
    QARenderStart(context, NULL, NULL);
    for (mode = 0; mode <= kQAFogMode_ExponentialSquared; mode++) {
        QASetInt(context, kQATag_FogMode, (TQAUInt32)mode);
        for (i = 0; i < STEPS; i++) {
            float alpha = mode == kQAFogMode_Alpha ? (float)i / (STEPS - 1) : 1;

            draw_cell(i, mode, (float)(i + 1) * 0.75f, alpha);
        }
    }
    /* Without a depth, z times the largest depth: 8 here. A mode that is none
     * changes nothing. */
    QASetInt(context, kQATag_FogMode, kQAFogMode_Linear);
    QASetInt(context, kQATag_FogMode, 17);
    draw_cell(0, 5, 0, 1);
    QASetFloat(context, kQATag_FogStart, 4);
    QASetFloat(context, kQATag_FogEnd, 4);
    draw_cell(1, 5, 3, 1);
    draw_cell(2, 5, 5, 1);
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
    for (mode = 0; mode <= kQAFogMode_ExponentialSquared; mode++) {
        for (i = 0; i < STEPS; i++) {
            check_cell(i, mode,
                       clear_part(mode, (float)(i + 1) * 0.75f, (float)i / (STEPS - 1)));
        }
    }
    check_cell(0, 5, 0.25f);
    check_cell(1, 5, 1);
    check_cell(2, 5, 0);
    CHECK(margin_is_clean(&target));
    QADrawContextDelete(context);
    return CHECK_REPORT();
}
