/* untangle.h - a map without turned triangles, where a few are left. */
#ifndef UNTANGLE_H
#define UNTANGLE_H

#include "../mesh/mesh.h"

enum { UNTANGLE_ENOMEM = -1 };

/* Move the vertices of triangles whose (u,v) area is negative, and as many rings around
 * them as it takes, up to a few, each to the mean of its neighbours by mean value weights
 * (Floater), which are positive; vertices on a side of the rectangle stay on it, corners
 * stay.  The rest of the map is left as it is.
 *
 * corner   places in the boundary loop, as corners.h gives them
 * turned   out  triangles of negative area that are left
 *
 * Returns 0 or UNTANGLE_ENOMEM. */
int untangle(const Disk *d, const int corner[4], double *u, double *v, int *turned);

#endif
