/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * meshes.c: arrays of vertices in every mode against single points, lines and
 * triangles; meshes, whose vertices are read when they are drawn.
 */
#include "rave_test.h"

#define WIDTH 160
#define HEIGHT 80
#define COUNT 12

static Target target;
static TQADrawContext *context;
static TQAUInt32 kept[WIDTH * HEIGHT];
static TQAVGouraud v[COUNT];
static TQAVTexture t[COUNT];
static TQATexture *texture;

static void keep(void)
{
    memcpy(kept, target.pixels, sizeof kept);
}

static int is_kept(void)
{
    return memcmp(kept, target.pixels, sizeof kept) == 0;
}

static int is_empty(void)
{
    int i;

    for (i = 0; i < WIDTH * HEIGHT && (target.pixels[i] & 0xffffff) == 0; i++) {
    }
    return i == WIDTH * HEIGHT;
}

static void start(void)
{
    QARenderStart(context, NULL, NULL);
}

static void end(void)
{
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
}

static void make_vertices(void)
{
    int i;

    for (i = 0; i < COUNT; i++) {
        float x = 12 + 12 * (float)i, y = i % 2 ? 62.0f - (float)i : 14.0f + (float)(i * 2);

        v[i] = gv(x, y, 0.9f - 0.05f * (float)i, (float)(i % 3) / 2, (float)(i % 4) / 3,
                  (float)(i % 5) / 4, 1);
        t[i] = tv(x, y, 0.9f - 0.05f * (float)i, (float)(i % 2), (float)i / 4);
        t[i].kd_r = (float)(i % 3) / 2;
    }
}

static void single(TQAVertexMode mode, TQAUInt32 n)
{
    TQAUInt32 i;

    switch (mode) {
    case kQAVertexMode_Point:
        for (i = 0; i < n; i++) {
            QADrawPoint(context, &v[i]);
        }
        break;
    case kQAVertexMode_Line:
        for (i = 0; i + 1 < n; i += 2) {
            QADrawLine(context, &v[i], &v[i + 1]);
        }
        break;
    case kQAVertexMode_Polyline:
        for (i = 0; i + 1 < n; i++) {
            QADrawLine(context, &v[i], &v[i + 1]);
        }
        break;
    case kQAVertexMode_Tri:
        for (i = 0; i + 2 < n; i += 3) {
            QADrawTriGouraud(context, &v[i], &v[i + 1], &v[i + 2], 0);
        }
        break;
    case kQAVertexMode_Strip:
        for (i = 0; i + 2 < n; i++) {
            QADrawTriGouraud(context, &v[i], &v[i + 1], &v[i + 2], 0);
        }
        break;
    default:
        for (i = 0; i + 2 < n; i++) {
            QADrawTriGouraud(context, &v[0], &v[i + 1], &v[i + 2], 0);
        }
        break;
    }
}

static void single_textured(TQAVertexMode mode, TQAUInt32 n)
{
    TQAUInt32 i, step = mode == kQAVertexMode_Tri ? 3 : 1;

    for (i = 0; i + 2 < n; i += step) {
        TQAUInt32 first = mode == kQAVertexMode_Fan ? 0 : i;

        QADrawTriTexture(context, &t[first], &t[i + 1], &t[i + 2], 0);
    }
}

static void check_arrays(void)
{
    static const TQAUInt32 counts[] = {COUNT, COUNT - 1, 3, 2, 1, 0};
    static TQAUInt32 flags[COUNT];
    int mode;
    size_t i;

    flags[1] = kQATriFlags_Backfacing;
    for (mode = 0; mode < kQAVertexMode_NumModes; mode++) {
        for (i = 0; i < sizeof counts / sizeof *counts; i++) {
            start();
            single((TQAVertexMode)mode, counts[i]);
            end();
            keep();
            CHECK((counts[i] >= 3) <= !is_empty());
            start();
            QADrawVGouraud(context, counts[i], (TQAVertexMode)mode, v,
                           mode < kQAVertexMode_Tri ? NULL : flags);
            end();
            CHECK(is_kept());
        }
        if (mode >= kQAVertexMode_Tri) {
            start();
            single_textured((TQAVertexMode)mode, COUNT);
            end();
            keep();
            CHECK(!is_empty());
            start();
            QADrawVTexture(context, COUNT, (TQAVertexMode)mode, t, NULL);
            end();
            CHECK(is_kept());
        }
    }
    start();
    QADrawVGouraud(context, COUNT, (TQAVertexMode)kQAVertexMode_NumModes, v, NULL);
    QADrawVGouraud(context, COUNT, kQAVertexMode_Tri, NULL, NULL);
    QARenderEnd(context, NULL);
    CHECK(is_empty());
}

static void check_meshes(void)
{
    static const TQAIndexedTriangle triangles[4] = {{0, {0, 1, 2}},
                                                    {kQATriFlags_Backfacing, {2, 1, 5}},
                                                    {0, {5, 7, 9}},
                                                    {0, {9, 7, 0}}};
    static const TQAIndexedTriangle beyond[2] = {{0, {0, 1, COUNT}}, {0, {0, 1, 2}}};
    int i;

    start();
    for (i = 0; i < 4; i++) {
        const TQAUInt32 *n = triangles[i].vertices;

        QADrawTriGouraud(context, &v[n[0]], &v[n[1]], &v[n[2]], triangles[i].triangleFlags);
    }
    end();
    keep();
    QASubmitVerticesGouraud(context, COUNT, v);
    start();
    QADrawTriMeshGouraud(context, 4, triangles);
    end();
    CHECK(is_kept());
    /* Vertices are read at the draw call. */
    for (i = 0; i < COUNT; i++) {
        v[i].x += 6;
    }
    start();
    QADrawTriMeshGouraud(context, 4, triangles);
    end();
    CHECK(!is_kept() && !is_empty());
    for (i = 0; i < COUNT; i++) {
        v[i].x -= 6;
    }
    start();
    QADrawTriMeshGouraud(context, 4, triangles);
    end();
    CHECK(is_kept());
    /* A triangle with an index beyond is dropped, and told of. */
    start();
    QADrawTriGouraud(context, &v[0], &v[1], &v[2], 0);
    end();
    keep();
    start();
    QADrawTriMeshGouraud(context, 2, beyond);
    CHECK(QARenderEnd(context, NULL) == kQAParamErr);
    CHECK(is_kept());
    /* Textured meshes have vertices of their own. */
    start();
    for (i = 0; i < 4; i++) {
        const TQAUInt32 *n = triangles[i].vertices;

        QADrawTriTexture(context, &t[n[0]], &t[n[1]], &t[n[2]], 0);
    }
    end();
    keep();
    QASubmitVerticesTexture(context, COUNT, t);
    start();
    QADrawTriMeshTexture(context, 4, triangles);
    end();
    CHECK(is_kept() && !is_empty());
}

int main(void)
{
    static TQAUInt32 texels[4] = {0xffffffffu, 0xff808080u, 0xff4040ffu, 0xffff4040u};

    context = open_usual(&target, WIDTH, HEIGHT);
    background(context, 0, 0, 0);
    QASetFloat(context, kQATag_Width, 3);
    texture = make_texture(engine_for(&target), 0, kQAPixel_ARGB32, 2, 2, 8, texels);
    QASetPtr(context, kQATag_Texture, texture);
    QASetInt(context, kQATag_TextureOp, kQATextureOp_Modulate);
    make_vertices();
    check_arrays();
    check_meshes();
    CHECK(margin_is_clean(&target));
    QATextureDelete(engine_for(&target), texture);
    QADrawContextDelete(context);
    return CHECK_REPORT();
}
