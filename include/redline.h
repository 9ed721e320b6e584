/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * redline.h: the upper layer of RRedline: surfaces, state, primitives.
 *
 *     cc -Iinclude program.c -lredline -lverite
 */
#ifndef FILLRATE_REDLINE_H
#define FILLRATE_REDLINE_H

#include <verite.h>
#include <vl_res.h>
#include <rlfifo.h>

#ifdef __cplusplus
extern "C" {
#endif

/* --- types --------------------------------------------------------------- */

typedef int vl_error;
typedef int vl_routine;

typedef void(V_CDECL *vl_error_handler)(v_handle verite, vl_routine routine, vl_error error,
                                        int exterr);

/* A public structure: programs read and set members. */
typedef struct _v_surface {
    v_u32 width;
    v_u32 height;
    v_u32 pixel_fmt;
    v_u32 chroma_color;
    v_u32 chroma_mask;
    v_u32 chromakey;
    v_u32 color_pad;
    v_u32 bgr;
    v_u32 clamp;
    v_u32 *palette;
    v_u32 start_index;
    v_u32 num_entries;
    v_u32 memsize;
    v_u32 num_buffers;
    v_u32 buffer_mask;
    v_buffer_group buffer_group;
} v_surface;

/* --- device -------------------------------------------------------------- */

V_IMPORT vl_error V_CDECL VL_OpenVerite(HWND window, v_handle *verite);
V_IMPORT vl_error V_CDECL VL_CloseVerite(v_handle verite);
V_IMPORT char *V_CDECL VL_GetExtensions(v_handle verite);
V_IMPORT void *V_CDECL VL_GetExtensionFunction(char *name);

/* --- surfaces ------------------------------------------------------------ */

V_IMPORT vl_error V_CDECL VL_CreateSurface(v_handle verite, v_surface **surface, v_u32 mask,
    v_u32 buffers, v_u32 pixel_fmt, v_u32 width, v_u32 height);
V_IMPORT vl_error V_CDECL VL_PointSurface(v_handle verite, v_surface **surface, v_u32 mask,
    v_u32 buffers, v_u32 pixel_fmt, v_u32 width, v_u32 height, v_foreignAddress address);
V_IMPORT vl_error V_CDECL VL_DestroySurface(v_handle verite, v_surface *surface);
V_IMPORT vl_error V_CDECL VL_RestoreSurface(v_handle verite, v_surface *surface);
V_IMPORT vl_error V_CDECL VL_SetSurfaceChromaKey(v_surface *surface, v_u32 enable);
V_IMPORT vl_error V_CDECL VL_SetSurfaceChromaColor(v_surface *surface, v_u32 color);
V_IMPORT vl_error V_CDECL VL_SetSurfaceChromaMask(v_surface *surface, v_u32 mask);
V_IMPORT vl_error V_CDECL VL_SetSurfaceColorPad(v_surface *surface, v_u32 enable);
V_IMPORT vl_error V_CDECL VL_SetSurfaceBGR(v_surface *surface, v_u32 enable);
V_IMPORT vl_error V_CDECL VL_SetSurfaceClamp(v_surface *surface, v_u32 uclamp,
    v_u32 vclamp);
V_IMPORT vl_error V_CDECL VL_SetSurfaceTexturePalette(v_surface *surface, int start,
    int count, v_u32 *entries);
V_IMPORT vl_error V_CDECL VL_InstallDstBuffer(v_cmdbuffer *cmdbuffer, v_surface *surface);
V_IMPORT vl_error V_CDECL VL_InstallTextureMap(v_cmdbuffer *cmdbuffer, v_surface *surface);
V_IMPORT vl_error V_CDECL VL_InstallTextureMapBasic(v_cmdbuffer *cmdbuffer,
    v_surface *surface);
V_IMPORT vl_error V_CDECL VL_InstallZBuffer(v_cmdbuffer *cmdbuffer, v_surface *surface);
V_IMPORT vl_error V_CDECL VL_SwapDisplaySurface(v_cmdbuffer *cmdbuffer, v_surface *surface);
V_IMPORT vl_error V_CDECL VL_WaitForDisplaySwitch(v_cmdbuffer *cmdbuffer);
V_IMPORT vl_error V_CDECL VL_ContextInit(v_cmdbuffer *cmdbuffer);
V_IMPORT vl_error V_CDECL VL_FrameMarker(v_cmdbuffer *cmdbuffer, int frame);

/* --- state, one word each ------------------------------------------------ */

V_IMPORT vl_error V_CDECL VL_SetSrcBase(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetSrcFmt(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetSrcFunc(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetSrcFilter(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetSrcColorNoPad(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetSwapUV(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetChromaKey(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetZScissorEnable(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetSrcBGR(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetUClamp(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetVClamp(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetUMask(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetVMask(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetUMultiplier(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetVMultiplier(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetSOffset(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetTOffset(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetSrcStride(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetDstStride(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetZStride(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetDstBase(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetALUMode(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetBlendSrcFunc(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetBlendDstFunc(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetZBufMode(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetZBufWrMode(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetYUV2RGB(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetBlendEnable(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetDitherEnable(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetFogEnable(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetDstRdDisable(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetDstBGR(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetTranspReject(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetDstFmt(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetPMask(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetPat(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetPatLength(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetPatEnable(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetPatOpaque(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetPatOffset(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetScissorX(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetScissorY(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetZBase(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetDitherOffset(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetFGColorABGR(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetFGColorARGB(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetBGColorABGR(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetBGColorARGB(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetFogColorBGR(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetFogColorRGB(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetDstColorABGR(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetDstColorARGB(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetZ(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetR(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetG(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetB(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetA(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetF(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetU(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetV(v_cmdbuffer *cmdbuffer, v_u32 value);
V_IMPORT vl_error V_CDECL VL_SetDisplayBase(v_cmdbuffer *cmdbuffer, v_u32 address);
V_IMPORT vl_error V_CDECL VL_SetAlphaThreshold(v_cmdbuffer *cmdbuffer, v_u8 threshold);
V_IMPORT vl_error V_CDECL VL_SetChromaColor(v_cmdbuffer *cmdbuffer, v_u32 color,
    v_u32 pixel_fmt);
V_IMPORT vl_error V_CDECL VL_SetChromaMask(v_cmdbuffer *cmdbuffer, v_u32 mask,
    v_u32 pixel_fmt);
V_IMPORT vl_error V_CDECL VL_SetCurrentTexture(v_cmdbuffer *cmdbuffer, v_u32 base,
    v_u32 stride, v_u16 vmask, v_u16 umask, v_u32 umultiplier, v_u32 vmultiplier);
V_IMPORT vl_error V_CDECL VL_SetStereoDisplayBase(v_cmdbuffer *cmdbuffer, v_u32 even,
    v_u32 odd);
V_IMPORT vl_error V_CDECL VL_SetPalette(v_cmdbuffer *cmdbuffer, v_u16 start, v_u16 count,
    v_u32 *entries);
V_IMPORT vl_error V_CDECL VL_SetTexturePalette(v_cmdbuffer *cmdbuffer, v_u16 start,
    v_u16 count, v_u32 *entries, v_u32 pixel_fmt);

/* --- primitives ---------------------------------------------------------- */

V_IMPORT vl_error V_CDECL VL_Dot(v_cmdbuffer *cmdbuffer, v_u32 type, v_u32 *vertex);
V_IMPORT vl_error V_CDECL VL_Line(v_cmdbuffer *cmdbuffer, v_u32 type, v_u32 *v1, v_u32 *v2);
V_IMPORT vl_error V_CDECL VL_Polyline(v_cmdbuffer *cmdbuffer, v_u32 type, v_u32 segments,
    v_u32 *vertices);
V_IMPORT vl_error V_CDECL VL_IntLine(v_cmdbuffer *cmdbuffer, v_u32 last_pixel, v_u16 x0,
    v_u16 y0, v_u16 x1, v_u16 y1);
V_IMPORT vl_error V_CDECL VL_IntPolyline(v_cmdbuffer *cmdbuffer, v_u32 last_pixel,
    v_u32 segments, v_u32 *points);
V_IMPORT vl_error V_CDECL VL_AALine(v_cmdbuffer *cmdbuffer, v_u32 type, v_u32 *v1,
    v_u32 *v2);
V_IMPORT vl_error V_CDECL VL_AAEdge(v_cmdbuffer *cmdbuffer, v_u32 type, v_u32 *v1,
    v_u32 *v2);
V_IMPORT vl_error V_CDECL VL_Span(v_cmdbuffer *cmdbuffer, v_u32 type, v_u32 *start,
    v_u32 *delta);
V_IMPORT vl_error V_CDECL VL_Square(v_cmdbuffer *cmdbuffer, v_u32 type, v_u32 side,
    v_u32 *vertex);
V_IMPORT vl_error V_CDECL VL_Rectangle(v_cmdbuffer *cmdbuffer, v_u32 type, v_u32 width,
    v_u32 height, v_u32 *vertex);
V_IMPORT vl_error V_CDECL VL_Triangle(v_cmdbuffer *cmdbuffer, v_u32 type, v_u32 *v1,
    v_u32 *v2, v_u32 *v3);
V_IMPORT vl_error V_CDECL VL_TriangleNormQ(v_cmdbuffer *cmdbuffer, v_u32 type, v_u32 *v1,
    v_u32 *v2, v_u32 *v3);
V_IMPORT vl_error V_CDECL VL_Triangle3(v_cmdbuffer *cmdbuffer, v_u32 type, v_u32 *v1,
    v_u32 *v2, v_u32 *v3);
V_IMPORT vl_error V_CDECL VL_Tristrip(v_cmdbuffer *cmdbuffer, v_u32 type, v_u32 triangles,
    v_u32 *vertices);
V_IMPORT vl_error V_CDECL VL_Trifan(v_cmdbuffer *cmdbuffer, v_u32 type, v_u32 count,
    v_u32 *vertices);
V_IMPORT vl_error V_CDECL VL_TriangleFill(v_cmdbuffer *cmdbuffer, v_u32 x0, v_u32 y0,
    v_u32 x1, v_u32 y1, v_u32 x2, v_u32 y2);
V_IMPORT vl_error V_CDECL VL_Affine(v_cmdbuffer *cmdbuffer, v_u32 ulx, v_u32 uly, v_u32 ulu,
    v_u32 ulv, v_u32 width, v_u32 height, v_u32 dudx, v_u32 dvdx, v_u32 dudy, v_u32 dvdy);
V_IMPORT vl_error V_CDECL VL_Warp(v_cmdbuffer *cmdbuffer, v_u16 ulx, v_u16 uly, v_u16 width,
    v_u16 height, v_u32 ulu, v_u32 ulv, v_u32 *tex_coords);
V_IMPORT vl_error V_CDECL VL_Particles(v_cmdbuffer *cmdbuffer, v_u32 count,
    v_memory memory);
V_IMPORT v_u32 V_CDECL VL_VertexSize(v_u32 type);
V_IMPORT v_u32 V_CDECL VL_QOffset(v_u32 type);
V_IMPORT void V_CDECL VL_QNormalize(v_u32 *q0, v_u32 *q1, v_u32 *q2);

/* --- fills and copies ---------------------------------------------------- */

V_IMPORT vl_error V_CDECL VL_FillBuffer(v_cmdbuffer *cmdbuffer, v_surface *surface,
    v_u32 buffer, v_u32 x, v_u32 y, v_u32 width, v_u32 height, v_u32 pixel);
V_IMPORT vl_error V_CDECL VL_LoadBuffer(v_cmdbuffer *cmdbuffer, v_surface *surface,
    v_u32 buffer, v_u32 linebytes, v_u32 width, v_u32 height, v_memory memory,
    v_u32 *address);
V_IMPORT vl_error V_CDECL VL_CopyBuffer(v_cmdbuffer *cmdbuffer, v_surface *surface,
    v_u32 buffer, v_u32 alu_mode, v_u16 dst_x, v_u16 dst_y, v_u16 width, v_u16 height,
    v_u16 src_x, v_u16 src_y);
V_IMPORT vl_error V_CDECL VL_MemFill(v_cmdbuffer *cmdbuffer, v_foreignAddress dest,
    v_u32 pixel, v_u32 pixel_fmt, v_u32 width);
V_IMPORT vl_error V_CDECL VL_MemFillRect(v_cmdbuffer *cmdbuffer, v_foreignAddress dest,
    v_u32 dest_linebytes, v_u32 pixel, v_u32 pixel_fmt, v_u32 width, v_u32 height);
V_IMPORT vl_error V_CDECL VL_MemWrite(v_cmdbuffer *cmdbuffer, v_foreignAddress dest,
    v_memory memory, v_u32 *address, v_u32 pixel_fmt, v_u32 width);
V_IMPORT vl_error V_CDECL VL_MemWriteRect(v_cmdbuffer *cmdbuffer, v_foreignAddress dest,
    v_u32 dest_linebytes, v_memory memory, v_u32 *address, v_u32 pixel_fmt, v_u32 linebytes,
    v_u32 width, v_u32 height);
V_IMPORT vl_error V_CDECL VL_MemWriteSprite(v_cmdbuffer *cmdbuffer, v_foreignAddress dest,
    v_u32 pixel_fmt, v_u32 bytes, v_memory memory);
V_IMPORT vl_error V_CDECL VL_Bitblt(v_cmdbuffer *cmdbuffer, v_u16 dst_ulx, v_u16 dst_uly,
    v_u16 width, v_u16 height, v_u16 src_ulx, v_u16 src_uly);
V_IMPORT vl_error V_CDECL VL_BitBlt(v_cmdbuffer *cmdbuffer, v_u16 dst_ulx, v_u16 dst_uly,
    v_u16 width, v_u16 height, v_u16 src_ulx, v_u16 src_uly);
V_IMPORT vl_error V_CDECL VL_BitbltMem(v_cmdbuffer *cmdbuffer, v_u16 ulx, v_u16 uly,
    v_u16 width, v_u16 height, v_u32 byte_swap, v_memory memory, v_u32 *address);
V_IMPORT vl_error V_CDECL VL_Bitfill(v_cmdbuffer *cmdbuffer, v_u16 ulx, v_u16 uly,
    v_u16 width, v_u16 height);
V_IMPORT vl_error V_CDECL VL_BitfillNoPat(v_cmdbuffer *cmdbuffer, v_surface *surface,
    v_u32 buffer, v_u32 fgcolor, v_u16 ulx, v_u16 uly, v_u16 width, v_u16 height);
V_IMPORT vl_error V_CDECL VL_BitfillPatTransparent(v_cmdbuffer *cmdbuffer,
    v_surface *surface, v_u32 buffer, v_u32 fgcolor, v_u32 pat, v_u32 pat_length,
    v_u32 pat_offset, v_u16 ulx, v_u16 uly, v_u16 width, v_u16 height);
V_IMPORT vl_error V_CDECL VL_BitfillPatOpaque(v_cmdbuffer *cmdbuffer, v_surface *surface,
    v_u32 buffer, v_u32 fgcolor, v_u32 bgcolor, v_u32 pat, v_u32 pat_length,
    v_u32 pat_offset, v_u16 ulx, v_u16 uly, v_u16 width, v_u16 height);
V_IMPORT vl_error V_CDECL VL_CompositeRect(v_cmdbuffer *cmdbuffer, v_u32 pixel_fmt,
    v_u16 ulx, v_u16 uly, v_u16 width, v_u16 height, v_u32 u_start, v_u32 v_start,
    v_u32 u_stop, v_u32 v_stop, v_memory memory);
V_IMPORT vl_error V_CDECL VL_Lookup(v_cmdbuffer *cmdbuffer, v_u16 ulx, v_u16 uly,
    v_u16 width, v_u16 height, v_memory memory, v_u32 *address);

/* --- errors -------------------------------------------------------------- */

V_IMPORT vl_error V_CDECL VL_RegisterErrorHandler(vl_error_handler handler);
V_IMPORT vl_error_handler V_CDECL VL_GetErrorHandler(void);
V_IMPORT vl_error V_CDECL VL_GetFunctionName(vl_routine routine, LPSTR text, int bytes);
V_IMPORT vl_error V_CDECL VL_GetErrorText(vl_error error, LPSTR text, int bytes);
V_IMPORT vl_error V_CDECL VL_GetLastError(vl_error *error, vl_routine *routine,
    int *exterr);

#ifdef __cplusplus
}
#endif

#endif
