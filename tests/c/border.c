/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * border.c: every function with arguments of any kind: numbers at random,
 * pointers that are null or point to memory of the size that the function may
 * use, at any alignment. Nothing may crash, hang, or write outside.
 *
 *     border [CALLS] [SEED]
 */
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <glide.h>

#define ROOM (24U << 20)
#define GUARD 4096
#define CORNERS 64

static unsigned char *room;         /* guarded at both ends */
static FxU32 state = 1;
static unsigned latest;             /* the function being called */
static char path[400];

static FxU32 any(void)
{
    state ^= state << 13;
    state ^= state >> 17;
    return state ^= state << 5;
}

/* Enumerants and small numbers mostly. */
static int number(void)
{
    static const int special[8] = {0xff, -1, 2147483647, -2147483647 - 1, 1024, 256, 640, 255};
    FxU32 kind = any() % 64;

    if (kind < 48) {
        return (int)(any() % 17);
    }
    return kind < 54 ? special[any() % 8] : kind < 60 ? (int)(any() % 1024) - 300 : (int)any();
}

static FxU32 word(void) { return any() % 4 ? (FxU32)number() : any() >> any() % 32; }
static GrChipID_t unit_number(void) { return any() % 8 ? (GrChipID_t)(any() % 2) : number(); }
static FxU32 handle(void) { return any() % 8 ? any() % 4 : word(); }

static float real(void)
{
    FxU32 bits = any();
    float value;

    if (any() % 8) {
        return (float)(any() % 4096) / 8.0f - 64.0f;
    }
    memcpy(&value, &bits, sizeof value);
    return value;
}

/* Memory of that size, at any alignment, or null. */
static void *memory(size_t size)
{
    if (any() % 8 == 0) {
        return NULL;
    }
    return room + GUARD + any() % (ROOM - size);
}

static void fill_corner(unsigned char *at)
{
    GrVertex v;
    float *f = &v.x;
    size_t i;

    for (i = 0; i < sizeof v / sizeof *f; i++) {
        f[i] = real();
    }
    if (any() % 4) {
        v.oow = 1.0f / (1.0f + (float)(any() % 64));
    }
    memcpy(at, &v, sizeof v);
}

static const GrVertex *corner_or_null(void)
{
    unsigned char *at = memory(sizeof(GrVertex));

    if (at != NULL) {
        fill_corner(at);
    }
    return (const GrVertex *)(void *)at;
}

static int corner_count(void) { return any() % 8 ? (int)(any() % 9) : (int)(any() % CORNERS) - 4; }

static const int *corner_indices(void)
{
    unsigned char *at = memory(CORNERS * sizeof(int));
    int i;

    for (i = 0; at != NULL && i < CORNERS; i++) {
        int index = (int)(any() % CORNERS);
        memcpy(at + (size_t)i * sizeof index, &index, sizeof index);
    }
    return (const int *)(void *)at;
}

static const GrVertex *corner_list(void)
{
    unsigned char *at = memory(CORNERS * sizeof(GrVertex));
    int i;

    for (i = 0; at != NULL && i < CORNERS; i++) {
        fill_corner(at + (size_t)i * sizeof(GrVertex));
    }
    return (const GrVertex *)(void *)at;
}

static GrTexInfo *texture(void)
{
    unsigned char *at = memory(sizeof(GrTexInfo));
    GrTexInfo info;

    info.largeLod = any() % 8 ? (int)(any() % 9) : number();
    info.smallLod = any() % 8 ? info.largeLod + (int)(any() % (9 - ((FxU32)info.largeLod & 7))) : number();
    info.aspectRatio = number();
    info.format = number();
    info.data = memory(262144);
    if (at != NULL) {
        memcpy(at, &info, sizeof info);
    }
    return (GrTexInfo *)(void *)at;
}

static const char *file_name(void)
{
    static const char *names[4] = {NULL, "", "/", "no such file"};
    return any() % 2 ? path : names[any() % 4];
}

/* A header that may be right, and noise. */
static void make_file(void)
{
    static const char *formats[6] = {"P8", "YIQ", "rgb565", "AP88", "I8", "what"};
    FILE *out = fopen(path, "wb");

    if (out != NULL) {
        fprintf(out, "3df v1.%u\n%s\nlod range: %u %u\naspect ratio: %u %u\n", any() % 9, formats[any() % 6],
                1U << any() % 9, 1U << any() % 9, 1U << any() % 4, 1U);
        fwrite(room + GUARD + any() % (1U << 20), 1, any() % 200000, out);
        fclose(out);
    }
}

static void load_file(void)
{
    Gu3dfInfo info;

    if (any() % 4 == 0) {
        make_file();
    }
    memset(&info, 0, sizeof info);
    if (gu3dfGetInfo(file_name(), &info) || any() % 2) {
        info.data = memory(262144);
        if (any() % 4 == 0) {
            info.mem_required = any() % 262144;
        }
        (void)gu3dfLoad(file_name(), any() % 8 ? &info : NULL);
    }
}

static void lock(void)
{
    GrLfbInfo_t info;
    FxU32 kind = any() % 8 ? any() % 2 : word();
    int buffer = number(), i;

    info.size = sizeof info;
    if (!grLfbLock(kind, buffer, number(), number(), number(), any() % 8 ? &info : NULL)) {
        return;
    }
    for (i = 0; i < 40; i++) {
        ((unsigned char *)info.lfbPtr)[any() % (info.strideInBytes * grSstScreenHeight())] = (unsigned char)any();
    }
    if (any() % 2) {
        (void)grLfbUnlock(kind, buffer);
    }
}

static void level_by_pointer(void)
{
    const void *from = memory(262144);
    const void **at = any() % 8 ? &from : NULL;

    guTexDownloadMipMapLevel(handle(), number(), at);
}

/* A record that is handed out can be read and written. */
static void look_at(GrMipMapInfo *record)
{
    if (record != NULL) {
        record->width += record->height;
    }
}

static void quiet(const char *text, FxBool fatal)
{
    (void)fatal;
    if (strchr(text, ':') == NULL) {
        printf("a message without a function: %s\n", text);
        exit(1);
    }
}

static const char *const names[] = {
    "grGlideInit",
    "grGlideShutdown",
    "grGlideGetVersion",
    "grGlideGetState",
    "grGlideSetState",
    "grGlideShamelessPlug",
    "grErrorSetCallback",
    "grHints",
    "grCheckForRoom",
    "grSplash",
    "grSstQueryBoards",
    "grSstQueryHardware",
    "grSstSelect",
    "grSstWinOpen",
    "grSstWinClose",
    "grSstControl",
    "grSstOrigin",
    "grSstScreenWidth",
    "grSstScreenHeight",
    "grSstIdle",
    "grSstIsBusy",
    "grSstStatus",
    "grSstVideoLine",
    "grSstVRetraceOn",
    "grSstVidMode",
    "grSstConfigPipeline",
    "grSstPerfStats",
    "grSstResetPerfStats",
    "grTriStats",
    "grResetTriStats",
    "grBufferClear",
    "grBufferSwap",
    "grBufferNumPending",
    "grRenderBuffer",
    "grClipWindow",
    "grColorMask",
    "grDepthMask",
    "grAlphaBlendFunction",
    "grAlphaCombine",
    "grAlphaControlsITRGBLighting",
    "grAlphaTestFunction",
    "grAlphaTestReferenceValue",
    "grChromakeyMode",
    "grChromakeyValue",
    "grColorCombine",
    "grConstantColorValue",
    "grConstantColorValue4",
    "grCullMode",
    "grDepthBiasLevel",
    "grDepthBufferFunction",
    "grDepthBufferMode",
    "grDisableAllEffects",
    "grDitherMode",
    "grFogColorValue",
    "grFogMode",
    "grFogTable",
    "grGammaCorrectionValue",
    "grDrawPoint",
    "grDrawLine",
    "grDrawTriangle",
    "grDrawPolygon",
    "grDrawPolygonVertexList",
    "grDrawPlanarPolygon",
    "grDrawPlanarPolygonVertexList",
    "grAADrawPoint",
    "grAADrawLine",
    "grAADrawTriangle",
    "grAADrawPolygon",
    "grAADrawPolygonVertexList",
    "grTexMinAddress",
    "grTexMaxAddress",
    "grTexCalcMemRequired",
    "grTexTextureMemRequired",
    "grTexSource",
    "grTexDownloadMipMap",
    "grTexDownloadMipMapLevel",
    "grTexDownloadMipMapLevelPartial",
    "grTexDownloadTable",
    "grTexDownloadTablePartial",
    "grTexNCCTable",
    "grTexClampMode",
    "grTexCombine",
    "grTexCombineFunction",
    "grTexDetailControl",
    "grTexFilterMode",
    "grTexLodBiasValue",
    "grTexMipMapMode",
    "grTexMultibase",
    "grTexMultibaseAddress",
    "ConvertAndDownloadRle",
    "grLfbLock",
    "grLfbUnlock",
    "grLfbConstantAlpha",
    "grLfbConstantDepth",
    "grLfbWriteColorFormat",
    "grLfbWriteColorSwizzle",
    "grLfbWriteRegion",
    "grLfbReadRegion",
    "grSstOpen",
    "grSstPassthruMode",
    "grSstDetectResources",
    "grSstControlMode",
    "grSstVRetraceTicks",
    "grLfbBegin",
    "grLfbEnd",
    "grLfbBypassMode",
    "grLfbOrigin",
    "grLfbWriteMode",
    "grLfbGetReadPtr",
    "grLfbGetWritePtr",
    "guAlphaSource",
    "guColorCombineFunction",
    "guTexCombineFunction",
    "guFogTableIndexToW",
    "guFogGenerateExp",
    "guFogGenerateExp2",
    "guFogGenerateLinear",
    "guDrawTriangleWithClip",
    "guAADrawTriangleWithClip",
    "guDrawPolygonVertexListWithClip",
    "guTexAllocateMemory",
    "guTexChangeAttributes",
    "guTexDownloadMipMap",
    "guTexDownloadMipMapLevel",
    "guTexSource",
    "guTexGetCurrentMipMap",
    "guTexGetMipMapInfo",
    "guTexMemQueryAvail",
    "guTexMemReset",
    "guTexCreateColorMipMap",
    "gu3dfGetInfo",
    "gu3dfLoad",
    "guEndianSwapWords",
    "guEndianSwapBytes",
    "guEncodeRLE16",
    "guMovieStart",
    "guMovieStop",
    "guMovieSetName",
    "guFbReadRegion",
    "guFbWriteRegion",
    "guMPInit",
    "guMPTexCombineFunction",
    "guMPTexSource",
    "guMPDrawTriangle"
};

static void call(unsigned which)
{
    switch (which) {
    case 0: grGlideInit(); break;
    case 1: grGlideShutdown(); break;
    case 2: grGlideGetVersion(memory(80)); break;
    case 3: grGlideGetState(memory(sizeof(GrState))); break;
    case 4: grGlideSetState(memory(sizeof(GrState))); break;
    case 5: grGlideShamelessPlug(number()); break;
    case 6: grErrorSetCallback(any() % 4 ? quiet : quiet); break;
    case 7: grHints(word(), word()); break;
    case 8: grCheckForRoom(number()); break;
    case 9: grSplash(real(), real(), real(), real(), word()); break;
    case 10: (void)grSstQueryBoards(memory(sizeof(GrHwConfiguration))); break;
    case 11: (void)grSstQueryHardware(memory(sizeof(GrHwConfiguration))); break;
    case 12: grSstSelect(number()); break;
    case 13: (void)grSstWinOpen(word(), number(), number(), number(), number(), number(), number()); break;
    case 14: grSstWinClose(); break;
    case 15: (void)grSstControl(word()); break;
    case 16: grSstOrigin(number()); break;
    case 17: (void)grSstScreenWidth(); break;
    case 18: (void)grSstScreenHeight(); break;
    case 19: grSstIdle(); break;
    case 20: (void)grSstIsBusy(); break;
    case 21: (void)grSstStatus(); break;
    case 22: (void)grSstVideoLine(); break;
    case 23: (void)grSstVRetraceOn(); break;
    case 24: grSstVidMode(word(), memory(256)); break;
    case 25: grSstConfigPipeline(number(), word(), word()); break;
    case 26: grSstPerfStats(memory(sizeof(GrSstPerfStats_t))); break;
    case 27: grSstResetPerfStats(); break;
    case 28: grTriStats(memory(4), memory(4)); break;
    case 29: grResetTriStats(); break;
    case 30: grBufferClear(word(), (FxU8)number(), (FxU16)number()); break;
    case 31: grBufferSwap(number()); break;
    case 32: (void)grBufferNumPending(); break;
    case 33: grRenderBuffer(number()); break;
    case 34: grClipWindow(word(), word(), word(), word()); break;
    case 35: grColorMask(number(), number()); break;
    case 36: grDepthMask(number()); break;
    case 37: grAlphaBlendFunction(number(), number(), number(), number()); break;
    case 38: grAlphaCombine(number(), number(), number(), number(), number()); break;
    case 39: grAlphaControlsITRGBLighting(number()); break;
    case 40: grAlphaTestFunction(number()); break;
    case 41: grAlphaTestReferenceValue((FxU8)number()); break;
    case 42: grChromakeyMode(number()); break;
    case 43: grChromakeyValue(word()); break;
    case 44: grColorCombine(number(), number(), number(), number(), number()); break;
    case 45: grConstantColorValue(word()); break;
    case 46: grConstantColorValue4(real(), real(), real(), real()); break;
    case 47: grCullMode(number()); break;
    case 48: grDepthBiasLevel((FxI16)number()); break;
    case 49: grDepthBufferFunction(number()); break;
    case 50: grDepthBufferMode(number()); break;
    case 51: grDisableAllEffects(); break;
    case 52: grDitherMode(number()); break;
    case 53: grFogColorValue(word()); break;
    case 54: grFogMode(number()); break;
    case 55: grFogTable(memory(64)); break;
    case 56: grGammaCorrectionValue(real()); break;
    case 57: grDrawPoint(corner_or_null()); break;
    case 58: grDrawLine(corner_or_null(), corner_or_null()); break;
    case 59: grDrawTriangle(corner_or_null(), corner_or_null(), corner_or_null()); break;
    case 60: grDrawPolygon(corner_count(), corner_indices(), corner_list()); break;
    case 61: grDrawPolygonVertexList(corner_count(), corner_list()); break;
    case 62: grDrawPlanarPolygon(corner_count(), corner_indices(), corner_list()); break;
    case 63: grDrawPlanarPolygonVertexList(corner_count(), corner_list()); break;
    case 64: grAADrawPoint(corner_or_null()); break;
    case 65: grAADrawLine(corner_or_null(), corner_or_null()); break;
    case 66: grAADrawTriangle(corner_or_null(), corner_or_null(), corner_or_null(), number(), number(), number()); break;
    case 67: grAADrawPolygon(corner_count(), corner_indices(), corner_list()); break;
    case 68: grAADrawPolygonVertexList(corner_count(), corner_list()); break;
    case 69: (void)grTexMinAddress(unit_number()); break;
    case 70: (void)grTexMaxAddress(unit_number()); break;
    case 71: (void)grTexCalcMemRequired(number(), number(), number(), number()); break;
    case 72: (void)grTexTextureMemRequired(word(), texture()); break;
    case 73: grTexSource(unit_number(), word() & ~7U, word(), texture()); break;
    case 74: grTexDownloadMipMap(unit_number(), word() & ~7U, word(), texture()); break;
    case 75: grTexDownloadMipMapLevel(unit_number(), word() & ~7U, number(), number(), number(), number(), word(), memory(131072)); break;
    case 76: grTexDownloadMipMapLevelPartial(unit_number(), word() & ~7U, number(), number(), number(), number(), word(), memory(131072), number(), number()); break;
    case 77: grTexDownloadTable(unit_number(), word(), memory(1024)); break;
    case 78: grTexDownloadTablePartial(unit_number(), word(), memory(1024), number(), number()); break;
    case 79: grTexNCCTable(unit_number(), word()); break;
    case 80: grTexClampMode(unit_number(), number(), number()); break;
    case 81: grTexCombine(unit_number(), number(), number(), number(), number(), number(), number()); break;
    case 82: grTexCombineFunction(unit_number(), number()); break;
    case 83: grTexDetailControl(unit_number(), number(), (FxU8)number(), real()); break;
    case 84: grTexFilterMode(unit_number(), number(), number()); break;
    case 85: grTexLodBiasValue(unit_number(), real()); break;
    case 86: grTexMipMapMode(unit_number(), number(), number()); break;
    case 87: grTexMultibase(unit_number(), number()); break;
    case 88: grTexMultibaseAddress(unit_number(), word(), word() & ~7U, word(), texture()); break;
    case 89: ConvertAndDownloadRle(unit_number(), word() & ~7U, number(), number(), number(), number(), word(), memory(4 + 1000 * 256), number() % 1000, word(), word(), word(), word(), word(), word(), memory(512)); break;
    case 90: lock(); break;
    case 91: (void)grLfbUnlock(word(), number()); break;
    case 92: grLfbConstantAlpha((FxU8)number()); break;
    case 93: grLfbConstantDepth((FxU16)number()); break;
    case 94: grLfbWriteColorFormat(number()); break;
    case 95: grLfbWriteColorSwizzle(number(), number()); break;
    case 96: (void)grLfbWriteRegion(number(), word(), word(), number(), word(), word(), number() % 4096, memory(5 << 20)); break;
    case 97: (void)grLfbReadRegion(number(), word(), word(), word(), word(), word() % 4096, memory(5 << 20)); break;
    case 98: (void)grSstOpen(number(), number(), number(), number(), number(), number()); break;
    case 99: grSstPassthruMode(number()); break;
    case 100: (void)grSstDetectResources(); break;
    case 101: grSstControlMode(word()); break;
    case 102: (void)grSstVRetraceTicks(); break;
    case 103: grLfbBegin(); break;
    case 104: grLfbEnd(); break;
    case 105: grLfbBypassMode(number()); break;
    case 106: grLfbOrigin(number()); break;
    case 107: grLfbWriteMode(number()); break;
    case 108: (void)grLfbGetReadPtr(number()); break;
    case 109: (void)grLfbGetWritePtr(number()); break;
    case 110: guAlphaSource(number()); break;
    case 111: guColorCombineFunction(number()); break;
    case 112: guTexCombineFunction(unit_number(), number()); break;
    case 113: (void)guFogTableIndexToW(number()); break;
    case 114: guFogGenerateExp(memory(64), real()); break;
    case 115: guFogGenerateExp2(memory(64), real()); break;
    case 116: guFogGenerateLinear(memory(64), real(), real()); break;
    case 117: guDrawTriangleWithClip(corner_or_null(), corner_or_null(), corner_or_null()); break;
    case 118: guAADrawTriangleWithClip(corner_or_null(), corner_or_null(), corner_or_null()); break;
    case 119: guDrawPolygonVertexListWithClip(corner_count(), corner_list()); break;
    case 120: (void)guTexAllocateMemory(unit_number(), (FxU8)number(), number(), number(), number(), number(), number(), number(), number(), number(), number(), number(), number(), real(), number()); break;
    case 121: (void)guTexChangeAttributes(handle(), number(), number(), number(), number(), number(), number(), number(), number(), number(), number(), number()); break;
    case 122: guTexDownloadMipMap(handle(), memory(262144), memory(sizeof(GuNccTable))); break;
    case 123: level_by_pointer(); break;
    case 124: guTexSource(handle()); break;
    case 125: (void)guTexGetCurrentMipMap(unit_number()); break;
    case 126: look_at(guTexGetMipMapInfo(handle())); break;
    case 127: (void)guTexMemQueryAvail(unit_number()); break;
    case 128: guTexMemReset(); break;
    case 129: free(guTexCreateColorMipMap()); break;
    case 130: (void)gu3dfGetInfo(file_name(), memory(sizeof(Gu3dfInfo))); break;
    case 131: load_file(); break;
    case 132: (void)guEndianSwapWords(word()); break;
    case 133: (void)guEndianSwapBytes((FxU16)number()); break;
    case 134: (void)guEncodeRLE16(memory(4 << 20), memory(2 << 20), word() % 1024, word() % 1024); break;
    case 135: guMovieStart(); break;
    case 136: guMovieStop(); break;
    case 137: guMovieSetName(file_name()); break;
    case 138: guFbReadRegion(number(), number(), number(), number(), memory(5 << 20), number() % 4096 & 4095); break;
    case 139: guFbWriteRegion(number(), number(), number(), number(), memory(18 << 20), number() % 4096); break;
    case 140: guMPInit(); break;
    case 141: guMPTexCombineFunction(number()); break;
    case 142: guMPTexSource(unit_number(), handle()); break;
    case 143: guMPDrawTriangle(corner_or_null(), corner_or_null(), corner_or_null()); break;
    default: break;
    }
}

static void on_crash(int number_of_signal)
{
    fprintf(stderr, "signal %d in %s\n", number_of_signal, names[latest]);
    _Exit(1);
}

static FxBool open_board(void)
{
    grGlideInit();
    grSstSelect(0);
    return grSstWinOpen(0, GR_RESOLUTION_320x200, GR_REFRESH_60Hz, GR_COLORFORMAT_ARGB, GR_ORIGIN_UPPER_LEFT, 2, 1);
}

/* After everything the library draws as it should. */
static int still_draws(void)
{
    FxU16 pixel = 0;

    grGlideShutdown();
    if (!open_board()) {
        return 0;
    }
    grDitherMode(GR_DITHER_DISABLE);
    grBufferClear(0xff8000, 0, 0);
    return grLfbReadRegion(GR_BUFFER_BACKBUFFER, 7, 9, 1, 1, 2, &pixel) && pixel == 0xfc00;
}

int main(int argc, char **argv)
{
    unsigned long calls = argc > 1 ? strtoul(argv[1], NULL, 10) : 30000, i;
    const char *folder = getenv("TMPDIR");
    unsigned count = sizeof names / sizeof *names, k;

    state = argc > 2 ? (FxU32)strtoul(argv[2], NULL, 10) | 1U : 1U;
    sprintf(path, "%.300s/border_test.3df", folder != NULL ? folder : "/tmp");
    room = malloc(ROOM + 2 * GUARD);
    if (room == NULL) {
        return 1;
    }
    for (k = 0; k < ROOM + 2 * GUARD; k++) {
        room[k] = (unsigned char)(k < GUARD || k >= ROOM + GUARD ? 0x5a : any() >> 8);
    }
    signal(SIGSEGV, on_crash);
    signal(SIGABRT, on_crash);
    signal(SIGFPE, on_crash);
    grErrorSetCallback(quiet);
    make_file();
    for (i = 0; i < calls; i++) {
        if (i % 64 == 0) {
            (void)open_board();
        }
        latest = any() % count;
        call(latest);
    }
    remove(path);
    for (k = 0; k < GUARD; k++) {
        if (room[k] != 0x5a || room[ROOM + GUARD + k] != 0x5a) {
            printf("memory around the room was written\n");
            return 1;
        }
    }
    printf("%lu calls of %u functions\n", calls, count);
    if (!still_draws()) {
        printf("the board no longer draws\n");
        return 1;
    }
    grGlideShutdown();
    return 0;
}
