/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * textures.c: every pixel type, colour tables, wrapping, levels of mip maps,
 * flipped origins, lent memory, and what becomes of a texture that is deleted.
 */
#include "rave_test.h"

static Target target;
static TQADrawContext *context;
static TQAEngine *engine;

/* One pixel of each type and the colour that it is. */
typedef struct Format {
    TQAImagePixelType type;
    int bytes;
    TQAUInt32 first, second; /* two pixels, as integers of the host */
    TQAUInt32 color;         /* of the first */
    float alpha;
} Format;

static const Format formats[] = {
    {kQAPixel_RGB16, 2, 0x7c1f, 0, 0xff00ff, 1},
    {kQAPixel_RGB16, 2, 0xfc00, 0, 0xff0000, 1}, /* bit 15 is ignored */
    {kQAPixel_ARGB16, 2, 0x83e0, 0, 0x00ff00, 1},
    {kQAPixel_ARGB16, 2, 0x03e0, 0, 0x00ff00, 0},
    {kQAPixel_RGB32, 4, 0x00123456, 0, 0x123456, 1},
    {kQAPixel_ARGB32, 4, 0xff654321u, 0, 0x654321, 1},
    {kQAPixel_ARGB32, 4, 0x33ff0000, 0, 0xff0000, 0.2f},
    {kQAPixel_RGB16_565, 2, 0x07e0, 0, 0x00ff00, 1},
    {kQAPixel_RGB16_565, 2, 0x8410, 0, 0x848284, 1}, /* 16, 32 and 16 replicated */
    {kQAPixel_RGB8_332, 1, 0xe3, 0, 0xff00ff, 1},
    {kQAPixel_ARGB16_4444, 2, 0xf0f8, 0, 0x00ff88, 1},
    {kQAPixel_ARGB16_4444, 2, 0x300f, 0, 0x0000ff, 0.2f},
    {kQAPixel_I8, 1, 0x9c, 0, 0x9c9c9c, 1},
    {kQAPixel_AI16_88, 2, 0xffc8, 0, 0xc8c8c8, 1},
    {kQAPixel_AI16_88, 2, 0x3364, 0, 0x646464, 0.2f},
};

#define FORMATS ((int)(sizeof formats / sizeof *formats))
#define CELL 16

/* Draws a texture over white in a cell, blended by its alpha. */
static void draw_cell(TQATexture *texture, int number)
{
    float x = (float)(number % 16 * CELL), y = (float)(number / 16 * CELL);

    QASetPtr(context, kQATag_Texture, texture);
    texture_rect(context, x, y, x + CELL, y + CELL, 0.5f);
}

static TQAUInt32 cell(int number)
{
    return at(&target, number % 16 * CELL + CELL / 2, number / 16 * CELL + CELL / 2);
}

static int over_white(TQAUInt32 color, float alpha, int shift)
{
    float c = (float)(color >> shift & 255);

    return (int)(c * alpha + 255 * (1 - alpha) + 0.5f);
}

static void check_formats(void)
{
    TQATexture *textures[FORMATS];
    TQAUInt32 pixels[FORMATS][2];
    TQAUInt32 allowed = 0;
    int i;

    CHECK(QAEngineGestalt(engine, kQAGestalt_TexturePixelTypesAllowed, &allowed) == kQANoErr);
    QARenderStart(context, NULL, NULL);
    QASetInt(context, kQATag_Blend, kQABlend_Interpolate);
    for (i = 0; i < FORMATS; i++) {
        const Format *f = &formats[i];
        unsigned char byte = (unsigned char)f->first;
        unsigned short half = (unsigned short)f->first;

        CHECK(allowed >> f->type & 1);
        memcpy(pixels[i],
               f->bytes == 1   ? (const void *)&byte
               : f->bytes == 2 ? (const void *)&half
                               : (const void *)&f->first,
               (size_t)f->bytes);
        textures[i] = make_texture(engine, 0, f->type, 1, 1, 4, pixels[i]);
        draw_cell(textures[i], i);
    }
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
    for (i = 0; i < FORMATS; i++) {
        const Format *f = &formats[i];

        CHECK(is_near(cell(i), over_white(f->color, f->alpha, 16),
                      over_white(f->color, f->alpha, 8), over_white(f->color, f->alpha, 0), 2));
        QATextureDelete(engine, textures[i]);
    }
}

static void check_palettes(void)
{
    static unsigned char nibbles[2] = {0x12, 0x30}; /* 1, 2 above 3, 0 */
    static unsigned char bytes[4] = {200, 1, 2, 0};
    static unsigned short with_alpha[1] = {0x33c8}; /* alpha 0.2, index 200 */
    TQAUInt32 small[16] = {0x102030, 0xff0000, 0x00ff00, 0x0000ff}, large[256] = {0};
    TQAColorTable *cl4 = NULL, *cl8 = NULL, *holes = NULL;
    TQATexture *four, *eight, *acl;

    large[0] = 0xffff00;
    large[1] = 0xff0000;
    large[2] = 0x00ff00;
    large[200] = 0x0000ff;
    CHECK(QAColorTableNew(engine, kQAColorTable_CL4_RGB32, small, 0, &cl4) == kQANoErr);
    CHECK(QAColorTableNew(engine, kQAColorTable_CL8_RGB32, large, 0, &cl8) == kQANoErr);
    CHECK(QAColorTableNew(engine, kQAColorTable_CL8_RGB32, large, 1, &holes) == kQANoErr);
    /* Entries are copied. */
    memset(small, 0, sizeof small);
    memset(large, 0, sizeof large);
    four = make_texture(engine, 0, kQAPixel_CL4, 2, 2, 1, nibbles);
    eight = make_texture(engine, 0, kQAPixel_CL8, 2, 2, 2, bytes);
    acl = make_texture(engine, 0, kQAPixel_ACL16_88, 1, 1, 2, with_alpha);
    CHECK(QATextureBindColorTable(engine, four, cl8) == kQAParamErr);
    CHECK(QATextureBindColorTable(engine, four, cl4) == kQANoErr);
    CHECK(QATextureBindColorTable(engine, eight, cl8) == kQANoErr);
    CHECK(QATextureBindColorTable(engine, acl, cl8) == kQANoErr);
    QARenderStart(context, NULL, NULL);
    draw_cell(four, 0);
    draw_cell(eight, 1);
    CHECK(QATextureBindColorTable(engine, eight, holes) == kQANoErr);
    draw_cell(eight, 2);
    draw_cell(acl, 3);
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
    CHECK(at(&target, 4, 4) == 0xff0000 && at(&target, 12, 4) == 0x00ff00);
    CHECK(at(&target, 4, 12) == 0x0000ff && at(&target, 12, 12) == 0x102030);
    CHECK(at(&target, 20, 4) == 0x0000ff && at(&target, 28, 4) == 0xff0000);
    CHECK(at(&target, 20, 12) == 0x00ff00 && at(&target, 28, 12) == 0xffff00);
    /* Index 0 is transparent: white shows through. */
    CHECK(at(&target, 36, 4) == 0x0000ff && at(&target, 44, 12) == 0xffffff);
    CHECK(is_near(cell(3), 204, 204, 255, 2));
    QATextureDelete(engine, four);
    QATextureDelete(engine, eight);
    QATextureDelete(engine, acl);
    QAColorTableDelete(engine, cl4);
    QAColorTableDelete(engine, cl8);
    QAColorTableDelete(engine, holes);
}

/* Three columns: below 0, inside, beyond 1. */
static void wrap_rect(float y)
{
    TQAVTexture v[4];

    v[0] = tv(0, y, 0.5f, -1, 1);
    v[1] = tv(48, y, 0.5f, 2, 1);
    v[2] = tv(0, y + 16, 0.5f, -1, 0);
    v[3] = tv(48, y + 16, 0.5f, 2, 0);
    QADrawVTexture(context, 4, kQAVertexMode_Strip, v, NULL);
}

static void check_wrapping(void)
{
    static TQAUInt32 columns[2] = {0xffff0000u, 0xff0000ffu};
    TQATexture *texture = make_texture(engine, 0, kQAPixel_ARGB32, 2, 1, 8, columns);

    QARenderStart(context, NULL, NULL);
    QASetPtr(context, kQATag_Texture, texture);
    wrap_rect(0);
    QASetInt(context, kQATagGL_TextureWrapU, kQAGL_Clamp);
    wrap_rect(16);
    QASetInt(context, kQATagGL_TextureWrapU, kQAGL_Repeat);
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
    CHECK(at(&target, 4, 8) == 0xff0000 && at(&target, 12, 8) == 0x0000ff);
    CHECK(at(&target, 20, 8) == 0xff0000 && at(&target, 28, 8) == 0x0000ff);
    CHECK(at(&target, 36, 8) == 0xff0000 && at(&target, 44, 8) == 0x0000ff);
    CHECK(at(&target, 4, 24) == 0xff0000 && at(&target, 12, 24) == 0xff0000);
    CHECK(at(&target, 20, 24) == 0xff0000 && at(&target, 28, 24) == 0x0000ff);
    CHECK(at(&target, 36, 24) == 0x0000ff && at(&target, 44, 24) == 0x0000ff);
    QASetPtr(context, kQATag_Texture, NULL);
    QATextureDelete(engine, texture);
}

/* Levels of one colour each; a smaller rectangle shows a smaller level. */
static void check_levels(void)
{
    static const TQAUInt32 colors[6] = {0xffff0000u, 0xff00ff00u, 0xff0000ffu,
                                        0xffffff00u, 0xff00ffffu, 0xffff00ffu};
    static TQAUInt32 texels[6][32 * 32];
    static const int sizes[6] = {32, 16, 8, 4, 2, 1};
    TQAImage images[6];
    TQATexture *texture = NULL;
    int level, i;

    for (level = 0; level < 6; level++) {
        for (i = 0; i < 32 * 32; i++) {
            texels[level][i] = colors[level];
        }
        images[level] =
            image_of(32 >> level, 32 >> level, 4 * (32 >> level), texels[level]);
    }
    CHECK(QATextureNew(engine, kQATexture_Mipmap, kQAPixel_ARGB32, images, &texture) == kQANoErr);
    CHECK(QATextureDetach(engine, texture) == kQANoErr);
    memset(texels, 0, sizeof texels);
    QARenderStart(context, NULL, NULL);
    QASetPtr(context, kQATag_Texture, texture);
    for (level = 0; level < 5; level++) {
        float x = (float)(40 * level), s = (float)sizes[level];

        texture_rect(context, x, 0, x + s, s, 0.5f);
    }
    /* A bias of one level. */
    QASetFloat(context, kQATag_MipmapBias, 1.5f);
    texture_rect(context, 0, 40, 32, 72, 0.5f);
    QASetFloat(context, kQATag_MipmapBias, 0.5f);
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
    for (level = 0; level < 5; level++) {
        int middle = sizes[level] / 2;

        CHECK(at(&target, 40 * level + middle, middle) == (colors[level] & 0xffffff));
    }
    CHECK(at(&target, 16, 56) == (colors[1] & 0xffffff));
    QASetPtr(context, kQATag_Texture, NULL);
    QATextureDelete(engine, texture);
}

static void check_memory_of_the_program(void)
{
    static TQAUInt32 lent[1] = {0xffff0000u}, copied[1] = {0xffff0000u};
    static TQAUInt32 rows[2] = {0xffff0000u, 0xff0000ffu};
    TQATexture *no_copy, *copy, *flipped, *upright;

    no_copy = make_texture(engine, kQATexture_NoCopy, kQAPixel_ARGB32, 1, 1, 4, lent);
    copy = make_texture(engine, 0, kQAPixel_ARGB32, 1, 1, 4, copied);
    flipped = make_texture(engine, kQATexture_FlipOrigin, kQAPixel_ARGB32, 1, 2, 4, rows);
    upright = make_texture(engine, 0, kQAPixel_ARGB32, 1, 2, 4, rows);
    lent[0] = copied[0] = 0xff00ff00u;
    QARenderStart(context, NULL, NULL);
    draw_cell(no_copy, 0);
    draw_cell(copy, 1);
    draw_cell(flipped, 2);
    draw_cell(upright, 3);
    /* Deleted while it waits to be drawn: it is drawn. */
    QATextureDelete(engine, copy);
    QASetPtr(context, kQATag_Texture, NULL);
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
    CHECK(cell(0) == 0x00ff00);
    CHECK(cell(1) == 0xff0000);
    CHECK(at(&target, 40, 4) == 0x0000ff && at(&target, 40, 12) == 0xff0000);
    CHECK(at(&target, 56, 4) == 0xff0000 && at(&target, 56, 12) == 0x0000ff);
    /* Detached, it is the engine's own. */
    CHECK(QATextureDetach(engine, no_copy) == kQANoErr);
    lent[0] = 0xff0000ffu;
    QARenderStart(context, NULL, NULL);
    draw_cell(no_copy, 0);
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
    CHECK(cell(0) == 0x00ff00);
    QASetPtr(context, kQATag_Texture, NULL);
    QATextureDelete(engine, no_copy);
    QATextureDelete(engine, flipped);
    QATextureDelete(engine, upright);
}

static void check_refusals(void)
{
    static TQAUInt32 texels[64];
    TQAImage image = image_of(3, 4, 12, texels);
    TQATexture *texture = (TQATexture *)texels;

    CHECK(QATextureNew(engine, 0, kQAPixel_ARGB32, &image, &texture) == kQAParamErr);
    CHECK(texture == NULL);
    image = image_of(4, 0, 16, texels);
    CHECK(QATextureNew(engine, 0, kQAPixel_ARGB32, &image, &texture) == kQAParamErr);
    image = image_of(4, 4, 16, NULL);
    CHECK(QATextureNew(engine, 0, kQAPixel_ARGB32, &image, &texture) != kQANoErr);
    image = image_of(4, 4, 16, texels);
    CHECK(QATextureNew(engine, 0, (TQAImagePixelType)77, &image, &texture) != kQANoErr);
    CHECK(QATextureNew(NULL, 0, kQAPixel_ARGB32, &image, &texture) == kQAParamErr);
    CHECK(QATextureNew(engine, 0, kQAPixel_ARGB32, NULL, &texture) == kQAParamErr);
    CHECK(QATextureNew(engine, 0, kQAPixel_ARGB32, &image, NULL) == kQAParamErr);
    CHECK(QATextureDetach(engine, NULL) != kQANoErr);
}

int main(void)
{
    context = open_usual(&target, 256, 128);
    engine = engine_for(&target);
    background(context, 1, 1, 1);
    check_formats();
    check_palettes();
    check_wrapping();
    check_levels();
    check_memory_of_the_program();
    check_refusals();
    /* The picture that is kept. */
    check_formats();
    CHECK(margin_is_clean(&target));
    QADrawContextDelete(context);
    return CHECK_REPORT();
}
