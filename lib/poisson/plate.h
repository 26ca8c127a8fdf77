/* plate.h - solves the equation of a plate under tension on a grid by fast transforms.
 *
 *   P = a Delta^2 - b Delta + c   for fields d with d = 0 and Delta d = 0 on the border,
 *
 * where Delta is the five-point Laplacian.  Its eigenvectors are products of sines.  P is the
 * preconditioner of the surface method (doc/mathematics.md 6.4).  With a free border,
 *
 *   P = W (a Delta^2 - b Delta + c + c0)   with the fields mirrored at the border.
 *
 * The eigenvectors are products of cosines, along u on the sock of cosines and sines.  The pillow has no
 * border and is always solved like this, with waves cos(2 pi m u + pi n v/T).  W is diagonal:
 * 1/4 in the corners, 1/2 on the rest of the border, 1 inside; it makes P symmetric.  c0 is b times the smallest positive eigenvalue of
 * -Delta; it makes P positive definite.  Constants are then treated like the longest waves, which
 * is harmless, since the misfit does not change when a constant is added to a field.
 */
#ifndef PLATE_H
#define PLATE_H

#include "../base/chart.h"
#include "transform.h"

enum { PLATE_ENOMEM = -1 };

typedef struct Plate {
	Chart     g;
	double   *eigenvalue[2];        /* of the negative second differences along u and v */
	int       free;                 /* 1: free border, cosines; 0: held border, sines */
	Transform transform[2];         /* along u and v; on the sock along v, on the pillow none, and [0]
	                                 * has the sines and cosines along u */
	fftw_plan plan[2];              /* on the sock and the pillow: along u, forward and back */
	fftw_plan column[2];            /* on the pillow: along v */
	double   *work;                 /* the workspaces of all threads */
} Plate;

/* g has at least 3 nodes in each direction.  Returns 0, or PLATE_ENOMEM with nothing in p to
 * free. */
int  plate_init(Plate *p, Chart g, int free);
void plate_free(Plate *p);

/* On a sock or a pillow: the nearest numbers of nodes for which plate_solve is fast (transform.h), an even number of
 * columns.  On a rectangle: g. */
Chart plate_fast(Chart g);

/* z = P^-1 z in place, for three fields z[3][nv][nu].  On a held border z must be 0, and remains 0.
 * The cost is six sine (cosine) transforms: one vector Poisson solve, the unit in which the cost of
 * a reconstruction is counted.  The result has the same bits for any number of threads. */
void plate_solve(const Plate *p, double a, double b, double c, double *z);

#endif
