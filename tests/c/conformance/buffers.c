/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * buffers.c: double and triple buffering, drawing into the front buffer, clears
 * under the masks, the alpha buffer, colour formats of packed colours.
 */
#include "conformance.h"

static FxU16 front(int x, int y) { return read_pixel(GR_BUFFER_FRONTBUFFER, x, y); }
static FxU16 back(int x, int y) { return read_pixel(GR_BUFFER_BACKBUFFER, x, y); }

static void check_swaps(int buffers)
{
    static const GrColor_t colors[4] = {0xff0000, 0x00ff00, 0x0000ff, 0xffffff};
    static const FxU16 seen[4] = {0xf800, 0x07e0, 0x001f, 0xffff};
    int i;

    for (i = 0; i < 4; i++) {
        clear_to(colors[i]);
        CHECK(back(5, 5) == seen[i]);
        grBufferSwap(1);
        CHECK(front(5, 5) == seen[i]);
        /* Two buffers change places; three come round. */
        if (i >= buffers - 1) {
            CHECK(back(5, 5) == seen[i - buffers + 1]);
        }
    }
}

static void check_masks(void)
{
    grDepthBufferMode(GR_DEPTHBUFFER_ZBUFFER);
    grDepthMask(FXTRUE);
    grBufferClear(0x202020, 0, 1000);
    grColorMask(FXFALSE, FXFALSE);
    grBufferClear(0xffffff, 0, 2000);
    CHECK(back(9, 9) == pack565(32, 32, 32) && read_pixel(GR_BUFFER_AUXBUFFER, 9, 9) == 2000);
    grColorMask(FXTRUE, FXFALSE);
    grDepthMask(FXFALSE);
    grBufferClear(0x404040, 0, 3000);
    CHECK(back(9, 9) == pack565(64, 64, 64) && read_pixel(GR_BUFFER_AUXBUFFER, 9, 9) == 2000);
    /* An alpha buffer is there when depth buffering is off. */
    grDepthBufferMode(GR_DEPTHBUFFER_DISABLE);
    grColorMask(FXTRUE, FXTRUE);
    grBufferClear(0x404040, 99, 0);
    CHECK(read_pixel(GR_BUFFER_AUXBUFFER, 9, 9) == 99);
    fill_box(cell(0, 4, 4), 200, 255, 0, 0);
    CHECK(read_pixel(GR_BUFFER_AUXBUFFER, 20, 20) == 200);
    /* Destination alpha: bright where it is high. */
    grAlphaBlendFunction(GR_BLEND_DST_ALPHA, GR_BLEND_ONE_MINUS_DST_ALPHA, GR_BLEND_ZERO, GR_BLEND_ONE);
    fill_box(cell(0, 2, 4), 0, 255, 255, 255);
    CHECK(green_of(back(20, 20)) > green_of(back(100, 20)));
    use_no_blending();
    grColorMask(FXTRUE, FXFALSE);
}

static void check_formats(void)
{
    static const GrColor_t packed[4] = {0x80ff8040U, 0x804080ffU, 0xff804080U, 0x4080ff80U};
    int i;

    for (i = 0; i < 4; i++) {
        Box box = cell(8 + i, 4, 4);

        grLfbWriteColorFormat(i);
        /* The format of packed colours is the one the board was opened with. */
        grLfbWriteColorFormat(GR_COLORFORMAT_ARGB);
        guColorCombineFunction(GR_COLORCOMBINE_CCRGB);
        grConstantColorValue(packed[0]);
        fill_box(box, 0, 0, 0, 0);
        CHECK(middle(box) == pack565(255, 128, 64));
    }
    grSstWinClose();
    for (i = 0; i < 4; i++) {
        CHECK(grSstWinOpen(0, GR_RESOLUTION_320x240, GR_REFRESH_60Hz, i, GR_ORIGIN_UPPER_LEFT, 2, 1));
        grDitherMode(GR_DITHER_DISABLE);
        grBufferClear(packed[i], 0, 0);
        CHECK(back(3, 3) == pack565(255, 128, 64));
        guColorCombineFunction(GR_COLORCOMBINE_CCRGB);
        grConstantColorValue(packed[i]);
        clear_to(0);
        fill_box(cell(5, 4, 4), 0, 0, 0, 0);
        CHECK(middle(cell(5, 4, 4)) == pack565(255, 128, 64));
        grChromakeyMode(GR_CHROMAKEY_ENABLE);
        grChromakeyValue(packed[i]);
        fill_box(cell(6, 4, 4), 0, 0, 0, 0);
        grChromakeyMode(GR_CHROMAKEY_DISABLE);
        grFogMode(GR_FOG_WITH_ITERATED_ALPHA);
        grFogColorValue(packed[i]);
        fill_box(cell(7, 4, 4), 255, 0, 0, 0);
        CHECK(middle(cell(7, 4, 4)) == pack565(255, 128, 64));
        grFogMode(GR_FOG_DISABLE);
        grBufferSwap(0);
        grSstWinClose();
    }
}

int main(void)
{
    open_small(GR_ORIGIN_UPPER_LEFT);
    use_vertex_colors();
    check_swaps(2);
    check_masks();
    grBufferSwap(0);
    /* Into the buffer that is shown. */
    grRenderBuffer(GR_BUFFER_FRONTBUFFER);
    fill_box(cell(6, 4, 4), 255, 255, 255, 0);
    CHECK(front(200, 90) == pack565(255, 255, 0));
    grRenderBuffer(GR_BUFFER_AUXBUFFER);
    CHECK(told_once("grRenderBuffer: "));
    grRenderBuffer(GR_BUFFER_BACKBUFFER);
    grBufferSwap(0);
    grBufferSwap(0);
    CHECK(front(200, 90) == pack565(255, 255, 0));
    grBufferSwap(-1);
    CHECK(told_once("grBufferSwap: "));
    check_formats();
    CHECK(grSstWinOpen(0, GR_RESOLUTION_320x240, GR_REFRESH_60Hz, GR_COLORFORMAT_ARGB, GR_ORIGIN_UPPER_LEFT, 3, 0));
    grDitherMode(GR_DITHER_DISABLE);
    check_swaps(3);
    return finish();
}
