/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * cull.c: one shell three times: every triangle, without those of negative
 * area, without those of positive area. The shell is a sphere with slots cut
 * into it; the outside is blue, the inside, wound the other way, is orange.
 */
#include "common.h"

#define STACKS 40
#define SLICES 60

static Vec on_shell(int stack, int slice, float time)
{
    float a = PI * (float)stack / STACKS;
    float b = 2.0f * PI * (float)slice / SLICES + 1.4f * cosine(a); /* twisted slots */
    return turn(vec(sine(a) * cosine(b), cosine(a), sine(a) * sine(b)), -0.5f, time);
}

static Corner shell_corner(Vec n, int inside)
{
    Vec outward = inside ? scale(n, -1.0f) : n;
    float sun = clampf(dot(outward, unit(vec(-0.55f, 0.70f, -0.65f))), 0.0f, 1.0f);
    float back = clampf(dot(outward, unit(vec(0.40f, 0.35f, 0.85f))), 0.0f, 1.0f);
    float shine = sun * sun * sun * sun;
    Color c = inside ? rgb(0.98f, 0.52f, 0.16f) : rgb(0.20f, 0.48f, 0.86f);

    c = scale_color(c, 0.26f + 0.78f * sun + 0.55f * back);
    c = mix_color(c, rgb(1, 1, 1), 0.5f * shine * shine);
    return corner(scale(n, inside ? 0.97f : 1.0f), c, 0, 0);
}

static void draw_patch(const Camera *camera, int stack, int slice, float time)
{
    Vec a = on_shell(stack, slice, time), b = on_shell(stack, slice + 1, time);
    Vec c = on_shell(stack + 1, slice + 1, time), d = on_shell(stack + 1, slice, time);
    Corner outer[4], inner[4];

    outer[0] = shell_corner(a, 0);
    outer[1] = shell_corner(b, 0);
    outer[2] = shell_corner(c, 0);
    outer[3] = shell_corner(d, 0);
    draw_in_space(camera, outer, 4);
    inner[0] = shell_corner(d, 1);
    inner[1] = shell_corner(c, 1);
    inner[2] = shell_corner(b, 1);
    inner[3] = shell_corner(a, 1);
    draw_in_space(camera, inner, 4);
}

static void draw_shell(float x, GrCullMode_t cull, float time)
{
    Camera camera = look_at(vec(0, 0, -5), vec(0, 0, 0), 470.0f);
    int stack, slice;

    camera.center_x = x;
    camera.center_y = 228.0f;
    grCullMode(cull);
    for (stack = 3; stack < STACKS - 3; stack++) {
        for (slice = 0; slice < SLICES; slice++) {
            if (slice % 10 < 6) { /* six slots */
                draw_patch(&camera, stack, slice, time);
            }
        }
    }
    grCullMode(GR_CULL_DISABLE);
}

int main(int argc, char **argv)
{
    int frames = frames_wanted(argc, argv, 1), frame;
    Color dark = {0.0f, 0.0f, 0.0f, 0.45f}, clear = {0.0f, 0.0f, 0.0f, 0.0f};
    float x;

    open_screen(GR_ORIGIN_UPPER_LEFT);
    use_vertex_colors();
    for (frame = 0; frame < frames; frame++) {
        float time = 0.4f + 0.03f * (float)frame;

        use_z_buffer();
        grBufferClear(0xff000000, 0, GR_ZDEPTHVALUE_FARTHEST);
        use_no_depth_buffer();
        shade_rectangle(0, 0, 640, 480, rgb(0.90f, 0.89f, 0.86f), rgb(0.70f, 0.71f, 0.74f));
        use_blending();
        for (x = 112.0f; x < 640.0f; x += 208.0f) {
            shade_ellipse(x, 352.0f, 92.0f, 15.0f, dark, clear);
        }
        use_no_blending();
        use_z_buffer();
        draw_shell(112.0f, GR_CULL_DISABLE, time);
        draw_shell(320.0f, GR_CULL_NEGATIVE, time);
        draw_shell(528.0f, GR_CULL_POSITIVE, time);
        grBufferSwap(1);
    }
    grGlideShutdown();
    return 0;
}
