/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * dma.c: blocks of memory in the stream, through all four ports, in order with
 * words, read when the buffer is issued.
 */
#include "conformance.h"

static v_u32 turned(v_u32 w, v_u32 port)
{
    switch (port) {
    case V_BYTE_FIFO_PORT:
        return w >> 24 | (w >> 8 & 0xFF00) | (w << 8 & 0xFF0000) | w << 24;
    case V_OTHER_FIFO_PORT:
        return (w >> 8 & 0x00FF00FF) | (w << 8 & 0xFF00FF00);
    case V_SHORT_FIFO_PORT:
        return w >> 16 | w << 16;
    default:
        return w;
    }
}

/* A triangle of one colour, as words turned for a port. */
static v_u32 put_triangle(v_u32 *to, v_u32 rgb, int x, int y, v_u32 port)
{
    v_kxy v[3];
    v_u32 list[10], i;

    for (i = 0; i < 3; i++) {
        v[i].rgb = rgb;
        v[i].x = FIX(x + (i == 1 ? 60 : 0));
        v[i].y = FIX(y + (i == 2 ? 60 : 0));
    }
    list[0] = V_FIFO_VTX_CMD(V_FIFO_KXY, V_FIFO_TRIANGLE);
    memcpy(list + 1, v, sizeof v);
    for (i = 0; i < 10; i++) {
        to[i] = turned(list[i], port);
    }
    return 10;
}

static const v_u32 ports[4] = { V_WORD_FIFO_PORT, V_BYTE_FIFO_PORT, V_OTHER_FIFO_PORT,
                                V_SHORT_FIFO_PORT };
static const v_u32 colors[4] = { 0xFF0000, 0x00FF00, 0x0000FF, 0xFFFF00 };
static const v_u16 pixels[4] = { 0xF800, 0x07E0, 0x001F, 0xFFE0 };

static void all_ports(void)
{
    v_memory memory = V_AllocLockedMem(verite, 4096);
    v_u32 *start = V_GetMemoryObjectAddress(memory);
    int i;

    CHECK(V_GetMemoryObjectSize(memory) == 4096);
    CHECK(V_GetMemoryObjectStatus(memory) == V_PAGES_LOCKED);
    CHECK(V_GetDMAEntries(memory, start, 10) == 1);
    for (i = 0; i < 4; i++) {
        v_u32 count = put_triangle(start + 16 * i, colors[i], 10 + 75 * i, 10, ports[i]);

        CHECK(V_AddToDMAList(&cb, ports[i], memory, start + 16 * i, count) == V_SUCCESS);
    }
    issue(verite, cb);
    for (i = 0; i < 4; i++) {
        CHECK(pixel(20 + 75 * i, 20) == pixels[i]);
    }
    CHECK(V_FreeLockedMem(verite, memory) == V_SUCCESS);
}

/* Words and blocks are carried out as they were appended; a block is read when
 * its buffer is issued. */
static void order(void)
{
    v_memory memory = V_AllocLockedMem(verite, 4096);
    v_u32 *start = V_GetMemoryObjectAddress(memory);

    quad(10, 100, 60, 60, 0xFFFFFFFF);
    CHECK(V_AddToDMAList(&cb, V_WORD_FIFO_PORT, memory, NULL, 10) == V_SUCCESS);
    put_triangle(start, 0xFF00FF, 10, 100, V_WORD_FIFO_PORT);
    CHECK(pixel(20, 110) == 0xF81F);
    put_triangle(start, 0x00FFFF, 90, 100, V_WORD_FIFO_PORT);
    CHECK(V_AddToDMAList(&cb, V_WORD_FIFO_PORT, memory, NULL, 10) == V_SUCCESS);
    quad(90, 100, 20, 20, 0xFFFF0000);
    CHECK(pixel(95, 105) == 0xF800 && pixel(112, 105) == 0x07FF);
    CHECK(V_FreeLockedMem(verite, memory) == V_SUCCESS);
}

/* A command whose data lie in a block. */
static void data_of_a_command(void)
{
    v_memory memory = V_AllocLockedMem(verite, 4096);
    v_u32 *start = V_GetMemoryObjectAddress(memory), *w;
    v_u32 pitch = V_GetBufferLinebytes(display->buffer_group, 1), i;

    for (i = 0; i < 16 * 16 / 2; i++) {
        start[i] = i / 8 % 2 ? 0xF81FF81F : 0x07E007E0;
    }
    w = V_AddToCmdAndDMAList(&cb, 5, V_GetDMAEntries(memory, start, 16 * 16 / 2));
    CHECK(w != NULL);
    w[0] = V_FIFO_MEM_WRITE_RECT;
    w[1] = V_GetBufferAddress(display->buffer_group, 1) + 100 * pitch + 200 * 2;
    w[2] = pitch;
    w[3] = 16 * 2;
    w[4] = 16;
    CHECK(V_AddToDMAList(&cb, V_WORD_FIFO_PORT, memory, start, 16 * 16 / 2) == V_SUCCESS);
    CHECK(pixel(200, 100) == 0x07E0 && pixel(215, 101) == 0xF81F && pixel(216, 100) == 0);
    CHECK(V_FreeLockedMem(verite, memory) == V_SUCCESS);
}

/* Memory of the program's own, locked and not. */
static void own_memory(void)
{
    static v_u32 words[2048];
    v_memory memory = V_AllocMemoryObject(verite, words, sizeof words / 2);

    CHECK(memory != NULL && V_GetMemoryObjectAddress(memory) == words);
    CHECK(V_GetMemoryObjectStatus(memory) == V_PAGES_UNLOCKED);
    CHECK(V_LockPages(verite, memory) == V_SUCCESS);
    CHECK(V_GetMemoryObjectStatus(memory) == V_PAGES_LOCKED);
    put_triangle(words, 0x8080FF, 230, 100, V_WORD_FIFO_PORT);
    CHECK(V_AddToDMAList(&cb, V_WORD_FIFO_PORT, memory, NULL, 10) == V_SUCCESS);
    CHECK(near_rgb(pixel(235, 105), 0x80, 0x80, 0xFF, 8));
    CHECK(V_UnlockPages(verite, memory) == V_SUCCESS);
    CHECK(V_SetMemoryObject(memory, words + 1024, 4096) == V_SUCCESS);
    CHECK(V_GetMemoryObjectAddress(memory) == words + 1024);
    CHECK(V_GetMemoryObjectSize(memory) == 4096);
    /* Blocks must lie inside the object. */
    CHECK(V_AddToDMAList(&cb, V_WORD_FIFO_PORT, memory, words, 4) != V_SUCCESS);
    CHECK(V_AddToDMAList(&cb, V_WORD_FIFO_PORT, memory, NULL, 1025) != V_SUCCESS);
    CHECK(V_AddToDMAList(&cb, 9, memory, NULL, 4) != V_SUCCESS);
    CHECK(v_told.calls == 3);
    forget_errors();
    V_FreeMemoryObject(verite, memory);
}

int main(void)
{
    open_small();
    VL_SetSrcFunc(&cb, V_SRCFUNC_NOTEXTURE);
    CHECK(V_GetUseDMA(verite) == 1);
    all_ports();
    order();
    data_of_a_command();
    own_memory();
    show();
    return finish();
}
