/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * blending.c: the two blends of RAVE and the factors of OpenGL, alpha tests,
 * channel masks, texture operations, the scissor.
 */
#include "rave_test.h"

#define SIZE 16

static Target target;
static TQADrawContext *context;

/* The cell that is drawn next. */
static int cell;

static void cell_rect(float *x, float *y)
{
    *x = (float)(cell % 20 * SIZE);
    *y = (float)(cell / 20 * SIZE);
}

static TQAUInt32 shown(int number)
{
    return at(&target, number % 20 * SIZE + SIZE / 2, number / 20 * SIZE + SIZE / 2);
}

/* One colour over another in a cell of its own; returns the cell. */
static int over(const float below[4], const float above[4])
{
    float x, y;
    TQAUInt32 blend = QAGetInt(context, kQATag_Blend);

    cell_rect(&x, &y);
    QASetInt(context, kQATag_Blend, kQABlend_PreMultiply);
    gouraud_rect(context, x, y, x + SIZE, y + SIZE, 0.6f, below[0], below[1], below[2], 1);
    QASetInt(context, kQATag_Blend, blend);
    gouraud_rect(context, x, y, x + SIZE, y + SIZE, 0.4f, above[0], above[1], above[2], above[3]);
    return cell++;
}

static const float grey[4] = {0.4f, 0.4f, 0.4f, 1};
static const float half_red[4] = {0.5f, 0.25f, 0, 0.5f};

/* Factors and what comes out of half_red on grey, in 0..1. */
typedef struct Factors {
    TQAUInt32 src, dst;
    float r, g, b;
} Factors;

static const Factors factors[] = {
    {0, 0, 0, 0, 0},                             /* zero, zero */
    {1, 0, 0.5f, 0.25f, 0},                      /* one, zero */
    {0, 1, 0.4f, 0.4f, 0.4f},                    /* zero, one */
    {1, 1, 0.9f, 0.65f, 0.4f},                   /* one, one */
    {0x302, 0x303, 0.45f, 0.325f, 0.2f},         /* by the source's alpha */
    {0x306, 0, 0.2f, 0.1f, 0},                   /* by the destination's colour */
    {0, 0x300, 0.2f, 0.1f, 0},                   /* by the source's colour */
    {0, 0x301, 0.2f, 0.3f, 0.4f},                /* by the rest of it */
    {0x307, 0, 0.3f, 0.15f, 0},                  /* by the rest of the destination's */
    {0x304, 0, 0.5f, 0.25f, 0},                  /* by the destination's alpha: 1 */
    {0x305, 1, 0.4f, 0.4f, 0.4f},                /* by the rest of it: 0 */
    {0x308, 1, 0.4f, 0.4f, 0.4f},                /* min(source, 1 - destination): 0 */
};

static int unit(float value)
{
    return (int)(value * 255 + 0.5f);
}

static void check_alpha_tests(int first)
{
    /* Alphas 0.25, 0.5 and 0.75 against 0.5, by function. */
    static const char passes[8][4] = {"111", "100", "010", "110", "001", "101", "011", "111"};
    int func, i;

    for (func = 0; func < 8; func++) {
        for (i = 0; i < 3; i++) {
            int is_drawn = is_near(shown(first + 3 * func + i), 0, 255, 0, 2);

            CHECK(is_drawn == (passes[func][i] == '1'));
        }
    }
}

static int draw_alpha_tests(void)
{
    int func, i, first = cell;

    QASetInt(context, kQATag_Blend, kQABlend_OpenGL);
    QASetInt(context, kQATagGL_BlendSrc, 1);
    QASetInt(context, kQATagGL_BlendDst, 0);
    /* 128 of 255, which 0.5 becomes too. */
    QASetFloat(context, kQATag_AlphaTestRef, 0.5f);
    for (func = 0; func < 8; func++) {
        for (i = 0; i < 3; i++) {
            float above[4] = {0, 1, 0, 0};

            above[3] = 0.25f * (float)(i + 1);
            QASetInt(context, kQATag_AlphaTestFunc, (TQAUInt32)func);
            over(grey, above);
        }
    }
    QASetInt(context, kQATag_AlphaTestFunc, kQAAlphaTest_None);
    return first;
}

/* A texel of (0.8, 0.4, 0.2) with half alpha under each operation. */
static void texture_cell(TQAUInt32 op, float kd, float ks, float a)
{
    TQAVTexture v[4];
    float x, y;
    int i;

    cell_rect(&x, &y);
    texture_corners(v, x, y, x + SIZE, y + SIZE, 0.4f);
    for (i = 0; i < 4; i++) {
        v[i].r = 0;
        v[i].g = 1;
        v[i].b = 0;
        v[i].a = a;
        v[i].kd_r = v[i].kd_g = v[i].kd_b = kd;
        v[i].ks_r = v[i].ks_g = v[i].ks_b = ks;
    }
    QASetInt(context, kQATag_TextureOp, op);
    QADrawVTexture(context, 4, kQAVertexMode_Strip, v, NULL);
    cell++;
}

int main(void)
{
    static TQAUInt32 texel = 0x80cc6633u, opaque = 0xffcc6633u, clear = 0x00cc6633u;
    int pre[3], inter[3], gl, tests, masks, textures, scissor, i;
    static const float light[4] = {0.2f, 0.1f, 0, 0};
    static const float solid[4] = {0.2f, 0.1f, 0, 1};
    TQATexture *texture, *solid_texture, *clear_texture;
    TQAEngine *engine;

    context = open_usual(&target, 320, 96);
    engine = engine_for(&target);
    texture = make_texture(engine, 0, kQAPixel_ARGB32, 1, 1, 4, &texel);
    solid_texture = make_texture(engine, 0, kQAPixel_ARGB32, 1, 1, 4, &opaque);
    clear_texture = make_texture(engine, 0, kQAPixel_ARGB32, 1, 1, 4, &clear);
    CHECK(QAGetInt(context, kQATag_Blend) == kQABlend_PreMultiply);
    background(context, 0, 0, 0);
    QARenderStart(context, NULL, NULL);
    pre[0] = over(grey, half_red);
    pre[1] = over(grey, light);
    pre[2] = over(grey, solid);
    QASetInt(context, kQATag_Blend, kQABlend_Interpolate);
    inter[0] = over(grey, half_red);
    inter[1] = over(grey, light);
    inter[2] = over(grey, solid);
    QASetInt(context, kQATag_Blend, kQABlend_OpenGL);
    gl = cell;
    for (i = 0; i < (int)(sizeof factors / sizeof *factors); i++) {
        QASetInt(context, kQATagGL_BlendSrc, factors[i].src);
        QASetInt(context, kQATagGL_BlendDst, factors[i].dst);
        over(grey, half_red);
    }
    tests = draw_alpha_tests();
    QASetInt(context, kQATag_Blend, kQABlend_PreMultiply);
    masks = cell;
    for (i = 0; i < 8; i++) {
        static const float white[4] = {1, 1, 1, 1};
        float x, y;

        cell_rect(&x, &y);
        gouraud_rect(context, x, y, x + SIZE, y + SIZE, 0.6f, 0.4f, 0.4f, 0.4f, 1);
        QASetInt(context, kQATag_ChannelMask, (TQAUInt32)i | kQAChannelMask_a);
        gouraud_rect(context, x, y, x + SIZE, y + SIZE, 0.4f, white[0], white[1], white[2], 1);
        QASetInt(context, kQATag_ChannelMask, 15);
        cell++;
    }
    textures = cell;
    QASetPtr(context, kQATag_Texture, solid_texture);
    texture_cell(kQATextureOp_None, 0.5f, 0.5f, 1);
    texture_cell(kQATextureOp_Modulate, 0.5f, 0.5f, 1);
    texture_cell(kQATextureOp_Modulate, 2, 0.5f, 1);
    texture_cell(kQATextureOp_Highlight, 0.5f, 0.5f, 1);
    texture_cell(kQATextureOp_Modulate | kQATextureOp_Highlight, 0.5f, 0.25f, 1);
    texture_cell(kQATextureOp_Decal, 0.5f, 0.5f, 1);
    QASetPtr(context, kQATag_Texture, clear_texture);
    texture_cell(kQATextureOp_Decal, 0.5f, 0.5f, 1);
    QASetPtr(context, kQATag_Texture, texture);
    texture_cell(kQATextureOp_Decal, 0.5f, 0.5f, 1);
    QASetInt(context, kQATag_Blend, kQABlend_Interpolate);
    texture_cell(kQATextureOp_None, 1, 0, 0.5f);
    QASetInt(context, kQATag_Blend, kQABlend_PreMultiply);
    QASetPtr(context, kQATag_Texture, NULL);
    QASetInt(context, kQATag_TextureOp, kQATextureOp_None);
    scissor = cell;
    {
        float x, y;

        cell_rect(&x, &y);
        QASetInt(context, kQATagGL_ScissorXMin, (TQAUInt32)x + 4);
        QASetInt(context, kQATagGL_ScissorYMin, (TQAUInt32)y + 4);
        QASetInt(context, kQATagGL_ScissorXMax, (TQAUInt32)x + 12);
        QASetInt(context, kQATagGL_ScissorYMax, (TQAUInt32)y + 12);
        gouraud_rect(context, x, y, x + SIZE, y + SIZE, 0.4f, 1, 1, 1, 1);
    }
    CHECK(QARenderEnd(context, NULL) == kQANoErr);

    /* The source is not multiplied: alpha 0 adds, alpha 1 replaces. */
    CHECK(is_near(shown(pre[0]), unit(0.7f), unit(0.45f), unit(0.2f), 2));
    CHECK(is_near(shown(pre[1]), unit(0.6f), unit(0.5f), unit(0.4f), 2));
    CHECK(is_near(shown(pre[2]), unit(0.2f), unit(0.1f), 0, 1));
    CHECK(is_near(shown(inter[0]), unit(0.45f), unit(0.325f), unit(0.2f), 2));
    CHECK(is_near(shown(inter[1]), unit(0.4f), unit(0.4f), unit(0.4f), 1));
    CHECK(is_near(shown(inter[2]), unit(0.2f), unit(0.1f), 0, 1));
    for (i = 0; i < (int)(sizeof factors / sizeof *factors); i++) {
        CHECK(is_near(shown(gl + i), unit(factors[i].r), unit(factors[i].g), unit(factors[i].b),
                      2));
    }
    check_alpha_tests(tests);
    for (i = 0; i < 8; i++) {
        CHECK(is_near(shown(masks + i), i & 1 ? 255 : 102, i & 2 ? 255 : 102, i & 4 ? 255 : 102,
                      1));
    }
    CHECK(is_near(shown(textures), 0xcc, 0x66, 0x33, 1));
    CHECK(is_near(shown(textures + 1), 0x66, 0x33, 0x1a, 2));
    CHECK(is_near(shown(textures + 2), 255, 0xcc, 0x66, 2));
    CHECK(is_near(shown(textures + 3), 255, 0xe6, 0xb3, 2));
    CHECK(is_near(shown(textures + 4), 0xa6, 0x73, 0x5a, 2));
    CHECK(is_near(shown(textures + 5), 0xcc, 0x66, 0x33, 1));
    CHECK(is_near(shown(textures + 6), 0, 255, 0, 1));
    CHECK(is_near(shown(textures + 7), 0x66, 0xb3, 0x1a, 2));
    /* Alpha is the product of both: a quarter over black. */
    CHECK(is_near(shown(textures + 8), 0x33, 0x1a, 0x0d, 2));
    {
        int x = scissor % 20 * SIZE, y = scissor / 20 * SIZE;

        CHECK(at(&target, x + 3, y + 8) == 0 && at(&target, x + 4, y + 4) == 0xffffff);
        CHECK(at(&target, x + 11, y + 11) == 0xffffff && at(&target, x + 12, y + 8) == 0);
        CHECK(at(&target, x + 8, y + 3) == 0 && at(&target, x + 8, y + 12) == 0);
    }
    CHECK(margin_is_clean(&target));
    QATextureDelete(engine, texture);
    QATextureDelete(engine, solid_texture);
    QATextureDelete(engine, clear_texture);
    QADrawContextDelete(context);
    return CHECK_REPORT();
}
