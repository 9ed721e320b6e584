/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * misuse.c: breaks every rule of the checking mode once. For each step it
 * prints what the error callback heard: the step's number, 1 or 0 for fatal or
 * not, and the message. The steps are in groups by what must be open.
 *
 * misuse_rules compares the messages with the table of rules: see
 * apps/cli/tests.
 */
#include <stdio.h>
#include <string.h>

#include <glide.h>

static int step;

static void heard(const char *message, FxBool fatal)
{
    printf("%d\t%d\t%s\n", step, fatal != 0, message);
}

/* One misuse. */
#define M(call) do { step++; (void)(call); } while (0)
/* A call that only sets the stage, and must be silent. */
#define S(call) do { int was = step; step = -1; (void)(call); step = was; } while (0)

static GrVertex v[5];
static FxU32 words[256];
static FxU8 texels[65536 * 3];
static GrLfbInfo_t info;

static GrTexInfo texture(int small_lod, int large_lod, int aspect, int format)
{
    GrTexInfo t;

    memset(&t, 0, sizeof t);
    t.smallLod = small_lod;
    t.largeLod = large_lod;
    t.aspectRatio = aspect;
    t.format = format;
    t.data = texels;
    return t;
}

static FxBool open_board(int resolution, int colors, int aux)
{
    return grSstWinOpen(0, resolution, GR_REFRESH_60Hz, GR_COLORFORMAT_ARGB,
                        GR_ORIGIN_UPPER_LEFT, colors, aux);
}

static FxBool old_open(int resolution, int refresh, int format, int origin, int smoothing, int buffers)
{
    return grSstOpen(resolution, refresh, format, origin, smoothing, buffers);
}

static void place(float x0, float y0, float x1, float y1, float x2, float y2, float x3, float y3)
{
    float at[4][2];
    int i;

    at[0][0] = x0; at[0][1] = y0; at[1][0] = x1; at[1][1] = y1;
    at[2][0] = x2; at[2][1] = y2; at[3][0] = x3; at[3][1] = y3;
    for (i = 0; i < 4; i++) {
        memset(&v[i], 0, sizeof v[i]);
        v[i].x = at[i][0];
        v[i].y = at[i][1];
        v[i].oow = 1.0f;
    }
}

static void opening(void)
{
    M(open_board(7, 2, 1));                 /* before grGlideInit */
    M(old_open(7, 0, 0, 0, 1, 2));
    S(grGlideInit());
    M(grBufferClear(0, 0, 0));              /* no board is open */
    M(grSstSelect(1));
    M(open_board(12, 2, 1));
    M(grSstWinOpen(0, 7, 99, 0, 0, 2, 1));
    M(grSstWinOpen(0, 7, 0, 4, 0, 2, 1));
    S(grSstWinClose());
    M(grSstWinOpen(0, 7, 0, 0, 2, 2, 1));
    S(grSstWinClose());
    M(open_board(7, 1, 1));
    M(open_board(7, 2, 2));
    M(open_board(7, 3, 1));
    M(open_board(8, 2, 1));                 /* too large for two megabytes */
    M(old_open(12, 0, 0, 0, 1, 2));
    M(old_open(7, 99, 0, 0, 1, 2));
    M(old_open(7, 0, 4, 0, 1, 2));
    S(grSstWinClose());
    M(old_open(7, 0, 0, 2, 1, 2));
    S(grSstWinClose());
    M(old_open(7, 0, 0, 0, 2, 2));
    S(grSstWinClose());
    M(old_open(7, 0, 0, 0, 1, 1));
    M(old_open(8, 0, 0, 0, 1, 3));          /* three buffers are too large */
    S(old_open(8, 0, 0, 0, 1, 2));          /* two are not */
    S(grSstWinClose());
    S(open_board(7, 2, 1));
    M(open_board(7, 2, 1));
    M(old_open(7, 0, 0, 0, 1, 2));
}

static void frames(void)
{
    M(grSstOrigin(2));
    S(grSstOrigin(0));
    M(grSstConfigPipeline(1, 0, 0));
    M(grSstConfigPipeline(3, 300, 0));
    M(grHints(7, 0));
    M(grHints(GR_HINT_STWHINT, 0x80));
    S(grHints(GR_HINT_STWHINT, 0));
    M(grBufferSwap(-1));
    M(grBufferSwap(256));
    M(grRenderBuffer(2));
    M(grClipWindow(9, 0, 8, 10));
    M(grClipWindow(0, 9, 10, 8));
    M(grClipWindow(0, 0, 641, 10));
    M(grClipWindow(0, 0, 10, 481));
    S(grClipWindow(0, 0, 640, 480));
    S(grDepthBufferMode(1));
    M(grColorMask(1, 1));
    M(grAlphaBlendFunction(3, 0, 4, 0));
    M(grAlphaBlendFunction(4, 7, 4, 0));
    S(grDepthBufferMode(0));
    S(grColorMask(1, 1));
    M(grDepthBufferMode(1));
    S(grDepthBufferMode(0));
    S(grColorMask(1, 0));
}

static void locks(void)
{
    M(grLfbLock(2, 1, 0, 0, 0, &info));
    M(grLfbLock(GR_LFB_READ_ONLY, 5, 0xff, 0, 0, &info));
    M(grLfbLock(GR_LFB_WRITE_ONLY, 1, 3, 0, 0, &info));
    M(grLfbLock(GR_LFB_WRITE_ONLY, 1, 0xf, 0, 0, &info));
    M(grLfbLock(GR_LFB_WRITE_ONLY, 1, 0xff, 2, 0, &info));
    M(grLfbLock(GR_LFB_WRITE_ONLY, 1, 0xff, 0, 0, &info));  /* taken by the step before */
    S(grLfbUnlock(GR_LFB_WRITE_ONLY, 1));
    M(grLfbUnlock(GR_LFB_WRITE_ONLY, 1));
    M(grLfbLock(GR_LFB_READ_ONLY, 1, 0xff, 0, 0, NULL));
    info.size = 0;
    M(grLfbLock(GR_LFB_WRITE_ONLY, 1, 0xff, 0, 0, &info));
    S(grLfbUnlock(GR_LFB_WRITE_ONLY, 1));
    info.size = sizeof info;
    M(grLfbGetWritePtr(2));                 /* the write mode is for colours */
    M(grLfbGetReadPtr(5));
    S(grLfbEnd());
    M(grLfbWriteColorFormat(4));
    M(grLfbWriteMode(3));
    M(grLfbOrigin(2));
    M(grLfbBypassMode(2));
    M(grLfbWriteRegion(3, 0, 0, 0xf, 1, 1, 2, words));
    M(grLfbWriteRegion(1, 0, 0, 3, 1, 1, 4, words));
    M(grLfbWriteRegion(1, 0, 0, 0xf, 1, 1, 2, words));
    M(grLfbWriteRegion(1, 639, 0, 0, 2, 1, 4, words));
    M(grLfbWriteRegion(1, 0, 0, 0, 2, 1, 2, words));
}

static void pixels(void)
{
    GrFog_t fog[64] = { 0 };

    M(grDepthBufferMode(5));
    M(grDepthBufferFunction(8));
    M(grAlphaBlendFunction(8, 0, 4, 0));
    M(grAlphaBlendFunction(4, 8, 4, 0));
    M(grAlphaBlendFunction(4, 0, 1, 0));
    M(grAlphaBlendFunction(4, 0, 4, 5));
    S(grAlphaBlendFunction(4, 0, 4, 0));
    M(grAlphaCombine(10, 0, 0, 0, 0));
    M(grAlphaCombine(3, 6, 0, 0, 0));
    M(grAlphaCombine(3, 0, 3, 0, 0));
    M(grAlphaCombine(3, 0, 0, 3, 0));
    M(grColorCombine(10, 0, 0, 0, 0));
    M(grColorCombine(3, 6, 0, 0, 0));
    M(grColorCombine(3, 0, 2, 0, 0));
    M(grColorCombine(3, 0, 0, 3, 0));
    M(grAlphaTestFunction(8));
    M(grChromakeyMode(2));
    S(grChromakeyMode(0));
    M(grConstantColorValue4(256.0f, 0.0f, 0.0f, 0.0f));
    M(grConstantColorValue4(0.0f, -1.0f, 0.0f, 0.0f));
    M(grConstantColorValue4(0.0f, 0.0f, 999.0f, 0.0f));
    M(grConstantColorValue4(0.0f, 0.0f, 0.0f, -0.5f));
    M(grCullMode(3));
    M(grDitherMode(3));
    M(grFogMode(4));
    fog[5] = 64;
    M(grFogTable(fog));
    M(grGammaCorrectionValue(0.0f));
    M(guColorCombineFunction(0x11));
    M(guAlphaSource(4));
}

static void primitives(void)
{
    static const int list[4] = { 0, 1, 2, 3 };

    place(0, 0, 10, 0, 10, 10, 3000, 10);
    M(grDrawPoint(&v[3]));
    M(grDrawLine(&v[0], &v[3]));
    M(grDrawTriangle(&v[0], &v[1], &v[3]));
    M(grDrawPolygon(4, list, v));
    M(grDrawPlanarPolygon(4, list, v));
    M(grDrawPolygon(2, list, v));
    M(grDrawPlanarPolygon(2, list, v));
    S(grAlphaBlendFunction(1, 5, 4, 0));
    M(grAADrawPoint(&v[3]));
    M(grAADrawLine(&v[0], &v[3]));
    M(grAADrawTriangle(&v[0], &v[1], &v[3], 1, 1, 1));
    M(grAADrawPolygon(4, list, v));
    M(grAADrawPolygon(2, list, v));
    M(grDrawPolygonVertexList(2, v));
    M(grDrawPlanarPolygonVertexList(2, v));
    M(grAADrawPolygonVertexList(2, v));
    place(0, 0, 10, 0, 3, 3, 0, 10);
    M(grDrawPolygon(4, list, v));
    M(grDrawPlanarPolygon(4, list, v));
    M(grAADrawPolygon(4, list, v));
    S(grAlphaBlendFunction(4, 0, 4, 0));
    M(grAADrawPoint(&v[0]));
    M(grAADrawLine(&v[0], &v[1]));
    M(grAADrawTriangle(&v[0], &v[1], &v[2], 1, 1, 1));
    M(grAADrawPolygon(3, list, v));
}

#define RGB565 GR_TEXFMT_RGB_565
#define SQUARE GR_ASPECT_1x1

/* The misuses that calls with an address of texture memory share. */
#define ADDRESSES(CALL) do { \
        GrTexInfo good = texture(8, 0, SQUARE, RGB565), t; \
        M(CALL(1, 0, 3, &good)); \
        M(CALL(0, 4, 3, &good)); \
        M(CALL(0, 2 << 20, 3, &good)); \
        t = texture(0, 0, SQUARE, RGB565); \
        M(CALL(0, (2 << 20) - 8, 3, &t)); \
        M(CALL(0, 0, 4, &good)); \
        t = texture(9, 0, SQUARE, RGB565); \
        M(CALL(0, 0, 3, &t)); \
        t = texture(8, -1, SQUARE, RGB565); \
        M(CALL(0, 0, 3, &t)); \
        t = texture(2, 3, SQUARE, RGB565); \
        M(CALL(0, 0, 3, &t)); \
        t = texture(8, 0, 7, RGB565); \
        M(CALL(0, 0, 3, &t)); \
        t = texture(8, 0, SQUARE, 6); \
        M(CALL(0, 0, 3, &t)); \
    } while (0)

#define MULTIBASE(tmu, start, even_odd, t) grTexMultibaseAddress(tmu, 0, start, even_odd, t)
#define PARTIAL(tmu, start, even_odd, t) \
    grTexDownloadMipMapLevelPartial(tmu, start, (t)->smallLod, (t)->largeLod, (t)->aspectRatio, \
                                    (t)->format, even_odd, texels, 0, 0)

static void textures(void)
{
    GrTexInfo good = texture(8, 0, SQUARE, RGB565);
    GrMipMapId_t id;

    ADDRESSES(grTexSource);
    ADDRESSES(grTexDownloadMipMap);
    ADDRESSES(PARTIAL);
    ADDRESSES(MULTIBASE);
    M(grTexDownloadMipMapLevelPartial(0, 0, 0, 0, SQUARE, RGB565, 3, texels, 5, 4));
    M(grTexDownloadMipMapLevelPartial(0, 0, 0, 0, SQUARE, RGB565, 3, texels, 0, 256));
    M(grTexMultibaseAddress(0, 4, 0, 3, &good));
    M(grTexDownloadTable(1, GR_TEXTABLE_PALETTE, words));
    M(grTexDownloadTable(0, 3, words));
    M(grTexDownloadTablePartial(0, GR_TEXTABLE_PALETTE, words, 1, 256));
    M(grTexNCCTable(1, 0));
    M(grTexClampMode(1, 0, 0));
    M(grTexCombine(1, 0, 0, 0, 0, 0, 0));
    M(grTexCombineFunction(1, 0));
    M(grTexDetailControl(1, 0, 0, 0.0f));
    M(grTexFilterMode(1, 0, 0));
    M(grTexLodBiasValue(1, 0.0f));
    M(grTexMipMapMode(1, 0, 0));
    M(grTexMultibase(1, 0));
    M(grTexNCCTable(0, 2));
    M(grTexClampMode(0, 2, 0));
    M(grTexClampMode(0, 0, 2));
    M(grTexCombine(0, 10, 0, 0, 0, 0, 0));
    M(grTexCombine(0, 0, 6, 0, 0, 0, 0));
    M(grTexCombine(0, 0, 0, 10, 0, 0, 0));
    M(grTexCombine(0, 0, 0, 0, 6, 0, 0));
    M(grTexCombineFunction(0, 11));
    M(guTexCombineFunction(0, 11));
    M(grTexDownloadMipMapLevel(0, 4, 0, 0, SQUARE, RGB565, 3, texels));
    id = guTexAllocateMemory(0, 3, 1, 1, RGB565, 0, GR_LOD_1, GR_LOD_1, SQUARE, 0, 0, 0, 0, 0.0f, 0);
    S(guTexSource(id));
    M(guTexSource(id));
    M(grTexDetailControl(0, -33, 0, 0.0f));
    M(grTexDetailControl(0, 0, 8, 0.0f));
    M(grTexDetailControl(0, 0, 0, 1.5f));
    M(grTexFilterMode(0, 2, 0));
    M(grTexFilterMode(0, 0, 2));
    M(grTexLodBiasValue(0, 8.0f));
    M(grTexMipMapMode(0, 3, 0));
}

/* No function takes a null pointer. */
static void nulls(void)
{
    GrVertex a;

    memset(&a, 0, sizeof a);
    M(grDrawTriangle(&a, NULL, &a));
    M(grDrawPoint(NULL));
    M(grDrawPolygonVertexList(3, NULL));
    M(grTexSource(0, 0, 3, NULL));
    M(grTexDownloadMipMap(0, 0, 3, NULL));
    M(grTexDownloadTable(0, GR_TEXTABLE_PALETTE, NULL));
    M(grFogTable(NULL));
    M(grSstPerfStats(NULL));
    M(grGlideGetState(NULL));
    M(grGlideSetState(NULL));
    M(grLfbWriteRegion(1, 0, 0, 0, 1, 1, 2, NULL));
    M(grLfbReadRegion(1, 0, 0, 1, 1, 2, NULL));
    M(grSstQueryHardware(NULL));
    M(grSstQueryBoards(NULL));
    M(grGlideGetVersion(NULL));
    M(grTexTextureMemRequired(3, NULL));
    M(grTexMultibaseAddress(0, 0, 0, 3, NULL));
    M(grTexDownloadMipMapLevel(0, 0, 0, 0, SQUARE, RGB565, 3, NULL));
    M(guDrawPolygonVertexListWithClip(3, NULL));
    M(guFogGenerateExp(NULL, 1.0f));
    M(guFogGenerateExp2(NULL, 1.0f));
    M(guFogGenerateLinear(NULL, 1.0f, 2.0f));
}

/* A third colour buffer leaves no auxiliary one. */
static void without_aux(void)
{
    S(grSstWinClose());
    S(open_board(7, 3, 0));
    M(grColorMask(1, 1));
    M(grDepthMask(1));
    M(grDepthBufferMode(1));
    M(grLfbLock(GR_LFB_READ_ONLY, 2, 0xf, 0, 0, &info));
    S(grSstWinClose());
    S(open_board(7, 2, 0));
    M(grColorMask(1, 1));
}

/* Other boards: one of four megabytes a unit, and one of two halves. */
static void other_boards(const char *which)
{
    GrTexInfo t = texture(0, 0, SQUARE, RGB565);

    S(grGlideInit());
    S(open_board(7, 2, 1));
    if (strcmp(which, "banks") == 0) {
        M(grTexSource(0, (2 << 20) - 8, 3, &t));
        M(grTexDownloadMipMap(0, (2 << 20) - 8, 3, &t));
        M(PARTIAL(0, (2 << 20) - 8, 3, &t));
        M(MULTIBASE(0, (2 << 20) - 8, 3, &t));
    } else {
        M(grLfbLock(GR_LFB_READ_ONLY, 1, 0xff, 0, 0, &info));
    }
}

int main(int argc, char **argv)
{
    grErrorSetCallback(heard);
    info.size = sizeof info;
    if (argc > 1) {
        other_boards(argv[1]);
        return 0;
    }
    opening();
    frames();
    locks();
    pixels();
    primitives();
    textures();
    nulls();
    without_aux();
    printf("%d steps\n", step);
    return 0;
}
