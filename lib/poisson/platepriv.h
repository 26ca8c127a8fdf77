/* platepriv.h - the plate on each kind of chart.  Private to plate.h. */
#ifndef PLATEPRIV_H
#define PLATEPRIV_H

#include <math.h>
#include <stdlib.h>

#include "plate.h"

/* The eigenvalues of the negative second difference for waves of first .. first + n-1 cycles in
 * `period` steps.  NULL if there is no memory. */
static inline double *
plate_eigenvalues(int n, int first, double period, double step)
{
	double *e = malloc(n*sizeof *e);
	int k;

	for (k = 0; e && k < n; k++)
		e[k] = (2 - 2*cos(2*M_PI*(k + first)/period))/(step*step);
	return e;
}

/* The sock and the pillow: platefold.c. */
int  platefold_init(Plate *p);
void platefold_solve(const Plate *p, double a, double b, double c, double *z);

#endif
