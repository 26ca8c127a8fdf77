/* sortpoints.h - sorts points of a disk by triangle and by edge. */
#ifndef SORTPOINTS_H
#define SORTPOINTS_H

#include "subdivision.h"

/* A point on an edge: `place` 0..1 from the start of the side. */
typedef struct EdgePoint {
	int    side;
	double place;
} EdgePoint;

/* Points within triangles, ordered by triangle; and points on edges, ordered by edge, then along
 * it. */
typedef struct Sorted {
	SurfacePoint *within;
	EdgePoint    *on;
	int           nwithin, non;
} Sorted;

/* Sorts n points of d.  Of points on an edge whose places differ by less than 1e-9 one is kept;
 * points at a vertex are dropped.  Returns 0 or MESH_ENOMEM; the arrays of s are to be freed in
 * both cases. */
int sort_points(const Disk *d, int n, const SurfacePoint *point, Sorted *s);

#endif
