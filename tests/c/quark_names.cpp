/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * quark_names.cpp: every name of the document with its value, its type, and,
 * for members, its place. What does not hold does not compile.
 */
#include <stddef.h>

#include <quark.h>

#define VALUE(name, value) static_assert((name) == (value), #name)

VALUE(SCR_X, 240);
VALUE(SCR_Y, 320);
VALUE(GD_BITS, 5);
VALUE(RD_BITS, 2);
VALUE(GR_BITS, 3);
VALUE(BL_BITS, 3);
VALUE(COLOR_RGB(255, 255, 0), 0xf8);
VALUE(COLOR_RGB(63, 31, 31), 0);
VALUE(COLOR_RGB(64, 32, 32), 0x49);
VALUE(COLOR_I(128), 0x1000);
VALUE(COLOR_I(255), 0x1f00);
VALUE(COLOR_RGB(255, 255, 0) | COLOR_I(128), 0x10f8);
VALUE(CLIPZ_NEAR, -64);
VALUE(CLIPZ_FAR, -4095);
VALUE(UV_MUL, 256);
VALUE(INVTBL_SHIFT, 22);
VALUE(ANGLE_SHIFT, 13);
VALUE(ANGLE2PI, 8192);
VALUE(DEGREE(45), 1023);
VALUE(DEGREE(360), 8191);
VALUE(DEGREE(-90), -2048);
VALUE(TRIGO_SHIFT, 14);
VALUE(TRIGO_MUL, 16384);
VALUE(DRAW_OPAQUE, 0);
VALUE(DRAW_KEYED, 1);
VALUE(DRAW_ALPHA, 2);
VALUE(DRAW_ALPHAKEYED, 3);
VALUE(TRI_NZC, 0);
VALUE(TRI_ZC, 1);
VALUE(TRI_UT, 2);
VALUE(TRI_WF, 3);
VALUE(ERR_NONE, 0);
VALUE(ERR_MEM, 1);
VALUE(ERR_TMEM, 2);
VALUE(ERR_UV, 3);
VALUE(ERR_VFMT, 4);
VALUE(ERR_IFMT, 5);
VALUE(ERR_DUPI, 6);
VALUE(ERR_DUPUV, 7);
VALUE(ERR_F32, 0x7fffffff);
VALUE(VF_XYZ, 0);
VALUE(VF_I, 1);
VALUE(VF_UV, 2);
VALUE(IF_ABC, 0);
VALUE(IF_I, 1);
VALUE(IF_C, 2);
VALUE(IF_UV, 4);
static_assert(sizeof(eDrawMode) == 4 && sizeof(eTriangleMode) == 4 && sizeof(eErrorCode) == 4
              && sizeof(eVextexFormat) == 4 && sizeof(eIndexFormat) == 4, "enums of 32 bits");

template <typename A, typename B> struct Same { enum { value = 0 }; };
template <typename A> struct Same<A, A> { enum { value = 1 }; };

/* A member's type, and that it lies behind the one before. */
#define MEMBER(owner, name, type) \
    static_assert(Same<decltype(owner::name), type>::value, #owner "::" #name)
#define AFTER(owner, name, before) \
    static_assert(offsetof(owner, name) >= offsetof(owner, before) + sizeof(owner::before), \
                  #owner "::" #name)
/* A function's type. */
#define METHOD(owner, name, ...) \
    static_assert(Same<decltype(&owner::name), __VA_ARGS__>::value, #owner "::" #name)

MEMBER(CTexture, SizeX, int);
MEMBER(CTexture, SizeY, int);
MEMBER(CTexture, Texels, unsigned char *);
MEMBER(CTexture, DrawMaskX, unsigned int);
MEMBER(CTexture, DrawMaskY, unsigned int);
AFTER(CTexture, SizeY, SizeX);
AFTER(CTexture, Texels, SizeY);
AFTER(CTexture, DrawMaskX, Texels);
AFTER(CTexture, DrawMaskY, DrawMaskX);
METHOD(CTexture, Init, int (CTexture::*)(unsigned char *, int, int, int));
static_assert(sizeof(CTexture) == 16 + sizeof(void *), "CTexture");

MEMBER(TRasterState, DrawMode, unsigned char);
MEMBER(TRasterState, DrawColor, unsigned char);
MEMBER(TRasterState, DrawIntensity, unsigned char);
MEMBER(TRasterState, TestCulling, unsigned char);
MEMBER(TRasterState, ZSort, unsigned char);
MEMBER(TRasterState, al, unsigned char[3]);
MEMBER(TRasterState, Texture, CTexture *);
VALUE(offsetof(TRasterState, DrawMode), 0);
VALUE(offsetof(TRasterState, DrawColor), 1);
VALUE(offsetof(TRasterState, DrawIntensity), 2);
VALUE(offsetof(TRasterState, TestCulling), 3);
VALUE(offsetof(TRasterState, ZSort), 4);
VALUE(offsetof(TRasterState, al), 5);
VALUE(offsetof(TRasterState, Texture), 8);
static_assert(sizeof(TRasterState) == 8 + sizeof(void *), "TRasterState");

MEMBER(TVertex, x, int);
MEMBER(TVertex, y, int);
MEMBER(TVertex, z, int);
MEMBER(TVertex, m, int);
MEMBER(TVertex, i, int);
MEMBER(TVertex, u, int);
MEMBER(TVertex, v, int);
VALUE(offsetof(TVertex, y), 4);
VALUE(offsetof(TVertex, z), 8);
VALUE(offsetof(TVertex, m), 12);
VALUE(offsetof(TVertex, i), 16);
VALUE(offsetof(TVertex, u), 20);
VALUE(offsetof(TVertex, v), 24);
static_assert(sizeof(TVertex) == 28, "TVertex");

MEMBER(CTriangleList, VertexList, short *);
MEMBER(CTriangleList, VertexListSize, int);
MEMBER(CTriangleList, VertexStride, int);
MEMBER(CTriangleList, IndexList, unsigned short *);
MEMBER(CTriangleList, IndexListSize, int);
MEMBER(CTriangleList, IndexStride, int);
MEMBER(CTriangleList, VuOfs, int);
MEMBER(CTriangleList, ViOfs, int);
MEMBER(CTriangleList, IuOfs, int);
MEMBER(CTriangleList, IiOfs, int);
MEMBER(CTriangleList, IcOfs, int);
MEMBER(CTriangleList, State, TRasterState *);
MEMBER(CTriangleList, CmdMin, unsigned short[2]);
MEMBER(CTriangleList, CmdList, unsigned short *);
MEMBER(CTriangleList, CmdListSize, int);
MEMBER(CTriangleList, ErrorCode, eErrorCode);
AFTER(CTriangleList, VertexListSize, VertexList);
AFTER(CTriangleList, VertexStride, VertexListSize);
AFTER(CTriangleList, IndexList, VertexStride);
AFTER(CTriangleList, IndexListSize, IndexList);
AFTER(CTriangleList, IndexStride, IndexListSize);
AFTER(CTriangleList, VuOfs, IndexStride);
AFTER(CTriangleList, ViOfs, VuOfs);
AFTER(CTriangleList, IuOfs, ViOfs);
AFTER(CTriangleList, IiOfs, IuOfs);
AFTER(CTriangleList, IcOfs, IiOfs);
AFTER(CTriangleList, State, IcOfs);
AFTER(CTriangleList, CmdMin, State);
AFTER(CTriangleList, CmdList, CmdMin);
AFTER(CTriangleList, CmdListSize, CmdList);
AFTER(CTriangleList, ErrorCode, CmdListSize);
METHOD(CTriangleList, Init, int (CTriangleList::*)(int, int, int, int, TRasterState *));
METHOD(CTriangleList, WeldVertex, int (CTriangleList::*)(int, int, int));
METHOD(CTriangleList, BuildCmdList, int (CTriangleList::*)(const unsigned short *));
METHOD(CTriangleList, BuildFNormalList, int (CTriangleList::*)(short *, int) const);
METHOD(CTriangleList, BuildVNormalList, int (CTriangleList::*)(short *, int) const);
METHOD(CTriangleList, Delete, void (CTriangleList::*)());
METHOD(CTriangleList, SetABC, void (CTriangleList::*)(int, const unsigned short *));
METHOD(CTriangleList, SetXYZ, void (CTriangleList::*)(int, const short *));
METHOD(CTriangleList, SetUV, void (CTriangleList::*)(int, const short *));
METHOD(CTriangleList, SetI, void (CTriangleList::*)(int, int));
METHOD(CTriangleList, SetC, void (CTriangleList::*)(int, int));
METHOD(CTriangleList, GetABC, void (CTriangleList::*)(int, int *) const);
METHOD(CTriangleList, GetXYZ, void (CTriangleList::*)(int, int *) const);
METHOD(CTriangleList, GetUV, void (CTriangleList::*)(int, int *) const);
METHOD(CTriangleList, GetI, int (CTriangleList::*)(int) const);
METHOD(CTriangleList, GetC, int (CTriangleList::*)(int) const);

static_assert(Same<decltype(&SINUS), short (*)(int)>::value, "SINUS");
static_assert(Same<decltype(&COSINUS), short (*)(int)>::value, "COSINUS");
static_assert(Same<decltype(&Sqrti), int (*)(int)>::value, "Sqrti");
static_assert(Same<decltype(&Atan2i), int (*)(int, int)>::value, "Atan2i");
static_assert(Same<decltype(&Log2), int (*)(int)>::value, "Log2");
static_assert(Same<decltype(&ConvertUv), void (*)(short *)>::value, "ConvertUv");
static_assert(Same<decltype(&Normalize), void (*)(int *)>::value, "Normalize");
static_assert(
    Same<decltype(&DefUNormal), void (*)(const int *, const int *, const int *, int *)>::value,
    "DefUNormal");
static_assert(Same<decltype(&Itoa), void (*)(int, char *)>::value, "Itoa");

MEMBER(CMatrix, m, int[12]);
static_assert(sizeof(CMatrix) == 48, "CMatrix");
METHOD(CMatrix, LoadIdentity, void (CMatrix::*)());
METHOD(CMatrix, Load, void (CMatrix::*)(const CMatrix *));
METHOD(CMatrix, Mult, void (CMatrix::*)(const CMatrix *));
METHOD(CMatrix, Translate, void (CMatrix::*)(int, int, int));
METHOD(CMatrix, RotateX, void (CMatrix::*)(int));
METHOD(CMatrix, RotateY, void (CMatrix::*)(int));
METHOD(CMatrix, RotateZ, void (CMatrix::*)(int));
METHOD(CMatrix, Scale, void (CMatrix::*)(int));
METHOD(CMatrix, TransformVector, void (CMatrix::*)(const int *, int *));
METHOD(CMatrix, RotateVector, void (CMatrix::*)(const int *, int *));
METHOD(CMatrix, InvRotateVector, void (CMatrix::*)(const int *, int *));
METHOD(CMatrix, Pos, int *(CMatrix::*)());
METHOD(CMatrix, Dir, int *(CMatrix::*)());
METHOD(CMatrix, Up, int *(CMatrix::*)());
METHOD(CMatrix, Right, int *(CMatrix::*)());

MEMBER(CVGpu, TextState, TRasterState);
MEMBER(CVGpu, LineState, TRasterState);
MEMBER(CVGpu, SpriteState, TRasterState);
MEMBER(CVGpu, TriangleState, TRasterState *);
MEMBER(CVGpu, TriangleMode, int);
MEMBER(CVGpu, Zoom, int);
MEMBER(CVGpu, ClipNear, int);
MEMBER(CVGpu, ClipFar, int);
MEMBER(CVGpu, NFrustrum, int[4][3]);
MEMBER(CVGpu, ViewMatrix, CMatrix *);
MEMBER(CVGpu, FrameCounter, int);
MEMBER(CVGpu, ZcErrorMax, int);
/* A pointer that brings itself up to date when it is read. */
static_assert(sizeof(CVGpu::FrameBuffer) == sizeof(unsigned int *), "FrameBuffer");
AFTER(CVGpu, LineState, TextState);
AFTER(CVGpu, SpriteState, LineState);
AFTER(CVGpu, TriangleState, SpriteState);
AFTER(CVGpu, TriangleMode, TriangleState);
AFTER(CVGpu, Zoom, TriangleMode);
AFTER(CVGpu, ClipNear, Zoom);
AFTER(CVGpu, ClipFar, ClipNear);
AFTER(CVGpu, NFrustrum, ClipFar);
AFTER(CVGpu, ViewMatrix, NFrustrum);
AFTER(CVGpu, FrameCounter, ViewMatrix);
AFTER(CVGpu, FrameBuffer, FrameCounter);
AFTER(CVGpu, ZcErrorMax, FrameBuffer);
METHOD(CVGpu, Init, int (CVGpu::*)(int, int, int));
METHOD(CVGpu, Delete, void (CVGpu::*)());
METHOD(CVGpu, SetWorkMemory, int (CVGpu::*)(int, int));
METHOD(CVGpu, PrintFps, void (CVGpu::*)(unsigned int));
METHOD(CVGpu, PutPixel, void (CVGpu::*)(int, int, int));
METHOD(CVGpu, DrawSprite, void (CVGpu::*)(int, int));
METHOD(CVGpu, DrawSpriteScale, void (CVGpu::*)(int, int, int));
METHOD(CVGpu, DrawSpriteScaleZb, void (CVGpu::*)(const int *, const int *, int));
METHOD(CVGpu, DrawTriangleList, eErrorCode (CVGpu::*)(const CTriangleList *));
METHOD(CVGpu, SortReset, void (CVGpu::*)());
METHOD(CVGpu, SortDraw, void (CVGpu::*)());
METHOD(CVGpu, FlushFB, void (CVGpu::*)(unsigned int, int));
METHOD(CVGpu, SetFov, int (CVGpu::*)(int));
METHOD(CVGpu, ScrProjection, int (CVGpu::*)(const int *, int *));
METHOD(CVGpu, SetNFClip, int (CVGpu::*)(int, int));
METHOD(CVGpu, ClipMsk, int (CVGpu::*)(const int *));
METHOD(CVGpu, CrossFrustrum, int (CVGpu::*)(const int *));
static_assert(Same<CVgpu, CVGpu>::value, "both spellings");

/* Documented without const; ours take constants as well. */
static void call_as_documented(CVGpu *gpu, char *text, int *a, int *b, TVertex *v)
{
    gpu->PrintXY(text, 0, 0);
    gpu->DrawLine(a, b);
    gpu->DrawTriangle(v, v, v);
}

int main()
{
    char text[] = "x";
    int point[3] = {0, 0, 100};
    TVertex vertex = {0, 0, 100, 0, 0, 0, 0};
    CVGpu gpu;

    gpu.Init(-64, -4095, 60);
    call_as_documented(&gpu, text, point, point, &vertex);
    gpu.Delete();
    return 0;
}
