/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * texture_files.c: .3df files of every format, written here, read with
 * gu3dfGetInfo and gu3dfLoad and drawn; and files that are damaged, which must
 * be refused whole. Works in the folder named by TMPDIR, or /tmp.
 */
#include "conformance.h"

typedef struct {
    const char *name;
    GrTextureFormat_t format;
} Named;

static const Named formats[13] = {
    {"I8", GR_TEXFMT_INTENSITY_8}, {"A8", GR_TEXFMT_ALPHA_8}, {"AI44", GR_TEXFMT_ALPHA_INTENSITY_44},
    {"YIQ", GR_TEXFMT_YIQ_422}, {"RGB332", GR_TEXFMT_RGB_332}, {"RGB565", GR_TEXFMT_RGB_565},
    {"ARGB8332", GR_TEXFMT_ARGB_8332}, {"argb1555", GR_TEXFMT_ARGB_1555},
    {"AYIQ8422", GR_TEXFMT_AYIQ_8422}, {"ARGB4444", GR_TEXFMT_ARGB_4444},
    {"ai88", GR_TEXFMT_ALPHA_INTENSITY_88}, {"P8", GR_TEXFMT_P_8}, {"AP88", GR_TEXFMT_AP_88}};

static char path[400];
static unsigned char file[200000];
static size_t length;

static void put16(unsigned value)
{
    file[length++] = (unsigned char)(value >> 8);
    file[length++] = (unsigned char)value;
}

/* A square file of levels from `large` to 1, with its table. */
static void make_file(const Named *f, GrLOD_t large)
{
    int side = 256 >> large, i, c, wide = f->format >= GR_TEXFMT_16BIT;

    length = (size_t)sprintf((char *)file, "3df v1.1\n%s\nlod range: 1 %d\naspect ratio: 1 1\n", f->name, side);
    if (f->format == GR_TEXFMT_YIQ_422 || f->format == GR_TEXFMT_AYIQ_8422) {
        for (i = 0; i < 16; i++) {
            put16((unsigned)(17 * i));
        }
        for (i = 0; i < 12; i++) {
            put16((unsigned)((i % 3 - 1) * (i / 3) * 30) & 0x1ff);
        }
        for (i = 0; i < 12; i++) {
            put16((unsigned)((1 - i % 3) * (i / 3) * 50) & 0xffff); /* high bits are dropped */
        }
    } else if (f->format == GR_TEXFMT_P_8 || f->format == GR_TEXFMT_AP_88) {
        for (i = 0; i < 256; i++) {
            FxU32 color = pack_color(hue((float)i / 256.0f));
            put16(color >> 16);
            put16(color & 0xffff);
        }
    }
    for (; side > 0; side /= 2) {
        for (i = 0; i < side * side; i++) {
            Color at = test_card((float)(i % side) / (float)side, (float)(i / side) / (float)side);
            FxU8 texel[2] = {0, 0};

            if (f->format == GR_TEXFMT_YIQ_422 || f->format == GR_TEXFMT_P_8
                || f->format == GR_TEXFMT_AYIQ_8422 || f->format == GR_TEXFMT_AP_88) {
                texel[0] = (FxU8)(i * 256 / (side * side));
                texel[1] = (FxU8)(255 - texel[0]);
            } else {
                store_texel(f->format, at, texel);
            }
            for (c = wide; c >= 0; c--) {
                file[length++] = texel[c];
            }
        }
    }
}

static void write_file(size_t count)
{
    FILE *out = fopen(path, "wb");

    CHECK(out != NULL);
    if (out != NULL) {
        CHECK(fwrite(file, 1, count, out) == count);
        fclose(out);
    }
}

static void draw_file(int i)
{
    const Named *f = &formats[i];
    Gu3dfInfo info;
    Texture t;
    FxU8 *memory;
    size_t bytes = 5461 * (f->format >= GR_TEXFMT_16BIT ? 2 : 1);

    make_file(f, GR_LOD_64);
    write_file(length);
    memset(&info, 0, sizeof info);
    CHECK(gu3dfGetInfo(path, &info));
    CHECK(info.header.width == 64 && info.header.height == 64);
    CHECK(info.header.small_lod == GR_LOD_1 && info.header.large_lod == GR_LOD_64);
    CHECK(info.header.aspect_ratio == GR_ASPECT_1x1 && info.header.format == f->format);
    CHECK(info.mem_required == bytes);
    memory = malloc(bytes + 1);
    if (memory == NULL) {
        exit(1);
    }
    memory[bytes] = 0x5a;
    info.data = memory;
    CHECK(gu3dfLoad(path, &info));
    CHECK(memory[bytes] == 0x5a);
    if (f->format == GR_TEXFMT_YIQ_422 || f->format == GR_TEXFMT_AYIQ_8422) {
        CHECK(info.table.nccTable.yRGB[15] == 255 && info.table.nccTable.iRGB[3][2] == 90);
        CHECK(info.table.nccTable.qRGB[1][2] == 0x1ce); /* -50 in nine bits */
        CHECK(info.table.nccTable.packed_data[3] == 0xffeeddccU);
        CHECK(info.table.nccTable.packed_data[5] == (0x1e2U << 18 | 30U));
        grTexDownloadTable(GR_TMU0, GR_TEXTABLE_NCC0, &info.table);
    } else if (f->format == GR_TEXFMT_P_8 || f->format == GR_TEXFMT_AP_88) {
        CHECK(info.table.palette.data[77] == pack_color(hue(77.0f / 256.0f)));
        grTexDownloadTable(GR_TMU0, GR_TEXTABLE_PALETTE, &info.table);
    }
    t.info.smallLod = info.header.small_lod;
    t.info.largeLod = info.header.large_lod;
    t.info.aspectRatio = info.header.aspect_ratio;
    t.info.format = info.header.format;
    t.info.data = info.data;
    t.address = reserve_texture(GR_TMU0, grTexTextureMemRequired(GR_MIPMAPLEVELMASK_BOTH, &t.info));
    grTexDownloadMipMap(GR_TMU0, t.address, GR_MIPMAPLEVELMASK_BOTH, &t.info);
    use_texture(GR_TMU0, &t);
    texture_box(cell(i, 5, 3), 0, 0, 256, 256);
    free(memory);
}

/* Whether a file of `count` bytes is refused, with nothing stored. */
static int refused(size_t count)
{
    static FxU8 memory[16384], before[16384];
    Gu3dfInfo info;
    int known;

    write_file(count);
    memset(&info, 0, sizeof info);
    memset(memory, 0x77, sizeof memory);
    memset(before, 0x77, sizeof before);
    known = gu3dfGetInfo(path, &info);
    info.data = memory;
    if (!known) {
        info.mem_required = sizeof memory;
    }
    return !gu3dfLoad(path, &info) && memcmp(memory, before, sizeof memory) == 0;
}

static void damage(const char *what, const char *with)
{
    char *at;

    make_file(&formats[5], GR_LOD_64);
    at = strstr((char *)file, what);
    CHECK(at != NULL);
    if (at != NULL) {
        memcpy(at, with, strlen(with));
    }
    CHECK(refused(length));
}

static void check_damage(void)
{
    Gu3dfInfo info;
    FxU8 small[16];
    size_t i;

    make_file(&formats[8], GR_LOD_64);
    CHECK(refused(0));
    for (i = 1; i < length; i += i < 300 ? 7 : 997) {
        CHECK(refused(i));
    }
    CHECK(refused(length - 1));
    damage("3df", "xdf");
    damage("RGB565", "RGB567");
    damage("1 64", "3 64");
    damage("1 64", "1 65");
    damage("1 64\n", "1 -4\n");
    damage("1 1\n", "1 3\n");
    damage("1 1\n", "0 0\n");
    memset(file, 'a', sizeof file);
    CHECK(refused(sizeof file));
    memset(file, '\n', sizeof file);
    CHECK(refused(sizeof file));
    /* No such file, a folder, no memory, too little memory, another header. */
    remove(path);
    memset(&info, 0, sizeof info);
    CHECK(!gu3dfGetInfo(path, &info) && !gu3dfLoad(path, &info));
    CHECK(!gu3dfGetInfo("/", &info) && !gu3dfGetInfo("", &info) && !gu3dfGetInfo(NULL, &info));
    make_file(&formats[0], GR_LOD_64);
    write_file(length);
    CHECK(gu3dfGetInfo(path, &info));
    info.data = NULL;
    CHECK(!gu3dfLoad(path, &info));
    info.data = small;
    info.mem_required = sizeof small;
    CHECK(!gu3dfLoad(path, &info));
    info.mem_required = 5461;
    info.header.format = GR_TEXFMT_RGB_565;
    CHECK(!gu3dfLoad(path, &info));
    remove(path);
}

int main(void)
{
    const char *folder = getenv("TMPDIR");
    int i;

    sprintf(path, "%.300s/texture_files_test.3df", folder != NULL ? folder : "/tmp");
    open_small(GR_ORIGIN_UPPER_LEFT);
    clear_to(0x303030);
    guColorCombineFunction(GR_COLORCOMBINE_DECAL_TEXTURE);
    for (i = 0; i < 13; i++) {
        draw_file(i);
    }
    check_damage();
    grBufferSwap(0);
    return finish();
}
