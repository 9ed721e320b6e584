/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * quark_document.cpp: what the document promises, call by call, as a program
 * sees it.
 */
#include <stdio.h>
#include <string.h>

#include <quark.h>

static int failures = 0;

#define CHECK(condition) \
    do { \
        if (!(condition)) { \
            printf("line %d: %s\n", __LINE__, #condition); \
            failures++; \
        } \
    } while (0)

static TRasterState plain(int color)
{
    TRasterState state;

    memset(&state, 0, sizeof state);
    state.DrawColor = (unsigned char)color;
    state.DrawIntensity = 255;
    state.TestCulling = 1;
    return state;
}

static void check_maths()
{
    int vector[3] = {3, 0, 4}, a[3] = {0, 0, 0}, b[3] = {10, 0, 0}, c[3] = {0, 10, 0};
    short uv[6] = {515, -1, 800, 300, 600, 40};
    char text[16];

    CHECK(SINUS(2048) == 16384 && SINUS(-2048) == -16384 && SINUS(8192) == 0);
    CHECK(COSINUS(0) == 16384 && COSINUS(4096) == -16384);
    CHECK(Sqrti(1000000) == 1000);
    CHECK(Atan2i(0, 5) == 2048 && Atan2i(-5, 0) == 4096 && Atan2i(5, -5) == -1024);
    CHECK(Log2(256) == 8 && Log2(255) == 7);
    ConvertUv(uv);
    CHECK(uv[0] == 3 && uv[2] == 288 && uv[4] == 88 && uv[1] == 255);
    Normalize(vector);
    CHECK(vector[0] == 9830 && vector[1] == 0 && vector[2] == 13107);
    DefUNormal(a, b, c, vector);
    CHECK(vector[0] == 0 && vector[1] == 0 && vector[2] == 100);
    Itoa(-2147483647 - 1, text);
    CHECK(strcmp(text, "-2147483648") == 0);
}

static void check_matrix()
{
    CMatrix m, other;
    int v[3] = {100, 0, 0}, out[3];

    m.LoadIdentity();
    CHECK(m.m[0] == 16384 && m.m[4] == 16384 && m.m[8] == 16384 && m.m[9] == 0);
    m.Translate(1, 2, 3);
    CHECK(m.Pos()[0] == 1 && m.Pos()[1] == 2 && m.Pos()[2] == 3);
    m.RotateZ(2048);
    m.RotateVector(v, out);
    CHECK(out[0] == 0 && out[1] == 100 && out[2] == 0);
    m.TransformVector(v, out);
    CHECK(out[0] == 1 && out[1] == 102 && out[2] == 3);
    m.InvRotateVector(out, out);
    CHECK(out[0] == 102 && out[1] == -1);
    m.Scale(512);
    CHECK(m.Right()[1] == 32768 && m.Up()[0] == -32768 && m.Dir()[2] == 32768);
    other.Load(&m);
    CHECK(memcmp(&m, &other, sizeof m) == 0);
    other.LoadIdentity();
    other.Mult(&m);
    CHECK(memcmp(&m, &other, sizeof m) == 0);
    other.LoadIdentity();
    other.RotateX(2048);
    CHECK(other.Up()[2] == 16384);
    other.LoadIdentity();
    other.RotateY(2048);
    CHECK(other.Dir()[0] == 16384);
}

static void check_lists()
{
    static TRasterState states[3] = {plain(1), plain(2), plain(3)};
    static const short at[4][3] = {{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {9, 0, 0}};
    static const unsigned short faces[3][3] = {{0, 1, 2}, {2, 1, 0}, {0, 1, 3}};
    static const unsigned short ids[3] = {2, 1, 0};
    short uv[6] = {300, 0, 400, 0, 300, 9}, normals[4 * 3];
    int numbers[6];
    CTriangleList list;

    CHECK(list.Init(VF_XYZ | VF_I, 4, IF_ABC | IF_C | IF_UV, 3, states) == 1);
    CHECK(list.VertexStride == 4 && list.ViOfs == 3 && list.VuOfs == 0);
    CHECK(list.IndexStride == 10 && list.IcOfs == 3 && list.IuOfs == 4 && list.IiOfs == 0);
    CHECK(list.CmdList == list.CmdMin && list.CmdListSize == 1);
    CHECK(list.CmdMin[0] == 3 && list.CmdMin[1] == 0 && list.State == states);
    for (int i = 0; i < 4; i++) {
        list.SetXYZ(i, at[i]);
        list.SetI(i, 100 + i);
    }
    for (int i = 0; i < 3; i++) {
        list.SetABC(i, faces[i]);
        list.SetC(i, 7 + i);
        list.SetUV(i, uv);
    }
    CHECK(list.VertexList[1 * list.VertexStride] == 9);
    CHECK(list.VertexList[2 * list.VertexStride + list.ViOfs] == 102 && list.GetI(2) == 102);
    CHECK(list.GetC(1) == 8 && list.IndexList[10 + 3] == 8);
    list.GetABC(1, numbers);
    CHECK(numbers[0] == 2 && numbers[1] == 1 && numbers[2] == 0);
    list.GetXYZ(1, numbers);
    CHECK(numbers[0] == 9 && numbers[1] == 0);
    list.GetUV(0, numbers);
    CHECK(numbers[0] == 300 && numbers[2] == 400 && numbers[5] == 9);

    CHECK(list.WeldVertex(0, 255, 0) == 1 && list.VertexListSize == 3 && list.GetI(1) == 102);
    CHECK(list.BuildCmdList(ids) == 1);
    /* The third face has the same corner twice now. */
    CHECK(list.IndexListSize == 2 && list.CmdListSize == 2 && list.CmdList != list.CmdMin);
    CHECK(list.CmdList[0] == 1 && list.CmdList[1] == 1 && list.CmdList[2] == 1
          && list.CmdList[3] == 2);
    list.GetUV(0, numbers);
    CHECK(numbers[0] == 44 && numbers[2] == 144);
    CHECK(list.BuildFNormalList(normals, 4) == 1);
    CHECK(normals[2] == -16384 && normals[4 + 2] == 16384);
    CHECK(list.BuildVNormalList(normals, 3) == 1 && normals[0] == 0 && normals[2] == 0);
    list.Delete();
    CHECK(list.VertexList == 0 && list.IndexList == 0 && list.CmdListSize == 0);
    list.Delete();

    CHECK(list.Init(4, 1, 0, 1, states) == 0 && list.ErrorCode == ERR_VFMT);
    CHECK(list.Init(0, 1, 8, 1, states) == 0 && list.ErrorCode == ERR_IFMT);
    CHECK(list.Init(VF_I, 1, IF_I, 1, states) == 0 && list.ErrorCode == ERR_DUPI);
    CHECK(list.Init(VF_UV, 1, IF_UV, 1, states) == 0 && list.ErrorCode == ERR_DUPUV);
    CHECK(list.Init(0, -1, 0, 1, states) == 0 && list.ErrorCode == ERR_MEM);
}

static void check_camera(CVGpu *gpu)
{
    int at[3] = {100, 50, -120}, screen[3] = {7, 7, 7}, box[8][3];

    CHECK(gpu->SetFov(90) == 1024 && gpu->Zoom == 120);
    CHECK(gpu->NFrustrum[2][0] == 11585 && gpu->NFrustrum[2][2] == -11585);
    CHECK(gpu->SetFov(7) == 0 && gpu->SetFov(121) == 0 && gpu->Zoom == 120);
    CHECK(gpu->ScrProjection(at, screen) == 0);
    CHECK(screen[0] == 220 && screen[1] == 110 && screen[2] == 120);
    at[2] = -63;
    screen[0] = 7;
    CHECK(gpu->ScrProjection(at, screen) == 32 && screen[0] == 7);
    CHECK(gpu->SetNFClip(-100, -1000) == 1 && gpu->ClipNear == -100 && gpu->ClipFar == -1000);
    CHECK(gpu->SetNFClip(-63, -1000) == 0 && gpu->SetNFClip(-64, -4096) == 0);
    CHECK(gpu->SetNFClip(-500, -400) == 0 && gpu->ClipNear == -100);
    at[0] = at[1] = 0;
    at[2] = -1001;
    CHECK(gpu->ClipMsk(at) == 16);
    at[2] = -99;
    CHECK(gpu->ClipMsk(at) == 32);
    at[2] = -500;
    CHECK(gpu->ClipMsk(at) == 0);
    for (int i = 0; i < 8; i++) {
        box[i][0] = i & 1 ? 50 : -50;
        box[i][1] = i & 2 ? 50 : -50;
        box[i][2] = i & 4 ? -500 : -600;
    }
    CHECK(gpu->CrossFrustrum(&box[0][0]) == 1);
    for (int i = 0; i < 8; i++) {
        box[i][0] += 5000;
    }
    CHECK(gpu->CrossFrustrum(&box[0][0]) == 0);
    CHECK(gpu->SetNFClip(-64, -4095) == 1 && gpu->SetFov(60) == 682);
}

static void check_frame_buffer(CVGpu *gpu)
{
    int yellow = COLOR_RGB(255, 255, 0) | COLOR_I(128);
    int near_end[3] = {10, 20, 100}, far_end[3] = {20, 20, 100};
    unsigned int *words = gpu->FrameBuffer;

    gpu->PutPixel(5, 6, yellow);
    CHECK(gpu->FrameBuffer[5 + 6 * SCR_X] == 0x10f8u);
    /* The pointer taken before sees it too. */
    CHECK(words[5 + 6 * SCR_X] == 0x10f8u);
    gpu->LineState.DrawColor = COLOR_RGB(255, 255, 255);
    gpu->DrawLine(near_end, far_end);
    CHECK(words[15 + 20 * SCR_X] == (41943u << 16 | 0x1fffu));
    /* What a program writes is there for depth tests and the display. */
    words[15 + 20 * SCR_X] = 50000u << 16 | 0x0707u;
    words[16 + 20 * SCR_X] = 100u << 16 | 0x0707u;
    gpu->DrawLine(near_end, far_end);
    CHECK(words[15 + 20 * SCR_X] == (50000u << 16 | 0x0707u));
    CHECK(words[16 + 20 * SCR_X] == (41943u << 16 | 0x1fffu));
    CHECK(gpu->FrameCounter == 0);
    gpu->FlushFB(0, yellow);
    CHECK(gpu->FrameCounter == 1 && words[0] == 0x10f8u && words[SCR_X * SCR_Y - 1] == 0x10f8u);
}

static void check_targets(CVGpu *gpu)
{
    static unsigned short portrait[SCR_X * SCR_Y], rotated[SCR_X * SCR_Y];
    /* The usual display, and the older one that lies on its side. */
    unsigned int usual = quark_target(portrait, 2, SCR_X * 2);
    unsigned int older = quark_target(&rotated[SCR_Y - 1], SCR_Y * 2, -2);

    gpu->PutPixel(3, 4, COLOR_RGB(255, 0, 0) | COLOR_I(255));
    gpu->FlushFB(usual, 0);
    CHECK(portrait[3 + 4 * SCR_X] == 0xf800 && portrait[0] == 0x8420);
    gpu->PutPixel(3, 4, COLOR_RGB(0, 255, 0) | COLOR_I(255));
    gpu->FlushFB(older, 0);
    CHECK(rotated[3 * SCR_Y + SCR_Y - 1 - 4] == 0x07e0 && rotated[0] == 0);
    quark_target_delete(usual);
    quark_target_delete(older);
    gpu->FlushFB(usual, 0);
    CHECK(portrait[3 + 4 * SCR_X] == 0xf800);
}

static void check_states(CVGpu *gpu)
{
    TRasterState state = plain(COLOR_RGB(0, 0, 255));
    TVertex a = {10, 10, 100, 0, 255, 0, 0}, b = {10, 60, 100, 0, 255, 0, 0},
            c = {60, 60, 100, 0, 255, 0, 0};
    unsigned int *words = gpu->FrameBuffer;

    gpu->FlushFB(0, 0);
    gpu->TriangleMode = TRI_UT;
    gpu->TriangleState = 0;
    gpu->DrawTriangle(&a, &b, &c);
    CHECK(words[12 + 30 * SCR_X] == 0);
    gpu->TriangleState = &state;
    gpu->DrawTriangle(&a, &c, &b);
    CHECK(words[12 + 30 * SCR_X] == 0);
    gpu->DrawTriangle(&a, &b, &c);
    CHECK((words[12 + 30 * SCR_X] & 0x1fff) == 0x1f07);
    /* A member changed between two calls counts. */
    state.DrawColor = COLOR_RGB(255, 0, 0);
    a.z = b.z = c.z = 90;
    gpu->DrawTriangle(&a, &b, &c);
    CHECK((words[12 + 30 * SCR_X] & 0xff) == 0xc0);
    a.m = b.m = c.m = 4;
    a.z = b.z = c.z = 80;
    state.DrawColor = 0;
    gpu->DrawTriangle(&a, &b, &c);
    CHECK((words[12 + 30 * SCR_X] & 0xff) == 0xc0);
}

static void check_textures(CVGpu *gpu)
{
    static unsigned char texels[32 * 16];
    CTexture texture;
    unsigned int *words = gpu->FrameBuffer;

    memset(texels, 0x55, sizeof texels);
    texels[0] = 9;
    CHECK(texture.Init(texels, 32, 16, 9) == 1);
    CHECK(texture.SizeX == 32 && texture.SizeY == 16);
    CHECK(texture.DrawMaskX == 31 && texture.DrawMaskY == 15);
    CHECK(texture.Texels != texels && texture.Texels[0] == 0 && texture.Texels[1] == 0x55);
    gpu->FlushFB(0, COLOR_RGB(255, 255, 255) | COLOR_I(255));
    gpu->SpriteState.Texture = &texture;
    gpu->SpriteState.DrawMode = DRAW_KEYED;
    gpu->SpriteState.DrawIntensity = 255;
    gpu->DrawSprite(100, 100);
    CHECK(words[100 + 100 * SCR_X] == 0x1fff && words[101 + 100 * SCR_X] == 0x1f55);
    /* Texels may be changed in place. */
    texture.Texels[1] = 0x66;
    gpu->DrawSprite(100, 100);
    CHECK(words[101 + 100 * SCR_X] == 0x1f66);
    CHECK(texture.Init(texels, 20, 16, 9) == 0);
    CHECK(texture.SizeX == 20);
    gpu->DrawSpriteScale(10, 200, 512);
    CHECK(words[10 + 200 * SCR_X] == 0x1fff && words[12 + 200 * SCR_X] == 0x1f55);
    int corner[2] = {150, 200}, opposite[2] = {170, 216};
    gpu->DrawSpriteScaleZb(corner, opposite, 128);
    CHECK(words[155 + 205 * SCR_X] == (32767u << 16 | 0x1f55u));
    CHECK(texture.Init(texels, 16, 16, -1) == 1 && texture.Texels[0] == 9);
}

static void check_sort(CVGpu *gpu)
{
    TRasterState state = plain(COLOR_RGB(255, 255, 255));
    TVertex a = {0, 0, 100, 0, 255, 0, 0}, b = {0, 50, 100, 0, 255, 0, 0},
            c = {50, 50, 100, 0, 255, 0, 0};
    unsigned int *words = gpu->FrameBuffer;

    gpu->FlushFB(0, 0);
    CHECK(gpu->SetWorkMemory(100, 2) == 1);
    CHECK(gpu->SetWorkMemory(-1, 2) == 0 && gpu->SetWorkMemory(1, -2) == 0);
    gpu->SortReset();
    gpu->TriangleState = &state;
    gpu->TriangleMode = TRI_UT;
    state.ZSort = 1;
    state.DrawMode = DRAW_ALPHA;
    gpu->DrawTriangle(&a, &b, &c);
    gpu->DrawTriangle(&a, &b, &c);
    gpu->DrawTriangle(&a, &b, &c);
    CHECK(words[2 + 20 * SCR_X] == 0);
    gpu->SortDraw();
    unsigned int twice = words[2 + 20 * SCR_X];
    CHECK(twice != 0);
    gpu->SortDraw();
    CHECK(words[2 + 20 * SCR_X] == twice);
}

static void check_text(CVGpu *gpu)
{
    unsigned int *words = gpu->FrameBuffer;
    int set = 0;
    char text[] = "A\nB";

    gpu->FlushFB(0, 0);
    gpu->TextState.DrawColor = COLOR_RGB(0, 255, 0);
    gpu->PrintXY(text, 40, 40);
    for (int y = 40; y < 56; y++) {
        for (int x = 40; x < 48; x++) {
            set += words[x + y * SCR_X] == (0x1f00u | COLOR_RGB(0, 255, 0));
        }
    }
    CHECK(set > 25 && set < 60);
    CHECK(words[48 + 44 * SCR_X] == 0);
    gpu->PrintFps(0);
    gpu->PrintFps(1000);
    gpu->FlushFB(0, 0);
}

int main()
{
    static CVGpu gpu;

    check_maths();
    check_matrix();
    check_lists();
    CHECK(gpu.Init(-64, -4095, 60) == 1);
    CHECK(gpu.Zoom == 208 && gpu.ClipNear == -64 && gpu.ClipFar == -4095);
    CHECK(gpu.TextState.DrawIntensity == 255 && gpu.LineState.TestCulling == 1);
    CHECK(gpu.TriangleState == 0 && gpu.ViewMatrix == 0 && gpu.ZcErrorMax == 0);
    check_camera(&gpu);
    check_frame_buffer(&gpu);
    check_targets(&gpu);
    check_states(&gpu);
    check_textures(&gpu);
    check_sort(&gpu);
    check_text(&gpu);
    gpu.Delete();
    CHECK(gpu.FrameBuffer == 0);
    CHECK(gpu.Init(0, -4095, 60) == 0);
    return failures != 0;
}
