/* flips.h - the Delaunay triangulation of a surface, by flips of intrinsic edges. */
#ifndef FLIPS_H
#define FLIPS_H

#include "intrinsic.h"

/* Flips the edges of s that lie within faces of its given disk until they are Delaunay.  The
 * surface stays the same, and fewer edges of s cross the edges of its intrinsic Delaunay
 * triangulation.
 *
 * key  in  as for intrinsic_delaunay
 *
 * Returns 0 or INTRINSIC_ENOMEM. */
int  intrinsic_improve(Subdivision *s, const double *key);

/* Flips edges until the triangulation is Delaunay: the two angles opposite to an inner edge sum to
 * at most pi.  If the four vertices of its two triangles lie on a circle, both diagonals are
 * Delaunay.  Then the diagonal is chosen on which the key, interpolated linearly, is smaller where
 * the two cross, so that the result does not depend on the numbering.
 *
 * key  in  [nv] a number for each vertex, not a linear function of position on any four such
 *          vertices; or NULL: either diagonal may remain
 *
 * Stops after 20 flips per triangle plus 200000, since rounding could make flips go on for ever.
 * Returns 0 or INTRINSIC_ENOMEM. */
int  intrinsic_delaunay(Intrinsic *t, const double *key);

#endif
