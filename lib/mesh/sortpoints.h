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

/* Sorts n points of d.  Points at a vertex are dropped.  If the places of points on an edge differ
 * by less than 1e-9, one of them is kept.  Returns 0 or MESH_ENOMEM; the arrays of s are to be
 * freed in both cases. */
int sort_points(const Disk *d, int n, const SurfacePoint *point, Sorted *s);

#endif
