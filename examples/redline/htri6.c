/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * htri6: highlights on the triangles of htri4: by the extension Specular, or
 * where the chip lacks it, by blending with a constant destination colour.
 * Source: RR, "Specular extensions".
 */
#include "common.h"

typedef struct {
    double x, y, z, u, v, w;
    v_u32 specular; /* of the extension */
    int amount;     /* the same as a share of the triangle's colour, 0..255 */
} Corner;

static v_surface *textures[2];
static VL_SetSpecularEnable_fn set_specular_enable;

static void load(void)
{
    textures[0] = make_texture(make_checker(128, 256, 16, 32, 0x07E0, 0x001F), V_PIXFMT_565, 128,
                               256);
    textures[1] = make_texture(make_checker(200, 100, 10, 10, 0xF81F, 0x07FF), V_PIXFMT_565, 200,
                               100);
    VL_SetSurfaceClamp(textures[0], V_UCLAMP_DISABLE, V_VCLAMP_DISABLE);
    VL_SetSurfaceClamp(textures[1], V_UCLAMP_ENABLE, V_VCLAMP_ENABLE);
    /* Names have spaces around them, so that no other name contains them. */
    if (strstr(VL_GetExtensions(verite), " Specular ") != NULL) {
        char name[] = "VL_SetSpecularEnable";
        void *function = VL_GetExtensionFunction(name);

        /* ISO C has no conversion from object to function pointers. */
        memcpy(&set_specular_enable, &function, sizeof function);
    }
}

static void set_state(void)
{
    VL_SetZBufMode(&cmdbuffer, V_ZBUFMODE_LT);
    VL_SetZBufWrMode(&cmdbuffer, V_ZBUFWRMODE_ENABLE);
    set_filter();
    if (set_specular_enable != NULL) {
        VL_SetSrcFunc(&cmdbuffer, V_SRCFUNC_REPLACE);
        set_specular_enable(&cmdbuffer, V_SPECULAR_ENABLE);
    } else {
        /* Texture times white, plus alpha times the constant colour. */
        VL_SetSrcFunc(&cmdbuffer, V_SRCFUNC_MODULATE);
        VL_SetBlendEnable(&cmdbuffer, V_BLEND_ENABLE);
        VL_SetBlendSrcFunc(&cmdbuffer, V_BLEND1);
        VL_SetBlendDstFunc(&cmdbuffer, V_BLENDSRCALPHA);
        VL_SetDstRdDisable(&cmdbuffer, V_DSTRD_DISABLE);
    }
}

static void draw_specular(const Corner *corners)
{
    v_ksxyzuvq v[3];
    int i;

    for (i = 0; i < 3; i++) {
        const Corner *c = &corners[i];
        v_ksxyzuvq vertex = { 0xFFFFFFFF, 0, FIX(c->x), FIX(c->y), FIX(c->z),
                              FIX(c->u), FIX(c->v), QFIX(1.0 / c->w) };

        vertex.s = c->specular;
        v[i] = vertex;
    }
    VL_Triangle(&cmdbuffer, V_FIFO_KSXYZUVQ, (v_u32 *)&v[0], (v_u32 *)&v[1], (v_u32 *)&v[2]);
}

static void draw_blended(const Corner *corners, v_u32 color)
{
    v_kaxyzuvq v[3];
    int i;

    for (i = 0; i < 3; i++) {
        const Corner *c = &corners[i];
        v_kaxyzuvq vertex = { 0xFFFFFFFF, 0, FIX(c->x), FIX(c->y), FIX(c->z),
                              FIX(c->u), FIX(c->v), QFIX(1.0 / c->w) };

        vertex.a = c->amount << 16;
        v[i] = vertex;
    }
    VL_SetDstColorARGB(&cmdbuffer, color);
    VL_Triangle(&cmdbuffer, V_FIFO_KAXYZUVQ, (v_u32 *)&v[0], (v_u32 *)&v[1], (v_u32 *)&v[2]);
}

static void draw_triangle(v_surface *texture, const Corner *corners, v_u32 color)
{
    VL_InstallTextureMap(&cmdbuffer, texture);
    if (set_specular_enable != NULL) {
        draw_specular(corners);
    } else {
        draw_blended(corners, color);
    }
}

static void draw(void)
{
    static const Corner a[3] = {
        { 100.0, 100.0, 2.0, 0.0, 0.0, 2.0, 0x00FF0000, 255 },
        { 500.0, 100.0, 4.0, 2.0, 0.0, 4.0, 0x00000000, 0 },
        { 100.0, 300.0, 2.0, 0.0, 2.0, 2.0, 0x00C80000, 200 },
    };
    static const Corner b[3] = {
        { 200.0, 150.0, 6.0, 0.0, 0.0, 3.0, 0x000000FF, 255 },
        { 600.0, 150.0, 8.0, 2.0, 0.0, 5.0, 0x00000000, 0 },
        { 200.0, 350.0, 6.0, 0.0, 2.0, 3.0, 0x000000C8, 200 },
    };

    draw_triangle(textures[0], a, ARGB(255, 255, 0, 0));
    draw_triangle(textures[1], b, ARGB(255, 0, 0, 255));
}

int main(int argc, char **argv)
{
    Program program = { V_WINDOWED_APP, 1, load, set_state, NULL, draw, ".f.a.f" };

    return run(&program, argc, argv);
}
