/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * partial_downloads.c: a texture loaded level by level, its largest level row
 * by row in any order, rows replaced between pictures, and the same for even
 * and odd levels apart. A download in parts must draw what a whole one draws.
 */
#include "conformance.h"

static FxU16 whole[2][64 * 64 + 32 * 32 + 16 * 16 + 8 * 8 + 4 * 4 + 2 * 2 + 1];
static FxU16 shots[3][78][104];

static void paint(FxU16 *at, float turn)
{
    int side, i;

    for (side = 64; side > 0; side /= 2) {
        for (i = 0; i < side * side; i++) {
            Color c = test_card((float)(i % side) / (float)side, (float)(i / side) / (float)side);
            FxU8 bytes[2];
            c = mix_color(c, hue(turn), 0.3f);
            store_texel(GR_TEXFMT_ARGB_4444, c, bytes);
            memcpy(at++, bytes, 2);
        }
    }
}

static void picture(int i)
{
    Box box = cell(i, 3, 3);

    texture_box(box, 0, 0, 256, 256);
    /* A small copy that needs a small level. */
    box.x0 += 70, box.y0 += 50, box.x1 = box.x0 + 12, box.y1 = box.y0 + 12;
    texture_box(box, 0, 0, 256, 256);
}

static void shoot(int i, int which)
{
    Box box = cell(i, 3, 3);

    CHECK(grLfbReadRegion(GR_BUFFER_BACKBUFFER, (FxU32)box.x0, (FxU32)box.y0, 104, 78,
                          sizeof shots[0][0], shots[which]));
}

static void load_in_parts(FxU32 address, FxU32 mask, FxU16 *texels)
{
    FxU16 *at = texels;
    int lod, row;

    for (row = 63; row >= 0; row--) {
        grTexDownloadMipMapLevelPartial(GR_TMU0, address, GR_LOD_64, GR_LOD_64, GR_ASPECT_1x1,
                                        GR_TEXFMT_ARGB_4444, mask, texels + 64 * row, row, row);
    }
    at += 64 * 64;
    for (lod = GR_LOD_32; lod <= GR_LOD_1; lod++) {
        int side = 256 >> lod;
        grTexDownloadMipMapLevel(GR_TMU0, address, lod, GR_LOD_64, GR_ASPECT_1x1,
                                 GR_TEXFMT_ARGB_4444, mask, at);
        at += side * side;
    }
}

int main(void)
{
    Texture t;
    int i;

    open_small(GR_ORIGIN_UPPER_LEFT);
    paint(whole[0], 0.1f);
    paint(whole[1], 0.6f);
    t.info.smallLod = GR_LOD_1;
    t.info.largeLod = GR_LOD_64;
    t.info.aspectRatio = GR_ASPECT_1x1;
    t.info.format = GR_TEXFMT_ARGB_4444;
    t.info.data = whole[0];
    t.address = 1024;
    clear_to(0x202020);
    guColorCombineFunction(GR_COLORCOMBINE_DECAL_TEXTURE);
    grTexDownloadMipMap(GR_TMU0, t.address, GR_MIPMAPLEVELMASK_BOTH, &t.info);
    use_texture(GR_TMU0, &t);
    picture(0);
    shoot(0, 0);
    /* Another picture, then the first again in parts. */
    t.info.data = whole[1];
    grTexDownloadMipMap(GR_TMU0, t.address, GR_MIPMAPLEVELMASK_BOTH, &t.info);
    picture(1);
    load_in_parts(t.address, GR_MIPMAPLEVELMASK_BOTH, whole[0]);
    picture(2);
    for (i = 1; i < 3; i++) {
        shoot(i, i);
    }
    CHECK(memcmp(shots[0], shots[1], sizeof shots[0]) != 0);
    /* Bilinear fractions depend on the place, which is the same within a cell
     * to a sixteenth: compare where the cells start. */
    for (i = 0; i < 78; i += 5) {
        CHECK(memcmp(shots[0][i], shots[2][i], sizeof shots[0][i]) == 0);
    }
    /* A band of the second picture within the first. */
    grTexDownloadMipMapLevelPartial(GR_TMU0, t.address, GR_LOD_64, GR_LOD_64, GR_ASPECT_1x1,
                                    GR_TEXFMT_ARGB_4444, GR_MIPMAPLEVELMASK_BOTH,
                                    whole[1] + 64 * 20, 20, 35);
    picture(3);
    /* Level 32 of the other: only the small copy of some pictures shows it. */
    grTexDownloadMipMapLevel(GR_TMU0, t.address, GR_LOD_16, GR_LOD_64, GR_ASPECT_1x1,
                             GR_TEXFMT_ARGB_4444, GR_MIPMAPLEVELMASK_BOTH, whole[1] + 64 * 64 + 32 * 32);
    picture(4);
    /* Even and odd levels at addresses of their own, from the same data. */
    for (i = 0; i < 2; i++) {
        FxU32 mask = i ? GR_MIPMAPLEVELMASK_ODD : GR_MIPMAPLEVELMASK_EVEN, at = 65536U * (FxU32)(i + 1);

        load_in_parts(at, mask, whole[0]);
        grTexSource(GR_TMU0, at, mask, &t.info);
        picture(6 + i);
        shoot(6 + i, i);
    }
    /* The even chain has level 64 itself, the odd one only 32. */
    CHECK(memcmp(shots[0][40], shots[1][40], sizeof shots[0][40]) != 0);
    grBufferSwap(0);
    return finish();
}
