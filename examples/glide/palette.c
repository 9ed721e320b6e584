/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * palette.c: one 8-bit texture, four palettes. The texels never change; each
 * frame turns the palettes by a few entries, and the plasma flows. The last
 * panel replaces a quarter of its palette with grTexDownloadTablePartial.
 */
#include "common.h"

#define TEXELS (256 * 256 + 128 * 128 + 64 * 64 + 32 * 32 + 16 * 16 + 64 + 16 + 4 + 1)

/* A sum of waves that repeats at the edges, as an index 0..255. */
static FxU8 plasma(float u, float v)
{
    float x = 2.0f * PI * u, y = 2.0f * PI * v;
    float sum = sine(2.0f * x + sine(y)) + sine(x + 3.0f * y + 1.3f * sine(2.0f * x))
        + sine(3.0f * x - 2.0f * y) + 1.6f * cloud(u, v, 4);

    return (FxU8)(int)clampf((sum + 3.0f) * (255.0f / 7.6f), 0.0f, 255.0f);
}

static Texture load_plasma(GrChipID_t tmu)
{
    static FxU8 texels[TEXELS];
    Texture texture;
    FxU8 *at = texels;
    int side, x, y;

    for (side = 256; side > 0; side /= 2) {
        for (y = 0; y < side; y++) {
            for (x = 0; x < side; x++) {
                *at++ = plasma(((float)x + 0.5f) / (float)side, ((float)y + 0.5f) / (float)side);
            }
        }
    }
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

/* Colour at t = 0..1 of palette `which`; the ends meet. */
static Color palette_color(int which, float t)
{
    float wave = 0.5f - 0.5f * cosine(2.0f * PI * t), fast = 0.5f - 0.5f * cosine(6.0f * PI * t);

    switch (which) {
    case 0: /* embers */
        return mix_color(mix_color(rgb(0.10f, 0.02f, 0.05f), rgb(0.93f, 0.24f, 0.05f), ramp(0.1f, 0.7f, wave)),
                         rgb(1.0f, 0.95f, 0.62f), ramp(0.6f, 1.0f, wave));
    case 1: /* lagoon */
        return mix_color(mix_color(rgb(0.01f, 0.08f, 0.22f), rgb(0.03f, 0.56f, 0.62f), ramp(0.0f, 0.6f, wave)),
                         rgb(0.93f, 1.0f, 0.88f), ramp(0.6f, 1.0f, wave));
    case 2: /* oil on water */
        return mix_color(hue(0.55f + 0.75f * wave), rgb(0.10f, 0.08f, 0.20f), 0.35f + 0.3f * fast);
    default: /* contour lines on paper */
        return mix_color(rgb(0.95f, 0.92f, 0.84f), rgb(0.24f, 0.20f, 0.30f), ramp(0.70f, 0.95f, fast));
    }
}

static void load_palette(int which, int shift)
{
    GuTexPalette palette;
    int i;

    for (i = 0; i < 256; i++) {
        palette.data[i] = pack_color(palette_color(which, (float)((i + shift) & 255) / 256.0f));
    }
    grTexDownloadTable(GR_TMU0, GR_TEXTABLE_PALETTE, &palette);
    if (which == 3) {
        for (i = 0; i < 64; i++) { /* a red band travels through the sheet */
            palette.data[i + 96] = pack_color(mix_color(rgb(0.78f, 0.16f, 0.14f), rgb(0.96f, 0.72f, 0.38f),
                                                        (float)((i + shift) & 63) / 64.0f));
        }
        grTexDownloadTablePartial(GR_TMU0, GR_TEXTABLE_PALETTE, &palette, 96, 159);
    }
}

static void draw_panel(float x0, float y0, float x1, float y1, float drift)
{
    GrVertex a = vertex(x0, y0, rgb(1, 1, 1)), b = vertex(x1, y0, rgb(1, 1, 1));
    GrVertex c = vertex(x1, y1, rgb(1, 1, 1)), d = vertex(x0, y1, rgb(1, 1, 1));

    set_texture(&a, drift, 0.0f);
    set_texture(&b, drift + 300.0f, 0.0f);
    set_texture(&c, drift + 300.0f, 222.0f);
    set_texture(&d, drift, 222.0f);
    draw_quad(&a, &b, &c, &d);
}

int main(int argc, char **argv)
{
    int frames = frames_wanted(argc, argv, 60), frame, i;
    Texture texture;

    open_screen(GR_ORIGIN_UPPER_LEFT);
    texture = load_plasma(GR_TMU0);
    use_texture(GR_TMU0, &texture);
    guColorCombineFunction(GR_COLORCOMBINE_DECAL_TEXTURE);
    for (frame = 0; frame < frames; frame++) {
        grBufferClear(0xff0b0b10, 0, 0);
        for (i = 0; i < 4; i++) {
            float x0 = 4.0f + 319.0f * (float)(i & 1), y0 = 4.0f + 239.0f * (float)(i >> 1);

            load_palette(i, 4 * frame);
            draw_panel(x0, y0, x0 + 313.0f, y0 + 233.0f, 70.0f * (float)i);
        }
        grBufferSwap(1);
    }
    grGlideShutdown();
    return 0;
}
