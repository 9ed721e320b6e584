/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * check.h: counts what passed and what failed in a C test program.
 *
 * With CHECK_STATIC defined every check becomes a compile-time assertion and
 * nothing of the C library is needed, so that layouts can be checked for
 * targets whose programs cannot be run here.
 */
#ifndef FILLRATE_CHECK_H
#define FILLRATE_CHECK_H

#ifdef CHECK_STATIC

#define CHECK(condition) (void)sizeof(char[(condition) ? 1 : -1])
#define CHECK_REPORT() 0

#else

#include <stdio.h>

static int checks_passed;
static int checks_failed;

static void check_that(int holds, const char *what, const char *file, int line)
{
    if (holds) {
        checks_passed++;
        return;
    }
    checks_failed++;
    printf("%s:%d: failed: %s\n", file, line, what);
}

static int check_report(void)
{
    printf("%d passed, %d failed\n", checks_passed, checks_failed);
    return checks_failed == 0 ? 0 : 1;
}

#define CHECK(condition) check_that((condition) ? 1 : 0, #condition, __FILE__, __LINE__)
#define CHECK_REPORT() check_report()

#endif

#endif
