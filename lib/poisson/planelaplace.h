/* planelaplace.h - solves the Poisson equation on a plane grid by fast transforms.
 *
 * P is the stiffness matrix of bilinear elements on [0,1] x [0,T].  On the rectangle:  Values are 0 on the two sides
 * at the ends of one axis and free on the other two sides.  The eigenvectors are sines along this
 * axis and cosines along the other.  On the sock, fields are odd (chart.h): axis 0 makes v = T free,
 * axis 1 makes them 0 there; the eigenvectors are sines and cosines along u, on the doubled grid
 * -T <= v <= T cosines or sines along v.  On the pillow fields are odd, too, and no node is held: the
 * doubled grid is periodic both ways.  P is the preconditioner of the polish
 * (doc/mathematics.md 3.7).
 */
#ifndef PLANELAPLACE_H
#define PLANELAPLACE_H

#include <fftw3.h>

#include "../base/chart.h"

enum { PLANELAPLACE_ENOMEM = -1 };

typedef struct PlaneLaplace {
	Chart     g;
	int       axis;                 /* 0: nodes i = 0, nu-1 are held at 0; 1: j = 0, nv-1; on the
	                                 * sock 1: j = nv-1; on the pillow either */
	int       i0, j0, n[2];         /* the free nodes: n[0] from i0 along u, n[1] from j0; on the
	                                 * sock and the pillow those of the doubled grid, whose row 0 is j = -nv */
	double   *work;                 /* [n[1]][n[0]] */
	double   *stiff[2], *mass[2];   /* [n[axis]] eigenvalues of the 1D matrices */
	fftw_plan plan[2];              /* forward and back */
} PlaneLaplace;

/* Returns 0, or PLANELAPLACE_ENOMEM with nothing in p to free. */
int  planelaplace_init(PlaneLaplace *p, Chart g, int axis);
void planelaplace_free(PlaneLaplace *p);

/* z = P^-1 r on the free nodes, and z = 0 on the held ones; r and z are [nv][nu]. */
void planelaplace_solve(const PlaneLaplace *p, const double *r, double *z);

#endif
