/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * clip_window.c: clip windows within the screen, past its edges, of one pixel
 * and empty, for clears and triangles, with both origins. The minimum belongs
 * to a window, the maximum does not.
 */
#include "conformance.h"

static const FxU32 windows[][4] = {
    {10, 10, 60, 50}, {70, 10, 71, 11}, {80, 20, 80, 40}, {100, 40, 90, 10}, {300, 200, 4000, 4000},
    {110, 10, 150, 70}, {0, 120, 320, 122}
};

static int inside(const FxU32 *w, int x, int y)
{
    return x >= (int)w[0] && x < (int)w[2] && y >= (int)w[1] && y < (int)w[3];
}

int main(void)
{
    static FxU16 shot[HIGH][WIDE];
    size_t i;
    int frame, x, y;

    broken_on_purpose = "grClipWindow";
    open_small(GR_ORIGIN_UPPER_LEFT);
    use_vertex_colors();
    for (frame = 0; frame < 4; frame++) {
        int lower = frame & 1, clears = frame >= 2, wrong = 0;

        grSstOrigin(lower ? GR_ORIGIN_LOWER_LEFT : GR_ORIGIN_UPPER_LEFT);
        grClipWindow(0, 0, WIDE, HIGH);
        clear_to(0x204060);
        for (i = 0; i < COUNT_OF(windows); i++) {
            const FxU32 *w = windows[i];
            grClipWindow(w[0], w[1], w[2], w[3]);
            if (clears) {
                clear_to(0xff8000);
            } else {
                fill_box(cell(0, 1, 1), 255, 255, 0x80, 0);
            }
        }
        CHECK(grLfbReadRegion(GR_BUFFER_BACKBUFFER, 0, 0, WIDE, HIGH, sizeof shot[0], shot));
        for (y = 0; y < HIGH; y++) {
            for (x = 0; x < WIDE; x++) {
                /* Rows of the window count in the origin's direction. */
                int row = lower ? HIGH - 1 - y : y, hit = 0;

                for (i = 0; i < COUNT_OF(windows); i++) {
                    hit |= inside(windows[i], x, row);
                }
                /* The filled box leaves a border of one pixel. */
                hit = hit && (clears || (x > 0 && x < WIDE - 1 && row > 0 && row < HIGH - 1));
                wrong += shot[y][x] != (hit ? pack565(255, 0x80, 0) : pack565(0x20, 0x40, 0x60));
            }
        }
        CHECK(wrong == 0);
        grBufferSwap(0);
    }
    return finish();
}
