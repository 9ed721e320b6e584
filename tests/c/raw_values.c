/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * raw_values.c: constants and layouts of the Raw client interface. Opcodes are
 * dense from 1 on; words have 32 bits and matrices no gaps.
 */
#include <render_client.h>

#include "check.h"

static void layouts(void)
{
    CHECK(sizeof(unsigned) == 4 && sizeof(signed) == 4 && sizeof(float) == 4);
    CHECK(sizeof(g_RPerspective) == 64 && sizeof(g_RCamera) == 64);
    CHECK(sizeof(g_RCamera[0]) == 16);
    CHECK(sizeof(g_RInSceneStream) == 4);
}

static void symbols(void)
{
    CHECK(R_TEXMODE_NONE == 0 && R_TEXMODE_COLOR == 1 && R_TEXMODE_TEXTURE == 2);
    CHECK(R_TEXMODE_BLEND == 3 && R_TEXMODE_TEXDECAL == 4 && R_TEXMODE_COLDECAL == 5);
    CHECK(R_TEXMODE_MODULATE == 6);
    CHECK(R_ALPHA_NONE == 0 && R_ALPHA_SOFT == 1 && R_ALPHA_HARD == 2);
    CHECK(R_TEXTILE_NONE == 0 && R_TEXTILE_REPEAT == 1);
    CHECK(R_TEXTILE_MIRROR == 2 && R_TEXTILE_CLAMP == 3);
    CHECK(R_PAGE_NONE == 0 && R_PAGE_BACK == 1 && R_PAGE_FRONT == 2 && R_PAGE_BOTH == 3);
}

static void opcodes(void)
{
    CHECK(RENDER_BEGINSCENE == 1 && RENDER_ENDSCENE == 2 && RENDER_VERTEX == 3);
    CHECK(RENDER_COLOR == 4 && RENDER_MODELMATRIX == 5 && RENDER_VIEWMATRIX == 6);
    CHECK(RENDER_NORMAL == 7 && RENDER_SET_LIT == 8 && RENDER_SET_USEAMB == 9);
    CHECK(RENDER_SET_USEDIR == 10 && RENDER_SET_TEXMODE == 11 && RENDER_SET_TEXALPHA == 12);
    CHECK(RENDER_SET_COLALPHA == 13 && RENDER_SET_COLINTERP == 14);
    CHECK(RENDER_SET_LITINTERP == 15 && RENDER_SET_TEXINTERP == 16);
    CHECK(RENDER_SET_OUTOFORDER == 17 && RENDER_SET_TEXTILE == 18 && RENDER_SET_NOUSEZ == 19);
    CHECK(RENDER_SET_NOWRITEZ == 20 && RENDER_SET_TEXTUREID == 21);
    CHECK(RENDER_COLTEXBALANCE == 22 && RENDER_ALPHATHRESH == 23 && RENDER_AMBCOLOR == 24);
    CHECK(RENDER_DIRCOLOR == 25 && RENDER_DIRLIGHT == 26 && RENDER_AMBREFLECT == 27);
    CHECK(RENDER_DIRREFLECT == 28 && RENDER_CLEARFB == 29 && RENDER_CLEARZ == 30);
    CHECK(RENDER_SETPAGE == 31 && RENDER_FLIPPAGE == 32 && RENDER_ALLOCATE_TEXTURE == 33);
    CHECK(RENDER_DEALLOC_TEXTURE == 34 && RENDER_UPLOAD_TEXTURE == 35);
    CHECK(RENDER_TEXMEM_AVAIL == 36 && RENDER_COMPACT_TEXMEM == 37 && RENDER_WRITE_FB == 38);
    CHECK(RENDER_WRITE_FB_BLOCK == 39 && RENDER_READ_FB == 40 && RENDER_READ_FB_BLOCK == 41);
    CHECK(RENDER_WRITE_Z == 42 && RENDER_WRITE_Z_BLOCK == 43 && RENDER_READ_Z == 44);
    CHECK(RENDER_READ_Z_BLOCK == 45 && RENDER_RESET == 46 && RENDER_HALT == 47);
}

int main(void)
{
    layouts();
    symbols();
    opcodes();
    return CHECK_REPORT();
}
