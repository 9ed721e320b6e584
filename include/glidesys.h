/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * glidesys.h: how many texture units a vertex carries coordinates for.
 *
 * The library strides arrays of GrVertex by 60 bytes, which is the size with
 * two units. Other values change the size of GrVertex and are only of use to
 * programs that pass single vertices.
 */
#ifndef FILLRATE_GLIDESYS_H
#define FILLRATE_GLIDESYS_H

#ifndef GLIDE_NUM_TMU
#define GLIDE_NUM_TMU 2
#endif

#if GLIDE_NUM_TMU < 1 || GLIDE_NUM_TMU > 3
#error "GLIDE_NUM_TMU must be 1, 2 or 3"
#endif

/* The chipset these headers describe: Voodoo Graphics. */
#ifndef SST1
#define SST1 1
#endif

#endif /* FILLRATE_GLIDESYS_H */
