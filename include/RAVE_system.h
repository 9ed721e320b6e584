/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * RAVE_system.h: the other side of QuickDraw 3D RAVE 1.6, for drawing engines.
 *
 * An engine is a function that hands out its methods. It registers itself; the
 * manager finds it for programs, and asks it for draw contexts, textures,
 * bitmaps and colour tables, which stay its own. Its draw contexts get their
 * methods by QARegisterDrawMethod, from inside kQADrawPrivateNew at first.
 * Arrays of vertices, meshes and notices may be left out: the manager splits
 * them, or refuses.
 */
#ifndef RAVE_SYSTEM_H
#define RAVE_SYSTEM_H

#include "RAVE.h"

#ifdef __cplusplus
extern "C" {
#endif

/* --- methods of an engine -------------------------------------------------- */

typedef TQAError (*TQADrawPrivateNew)(TQADrawContext *newDrawContext, const TQADevice *device,
                                      const TQARect *rect, const TQAClip *clip, TQAUInt32 flags);
typedef void (*TQADrawPrivateDelete)(TQADrawPrivate *drawPrivate);
typedef TQAError (*TQAEngineCheckDevice)(const TQADevice *device);
typedef TQAError (*TQAEngineGestalt)(TQAGestaltSelector selector, void *response);
typedef TQAError (*TQATextureNew)(TQAUInt32 flags, TQAImagePixelType pixelType,
                                  const TQAImage images[], TQATexture **newTexture);
typedef TQAError (*TQATextureDetach)(TQATexture *texture);
typedef void (*TQATextureDelete)(TQATexture *texture);
typedef TQAError (*TQABitmapNew)(TQAUInt32 flags, TQAImagePixelType pixelType,
                                 const TQAImage *image, TQABitmap **newBitmap);
typedef TQAError (*TQABitmapDetach)(TQABitmap *bitmap);
typedef void (*TQABitmapDelete)(TQABitmap *bitmap);
typedef TQAError (*TQAColorTableNew)(TQAColorTableType pixelType, void *pixelData,
                                     TQAInt32 transparentIndexFlag, TQAColorTable **newTable);
typedef void (*TQAColorTableDelete)(TQAColorTable *colorTable);
typedef TQAError (*TQATextureBindColorTable)(TQATexture *texture, TQAColorTable *colorTable);
typedef TQAError (*TQABitmapBindColorTable)(TQABitmap *bitmap, TQAColorTable *colorTable);
typedef TQAError (*TQAAccessTexture)(TQATexture *texture, TQAInt32 mipmapLevel, TQAInt32 flags,
                                     TQAPixelBuffer *buffer);
typedef TQAError (*TQAAccessTextureEnd)(TQATexture *texture, const TQARect *dirtyRect);
typedef TQAError (*TQAAccessBitmap)(TQABitmap *bitmap, TQAInt32 flags, TQAPixelBuffer *buffer);
typedef TQAError (*TQAAccessBitmapEnd)(TQABitmap *bitmap, const TQARect *dirtyRect);

typedef enum TQAEngineMethodTag {
    kQADrawPrivateNew = 0,
    kQADrawPrivateDelete = 1,
    kQAEngineCheckDevice = 2,
    kQAEngineGestalt = 3,
    kQATextureNew = 4,
    kQATextureDetach = 5,
    kQATextureDelete = 6,
    kQABitmapNew = 7,
    kQABitmapDetach = 8,
    kQABitmapDelete = 9,
    kQAColorTableNew = 10,
    kQAColorTableDelete = 11,
    kQATextureBindColorTable = 12,
    kQABitmapBindColorTable = 13,
    kQAAccessTexture = 14,
    kQAAccessTextureEnd = 15,
    kQAAccessBitmap = 16,
    kQAAccessBitmapEnd = 17
} TQAEngineMethodTag;

typedef union TQAEngineMethod {
    TQADrawPrivateNew drawPrivateNew;
    TQADrawPrivateDelete drawPrivateDelete;
    TQAEngineCheckDevice engineCheckDevice;
    TQAEngineGestalt engineGestalt;
    TQATextureNew textureNew;
    TQATextureDetach textureDetach;
    TQATextureDelete textureDelete;
    TQABitmapNew bitmapNew;
    TQABitmapDetach bitmapDetach;
    TQABitmapDelete bitmapDelete;
    TQAColorTableNew colorTableNew;
    TQAColorTableDelete colorTableDelete;
    TQATextureBindColorTable textureBindColorTable;
    TQABitmapBindColorTable bitmapBindColorTable;
    TQAAccessTexture accessTexture;
    TQAAccessTextureEnd accessTextureEnd;
    TQAAccessBitmap accessBitmap;
    TQAAccessBitmapEnd accessBitmapEnd;
} TQAEngineMethod;

/* kQANotSupported for methods that the engine does not have. */
typedef TQAError (*TQAEngineGetMethod)(TQAEngineMethodTag methodTag, TQAEngineMethod *method);

/* --- methods of an engine's draw contexts ---------------------------------- */

typedef enum TQADrawMethodTag {
    kQASetFloat = 0,
    kQASetInt = 1,
    kQASetPtr = 2,
    kQAGetFloat = 3,
    kQAGetInt = 4,
    kQAGetPtr = 5,
    kQADrawPoint = 6,
    kQADrawLine = 7,
    kQADrawTriGouraud = 8,
    kQADrawTriTexture = 9,
    kQADrawVGouraud = 10,
    kQADrawVTexture = 11,
    kQADrawBitmap = 12,
    kQARenderStart = 13,
    kQARenderEnd = 14,
    kQARenderAbort = 15,
    kQAFlush = 16,
    kQASync = 17,
    kQASubmitVerticesGouraud = 18,
    kQASubmitVerticesTexture = 19,
    kQADrawTriMeshGouraud = 20,
    kQADrawTriMeshTexture = 21,
    kQASetNoticeMethod = 22,
    kQAGetNoticeMethod = 23,
    kQASubmitMultiTextureParams = 24,
    kQAAccessDrawBuffer = 25,
    kQAAccessDrawBufferEnd = 26,
    kQAAccessZBuffer = 27,
    kQAAccessZBufferEnd = 28,
    kQAClearDrawBuffer = 29,
    kQAClearZBuffer = 30,
    kQATextureNewFromDrawContext = 31,
    kQABitmapNewFromDrawContext = 32,
    kQABusy = 33,
    kQASwapBuffers = 34,
    kQANumDrawMethods = 35
} TQADrawMethodTag;

typedef union TQADrawMethod {
    TQASetFloat setFloat;
    TQASetInt setInt;
    TQASetPtr setPtr;
    TQAGetFloat getFloat;
    TQAGetInt getInt;
    TQAGetPtr getPtr;
    TQADrawPoint drawPoint;
    TQADrawLine drawLine;
    TQADrawTriGouraud drawTriGouraud;
    TQADrawTriTexture drawTriTexture;
    TQADrawVGouraud drawVGouraud;
    TQADrawVTexture drawVTexture;
    TQADrawBitmap drawBitmap;
    TQARenderStart renderStart;
    TQARenderEnd renderEnd;
    TQARenderAbort renderAbort;
    TQAFlush flush;
    TQASync sync;
    TQASubmitVerticesGouraud submitVerticesGouraud;
    TQASubmitVerticesTexture submitVerticesTexture;
    TQADrawTriMeshGouraud drawTriMeshGouraud;
    TQADrawTriMeshTexture drawTriMeshTexture;
    TQASetNoticeMethod setNoticeMethod;
    TQAGetNoticeMethod getNoticeMethod;
    TQASubmitMultiTextureParams submitMultiTextureParams;
    TQAAccessDrawBuffer accessDrawBuffer;
    TQAAccessDrawBufferEnd accessDrawBufferEnd;
    TQAAccessZBuffer accessZBuffer;
    TQAAccessZBufferEnd accessZBufferEnd;
    TQAClearDrawBuffer clearDrawBuffer;
    TQAClearZBuffer clearZBuffer;
    TQATextureNewFromDrawContext textureFromContext;
    TQABitmapNewFromDrawContext bitmapFromContext;
    TQABusy busy;
    TQASwapBuffers swapBuffers;
} TQADrawMethod;

/* --- registration ---------------------------------------------------------- */

/* Of two engines with one vendor and number the one of the greater revision
 * stays; the other is refused with kQAOutOfDate. */
TQAError QARegisterEngine(TQAEngineGetMethod engineGetMethod);
TQAError QARegisterEngineWithRefCon(TQAEngineGetMethod engineGetMethod, long refCon);
/* The refCon of the engine whose method runs. */
long QAGetCurrentEngineRefCon(void);

TQAError QARegisterDrawMethod(TQADrawContext *drawContext, TQADrawMethodTag methodTag,
                              TQADrawMethod method);

#ifdef __cplusplus
}
#endif

#endif
