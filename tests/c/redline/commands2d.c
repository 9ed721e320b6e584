/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * commands2d.c: fills, copies, look-ups, sprites, particles, rectangles.
 */
#include "conformance.h"

static v_u32 back(void) { return V_GetBufferAddress(display->buffer_group, 1); }
static v_u32 pitch(void) { return V_GetBufferLinebytes(display->buffer_group, 1); }

static int count(int x0, int y0, int x1, int y1, v_u16 value)
{
    int x, y, n = 0;

    lock(display, 1);
    for (y = y0; y < y1; y++) {
        for (x = x0; x < x1; x++) {
            n += *at16(x, y) == value;
        }
    }
    unlock();
    return n;
}

static void fills(void)
{
    CHECK(VL_FillBuffer(&cb, display, 1, 10, 10, 20, 12, 0xF800) == VL_SUCCESS);
    CHECK(count(0, 0, 40, 40, 0xF800) == 240);
    CHECK(VL_MemFill(&cb, back() + 50 * pitch() + 10 * 2, 0x07E0, V_PIXFMT_565, 30)
          == VL_SUCCESS);
    CHECK(count(0, 48, 60, 54, 0x07E0) == 30);
    CHECK(VL_MemFillRect(&cb, back() + 10 * pitch() + 40 * 2, pitch(), 0x001F001F, V_PIXFMT_565,
                         11, 7) == VL_SUCCESS);
    CHECK(count(38, 8, 60, 30, 0x001F) == 77);
    /* Colours of these are not pixels. */
    CHECK(VL_BitfillNoPat(&cb, display, 1, 0x00FFFF00, 60, 10, 13, 9) == VL_SUCCESS);
    CHECK(count(58, 8, 90, 30, 0xFFE0) == 117);
    VL_SetFGColorARGB(&cb, 0xFF00FFFF);
    CHECK(VL_Bitfill(&cb, 80, 10, 5, 6) == VL_SUCCESS);
    CHECK(count(78, 8, 90, 30, 0x07FF) == 30);
}

static void writes(void)
{
    v_memory memory = V_AllocLockedMem(verite, 4096);
    v_u16 *data = (v_u16 *)V_GetMemoryObjectAddress(memory);
    int i;

    for (i = 0; i < 16 * 10; i++) {
        data[i] = (v_u16)(i % 16 < 15 ? 0xFFFF - i : 0x1234);
    }
    CHECK(VL_MemWriteRect(&cb, back() + 60 * pitch() + 10 * 2, pitch(), memory, NULL,
                          V_PIXFMT_565, 32, 15, 10) == VL_SUCCESS);
    CHECK(pixel(10, 60) == 0xFFFF && pixel(24, 69) == 0xFFFF - (9 * 16 + 14));
    CHECK(pixel(25, 60) == 0);
    /* A destination that is no multiple of four. */
    CHECK(VL_MemWrite(&cb, back() + 75 * pitch() + 11 * 2, memory,
                      (v_u32 *)(void *)(data + 16), V_PIXFMT_565, 5) == VL_SUCCESS);
    CHECK(pixel(10, 75) == 0 && pixel(11, 75) == 0xFFFF - 16 && pixel(16, 75) == 0);
    issue(verite, cb);
    CHECK(V_FreeLockedMem(verite, memory) == V_SUCCESS);
}

/* Within one picture, and from a texture with a key. */
static void copies(void)
{
    v_u16 data[16 * 16];
    v_surface *surface;
    int i;

    for (i = 0; i < 16 * 16; i++) {
        data[i] = (v_u16)((i / 16 + i) % 2 ? 0xF81F : 0x0000);
    }
    surface = texture(V_PIXFMT_565, 16, 16, 32, data);
    CHECK(VL_SetSurfaceChromaKey(surface, 1) == VL_SUCCESS);
    VL_FillBuffer(&cb, display, 1, 50, 60, 40, 16, 0x07E0);
    VL_InstallTextureMap(&cb, surface);
    VL_SetChromaKey(&cb, V_CHROMAKEY_DISABLE);
    CHECK(VL_Bitblt(&cb, 50, 60, 16, 16, 0, 0) == VL_SUCCESS);
    VL_SetChromaKey(&cb, V_CHROMAKEY_ENABLE);
    VL_SetTranspReject(&cb, V_TRANSPREJECT_ENABLE);
    CHECK(VL_Bitblt(&cb, 70, 60, 16, 16, 0, 0) == VL_SUCCESS);
    CHECK(count(50, 60, 66, 76, 0x0000) == 128 && count(50, 60, 66, 76, 0xF81F) == 128);
    CHECK(count(70, 60, 86, 76, 0x07E0) == 128 && count(70, 60, 86, 76, 0xF81F) == 128);
    VL_SetChromaKey(&cb, V_CHROMAKEY_DISABLE);
    VL_SetTranspReject(&cb, V_TRANSPREJECT_DISABLE);
    /* By the operation XOR, twice is nothing. */
    for (i = 0; i < 2; i++) {
        CHECK(VL_CopyBuffer(&cb, surface, 0, V_ALUMODE_SRC_XOR_DST, 100, 60, 16, 16, 0, 0)
              == VL_SUCCESS);
        CHECK(count(100, 60, 116, 76, 0xF81F) == (i == 0 ? 128 : 0));
    }
    VL_CopyBuffer(&cb, surface, 0, V_ALUMODE_SRC, 100, 60, 16, 16, 0, 0);
    CHECK(VL_DestroySurface(verite, surface) == VL_SUCCESS);
}

/* Bytes as indices into a texture of 256x1. */
static void lookup(void)
{
    v_u16 palette[256];
    v_surface *surface;
    v_memory memory = V_AllocLockedMem(verite, 4096);
    unsigned char *bytes = (unsigned char *)V_GetMemoryObjectAddress(memory);
    int i, wrong = 0;

    for (i = 0; i < 256; i++) {
        palette[i] = (v_u16)(i * 257);
    }
    surface = texture(V_PIXFMT_565, 256, 1, 512, palette);
    for (i = 0; i < 64 * 30; i++) {
        bytes[i] = (unsigned char)(i * 7);
    }
    VL_InstallTextureMapBasic(&cb, surface);
    VL_SetSrcFmt(&cb, V_PIXFMT_565);
    VL_SetSrcFunc(&cb, V_SRCFUNC_REPLACE);
    VL_SetSrcFilter(&cb, V_SRCFILTER_POINT);
    CHECK(VL_Lookup(&cb, 130, 10, 62, 30, memory, NULL) == VL_SUCCESS);
    lock(display, 1);
    for (i = 0; i < 62 * 30; i++) {
        v_u16 expected = palette[bytes[i / 62 * 64 + i % 62]];

        /* Texels are widened without padding and cut again. */
        wrong += *at16(130 + i % 62, 10 + i / 62) != expected;
    }
    unlock();
    CHECK(wrong == 0);
    CHECK(V_FreeLockedMem(verite, memory) == V_SUCCESS);
    CHECK(VL_DestroySurface(verite, surface) == VL_SUCCESS);
}

/* Runs of pixels and what is skipped between them. */
static void sprite(void)
{
    v_memory memory = V_AllocLockedMem(verite, 4096);
    v_u32 *word = V_GetMemoryObjectAddress(memory), line;

    for (line = 0; line < 8; line++) {
        *word++ = (line == 0 ? 0 : pitch() - 8) << 16 | 8;
        *word++ = 0xFFE0FFE0;
        *word++ = 0xF800F800;
    }
    *word++ = 0;
    CHECK(VL_MemWriteSprite(&cb, back() + 100 * pitch() + 10 * 2, V_PIXFMT_565, 8 * 12 + 4,
                            memory) == VL_SUCCESS);
    CHECK(count(8, 98, 30, 120, 0xFFE0) == 16 && count(8, 98, 30, 120, 0xF800) == 16);
    CHECK(pixel(10, 107) == 0xFFE0 && pixel(13, 107) == 0xF800);
    CHECK(V_FreeLockedMem(verite, memory) == V_SUCCESS);
}

static void particles(void)
{
    v_memory memory = V_AllocLockedMem(verite, 4096);
    v_u32 *word = V_GetMemoryObjectAddress(memory);
    int i;

    for (i = 0; i < 30; i++) {
        *word++ = V_FIFO_PACK_XY(40 + i * 8, 100 + i % 3 * 6);
        *word++ = V_FIFO_PACK_XY(4, 3);
        *word++ = 100u << 16;
        *word++ = 0x0000FFFF;
    }
    CHECK(VL_Particles(&cb, 30, memory) == VL_SUCCESS);
    CHECK(count(36, 96, 300, 130, 0x07FF) == 30 * 12);
    CHECK(V_FreeLockedMem(verite, memory) == V_SUCCESS);
}

/* Rectangles are placed by their centre and show the whole texture. */
static void rectangles(void)
{
    v_u16 data[4 * 4];
    v_surface *surface;
    v_xy at = { FIX(40), FIX(160) };
    int i;

    for (i = 0; i < 16; i++) {
        data[i] = (v_u16)(i % 4 < 2 ? (i / 4 < 2 ? 0xF800 : 0x07E0)
                                    : (i / 4 < 2 ? 0x001F : 0xFFFF));
    }
    surface = texture(V_PIXFMT_565, 4, 4, 8, data);
    CHECK(VL_SetSurfaceColorPad(surface, 1) == VL_SUCCESS);
    VL_InstallTextureMap(&cb, surface);
    VL_SetSrcFunc(&cb, V_SRCFUNC_REPLACE);
    CHECK(VL_Square(&cb, V_FIFO_XY, (v_u32)FIX(40), WORDS(at)) == VL_SUCCESS);
    CHECK(count(0, 130, 80, 200, 0xF800) == 400 && count(0, 130, 80, 200, 0xFFFF) == 400);
    CHECK(pixel(21, 141) == 0xF800 && pixel(58, 178) == 0xFFFF && pixel(61, 160) == 0);
    at.x = FIX(120);
    CHECK(VL_Rectangle(&cb, V_FIFO_XY, (v_u32)FIX(80), (v_u32)FIX(20), WORDS(at)) == VL_SUCCESS);
    CHECK(count(78, 130, 170, 200, 0x07E0) == 400);
    CHECK(pixel(81, 151) == 0xF800 && pixel(158, 168) == 0xFFFF);
    /* Half a texel to each pixel, from the corner. */
    CHECK(VL_Affine(&cb, (v_u32)FIX(180), (v_u32)FIX(150), 0, 0, (v_u32)FIX(40), (v_u32)FIX(40),
                    (v_u32)(65536 / 40 * 256), 0, 0, (v_u32)(65536 / 40 * 256)) == VL_SUCCESS);
    CHECK(pixel(181, 151) == 0xF800 && pixel(218, 188) == 0xFFFF);
    CHECK(VL_DestroySurface(verite, surface) == VL_SUCCESS);
}

static void host_blit(void)
{
    v_memory memory = V_AllocLockedMem(verite, 4096);
    v_u16 *data = (v_u16 *)V_GetMemoryObjectAddress(memory);
    int i;

    for (i = 0; i < 16 * 8; i++) {
        data[i] = 0xFD20;
    }
    CHECK(VL_BitbltMem(&cb, 250, 150, 16, 8, 0, memory, NULL) == VL_SUCCESS);
    CHECK(count(240, 140, 290, 170, 0xFD20) == 128);
    CHECK(V_FreeLockedMem(verite, memory) == V_SUCCESS);
}

int main(void)
{
    open_small();
    VL_SetSrcFunc(&cb, V_SRCFUNC_NOTEXTURE);
    fills();
    writes();
    copies();
    lookup();
    sprite();
    VL_SetSrcFunc(&cb, V_SRCFUNC_NOTEXTURE);
    particles();
    rectangles();
    host_blit();
    show();
    return finish();
}
