/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * presets.c: the ready-made colour combine functions (first three rows), alpha
 * sources and texture combine functions: each draws what the same set-up
 * through the combine units draws.
 */
#include "conformance.h"

typedef struct {
    GrCombineFunction_t function;
    GrCombineFactor_t factor;
    GrCombineLocal_t local;
    GrCombineOther_t other;
    FxBool invert;
} SetUp;

#define ITERATED GR_COMBINE_LOCAL_ITERATED
#define CONSTANT GR_COMBINE_LOCAL_CONSTANT
#define TEXTURE GR_COMBINE_OTHER_TEXTURE
#define NONE GR_COMBINE_OTHER_NONE

/* As the guide describes the functions, by number. */
static const SetUp colors[17] = {
    {0, 0, CONSTANT, NONE, 0}, {1, 0, CONSTANT, NONE, 0}, {1, 0, ITERATED, NONE, 0}, {1, 0, ITERATED, NONE, 0},
    {3, 8, CONSTANT, TEXTURE, 0}, {3, 1, CONSTANT, TEXTURE, 0}, {3, 1, ITERATED, TEXTURE, 0},
    {3, 1, ITERATED, TEXTURE, 0}, {5, 1, ITERATED, TEXTURE, 0}, {3, 3, CONSTANT, TEXTURE, 0},
    {4, 3, ITERATED, TEXTURE, 0}, {4, 8, ITERATED, TEXTURE, 0}, {6, 8, ITERATED, TEXTURE, 0},
    {7, 4, CONSTANT, GR_COMBINE_OTHER_ITERATED, 0}, {4, 3, ITERATED, TEXTURE, 0},
    {5, 1, ITERATED, TEXTURE, 0}, {0, 0, CONSTANT, NONE, 1}
};
static const SetUp alphas[4] = {
    {1, 0, CONSTANT, NONE, 0}, {1, 0, ITERATED, NONE, 0}, {3, 8, CONSTANT, TEXTURE, 0}, {3, 1, ITERATED, TEXTURE, 0}
};
static const int textures[11][3] = { /* function, factor, inverted */
    {0, 0, 0}, {1, 0, 0}, {3, 8, 0}, {4, 8, 0}, {3, 1, 0}, {6, 8, 0}, {7, 0xc, 0}, {7, 4, 0}, {7, 0xd, 0}, {7, 5, 0}, {0, 0, 1}
};

static FxU16 shots[2][36][36];

static void draw(Box box, int which)
{
    grClipWindow((FxU32)box.x0, (FxU32)box.y0, (FxU32)box.x1, (FxU32)box.y1);
    clear_to(0x00003c);
    grClipWindow(0, 0, WIDE, HIGH);
    shaded_box(box, rgba(1, 0, 0, 0.2f), rgba(0, 1, 0, 0.9f), rgba(0, 0, 1, 0.5f), rgba(1, 1, 1, 1));
    CHECK(grLfbReadRegion(GR_BUFFER_BACKBUFFER, (FxU32)box.x0 + 1, (FxU32)box.y0 + 1, 36, 36,
                          sizeof shots[0][0], shots[which]));
}

int main(void)
{
    Texture t, u;
    int i, units = open_small(GR_ORIGIN_UPPER_LEFT);

    t = load_texture(GR_TMU0, test_card, GR_TEXFMT_ARGB_4444, GR_LOD_64);
    use_texture(GR_TMU0, &t);
    grTexClampMode(GR_TMU0, GR_TEXTURECLAMP_CLAMP, GR_TEXTURECLAMP_CLAMP);
    if (units > 1) {
        u = load_texture(GR_TMU1, test_card, GR_TEXFMT_INTENSITY_8, GR_LOD_32);
        use_texture(GR_TMU1, &u);
    }
    clear_to(0x303030);
    use_blending();
    grConstantColorValue(0x8040c0ff);
    grConstantColorValue4(255.0f, 200.0f, 100.0f, 50.0f);
    grTexDetailControl(GR_TMU0, 20, 3, 0.8f);
    for (i = 0; i < 17; i++) {
        Box box = cell(i, 8, 6);
        const SetUp *s = &colors[i];

        guAlphaSource(GR_ALPHASOURCE_ITERATED_ALPHA);
        if (i == GR_COLORCOMBINE_ITRGB_DELTA0 || i == GR_COLORCOMBINE_TEXTURE_TIMES_ITRGB_DELTA0) {
            guColorCombineFunction(i); /* the constant in place of the iterated colour */
            draw(box, 0);
            CHECK(i != GR_COLORCOMBINE_ITRGB_DELTA0 || red_of(shots[0][30][30]) <= 200);
            continue;
        }
        grColorCombine(s->function, s->factor, s->local, s->other, s->invert);
        draw(box, 0);
        guColorCombineFunction(i);
        draw(box, 1);
        CHECK(memcmp(shots[0], shots[1], sizeof shots[0]) == 0);
    }
    guColorCombineFunction(GR_COLORCOMBINE_ITRGB);
    for (i = 0; i < 4; i++) {
        Box box = cell(24 + i, 8, 6);
        const SetUp *s = &alphas[i];

        grAlphaCombine(s->function, s->factor, s->local, s->other, s->invert);
        draw(box, 0);
        guAlphaSource(i);
        draw(box, 1);
        CHECK(memcmp(shots[0], shots[1], sizeof shots[0]) == 0);
    }
    guColorCombineFunction(GR_COLORCOMBINE_DECAL_TEXTURE);
    for (i = 0; i < 11; i++) {
        Box box = cell(32 + i, 8, 6);
        const int *s = textures[i];

        grTexCombine(GR_TMU0, s[0], s[1], s[0], s[1], s[2], s[2]);
        draw(box, 0);
        guTexCombineFunction(GR_TMU0, i);
        draw(box, 1);
        CHECK(memcmp(shots[0], shots[1], sizeof shots[0]) == 0);
        grTexCombineFunction(GR_TMU0, i);
        draw(box, 1);
        CHECK(memcmp(shots[0], shots[1], sizeof shots[0]) == 0);
    }
    guTexCombineFunction(GR_TMU0, 11);
    CHECK(told_once("grTexCombineFunction: ") || errors_told == 0);
    grBufferSwap(0);
    return finish();
}
