/* scatter.h - evenly spaced random points in a plane domain (Poisson disk sampling). */
#ifndef SCATTER_H
#define SCATTER_H

#include <stdint.h>

enum { SCATTER_ENOMEM = -1 };

typedef struct ScatterRule {
	double x0, x1, y0, y1;          /* a box around the domain */
	double rmin;                    /* the smallest value of dist, or a little less; > 0 */
	double (*dist)(const void *data, double x, double y);   /* least distance of a point
	                                 * at (x,y) from all before it */
	int  (*inside)(const void *data, double x, double y);
	const void *data;
} ScatterRule;

typedef struct Points {
	int     n, max;
	double *xy;             /* [max][2], malloc'd; the first n are set */
} Points;

/* Grow points from those in p (the boundary of the domain) until none fits, by throwing
 * darts around each point, the oldest first (after Bridson 2007; all tries at about the
 * least distance, as Roberts proposed, pack more evenly than a random annulus).  Linear
 * in the number of points if dist varies slowly; memory grows with (dist/rmin)^2.
 *
 * Appends to p and returns 0, or SCATTER_ENOMEM; p remains the caller's to free. */
int scatter(const ScatterRule *rule, uint64_t seed, Points *p);

/* Append one point.  Returns 0 or SCATTER_ENOMEM. */
int scatter_add(Points *p, double x, double y);

#endif
