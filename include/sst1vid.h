/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * sst1vid.h: screen resolutions and refresh rates for grSstWinOpen and
 * grSstOpen.
 */
#ifndef FILLRATE_SST1VID_H
#define FILLRATE_SST1VID_H

#include "3dfx.h"

/* Vertical refresh of the display. */
typedef FxI32 GrScreenRefresh_t;
#define GR_REFRESH_60Hz   0x0
#define GR_REFRESH_70Hz   0x1
#define GR_REFRESH_72Hz   0x2
#define GR_REFRESH_75Hz   0x3
#define GR_REFRESH_80Hz   0x4
#define GR_REFRESH_90Hz   0x5
#define GR_REFRESH_100Hz  0x6
#define GR_REFRESH_85Hz   0x7
#define GR_REFRESH_120Hz  0x8
#define GR_REFRESH_NONE   0xff

/* The spelling the Programming Guide prints. */
#define GR_REFRESH_60HZ   GR_REFRESH_60Hz
#define GR_REFRESH_70HZ   GR_REFRESH_70Hz
#define GR_REFRESH_72HZ   GR_REFRESH_72Hz
#define GR_REFRESH_75HZ   GR_REFRESH_75Hz
#define GR_REFRESH_80HZ   GR_REFRESH_80Hz
#define GR_REFRESH_90HZ   GR_REFRESH_90Hz
#define GR_REFRESH_100HZ  GR_REFRESH_100Hz
#define GR_REFRESH_85HZ   GR_REFRESH_85Hz
#define GR_REFRESH_120HZ  GR_REFRESH_120Hz

/* Width x height in pixels. Voodoo Graphics has timings for 0x0..0xB; with
 * 2 MB of frame memory 800x600 and 856x480 leave no room for a depth buffer. */
typedef FxI32 GrScreenResolution_t;
#define GR_RESOLUTION_320x200    0x0
#define GR_RESOLUTION_320x240    0x1
#define GR_RESOLUTION_400x256    0x2
#define GR_RESOLUTION_512x384    0x3
#define GR_RESOLUTION_640x200    0x4
#define GR_RESOLUTION_640x350    0x5
#define GR_RESOLUTION_640x400    0x6
#define GR_RESOLUTION_640x480    0x7
#define GR_RESOLUTION_800x600    0x8
#define GR_RESOLUTION_960x720    0x9
#define GR_RESOLUTION_856x480    0xa
#define GR_RESOLUTION_512x256    0xb
#define GR_RESOLUTION_1024x768   0xc
#define GR_RESOLUTION_1280x1024  0xd
#define GR_RESOLUTION_1600x1200  0xe
#define GR_RESOLUTION_400x300    0xf
#define GR_RESOLUTION_NONE       0xff  /* size of the window, where there is one */

#define GR_RESOLUTION_MIN GR_RESOLUTION_320x200
#define GR_RESOLUTION_MAX GR_RESOLUTION_1600x1200

#endif /* FILLRATE_SST1VID_H */
