/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * gump.h: multi-pass texturing. Gives a board with one texture unit a second,
 * virtual one by drawing each triangle twice.
 */
#ifndef FILLRATE_GUMP_H
#define FILLRATE_GUMP_H

#include "glide.h"

#ifdef __cplusplus
extern "C" {
#endif

#define GLIDE_NUM_VIRTUAL_TMU 2

/* How the two textures are put together. */
typedef FxI32 GrMPTextureCombineFnc_t;
#define GR_MPTEXTURECOMBINE_ADD        0x0
#define GR_MPTEXTURECOMBINE_MULTIPLY   0x1
#define GR_MPTEXTURECOMBINE_DETAIL0    0x2
#define GR_MPTEXTURECOMBINE_DETAIL1    0x3
#define GR_MPTEXTURECOMBINE_TRILINEAR0 0x4
#define GR_MPTEXTURECOMBINE_TRILINEAR1 0x5
#define GR_MPTEXTURECOMBINE_SUBTRACT   0x6

typedef struct {
    GrMipMapId_t            mmid[GLIDE_NUM_VIRTUAL_TMU];
    GrMPTextureCombineFnc_t tc_fnc;
} GrMPState;

#ifndef FX_GLIDE_NO_FUNC_PROTO

FX_ENTRY void FX_CALL guMPInit(void);
FX_ENTRY void FX_CALL guMPTexCombineFunction(GrMPTextureCombineFnc_t tc);
FX_ENTRY void FX_CALL guMPTexSource(GrChipID_t virtual_tmu, GrMipMapId_t mmid);
FX_ENTRY void FX_CALL guMPDrawTriangle(
    const GrVertex *a, const GrVertex *b, const GrVertex *c);

#endif /* FX_GLIDE_NO_FUNC_PROTO */

#ifdef __cplusplus
}
#endif

#endif /* FILLRATE_GUMP_H */
