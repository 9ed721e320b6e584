/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * rave_layout.c: sizes and offsets of the structures of RAVE.h, for pointers of
 * 32 and of 64 bits, and the order of the methods of a draw context.
 */
#include <stddef.h>

#include <RAVE.h>
#include <RAVE_system.h>

#include "check.h"

/* The value that applies to this build's pointer size. */
#define BITS(v32, v64) (sizeof(void *) == 4 ? (size_t)(v32) : (size_t)(v64))
#define SIZE(type, v32, v64) CHECK(sizeof(type) == BITS(v32, v64))
#define FIELD(type, field, v32, v64) CHECK(offsetof(type, field) == BITS(v32, v64))
/* The nth method. */
#define METHOD(field, tag) \
    CHECK(offsetof(TQADrawContext, field) == BITS(8, 16) + (size_t)(tag) * sizeof(void (*)(void)))

static void structures(void)
{
    SIZE(TQARect, 16, 16);
    FIELD(TQARect, left, 0, 0);
    FIELD(TQARect, right, 4, 4);
    FIELD(TQARect, top, 8, 8);
    FIELD(TQARect, bottom, 12, 12);
    SIZE(TQAImage, 16, 24);
    FIELD(TQAImage, width, 0, 0);
    FIELD(TQAImage, height, 4, 4);
    FIELD(TQAImage, rowBytes, 8, 8);
    FIELD(TQAImage, pixmap, 12, 16);
    SIZE(TQADeviceMemory, 20, 24);
    FIELD(TQADeviceMemory, rowBytes, 0, 0);
    FIELD(TQADeviceMemory, pixelType, 4, 4);
    FIELD(TQADeviceMemory, width, 8, 8);
    FIELD(TQADeviceMemory, height, 12, 12);
    FIELD(TQADeviceMemory, baseAddr, 16, 16);
    SIZE(TQAPixelBuffer, 20, 24);
    FIELD(TQAPixelBuffer, rowBytes, 0, 0);
    FIELD(TQAPixelBuffer, baseAddr, 16, 16);
    SIZE(TQAZBuffer, 24, 32);
    FIELD(TQAZBuffer, width, 0, 0);
    FIELD(TQAZBuffer, height, 4, 4);
    FIELD(TQAZBuffer, rowBytes, 8, 8);
    FIELD(TQAZBuffer, zbuffer, 12, 16);
    FIELD(TQAZBuffer, zDepth, 16, 24);
    FIELD(TQAZBuffer, isBigEndian, 20, 28);
    SIZE(TQADeviceOffscreen, 4, 4);
    FIELD(TQADeviceOffscreen, pixelType, 0, 0);
    SIZE(TQADevice, 24, 32);
    FIELD(TQADevice, deviceType, 0, 0);
    FIELD(TQADevice, device.memoryDevice.rowBytes, 4, 8);
    FIELD(TQADevice, device.memoryDevice.pixelType, 8, 12);
    FIELD(TQADevice, device.memoryDevice.width, 12, 16);
    FIELD(TQADevice, device.memoryDevice.height, 16, 20);
    FIELD(TQADevice, device.memoryDevice.baseAddr, 20, 24);
    SIZE(TQAClip, 8, 16);
    FIELD(TQAClip, clipType, 0, 0);
    FIELD(TQAClip, clip, 4, 8);
    SIZE(TQAClipRectList, 8, 16);
    FIELD(TQAClipRectList, count, 0, 0);
    FIELD(TQAClipRectList, rects, 4, 8);
    SIZE(TQAGlobalRect, 8, 8);
    FIELD(TQAGlobalRect, top, 0, 0);
    FIELD(TQAGlobalRect, left, 2, 2);
    FIELD(TQAGlobalRect, bottom, 4, 4);
    FIELD(TQAGlobalRect, right, 6, 6);
    SIZE(TQAVGouraud, 32, 32);
    FIELD(TQAVGouraud, x, 0, 0);
    FIELD(TQAVGouraud, y, 4, 4);
    FIELD(TQAVGouraud, z, 8, 8);
    FIELD(TQAVGouraud, invW, 12, 12);
    FIELD(TQAVGouraud, r, 16, 16);
    FIELD(TQAVGouraud, g, 20, 20);
    FIELD(TQAVGouraud, b, 24, 24);
    FIELD(TQAVGouraud, a, 28, 28);
    SIZE(TQAVTexture, 64, 64);
    FIELD(TQAVTexture, x, 0, 0);
    FIELD(TQAVTexture, y, 4, 4);
    FIELD(TQAVTexture, z, 8, 8);
    FIELD(TQAVTexture, invW, 12, 12);
    FIELD(TQAVTexture, r, 16, 16);
    FIELD(TQAVTexture, g, 20, 20);
    FIELD(TQAVTexture, b, 24, 24);
    FIELD(TQAVTexture, a, 28, 28);
    FIELD(TQAVTexture, uOverW, 32, 32);
    FIELD(TQAVTexture, vOverW, 36, 36);
    FIELD(TQAVTexture, kd_r, 40, 40);
    FIELD(TQAVTexture, kd_g, 44, 44);
    FIELD(TQAVTexture, kd_b, 48, 48);
    FIELD(TQAVTexture, ks_r, 52, 52);
    FIELD(TQAVTexture, ks_g, 56, 56);
    FIELD(TQAVTexture, ks_b, 60, 60);
    SIZE(TQAVMultiTexture, 12, 12);
    FIELD(TQAVMultiTexture, invW, 0, 0);
    FIELD(TQAVMultiTexture, uOverW, 4, 4);
    FIELD(TQAVMultiTexture, vOverW, 8, 8);
    SIZE(TQAIndexedTriangle, 16, 16);
    FIELD(TQAIndexedTriangle, triangleFlags, 0, 0);
    FIELD(TQAIndexedTriangle, vertices, 4, 4);
    SIZE(TQANoticeMethod, 4, 8);
    SIZE(TQAEngineMethod, 4, 8);
    SIZE(TQADrawMethod, 4, 8);
}

static void methods(void)
{
    FIELD(TQADrawContext, drawPrivate, 0, 0);
    FIELD(TQADrawContext, version, 4, 8);
    METHOD(setFloat, 0);
    METHOD(setInt, 1);
    METHOD(setPtr, 2);
    METHOD(getFloat, 3);
    METHOD(getInt, 4);
    METHOD(getPtr, 5);
    METHOD(drawPoint, 6);
    METHOD(drawLine, 7);
    METHOD(drawTriGouraud, 8);
    METHOD(drawTriTexture, 9);
    METHOD(drawVGouraud, 10);
    METHOD(drawVTexture, 11);
    METHOD(drawBitmap, 12);
    METHOD(renderStart, 13);
    METHOD(renderEnd, 14);
    METHOD(renderAbort, 15);
    METHOD(flush, 16);
    METHOD(sync, 17);
    METHOD(submitVerticesGouraud, 18);
    METHOD(submitVerticesTexture, 19);
    METHOD(drawTriMeshGouraud, 20);
    METHOD(drawTriMeshTexture, 21);
    METHOD(setNoticeMethod, 22);
    METHOD(getNoticeMethod, 23);
    METHOD(submitMultiTextureParams, 24);
    METHOD(accessDrawBuffer, 25);
    METHOD(accessDrawBufferEnd, 26);
    METHOD(accessZBuffer, 27);
    METHOD(accessZBufferEnd, 28);
    METHOD(clearDrawBuffer, 29);
    METHOD(clearZBuffer, 30);
    METHOD(textureFromContext, 31);
    METHOD(bitmapFromContext, 32);
    METHOD(busy, 33);
    METHOD(swapBuffers, 34);
    SIZE(TQADrawContext, 8 + 4 * 35, 16 + 8 * 35);
}

int main(void)
{
    CHECK(sizeof(TQAInt32) == 4 && (TQAInt32)-1 < 0);
    CHECK(sizeof(TQAUInt32) == 4 && (TQAUInt32)-1 > 0);
    CHECK(sizeof(TQABoolean) == 1 && (TQABoolean)-1 > 0);
    CHECK(sizeof(TQAError) == 4 && sizeof(TQAVersion) == 4 && sizeof(TQATagInt) == 4);
    CHECK(sizeof(TQATagFloat) == 4 && sizeof(TQATagPtr) == 4 && sizeof(TQAVertexMode) == 4);
    CHECK(sizeof(TQAImagePixelType) == 4 && sizeof(TQAGestaltSelector) == 4);
    structures();
    methods();
    return CHECK_REPORT();
}
