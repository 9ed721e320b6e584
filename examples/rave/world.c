/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * world.c: a whole program of the time. A hundred objects stand in a world; each
 * frame culls them by their bounding spheres, clips the polygons of those that
 * cross the edge of the view, projects and draws them. They have 36 textures, on
 * a board whose memory holds nine: textures that do not fit have to be deleted
 * and made again.
 *
 * Half of the frames do so as the objects come. The other half preflights: it
 * finds out which textures the frame needs, draws everything that is loaded,
 * waits, deletes what is done with, and loads the rest, so that no texture is
 * loaded twice in a frame. Both ways print their loads.
 *
 * Without other settings the board keeps textures in its own memory alone.
 */
#define _POSIX_C_SOURCE 200112L

#include "common.h"

#define OBJECTS 100
#define TEXTURES 36
#define TEXTURE_SIDE 64

/* --- textures: walls of stone, brick, wood, plaster and tile ---------------- */

static TQAUInt32 wall(int x, int y, int side, int kind)
{
    static const int hues[9][3] = {{150, 84, 60}, {120, 116, 108}, {168, 142, 96},
                                   {92, 108, 76}, {96, 104, 128},  {156, 112, 70},
                                   {132, 92, 100}, {84, 116, 116}, {170, 160, 140}};
    const int *hue = hues[kind % 9];
    int grain = noise(x, y, side, 16) / 6 + lattice(x + 64 * kind, y) / 12 - 30;
    int row, seam = 0, lit = 0;

    switch (kind / 9) {
    case 0: /* bricks */
        row = y / 8;
        seam = y % 8 == 0 || (x + row % 2 * 8) % 16 == 0;
        lit = lattice((x + row % 2 * 8) / 16 % 4, row) / 7 - 18;
        break;
    case 1: /* windows */
        row = y % 16 >= 4 && y % 16 < 13 && x % 16 >= 4 && x % 16 < 12;
        if (row) {
            int warm = lattice(x / 16 + 8 * kind, y / 16) > 130;

            return warm ? argb(255, 250, 214, 120) : argb(255, 44, 56, 78);
        }
        break;
    case 2: /* planks */
        seam = x % 8 == 0;
        lit = noise(x * 4 % side, y / 2, side, 8) / 5 - 24 + lattice(x / 8, 3) / 9;
        break;
    default: /* tiles in two colours */
        lit = (x / 8 + y / 8) % 2 ? 34 : -18;
        seam = x % 8 == 0 || y % 8 == 0;
        break;
    }
    lit += grain - 52 * seam;
    return argb(255, hue[0] + lit, hue[1] + lit, hue[2] + lit);
}

/* A texture of the program: what it looks like, and the engine's, if loaded. */
typedef struct Skin {
    Picture picture;
    TQATexture *texture;
    int last_use;
    int loads; /* in this frame */
} Skin;

static Skin skins[TEXTURES];
static int clock_of_uses, loads_of_frame;

/* Makes the engine's texture; 0 where it has no room. */
static int create(const TQAEngine *engine, Skin *skin)
{
    if (QATextureNew(engine, kQATexture_Mipmap, kQAPixel_ARGB32, skin->picture.images,
                     &skin->texture) != kQANoErr) {
        return 0;
    }
    skin->loads++;
    loads_of_frame++;
    return 1;
}

static void delete(const TQAEngine *engine, Skin *skin)
{
    QATextureDelete(engine, skin->texture);
    skin->texture = NULL;
}

/* --- the world -------------------------------------------------------------- */

typedef struct Object {
    Vec3 base;
    float half, height, yaw;
    int skin;
    int is_seen, is_crossing, is_drawn;
} Object;

static Object objects[OBJECTS];

static void build_world(void)
{
    TQAUInt32 seed = 7;
    int i;

    for (i = 0; i < TEXTURES; i++) {
        paint_picture(&skins[i].picture, TEXTURE_SIDE, wall, i);
    }
    for (i = 0; i < OBJECTS; i++) {
        Object *object = &objects[i];

        object->base.x = (float)(i % 10 - 5) * 16 + 8 + (float)(next_random(&seed) % 60) / 10 - 3;
        object->base.z = (float)(i / 10) * 18 + 10 + (float)(next_random(&seed) % 60) / 10 - 3;
        object->base.y = 0;
        object->half = 2.6f + (float)(next_random(&seed) % 30) / 10;
        object->height = 3 + (float)(next_random(&seed) % 110) / 10;
        object->yaw = (float)(next_random(&seed) % 100) / 400;
        object->skin = next_random(&seed) % TEXTURES;
    }
}

typedef struct Camera {
    Vec3 eye;
    float yaw, pitch;
} Camera;

static Vec3 seen_from(const Camera *camera, Vec3 p)
{
    p = vec3(p.x - camera->eye.x, p.y - camera->eye.y, p.z - camera->eye.z);
    return turned(p, camera->yaw, camera->pitch);
}

/* Lengths of the normals of the six planes. */
static float plane_length(int plane)
{
    float half = plane < 4 ? SCREEN_WIDTH / 2 : SCREEN_HEIGHT / 2;

    return plane < 2 ? 1.0f : (float)sqrt(half * half + VIEW_DISTANCE * VIEW_DISTANCE);
}

/* Sets whether an object's ball lies outside, inside, or across the view. */
static void cull(Object *object, const Camera *camera)
{
    float middle = object->height / 2;
    Vec3 centre = vec3(object->base.x, middle, object->base.z);
    float radius = (float)sqrt(2 * object->half * object->half + middle * middle);
    int plane;

    centre = seen_from(camera, centre);
    object->is_seen = 1;
    object->is_crossing = 0;
    object->is_drawn = 0;
    for (plane = 0; plane < 6; plane++) {
        float distance = inside(centre, plane) / plane_length(plane);

        object->is_seen = object->is_seen && distance > -radius;
        object->is_crossing = object->is_crossing || distance < radius;
    }
}

/* Draws the four walls and the roof of an object with its texture. */
static void draw_object(const TQADrawContext *context, const Object *object, const Camera *camera)
{
    static const float light[5] = {0.95f, 0.6f, 0.45f, 0.75f, 1.0f};
    static const float around[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    Vec3 low[4], high[4];
    Corner face[4];
    int side, i;

    for (i = 0; i < 4; i++) {
        Vec3 p = turned(vec3(around[i][0] * object->half, 0, around[i][1] * object->half),
                        object->yaw, 0);

        p.x += object->base.x;
        p.z += object->base.z;
        low[i] = seen_from(camera, p);
        p.y = object->height;
        high[i] = seen_from(camera, p);
    }
    for (side = 0; side < 5; side++) {
        int next = (side + 1) % 4;
        const Vec3 *corners[4];
        float high_v = side < 4 ? object->height / (2 * object->half) : 1.0f;
        TQAVTexture vertices[4];

        corners[0] = side < 4 ? &high[side] : &high[3];
        corners[1] = side < 4 ? &high[next] : &high[2];
        corners[2] = side < 4 ? &low[next] : &high[1];
        corners[3] = side < 4 ? &low[side] : &high[0];
        for (i = 0; i < 4; i++) {
            face[i].position = *corners[i];
            face[i].u = i == 1 || i == 2 ? 1.0f : 0.0f;
            face[i].v = i < 2 ? high_v : 0.0f;
            face[i].r = face[i].g = face[i].b = light[side];
        }
        if (object->is_crossing) {
            draw_polygon(context, face, 4);
            continue;
        }
        for (i = 0; i < 4; i++) {
            vertices[i] = project(context, &face[i]);
        }
        if (!shows_back(vertices)) {
            QADrawVTexture(context, 4, kQAVertexMode_Fan, vertices, NULL);
        }
    }
}

/* The ground: strips of grass, without a texture. */
static void draw_ground(const TQADrawContext *context, const Camera *camera)
{
    int x, z, i, count;

    for (z = 0; z < 14; z++) {
        for (x = 0; x < 8; x++) {
            static const float around[4][2] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
            Corner corners[MAX_CORNERS];
            TQAVGouraud vertices[MAX_CORNERS];
            float shade = 0.24f + 0.05f * (float)((x + z) % 2);

            for (i = 0; i < 4; i++) {
                Vec3 p = vec3(((float)x - 4 + around[i][0]) * 24, 0,
                              ((float)z - 4 + around[i][1]) * 24);

                memset(&corners[i], 0, sizeof corners[i]);
                corners[i].position = seen_from(camera, p);
            }
            count = clip_polygon(corners, 4);
            for (i = 0; i < count; i++) {
                TQAVTexture v = project(context, &corners[i]);

                vertices[i] = gouraud(v.x, v.y, v.z, shade, shade + 0.1f, shade * 0.6f, 1);
                vertices[i].invW = v.invW;
            }
            if (count >= 3) {
                QADrawVGouraud(context, (TQAUInt32)count, kQAVertexMode_Fan, vertices, NULL);
            }
        }
    }
}

static void draw_with_skin(TQADrawContext *context, Object *object, const Camera *camera)
{
    Skin *skin = &skins[object->skin];

    skin->last_use = ++clock_of_uses;
    QASetPtr(context, kQATag_Texture, skin->texture);
    draw_object(context, object, camera);
    object->is_drawn = 1;
}

/* --- as the objects come ------------------------------------------------------ */

/* Deletes the texture that was used longest ago. */
static void delete_oldest(const TQAEngine *engine)
{
    Skin *oldest = NULL;
    int i;

    for (i = 0; i < TEXTURES; i++) {
        if (skins[i].texture && (!oldest || skins[i].last_use < oldest->last_use)) {
            oldest = &skins[i];
        }
    }
    if (oldest) {
        delete(engine, oldest);
    }
}

static void frame_as_it_comes(Screen *screen, const Camera *camera)
{
    int i;

    QARenderStart(screen->context, NULL, NULL);
    draw_ground(screen->context, camera);
    for (i = 0; i < OBJECTS; i++) {
        Skin *skin = &skins[objects[i].skin];

        if (!objects[i].is_seen) {
            continue;
        }
        while (!skin->texture && !create(screen->engine, skin)) {
            delete_oldest(screen->engine);
        }
        draw_with_skin(screen->context, &objects[i], camera);
    }
    need(QARenderEnd(screen->context, NULL), "QARenderEnd");
}

/* --- preflighting ----------------------------------------------------------------- */

/* Whether something is still to be drawn with a texture. */
static int is_needed(int skin)
{
    int i;

    for (i = 0; i < OBJECTS; i++) {
        if (objects[i].is_seen && !objects[i].is_drawn && objects[i].skin == skin) {
            return 1;
        }
    }
    return 0;
}

/* Deletes a texture that nothing is to be drawn with; 0 where there is none. */
static int delete_unneeded(const TQAEngine *engine)
{
    int i, oldest = -1;

    for (i = 0; i < TEXTURES; i++) {
        if (skins[i].texture && !is_needed(i) &&
            (oldest < 0 || skins[i].last_use < skins[oldest].last_use)) {
            oldest = i;
        }
    }
    if (oldest < 0) {
        return 0;
    }
    delete(engine, &skins[oldest]);
    return 1;
}

/* Loads textures of what is to be drawn. True when all are loaded, or when
 * nothing could be loaded twice in a row. */
static int load_textures(const TQAEngine *engine)
{
    static int failures;
    int i, loaded = 0, all = 1;

    for (i = 0; i < TEXTURES && all; i++) {
        if (skins[i].texture || !is_needed(i)) {
            continue;
        }
        while (!create(engine, &skins[i])) {
            if (!delete_unneeded(engine)) {
                all = 0;
                break;
            }
        }
        loaded += all;
    }
    failures = loaded || all ? 0 : failures + 1;
    if (failures >= 2) {
        failures = 0;
        return 1;
    }
    return all;
}

/* Draws everything whose texture is loaded, texture by texture. */
static void render_textures(Screen *screen, const Camera *camera)
{
    int skin, i;

    for (skin = 0; skin < TEXTURES; skin++) {
        for (i = 0; i < OBJECTS && skins[skin].texture; i++) {
            if (objects[i].is_seen && !objects[i].is_drawn && objects[i].skin == skin) {
                draw_with_skin(screen->context, &objects[i], camera);
            }
        }
    }
}

static void frame_preflighted(Screen *screen, const Camera *camera)
{
    int done;

    QASync(screen->context);
    done = load_textures(screen->engine);
    QARenderStart(screen->context, NULL, NULL);
    draw_ground(screen->context, camera);
    render_textures(screen, camera);
    while (!done) {
        QASync(screen->context);
        done = load_textures(screen->engine);
        render_textures(screen, camera);
    }
    need(QARenderEnd(screen->context, NULL), "QARenderEnd");
}

/* --- both ----------------------------------------------------------------------------- */

/* Prints what a frame loaded, and sees that preflighting loads nothing twice. */
static void report(const char *how, int frame)
{
    int i, needed = 0, twice = 0, is_used[TEXTURES] = {0};

    for (i = 0; i < OBJECTS; i++) {
        is_used[objects[i].skin] |= objects[i].is_seen;
        if (objects[i].is_seen && !objects[i].is_drawn) {
            fprintf(stderr, "object %d is missing\n", i);
            exit(1);
        }
    }
    for (i = 0; i < TEXTURES; i++) {
        needed += is_used[i];
        twice += skins[i].loads > 1;
        skins[i].loads = 0;
    }
    printf("%s, frame %d: %d textures needed, %d loads, %d of them loaded more than once\n", how,
           frame, needed, loads_of_frame, twice);
    if (strcmp(how, "preflighted") == 0 && (twice > 0 || loads_of_frame > needed)) {
        fprintf(stderr, "preflighting loaded too much\n");
        exit(1);
    }
    loads_of_frame = 0;
}

int main(int argc, char **argv)
{
    static Screen screen;
    int frame, i, half, frames = frames_wanted(argc, argv, 8);

    /* A board of 2 MB keeps about this much for textures. */
    setenv("FILLRATE_RAVE_TEXTURE_MEMORY", "200K", 0);
    setenv("FILLRATE_RAVE_TEXTURES", "video", 0);
    open_screen(&screen, kQAPixel_RGB16, kQAOptional_Texture | kQAOptional_FogDepth,
                kQAContext_DoubleBuffer);
    build_world();
    set_background(screen.context, 0.62f, 0.7f, 0.8f);
    QASetInt(screen.context, kQATag_TextureFilter, kQATextureFilter_Mid);
    QASetInt(screen.context, kQATag_TextureOp, kQATextureOp_Modulate);
    QASetInt(screen.context, kQATag_FogMode, kQAFogMode_Linear);
    QASetFloat(screen.context, kQATag_FogColor_r, 0.62f);
    QASetFloat(screen.context, kQATag_FogColor_g, 0.7f);
    QASetFloat(screen.context, kQATag_FogColor_b, 0.8f);
    QASetFloat(screen.context, kQATag_FogStart, 40);
    QASetFloat(screen.context, kQATag_FogEnd, 190);
    QASetFloat(screen.context, kQATag_FogMaxDepth, YON);
    half = (frames + 1) / 2;
    for (frame = 0; frame < frames; frame++) {
        int preflights = frame >= half;
        float t = (float)(frame % half);
        Camera camera;

        camera.eye = vec3(4 * turn_sin(t / 24), 11, -14 + 3 * t);
        camera.yaw = 0.02f * turn_sin(t / 16);
        camera.pitch = -0.03f;
        for (i = 0; i < OBJECTS; i++) {
            cull(&objects[i], &camera);
        }
        if (preflights) {
            frame_preflighted(&screen, &camera);
        } else {
            frame_as_it_comes(&screen, &camera);
        }
        report(preflights ? "preflighted" : "as it comes", frame % half);
    }
    QASetPtr(screen.context, kQATag_Texture, NULL);
    for (i = 0; i < TEXTURES; i++) {
        if (skins[i].texture) {
            delete(screen.engine, &skins[i]);
        }
    }
    QADrawContextDelete(screen.context);
    return 0;
}
