/* plate.h - the operator of a plate under tension on a grid, inverted by fast transforms.
 *
 *   P = a Delta^2 - b Delta,   fields 0 on the border, Delta d = 0 there too,
 *
 * with the five-point Laplacian, whose eigenvectors are the sines: the preconditioner of
 * the surface method (DESIGN section 6).  Where the border is free,
 *
 *   P = W (a Delta^2 - b Delta + c),   Delta of the fields mirrored at the border,
 *
 * whose eigenvectors are the cosines; W is 1/2 on the border, 1/4 in the corners, so that P is
 * symmetric, and c is b times the least eigenvalue of -Delta that is not 0: constants, of
 * which the misfit says nothing, are held as the longest waves are.
 */
#ifndef PLATE_H
#define PLATE_H

#include "../base/chart.h"
#include "cosine.h"
#include "sine.h"

enum { PLATE_ENOMEM = -1 };

typedef struct Plate {
	Chart     g;
	double   *eigenvalue[2];        /* of minus the second differences along u and v */
	int       free;                 /* cosines, else sines */
	Sine      sine[2];              /* along u and v */
	Cosine    cosine[2];
	double   *work;                 /* of each thread */
} Plate;

/* g has at least 3 nodes in either direction.  Returns 0 or PLATE_ENOMEM; p then holds
 * nothing to free. */
int  plate_init(Plate *p, Chart g, int free);
void plate_free(Plate *p);

/* z = P^-1 z in place, for three fields z[3][nv][nu] that are 0 on the border and stay so,
 * unless it is free: six sine (cosine) transforms, the unit in which the cost of a reconstruction is counted.  The same
 * bits for any number of threads. */
void plate_solve(const Plate *p, double a, double b, double *z);

#endif
