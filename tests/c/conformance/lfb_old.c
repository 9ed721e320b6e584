/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * lfb_old.c: the interface of Glide 2.0 to 2.3: grSstOpen, pointers between
 * grLfbBegin and grLfbEnd, guFbReadRegion and guFbWriteRegion.
 */
#include "conformance.h"

static FxU16 picture[60][80], back[60][80];

static void make_picture(void)
{
    int x, y;

    for (y = 0; y < 60; y++) {
        for (x = 0; x < 80; x++) {
            Color c = test_card((float)x / 80.0f, (float)y / 60.0f);
            picture[y][x] = pack565((int)to_byte(c.r), (int)to_byte(c.g), (int)to_byte(c.b));
        }
    }
}

static void draw_by_pointer(void)
{
    const FxU32 *from;
    FxU16 *to;
    int y;

    grLfbBegin();
    grLfbWriteMode(GR_LFBWRITEMODE_565);
    grLfbBypassMode(GR_LFBBYPASS_ENABLE);
    grLfbOrigin(GR_ORIGIN_UPPER_LEFT);
    to = grLfbGetWritePtr(GR_BUFFER_BACKBUFFER);
    CHECK(to != NULL);
    for (y = 0; y < 60 && to != NULL; y++) {
        memcpy(&to[(10 + y) * 1024 + 10], picture[y], sizeof picture[y]);
    }
    grLfbEnd();
    /* Lower left: the same rows, upside down. */
    grLfbBegin();
    grLfbOrigin(GR_ORIGIN_LOWER_LEFT);
    to = grLfbGetWritePtr(GR_BUFFER_BACKBUFFER);
    for (y = 0; y < 60 && to != NULL; y++) {
        memcpy(&to[(HIGH - 70 + y) * 1024 + 110], picture[y], sizeof picture[y]);
    }
    grLfbEnd();
    grLfbBegin();
    grLfbOrigin(GR_ORIGIN_UPPER_LEFT);
    from = grLfbGetReadPtr(GR_BUFFER_BACKBUFFER);
    CHECK(from != NULL);
    for (y = 0; y < 60 && from != NULL; y++) {
        CHECK(memcmp((const FxU16 *)from + (10 + y) * 1024 + 10, picture[y], sizeof picture[y]) == 0);
        CHECK(memcmp((const FxU16 *)from + (69 - y) * 1024 + 110, picture[y], sizeof picture[y]) == 0);
    }
    grLfbEnd();
    /* Through the pipeline: blended with the constant alpha. */
    use_blending();
    grLfbConstantAlpha(100);
    grLfbBypassMode(GR_LFBBYPASS_DISABLE);
    grLfbBegin();
    to = grLfbGetWritePtr(GR_BUFFER_BACKBUFFER);
    for (y = 0; y < 60 && to != NULL; y++) {
        memcpy(&to[(10 + y) * 1024 + 210], picture[y], sizeof picture[y]);
    }
    grLfbEnd();
    grLfbBypassMode(GR_LFBBYPASS_ENABLE);
    use_no_blending();
}

static void copy_regions(void)
{
    int y;

    guFbWriteRegion(10, 90, 80, 60, picture, sizeof picture[0]);
    /* Between begin and end a region goes where the pointer points. */
    grLfbBegin();
    CHECK(grLfbGetWritePtr(GR_BUFFER_BACKBUFFER) != NULL);
    guFbWriteRegion(110, 90, 80, 60, picture, sizeof picture[0]);
    grLfbEnd();
    memset(back, 0, sizeof back);
    guFbReadRegion(10, 90, 80, 60, back, sizeof back[0]);
    CHECK(memcmp(back, picture, sizeof back) == 0);
    CHECK(grLfbReadRegion(GR_BUFFER_BACKBUFFER, 110, 90, 80, 60, sizeof back[0], back));
    CHECK(memcmp(back, picture, sizeof back) == 0);
    /* Past the edges: what lies outside is left out, and read as 0. */
    guFbWriteRegion(WIDE - 40, HIGH - 30, 80, 60, picture, sizeof picture[0]);
    guFbWriteRegion(-40, HIGH - 30, 80, 60, picture, sizeof picture[0]);
    guFbReadRegion(WIDE - 40, HIGH - 30, 80, 60, back, sizeof back[0]);
    for (y = 0; y < 60; y++) {
        CHECK(memcmp(back[y], picture[y], y < 30 ? 80 : 0) == 0);
        CHECK(back[y][40] == 0 && (y < 30 || back[y][5] == 0));
    }
    CHECK(read_pixel(GR_BUFFER_BACKBUFFER, 0, HIGH - 30) == picture[0][40]);
    /* Lower left rows count from below here too. */
    grLfbOrigin(GR_ORIGIN_LOWER_LEFT);
    guFbWriteRegion(210, 90, 80, 60, picture, sizeof picture[0]);
    CHECK(read_pixel(GR_BUFFER_BACKBUFFER, 210, HIGH - 1 - 90) == picture[0][0]);
    grLfbOrigin(GR_ORIGIN_UPPER_LEFT);
    guFbWriteRegion(0, 0, 0, 60, picture, sizeof picture[0]);
    guFbWriteRegion(0, 0, 80, -60, picture, sizeof picture[0]);
    guFbReadRegion(0, 0, 0, 0, back, 0);
}

int main(void)
{
    grErrorSetCallback(note_error);
    CHECK(grSstDetectResources());
    grGlideInit();
    grSstPassthruMode(GR_PASSTHRU_SHOW_VGA);
    CHECK(grSstOpen(GR_RESOLUTION_320x240, GR_REFRESH_60Hz, GR_COLORFORMAT_ARGB,
                    GR_ORIGIN_UPPER_LEFT, GR_SMOOTHING_ENABLE, 2));
    grSstPassthruMode(GR_PASSTHRU_SHOW_SST1);
    grSstControlMode(GR_CONTROL_ACTIVATE);
    grDitherMode(GR_DITHER_DISABLE);
    CHECK(grSstScreenWidth() == WIDE && grSstScreenHeight() == HIGH);
    make_picture();
    clear_to(0x404060);
    draw_by_pointer();
    copy_regions();
    grBufferSwap(0);
    grSstWinClose();
    /* Three buffers come without an auxiliary one. */
    CHECK(grSstOpen(GR_RESOLUTION_320x240, GR_REFRESH_60Hz, GR_COLORFORMAT_ARGB,
                    GR_ORIGIN_UPPER_LEFT, GR_SMOOTHING_DISABLE, 3));
    CHECK(!grLfbReadRegion(GR_BUFFER_AUXBUFFER, 0, 0, 1, 1, 2, back));
    errors_told = 0;
    return finish();
}
