/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * counters.c: the pixel counters and what stops pixels, and the triangle
 * counters; the picture shows what was counted.
 */
#include "conformance.h"

static GrSstPerfStats_t count(void)
{
    GrSstPerfStats_t stats;

    grSstIdle();
    memset(&stats, 0x5a, sizeof stats);
    grSstPerfStats(&stats);
    return stats;
}

int main(void)
{
    GrSstPerfStats_t s;
    Box box = {10, 10, 110, 60};
    FxU32 processed, drawn;

    open_small(GR_ORIGIN_UPPER_LEFT);
    use_vertex_colors();
    clear_to(0x303030);
    grSstResetPerfStats();
    s = count();
    CHECK(s.pixelsIn == 0 && s.pixelsOut == 0 && s.chromaFail == 0 && s.zFuncFail == 0 && s.aFuncFail == 0);
    fill_box(box, 255, 255, 0, 0);
    s = count();
    CHECK(s.pixelsIn == 5000 && s.pixelsOut == 5000);
    /* The colour mask does not change what is counted. */
    grColorMask(FXFALSE, FXFALSE);
    fill_box(box, 255, 255, 0, 0);
    grColorMask(FXTRUE, FXFALSE);
    s = count();
    CHECK(s.pixelsIn == 10000 && s.pixelsOut == 10000);
    grSstResetPerfStats();
    grAlphaTestFunction(GR_CMP_LESS);
    grAlphaTestReferenceValue(100);
    box.y0 = 70, box.y1 = 120;
    fill_box(box, 200, 0, 255, 0);
    grAlphaTestFunction(GR_CMP_ALWAYS);
    s = count();
    CHECK(s.aFuncFail == 5000 && s.pixelsOut == 0);
    use_z_buffer();
    grBufferClear(0x303030, 0, 40000);
    grSstResetPerfStats();
    box.x0 = 120, box.x1 = 220;
    flat_box(box, 255, 255, 255, 0, 30000.0f, 1.0f);
    s = count();
    CHECK(s.zFuncFail == 5000 && s.pixelsOut == 0 && s.pixelsIn == 5000);
    flat_box(box, 255, 255, 255, 0, 50000.0f, 1.0f);
    use_no_depth_buffer();
    grChromakeyMode(GR_CHROMAKEY_ENABLE);
    grChromakeyValue(0x0000ff);
    grColorCombine(GR_COMBINE_FUNCTION_SCALE_OTHER, GR_COMBINE_FACTOR_ONE, GR_COMBINE_LOCAL_NONE,
                   GR_COMBINE_OTHER_ITERATED, FXFALSE);
    fill_box(box, 255, 0, 0, 255);
    grChromakeyMode(GR_CHROMAKEY_DISABLE);
    s = count();
    CHECK(s.chromaFail == 5000 && s.pixelsOut == 5000);
    /* Pixels outside the clip window were generated, and go no further. */
    grSstResetPerfStats();
    grClipWindow(0, 0, 170, HIGH);
    fill_box(box, 255, 0, 255, 255);
    grClipWindow(0, 0, WIDE, HIGH);
    s = count();
    CHECK(s.pixelsIn == 5000 && s.pixelsOut == 2500);
    grResetTriStats();
    fill_box(box, 255, 0, 200, 255);
    grTriStats(&processed, &drawn);
    CHECK(processed == 2 && drawn == 2);
    grBufferSwap(0);
    return finish();
}
