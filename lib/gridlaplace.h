/* gridlaplace.h - harmonic functions on a gridded surface, by its own metric.
 *
 * The grid phi over [0,1] x [0,T], bilinear in every cell, need not be conformal: its
 * Dirichlet energy is that of the conformal structure pulled back,
 *
 *   E(f) = integral  <grad f, A grad f> du dv,    A = sqrt(det g) g^-1,  g = (E F; F G),
 *
 * by bilinear elements and their corners as points of quadrature, so that on a conformal grid
 * it is the five-point Laplacian; the tangents in g are a mean of central differences, which
 * do not see the odd-even mode, and of those along the sides of each cell.  A is the
 * identity where phi is conformal
 * (DESIGN section 4, polish).
 */
#ifndef GRIDLAPLACE_H
#define GRIDLAPLACE_H

#include "chart.h"

enum { GRIDLAPLACE_ENOMEM = -1 };

typedef struct GridLaplace {
	Chart   g;
	double *cell;           /* [cells][10] the lower triangle of each cell's 4 x 4 matrix */
} GridLaplace;

/* The matrices of phi[0], phi[1], phi[2], each [nv][nu]; central is the part that central
 * differences have in the tangents, 0..1.  Returns 0 or GRIDLAPLACE_ENOMEM. */
int  gridlaplace_init(GridLaplace *l, Chart g, double *const phi[3], double central);
void gridlaplace_free(GridLaplace *l);

/* y = K x, the matrix of E: <x, K x> = E(x). */
void gridlaplace_apply(const GridLaplace *l, const double *x, double *y);

/* f harmonic, 0 on the side i = 0 and 1 on i = nu-1 (axis 0), or the same between j = 0
 * and j = nv-1 (axis 1), free on the other two; its energy.  Conjugate gradients,
 * preconditioned by the Laplacian of the plane, which sine transforms along the axis and
 * cosine transforms across it invert; where the grid is far from conformal they stop
 * after 200 steps with what they have.  Returns 0 or GRIDLAPLACE_ENOMEM. */
int  gridlaplace_harmonic(const GridLaplace *l, int axis, double *f, double *energy);

#endif
