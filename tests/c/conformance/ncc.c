/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * ncc.c: the two narrow-channel tables: all 256 codes through each (upper and
 * lower left), the same after words were replaced one at a time (right), and
 * both alternating. Codes are compared with Y + I + Q.
 */
#include "conformance.h"

static int y_of(int table, int i) { return table ? 255 - 17 * i : 17 * i; }
static int i_of(int table, int i, int c) { return (i - 1) * (table ? 60 : -45) * (c - 1); }
static int q_of(int table, int i, int c) { return (i - 2) * (table ? -30 : 80) * (c == 1 ? 1 : -1); }

static void make_table(int table, GuNccTable *ncc)
{
    int i, c;

    memset(ncc, 0, sizeof *ncc);
    for (i = 0; i < 16; i++) {
        ncc->yRGB[i] = (FxU8)y_of(table, i);
        ncc->packed_data[i / 4] |= (FxU32)ncc->yRGB[i] << (8 * (i % 4));
    }
    for (i = 0; i < 4; i++) {
        for (c = 0; c < 3; c++) {
            ncc->iRGB[i][c] = (FxI16)i_of(table, i, c);
            ncc->qRGB[i][c] = (FxI16)q_of(table, i, c);
            ncc->packed_data[4 + i] |= ((FxU32)ncc->iRGB[i][c] & 0x1ff) << (9 * (2 - c));
            ncc->packed_data[8 + i] |= ((FxU32)ncc->qRGB[i][c] & 0x1ff) << (9 * (2 - c));
        }
    }
}

static FxU16 code_color(int table, int code)
{
    int c, part[3];

    for (c = 0; c < 3; c++) {
        part[c] = clamp_byte(y_of(table, code >> 4) + i_of(table, code >> 2 & 3, c)
                             + q_of(table, code & 3, c));
    }
    return pack565(part[0], part[1], part[2]);
}

/* All codes as a 16x16 picture, each at least seven pixels wide. */
static void check_codes(Box box, int table)
{
    int code;

    texture_box(box, 0, 0, 256, 256);
    for (code = 0; code < 256; code++) {
        int x = box.x0 + (box.x1 - box.x0) * (2 * (code % 16) + 1) / 32;
        int y = box.y0 + (box.y1 - box.y0) * (2 * (code / 16) + 1) / 32;

        CHECK(read_pixel(GR_BUFFER_BACKBUFFER, x, y) == code_color(table, code));
    }
}

int main(void)
{
    GuNccTable tables[2];
    FxU8 codes[256];
    Texture t;
    int i;

    open_small(GR_ORIGIN_UPPER_LEFT);
    for (i = 0; i < 2; i++) {
        make_table(i, &tables[i]);
        grTexDownloadTable(GR_TMU0, i ? GR_TEXTABLE_NCC1 : GR_TEXTABLE_NCC0, &tables[i]);
    }
    for (i = 0; i < 256; i++) {
        codes[i] = (FxU8)i;
    }
    t.info.smallLod = t.info.largeLod = GR_LOD_16;
    t.info.aspectRatio = GR_ASPECT_1x1;
    t.info.format = GR_TEXFMT_YIQ_422;
    t.info.data = codes;
    t.address = grTexMinAddress(GR_TMU0);
    grTexDownloadMipMap(GR_TMU0, t.address, GR_MIPMAPLEVELMASK_BOTH, &t.info);
    use_texture(GR_TMU0, &t);
    grTexMipMapMode(GR_TMU0, GR_MIPMAP_DISABLE, FXFALSE);
    grTexFilterMode(GR_TMU0, GR_TEXTUREFILTER_POINT_SAMPLED, GR_TEXTUREFILTER_POINT_SAMPLED);
    guColorCombineFunction(GR_COLORCOMBINE_DECAL_TEXTURE);
    clear_to(0);
    grTexNCCTable(GR_TMU0, GR_NCCTABLE_NCC0);
    check_codes(cell(0, 2, 2), 0);
    grTexNCCTable(GR_TMU0, GR_NCCTABLE_NCC1);
    check_codes(cell(2, 2, 2), 1);
    /* Table 1 word by word over table 0, from the last. */
    grTexNCCTable(GR_TMU0, GR_NCCTABLE_NCC0);
    for (i = 11; i >= 0; i--) {
        grTexDownloadTablePartial(GR_TMU0, GR_TEXTABLE_NCC0, &tables[1], i, i);
    }
    check_codes(cell(1, 2, 2), 1);
    grTexDownloadTablePartial(GR_TMU0, GR_TEXTABLE_NCC0, &tables[0], 0, 11);
    for (i = 0; i < 8; i++) {
        Box box = cell(24 + i % 4 + 8 * (i / 4) + 4, 8, 8);

        box.y0 += 60, box.y1 += 60;
        grTexNCCTable(GR_TMU0, i % 2 ? GR_NCCTABLE_NCC1 : GR_NCCTABLE_NCC0);
        texture_box(box, 0, 0, 256, 256);
    }
    grBufferSwap(0);
    return finish();
}
