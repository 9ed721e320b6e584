/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * redline_submit.c: how many triangles a second a C program hands over on one
 * thread, and how many are drawn. V_FIFO_KXYZ, ten pixels each, into a ring of
 * command buffers. With the argument "reset", full buffers are dropped, so that
 * only recording is measured.
 *
 *   cc -O2 -Iinclude benches/redline_submit.c -o submit \
 *      -Ltarget/release -lredline -lverite
 *   LD_LIBRARY_PATH=target/release ./submit reset
 *   LD_LIBRARY_PATH=target/release ./submit issue
 */
#define _POSIX_C_SOURCE 199309L
#include <redline.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#define RING 8
#define TRIANGLES 5000000

static v_handle verite;
static v_cmdbuffer ring[RING];
static int at;
static int drop;

static v_cmdbuffer V_CDECL next(v_handle handle, v_cmdbuffer full)
{
    if (drop) {
        V_ResetCmdBuffer(full);
        return full;
    }
    V_IssueCmdBufferAsync(handle, full);
    at = (at + 1) % RING;
    while (V_QueryCmdBuffer(handle, ring[at]) == V_CMDBUFFER_INUSE) {
    }
    return ring[at];
}

static double seconds(void)
{
    struct timespec now;

    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + (double)now.tv_nsec * 1e-9;
}

int main(int argc, char **argv)
{
    v_surface *display = NULL;
    v_cmdbuffer cb;
    v_kxyz v[3];
    double start, best = 0;
    int i, run;

    drop = argc > 1 && strcmp(argv[1], "reset") == 0;
    VL_OpenVerite(NULL, &verite);
    V_SetDisplayType(verite, V_FULLSCREEN_APP);
    V_SetDisplayMode(verite, 640, 480, 16, 60);
    VL_CreateSurface(verite, &display, V_SURFACE_PRIMARY | V_SURFACE_Z_BUFFER, 3, V_PIXFMT_565,
                     640, 480);
    for (i = 0; i < RING; i++) {
        ring[i] = V_CreateCmdBuffer(verite, 1024, 16384);
        V_SetCmdBufferCallBack(ring[i], next);
    }
    cb = ring[0];
    VL_InstallDstBuffer(&cb, display);
    VL_InstallZBuffer(&cb, display);
    V_IssueCmdBuffer(verite, cb);
    for (run = 0; run < 5; run++) {
        double rate;

        start = seconds();
        for (i = 0; i < TRIANGLES; i++) {
            int x = i % 126 * 5, y = i / 126 % 94 * 5;

            v[0].rgb = v[1].rgb = v[2].rgb = (v_u32)i * 0x010305u;
            v[0].x = v[2].x = x << 16;
            v[1].x = (x + 5) << 16;
            v[0].y = v[1].y = y << 16;
            v[2].y = (y + 4) << 16;
            v[0].z = v[1].z = v[2].z = 100 << 16;
            VL_Triangle(&cb, V_FIFO_KXYZ, (v_u32 *)&v[0], (v_u32 *)&v[1], (v_u32 *)&v[2]);
        }
        if (!drop) {
            V_IssueCmdBuffer(verite, cb);
        }
        rate = TRIANGLES / (seconds() - start) / 1e6;
        best = rate > best ? rate : best;
        printf("%.2f Mtri/s\n", rate);
    }
    printf("best of 5: %.2f Mtri/s\n", best);
    VL_CloseVerite(verite);
    return 0;
}
