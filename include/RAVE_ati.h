/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * RAVE_ati.h: ATI's additions to RAVE 1.6, as far as programs of the time use
 * them. The library follows the tags of fog, alpha test, depth writes and
 * channels; it ignores the others. Its extension functions are the first five.
 */
#ifndef RAVE_ATI_H
#define RAVE_ATI_H

#include "RAVE.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Tags of any type: cast to TQATagInt, TQATagFloat or TQATagPtr. */
#define kATITriCache 1000
#define kATIClearPreCallback 1001
#define kATIFogMode 1002
#define kATIFogColor_r 1003
#define kATIFogColor_g 1004
#define kATIFogColor_b 1005
#define kATIFogColor_a 1006
#define kATIFogDensity 1007
#define kATIFogStart 1008
#define kATIFogEnd 1009
#define kATILodBias 1010
#define kATIChipID 1011
#define kATICompositing 1012
#define kATICompositingFunc 1013
#define kATICompositingFactor 1014
#define kATISecondTexMin 1015
#define kATISecondTexMag 1016
#define kATIVQTexCompresion 1017
#define kATISecond_Texture 1018
#define kATICompositingAlpha 1019
#define kATINoDefaultClear 1020
#define kATIRaveExtFuncs 1021
#define kATIEnableZWrite 1022
#define kATIRop2 1023
#define kATIAlphaTestEnable 1024
#define kATIAlphaTestRef 1025
#define kATIAlphaTestFunc 1026
#define kATITexCompress 1027
#define kATI_TextureContext 1028
#define kATISecond_TextureContext 1029
#define kATISecondTextureWrapU 1030
#define kATISecondTextureWrapV 1031
#define kATISafeCallbacks 1032
#define kATITextureAddr 1033
#define kATIAlphaEnable 1034
#define kATIRedEnable 1035
#define kATIGreenEnable 1036
#define kATIBlueEnable 1037
#define kATINotifyZBuffer 1038
#define kATIModulate2x 1039
#define kATIDitherMode 1040
#define kATIChipBusy 1041
#define kATIMeshAsStrip 1042

/* kATIFogMode: other numbers than kQAFogMode. */
#define kATIFogDisable 0
#define kATIFogExp 1
#define kATIFogExp2 2
#define kATIFogAlpha 3
#define kATIFogLinear 4

/* kATICompositingFunc. */
#define kATICompositeBlend 0
#define kATICompositeModulate 1
#define kATICompositeAddSpecular 2

/* kATIDitherMode. */
#define kATIDitherOff 0
#define kATIDitherErrorDiffusion 1
#define kATIDitherLookUp 2

/* Pixel types of the boards; refused. */
#define kATIPixel_RGB4444 1000
#define kATIPixel_ARGB4444 1001
#define kATIPixel_YUV422 1002
#define kATIPixel_ARGB8 1003

/* On call the response holds the address of a TQADevice, afterwards that of the
 * draw context which draws there, or NULL. */
#define kATIGestalt_CurrentContext 1000

/* QAGetPtr of kATIRaveExtFuncs. */
typedef struct ATIRaveExtFuncs {
    TQAError (*clearDrawBuffer)(const TQADrawContext *drawContext, const TQARect *rect);
    TQAError (*clearZBuffer)(const TQADrawContext *drawContext, const TQARect *rect);
    /* Replaces the contents of a texture; size and type stay. */
    TQAError (*textureUpdate)(TQAUInt32 flags, TQAImagePixelType pixelType,
                              const TQAImage images[], TQATexture *texture);
    TQAError (*bindCodeBook)(TQATexture *texture, void *codeBook); /* not supported */
    TQAError (*getDrawBuffer)(const TQADrawContext *drawContext, TQADevice *buffer);
} ATIRaveExtFuncs;

#ifdef __cplusplus
}
#endif

#endif
