/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * rlfifo.h: words that the chip reads: vertices, commands, state.
 */
#ifndef FILLRATE_RLFIFO_H
#define FILLRATE_RLFIFO_H

#include <v_env.h>

/* --- packing ------------------------------------------------------------- */

#define V_FIFO_PACK_XY(x, y) ((((v_u32)(x)) << 16) | ((v_u32)(y) & 0xFFFF))
#define V_SCISSORX(l, r) ((((v_u32)(l)) << 16) | ((v_u32)(r) & 0xFFFF))
#define V_SCISSORY(t, b) ((((v_u32)(t)) << 16) | ((v_u32)(b) & 0xFFFF))
#define V_DITHEROFFSET(x, y) ((((v_u32)(y) & 3) << 4) | ((v_u32)(x) & 3))

/* First words of commands: a vertex type, or flags, and the command. */
#define V_FIFO_VTX_CMD(type, cmd) ((((v_u32)(type)) << 16) | ((v_u32)(cmd) & 0xFFFF))
#define V_FIFO_FLAGS_CMD(flags, cmd) ((((v_u32)(flags)) << 16) | ((v_u32)(cmd) & 0xFFFF))

#define V_FIFO_LAST_PIXEL_OMIT 0
#define V_FIFO_LAST_PIXEL_DRAW 1

/* --- vertices ------------------------------------------------------------ */

#define V_FIFO_XY           1
#define V_FIFO_XYUV         2
#define V_FIFO_XYUVQ        3
#define V_FIFO_IXYUVQ       4
#define V_FIFO_FXYUVQ       5
#define V_FIFO_XYZUVQ       6
#define V_FIFO_RGBFXY       7
#define V_FIFO_RGBXYZ       8
#define V_FIFO_IFXYUVQ      9
#define V_FIFO_IXYZUVQ      10
#define V_FIFO_RGBAFXYUVQ   11
#define V_FIFO_RGBAXYZUVQ   12
#define V_FIFO_KFXY         17
#define V_FIFO_KXYZ         18
#define V_FIFO_KAFXYUVQ     19
#define V_FIFO_KAXYZUVQ     20
#define V_FIFO_IXYZUV       21
#define V_FIFO_RGBAFXYZUVQ  22
#define V_FIFO_KAFXYZUVQ    24
#define V_FIFO_KXYUVQ       25
#define V_FIFO_IFXYZUVQ     26
#define V_FIFO_AXY          27
#define V_FIFO_KXY          28
#define V_FIFO_KFXYZ        29
#define V_FIFO_FXYZ         30
#define V_FIFO_XYZ          31

/* Coordinates, intensities and colours of a channel: 16.16. rgb: a byte each,
 * red in bits 23..16. q: 0.24. */
typedef struct {
    v_s32 x;
    v_s32 y;
} v_xy;

typedef struct {
    v_s32 x;
    v_s32 y;
    v_s32 u;
    v_s32 v;
} v_xyuv;

typedef struct {
    v_s32 x;
    v_s32 y;
    v_s32 u;
    v_s32 v;
    v_u32 q;
} v_xyuvq;

typedef struct {
    v_s32 i;
    v_s32 x;
    v_s32 y;
    v_s32 u;
    v_s32 v;
    v_u32 q;
} v_ixyuvq;

typedef struct {
    v_s32 f;
    v_s32 x;
    v_s32 y;
    v_s32 u;
    v_s32 v;
    v_u32 q;
} v_fxyuvq;

typedef struct {
    v_s32 x;
    v_s32 y;
    v_u32 z;
    v_s32 u;
    v_s32 v;
    v_u32 q;
} v_xyzuvq;

typedef struct {
    v_s32 r;
    v_s32 g;
    v_s32 b;
    v_s32 f;
    v_s32 x;
    v_s32 y;
} v_rgbfxy;

typedef struct {
    v_s32 r;
    v_s32 g;
    v_s32 b;
    v_s32 x;
    v_s32 y;
    v_u32 z;
} v_rgbxyz;

typedef struct {
    v_s32 i;
    v_s32 f;
    v_s32 x;
    v_s32 y;
    v_s32 u;
    v_s32 v;
    v_u32 q;
} v_ifxyuvq;

typedef struct {
    v_s32 i;
    v_s32 x;
    v_s32 y;
    v_u32 z;
    v_s32 u;
    v_s32 v;
    v_u32 q;
} v_ixyzuvq;

typedef struct {
    v_s32 r;
    v_s32 g;
    v_s32 b;
    v_s32 a;
    v_s32 f;
    v_s32 x;
    v_s32 y;
    v_s32 u;
    v_s32 v;
    v_u32 q;
} v_rgbafxyuvq;

typedef struct {
    v_s32 r;
    v_s32 g;
    v_s32 b;
    v_s32 a;
    v_s32 x;
    v_s32 y;
    v_u32 z;
    v_s32 u;
    v_s32 v;
    v_u32 q;
} v_rgbaxyzuvq;

typedef struct {
    v_u32 rgb;
    v_s32 f;
    v_s32 x;
    v_s32 y;
} v_kfxy;

typedef struct {
    v_u32 rgb;
    v_s32 x;
    v_s32 y;
    v_u32 z;
} v_kxyz;

typedef struct {
    v_u32 rgb;
    v_s32 a;
    v_s32 f;
    v_s32 x;
    v_s32 y;
    v_s32 u;
    v_s32 v;
    v_u32 q;
} v_kafxyuvq;

typedef struct {
    v_u32 rgb;
    v_s32 a;
    v_s32 x;
    v_s32 y;
    v_u32 z;
    v_s32 u;
    v_s32 v;
    v_u32 q;
} v_kaxyzuvq;

typedef struct {
    v_s32 i;
    v_s32 x;
    v_s32 y;
    v_u32 z;
    v_s32 u;
    v_s32 v;
} v_ixyzuv;

typedef struct {
    v_s32 r;
    v_s32 g;
    v_s32 b;
    v_s32 a;
    v_s32 f;
    v_s32 x;
    v_s32 y;
    v_u32 z;
    v_s32 u;
    v_s32 v;
    v_u32 q;
} v_rgbafxyzuvq;

typedef struct {
    v_u32 rgb;
    v_s32 a;
    v_s32 f;
    v_s32 x;
    v_s32 y;
    v_u32 z;
    v_s32 u;
    v_s32 v;
    v_u32 q;
} v_kafxyzuvq;

typedef struct {
    v_u32 rgb;
    v_s32 x;
    v_s32 y;
    v_s32 u;
    v_s32 v;
    v_u32 q;
} v_kxyuvq;

typedef struct {
    v_s32 i;
    v_s32 f;
    v_s32 x;
    v_s32 y;
    v_u32 z;
    v_s32 u;
    v_s32 v;
    v_u32 q;
} v_ifxyzuvq;

typedef struct {
    v_s32 a;
    v_s32 x;
    v_s32 y;
} v_axy;

typedef struct {
    v_u32 rgb;
    v_s32 x;
    v_s32 y;
} v_kxy;

typedef struct {
    v_u32 rgb;
    v_s32 f;
    v_s32 x;
    v_s32 y;
    v_u32 z;
} v_kfxyz;

typedef struct {
    v_s32 f;
    v_s32 x;
    v_s32 y;
    v_u32 z;
} v_fxyz;

typedef struct {
    v_s32 x;
    v_s32 y;
    v_u32 z;
} v_xyz;

/* Of the fast triangles; f is in bits 31..24. */
typedef struct {
    v_u32 rgb;
    v_s32 x;
    v_s32 y;
    v_u32 z;
    v_s32 u;
    v_s32 v;
    v_u32 q;
} v_kxyzuvq;

typedef struct {
    v_u32 rgb;
    v_u32 f;
    v_s32 x;
    v_s32 y;
    v_u32 z;
    v_s32 u;
    v_s32 v;
    v_u32 q;
} v_kfxyzuvq;

/* --- commands ------------------------------------------------------------ */

#define V_FIFO_CONTEXT_INIT         2
#define V_FIFO_DISPLAY              4
#define V_FIFO_STEREO_DISPLAY       5
#define V_FIFO_WAIT_DISPLAY_SWITCH  6
#define V_FIFO_SYNC_AND_RESPOND     8
#define V_FIFO_MEM_WRITE            9
#define V_FIFO_MEM_WRITE_RECT       10
#define V_FIFO_MEM_CLEAR_RECT       13
#define V_FIFO_MEM_WRITE_SPRITE     14
#define V_FIFO_DOT                  15
#define V_FIFO_LINE                 16
#define V_FIFO_POLYLINE             17
#define V_FIFO_INTLINE              18
#define V_FIFO_INTPOLYLINE          19
#define V_FIFO_AALINE               20
#define V_FIFO_SPAN                 21
#define V_FIFO_SQUARE               22
#define V_FIFO_RECTANGLE            23
#define V_FIFO_TRIANGLE             24
#define V_FIFO_AAEDGE               25
#define V_FIFO_TRISTRIP             26
#define V_FIFO_TRIFAN               27
#define V_FIFO_AFFINE               28
#define V_FIFO_WARP                 29
#define V_FIFO_BITBLT               30
#define V_FIFO_BITFILL              31
#define V_FIFO_RLEHACK              32
#define V_FIFO_PALETTE              33
#define V_FIFO_TIMER_FUNCS          34
#define V_FIFO_FRAME_MARKER         35
#define V_FIFO_COMPOSITE_RECT       36
#define V_FIFO_PARTICLES            37
#define V_FIFO_TRI_FILL             38
#define V_FIFO_QSPAN                39
#define V_FIFO_QLIGHT               40
#define V_FIFO_BITBLT_MEM           41
#define V_FIFO_LOOKUP               42
#define V_FIFO_QAAZEDGE             43

/* Three vertices each of k x y z, k x y z u v q, k f x y z u v q, k s x y z,
 * k s x y z u v q. */
#define V_FIFO_FTRI_KXYZ      48
#define V_FIFO_FTRI_KXYZUVQ   49
#define V_FIFO_FTRI_KFXYZUVQ  50
#define V_FIFO_FTRI_KSXYZ     51
#define V_FIFO_FTRI_KSXYZUVQ  52

#define V_FIFO_FRAME_MARKER_CMD      0x5A3C0023
#define V_FIFO_FRAME_MARKER_PATTERN  0xA5C31697

/* V_FIFO_TIMER_FUNCS: bits 23..16 and the timer in bits 28..24. */
#define V_FIFO_TIMER_RESET 0
#define V_FIFO_TIMER_START 1
#define V_FIFO_TIMER_STOP  2
#define V_FIFO_TIMER_GET   3

/* --- state, followed by one word of data ---------------------------------- */

/* Parts of a first word: bits 31..16, 15..12, 11..7 and 6..0. */
#define V_FIFO_SSMSK(mask)   (((v_u32)(mask)) << 16)
#define V_FIFO_SSOP(op)      (((v_u32)(op)) << 12)
#define V_FIFO_SSSHFT(shift) (((v_u32)(shift)) << 7)
#define V_FIFO_SSREG(reg)    ((v_u32)(reg))

#define V_FIFO_SRCBASE         0x1000
#define V_FIFO_DSTBASE         0x1004
#define V_FIFO_SRCFMT          0x1030
#define V_FIFO_DSTFMT          0x1006
#define V_FIFO_SRCFUNC         0x1231
#define V_FIFO_PMASK           0x1007
#define V_FIFO_SRCFILTER       0x13B2
#define V_FIFO_PAT             0x1008
#define V_FIFO_SRCCOLORNOPAD   0x14B3
#define V_FIFO_PATOFFSET       0x100D
#define V_FIFO_SWAPUV          0x1534
#define V_FIFO_SCISSORX        0x100E
#define V_FIFO_CHROMAKEY       0x15B5
#define V_FIFO_SCISSORY        0x100F
#define V_FIFO_ZSCISSOR        0x1636
#define V_FIFO_ZBASE           0x1010
#define V_FIFO_SRCBGR          0x16B7
#define V_FIFO_DITHEROFFSET    0x1011
#define V_FIFO_UMASK           0x1038
#define V_FIFO_FGCOLORARGB     0x3013
#define V_FIFO_VMASK           0x1839
#define V_FIFO_BGCOLORARGB     0x1014
#define V_FIFO_SRCSTRIDE       0x103A
#define V_FIFO_FOGCOLORRGB     0x1015
#define V_FIFO_DSTSTRIDE       0x143B
#define V_FIFO_DSTCOLORARGB    0x1016
#define V_FIFO_ZSTRIDE         0x183C
#define V_FIFO_CHROMACOLOR     0x1017
#define V_FIFO_UCLAMP          0x17BE
#define V_FIFO_YUVCONTRAST     0x1018
#define V_FIFO_VCLAMP          0x183F
#define V_FIFO_CHROMAMASK      0x101A
#define V_FIFO_UMULTIPLIER     0x5028
#define V_FIFO_ALPHATHRESHOLD  0x101D
#define V_FIFO_VMULTIPLIER     0x5029
#define V_FIFO_ALUMODE         0x1040
#define V_FIFO_SOFFSET         0x602A
#define V_FIFO_BLENDSRCFUNC    0x1241
#define V_FIFO_TOFFSET         0x602B
#define V_FIFO_BLENDDSTFUNC    0x1442
#define V_FIFO_PATLENGTHM1     0x1050
#define V_FIFO_ZBUFMODE        0x1643
#define V_FIFO_PATENABLE       0x1851
#define V_FIFO_ZBUFWRMODE      0x1844
#define V_FIFO_PATOPAQUE       0x18D2
#define V_FIFO_YUV2RGB         0x9945
#define V_FIFO_BLENDENABLE     0x89C6
#define V_FIFO_DITHERENABLE    0xAA47
#define V_FIFO_Z               0x2054
#define V_FIFO_FOGENABLE       0x1AC8
#define V_FIFO_A               0x2055
#define V_FIFO_DSTRDDISABLE    0x1BCA
#define V_FIFO_R               0x2056
#define V_FIFO_DSTBGR          0x1C4B
#define V_FIFO_V               0x2057
#define V_FIFO_TRANSPREJECT    0x1CCC
#define V_FIFO_G               0x2058
#define V_FIFO_U               0x205A
#define V_FIFO_B               0x2059
#define V_FIFO_F               0x205B

/* Followed by base, stride, both masks, and two multipliers. */
#define V_FIFO_SET_CURRENT_TEXTURE 0x4000
/* Followed by eight words of two entries. */
#define V_FIFO_TEX4PAL 0x7020

#endif
