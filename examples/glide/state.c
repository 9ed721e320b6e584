/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * state.c: grGlideGetState and grGlideSetState. The left panel is drawn with
 * a carefully set up state, which is then saved; the middle one after nearly
 * everything has been changed; the right one after the state is restored, by
 * code that sets nothing. The left panel, drawn once more with the restored
 * state, must equal itself bit for bit, or the program fails.
 */
#include "common.h"

#define PANEL_WIDTH  200
#define PANEL_HEIGHT 400

static Color weave(float u, float v)
{
    int i = (int)(u * 8.0f), j = (int)(v * 8.0f);
    float x = u * 8.0f - (float)i - 0.5f, y = v * 8.0f - (float)j - 0.5f;
    float across = (i + j) & 1 ? x : y, shade = 0.55f + 0.45f * cosine(3.0f * across);
    return scale_color((i + j) & 1 ? rgb(0.95f, 0.82f, 0.55f) : rgb(0.80f, 0.35f, 0.25f), shade);
}

/* A ribbon in depth that coils down the panel, as a strip of quads. */
static Corner ribbon_corner(int i, int side, float time)
{
    float a = 0.22f * (float)i + time, y = 3.3f - 0.055f * (float)i, r = 1.15f;
    Vec out = vec(sine(a), 0.0f, -cosine(a));
    float light = 0.30f + 0.70f * clampf(0.35f + 0.65f * dot(out, unit(vec(-0.5f, 0.3f, -0.8f))), 0.0f, 1.0f);

    return corner(vec(r * out.x, y + (side ? -0.42f : 0.42f), 6.5f + r * out.z),
                  rgb(light, light * 0.97f, light * 0.92f), 34.0f * (float)i, side ? 256.0f : 0.0f);
}

static void draw_ribbon(float x, float time)
{
    Camera camera = look_at(vec(0, 0, 0), vec(0, 0, 1), 360.0f);
    int i;

    camera.center_x = x;
    for (i = 0; i < 120; i++) {
        Corner q[4];
        q[0] = ribbon_corner(i, 0, time);
        q[1] = ribbon_corner(i + 1, 0, time);
        q[2] = ribbon_corner(i + 1, 1, time);
        q[3] = ribbon_corner(i, 1, time);
        draw_in_space(&camera, q, 4);
    }
}

/* The state worth saving: w buffer, texture times light, fog, no culling. */
static void set_state(Texture *texture)
{
    GrFog_t table[GR_FOG_TABLE_SIZE];

    guFogGenerateLinear(table, 5.2f, 9.0f);
    grFogTable(table);
    grFogColorValue(0xff20406b);
    grFogMode(GR_FOG_WITH_TABLE);
    use_w_buffer();
    use_texture(GR_TMU0, texture);
    guColorCombineFunction(GR_COLORCOMBINE_TEXTURE_TIMES_ITRGB);
    grDitherMode(GR_DITHER_4x4);
}

static void change_everything(void)
{
    grFogMode(GR_FOG_DISABLE);
    grFogColorValue(0xffffffff);
    grDepthBufferFunction(GR_CMP_ALWAYS);
    grCullMode(GR_CULL_POSITIVE);
    grConstantColorValue(0xff59d0c0);
    guColorCombineFunction(GR_COLORCOMBINE_TEXTURE_TIMES_CCRGB);
    grTexFilterMode(GR_TMU0, GR_TEXTUREFILTER_POINT_SAMPLED, GR_TEXTUREFILTER_POINT_SAMPLED);
    grTexLodBiasValue(GR_TMU0, 3.0f);
    grAlphaBlendFunction(GR_BLEND_ONE, GR_BLEND_ONE, GR_BLEND_ONE, GR_BLEND_ZERO);
    grAlphaTestFunction(GR_CMP_NOTEQUAL);
    grDitherMode(GR_DITHER_DISABLE);
    grClipWindow(220, 40, 420, 440);
    grDepthMask(FXFALSE);
}

static void clear_panel(int x, GrColor_t color)
{
    grClipWindow((FxU32)x, 40, (FxU32)(x + PANEL_WIDTH), 40 + PANEL_HEIGHT);
    grBufferClear(color, 0, GR_WDEPTHVALUE_FARTHEST);
}

static void read_left_panel(FxU16 *pixels)
{
    if (!grLfbReadRegion(GR_BUFFER_BACKBUFFER, 10, 40, PANEL_WIDTH, PANEL_HEIGHT,
                         PANEL_WIDTH * 2, pixels)) {
        fprintf(stderr, "cannot read the back buffer\n");
        exit(1);
    }
}

/* Draws the three panels; returns whether the left one came out the same
 * before and after. */
static int draw_frame(Texture *texture, float time)
{
    static FxU16 before[PANEL_WIDTH * PANEL_HEIGHT], after[PANEL_WIDTH * PANEL_HEIGHT];
    GrState saved;

    grClipWindow(0, 0, SCREEN_WIDTH, SCREEN_HEIGHT);
    set_state(texture);
    grBufferClear(0xff0e1420, 0, GR_WDEPTHVALUE_FARTHEST);
    clear_panel(10, 0xff20406b);
    draw_ribbon(110.0f, time);
    read_left_panel(before);
    grGlideGetState(&saved);

    clear_panel(220, 0xff2b1230);
    change_everything();
    draw_ribbon(320.0f, time);

    grGlideSetState(&saved);
    grBufferClear(0xff20406b, 0, GR_WDEPTHVALUE_FARTHEST); /* the saved clip window */
    draw_ribbon(110.0f, time);
    read_left_panel(after);
    clear_panel(430, 0xff20406b);
    draw_ribbon(530.0f, time);
    return memcmp(before, after, sizeof before) == 0;
}

int main(int argc, char **argv)
{
    int frames = frames_wanted(argc, argv, 1), frame, same = 1;
    Texture texture;

    open_screen(GR_ORIGIN_UPPER_LEFT);
    texture = load_texture(GR_TMU0, weave, GR_TEXFMT_RGB_565, GR_LOD_128);
    for (frame = 0; frame < frames; frame++) {
        same &= draw_frame(&texture, 0.04f * (float)frame);
        grBufferSwap(1);
    }
    grGlideShutdown();
    if (!same) {
        fprintf(stderr, "the restored state draws another picture\n");
    }
    return same ? 0 : 1;
}
