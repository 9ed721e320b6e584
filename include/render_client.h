/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * render_client.h: the client interface of the Raw 3D pipeline.
 *
 * Programs written for the interface of the thesis compile against this
 * header and link librender_client. Calls made in the wrong mode are left out
 * silently, as the interface has it: commands that only exist outside a scene
 * do nothing inside one, vertices nothing outside.
 *
 * Words: colours are rgba (red in the high byte), lights rgbi with an
 * intensity in the low byte, pixels rgbx. Matrices are rows of columns.
 */
#ifndef RENDER_CLIENT_H
#define RENDER_CLIENT_H

/* What programs of the time got with this header. */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif

/* How colour and texture are combined. */
#define R_TEXMODE_NONE 0
#define R_TEXMODE_COLOR 1
#define R_TEXMODE_TEXTURE 2
#define R_TEXMODE_BLEND 3
#define R_TEXMODE_TEXDECAL 4
#define R_TEXMODE_COLDECAL 5
#define R_TEXMODE_MODULATE 6

/* How an alpha channel is used: not at all, as it is, by threshold. */
#define R_ALPHA_NONE 0
#define R_ALPHA_SOFT 1
#define R_ALPHA_HARD 2

/* Texture coordinates outside 0 to 1. */
#define R_TEXTILE_NONE 0
#define R_TEXTILE_REPEAT 1
#define R_TEXTILE_MIRROR 2
#define R_TEXTILE_CLAMP 3

/* Page masks; the page of a read is 0 for back, 1 for front. */
#define R_PAGE_NONE 0
#define R_PAGE_BACK 1
#define R_PAGE_FRONT 2
#define R_PAGE_BOTH 3

/* Opcodes of the command stream. */
#define RENDER_BEGINSCENE 1
#define RENDER_ENDSCENE 2
#define RENDER_VERTEX 3
#define RENDER_COLOR 4
#define RENDER_MODELMATRIX 5
#define RENDER_VIEWMATRIX 6
#define RENDER_NORMAL 7
#define RENDER_SET_LIT 8
#define RENDER_SET_USEAMB 9
#define RENDER_SET_USEDIR 10
#define RENDER_SET_TEXMODE 11
#define RENDER_SET_TEXALPHA 12
#define RENDER_SET_COLALPHA 13
#define RENDER_SET_COLINTERP 14
#define RENDER_SET_LITINTERP 15
#define RENDER_SET_TEXINTERP 16
#define RENDER_SET_OUTOFORDER 17
#define RENDER_SET_TEXTILE 18
#define RENDER_SET_NOUSEZ 19
#define RENDER_SET_NOWRITEZ 20
#define RENDER_SET_TEXTUREID 21
#define RENDER_COLTEXBALANCE 22
#define RENDER_ALPHATHRESH 23
#define RENDER_AMBCOLOR 24
#define RENDER_DIRCOLOR 25
#define RENDER_DIRLIGHT 26
#define RENDER_AMBREFLECT 27
#define RENDER_DIRREFLECT 28
#define RENDER_CLEARFB 29
#define RENDER_CLEARZ 30
#define RENDER_SETPAGE 31
#define RENDER_FLIPPAGE 32
#define RENDER_ALLOCATE_TEXTURE 33
#define RENDER_DEALLOC_TEXTURE 34
#define RENDER_UPLOAD_TEXTURE 35
#define RENDER_TEXMEM_AVAIL 36
#define RENDER_COMPACT_TEXMEM 37
#define RENDER_WRITE_FB 38
#define RENDER_WRITE_FB_BLOCK 39
#define RENDER_READ_FB 40
#define RENDER_READ_FB_BLOCK 41
#define RENDER_WRITE_Z 42
#define RENDER_WRITE_Z_BLOCK 43
#define RENDER_READ_Z 44
#define RENDER_READ_Z_BLOCK 45
#define RENDER_RESET 46
#define RENDER_HALT 47

/* Beyond the thesis, from here on all names begin with RX: what vertices make
 * up, what happens at the borders of the view, how texture levels are used. */
#define RX_PRIM_TRIANGLE 0
#define RX_PRIM_TRIANGLES 1
#define RX_PRIM_STRIP 2
#define RX_PRIM_FAN 3
#define RX_PRIM_LINES 4
#define RX_PRIM_LINESTRIP 5
#define RX_PRIM_POINTS 6
#define RX_CLIP_DROP 0
#define RX_CLIP_NEAR 1
#define RX_CLIP_FRUSTUM 2
#define RX_MIPMAP_OFF 0
#define RX_MIPMAP_NEAREST 1
#define RX_MIPMAP_BLEND 2
#define RX_MAX_STORED 4096
#define RENDERX_SET_PRIMITIVE 64
#define RENDERX_SET_CLIP 65
#define RENDERX_SET_MIPMAP 66
#define RENDERX_SET_POINTSIZE 67
#define RENDERX_STORE_VERTEX 68
#define RENDERX_INDEX 69
#define RENDERX_LIGHT 70
#define RENDERX_SPECULAR 71
#define RENDERX_EYE 72
#define RENDERX_ALLOCATE_MIPMAPPED 73
#define RENDERX_MAKE_MIPMAPS 74
#define RENDERX_RESIZE 75

/* The client's own state. RUpdateMatrices sends projection times camera. */
extern unsigned g_RInSceneStream;
extern float g_RPerspective[4][4];
extern float g_RCamera[4][4];

/* Words and records, as they are. Reading gives 0 at the end of the stream. */
void RSendPVal(void *val);
void RSendUnsigned(unsigned val);
void RSendSigned(signed val);
void RSendFloat(float val);
unsigned RReadUnsigned(void);
signed RReadSigned(void);
float RReadFloat(void);
void RSendMeta(const char *val);
void RMETAHalt(void);
void RMETAWait(void);
void RMETADebug(void);
void RMETARead(unsigned num);

/* Scenes and primitives: three vertices between begin and end. */
void RInit(void);
void RBeginScene(void);
void RBeginPrim(void);
void REndPrim(void);
void REndScene(void);
void RVertex(float x, float y, float z, float u, float v);
void RColorRGBA(unsigned rgba);
void RColor(unsigned R, unsigned G, unsigned B, unsigned A);
void RNormal(float x, float y, float z);

/* Matrices. */
void RModelMatrix(float M[4][4]);
void RViewMatrix(float M[4][4]);
void MatrixMult(float X[4][4], float M[4][4], float Y[4][4]);
void RUpdateMatrices(void);
void RSetProjMatrix(float M[4][4]);
void RProjMatrix(float l, float r, float t, float b, float n, float f);
void RProjMatrixUV(float u, float v, float n, float f);
void ROrthMatrix(float l, float r, float t, float b, float n, float f);
void RCameraMatrix(float VRP[3], float FP[3], float UP[3]);

/* Modes. */
void RSetLit(unsigned val);
void RSetUseAmb(unsigned val);
void RSetUseDir(unsigned val);
void RSetTexMode(unsigned val);
void RSetTexAlpha(unsigned val);
void RSetColAlpha(unsigned val);
void RSetColInterp(unsigned val);
void RSetLitInterp(unsigned val);
void RSetTexInterp(unsigned val);
void RSetOutOfOrder(unsigned val);
void RSetTexTile(unsigned val);
void RSetNoUseZ(unsigned val);
void RSetNoWriteZ(unsigned val);
void RSetTextureID(unsigned val);
void RColTexBalance(float val);
void RAlphaThresh(unsigned val);

/* Light. */
void RAmbColorRGBI(unsigned rgbi);
void RAmbColor(unsigned R, unsigned G, unsigned B, unsigned I);
void RDirColorRGBI(unsigned rgbi);
void RDirColor(unsigned R, unsigned G, unsigned B, unsigned I);
void RDirLight(float x, float y, float z);
void RAmbReflect(unsigned val);
void RDirReflect(unsigned val);

/* Outside scenes only: frame buffer, textures, memory. */
void RClearFBRGBX(unsigned page, unsigned rgbx);
void RClearFB(unsigned page, unsigned R, unsigned G, unsigned B);
void RClearZ(void);
void RSetPage(unsigned page);
void RFlipPage(unsigned wait);
int RAllocateTexture(unsigned width, unsigned height);
void RDeallocTexture(int id);
void RUploadTexture(int id, unsigned n, unsigned *data);
unsigned RTexMemAvail(void);
void RCompactTexMem(void);
void RWriteFBRGBX(unsigned x, unsigned y, unsigned page, unsigned rgbx);
void RWriteFB(unsigned x, unsigned y, unsigned page, unsigned R, unsigned G, unsigned B);
void RWriteFBBlock(unsigned x, unsigned y, unsigned page, unsigned n, unsigned *data);
unsigned RReadFB(unsigned x, unsigned y, unsigned page);
void RReadFBBlock(unsigned x, unsigned y, unsigned page, unsigned n, unsigned *data);
void RWriteZ(unsigned x, unsigned y, signed z);
void RWriteZBlock(unsigned x, unsigned y, unsigned n, signed *data);
signed RReadZ(unsigned x, unsigned y);
void RReadZBlock(unsigned x, unsigned y, unsigned page, unsigned n, signed *data);
void RReset(void);
void RHalt(void);

/* Beyond the thesis. A primitive may have up to 4096 vertices and is cut where
 * it leaves the view if so asked; lights 1 to 7 come beside the first; stored
 * vertices keep the colour and normal of their time. */
void RXSetPrimitive(unsigned kind);
void RXSetClip(unsigned planes);
void RXSetMipMap(unsigned mode);
void RXSetPointSize(unsigned pixels);
void RXStoreVertex(unsigned index, float x, float y, float z, float u, float v);
void RXIndex(unsigned index);
void RXLight(unsigned number, unsigned rgbi, float x, float y, float z);
void RXSpecular(unsigned rgbi, unsigned exponent);
void RXEye(float x, float y, float z);
int RXAllocateMipMapped(unsigned width, unsigned height);
void RXMakeMipMaps(int id);
void RXResize(unsigned width, unsigned height);
void RXAsyncReset(void);

#ifdef __cplusplus
}
#endif

#endif
