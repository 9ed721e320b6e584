/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * raw_calls.c: every call of the Raw client interface against a device: what
 * answers, what is left out in the wrong mode, and what wrong arguments do,
 * which is nothing.
 */
#include <render_client.h>

#include "check.h"

static int near_to(float a, float b)
{
    return fabs(a - b) < 1e-5;
}

static void textures(void)
{
    unsigned texels[16];
    unsigned available = RTexMemAvail();
    int i, id;

    for (i = 0; i < 16; i++) {
        texels[i] = 0x01020300u * (unsigned)i + 0xff;
    }
    id = RAllocateTexture(4, 4);
    CHECK(id == 0);
    CHECK(RTexMemAvail() == available - 64);
    RUploadTexture(id, 16, texels);
    RUploadTexture(id, 0, NULL);
    RUploadTexture(id, 16, NULL);
    RUploadTexture(id, 0xffffffffu, texels);
    RUploadTexture(77, 16, texels);
    CHECK(RAllocateTexture(0, 4) == -1);
    CHECK(RAllocateTexture(0xffffffffu, 0xffffffffu) == -1);
    RCompactTexMem();
    RDeallocTexture(id);
    RDeallocTexture(-1);
    CHECK(RTexMemAvail() == available);
}

static void buffers(void)
{
    unsigned pixels[8], back[8];
    signed depths[8], z[8];
    int i;

    for (i = 0; i < 8; i++) {
        pixels[i] = 0x10000000u * (unsigned)i + 0x200;
        depths[i] = -100 * i;
        back[i] = 1;
        z[i] = 1;
    }
    RClearFB(R_PAGE_BOTH, 1, 2, 3);
    CHECK(RReadFB(5, 5, 0) == 0x01020300u && RReadFB(5, 5, 1) == 0x01020300u);
    RWriteFB(5, 5, R_PAGE_FRONT, 4, 5, 6);
    CHECK(RReadFB(5, 5, 0) == 0x01020300u && RReadFB(5, 5, 1) == 0x04050600u);
    RFlipPage(0);
    CHECK(RReadFB(5, 5, 0) == 0x04050600u);
    RWriteFBBlock(2, 1, R_PAGE_BACK, 8, pixels);
    RReadFBBlock(2, 1, 0, 8, back);
    CHECK(memcmp(pixels, back, sizeof back) == 0);
    RClearZ();
    CHECK(RReadZ(0, 0) == 0x7fffffff);
    RWriteZ(0, 0, -5);
    CHECK(RReadZ(0, 0) == -5);
    RWriteZBlock(2, 1, 8, depths);
    RReadZBlock(2, 1, 0, 8, z);
    CHECK(memcmp(depths, z, sizeof z) == 0);
    RWriteFBBlock(0, 0, 1, 8, NULL);
    RReadFBBlock(0, 0, 1, 8, NULL);
    RWriteZBlock(0, 0, 8, NULL);
    RReadZBlock(0, 0, 0, 0xffffffffu, z);
    RWriteFBRGBX(0xffffffffu, 0xffffffffu, 3, 0xff);
    CHECK(RReadFB(0xffffffffu, 0xffffffffu, 0) == 0);
}

static void triangle(float z, unsigned rgba)
{
    RBeginPrim();
    RColorRGBA(rgba);
    RVertex(-1.0f, -1.0f, z, 0.0f, 0.0f);
    RVertex(3.0f, -1.0f, z, 1.0f, 0.0f);
    RVertex(-1.0f, 3.0f, z, 0.0f, 1.0f);
    REndPrim();
}

static void scenes(void)
{
    RClearZ();
    RVertex(0, 0, 0, 0, 0); /* outside a scene: left out */
    REndScene();
    CHECK(g_RInSceneStream == 0);
    RBeginScene();
    CHECK(g_RInSceneStream == 1);
    RBeginScene();
    CHECK(RReadFB(0, 0, 0) == 0 && RTexMemAvail() == 0);
    CHECK(RAllocateTexture(4, 4) == -1 && RReadZ(0, 0) == 0);
    RClearZ();
    triangle(0.5f, 0x112233ff);
    triangle(0.9f, 0xffffffff);
    REndScene();
    CHECK(g_RInSceneStream == 0);
    CHECK(RReadFB(10, 10, 0) == 0x11223300u);
    CHECK(RReadZ(10, 10) > 0x3f000000 && RReadZ(10, 10) < 0x41000000);
}

static void matrices(void)
{
    float m[4][4] = { { 0 } }, x[4][4];
    float eye[3] = { 0, 0, -4 }, focus[3] = { 0, 0, 0 }, up[3] = { 0, 10, -4 };

    m[0][0] = 2.0f;
    m[1][2] = 3.0f;
    m[2][1] = 5.0f;
    m[3][3] = 1.0f;
    MatrixMult(x, m, m);
    CHECK(near_to(x[0][0], 4.0f) && near_to(x[1][1], 15.0f) && near_to(x[2][2], 15.0f));
    MatrixMult(m, m, m);
    CHECK(memcmp(x, m, sizeof m) == 0);
    MatrixMult(NULL, m, m);
    MatrixMult(x, NULL, m);
    RModelMatrix(m);
    RModelMatrix(NULL);
    RViewMatrix(m);
    RViewMatrix(NULL);
    RProjMatrixUV(0.78539816f, 0.78539816f, 1.0f, 3.0f);
    CHECK(near_to(g_RPerspective[0][0], 1.0f) && near_to(g_RPerspective[1][1], -1.0f));
    CHECK(near_to(g_RPerspective[2][2], 2.0f) && near_to(g_RPerspective[2][3], -3.0f));
    RProjMatrix(-1.0f, 1.0f, 1.0f, -1.0f, 1.0f, 3.0f);
    CHECK(near_to(g_RPerspective[1][1], -1.0f) && near_to(g_RPerspective[3][2], 1.0f));
    ROrthMatrix(-2.0f, 2.0f, 2.0f, -2.0f, 0.0f, 4.0f);
    CHECK(near_to(g_RPerspective[0][0], 0.5f) && near_to(g_RPerspective[3][3], 1.0f));
    RCameraMatrix(eye, focus, up);
    CHECK(near_to(g_RCamera[0][0], 1.0f) && near_to(g_RCamera[1][1], 1.0f));
    CHECK(near_to(g_RCamera[2][2], 1.0f) && near_to(g_RCamera[2][3], 4.0f));
    RCameraMatrix(NULL, focus, up);
    RSetProjMatrix(m);
    CHECK(memcmp(g_RPerspective, m, sizeof m) == 0);
    RSetProjMatrix(NULL);
    g_RCamera[0][3] = 7.0f;
    RUpdateMatrices();
}

static void words(void)
{
    unsigned op = RENDER_TEXMEM_AVAIL;

    RSendPVal(&op);
    RSendPVal(NULL);
    RMETARead(1);
    CHECK(RReadUnsigned() == RTexMemAvail());
    CHECK(RReadSigned() == 0 && RReadFloat() == 0.0f);
    RSendUnsigned(RENDER_DIRLIGHT);
    RSendFloat(1.0f);
    RSendFloat(0.0f);
    RSendSigned(0);
    RSendMeta("pstart");
    RSendMeta("preset");
    RMETADebug();
    RSendMeta("it works");
    RSendMeta(NULL);
    RMETAWait(); /* nothing comes: told, not waited for */
}

static void states(void)
{
    unsigned wild[4] = { 0, 1, 0x80000000u, 0xffffffffu };
    int i;

    for (i = 0; i < 4; i++) {
        unsigned v = wild[i];
        RSetLit(v), RSetUseAmb(v), RSetUseDir(v), RSetTexMode(v), RSetTexAlpha(v);
        RSetColAlpha(v), RSetColInterp(v), RSetLitInterp(v), RSetTexInterp(v);
        RSetOutOfOrder(v), RSetTexTile(v), RSetNoUseZ(v), RSetNoWriteZ(v), RSetTextureID(v);
        RColTexBalance((float)v), RAlphaThresh(v), RAmbColorRGBI(v), RAmbColor(v, v, v, v);
        RDirColorRGBI(v), RDirColor(v, v, v, v), RDirLight((float)v, 0.0f, 0.0f);
        RAmbReflect(v), RDirReflect(v), RNormal(0.0f, 0.0f, 0.0f), RColor(v, v, v, v);
        RBeginScene();
        triangle(0.0f, v);
        REndScene();
    }
}

static void beyond(void)
{
    unsigned i;
    int id = RXAllocateMipMapped(8, 8);

    CHECK(id >= 0);
    RXMakeMipMaps(id);
    RXMakeMipMaps(-1);
    CHECK(RXAllocateMipMapped(0, 0) == -1);
    RXResize(16, 8);
    RXResize(0, 0xffffffffu);
    RWriteFBRGBX(15, 7, R_PAGE_BACK, 0x11000000);
    CHECK(RReadFB(15, 7, 0) == 0x11000000u && RReadFB(0, 8, 0) == 0);
    RXSetPrimitive(RX_PRIM_STRIP);
    RXSetClip(RX_CLIP_FRUSTUM);
    RXSetMipMap(RX_MIPMAP_BLEND);
    RXSetPointSize(0xffffffffu);
    RXLight(0xffffffffu, 0, 0, 0, 0);
    RXSpecular(0xffffffffu, 0xffffffffu);
    RXEye(0, 0, 0);
    RColorRGBA(0x223344ffu);
    RXStoreVertex(0, -1.0f, -1.0f, 0.0f, 0.0f, 0.0f);
    RXStoreVertex(1, 1.0f, -1.0f, 0.0f, 0.0f, 0.0f);
    RXStoreVertex(2, -1.0f, 1.0f, 0.0f, 0.0f, 0.0f);
    RXStoreVertex(3, 1.0f, 1.0f, 0.0f, 0.0f, 0.0f);
    RXStoreVertex(0xffffffffu, 0, 0, 0, 0, 0);
    RXIndex(0); /* outside a scene: left out */
    RBeginScene();
    RBeginPrim();
    for (i = 0; i < 4; i++) {
        RXIndex(i);
    }
    REndPrim();
    RXAsyncReset(); /* in the middle of a scene */
    CHECK(g_RInSceneStream == 0);
    CHECK(RReadFB(3, 3, 0) == 0x22334400u && RReadFB(12, 6, 0) == 0x22334400u);
    CHECK(RTexMemAvail() == 1u << 20);
    RXResize(320, 240);
}

int main(void)
{
    RInit();
    RReset();
    beyond();
    RInit();
    RReset();
    textures();
    buffers();
    scenes();
    matrices();
    RReset();
    CHECK(near_to(g_RCamera[0][3], 0.0f));
    words();
    states();
    RMETAHalt();
    RClearZ(); /* after a halt: nothing */
    RHalt();
    return CHECK_REPORT();
}
