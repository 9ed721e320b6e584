/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * rlex.h: extensions of the redline layer. Their functions come from
 * VL_GetExtensionFunction, after VL_GetExtensions has named them.
 */
#ifndef FILLRATE_RLEX_H
#define FILLRATE_RLEX_H

#include <redline.h>
#include <rlfifoex.h>

typedef enum {
    V_SPECULAR_DISABLE = 0,
    V_SPECULAR_ENABLE = 1
} v_SpecularEnable;

typedef vl_error(V_CDECL *VL_SetSpecularEnable_fn)(v_cmdbuffer *cmdbuffer, v_u32 enable);
typedef vl_error(V_CDECL *VL_SetSpecularColorRGB_fn)(v_cmdbuffer *cmdbuffer, v_u32 color);
typedef vl_error(V_CDECL *VL_SetSpecularColorBGR_fn)(v_cmdbuffer *cmdbuffer, v_u32 color);

#endif
