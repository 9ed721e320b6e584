/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * textured.c: four texture formats in four columns: RGB 565, ARGB 4444, an
 * 8-bit palette, RGB 332. Above, the texture as it is (decal) on tilted tiles;
 * below, the texture times the light at the vertices, on spheres.
 */
#include "common.h"

#define PANELS 4

/* 565: a marbled green stone. */
static Color stone(float u, float v)
{
    float vein = fabsf(sine(2.0f * PI * (2.0f * u + v) + 7.0f * cloud(u, v, 4)));
    Color c = mix_color(rgb(0.05f, 0.32f, 0.26f), rgb(0.30f, 0.66f, 0.48f), cloud(u, v, 8));
    return mix_color(rgb(0.93f, 0.95f, 0.82f), c, ramp(0.0f, 0.30f, vein));
}

/* 4444: an openwork screen of rings; between them the alpha is 0. */
static Color lattice_screen(float u, float v)
{
    float x = u * 4.0f - floorf(u * 4.0f) - 0.5f, y = v * 4.0f - floorf(v * 4.0f) - 0.5f;
    float r = sqrtf(x * x + y * y), ring = fabsf(r - 0.44f);
    float cross_bar = fabsf(x) < fabsf(y) ? fabsf(x) : fabsf(y);
    float body = 1.0f - ramp(0.05f, 0.09f, ring < cross_bar ? ring : cross_bar);
    Color c = mix_color(rgb(0.55f, 0.26f, 0.06f), rgb(1.0f, 0.80f, 0.36f), ramp(0.6f, -0.6f, x + y));

    c.a = body;
    return c;
}

/* 332: a quilt of few, strong colours. */
static Color quilt(float u, float v)
{
    int i = (int)(u * 8.0f), j = (int)(v * 8.0f);
    float x = u * 8.0f - (float)i - 0.5f, y = v * 8.0f - (float)j - 0.5f;
    Color c = hue(lattice(i, j));

    if (fabsf(x) + fabsf(y) < 0.36f) {
        return rgb(1.0f, 0.95f, 0.67f);
    }
    return scale_color(c, (i + j) & 1 ? 1.0f : 0.55f);
}

/* Palette: rings whose index runs through a sunset of 256 colours. */
static Texture load_palette_rings(GrChipID_t tmu)
{
    static FxU8 texels[256 * 256 + 128 * 128 + 64 * 64 + 32 * 32 + 16 * 16 + 64 + 16 + 4 + 1];
    GuTexPalette palette;
    Texture texture;
    FxU8 *at = texels;
    int side, x, y, i;

    for (side = 256; side > 0; side /= 2) {
        for (y = 0; y < side; y++) {
            for (x = 0; x < side; x++) {
                float u = ((float)x + 0.5f) / (float)side - 0.5f;
                float v = ((float)y + 0.5f) / (float)side - 0.5f;
                float r = sqrtf(u * u + v * v) * 1700.0f + 190.0f * cloud(u + 0.5f, v + 0.5f, 4);
                i = (int)r % 512;
                *at++ = (FxU8)(i < 256 ? i : 511 - i);
            }
        }
    }
    for (i = 0; i < 256; i++) {
        float t = (float)i / 255.0f;
        Color c = mix_color(rgb(0.14f, 0.04f, 0.30f), rgb(0.92f, 0.20f, 0.36f), ramp(0.0f, 0.5f, t));
        palette.data[i] = pack_color(mix_color(c, rgb(1.0f, 0.93f, 0.62f), ramp(0.45f, 1.0f, t)));
    }
    grTexDownloadTable(tmu, GR_TEXTABLE_PALETTE, &palette);
    texture.info.smallLod = GR_LOD_1;
    texture.info.largeLod = GR_LOD_256;
    texture.info.aspectRatio = GR_ASPECT_1x1;
    texture.info.format = GR_TEXFMT_P_8;
    texture.info.data = texels;
    texture.address = reserve_texture(tmu, grTexTextureMemRequired(GR_MIPMAPLEVELMASK_BOTH,
                                                                   &texture.info));
    grTexDownloadMipMap(tmu, texture.address, GR_MIPMAPLEVELMASK_BOTH, &texture.info);
    return texture;
}

static void draw_tile(Camera camera, float x, float y, float swing)
{
    static const float at[4][2] = {{-1, 1}, {1, 1}, {1, -1}, {-1, -1}};
    Corner corners[4];
    int i;

    camera.center_x = x;
    camera.center_y = y;
    for (i = 0; i < 4; i++) {
        Vec p = turn(vec(at[i][0], at[i][1], 0.0f), 0.35f, swing);
        corners[i] = corner(add(p, vec(0.0f, 0.0f, 4.0f)), rgb(1, 1, 1),
                            128.0f + 128.0f * at[i][0], 128.0f - 128.0f * at[i][1]);
    }
    draw_in_space(&camera, corners, 4);
}

static Corner sphere_corner(int stack, int slice, float spin)
{
    float a = PI * (float)stack / 20.0f, b = 2.0f * PI * (float)slice / 32.0f;
    Vec n = turn(vec(sine(a) * cosine(b), cosine(a), sine(a) * sine(b)), -0.45f, spin);
    float sun = clampf(dot(n, unit(vec(-0.6f, 0.7f, -0.7f))), 0.0f, 1.0f);

    return corner(add(n, vec(0.0f, 0.0f, 4.0f)),
                  rgb(0.12f + 0.95f * sun, 0.13f + 0.92f * sun, 0.22f + 0.82f * sun),
                  512.0f * (float)slice / 32.0f, 256.0f * (float)stack / 20.0f);
}

static void draw_ball(Camera camera, float x, float y, float spin, GrCullMode_t cull)
{
    int stack, slice;

    camera.center_x = x;
    camera.center_y = y;
    grCullMode(cull);
    for (stack = 0; stack < 20; stack++) {
        for (slice = 0; slice < 32; slice++) {
            Corner q[4];
            q[0] = sphere_corner(stack, slice, spin);
            q[1] = sphere_corner(stack, slice + 1, spin);
            q[2] = sphere_corner(stack + 1, slice + 1, spin);
            q[3] = sphere_corner(stack + 1, slice, spin);
            draw_in_space(&camera, q, 4);
        }
    }
    grCullMode(GR_CULL_DISABLE);
}

static void draw_panel(Texture *texture, int i, float time)
{
    Camera camera = look_at(vec(0, 0, 0), vec(0, 0, 1), 262.0f);
    float x = 80.0f + 160.0f * (float)i;

    use_texture(GR_TMU0, texture);
    guAlphaSource(GR_ALPHASOURCE_TEXTURE_ALPHA);
    guColorCombineFunction(GR_COLORCOMBINE_DECAL_TEXTURE);
    draw_tile(camera, x, 128.0f, 0.55f * sine(time + 0.8f));
    guColorCombineFunction(GR_COLORCOMBINE_TEXTURE_TIMES_ITRGB);
    if (texture->info.format == GR_TEXFMT_ARGB_4444) {
        draw_ball(camera, x, 352.0f, time, GR_CULL_POSITIVE); /* the inside, seen through */
    }
    draw_ball(camera, x, 352.0f, time, GR_CULL_NEGATIVE);
}

int main(int argc, char **argv)
{
    int frames = frames_wanted(argc, argv, 1), frame, i;
    Texture textures[PANELS];

    open_screen(GR_ORIGIN_UPPER_LEFT);
    textures[0] = load_texture(GR_TMU0, stone, GR_TEXFMT_RGB_565, GR_LOD_256);
    textures[1] = load_texture(GR_TMU0, lattice_screen, GR_TEXFMT_ARGB_4444, GR_LOD_256);
    textures[2] = load_palette_rings(GR_TMU0);
    textures[3] = load_texture(GR_TMU0, quilt, GR_TEXFMT_RGB_332, GR_LOD_256);

    for (frame = 0; frame < frames; frame++) {
        use_no_blending();
        use_vertex_colors();
        shade_rectangle(0, 0, 640, 240, rgb(0.09f, 0.10f, 0.20f), rgb(0.22f, 0.20f, 0.34f));
        shade_rectangle(0, 240, 640, 480, rgb(0.22f, 0.20f, 0.34f), rgb(0.05f, 0.05f, 0.10f));
        use_blending();
        for (i = 0; i < PANELS; i++) {
            draw_panel(&textures[i], i, 0.05f * (float)frame);
        }
        grBufferSwap(1);
    }
    grGlideShutdown();
    return 0;
}
