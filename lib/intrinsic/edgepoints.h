/* edgepoints.h - points on the edges of an intrinsic triangulation, as points of its mesh. */
#ifndef EDGEPOINTS_H
#define EDGEPOINTS_H

#include "intrinsic.h"

/* A growing list; begins as { 0 }.  The caller frees point. */
typedef struct EdgePoints {
	SurfacePoint *point;
	int           n, room;
} EdgePoints;

/* Adds the middles of the marked edges.  marked: [t->ne], 0 or 1.  Returns 0 or INTRINSIC_ENOMEM. */
int edgepoints_middles(const Intrinsic *t, const Disk *mesh, const unsigned char *marked,
	EdgePoints *points);

/* Adds the feet of obtuse angles opposite to boundary edges, as points of these edges: with such an
 * angle, the triangulation and its mirror image beyond the boundary are together not Delaunay.
 * Returns 0 or INTRINSIC_ENOMEM. */
int edgepoints_feet(const Intrinsic *t, EdgePoints *points);

#endif
