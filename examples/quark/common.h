/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * common.h: what the fifteen Quark 3D programs share: the loop over frames,
 * textures made from formulas, and solids.
 *
 *     c++ -Iinclude examples/quark/demo0.cpp -o demo0 -lquark3d
 *     ./demo0            draws the usual number of frames
 *     ./demo0 -n 100     draws 100
 *
 * All arithmetic is in integers, so that every machine draws the same frames.
 */
#ifndef QUARK_COMMON_H
#define QUARK_COMMON_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <quark.h>

/* --- the loop ----------------------------------------------------------- */

/* The clock of the programs: 25 frames a second, whatever the machine. */
static const unsigned int TICKS_PER_FRAME = 40;

/* Frames to draw: the number after -n, or `otherwise`. */
static inline int frames_wanted(int argc, char **argv, int otherwise)
{
    if (argc == 1) {
        return otherwise;
    }
    if (argc == 3 && strcmp(argv[1], "-n") == 0 && atoi(argv[2]) > 0) {
        return atoi(argv[2]);
    }
    fprintf(stderr, "usage: %s [-n FRAMES]\n", argv[0]);
    exit(2);
}

/* Starts the processor with the usual planes and field of view. */
static inline void start(CVGpu *Gpu)
{
    if (!Gpu->Init(-64, -4095, 60)) {
        fprintf(stderr, "the processor does not start\n");
        exit(1);
    }
    Gpu->TextState.DrawColor = COLOR_RGB(255, 255, 255);
}

/* Draws the frame rate and a line of text, and shows the frame. */
static inline void end_frame(CVGpu *Gpu, int frame, const char *title, int clear_color)
{
    Gpu->PrintFps((unsigned int)frame * TICKS_PER_FRAME);
    Gpu->PrintXY((char *)title, SCR_X - 8 * (int)strlen(title), 0);
    Gpu->FlushFB(0, clear_color);
}

/* A state as programs usually set it. */
static inline TRasterState state_of(int mode, int color, CTexture *texture)
{
    TRasterState state;

    memset(&state, 0, sizeof state);
    state.DrawMode = (unsigned char)mode;
    state.DrawColor = (unsigned char)color;
    state.DrawIntensity = 255;
    state.TestCulling = 1;
    state.Texture = texture;
    return state;
}

/* --- numbers ------------------------------------------------------------ */

/* The next of a fixed sequence of numbers, 0..32767. */
static inline int next_random(unsigned int *seed)
{
    *seed = *seed * 1664525u + 1013904223u;
    return (int)(*seed >> 17);
}

/* A fixed number of 0..255 for each pair of whole numbers. */
static inline int lattice(int x, int y)
{
    unsigned int h = (unsigned int)x * 0x9e3779b1u ^ (unsigned int)y * 0x85ebca77u;

    h = (h ^ (h >> 15)) * 0x2c1b3c6du;
    h = (h ^ (h >> 12)) * 0x297a2d39u;
    return (int)((h ^ (h >> 15)) >> 24);
}

/* Smooth noise of 0..255 over a square of `side` units, `cells` across, that
 * repeats without a seam. */
static inline int noise(int x, int y, int side, int cells)
{
    int fx = x * cells % side * 256 / side, fy = y * cells % side * 256 / side;
    int x0 = x * cells / side % cells, y0 = y * cells / side % cells;
    int x1 = (x0 + 1) % cells, y1 = (y0 + 1) % cells;
    int top, bottom;

    fx = fx * fx * (768 - 2 * fx) >> 16;
    fy = fy * fy * (768 - 2 * fy) >> 16;
    top = lattice(x0, y0) * (256 - fx) + lattice(x1, y0) * fx;
    bottom = lattice(x0, y1) * (256 - fx) + lattice(x1, y1) * fx;
    return ((top >> 8) * (256 - fy) + (bottom >> 8) * fy) >> 8;
}

/* Two octaves of noise, 0..255. */
static inline int cloud(int x, int y, int side, int cells)
{
    return (2 * noise(x, y, side, cells) + noise(x, y, side, 2 * cells)) / 3;
}

/* A base colour, dithered by position so that eight levels look like more.
 * Channels of 0..255 and beyond. */
static inline unsigned char dithered(int r, int g, int b, int x, int y)
{
    static const int matrix[4][4] = {
        {0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
    int d = matrix[y & 3][x & 3];

    r += d * 4 - 30;
    g += d * 2 - 15;
    b += d * 2 - 15;
    r = r < 0 ? 0 : r > 255 ? 255 : r;
    g = g < 0 ? 0 : g > 255 ? 255 : g;
    b = b < 0 ? 0 : b > 255 ? 255 : b;
    return (unsigned char)COLOR_RGB(r, g, b);
}

/* --- textures, 64x64 ---------------------------------------------------- */

#define SIDE 64

/* A texture from a function of the texel's place; `key` as of Init. */
static inline void make_texture(CTexture *texture, unsigned char (*texel)(int, int), int key)
{
    unsigned char texels[SIDE * SIDE];
    int x, y;

    for (y = 0; y < SIDE; y++) {
        for (x = 0; x < SIDE; x++) {
            texels[y * SIDE + x] = texel(x, y);
        }
    }
    texture->Init(texels, SIDE, SIDE, key);
}

/* A wooden crate: boards with a frame and a cross brace. */
static inline unsigned char crate_texel(int x, int y)
{
    int frame = x < 7 || y < 7 || x > 56 || y > 56;
    int brace = abs(x - y) < 6;
    int grain = cloud(frame && (x < 7 || x > 56) ? y : x, brace ? x + y : y * 4 % SIDE, SIDE, 8);
    int light = 120 + grain / 3;

    if (frame || brace) {
        light += 35;
    }
    if (x == 7 || y == 7 || x == 56 || y == 56 || (!frame && abs(x - y) == 6)) {
        light -= 80;
    }
    if (!frame && !brace && (x - 7) % 10 == 0) {
        light -= 60;
    }
    return dithered(light + 40, light * 3 / 4, light / 3, x, y);
}

/* Red bricks with grey mortar. */
static inline unsigned char brick_texel(int x, int y)
{
    int row = y / 16, column = (x + (row & 1 ? 16 : 0)) % SIDE;
    int grain = cloud(x, y, SIDE, 8);

    if (y % 16 < 2 || column % 32 < 2) {
        return dithered(150 + grain / 6, 145 + grain / 6, 130 + grain / 6, x, y);
    }
    grain = grain / 4 + lattice(row, column / 32) / 5;
    return dithered(150 + grain, 55 + grain / 2, 35 + grain / 2, x, y);
}

/* A stone floor of four slabs. */
static inline unsigned char stone_texel(int x, int y)
{
    int grain = cloud(x, y, SIDE, 4) / 2 + lattice(x / 32, y / 32) / 6;

    if (x % 32 == 0 || y % 32 == 0) {
        grain = 0;
    }
    return dithered(60 + grain, 70 + grain, 80 + grain, x, y);
}

/* Grass. */
static inline unsigned char grass_texel(int x, int y)
{
    int grain = cloud(x, y, SIDE, 8);

    return dithered(20 + grain / 3, 80 + grain / 2, 20 + grain / 8, x, y);
}

/* A disc with a soft shading, transparent (0) outside. */
static inline unsigned char ball_texel(int x, int y)
{
    int dx = 2 * x - SIDE + 1, dy = 2 * y - SIDE + 1;
    int square = dx * dx + dy * dy;
    int light;

    if (square > (SIDE - 4) * (SIDE - 4)) {
        return 0;
    }
    light = 255 - Sqrti((dx + 20) * (dx + 20) + (dy + 24) * (dy + 24)) * 5 / 2;
    return dithered(light + 60, light / 2 + 40, 36, x, y) | 1;
}

/* A grate: bars with holes (0) between them. */
static inline unsigned char grate_texel(int x, int y)
{
    int bar = x % 16 < 5 || y % 16 < 5;
    int light = x % 16 == 0 || y % 16 == 0 ? 230 : 130;

    return bar ? dithered(light, light, light - 10, x, y) | 1 : 0;
}

/* A tree, transparent (0) around it. */
static inline unsigned char tree_texel(int x, int y)
{
    int width = y < 50 ? 4 + y % 17 + y / 3 : 0;
    int grain = cloud(x, y, SIDE, 16);

    if (y >= 50) {
        return abs(x - 32) < 4 ? dithered(110, 70, 30, x, y) | 1 : 0;
    }
    if (y < 3 || abs(x - 32) > width || (abs(x - 32) > width - 3 && grain < 100)) {
        return 0;
    }
    return dithered(10 + grain / 6, 60 + grain / 2, 20, x, y) | 8;
}

/* --- solids ------------------------------------------------------------- */

/* Corners of a cube of half side 1, and its faces counter-clockwise seen from
 * outside: front, back, right, left, top, bottom. */
static const short CUBE[8][3] = {{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1},
                                 {-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}};
static const unsigned short CUBE_FACES[6][4] = {{0, 1, 2, 3}, {5, 4, 7, 6}, {1, 5, 6, 2},
                                                {4, 0, 3, 7}, {3, 2, 6, 7}, {4, 5, 1, 0}};
/* Texture coordinates of the two triangles of a face. */
static const short QUAD_UV[2][6] = {{0, 255, 255, 255, 255, 0}, {0, 255, 255, 0, 0, 0}};

/* A cube as a list of 8 vertices and 12 triangles with texture coordinates in
 * its faces; further bits of the formats as asked. */
static inline void make_cube(CTriangleList *list, int half, int vertex_format, int index_format,
                             TRasterState *states)
{
    int i, k;

    list->Init(vertex_format, 8, index_format, 12, states);
    for (i = 0; i < 8; i++) {
        short at[3];
        for (k = 0; k < 3; k++) {
            at[k] = (short)(CUBE[i][k] * half);
        }
        list->SetXYZ(i, at);
    }
    for (i = 0; i < 12; i++) {
        const unsigned short *quad = CUBE_FACES[i / 2];
        unsigned short face[3];
        face[0] = quad[0];
        face[1] = quad[1 + i % 2];
        face[2] = quad[2 + i % 2];
        list->SetABC(i, face);
        if (index_format & IF_UV) {
            list->SetUV(i, QUAD_UV[i % 2]);
        }
    }
}

/* A sphere of `rings` x `sectors` patches with a vertex for each corner. */
static inline void make_sphere(CTriangleList *list, int radius, int rings, int sectors,
                               int vertex_format, int index_format, TRasterState *states)
{
    int r, s, at = 0, face = 0;

    list->Init(vertex_format, (rings + 1) * (sectors + 1), index_format, rings * sectors * 2,
               states);
    for (r = 0; r <= rings; r++) {
        for (s = 0; s <= sectors; s++) {
            int up = ANGLE2PI / 4 - r * (ANGLE2PI / 2) / rings;
            int around = s * ANGLE2PI / sectors;
            int flat = radius * COSINUS(up) >> TRIGO_SHIFT;
            short place[3], uv[2];
            place[0] = (short)(flat * SINUS(around) >> TRIGO_SHIFT);
            place[1] = (short)(radius * SINUS(up) >> TRIGO_SHIFT);
            place[2] = (short)(flat * COSINUS(around) >> TRIGO_SHIFT);
            list->SetXYZ(at, place);
            uv[0] = (short)(s * 512 / sectors);
            uv[1] = (short)(r * 256 / rings);
            if (vertex_format & VF_UV) {
                list->SetUV(at, uv);
            }
            at++;
        }
    }
    for (r = 0; r < rings; r++) {
        for (s = 0; s < sectors; s++) {
            unsigned short a = (unsigned short)(r * (sectors + 1) + s);
            unsigned short b = (unsigned short)(a + sectors + 1);
            unsigned short one[3], two[3];
            one[0] = a, one[1] = b, one[2] = (unsigned short)(b + 1);
            two[0] = a, two[1] = (unsigned short)(b + 1), two[2] = (unsigned short)(a + 1);
            list->SetABC(face++, one);
            list->SetABC(face++, two);
        }
    }
}

/* A ring (torus) of `sectors` x `sides` patches. */
static inline void make_ring(CTriangleList *list, int radius, int thickness, int sectors, int sides,
                             int vertex_format, int index_format, TRasterState *states)
{
    int i, k, face = 0;

    list->Init(vertex_format, sectors * sides, index_format, sectors * sides * 2, states);
    for (i = 0; i < sectors; i++) {
        for (k = 0; k < sides; k++) {
            int around = i * ANGLE2PI / sectors, across = k * ANGLE2PI / sides;
            int out = radius + (thickness * COSINUS(across) >> TRIGO_SHIFT);
            short place[3];
            place[0] = (short)(out * COSINUS(around) >> TRIGO_SHIFT);
            place[1] = (short)(out * SINUS(around) >> TRIGO_SHIFT);
            place[2] = (short)(thickness * SINUS(across) >> TRIGO_SHIFT);
            list->SetXYZ(i * sides + k, place);
        }
    }
    for (i = 0; i < sectors; i++) {
        for (k = 0; k < sides; k++) {
            int i2 = (i + 1) % sectors, k2 = (k + 1) % sides;
            unsigned short one[3], two[3];
            one[0] = (unsigned short)(i * sides + k), one[1] = (unsigned short)(i2 * sides + k);
            one[2] = (unsigned short)(i2 * sides + k2);
            two[0] = one[0], two[1] = one[2], two[2] = (unsigned short)(i * sides + k2);
            list->SetABC(face++, one);
            list->SetABC(face++, two);
        }
    }
}

/* --- light -------------------------------------------------------------- */

/* The direction towards the light in an object's coordinates, unit length. */
static inline void local_light(CMatrix *matrix, int x, int y, int z, int *light)
{
    int world[3];

    world[0] = x, world[1] = y, world[2] = z;
    Normalize(world);
    matrix->InvRotateVector(world, light);
}

/* Intensity of a surface with that unit normal, at least `ambient`. */
static inline int lit(const short *normal, const int *light, int ambient)
{
    int dot = (normal[0] * light[0] + normal[1] * light[1] + normal[2] * light[2]) >> TRIGO_SHIFT;
    int intensity = dot * 255 >> TRIGO_SHIFT;

    return intensity < ambient ? ambient : intensity > 255 ? 255 : intensity;
}

#endif
