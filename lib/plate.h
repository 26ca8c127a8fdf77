/* plate.h - the operator of a plate under tension on a grid, inverted by sine transforms.
 *
 *   P = a Delta^2 - b Delta,   fields 0 on the border, Delta d = 0 there too,
 *
 * with the five-point Laplacian, whose eigenvectors are the sines: the preconditioner of
 * the surface method (DESIGN section 6).
 */
#ifndef PLATE_H
#define PLATE_H

#include "chart.h"
#include "sine.h"

enum { PLATE_ENOMEM = -1 };

typedef struct Plate {
	Chart     g;
	double   *eigenvalue[2];        /* of minus the second differences along u and v */
	Sine      along_u, along_v;
	double   *work;                 /* of each thread */
} Plate;

/* g has at least 3 nodes in either direction.  Returns 0 or PLATE_ENOMEM; p then holds
 * nothing to free. */
int  plate_init(Plate *p, Chart g);
void plate_free(Plate *p);

/* z = P^-1 z in place, for three fields z[3][nv][nu] that are 0 on the border and stay so:
 * six sine transforms, the unit in which the cost of a reconstruction is counted.  The same
 * bits for any number of threads. */
void plate_solve(const Plate *p, double a, double b, double *z);

#endif
