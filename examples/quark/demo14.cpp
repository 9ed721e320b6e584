/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * demo14: high polygon scene, a benchmark. A terrain of 16 tiles and 20
 * objects, about 5000 triangles, along a fixed path of the camera, by the
 * whole process of the document: bounding box against the frustum, transform,
 * clip, draw. CrossFrustrum, ZcErrorMax.
 *
 * Prints the frames a second and a score, 20 times as much, for three values of
 * ZcErrorMax. The pictures do not depend on the clock.
 */
#include <time.h>

#include "common.h"

static const int TILES = 4;       /* terrain tiles in each direction */
static const int CELLS = 10;      /* squares of a tile in each direction */
static const int CELL = 160;      /* units of a square */
static const int OBJECTS = 20;

struct Object
{
    CTriangleList list;
    TRasterState state;
    int low[3], high[3];          /* bounding box, in its own coordinates */
    int at[3], turn;
};

static CVGpu Gpu;
static CTexture grass, crate, stone, brick, tree;
static Object terrain[TILES * TILES], objects[OBJECTS];
/* A tree is two crossed quads, drawn from both sides. */
static Object trees[OBJECTS * 2];

/* Height of the ground. */
static int height(int x, int z)
{
    int hill = 200 * SINUS(x * 2 + 700) >> TRIGO_SHIFT;
    hill += 180 * COSINUS(z * 2 - x) >> TRIGO_SHIFT;
    hill += 50 * SINUS(x * 5 + z * 4) >> TRIGO_SHIFT;
    /* Mountains around the plain. */
    int far = Sqrti(x * x + z * z) - 2000;
    return far > 0 ? hill + far / 2 : hill;
}

static void find_box(Object *object)
{
    for (int k = 0; k < 3; k++) {
        object->low[k] = 32767;
        object->high[k] = -32768;
    }
    for (int i = 0; i < object->list.VertexListSize; i++) {
        int at[3];
        object->list.GetXYZ(i, at);
        for (int k = 0; k < 3; k++) {
            object->low[k] = at[k] < object->low[k] ? at[k] : object->low[k];
            object->high[k] = at[k] > object->high[k] ? at[k] : object->high[k];
        }
    }
}

/* Light for every vertex, once and for all: the sun does not move. */
static void light_vertices(CTriangleList *list)
{
    static short normals[3 * 2000];
    int sun[3] = {9000, 12000, 6000};

    Normalize(sun);
    list->BuildVNormalList(normals, 3);
    for (int i = 0; i < list->VertexListSize; i++) {
        list->SetI(i, lit(&normals[3 * i], sun, 60));
    }
}

static void make_tile(Object *tile, int column, int row)
{
    static const unsigned short one_state[CELLS * CELLS * 2] = {0};
    int side = CELLS + 1, face = 0;

    tile->state = state_of(DRAW_OPAQUE, 0, &grass);
    tile->list.Init(VF_XYZ | VF_I, side * side, IF_ABC | IF_UV, CELLS * CELLS * 2, &tile->state);
    tile->at[0] = (2 * column - TILES) * CELLS * CELL / 2;
    tile->at[2] = (2 * row - TILES) * CELLS * CELL / 2;
    for (int z = 0; z < side; z++) {
        for (int x = 0; x < side; x++) {
            short at[3] = {(short)(x * CELL),
                           (short)height(tile->at[0] + x * CELL, tile->at[2] + z * CELL),
                           (short)(z * CELL)};
            tile->list.SetXYZ(z * side + x, at);
        }
    }
    for (int z = 0; z < CELLS; z++) {
        for (int x = 0; x < CELLS; x++) {
            unsigned short a = (unsigned short)(z * side + x);
            unsigned short b = (unsigned short)(a + side);
            unsigned short one[3] = {a, b, (unsigned short)(b + 1)};
            unsigned short two[3] = {a, (unsigned short)(b + 1), (unsigned short)(a + 1)};
            static const short uv[2][6] = {{0, 0, 0, 256, 256, 256}, {0, 0, 256, 256, 256, 0}};
            tile->list.SetABC(face, one);
            tile->list.SetUV(face++, uv[0]);
            tile->list.SetABC(face, two);
            tile->list.SetUV(face++, uv[1]);
        }
    }
    tile->list.BuildCmdList(one_state);
    light_vertices(&tile->list);
    find_box(tile);
}

static void make_object(Object *object, int number)
{
    static const unsigned short one_state[1000] = {0};
    CTexture *skins[3] = {&crate, &stone, &brick};

    object->state = state_of(DRAW_OPAQUE, 0, skins[number % 3]);
    if (number % 3 == 0) {
        make_cube(&object->list, 90, VF_XYZ | VF_I, IF_ABC | IF_UV, &object->state);
    } else {
        make_sphere(&object->list, 110, 6, 10, VF_XYZ | VF_I | VF_UV, IF_ABC, &object->state);
    }
    object->list.BuildCmdList(one_state);
    light_vertices(&object->list);
    find_box(object);
    object->at[0] = (number * 7 % 20 - 10) * 150 + 75;
    object->at[2] = (number * 11 % 20 - 10) * 150;
    object->at[1] = height(object->at[0], object->at[2]) + 90;
}

static void make_tree(Object *object, int number)
{
    static const unsigned short one_state[4] = {0};
    static const short at[8][3] = {{-100, 0, 0}, {100, 0, 0}, {100, 260, 0}, {-100, 260, 0},
                                   {0, 0, 100}, {0, 0, -100}, {0, 260, -100}, {0, 260, 100}};
    unsigned int seed = (unsigned int)number * 977u + 5u;

    object->state = state_of(DRAW_KEYED, 0, &tree);
    object->state.TestCulling = 0;
    object->list.Init(VF_XYZ, 8, IF_ABC | IF_UV, 4, &object->state);
    for (int i = 0; i < 8; i++) {
        object->list.SetXYZ(i, at[i]);
    }
    for (int i = 0; i < 4; i++) {
        unsigned short first = (unsigned short)(i / 2 * 4);
        unsigned short face[3] = {first, (unsigned short)(first + 1 + i % 2),
                                  (unsigned short)(first + 2 + i % 2)};
        object->list.SetABC(i, face);
        object->list.SetUV(i, QUAD_UV[i % 2]);
    }
    object->list.BuildCmdList(one_state);
    find_box(object);
    object->at[0] = next_random(&seed) % 5600 - 2800;
    object->at[2] = next_random(&seed) % 5600 - 2800;
    object->at[1] = height(object->at[0], object->at[2]) - 10;
    object->turn = next_random(&seed);
}

/* The camera's place on its path, as a matrix from the world to the view. */
static void place_camera(CMatrix *view, int frame)
{
    int angle = frame * 24;
    int x = 1900 * COSINUS(angle) >> TRIGO_SHIFT, z = 1900 * SINUS(angle) >> TRIGO_SHIFT;
    int y = height(x, z) + 420;

    view->LoadIdentity();
    view->RotateX(DEGREE(14));
    view->RotateY(angle - DEGREE(78));
    view->Translate(-x, -y, -z);
}

/* Draws an object unless its bounding box is outside the frustum. */
static void draw(Object *object, const CMatrix *camera)
{
    CMatrix matrix;
    int box[8][3];

    matrix.Load(camera);
    matrix.Translate(object->at[0], object->at[1], object->at[2]);
    if (object->turn) {
        matrix.RotateY(object->turn);
    }
    for (int i = 0; i < 8; i++) {
        int corner[3];
        for (int k = 0; k < 3; k++) {
            corner[k] = i >> k & 1 ? object->high[k] : object->low[k];
        }
        matrix.TransformVector(corner, box[i]);
    }
    if (!Gpu.CrossFrustrum(&box[0][0])) {
        return;
    }
    Gpu.ViewMatrix = &matrix;
    Gpu.DrawTriangleList(&object->list);
    Gpu.ViewMatrix = 0;
}

static void draw_frame(int frame)
{
    CMatrix camera;

    place_camera(&camera, frame);
    for (int i = 0; i < TILES * TILES; i++) {
        draw(&terrain[i], &camera);
    }
    for (int i = 0; i < OBJECTS; i++) {
        objects[i].turn = i % 3 ? frame * 40 : 0;
        draw(&objects[i], &camera);
    }
    for (int i = 0; i < OBJECTS * 2; i++) {
        draw(&trees[i], &camera);
    }
}

int main(int argc, char **argv)
{
    static const int errors[3] = {0, 200, 1500};
    int frames = frames_wanted(argc, argv, 60), triangles = 0;
    int sky = COLOR_RGB(120, 180, 255) | COLOR_I(230);

    start(&Gpu);
    make_texture(&grass, grass_texel, -1);
    make_texture(&crate, crate_texel, -1);
    make_texture(&stone, stone_texel, -1);
    make_texture(&brick, brick_texel, -1);
    make_texture(&tree, tree_texel, 0);
    for (int i = 0; i < TILES * TILES; i++) {
        make_tile(&terrain[i], i % TILES, i / TILES);
        triangles += terrain[i].list.IndexListSize;
    }
    for (int i = 0; i < OBJECTS; i++) {
        make_object(&objects[i], i);
        triangles += objects[i].list.IndexListSize;
    }
    for (int i = 0; i < OBJECTS * 2; i++) {
        make_tree(&trees[i], i);
        triangles += trees[i].list.IndexListSize;
    }
    if (!Gpu.SetWorkMemory(2000, 0)) {
        fprintf(stderr, "no memory\n");
        return 1;
    }
    Gpu.TriangleMode = TRI_ZC;
    printf("%d triangles\n", triangles);
    /* A third of the frames for each, the last third without any error. */
    for (int part = 2; part >= 0; part--) {
        struct timespec from, to;
        int first = (2 - part) * frames / 3, last = (3 - part) * frames / 3;
        Gpu.ZcErrorMax = errors[part];
        timespec_get(&from, TIME_UTC);
        for (int frame = first; frame < last; frame++) {
            draw_frame(frame);
            end_frame(&Gpu, frame, "Benchmark", sky);
        }
        timespec_get(&to, TIME_UTC);
        double seconds = (double)(to.tv_sec - from.tv_sec) + (to.tv_nsec - from.tv_nsec) * 1e-9;
        if (last > first && seconds > 0) {
            double rate = (last - first) / seconds;
            printf("ZcErrorMax %4d: %.1f frames a second, score %.0f\n", errors[part], rate,
                   20 * rate);
        }
    }
    Gpu.Delete();
    return 0;
}
