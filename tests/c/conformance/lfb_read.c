/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * lfb_read.c: reading each buffer through a lock with both origins and through
 * regions, copying what was read elsewhere with grLfbWriteRegion in every
 * source format, and what locks refuse.
 */
#include "conformance.h"

static FxU16 shot[HIGH][WIDE], again[HIGH][WIDE];

static void draw_scene(void)
{
    use_vertex_colors();
    use_z_buffer();
    grBufferClear(0x102030, 0, 0);
    grDepthBufferFunction(GR_CMP_GEQUAL);
    shaded_box(cell(0, 4, 3), rgb(1, 0, 0), rgb(0, 1, 0), rgb(0, 0, 1), rgb(1, 1, 1));
    grDepthBufferFunction(GR_CMP_GREATER);
    flat_box(cell(1, 4, 3), 255, 20, 220, 160, 12345.0f, 0.5f);
}

static void read_locked(GrBuffer_t buffer, GrOriginLocation_t origin, FxU16 to[HIGH][WIDE])
{
    GrLfbInfo_t info;
    int y;

    info.size = sizeof info;
    CHECK(grLfbLock(GR_LFB_READ_ONLY | GR_LFB_NOIDLE, buffer, GR_LFBWRITEMODE_ANY, origin, FXFALSE, &info));
    CHECK(info.strideInBytes == 2048);
    CHECK(!grLfbLock(GR_LFB_READ_ONLY, buffer, GR_LFBWRITEMODE_ANY, origin, FXFALSE, &info));
    errors_told = 0;
    for (y = 0; y < HIGH; y++) {
        memcpy(to[y], (const char *)info.lfbPtr + y * 2048, sizeof to[y]);
    }
    CHECK(grLfbUnlock(GR_LFB_READ_ONLY, buffer));
    CHECK(!grLfbUnlock(GR_LFB_READ_ONLY, buffer));
    errors_told = 0;
}

static void compare_reads(void)
{
    int y;

    read_locked(GR_BUFFER_BACKBUFFER, GR_ORIGIN_UPPER_LEFT, shot);
    read_locked(GR_BUFFER_BACKBUFFER, GR_ORIGIN_LOWER_LEFT, again);
    for (y = 0; y < HIGH; y++) {
        CHECK(memcmp(shot[y], again[HIGH - 1 - y], sizeof shot[y]) == 0);
    }
    memset(again, 0, sizeof again);
    CHECK(grLfbReadRegion(GR_BUFFER_BACKBUFFER, 0, 0, WIDE, HIGH, sizeof again[0], again));
    CHECK(memcmp(shot, again, sizeof shot) == 0);
    /* A part, with a stride of its own. */
    CHECK(grLfbReadRegion(GR_BUFFER_BACKBUFFER, 30, 20, 17, 9, sizeof again[0], &again[100][50]));
    for (y = 0; y < 9; y++) {
        CHECK(memcmp(&again[100 + y][50], &shot[20 + y][30], 34) == 0);
    }
    read_locked(GR_BUFFER_AUXBUFFER, GR_ORIGIN_UPPER_LEFT, again);
    CHECK(again[40][120] == 12345 && again[200][10] == 0);
}

/* The first cell again as pixels of a source format. */
static void write_copy(Box box, GrLfbSrcFmt_t format)
{
    static FxU32 wide[HIGH][WIDE];
    static FxU16 narrow[HIGH][WIDE];
    int x, y, four = format == GR_LFB_SRC_FMT_888 || format == GR_LFB_SRC_FMT_8888
        || format >= GR_LFB_SRC_FMT_565_DEPTH;

    for (y = 0; y < 78; y++) {
        for (x = 0; x < 78; x++) {
            FxU16 p = shot[y + 1][x + 1];
            FxU32 rgb24 = (FxU32)(red_of(p) << 16 | green_of(p) << 8 | blue_of(p));
            FxU32 rgb15 = (FxU32)((p >> 11) << 10 | ((p >> 6) & 31) << 5 | (p & 31));

            narrow[y][x] = format == GR_LFB_SRC_FMT_565 ? p
                : (FxU16)(rgb15 | (format == GR_LFB_SRC_FMT_1555 ? 0x8000 : 0));
            wide[y][x] = format == GR_LFB_SRC_FMT_888 || format == GR_LFB_SRC_FMT_8888
                ? rgb24 | 0xff000000U
                : (FxU32)7777 << 16 | (format == GR_LFB_SRC_FMT_565_DEPTH ? p : rgb15 | 0x8000);
        }
    }
    CHECK(grLfbWriteRegion(GR_BUFFER_BACKBUFFER, (FxU32)box.x0, (FxU32)box.y0, format, 78, 78,
                           four ? (FxI32)sizeof wide[0] : (FxI32)sizeof narrow[0],
                           four ? (void *)wide : (void *)narrow));
    for (y = 0; y < 78; y += 7) {
        for (x = 0; x < 78; x += 7) {
            FxU16 p = read_pixel(GR_BUFFER_BACKBUFFER, box.x0 + x, box.y0 + y);
            int exact = format == GR_LFB_SRC_FMT_565 || format == GR_LFB_SRC_FMT_565_DEPTH
                || format == GR_LFB_SRC_FMT_888 || format == GR_LFB_SRC_FMT_8888;

            CHECK((p & (exact ? 0xffff : 0xffdf)) == (shot[y + 1][x + 1] & (exact ? 0xffff : 0xffdf)));
        }
    }
}

int main(void)
{
    static const GrLfbSrcFmt_t formats[8] = {
        GR_LFB_SRC_FMT_565, GR_LFB_SRC_FMT_555, GR_LFB_SRC_FMT_1555, GR_LFB_SRC_FMT_888,
        GR_LFB_SRC_FMT_8888, GR_LFB_SRC_FMT_565_DEPTH, GR_LFB_SRC_FMT_555_DEPTH,
        GR_LFB_SRC_FMT_1555_DEPTH};
    FxU16 one = 4242;
    int i;

    open_small(GR_ORIGIN_UPPER_LEFT);
    draw_scene();
    compare_reads();
    for (i = 0; i < 8; i++) {
        write_copy(cell(4 + i, 4, 3), formats[i]);
        CHECK(i < 5 || read_pixel(GR_BUFFER_AUXBUFFER, cell(4 + i, 4, 3).x0 + 3, 170) == 7777);
    }
    CHECK(grLfbWriteRegion(GR_BUFFER_AUXBUFFER, 5, 6, GR_LFB_SRC_FMT_ZA16, 1, 1, 2, &one));
    CHECK(read_pixel(GR_BUFFER_AUXBUFFER, 5, 6) == 4242);
    CHECK(!grLfbWriteRegion(GR_BUFFER_BACKBUFFER, 5, 6, GR_LFB_SRC_FMT_RLE16, 1, 1, 2, &one));
    CHECK(!grLfbWriteRegion(GR_BUFFER_BACKBUFFER, 5, 6, GR_LFB_SRC_FMT_ZA16, 1, 1, 2, &one));
    errors_told = 0;
    grBufferSwap(0);
    /* The displayed buffer can be read, and holds what was drawn. */
    CHECK(grLfbReadRegion(GR_BUFFER_FRONTBUFFER, 0, 0, WIDE, HIGH, sizeof again[0], again));
    CHECK(memcmp(&again[10][10], &shot[10][10], 60) == 0);
    return finish();
}
