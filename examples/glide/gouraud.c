/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * gouraud.c: smooth shading. Three glossy spheres lit at their vertices over
 * a shaded backdrop; each has a mirror image in the floor. Spheres are convex,
 * so culling the back faces is all the hidden surface removal they need.
 */
#include "common.h"

#define SLICES 48
#define STACKS 32

static Vec on_sphere(int stack, int slice)
{
    float a = PI * (float)stack / STACKS, b = 2.0f * PI * (float)slice / SLICES;
    return vec(sine(a) * cosine(b), cosine(a), sine(a) * sine(b));
}

static float power(float base, int exponent)
{
    float result = 1.0f;

    while (exponent-- > 0) {
        result *= base;
    }
    return result;
}

/* Ambient, diffuse and specular light of a white lamp and a blue one. */
static Color shade(Vec normal, Color material)
{
    Vec lamp = unit(vec(-0.55f, 0.75f, -0.60f)), fill = unit(vec(0.9f, 0.1f, -0.15f));
    Vec to_eye = vec(0.0f, 0.0f, -1.0f);
    float diffuse = clampf(dot(normal, lamp), 0.0f, 1.0f);
    float blue = clampf(dot(normal, fill), 0.0f, 1.0f);
    float shine = power(clampf(dot(normal, unit(add(lamp, to_eye))), 0.0f, 1.0f), 40);
    float rim = power(1.0f - clampf(-normal.z, 0.0f, 1.0f), 3);

    return rgb(material.r * (0.10f + 0.95f * diffuse) + 0.95f * shine + 0.10f * blue + 0.10f * rim,
               material.g * (0.10f + 0.95f * diffuse) + 0.92f * shine + 0.18f * blue + 0.14f * rim,
               material.b * (0.12f + 0.95f * diffuse) + 0.85f * shine + 0.42f * blue + 0.26f * rim);
}

/* A sphere at (x, y) with a radius in pixels; `flip` is 1, or -1 for the
 * mirror image; alpha fades the picture out. */
static GrVertex sphere_vertex(int stack, int slice, float x, float y, float radius,
                              float flip, Color material, float alpha)
{
    Vec n = on_sphere(stack, slice);
    Color c = shade(n, material);

    c.a = flip < 0.0f ? alpha * clampf(0.35f - 0.65f * n.y, 0.0f, 1.0f) : alpha;
    return vertex(x + radius * n.x, y - flip * radius * n.y, c);
}

static void draw_sphere(float x, float y, float radius, float flip, Color material, float alpha)
{
    int stack, slice;

    grCullMode(flip > 0.0f ? GR_CULL_NEGATIVE : GR_CULL_POSITIVE);
    for (stack = 0; stack < STACKS; stack++) {
        for (slice = 0; slice < SLICES; slice++) {
            GrVertex a = sphere_vertex(stack, slice, x, y, radius, flip, material, alpha);
            GrVertex b = sphere_vertex(stack, slice + 1, x, y, radius, flip, material, alpha);
            GrVertex c = sphere_vertex(stack + 1, slice + 1, x, y, radius, flip, material, alpha);
            GrVertex d = sphere_vertex(stack + 1, slice, x, y, radius, flip, material, alpha);
            draw_quad(&a, &b, &c, &d);
        }
    }
    grCullMode(GR_CULL_DISABLE);
}

static void draw_ball(float x, float floor_y, float radius, Color material)
{
    Color dark = {0.0f, 0.0f, 0.02f, 0.75f}, clear = {0.0f, 0.0f, 0.02f, 0.0f};

    use_blending();
    draw_sphere(x, floor_y + radius, radius, -1.0f, material, 0.75f);
    shade_ellipse(x + radius * 0.35f, floor_y + 2.0f, radius * 1.15f, radius * 0.17f, dark, clear);
    use_no_blending();
    draw_sphere(x, floor_y - radius, radius, 1.0f, material, 1.0f);
}

int main(int argc, char **argv)
{
    int frames = frames_wanted(argc, argv, 1), frame;

    open_screen(GR_ORIGIN_UPPER_LEFT);
    use_vertex_colors();
    for (frame = 0; frame < frames; frame++) {
        float bob = 3.0f * sine(0.1f * (float)frame);

        use_no_blending();
        shade_rectangle(0, 0, 640, 300, rgb(0.05f, 0.07f, 0.16f), rgb(0.30f, 0.36f, 0.50f));
        shade_rectangle(0, 300, 640, 480, rgb(0.26f, 0.30f, 0.42f), rgb(0.05f, 0.06f, 0.11f));
        draw_ball(462.0f, 340.0f + bob, 84.0f, rgb(0.06f, 0.52f, 0.78f));
        draw_ball(190.0f, 352.0f - bob, 112.0f, rgb(0.86f, 0.16f, 0.14f));
        draw_ball(352.0f, 396.0f, 66.0f, rgb(0.96f, 0.66f, 0.10f));
        grBufferSwap(1);
    }
    grGlideShutdown();
    return 0;
}
