/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * lfb_locks.c: a write lock that is held: black is a colour like others in every
 * mode; swaps put what was stored before them into the buffer it was stored
 * into, and show the program the other one; reads find what was stored.
 */
#include "conformance.h"

static const GrLfbWriteMode_t modes[8] = {
    GR_LFBWRITEMODE_565, GR_LFBWRITEMODE_555, GR_LFBWRITEMODE_1555, GR_LFBWRITEMODE_888,
    GR_LFBWRITEMODE_8888, GR_LFBWRITEMODE_565_DEPTH, GR_LFBWRITEMODE_555_DEPTH,
    GR_LFBWRITEMODE_1555_DEPTH};

static GrLfbInfo_t lock(GrLfbWriteMode_t mode, FxBool pipeline)
{
    GrLfbInfo_t info;

    memset(&info, 0, sizeof info);
    info.size = sizeof info;
    CHECK(grLfbLock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER, mode, GR_ORIGIN_UPPER_LEFT, pipeline, &info));
    return info;
}

/* Rows of black, of all bits, and of black again, each third pixel left out. */
static void store_stripes(Box box, GrLfbWriteMode_t mode, FxBool pipeline)
{
    GrLfbInfo_t info = lock(mode, pipeline);
    int x, y, wide = info.strideInBytes == 4096;
    Box inner = box;

    for (y = box.y0; y < box.y1; y++) {
        for (x = box.x0; x < box.x1; x++) {
            char *at = (char *)info.lfbPtr + y * (int)info.strideInBytes + x * (wide ? 4 : 2);
            FxU32 value = (y - box.y0) / 8 % 2 ? 0xffffffffU : 0;

            if ((x - box.x0) % 3 != 2) {
                memcpy(at, &value, wide ? 4 : 2);
            }
        }
    }
    CHECK(grLfbUnlock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER));
    for (y = inner.y0; y < inner.y1; y += 5) {
        for (x = inner.x0; x < inner.x1; x++) {
            FxU16 expected = (x - box.x0) % 3 == 2 ? pack565(255, 128, 0) : (y - box.y0) / 8 % 2 ? 0xffff : 0;
            CHECK(read_pixel(GR_BUFFER_BACKBUFFER, x, y) == expected);
        }
    }
}

/* Through the pipeline, with a depth that must be written everywhere. */
static void check_depth(Box box)
{
    GrLfbInfo_t info;
    int x, y, missing = 0;

    grDepthBufferMode(GR_DEPTHBUFFER_ZBUFFER);
    grDepthBufferFunction(GR_CMP_ALWAYS);
    grDepthMask(FXTRUE);
    info = lock(GR_LFBWRITEMODE_565_DEPTH, FXTRUE);
    for (y = box.y0; y < box.y1; y++) {
        for (x = box.x0; x < box.x1; x++) {
            FxU32 value = (FxU32)(x & 1 ? 0 : 0xffff) | (FxU32)(x * 7 + y) << 16;
            memcpy((char *)info.lfbPtr + y * 4096 + x * 4, &value, 4);
        }
    }
    CHECK(grLfbUnlock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER));
    for (y = box.y0; y < box.y1; y += 3) {
        for (x = box.x0; x < box.x1; x++) {
            missing += read_pixel(GR_BUFFER_AUXBUFFER, x, y) != x * 7 + y;
        }
    }
    CHECK(missing == 0);
    use_no_depth_buffer();
}

/* Blocks that are stored between swaps, as programs did that never unlocked. */
static void check_swaps(void)
{
    static const FxU16 colors[4] = {0xf800, 0x07e0, 0x001f, 0x0000};
    GrLfbInfo_t info;
    FxU16 seen[2], *at;
    int i, x;

    clear_to(0x808080);
    grBufferSwap(0);
    clear_to(0x404040);
    info = lock(GR_LFBWRITEMODE_565, FXFALSE);
    for (i = 0; i < 4; i++) {
        at = (FxU16 *)(void *)((char *)info.lfbPtr + (20 + 10 * i) * (int)info.strideInBytes);
        for (x = 10; x < 60; x++) {
            at[x] = colors[i];
        }
        /* Stored, so it can be read, and the lock still holds. */
        CHECK(read_pixel(GR_BUFFER_BACKBUFFER, 30, 20 + 10 * i) == colors[i]);
        CHECK(grLfbReadRegion(GR_BUFFER_BACKBUFFER, 59, (FxU32)(20 + 10 * i), 2, 1, 4, seen));
        CHECK(seen[0] == colors[i] && seen[1] != colors[i]);
        CHECK(at[30] == colors[i]);
        grBufferSwap(0);
        CHECK(read_pixel(GR_BUFFER_FRONTBUFFER, 30, 20 + 10 * i) == colors[i]);
        /* The pointer stays, and shows the other buffer. */
        CHECK(at[100] == read_pixel(GR_BUFFER_BACKBUFFER, 100, 20 + 10 * i));
        CHECK(at[30] == read_pixel(GR_BUFFER_BACKBUFFER, 30, 20 + 10 * i));
    }
    CHECK(grLfbUnlock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER));
    /* Each buffer has every second block. */
    CHECK(read_pixel(GR_BUFFER_FRONTBUFFER, 30, 30) == colors[1] && read_pixel(GR_BUFFER_FRONTBUFFER, 30, 50) == colors[3]);
    CHECK(read_pixel(GR_BUFFER_FRONTBUFFER, 30, 20) != colors[0]);
    CHECK(read_pixel(GR_BUFFER_BACKBUFFER, 30, 20) == colors[0] && read_pixel(GR_BUFFER_BACKBUFFER, 30, 40) == colors[2]);
}

int main(void)
{
    int i;

    open_small(GR_ORIGIN_UPPER_LEFT);
    clear_to(0xff8000);
    for (i = 0; i < 8; i++) {
        store_stripes(cell(i, 4, 5), modes[i], FXFALSE);
        store_stripes(cell(8 + i, 4, 5), modes[i], FXTRUE);
    }
    check_depth(cell(17, 4, 5));
    grBufferSwap(0);
    check_swaps();
    return finish();
}
