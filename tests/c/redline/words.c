/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * words.c: commands written as words into the buffer draw what the functions
 * draw. The left half is drawn by functions, the right half by words.
 */
#include "conformance.h"

#define HALF (WIDE / 2)

static void state_word(v_u32 word, v_u32 value)
{
    v_u32 *w = V_AddToCmdList(&cb, 2);

    CHECK(w != NULL);
    w[0] = word;
    w[1] = value;
}

static void words(v_u32 first, v_u32 count, const void *rest)
{
    v_u32 *w = V_AddToCmdList(&cb, count + 1);

    CHECK(w != NULL);
    w[0] = first;
    memcpy(w + 1, rest, count * 4);
}

static void move(v_s32 *x, v_u32 vertices, v_u32 stride)
{
    v_u32 i;

    for (i = 0; i < vertices; i++) {
        x[i * stride] += FIX(HALF);
    }
}

static void triangles(void)
{
    v_kxyz v[6] = {
        { 0xFF0000, FIX(10), FIX(10), 100u << 16 },  { 0x00FF00, FIX(90), FIX(10), 100u << 16 },
        { 0x0000FF, FIX(50), FIX(60), 100u << 16 },  { 0xFFFF00, FIX(130), FIX(60), 90u << 16 },
        { 0x00FFFF, FIX(100), FIX(100), 80u << 16 }, { 0xFF00FF, FIX(150), FIX(110), 70u << 16 },
    };
    v_u32 list[1 + 6 * 4];

    VL_SetZBufMode(&cb, V_ZBUFMODE_LT);
    VL_SetZBufWrMode(&cb, V_ZBUFWRMODE_ENABLE);
    CHECK(VL_Triangle(&cb, V_FIFO_KXYZ, WORDS(v[0]), WORDS(v[1]), WORDS(v[2])) == VL_SUCCESS);
    CHECK(VL_Tristrip(&cb, V_FIFO_KXYZ, 2, WORDS(v[2])) == VL_SUCCESS);
    CHECK(VL_Trifan(&cb, V_FIFO_KXYZ, 3, WORDS(v[3])) == VL_SUCCESS);

    move(&v[0].x, 6, 4);
    state_word(V_FIFO_ZBUFMODE, V_ZBUFMODE_LT);
    state_word(V_FIFO_ZBUFWRMODE, V_ZBUFWRMODE_ENABLE);
    words(V_FIFO_VTX_CMD(V_FIFO_KXYZ, V_FIFO_TRIANGLE), 12, v);
    list[0] = 2;
    memcpy(list + 1, &v[2], 16 * 4);
    words(V_FIFO_VTX_CMD(V_FIFO_KXYZ, V_FIFO_TRISTRIP), 17, list);
    list[0] = 3;
    memcpy(list + 1, &v[3], 12 * 4);
    words(V_FIFO_VTX_CMD(V_FIFO_KXYZ, V_FIFO_TRIFAN), 13, list);
}

static void fast_triangles(void)
{
    v_kxyz v[3] = {
        { 0xFF8000, FIX(100), FIX(5), 50u << 16 },
        { 0x0080FF, FIX(150), FIX(15), 50u << 16 },
        { 0x80FF00, FIX(110), FIX(40), 50u << 16 },
    };

    VL_Triangle(&cb, V_FIFO_KXYZ, WORDS(v[0]), WORDS(v[1]), WORDS(v[2]));
    move(&v[0].x, 3, 4);
    words(V_FIFO_FTRI_KXYZ, 12, v);
}

static void lines(void)
{
    v_kxy v[4] = { { 0xFFFFFF, FIX(10), FIX(120) }, { 0xFF0000, FIX(60), FIX(150) },
                   { 0x00FF00, FIX(90), FIX(125) }, { 0x0000FF, FIX(140), FIX(160) } };
    v_u32 points[3], list[1 + 12];
    int i;

    VL_SetZBufMode(&cb, V_ZBUFMODE_ALWAYS);
    VL_SetZBufWrMode(&cb, V_ZBUFWRMODE_DISABLE);
    VL_Line(&cb, V_FIFO_KXY, WORDS(v[0]), WORDS(v[3]));
    VL_Polyline(&cb, V_FIFO_KXY, 3, WORDS(v));
    VL_Dot(&cb, V_FIFO_KXY, WORDS(v[1]));
    VL_SetFGColorARGB(&cb, 0xFFFFFF00);
    VL_IntLine(&cb, V_FIFO_LAST_PIXEL_DRAW, 10, 170, 60, 180);
    for (i = 0; i < 3; i++) {
        points[i] = V_FIFO_PACK_XY(70 + i * 30, i % 2 ? 190 : 170);
    }
    VL_IntPolyline(&cb, V_FIFO_LAST_PIXEL_OMIT, 2, points);

    move(&v[0].x, 4, 3);
    list[0] = V_FIFO_PACK_XY(10 + HALF, 170);
    list[1] = V_FIFO_PACK_XY(60 + HALF, 180);
    words(V_FIFO_FLAGS_CMD(V_FIFO_LAST_PIXEL_DRAW, V_FIFO_INTLINE), 2, list);
    list[0] = 2;
    for (i = 0; i < 3; i++) {
        list[1 + i] = V_FIFO_PACK_XY(70 + i * 30 + HALF, i % 2 ? 190 : 170);
    }
    words(V_FIFO_FLAGS_CMD(V_FIFO_LAST_PIXEL_OMIT, V_FIFO_INTPOLYLINE), 4, list);
    memcpy(list, &v[0], 12);
    memcpy(list + 3, &v[3], 12);
    words(V_FIFO_VTX_CMD(V_FIFO_KXY, V_FIFO_LINE), 6, list);
    list[0] = 3;
    memcpy(list + 1, v, sizeof v);
    words(V_FIFO_VTX_CMD(V_FIFO_KXY, V_FIFO_POLYLINE), 13, list);
    words(V_FIFO_VTX_CMD(V_FIFO_KXY, V_FIFO_DOT), 3, &v[1]);
}

static void fills(void)
{
    v_u32 list[8], address = V_GetBufferAddress(display->buffer_group, 1);
    v_u32 pitch = V_GetBufferLinebytes(display->buffer_group, 1);

    VL_SetFGColorARGB(&cb, 0xFF8040C0);
    VL_Bitfill(&cb, 10, 200, 40, 30);
    VL_FillBuffer(&cb, display, 1, 60, 200, 40, 30, 0x07FF);
    VL_TriangleFill(&cb, FIX(110), FIX(200), FIX(150), FIX(200), FIX(110), FIX(230));
    list[0] = V_FIFO_PACK_XY(10 + HALF, 200);
    list[1] = V_FIFO_PACK_XY(40, 30);
    words(V_FIFO_BITFILL, 2, list);
    list[0] = address + 200 * pitch + (60 + HALF) * 2;
    list[1] = pitch;
    list[2] = 40 * 2;
    list[3] = 30;
    list[4] = 0x07FF07FF;
    words(V_FIFO_MEM_CLEAR_RECT, 5, list);
    list[0] = FIX(110 + HALF);
    list[1] = FIX(200);
    list[2] = FIX(150 + HALF);
    list[3] = FIX(200);
    list[4] = FIX(110 + HALF);
    list[5] = FIX(230);
    words(V_FIFO_TRI_FILL, 6, list);
}

static void halves_are_the_same(void)
{
    int x, y, different = 0, drawn = 0;

    lock(display, 1);
    for (y = 0; y < HIGH; y++) {
        for (x = 0; x < HALF; x++) {
            different += *at16(x, y) != *at16(x + HALF, y);
            drawn += *at16(x, y) != 0;
        }
    }
    unlock();
    CHECK(different == 0);
    CHECK(drawn > 8000);
}

int main(void)
{
    open_small();
    VL_SetSrcFunc(&cb, V_SRCFUNC_NOTEXTURE);
    triangles();
    fast_triangles();
    lines();
    fills();
    halves_are_the_same();
    show();
    return finish();
}
