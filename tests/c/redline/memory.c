/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * memory.c: strides, buffer groups, how much video memory there is, addresses.
 */
#include "conformance.h"

/* RR: pitches of both chips, and those of the V2000 alone. */
static const v_u32 pitches[] = {
    4,    16,   20,   32,   36,   64,   68,   128,  132,  256,  272,  288,  320,
    384,  512,  528,  544,  576,  640,  1024, 1028, 1040, 1056, 1088, 1152, 1280,
    1536, 2048, 2052, 2304, 2560, 3072, 4096, 4100, 4352, 4608, 5120,
};
static const v_u32 more_pitches[] = { 592,  608,  704,  768,  784,  800,  832,  896,  1168, 1184,
                                      1216, 1600, 1792, 2176, 2624, 2816, 3200, 4672, 4864, 5248 };

static int is_v2000(void)
{
    return strstr(VL_GetExtensions(verite), " V2K_Verite ") != NULL;
}

static int is_pitch(v_u32 pitch)
{
    size_t i;

    for (i = 0; i < COUNT_OF(pitches); i++) {
        if (pitches[i] == pitch) {
            return 1;
        }
    }
    for (i = 0; is_v2000() && i < COUNT_OF(more_pitches); i++) {
        if (more_pitches[i] == pitch) {
            return 1;
        }
    }
    return 0;
}

static void strides(void)
{
    v_u32 bytes, largest = is_v2000() ? 5248 : 5120, expected = 0;

    /* From the largest down, the pitch is the last one met. */
    for (bytes = largest; bytes > 0; bytes--) {
        v_u32 pitch = V_Linebytes(verite, V_Stride(verite, bytes));

        if (is_pitch(bytes)) {
            expected = bytes;
        }
        CHECK(pitch == expected);
    }
    CHECK(V_Linebytes(verite, 0x51) == 256 + 1024 && V_Linebytes(verite, 0x02) == 512);
    CHECK(V_Linebytes(verite, 0x41) == 256 + 128);
    /* Where two codes give one pitch. */
    CHECK(V_Stride(verite, 576) == 0x32 && V_Stride(verite, 1024) == 0x03);
    CHECK(V_Stride(verite, 1280) == 0x51 && V_Stride(verite, 2048) == 0x60);
}

static int fits(v_u32 height)
{
    v_buffer_group group = NULL;
    v_u32 size = 0;
    v_error error
        = V_CreateBufferGroup(verite, &group, &size, 0, 1, V_PIXFMT_565, 256, height);

    if (error != V_SUCCESS) {
        CHECK(error == V_OUT_OF_VIDEO_MEMORY && group == NULL);
        return 0;
    }
    CHECK(size == 512 * height);
    CHECK(V_DestroyBufferGroup(verite, group) == V_SUCCESS);
    return 1;
}

/* Lines of 256 pixels that are free, by halving. */
static v_u32 free_lines(void)
{
    v_error_handler before = V_GetErrorHandler();
    v_u32 low = 0, high = 32768;

    V_RegisterErrorHandler(NULL);
    while (high - low > 1) {
        v_u32 middle = (low + high) / 2;

        if (fits(middle)) {
            low = middle;
        } else {
            high = middle;
        }
    }
    V_RegisterErrorHandler(before);
    return low;
}

static void video_memory(void)
{
    v_buffer_group groups[3];
    v_u32 size, start = free_lines(), i, used;
    v_verite_info info;

    memset(&info, 0, sizeof info);
    CHECK(V_EnumVeriteBoards(NULL, 1, &info) == V_SUCCESS);
    CHECK((info.veriteID & 0xFFFF) == 0x1163);
    /* The microcode and three buffers of the display are taken. */
    used = 128 * 1024 + 3 * HIGH * V_GetBufferLinebytes(display->buffer_group, 0);
    CHECK(start == (info.memSize - used) / 512);
    CHECK(start > 1000);
    for (i = 0; i < 3; i++) {
        CHECK(V_CreateBufferGroup(verite, &groups[i], &size, 0, 1, V_PIXFMT_565, 256, 100)
              == V_SUCCESS);
        CHECK(V_GetBufferAddress(groups[i], 0) % 4 == 0);
    }
    CHECK(free_lines() == start - 300);
    /* The hole in the middle cannot be part of a larger group. */
    CHECK(V_DestroyBufferGroup(verite, groups[1]) == V_SUCCESS);
    CHECK(free_lines() == start - 300);
    CHECK(V_DestroyBufferGroup(verite, groups[0]) == V_SUCCESS);
    CHECK(V_DestroyBufferGroup(verite, groups[2]) == V_SUCCESS);
    CHECK(free_lines() == start);
}

static void groups(void)
{
    v_buffer_group group = NULL, inside = NULL;
    v_u32 size = 0, *pointer, board = 0, i;
    v_u32 pixels[4 * 8];

    CHECK(V_CreateBufferGroup(verite, &group, &size, V_SURFACE_Z_BUFFER, 2, V_PIXFMT_4444, 60, 40)
          == V_SUCCESS);
    CHECK(V_GetNumBuffers(group) == 2 && V_GetBufferMask(group) == V_SURFACE_Z_BUFFER);
    CHECK(V_GetBufferLinebytes(group, 0) == 128 && V_GetBufferLinebytes(group, 1) == 128);
    CHECK(V_DestroyBufferGroup(verite, group) == V_SUCCESS);
    CHECK(V_CreateBufferGroup(verite, &group, &size, 0, 3, V_PIXFMT_8888, 60, 40) == V_SUCCESS);
    CHECK(V_GetBufferLinebytes(group, 0) == 256 && V_GetBufferLinebytes(group, 2) == 256);
    CHECK(V_Linebytes(verite, V_GetBufferStride(group, 0)) == 256);
    CHECK(size == 3 * 256 * 40);
    pointer = V_LockBuffer(verite, group, 1);
    CHECK(pointer != NULL);
    if (pointer == NULL) {
        return;
    }
    CHECK(V_GetBoardAddress(verite, pointer, &board) == V_SUCCESS);
    CHECK(board == V_GetBufferAddress(group, 1));
    for (i = 0; i < 64 * 40; i++) {
        pointer[i] = i;
    }
    CHECK(V_UnlockBuffer(verite, group, 1) == V_SUCCESS);
    /* Reading, and another group over the same memory. */
    CHECK(V_ReadBuffer(verite, group, 1, 5, 7, 4, 8, 16, pixels) == V_SUCCESS);
    CHECK(pixels[0] == 7 * 64 + 5 && pixels[31] == 14 * 64 + 8);
    CHECK(V_PointBufferGroup(verite, &inside, &size, 0, 1, V_PIXFMT_8888, 60, 10, board + 256 * 3)
          == V_SUCCESS);
    CHECK(V_ReadBuffer(verite, inside, 0, 0, 0, 4, 8, 16, pixels) == V_SUCCESS);
    CHECK(pixels[0] == 3 * 64);
    CHECK(V_DestroyBufferGroup(verite, inside) == V_SUCCESS);
    /* Buffers change their numbers. */
    CHECK(V_SwapBuffers(group, 0, 1) == V_SUCCESS);
    CHECK(V_GetBufferAddress(group, 0) == board);
    CHECK(V_SwapBuffers(group, 0, 9) != V_SUCCESS);
    CHECK(V_ReadBuffer(verite, group, 1, 50, 0, 40, 8, 160, pixels) != V_SUCCESS);
    CHECK(V_LockBuffer(verite, group, 3) == NULL);
    CHECK(v_told.calls == 3);
    forget_errors();
    CHECK(V_IsBufferLost(verite, group, 0) == 0);
    CHECK(V_DestroyBufferGroup(verite, group) == V_SUCCESS);
}

static v_u16 stored(const unsigned char *bytes, v_u32 pitch, v_u32 x, v_u32 y)
{
    v_u16 pixel;

    memcpy(&pixel, bytes + y * pitch + x * 2, sizeof pixel);
    return pixel;
}

/* A buffer that is held while commands draw into it: stores come before what is
 * issued after them, and the pointer shows what is drawn once a call has said
 * that it is done. */
static void held(void)
{
    v_u32 pitch = V_GetBufferLinebytes(display->buffer_group, 1), i;
    v_u16 green = 0x07E0, pixels[4];
    unsigned char *bytes, *again;

    CHECK(V_IssueCmdBuffer(verite, cb) == V_SUCCESS);
    bytes = V_LockBuffer(verite, display->buffer_group, 1);
    CHECK(bytes != NULL);
    if (bytes == NULL) {
        return;
    }
    /* Waited for. */
    CHECK(VL_FillBuffer(&cb, display, 1, 10, 20, 30, 5, 0xF800) == VL_SUCCESS);
    CHECK(stored(bytes, pitch, 10, 20) == 0);
    CHECK(V_IssueCmdBuffer(verite, cb) == V_SUCCESS);
    CHECK(stored(bytes, pitch, 10, 20) == 0xF800 && stored(bytes, pitch, 39, 24) == 0xF800);
    CHECK(stored(bytes, pitch, 40, 20) == 0);
    /* Asked for; a store before the issue is drawn over, one beside it stays. */
    for (i = 12; i < 16; i++) {
        memcpy(bytes + 21 * pitch + i * 2, &green, sizeof green);
    }
    CHECK(VL_FillBuffer(&cb, display, 1, 13, 21, 1, 1, 0x001F) == VL_SUCCESS);
    CHECK(V_IssueCmdBufferAsync(verite, cb) == V_SUCCESS);
    while (V_QueryCmdBuffer(verite, cb) == V_CMDBUFFER_INUSE) {
    }
    CHECK(stored(bytes, pitch, 12, 21) == green && stored(bytes, pitch, 13, 21) == 0x001F);
    /* The board sees stores without an unlock. */
    memcpy(bytes + 22 * pitch + 2 * 50, &green, sizeof green);
    CHECK(V_ReadBuffer(verite, display->buffer_group, 1, 48, 22, 4, 1, 8, (v_u32 *)pixels)
          == V_SUCCESS);
    CHECK(pixels[1] == 0 && pixels[2] == green && pixels[3] == 0);
    /* A second lock is the same memory. */
    CHECK(VL_FillBuffer(&cb, display, 1, 60, 22, 2, 1, 0xFFFF) == VL_SUCCESS);
    CHECK(V_IssueCmdBufferAsync(verite, cb) == V_SUCCESS);
    again = V_LockBuffer(verite, display->buffer_group, 1);
    CHECK(again == bytes && stored(bytes, pitch, 61, 22) == 0xFFFF);
    CHECK(V_UnlockBuffer(verite, display->buffer_group, 1) == V_SUCCESS);
    /* Drawn and stored before the last unlock: both stay. */
    CHECK(VL_FillBuffer(&cb, display, 1, 70, 22, 2, 1, 0xFFFF) == VL_SUCCESS);
    CHECK(V_IssueCmdBufferAsync(verite, cb) == V_SUCCESS);
    memcpy(bytes + 22 * pitch + 2 * 72, &green, sizeof green);
    CHECK(V_UnlockBuffer(verite, display->buffer_group, 1) == V_SUCCESS);
    CHECK(V_ReadBuffer(verite, display->buffer_group, 1, 70, 22, 4, 1, 8, (v_u32 *)pixels)
          == V_SUCCESS);
    CHECK(pixels[0] == 0xFFFF && pixels[1] == 0xFFFF && pixels[2] == green && pixels[3] == 0);
    CHECK(VL_FillBuffer(&cb, display, 1, 0, 0, WIDE, HIGH, 0) == VL_SUCCESS);
}

int main(void)
{
    open_small();
    strides();
    video_memory();
    groups();
    held();
    V_SetUserPrivate(verite, 0x12345678);
    CHECK(V_GetUserPrivate(verite) == 0x12345678);
    quad(40, 40, 240, 160, 0xFF00C0C0);
    show();
    return finish();
}
