/* flips.h - the Delaunay triangulation of a surface, by flips of intrinsic edges. */
#ifndef FLIPS_H
#define FLIPS_H

#include "intrinsic.h"

/* Flips the edges of s within faces of its given disk until they are Delaunay there.  The surface
 * stays the same, and fewer edges of s cross those of its intrinsic Delaunay triangulation.  Returns
 * 0 or INTRINSIC_ENOMEM. */
int  intrinsic_improve(Subdivision *s, const double *key);

/* Flips edges until the triangulation is Delaunay: the two angles opposite to an inner edge sum to
 * at most pi.  Of four vertices on a circle either diagonal is Delaunay.  Then the one is taken on
 * which the keys, continued linearly, are smaller where both cross: so the result does not depend on
 * the numbering.
 *
 * key  in  [nv] in general position: not linear along the surface; or NULL
 *
 * Ends after 20 flips per triangle and 200000 more, should rounding prevent an end.
 * Returns 0 or INTRINSIC_ENOMEM. */
int  intrinsic_delaunay(Intrinsic *t, const double *key);

#endif
