/* planelaplace.h - the Laplacian of the plane on a grid, inverted by fast transforms.
 *
 * Bilinear elements on [0,1] x [0,T]; values are 0 on the two sides across one axis and
 * free on the other two.  The eigenvectors are sines along the axis and cosines across it.
 * The operator is the preconditioner of the polish (doc/mathematics.md 3.7).
 */
#ifndef PLANELAPLACE_H
#define PLANELAPLACE_H

#include <fftw3.h>

#include "../base/chart.h"

enum { PLANELAPLACE_ENOMEM = -1 };

typedef struct PlaneLaplace {
	Chart     g;
	int       axis;                 /* 0: held at i = 0 and nu-1; 1: at j = 0 and nv-1 */
	int       i0, j0, n[2];         /* the free nodes: n[0] from i0 along u, n[1] from j0 */
	double   *work;                 /* [n[1]][n[0]] */
	double   *stiff[2], *mass[2];   /* eigenvalues of the one-dimensional matrices */
	fftw_plan plan;
} PlaneLaplace;

/* Returns 0 or PLANELAPLACE_ENOMEM; p then holds nothing to free. */
int  planelaplace_init(PlaneLaplace *p, Chart g, int axis);
void planelaplace_free(PlaneLaplace *p);

/* z = P^-1 r on the free nodes, 0 on held ones; r and z are [nv][nu]. */
void planelaplace_solve(const PlaneLaplace *p, const double *r, double *z);

#endif
