/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * 3dfx.h: scalar types, Booleans and calling conventions shared by every
 * header of the Glide 2.x API.
 *
 * Written from the published description of the interface; plain C89.
 */
#ifndef FILLRATE_3DFX_H
#define FILLRATE_3DFX_H

/* The original header's guard: programs test it to see whether this header
 * has been read. */
#ifndef __3DFX_H__
#define __3DFX_H__
#endif

#include "fxdll.h"

/* Fixed-width integers. DOS and Windows compilers of the time used `long`
 * for the 32-bit types; everywhere else `int` is the one that stays at
 * 32 bits when pointers grow to 64. */
typedef unsigned char  FxU8;
typedef signed char    FxI8;
typedef unsigned short FxU16;
typedef signed short   FxI16;
#if defined(_WIN32) || defined(__DOS__) || defined(__MSDOS__) || defined(__DJGPP__)
typedef unsigned long  FxU32;
typedef signed long    FxI32;
#else
typedef unsigned int   FxU32;
typedef signed int     FxI32;
#endif

typedef int    FxBool;   /* FXFALSE or FXTRUE; any other non-zero counts as true */
typedef float  FxFloat;
typedef double FxDouble;

#define FXTRUE  1
#define FXFALSE 0

/* Packed 32-bit colour, and one colour as four floats. */
typedef FxU32 FxColor_t;
typedef struct {
    float r, g, b, a;
} FxColor4;

/* A word with only bit i set, i in 0..31. */
#define FXBIT(i) ((FxU32)1 << (i))

/* Stops the compilation where a type does not have the width the ABI needs. */
typedef char fillrate_assert_fxu16_is_2_bytes[sizeof(FxU16) == 2 ? 1 : -1];
typedef char fillrate_assert_fxu32_is_4_bytes[sizeof(FxU32) == 4 ? 1 : -1];
typedef char fillrate_assert_fxbool_is_4_bytes[sizeof(FxBool) == 4 ? 1 : -1];
typedef char fillrate_assert_float_is_4_bytes[sizeof(float) == 4 ? 1 : -1];

#endif /* FILLRATE_3DFX_H */
