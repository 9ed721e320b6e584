/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * bad_input.c: calls at the wrong time, null pointers, and misuse of frame
 * buffer locks. Expected is the documented or the least surprising result,
 * a message in checking mode, and never a crash.
 */
#include "abuse.h"

static GrVertex A, B, C;

static void set_vertices(void)
{
    A = abuse_vertex(10, 10);
    B = abuse_vertex(200, 20);
    C = abuse_vertex(50, 180);
}

/* Everything a program might draw with. */
static void draw_one_of_each(void)
{
    GrVertex list[3];
    int indices[3] = {0, 1, 2};

    set_vertices();
    list[0] = A;
    list[1] = B;
    list[2] = C;
    grBufferClear(0, 0, 0);
    grDrawPoint(&A);
    grDrawLine(&A, &B);
    grDrawTriangle(&A, &B, &C);
    grDrawPolygon(3, indices, list);
    grDrawPolygonVertexList(3, list);
    grDrawPlanarPolygon(3, indices, list);
    grDrawPlanarPolygonVertexList(3, list);
    grAADrawPoint(&A);
    grAADrawLine(&A, &B);
    grAADrawTriangle(&A, &B, &C, FXTRUE, FXTRUE, FXTRUE);
    grAADrawPolygon(3, indices, list);
    grAADrawPolygonVertexList(3, list);
    guDrawTriangleWithClip(&A, &B, &C);
    guAADrawTriangleWithClip(&A, &B, &C);
    guDrawPolygonVertexListWithClip(3, list);
    guMPDrawTriangle(&A, &B, &C);
    grBufferSwap(1);
}

/* State, texture and query calls, with arguments that are right once open. */
static void call_one_of_each(void)
{
    static FxU16 texels[4];
    static FxU32 palette[256];
    GrTexInfo info = {GR_LOD_1, GR_LOD_1, GR_ASPECT_1x1, GR_TEXFMT_RGB_565, NULL};
    GrFog_t fog[GR_FOG_TABLE_SIZE] = {0};
    GrSstPerfStats_t stats;
    FxU32 in, out;

    info.data = texels;
    guColorCombineFunction(GR_COLORCOMBINE_ITRGB);
    guAlphaSource(GR_ALPHASOURCE_CC_ALPHA);
    grAlphaBlendFunction(GR_BLEND_ONE, GR_BLEND_ZERO, GR_BLEND_ONE, GR_BLEND_ZERO);
    grDepthBufferMode(GR_DEPTHBUFFER_DISABLE);
    grCullMode(GR_CULL_DISABLE);
    grClipWindow(0, 0, 640, 480);
    grFogTable(fog);
    grTexDownloadMipMap(GR_TMU0, 0, GR_MIPMAPLEVELMASK_BOTH, &info);
    grTexSource(GR_TMU0, 0, GR_MIPMAPLEVELMASK_BOTH, &info);
    grTexDownloadTable(GR_TMU0, GR_TEXTABLE_PALETTE, palette);
    guTexMemReset();
    guTexMemQueryAvail(GR_TMU0);
    grSstIsBusy();
    grSstIdle();
    grSstStatus();
    grSstVideoLine();
    grSstVRetraceOn();
    grSstPerfStats(&stats);
    grTriStats(&in, &out);
    grResetTriStats();
    grDisableAllEffects();
    grGammaCorrectionValue(1.7f);
    grHints(GR_HINT_STWHINT, 0);
    grSplash(0, 0, 100, 100, 1);
    grGlideShamelessPlug(FXFALSE);
}

static int lock_is_refused(void)
{
    GrLfbInfo_t info;
    FxU16 pixel = 0;

    info.size = sizeof info;
    return !grLfbLock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER, GR_LFBWRITEMODE_565,
                      GR_ORIGIN_UPPER_LEFT, FXFALSE, &info)
        && !grLfbLock(GR_LFB_READ_ONLY, GR_BUFFER_FRONTBUFFER, GR_LFBWRITEMODE_ANY,
                      GR_ORIGIN_UPPER_LEFT, FXFALSE, &info)
        && !grLfbUnlock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER)
        && !grLfbReadRegion(GR_BUFFER_BACKBUFFER, 0, 0, 1, 1, 2, &pixel)
        && !grLfbWriteRegion(GR_BUFFER_BACKBUFFER, 0, 0, GR_LFB_SRC_FMT_565, 1, 1, 2, &pixel)
        && grLfbGetReadPtr(GR_BUFFER_BACKBUFFER) == NULL
        && grLfbGetWritePtr(GR_BUFFER_BACKBUFFER) == NULL;
}

/* --- calls at the wrong time ---------------------------------------------- */

static int drawing_before_init(void)
{
    grGlideShutdown();
    draw_one_of_each();
    return 1;
}

static int calls_before_init(void)
{
    grGlideShutdown();
    call_one_of_each();
    return grSstScreenWidth() == 0 && grSstScreenHeight() == 0 && lock_is_refused();
}

static int state_before_init(void)
{
    GrState state;

    grGlideShutdown();
    memset(&state, 0, sizeof state);
    grGlideGetState(&state);
    grGlideSetState(&state);
    return 1;
}

static int query_boards_before_init(void)
{
    GrHwConfiguration hardware;

    grGlideShutdown();
    memset(&hardware, 0, sizeof hardware);
    return grSstQueryBoards(&hardware) && hardware.num_sst >= 1
        && hardware.num_sst <= MAX_NUM_SST;
}

static int open_before_init(void)
{
    grGlideShutdown();
    return !abuse_open();
}

static int close_before_init(void)
{
    grGlideShutdown();
    grSstWinClose();
    grGlideShutdown();
    grGlideShutdown();
    return 1;
}

static int drawing_before_open(void)
{
    grGlideShutdown();
    grGlideInit();
    abuse_messages = 0;
    draw_one_of_each();
    call_one_of_each();
    return grSstScreenWidth() == 0 && lock_is_refused();
}

static int drawing_before_open_is_told(void)
{
    grGlideShutdown();
    grGlideInit();
    abuse_messages = 0;
    set_vertices();
    grDrawTriangle(&A, &B, &C);
    return told_when_checking("grDrawTriangle");
}

static int drawing_after_close(void)
{
    grSstWinClose();
    draw_one_of_each();
    call_one_of_each();
    return lock_is_refused();
}

static int drawing_after_shutdown(void)
{
    grGlideShutdown();
    draw_one_of_each();
    call_one_of_each();
    return lock_is_refused() && !abuse_open();
}

static int double_init(void)
{
    grGlideInit();
    grGlideInit();
    return draws_correctly();
}

static int double_open(void)
{
    FxBool again = abuse_open();
    return !again && told_when_checking("grSstWinOpen") && draws_correctly();
}

static int double_close(void)
{
    grSstWinClose();
    grSstWinClose();
    return 1;
}

static int many_opens(void)
{
    int i;

    for (i = 0; i < 20; i++) {
        grSstWinClose();
        if (!abuse_open()) {
            return 0;
        }
    }
    return draws_correctly();
}

static int open_with_bad_arguments(void)
{
    static const int bad[][6] = { /* resolution, refresh, format, origin, colour, aux */
        {-1, 0, 0, 0, 2, 1}, {0x10, 0, 0, 0, 2, 1}, {0x7fffffff, 0, 0, 0, 2, 1},
        {7, 0, -1, 0, 2, 1}, {7, 0, 4, 0, 2, 1}, {7, 0, 0, 0, -1, 1}, {7, 0, 0, 0, 99, 1},
        {0xe, 0, 0, 0, 2, 1}
    };
    size_t i;

    grSstWinClose();
    for (i = 0; i < COUNT_OF(bad); i++) {
        const int *b = bad[i];
        if (grSstWinOpen(0, b[0], b[1], b[2], b[3], b[4], b[5])) {
            printf("  opened with argument set %u\n", (unsigned)i);
            return 0;
        }
    }
    return 1;
}

static int select_out_of_range(void)
{
    static const int bad[] = {-1, 4, 99, 0x7fffffff, -0x7fffffff};
    size_t i;

    for (i = 0; i < COUNT_OF(bad); i++) {
        abuse_messages = 0;
        grSstSelect(bad[i]);
        if (!told_by("grSstSelect")) { /* told in every mode */
            return 0;
        }
    }
    return draws_correctly(); /* the board selected before stays so */
}

/* --- null pointers --------------------------------------------------------- */

static int null_vertices(void)
{
    set_vertices();
    grDrawPoint(NULL);
    grDrawLine(NULL, &B);
    grDrawLine(&A, NULL);
    grDrawTriangle(NULL, &B, &C);
    grDrawTriangle(&A, NULL, &C);
    grDrawTriangle(&A, &B, NULL);
    grAADrawPoint(NULL);
    grAADrawLine(NULL, NULL);
    grAADrawTriangle(NULL, NULL, &C, FXTRUE, FXTRUE, FXTRUE);
    guDrawTriangleWithClip(&A, NULL, &C);
    guAADrawTriangleWithClip(NULL, &B, &C);
    guMPDrawTriangle(&A, &B, NULL);
    return 1;
}

static int null_vertex_is_told(void)
{
    set_vertices();
    abuse_messages = 0;
    grDrawTriangle(&A, NULL, &C);
    return told_when_checking("grDrawTriangle");
}

static int null_vertex_lists(void)
{
    GrVertex list[3];
    int indices[3] = {0, 1, 2};

    set_vertices();
    list[0] = A;
    list[1] = B;
    list[2] = C;
    grDrawPolygon(3, NULL, list);
    grDrawPolygon(3, indices, NULL);
    grDrawPolygonVertexList(3, NULL);
    grDrawPlanarPolygon(3, NULL, list);
    grDrawPlanarPolygon(3, indices, NULL);
    grDrawPlanarPolygonVertexList(3, NULL);
    grAADrawPolygon(3, NULL, list);
    grAADrawPolygon(3, indices, NULL);
    grAADrawPolygonVertexList(3, NULL);
    guDrawPolygonVertexListWithClip(3, NULL);
    return 1;
}

static int null_library_pointers(void)
{
    grGlideGetVersion(NULL);
    grGlideGetState(NULL);
    grGlideSetState(NULL);
    grSstPerfStats(NULL);
    grTriStats(NULL, NULL);
    grSstVidMode(0, NULL);
    grFogTable(NULL);
    guMovieSetName(NULL);
    return !grSstQueryBoards(NULL) && !grSstQueryHardware(NULL);
}

static int null_error_callback(void)
{
    grErrorSetCallback(NULL); /* back to the default; nothing is wrong now */
    return draws_correctly();
}

static int null_texture_pointers(void)
{
    GrTexInfo empty = {GR_LOD_1, GR_LOD_256, GR_ASPECT_1x1, GR_TEXFMT_RGB_565, NULL};

    grTexSource(GR_TMU0, 0, GR_MIPMAPLEVELMASK_BOTH, NULL);
    grTexDownloadMipMap(GR_TMU0, 0, GR_MIPMAPLEVELMASK_BOTH, NULL);
    grTexDownloadMipMap(GR_TMU0, 0, GR_MIPMAPLEVELMASK_BOTH, &empty);
    grTexDownloadMipMapLevel(GR_TMU0, 0, GR_LOD_256, GR_LOD_256, GR_ASPECT_1x1,
                             GR_TEXFMT_RGB_565, GR_MIPMAPLEVELMASK_BOTH, NULL);
    grTexDownloadMipMapLevelPartial(GR_TMU0, 0, GR_LOD_256, GR_LOD_256, GR_ASPECT_1x1,
                                    GR_TEXFMT_RGB_565, GR_MIPMAPLEVELMASK_BOTH, NULL, 0, 255);
    grTexDownloadTable(GR_TMU0, GR_TEXTABLE_PALETTE, NULL);
    grTexDownloadTable(GR_TMU0, GR_TEXTABLE_NCC0, NULL);
    grTexDownloadTablePartial(GR_TMU0, GR_TEXTABLE_PALETTE, NULL, 0, 255);
    grTexMultibaseAddress(GR_TMU0, GR_TEXBASE_256, 0, GR_MIPMAPLEVELMASK_BOTH, NULL);
    ConvertAndDownloadRle(GR_TMU0, 0, GR_LOD_8, GR_LOD_8, GR_ASPECT_1x1, GR_TEXFMT_RGB_565,
                          GR_MIPMAPLEVELMASK_BOTH, NULL, 8, 0, 0, 8, 8, 8, 8, NULL);
    return grTexTextureMemRequired(GR_MIPMAPLEVELMASK_BOTH, NULL) == 0;
}

static int null_utility_pointers(void)
{
    GrMipMapId_t id = guTexAllocateMemory(GR_TMU0, GR_MIPMAPLEVELMASK_BOTH, 8, 8,
        GR_TEXFMT_RGB_565, GR_MIPMAP_NEAREST, GR_LOD_1, GR_LOD_8, GR_ASPECT_1x1,
        GR_TEXTURECLAMP_WRAP, GR_TEXTURECLAMP_WRAP, GR_TEXTUREFILTER_BILINEAR,
        GR_TEXTUREFILTER_BILINEAR, 0.0f, FXFALSE);
    const void *nothing = NULL;
    Gu3dfInfo info;

    memset(&info, 0, sizeof info);
    guFogGenerateExp(NULL, 0.1f);
    guFogGenerateExp2(NULL, 0.1f);
    guFogGenerateLinear(NULL, 1.0f, 100.0f);
    guTexDownloadMipMap(id, NULL, NULL);
    guTexDownloadMipMapLevel(id, GR_LOD_8, NULL);
    guTexDownloadMipMapLevel(id, GR_LOD_8, &nothing);
    guFbReadRegion(0, 0, 8, 8, NULL, 16);
    guFbWriteRegion(0, 0, 8, 8, NULL, 16);
    return !gu3dfGetInfo(NULL, &info) && !gu3dfGetInfo("no such file.3df", NULL)
        && !gu3dfLoad(NULL, &info) && !gu3dfLoad("no such file.3df", NULL)
        && !gu3dfGetInfo("no such file.3df", &info) && guEncodeRLE16(NULL, NULL, 8, 8) == 0;
}

static int null_frame_buffer_pointers(void)
{
    return !grLfbLock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER, GR_LFBWRITEMODE_565,
                      GR_ORIGIN_UPPER_LEFT, FXFALSE, NULL)
        && !grLfbReadRegion(GR_BUFFER_BACKBUFFER, 0, 0, 8, 8, 16, NULL)
        && !grLfbWriteRegion(GR_BUFFER_BACKBUFFER, 0, 0, GR_LFB_SRC_FMT_565, 8, 8, 16, NULL);
}

/* --- frame buffer locks ------------------------------------------------------ */

static FxBool lock(GrLock_t type, GrBuffer_t buffer, GrLfbWriteMode_t mode, GrLfbInfo_t *info)
{
    memset(info, 0, sizeof *info);
    info->size = sizeof *info;
    return grLfbLock(type, buffer, mode, GR_ORIGIN_UPPER_LEFT, FXFALSE, info);
}

static int double_lock(void)
{
    GrLfbInfo_t info;

    return lock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER, GR_LFBWRITEMODE_565, &info)
        && !lock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER, GR_LFBWRITEMODE_565, &info)
        && !lock(GR_LFB_WRITE_ONLY, GR_BUFFER_FRONTBUFFER, GR_LFBWRITEMODE_565, &info)
        && grLfbUnlock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER)
        && !grLfbUnlock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER);
}

static int read_and_write_locks_coexist(void)
{
    GrLfbInfo_t info, other;

    return lock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER, GR_LFBWRITEMODE_565, &info)
        && lock(GR_LFB_READ_ONLY, GR_BUFFER_FRONTBUFFER, GR_LFBWRITEMODE_ANY, &other)
        && info.strideInBytes == 2048 && other.strideInBytes == 2048
        && grLfbUnlock(GR_LFB_READ_ONLY, GR_BUFFER_FRONTBUFFER)
        && grLfbUnlock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER);
}

static int unlock_without_lock(void)
{
    int refused = !grLfbUnlock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER);

    return told_when_checking("grLfbUnlock") && refused
        && !grLfbUnlock(GR_LFB_READ_ONLY, GR_BUFFER_BACKBUFFER)
        && !grLfbUnlock(0x7f, GR_BUFFER_BACKBUFFER);
}

static int buffer_and_mode_must_fit(void)
{
    GrLfbInfo_t info;
    int mode;

    for (mode = -1; mode < 0x20; mode++) {
        int reserved = mode < 0 || mode == 3 || (mode > 5 && mode < 0xc) || mode > 0xf;
        if (reserved && lock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER, mode, &info)) {
            printf("  mode %d was accepted\n", mode);
            return 0;
        }
    }
    return !lock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER, GR_LFBWRITEMODE_ZA16, &info)
        && !lock(GR_LFB_WRITE_ONLY, GR_BUFFER_AUXBUFFER, GR_LFBWRITEMODE_565, &info)
        && !lock(GR_LFB_WRITE_ONLY, GR_BUFFER_AUXBUFFER, GR_LFBWRITEMODE_8888, &info)
        && !lock(GR_LFB_WRITE_ONLY, 99, GR_LFBWRITEMODE_565, &info)
        && !lock(GR_LFB_READ_ONLY, -1, GR_LFBWRITEMODE_ANY, &info)
        && lock(GR_LFB_WRITE_ONLY, GR_BUFFER_AUXBUFFER, GR_LFBWRITEMODE_ANY, &info)
        && info.writeMode == GR_LFBWRITEMODE_ZA16;
}

static int use_while_locked(void)
{
    GrLfbInfo_t info;

    if (!lock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER, GR_LFBWRITEMODE_888, &info)
        || info.strideInBytes != 4096) {
        return 0;
    }
    memset(info.lfbPtr, 0xff, (size_t)info.strideInBytes * 480); /* all of it is ours */
    draw_one_of_each();
    call_one_of_each();
    return grLfbUnlock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER);
}

static int close_while_locked(void)
{
    GrLfbInfo_t info;

    if (!lock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER, GR_LFBWRITEMODE_565, &info)) {
        return 0;
    }
    grSstWinClose();
    return !grLfbUnlock(GR_LFB_WRITE_ONLY, GR_BUFFER_BACKBUFFER) && abuse_open()
        && draws_correctly();
}

static int regions_off_the_screen(void)
{
    static FxU16 pixels[1024 * 8];
    static const FxU32 at[][4] = { /* x, y, width, height */
        {640, 0, 1, 1}, {0, 480, 1, 1}, {636, 476, 8, 8}, {0xffffffff, 0, 8, 8},
        {0, 0xffffffff, 8, 8}, {0xfffffffc, 0xfffffffc, 8, 8}, {0, 0, 0, 0}, {5, 5, 0, 8}
    };
    size_t i;

    for (i = 0; i < COUNT_OF(at); i++) {
        const FxU32 *r = at[i];
        grLfbReadRegion(GR_BUFFER_BACKBUFFER, r[0], r[1], r[2], r[3], 2048, pixels);
        grLfbWriteRegion(GR_BUFFER_BACKBUFFER, r[0], r[1], GR_LFB_SRC_FMT_565, r[2], r[3], 2048, pixels);
        grLfbWriteRegion(GR_BUFFER_AUXBUFFER, r[0], r[1], GR_LFB_SRC_FMT_ZA16, r[2], r[3], 2048, pixels);
    }
    return !grLfbWriteRegion(GR_BUFFER_BACKBUFFER, 0, 0, GR_LFB_SRC_FMT_RLE16, 8, 8, 16, pixels)
        && !grLfbWriteRegion(GR_BUFFER_BACKBUFFER, 0, 0, 0x55, 8, 8, 16, pixels)
        && !grLfbWriteRegion(77, 0, 0, GR_LFB_SRC_FMT_565, 8, 8, 16, pixels)
        && !grLfbReadRegion(-5, 0, 0, 8, 8, 16, pixels);
}

static int old_access_in_disorder(void)
{
    grLfbEnd();
    grLfbBegin();
    grLfbBegin();
    grLfbGetReadPtr(99);
    grLfbGetWritePtr(-1);
    grLfbWriteMode(99);
    grLfbBypassMode(99);
    grLfbOrigin(99);
    grLfbGetWritePtr(GR_BUFFER_BACKBUFFER);
    grLfbEnd();
    grLfbEnd();
    return 1;
}

int main(void)
{
    static const AbuseCheck checks[] = {
        {"drawing_before_init", drawing_before_init},
        {"calls_before_init", calls_before_init},
        {"state_before_init", state_before_init},
        {"query_boards_before_init", query_boards_before_init},
        {"open_before_init", open_before_init},
        {"close_before_init", close_before_init},
        {"drawing_before_open", drawing_before_open},
        {"drawing_before_open_is_told", drawing_before_open_is_told},
        {"drawing_after_close", drawing_after_close},
        {"drawing_after_shutdown", drawing_after_shutdown},
        {"double_init", double_init},
        {"double_open", double_open},
        {"double_close", double_close},
        {"many_opens", many_opens},
        {"open_with_bad_arguments", open_with_bad_arguments},
        {"select_out_of_range", select_out_of_range},
        {"null_vertices", null_vertices},
        {"null_vertex_is_told", null_vertex_is_told},
        {"null_vertex_lists", null_vertex_lists},
        {"null_library_pointers", null_library_pointers},
        {"null_error_callback", null_error_callback},
        {"null_texture_pointers", null_texture_pointers},
        {"null_utility_pointers", null_utility_pointers},
        {"null_frame_buffer_pointers", null_frame_buffer_pointers},
        {"double_lock", double_lock},
        {"read_and_write_locks_coexist", read_and_write_locks_coexist},
        {"unlock_without_lock", unlock_without_lock},
        {"buffer_and_mode_must_fit", buffer_and_mode_must_fit},
        {"use_while_locked", use_while_locked},
        {"close_while_locked", close_while_locked},
        {"regions_off_the_screen", regions_off_the_screen},
        {"old_access_in_disorder", old_access_in_disorder}
    };

    return run_abuse(checks, COUNT_OF(checks));
}
