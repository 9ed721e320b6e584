/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * memory.c: textures on a board with room for four of them, of each kind of
 * engine: "separate" keeps textures in host memory and loads them, "video" keeps
 * them on the board alone, "frame" frees nothing before the frame is complete.
 * The kind is the argument.
 */
#define _POSIX_C_SOURCE 200112L

#include "rave_test.h"

#define SIDE 16
#define BYTES (SIDE * SIDE * 4)
#define COUNT 10

static Target target;
static TQADrawContext *context;
static TQAEngine *engine;
static TQAUInt32 texels[COUNT][SIDE * SIDE];

static TQAUInt32 color_of(int number)
{
    return (TQAUInt32)(number + 1) * 0x170b05u & 0xffffff;
}

static TQAError make(int number, TQAUInt32 flags, TQATexture **texture)
{
    TQAImage image = image_of(SIDE, SIDE, SIDE * 4, texels[number]);

    return QATextureNew(engine, flags, kQAPixel_ARGB32, &image, texture);
}

static TQAUInt32 ask(TQAGestaltSelector selector)
{
    TQAUInt32 answer = 0;

    CHECK(QAEngineGestalt(engine, selector, &answer) == kQANoErr);
    return answer;
}

static void draw(TQATexture *texture, int number)
{
    float x = (float)(number % COUNT * SIDE), y = (float)(number / COUNT * SIDE);

    QASetPtr(context, kQATag_Texture, texture);
    texture_rect(context, x, y, x + SIDE, y + SIDE, 0.5f);
}

/* Whether the first cells show the textures in order. */
static int shows(int cells)
{
    int i;

    for (i = 0; i < cells; i++) {
        if (at(&target, i % COUNT * SIDE + 8, i / COUNT * SIDE + 8) != color_of(i % COUNT)) {
            return 0;
        }
    }
    return 1;
}

static void check_separate(void)
{
    TQATexture *textures[COUNT], *locked = NULL, *another = NULL;
    TQAUInt32 before;
    int i;

    for (i = 0; i < COUNT; i++) {
        CHECK(make(i, 0, &textures[i]) == kQANoErr);
        CHECK(QATextureDetach(engine, textures[i]) == kQANoErr);
    }
    CHECK(ask(kQAGestalt_FastTextureMemory) == 4 * BYTES);
    /* In turn: every texture is loaded every time. */
    before = ask(kQAGestalt_TextureLoads);
    QARenderStart(context, NULL, NULL);
    for (i = 0; i < 2 * COUNT; i++) {
        draw(textures[i % COUNT], i);
    }
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
    CHECK(shows(2 * COUNT));
    CHECK(ask(kQAGestalt_TextureLoads) - before == 2 * COUNT);
    CHECK(ask(kQAGestalt_TextureEvictions) == 2 * COUNT - 4);
    /* Sorted: once each, but for the four that are there. */
    before = ask(kQAGestalt_TextureLoads);
    QARenderStart(context, NULL, NULL);
    for (i = COUNT - 1; i >= 0; i--) {
        draw(textures[i], i);
        draw(textures[i], COUNT + i);
    }
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
    CHECK(shows(2 * COUNT));
    CHECK(ask(kQAGestalt_TextureLoads) - before == COUNT - 4);
    /* Locked ones have to fit. */
    CHECK(make(0, kQATexture_Lock, &locked) == kQANoErr);
    CHECK(ask(kQAGestalt_FastTextureMemory) == 3 * BYTES);
    for (i = 0; i < 3; i++) {
        CHECK(make(1, kQATexture_Lock, &another) == kQANoErr);
        QATextureDelete(engine, another);
    }
    QARenderStart(context, NULL, NULL);
    for (i = 0; i < COUNT; i++) {
        draw(textures[i], i);
        QATextureDelete(engine, textures[i]); /* each waits for its polygons */
    }
    draw(locked, COUNT);
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
    CHECK(shows(COUNT + 1));
    QATextureDelete(engine, locked);
    CHECK(ask(kQAGestalt_FastTextureMemory) == 4 * BYTES);
}

static void check_video(int keeps_frames)
{
    TQATexture *textures[COUNT], *more = NULL;
    int i;

    for (i = 0; i < 4; i++) {
        CHECK(make(i, 0, &textures[i]) == kQANoErr);
    }
    CHECK(ask(kQAGestalt_TextureMemory) == 0);
    CHECK(make(4, 0, &more) == kQAOutOfVideoMemory && more == NULL);
    QARenderStart(context, NULL, NULL);
    for (i = 0; i < 4; i++) {
        draw(textures[i], i);
    }
    /* Still owned: there is no room to wait for. */
    CHECK(make(4, 0, &more) == kQAOutOfVideoMemory);
    /* Deleted while their polygons wait: the next ones wait for those. */
    for (i = 4; i < COUNT; i++) {
        TQAError error;

        QATextureDelete(engine, textures[i - 4]);
        QASetPtr(context, kQATag_Texture, NULL);
        error = make(i, 0, &textures[i]);
        if (keeps_frames) {
            CHECK(error == kQAOutOfVideoMemory);
            break;
        }
        CHECK(error == kQANoErr);
        draw(textures[i], i);
    }
    CHECK(QARenderEnd(context, NULL) == kQANoErr);
    CHECK(shows(keeps_frames ? 4 : COUNT));
    if (keeps_frames) {
        /* The frame is complete: the board has room again. */
        CHECK(make(4, 0, &textures[0]) == kQANoErr);
        for (i = 0; i < 4; i++) {
            QATextureDelete(engine, textures[i]);
        }
    } else {
        for (i = COUNT - 4; i < COUNT; i++) {
            QATextureDelete(engine, textures[i]);
        }
    }
    CHECK(ask(kQAGestalt_TextureMemory) == 4 * BYTES);
    CHECK(ask(kQAGestalt_TextureEvictions) == 0);
}

int main(int argc, char **argv)
{
    const char *kind = argc > 1 ? argv[1] : "separate";
    TQATexture *large = NULL;
    TQAImage image = image_of(64, 64, 256, NULL);
    static TQAUInt32 pixels[64 * 64];
    int i, n;

    setenv("FILLRATE_RAVE_TEXTURE_MEMORY", "4K", 1);
    setenv("FILLRATE_RAVE_TEXTURES", kind, 1);
    for (n = 0; n < COUNT; n++) {
        for (i = 0; i < SIDE * SIDE; i++) {
            texels[n][i] = 0xff000000u | color_of(n);
        }
    }
    context = open_usual(&target, COUNT * SIDE, 2 * SIDE);
    engine = engine_for(&target);
    /* Larger than the board. */
    image.pixmap = pixels;
    CHECK(QATextureNew(engine, 0, kQAPixel_ARGB32, &image, &large) == kQAOutOfVideoMemory);
    CHECK(large == NULL);
    if (strcmp(kind, "separate") == 0) {
        check_separate();
    } else {
        check_video(strcmp(kind, "frame") == 0);
    }
    CHECK(margin_is_clean(&target));
    QADrawContextDelete(context);
    return CHECK_REPORT();
}
