/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * chroma_key.c: the key compares the "other" colour before the combine unit:
 * the texture, the iterated or the constant colour. Left to right: off, key on
 * the texture's red square (565 and 332), key that nothing has, key on iterated
 * and constant colours, and one that bilinear filtering blurs.
 */
#include "conformance.h"

static Color squares(float u, float v)
{
    int i = (int)(u * 4.0f) + (int)(v * 4.0f);

    return i % 3 == 0 ? rgb(1, 0, 0) : i % 3 == 1 ? rgb(0.1f, 0.6f, 1) : rgb(1, 1, 0.4f);
}

int main(void)
{
    Texture wide, narrow;
    Box box;
    FxU16 background = pack565(0x20, 0x50, 0x20);

    open_small(GR_ORIGIN_UPPER_LEFT);
    wide = load_texture(GR_TMU0, squares, GR_TEXFMT_RGB_565, GR_LOD_64);
    narrow = load_texture(GR_TMU0, squares, GR_TEXFMT_RGB_332, GR_LOD_64);
    use_texture(GR_TMU0, &wide);
    grTexFilterMode(GR_TMU0, GR_TEXTUREFILTER_POINT_SAMPLED, GR_TEXTUREFILTER_POINT_SAMPLED);
    guColorCombineFunction(GR_COLORCOMBINE_DECAL_TEXTURE);
    guAlphaSource(GR_ALPHASOURCE_CC_ALPHA);
    clear_to(0x205020);

    texture_box(cell(0, 4, 2), 0, 0, 256, 256);
    CHECK(read_pixel(GR_BUFFER_BACKBUFFER, 5, 5) == pack565(255, 0, 0));
    grChromakeyMode(GR_CHROMAKEY_ENABLE);
    grChromakeyValue(0xff0000);
    texture_box(cell(1, 4, 2), 0, 0, 256, 256);
    CHECK(read_pixel(GR_BUFFER_BACKBUFFER, 85, 5) == background);
    CHECK(read_pixel(GR_BUFFER_BACKBUFFER, 105, 5) != background);
    use_texture(GR_TMU0, &narrow);
    grTexFilterMode(GR_TMU0, GR_TEXTUREFILTER_POINT_SAMPLED, GR_TEXTUREFILTER_POINT_SAMPLED);
    texture_box(cell(2, 4, 2), 0, 0, 256, 256);
    CHECK(read_pixel(GR_BUFFER_BACKBUFFER, 165, 5) == background);
    grChromakeyValue(0xff0001);
    texture_box(cell(3, 4, 2), 0, 0, 256, 256);
    CHECK(read_pixel(GR_BUFFER_BACKBUFFER, 245, 5) == pack565(255, 0, 0));

    /* The key looks at "other" even where only "local" is drawn. */
    grColorCombine(GR_COMBINE_FUNCTION_LOCAL, GR_COMBINE_FACTOR_NONE, GR_COMBINE_LOCAL_CONSTANT,
                   GR_COMBINE_OTHER_ITERATED, FXFALSE);
    grConstantColorValue(0xffff00ff);
    grChromakeyValue(0x404040);
    box = cell(4, 4, 2);
    fill_box(box, 255, 0x40, 0x40, 0x40);
    CHECK(middle(box) == background);
    fill_box(box, 255, 0x40, 0x40, 0x41);
    CHECK(middle(box) == pack565(255, 0, 255));
    grColorCombine(GR_COMBINE_FUNCTION_LOCAL, GR_COMBINE_FACTOR_NONE, GR_COMBINE_LOCAL_ITERATED,
                   GR_COMBINE_OTHER_CONSTANT, FXFALSE);
    grChromakeyValue(0x00ff00ff);
    box = cell(5, 4, 2);
    fill_box(box, 255, 255, 255, 0);
    CHECK(middle(box) == background);

    guColorCombineFunction(GR_COLORCOMBINE_DECAL_TEXTURE);
    grChromakeyValue(0xff0000);
    use_texture(GR_TMU0, &wide);
    texture_box(cell(6, 4, 2), 0, 0, 256, 256);
    grChromakeyMode(GR_CHROMAKEY_DISABLE);
    texture_box(cell(7, 4, 2), 0, 0, 256, 256);
    grBufferSwap(0);
    return finish();
}
