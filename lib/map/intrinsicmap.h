/* intrinsicmap.h - the conformal map of any disk onto a rectangle, with no triangle turned over.
 *
 * The harmonic functions are solved on the intrinsic Delaunay triangulation of the surface
 * (../intrinsic), whose cotangent weights are not negative.  With such weights the harmonic map
 * onto a rectangle, continued by reflection in the sides, is an embedding (doc/mathematics.md 3.6).
 */
#ifndef INTRINSICMAP_H
#define INTRINSICMAP_H

#include "adapt.h"
#include "intrinsicsolve.h"

enum { INTRINSICMAP_CROSSINGS = 4 };

/* Splits edges until the triangulation can be embedded, and then where the terms of the certificate
 * are largest.  This ends when the certificate is at most options->tolerance, or when there are
 * about options->most vertices, or INTRINSICMAP_CROSSINGS*options->most crossings of mesh edges
 * with edges of the triangulation.  Near a vertex with many edges there are far more crossings than
 * vertices.
 *
 * vertex: the corners, as vertex numbers.  Returns 0, SPD_ENOMEM or SPD_EINDEFINITE; on an error m
 * holds nothing to free. */
int  intrinsic_map(const Disk *d, const int vertex[4], const AdaptOptions *options, IntrinsicMap *m,
	SpdReport *report);
void intrinsic_map_free(IntrinsicMap *m);

#endif
