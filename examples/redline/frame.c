/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * frame: a flight through a hall whose 96 pictures, 3 MB, do not fit into what
 * the display leaves of the board's memory. A cache gives each picture that is needed a surface, takes
 * the one that was not needed for the longest time when memory is used up, and
 * loads texels from locked memory. The triangles are written into the command
 * buffers as words, with fog that grows with the distance.
 *
 * Source: RR, "Caching" and "Optimizations".
 */
#include <math.h>
#include "common.h"

#define PICTURES 96
#define SIZE 128
#define PANELS 12          /* of each side that are seen */
#define LENGTH 2.0         /* of a panel */
#define NEAREST 0.35
#define FARTHEST (PANELS * LENGTH)

/* --- pictures -------------------------------------------------------------- */

static v_memory store; /* all of them, one after the other */

static double wave(double a)
{
    return 0.5 + 0.5 * sin(a);
}

/* Rings, bricks, stripes and squares in colours by number. */
static v_u16 texel(int picture, int x, int y)
{
    double u = x / (double)SIZE, v = y / (double)SIZE, light;
    double hue = picture * 0.61803;
    int r, g, b;

    switch (picture % 4) {
    case 0:
        light = wave(40.0 * sqrt((u - 0.5) * (u - 0.5) + (v - 0.5) * (v - 0.5)));
        break;
    case 1:
        light = (y % 16 < 2 || (x + y / 16 % 2 * 16) % 32 < 2) ? 0.35 : 0.8 + 0.2 * wave(x * y);
        break;
    case 2:
        light = wave(6.2832 * (8.0 * u + 3.0 * v));
        break;
    default:
        light = (x / 16 + y / 16) % 2 ? 0.95 : 0.45;
        break;
    }
    /* A frame around every picture. */
    if (x < 4 || y < 4 || x >= SIZE - 4 || y >= SIZE - 4) {
        light = 0.2;
    }
    r = (int)(31.0 * light * (0.4 + 0.6 * wave(6.2832 * hue)));
    g = (int)(63.0 * light * (0.4 + 0.6 * wave(6.2832 * (hue + 0.333))));
    b = (int)(31.0 * light * (0.4 + 0.6 * wave(6.2832 * (hue + 0.667))));
    return (v_u16)(r << 11 | g << 5 | b);
}

static v_u32 *picture_address(int picture)
{
    return V_GetMemoryObjectAddress(store) + (size_t)picture * SIZE * SIZE / 2;
}

static void make_pictures(void)
{
    int picture, x, y;

    store = V_AllocLockedMem(verite, PICTURES * SIZE * SIZE * 2);
    for (picture = 0; picture < PICTURES; picture++) {
        v_u16 *out = (v_u16 *)picture_address(picture);

        for (y = 0; y < SIZE; y++) {
            for (x = 0; x < SIZE; x++) {
                *out++ = texel(picture, x, y);
            }
        }
    }
}

/* --- the cache ------------------------------------------------------------- */

static v_surface *surfaces[PICTURES];
static int last_used[PICTURES];
static int now, loads, evictions;

/* Running out of video memory is expected here. */
static v_surface *try_surface(void)
{
    v_error_handler verite_handler = V_GetErrorHandler();
    vl_error_handler redline_handler = VL_GetErrorHandler();
    v_surface *surface = NULL;

    V_RegisterErrorHandler(NULL);
    VL_RegisterErrorHandler(NULL);
    if (VL_CreateSurface(verite, &surface, 0, 1, V_PIXFMT_565, SIZE, SIZE) != VL_SUCCESS) {
        surface = NULL;
    }
    V_RegisterErrorHandler(verite_handler);
    VL_RegisterErrorHandler(redline_handler);
    return surface;
}

/* The surface of the picture that was not used for the longest time. Commands
 * that draw with it were recorded before those that load it again. */
static v_surface *evict(void)
{
    int i, oldest = -1;
    v_surface *surface;

    for (i = 0; i < PICTURES; i++) {
        if (surfaces[i] != NULL && (oldest < 0 || last_used[i] < last_used[oldest])) {
            oldest = i;
        }
    }
    if (oldest < 0) {
        fail("frame", "evict", "not even one picture fits", 0);
    }
    evictions++;
    surface = surfaces[oldest];
    surfaces[oldest] = NULL;
    return surface;
}

static void install(int picture)
{
    if (surfaces[picture] == NULL) {
        v_surface *surface = try_surface();

        surfaces[picture] = surface != NULL ? surface : evict();
        VL_LoadBuffer(&cmdbuffer, surfaces[picture], 0, SIZE * 2, SIZE, SIZE, store,
                      picture_address(picture));
        loads++;
    }
    last_used[picture] = ++now;
    VL_InstallTextureMap(&cmdbuffer, surfaces[picture]);
}

/* --- drawing --------------------------------------------------------------- */

typedef struct {
    double x, y, z, u, v;
} Point;

static v_kafxyzuvq project(const Point *p)
{
    v_kafxyzuvq vertex;
    double clear = 1.0 - p->z / FARTHEST;
    double depth = 65000.0 * (1.0 - NEAREST / p->z);

    vertex.rgb = 0xFFFFFF;
    vertex.a = 255 << 16;
    vertex.f = FIX(255.0 * (clear < 0.0 ? 0.0 : clear));
    vertex.x = FIX(WIDTH / 2 + 300.0 * p->x / p->z);
    vertex.y = FIX(HEIGHT / 2 - 300.0 * p->y / p->z);
    vertex.z = (v_u32)(depth * 65536.0);
    vertex.u = FIX(p->u);
    vertex.v = FIX(p->v);
    vertex.q = QFIX(0.99 * NEAREST / p->z);
    return vertex;
}

/* Two triangles as words, into whichever buffer has room for both. */
static void draw_panel(const Point *corners)
{
    static const int order[6] = { 0, 1, 2, 0, 2, 3 };
    v_u32 words = sizeof(v_kafxyzuvq) / 4;
    v_u32 *to = V_AddToCmdList(&cmdbuffer, 2 * (3 * words + 1));
    int i;

    if (to == NULL) {
        return;
    }
    for (i = 0; i < 6; i++) {
        v_kafxyzuvq vertex = project(&corners[order[i]]);

        if (i % 3 == 0) {
            *to++ = V_FIFO_VTX_CMD(V_FIFO_KAFXYZUVQ, V_FIFO_TRIANGLE);
        }
        memcpy(to, &vertex, sizeof vertex);
        to += words;
    }
}

/* A panel from z0 to z1, of which only what is beyond the nearest distance can
 * be drawn. */
static void panel(int picture, double ax, double ay, double bx, double by, double z0, double z1)
{
    double from = z0 < NEAREST ? NEAREST : z0, u = (from - z0) / (z1 - z0);
    Point corners[4];

    if (z1 <= NEAREST) {
        return;
    }
    corners[0].x = ax, corners[0].y = ay, corners[0].z = from, corners[0].u = u;
    corners[1].x = ax, corners[1].y = ay, corners[1].z = z1, corners[1].u = 1.0;
    corners[2].x = bx, corners[2].y = by, corners[2].z = z1, corners[2].u = 1.0;
    corners[3].x = bx, corners[3].y = by, corners[3].z = from, corners[3].u = u;
    corners[0].v = corners[1].v = 0.0;
    corners[2].v = corners[3].v = 1.0;
    install(picture);
    draw_panel(corners);
}

static int frame_number;

static void draw(void)
{
    double position = frame_number * 2.7;
    int first = (int)(position / LENGTH), i;

    for (i = 0; i < PANELS; i++) {
        double z0 = (first + i) * LENGTH - position, z1 = z0 + LENGTH;
        int picture = (first + i) * 4 % PICTURES;

        panel(picture, -1.2, 1.0, -1.2, -1.0, z0, z1);
        panel((picture + 1) % PICTURES, 1.2, 1.0, 1.2, -1.0, z0, z1);
        panel((picture + 2) % PICTURES, -1.2, -1.0, 1.2, -1.0, z0, z1);
        panel((picture + 3) % PICTURES, -1.2, 1.0, 1.2, 1.0, z0, z1);
    }
    frame_number++;
}

static void load(void)
{
    make_pictures();
}

static void restore(void)
{
    int i;

    for (i = 0; i < PICTURES; i++) {
        if (surfaces[i] != NULL) {
            VL_RestoreSurface(verite, surfaces[i]);
            VL_LoadBuffer(&cmdbuffer, surfaces[i], 0, SIZE * 2, SIZE, SIZE, store,
                          picture_address(i));
        }
    }
}

static void set_state(void)
{
    VL_SetSrcFunc(&cmdbuffer, V_SRCFUNC_MODULATE);
    VL_SetZBufMode(&cmdbuffer, V_ZBUFMODE_LT);
    VL_SetZBufWrMode(&cmdbuffer, V_ZBUFWRMODE_ENABLE);
    VL_SetFogEnable(&cmdbuffer, V_FOG_ENABLE);
    VL_SetFogColorRGB(&cmdbuffer, 0x00081020);
    VL_SetDitherEnable(&cmdbuffer, V_DITHER_ENABLE);
    bilinear = 1;
    set_filter();
}

int main(int argc, char **argv)
{
    Program program = { V_FULLSCREEN_APP, 1, load, set_state, restore, draw, "............" };
    int code = run(&program, argc, argv);

    printf("%d loads, %d evictions\n", loads, evictions);
    return code;
}
