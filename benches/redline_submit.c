/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * redline_submit: how fast a program gets triangles of V_FIFO_KXYZ into command
 * buffers: by VL_Triangle, and as words into room from V_AddToCmdList. Run it
 * with FILLRATE_SPEED_OF_LIGHT=1, which drops issued buffers.
 *
 *     cc -O2 -Iinclude benches/redline_submit.c -o submit -Ltarget/release \
 *         -lredline -lverite
 *     FILLRATE_SPEED_OF_LIGHT=1 LD_LIBRARY_PATH=target/release ./submit
 */
#include <stdio.h>
#include <string.h>
#include <time.h>
#include <redline.h>

#define RING 8
#define TRIANGLES 2000000

static v_handle verite;
static v_cmdbuffer ring[RING];
static int ring_index;
static v_cmdbuffer cb;

static v_cmdbuffer V_CDECL issue(v_handle handle, v_cmdbuffer full)
{
    V_IssueCmdBufferAsync(handle, full);
    ring_index = (ring_index + 1) % RING;
    cb = ring[ring_index];
    while (V_QueryCmdBuffer(handle, cb) == V_CMDBUFFER_INUSE) {
    }
    return cb;
}

static double seconds(void)
{
    return (double)clock() / CLOCKS_PER_SEC;
}

static void report(const char *how, double start)
{
    printf("%-16s %.2f million triangles a second\n", how,
           TRIANGLES / (seconds() - start) * 1e-6);
}

int main(void)
{
    v_kxyz v[3] = { { 0xFF0000, 0, 0, 0 }, { 0xFF00, 5 << 16, 0, 0 }, { 0xFF, 0, 5 << 16, 0 } };
    double start;
    int i;

    VL_OpenVerite(NULL, &verite);
    for (i = 0; i < RING; i++) {
        ring[i] = V_CreateCmdBuffer(verite, 16, 16384);
        V_SetCmdBufferCallBack(ring[i], issue);
    }
    cb = ring[0];
    start = seconds();
    for (i = 0; i < TRIANGLES; i++) {
        v[0].x = i << 12;
        VL_Triangle(&cb, V_FIFO_KXYZ, (v_u32 *)&v[0], (v_u32 *)&v[1], (v_u32 *)&v[2]);
    }
    report("VL_Triangle", start);
    start = seconds();
    for (i = 0; i < TRIANGLES; i++) {
        v_u32 *to = V_AddToCmdList(&cb, 13);

        v[0].x = i << 12;
        to[0] = V_FIFO_VTX_CMD(V_FIFO_KXYZ, V_FIFO_TRIANGLE);
        memcpy(to + 1, v, sizeof v);
    }
    report("V_AddToCmdList", start);
    start = seconds();
    for (i = 0; i < TRIANGLES; i += 100) {
        v_u32 *to = V_AddToCmdList(&cb, 1300);
        int k;

        for (k = 0; k < 100; k++, to += 13) {
            v[0].x = (i + k) << 12;
            to[0] = V_FIFO_VTX_CMD(V_FIFO_KXYZ, V_FIFO_TRIANGLE);
            memcpy(to + 1, v, sizeof v);
        }
    }
    report("words by hundred", start);
    for (i = 0; i < RING; i++) {
        V_DestroyCmdBuffer(ring[i]);
    }
    VL_CloseVerite(verite);
    return 0;
}
