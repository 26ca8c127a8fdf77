/* untangle.h - removes the last few turned triangles of a map (doc/mathematics.md 3.5). */
#ifndef UNTANGLE_H
#define UNTANGLE_H

#include "../mesh/mesh.h"

enum { UNTANGLE_ENOMEM = -1 };

/* Moves the vertices of triangles whose (u,v) area is negative to the mean of their neighbours,
 * with mean value weights (Floater), which are positive.  If that is not enough, up to seven
 * rings of vertices around them move, too.  Vertices on a side of the rectangle stay on it, corners
 * do not move, and the rest of the map is unchanged.
 *
 * corner   indices into the boundary loop (corners.h)
 * turned   out  triangles of negative area that remain
 *
 * Returns 0 or UNTANGLE_ENOMEM. */
int untangle(const Disk *d, const int corner[4], double *u, double *v, int *turned);

#endif
