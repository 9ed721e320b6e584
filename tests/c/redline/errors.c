/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * errors.c: codes, handlers, their recursion, names and texts.
 */
#include "conformance.h"

static int depth_of_calls, deepest;

/* A handler may call the library; its failures reach the handler again. */
static void V_CDECL fails_again(v_handle handle, v_routine routine, v_error error, int extended)
{
    (void)routine;
    (void)error;
    (void)extended;
    depth_of_calls++;
    if (depth_of_calls > deepest) {
        deepest = depth_of_calls;
    }
    if (depth_of_calls < 3) {
        CHECK(V_SetDisplayType(handle, 77) == V_PARAM_ERROR);
    }
    depth_of_calls--;
}

static void silent_functions(void)
{
    char text[128], tiny[8];
    int i;

    for (i = 100; i <= 164; i++) {
        memset(text, 'x', sizeof text);
        if (V_GetFunctionName(i, text, sizeof text) == V_SUCCESS) {
            CHECK(strncmp(text, "V_", 2) == 0 && strlen(text) > 4);
        }
    }
    for (i = 200; i <= 364; i++) {
        memset(text, 'x', sizeof text);
        if (VL_GetFunctionName(i, text, sizeof text) == VL_SUCCESS) {
            CHECK(strncmp(text, "VL_", 3) == 0 && strlen(text) > 3);
        }
    }
    CHECK(V_GetFunctionName(V_R_CreateCmdBuffer, text, sizeof text) == V_SUCCESS);
    CHECK(strcmp(text, "V_CreateCmdBuffer") == 0);
    CHECK(VL_GetFunctionName(VL_R_Triangle, text, sizeof text) == VL_SUCCESS);
    CHECK(strcmp(text, "VL_Triangle") == 0);
    CHECK(V_GetErrorText(V_OUT_OF_VIDEO_MEMORY, text, sizeof text) == V_SUCCESS);
    CHECK(strlen(text) > 8);
    CHECK(VL_GetErrorText(VL_BAD_PIXFMT, text, sizeof text) == VL_SUCCESS);
    CHECK(strlen(text) > 8);
    /* What does not fit is cut and ended. */
    memset(tiny, 'x', sizeof tiny);
    CHECK(V_GetFunctionName(V_R_CreateCmdBuffer, tiny, 5) == V_SUCCESS);
    CHECK(strcmp(tiny, "V_Cr") == 0 && tiny[5] == 'x');
    CHECK(V_GetFunctionName(12345, text, sizeof text) == V_PARAM_ERROR);
    CHECK(V_GetErrorText(12345, text, sizeof text) == V_PARAM_ERROR);
    CHECK(V_GetErrorText(V_FAILED, NULL, 8) == V_PARAM_ERROR);
    CHECK(V_GetErrorText(V_FAILED, text, 0) == V_PARAM_ERROR);
    CHECK(V_GetErrorText(V_FAILED, text, -3) == V_PARAM_ERROR);
    CHECK(VL_GetFunctionName(12345, text, sizeof text) == VL_PARAM_ERROR);
    CHECK(VL_GetErrorText(12345, text, sizeof text) == VL_PARAM_ERROR);
    CHECK(VL_GetErrorText(VL_FAILED, NULL, 8) == VL_PARAM_ERROR);
    CHECK(VL_GetErrorText(VL_FAILED, text, 0) == VL_PARAM_ERROR);
    CHECK(v_told.calls == 0 && vl_told.calls == 0);
}

static void codes_and_handlers(void)
{
    v_error error = 0;
    v_routine routine = 0;
    int extended = -1;
    v_surface *surface = NULL;
    v_handle none = NULL;

    CHECK(V_SetDisplayType(verite, 77) == V_PARAM_ERROR);
    CHECK(v_told.handle == verite);
    CHECK(v_told_once(V_R_SetDisplayType, V_PARAM_ERROR));
    CHECK(V_GetLastError(&routine, &error, &extended) == V_SUCCESS);
    CHECK(routine == V_R_SetDisplayType && error == V_PARAM_ERROR);

    CHECK(VL_CreateSurface(verite, NULL, 0, 1, V_PIXFMT_565, 8, 8) == VL_PARAM_ERROR);
    CHECK(vl_told_once(VL_R_CreateSurface, VL_PARAM_ERROR));
    /* Here the error comes first. */
    CHECK(VL_GetLastError(&error, &routine, &extended) == VL_SUCCESS);
    CHECK(routine == VL_R_CreateSurface && error == VL_PARAM_ERROR);
    forget_errors();

    /* More than the board has: the lower layer is heard first. */
    CHECK(VL_CreateSurface(verite, &surface, 0, 16, V_PIXFMT_8888, 320, 1000)
          == VL_OUT_OF_VIDEO_MEMORY);
    CHECK(surface == NULL);
    CHECK(v_told.error == V_OUT_OF_VIDEO_MEMORY);
    CHECK(vl_told_once(VL_R_CreateSurface, VL_OUT_OF_VIDEO_MEMORY));
    forget_errors();

    CHECK(VL_CreateSurface(verite, &surface, 0, 1, 99, 8, 8) != VL_SUCCESS);
    CHECK(vl_told.calls == 1 && vl_told.routine == VL_R_CreateSurface);
    forget_errors();
    CHECK(V_CreateCmdBuffer(verite, -1, 16) == NULL);
    CHECK(v_told_once(V_R_CreateCmdBuffer, V_PARAM_ERROR));
    CHECK(V_CreateVerite(9, NULL, &none, NULL) != V_SUCCESS && none == NULL);
    CHECK(v_told.calls == 1 && v_told.routine == V_R_CreateVerite);
    forget_errors();
    CHECK(VL_SetSrcFunc(NULL, V_SRCFUNC_REPLACE) == VL_PARAM_ERROR);
    CHECK(vl_told.calls == 1 && vl_told.routine == VL_R_SetSrcFunc);
    forget_errors();
}

static void recursion(void)
{
    v_error_handler before = V_GetErrorHandler();

    CHECK(before == note_v);
    CHECK(VL_GetErrorHandler() == note_vl);
    CHECK(V_RegisterErrorHandler(fails_again) == V_SUCCESS);
    CHECK(V_SetDisplayType(verite, 78) == V_PARAM_ERROR);
    CHECK(deepest == 3 && depth_of_calls == 0);
    /* Without a handler codes are returned all the same. */
    CHECK(V_RegisterErrorHandler(NULL) == V_SUCCESS);
    CHECK(V_GetErrorHandler() == NULL);
    CHECK(V_SetDisplayType(verite, 79) == V_PARAM_ERROR);
    CHECK(V_RegisterErrorHandler(before) == V_SUCCESS);
    CHECK(v_told.calls == 0);
}

int main(void)
{
    v_handle none = NULL;

    /* Nothing is open, no handler is there. */
    CHECK(V_DestroyVerite(NULL) == V_PARAM_ERROR);
    CHECK(V_GetDisplayType(none) == 0);
    open_small();
    silent_functions();
    codes_and_handlers();
    recursion();
    quad(20, 20, 280, 200, 0xFF40C040);
    show();
    return finish();
}
