/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * common.h: what the RRedline examples share: a ring of command buffers, error
 * handlers, page flips in a window and on the full screen, keys.
 *
 * There is no keyboard here: option -k gives one key for each frame.
 *
 *     f  the other texture filter     a  the other display type (Alt-Enter)
 *     l  another program takes over   r  it ends, and everything is restored
 *     q  quit                         .  none
 *
 * -n N shows N frames without keys; -w and -s start in a window or on the full
 * screen.
 */
#ifndef FILLRATE_REDLINE_COMMON_H
#define FILLRATE_REDLINE_COMMON_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <redline.h>
#include <rlex.h>

#define WIDTH 640
#define HEIGHT 480

#define RING 8
#define DMA_ENTRIES 1024
#define COMMANDS 4096

/* Numbers as the chip reads them. */
#define FIX(a) ((v_s32)((a) * 65536.0))
#define QFIX(a) ((v_u32)((a) * 16777215.0))
#define ARGB(a, r, g, b) \
    ((v_u32)(a) << 24 | (v_u32)(r) << 16 | (v_u32)(g) << 8 | (v_u32)(b))

/* A program: what differs from the others. */
typedef struct {
    v_u32 display_type;
    int has_depth;
    void (*load)(void);    /* makes surfaces and fills them */
    void (*state)(void);   /* the state that never changes */
    void (*restore)(void); /* loads surfaces again */
    void (*draw)(void);    /* one frame */
    const char *keys;      /* unless -k or -n say otherwise */
} Program;

static v_handle verite;
static v_cmdbuffer ring[RING];
static int ring_index;
static v_cmdbuffer cmdbuffer;
static v_surface *display;
static int bilinear;
static int active = 1;

/* --- errors -------------------------------------------------------------- */

static inline void close_all(void)
{
    int i;

    for (i = 0; i < RING && ring[i] != NULL; i++) {
        V_DestroyCmdBuffer(ring[i]);
        ring[i] = NULL;
    }
    if (display != NULL) {
        VL_DestroySurface(verite, display);
        display = NULL;
    }
    if (verite != NULL) {
        VL_CloseVerite(verite);
        verite = NULL;
    }
}

static inline void fail(const char *layer, const char *routine, const char *text, int extended)
{
    static int entered;

    fprintf(stderr, "%s: %s: %s (%#x)\n", layer, routine, text, (unsigned)extended);
    if (entered++ == 0) {
        close_all();
    }
    exit(1);
}

static inline void V_CDECL verite_failed(v_handle handle, v_routine routine, v_error error,
                                         int extended)
{
    char name[64] = "?", text[128] = "?";

    (void)handle;
    V_GetFunctionName(routine, name, sizeof name);
    V_GetErrorText(error, text, sizeof text);
    fail("verite", name, text, extended);
}

static inline void V_CDECL redline_failed(v_handle handle, vl_routine routine, vl_error error,
                                          int extended)
{
    char name[64] = "?", text[128] = "?";

    (void)handle;
    VL_GetFunctionName(routine, name, sizeof name);
    VL_GetErrorText(error, text, sizeof text);
    fail("redline", name, text, extended);
}

/* --- commands ------------------------------------------------------------ */

/* Issues a buffer and goes on with the next of the ring. It is also what
 * happens when a buffer is full. */
static inline v_cmdbuffer V_CDECL issue(v_handle handle, v_cmdbuffer full)
{
    V_IssueCmdBufferAsync(handle, full);
    ring_index = (ring_index + 1) % RING;
    cmdbuffer = ring[ring_index];
    while (V_QueryCmdBuffer(handle, cmdbuffer) == V_CMDBUFFER_INUSE) {
    }
    return cmdbuffer;
}

/* Locking waits until everything issued is done. */
static inline void finish_all(void)
{
    issue(verite, cmdbuffer);
    if (display != NULL) {
        V_LockBuffer(verite, display->buffer_group, 0);
        V_UnlockBuffer(verite, display->buffer_group, 0);
    }
}

/* --- display ------------------------------------------------------------- */

static inline void clear_display(void)
{
    VL_FillBuffer(&cmdbuffer, display, 1, 0, 0, display->width, display->height, 0);
    if (display->buffer_mask & V_SURFACE_Z_BUFFER) {
        VL_FillBuffer(&cmdbuffer, display, 2, 0, 0, display->width, display->height, 0xFFFF);
    }
}

static inline void flip_pages(void)
{
    if (V_GetDisplayType(verite) == V_FULLSCREEN_APP) {
        VL_SwapDisplaySurface(&cmdbuffer, display);
        VL_WaitForDisplaySwitch(&cmdbuffer);
        clear_display();
        issue(verite, cmdbuffer);
    } else {
        v_rect window = { 0, 0, WIDTH, HEIGHT };

        issue(verite, cmdbuffer);
        V_BltDisplayBuffer(verite, display->buffer_group, 0, &window, display->buffer_group, 1,
                           NULL);
        clear_display();
    }
}

/* State that refers to the display's buffers. */
static inline void install_display(void)
{
    VL_InstallDstBuffer(&cmdbuffer, display);
    if (display->buffer_mask & V_SURFACE_Z_BUFFER) {
        VL_InstallZBuffer(&cmdbuffer, display);
    }
}

static inline void set_display(v_u32 type, int has_depth)
{
    v_u32 mask = V_SURFACE_PRIMARY | (has_depth ? V_SURFACE_Z_BUFFER : 0);

    finish_all();
    if (display != NULL) {
        VL_DestroySurface(verite, display);
        display = NULL;
    }
    V_SetDisplayType(verite, type);
    if (type == V_FULLSCREEN_APP) {
        V_SetDisplayMode(verite, WIDTH, HEIGHT, 16, 60);
    }
    VL_CreateSurface(verite, &display, mask, has_depth ? 3 : 2, V_PIXFMT_565, WIDTH, HEIGHT);
    install_display();
    clear_display();
}

/* --- state that several examples have ------------------------------------ */

/* With bilinear filtering the texel's centre is half a texel away. */
static inline void set_filter(void)
{
    v_u32 offset = bilinear ? 0xFFFF8000 : 0;

    VL_SetSrcFilter(&cmdbuffer, bilinear ? V_SRCFILTER_BILINEAR : V_SRCFILTER_POINT);
    VL_SetSOffset(&cmdbuffer, offset);
    VL_SetTOffset(&cmdbuffer, offset);
}

/* A chequered picture of 16-bit texels in locked memory. */
static inline v_memory make_checker(int width, int height, int section_width, int section_height,
                                    v_u16 color1, v_u16 color2)
{
    v_memory memory = V_AllocLockedMem(verite, (v_u32)(width * height * 2));
    v_u16 *texel = (v_u16 *)V_GetMemoryObjectAddress(memory);
    int x, y;

    for (y = 0; y < height; y++) {
        for (x = 0; x < width; x++) {
            *texel++ = (x / section_width + y / section_height) % 2 == 0 ? color1 : color2;
        }
    }
    return memory;
}

/* A texture surface, filled from memory. */
static inline v_surface *make_texture(v_memory memory, v_u32 format, v_u32 width, v_u32 height)
{
    v_surface *surface = NULL;

    VL_CreateSurface(verite, &surface, 0, 1, format, width, height);
    VL_LoadBuffer(&cmdbuffer, surface, 0, width * 2, width, height, memory, NULL);
    return surface;
}

/* --- the program --------------------------------------------------------- */

static inline void open_all(const Program *program)
{
    int i;

    if (V_RegisterErrorHandler(verite_failed) != V_SUCCESS
        || VL_RegisterErrorHandler(redline_failed) != VL_SUCCESS) {
        exit(1);
    }
    VL_OpenVerite(NULL, &verite);
    for (i = 0; i < RING; i++) {
        ring[i] = V_CreateCmdBuffer(verite, DMA_ENTRIES, COMMANDS);
        V_SetCmdBufferCallBack(ring[i], issue);
    }
    cmdbuffer = ring[0];
    set_display(program->display_type, program->has_depth);
    if (program->load != NULL) {
        program->load();
    }
    program->state();
}

/* Another program may have used the chip: nothing is as it was. */
static inline void restore_all(const Program *program)
{
    VL_ContextInit(&cmdbuffer);
    program->state();
    VL_RestoreSurface(verite, display);
    install_display();
    clear_display();
    if (program->restore != NULL) {
        program->restore();
    }
}

static inline void press(const Program *program, char key)
{
    switch (key) {
    case 'f':
        bilinear = !bilinear;
        program->state();
        break;
    case 'a':
        set_display(V_GetDisplayType(verite) == V_FULLSCREEN_APP ? V_WINDOWED_APP
                                                                 : V_FULLSCREEN_APP,
                    program->has_depth);
        break;
    case 'l':
        active = 0;
        V_ResetCmdBuffer(cmdbuffer);
        break;
    case 'r':
        active = 1;
        restore_all(program);
        break;
    default:
        break;
    }
}

static inline int run(const Program *program, int argc, char **argv)
{
    Program chosen = *program;
    const char *keys = program->keys;
    int frames = (int)strlen(keys), i;

    for (i = 1; i < argc; i++) {
        if (strcmp(argv[i], "-k") == 0 && i + 1 < argc) {
            keys = argv[++i];
            frames = (int)strlen(keys);
        } else if (strcmp(argv[i], "-n") == 0 && i + 1 < argc) {
            keys = "";
            frames = atoi(argv[++i]);
        } else if (strcmp(argv[i], "-w") == 0) {
            chosen.display_type = V_WINDOWED_APP;
        } else if (strcmp(argv[i], "-s") == 0) {
            chosen.display_type = V_FULLSCREEN_APP;
        } else {
            fprintf(stderr, "usage: %s [-k KEYS] [-n FRAMES] [-w] [-s]\n", argv[0]);
            return 2;
        }
    }
    open_all(&chosen);
    for (i = 0; i < frames; i++) {
        char key = (char)(keys[0] != '\0' ? keys[i] : '.');

        if (key == 'q') {
            break;
        }
        press(&chosen, key);
        if (active) {
            chosen.draw();
            flip_pages();
        }
    }
    finish_all();
    close_all();
    return 0;
}

#endif
