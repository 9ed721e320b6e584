/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * fxdll.h: linkage and calling convention of the library's functions.
 *
 *   FX_ENTRY   storage class in front of every prototype
 *   FX_CALL    calling convention of every library function
 *   FX_CSTYLE  the same convention, for code that wraps or re-exports one
 *   FX_EXPORT  storage class for a function that a library defines
 *
 * On 32-bit Windows, Watcom and IBM compilers the library is called with
 * __stdcall; DJGPP, every Unix and all 64-bit targets use the platform's
 * usual C convention.
 */
#ifndef FILLRATE_FXDLL_H
#define FILLRATE_FXDLL_H

#define FX_ENTRY extern

#if defined(_WIN64) || defined(__DJGPP__)
#define FX_CALL
#elif defined(_MSC_VER) || defined(__MINGW32__) || defined(__WATCOMC__) \
    || defined(__IBMC__) || defined(__IBMCPP__)
#define FX_CALL __stdcall
#else
#define FX_CALL
#endif

#define FX_CSTYLE FX_CALL

#if defined(_WIN32) && defined(FX_DLL_DEFINITION)
#define FX_EXPORT __declspec(dllexport)
#else
#define FX_EXPORT extern
#endif

#endif /* FILLRATE_FXDLL_H */
