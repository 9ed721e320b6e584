/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * access.c: memory of buffers, textures and bitmaps; clears in mid-frame;
 * pictures made of draw contexts; ATI's extension.
 */
#include "rave_test.h"

#include <RAVE_ati.h>

static Target target;
static TQADrawContext *context;
static TQAEngine *engine;

static void check_draw_buffer(void)
{
    TQAPixelBuffer buffer;
    TQARect dirty = {0, 64, 20, 30};
    TQAUInt32 *pixels;
    int i;

    QARenderStart(context, NULL, NULL);
    gouraud_rect(context, 0, 0, 32, 48, 0.5f, 1, 0, 0, 1);
    CHECK(QAAccessDrawBuffer(context, &buffer) == kQANoErr);
    CHECK(buffer.width == 64 && buffer.height == 48 && buffer.pixelType == kQAPixel_RGB32);
    pixels = buffer.baseAddr;
    CHECK((pixels[10 * buffer.rowBytes / 4 + 10] & 0xffffff) == 0xff0000);
    for (i = 0; i < 64; i++) {
        pixels[10 * buffer.rowBytes / 4 + i] = 0x00ff00; /* not in the rectangle */
        pixels[25 * buffer.rowBytes / 4 + i] = 0x0000ff;
    }
    CHECK(QAAccessDrawBuffer(context, &buffer) != kQANoErr);
    CHECK(QAAccessDrawBufferEnd(context, &dirty) == kQANoErr);
    CHECK(QAAccessDrawBufferEnd(context, &dirty) != kQANoErr);
    gouraud_rect(context, 60, 0, 64, 48, 0.5f, 1, 1, 1, 1);
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
    CHECK(at(&target, 10, 10) == 0xff0000 && at(&target, 10, 25) == 0x0000ff);
    CHECK(at(&target, 40, 25) == 0x0000ff && at(&target, 62, 25) == 0xffffff);
}

static void check_z_buffer(void)
{
    TQAZBuffer buffer;
    int x, y;

    QARenderStart(context, NULL, NULL);
    gouraud_rect(context, 0, 0, 32, 48, 0.5f, 1, 0, 0, 1);
    CHECK(QAAccessZBuffer(context, &buffer) == kQANoErr);
    CHECK(buffer.width == 64 && buffer.height == 48 && buffer.isBigEndian == 0);
    CHECK(buffer.zDepth == 16);
    {
        unsigned short *row = (unsigned short *)(void *)((char *)buffer.zbuffer + 5 * buffer.rowBytes);

        CHECK(abs((int)row[10] - 0x7fff) <= 2 && row[40] == 0xffff);
    }
    /* The right half becomes the nearest there is. */
    for (y = 0; y < buffer.height; y++) {
        unsigned short *row = (unsigned short *)(void *)((char *)buffer.zbuffer + y * buffer.rowBytes);

        for (x = 32; x < 64; x++) {
            row[x] = 0;
        }
    }
    CHECK(QAAccessZBufferEnd(context, NULL) == kQANoErr);
    gouraud_rect(context, 0, 0, 64, 48, 0.3f, 0, 1, 0, 1);
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
    CHECK(at(&target, 10, 10) == 0x00ff00 && at(&target, 40, 10) == 0);
    /* Without one there is nothing to see. */
    {
        static Target flat;
        TQADrawContext *without;

        init_target(&flat, kQAPixel_RGB32, 16, 16, 0);
        without = open_context(&flat, kQAContext_NoZBuffer);
        CHECK(QAAccessZBuffer(without, &buffer) != kQANoErr);
        QADrawContextDelete(without);
    }
}

static void check_clears(void)
{
    TQARect left = {0, 20, 0, 48};

    background(context, 0, 0, 1);
    QARenderStart(context, NULL, NULL);
    gouraud_rect(context, 0, 0, 64, 48, 0.3f, 1, 0, 0, 1);
    CHECK(QAClearDrawBuffer(context, &left, NULL) == kQANoErr);
    gouraud_rect(context, 0, 0, 64, 10, 0.5f, 0, 1, 0, 1); /* hidden everywhere */
    CHECK(QAClearZBuffer(context, &left, NULL) == kQANoErr);
    gouraud_rect(context, 0, 10, 64, 20, 0.5f, 0, 1, 0, 1); /* seen at the left */
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
    CHECK(at(&target, 5, 5) == 0x0000ff && at(&target, 30, 5) == 0xff0000);
    CHECK(at(&target, 5, 15) == 0x00ff00 && at(&target, 30, 15) == 0xff0000);
    CHECK(at(&target, 5, 30) == 0x0000ff);
    background(context, 0, 0, 0);
}

static void check_textures(void)
{
    static TQAUInt32 texels[4] = {0xffff0000u, 0xffff0000u, 0xffff0000u, 0xffff0000u};
    TQATexture *texture = make_texture(engine, 0, kQAPixel_ARGB32, 2, 2, 8, texels);
    TQABitmap *bitmap = make_bitmap(engine, 0, kQAPixel_ARGB32, 2, 2, 8, texels);
    TQAPixelBuffer buffer;
    TQARect one = {1, 2, 0, 1};
    TQAVGouraud corner = gv(40, 10, 0.5f, 0, 0, 0, 1);

    CHECK(QAAccessTexture(engine, texture, 7, 0, &buffer) != kQANoErr);
    CHECK(QAAccessTexture(engine, texture, 0, 0, &buffer) == kQANoErr);
    CHECK(buffer.width == 2 && buffer.height == 2 && buffer.pixelType == kQAPixel_ARGB32);
    CHECK(((TQAUInt32 *)buffer.baseAddr)[0] == 0xffff0000u);
    ((TQAUInt32 *)buffer.baseAddr)[0] = 0xffffffffu; /* not in the rectangle */
    ((TQAUInt32 *)buffer.baseAddr)[1] = 0xff00ff00u;
    CHECK(QAAccessTextureEnd(engine, texture, &one) == kQANoErr);
    CHECK(QAAccessTextureEnd(engine, texture, &one) != kQANoErr);
    CHECK(QAAccessBitmap(engine, bitmap, kQANoCopyNeeded, &buffer) == kQANoErr);
    ((TQAUInt32 *)buffer.baseAddr)[0] = ((TQAUInt32 *)buffer.baseAddr)[1] = 0xff0000ffu;
    ((TQAUInt32 *)(void *)((char *)buffer.baseAddr + buffer.rowBytes))[0] = 0xffffff00u;
    ((TQAUInt32 *)(void *)((char *)buffer.baseAddr + buffer.rowBytes))[1] = 0xffffff00u;
    CHECK(QAAccessBitmapEnd(engine, bitmap, NULL) == kQANoErr);
    QARenderStart(context, NULL, NULL);
    QASetPtr(context, kQATag_Texture, texture);
    texture_rect(context, 0, 0, 32, 32, 0.5f);
    QADrawBitmap(context, &corner, bitmap);
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
    CHECK(at(&target, 8, 8) == 0xff0000 && at(&target, 24, 8) == 0x00ff00);
    CHECK(at(&target, 8, 24) == 0xff0000);
    CHECK(at(&target, 40, 10) == 0x0000ff && at(&target, 41, 11) == 0xffff00);
    QASetPtr(context, kQATag_Texture, NULL);
    QATextureDelete(engine, texture);
    QABitmapDelete(engine, bitmap);
}

static void check_pictures_of_contexts(void)
{
    static Target off;
    TQADrawContext *source;
    TQATexture *texture = NULL;
    TQABitmap *bitmap = NULL;
    TQAVGouraud corner = gv(40, 8, 0.5f, 0, 0, 0, 1);

    init_target(&off, kQAPixel_RGB32, 16, 16, 0);
    source = open_context(&off, kQAContext_DoubleBuffer);
    CHECK(QATextureNewFromDrawContext(source, 0, &texture) == kQANoErr);
    CHECK(QABitmapNewFromDrawContext(source, 0, &bitmap) == kQANoErr);
    QARenderStart(source, NULL, NULL);
    gouraud_rect(source, 0, 0, 16, 8, 0.5f, 1, 0, 0, 1);
    gouraud_rect(source, 0, 8, 16, 16, 0.5f, 0, 0, 1, 1);
    CHECK(QARenderEnd(source, NULL) == kQANoErr);
    QARenderStart(context, NULL, NULL);
    QASetPtr(context, kQATag_Texture, texture);
    texture_rect(context, 0, 0, 32, 32, 0.5f);
    QADrawBitmap(context, &corner, bitmap);
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
    CHECK(at(&target, 10, 5) == 0xff0000 && at(&target, 10, 28) == 0x0000ff);
    CHECK(at(&target, 41, 9) == 0xff0000 && at(&target, 55, 23) == 0x0000ff);
    /* The next frame of the source is in the picture. */
    QARenderStart(source, NULL, NULL);
    gouraud_rect(source, 0, 0, 16, 16, 0.5f, 0, 1, 0, 1);
    CHECK(QARenderEnd(source, NULL) == kQANoErr);
    QARenderStart(context, NULL, NULL);
    texture_rect(context, 0, 0, 32, 32, 0.5f);
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
    CHECK(at(&target, 10, 5) == 0x00ff00);
    QASetPtr(context, kQATag_Texture, NULL);
    QATextureDelete(engine, texture);
    QABitmapDelete(engine, bitmap);
    QADrawContextDelete(source);
}

static void check_extension(void)
{
    static TQAUInt32 texels[1] = {0xffff0000u}, others[1] = {0xff00ff00u};
    TQATexture *texture = make_texture(engine, 0, kQAPixel_ARGB32, 1, 1, 4, texels);
    TQAImage image = image_of(1, 1, 4, others);
    const ATIRaveExtFuncs *functions = QAGetPtr(context, (TQATagPtr)kATIRaveExtFuncs);
    TQADevice buffer;
    void *current;

    CHECK(functions != NULL);
    CHECK(functions->bindCodeBook(texture, texels) == kQANotSupported);
    CHECK(functions->getDrawBuffer(context, &buffer) == kQANoErr);
    CHECK(buffer.deviceType == kQADeviceMemory);
    CHECK(buffer.device.memoryDevice.baseAddr == (void *)target.pixels);
    current = &target.device;
    CHECK(QAEngineGestalt(engine, (TQAGestaltSelector)kATIGestalt_CurrentContext, &current) ==
          kQANoErr);
    CHECK(current == (void *)context);
    background(context, 0, 0, 1);
    /* The board's own numbers: 4 is linear. */
    QASetInt(context, (TQATagInt)kATIFogMode, kATIFogLinear);
    CHECK(QAGetInt(context, (TQATagInt)kATIFogMode) == kATIFogLinear);
    QASetInt(context, (TQATagInt)kATIFogMode, kATIFogDisable);
    QARenderStart(context, NULL, NULL);
    gouraud_rect(context, 0, 0, 64, 48, 0.5f, 1, 1, 1, 1);
    CHECK(functions->clearDrawBuffer(context, NULL) == kQANoErr);
    CHECK(functions->clearZBuffer(context, NULL) == kQANoErr);
    CHECK(functions->textureUpdate(0, kQAPixel_ARGB32, &image, texture) == kQANoErr);
    QASetPtr(context, kQATag_Texture, texture);
    texture_rect(context, 8, 8, 24, 24, 0.9f);
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
    CHECK(at(&target, 2, 2) == 0x0000ff && at(&target, 16, 16) == 0x00ff00);
    QASetPtr(context, kQATag_Texture, NULL);
    QATextureDelete(engine, texture);
}

int main(void)
{
    context = open_usual(&target, 64, 48);
    engine = engine_for(&target);
    check_draw_buffer();
    check_z_buffer();
    check_clears();
    check_textures();
    check_pictures_of_contexts();
    check_extension();
    CHECK(margin_is_clean(&target));
    QADrawContextDelete(context);
    return CHECK_REPORT();
}
