/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * verite.h: the lower layer of RRedline: host and video memory, command
 * buffers, display modes.
 *
 *     cc -Iinclude program.c -lredline -lverite
 */
#ifndef FILLRATE_VERITE_H
#define FILLRATE_VERITE_H

#include <v_env.h>
#include <v_res.h>

#ifdef __cplusplus
extern "C" {
#endif

/* --- types --------------------------------------------------------------- */

typedef int v_error;
typedef int v_routine;

typedef struct v_handle_rec *v_handle;
typedef struct v_memory_rec *v_memory;
typedef struct v_cmdbuffer_rec *v_cmdbuffer;
typedef struct v_buffer_group_rec *v_buffer_group;

/* Right and bottom are the first column and row outside. */
typedef struct {
    long left;
    long top;
    long right;
    long bottom;
} v_rect;

typedef struct {
    unsigned long veriteID;
    unsigned long memMappedIoBase;
    unsigned long memBase;
    unsigned long memSize;
    v_u16 ioBase;
    v_u8 busMaster;
    v_u8 vgaDevice;
} v_verite_info;

/* Is called when a command does not fit; returns the buffer to go on with. */
typedef v_cmdbuffer(V_CDECL *v_cmdbuffer_callback)(v_handle verite, v_cmdbuffer cmdbuffer);
typedef void(V_CDECL *v_error_handler)(v_handle verite, v_routine routine, v_error error,
                                       int exterr);

/* --- enumerations -------------------------------------------------------- */

/* Pixel formats, high bit first. */
typedef enum {
    V_PIXFMT_DSTFMT = 0,
    V_PIXFMT_332 = 1,
    V_PIXFMT_233 = 1,
    V_PIXFMT_8I = 2,
    V_PIXFMT_8A = 3,
    V_PIXFMT_565 = 4,
    V_PIXFMT_4444 = 5,
    V_PIXFMT_1555 = 6,
    V_PIXFMT_4I_565 = 8,
    V_PIXFMT_4I_4444 = 9,
    V_PIXFMT_4I_1555 = 10,
    V_PIXFMT_8888 = 12,
    V_PIXFMT_Y0CRY1CB = 13,
    V_PIXFMT_Y0CBY1CR = 13
} v_PixFmt;

typedef enum {
    V_SRCFUNC_NOTEXTURE = 0,
    V_SRCFUNC_REPLACE = 1,
    V_SRCFUNC_DECAL = 2,
    V_SRCFUNC_MODULATE = 3
} v_SrcFunc;

typedef enum {
    V_SRCFILTER_POINT = 0,
    V_SRCFILTER_BILINEAR = 1
} v_SrcFilter;

/* These two are named for what they switch off. */
typedef enum {
    V_SRCCOLORPAD_ENABLE = 0,
    V_SRCCOLORPAD_DISABLE = 1
} v_SrcColorNoPad;

typedef enum {
    V_DSTRD_ENABLE = 0,
    V_DSTRD_DISABLE = 1
} v_DstRdDisable;

typedef enum {
    V_SWAPUV_DISABLE = 0,
    V_SWAPUV_ENABLE = 1
} v_SwapUV;

typedef enum {
    V_CHROMAKEY_DISABLE = 0,
    V_CHROMAKEY_ENABLE = 1
} v_ChromaKey;

typedef enum {
    V_ZSCISSOR_DISABLE = 0,
    V_ZSCISSOR_ENABLE = 1
} v_ZScissorEn;

typedef enum {
    V_SRCBGR_DISABLE = 0,
    V_SRCBGR_ENABLE = 1
} v_SrcBGR;

typedef enum {
    V_UCLAMP_DISABLE = 0,
    V_UCLAMP_ENABLE = 1
} v_UClamp;

typedef enum {
    V_VCLAMP_DISABLE = 0,
    V_VCLAMP_ENABLE = 1
} v_VClamp;

typedef enum {
    V_YUV2RGB_DISABLE = 0,
    V_YUV2RGB_ENABLE = 1
} v_YUV2RGB;

typedef enum {
    V_BLEND_DISABLE = 0,
    V_BLEND_ENABLE = 1
} v_BlendEnable;

typedef enum {
    V_DITHER_DISABLE = 0,
    V_DITHER_ENABLE = 1
} v_DitherEnable;

typedef enum {
    V_FOG_DISABLE = 0,
    V_FOG_ENABLE = 1
} v_FogEnable;

typedef enum {
    V_DSTBGR_DISABLE = 0,
    V_DSTBGR_ENABLE = 1
} v_DstBGR;

typedef enum {
    V_TRANSPREJECT_DISABLE = 0,
    V_TRANSPREJECT_ENABLE = 1
} v_TranspReject;

typedef enum {
    V_PAT_DISABLE = 0,
    V_PAT_ENABLE = 1
} v_PatEnable;

typedef enum {
    V_PATOPAQUE_DISABLE = 0,
    V_PATOPAQUE_ENABLE = 1
} v_PatOpaque;

typedef enum {
    V_ZBUFWRMODE_DISABLE = 0,
    V_ZBUFWRMODE_ENABLE = 1
} v_ZBufWrMode;

/* A new depth passes where it compares so with the stored one. */
typedef enum {
    V_ZBUFMODE_ALWAYS = 0,
    V_ZBUFMODE_LT = 1,
    V_ZBUFMODE_EQ = 2,
    V_ZBUFMODE_LE = 3,
    V_ZBUFMODE_GT = 4,
    V_ZBUFMODE_NE = 5,
    V_ZBUFMODE_GE = 6
} v_ZBufMode;

/* Values 0 and 1 are the colour of the other operand than the one they scale. */
typedef enum {
    V_BLENDSRCCOLOR = 0,
    V_BLENDSRCCOLORINV = 1,
    V_BLENDDSTCOLOR = 0,
    V_BLENDDSTCOLORINV = 1,
    V_BLENDSRCALPHA = 2,
    V_BLENDSRCALPHAINV = 3,
    V_BLENDDSTALPHA = 4,
    V_BLENDDSTALPHAINV = 5,
    V_BLEND0 = 6,
    V_BLEND1 = 7,
    V_BLENDSRCALPHASAT = 8,
    V_BLENDSRCALPHASATINV = 9
} v_BlendFunc;

/* Bit 2s + d is the result for source bit s and destination bit d. */
typedef enum {
    V_ALUMODE_ZERO = 0,
    V_ALUMODE_SRC_NOR_DST = 1,
    V_ALUMODE_NOT_SRC_AND_DST = 2,
    V_ALUMODE_NOT_SRC = 3,
    V_ALUMODE_SRC_AND_NOT_DST = 4,
    V_ALUMODE_NOT_DST = 5,
    V_ALUMODE_SRC_XOR_DST = 6,
    V_ALUMODE_SRC_NAND_DST = 7,
    V_ALUMODE_SRC_AND_DST = 8,
    V_ALUMODE_SRC_XNOR_DST = 9,
    V_ALUMODE_DST = 10,
    V_ALUMODE_NOT_SRC_OR_DST = 11,
    V_ALUMODE_SRC = 12,
    V_ALUMODE_SRC_OR_NOT_DST = 13,
    V_ALUMODE_SRC_OR_DST = 14,
    V_ALUMODE_ONE = 15
} v_ALUMode;

/* Bytes of a pixel; 0 for formats without a whole byte and for unknown ones. */
#define V_PIXEL_SIZE(fmt) \
    ((fmt) >= 1 && (fmt) <= 3 ? 1 : ((fmt) >= 4 && (fmt) <= 6) || (fmt) == 13 ? 2 \
     : (fmt) == 12 ? 4 : 0)

/* --- bits and numbers ---------------------------------------------------- */

#define V_SURFACE_Z_BUFFER 1
#define V_SURFACE_PRIMARY 2
#define V_SURFACE_INTERLEAVED 4

#define V_SURFACE_UCLAMP 1
#define V_SURFACE_VCLAMP 2

#define V_WINDOWED_APP 1
#define V_FULLSCREEN_APP 2

/* How the words of a DMA block are turned: not, all four bytes, the bytes of
 * each half, the halves. */
#define V_WORD_FIFO_PORT 0
#define V_BYTE_FIFO_PORT 1
#define V_OTHER_FIFO_PORT 2
#define V_SHORT_FIFO_PORT 3

/* V_GetMemoryObjectStatus. */
#define V_PAGES_LOCKED 0x101
#define V_PAGES_UNLOCKED 0x102

/* --- device -------------------------------------------------------------- */

V_IMPORT v_error V_CDECL V_CreateVerite(v_u32 board, HWND window, v_handle *verite,
    char *microcode);
V_IMPORT v_error V_CDECL V_DestroyVerite(v_handle verite);
V_IMPORT v_error V_CDECL V_EnumVeriteBoards(HWND window, v_u32 board, v_verite_info *info);
V_IMPORT v_u32 V_CDECL V_GetUseDMA(v_handle verite);
V_IMPORT void V_CDECL V_SetUserPrivate(v_handle verite, v_u32 value);
V_IMPORT v_u32 V_CDECL V_GetUserPrivate(v_handle verite);
V_IMPORT v_u32 V_CDECL V_Stride(v_handle verite, v_u32 linebytes);
V_IMPORT v_u32 V_CDECL V_Linebytes(v_handle verite, v_u32 stride);
V_IMPORT v_error V_CDECL V_RegisterSyncCmd(v_handle verite, v_u32 command);

/* --- host memory --------------------------------------------------------- */

V_IMPORT v_memory V_CDECL V_AllocMemoryObject(v_handle verite, v_u32 *address, v_u32 bytes);
V_IMPORT v_error V_CDECL V_SetMemoryObject(v_memory memory, v_u32 *address, v_u32 bytes);
V_IMPORT v_u32 *V_CDECL V_GetMemoryObjectAddress(v_memory memory);
V_IMPORT v_u32 V_CDECL V_GetMemoryObjectSize(v_memory memory);
V_IMPORT v_u32 V_CDECL V_GetMemoryObjectStatus(v_memory memory);
V_IMPORT void V_CDECL V_FreeMemoryObject(v_handle verite, v_memory memory);
V_IMPORT v_memory V_CDECL V_AllocLockedMem(v_handle verite, v_u32 bytes);
V_IMPORT v_error V_CDECL V_FreeLockedMem(v_handle verite, v_memory memory);
V_IMPORT v_error V_CDECL V_LockPages(v_handle verite, v_memory memory);
V_IMPORT v_error V_CDECL V_UnlockPages(v_handle verite, v_memory memory);

/* --- command buffers ----------------------------------------------------- */

V_IMPORT v_cmdbuffer V_CDECL V_CreateCmdBuffer(v_handle verite, int dma_entries,
    int commands);
V_IMPORT v_error V_CDECL V_IssueCmdBuffer(v_handle verite, v_cmdbuffer cmdbuffer);
V_IMPORT v_error V_CDECL V_IssueCmdBufferAsync(v_handle verite, v_cmdbuffer cmdbuffer);
V_IMPORT v_u32 V_CDECL V_QueryCmdBuffer(v_handle verite, v_cmdbuffer cmdbuffer);
V_IMPORT v_error V_CDECL V_DestroyCmdBuffer(v_cmdbuffer cmdbuffer);
V_IMPORT void V_CDECL V_ResetCmdBuffer(v_cmdbuffer cmdbuffer);
V_IMPORT void V_CDECL V_SetCmdBufferCallBack(v_cmdbuffer cmdbuffer,
    v_cmdbuffer_callback callback);
V_IMPORT v_cmdbuffer_callback V_CDECL V_GetCmdBufferCallBack(v_cmdbuffer cmdbuffer);
V_IMPORT v_handle V_CDECL V_GetCmdBufferHandle(v_cmdbuffer cmdbuffer);
V_IMPORT v_error V_CDECL V_GetCmdBufferFreeSpace(v_cmdbuffer cmdbuffer, v_u32 *commands,
    v_u32 *dma_entries);
V_IMPORT v_u32 V_CDECL V_GetDMAEntries(v_memory memory, v_u32 *address, v_u32 words);
V_IMPORT v_u32 *V_CDECL V_AddToCmdList(v_cmdbuffer *cmdbuffer, v_u32 words);
V_IMPORT v_u32 *V_CDECL V_AddToCmdAndDMAList(v_cmdbuffer *cmdbuffer, v_u32 words,
    v_u32 dma_entries);
V_IMPORT v_error V_CDECL V_AddToDMAList(v_cmdbuffer *cmdbuffer, v_u32 port, v_memory memory,
    v_u32 *address, v_u32 words);

/* --- display and video memory -------------------------------------------- */

V_IMPORT v_error V_CDECL V_SetDisplayType(v_handle verite, v_u32 type);
V_IMPORT v_u32 V_CDECL V_GetDisplayType(v_handle verite);
V_IMPORT v_error V_CDECL V_SetDisplayMode(v_handle verite, v_u32 width, v_u32 height,
    v_u32 bits, v_u32 refresh);
V_IMPORT v_error V_CDECL V_SetDisplayLinebytes(v_handle verite, v_u32 linebytes);
V_IMPORT v_error V_CDECL V_CreateBufferGroup(v_handle verite, v_buffer_group *group,
    v_u32 *memsize, v_u32 mask, v_u32 buffers, v_u32 pixel_fmt, v_u32 width, v_u32 height);
V_IMPORT v_error V_CDECL V_PointBufferGroup(v_handle verite, v_buffer_group *group,
    v_u32 *memsize, v_u32 mask, v_u32 buffers, v_u32 pixel_fmt, v_u32 width, v_u32 height,
    v_foreignAddress address);
V_IMPORT v_error V_CDECL V_DestroyBufferGroup(v_handle verite, v_buffer_group group);
V_IMPORT v_error V_CDECL V_BltDisplayBuffer(v_handle verite, v_buffer_group dst,
    v_u32 dst_buffer, v_rect *dst_rect, v_buffer_group src, v_u32 src_buffer,
    v_rect *src_rect);
V_IMPORT v_error V_CDECL V_ReadBuffer(v_handle verite, v_buffer_group group, v_u32 buffer,
    v_u32 x, v_u32 y, v_u32 width, v_u32 height, v_u32 linebytes, v_u32 *data);
V_IMPORT void *V_CDECL V_LockBuffer(v_handle verite, v_buffer_group group, v_u32 buffer);
V_IMPORT v_error V_CDECL V_UnlockBuffer(v_handle verite, v_buffer_group group,
    v_u32 buffer);
V_IMPORT v_u32 V_CDECL V_IsBufferLost(v_handle verite, v_buffer_group group, v_u32 buffer);
V_IMPORT v_error V_CDECL V_RestoreBuffer(v_handle verite, v_buffer_group group,
    v_u32 buffer);
V_IMPORT v_u32 V_CDECL V_GetBufferLinebytes(v_buffer_group group, v_u32 buffer);
V_IMPORT v_u32 V_CDECL V_GetBufferStride(v_buffer_group group, v_u32 buffer);
V_IMPORT v_foreignAddress V_CDECL V_GetBufferAddress(v_buffer_group group, v_u32 buffer);
V_IMPORT v_u32 V_CDECL V_GetNumBuffers(v_buffer_group group);
V_IMPORT v_u32 V_CDECL V_GetBufferMask(v_buffer_group group);
V_IMPORT v_error V_CDECL V_SwapBuffers(v_buffer_group group, v_u32 a, v_u32 b);
V_IMPORT v_error V_CDECL V_GetBufferDC(v_buffer_group group, v_u32 buffer, HDC *dc);
V_IMPORT v_error V_CDECL V_ReleaseBufferDC(v_buffer_group group, v_u32 buffer, HDC dc);
V_IMPORT v_error V_CDECL V_GetBoardAddress(v_handle verite, v_u32 *address,
    v_foreignAddress *board_address);

/* --- errors -------------------------------------------------------------- */

V_IMPORT v_error V_CDECL V_RegisterErrorHandler(v_error_handler handler);
V_IMPORT v_error_handler V_CDECL V_GetErrorHandler(void);
V_IMPORT v_error V_CDECL V_GetFunctionName(v_routine routine, LPSTR text, int bytes);
V_IMPORT v_error V_CDECL V_GetErrorText(v_error error, LPSTR text, int bytes);
V_IMPORT v_error V_CDECL V_GetLastError(v_routine *routine, v_error *error, int *exterr);

#ifdef __cplusplus
}
#endif

#endif
