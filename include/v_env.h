/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * v_env.h: scalars of RRedline and what stands in for Windows, so that
 * programs of the time compile where there is none. On Windows the system's own
 * types are used.
 */
#ifndef FILLRATE_V_ENV_H
#define FILLRATE_V_ENV_H

#define V_CDECL
#define V_DLLIMPORT V_CDECL
#define V_DLLEXPORT V_CDECL
#define V_EXPORTED
#if defined(_WIN32)
#include <windows.h>
#define V_IMPORT extern __declspec(dllimport)
#undef V_CDECL
#define V_CDECL __cdecl
#else
#define V_IMPORT extern
#ifndef FILLRATE_NO_WINDOWS_TYPES
typedef void *HWND;
typedef void *HDC;
typedef char *LPSTR;
#endif
#endif

/* --- scalars ------------------------------------------------------------ */

typedef unsigned int v_u32;
typedef unsigned short v_u16;
typedef unsigned char v_u8;
typedef int v_s32;
typedef short v_s16;
typedef signed char v_s8;

/* A byte address in the board's memory. */
typedef v_u32 v_foreignAddress;
typedef v_u32 v_physaddr;

/* --- memory pages ------------------------------------------------------- */

#define V_PAGE_SIZE 4096
#define V_PAGE_WORDS 1024
#define V_PAGE_SHIFT 12
#define V_PAGE_MASK 0xFFFFF000
#define V_PAGE_PRESENT 1

/* One block of a DMA list. */
typedef struct {
    v_u32 *addr;
    v_u32 port : 2;
    v_u32 len : 22;
    v_u32 reserved : 7;
    v_u32 link : 1;
} v_env_dmalist_entry;

#endif
