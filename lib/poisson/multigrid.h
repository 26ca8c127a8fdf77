/* multigrid.h - approximate inverse of  A = t K + M  on a chart: one V-cycle of multigrid.
 *
 *   K   the five-point Laplacian times -h k, so that <x, K x> is the Dirichlet integral of x.  An open
 *       side is free, which mirrors the field there, or held: x = 0 on it
 *   M   diagonal: a density >= 0 times the area of the cell of each node, which is h k, and half of
 *       that on free sides and a quarter at free corners
 *
 * Fast transforms (plate.h) do not invert A where the density varies; as a preconditioner they leave a
 * condition number up to the ratio of the largest density to the smallest.  A V-cycle reduces the
 * error about tenfold for any density.  The V-cycle is symmetric and positive definite, so it can serve
 * as a preconditioner of conjugate gradients.  On each grid the error is smoothed by two steps of Jacobi
 * before the coarse correction and two after it (W. Hackbusch, Multi-Grid Methods and Applications,
 * Springer 1985).
 */
#ifndef MULTIGRID_H
#define MULTIGRID_H

#include "multilevel.h"

enum { MULTIGRID_ENOMEM = -1, MULTIGRID_MOST = 32 };

typedef struct Multigrid {
	Chart      g;
	double     t;
	double    *mass;                /* [nv][nu] the diagonal of M; 0 at held nodes */
	int        levels;
	Multilevel level[MULTIGRID_MOST];
	double    *factor;              /* [n][n] Cholesky factor of the coarsest A, in its lower triangle */
} Multigrid;

/* density[nv][nu] >= 0.  With a density of 0 everywhere, the field must be held somewhere.  Then
 * multigrid_set must be called.  Returns 0 or MULTIGRID_ENOMEM; m then holds nothing to free. */
int  multigrid_init(Multigrid *m, Chart g, int held, const double *density);
void multigrid_free(Multigrid *m);

/* Sets t > 0. */
void multigrid_set(Multigrid *m, double t);

/* y = K x and x = (about) A^-1 b, for fields [nv][nu].  At held nodes x and b are not read, and the
 * results are 0.  The results have the same bits for any number of threads. */
void multigrid_stiffness(Multigrid *m, const double *x, double *y);
void multigrid_cycle(Multigrid *m, const double *b, double *x);

#endif
