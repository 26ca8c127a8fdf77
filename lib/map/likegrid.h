/* likegrid.h - a closed gridded surface as a function on the sphere of its pillow. */
#ifndef LIKEGRID_H
#define LIKEGRID_H

#include "../base/chart.h"
#include "../base/pillowplane.h"
#include "likepoints.h"

typedef struct LikeGrid {
	Chart       g;
	PillowPlane plane;
	double     *phi[3];     /* [nv][nu] (position - mean)/radius; one piece of memory */
	LikePoints  points;     /* of the surface, on the same sphere */
} LikeGrid;

/* phi on the pillow g, nu, nv >= 6, and n of its points.  Returns as likepoints_init. */
int  likegrid_init(LikeGrid *a, Chart g, const double *const phi[3], int n);
void likegrid_free(LikeGrid *a);

/* x: the point of the surface at w, of norm 1.  slope: its derivatives by the real and the imaginary part of the place in
 * the plane in which w is at 0 (moebius.h). */
void likegrid_point(const LikeGrid *a, const Spinor w, double x[3]);
void likegrid_slopes(const LikeGrid *a, const Spinor w, double slope[2][3]);

#endif
