/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * scene.c: one frame with everything: depth, blending, alpha test, triangle
 * flags, textures, a bitmap, fog, a clip. Where a pixel must have a colour is
 * known from engines of the time.
 */
#include "rave_test.h"

static void triangle(const TQADrawContext *context, const float xy[6], float z, float r, float g,
                     float b, float a, TQAUInt32 flags)
{
    TQAVGouraud v[3];
    int i;

    for (i = 0; i < 3; i++) {
        v[i] = gv(xy[2 * i], xy[2 * i + 1], z, r, g, b, a);
    }
    QADrawTriGouraud(context, &v[0], &v[1], &v[2], flags);
}

int main(void)
{
    static Target target;
    static const float far_one[6] = {10, 205, 82, 18, 154, 205};
    static const float near_one[6] = {35, 170, 82, 65, 129, 170};
    static const float blended[6] = {130, 208, 160, 150, 190, 208};
    static const float tested[6] = {280, 215, 295, 195, 310, 215};
    static const float back[6] = {5, 55, 30, 5, 55, 55};
    static const float textured[6] = {115, 55, 140, 5, 165, 55};
    static const float fogged[6] = {210, 232, 240, 200, 270, 232};
    static unsigned char indices[4] = {1, 2, 3, 4};
    static TQAUInt32 entries[256] = {0, 0xff0000, 0x00ff00, 0x0000ff, 0xffffff};
    static TQAUInt32 picture[16];
    TQARect holes[4] = {{0, 320, 0, 4}, {0, 160, 4, 5}, {161, 320, 4, 5}, {0, 320, 5, 220}};
    TQAClipRectList list;
    TQAClip clip;
    TQADrawContext *context = NULL;
    TQAEngine *engine;
    TQATexture *texture;
    TQAColorTable *table = NULL;
    TQABitmap *bitmap;
    TQAVTexture strip[4], v[3];
    TQAVGouraud corner;
    int i;

    init_target(&target, kQAPixel_RGB32, 320, 220, 0);
    target.pixels[4 * 320 + 160] = 0x00ff00;
    engine = engine_for(&target);
    list.count = 4;
    list.rects = holes;
    clip.clipType = kQAClipRects;
    clip.clip.clipRects = &list;
    CHECK(QADrawContextNew(&target.device, &target.rect, &clip, engine, kQAContext_DoubleBuffer,
                           &context) == kQANoErr);
    CHECK(context->version == kQAVersion_1_6);
    background(context, 0.03f, 0.03f, 0.08f);
    QASetInt(context, kQATag_ZFunction, kQAZFunction_LT);
    QASetInt(context, kQATag_ZBufferMask, kQAZBufferMask_Enable);

    texture = make_texture(engine, kQATexture_None, kQAPixel_CL8, 2, 2, 2, indices);
    CHECK(QAColorTableNew(engine, kQAColorTable_CL8_RGB32, entries, 0, &table) == kQANoErr);
    CHECK(QATextureBindColorTable(engine, texture, table) == kQANoErr);
    for (i = 0; i < 16; i++) {
        picture[i] = i < 8 ? 0xffff0000u : 0xff00ff00u;
    }
    bitmap = make_bitmap(engine, kQABitmap_None, kQAPixel_ARGB32, 4, 4, 16, picture);

    QARenderStart(context, NULL, NULL);
    /* 1: depth */
    triangle(context, far_one, 0.8f, 0, 0.15f, 1, 1, 0);
    triangle(context, near_one, 0.2f, 1, 0.08f, 0.03f, 1, 0);
    /* 2: interpolation */
    QASetInt(context, kQATag_Blend, kQABlend_Interpolate);
    triangle(context, blended, 0.4f, 0, 0, 1, 1, 0);
    triangle(context, blended, 0.1f, 1, 0, 0, 0.5f, 0);
    /* 3: alpha test */
    triangle(context, tested, 0.4f, 0, 1, 0, 1, 0);
    QASetFloat(context, kQATag_AlphaTestRef, 0.5f);
    QASetInt(context, kQATag_AlphaTestFunc, kQAAlphaTest_GT);
    triangle(context, tested, 0.1f, 1, 0, 0, 0.25f, 0);
    QASetInt(context, kQATag_AlphaTestFunc, kQAAlphaTest_None);
    /* 4: back faces are drawn */
    triangle(context, back, 0.4f, 0, 0, 1, 1, 0);
    triangle(context, back, 0.1f, 1, 0, 0, 1, kQATriFlags_Backfacing);
    /* 5: v counts from below: v = 1 is the top row */
    triangle(context, textured, 0.4f, 0, 0, 1, 1, 0);
    QASetPtr(context, kQATag_Texture, texture);
    CHECK(QAGetPtr(context, kQATag_Texture) == (void *)texture);
    QASetInt(context, kQATag_TextureFilter, kQATextureFilter_Fast);
    QASetInt(context, kQATag_TextureOp, kQATextureOp_None);
    QASetInt(context, kQATagGL_TextureWrapU, kQAGL_Clamp);
    QASetInt(context, kQATagGL_TextureWrapV, kQAGL_Clamp);
    for (i = 0; i < 3; i++) {
        TQAUInt32 flags[1] = {kQATriFlags_Backfacing};

        v[i] = tv(textured[2 * i], textured[2 * i + 1], 0.1f, 0, 1);
        if (i == 2) {
            QADrawVTexture(context, 3, kQAVertexMode_Tri, v, flags);
        }
    }
    /* 6: v = 0 at the top of the screen shows the last row of the image */
    strip[0] = tv(178, 38, 0.3f, 0, 0);
    strip[1] = tv(302, 38, 0.3f, 1, 0);
    strip[2] = tv(178, 190, 0.3f, 0, 1);
    strip[3] = tv(302, 190, 0.3f, 1, 1);
    QADrawVTexture(context, 4, kQAVertexMode_Strip, strip, NULL);
    /* 7: a bitmap needs no texture and may reach beyond the edge */
    QASetPtr(context, kQATag_Texture, NULL);
    CHECK(QAGetPtr(context, kQATag_Texture) == NULL);
    corner = gv(318, 212, 0.05f, 0, 0, 0, 1);
    QADrawBitmap(context, &corner, bitmap);
    /* 8: fog goes by 1 / invW; vertices reach beyond the bottom */
    QASetFloat(context, kQATag_FogColor_b, 1);
    QASetFloat(context, kQATag_FogStart, 0);
    QASetFloat(context, kQATag_FogEnd, 1);
    QASetInt(context, kQATag_PerspectiveZ, kQAPerspectiveZ_On);
    QASetInt(context, kQATag_FogMode, kQAFogMode_Linear);
    {
        TQAVGouraud f[3];

        for (i = 0; i < 3; i++) {
            f[i] = gv(fogged[2 * i], fogged[2 * i + 1], 0.1f, 1, 0, 0, 1);
            f[i].invW = 1 / 0.75f;
        }
        QADrawTriGouraud(context, &f[0], &f[1], &f[2], kQATriFlags_None);
    }
    QASetInt(context, kQATag_FogMode, kQAFogMode_None);
    QASetInt(context, kQATag_PerspectiveZ, kQAPerspectiveZ_Off);
    CHECK(at(&target, 82, 120) == 0);
    CHECK(QARenderEnd(context, NULL) == kQANoErr);

    CHECK(is_red(at(&target, 82, 120)));
    CHECK(is_purple(at(&target, 160, 190)));
    CHECK(is_green(at(&target, 295, 207)));
    CHECK(is_red(at(&target, 30, 35)));
    CHECK(is_red(at(&target, 140, 35)));
    CHECK(is_blue(at(&target, 200, 60)));
    CHECK(is_red(at(&target, 200, 180)) && is_green(at(&target, 290, 180)));
    CHECK(is_red(at(&target, 319, 213)) && is_green(at(&target, 319, 215)));
    CHECK(is_near(at(&target, 240, 218), 64, 0, 191, 4));
    CHECK(at(&target, 160, 4) == 0x00ff00);
    CHECK(is_near(at(&target, 159, 4), 8, 8, 20, 1));
    CHECK(is_near(at(&target, 5, 100), 8, 8, 20, 1));
    CHECK(margin_is_clean(&target));

    QABitmapDelete(engine, bitmap);
    QATextureDelete(engine, texture);
    QAColorTableDelete(engine, table);
    QADrawContextDelete(context);
    return CHECK_REPORT();
}
