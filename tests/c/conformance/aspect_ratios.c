/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * aspect_ratios.c: textures of the seven aspect ratios (columns), clamped and
 * repeated in each direction (rows). Sizes in memory and on the host are
 * compared with the tables of the guide.
 */
#include "conformance.h"

static Texture ratio(GrAspectRatio_t aspect, GrLOD_t large, GrLOD_t small)
{
    static FxU16 texels[2 * 65536];
    FxU16 *at = texels;
    Texture t;
    int lod;

    for (lod = (int)large; lod <= (int)small; lod++) {
        int side = 256 >> lod, bits = aspect < 3 ? 3 - (int)aspect : (int)aspect - 3;
        int less = side >> bits > 0 ? side >> bits : 1, x, y;
        int wide = aspect <= 3 ? side : less, high = aspect >= 3 ? side : less;

        for (y = 0; y < high; y++) {
            for (x = 0; x < wide; x++, at++) {
                FxU8 bytes[2];
                store_texel(GR_TEXFMT_RGB_565, test_card(((float)x + 0.5f) / (float)wide,
                                                         ((float)y + 0.5f) / (float)high), bytes);
                memcpy(at, bytes, 2);
            }
        }
    }
    t.info.smallLod = small;
    t.info.largeLod = large;
    t.info.aspectRatio = aspect;
    t.info.format = GR_TEXFMT_RGB_565;
    t.info.data = texels;
    t.address = reserve_texture(GR_TMU0, grTexTextureMemRequired(GR_MIPMAPLEVELMASK_BOTH, &t.info));
    grTexDownloadMipMap(GR_TMU0, t.address, GR_MIPMAPLEVELMASK_BOTH, &t.info);
    t.info.data = NULL;
    return t;
}

static void check_sizes(void)
{
    /* 8-bit texels of the levels from 256 to 1, by elongation. */
    static const FxU32 sizes[4][9] = {
        {0x10000, 0x4000, 0x1000, 0x400, 0x100, 0x40, 0x10, 4, 4},
        {0x8000, 0x2000, 0x800, 0x200, 0x80, 0x20, 8, 4, 4},
        {0x4000, 0x1000, 0x400, 0x100, 0x40, 0x10, 8, 4, 4},
        {0x2000, 0x800, 0x200, 0x80, 0x20, 0x10, 8, 4, 4}};
    GrTexInfo info;
    int aspect, large, small, lod;

    info.data = NULL;
    for (aspect = 0; aspect <= 6; aspect++) {
        for (large = 0; large <= 8; large++) {
            for (small = large; small <= 8; small++) {
                FxU32 parts[3] = {0, 0, 0};
                int elongation = aspect < 3 ? 3 - aspect : aspect - 3;

                for (lod = large; lod <= small; lod++) {
                    parts[lod & 1] += sizes[elongation][lod];
                    parts[2] += sizes[elongation][lod];
                }
                CHECK(grTexCalcMemRequired(small, large, aspect, GR_TEXFMT_P_8)
                      == ((parts[2] + 7) & ~7U));
                CHECK(grTexCalcMemRequired(small, large, aspect, GR_TEXFMT_RGB_565)
                      == ((2 * parts[2] + 7) & ~7U));
                info.smallLod = small;
                info.largeLod = large;
                info.aspectRatio = aspect;
                info.format = GR_TEXFMT_ARGB_4444;
                CHECK(grTexTextureMemRequired(GR_MIPMAPLEVELMASK_EVEN, &info)
                      == ((2 * parts[0] + 7) & ~7U));
                CHECK(grTexTextureMemRequired(GR_MIPMAPLEVELMASK_ODD, &info)
                      == ((2 * parts[1] + 7) & ~7U));
            }
        }
    }
}

int main(void)
{
    int column, row;

    open_small(GR_ORIGIN_UPPER_LEFT);
    check_sizes();
    CHECK(grTexMinAddress(GR_TMU0) == 0);
    CHECK((grTexMaxAddress(GR_TMU0) + 8) % (1U << 20) == 0);
    clear_to(0x303030);
    guColorCombineFunction(GR_COLORCOMBINE_DECAL_TEXTURE);
    for (column = 0; column < 7; column++) {
        Texture t = ratio(column, GR_LOD_64, GR_LOD_1);
        float s = column < 3 ? 256.0f : (float)(256 >> (column - 3));
        float u = column > 3 ? 256.0f : (float)(256 >> (3 - column));

        use_texture(GR_TMU0, &t);
        for (row = 0; row < 4; row++) {
            grTexClampMode(GR_TMU0, row & 1 ? GR_TEXTURECLAMP_CLAMP : GR_TEXTURECLAMP_WRAP,
                           row & 2 ? GR_TEXTURECLAMP_CLAMP : GR_TEXTURECLAMP_WRAP);
            texture_box(cell(7 * row + column, 7, 4), -0.5f * s, -0.5f * u, 1.5f * s, 1.5f * u);
        }
    }
    grBufferSwap(0);
    return finish();
}
