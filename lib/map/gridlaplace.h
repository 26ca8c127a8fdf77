/* gridlaplace.h - harmonic coordinates on a gridded surface, by its own metric.
 *
 * The grid phi over its chart, bilinear in every cell, need not be conformal.  Its
 * Dirichlet energy is that of its metric g pulled back to the rectangle, (5):
 *
 *   E(f) = integral  <grad f, A grad f> du dv,    A = sqrt(det g) g^-1,  g = (E F; F G),
 *
 * computed by bilinear elements with 2 x 2 quadrature points in each cell.  The tangents in g are
 * weighted means of differences within the cell and central differences at its corners.  A is the
 * identity where phi is conformal.  On a chart with cones it is also the identity within two and a half steps of
 * a cone, where bilinear elements degenerate, and, gradually, in cells within which the surface turns much
 * (gridcell.h).  doc/mathematics.md 3.7.
 */
#ifndef GRIDLAPLACE_H
#define GRIDLAPLACE_H

#include "../base/chart.h"
#include "gridcell.h"

enum { GRIDLAPLACE_ENOMEM = -1 };

typedef struct GridLaplace {
	Chart   g;
	int     across, down;   /* cells in a row; rows of cells, the folds included, which come last */
	double *cell;           /* [down][across][10] the lower triangle of each cell's 4 x 4 matrix */
} GridLaplace;

/* The matrices of the surface phi[0], phi[1], phi[2], each [nv][nu]; metric is GRIDLAPLACE_CELLS or
 * GRIDLAPLACE_NODES.
 * Returns 0 or GRIDLAPLACE_ENOMEM. */
int  gridlaplace_init(GridLaplace *l, Chart g, double *const phi[3], int metric);
void gridlaplace_free(GridLaplace *l);

/* y = K x, the matrix of E: <x, K x> = E(x).  Across a fold x is odd (chart.h), and E is that of one of
 * both sheets. */
void gridlaplace_apply(const GridLaplace *l, const double *x, double *y);

/* The harmonic coordinate along u (axis 0) or v (axis 1) less the coordinate of the grid, in grid steps;
 * and its energy, of the coordinate from 0 to 1.  On the rectangle it is 0 on the side i = 0 and 1 on i =
 * nu-1 (axis 0), or 0 on j = 0 and 1 on j = nv-1 (axis 1), and free on the other two.  On the sock u grows
 * by 1 round the period and is free at the boundary, v is 1 at the boundary; both are odd under the turns
 * about the cones.  On the pillow u grows by 1 round the period in u, and v by 2 round that of both sheets
 * along v; both are odd under the turns about the cones.  Solved by conjugate gradients, preconditioned by the Laplacian of the plane
 * (planelaplace.h), in at most 420 steps; on grids far from conformal they may not have converged then.
 * Returns 0 or GRIDLAPLACE_ENOMEM. */
int  gridlaplace_shift(const GridLaplace *l, int axis, double *shift, double *energy);

/* E(a,b) of the two coordinates, each from 0 to 1, less which the coordinates of the grid are these shifts; on a folded
 * chart. */
double gridlaplace_product(const GridLaplace *l, const double *shift_u, const double *shift_v);

#endif
