/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * bitmaps.c: any size, pixel types, places beyond every edge, depth, alpha,
 * scales, and memory that is lent.
 */
#include "rave_test.h"

static Target target;
static TQADrawContext *context;
static TQAEngine *engine;

static void place(TQABitmap *bitmap, float x, float y, float z, float alpha)
{
    TQAVGouraud v = gv(x, y, z, 0.2f, 0.3f, 0.4f, alpha);

    QADrawBitmap(context, &v, bitmap);
}

/* A picture whose pixels tell where they are: red by column, green by row. */
#define W 7
#define H 5
static TQAUInt32 map[W * H];

static TQAUInt32 map_at(int x, int y)
{
    return (TQAUInt32)(20 + 30 * x) << 16 | (TQAUInt32)(20 + 40 * y) << 8 | 0x40;
}

static void check_places(TQABitmap *bitmap)
{
    static const int corners[6][2] = {{10, 10}, {-3, 30}, {124, 20}, {40, -2}, {60, 78}, {300, 5}};
    int i, x, y;

    QARenderStart(context, NULL, NULL);
    for (i = 0; i < 6; i++) {
        place(bitmap, (float)corners[i][0], (float)corners[i][1], 0.5f, 1);
    }
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
    for (i = 0; i < 6; i++) {
        for (y = -1; y <= H; y++) {
            for (x = -1; x <= W; x++) {
                int px = corners[i][0] + x, py = corners[i][1] + y;
                int is_inside = x >= 0 && y >= 0 && x < W && y < H;

                if (px >= 0 && py >= 0 && px < 128 && py < 80) {
                    CHECK(at(&target, px, py) == (is_inside ? map_at(x, y) : 0));
                }
            }
        }
    }
}

static void check_depth_and_alpha(TQABitmap *bitmap)
{
    static TQAUInt32 half[1] = {0x80ff0000u};
    TQABitmap *glass = make_bitmap(engine, 0, kQAPixel_ARGB32, 1, 1, 4, half);

    QARenderStart(context, NULL, NULL);
    gouraud_rect(context, 0, 0, 64, 80, 0.5f, 0, 0, 1, 1);
    place(bitmap, 10, 10, 0.6f, 1);
    place(bitmap, 10, 30, 0.4f, 1);
    QASetInt(context, kQATag_Blend, kQABlend_Interpolate);
    place(bitmap, 40, 10, 0.4f, 0.5f);
    QASetFloat(context, kQATag_BitmapScale_x, 8);
    QASetFloat(context, kQATag_BitmapScale_y, 8);
    place(glass, 40, 40, 0.4f, 1);
    place(glass, 80, 40, 0.4f, 0.5f);
    QASetFloat(context, kQATag_BitmapScale_x, 1);
    QASetFloat(context, kQATag_BitmapScale_y, 1);
    QASetInt(context, kQATag_Blend, kQABlend_PreMultiply);
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
    CHECK(at(&target, 12, 12) == 0x0000ff);
    CHECK(at(&target, 12, 32) == map_at(2, 2));
    CHECK(is_near(at(&target, 42, 12), 40, 50, 160, 2));
    CHECK(is_near(at(&target, 44, 44), 128, 0, 127, 2));
    CHECK(is_near(at(&target, 84, 44), 64, 0, 0, 2));
    CHECK(at(&target, 39, 44) == 0x0000ff && at(&target, 48, 44) == 0x0000ff);
    QABitmapDelete(engine, glass);
}

static void check_scales(TQABitmap *bitmap)
{
    int x, y;

    QARenderStart(context, NULL, NULL);
    QASetFloat(context, kQATag_BitmapScale_x, 3);
    QASetFloat(context, kQATag_BitmapScale_y, 2);
    place(bitmap, 10, 10, 0.5f, 1);
    QASetFloat(context, kQATag_BitmapScale_x, 1);
    QASetFloat(context, kQATag_BitmapScale_y, 1);
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
    for (y = 0; y < 2 * H; y++) {
        for (x = 0; x < 3 * W; x++) {
            CHECK(at(&target, 10 + x, 10 + y) == map_at(x / 3, y / 2));
        }
    }
    CHECK(at(&target, 9, 12) == 0 && at(&target, 10 + 3 * W, 12) == 0);
}

static void check_types_and_memory(void)
{
    static unsigned char bits[2] = {0xa0, 0x40}; /* 101 above 010 */
    static unsigned short pixels[3] = {0x7c00, 0x03e0, 0x001f};
    static TQAUInt32 lent[1] = {0xff123456u};
    static unsigned char index[1] = {5};
    static TQAUInt32 entries[256];
    TQABitmap *stencil, *row, *loan, *palette;
    TQAColorTable *table = NULL;

    entries[5] = 0xabcdef;
    stencil = make_bitmap(engine, 0, kQAPixel_Alpha1, 3, 2, 1, bits);
    row = make_bitmap(engine, kQABitmap_Lock, kQAPixel_RGB16, 3, 1, 6, pixels);
    loan = make_bitmap(engine, kQABitmap_NoCopy, kQAPixel_ARGB32, 1, 1, 4, lent);
    palette = make_bitmap(engine, 0, kQAPixel_CL8, 1, 1, 1, index);
    CHECK(QAColorTableNew(engine, kQAColorTable_CL8_RGB32, entries, 0, &table) == kQANoErr);
    CHECK(QABitmapBindColorTable(engine, palette, table) == kQANoErr);
    CHECK(QABitmapBindColorTable(engine, row, table) == kQAParamErr);
    CHECK(QABitmapDetach(engine, row) == kQANoErr);
    memset(pixels, 0, sizeof pixels);
    lent[0] = 0xff654321u;
    QARenderStart(context, NULL, NULL);
    QASetInt(context, kQATag_Blend, kQABlend_Interpolate);
    place(stencil, 1, 1, 0.5f, 1);
    place(row, 1, 5, 0.5f, 1);
    place(loan, 1, 8, 0.5f, 1);
    place(palette, 3, 8, 0.5f, 1);
    QABitmapDelete(engine, row); /* it waits to be drawn */
    QASetInt(context, kQATag_Blend, kQABlend_PreMultiply);
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
    CHECK(at(&target, 1, 1) == 0xffffff && at(&target, 2, 1) == 0 && at(&target, 3, 1) == 0xffffff);
    CHECK(at(&target, 1, 2) == 0 && at(&target, 2, 2) == 0xffffff && at(&target, 3, 2) == 0);
    CHECK(at(&target, 1, 5) == 0xff0000 && at(&target, 2, 5) == 0x00ff00);
    CHECK(at(&target, 3, 5) == 0x0000ff);
    CHECK(at(&target, 1, 8) == 0x654321 && at(&target, 3, 8) == 0xabcdef);
    QABitmapDelete(engine, stencil);
    QABitmapDelete(engine, loan);
    QABitmapDelete(engine, palette);
    QAColorTableDelete(engine, table);
}

static void check_refusals(void)
{
    TQABitmap *bitmap = (TQABitmap *)map;
    TQAImage image = image_of(0, 4, 16, map);

    CHECK(QABitmapNew(engine, 0, kQAPixel_ARGB32, &image, &bitmap) == kQAParamErr);
    CHECK(bitmap == NULL);
    image = image_of(-4, 4, 16, map);
    CHECK(QABitmapNew(engine, 0, kQAPixel_ARGB32, &image, &bitmap) == kQAParamErr);
    CHECK(QABitmapNew(engine, 0, kQAPixel_ARGB32, NULL, &bitmap) == kQAParamErr);
    QARenderStart(context, NULL, NULL);
    QADrawBitmap(context, NULL, NULL);
    QARenderEnd(context, NULL);
}

int main(void)
{
    TQABitmap *bitmap;
    int i;

    context = open_usual(&target, 128, 80);
    engine = engine_for(&target);
    background(context, 0, 0, 0);
    for (i = 0; i < W * H; i++) {
        map[i] = 0xff000000u | map_at(i % W, i / W);
    }
    bitmap = make_bitmap(engine, 0, kQAPixel_ARGB32, W, H, 4 * W, map);
    check_places(bitmap);
    check_scales(bitmap);
    check_types_and_memory();
    check_refusals();
    check_depth_and_alpha(bitmap);
    CHECK(margin_is_clean(&target));
    QABitmapDelete(engine, bitmap);
    QADrawContextDelete(context);
    return CHECK_REPORT();
}
