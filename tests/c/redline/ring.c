/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * ring.c: command buffers that overflow into the next of a ring; commands that
 * fit nowhere; queries, free space, reset.
 */
#include "conformance.h"

static v_cmdbuffer told_buffer;

static v_cmdbuffer V_CDECL count_and_issue(v_handle handle, v_cmdbuffer full)
{
    CHECK(handle == verite);
    told_buffer = full;
    return issue(handle, full);
}

/* 4000 dots through buffers of 64 words. */
static void overflow(void)
{
    v_cmdbuffer first = cb;
    int i, before = issues, changes = 0;

    for (i = 0; i < RING; i++) {
        V_SetCmdBufferCallBack(ring[i], count_and_issue);
        CHECK(V_GetCmdBufferCallBack(ring[i]) == count_and_issue);
        CHECK(V_GetCmdBufferHandle(ring[i]) == verite);
    }
    for (i = 0; i < 4000; i++) {
        v_kxy dot = { 0, FIX(10 + i % 100), FIX(10 + i / 100) };
        v_cmdbuffer old = cb;

        dot.rgb = 0xFF0000u >> (i % 3 * 8);
        CHECK(VL_Dot(&cb, V_FIFO_KXY, WORDS(dot)) == VL_SUCCESS);
        changes += cb != old;
    }
    /* Sixteen dots fill a buffer. */
    CHECK(issues - before >= 4000 / 16 - 1 && changes == issues - before);
    CHECK(told_buffer != NULL && first == ring[0]);
    for (i = 0; i < 4000; i += 371) {
        v_u16 expected = (v_u16)(i % 3 == 0 ? 0xF800 : i % 3 == 1 ? 0x07E0 : 0x001F);

        CHECK(pixel(10 + i % 100, 10 + i / 100) == expected);
    }
}

/* A command larger than an empty buffer, without and with a callback. */
static void too_large(void)
{
    v_cmdbuffer small = V_CreateCmdBuffer(verite, 2, 16), held = small;
    v_memory memory = V_AllocLockedMem(verite, 4096);
    v_u32 commands = 0, entries = 0;
    int i;

    CHECK(V_GetCmdBufferCallBack(small) == NULL);
    CHECK(V_GetCmdBufferFreeSpace(small, &commands, &entries) == V_SUCCESS);
    CHECK(commands >= 16 && entries >= 2);
    CHECK(V_AddToCmdList(&held, commands + 1) == NULL && held == small);
    CHECK(v_told_once(V_R_AddToCmdList, V_CMDBUFFER_TOO_SMALL));
    /* Full, without a callback. */
    CHECK(V_AddToCmdList(&held, commands) != NULL);
    CHECK(V_AddToCmdList(&held, 1) == NULL);
    CHECK(v_told.calls == 1 && v_told.routine == V_R_AddToCmdList);
    forget_errors();
    CHECK(VL_SetSrcFunc(&held, V_SRCFUNC_REPLACE) == VL_ADDTOCMDLIST_FAILED);
    CHECK(vl_told_once(VL_R_SetSrcFunc, VL_ADDTOCMDLIST_FAILED));
    forget_errors();
    V_ResetCmdBuffer(small);
    CHECK(VL_SetSrcFunc(&held, V_SRCFUNC_NOTEXTURE) == VL_SUCCESS);
    V_ResetCmdBuffer(small);
    /* DMA entries run out. */
    for (i = 0; i < 100 && V_AddToDMAList(&held, V_WORD_FIFO_PORT, memory, NULL, 1) == V_SUCCESS;
         i++) {
    }
    CHECK(i > 0 && i < 100);
    CHECK(v_told_once(V_R_AddToDMAList, V_CMDBUFFER_NO_DMAENTRIES));
    V_ResetCmdBuffer(small);
    CHECK(V_FreeLockedMem(verite, memory) == V_SUCCESS);
    CHECK(V_DestroyCmdBuffer(small) == V_SUCCESS);
}

/* Resetting drops what was not issued and nothing else. */
static void reset(void)
{
    quad(150, 10, 50, 50, 0xFFFFFFFF);
    issue(verite, cb);
    quad(210, 10, 50, 50, 0xFFFF0000);
    V_ResetCmdBuffer(cb);
    quad(150, 70, 50, 50, 0xFF0000FF);
    CHECK(pixel(170, 30) == 0xFFFF);
    CHECK(pixel(230, 30) == 0);
    CHECK(pixel(170, 90) == 0x001F);
    CHECK(V_IssueCmdBuffer(verite, cb) == V_SUCCESS);
    CHECK(V_QueryCmdBuffer(verite, cb) == V_CMDBUFFER_AVAIL);
}

int main(void)
{
    open_board(64);
    open_display(V_FULLSCREEN_APP);
    VL_SetSrcFunc(&cb, V_SRCFUNC_NOTEXTURE);
    overflow();
    too_large();
    reset();
    show();
    return finish();
}
