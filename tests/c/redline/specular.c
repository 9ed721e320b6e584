/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * specular.c: the extension on the chip that has it, its absence on the other;
 * a second colour is added and stops at white.
 */
#include "conformance.h"

typedef vl_error(V_CDECL *Setter)(v_cmdbuffer *, v_u32);

static Setter setter(const char *function)
{
    char name[32];
    void *found;
    Setter result;

    strcpy(name, function);
    found = VL_GetExtensionFunction(name);
    memcpy(&result, &found, sizeof found);
    return result;
}

static void with(void)
{
    Setter enable = setter("VL_SetSpecularEnable"), rgb = setter("VL_SetSpecularColorRGB");
    Setter bgr = setter("VL_SetSpecularColorBGR");
    v_ksxyzuvq v[4];
    int i;

    CHECK(enable != NULL && rgb != NULL && bgr != NULL);
    VL_SetSrcFunc(&cb, V_SRCFUNC_NOTEXTURE);
    for (i = 0; i < 4; i++) {
        memset(&v[i], 0, sizeof v[i]);
        v[i].rgb = 0x408000;
        v[i].s = i & 1 ? 0x0000FF : 0x800000;
        v[i].x = FIX(20 + (i & 1 ? 256 : 0));
        v[i].y = FIX(20 + (i & 2 ? 60 : 0));
        v[i].q = QFIX(0.5);
    }
    CHECK(enable(&cb, V_SPECULAR_ENABLE) == VL_SUCCESS);
    CHECK(VL_Tristrip(&cb, V_FIFO_KSXYZUVQ, 2, WORDS(v)) == VL_SUCCESS);
    CHECK(near_rgb(pixel(22, 30), 0x40 + 0x80, 0x80, 0, 10));
    CHECK(near_rgb(pixel(148, 30), 0x40 + 0x40, 0x80, 0x80, 10));
    CHECK(near_rgb(pixel(273, 30), 0x40, 0x80, 0xFF, 10));
    /* The default colour, for vertices without one; sums stop at 255. */
    CHECK(rgb(&cb, 0x00FF2010) == VL_SUCCESS);
    quad(20, 100, 60, 60, 0xFFF01000);
    CHECK(near_rgb(pixel(30, 110), 255, 0x30, 0x10, 8));
    CHECK(bgr(&cb, 0x00FF2010) == VL_SUCCESS);
    quad(90, 100, 60, 60, 0xFF001000);
    CHECK(near_rgb(pixel(100, 110), 0x10, 0x30, 0xFF, 8));
    CHECK(enable(&cb, V_SPECULAR_DISABLE) == VL_SUCCESS);
    quad(160, 100, 60, 60, 0xFF001000);
    CHECK(near_rgb(pixel(170, 110), 0, 0x10, 0, 8));
}

static void without(void)
{
    v_ksxyzuvq v[3];

    memset(v, 0, sizeof v);
    CHECK(setter("VL_SetSpecularEnable") == NULL);
    CHECK(setter("VL_SetSpecularColorRGB") == NULL);
    CHECK(VL_Triangle(&cb, V_FIFO_KSXYZUVQ, WORDS(v[0]), WORDS(v[1]), WORDS(v[2]))
          == VL_PARAM_ERROR);
    CHECK(vl_told_once(VL_R_Triangle, VL_PARAM_ERROR));
    quad(20, 20, 256, 60, 0xFF408000);
}

int main(void)
{
    const char *names;

    open_small();
    VL_SetSrcFunc(&cb, V_SRCFUNC_NOTEXTURE);
    names = VL_GetExtensions(verite);
    CHECK(names != NULL && strstr(names, " PixFmt_332 ") && strstr(names, " PixFmt_4I "));
    CHECK((strstr(names, " V1K_Verite ") != NULL) != (strstr(names, " V2K_Verite ") != NULL));
    CHECK(setter("VL_NoSuchFunction") == NULL);
    if (strstr(names, " Specular ") != NULL) {
        CHECK(strstr(names, " V2K_Verite ") != NULL);
        with();
    } else {
        CHECK(strstr(names, " V1K_Verite ") != NULL);
        without();
    }
    forget_errors();
    show();
    return finish();
}
