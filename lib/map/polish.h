/* polish.h - a nearly conformal grid made conformal.
 *
 * The grid is taken as a surface of its own and mapped conformally once more, by its own
 * metric (gridlaplace.h): a and b, 0..1, harmonic on it, T = sqrt(E(a)/E(b)).  The map
 * (u,v) -> (a, T b) is near the identity; its inverse says where on the old grid each node
 * of the new one lies, and so where in the chart of the mesh, and there the mesh is sampled
 * again (DESIGN section 4).
 */
#ifndef POLISH_H
#define POLISH_H

#include "../sample/sampler.h"

enum { POLISH_ENOMEM = -1 };

/* A surface sampled on a grid, and from where. */
typedef struct Grid {
	Chart   g;
	double *x, *y;          /* [nv][nu] place of each node in the chart of the mesh */
	double *phi[3];         /* [nv][nu] */
} Grid;

/* The grid of g over the whole chart [0,1] x [0,g.T] of s, sampled.  g.nu, g.nv >= 4.
 * Returns 0 or POLISH_ENOMEM. */
int  grid_init(Grid *a, Chart g, const Sampler *s);
void grid_free(Grid *a);

/* At most so many rounds, fewer when they gain nothing more or when the mean modulus of the
 * Beltrami coefficient over the inner nodes is no more than enough; what is kept is the
 * round that has the least mean.  Where the surface turns much within a cell and that mean stays
 * above 4e-3, rounds by the metric of the nodes follow on those by that of the cells.
 *
 * a        in/out
 * pu, pv   in/out  [n] points carried along, in the chart of a; n may be 0
 * done     out     rounds that led to what is kept
 *
 * Returns 0 or POLISH_ENOMEM; a is then some grid that is no worse than it was. */
int polish(const Sampler *s, Grid *a, int rounds, double enough, int n, double *pu, double *pv, int *done);

#endif
