/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * engines.c: engines of the program: registration, order, revisions, methods that
 * are missing, and everything that is handed to them.
 */
#include "rave_test.h"

#include <RAVE_system.h>

/* The drawing functions themselves, not the macros. */
#undef QADrawPoint
#undef QARenderEnd

struct TQADrawPrivate {
    int serial;
};

/* What the engine was asked for. */
static struct {
    int contexts, points, lines, triangles, textured, started, ended, flags;
    int textures, bitmaps, tables, bound, accesses;
    float x[16];
    int xs;
    long refCon;
    TQAUInt32 last_int;
} seen;

static TQADrawPrivate privates[4];

static void set_int(TQADrawContext *context, TQATagInt tag, TQAUInt32 value)
{
    CHECK(context->drawPrivate->serial > 0);
    seen.last_int = (TQAUInt32)tag * 1000 + value;
}

static TQAUInt32 get_int(const TQADrawContext *context, TQATagInt tag)
{
    (void)context;
    return (TQAUInt32)tag + 5;
}

static void draw_point(const TQADrawContext *context, const TQAVGouraud *v)
{
    (void)context;
    seen.points++;
    seen.x[seen.xs++ % 16] = v->x;
}

static void draw_line(const TQADrawContext *context, const TQAVGouraud *a, const TQAVGouraud *b)
{
    (void)context;
    seen.lines++;
    seen.x[seen.xs++ % 16] = a->x + 100 * b->x;
}

static void draw_triangle(const TQADrawContext *context, const TQAVGouraud *a,
                          const TQAVGouraud *b, const TQAVGouraud *c, TQAUInt32 flags)
{
    (void)context;
    seen.triangles++;
    seen.flags = seen.flags * 2 + (int)flags;
    seen.x[seen.xs++ % 16] = a->x + 100 * b->x + 10000 * c->x;
}

static void draw_textured(const TQADrawContext *context, const TQAVTexture *a,
                          const TQAVTexture *b, const TQAVTexture *c, TQAUInt32 flags)
{
    (void)context;
    (void)flags;
    seen.textured++;
    seen.x[seen.xs++ % 16] = a->x + 100 * b->x + 10000 * c->x;
}

static void render_start(const TQADrawContext *context, const TQARect *dirty,
                         const TQADrawContext *initial)
{
    (void)context;
    seen.started += dirty == NULL && initial == NULL;
}

static TQAError render_end(const TQADrawContext *context, const TQARect *modified)
{
    (void)context;
    (void)modified;
    seen.ended++;
    return kQAError;
}

static TQAError new_private(TQADrawContext *context, const TQADevice *device, const TQARect *rect,
                            const TQAClip *clip, TQAUInt32 flags)
{
    TQADrawMethod method;

    (void)clip;
    CHECK(device->deviceType == kQADeviceMemory && rect->right == 64);
    seen.refCon = QAGetCurrentEngineRefCon();
    if (flags & kQAContext_Cache) {
        return kQANotSupported;
    }
    context->drawPrivate = &privates[seen.contexts];
    context->drawPrivate->serial = ++seen.contexts;
    context->version = kQAVersion_1_5;
#define REGISTER(tag, member, function) \
    method.member = function;           \
    CHECK(QARegisterDrawMethod(context, tag, method) == kQANoErr)
    REGISTER(kQASetInt, setInt, set_int);
    REGISTER(kQAGetInt, getInt, get_int);
    REGISTER(kQADrawPoint, drawPoint, draw_point);
    REGISTER(kQADrawLine, drawLine, draw_line);
    REGISTER(kQADrawTriGouraud, drawTriGouraud, draw_triangle);
    REGISTER(kQADrawTriTexture, drawTriTexture, draw_textured);
    REGISTER(kQARenderStart, renderStart, render_start);
    REGISTER(kQARenderEnd, renderEnd, render_end);
    CHECK(QARegisterDrawMethod(context, kQANumDrawMethods, method) == kQAParamErr);
    return kQANoErr;
}

static void delete_private(TQADrawPrivate *made)
{
    CHECK(made->serial > 0);
    made->serial = 0;
}

static TQAError check_device(const TQADevice *device)
{
    return device->deviceType == kQADeviceMemory && device->device.memoryDevice.width == 64
               ? kQANoErr
               : kQANotSupported;
}

static TQAUInt32 revision = 3, fast = 0xffff;

static TQAError gestalt(TQAGestaltSelector selector, void *response)
{
    static const char name[] = "Engine of the test";
    TQAUInt32 answer;

    switch (selector) {
    case kQAGestalt_OptionalFeatures: answer = kQAOptional_Texture; break;
    case kQAGestalt_FastFeatures: answer = fast; break;
    case kQAGestalt_VendorID: answer = 0x7777; break;
    case kQAGestalt_EngineID: answer = 9; break;
    case kQAGestalt_Revision: answer = revision; break;
    case kQAGestalt_ASCIINameLength: answer = sizeof name - 1; break;
    case kQAGestalt_ASCIIName: memcpy(response, name, sizeof name); return kQANoErr;
    default: return kQAGestaltUnknown;
    }
    *(TQAUInt32 *)response = answer;
    return kQANoErr;
}

static TQAError texture_new(TQAUInt32 flags, TQAImagePixelType type, const TQAImage images[],
                            TQATexture **made)
{
    CHECK(flags == kQATexture_Lock && type == kQAPixel_ARGB32 && images[0].width == 3);
    seen.textures++;
    *made = (TQATexture *)&seen;
    return kQANoErr;
}

static TQAError texture_detach(TQATexture *texture)
{
    return texture == (TQATexture *)&seen ? kQAOutOfMemory : kQAParamErr;
}

static void texture_delete(TQATexture *texture)
{
    seen.textures -= texture == (TQATexture *)&seen;
}

static TQAError bitmap_new(TQAUInt32 flags, TQAImagePixelType type, const TQAImage *image,
                           TQABitmap **made)
{
    (void)flags;
    (void)type;
    seen.bitmaps += image->height;
    *made = (TQABitmap *)&seen;
    return kQANoErr;
}

static void bitmap_delete(TQABitmap *bitmap)
{
    seen.bitmaps = bitmap == (TQABitmap *)&seen ? 0 : -1;
}

static TQAError table_new(TQAColorTableType type, void *data, TQAInt32 transparent,
                          TQAColorTable **made)
{
    (void)data;
    seen.tables = (int)type * 10 + transparent;
    *made = (TQAColorTable *)&seen;
    return kQANoErr;
}

static TQAError bind(TQATexture *texture, TQAColorTable *table)
{
    seen.bound = (void *)texture == (void *)table;
    return kQANoErr;
}

static TQAError access_texture(TQATexture *texture, TQAInt32 level, TQAInt32 flags,
                               TQAPixelBuffer *buffer)
{
    (void)texture;
    (void)flags;
    seen.accesses += level;
    buffer->width = 77;
    return kQANoErr;
}

static TQAError get_method(TQAEngineMethodTag tag, TQAEngineMethod *method)
{
    switch (tag) {
    case kQADrawPrivateNew: method->drawPrivateNew = new_private; return kQANoErr;
    case kQADrawPrivateDelete: method->drawPrivateDelete = delete_private; return kQANoErr;
    case kQAEngineCheckDevice: method->engineCheckDevice = check_device; return kQANoErr;
    case kQAEngineGestalt: method->engineGestalt = gestalt; return kQANoErr;
    case kQATextureNew: method->textureNew = texture_new; return kQANoErr;
    case kQATextureDetach: method->textureDetach = texture_detach; return kQANoErr;
    case kQATextureDelete: method->textureDelete = texture_delete; return kQANoErr;
    case kQABitmapNew: method->bitmapNew = bitmap_new; return kQANoErr;
    case kQABitmapDelete: method->bitmapDelete = bitmap_delete; return kQANoErr;
    case kQAColorTableNew: method->colorTableNew = table_new; return kQANoErr;
    case kQATextureBindColorTable: method->textureBindColorTable = bind; return kQANoErr;
    case kQAAccessTexture: method->accessTexture = access_texture; return kQANoErr;
    default: return kQANotSupported;
    }
}

static TQAError nothing(TQAEngineMethodTag tag, TQAEngineMethod *method)
{
    (void)tag;
    (void)method;
    return kQANotSupported;
}

static int is_listed(const TQADevice *device, const TQAEngine *wanted)
{
    TQAEngine *engine = QADeviceGetFirstEngine(device);

    while (engine != NULL && engine != wanted) {
        engine = QADeviceGetNextEngine(device, engine);
    }
    return engine != NULL;
}

static void check_built_in(TQAEngine *engine)
{
    TQAUInt32 answer = 0, length = 0, apple = 1;
    char name[64];
    TQADevice screen;

    CHECK(QAEngineGestalt(engine, kQAGestalt_ASCIINameLength, &length) == kQANoErr);
    CHECK(QAEngineGestalt(engine, kQAGestalt_ASCIIName, name) == kQANoErr);
    CHECK(strlen(name) == length && length > 0 && length < sizeof name);
    CHECK(QAEngineGestalt(engine, kQAGestalt_VendorID, &apple) == kQANoErr);
    CHECK(apple != kQAVendor_Apple);
    answer = 4711;
    CHECK(QAEngineGestalt(engine, kQAGestalt_NumSelectors, &answer) == kQANoErr ||
          answer == 4711);
    answer = 4711;
    CHECK(QAEngineGestalt(engine, (TQAGestaltSelector)500, &answer) == kQAGestaltUnknown);
    CHECK(answer == 4711);
    CHECK(QAEngineGestalt(engine, kQAGestalt_OptionalFeatures2, &answer) == kQANoErr);
    CHECK(answer & kQAOptional2_SwapBuffers);
    CHECK(QAEngineGestalt(engine, kQAGestalt_DrawContextPixelTypesAllowed, &answer) == kQANoErr);
    CHECK(answer >> kQAPixel_RGB16 & 1 && answer >> kQAPixel_RGB32 & 1);
    memset(&screen, 0, sizeof screen);
    screen.deviceType = kQADeviceGDevice;
    CHECK(QAEngineCheckDevice(engine, &screen) != kQANoErr);
    CHECK(QADeviceGetFirstEngine(&screen) == NULL);
    CHECK(QAInit() == kQANoErr && QAExit() == kQANoErr);
}

static void check_drawing(const Target *target, TQAEngine *mine)
{
    static const TQAIndexedTriangle triangles[3] = {{1, {0, 1, 2}}, {0, {3, 4, 9}}, {1, {2, 1, 0}}};
    static const TQAUInt32 flags[3] = {1, 0, 1};
    TQADrawContext *context = NULL;
    TQANoticeMethod notice;
    TQAVGouraud v[6];
    TQAVTexture t[4];
    int i;

    CHECK(QADrawContextNew(&target->device, &target->rect, NULL, mine, kQAContext_Cache,
                           &context) == kQANotSupported);
    CHECK(context == NULL);
    CHECK(QADrawContextNew(&target->device, &target->rect, NULL, mine, 0, &context) == kQANoErr);
    CHECK(seen.contexts == 1 && seen.refCon == 4242 && QAGetCurrentEngineRefCon() == 0);
    CHECK(context->version == kQAVersion_1_5);
    for (i = 0; i < 6; i++) {
        v[i] = gv((float)i, 0, 0, 0, 0, 0, 0);
    }
    for (i = 0; i < 4; i++) {
        t[i] = tv((float)i, 0, 0, 0, 0);
    }
    QASetInt(context, kQATag_Blend, 7);
    CHECK(seen.last_int == 9007 && QAGetInt(context, kQATag_Blend) == 14);
    QARenderStart(context, NULL, NULL);
    CHECK(seen.started == 1);
    /* Arrays are split. */
    QADrawVGouraud(context, 3, kQAVertexMode_Point, v, NULL);
    CHECK(seen.points == 3 && seen.x[2] == 2);
    QADrawPoint(context, &v[5]);
    CHECK(seen.points == 4 && seen.x[3] == 5);
    seen.xs = 0;
    QADrawVGouraud(context, 5, kQAVertexMode_Line, v, NULL);
    CHECK(seen.lines == 2 && seen.x[0] == 100 && seen.x[1] == 302);
    QADrawVGouraud(context, 3, kQAVertexMode_Polyline, v, NULL);
    CHECK(seen.lines == 4 && seen.x[2] == 100 && seen.x[3] == 201);
    seen.xs = 0;
    QADrawVGouraud(context, 6, kQAVertexMode_Tri, v, NULL);
    CHECK(seen.triangles == 2 && seen.x[0] == 20100 && seen.x[1] == 50403 && seen.flags == 0);
    QADrawVGouraud(context, 5, kQAVertexMode_Strip, v, flags);
    CHECK(seen.triangles == 5 && seen.x[3] == 30201 && seen.flags == 5);
    QADrawVGouraud(context, 4, kQAVertexMode_Fan, v, NULL);
    CHECK(seen.triangles == 7 && seen.x[6] == 30200);
    seen.xs = 0;
    QADrawVTexture(context, 4, kQAVertexMode_Strip, t, NULL);
    CHECK(seen.textured == 2 && seen.x[1] == 30201);
    QADrawVTexture(context, 4, kQAVertexMode_Line, t, NULL);
    CHECK(seen.textured == 2 && seen.lines == 4);
    /* So are meshes; an index beyond is dropped. */
    seen.xs = seen.flags = 0;
    QASubmitVerticesGouraud(context, 6, v);
    QADrawTriMeshGouraud(context, 3, triangles);
    CHECK(seen.triangles == 9 && seen.x[0] == 20100 && seen.x[1] == 102 && seen.flags == 3);
    QASubmitVerticesTexture(context, 4, t);
    QADrawTriMeshTexture(context, 1, triangles);
    CHECK(seen.textured == 3);
    CHECK(QARenderEnd(context, NULL) == kQAError && seen.ended == 1);
    /* What it lacks is refused. */
    CHECK(QASync(context) == kQANotSupported && QAGetPtr(context, kQATag_Texture) == NULL);
    CHECK(QAGetFloat(context, kQATag_Width) == 0 && QABusy(context) == 0);
    notice.standardNoticeMethod = NULL;
    CHECK(QASetNoticeMethod(context, kQAMethod_RenderCompletion, notice, NULL) ==
          kQANotSupported);
    QADrawContextDelete(context);
    CHECK(privates[0].serial == 0);
}

static void check_objects(TQAEngine *mine)
{
    static TQAUInt32 pixels[9];
    TQAImage image = image_of(3, 3, 12, pixels);
    TQATexture *texture = NULL;
    TQABitmap *bitmap = NULL;
    TQAColorTable *table = NULL;
    TQAPixelBuffer buffer;

    CHECK(QATextureNew(mine, kQATexture_Lock, kQAPixel_ARGB32, &image, &texture) == kQANoErr);
    CHECK(texture == (TQATexture *)&seen && seen.textures == 1);
    CHECK(QATextureDetach(mine, texture) == kQAOutOfMemory);
    CHECK(QABitmapNew(mine, 0, kQAPixel_ARGB32, &image, &bitmap) == kQANoErr);
    CHECK(seen.bitmaps == 3);
    CHECK(QABitmapDetach(mine, bitmap) == kQANotSupported);
    CHECK(QAColorTableNew(mine, kQAColorTable_CL4_RGB32, pixels, 1, &table) == kQANoErr);
    CHECK(seen.tables == 11);
    CHECK(QATextureBindColorTable(mine, texture, table) == kQANoErr && seen.bound);
    CHECK(QABitmapBindColorTable(mine, bitmap, table) == kQANotSupported);
    CHECK(QAAccessTexture(mine, texture, 5, 0, &buffer) == kQANoErr);
    CHECK(seen.accesses == 5 && buffer.width == 77);
    CHECK(QAAccessTextureEnd(mine, texture, NULL) == kQANotSupported);
    CHECK(QAAccessBitmap(mine, bitmap, 0, &buffer) == kQANotSupported);
    CHECK(QAAccessBitmapEnd(mine, bitmap, NULL) == kQANotSupported);
    QATextureDelete(mine, texture);
    QABitmapDelete(mine, bitmap);
    QAColorTableDelete(mine, table);
    CHECK(seen.textures == 0 && seen.bitmaps == 0);
}

int main(void)
{
    static Target target, other;
    TQAEngine *built_in, *mine, *newer;
    TQADrawContext *context;

    init_target(&target, kQAPixel_RGB32, 64, 48, 0);
    init_target(&other, kQAPixel_RGB32, 32, 32, 0);
    built_in = QADeviceGetFirstEngine(NULL);
    CHECK(built_in != NULL && QADeviceGetNextEngine(NULL, built_in) == NULL);
    check_built_in(built_in);

    CHECK(QARegisterEngine(NULL) == kQAParamErr);
    CHECK(QARegisterEngine(nothing) == kQAParamErr);
    CHECK(QARegisterEngineWithRefCon(get_method, 4242) == kQANoErr);
    CHECK(QARegisterEngine(get_method) == kQAOutOfDate);
    /* It says that it is fast at more: it comes first, on devices that it takes. */
    mine = QADeviceGetFirstEngine(&target.device);
    CHECK(mine != NULL && mine != built_in);
    CHECK(QADeviceGetNextEngine(&target.device, mine) == built_in);
    CHECK(QADeviceGetFirstEngine(&other.device) == built_in);
    CHECK(QAEngineCheckDevice(mine, &other.device) == kQANotSupported);
    check_drawing(&target, mine);
    check_objects(mine);

    /* Disabled, it is no longer listed. */
    CHECK(QAEngineDisable(0x7777, 9) == kQANoErr);
    CHECK(!is_listed(NULL, mine) && is_listed(NULL, built_in));
    CHECK(QAEngineEnable(0x7777, 9) == kQANoErr);
    CHECK(is_listed(NULL, mine));
    CHECK(QAEngineDisable(0x7778, 9) != kQANoErr);

    /* A newer one takes its place. */
    revision = 4;
    fast = kQAFast_Line;
    CHECK(QARegisterEngine(get_method) == kQANoErr);
    CHECK(!is_listed(NULL, mine));
    newer = QADeviceGetNextEngine(NULL, built_in);
    CHECK(QADeviceGetFirstEngine(NULL) == built_in && newer != NULL && newer != mine);

    /* The picture that is kept is the built-in engine's. */
    CHECK(QADrawContextNew(&target.device, &target.rect, NULL, built_in, 0, &context) == kQANoErr);
    QARenderStart(context, NULL, NULL);
    gouraud_rect(context, 8, 8, 56, 40, 0.5f, 0.2f, 0.6f, 1, 1);
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
    CHECK(is_near(at(&target, 20, 20), 51, 153, 255, 1));
    QADrawContextDelete(context);
    return CHECK_REPORT();
}
