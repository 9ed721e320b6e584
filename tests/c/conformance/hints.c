/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * hints.c: which w, s and t a texture unit reads: without hints both units
 * follow unit 0's s and t and the vertex's w; each hint gives one of them its
 * own. Cells left to right: no hint, ST of unit 1, W of unit 0, W of unit 1,
 * everything; unit 1 alone, which reads its own even without a hint.
 */
#include "conformance.h"

static FxU16 shots[2][78][104];

static void draw(Box box)
{
    GrVertex v[4];
    int i;

    for (i = 0; i < 4; i++) {
        int right = i == 1 || i == 2, low = i >= 2;

        v[i] = vertex((float)(right ? box.x1 : box.x0), (float)(low ? box.y1 : box.y0), rgb(1, 1, 1));
        v[i].oow = right ? 0.25f : 1.0f;
        v[i].tmuvtx[0].sow = (right ? 256.0f : 0.0f) * v[i].oow;
        v[i].tmuvtx[0].tow = (low ? 256.0f : 0.0f);
        v[i].tmuvtx[1].sow = (low ? 512.0f : 0.0f) * v[i].oow;
        v[i].tmuvtx[1].tow = (right ? 512.0f : 0.0f) * v[i].oow;
        v[i].tmuvtx[0].oow = right ? 0.5f : 1.0f;
        v[i].tmuvtx[1].oow = 1.0f;
    }
    draw_quad(&v[0], &v[1], &v[2], &v[3]);
}

static void shoot(Box box, int which)
{
    CHECK(grLfbReadRegion(GR_BUFFER_BACKBUFFER, (FxU32)box.x0, (FxU32)box.y0, 104, 78,
                          sizeof shots[0][0], shots[which]));
}

int main(void)
{
    static const FxU32 masks[5] = {
        0, GR_STWHINT_ST_DIFF_TMU1, GR_STWHINT_W_DIFF_TMU0, GR_STWHINT_W_DIFF_TMU1,
        GR_STWHINT_ST_DIFF_TMU1 | GR_STWHINT_W_DIFF_TMU0 | GR_STWHINT_W_DIFF_TMU1 | GR_STWHINT_W_DIFF_FBI};
    Texture t, u;
    int i, units = open_small(GR_ORIGIN_UPPER_LEFT);

    clear_to(0x202020);
    guColorCombineFunction(GR_COLORCOMBINE_DECAL_TEXTURE);
    t = load_texture(GR_TMU0, test_card, GR_TEXFMT_RGB_565, GR_LOD_64);
    use_texture(GR_TMU0, &t);
    if (units > 1) {
        u = load_texture(GR_TMU1, test_card, GR_TEXFMT_INTENSITY_8, GR_LOD_64);
        use_texture(GR_TMU1, &u);
        grTexCombineFunction(GR_TMU0, GR_TEXTURECOMBINE_MULTIPLY);
    }
    for (i = 0; i < 5; i++) {
        grHints(GR_HINT_STWHINT, masks[i]);
        draw(cell(i, 3, 3));
        if (i > 0 && units > 1) {
            shoot(cell(0, 3, 3), 0);
            shoot(cell(i, 3, 3), 1);
            CHECK(memcmp(shots[0], shots[1], sizeof shots[0]) != 0);
        }
    }
    grHints(GR_HINT_STWHINT, 0);
    if (units > 1) {
        grTexCombineFunction(GR_TMU0, GR_TEXTURECOMBINE_OTHER);
        draw(cell(5, 3, 3));
        grTexCombineFunction(GR_TMU0, GR_TEXTURECOMBINE_DECAL);
    }
    /* The others promise or ask for nothing that can be seen. */
    shoot(cell(0, 3, 3), 0);
    grHints(GR_HINT_FIFOCHECKHINT, GR_GENERATE_FIFOCHECK_HINT_MASK(64, 16));
    grHints(GR_HINT_FPUPRECISION, 1);
    draw(cell(6, 3, 3));
    grHints(GR_HINTTYPE_MAX + 1, 0);
    CHECK(told_once("grHints: "));
    grBufferSwap(0);
    return finish();
}
