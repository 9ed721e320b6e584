/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * depth.c: every Z function, nearer, equal and farther; the mask; contexts with
 * deep z, without z, and by perspective; the clear value and the far end.
 */
#include "rave_test.h"

#define CELL 10

static const TQAUInt32 flag_sets[3] = {kQAContext_None, kQAContext_DeepZ, kQAContext_NoZBuffer};

/* Whether a fragment passes by function: nearer, equal, farther. */
static const char passes[9][4] = {"111", "100", "010", "110", "001", "101", "011", "111", "000"};
/* Whether it then leaves its depth. */
static const char writes[10] = "011111110";

static void cell_rect(const TQADrawContext *context, int x, int y, float z, float r, float g,
                      float b)
{
    float left = (float)(x * CELL), top = (float)(y * CELL);

    gouraud_rect(context, left, top, left + CELL, top + CELL, z, r, g, b, 1);
}

static TQAUInt32 cell(const Target *target, int x, int y)
{
    return at(target, x * CELL + CELL / 2, y * CELL + CELL / 2);
}

/* Blue at 0.5, then green nearer, equal and farther, then red at a depth that
 * tells who left theirs. */
static void draw_functions(TQADrawContext *context, int row)
{
    static const float depths[3] = {0.25f, 0.5f, 0.75f};
    int func, i;

    for (func = 0; func <= 8; func++) {
        for (i = 0; i < 3; i++) {
            int x = 3 * func + i;

            QASetInt(context, kQATag_ZFunction, kQAZFunction_LT);
            cell_rect(context, x, row, 0.5f, 0, 0, 1);
            QASetInt(context, kQATag_ZFunction, (TQAUInt32)func);
            cell_rect(context, x, row, depths[i], 0, 1, 0);
            QASetInt(context, kQATag_ZFunction, kQAZFunction_LT);
            /* Between 0.25 and 0.5: seen unless a nearer one left its depth. */
            cell_rect(context, x, row + 1, 0.5f, 0, 0, 1);
            QASetInt(context, kQATag_ZFunction, (TQAUInt32)func);
            cell_rect(context, x, row + 1, depths[i], 0, 1, 0);
            QASetInt(context, kQATag_ZFunction, kQAZFunction_LT);
            cell_rect(context, x, row + 1, 0.4f, 1, 0, 0);
        }
    }
}

static void check_functions(const Target *target, int row)
{
    int func, i;

    for (func = 0; func <= 8; func++) {
        for (i = 0; i < 3; i++) {
            int x = 3 * func + i, is_drawn = passes[func][i] == '1';
            int hides = is_drawn && writes[func] == '1' && i == 0;

            CHECK(cell(target, x, row) == (is_drawn ? 0x00ff00u : 0x0000ffu));
            CHECK((cell(target, x, row + 1) == 0xff0000) == !hides);
        }
    }
}

static void check_context(TQAUInt32 flags, int has_z)
{
    static Target target;
    TQADrawContext *context;

    init_target(&target, kQAPixel_RGB32, 27 * CELL, 4 * CELL, 0);
    context = open_context(&target, flags | kQAContext_DoubleBuffer);
    CHECK(QAGetInt(context, kQATag_ZFunction) == (has_z ? kQAZFunction_LT : kQAZFunction_None));
    QARenderStart(context, NULL, NULL);
    draw_functions(context, 0);
    /* Test without a write. */
    QASetInt(context, kQATag_ZBufferMask, kQAZBufferMask_Disable);
    cell_rect(context, 0, 2, 0.3f, 0, 1, 0);
    QASetInt(context, kQATag_ZBufferMask, kQAZBufferMask_Enable);
    cell_rect(context, 0, 2, 0.6f, 1, 0, 0);
    /* The far end never shows; just before it does. */
    cell_rect(context, 1, 2, 1.0f, 1, 0, 0);
    cell_rect(context, 2, 2,
              1.0f * QAGetFloat(context, kQATag_ZMinScale) +
                  QAGetFloat(context, kQATag_ZMinOffset),
              1, 0, 0);
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
    if (has_z) {
        check_functions(&target, 0);
        CHECK(cell(&target, 1, 2) == 0);
    } else {
        CHECK(QAGetInt(context, kQATag_ZFunction) == kQAZFunction_None);
        CHECK(cell(&target, 1, 2) == 0xff0000);
    }
    CHECK(cell(&target, 0, 2) == 0xff0000);
    CHECK(cell(&target, 2, 2) == 0xff0000);
    CHECK(margin_is_clean(&target));
    QADrawContextDelete(context);
}

/* By perspective, larger invW is nearer whatever z says. */
static void check_perspective(void)
{
    static Target target;
    TQADrawContext *context = open_usual(&target, 4 * CELL, CELL);
    TQAVGouraud v[3];
    int i, n;

    QASetInt(context, kQATag_PerspectiveZ, kQAPerspectiveZ_On);
    QARenderStart(context, NULL, NULL);
    for (i = 0; i < 4; i++) {
        static const float inverse[4][2] = {{0.5f, 0.6f}, {0.5f, 0.4f}, {0.5f, 0.5f}, {0.9f, 2}};
        float x = (float)(i * CELL);

        for (n = 0; n < 2; n++) {
            v[0] = gv(x - 8, 0, n == 0 ? 0.1f : 0.9f, (float)n, (float)!n, 0, 1);
            v[1] = gv(x + 40, 0, v[0].z, (float)n, (float)!n, 0, 1);
            v[2] = gv(x - 8, 40, v[0].z, (float)n, (float)!n, 0, 1);
            v[0].invW = v[1].invW = v[2].invW = inverse[i][n];
            QASetInt(context, kQATagGL_ScissorXMin, (TQAUInt32)x);
            QASetInt(context, kQATagGL_ScissorXMax, (TQAUInt32)x + CELL);
            QADrawTriGouraud(context, &v[0], &v[1], &v[2], kQATriFlags_None);
        }
    }
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
    CHECK(cell(&target, 0, 0) == 0xff0000);
    CHECK(cell(&target, 1, 0) == 0x00ff00);
    CHECK(cell(&target, 2, 0) == 0x00ff00);
    CHECK(cell(&target, 3, 0) == 0xff0000);
    QADrawContextDelete(context);
}

/* The depth that a frame starts with can be set. */
static void check_background_depth(void)
{
    static Target target;
    TQADrawContext *context = open_usual(&target, 2 * CELL, CELL);

    QASetFloat(context, kQATagGL_DepthBG, 0.5f);
    QARenderStart(context, NULL, NULL);
    cell_rect(context, 0, 0, 0.6f, 1, 0, 0);
    cell_rect(context, 1, 0, 0.4f, 1, 0, 0);
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
    CHECK(cell(&target, 0, 0) == 0 && cell(&target, 1, 0) == 0xff0000);
    QADrawContextDelete(context);
}

int main(void)
{
    int i;

    check_perspective();
    check_background_depth();
    for (i = 2; i >= 0; i--) {
        check_context(flag_sets[i], i < 2);
    }
    return CHECK_REPORT();
}
