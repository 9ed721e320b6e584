/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * late.c: frames that are drawn behind the program's back. RenderEnd does not wait;
 * the program's memory holds a frame after QASync, when its completion is told, or
 * when the next one ends.
 */
#define _POSIX_C_SOURCE 200112L

#include "rave_test.h"

#define FRAMES 20

static Target target;
static int told;

static TQAUInt32 color_of(int frame)
{
    return (TQAUInt32)(frame * 12 + 5) << 16 | (TQAUInt32)(250 - frame * 12) << 8 | 0x40;
}

static void complete(const TQADrawContext *context, void *refCon)
{
    (void)context;
    CHECK(refCon == &told);
    /* The frame is there when its completion is told. */
    CHECK(at(&target, 5, 5) == color_of(told));
    told++;
}

static void draw(TQADrawContext *context, int frame)
{
    TQAUInt32 color = color_of(frame);
    int i;

    background(context, (float)red(color) / 255, (float)green(color) / 255,
               (float)blue(color) / 255);
    QARenderStart(context, NULL, NULL);
    for (i = 0; i < 200; i++) {
        gouraud_rect(context, 10, 10, (float)(20 + i % 40), 40, 0.9f - (float)i / 400, 1, 0,
                     (float)i / 200, 0.5f);
    }
}

int main(void)
{
    TQADrawContext *context;
    TQANoticeMethod method;
    int frame;

    CHECK(setenv("FILLRATE_RAVE_ASYNCHRONOUS", "2", 1) == 0);
    context = open_usual(&target, 64, 48);
    method.standardNoticeMethod = complete;
    CHECK(QASetNoticeMethod(context, kQAMethod_RenderCompletion, method, &told) == kQANoErr);
    for (frame = 0; frame < FRAMES; frame++) {
        draw(context, frame);
        CHECK(QARenderEnd(context, NULL) == kQANoErr);
        /* This one or the one before. */
        CHECK(told >= frame);
        CHECK(frame == 0 || at(&target, 5, 5) == color_of(told - 1));
    }
    CHECK(QASync(context) == kQANoErr);
    CHECK(told == FRAMES && QABusy(context) == 0);
    CHECK(at(&target, 5, 5) == color_of(FRAMES - 1));
    /* Given up: the frame before is shown all the same. */
    draw(context, FRAMES);
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
    draw(context, 0);
    CHECK(QARenderAbort(context) == kQANoErr);
    CHECK(at(&target, 5, 5) == color_of(FRAMES));
    /* What was not waited for is there when the context is gone. */
    method.standardNoticeMethod = NULL;
    CHECK(QASetNoticeMethod(context, kQAMethod_RenderCompletion, method, NULL) == kQANoErr);
    draw(context, 7);
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
    QADrawContextDelete(context);
    CHECK(at(&target, 5, 5) == color_of(7));
    CHECK(margin_is_clean(&target));
    return CHECK_REPORT();
}
