/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * bad_input.c: null and foreign pointers, numbers out of every range, objects that
 * are gone. Nothing crashes or writes elsewhere, and the engine draws afterwards.
 */
#include "rave_test.h"

#include <RAVE_system.h>

static Target target;

/* Something that is not ours. */
static TQADrawContext impostor;

static float float_of(TQAUInt32 bits)
{
    float f;

    memcpy(&f, &bits, sizeof f);
    return f;
}

static void check_null(void)
{
    TQADrawContext *context = &impostor;
    TQAEngine *engine = engine_for(&target);
    TQAUInt32 number = 0;
    TQARect empty = {10, 10, 5, 5}, wide = {0, 1 << 30, 0, 1 << 30}, odd = {-5, 20, -5, 20};
    TQADevice device = target.device;
    TQAClip clip;

    CHECK(QADrawContextNew(NULL, &target.rect, NULL, engine, 0, &context) == kQAParamErr);
    CHECK(context == NULL);
    CHECK(QADrawContextNew(&target.device, NULL, NULL, engine, 0, &context) == kQAParamErr);
    CHECK(QADrawContextNew(&target.device, &target.rect, NULL, NULL, 0, &context) ==
          kQAParamErr);
    CHECK(QADrawContextNew(&target.device, &target.rect, NULL, engine, 0, NULL) == kQAParamErr);
    CHECK(QADrawContextNew(&target.device, &empty, NULL, engine, 0, &context) != kQANoErr);
    CHECK(QADrawContextNew(&target.device, &wide, NULL, engine, 0, &context) != kQANoErr);
    CHECK(QADrawContextNew(&target.device, &odd, NULL, engine, 0, &context) != kQANoErr);
    clip.clipType = kQAClipRgn;
    clip.clip.clipRgn = &number;
    CHECK(QADrawContextNew(&target.device, &target.rect, &clip, engine, 0, &context) ==
          kQAParamErr);
    device.deviceType = kQADeviceDDSurface;
    CHECK(QADrawContextNew(&device, &target.rect, NULL, engine, 0, &context) != kQANoErr);
    device = target.device;
    device.device.memoryDevice.rowBytes = 5;
    CHECK(QADrawContextNew(&device, &target.rect, NULL, engine, 0, &context) != kQANoErr);
    device = target.device;
    device.device.memoryDevice.baseAddr = NULL;
    CHECK(QADrawContextNew(&device, &target.rect, NULL, engine, 0, &context) != kQANoErr);
    device = target.device;
    device.device.memoryDevice.pixelType = kQAPixel_YUVS;
    CHECK(QADrawContextNew(&device, &target.rect, NULL, engine, 0, &context) != kQANoErr);
    CHECK(QAEngineGestalt(NULL, kQAGestalt_VendorID, &number) == kQAParamErr);
    CHECK(QAEngineGestalt(engine, kQAGestalt_VendorID, NULL) == kQAParamErr);
    CHECK(QAEngineCheckDevice(engine, NULL) == kQAParamErr);
    CHECK(QADeviceGetNextEngine(NULL, (TQAEngine *)&impostor) == NULL);
    QADrawContextDelete(NULL);
    QADrawContextDelete(&impostor);
    QATextureDelete(engine, NULL);
    QATextureDelete(engine, (TQATexture *)&impostor);
    QATextureDelete(NULL, NULL);
    QABitmapDelete(engine, (TQABitmap *)&impostor);
    QAColorTableDelete(engine, (TQAColorTable *)&impostor);
    CHECK(QATextureBindColorTable(engine, NULL, NULL) != kQANoErr);
    CHECK(QAColorTableNew(engine, (TQAColorTableType)9, &number, 0, (TQAColorTable **)&context) ==
          kQAParamErr);
}

/* The functions, which cannot trust the structure. */
#undef QARenderStart
#undef QARenderEnd
#undef QASync
#undef QASetInt
#undef QADrawTriGouraud
#undef QASubmitVerticesGouraud
#undef QADrawTriMeshGouraud
#undef QASetNoticeMethod
#undef QAAccessDrawBuffer

static void check_impostor(void)
{
    TQAVGouraud v = gv(1, 1, 0.5f, 1, 1, 1, 1);
    TQAPixelBuffer buffer;
    TQANoticeMethod notice;
    TQADrawMethod method;

    notice.standardNoticeMethod = NULL;
    method.drawPoint = NULL;
    QARenderStart(&impostor, NULL, NULL);
    QASetInt(&impostor, kQATag_Blend, 1);
    QADrawTriGouraud(&impostor, &v, &v, &v, 0);
    QASubmitVerticesGouraud(NULL, 1, &v);
    QADrawTriMeshGouraud(NULL, 1, NULL);
    CHECK(QARenderEnd(&impostor, NULL) != kQANoErr);
    CHECK(QASync(NULL) != kQANoErr);
    CHECK(QASetNoticeMethod(NULL, kQAMethod_RenderCompletion, notice, NULL) != kQANoErr);
    CHECK(QAAccessDrawBuffer(&impostor, &buffer) != kQANoErr);
    CHECK(QARegisterDrawMethod(&impostor, kQADrawPoint, method) == kQAParamErr);
}

/* Numbers for vertices: some fit, most do not. */
static float any_float(TQAUInt32 *seed)
{
    static const TQAUInt32 special[] = {0x7fc00000, 0x7f800000, 0xff800000, 0x7f7fffff,
                                        0xff7fffff, 0x00000001, 0x80000000, 0x4f000000,
                                        0xcf000000, 0x3f800000};

    *seed = *seed * 1664525u + 1013904223u;
    if (*seed >> 28 < 6) {
        return float_of(special[*seed >> 8 & 0xffff % (sizeof special / sizeof *special)] |
                        (*seed & 1 ? 0x80000000u : 0)) *
               1.0f;
    }
    return (float)((int)(*seed >> 12 & 0xfff) - 1000) / (*seed & 1 ? 8.0f : 1024.0f);
}

static void any_gouraud(TQAVGouraud *v, TQAUInt32 *seed)
{
    float *f = &v->x;
    int i;

    for (i = 0; i < 8; i++) {
        f[i] = any_float(seed);
    }
}

static void any_texture(TQAVTexture *v, TQAUInt32 *seed)
{
    float *f = &v->x;
    int i;

    for (i = 0; i < 16; i++) {
        f[i] = any_float(seed);
    }
}

static void check_numbers(TQADrawContext *context, TQATexture *texture, TQABitmap *bitmap)
{
    TQAUInt32 seed = 99;
    TQAVGouraud g[6];
    TQAVTexture t[6];
    int round, i;

    for (round = 0; round < 300; round++) {
        context->renderStart(context, NULL, round % 3 ? NULL : context);
        context->setPtr(context, kQATag_Texture, round % 5 ? texture : (TQATexture *)&impostor);
        for (i = 0; i < 12; i++) {
            seed = seed * 1664525u + 1013904223u;
            context->setInt(context, (TQATagInt)(seed >> 24), seed >> 4 & (round % 2 ? 7 : ~0u));
            context->setFloat(context, (TQATagFloat)(seed >> 16 & 0xff), any_float(&seed));
            (void)context->getInt(context, (TQATagInt)(seed >> 10));
            (void)context->getFloat(context, (TQATagFloat)(seed >> 9));
        }
        for (i = 0; i < 6; i++) {
            any_gouraud(&g[i], &seed);
            any_texture(&t[i], &seed);
        }
        context->drawPoint(context, &g[0]);
        context->drawLine(context, &g[0], &g[1]);
        context->drawTriGouraud(context, &g[0], &g[1], &g[2], seed);
        context->drawTriTexture(context, &t[0], &t[1], &t[2], seed);
        context->drawVGouraud(context, 6, (TQAVertexMode)(round % 8), g, NULL);
        context->drawVTexture(context, 6, (TQAVertexMode)(round % 8), t, NULL);
        context->drawBitmap(context, &g[3], round % 2 ? bitmap : NULL);
        context->drawVGouraud(context, 0xffffffffu, kQAVertexMode_Tri, NULL, NULL);
        context->submitMultiTextureParams(context, 0, NULL);
        (void)context->clearDrawBuffer(context, NULL, context);
        if (round % 7 == 0) {
            (void)context->renderAbort(context);
        } else {
            (void)context->renderEnd(context, NULL);
        }
    }
}

int main(void)
{
    static TQAUInt32 texels[16 * 16];
    TQADrawContext *context;
    TQATexture *texture;
    TQABitmap *bitmap;
    TQAEngine *engine;
    int i;

    init_target(&target, kQAPixel_RGB32, 64, 48, 0);
    check_null();
    check_impostor();
    context = open_context(&target, kQAContext_DoubleBuffer);
    engine = engine_for(&target);
    for (i = 0; i < 256; i++) {
        texels[i] = (TQAUInt32)i * 0x01030507u;
    }
    texture = make_texture(engine, 0, kQAPixel_ARGB32, 16, 16, 64, texels);
    bitmap = make_bitmap(engine, 0, kQAPixel_ARGB32, 16, 16, 64, texels);
    check_numbers(context, texture, bitmap);
    /* Objects that are gone. */
    QATextureDelete(engine, texture);
    QATextureDelete(engine, texture);
    QABitmapDelete(engine, bitmap);
    CHECK(QATextureDetach(engine, texture) != kQANoErr);
    context->renderStart(context, NULL, NULL);
    context->setPtr(context, kQATag_Texture, texture);
    texture_rect(context, 0, 0, 32, 32, 0.5f);
    {
        TQAVGouraud v = gv(0, 0, 0.5f, 0, 0, 0, 1);

        context->drawBitmap(context, &v, bitmap);
    }
    (void)context->renderEnd(context, NULL);
    QADrawContextDelete(context);
    /* A new context draws as if nothing had been. */
    context = open_context(&target, kQAContext_DoubleBuffer);
    background(context, 0, 0, 1);
    context->renderStart(context, NULL, NULL);
    gouraud_rect(context, 8, 8, 56, 40, 0.5f, 1, 0, 0, 1);
    CHECK(context->renderEnd(context, NULL) == kQANoErr);
    CHECK(at(&target, 20, 20) == 0xff0000 && at(&target, 2, 2) == 0x0000ff);
    CHECK(margin_is_clean(&target));
    QADrawContextDelete(context);
    return CHECK_REPORT();
}
