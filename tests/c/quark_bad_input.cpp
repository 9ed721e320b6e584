/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * quark_bad_input.cpp: misuse of every function. Nothing may crash or hang, and
 * what the document gives an error code must return it.
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

static const int MOST = 2147483647, LEAST = -2147483647 - 1;

/* Everything on an object that was never initialized, or was deleted. */
static void use(CVGpu *gpu)
{
    int point[3] = {0, 0, -100}, out[3];
    int box[24] = {0};
    TVertex v = {0, 0, 100, 0, 0, 0, 0};
    CTriangleList list;

    list.Init(0, 3, 0, 1, 0);
    gpu->SetWorkMemory(10, 10);
    gpu->PrintXY("text", 0, 0);
    gpu->PrintFps(0);
    gpu->PutPixel(0, 0, 0);
    gpu->DrawLine(point, point);
    gpu->DrawSprite(0, 0);
    gpu->DrawSpriteScale(0, 0, 256);
    gpu->DrawSpriteScaleZb(point, point, 100);
    gpu->DrawTriangle(&v, &v, &v);
    gpu->DrawTriangleList(&list);
    gpu->SortReset();
    gpu->SortDraw();
    gpu->FlushFB(0, 0);
    gpu->SetFov(60);
    gpu->ScrProjection(point, out);
    gpu->SetNFClip(-64, -4095);
    gpu->ClipMsk(point);
    gpu->CrossFrustrum(box);
    CHECK(gpu->FrameBuffer == 0);
    list.Delete();
}

static void null_pointers(CVGpu *gpu)
{
    CTexture texture;
    CTriangleList list;
    CMatrix matrix;
    short normals[9];
    unsigned short ids[1] = {0};

    CHECK(quark_gpu_init(0, -64, -4095, 60) == 0);
    quark_gpu_delete(0);
    gpu->PrintXY(0, 0, 0);
    gpu->DrawLine(0, 0);
    gpu->DrawSpriteScaleZb(0, 0, 100);
    gpu->DrawTriangle(0, 0, 0);
    CHECK(gpu->DrawTriangleList(0) == ERR_MEM);
    gpu->ScrProjection(0, 0);
    gpu->ClipMsk(0);
    gpu->CrossFrustrum(0);
    CHECK(quark_frame_buffer(0) == 0);
    CHECK(texture.Init(0, 16, 16, 0) == 0 && texture.Texels == 0);
    CHECK(quark_texture_init(0, 0, 16, 16, 0) == 0);
    ConvertUv(0);
    Normalize(0);
    DefUNormal(0, 0, 0, 0);
    Itoa(5, 0);
    matrix.LoadIdentity();
    matrix.Load(0);
    matrix.Mult(0);
    matrix.TransformVector(0, 0);
    CHECK(list.Init(0, 3, 0, 1, 0) == 1);
    list.SetABC(0, 0);
    list.SetXYZ(0, 0);
    list.SetUV(0, 0);
    list.GetABC(0, 0);
    list.GetXYZ(0, 0);
    CHECK(list.BuildCmdList(0) == 0 && list.ErrorCode == ERR_MEM);
    CHECK(list.BuildFNormalList(0, 3) == 0 && list.BuildVNormalList(0, 3) == 0);
    CHECK(list.BuildFNormalList(normals, 0) == 0 && list.BuildVNormalList(normals, -3) == 0);
    /* A list without states draws nothing. */
    gpu->SetWorkMemory(10, 0);
    gpu->TriangleMode = TRI_UT;
    CHECK(list.BuildCmdList(ids) == 1);
    CHECK(gpu->DrawTriangleList(&list) == ERR_NONE);
    /* Lists that lost their memory. */
    list.Delete();
    CHECK(list.WeldVertex(0, 0, 0) == 0);
    CHECK(gpu->DrawTriangleList(&list) == ERR_VFMT);
}

static void broken_lists(CVGpu *gpu)
{
    static TRasterState states[2];
    CTriangleList list, copy;
    int numbers[6];
    unsigned short far_away[3] = {0, 1, 65535};
    short at[3] = {0, 0, -100};

    CHECK(list.Init(VF_UV, 3, IF_ABC | IF_C | IF_I, 2, states) == 1);
    for (int index = -2; index < 5; index++) {
        list.SetABC(index, far_away);
        list.SetXYZ(index, at);
        list.SetI(index, 300);
        list.SetC(index, 300);
        list.GetABC(index, numbers);
        list.GetXYZ(index, numbers);
        list.GetUV(index, numbers);
        CHECK(index < 0 || index > 1 || list.GetI(index) == 300);
        CHECK((index >= 0 && index <= 1) || list.GetC(index) == 0);
    }
    CHECK(list.GetI(MOST) == 0 && list.GetI(LEAST) == 0);
    gpu->SetWorkMemory(2, 0);
    CHECK(gpu->DrawTriangleList(&list) == ERR_TMEM);
    gpu->SetWorkMemory(3, 0);
    CHECK(gpu->DrawTriangleList(&list) == ERR_NONE);
    copy = list;
    copy.VertexStride = 0;
    CHECK(gpu->DrawTriangleList(&copy) == ERR_VFMT && copy.WeldVertex(0, 0, 0) == 0);
    CHECK(copy.ErrorCode == ERR_VFMT);
    copy = list;
    copy.IndexStride = 1000000;
    CHECK(gpu->DrawTriangleList(&copy) == ERR_IFMT);
    copy = list;
    copy.VertexListSize = -1;
    CHECK(gpu->DrawTriangleList(&copy) == ERR_MEM);
    copy = list;
    copy.CmdList = 0;
    CHECK(gpu->DrawTriangleList(&copy) == ERR_MEM);
    copy = list;
    copy.CmdMin[0] = 65535;
    copy.CmdList = copy.CmdMin;
    CHECK(gpu->DrawTriangleList(&copy) == ERR_NONE);
    gpu->TriangleMode = TRI_ZC;
    CHECK(gpu->DrawTriangleList(&list) == ERR_NONE);
    list.Delete();
    CHECK(list.Init(0, 3, 0, 1, states) == 1);
    CHECK(gpu->DrawTriangleList(&list) == ERR_UV);
    list.Delete();
    list.Delete();
    /* Members that were never set. */
    memset(&list, 0xaa, sizeof list);
    list.VertexListSize = 5;
    list.Delete();
}

static void odd_textures(CVGpu *gpu)
{
    static unsigned char texels[256 * 256];
    CTexture texture;

    CHECK(texture.Init(texels, 0, 16, 0) == 0 && texture.Init(texels, -16, 16, 0) == 0);
    CHECK(texture.Init(texels, MOST, MOST, 0) == 0 && texture.Init(texels, 2049, 1, 0) == 0);
    CHECK(texture.Init(texels, 256, 256, 0) == 0 && texture.SizeX == 256);
    CHECK(texture.Init(texels, 8, 8, 0) == 0 && texture.Init(texels, 48, 64, 0) == 0);
    CHECK(texture.Init(texels, 128, 16, 0) == 1);
    gpu->SpriteState.Texture = &texture;
    gpu->DrawSprite(0, 0);
    /* Larger than its memory. */
    texture.SizeX = 2048;
    texture.SizeY = 2048;
    gpu->DrawSprite(0, 0);
    texture.SizeX = -5;
    gpu->DrawSprite(0, 0);
    texture.Texels = 0;
    texture.SizeX = 16;
    gpu->DrawSprite(0, 0);
    for (int i = 0; i < 2000; i++) {
        texture.Init(texels, 16 + i % 100, 16, i);
        gpu->DrawSpriteScale(i - 1000, i - 1000, i * 1000);
    }
    gpu->SpriteState.Texture = 0;
    gpu->DrawSprite(0, 0);
}

static void extremes(CVGpu *gpu)
{
    static const int values[7] = {LEAST, -1, 0, 1, 64, 70000, MOST};
    static TRasterState state;
    unsigned int step = 1;

    gpu->TriangleState = &state;
    for (int i = 0; i < 5000; i++) {
        int n[8];
        for (int k = 0; k < 8; k++) {
            step = step * 1664525u + 1013904223u;
            n[k] = values[(step >> 20) % 7];
        }
        TVertex a = {n[0], n[1], n[2], 0, n[3], n[4], n[5]}, b = {n[6], n[7], n[0], 0, 0, n[1], 0},
                c = {n[5], n[3], 100, 0, 255, 0, n[7]};
        state.DrawMode = (unsigned char)n[4];
        state.DrawColor = (unsigned char)i;
        gpu->TriangleMode = n[6];
        gpu->ZcErrorMax = n[7];
        gpu->DrawTriangle(&a, &b, &c);
        gpu->DrawLine(&n[0], &n[3]);
        gpu->PutPixel(n[0], n[1], n[2]);
        gpu->PrintXY("\x80\xff\n", n[0], n[1]);
        gpu->PrintFps((unsigned int)n[0]);
        gpu->ScrProjection(&n[0], &n[3]);
        gpu->ClipMsk(&n[1]);
        gpu->SetFov(n[2]);
        gpu->SetNFClip(n[3], n[4]);
        if (i % 50 == 0) {
            gpu->Zoom = n[0];
            gpu->NFrustrum[0][0] = n[1];
            gpu->FrameCounter = n[2];
            gpu->FlushFB((unsigned int)n[3], n[4]);
        }
        SINUS(n[0]);
        Sqrti(n[1]);
        Atan2i(n[2], n[3]);
        Log2(n[4]);
        Normalize(&n[0]);
        DefUNormal(&n[0], &n[3], &n[5], &n[1]);
    }
}

int main()
{
    static CVGpu gpu;
    CVGpu other;

    memset(static_cast<void *>(&other), 0x55, sizeof other);
    use(&other);
    CHECK(gpu.Init(-64, -4095, 60) == 1);
    null_pointers(&gpu);
    broken_lists(&gpu);
    odd_textures(&gpu);
    extremes(&gpu);
    for (int i = 0; i < 4; i++) {
        CHECK(quark_target(0, 2, 480) == 0);
        gpu.FlushFB(0x51330000u + (unsigned int)i, 0);
        quark_target_delete((unsigned int)i);
    }
    CHECK(gpu.Init(-64, -4095, 200) == 0);
    CHECK(gpu.Init(-64, -4095, 60) == 1 && gpu.Init(-64, -4095, 60) == 1);
    gpu.Delete();
    use(&gpu);
    gpu.Delete();
    return failures != 0;
}
