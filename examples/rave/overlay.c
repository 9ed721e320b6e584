/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * overlay.c: instruments over a flight along a tunnel: bitmaps with alpha at the
 * edges and across them, one scaled up, one in palette colours. Bitmaps need no
 * texture and take the depth of their corner: here the nearest.
 */
#include "common.h"

#define RINGS 24
#define SIDES 12

/* The middle of the tunnel at a distance. */
static Vec3 tunnel(float z)
{
    return vec3(3 * turn_sin(z / 60), 2 * turn_sin(z / 45 + 0.2f), z);
}

/* A corner of ring n, in view space. */
static Corner wall_corner(int ring, int side, float at)
{
    float z = (float)ring * 4 - at, turns = (float)side / SIDES + (float)ring / 96;
    Vec3 middle = tunnel((float)ring * 4), eye = tunnel(at);
    float light = ring % 4 == 0 ? 1.0f : 0.55f - 0.3f * turn_cos(turns);
    Corner corner;

    corner.position = vec3(middle.x - eye.x + 5 * turn_sin(turns),
                           middle.y - eye.y + 5 * turn_cos(turns), z);
    corner.u = corner.v = 0;
    corner.r = light * (0.35f + 0.4f * turn_sin((float)ring / 40));
    corner.g = light * 0.42f;
    corner.b = light * (0.62f - 0.3f * turn_sin((float)ring / 40));
    return corner;
}

static void draw_tunnel(const TQADrawContext *context, float at)
{
    int first = (int)(at / 4), ring, side, i;

    for (ring = first; ring < first + RINGS; ring++) {
        for (side = 0; side < SIDES; side++) {
            Corner corners[MAX_CORNERS];
            TQAVGouraud vertices[MAX_CORNERS];
            int count;

            corners[0] = wall_corner(ring, side, at);
            corners[1] = wall_corner(ring, side + 1, at);
            corners[2] = wall_corner(ring + 1, side + 1, at);
            corners[3] = wall_corner(ring + 1, side, at);
            count = clip_polygon(corners, 4);
            for (i = 0; i < count; i++) {
                TQAVTexture v = project(context, &corners[i]);
                float fade = 1 - corners[i].position.z / (4 * RINGS);

                fade = fade < 0 ? 0 : fade;
                vertices[i] = gouraud(v.x, v.y, v.z, v.kd_r * fade, v.kd_g * fade, v.kd_b * fade,
                                      1);
            }
            if (count >= 3) {
                QADrawVGouraud(context, (TQAUInt32)count, kQAVertexMode_Fan, vertices, NULL);
            }
        }
    }
}

#define DIAL 80

/* A round instrument whose hand points at `turns`. */
static void paint_dial(TQAUInt32 *pixels, float turns)
{
    int x, y;

    for (y = 0; y < DIAL; y++) {
        for (x = 0; x < DIAL; x++) {
            float dx = (float)x + 0.5f - DIAL / 2, dy = (float)y + 0.5f - DIAL / 2;
            float r = (float)sqrt(dx * dx + dy * dy);
            float along = dx * turn_sin(turns) - dy * turn_cos(turns);
            float across = dx * turn_cos(turns) + dy * turn_sin(turns);
            int mark = 0, i;

            for (i = 0; i < 12; i++) {
                float sx = turn_sin((float)i / 12), sy = -turn_cos((float)i / 12);

                mark |= dx * sx + dy * sy > 29 && (float)fabs(dx * sy - dy * sx) < 1.2f;
            }
            if (r > DIAL / 2 - 1) {
                pixels[y * DIAL + x] = 0;
            } else if (r > DIAL / 2 - 4) {
                pixels[y * DIAL + x] = argb(255, 190 - (int)dy, 196 - (int)dy, 204 - (int)dy);
            } else if (along > -6 && along < 30 && across < 2 && across > -2) {
                pixels[y * DIAL + x] = argb(255, 250, 90, 50);
            } else if (mark && r < 36) {
                pixels[y * DIAL + x] = argb(255, 236, 240, 230);
            } else {
                pixels[y * DIAL + x] = argb(150, 10, 16, 20);
            }
        }
    }
}

/* A cross that is open in the middle, partly transparent. */
static TQAUInt32 sight[15 * 15];

static void paint_sight(void)
{
    int x, y;

    for (y = 0; y < 15; y++) {
        for (x = 0; x < 15; x++) {
            int arm = (x == 7 || y == 7) && !(x > 4 && x < 10 && y > 4 && y < 10);

            sight[y * 15 + x] = arm ? argb(200, 120, 255, 140) : 0;
        }
    }
}

/* A word in palette colours: index 0 is transparent. */
#define WORD_WIDTH 24
#define WORD_HEIGHT 8
static unsigned char word[WORD_WIDTH * WORD_HEIGHT];

static void paint_word(const char *text)
{
    int i, x, y;

    memset(word, 0, sizeof word);
    for (i = 0; text[i] != 0; i++) {
        const unsigned char *rows = letter(text[i]);

        for (y = 0; y < 7; y++) {
            for (x = 0; x < 5; x++) {
                if (rows[y] >> (4 - x) & 1) {
                    word[y * WORD_WIDTH + 6 * i + x] = (unsigned char)(1 + y);
                }
            }
        }
    }
}

static TQABitmap *bitmap_of(const TQAEngine *engine, TQAImagePixelType type, int width, int height,
                            int bytes, void *pixels)
{
    TQABitmap *bitmap;
    TQAImage image;

    image.width = width;
    image.height = height;
    image.rowBytes = width * bytes;
    image.pixmap = pixels;
    need(QABitmapNew(engine, kQABitmap_None, type, &image, &bitmap), "QABitmapNew");
    return bitmap;
}

static void place(const TQADrawContext *context, TQABitmap *bitmap, float x, float y, float alpha)
{
    TQAVGouraud v = gouraud(x, y, 0, 0, 0, 0, alpha);

    QADrawBitmap(context, &v, bitmap);
}

int main(int argc, char **argv)
{
    static Screen screen;
    static TQAUInt32 dial_pixels[DIAL * DIAL], entries[256];
    TQABitmap *cross, *title;
    TQAColorTable *table;
    int frame, i, frames = frames_wanted(argc, argv, 8);

    open_screen(&screen, kQAPixel_RGB32, kQAOptional_Blend | kQAOptional_CL8,
                kQAContext_DoubleBuffer);
    paint_sight();
    paint_word("RAVE");
    for (i = 0; i < 256; i++) {
        entries[i] = argb(0, 255, 250 - 18 * i, 90 - 10 * i);
    }
    cross = bitmap_of(screen.engine, kQAPixel_ARGB32, 15, 15, 4, sight);
    title = bitmap_of(screen.engine, kQAPixel_CL8, WORD_WIDTH, WORD_HEIGHT, 1, word);
    need(QAColorTableNew(screen.engine, kQAColorTable_CL8_RGB32, entries, 1, &table),
         "QAColorTableNew");
    need(QABitmapBindColorTable(screen.engine, title, table), "QABitmapBindColorTable");
    for (frame = 0; frame < frames; frame++) {
        float at = 2 + 1.5f * (float)frame;
        TQABitmap *dial;

        QASetInt(screen.context, kQATag_Blend, kQABlend_PreMultiply);
        QARenderStart(screen.context, NULL, NULL);
        draw_tunnel(screen.context, at);
        QASetInt(screen.context, kQATag_Blend, kQABlend_Interpolate);
        paint_dial(dial_pixels, (float)frame / 16);
        dial = bitmap_of(screen.engine, kQAPixel_ARGB32, DIAL, DIAL, 4, dial_pixels);
        place(screen.context, dial, 6, SCREEN_HEIGHT - DIAL - 6, 1);
        /* A second one reaches past the corner of the screen. */
        place(screen.context, dial, SCREEN_WIDTH - 56, SCREEN_HEIGHT - 56, 0.85f);
        QABitmapDelete(screen.engine, dial); /* it is still drawn */
        place(screen.context, cross, SCREEN_WIDTH / 2 - 7, SCREEN_HEIGHT / 2 - 7, 1);
        QASetFloat(screen.context, kQATag_BitmapScale_x, 3);
        QASetFloat(screen.context, kQATag_BitmapScale_y, 3);
        place(screen.context, title, 8, 8, 0.9f);
        QASetFloat(screen.context, kQATag_BitmapScale_x, 1);
        QASetFloat(screen.context, kQATag_BitmapScale_y, 1);
        need(QARenderEnd(screen.context, NULL), "QARenderEnd");
    }
    QABitmapDelete(screen.engine, title);
    QABitmapDelete(screen.engine, cross);
    QAColorTableDelete(screen.engine, table);
    QADrawContextDelete(screen.context);
    return 0;
}
