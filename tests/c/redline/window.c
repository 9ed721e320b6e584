/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * window.c: the windowed display: copies to it, stretched and in part; what
 * needs the full screen; switching between both; restoring what was lost.
 */
#include "conformance.h"

static void copies(void)
{
    v_rect whole = { 0, 0, WIDE, HIGH }, quarter = { 160, 120, 320, 240 };
    v_rect part = { 40, 40, 120, 100 }, corner = { 0, 180, 80, 240 };

    quad(40, 40, 80, 60, 0xFFFF0000);
    quad(200, 40, 80, 60, 0xFF00FF00);
    /* Nothing is issued by itself: the picture is still empty. */
    CHECK(V_BltDisplayBuffer(verite, display->buffer_group, 0, &whole, display->buffer_group, 1,
                             NULL) == V_SUCCESS);
    CHECK(pixel_of(display, 0, 60, 60) == 0);
    issue(verite, cb);
    CHECK(V_BltDisplayBuffer(verite, display->buffer_group, 0, &whole, display->buffer_group, 1,
                             NULL) == V_SUCCESS);
    CHECK(pixel_of(display, 0, 60, 60) == 0xF800);
    CHECK(V_BltDisplayBuffer(verite, display->buffer_group, 0, &corner, display->buffer_group, 1,
                             &part) == V_SUCCESS);
    CHECK(pixel_of(display, 0, 0, 180) == 0xF800 && pixel_of(display, 0, 79, 239) == 0xF800);
    CHECK(pixel_of(display, 0, 80, 200) == 0 && pixel_of(display, 0, 40, 179) == 0);
    /* The window moves and has half the size. */
    CHECK(V_BltDisplayBuffer(verite, display->buffer_group, 0, &quarter, display->buffer_group, 1,
                             NULL) == V_SUCCESS);
    CHECK(pixel_of(display, 0, 190, 150) == 0xF800 && pixel_of(display, 0, 270, 150) == 0x07E0);
    CHECK(pixel_of(display, 0, 165, 230) == 0);
}

static void full_screen_only(void)
{
    CHECK(V_SetDisplayMode(verite, WIDE, HIGH, 16, 60) == V_FULLSCREEN_MODE_ONLY);
    CHECK(v_told_once(V_R_SetDisplayMode, V_FULLSCREEN_MODE_ONLY));
    CHECK(VL_SwapDisplaySurface(&cb, display) == VL_FULLSCREEN_MODE_ONLY);
    CHECK(vl_told_once(VL_R_SwapDisplaySurface, VL_FULLSCREEN_MODE_ONLY));
    forget_errors();
    /* Waiting for a switch that nobody asked for ends at once. */
    CHECK(VL_WaitForDisplaySwitch(&cb) == VL_SUCCESS);
}

static void rules_of_surfaces(void)
{
    v_surface *other = NULL;

    /* One display, of one format; nothing is wider than it. */
    CHECK(VL_CreateSurface(verite, &other, V_SURFACE_PRIMARY, 2, V_PIXFMT_565, WIDE, HIGH)
          != VL_SUCCESS);
    CHECK(VL_CreateSurface(verite, &other, 0, 1, V_PIXFMT_565, WIDE + 8, 8) != VL_SUCCESS);
    CHECK(other == NULL && vl_told.calls == 2);
    forget_errors();
    CHECK(VL_CreateSurface(verite, &other, 0, 1, V_PIXFMT_565, WIDE, 8) == VL_SUCCESS);
    CHECK(other->width == WIDE && other->height == 8 && other->pixel_fmt == V_PIXFMT_565);
    CHECK(other->num_buffers == 1 && other->buffer_mask == 0 && other->palette == NULL);
    CHECK(other->memsize == 8 * V_GetBufferLinebytes(other->buffer_group, 0));
    CHECK(other->chromakey == 0 && other->color_pad == 0 && other->bgr == 0 && other->clamp == 0);
    CHECK(VL_SetSurfaceClamp(other, 1, 0) == VL_SUCCESS && other->clamp == V_SURFACE_UCLAMP);
    CHECK(VL_SetSurfaceClamp(other, 1, 1) == VL_SUCCESS
          && other->clamp == (V_SURFACE_UCLAMP | V_SURFACE_VCLAMP));
    CHECK(VL_DestroySurface(verite, other) == VL_SUCCESS);
}

static void restore(void)
{
    quad(100, 100, 50, 50, 0xFFFFFFFF);
    V_ResetCmdBuffer(cb);
    CHECK(VL_ContextInit(&cb) == VL_SUCCESS);
    CHECK(VL_RestoreSurface(verite, display) == VL_SUCCESS);
    CHECK(V_IsBufferLost(verite, display->buffer_group, 1) == 0);
    CHECK(V_RestoreBuffer(verite, display->buffer_group, 1) == V_SUCCESS);
    CHECK(VL_InstallDstBuffer(&cb, display) == VL_SUCCESS);
    /* State is as at the start: the colour is white. */
    VL_FillBuffer(&cb, display, 1, 0, 0, WIDE, HIGH, 0);
    VL_TriangleFill(&cb, FIX(0), FIX(0), FIX(50), FIX(0), FIX(0), FIX(50));
    CHECK(pixel(5, 5) == 0xFFFF);
}

int main(void)
{
    open_board(4096);
    CHECK(V_GetDisplayType(verite) == V_WINDOWED_APP);
    open_display(V_WINDOWED_APP);
    VL_SetSrcFunc(&cb, V_SRCFUNC_NOTEXTURE);
    copies();
    full_screen_only();
    rules_of_surfaces();
    restore();
    /* The same on the full screen. */
    issue(verite, cb);
    CHECK(VL_DestroySurface(verite, display) == VL_SUCCESS);
    display = NULL;
    open_display(V_FULLSCREEN_APP);
    CHECK(V_GetDisplayType(verite) == V_FULLSCREEN_APP);
    quad(60, 60, 200, 120, 0xFF4080C0);
    show();
    CHECK(near_rgb(pixel_of(display, 0, 100, 100), 0x40, 0x80, 0xC0, 8));
    return finish();
}
