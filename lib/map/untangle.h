/* untangle.h - moves vertices in a chart so that no triangle with straight edges is turned over
 * (doc/mathematics.md 3.5). */
#ifndef UNTANGLE_H
#define UNTANGLE_H

#include "../base/chart.h"
#include "../mesh/mesh.h"

enum { UNTANGLE_ENOMEM = -1 };

typedef struct Untangled {
	int    turned;          /* triangles that are still turned over, or so thin that rounding
	                         * leaves their sign open */
	int    moved;           /* vertices that are not at their given places */
	double farthest;        /* the largest distance from the given place */
} Untangled;

/* The chart of the places. */
typedef struct UntangleChart {
	const ChartKind *kind;
	double T;
	int    corner[4];       /* indices into the boundary loop (corners.h): the corners of the rectangle.
	                         * On any chart they decide between vertices, whatever their numbers */
	int    cone[2];         /* the vertices at the cones of a sock */
} UntangleChart;

/* Moves vertices near triangles that are turned over, and few others.  Vertices of a side stay on that
 * side; corners and cones do not move.  On a sock each triangle is drawn on one sheet (sheet_polygon).
 *
 * u, v     in/out  [nv]; first clamped to the chart, and put onto the sides at their vertices
 * r        out
 *
 * Returns 0 or UNTANGLE_ENOMEM. */
int untangle(const Disk *d, const UntangleChart *on, double *u, double *v, Untangled *r);

#endif
