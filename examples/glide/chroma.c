/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * chroma.c: blue-screening. The fish are painted on solid magenta, which the
 * chroma key leaves out. The texture is point sampled: a filter would mix
 * magenta into the outline. The bubbles' squares are keyed by their constant
 * colour, so that every third one is not drawn at all.
 */
#include "common.h"

#define KEY 0xffff00ffU

/* One letter per texel: space is the key colour. */
static const char *const FISH[16] = {
    "                ",
    "      bbbb      ",
    "     bbccbb     ",
    "   aaaaaaaa    a",
    "  aaacaaaaaa  aa",
    " aaaacaaaacaaaaa",
    " aeeacaaaacaaaca",
    "aaewacaaaacaacc ",
    "aaeeacaaaacaacc ",
    " aaaacaaaacaaaca",
    " ddaacaaaacaaaaa",
    "  dddcaadaaa  aa",
    "   ddddddaa    a",
    "     ccbb       ",
    "      bb        ",
    "                "
};

static Color fish_texel(float u, float v)
{
    switch (FISH[(int)(v * 16.0f)][(int)(u * 16.0f)]) {
    case 'a': return rgb(1.0f, 0.50f, 0.06f);
    case 'b': return rgb(0.86f, 0.27f, 0.05f);
    case 'c': return rgb(1.0f, 0.96f, 0.90f);
    case 'd': return rgb(1.0f, 0.74f, 0.30f);
    case 'e': return rgb(0.98f, 0.98f, 0.95f);
    case 'w': return rgb(0.05f, 0.05f, 0.10f);
    default: return rgb(1.0f, 0.0f, 1.0f);
    }
}

/* A fish as wide as `size`; it looks left, or right when `flip` is set. */
static void draw_fish(float x, float y, float size, int flip, Color light)
{
    float h = size / 2.0f, s0 = flip ? 256.0f : 0.0f, s1 = flip ? 0.0f : 256.0f;
    GrVertex a = vertex(x - h, y - h, light), b = vertex(x + h, y - h, light);
    GrVertex c = vertex(x + h, y + h, light), d = vertex(x - h, y + h, light);

    set_texture(&a, s0, 0.0f);
    set_texture(&b, s1, 0.0f);
    set_texture(&c, s1, 256.0f);
    set_texture(&d, s0, 256.0f);
    draw_quad(&a, &b, &c, &d);
}

static void draw_shoal(float time)
{
    FxU32 seed = 5;
    int i;

    for (i = 0; i < 22; i++) {
        float near = (float)i / 21.0f, size = 24.0f + 110.0f * near * near;
        float speed = (10.0f + 26.0f * near) * (i % 3 == 0 ? 1.0f : -1.0f);
        float x = 640.0f * random_unit(&seed) + speed * time;
        float y = 60.0f + 330.0f * random_unit(&seed) + 6.0f * sine(time + (float)i);
        Color light = mix_color(rgb(0.40f, 0.52f, 0.66f), rgb(1, 1, 1), ramp(0.0f, 0.9f, near));

        x -= 760.0f * floorf((x + 60.0f) / 760.0f);
        draw_fish(x, y, size, i % 3 == 0, light);
    }
}

/* Light from above, in slanted beams. */
static void draw_beams(float time)
{
    int i;

    use_added_light();
    for (i = 0; i < 6; i++) {
        float x = 60.0f + 110.0f * (float)i + 16.0f * sine(time * 0.7f + (float)(i * i));
        float w = 20.0f + 14.0f * lattice(i, 3);
        Color top = {0.45f, 0.85f, 0.80f, 0.32f}, end = {0.3f, 0.8f, 0.8f, 0.0f};
        GrVertex a = vertex(x, 0, top), b = vertex(x + w, 0, top);
        GrVertex c = vertex(x + w * 2.4f - 110.0f, 420, end), d = vertex(x - w - 110.0f, 420, end);
        draw_quad(&a, &b, &c, &d);
    }
    use_no_blending();
}

static void draw_sand(void)
{
    int i;

    for (i = 0; i < 40; i++) {
        float x = 16.0f * (float)i, y0 = 436.0f + 14.0f * noise((float)i / 40.0f, 0.3f, 6);
        float y1 = 436.0f + 14.0f * noise((float)(i + 1) / 40.0f, 0.3f, 6);
        GrVertex a = vertex(x, y0, rgb(0.60f, 0.62f, 0.46f)), b = vertex(x + 16.0f, y1, rgb(0.60f, 0.62f, 0.46f));
        GrVertex c = vertex(x + 16.0f, 480, rgb(0.16f, 0.28f, 0.30f)), d = vertex(x, 480, rgb(0.16f, 0.28f, 0.30f));
        draw_quad(&a, &b, &c, &d);
    }
}

/* Small squares; the key is compared with their constant colour. */
static void draw_bubbles(float time)
{
    static const GrColor_t colors[3] = {0xffb8f0f0, KEY, 0xff7fd0e0};
    FxU32 seed = 77;
    int i;

    for (i = 0; i < 66; i++) {
        float x = floorf(200.0f + 250.0f * sine(2.4f * (float)(i / 11)) + 14.0f * random_unit(&seed));
        float y = 430.0f - 36.0f * (float)(i % 11) - 24.0f * random_unit(&seed) - 9.0f * time;
        float size = floorf(2.0f + 4.0f * random_unit(&seed));

        y = floorf(y - 480.0f * floorf(y / 480.0f));
        grConstantColorValue(colors[i % 3]);
        shade_rectangle(x, y, x + size, y + size, rgb(0, 0, 0), rgb(0, 0, 0));
    }
}

int main(int argc, char **argv)
{
    int frames = frames_wanted(argc, argv, 1), frame;
    Texture fish;

    open_screen(GR_ORIGIN_UPPER_LEFT);
    fish = load_texture(GR_TMU0, fish_texel, GR_TEXFMT_RGB_565, GR_LOD_16);
    for (frame = 0; frame < frames; frame++) {
        float time = 0.1f * (float)frame;

        use_vertex_colors();
        shade_rectangle(0, 0, 640, 480, rgb(0.10f, 0.55f, 0.66f), rgb(0.01f, 0.10f, 0.24f));
        draw_sand();
        draw_beams(time);

        grChromakeyValue(KEY);
        grChromakeyMode(GR_CHROMAKEY_ENABLE);
        grColorCombine(GR_COMBINE_FUNCTION_SCALE_OTHER, GR_COMBINE_FACTOR_ONE,
                       GR_COMBINE_LOCAL_NONE, GR_COMBINE_OTHER_CONSTANT, FXFALSE);
        draw_bubbles(time);

        use_texture(GR_TMU0, &fish);
        grTexFilterMode(GR_TMU0, GR_TEXTUREFILTER_POINT_SAMPLED, GR_TEXTUREFILTER_POINT_SAMPLED);
        grTexMipMapMode(GR_TMU0, GR_MIPMAP_DISABLE, FXFALSE);
        guColorCombineFunction(GR_COLORCOMBINE_TEXTURE_TIMES_ITRGB);
        draw_shoal(time);
        grChromakeyMode(GR_CHROMAKEY_DISABLE);
        grBufferSwap(1);
    }
    grGlideShutdown();
    return 0;
}
