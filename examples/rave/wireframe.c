/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * wireframe.c: a drawing engine of the program's own. It draws the edges of
 * triangles alone, by way of another engine, and says so to the manager; the
 * program then asks the manager for an engine by vendor, as programs did, and
 * draws a torus with it. The engine has no methods for arrays and meshes: the
 * manager splits them.
 */
#include "common.h"

#include <RAVE_system.h>

/* --- the engine --------------------------------------------------------------- */

#define VENDOR 0x5749
#define ENGINE 1

/* What a context of ours keeps: a context of the engine that draws lines. */
struct TQADrawPrivate {
    TQADrawContext *lines;
};

static TQAEngine *lines_engine;

static TQADrawContext *lines_of(const TQADrawContext *context)
{
    return context->drawPrivate->lines;
}

static void set_float(TQADrawContext *context, TQATagFloat tag, float value)
{
    QASetFloat(lines_of(context), tag, value);
}

static void set_int(TQADrawContext *context, TQATagInt tag, TQAUInt32 value)
{
    QASetInt(lines_of(context), tag, value);
}

static float get_float(const TQADrawContext *context, TQATagFloat tag)
{
    return QAGetFloat(lines_of(context), tag);
}

static TQAUInt32 get_int(const TQADrawContext *context, TQATagInt tag)
{
    return QAGetInt(lines_of(context), tag);
}

static void draw_point(const TQADrawContext *context, const TQAVGouraud *v)
{
    QADrawPoint(lines_of(context), v);
}

static void draw_line(const TQADrawContext *context, const TQAVGouraud *a, const TQAVGouraud *b)
{
    QADrawLine(lines_of(context), a, b);
}

static void draw_triangle(const TQADrawContext *context, const TQAVGouraud *a,
                          const TQAVGouraud *b, const TQAVGouraud *c, TQAUInt32 flags)
{
    (void)flags;
    QADrawLine(lines_of(context), a, b);
    QADrawLine(lines_of(context), b, c);
    QADrawLine(lines_of(context), c, a);
}

static void render_start(const TQADrawContext *context, const TQARect *dirty,
                         const TQADrawContext *initial)
{
    QARenderStart(lines_of(context), dirty, initial ? lines_of(initial) : NULL);
}

static TQAError render_end(const TQADrawContext *context, const TQARect *modified)
{
    return QARenderEnd(lines_of(context), modified);
}

static TQAError sync(const TQADrawContext *context)
{
    return QASync(lines_of(context));
}

static TQAError new_private(TQADrawContext *context, const TQADevice *device, const TQARect *rect,
                            const TQAClip *clip, TQAUInt32 flags)
{
    TQADrawPrivate *made = malloc(sizeof *made);
    TQADrawMethod method;
    TQAError error;

    if (made == NULL) {
        return kQAOutOfMemory;
    }
    error = QADrawContextNew(device, rect, clip, lines_engine, flags, &made->lines);
    if (error != kQANoErr) {
        free(made);
        return error;
    }
    context->drawPrivate = made;
    context->version = kQAVersion_1_6;
#define REGISTER(tag, member, function) \
    method.member = function;           \
    QARegisterDrawMethod(context, tag, method)
    REGISTER(kQASetFloat, setFloat, set_float);
    REGISTER(kQASetInt, setInt, set_int);
    REGISTER(kQAGetFloat, getFloat, get_float);
    REGISTER(kQAGetInt, getInt, get_int);
    REGISTER(kQADrawPoint, drawPoint, draw_point);
    REGISTER(kQADrawLine, drawLine, draw_line);
    REGISTER(kQADrawTriGouraud, drawTriGouraud, draw_triangle);
    REGISTER(kQARenderStart, renderStart, render_start);
    REGISTER(kQARenderEnd, renderEnd, render_end);
    REGISTER(kQASync, sync, sync);
    return kQANoErr;
}

static void delete_private(TQADrawPrivate *made)
{
    QADrawContextDelete(made->lines);
    free(made);
}

static TQAError check_device(const TQADevice *device)
{
    return QAEngineCheckDevice(lines_engine, device);
}

static TQAError gestalt(TQAGestaltSelector selector, void *response)
{
    static const char name[] = "Wireframe";
    TQAUInt32 answer;

    switch (selector) {
    case kQAGestalt_OptionalFeatures: answer = kQAOptional_None; break;
    case kQAGestalt_FastFeatures: answer = kQAFast_Line; break;
    case kQAGestalt_VendorID: answer = VENDOR; break;
    case kQAGestalt_EngineID: answer = ENGINE; break;
    case kQAGestalt_Revision: answer = 1; break;
    case kQAGestalt_ASCIINameLength: answer = sizeof name - 1; break;
    case kQAGestalt_ASCIIName: memcpy(response, name, sizeof name); return kQANoErr;
    default: return kQAGestaltUnknown;
    }
    *(TQAUInt32 *)response = answer;
    return kQANoErr;
}

static TQAError get_method(TQAEngineMethodTag tag, TQAEngineMethod *method)
{
    switch (tag) {
    case kQADrawPrivateNew: method->drawPrivateNew = new_private; return kQANoErr;
    case kQADrawPrivateDelete: method->drawPrivateDelete = delete_private; return kQANoErr;
    case kQAEngineCheckDevice: method->engineCheckDevice = check_device; return kQANoErr;
    case kQAEngineGestalt: method->engineGestalt = gestalt; return kQANoErr;
    default: return kQANotSupported;
    }
}

/* --- the program ---------------------------------------------------------------- */

#define AROUND 36
#define ACROSS 16

/* The engine of a vendor; the program ends where there is none. */
static TQAEngine *find_engine(const TQADevice *device, TQAUInt32 vendor)
{
    TQAEngine *engine = QADeviceGetFirstEngine(device);
    TQAUInt32 answer = 0;
    char name[64];

    while (engine != NULL) {
        if (QAEngineGestalt(engine, kQAGestalt_VendorID, &answer) == kQANoErr &&
            answer == vendor) {
            need(QAEngineGestalt(engine, kQAGestalt_ASCIIName, name), "QAEngineGestalt");
            printf("drawing with %s\n", name);
            return engine;
        }
        engine = QADeviceGetNextEngine(device, engine);
    }
    fprintf(stderr, "the engine is not there\n");
    exit(1);
}

static void draw_torus(const TQADrawContext *context, int frame)
{
    static TQAVGouraud vertices[AROUND * ACROSS];
    static TQAIndexedTriangle triangles[2 * AROUND * ACROSS];
    int i, j, n = 0;

    for (i = 0; i < AROUND; i++) {
        for (j = 0; j < ACROSS; j++) {
            float a = (float)i / AROUND, b = (float)j / ACROSS, r = 2 + 0.85f * turn_cos(b);
            Vec3 p = turned(vec3(r * turn_cos(a), 0.85f * turn_sin(b), r * turn_sin(a)),
                            (float)frame / 128, 0.88f);
            float inv = 1 / (p.z + 5.6f), light = 1.35f * inv * 4 - 0.45f;

            vertices[i * ACROSS + j] =
                gouraud(160 + 215 * p.x * inv, 110 - 215 * p.y * inv, 1 - inv * 2,
                        light * (0.45f + 0.5f * turn_sin(a) * turn_sin(a)), light * 0.75f,
                        light * (0.95f - 0.5f * turn_sin(a) * turn_sin(a)), 1);
        }
    }
    for (i = 0; i < AROUND; i++) {
        for (j = 0; j < ACROSS; j++) {
            TQAUInt32 a = (TQAUInt32)(i * ACROSS + j);
            TQAUInt32 b = (TQAUInt32)((i + 1) % AROUND * ACROSS + j);
            TQAUInt32 c = (TQAUInt32)((i + 1) % AROUND * ACROSS + (j + 1) % ACROSS);

            triangles[n].triangleFlags = kQATriFlags_None;
            triangles[n].vertices[0] = a;
            triangles[n].vertices[1] = b;
            triangles[n].vertices[2] = c;
            n++;
        }
    }
    QASubmitVerticesGouraud(context, AROUND * ACROSS, vertices);
    QADrawTriMeshGouraud(context, (TQAUInt32)n, triangles);
}

int main(int argc, char **argv)
{
    static Screen screen;
    TQADrawContext *context;
    int frame, frames = frames_wanted(argc, argv, 8);

    /* The engine draws by way of the one that is there. */
    open_screen(&screen, kQAPixel_RGB32, 0, kQAContext_DoubleBuffer);
    QADrawContextDelete(screen.context);
    lines_engine = screen.engine;
    need(QARegisterEngine(get_method), "QARegisterEngine");
    need(QADrawContextNew(&screen.device, &screen.rect, NULL, find_engine(&screen.device, VENDOR),
                          kQAContext_DoubleBuffer, &context),
         "QADrawContextNew");
    set_background(context, 0.03f, 0.04f, 0.07f);
    for (frame = 0; frame < frames; frame++) {
        QARenderStart(context, NULL, NULL);
        draw_torus(context, frame);
        need(QARenderEnd(context, NULL), "QARenderEnd");
    }
    QADrawContextDelete(context);
    return 0;
}
