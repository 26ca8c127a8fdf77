/* edgepoints.h - points on the edges of an intrinsic triangulation, given as points of the mesh. */
#ifndef EDGEPOINTS_H
#define EDGEPOINTS_H

#include "intrinsic.h"

/* A growing list of points.  Initialise it to { 0 }; the caller frees point. */
typedef struct EdgePoints {
	SurfacePoint *point;
	int           n, room;
} EdgePoints;

/* Adds the midpoints of the marked edges that are longer than INTRINSIC_SHORTEST.  marked: [t->ne],
 * 0 or 1.  Returns 0 or INTRINSIC_ENOMEM. */
int edgepoints_middles(const Intrinsic *t, const Disk *mesh, const unsigned char *marked,
	EdgePoints *points);

/* For each boundary edge with an obtuse angle opposite to it, adds the foot of the perpendicular
 * from that corner to the edge.  With such an angle, the triangulation together with its mirror
 * image beyond the boundary would not be Delaunay.  Edges up to INTRINSIC_SHORTEST and feet within 1 %
 * of an end of the edge are left out.  Returns 0 or INTRINSIC_ENOMEM. */
int edgepoints_feet(const Intrinsic *t, EdgePoints *points);

#endif
