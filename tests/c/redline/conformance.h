/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * conformance.h: what the RRedline conformance programs share. Each treats one
 * topic of the interface: it draws a small picture, which is compared with a
 * kept one, and checks in C what can be computed.
 */
#ifndef FILLRATE_REDLINE_CONFORMANCE_H
#define FILLRATE_REDLINE_CONFORMANCE_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <redline.h>
#include <rlex.h>
#include "../check.h"

#define WIDE 320
#define HIGH 240
#define RING 8

#define FIX(a) ((v_s32)((a) * 65536.0))
#define QFIX(a) ((v_u32)((a) * 16777215.0))
#define WORDS(vertex) ((v_u32 *)&(vertex))
#define COUNT_OF(array) (sizeof(array) / sizeof((array)[0]))

static v_handle verite;
static v_surface *display;
static v_cmdbuffer ring[RING];
static int ring_index;
static v_cmdbuffer cb;
static int issues;

/* --- errors -------------------------------------------------------------- */

typedef struct {
    int calls;
    v_handle handle;
    int routine, error, extended;
} Told;

static Told v_told, vl_told;

static inline void V_CDECL note_v(v_handle handle, v_routine routine, v_error error, int extended)
{
    v_told.calls++;
    v_told.handle = handle;
    v_told.routine = routine;
    v_told.error = error;
    v_told.extended = extended;
}

static inline void V_CDECL note_vl(v_handle handle, vl_routine routine, vl_error error,
                                   int extended)
{
    vl_told.calls++;
    vl_told.handle = handle;
    vl_told.routine = routine;
    vl_told.error = error;
    vl_told.extended = extended;
}

/* Whether a handler heard exactly this since the last question. */
static inline int told_once(Told *told, int routine, int error)
{
    int right = told->calls == 1 && told->routine == routine && told->error == error;

    if (!right) {
        printf("expected %d/%d once, heard %d/%d %d times\n", routine, error, told->routine,
               told->error, told->calls);
    }
    memset(told, 0, sizeof *told);
    return right;
}

static inline int v_told_once(int routine, int error) { return told_once(&v_told, routine, error); }
static inline int vl_told_once(int routine, int error)
{
    return told_once(&vl_told, routine, error);
}

static inline void forget_errors(void)
{
    memset(&v_told, 0, sizeof v_told);
    memset(&vl_told, 0, sizeof vl_told);
}

/* --- opening, issuing, ending --------------------------------------------- */

static inline v_cmdbuffer V_CDECL issue(v_handle handle, v_cmdbuffer full)
{
    issues++;
    V_IssueCmdBufferAsync(handle, full);
    ring_index = (ring_index + 1) % RING;
    while (V_QueryCmdBuffer(handle, ring[ring_index]) == V_CMDBUFFER_INUSE) {
    }
    cb = ring[ring_index];
    return cb;
}

/* Opens the board with a ring of buffers of this size; no surface yet. */
static inline void open_board(int words)
{
    int i;

    CHECK(V_RegisterErrorHandler(note_v) == V_SUCCESS);
    CHECK(VL_RegisterErrorHandler(note_vl) == VL_SUCCESS);
    CHECK(VL_OpenVerite(NULL, &verite) == VL_SUCCESS);
    for (i = 0; i < RING; i++) {
        ring[i] = V_CreateCmdBuffer(verite, 256, words);
        V_SetCmdBufferCallBack(ring[i], issue);
    }
    cb = ring[0];
}

/* Full screen, 320x240, front, back and depth buffers. */
static inline void open_display(v_u32 type)
{
    CHECK(V_SetDisplayType(verite, type) == V_SUCCESS);
    if (type == V_FULLSCREEN_APP) {
        CHECK(V_SetDisplayMode(verite, WIDE, HIGH, 16, 60) == V_SUCCESS);
    }
    CHECK(VL_CreateSurface(verite, &display, V_SURFACE_PRIMARY | V_SURFACE_Z_BUFFER, 3,
                           V_PIXFMT_565, WIDE, HIGH) == VL_SUCCESS);
    CHECK(VL_InstallDstBuffer(&cb, display) == VL_SUCCESS);
    CHECK(VL_InstallZBuffer(&cb, display) == VL_SUCCESS);
    CHECK(VL_FillBuffer(&cb, display, 1, 0, 0, WIDE, HIGH, 0) == VL_SUCCESS);
    CHECK(VL_FillBuffer(&cb, display, 2, 0, 0, WIDE, HIGH, 0xFFFF) == VL_SUCCESS);
}

static inline void open_small(void)
{
    open_board(4096);
    open_display(V_FULLSCREEN_APP);
}

/* Shows the picture that is in the back buffer. */
static inline void show(void)
{
    CHECK(VL_SwapDisplaySurface(&cb, display) == VL_SUCCESS);
    CHECK(VL_WaitForDisplaySwitch(&cb) == VL_SUCCESS);
    issue(verite, cb);
}

static inline void close_board(void)
{
    int i;

    CHECK(v_told.calls == 0 && vl_told.calls == 0);
    for (i = 0; i < RING; i++) {
        CHECK(V_DestroyCmdBuffer(ring[i]) == V_SUCCESS);
    }
    if (display != NULL) {
        CHECK(VL_DestroySurface(verite, display) == VL_SUCCESS);
    }
    CHECK(VL_CloseVerite(verite) == VL_SUCCESS);
    CHECK(v_told.calls == 0 && vl_told.calls == 0);
}

static inline int finish(void)
{
    close_board();
    return CHECK_REPORT();
}

/* --- pixels --------------------------------------------------------------- */

static unsigned char *locked;
static v_u32 locked_pitch;
static v_surface *locked_surface;
static v_u32 locked_buffer;

/* Issues what is recorded and locks a buffer. */
static inline void lock(v_surface *surface, v_u32 buffer)
{
    issue(verite, cb);
    locked = (unsigned char *)V_LockBuffer(verite, surface->buffer_group, buffer);
    CHECK(locked != NULL);
    locked_pitch = V_GetBufferLinebytes(surface->buffer_group, buffer);
    locked_surface = surface;
    locked_buffer = buffer;
}

static inline void unlock(void)
{
    CHECK(V_UnlockBuffer(verite, locked_surface->buffer_group, locked_buffer) == V_SUCCESS);
    locked = NULL;
}

static inline v_u16 *at16(int x, int y)
{
    return (v_u16 *)(void *)(locked + (size_t)y * locked_pitch) + x;
}

static inline v_u32 *at32(int x, int y)
{
    return (v_u32 *)(void *)(locked + (size_t)y * locked_pitch) + x;
}

static inline v_u16 pixel_of(v_surface *surface, v_u32 buffer, int x, int y)
{
    v_u16 pixel;

    lock(surface, buffer);
    pixel = *at16(x, y);
    unlock();
    return pixel;
}

static inline v_u16 pixel(int x, int y) { return pixel_of(display, 1, x, y); }
static inline v_u16 depth(int x, int y) { return pixel_of(display, 2, x, y); }

static inline int red_of(v_u16 p) { return (p >> 11) << 3 | p >> 13; }
static inline int green_of(v_u16 p) { return ((p >> 5) & 63) << 2 | ((p >> 9) & 3); }
static inline int blue_of(v_u16 p) { return (p & 31) << 3 | ((p >> 2) & 7); }

/* Whether channels of 0..255 are met within a tolerance. */
static inline int near_rgb(v_u16 p, int r, int g, int b, int tolerance)
{
    int right = abs(red_of(p) - r) <= tolerance && abs(green_of(p) - g) <= tolerance
                && abs(blue_of(p) - b) <= tolerance;

    if (!right) {
        printf("pixel (%d, %d, %d), expected (%d, %d, %d)\n", red_of(p), green_of(p), blue_of(p),
               r, g, b);
    }
    return right;
}

/* --- drawing -------------------------------------------------------------- */

/* A rectangle of one colour, A8 R8 G8 B8, as two triangles. */
static inline void quad(int x, int y, int width, int height, v_u32 argb)
{
    v_xy v[4];
    int i;

    for (i = 0; i < 4; i++) {
        v[i].x = FIX(x + (i & 1 ? width : 0));
        v[i].y = FIX(y + (i & 2 ? height : 0));
    }
    VL_SetFGColorARGB(&cb, argb);
    CHECK(VL_Tristrip(&cb, V_FIFO_XY, 2, WORDS(v)) == VL_SUCCESS);
}

/* A rectangle at one depth. */
static inline void quad_z(int x, int y, int width, int height, v_u32 rgb, int z)
{
    v_kxyz v[4];
    int i;

    for (i = 0; i < 4; i++) {
        v[i].rgb = rgb;
        v[i].x = FIX(x + (i & 1 ? width : 0));
        v[i].y = FIX(y + (i & 2 ? height : 0));
        v[i].z = (v_u32)z << 16;
    }
    CHECK(VL_Tristrip(&cb, V_FIFO_KXYZ, 2, WORDS(v)) == VL_SUCCESS);
}

/* A rectangle that shows the texture from (u0, v0) to (u1, v1). */
static inline void quad_uv(int x, int y, int width, int height, double u0, double v0, double u1,
                           double v1)
{
    v_xyuv v[4];
    int i;

    for (i = 0; i < 4; i++) {
        v[i].x = FIX(x + (i & 1 ? width : 0));
        v[i].y = FIX(y + (i & 2 ? height : 0));
        v[i].u = FIX(i & 1 ? u1 : u0);
        v[i].v = FIX(i & 2 ? v1 : v0);
    }
    CHECK(VL_Tristrip(&cb, V_FIFO_XYUV, 2, WORDS(v)) == VL_SUCCESS);
}

/* A texture surface whose bytes are copied from `data`, rows padded to words. */
static inline v_surface *texture(v_u32 format, v_u32 width, v_u32 height, v_u32 linebytes,
                                 const void *data)
{
    v_surface *surface = NULL;
    v_memory memory = V_AllocLockedMem(verite, linebytes * height);

    CHECK(memory != NULL);
    memcpy(V_GetMemoryObjectAddress(memory), data, (size_t)linebytes * height);
    CHECK(VL_CreateSurface(verite, &surface, 0, 1, format, width, height) == VL_SUCCESS);
    CHECK(VL_LoadBuffer(&cb, surface, 0, linebytes, width, height, memory, NULL) == VL_SUCCESS);
    /* The memory must stay until the buffer is done. */
    issue(verite, cb);
    V_LockBuffer(verite, surface->buffer_group, 0);
    V_UnlockBuffer(verite, surface->buffer_group, 0);
    CHECK(V_FreeLockedMem(verite, memory) == V_SUCCESS);
    return surface;
}

#endif
