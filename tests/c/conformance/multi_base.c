/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * multi_base.c: levels 256, 128, 64 and 32 to 1 at addresses of their own
 * draw what the same levels in one piece draw; then with one group moved.
 */
#include "conformance.h"

static FxU16 shots[2][HIGH][WIDE];

static void wall(void)
{
    GrVertex v[4];
    int i;

    for (i = 0; i < 4; i++) {
        int far_end = i == 1 || i == 2;
        v[i] = vertex(far_end ? 319.0f : 1.0f, i >= 2 ? 230.0f : 10.0f, rgb(1, 1, 1));
        v[i].oow = far_end ? 1.0f / 64.0f : 1.0f;
        set_texture(&v[i], far_end ? 30000.0f : 0.0f,
                    (i >= 2 ? 200.0f : 0.0f) * (far_end ? 64.0f : 1.0f));
    }
    clear_to(0x202020);
    draw_quad(&v[0], &v[1], &v[2], &v[3]);
}

int main(void)
{
    static const GrLOD_t first[4] = {GR_LOD_256, GR_LOD_128, GR_LOD_64, GR_LOD_32};
    static const FxU32 at[4] = {1 << 20, 3 << 18, 5 << 17, 9 << 16};
    FxU16 *levels = guTexCreateColorMipMap(), *from = levels;
    GrTexInfo info;
    int i;

    open_small(GR_ORIGIN_UPPER_LEFT);
    guColorCombineFunction(GR_COLORCOMBINE_DECAL_TEXTURE);
    info.smallLod = GR_LOD_1;
    info.largeLod = GR_LOD_256;
    info.aspectRatio = GR_ASPECT_1x1;
    info.format = GR_TEXFMT_RGB_565;
    info.data = levels;
    grTexDownloadMipMap(GR_TMU0, 0, GR_MIPMAPLEVELMASK_BOTH, &info);
    {
        Texture t;
        t.info = info;
        t.address = 0;
        use_texture(GR_TMU0, &t);
    }
    wall();
    CHECK(grLfbReadRegion(GR_BUFFER_BACKBUFFER, 0, 0, WIDE, HIGH, sizeof shots[0][0], shots[0]));
    grBufferSwap(0);
    for (i = 0; i < 4; i++) {
        int lod, last = i == 3 ? GR_LOD_1 : first[i];
        GrTexInfo part = info;

        part.largeLod = first[i];
        part.smallLod = last;
        for (lod = first[i]; lod <= last; lod++) {
            int side = 256 >> lod;
            grTexDownloadMipMapLevel(GR_TMU0, at[i], lod, first[i], GR_ASPECT_1x1, GR_TEXFMT_RGB_565,
                                     GR_MIPMAPLEVELMASK_BOTH, from);
            from += side * side;
        }
        grTexMultibaseAddress(GR_TMU0, i, at[i], GR_MIPMAPLEVELMASK_BOTH, &part);
    }
    grTexMultibase(GR_TMU0, FXTRUE);
    wall();
    CHECK(grLfbReadRegion(GR_BUFFER_BACKBUFFER, 0, 0, WIDE, HIGH, sizeof shots[0][0], shots[1]));
    CHECK(memcmp(shots[0], shots[1], sizeof shots[0]) == 0);
    grBufferSwap(0);
    /* Level 128 shows what level 256 has. */
    grTexMultibaseAddress(GR_TMU0, GR_TEXBASE_128, at[0], GR_MIPMAPLEVELMASK_BOTH, &info);
    wall();
    grBufferSwap(0);
    grTexMultibase(GR_TMU0, FXFALSE);
    wall();
    CHECK(grLfbReadRegion(GR_BUFFER_BACKBUFFER, 0, 0, WIDE, HIGH, sizeof shots[0][0], shots[1]));
    free(levels);
    return finish();
}
