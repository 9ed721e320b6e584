/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * notices.c: functions of the program that the engine calls. One paints the back
 * buffer before a frame, in place of the clear; one writes the number of the
 * frame over the finished picture; one counts the frames that were shown.
 */
#include "common.h"

typedef struct Count {
    int started, composed, shown;
} Count;

/* A pixel of a back buffer of 32 bits. */
static TQAUInt32 *pixel(const TQADevice *buffer, int x, int y)
{
    const TQADeviceMemory *memory = &buffer->device.memoryDevice;

    return (TQAUInt32 *)(void *)((char *)memory->baseAddr + y * memory->rowBytes) + x;
}

/* Deep water: darker downwards, with slow waves of light. */
static void paint_sea(const TQADrawContext *context, const TQADevice *buffer,
                      const TQARect *dirty, void *refCon)
{
    Count *count = refCon;
    int x, y;

    (void)context;
    if (buffer->deviceType != kQADeviceMemory) {
        return;
    }
    for (y = dirty->top; y < dirty->bottom; y++) {
        for (x = dirty->left; x < dirty->right; x++) {
            float wave = turn_sin((float)x / 90 + (float)y / 160 + (float)count->started / 32) +
                         turn_sin((float)x / 61 - (float)y / 120);
            int light = 150 - y / 2 + (int)(wave * (14 - (float)y / 24));

            *pixel(buffer, x, y) = argb(255, light / 6, light * 2 / 3, light + 40 - y / 8);
        }
    }
    count->started++;
}

/* The frame's number, in the corner. */
static void write_number(const TQADrawContext *context, const TQADevice *buffer,
                         const TQARect *dirty, void *refCon)
{
    Count *count = refCon;
    char text[16];
    int i, x, y;

    (void)context;
    (void)dirty;
    sprintf(text, "FRAME %d", count->composed++);
    for (i = 0; text[i] != 0; i++) {
        const unsigned char *rows = letter(text[i]);

        for (y = 0; y < 14; y++) {
            for (x = 0; x < 10; x++) {
                if (rows[y / 2] >> (4 - x / 2) & 1) {
                    *pixel(buffer, 8 + 12 * i + x, 8 + y) = argb(255, 255, 240, 170);
                }
            }
        }
    }
}

static void count_frame(const TQADrawContext *context, void *refCon)
{
    (void)context;
    ((Count *)refCon)->shown++;
}

/* A fish: an ellipse with a tail, as a fan and a triangle. */
static void draw_fish(const TQADrawContext *context, int number, int frame)
{
    float k = (float)number, size = 12 + 5 * (float)(number % 4);
    float x = (float)((number * 97 + frame * (3 + number % 3)) % 280) + 20;
    float y = 52 + 23 * k + 6 * turn_sin((float)frame / 12 + k / 5);
    float z = 0.9f - size / 40, warm = (float)(number * 5 % 8) / 8;
    TQAVGouraud v[26];
    int i;

    v[0] = gouraud(x, y, z, 1, 0.6f + 0.35f * warm, 0.35f, 1);
    for (i = 0; i <= 24; i++) {
        float turns = (float)i / 24;

        v[i + 1] = gouraud(x + size * turn_sin(turns), y - size * 0.45f * turn_cos(turns), z,
                           0.85f, 0.25f + 0.4f * warm, 0.12f, 1);
    }
    QADrawVGouraud(context, 26, kQAVertexMode_Fan, v, NULL);
    v[0] = gouraud(x - size * 0.8f, y, z, 0.85f, 0.3f + 0.4f * warm, 0.1f, 1);
    v[1] = gouraud(x - size * 1.6f, y - size * 0.5f, z, 0.5f, 0.15f, 0.1f, 1);
    v[2] = gouraud(x - size * 1.6f, y + size * 0.5f, z, 0.5f, 0.15f, 0.1f, 1);
    QADrawTriGouraud(context, &v[0], &v[1], &v[2], kQATriFlags_None);
    v[0] = gouraud(x + size * 0.55f, y - size * 0.12f, z - 0.01f, 0.05f, 0.05f, 0.1f, 1);
    QADrawPoint(context, &v[0]);
}

int main(int argc, char **argv)
{
    static Screen screen;
    static Count count;
    TQANoticeMethod method;
    int frame, i, frames = frames_wanted(argc, argv, 8);

    open_screen(&screen, kQAPixel_RGB32, 0, kQAContext_DoubleBuffer);
    method.bufferNoticeMethod = paint_sea;
    need(QASetNoticeMethod(screen.context, kQAMethod_ImageBufferInitialize, method, &count),
         "QASetNoticeMethod");
    method.bufferNoticeMethod = write_number;
    need(QASetNoticeMethod(screen.context, kQAMethod_ImageBuffer2DComposite, method, &count),
         "QASetNoticeMethod");
    method.standardNoticeMethod = count_frame;
    need(QASetNoticeMethod(screen.context, kQAMethod_RenderCompletion, method, &count),
         "QASetNoticeMethod");
    QASetFloat(screen.context, kQATag_Width, 3);
    for (frame = 0; frame < frames; frame++) {
        QARenderStart(screen.context, NULL, NULL);
        for (i = 0; i < 8; i++) {
            draw_fish(screen.context, i, frame);
        }
        need(QARenderEnd(screen.context, NULL), "QARenderEnd");
    }
    QASync(screen.context);
    printf("%d started, %d composed, %d shown\n", count.started, count.composed, count.shown);
    QADrawContextDelete(screen.context);
    return count.shown == frames ? 0 : 1;
}
