/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * frames.c: when a frame is seen: double and single buffers, swaps on demand,
 * frames that are given up; notices and caches; scaled contexts; what the
 * program is told of drawing to its screen.
 */
#include "rave_test.h"

static Target target;

static void whole(const TQADrawContext *context, float r, float g, float b)
{
    gouraud_rect(context, 0, 0, 64, 48, 0.5f, r, g, b, 1);
}

static void check_buffers(void)
{
    TQADrawContext *context = open_usual(&target, 64, 48);

    CHECK(QAGetInt(context, kQATagGL_DrawBuffer) == kQAGL_DrawBuffer_Back);
    QARenderStart(context, NULL, NULL);
    whole(context, 1, 0, 0);
    CHECK(QAFlush(context) == kQANoErr && QASync(context) == kQANoErr);
    CHECK(at(&target, 5, 5) == 0);
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
    CHECK(at(&target, 5, 5) == 0xff0000);
    CHECK(QABusy(context) == 0 || QASync(context) == kQANoErr);
    /* Given up: nothing is shown. */
    QARenderStart(context, NULL, NULL);
    whole(context, 0, 1, 0);
    CHECK(QARenderAbort(context) == kQANoErr);
    CHECK(at(&target, 5, 5) == 0xff0000);
    /* Shown on demand. */
    QASetInt(context, kQATag_DontSwap, 1);
    QARenderStart(context, NULL, NULL);
    whole(context, 0, 0, 1);
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
    CHECK(at(&target, 5, 5) == 0xff0000);
    CHECK(QASwapBuffers(context, NULL) == kQANoErr);
    CHECK(at(&target, 5, 5) == 0x0000ff);
    QASetInt(context, kQATag_DontSwap, 0);
    /* Drawing outside of frames, and frames that do not fit together. */
    whole(context, 1, 1, 1);
    CHECK(QARenderEnd(context, NULL) != kQANoErr);
    QADrawContextDelete(context);

    init_target(&target, kQAPixel_RGB32, 64, 48, 0);
    context = open_context(&target, kQAContext_None);
    CHECK(QAGetInt(context, kQATagGL_DrawBuffer) == kQAGL_DrawBuffer_Front);
    QARenderStart(context, NULL, NULL);
    whole(context, 1, 0, 0);
    CHECK(QASync(context) == kQANoErr);
    CHECK(at(&target, 5, 5) == 0xff0000);
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
    CHECK(margin_is_clean(&target));
    QADrawContextDelete(context);
}

/* A part of the device, and a part of that shown. */
static void check_rectangles(void)
{
    TQARect part = {16, 48, 8, 40}, shown = {4, 12, 2, 10};
    TQADrawContext *context = NULL;

    init_target(&target, kQAPixel_RGB32, 64, 48, 0);
    CHECK(QADrawContextNew(&target.device, &part, NULL, engine_for(&target),
                           kQAContext_DoubleBuffer, &context) == kQANoErr);
    QARenderStart(context, NULL, NULL);
    whole(context, 1, 0, 0);
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
    CHECK(at(&target, 16, 8) == 0xff0000 && at(&target, 47, 39) == 0xff0000);
    CHECK(at(&target, 15, 8) == 0 && at(&target, 48, 20) == 0 && at(&target, 20, 7) == 0 &&
          at(&target, 20, 40) == 0);
    QARenderStart(context, NULL, NULL);
    whole(context, 0, 1, 0);
    CHECK(QARenderEnd(context, &shown) == kQANoErr);
    CHECK(at(&target, 20, 10) == 0x00ff00 && at(&target, 27, 17) == 0x00ff00);
    QADrawContextDelete(context);
    /* Twice the size in each direction, and half. */
    {
        TQARect two[2] = {{0, 32, 0, 24}, {0, 64, 0, 48}};

        init_target(&target, kQAPixel_RGB32, 64, 48, 0);
        CHECK(QADrawContextNew(&target.device, two, NULL, engine_for(&target),
                               kQAContext_DoubleBuffer | kQAContext_Scale, &context) == kQANoErr);
        QARenderStart(context, NULL, NULL);
        gouraud_rect(context, 8, 6, 16, 12, 0.5f, 1, 0, 0, 1);
        CHECK(QARenderEnd(context, NULL) == kQANoErr);
        CHECK(at(&target, 16, 12) == 0xff0000 && at(&target, 31, 23) == 0xff0000);
        CHECK(at(&target, 15, 12) == 0 && at(&target, 32, 12) == 0 && at(&target, 16, 24) == 0);
        QADrawContextDelete(context);
        two[0].right = 128;
        two[0].bottom = 96;
        CHECK(QADrawContextNew(&target.device, two, NULL, engine_for(&target),
                               kQAContext_DoubleBuffer | kQAContext_Scale, &context) == kQANoErr);
        QARenderStart(context, NULL, NULL);
        gouraud_rect(context, 1, 1, 128, 96, 0.5f, 1, 1, 1, 1);
        CHECK(QARenderEnd(context, NULL) == kQANoErr);
        /* A quarter of the corner pixel is white, half of its neighbours. */
        CHECK(is_near(at(&target, 0, 0), 64, 64, 64, 2));
        CHECK(is_near(at(&target, 1, 0), 128, 128, 128, 2) && at(&target, 1, 1) == 0xffffff);
        QADrawContextDelete(context);
    }
    CHECK(margin_is_clean(&target));
}

/* --- notices ----------------------------------------------------------------- */

typedef struct Log {
    char order[32];
    int length;
    const TQADrawContext *context;
    TQAUInt32 seen;
} Log;

static void note(Log *log, char what)
{
    if (log->length < 31) {
        log->order[log->length++] = what;
    }
}

static TQAUInt32 *pixel(const TQADevice *buffer, int x, int y)
{
    const TQADeviceMemory *memory = &buffer->device.memoryDevice;

    return (TQAUInt32 *)(void *)((char *)memory->baseAddr + y * memory->rowBytes) + x;
}

static void initialize(const TQADrawContext *context, const TQADevice *buffer,
                       const TQARect *dirty, void *refCon)
{
    Log *log = refCon;
    int x;

    note(log, 'i');
    log->context = context;
    CHECK(buffer->deviceType == kQADeviceMemory);
    CHECK(buffer->device.memoryDevice.width == 64 && buffer->device.memoryDevice.height == 48);
    CHECK(dirty->left == 0 && dirty->right == 64 && dirty->top == 0 && dirty->bottom == 48);
    for (x = 0; x < 64; x++) {
        *pixel(buffer, x, 3) = 0xff00ffffu;
    }
}

static void do_nothing(const TQADrawContext *context, const TQADevice *buffer,
                       const TQARect *dirty, void *refCon)
{
    (void)context;
    (void)buffer;
    (void)dirty;
    note(refCon, 'e');
}

static void composite(const TQADrawContext *context, const TQADevice *buffer,
                      const TQARect *dirty, void *refCon)
{
    Log *log = refCon;

    (void)context;
    (void)dirty;
    note(log, 'c');
    log->seen = *pixel(buffer, 5, 5) & 0xffffff;
    *pixel(buffer, 7, 7) = 0xffffff00u;
    /* Not shown yet. */
    CHECK(at(&target, 5, 5) != log->seen);
}

static void complete(const TQADrawContext *context, void *refCon)
{
    Log *log = refCon;

    note(log, 'd');
    CHECK(context == log->context);
    CHECK(at(&target, 5, 5) == log->seen);
}

static void check_notices(void)
{
    TQADrawContext *context = open_usual(&target, 64, 48);
    Log log;
    TQANoticeMethod method, before, got;
    void *refCon = &log;

    memset(&log, 0, sizeof log);
    CHECK(QAGetNoticeMethod(context, kQAMethod_ImageBufferInitialize, &before, &refCon) ==
          kQANoErr);
    CHECK(before.bufferNoticeMethod == NULL && refCon == NULL);
    method.bufferNoticeMethod = initialize;
    CHECK(QASetNoticeMethod(context, kQAMethod_ImageBufferInitialize, method, &log) == kQANoErr);
    CHECK(QAGetNoticeMethod(context, kQAMethod_ImageBufferInitialize, &got, &refCon) == kQANoErr);
    CHECK(got.bufferNoticeMethod == initialize && refCon == &log);
    method.bufferNoticeMethod = composite;
    CHECK(QASetNoticeMethod(context, kQAMethod_ImageBuffer2DComposite, method, &log) == kQANoErr);
    method.standardNoticeMethod = complete;
    CHECK(QASetNoticeMethod(context, kQAMethod_RenderCompletion, method, &log) == kQANoErr);
    CHECK(QASetNoticeMethod(context, kQAMethod_NumSelectors, method, &log) == kQAParamErr);

    background(context, 1, 0, 0);
    QARenderStart(context, NULL, NULL);
    note(&log, '-');
    gouraud_rect(context, 0, 0, 64, 2, 0.5f, 0, 1, 0, 1);
    gouraud_rect(context, 4, 4, 8, 8, 0.5f, 0, 0, 1, 1);
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
    CHECK(QASync(context) == kQANoErr);
    CHECK(strcmp(log.order, "i-cd") == 0);
    /* The notice took the clear's place; what it left is there. */
    CHECK(at(&target, 20, 3) == 0x00ffff && at(&target, 20, 20) == 0);
    CHECK(at(&target, 20, 1) == 0x00ff00 && log.seen == 0x0000ff);
    CHECK(at(&target, 7, 7) == 0xffff00 && at(&target, 6, 7) == 0x0000ff);

    /* One that does nothing keeps the picture; depths are cleared all the same. */
    method.bufferNoticeMethod = NULL;
    CHECK(QASetNoticeMethod(context, kQAMethod_ImageBuffer2DComposite, method, NULL) == kQANoErr);
    method.standardNoticeMethod = NULL;
    CHECK(QASetNoticeMethod(context, kQAMethod_RenderCompletion, method, NULL) == kQANoErr);
    method.bufferNoticeMethod = do_nothing;
    CHECK(QASetNoticeMethod(context, kQAMethod_ImageBufferInitialize, method, &log) == kQANoErr);
    QARenderStart(context, NULL, NULL);
    gouraud_rect(context, 4, 4, 6, 6, 0.9f, 1, 1, 1, 1);
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
    CHECK(at(&target, 20, 3) == 0x00ffff && at(&target, 7, 7) == 0xffff00);
    CHECK(at(&target, 4, 4) == 0xffffff && at(&target, 6, 6) == 0x0000ff);
    CHECK(log.order[log.length - 1] == 'e');

    /* The old method put back clears again. */
    CHECK(QASetNoticeMethod(context, kQAMethod_ImageBufferInitialize, before, NULL) == kQANoErr);
    QARenderStart(context, NULL, NULL);
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
    CHECK(at(&target, 20, 3) == 0xff0000 && at(&target, 4, 4) == 0xff0000);
    QADrawContextDelete(context);
}

/* --- caches --------------------------------------------------------------------- */

static void check_caches(void)
{
    TQADrawContext *context = open_usual(&target, 64, 48), *cache = NULL, *second = NULL;
    static Target small;
    TQADrawContext *other;

    CHECK(QADrawContextNew(&target.device, &target.rect, NULL, engine_for(&target),
                           kQAContext_DoubleBuffer | kQAContext_Cache, &cache) == kQANoErr);
    CHECK(QADrawContextNew(&target.device, &target.rect, NULL, engine_for(&target),
                           kQAContext_DoubleBuffer | kQAContext_Cache, &second) == kQANoErr);
    background(cache, 0, 0, 1);
    QARenderStart(cache, NULL, NULL);
    gouraud_rect(cache, 10, 10, 30, 30, 0.4f, 1, 0, 0, 1);
    CHECK(QARenderEnd(cache, NULL) == kQANoErr);
    CHECK(at(&target, 15, 15) == 0);
    /* A cache from a cache. */
    QARenderStart(second, NULL, cache);
    gouraud_rect(second, 40, 10, 60, 30, 0.4f, 1, 1, 0, 1);
    CHECK(QARenderEnd(second, NULL) == kQANoErr);
    QARenderStart(context, NULL, second);
    gouraud_rect(context, 0, 20, 64, 25, 0.6f, 0, 1, 0, 1);
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
    CHECK(at(&target, 2, 2) == 0x0000ff && at(&target, 15, 15) == 0xff0000);
    CHECK(at(&target, 50, 15) == 0xffff00);
    /* Depths came along. */
    CHECK(at(&target, 15, 22) == 0xff0000 && at(&target, 50, 22) == 0xffff00);
    CHECK(at(&target, 35, 22) == 0x00ff00);
    /* A cache of another size is no cache: a clear, and an error. */
    other = open_usual(&small, 32, 32);
    QARenderStart(other, NULL, cache);
    CHECK(QARenderEnd(other, NULL) == kQAParamErr);
    CHECK(at(&small, 15, 15) == 0);
    QADrawContextDelete(other);
    QADrawContextDelete(second);
    QADrawContextDelete(cache);
    QADrawContextDelete(context);
}

/* --- drawing to the screen --------------------------------------------------------- */

static int times, last[4];

static void about_to_draw(short left, short top, short right, short bottom, long refCon)
{
    times += (int)refCon;
    last[0] = left;
    last[1] = top;
    last[2] = right;
    last[3] = bottom;
}

static void check_draw_notification(void)
{
    TQAGlobalRect near_by = {0, 0, 10, 10}, elsewhere = {40, 100, 50, 120};
    TQADrawContext *context = open_usual(&target, 64, 48);
    TQAInt32 first = 0, second = 0;

    CHECK(QARegisterDrawNotificationProc(&near_by, about_to_draw, 3, &first) == kQANoErr);
    CHECK(QARegisterDrawNotificationProc(&elsewhere, about_to_draw, 100, &second) == kQANoErr);
    CHECK(first != second);
    CHECK(QARegisterDrawNotificationProc(NULL, about_to_draw, 3, &first) == kQAParamErr);
    CHECK(QARegisterDrawNotificationProc(&near_by, NULL, 3, &first) == kQAParamErr);
    QARenderStart(context, NULL, NULL);
    CHECK(times == 0);
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
    CHECK(times == 3 && last[0] == 0 && last[1] == 0 && last[2] == 64 && last[3] == 48);
    CHECK(QAUnregisterDrawNotificationProc(first) == kQANoErr);
    CHECK(QAUnregisterDrawNotificationProc(first) == kQAParamErr);
    CHECK(QAUnregisterDrawNotificationProc(second) == kQANoErr);
    QARenderStart(context, NULL, NULL);
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
    CHECK(times == 3);
    QADrawContextDelete(context);
}

int main(void)
{
    check_buffers();
    check_rectangles();
    check_caches();
    check_draw_notification();
    check_notices();
    return CHECK_REPORT();
}
