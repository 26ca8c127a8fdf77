/* scatter.h - evenly spaced random points in a plane domain (Poisson disk sampling). */
#ifndef SCATTER_H
#define SCATTER_H

#include <stdint.h>

enum { SCATTER_ENOMEM = -1 };

typedef struct ScatterRule {
	double x0, x1, y0, y1;          /* a box around the domain */
	double rmin;                    /* the smallest value of dist, or a little less; > 0 */
	double (*dist)(const void *data, double x, double y);   /* least distance of a point
	                                 * at (x,y) from all earlier points */
	int  (*inside)(const void *data, double x, double y);
	const void *data;
} ScatterRule;

typedef struct Points {
	int     n, max;
	double *xy;             /* [max][2], malloc'd; the first n are set */
} Points;

/* Fills the domain with points.  p has the points of the boundary, and the new points are
 * appended.  Around each point, the oldest first, darts are thrown (after Bridson 2007).  All darts
 * land at about the least distance, as Roberts proposed, which packs more evenly than random places
 * in an annulus.  The time is linear in the number of points if dist varies slowly; the memory grows
 * with (dist/rmin)^2.
 *
 * Returns 0 or SCATTER_ENOMEM; the caller frees p->xy in both cases. */
int scatter(const ScatterRule *rule, uint64_t seed, Points *p);

/* Append one point.  Returns 0 or SCATTER_ENOMEM. */
int scatter_add(Points *p, double x, double y);

#endif
