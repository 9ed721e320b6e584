/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * quark.h: Quark 3D, the integer 3D library of the Pocket PC, for C++.
 *
 * Classes, members, constants and functions have the documented names, types
 * and order. They call libquark3d, whose C functions are declared at the end of
 * each part; programs have no need of those, but for the last part.
 *
 *     c++ -Iinclude program.cpp -lquark3d
 */
#ifndef QUARK_H
#define QUARK_H

#ifndef __cplusplus
#error "quark.h is a C++ header"
#endif

/* --- screen ------------------------------------------------------------ */

#define SCR_X 240
#define SCR_Y 320

/* Bits of intensity, red, green and blue in a word of the frame buffer: blue
 * in bits 0..2, green 3..5, red 6..7, intensity 8..12; 1/z in bits 16..31. */
#define GD_BITS 5
#define RD_BITS 2
#define GR_BITS 3
#define BL_BITS 3

/* Base colour of channels of 0..255. */
#define COLOR_RGB(R, G, B) \
    ((((R) & 0xff) >> 6 << 6) | (((G) & 0xff) >> 5 << 3) | (((B) & 0xff) >> 5))
/* An intensity of 0..255, to be joined with a base colour. */
#define COLOR_I(I) (((I) & 0xff) >> 3 << 8)

/* 1/z is scaled by two to this. */
#define INVTBL_SHIFT 22

/* Nearest and farthest z; the camera looks along -z. */
#define CLIPZ_NEAR (-64)
#define CLIPZ_FAR (-4095)

/* Texture coordinates of one repeat. */
#define UV_MUL 256

enum eDrawMode
{
    DRAW_OPAQUE = 0,
    DRAW_KEYED,
    DRAW_ALPHA,
    DRAW_ALPHAKEYED
};

enum eTriangleMode
{
    TRI_NZC = 0,
    TRI_ZC,
    TRI_UT,
    TRI_WF
};

enum eErrorCode
{
    ERR_NONE = 0,
    ERR_MEM = 1,
    ERR_TMEM = 2,
    ERR_UV = 3,
    ERR_VFMT = 4,
    ERR_IFMT = 5,
    ERR_DUPI = 6,
    ERR_DUPUV = 7,
    ERR_F32 = 0x7fffffff
};

class CTexture;
class CMatrix;
class CTriangleList;
class CVGpu;
struct TRasterState;
struct TVertex;

/* --- textures ---------------------------------------------------------- */

extern "C" int quark_texture_init(CTexture *texture, const unsigned char *texels, int x, int y,
                                  int key);

/* Base colours, one byte a texel. */
class CTexture
{
public:
    int SizeX;
    int SizeY;
    unsigned char *Texels;
    unsigned int DrawMaskX;
    unsigned int DrawMaskY;

    /* Copies x * y base colours; those equal to CKey become 0, the colour that
     * keyed modes leave out; a CKey outside 0..255 is none. Returns 1 where
     * triangles can use it: both sides powers of two from 16 to 128. */
    int Init(unsigned char *RGB8, int x, int y, int CKey)
    {
        return quark_texture_init(this, RGB8, x, y, CKey);
    }
};

/* --- states and vertices ----------------------------------------------- */

struct TRasterState
{
    unsigned char DrawMode;
    unsigned char DrawColor;
    unsigned char DrawIntensity;
    unsigned char TestCulling;
    unsigned char ZSort;
    unsigned char al[3];
    CTexture *Texture;
};

struct TVertex
{
    int x, y, z;
    int m;
    int i;
    int u, v;
};

enum eVextexFormat
{
    VF_XYZ = 0,
    VF_I = 1,
    VF_UV = 2
};

enum eIndexFormat
{
    IF_ABC = 0,
    IF_I = 1,
    IF_C = 2,
    IF_UV = 4
};

/* --- triangle lists ---------------------------------------------------- */

extern "C" {
int quark_list_init(CTriangleList *list, int vertex_format, int vertices, int index_format,
                    int triangles, TRasterState *states);
int quark_list_weld(CTriangleList *list, int position, int intensity, int uv);
int quark_list_build_commands(CTriangleList *list, const unsigned short *states);
int quark_list_face_normals(const CTriangleList *list, short *normals, int stride);
int quark_list_vertex_normals(const CTriangleList *list, short *normals, int stride);
void quark_list_delete(CTriangleList *list);
void quark_list_set_abc(CTriangleList *list, int index, const unsigned short *abc);
void quark_list_set_xyz(CTriangleList *list, int index, const short *xyz);
void quark_list_set_uv(CTriangleList *list, int index, const short *uv);
void quark_list_set_i(CTriangleList *list, int index, int intensity);
void quark_list_set_c(CTriangleList *list, int index, int color);
void quark_list_get_abc(const CTriangleList *list, int index, int *abc);
void quark_list_get_xyz(const CTriangleList *list, int index, int *xyz);
void quark_list_get_uv(const CTriangleList *list, int index, int *uv);
int quark_list_get_i(const CTriangleList *list, int index);
int quark_list_get_c(const CTriangleList *list, int index);
}

class CTriangleList
{
public:
    short *VertexList;
    int VertexListSize;
    int VertexStride;

    unsigned short *IndexList;
    int IndexListSize;
    int IndexStride;

    int VuOfs;
    int ViOfs;
    int IuOfs;
    int IiOfs;
    int IcOfs;

    TRasterState *State;

    unsigned short CmdMin[2];
    unsigned short *CmdList;
    int CmdListSize;

    eErrorCode ErrorCode;

    int Init(int VFormat, int VCount, int IFormat, int ICount, TRasterState *StateList)
    {
        return quark_list_init(this, VFormat, VCount, IFormat, ICount, StateList);
    }
    int WeldVertex(int WpDelta, int WiDelta, int WuvDelta)
    {
        return quark_list_weld(this, WpDelta, WiDelta, WuvDelta);
    }
    int BuildCmdList(const unsigned short *StateIdList)
    {
        return quark_list_build_commands(this, StateIdList);
    }
    int BuildFNormalList(short *NList, int Stride16) const
    {
        return quark_list_face_normals(this, NList, Stride16);
    }
    int BuildVNormalList(short *NList, int Stride16) const
    {
        return quark_list_vertex_normals(this, NList, Stride16);
    }
    void Delete(void) { quark_list_delete(this); }

    void SetABC(int Index, const unsigned short *ABC) { quark_list_set_abc(this, Index, ABC); }
    void SetXYZ(int Index, const short *XYZ) { quark_list_set_xyz(this, Index, XYZ); }
    void SetUV(int Index, const short *UV) { quark_list_set_uv(this, Index, UV); }
    void SetI(int Index, int Intensity) { quark_list_set_i(this, Index, Intensity); }
    void SetC(int Index, int Color) { quark_list_set_c(this, Index, Color); }

    void GetABC(int Index, int *ABC) const { quark_list_get_abc(this, Index, ABC); }
    void GetXYZ(int Index, int *XYZ) const { quark_list_get_xyz(this, Index, XYZ); }
    void GetUV(int Index, int *UV) const { quark_list_get_uv(this, Index, UV); }
    int GetI(int Index) const { return quark_list_get_i(this, Index); }
    int GetC(int Index) const { return quark_list_get_c(this, Index); }
};

/* --- mathematics ------------------------------------------------------- */

#define ANGLE_SHIFT 13
#define ANGLE2PI (1 << ANGLE_SHIFT)
/* Degrees as an angle; wraps beyond 46080 degrees. */
#define DEGREE(a) ((int)((unsigned int)(a) * 46603u) >> 11)

#define TRIGO_SHIFT 14
#define TRIGO_MUL (1 << TRIGO_SHIFT)

extern "C" {
short quark_sinus(int a);
short quark_cosinus(int a);
int quark_sqrti(int a);
int quark_atan2i(int x, int y);
int quark_log2(int a);
void quark_convert_uv(short *uv);
void quark_normalize(int *n);
void quark_def_u_normal(const int *a, const int *b, const int *c, int *n);
void quark_itoa(int a, char *text);
}

inline short SINUS(int a) { return quark_sinus(a); }
inline short COSINUS(int a) { return quark_cosinus(a); }
inline int Sqrti(int a) { return quark_sqrti(a); }
inline int Atan2i(int x, int y) { return quark_atan2i(x, y); }
inline int Log2(int a) { return quark_log2(a); }
inline void ConvertUv(short *UvSet) { quark_convert_uv(UvSet); }
inline void Normalize(int *N) { quark_normalize(N); }
inline void DefUNormal(const int *A, const int *B, const int *C, int *N)
{
    quark_def_u_normal(A, B, C, N);
}
/* Decimal; 12 bytes always suffice. */
inline void Itoa(int a, char *aStr) { quark_itoa(a, aStr); }

/* --- matrices ---------------------------------------------------------- */

extern "C" {
void quark_matrix_load_identity(CMatrix *matrix);
void quark_matrix_load(CMatrix *matrix, const CMatrix *from);
void quark_matrix_mult(CMatrix *matrix, const CMatrix *other);
void quark_matrix_translate(CMatrix *matrix, int x, int y, int z);
void quark_matrix_rotate_x(CMatrix *matrix, int a);
void quark_matrix_rotate_y(CMatrix *matrix, int a);
void quark_matrix_rotate_z(CMatrix *matrix, int a);
void quark_matrix_scale(CMatrix *matrix, int s);
void quark_matrix_transform_vector(const CMatrix *matrix, const int *from, int *to);
void quark_matrix_rotate_vector(const CMatrix *matrix, const int *from, int *to);
void quark_matrix_inv_rotate_vector(const CMatrix *matrix, const int *from, int *to);
}

/* Element (i, j) is m[i + j * 3]: right, up and direction vectors scaled by
 * TRIGO_MUL, and the position. */
class CMatrix
{
public:
    int m[12];

    void LoadIdentity(void) { quark_matrix_load_identity(this); }
    void Load(const CMatrix *Sm) { quark_matrix_load(this, Sm); }
    void Mult(const CMatrix *M2) { quark_matrix_mult(this, M2); }
    void Translate(int x, int y, int z) { quark_matrix_translate(this, x, y, z); }
    void RotateX(int a) { quark_matrix_rotate_x(this, a); }
    void RotateY(int a) { quark_matrix_rotate_y(this, a); }
    void RotateZ(int a) { quark_matrix_rotate_z(this, a); }
    void Scale(int s) { quark_matrix_scale(this, s); }
    void TransformVector(const int *Src, int *Dest)
    {
        quark_matrix_transform_vector(this, Src, Dest);
    }
    void RotateVector(const int *Src, int *Dest) { quark_matrix_rotate_vector(this, Src, Dest); }
    void InvRotateVector(const int *Src, int *Dest)
    {
        quark_matrix_inv_rotate_vector(this, Src, Dest);
    }

    int *Pos(void) { return &m[9]; }
    int *Dir(void) { return &m[6]; }
    int *Up(void) { return &m[3]; }
    int *Right(void) { return &m[0]; }
};

/* --- the virtual graphics processor ------------------------------------ */

extern "C" {
int quark_gpu_init(CVGpu *gpu, int near_clip, int far_clip, int fov);
void quark_gpu_delete(CVGpu *gpu);
int quark_gpu_set_work_memory(CVGpu *gpu, int vertices, int faces);
void quark_gpu_print_xy(CVGpu *gpu, const char *text, int x, int y);
void quark_gpu_print_fps(CVGpu *gpu, unsigned int ticks);
void quark_gpu_put_pixel(CVGpu *gpu, int x, int y, int color);
void quark_gpu_draw_line(CVGpu *gpu, const int *a, const int *b);
void quark_gpu_draw_sprite(CVGpu *gpu, int x, int y);
void quark_gpu_draw_sprite_scale(CVGpu *gpu, int x, int y, int scale);
void quark_gpu_draw_sprite_scale_zb(CVGpu *gpu, const int *top_left, const int *bottom_right,
                                    int z);
void quark_gpu_draw_triangle(CVGpu *gpu, const TVertex *a, const TVertex *b, const TVertex *c);
eErrorCode quark_gpu_draw_triangle_list(CVGpu *gpu, const CTriangleList *list);
void quark_gpu_sort_reset(CVGpu *gpu);
void quark_gpu_sort_draw(CVGpu *gpu);
void quark_gpu_flush_fb(CVGpu *gpu, unsigned int address, int clear_color);
int quark_gpu_set_fov(CVGpu *gpu, int fov);
int quark_gpu_scr_projection(CVGpu *gpu, const int *position, int *screen);
int quark_gpu_set_nf_clip(CVGpu *gpu, int near_clip, int far_clip);
int quark_gpu_clip_msk(CVGpu *gpu, const int *position);
int quark_gpu_cross_frustrum(CVGpu *gpu, const int *box);
unsigned int *quark_frame_buffer(const void *member);
}

/* The type of CVGpu::FrameBuffer: a pointer to the words of the frame buffer,
 * which are brought up to date when it is read. Once a program has read it,
 * what it writes through it is drawn, and every call costs more. */
class QuarkFrameBuffer
{
public:
    operator unsigned int *() const { return quark_frame_buffer(this); }

private:
    unsigned int *Words;
};

class CVGpu
{
public:
    TRasterState TextState;
    TRasterState LineState;
    TRasterState SpriteState;
    TRasterState *TriangleState;

    int TriangleMode;

    int Zoom;
    int ClipNear;
    int ClipFar;
    int NFrustrum[4][3];

    CMatrix *ViewMatrix;
    int FrameCounter;
    QuarkFrameBuffer FrameBuffer;

    int Init(int NearClp, int FarClp, int Fov)
    {
        return quark_gpu_init(this, NearClp, FarClp, Fov);
    }
    void Delete(void) { quark_gpu_delete(this); }
    int SetWorkMemory(int MaxVertex, int MaxFSort)
    {
        return quark_gpu_set_work_memory(this, MaxVertex, MaxFSort);
    }

    void PrintXY(const char *Str, int x, int y) { quark_gpu_print_xy(this, Str, x, y); }
    void PrintFps(unsigned int Ticks) { quark_gpu_print_fps(this, Ticks); }
    void PutPixel(int x, int y, int Color) { quark_gpu_put_pixel(this, x, y, Color); }
    void DrawLine(const int *A, const int *B) { quark_gpu_draw_line(this, A, B); }
    void DrawSprite(int x, int y) { quark_gpu_draw_sprite(this, x, y); }
    void DrawSpriteScale(int x, int y, int Scale)
    {
        quark_gpu_draw_sprite_scale(this, x, y, Scale);
    }
    void DrawSpriteScaleZb(const int *ScrTl, const int *ScrBr, int z)
    {
        quark_gpu_draw_sprite_scale_zb(this, ScrTl, ScrBr, z);
    }
    void DrawTriangle(const TVertex *A, const TVertex *B, const TVertex *C)
    {
        quark_gpu_draw_triangle(this, A, B, C);
    }
    eErrorCode DrawTriangleList(const CTriangleList *Tl)
    {
        return quark_gpu_draw_triangle_list(this, Tl);
    }

    void SortReset(void) { quark_gpu_sort_reset(this); }
    void SortDraw(void) { quark_gpu_sort_draw(this); }

    /* Shows the frame and clears the frame buffer to a base colour with its
     * intensity. VAddr is a target of quark_target below, or 0. */
    void FlushFB(unsigned int VAddr, int ClearColor)
    {
        quark_gpu_flush_fb(this, VAddr, ClearColor);
    }

    int SetFov(int Fov) { return quark_gpu_set_fov(this, Fov); }
    int ScrProjection(const int *Pos3D, int *ScrPos)
    {
        return quark_gpu_scr_projection(this, Pos3D, ScrPos);
    }
    int SetNFClip(int NearClp, int FarClp)
    {
        return quark_gpu_set_nf_clip(this, NearClp, FarClp);
    }
    int ClipMsk(const int *wPos) { return quark_gpu_clip_msk(this, wPos); }
    int CrossFrustrum(const int *Box) { return quark_gpu_cross_frustrum(this, Box); }

    int ZcErrorMax;
};

/* The document spells the class both ways. */
typedef CVGpu CVgpu;

/* --- beyond the document ----------------------------------------------- */

extern "C" {
/* Makes memory a target of CVGpu::FlushFB: 240x320 pixels of 16 bits (565),
 * the first at `base`, `right` bytes from a pixel to its right neighbour, `down`
 * bytes to its lower one; both may be negative. Returns the address to pass,
 * 0 where there are too many. The memory must stay until quark_target_delete. */
unsigned int quark_target(void *base, int right, int down);
/* Forgets a target. */
void quark_target_delete(unsigned int address);
}

#endif
