/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * lfb_swizzle.c: grLfbWriteColorSwizzle: nothing, half words, bytes and both
 * exchanged (columns), for words of two 565 pixels and words of one 888 pixel
 * stored through a lock, and for regions of each (rows).
 */
#include "conformance.h"

/* What the board makes of a stored word. */
static FxU32 exchanged(FxU32 word, FxBool bytes, FxBool words)
{
    if (bytes) {
        word = word >> 24 | (word >> 8 & 0xff00) | (word << 8 & 0xff0000) | word << 24;
    }
    return words ? word >> 16 | word << 16 : word;
}

static FxU32 word_at(int x, int y, int wide)
{
    FxU16 left = pack565(4 * x, 200, 3 * y), right = pack565(250, 3 * y, 4 * x);

    return wide ? 0x40000000U | (FxU32)(4 * x) << 16 | (FxU32)(4 * y) << 8 | 0x90
        : (FxU32)left | (FxU32)right << 16;
}

static void store(Box box, int wide, int region)
{
    static FxU32 words[78][40];
    GrLfbInfo_t info;
    int x, y, count = wide ? 38 : 19;

    for (y = 0; y < 38; y++) {
        for (x = 0; x < count; x++) {
            words[y][x] = word_at(x, y, wide);
        }
    }
    if (region) {
        CHECK(grLfbWriteRegion(GR_BUFFER_BACKBUFFER, (FxU32)box.x0, (FxU32)box.y0,
                               wide ? GR_LFB_SRC_FMT_888 : GR_LFB_SRC_FMT_565, 38, 38,
                               sizeof words[0], words));
        return;
    }
    info.size = sizeof info;
    CHECK(grLfbLock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER,
                    wide ? GR_LFBWRITEMODE_888 : GR_LFBWRITEMODE_565, GR_ORIGIN_UPPER_LEFT, FXFALSE, &info));
    for (y = 0; y < 38; y++) {
        memcpy((char *)info.lfbPtr + (box.y0 + y) * (int)info.strideInBytes + box.x0 * (wide ? 4 : 2),
               words[y], (size_t)count * 4);
    }
    CHECK(grLfbUnlock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER));
}

int main(void)
{
    int i, x, y;

    open_small(GR_ORIGIN_UPPER_LEFT);
    clear_to(0x303030);
    for (i = 0; i < 16; i++) {
        FxBool bytes = i % 4 >= 2, words = i % 2;
        int wide = i / 4 % 2, region = i / 8;
        Box box = cell(i, 4, 4);

        box.x0 += 1; /* even, so that words are words */
        grLfbWriteColorSwizzle(bytes, words);
        store(box, wide, region);
        grLfbWriteColorSwizzle(FXFALSE, FXFALSE);
        for (y = 0; y < 38; y += 5) {
            for (x = 0; x < (wide ? 38 : 19); x++) {
                FxU32 word = exchanged(word_at(x, y, wide), bytes, words);
                int at = box.x0 + (wide ? x : 2 * x);

                if (wide) {
                    CHECK(read_pixel(GR_BUFFER_BACKBUFFER, at, box.y0 + y)
                          == pack565((int)(word >> 16 & 255), (int)(word >> 8 & 255), (int)(word & 255)));
                } else {
                    CHECK(read_pixel(GR_BUFFER_BACKBUFFER, at, box.y0 + y) == (word & 0xffff));
                    CHECK(read_pixel(GR_BUFFER_BACKBUFFER, at + 1, box.y0 + y) == word >> 16);
                }
            }
        }
    }
    grBufferSwap(0);
    return finish();
}
