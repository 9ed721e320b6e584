/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * lfb_write.c: every write mode (columns), past the pixel pipeline and through
 * it, with both origins, and in the four colour formats (rows), over a yellow
 * background. Pixels that are not written must stay.
 */
#include "conformance.h"

static const GrLfbWriteMode_t modes[9] = {
    GR_LFBWRITEMODE_565, GR_LFBWRITEMODE_555, GR_LFBWRITEMODE_1555, GR_LFBWRITEMODE_888,
    GR_LFBWRITEMODE_8888, GR_LFBWRITEMODE_565_DEPTH, GR_LFBWRITEMODE_555_DEPTH,
    GR_LFBWRITEMODE_1555_DEPTH, GR_LFBWRITEMODE_ZA16};

/* A pixel of a mode and colour format with these parts. */
static FxU32 make_pixel(GrLfbWriteMode_t mode, GrColorFormat_t format, int a, int r, int g, int b,
                        FxU32 depth)
{
    int first = r, last = b, low = format >= GR_COLORFORMAT_RGBA;
    FxU32 c;

    if (format == GR_COLORFORMAT_ABGR || format == GR_COLORFORMAT_BGRA) {
        first = b, last = r;
    }
    switch (mode) {
    case GR_LFBWRITEMODE_565: case GR_LFBWRITEMODE_565_DEPTH:
        c = (FxU32)((first >> 3) << 11 | (g >> 2) << 5 | last >> 3);
        break;
    case GR_LFBWRITEMODE_555: case GR_LFBWRITEMODE_1555:
    case GR_LFBWRITEMODE_555_DEPTH: case GR_LFBWRITEMODE_1555_DEPTH:
        c = (FxU32)((first >> 3) << 10 | (g >> 3) << 5 | last >> 3);
        c = low ? c << 1 | (FxU32)(a >> 7) : c | (FxU32)(a >> 7) << 15;
        break;
    case GR_LFBWRITEMODE_888: case GR_LFBWRITEMODE_8888:
        c = (FxU32)(first << 16 | g << 8 | last);
        return low ? c << 8 | (FxU32)a : c | (FxU32)a << 24;
    default:
        return depth;
    }
    return mode >= GR_LFBWRITEMODE_565_DEPTH ? c | depth << 16 : c;
}

/* A picture of 32 x 24 pixels, transparent at the left, in the box. */
static void write_box(Box box, GrLfbWriteMode_t mode, GrColorFormat_t format,
                      GrOriginLocation_t origin, FxBool pipeline)
{
    GrLfbInfo_t info;
    GrBuffer_t buffer = mode == GR_LFBWRITEMODE_ZA16 ? GR_BUFFER_AUXBUFFER : GR_BUFFER_BACKBUFFER;
    int x, y, bytes = mode == GR_LFBWRITEMODE_888 || mode == GR_LFBWRITEMODE_8888
        || (mode >= GR_LFBWRITEMODE_565_DEPTH && mode != GR_LFBWRITEMODE_ZA16) ? 4 : 2;

    memset(&info, 0, sizeof info);
    info.size = sizeof info;
    grLfbWriteColorFormat(format);
    CHECK(grLfbLock(GR_LFB_WRITE_ONLY, buffer, mode, origin, pipeline, &info));
    CHECK(info.strideInBytes == (FxU32)(1024 * bytes));
    CHECK(info.writeMode == mode && info.origin == origin);
    for (y = 0; y < 24; y++) {
        for (x = 0; x < 32; x++) {
            int row = origin == GR_ORIGIN_UPPER_LEFT ? box.y0 + y : HIGH - 1 - (box.y0 + y);
            char *at = (char *)info.lfbPtr + row * (int)info.strideInBytes + (box.x0 + x) * bytes;
            FxU32 pixel = make_pixel(mode, format, x < 16 ? 64 : 255, 8 * x, 255 - 10 * y, 200,
                                     (FxU32)(1000 * y + 10000));
            FxU16 half = (FxU16)pixel;

            if (x > 12 && x < 20 && y > 8 && y < 16) {
                continue; /* not written */
            }
            memcpy(at, bytes == 4 ? (void *)&pixel : (void *)&half, (size_t)bytes);
        }
    }
    CHECK(grLfbUnlock(GR_LFB_WRITE_ONLY, buffer));
}

static void check_box(Box box, GrLfbWriteMode_t mode, int five)
{
    FxU16 pixel = read_pixel(GR_BUFFER_BACKBUFFER, box.x0 + 25, box.y0 + 4);
    int g = 255 - 40;

    CHECK(read_pixel(GR_BUFFER_BACKBUFFER, box.x0 + 16, box.y0 + 12) == pack565(255, 255, 0));
    if (mode == GR_LFBWRITEMODE_ZA16) {
        CHECK(pixel == pack565(255, 255, 0));
        CHECK(read_pixel(GR_BUFFER_AUXBUFFER, box.x0 + 25, box.y0 + 4) == 14000);
        return;
    }
    g = five ? (g >> 3) << 3 | g >> 5 : g;
    CHECK(pixel == pack565(200, g, 200));
    if (mode >= GR_LFBWRITEMODE_565_DEPTH) {
        CHECK(read_pixel(GR_BUFFER_AUXBUFFER, box.x0 + 25, box.y0 + 4) == 14000);
    }
}

int main(void)
{
    int row, column;

    open_small(GR_ORIGIN_UPPER_LEFT);
    grDepthBufferMode(GR_DEPTHBUFFER_ZBUFFER);
    grDepthBufferFunction(GR_CMP_ALWAYS);
    grDepthMask(FXTRUE);
    grBufferClear(0xffff00, 0, 5000);
    for (row = 0; row < 8; row++) {
        GrColorFormat_t format = row < 4 ? GR_COLORFORMAT_ARGB : row - 4;
        GrOriginLocation_t origin = row & 1 ? GR_ORIGIN_LOWER_LEFT : GR_ORIGIN_UPPER_LEFT;
        FxBool pipeline = row == 2 || row == 3;

        for (column = 0; column < 9; column++) {
            Box box = cell(row * 9 + column, 9, 8);

            /* Through the pipeline: blended by its own or a constant alpha. */
            use_no_blending();
            if (pipeline) {
                grLfbConstantAlpha(128);
                grLfbConstantDepth(20000);
                use_blending();
            }
            write_box(box, modes[column], format, origin, pipeline);
            use_no_blending();
            if (!pipeline) {
                check_box(box, modes[column], column == 1 || column == 2 || column == 6 || column == 7);
            }
        }
    }
    grLfbWriteColorFormat(GR_COLORFORMAT_ARGB);
    grBufferSwap(0);
    return finish();
}
