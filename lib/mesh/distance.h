/* distance.h - distances of two surfaces, and self-intersections (CGAL). */
#ifndef DISTANCE_H
#define DISTANCE_H

#include "mesh.h"

#ifdef __cplusplus
extern "C" {
#endif

enum {
	DISTANCE_ENOMEM = -1,
	DISTANCE_EAREA  = -2,   /* all faces have zero area */
	DISTANCE_EEDGE  = -3,   /* an edge of three faces, or neighbours of opposite orientation */
	DISTANCE_ECGAL  = -4    /* CGAL failed */
};

/* Maximum and mean distance between vertex i of a and vertex i of b; both must have equally many
 * vertices. */
void distance_vertices(const Mesh *a, const Mesh *b, double *max, double *mean);

/* The symmetric Hausdorff distance between two surfaces: the largest distance from a point of one
 * surface to the other surface, over all points of the faces, not only the vertices.  Faces without
 * area are left out.  Coordinates must be finite.
 *
 * error  in   > 0, in the unit of length.  If the surfaces are farther apart than this, the
 *             time depends on their sizes only; otherwise it grows as 1/error: two
 *             triangulations of one plane, of 5000 and 6000 vertices, took 0.2, 2 and
 *             29 s for an error of 1e-2, 1e-3 and 1e-4 of the square root of the area
 * d      out  the distance, up to +-error.  0 if both have the same faces.  If all that is known is
 *             that the distance is at most `error`, d is `error`
 *
 * Returns 0, DISTANCE_ENOMEM, DISTANCE_EAREA or DISTANCE_ECGAL. */
int distance_hausdorff(const Mesh *a, const Mesh *b, double error, double *d);

/* Sets *pairs to the number of pairs of faces that intersect in more than the vertices or the edge
 * that they share.  A vertex is shared if it has the same number in both faces.  Faces without area
 * are left out.
 *
 * Returns 0, DISTANCE_ENOMEM, DISTANCE_EEDGE or DISTANCE_ECGAL. */
int distance_crossings(const Mesh *m, long *pairs);

#ifdef __cplusplus
}
#endif

#endif
