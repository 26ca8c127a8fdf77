/* untangle.h - moves vertices in the rectangle so that no triangle with straight edges is turned over
 * (doc/mathematics.md 3.5). */
#ifndef UNTANGLE_H
#define UNTANGLE_H

#include "../mesh/mesh.h"

enum { UNTANGLE_ENOMEM = -1 };

typedef struct Untangled {
	int    turned;          /* triangles that are still turned over, or so thin that rounding
	                         * leaves their sign open */
	int    moved;           /* vertices that are not at their given places */
	double farthest;        /* the largest distance from the given place */
} Untangled;

/* Moves vertices near triangles that are turned over, and few others.  Vertices of a side stay on that
 * side; corners do not move.
 *
 * corner   indices into the boundary loop (corners.h)
 * T        height of the rectangle
 * u, v     in/out  [nv]; first clamped to the rectangle, and put onto the sides at their vertices
 * r        out
 *
 * Returns 0 or UNTANGLE_ENOMEM. */
int untangle(const Disk *d, const int corner[4], double T, double *u, double *v, Untangled *r);

#endif
