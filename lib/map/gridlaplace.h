/* gridlaplace.h - harmonic functions on a gridded surface, by its own metric.
 *
 * The grid phi over [0,1] x [0,T], bilinear in every cell, need not be conformal.  Its
 * Dirichlet energy is that of its metric g pulled back to the rectangle, (5):
 *
 *   E(f) = integral  <grad f, A grad f> du dv,    A = sqrt(det g) g^-1,  g = (E F; F G),
 *
 * computed by bilinear elements with 2 x 2 quadrature points in each cell.  The tangents in g are
 * weighted means of differences within the cell and central differences at its corners.  A is the
 * identity where phi is conformal.  doc/mathematics.md 3.7.
 */
#ifndef GRIDLAPLACE_H
#define GRIDLAPLACE_H

#include "../base/chart.h"

enum { GRIDLAPLACE_ENOMEM = -1 };

enum {
	GRIDLAPLACE_CELLS,      /* metric at Gauss points, central differences with weight 0.5 */
	GRIDLAPLACE_NODES       /* metric at the corners of the cells, central differences with
	                         * weight 0.9: nearly the metric of lambda and H (lambdah.h) */
};

typedef struct GridLaplace {
	Chart   g;
	double *cell;           /* [cells][10] the lower triangle of each cell's 4 x 4 matrix */
} GridLaplace;

/* The matrices of the surface phi[0], phi[1], phi[2], each [nv][nu]; metric is GRIDLAPLACE_CELLS or
 * GRIDLAPLACE_NODES.
 * Returns 0 or GRIDLAPLACE_ENOMEM. */
int  gridlaplace_init(GridLaplace *l, Chart g, double *const phi[3], int metric);
void gridlaplace_free(GridLaplace *l);

/* y = K x, the matrix of E: <x, K x> = E(x). */
void gridlaplace_apply(const GridLaplace *l, const double *x, double *y);

/* The harmonic f that is 0 on the side i = 0 and 1 on i = nu-1 (axis 0), or 0 on j = 0 and 1
 * on j = nv-1 (axis 1), free on the other two; and its energy.  Solved by conjugate gradients,
 * preconditioned by the Laplacian of the plane (planelaplace.h), in at most 200 steps; on grids far
 * from conformal they may not have converged then.  Returns 0 or GRIDLAPLACE_ENOMEM. */
int  gridlaplace_harmonic(const GridLaplace *l, int axis, double *f, double *energy);

#endif
