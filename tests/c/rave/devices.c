/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * devices.c: memory of the program in every pixel type, with rows that are longer
 * than the picture and a context that covers a part; devices without memory.
 */
#include "rave_test.h"

#define WIDTH 20
#define HEIGHT 12
#define PAD 12
#define UNTOUCHED 0xa5

/* Where contexts draw on the device. */
static TQARect part = {3, 18, 2, 11};

typedef struct Layout {
    TQAImagePixelType type;
    int bytes;
    TQAUInt32 red, green, blue, white;
    TQAUInt32 mask; /* bits with a meaning */
} Layout;

static const Layout layouts[] = {
    {kQAPixel_RGB16, 2, 0x7c00, 0x03e0, 0x001f, 0x7fff, 0x7fff},
    {kQAPixel_ARGB16, 2, 0xfc00, 0x83e0, 0x801f, 0xffff, 0xffff},
    {kQAPixel_RGB32, 4, 0xff0000, 0x00ff00, 0x0000ff, 0xffffff, 0xffffff},
    {kQAPixel_ARGB32, 4, 0xffff0000u, 0xff00ff00u, 0xff0000ffu, 0xffffffffu, 0xffffffffu},
    {kQAPixel_RGB16_565, 2, 0xf800, 0x07e0, 0x001f, 0xffff, 0xffff},
    {kQAPixel_RGB24, 3, 0xff0000, 0x00ff00, 0x0000ff, 0xffffff, 0xffffff},
    {kQAPixel_RGB8_332, 1, 0xe0, 0x1c, 0x03, 0xff, 0xff},
    {kQAPixel_ARGB16_4444, 2, 0xff00, 0xf0f0, 0xf00f, 0xffff, 0xffff},
    {kQAPixel_I8, 1, 0, 0, 0, 0xff, 0xff}};

#define LAYOUTS ((int)(sizeof layouts / sizeof *layouts))

static unsigned char memory[HEIGHT * (WIDTH * 4 + PAD)];

static TQADevice device_of(TQAImagePixelType type, int bytes)
{
    TQADevice device;

    memset(&device, 0, sizeof device);
    device.deviceType = kQADeviceMemory;
    device.device.memoryDevice.rowBytes = WIDTH * bytes + PAD;
    device.device.memoryDevice.pixelType = type;
    device.device.memoryDevice.width = WIDTH;
    device.device.memoryDevice.height = HEIGHT;
    device.device.memoryDevice.baseAddr = memory;
    return device;
}

/* A pixel as an integer; RGB24 has its blue byte first. */
static TQAUInt32 pixel_at(const void *rows, int rowBytes, int bytes, int x, int y)
{
    const unsigned char *p = (const unsigned char *)rows + y * rowBytes + x * bytes;
    unsigned short half;
    TQAUInt32 word;

    switch (bytes) {
    case 1:
        return *p;
    case 2:
        memcpy(&half, p, 2);
        return half;
    case 3:
        return p[0] | (TQAUInt32)p[1] << 8 | (TQAUInt32)p[2] << 16;
    default:
        memcpy(&word, p, 4);
        return word;
    }
}

/* Quarters of red, green, blue and white. */
static void draw(const TQADrawContext *context)
{
    QARenderStart(context, NULL, NULL);
    gouraud_rect(context, 0, 0, 7, 4, 0.5f, 1, 0, 0, 1);
    gouraud_rect(context, 7, 0, 15, 4, 0.5f, 0, 1, 0, 1);
    gouraud_rect(context, 0, 4, 7, 9, 0.5f, 0, 0, 1, 1);
    gouraud_rect(context, 7, 4, 15, 9, 0.5f, 1, 1, 1, 1);
}

static int is_drawn(const Layout *layout, const void *rows, int rowBytes, int left, int top)
{
    TQAUInt32 mask = layout->mask;
    int bytes = layout->bytes, x, y;

    for (y = 0; y < 9; y++) {
        for (x = 0; x < 15; x++) {
            TQAUInt32 pixel = pixel_at(rows, rowBytes, bytes, left + x, top + y);
            TQAUInt32 expected = y < 4 ? (x < 7 ? layout->red : layout->green)
                                       : (x < 7 ? layout->blue : layout->white);

            if (layout->type == kQAPixel_I8 && expected == 0) {
                continue; /* how bright a colour is, is not this test's */
            }
            if ((pixel & mask) != expected) {
                return 0;
            }
        }
    }
    return 1;
}

/* Whether everything but the part is as it was. */
static int is_untouched(int bytes)
{
    int row = WIDTH * bytes + PAD, x, y;

    for (y = 0; y < HEIGHT; y++) {
        for (x = 0; x < row; x++) {
            int inside = y >= part.top && y < part.bottom && x >= part.left * bytes &&
                         x < part.right * bytes;

            if (!inside && memory[y * row + x] != UNTOUCHED) {
                return 0;
            }
        }
    }
    return 1;
}

static void check_memory(void)
{
    TQAUInt32 allowed = 0;
    TQADevice device = device_of(kQAPixel_RGB32, 4);
    TQAEngine *engine = QADeviceGetFirstEngine(&device);
    TQADrawContext *context;
    int i, type;

    CHECK(QAEngineGestalt(engine, kQAGestalt_DrawContextPixelTypesAllowed, &allowed) == kQANoErr);
    for (i = 0; i < LAYOUTS; i++) {
        const Layout *layout = &layouts[i];

        CHECK(allowed >> layout->type & 1);
        device = device_of(layout->type, layout->bytes);
        memset(memory, UNTOUCHED, sizeof memory);
        CHECK(QAEngineCheckDevice(engine, &device) == kQANoErr);
        CHECK(QADrawContextNew(&device, &part, NULL, engine, kQAContext_DoubleBuffer, &context) ==
              kQANoErr);
        draw(context);
        CHECK(QARenderEnd(context, NULL) == kQANoErr);
        CHECK(is_drawn(layout, memory, WIDTH * layout->bytes + PAD, part.left, part.top));
        CHECK(is_untouched(layout->bytes));
        QADrawContextDelete(context);
        allowed &= ~(1u << layout->type);
    }
    /* There are no others. */
    CHECK(allowed == 0);
    for (type = 0; type < 18; type++) {
        int known = 0;

        for (i = 0; i < LAYOUTS; i++) {
            known |= (int)layouts[i].type == type;
        }
        device = device_of((TQAImagePixelType)type, 4);
        CHECK(known || QADrawContextNew(&device, &part, NULL, engine, 0, &context) ==
                           kQANotSupported);
    }
}

static int completed;

static void complete(const TQADrawContext *context, void *refCon)
{
    CHECK(refCon == &completed && QABusy(context) == 0);
    completed++;
}

static void check_offscreen(void)
{
    TQADevice device;
    TQADrawContext *context = NULL;
    TQAEngine *engine;
    TQAPixelBuffer buffer;
    TQANoticeMethod method;
    int i;

    memset(&device, 0, sizeof device);
    device.deviceType = kQADeviceOffscreen;
    for (i = 0; i < LAYOUTS; i++) {
        const Layout *layout = &layouts[i];

        device.device.offscreenDevice.pixelType = layout->type;
        engine = QADeviceGetFirstEngine(&device);
        CHECK(engine != NULL && QAEngineCheckDevice(engine, &device) == kQANoErr);
        CHECK(QADrawContextNew(&device, &part, NULL, engine, kQAContext_DoubleBuffer, &context) ==
              kQANoErr);
        completed = 0;
        method.standardNoticeMethod = complete;
        CHECK(QASetNoticeMethod(context, kQAMethod_RenderCompletion, method, &completed) ==
              kQANoErr);
        draw(context);
        CHECK(QARenderEnd(context, NULL) == kQANoErr);
        CHECK(QASync(context) == kQANoErr && completed == 1);
        CHECK(QAAccessDrawBuffer(context, &buffer) == kQANoErr);
        CHECK(buffer.pixelType == layout->type && buffer.width == 15 && buffer.height == 9);
        CHECK(is_drawn(layout, buffer.baseAddr, buffer.rowBytes, 0, 0));
        CHECK(QAAccessDrawBufferEnd(context, NULL) == kQANoErr);
        QADrawContextDelete(context);
    }
    device.device.offscreenDevice.pixelType = kQAPixel_CL8;
    CHECK(QADrawContextNew(&device, &part, NULL, engine, 0, &context) == kQANotSupported);
}

/* A frame without memory becomes a texture of one that has some. */
static void check_texture(void)
{
    static Target target;
    TQADrawContext *screen = open_usual(&target, 64, 48), *hidden = NULL;
    TQADevice device;
    TQARect square = {0, 16, 0, 16};
    TQAEngine *engine = engine_for(&target);
    TQATexture *texture = NULL;

    memset(&device, 0, sizeof device);
    device.deviceType = kQADeviceOffscreen;
    device.device.offscreenDevice.pixelType = kQAPixel_RGB16_565;
    CHECK(QADrawContextNew(&device, &square, NULL, engine, kQAContext_DoubleBuffer, &hidden) ==
          kQANoErr);
    CHECK(QATextureNewFromDrawContext(hidden, 0, &texture) == kQANoErr);
    QARenderStart(hidden, NULL, NULL);
    gouraud_rect(hidden, 0, 0, 8, 16, 0.5f, 1, 0, 0, 1);
    gouraud_rect(hidden, 8, 0, 16, 8, 0.5f, 0, 1, 0, 1);
    CHECK(QARenderEnd(hidden, NULL) == kQANoErr);
    QARenderStart(screen, NULL, NULL);
    QASetPtr(screen, kQATag_Texture, texture);
    texture_rect(screen, 8, 8, 40, 40, 0.5f);
    CHECK(QARenderEnd(screen, NULL) == kQANoErr);
    CHECK(at(&target, 10, 10) == 0xff0000 && at(&target, 10, 38) == 0xff0000);
    CHECK(at(&target, 38, 10) == 0x00ff00 && at(&target, 38, 38) == 0);
    CHECK(margin_is_clean(&target));
    QADrawContextDelete(hidden);
    QATextureDelete(engine, texture);
    QADrawContextDelete(screen);
}

int main(void)
{
    check_memory();
    check_offscreen();
    check_texture();
    return CHECK_REPORT();
}
