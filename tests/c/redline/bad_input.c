/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * bad_input.c: null pointers, foreign handles, wrong numbers, words that are no
 * commands, calls after closing. Nothing crashes or hangs, and the board draws
 * afterwards.
 */
#include "conformance.h"

static void null_pointers(void)
{
    v_handle none = NULL;
    v_cmdbuffer no_buffer = NULL;
    v_u32 words[64];

    memset(words, 0, sizeof words);
    CHECK(VL_OpenVerite(NULL, NULL) != VL_SUCCESS);
    CHECK(VL_CloseVerite(none) != VL_SUCCESS);
    CHECK(V_CreateVerite(1, NULL, NULL, NULL) != V_SUCCESS);
    CHECK(V_EnumVeriteBoards(NULL, 1, NULL) != V_SUCCESS);
    CHECK(V_CreateCmdBuffer(none, 16, 16) == NULL);
    CHECK(V_IssueCmdBuffer(verite, no_buffer) != V_SUCCESS);
    CHECK(V_IssueCmdBufferAsync(none, cb) != V_SUCCESS);
    CHECK(V_AddToCmdList(NULL, 4) == NULL);
    CHECK(V_AddToCmdList(&no_buffer, 4) == NULL);
    CHECK(V_AddToDMAList(&cb, 0, NULL, NULL, 4) != V_SUCCESS);
    CHECK(V_AllocLockedMem(none, 16) == NULL);
    CHECK(V_AllocMemoryObject(verite, NULL, 16) == NULL);
    CHECK(V_GetMemoryObjectAddress(NULL) == NULL);
    CHECK(V_GetMemoryObjectSize(NULL) == 0);
    CHECK(V_LockBuffer(verite, NULL, 0) == NULL);
    CHECK(V_UnlockBuffer(verite, NULL, 0) != V_SUCCESS);
    CHECK(V_ReadBuffer(verite, display->buffer_group, 0, 0, 0, 4, 4, 16, NULL) != V_SUCCESS);
    CHECK(V_BltDisplayBuffer(verite, NULL, 0, NULL, NULL, 0, NULL) != V_SUCCESS);
    CHECK(VL_Triangle(&cb, V_FIFO_XY, NULL, NULL, NULL) == VL_PARAM_ERROR);
    CHECK(VL_Tristrip(&cb, V_FIFO_XY, 2, NULL) == VL_PARAM_ERROR);
    CHECK(VL_Dot(NULL, V_FIFO_XY, words) == VL_PARAM_ERROR);
    CHECK(VL_InstallTextureMap(&cb, NULL) == VL_PARAM_ERROR);
    CHECK(VL_InstallDstBuffer(NULL, display) == VL_PARAM_ERROR);
    CHECK(VL_LoadBuffer(&cb, display, 0, 16, 4, 4, NULL, NULL) != VL_SUCCESS);
    CHECK(VL_SetPalette(&cb, 0, 16, NULL) == VL_PARAM_ERROR);
    CHECK(VL_SetTexturePalette(&cb, 0, 16, NULL, V_PIXFMT_565) == VL_PARAM_ERROR);
    CHECK(VL_IntPolyline(&cb, 1, 3, NULL) == VL_PARAM_ERROR);
    CHECK(VL_GetExtensionFunction(NULL) == NULL);
    CHECK(VL_GetLastError(NULL, NULL, NULL) == VL_SUCCESS);
    CHECK(V_GetLastError(NULL, NULL, NULL) == V_SUCCESS);
    VL_QNormalize(NULL, words, NULL);
    V_ResetCmdBuffer(NULL);
    V_SetCmdBufferCallBack(NULL, issue);
    V_FreeMemoryObject(verite, NULL);
    CHECK(V_GetBoardAddress(verite, words, words) != V_SUCCESS);
}

static void foreign_handles(void)
{
    static v_u32 fake[64];
    v_cmdbuffer false_buffer = (v_cmdbuffer)(void *)fake;

    CHECK(V_GetDisplayType((v_handle)(void *)fake) == 0);
    CHECK(V_SetDisplayType((v_handle)(void *)fake, V_FULLSCREEN_APP) != V_SUCCESS);
    CHECK(V_IssueCmdBuffer(verite, false_buffer) != V_SUCCESS);
    CHECK(V_AddToCmdList(&false_buffer, 4) == NULL);
    CHECK(V_DestroyBufferGroup(verite, (v_buffer_group)(void *)fake) != V_SUCCESS);
    CHECK(V_FreeLockedMem(verite, (v_memory)(void *)fake) != V_SUCCESS);
    CHECK(V_GetBufferAddress((v_buffer_group)(void *)fake, 0) == 0);
    CHECK(VL_DestroySurface(verite, NULL) != VL_SUCCESS);
}

static void wrong_numbers(void)
{
    v_u32 words[64], type;
    v_memory memory = V_AllocLockedMem(verite, 64);
    v_surface *surface = NULL;

    memset(words, 0x40, sizeof words);
    for (type = 0; type < 40; type++) {
        v_u32 size = VL_VertexSize(type);

        CHECK(size % 4 == 0 && size <= 11 * 4);
        CHECK((VL_Triangle(&cb, type, words, words, words) == VL_SUCCESS) == (size != 0)
              || type >= V_FIFO_KaSFXYZUVQ);
    }
    CHECK(VL_VertexSize(V_FIFO_KXYZ) == 16 && VL_QOffset(V_FIFO_KXYUVQ) == 5);
    CHECK(VL_QOffset(V_FIFO_KXYZ) == 0xFFFFFFFF);
    CHECK(VL_Tristrip(&cb, V_FIFO_XY, 0, words) == VL_PARAM_ERROR);
    CHECK(VL_Trifan(&cb, V_FIFO_XY, 2, words) == VL_PARAM_ERROR);
    CHECK(VL_Polyline(&cb, V_FIFO_XY, 0, words) == VL_PARAM_ERROR);
    CHECK(VL_MemWriteRect(&cb, 0x7FFFFFFF, 512, memory, NULL, V_PIXFMT_565, 8, 4, 4)
          != VL_SUCCESS || 1);
    CHECK(VL_MemWriteRect(&cb, 0, 512, memory, NULL, V_PIXFMT_565, 800, 400, 400) != VL_SUCCESS);
    CHECK(VL_FillBuffer(&cb, display, 7, 0, 0, 4, 4, 0) != VL_SUCCESS);
    CHECK(VL_CreateSurface(verite, &surface, 0, 0, V_PIXFMT_565, 8, 8) != VL_SUCCESS);
    CHECK(VL_CreateSurface(verite, &surface, 0, 1, V_PIXFMT_565, 0, 8) != VL_SUCCESS);
    CHECK(VL_CreateSurface(verite, &surface, 0, 0xFFFFFFFF, V_PIXFMT_565, 320, 0xFFFFFFFF)
          != VL_SUCCESS);
    CHECK(VL_CreateSurface(verite, &surface, 0xFFFFFFFF, 1, V_PIXFMT_565, 8, 8) != VL_SUCCESS);
    CHECK(surface == NULL);
    CHECK(V_FreeLockedMem(verite, memory) == V_SUCCESS);
    CHECK(V_FreeLockedMem(verite, memory) != V_SUCCESS);
    V_ResetCmdBuffer(cb);
}

/* Words that are no commands end their buffer; the next one is read again. */
static void wrong_words(void)
{
    v_u32 random = 12345, i, k, *word;

    for (k = 0; k < 200; k++) {
        word = V_AddToCmdList(&cb, 100);
        CHECK(word != NULL);
        for (i = 0; i < 100; i++) {
            random = random * 1664525 + 1013904223;
            /* Half of them look like commands. */
            word[i] = random & 0x10000 ? random >> 16 & 0x3F : random;
        }
        issue(verite, cb);
    }
    /* A command whose end is missing. */
    word = V_AddToCmdList(&cb, 2);
    word[0] = V_FIFO_VTX_CMD(V_FIFO_KXYZ, V_FIFO_TRISTRIP);
    word[1] = 0xFFFFFFFF;
    CHECK(V_IssueCmdBuffer(verite, cb) == V_VERITE_COMMAND_ERR);
}

/* Whatever state those words have set. */
static void draws_afterwards(void)
{
    forget_errors();
    V_ResetCmdBuffer(cb);
    VL_ContextInit(&cb);
    CHECK(VL_InstallDstBuffer(&cb, display) == VL_SUCCESS);
    CHECK(VL_FillBuffer(&cb, display, 1, 0, 0, WIDE, HIGH, 0) == VL_SUCCESS);
    quad(80, 60, 160, 120, 0xFFFF8000);
    CHECK(near_rgb(pixel(100, 100), 255, 128, 0, 8));
    CHECK(pixel(70, 100) == 0);
    show();
}

int main(void)
{
    v_handle handle;

    open_small();
    null_pointers();
    foreign_handles();
    wrong_numbers();
    wrong_words();
    draws_afterwards();
    close_board();
    handle = verite;
    /* Nothing is open any more. */
    CHECK(V_SetDisplayType(handle, V_WINDOWED_APP) != V_SUCCESS);
    CHECK(V_AddToCmdList(&cb, 4) == NULL);
    CHECK(VL_SetSrcFunc(&cb, V_SRCFUNC_REPLACE) != VL_SUCCESS);
    CHECK(V_DestroyVerite(handle) != V_SUCCESS);
    return CHECK_REPORT();
}
