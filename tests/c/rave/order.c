/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * order.c: pixels with the high byte first, as a PowerPC has them. The argument
 * says what of the program's memory is so, and the same picture is drawn.
 */
#define _POSIX_C_SOURCE 200112L

#include "rave_test.h"

static Target target;
static TQADrawContext *context;
static TQAEngine *engine;
static int pictures_are_big, buffers_are_big;

static TQAUInt32 swapped(TQAUInt32 value, int bytes)
{
    return bytes == 2 ? (value >> 8 & 0xff) | (value & 0xff) << 8
                      : value >> 24 | (value >> 8 & 0xff00) | (value & 0xff00) << 8 | value << 24;
}

/* Stores an integer as pictures have it. */
static void put(void *to, TQAUInt32 value, int bytes)
{
    unsigned short half;

    value = pictures_are_big ? swapped(value, bytes) : value;
    if (bytes == 2) {
        half = (unsigned short)value;
        memcpy(to, &half, 2);
    } else {
        memcpy(to, &value, 4);
    }
}

/* A pixel of the screen. */
static TQAUInt32 screen(int x, int y)
{
    TQAUInt32 pixel = target.pixels[y * 64 + x];

    return (buffers_are_big ? swapped(pixel, 4) : pixel) & 0xffffff;
}

typedef struct Kind {
    TQAImagePixelType type;
    int bytes;
    TQAUInt32 pixel, shown;
} Kind;

static const Kind kinds[] = {
    {kQAPixel_RGB16, 2, 0x7c1f, 0xff00ff},       {kQAPixel_ARGB16, 2, 0x83e0, 0x00ff00},
    {kQAPixel_RGB32, 4, 0x00123456, 0x123456},   {kQAPixel_ARGB32, 4, 0xff654321u, 0x654321},
    {kQAPixel_RGB16_565, 2, 0xf81f, 0xff00ff},   {kQAPixel_ARGB16_4444, 2, 0xf8c0, 0x88cc00},
    {kQAPixel_ACL16_88, 2, 0xff02, 0x204060},    {kQAPixel_AI16_88, 2, 0xff40, 0x404040}};

#define KINDS ((int)(sizeof kinds / sizeof *kinds))

static TQAColorTable *table;

/* Textures in a row, bitmaps below. */
static void draw_pictures(void)
{
    unsigned char pixels[4];
    TQATexture *textures[KINDS];
    TQABitmap *bitmaps[KINDS];
    int i;

    QARenderStart(context, NULL, NULL);
    for (i = 0; i < KINDS; i++) {
        const Kind *kind = &kinds[i];
        TQAVGouraud corner = gv((float)(8 * i + 2), 10, 0.5f, 1, 1, 1, 1);

        put(pixels, kind->pixel, kind->bytes);
        textures[i] = make_texture(engine, 0, kind->type, 1, 1, kind->bytes, pixels);
        bitmaps[i] = make_bitmap(engine, 0, kind->type, 1, 1, kind->bytes, pixels);
        if (kind->type == kQAPixel_ACL16_88) {
            CHECK(QATextureBindColorTable(engine, textures[i], table) == kQANoErr);
            CHECK(QABitmapBindColorTable(engine, bitmaps[i], table) == kQANoErr);
        }
        QASetPtr(context, kQATag_Texture, textures[i]);
        texture_rect(context, (float)(8 * i), 0, (float)(8 * i + 8), 8, 0.5f);
        QADrawBitmap(context, &corner, bitmaps[i]);
    }
}

static void check_kinds(void)
{
    int i;

    for (i = 0; i < KINDS; i++) {
        CHECK(screen(8 * i + 4, 4) == kinds[i].shown);
        CHECK(screen(8 * i + 2, 10) == kinds[i].shown);
    }
}

/* Bytes stay bytes. */
static void check_bytes(void)
{
    unsigned char index = 3, chroma[4] = {81, 90, 81, 240}, rgb[3] = {0x11, 0x22, 0x33};
    TQATexture *cl8 = make_texture(engine, 0, kQAPixel_CL8, 1, 1, 1, &index);
    TQATexture *yuv = make_texture(engine, 0, kQAPixel_YUVS, 2, 1, 4, chroma);
    TQATexture *rgb24 = make_texture(engine, 0, kQAPixel_RGB24, 1, 1, 3, rgb);

    CHECK(QATextureBindColorTable(engine, cl8, table) == kQANoErr);
    QASetPtr(context, kQATag_Texture, cl8);
    texture_rect(context, 0, 16, 8, 24, 0.5f);
    QASetPtr(context, kQATag_Texture, yuv);
    texture_rect(context, 8, 16, 16, 24, 0.5f);
    QASetPtr(context, kQATag_Texture, rgb24);
    texture_rect(context, 16, 16, 24, 24, 0.5f);
}

static TQAUInt32 of_buffer(TQAUInt32 value, int bytes)
{
    return buffers_are_big ? swapped(value, bytes) : value;
}

/* The program's side of the buffers. */
static void check_access(void)
{
    TQAPixelBuffer buffer;
    TQAZBuffer depths;
    TQARect one = {50, 51, 30, 31};

    CHECK(QAAccessDrawBuffer(context, &buffer) == kQANoErr);
    {
        TQAUInt32 *row = (TQAUInt32 *)(void *)((char *)buffer.baseAddr + 4 * buffer.rowBytes);

        CHECK((of_buffer(row[8 * 2 + 4], 4) & 0xffffff) == 0x123456);
        row = (TQAUInt32 *)(void *)((char *)buffer.baseAddr + 30 * buffer.rowBytes);
        row[50] = of_buffer(0x00abcdef, 4);
    }
    CHECK(QAAccessDrawBufferEnd(context, &one) == kQANoErr);
    CHECK(QAAccessZBuffer(context, &depths) == kQANoErr);
    CHECK(depths.zDepth == 16 && !depths.isBigEndian == !buffers_are_big);
    {
        unsigned short *row = (unsigned short *)(void *)((char *)depths.zbuffer + 4 * depths.rowBytes);

        CHECK(abs((int)of_buffer(row[4], 2) - 0x7fff) <= 2);
        row[60] = (unsigned short)of_buffer(0x1234, 2);
    }
    CHECK(QAAccessZBufferEnd(context, NULL) == kQANoErr);
    CHECK(QAAccessZBuffer(context, &depths) == kQANoErr);
    {
        unsigned short *row = (unsigned short *)(void *)((char *)depths.zbuffer + 4 * depths.rowBytes);

        CHECK(of_buffer(row[60], 2) == 0x1234);
    }
    CHECK(QAAccessZBufferEnd(context, NULL) == kQANoErr);
}

static void composite(const TQADrawContext *drawn, const TQADevice *buffer, const TQARect *dirty,
                      void *refCon)
{
    const TQADeviceMemory *memory = &buffer->device.memoryDevice;
    TQAUInt32 *row = (TQAUInt32 *)(void *)((char *)memory->baseAddr + 40 * memory->rowBytes);

    (void)drawn;
    (void)dirty;
    (void)refCon;
    row[5] = of_buffer(0x00fedcba, 4);
}

static void check_texture_access(void)
{
    static unsigned char pixels[4];
    TQATexture *texture;
    TQAPixelBuffer buffer;
    TQAUInt32 pixel;

    put(pixels, 0xff112233u, 4);
    texture = make_texture(engine, 0, kQAPixel_ARGB32, 1, 1, 4, pixels);
    CHECK(QAAccessTexture(engine, texture, 0, 0, &buffer) == kQANoErr);
    CHECK(memcmp(buffer.baseAddr, pixels, 4) == 0);
    put(buffer.baseAddr, 0xff998877u, 4);
    CHECK(QAAccessTextureEnd(engine, texture, NULL) == kQANoErr);
    QASetPtr(context, kQATag_Texture, texture);
    texture_rect(context, 24, 16, 32, 24, 0.5f);
    pixel = 0;
    memcpy(&pixel, pixels, 4);
    CHECK(pixel == (pictures_are_big ? 0x332211ffu : 0xff112233u));
}

int main(int count, char **arguments)
{
    static unsigned char entries[256 * 4];
    TQANoticeMethod method;
    const char *how = count > 1 ? arguments[1] : "0";
    int i;

    CHECK(setenv("FILLRATE_RAVE_BIG_ENDIAN", how, 1) == 0);
    buffers_are_big = strcmp(how, "1") == 0;
    pictures_are_big = buffers_are_big || strcmp(how, "pictures") == 0;
    context = open_usual(&target, 64, 48);
    engine = engine_for(&target);
    for (i = 0; i < 256; i++) {
        put(entries + 4 * i, (TQAUInt32)i * 0x102030u & 0xffffff, 4);
    }
    CHECK(QAColorTableNew(engine, kQAColorTable_CL8_RGB32, entries, 0, &table) == kQANoErr);
    method.bufferNoticeMethod = composite;
    CHECK(QASetNoticeMethod(context, kQAMethod_ImageBuffer2DComposite, method, NULL) == kQANoErr);
    draw_pictures();
    check_bytes();
    check_texture_access();
    check_access();
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
    check_kinds();
    CHECK(screen(4, 20) == 0x306090 && red(screen(12, 20)) > 240 && blue(screen(12, 20)) < 16);
    CHECK(screen(20, 20) == 0x332211 && screen(28, 20) == 0x998877);
    CHECK(screen(50, 30) == 0xabcdef && screen(5, 40) == 0xfedcba);
    CHECK(margin_is_clean(&target));
    QADrawContextDelete(context);
    return CHECK_REPORT();
}
