/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * cube.h: a cube drawn face by face with DrawTriangle, for demo6 and demo7.
 */
#ifndef QUARK_CUBE_H
#define QUARK_CUBE_H

#include "common.h"

/* Transforms, projects and draws the cube's faces; `colors` holds one base
 * colour a face, or is null. The triangle state gives the rest. */
static inline void draw_cube(CVGpu *Gpu, CMatrix *matrix, int half, const unsigned char *colors)
{
    TVertex corner[8];

    for (int i = 0; i < 8; i++) {
        int local[3], world[3], screen[3] = {0, 0, 64};
        for (int k = 0; k < 3; k++) {
            local[k] = CUBE[i][k] * half;
        }
        matrix->TransformVector(local, world);
        corner[i].m = Gpu->ScrProjection(world, screen);
        corner[i].x = screen[0];
        corner[i].y = screen[1];
        corner[i].z = screen[2];
        corner[i].i = 255;
    }
    for (int i = 0; i < 12; i++) {
        const unsigned short *quad = CUBE_FACES[i / 2];
        const short *uv = QUAD_UV[i % 2];
        TVertex face[3];
        face[0] = corner[quad[0]];
        face[1] = corner[quad[1 + i % 2]];
        face[2] = corner[quad[2 + i % 2]];
        for (int k = 0; k < 3; k++) {
            face[k].u = uv[2 * k];
            face[k].v = uv[2 * k + 1];
        }
        if (colors) {
            Gpu->TriangleState->DrawColor = colors[i / 2];
        }
        Gpu->DrawTriangle(&face[0], &face[1], &face[2]);
    }
}

/* Where the cube of demo6, demo7 and demo8 is in a frame. */
static inline void place_cube(CMatrix *matrix, int frame)
{
    matrix->LoadIdentity();
    matrix->Translate(0, 0, -500);
    matrix->RotateX(DEGREE(10) + frame * 17);
    matrix->RotateY(DEGREE(-15) + frame * 41);
}

#endif
