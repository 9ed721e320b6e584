/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * palettes.c: all entries of a palette, replaced in parts between pictures
 * that are drawn (the unit has one palette, and what is drawn keeps the colours
 * of its time); P_8 above, AP_88 blended below.
 */
#include "conformance.h"

static FxU32 entry(int set, int i)
{
    Color c = set == 0 ? hue((float)i / 256.0f)
        : set == 1 ? mix_color(rgb(0, 0, 0.2f), rgb(1, 0.9f, 0.5f), (float)i / 255.0f)
        : scale_color(hue((float)(i % 32) / 32.0f), 1.0f - (float)i / 300.0f);

    return pack_color(c) & 0xffffff;
}

static void check_entries(Box box, int from, int to, int inside, int outside)
{
    int i;

    texture_box(box, 0, 0, 256, 256);
    for (i = 0; i < 256; i++) {
        int x = box.x0 + (box.x1 - box.x0) * (2 * (i % 16) + 1) / 32;
        int y = box.y0 + (box.y1 - box.y0) * (2 * (i / 16) + 1) / 32;
        FxU32 c = entry(i >= from && i <= to ? inside : outside, i);

        CHECK(read_pixel(GR_BUFFER_BACKBUFFER, x, y)
              == pack565((int)(c >> 16), (int)(c >> 8 & 255), (int)(c & 255)));
    }
}

int main(void)
{
    GuTexPalette sets[3];
    FxU16 wide[256];
    FxU8 narrow[256];
    Texture p8, ap88;
    int i, set;

    open_small(GR_ORIGIN_UPPER_LEFT);
    for (set = 0; set < 3; set++) {
        for (i = 0; i < 256; i++) {
            sets[set].data[i] = entry(set, i) | (FxU32)i << 24; /* the high byte is not used */
        }
    }
    for (i = 0; i < 256; i++) {
        narrow[i] = (FxU8)i;
        wide[i] = (FxU16)(i | (255 - i) << 8);
    }
    p8.info.smallLod = p8.info.largeLod = GR_LOD_16;
    p8.info.aspectRatio = GR_ASPECT_1x1;
    p8.info.format = GR_TEXFMT_P_8;
    p8.info.data = narrow;
    p8.address = 0;
    ap88 = p8;
    ap88.info.format = GR_TEXFMT_AP_88;
    ap88.info.data = wide;
    ap88.address = 4096;
    grTexDownloadMipMap(GR_TMU0, p8.address, GR_MIPMAPLEVELMASK_BOTH, &p8.info);
    grTexDownloadMipMap(GR_TMU0, ap88.address, GR_MIPMAPLEVELMASK_BOTH, &ap88.info);
    clear_to(0x606060);
    guColorCombineFunction(GR_COLORCOMBINE_DECAL_TEXTURE);
    use_texture(GR_TMU0, &p8);
    grTexMipMapMode(GR_TMU0, GR_MIPMAP_DISABLE, FXFALSE);
    grTexFilterMode(GR_TMU0, GR_TEXTUREFILTER_POINT_SAMPLED, GR_TEXTUREFILTER_POINT_SAMPLED);
    grTexDownloadTable(GR_TMU0, GR_TEXTABLE_PALETTE, &sets[0]);
    check_entries(cell(0, 3, 2), 0, 255, 0, 0);
    grTexDownloadTablePartial(GR_TMU0, GR_TEXTABLE_PALETTE, &sets[1], 100, 200);
    check_entries(cell(1, 3, 2), 100, 200, 1, 0);
    grTexDownloadTable(GR_TMU0, GR_TEXTABLE_PALETTE, &sets[1]);
    for (i = 0; i < 256; i += 2) {
        grTexDownloadTablePartial(GR_TMU0, GR_TEXTABLE_PALETTE, &sets[2], i, i);
        grTexDownloadTablePartial(GR_TMU0, GR_TEXTABLE_PALETTE, &sets[2], i + 1, i + 1);
    }
    check_entries(cell(2, 3, 2), 0, 255, 2, 2);
    grTexSource(GR_TMU0, ap88.address, GR_MIPMAPLEVELMASK_BOTH, &ap88.info);
    guAlphaSource(GR_ALPHASOURCE_TEXTURE_ALPHA);
    use_blending();
    for (set = 0; set < 3; set++) {
        grTexDownloadTable(GR_TMU0, GR_TEXTABLE_PALETTE, &sets[set]);
        texture_box(cell(3 + set, 3, 2), 0, 0, 256, 256);
    }
    grBufferSwap(0);
    return finish();
}
