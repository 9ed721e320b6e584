/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * abuse.h: harness for programs that misuse the library. Each check is one
 * function; it returns whether the library answered as it should. Whatever a
 * check did, the library must draw correctly afterwards. A crash names the
 * check it happened in.
 *
 * FILLRATE_CHECK=1 turns the library's checking mode on, in which misuse is
 * reported to the error callback; without it, only what the original release
 * library reported is.
 */
#ifndef FILLRATE_ABUSE_H
#define FILLRATE_ABUSE_H

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <glide.h>

typedef struct {
    const char *name;
    int (*run)(void);
} AbuseCheck;

#define COUNT_OF(array) (sizeof(array) / sizeof((array)[0]))

static const char *abuse_current = "start-up";
static int abuse_checking;         /* is the checking mode on? */
static int abuse_messages;         /* since the check began */
static char abuse_last[256];       /* the latest message */

static void abuse_on_error(const char *message, FxBool fatal)
{
    (void)fatal;
    abuse_messages++;
    strncpy(abuse_last, message == NULL ? "(null)" : message, sizeof abuse_last - 1);
}

static void abuse_on_crash(int number)
{
    fprintf(stderr, "signal %d in check %s\n", number, abuse_current);
    _Exit(1);
}

/* Whether a message of the form "function: text" came. */
static inline int told_by(const char *function)
{
    size_t length = strlen(function);
    return abuse_messages > 0 && strncmp(abuse_last, function, length) == 0
        && strncmp(abuse_last + length, ": ", 2) == 0 && abuse_last[length + 2] != '\0';
}

/* What checking mode must tell and release mode must keep to itself. */
static inline int told_when_checking(const char *function)
{
    int right = abuse_checking ? told_by(function) : abuse_messages == 0;

    if (!right) {
        printf("  %s: %d message(s), last \"%s\"\n", function, abuse_messages, abuse_last);
    }
    abuse_messages = 0;
    abuse_last[0] = '\0';
    return right;
}

static inline FxBool abuse_open(void)
{
    return grSstWinOpen(0, GR_RESOLUTION_640x480, GR_REFRESH_60Hz,
                        GR_COLORFORMAT_ARGB, GR_ORIGIN_UPPER_LEFT, 2, 1);
}

static inline GrVertex abuse_vertex(float x, float y)
{
    GrVertex v;

    memset(&v, 0, sizeof v);
    v.x = x;
    v.y = y;
    v.r = v.g = v.b = v.a = 255.0f;
    v.oow = 1.0f;
    v.ooz = 65535.0f;
    return v;
}

/* A pixel of the back buffer, or -1. */
static inline long abuse_pixel(FxU32 x, FxU32 y)
{
    FxU16 pixel = 0;
    return grLfbReadRegion(GR_BUFFER_BACKBUFFER, x, y, 1, 1, 2, &pixel) ? (long)pixel : -1L;
}

/* Whether a white triangle on black comes out right. */
static inline int draws_correctly(void)
{
    GrVertex a = abuse_vertex(100, 100), b = abuse_vertex(300, 100), c = abuse_vertex(100, 300);

    grClipWindow(0, 0, 640, 480);
    grColorMask(FXTRUE, FXFALSE);
    grBufferClear(0xff000000, 0, 0);
    grDrawTriangle(&a, &b, &c);
    return abuse_pixel(150, 150) == 0xffff && abuse_pixel(90, 150) == 0
        && abuse_pixel(290, 290) == 0 && abuse_pixel(639, 479) == 0;
}

/* Back to a freshly opened board, whatever happened before. */
static inline int recover(void)
{
    grGlideInit();
    grSstSelect(0);
    grLfbUnlock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER);
    grLfbUnlock(GR_LFB_READ_ONLY, GR_BUFFER_BACKBUFFER);
    grSstWinClose();
    return abuse_open() && draws_correctly();
}

/* Runs the checks, printing the name of each that fails. */
static int run_abuse(const AbuseCheck *checks, size_t count)
{
    const char *mode = getenv("FILLRATE_CHECK");
    size_t i;
    int passed = 0, failed = 0;

    abuse_checking = mode != NULL && atoi(mode) != 0;
    signal(SIGSEGV, abuse_on_crash);
    signal(SIGABRT, abuse_on_crash);
    signal(SIGFPE, abuse_on_crash);
    signal(SIGILL, abuse_on_crash);
    grErrorSetCallback(abuse_on_error);
    for (i = 0; i < count; i++) {
        int good, sound;

        abuse_current = checks[i].name;
        abuse_messages = 0;
        memset(abuse_last, 0, sizeof abuse_last);
        good = checks[i].run();
        grErrorSetCallback(abuse_on_error);
        sound = recover();
        if (good && sound) {
            passed++;
            continue;
        }
        failed++;
        printf("failed: %s%s%s\n", checks[i].name, good ? "" : ": wrong answer",
               sound ? "" : ": drawing is broken afterwards");
    }
    grGlideShutdown();
    printf("%d passed, %d failed\n", passed, failed);
    return failed == 0 ? 0 : 1;
}

#endif
