/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * lfb_held.c: locks that are held while the board draws. The memory is the
 * buffer: it shows what is drawn, stores and drawing keep their order, a store
 * of what is there is a store, and rows have the board's distances.
 */
#include "conformance.h"

typedef FxU16 Row[1024];

static GrLfbInfo_t lock(GrLock_t type, GrBuffer_t buffer, GrLfbWriteMode_t mode,
                        GrOriginLocation_t origin, FxBool pipeline)
{
    GrLfbInfo_t info;

    memset(&info, 0, sizeof info);
    info.size = sizeof info;
    CHECK(grLfbLock(type, buffer, mode, origin, pipeline, &info));
    CHECK(info.lfbPtr != NULL);
    return info;
}

static Row *rows(const GrLfbInfo_t *info)
{
    CHECK(info->strideInBytes == sizeof(Row));
    return info->lfbPtr;
}

/* Draws after the locks were taken, looked at through both. */
static void check_drawing(GrOriginLocation_t origin)
{
    GrLfbInfo_t w = lock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER, GR_LFBWRITEMODE_565, origin, FXFALSE);
    GrLfbInfo_t r = lock(GR_LFB_READ_ONLY, GR_BUFFER_BACKBUFFER, GR_LFBWRITEMODE_ANY, origin, FXFALSE);
    Box box = {20, 30, 100, 90};
    int lower = origin != GR_ORIGIN_UPPER_LEFT, x, y, wrong = 0;

    fill_box(box, 255, 255, 0, 0);
    grSstIdle();
    for (y = 0; y < HIGH; y++) {
        for (x = 0; x < WIDE; x++) {
            FxU16 expected = read_pixel(GR_BUFFER_BACKBUFFER, x, lower ? HIGH - 1 - y : y);
            wrong += rows(&w)[y][x] != expected || rows(&r)[y][x] != expected;
        }
    }
    CHECK(wrong == 0);
    CHECK(read_pixel(GR_BUFFER_BACKBUFFER, 50, 50) == pack565(255, 0, 0));
    /* Every look at the board is enough, and so is none: nothing is queued. */
    fill_box(box, 255, 0, 255, 0);
    CHECK(rows(&r)[lower ? HIGH - 51 : 50][50] == pack565(0, 255, 0));
    grDrawPoint((GrVertex[]){byte_vertex(60.5f, 50.5f, 255, 0, 0, 255)});
    grSstStatus();
    CHECK(rows(&w)[lower ? HIGH - 51 : 50][60] == pack565(0, 0, 255));
    grClipWindow(90, 80, 120, 100);
    grBufferClear(0x123456, 0, 0);
    grClipWindow(0, 0, WIDE, HIGH);
    CHECK(rows(&r)[lower ? HIGH - 91 : 90][100] == pack565(0x12, 0x34, 0x56));
    CHECK(rows(&r)[lower ? HIGH - 101 : 100][100] != pack565(0x12, 0x34, 0x56));
    /* What is stored through one is read through the other. */
    rows(&w)[7][9] = 0x5a5a;
    CHECK(rows(&r)[7][9] == 0x5a5a);
    CHECK(grLfbUnlock(GR_LFB_READ_ONLY, GR_BUFFER_BACKBUFFER));
    CHECK(grLfbUnlock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER));
    CHECK(read_pixel(GR_BUFFER_BACKBUFFER, 9, lower ? HIGH - 8 : 7) == 0x5a5a);
}

/* A store, a shape over it, a store over that: of the same value that was there
 * before the shape, which is what a lock without a copy makes easy. */
static void check_order(void)
{
    GrLfbInfo_t w = lock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER, GR_LFBWRITEMODE_565,
                         GR_ORIGIN_UPPER_LEFT, FXFALSE);
    Box box = {130, 30, 210, 90};
    int x;

    clear_to(0);
    for (x = 130; x < 200; x++) {
        rows(&w)[40][x] = 0xffff;
        rows(&w)[50][x] = 0xffff;
    }
    fill_box(box, 255, 255, 0, 255);
    for (x = 140; x < 160; x++) {
        rows(&w)[50][x] = 0;
        rows(&w)[60][x] = 0;
    }
    grSstIdle();
    CHECK(read_pixel(GR_BUFFER_BACKBUFFER, 150, 40) == pack565(255, 0, 255));
    CHECK(read_pixel(GR_BUFFER_BACKBUFFER, 150, 50) == 0 && read_pixel(GR_BUFFER_BACKBUFFER, 150, 60) == 0);
    CHECK(read_pixel(GR_BUFFER_BACKBUFFER, 165, 50) == pack565(255, 0, 255));
    CHECK(rows(&w)[40][150] == pack565(255, 0, 255) && rows(&w)[50][150] == 0);
    /* Blended shapes see what was stored: every second one brightens it. */
    use_blending();
    for (x = 130; x < 200; x++) {
        rows(&w)[70][x] = pack565(0, 0, 248);
    }
    fill_box(box, 128, 255, 255, 0);
    use_no_blending();
    CHECK(grLfbUnlock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER));
    CHECK(blue_of(read_pixel(GR_BUFFER_BACKBUFFER, 150, 70)) > 90 && red_of(read_pixel(GR_BUFFER_BACKBUFFER, 150, 70)) > 90);
}

/* Each store through the pipeline is blended, whatever was stored before. */
static void check_same_value(GrLfbWriteMode_t mode)
{
    GrLfbInfo_t w;
    int i, x, y, wide, step[4], uneven = 0;

    clear_to(0x0000ff);
    use_blending();
    grLfbConstantAlpha(128);
    w = lock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER, mode, GR_ORIGIN_UPPER_LEFT, FXTRUE);
    wide = w.strideInBytes == 4096;
    for (i = 0; i < 4; i++) {
        for (y = 100; y < 160; y++) {
            for (x = 10; x < 200; x++) {
                FxU32 red = mode == GR_LFBWRITEMODE_888 ? 0xff0000
                    : mode == GR_LFBWRITEMODE_8888 ? 0x80ff0000U : mode == GR_LFBWRITEMODE_555 ? 0x7c00 : 0xf800;
                memcpy((char *)w.lfbPtr + y * (int)w.strideInBytes + x * (wide ? 4 : 2), &red, wide ? 4 : 2);
            }
        }
        grSstIdle();
        step[i] = red_of(read_pixel(GR_BUFFER_BACKBUFFER, 100, 130));
    }
    CHECK(grLfbUnlock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER));
    use_no_blending();
    CHECK(step[0] > 120 && step[1] > step[0] + 50 && step[2] > step[1] + 20 && step[3] > step[2] + 8);
    for (y = 100; y < 160; y++) {
        for (x = 10; x < 200; x++) {
            uneven += red_of(read_pixel(GR_BUFFER_BACKBUFFER, x, y)) != step[3];
        }
    }
    CHECK(uneven == 0);
    /* What is there is stored with a depth: the aux buffer has it. */
    grDepthBufferMode(GR_DEPTHBUFFER_ZBUFFER);
    grDepthBufferFunction(GR_CMP_ALWAYS);
    grDepthMask(FXTRUE);
    grLfbConstantDepth(4321);
    w = lock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER, mode, GR_ORIGIN_UPPER_LEFT, FXTRUE);
    for (x = 210; x < 300; x++) {
        FxU32 blue = mode == GR_LFBWRITEMODE_888 || mode == GR_LFBWRITEMODE_8888 ? 0xff : 0x1f;
        memcpy((char *)w.lfbPtr + 100 * (int)w.strideInBytes + x * (wide ? 4 : 2), &blue, wide ? 4 : 2);
    }
    CHECK(grLfbUnlock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER));
    for (x = 210; x < 300; x++) {
        CHECK(read_pixel(GR_BUFFER_AUXBUFFER, x, 100) == 4321);
        CHECK(read_pixel(GR_BUFFER_BACKBUFFER, x, 100) == 0x1f);
    }
    use_no_depth_buffer();
}

/* Past the pipeline every mode shows the buffer in its own pixels. */
static void check_modes(void)
{
    static const GrLfbWriteMode_t modes[3] = {GR_LFBWRITEMODE_555, GR_LFBWRITEMODE_888, GR_LFBWRITEMODE_565_DEPTH};
    static const FxU32 masks[3] = {0x7fff, 0xffffff, 0xffffffff}, values[3] = {0x7c1f, 0xff00ff, 0x04d2f81f};
    int i;

    use_z_buffer();
    grDepthBufferFunction(GR_CMP_ALWAYS);
    for (i = 0; i < 3; i++) {
        GrLfbInfo_t w = lock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER, modes[i], GR_ORIGIN_UPPER_LEFT, FXFALSE);
        Box box = {220 + 20 * i, 170, 235 + 20 * i, 200};
        FxU32 shown = 0;
        int bytes = i ? 4 : 2;

        CHECK((int)w.strideInBytes == 1024 * bytes);
        flat_box(box, 255, 255, 0, 255, 1234.0f, 1.0f);
        memcpy(&shown, (char *)w.lfbPtr + 180 * (int)w.strideInBytes + (225 + 20 * i) * bytes, (size_t)bytes);
        CHECK((shown & masks[i]) == values[i]);
        CHECK(grLfbUnlock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER));
    }
    use_no_depth_buffer();
}

/* The address space is as large as the board's and stays where it is: what is
 * stored outside the screen does no harm, then or later. */
static void check_address_space(void)
{
    GrLfbInfo_t w = lock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER, GR_LFBWRITEMODE_565, GR_ORIGIN_UPPER_LEFT, FXFALSE);
    Row *first = rows(&w);

    first[HIGH][0] = first[1023][1023] = first[10][WIDE] = 0x1234;
    CHECK(grLfbUnlock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER));
    first[11][11] = 0x4321; /* Too late. */
    w = lock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER, GR_LFBWRITEMODE_565, GR_ORIGIN_UPPER_LEFT, FXFALSE);
    CHECK(rows(&w) == first);
    CHECK(first[11][11] == read_pixel(GR_BUFFER_BACKBUFFER, 11, 11) && first[11][11] != 0x4321);
    CHECK(grLfbUnlock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER));
}

int main(void)
{
    open_small(GR_ORIGIN_UPPER_LEFT);
    use_vertex_colors();
    clear_to(0x404040);
    check_drawing(GR_ORIGIN_UPPER_LEFT);
    check_drawing(GR_ORIGIN_LOWER_LEFT);
    check_order();
    check_address_space();
    check_same_value(GR_LFBWRITEMODE_565);
    check_same_value(GR_LFBWRITEMODE_555);
    check_same_value(GR_LFBWRITEMODE_888);
    check_same_value(GR_LFBWRITEMODE_8888);
    check_modes();
    grBufferSwap(0);
    return finish();
}
