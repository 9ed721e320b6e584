/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * rlfifoex.h: words of the extension Specular.
 */
#ifndef FILLRATE_RLFIFOEX_H
#define FILLRATE_RLFIFOEX_H

#include <rlfifo.h>

/* Ka: alpha in bits 31..24. Sf: fog factor in bits 31..24. */
#define V_FIFO_KaSFXYZUVQ 32
#define V_FIFO_KSXYUVQ    33
#define V_FIFO_KSXYZUVQ   34

typedef struct {
    v_u32 argb;
    v_u32 sf;
    v_s32 x;
    v_s32 y;
    v_u32 z;
    v_s32 u;
    v_s32 v;
    v_u32 q;
} v_kasfxyzuvq;

typedef struct {
    v_u32 rgb;
    v_u32 s;
    v_s32 x;
    v_s32 y;
    v_s32 u;
    v_s32 v;
    v_u32 q;
} v_ksxyuvq;

typedef struct {
    v_u32 rgb;
    v_u32 s;
    v_s32 x;
    v_s32 y;
    v_u32 z;
    v_s32 u;
    v_s32 v;
    v_u32 q;
} v_ksxyzuvq;

#define V_FIFO_SPECULARENABLE 0x18D3
#define V_FIFO_SPECCOLORRGB   0x205C

#endif
