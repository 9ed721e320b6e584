/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * texture_formats.c: every texel format, point sampled (upper half) and
 * bilinear (lower half), blended by its alpha over a grey check. One texel of
 * each is compared with its decoding.
 */
#include "conformance.h"

typedef struct {
    GrTextureFormat_t format;
    FxU16 texel;
    int a, r, g, b; /* as the format decodes it */
} Format;

static const Format formats[] = {
    {GR_TEXFMT_RGB_332, 0xb6, 255, 0xb6, 0xb6, 0xaa},
    {GR_TEXFMT_ALPHA_8, 0x5c, 0x5c, 0x5c, 0x5c, 0x5c},
    {GR_TEXFMT_INTENSITY_8, 0x5c, 255, 0x5c, 0x5c, 0x5c},
    {GR_TEXFMT_ALPHA_INTENSITY_44, 0x9c, 0x99, 0xcc, 0xcc, 0xcc},
    {GR_TEXFMT_P_8, 0x21, 255, 0x21, 0xde, 0x80},
    {GR_TEXFMT_YIQ_422, 0x80, 255, 0x88, 0x88, 0x88},
    {GR_TEXFMT_ARGB_8332, 0x70b6, 0x70, 0xb6, 0xb6, 0xaa},
    {GR_TEXFMT_AYIQ_8422, 0x7080, 0x70, 0x88, 0x88, 0x88},
    {GR_TEXFMT_RGB_565, 0x8c51, 255, 0x8c, 0x8a, 0x8c},
    {GR_TEXFMT_ARGB_1555, 0xc631, 255, 0x8c, 0x8c, 0x8c},
    {GR_TEXFMT_ARGB_4444, 0x5af0, 0x55, 0xaa, 0xff, 0x00},
    {GR_TEXFMT_ALPHA_INTENSITY_88, 0x6633, 0x66, 0x33, 0x33, 0x33},
    {GR_TEXFMT_AP_88, 0x6621, 0x66, 0x21, 0xde, 0x80}
};

/* A 16x16 picture in any format: formats with tables are given numbers. */
static Texture picture(GrTextureFormat_t format, FxU16 first)
{
    FxU16 wide[256];
    FxU8 narrow[256];
    Texture t;
    int i;

    t.info.smallLod = t.info.largeLod = GR_LOD_16;
    t.info.aspectRatio = GR_ASPECT_1x1;
    t.info.format = format;
    for (i = 0; i < 256; i++) {
        FxU8 texel[2] = {0, 0};

        if (format == GR_TEXFMT_P_8 || format == GR_TEXFMT_YIQ_422) {
            texel[0] = (FxU8)i;
        } else if (format == GR_TEXFMT_AP_88 || format == GR_TEXFMT_AYIQ_8422) {
            texel[0] = (FxU8)i;
            texel[1] = (FxU8)(255 - i);
        } else {
            store_texel(format, test_card((float)(i % 16) / 16.0f, (float)(i / 16) / 16.0f), texel);
        }
        narrow[i] = texel[0];
        wide[i] = (FxU16)(texel[0] | texel[1] << 8);
    }
    narrow[0] = (FxU8)first;
    wide[0] = first;
    t.info.data = format < GR_TEXFMT_16BIT ? (void *)narrow : (void *)wide;
    t.address = reserve_texture(GR_TMU0, grTexTextureMemRequired(GR_MIPMAPLEVELMASK_BOTH, &t.info));
    CHECK(t.address % 8 == 0);
    grTexDownloadMipMap(GR_TMU0, t.address, GR_MIPMAPLEVELMASK_BOTH, &t.info);
    t.info.data = NULL;
    return t;
}

static void load_tables(void)
{
    GuTexPalette palette;
    GuNccTable ncc;
    int i;

    for (i = 0; i < 256; i++) {
        palette.data[i] = (FxU32)(i << 16 | (255 - i) << 8 | 0x80);
    }
    grTexDownloadTable(GR_TMU0, GR_TEXTABLE_PALETTE, &palette);
    memset(&ncc, 0, sizeof ncc);
    for (i = 0; i < 4; i++) {
        ncc.packed_data[i] = (FxU32)((68 * i) | (68 * i + 17) << 8 | (68 * i + 34) << 16)
            | (FxU32)(68 * i + 51) << 24;
    }
    for (i = 1; i < 4; i++) {
        FxU32 up = (FxU32)(40 * i), down = (FxU32)(512 - 40 * i);

        ncc.packed_data[4 + i] = up << 18 | down;
        ncc.packed_data[8 + i] = up << 9 | down << 18;
    }
    grTexDownloadTable(GR_TMU0, GR_TEXTABLE_NCC0, &ncc);
    grTexNCCTable(GR_TMU0, GR_NCCTABLE_NCC0);
}

int main(void)
{
    size_t i;

    open_small(GR_ORIGIN_UPPER_LEFT);
    load_tables();
    clear_to(0x404040);
    use_vertex_colors();
    for (i = 0; i < 10 * 8; i += 1) {
        Box half = cell((int)i, 10, 8);

        half.x1 = (half.x0 + half.x1) / 2;
        fill_box(half, 255, 0x90, 0x90, 0x90);
    }
    for (i = 0; i < COUNT_OF(formats); i++) {
        const Format *f = &formats[i];
        Texture t = picture(f->format, f->texel);
        Box box = cell((int)i, 5, 6), corner;
        int channel;

        use_texture(GR_TMU0, &t);
        grTexMipMapMode(GR_TMU0, GR_MIPMAP_DISABLE, FXFALSE);
        guColorCombineFunction(GR_COLORCOMBINE_DECAL_TEXTURE);
        guAlphaSource(GR_ALPHASOURCE_TEXTURE_ALPHA);
        use_blending();
        grTexFilterMode(GR_TMU0, GR_TEXTUREFILTER_POINT_SAMPLED, GR_TEXTUREFILTER_POINT_SAMPLED);
        texture_box(box, 0, 0, 256, 256);
        grTexFilterMode(GR_TMU0, GR_TEXTUREFILTER_BILINEAR, GR_TEXTUREFILTER_BILINEAR);
        texture_box(cell((int)i + 15, 5, 6), 0, 0, 256, 256);
        /* The first texel in a corner of the last cells: colour, then alpha. */
        use_no_blending();
        grTexFilterMode(GR_TMU0, GR_TEXTUREFILTER_POINT_SAMPLED, GR_TEXTUREFILTER_POINT_SAMPLED);
        corner = cell(14, 5, 6);
        corner.x0 += 4 * (int)i, corner.x1 = corner.x0 + 4;
        corner.y1 = corner.y0 + 12;
        texture_box(corner, 0, 0, 15, 15);
        CHECK(middle(corner) == pack565(f->r, f->g, f->b));
        grColorCombine(GR_COMBINE_FUNCTION_SCALE_OTHER, GR_COMBINE_FACTOR_TEXTURE_ALPHA,
                       GR_COMBINE_LOCAL_NONE, GR_COMBINE_OTHER_CONSTANT, FXFALSE);
        corner.y0 = corner.y1, corner.y1 += 12;
        texture_box(corner, 0, 0, 15, 15);
        channel = 255 * (f->a + 1) / 256;
        CHECK(middle(corner) == pack565(channel, channel, channel));
        use_vertex_colors();
    }
    grBufferSwap(0);
    return finish();
}
