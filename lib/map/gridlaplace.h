/* gridlaplace.h - harmonic functions on a gridded surface, by its own metric.
 *
 * The grid phi over [0,1] x [0,T], bilinear in every cell, need not be conformal.  Its
 * Dirichlet energy is that of its metric g pulled back to the rectangle, (5):
 *
 *   E(f) = integral  <grad f, A grad f> du dv,    A = sqrt(det g) g^-1,  g = (E F; F G),
 *
 * by bilinear elements and 2 x 2 points a cell; the tangents in g are means of cell and central
 * differences.  A is the identity where phi is conformal.  doc/mathematics.md 3.7.
 */
#ifndef GRIDLAPLACE_H
#define GRIDLAPLACE_H

#include "../base/chart.h"

enum { GRIDLAPLACE_ENOMEM = -1 };

enum {
	GRIDLAPLACE_CELLS,      /* at Gauss points, half central differences */
	GRIDLAPLACE_NODES       /* at corners, 0.9 central differences: nearly the metric from
	                         * which lambda and H are computed */
};

typedef struct GridLaplace {
	Chart   g;
	double *cell;           /* [cells][10] the lower triangle of each cell's 4 x 4 matrix */
} GridLaplace;

/* The matrices of the surface phi[0], phi[1], phi[2], each [nv][nu], for one of these metrics.
 * Returns 0 or GRIDLAPLACE_ENOMEM. */
int  gridlaplace_init(GridLaplace *l, Chart g, double *const phi[3], int metric);
void gridlaplace_free(GridLaplace *l);

/* y = K x, the matrix of E: <x, K x> = E(x). */
void gridlaplace_apply(const GridLaplace *l, const double *x, double *y);

/* The harmonic f that is 0 on the side i = 0 and 1 on i = nu-1 (axis 0), or 0 on j = 0 and 1
 * on j = nv-1 (axis 1), free on the other two; and its energy.  Conjugate gradients,
 * preconditioned by the Laplacian of the plane (planelaplace.h).  They stop after 200 steps
 * at the latest, on grids far from conformal before they have converged.  Returns 0 or
 * GRIDLAPLACE_ENOMEM. */
int  gridlaplace_harmonic(const GridLaplace *l, int axis, double *f, double *energy);

#endif
