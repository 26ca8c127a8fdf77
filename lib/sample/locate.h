/* locate.h - point location: the triangle of a mapped mesh that contains a point of the chart. */
#ifndef LOCATE_H
#define LOCATE_H

#include "../mesh/mesh.h"

typedef struct Locator {
	const Mesh   *m;
	const double *u, *v;
	const int    *twin;     /* [3*nf] of the disk */
	int          *start;    /* [ny][nx] the chart is divided into cells: a triangle in or near
	                         * each cell, where walks to the points of this cell start */
	int           nx, ny;
	double        T;
	int           corner[4];        /* for each of (0,0), (1,0), (0,T), (1,T): 3*t + k, where
	                                 * corner k of triangle t is mapped there; -1 if none is */
} Locator;

/* Prepares to locate points of [0,1] x [0,T] in d mapped by u, v, which must outlive l.
 * Returns 0 or MESH_ENOMEM. */
int  locator_init(Locator *l, const Disk *d, const double *u, const double *v, double T);
void locator_free(Locator *l);

/* Returns the triangle that contains (x,y) and sets bary to the barycentric coordinates in it, each
 * in 0..1.  The triangle is found by a walk that starts at the triangle of l->start.  If no triangle
 * contains the point, which can happen among triangles that are turned over or flat, returns the
 * one in which the least coordinate is largest, and sets negative coordinates to 0.  If (x,y) is a
 * corner of the chart, the result is the vertex that is mapped exactly there, if there is one;
 * rounding may put other vertices equally near.  May be called from several threads. */
int  locate(const Locator *l, double x, double y, double bary[3]);

/* Like locate, but the walk starts at triangle `from`.  Where triangles are turned over, several may
 * contain the point; the result is then the first of these on the walk. */
int  locate_from(const Locator *l, int from, double x, double y, double bary[3]);

/* Whether triangle t of l->m is turned over or flat in (u,v), or so narrow that the errors of its
 * coordinates may decide this: less than 1e-7 high, in units of the longer side of the chart.  (Near
 * (0,0) even triangles far below 1e-16 have exact areas, near the other corners they do not; so the
 * sign of the area alone would depend on which corner is (0,0).) */
int  locate_is_flat(const Locator *l, int t);

#endif
