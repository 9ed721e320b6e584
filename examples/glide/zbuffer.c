/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * zbuffer.c: triangles that all pass through one another. They are drawn in
 * no useful order; the z buffer finds the lines where they meet.
 */
#include "common.h"

#define BLADES 13

/* Evenly spread directions: equal steps in height, golden angle around. */
static Vec direction(int i)
{
    float y = 1.0f - (2.0f * (float)i + 1.0f) / BLADES, r = sqrtf(1.0f - y * y);
    return vec(r * cosine(2.39996f * (float)i), y, r * sine(2.39996f * (float)i));
}

/* An equilateral triangle around the origin, at right angles to `normal`. */
static void draw_blade(const Camera *camera, int i, float angle)
{
    Vec normal = turn(direction(i), 0.4f + 0.3f * angle, angle);
    Vec u = unit(cross(normal, vec(0.31f, 0.88f, -0.36f))), v = cross(normal, u);
    float facing = fabsf(dot(normal, unit(vec(-0.4f, 0.5f, -0.77f))));
    Color tone = hue((float)i / BLADES);
    Corner corners[3];
    int k;

    tone = mix_color(scale_color(tone, 0.40f + 0.60f * facing), rgb(1, 1, 1), 0.12f + 0.38f * facing * facing);
    for (k = 0; k < 3; k++) {
        float turns = 2.0f * PI * ((float)k / 3.0f + 0.13f * (float)i);
        Vec p = add(scale(u, 2.1f * cosine(turns)), scale(v, 2.1f * sine(turns)));
        corners[k] = corner(p, scale_color(tone, k == 0 ? 1.20f : k == 1 ? 0.85f : 0.55f), 0, 0);
    }
    draw_in_space(camera, corners, 3);
}

int main(int argc, char **argv)
{
    int frames = frames_wanted(argc, argv, 1), frame, i;
    Camera camera = look_at(vec(0.0f, 0.0f, -6.0f), vec(0.0f, 0.0f, 0.0f), 620.0f);

    open_screen(GR_ORIGIN_UPPER_LEFT);
    use_vertex_colors();
    for (frame = 0; frame < frames; frame++) {
        use_z_buffer();
        grBufferClear(0xff000000, 0, GR_ZDEPTHVALUE_FARTHEST);
        use_no_depth_buffer();
        shade_rectangle(0, 0, 640, 480, rgb(0.10f, 0.11f, 0.17f), rgb(0.03f, 0.03f, 0.06f));
        shade_ellipse(320, 240, 560, 420, rgb(0.30f, 0.31f, 0.42f), rgb(0.04f, 0.04f, 0.08f));
        use_z_buffer();
        for (i = 0; i < BLADES; i++) {
            draw_blade(&camera, i, 0.9f + 0.03f * (float)frame);
        }
        grBufferSwap(1);
    }
    grGlideShutdown();
    return 0;
}
