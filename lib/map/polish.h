/* polish.h - makes a nearly conformal grid conformal (doc/mathematics.md 3.7).
 *
 * The grid is itself a surface, and is mapped conformally once more, with its own metric
 * (gridlaplace.h): the coordinates a and b, with values 0..1, are harmonic on it, and
 * T = sqrt(E(a)/E(b)).  The map (u,v) -> (a, T b) is near the identity.  Its inverse gives the
 * place of each new node on the old grid, and so in the chart of the mesh; there the mesh is
 * sampled again.
 */
#ifndef POLISH_H
#define POLISH_H

#include "../sample/sampler.h"
#include "chartmap.h"

enum { POLISH_ENOMEM = -1 };

/* A surface sampled on a grid, with the place of each sample. */
typedef struct Grid {
	Chart    g;
	ChartMap map;           /* where places lie on the rectangle of the mesh */
	double *phi[3];         /* [nv][nu] position of each node; one piece of memory, which also holds x and y */
	double *x, *y;          /* [nv][nu] place of each node; NULL on the pillow (pillowgrid.h) */
} Grid;

/* Samples s on the nodes (23) of a chart of nu x nv nodes, nu, nv >= 4; on a sock nu, nv >= 6.  s is over
 * the rectangle of the map.  Returns 0 or POLISH_ENOMEM. */
int  grid_init(Grid *a, const ChartMap *map, int nu, int nv, const Sampler *s);
void grid_free(Grid *a);

/* Polishes the grid in at most `rounds` rounds.  Stops earlier if rounds gain nothing more, or if
 * the mean modulus of the Beltrami coefficient over the inner nodes is at most `enough`.  The round
 * with the smallest mean is kept.  If the mean stays above 4e-3 (surfaces that turn much within a cell), rounds with the cell metric are followed by rounds with the node metric.  If it is above
 * .05 after one round, the grid has too few cells for the surface, and stays as it is.
 *
 * a        in/out
 * pu, pv   in/out  [n] points that move with the grid, in the chart of a; n may be 0
 * done     out     the number of the round that is kept; 0: the given grid is kept
 *
 * Returns 0 or POLISH_ENOMEM; a is then a grid no worse than the given one. */
int polish(const Sampler *s, Grid *a, int rounds, double enough, int n, double *pu, double *pv,
	int *done);

#endif
