/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * bad_values.c: numbers no program should pass: NaN and infinite coordinates,
 * unknown enumerants, texture units and addresses that do not exist, clip
 * windows off the screen, states full of garbage, polygons of many vertices.
 */
#include "abuse.h"

/* Not a macro: some compilers refuse to divide constants by zero. */
static float quotient(float a, float b)
{
    return a / b;
}

#define HOSTILE_COUNT 16

static float hostile(int i)
{
    static const float values[HOSTILE_COUNT - 3] = {
        0.0f, -0.0f, 3.0e38f, -3.0e38f, 1.0e-40f, -1.0e-40f, 3.0e9f, -3.0e9f,
        786432.0f, 2048.0f, -2048.0625f, 65536.5f, -1.0f
    };
    float zero = 0.0f;

    switch (i) {
    case 0: return quotient(zero, zero);
    case 1: return quotient(1.0f, zero);
    case 2: return quotient(-1.0f, zero);
    default: return values[i - 3];
    }
}

/* Values that are no enumerant of any type. */
static const int WILD[] = {-1, 0x11, 0x66, 99, 0x1000, 0x7fffffff, -0x7fffffff - 1};

/* --- vertices ----------------------------------------------------------------- */

static void draw_all(const GrVertex *v)
{
    grDrawPoint(&v[0]);
    grDrawLine(&v[0], &v[1]);
    grDrawTriangle(&v[0], &v[1], &v[2]);
    grDrawPolygonVertexList(3, v);
    grDrawPlanarPolygonVertexList(3, v);
    grAADrawPoint(&v[0]);
    grAADrawLine(&v[1], &v[2]);
    grAADrawTriangle(&v[0], &v[1], &v[2], FXTRUE, FXTRUE, FXTRUE);
    guDrawTriangleWithClip(&v[0], &v[1], &v[2]);
    guAADrawTriangleWithClip(&v[0], &v[1], &v[2]);
    guDrawPolygonVertexListWithClip(3, v);
}

/* Textured, fogged, blended, depth tested: every parameter is in use. */
static void use_everything(void)
{
    static FxU16 texels[64];
    GrTexInfo info = {GR_LOD_8, GR_LOD_8, GR_ASPECT_1x1, GR_TEXFMT_RGB_565, NULL};
    GrFog_t fog[GR_FOG_TABLE_SIZE];

    info.data = texels;
    grTexDownloadMipMap(GR_TMU0, 0, GR_MIPMAPLEVELMASK_BOTH, &info);
    grTexSource(GR_TMU0, 0, GR_MIPMAPLEVELMASK_BOTH, &info);
    grTexCombineFunction(GR_TMU0, GR_TEXTURECOMBINE_DECAL);
    grTexFilterMode(GR_TMU0, GR_TEXTUREFILTER_BILINEAR, GR_TEXTUREFILTER_BILINEAR);
    grTexMipMapMode(GR_TMU0, GR_MIPMAP_NEAREST, FXTRUE);
    guColorCombineFunction(GR_COLORCOMBINE_TEXTURE_TIMES_ITRGB_ADD_ALPHA);
    guAlphaSource(GR_ALPHASOURCE_TEXTURE_ALPHA_TIMES_ITERATED_ALPHA);
    grAlphaBlendFunction(GR_BLEND_SRC_ALPHA, GR_BLEND_ONE_MINUS_SRC_ALPHA,
                         GR_BLEND_ONE, GR_BLEND_ZERO);
    guFogGenerateExp(fog, 0.01f);
    grFogTable(fog);
    grFogMode(GR_FOG_WITH_TABLE);
    grDepthBufferMode(GR_DEPTHBUFFER_WBUFFER);
    grDepthBufferFunction(GR_CMP_LEQUAL);
    grDepthMask(FXTRUE);
}

/* Every field of one vertex in turn takes every hostile value. */
static int hostile_vertex_fields(void)
{
    int field, value;

    use_everything();
    for (field = 0; field < (int)(sizeof(GrVertex) / sizeof(float)); field++) {
        for (value = 0; value < HOSTILE_COUNT; value++) {
            GrVertex v[3];
            float bad = hostile(value);

            v[0] = abuse_vertex(10, 10);
            v[1] = abuse_vertex(60, 15);
            v[2] = abuse_vertex(20, 70);
            memcpy((char *)&v[field % 3] + sizeof(float) * (size_t)field, &bad, sizeof bad);
            draw_all(v);
        }
    }
    return 1;
}

/* Positions of all three vertices take hostile values together. */
static int hostile_positions(void)
{
    int i, j, k;

    for (i = 0; i < HOSTILE_COUNT; i++) {
        for (j = 0; j < HOSTILE_COUNT; j++) {
            for (k = 0; k < 4; k++) {
                GrVertex v[3];
                v[0] = abuse_vertex(hostile(i), hostile(j));
                v[1] = abuse_vertex(hostile((i + k) % HOSTILE_COUNT), 20.0f);
                v[2] = abuse_vertex(30.0f, hostile((j + 2 * k) % HOSTILE_COUNT));
                draw_all(v);
            }
        }
    }
    return 1;
}

static int snap_bias_is_harmless(void)
{
    const float bias = 786432.0f;
    GrVertex a = abuse_vertex(100 + bias, 100 + bias), b = abuse_vertex(300 + bias, 100 + bias);
    GrVertex c = abuse_vertex(100 + bias, 300 + bias);

    grBufferClear(0xff000000, 0, 0);
    grDrawTriangle(&a, &b, &c);
    return abuse_pixel(150, 150) == 0xffff && abuse_pixel(90, 150) == 0;
}

static int nan_draws_nothing(void)
{
    GrVertex a = abuse_vertex(hostile(0), 100), b = abuse_vertex(300, 100), c = abuse_vertex(100, 300);
    FxU32 x, y;

    grBufferClear(0xff000000, 0, 0);
    grDrawTriangle(&a, &b, &c);
    for (y = 0; y < 480; y += 16) {
        for (x = 0; x < 640; x += 16) {
            if (abuse_pixel(x, y) != 0) {
                return 0;
            }
        }
    }
    return 1;
}

/* --- polygons ------------------------------------------------------------------ */

static int polygon_counts(void)
{
    static const int counts[] = {-1, 0, 1, 2, -0x7fffffff - 1};
    GrVertex v[3];
    int indices[3] = {0, 1, 2};
    size_t i;

    v[0] = abuse_vertex(10, 10);
    v[1] = abuse_vertex(60, 15);
    v[2] = abuse_vertex(20, 70);
    grBufferClear(0xff000000, 0, 0);
    for (i = 0; i < COUNT_OF(counts); i++) {
        grDrawPolygon(counts[i], indices, v);
        grDrawPolygonVertexList(counts[i], v);
        grDrawPlanarPolygon(counts[i], indices, v);
        grDrawPlanarPolygonVertexList(counts[i], v);
        grAADrawPolygon(counts[i], indices, v);
        grAADrawPolygonVertexList(counts[i], v);
        guDrawPolygonVertexListWithClip(counts[i], v);
    }
    return abuse_pixel(25, 25) == 0;
}

/* A hundred thousand corners, all there: a very round triangle. */
static int huge_polygon(void)
{
    const int count = 100000;
    GrVertex *v = malloc((size_t)count * sizeof *v);
    int *indices = malloc((size_t)count * sizeof *indices);
    int i;

    if (v == NULL || indices == NULL) {
        free(v);
        free(indices);
        return 0;
    }
    for (i = 0; i < count; i++) {
        float t = (float)i / (float)count;
        v[i] = abuse_vertex(100.0f + 400.0f * t, 100.0f + 800.0f * t * (1.0f - t));
        indices[i] = i;
    }
    grBufferClear(0xff000000, 0, 0);
    grDrawPolygonVertexList(count, v);
    grDrawPolygon(count, indices, v);
    grDrawPlanarPolygonVertexList(count, v);
    grDrawPlanarPolygon(count, indices, v);
    grAADrawPolygonVertexList(count, v);
    guDrawPolygonVertexListWithClip(count, v);
    free(v);
    free(indices);
    return abuse_pixel(300, 150) == 0xffff;
}

/* --- enumerants ------------------------------------------------------------------ */

static void set_state_to(int n)
{
    grAlphaBlendFunction(n, n, n, n);
    grAlphaCombine(n, n, n, n, n);
    grAlphaControlsITRGBLighting(n);
    grAlphaTestFunction(n);
    grChromakeyMode(n);
    grColorCombine(n, n, n, n, n);
    grColorMask(n, n);
    grCullMode(n);
    grDepthBiasLevel((FxI16)n);
    grDepthBufferFunction(n);
    grDepthBufferMode(n);
    grDepthMask(n);
    grDitherMode(n);
    grFogMode(n);
    grRenderBuffer(n);
    grSstOrigin(n);
    grSstControl((FxU32)n);
    grSstControlMode((FxU32)n);
    grSstPassthruMode(n);
    grHints((FxU32)n, (FxU32)n);
    grCheckForRoom(n);
    grLfbWriteColorFormat(n);
    grLfbWriteColorSwizzle(n, n);
    guAlphaSource(n);
    guColorCombineFunction(n);
    guTexCombineFunction(GR_TMU0, n);
    guMPTexCombineFunction(n);
}

static void set_texture_to(int n)
{
    GrTexInfo info = {GR_LOD_1, GR_LOD_256, GR_ASPECT_1x1, GR_TEXFMT_RGB_565, NULL};

    grTexClampMode(GR_TMU0, n, n);
    grTexCombine(GR_TMU0, n, n, n, n, n, n);
    grTexCombineFunction(GR_TMU0, n);
    grTexFilterMode(GR_TMU0, n, n);
    grTexMipMapMode(GR_TMU0, n, n);
    grTexNCCTable(GR_TMU0, (FxU32)n);
    grTexMultibase(GR_TMU0, n);
    grTexCalcMemRequired(n, n, n, n);
    grTexTextureMemRequired((FxU32)n, &info);
    info.smallLod = info.largeLod = n;
    info.aspectRatio = n;
    info.format = n;
    grTexTextureMemRequired(GR_MIPMAPLEVELMASK_BOTH, &info);
    grTexSource(GR_TMU0, 0, (FxU32)n, &info);
    grTexMultibaseAddress(GR_TMU0, (FxU32)n, 0, (FxU32)n, &info);
    grTexDownloadMipMap(GR_TMU0, 0, (FxU32)n, &info);
}

static int unknown_enumerants(void)
{
    GrVertex v[3];
    size_t i;

    v[0] = abuse_vertex(10, 10);
    v[1] = abuse_vertex(60, 15);
    v[2] = abuse_vertex(20, 70);
    for (i = 0; i < COUNT_OF(WILD); i++) {
        set_state_to(WILD[i]);
        draw_all(v);
        grBufferClear(0, 0, 0);
        set_texture_to(WILD[i]);
        draw_all(v);
        grBufferSwap(1);
    }
    return 1;
}

static int unknown_enumerants_are_told(void)
{
    int right = 1;

    grCullMode(99);
    right &= told_when_checking("grCullMode");
    grDepthBufferFunction(-1);
    right &= told_when_checking("grDepthBufferFunction");
    grColorCombine(0x20, GR_COMBINE_FACTOR_ONE, GR_COMBINE_LOCAL_NONE, GR_COMBINE_OTHER_NONE, FXFALSE);
    right &= told_when_checking("grColorCombine");
    grTexFilterMode(GR_TMU0, 7, 7);
    right &= told_when_checking("grTexFilterMode");
    grBufferSwap(-1);
    right &= told_when_checking("grBufferSwap");
    grBufferSwap(256);
    right &= told_when_checking("grBufferSwap");
    return right;
}

/* An unknown enumerant leaves the state as it was. */
static int unknown_enumerants_change_nothing(void)
{
    GrVertex a = abuse_vertex(100, 100), b = abuse_vertex(300, 100), c = abuse_vertex(100, 300);

    grBufferClear(0xff000000, 0, 0);
    grCullMode(99);
    grAlphaTestFunction(0x20);
    grDrawTriangle(&a, &b, &c);
    return abuse_pixel(150, 150) == 0xffff;
}

/* --- texture units, addresses, tables --------------------------------------------- */

static void use_unit(int tmu)
{
    static FxU16 texels[64];
    static FxU32 palette[256];
    GrTexInfo info = {GR_LOD_8, GR_LOD_8, GR_ASPECT_1x1, GR_TEXFMT_RGB_565, NULL};

    info.data = texels;
    grTexMinAddress(tmu);
    grTexMaxAddress(tmu);
    grTexSource(tmu, 0, GR_MIPMAPLEVELMASK_BOTH, &info);
    grTexDownloadMipMap(tmu, 0, GR_MIPMAPLEVELMASK_BOTH, &info);
    grTexDownloadMipMapLevel(tmu, 0, GR_LOD_8, GR_LOD_8, GR_ASPECT_1x1, GR_TEXFMT_RGB_565,
                             GR_MIPMAPLEVELMASK_BOTH, texels);
    grTexDownloadMipMapLevelPartial(tmu, 0, GR_LOD_8, GR_LOD_8, GR_ASPECT_1x1, GR_TEXFMT_RGB_565,
                                    GR_MIPMAPLEVELMASK_BOTH, texels, 0, 7);
    grTexDownloadTable(tmu, GR_TEXTABLE_PALETTE, palette);
    grTexDownloadTablePartial(tmu, GR_TEXTABLE_PALETTE, palette, 0, 255);
    grTexNCCTable(tmu, GR_NCCTABLE_NCC0);
    grTexClampMode(tmu, GR_TEXTURECLAMP_WRAP, GR_TEXTURECLAMP_WRAP);
    grTexCombine(tmu, 1, 0, 1, 0, FXFALSE, FXFALSE);
    grTexCombineFunction(tmu, GR_TEXTURECOMBINE_DECAL);
    guTexCombineFunction(tmu, GR_TEXTURECOMBINE_DECAL);
    grTexDetailControl(tmu, 0, 1, 1.0f);
    grTexFilterMode(tmu, 1, 1);
    grTexLodBiasValue(tmu, 0.0f);
    grTexMipMapMode(tmu, 1, FXFALSE);
    grTexMultibase(tmu, FXTRUE);
    grTexMultibaseAddress(tmu, GR_TEXBASE_256, 0, GR_MIPMAPLEVELMASK_BOTH, &info);
    guTexMemQueryAvail(tmu);
    guTexGetCurrentMipMap(tmu);
    guMPTexSource(tmu, 0);
}

static int wrong_texture_units(void)
{
    size_t i;

    use_unit(3);
    for (i = 0; i < COUNT_OF(WILD); i++) {
        use_unit(WILD[i]);
        grSstConfigPipeline(WILD[i], 65, 0xffffffffU);
    }
    return 1;
}

static int wrong_texture_unit_is_told(void)
{
    abuse_messages = 0;
    grTexCombineFunction(99, GR_TEXTURECOMBINE_DECAL);
    return told_when_checking("grTexCombineFunction");
}

static int addresses_beyond_memory(void)
{
    static FxU16 texels[256 * 256 * 2];
    static const FxU32 starts[] = {3, 0x1ffff8, 0x200000, 0x3ffff8, 0x400000, 0x7ffffff8, 0xfffffff8, 0xffffffff};
    GrTexInfo info = {GR_LOD_1, GR_LOD_256, GR_ASPECT_1x1, GR_TEXFMT_RGB_565, NULL};
    GrVertex v[3];
    size_t i;

    info.data = texels;
    use_everything();
    v[0] = abuse_vertex(10, 10);
    v[1] = abuse_vertex(60, 15);
    v[2] = abuse_vertex(20, 70);
    for (i = 0; i < COUNT_OF(starts); i++) {
        grTexDownloadMipMap(GR_TMU0, starts[i], GR_MIPMAPLEVELMASK_BOTH, &info);
        grTexDownloadMipMapLevel(GR_TMU0, starts[i], GR_LOD_256, GR_LOD_256, GR_ASPECT_1x1,
                                 GR_TEXFMT_RGB_565, GR_MIPMAPLEVELMASK_ODD, texels);
        grTexSource(GR_TMU0, starts[i], GR_MIPMAPLEVELMASK_BOTH, &info);
        draw_all(v);
        grTexMultibaseAddress(GR_TMU0, GR_TEXBASE_128, starts[i], GR_MIPMAPLEVELMASK_EVEN, &info);
        grTexMultibase(GR_TMU0, FXTRUE);
        draw_all(v);
        grTexMultibase(GR_TMU0, FXFALSE);
    }
    return 1;
}

static int address_beyond_memory_is_told(void)
{
    GrTexInfo info = {GR_LOD_8, GR_LOD_8, GR_ASPECT_1x1, GR_TEXFMT_RGB_565, NULL};

    abuse_messages = 0;
    grTexSource(GR_TMU0, 0x7fe00000, GR_MIPMAPLEVELMASK_BOTH, &info);
    return told_when_checking("grTexSource");
}

static int levels_and_rows_out_of_order(void)
{
    static FxU16 texels[256 * 256];
    static const int rows[][2] = {{-1, 7}, {0, 8}, {7, 0}, {8, 8}, {0, 0x7fffffff}, {-0x7fffffff, 3}};
    GrTexInfo info = {GR_LOD_256, GR_LOD_1, GR_ASPECT_1x1, GR_TEXFMT_RGB_565, NULL};
    size_t i;

    info.data = texels; /* small and large are exchanged */
    grTexSource(GR_TMU0, 0, GR_MIPMAPLEVELMASK_BOTH, &info);
    grTexDownloadMipMap(GR_TMU0, 0, GR_MIPMAPLEVELMASK_BOTH, &info);
    grTexDownloadMipMapLevel(GR_TMU0, 0, GR_LOD_256, GR_LOD_8, GR_ASPECT_1x1, GR_TEXFMT_RGB_565,
                             GR_MIPMAPLEVELMASK_BOTH, texels);
    for (i = 0; i < COUNT_OF(rows); i++) {
        grTexDownloadMipMapLevelPartial(GR_TMU0, 0, GR_LOD_8, GR_LOD_8, GR_ASPECT_1x1,
                                        GR_TEXFMT_RGB_565, GR_MIPMAPLEVELMASK_BOTH, texels,
                                        rows[i][0], rows[i][1]);
    }
    return 1;
}

static int tables_out_of_range(void)
{
    static FxU32 table[256];
    static const int ranges[][2] = {{-1, 5}, {0, 256}, {255, 0}, {300, 400}, {0, 0x7fffffff}, {-0x7fffffff, 0}};
    size_t i;

    for (i = 0; i < COUNT_OF(ranges); i++) {
        grTexDownloadTablePartial(GR_TMU0, GR_TEXTABLE_PALETTE, table, ranges[i][0], ranges[i][1]);
        grTexDownloadTablePartial(GR_TMU0, GR_TEXTABLE_NCC0, table, ranges[i][0], ranges[i][1]);
    }
    for (i = 0; i < COUNT_OF(WILD); i++) {
        grTexDownloadTable(GR_TMU0, (FxU32)WILD[i], table);
        grTexDownloadTablePartial(GR_TMU0, (FxU32)WILD[i], table, 0, 255);
    }
    return 1;
}

/* --- the rest ----------------------------------------------------------------------- */

static int clip_windows(void)
{
    static const FxU32 windows[][4] = {
        {0, 0, 0, 0}, {0, 0, 0xffffffff, 0xffffffff}, {0xffffffff, 0xffffffff, 0, 0},
        {400, 300, 100, 100}, {639, 479, 640, 480}, {640, 480, 700, 500},
        {0x80000000, 0, 640, 480}, {1023, 1023, 1024, 1024}
    };
    size_t i;

    for (i = 0; i < COUNT_OF(windows); i++) {
        const FxU32 *w = windows[i];
        GrVertex v[3];

        v[0] = abuse_vertex(-100, -100);
        v[1] = abuse_vertex(1500, -100);
        v[2] = abuse_vertex(-100, 1500);
        grClipWindow(w[0], w[1], w[2], w[3]);
        grBufferClear(0xff00ff00, 0, 0);
        draw_all(v);
    }
    return 1;
}

static int empty_clip_window_draws_nothing(void)
{
    GrVertex a = abuse_vertex(100, 100), b = abuse_vertex(300, 100), c = abuse_vertex(100, 300);

    grBufferClear(0xff000000, 0, 0);
    grClipWindow(400, 300, 100, 100);
    grBufferClear(0xffffffff, 0, 0);
    grDrawTriangle(&a, &b, &c);
    return abuse_pixel(150, 150) == 0 && abuse_pixel(400, 300) == 0 && abuse_pixel(0, 0) == 0;
}

static int hostile_scalars(void)
{
    GrFog_t fog[GR_FOG_TABLE_SIZE];
    int i;

    for (i = 0; i < HOSTILE_COUNT; i++) {
        float f = hostile(i);

        grTexLodBiasValue(GR_TMU0, f);
        grTexDetailControl(GR_TMU0, (i - 8) * 0x10000000, 255, f);
        grConstantColorValue4(f, f, f, f);
        grGammaCorrectionValue(f);
        guFogGenerateExp(fog, f);
        guFogGenerateExp2(fog, f);
        guFogGenerateLinear(fog, f, f);
        guFogGenerateLinear(fog, f, hostile((i + 5) % HOSTILE_COUNT));
        grFogTable(fog);
        grSplash(f, f, f, f, (FxU32)i);
    }
    guFogTableIndexToW(-1);
    guFogTableIndexToW(64);
    guFogTableIndexToW(0x7fffffff);
    guFogTableIndexToW(-0x7fffffff - 1);
    return 1;
}

static int wild_registers(void)
{
    static const FxU32 values[] = {0, 0xffffffff, 0x80000000, 0x7fffffff, 0x55555555};
    GrVertex v[3];
    FxU32 reg;
    size_t i;

    v[0] = abuse_vertex(10, 10);
    v[1] = abuse_vertex(60, 15);
    v[2] = abuse_vertex(20, 70);
    for (i = 0; i < COUNT_OF(values); i++) {
        for (reg = 0; reg < 260; reg++) {
            grSstConfigPipeline(GR_FBI, reg, values[i]);
            grSstConfigPipeline(GR_TMU0, reg, values[i]);
        }
        draw_all(v);
        grBufferClear(0, 0, 0);
    }
    grSstConfigPipeline(GR_FBI, 0xffffffff, 1);
    return 1;
}

static int garbage_state(void)
{
    GrVertex v[3];
    GrState state;
    FxU32 seed = 1;
    int round;
    size_t i;

    v[0] = abuse_vertex(10, 10);
    v[1] = abuse_vertex(60, 15);
    v[2] = abuse_vertex(20, 70);
    for (round = 0; round < 64; round++) {
        for (i = 0; i < sizeof state.pad; i++) {
            seed = seed * 1664525U + 1013904223U;
            state.pad[i] = (char)(round == 0 ? 0 : round == 1 ? -1 : (int)(seed >> 24) - 128);
        }
        grGlideSetState(&state);
        draw_all(v);
        grBufferClear(0, 0, 0);
    }
    return 1;
}

/* A state may lie at any address; exactly 312 bytes are written. */
static int state_without_alignment(void)
{
    char memory[sizeof(GrState) + 16];
    size_t offset;

    for (offset = 1; offset < 8; offset++) {
        memset(memory, 0x5a, sizeof memory);
        grGlideGetState((GrState *)(void *)(memory + offset));
        if (memory[offset - 1] != 0x5a || memory[offset + sizeof(GrState)] != 0x5a) {
            return 0;
        }
        grGlideSetState((const GrState *)(const void *)(memory + offset));
    }
    return draws_correctly();
}

static int mip_map_ids(void)
{
    static const GrMipMapId_t ids[] = {1, 1023, 1024, 0x7fffffff, 0xffffffff};
    static FxU16 texels[64];
    const void *source;
    size_t i;

    for (i = 0; i < COUNT_OF(ids); i++) {
        guTexSource(ids[i]);
        guTexDownloadMipMap(ids[i], texels, NULL);
        source = texels;
        guTexDownloadMipMapLevel(ids[i], GR_LOD_8, &source);
        guMPTexSource(GR_TMU0, ids[i]);
        if (guTexGetMipMapInfo(ids[i]) != NULL
            || guTexChangeAttributes(ids[i], -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1)) {
            return 0;
        }
    }
    return 1;
}

/* Asking for memory until there is none, and in ways that make no sense. */
static int texture_manager_runs_out(void)
{
    int i, served = 0;

    for (i = 0; i < 4000; i++) {
        GrMipMapId_t id = guTexAllocateMemory(GR_TMU0, GR_MIPMAPLEVELMASK_BOTH, 256, 256,
            GR_TEXFMT_RGB_565, GR_MIPMAP_NEAREST, GR_LOD_1, GR_LOD_256, GR_ASPECT_1x1,
            GR_TEXTURECLAMP_WRAP, GR_TEXTURECLAMP_WRAP, GR_TEXTUREFILTER_BILINEAR,
            GR_TEXTUREFILTER_BILINEAR, 0.0f, FXFALSE);
        served += id != GR_NULL_MIPMAP_HANDLE;
    }
    for (i = 0; i < (int)COUNT_OF(WILD); i++) {
        int n = WILD[i];
        guTexAllocateMemory(n, (FxU8)n, n, n, n, n, n, n, n, n, n, n, n, hostile(i), n);
    }
    return served < 100; /* 174 KB each: a dozen fit into 2 MB */
}

int main(void)
{
    static const AbuseCheck checks[] = {
        {"hostile_vertex_fields", hostile_vertex_fields},
        {"hostile_positions", hostile_positions},
        {"snap_bias_is_harmless", snap_bias_is_harmless},
        {"nan_draws_nothing", nan_draws_nothing},
        {"polygon_counts", polygon_counts},
        {"huge_polygon", huge_polygon},
        {"unknown_enumerants", unknown_enumerants},
        {"unknown_enumerants_are_told", unknown_enumerants_are_told},
        {"unknown_enumerants_change_nothing", unknown_enumerants_change_nothing},
        {"wrong_texture_units", wrong_texture_units},
        {"wrong_texture_unit_is_told", wrong_texture_unit_is_told},
        {"addresses_beyond_memory", addresses_beyond_memory},
        {"address_beyond_memory_is_told", address_beyond_memory_is_told},
        {"levels_and_rows_out_of_order", levels_and_rows_out_of_order},
        {"tables_out_of_range", tables_out_of_range},
        {"clip_windows", clip_windows},
        {"empty_clip_window_draws_nothing", empty_clip_window_draws_nothing},
        {"hostile_scalars", hostile_scalars},
        {"wild_registers", wild_registers},
        {"garbage_state", garbage_state},
        {"state_without_alignment", state_without_alignment},
        {"mip_map_ids", mip_map_ids},
        {"texture_manager_runs_out", texture_manager_runs_out}
    };

    grGlideInit();
    abuse_open();
    return run_abuse(checks, COUNT_OF(checks));
}
