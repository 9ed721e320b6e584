/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * lfb_pipeline.c: what the pixel pipeline does to pixels written through it:
 * depth test, alpha test, chroma key, fog, clip window, masks (left to right,
 * top to bottom), each beside the same write past the pipeline, which none of
 * them touches.
 */
#include "conformance.h"

static void write_ramp(Box box, FxBool pipeline)
{
    GrLfbInfo_t info;
    int x, y;

    info.size = sizeof info;
    CHECK(grLfbLock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER, GR_LFBWRITEMODE_1555,
                    GR_ORIGIN_UPPER_LEFT, pipeline, &info));
    for (y = box.y0; y < box.y1; y++) {
        FxU16 *row = (FxU16 *)(void *)((char *)info.lfbPtr + y * (int)info.strideInBytes);

        for (x = box.x0; x < box.x1; x++) {
            int i = (x - box.x0) * 32 / (box.x1 - box.x0);
            row[x] = (FxU16)((y & 8 ? 0x8000 : 0) | i << 10 | (31 - i) << 5 | 8);
        }
    }
    CHECK(grLfbUnlock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER));
}

/* Counts the pixels of a box that are still background. */
static int untouched(Box box)
{
    int x, y, count = 0;

    for (y = box.y0; y < box.y1; y++) {
        for (x = box.x0; x < box.x1; x++) {
            count += read_pixel(GR_BUFFER_BACKBUFFER, x, y) == pack565(0xff, 0xff, 0xff);
        }
    }
    return count;
}

static void set_up(int i, Box box)
{
    grDisableAllEffects();
    grClipWindow(0, 0, WIDE, HIGH);
    grColorMask(FXTRUE, FXFALSE);
    switch (i) {
    case 0: /* depth: the box's upper half is nearer than the constant depth */
        grDepthBufferMode(GR_DEPTHBUFFER_ZBUFFER);
        grDepthBufferFunction(GR_CMP_GREATER);
        grLfbConstantDepth(30000);
        break;
    case 1:
        grAlphaTestFunction(GR_CMP_GREATER);
        grAlphaTestReferenceValue(100);
        break;
    case 2: /* the eleventh of the 32 colours */
        grChromakeyMode(GR_CHROMAKEY_ENABLE);
        grChromakeyValue((FxU32)(10 << 3 | 10 >> 2) << 16 | (FxU32)(21 << 3 | 21 >> 2) << 8 | 8 << 3 | 8 >> 2);
        break;
    case 3:
        grFogMode(GR_FOG_WITH_TABLE);
        break;
    case 4:
        grClipWindow((FxU32)box.x0 + 10, (FxU32)box.y0 + 10, (FxU32)box.x1 - 10, (FxU32)box.y1 - 10);
        break;
    default:
        grColorMask(FXFALSE, FXFALSE);
        break;
    }
}

int main(void)
{
    static const int kept[6] = {78 * 39, 78 * 39, 0, 0, 78 * 78 - 58 * 58, 78 * 78};
    GrFog_t table[GR_FOG_TABLE_SIZE];
    int i;

    open_small(GR_ORIGIN_UPPER_LEFT);
    clear_to(0xffffff);
    memset(table, 128, sizeof table);
    grFogTable(table);
    grFogColorValue(0x0000ff);
    for (i = 0; i < 6; i++) {
        Box box = cell(i % 2 * 2 + i / 2 * 4, 4, 3), other = cell(i % 2 * 2 + i / 2 * 4 + 1, 4, 3);

        set_up(5, box);
        if (i == 0) {
            Box half = box;

            half.y1 = (box.y0 + box.y1) / 2;
            grDepthBufferMode(GR_DEPTHBUFFER_ZBUFFER);
            grDepthBufferFunction(GR_CMP_ALWAYS);
            grDepthMask(FXTRUE);
            grBufferClear(0, 0, 0);
            flat_box(half, 0, 0, 0, 0, 40000.0f, 1.0f);
        }
        set_up(i, box);
        write_ramp(box, FXTRUE);
        write_ramp(other, FXFALSE);
        if (i == 2) {
            CHECK(untouched(box) > 100 && untouched(box) < 400);
        } else {
            if (untouched(box) != kept[i]) {
                printf("write %d: %d pixels kept\n", i, untouched(box));
            }
            CHECK(untouched(box) == kept[i]);
        }
        CHECK(untouched(other) == 0);
    }
    set_up(4, cell(0, 1, 1));
    grBufferSwap(0);
    return finish();
}
