/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * queries.c: version, configuration, status and the beam, byte orders, video
 * functions that change nothing, gamma; one picture at each resolution the
 * board has.
 */
#include "conformance.h"

static void check_machine(void)
{
    GrHwConfiguration hardware;
    char version[80];

    memset(version, 'x', sizeof version);
    grGlideGetVersion(version);
    CHECK(strcmp(version, "2.46") == 0);
    memset(&hardware, 0, sizeof hardware);
    CHECK(grSstQueryBoards(&hardware) && hardware.num_sst >= 1);
    CHECK(hardware.SSTs[0].sstBoard.VoodooConfig.fbRam == 0);
    CHECK(grSstQueryHardware(&hardware));
    CHECK(hardware.SSTs[0].sstBoard.VoodooConfig.fbRam >= 2);
    CHECK(hardware.SSTs[0].sstBoard.VoodooConfig.tmuConfig[0].tmuRam >= 1);
    CHECK((FxU32)hardware.SSTs[0].sstBoard.VoodooConfig.tmuConfig[0].tmuRam << 20
          == grTexMaxAddress(GR_TMU0) + 8);
    CHECK(guEndianSwapWords(0x12345678U) == 0x56781234U && guEndianSwapBytes(0x1234) == 0x3412);
}

/* Programs wait for the beam: it must come, and go. */
static void check_beam(void)
{
    FxU32 line, ticks;
    int i, in = 0, out = 0, lines = 0;

    line = grSstVideoLine();
    for (i = 0; i < 100000 && (in < 3 || out < 3 || lines < 10); i++) {
        if (grSstVRetraceOn()) {
            in++;
            CHECK((grSstStatus() >> 6 & 1) == 0 || !grSstVRetraceOn());
        } else {
            out++;
        }
        lines += grSstVideoLine() != line;
        line = grSstVideoLine();
        ticks = grSstVRetraceTicks();
        CHECK(ticks < 2000);
    }
    CHECK(in >= 3 && out >= 3 && lines >= 10);
    grSstIdle();
    CHECK(!grSstIsBusy() && grBufferNumPending() == 0);
    CHECK((grSstStatus() & 0x3f) == 0x3f && (grSstStatus() >> 12 & 0xffff) == 0xffff);
    grCheckForRoom(100);
}

int main(void)
{
    static const int sizes[12][2] = {{320, 200}, {320, 240}, {400, 256}, {512, 384}, {640, 200}, {640, 350},
                                     {640, 400}, {640, 480}, {800, 600}, {960, 720}, {856, 480}, {512, 256}};
    int i, timings[16] = {0}, opened = 0;

    grErrorSetCallback(note_error);
    grGlideInit();
    grGlideInit();
    check_machine();
    grSstSelect(0);
    grSstVidMode(0, timings);
    for (i = -1; i <= 0x10; i++) {
        FxBool open = grSstWinOpen(0, i, GR_REFRESH_60Hz, GR_COLORFORMAT_RGBA, GR_ORIGIN_LOWER_LEFT, 2, 0);
        Box box;

        errors_told = 0;
        if (!open) {
            CHECK(i < 0 || i >= 12 || i == GR_RESOLUTION_960x720);
            continue;
        }
        opened++;
        CHECK(grSstScreenWidth() == (FxU32)sizes[i][0] && grSstScreenHeight() == (FxU32)sizes[i][1]);
        CHECK(grSstControl(GR_CONTROL_ACTIVATE) && grSstControl(GR_CONTROL_DEACTIVATE));
        grGammaCorrectionValue(1.3f);
        use_vertex_colors();
        clear_to(0x306090ff); /* red, green, blue, alpha */
        CHECK(read_pixel(GR_BUFFER_BACKBUFFER, sizes[i][0] - 1, sizes[i][1] - 1) == pack565(0x30, 0x60, 0x90)
              || read_pixel(GR_BUFFER_BACKBUFFER, sizes[i][0] - 1, sizes[i][1] - 1) != 0);
        box.x0 = box.y0 = 2;
        box.x1 = sizes[i][0] - 2;
        box.y1 = sizes[i][1] - 2;
        shaded_box(box, rgb(1, 0, 0), rgb(0, 1, 0), rgb(0, 0, 1), rgb(1, 1, 0));
        /* Lower left: what has the smallest y is at the bottom. */
        CHECK(red_of(read_pixel(GR_BUFFER_BACKBUFFER, 4, sizes[i][1] - 5)) > 200);
        if (i == GR_RESOLUTION_320x240) {
            check_beam();
        }
        grBufferSwap(i == 0 ? 0 : 1);
        grSstWinClose();
        CHECK(grSstScreenWidth() == 0);
    }
    CHECK(opened >= 10);
    grSstWinClose();
    errors_told = 0;
    CHECK(finish() == 0);
    grGlideShutdown();
    return CHECK_REPORT();
}
