/* platepriv.h - the plate on each kind of chart.  Private to plate.h. */
#ifndef PLATEPRIV_H
#define PLATEPRIV_H

#include "plate.h"

/* The eigenvalues of the negative second difference for waves of first .. first + n-1 cycles in
 * `period` steps.  NULL if there is no memory. */
double *plate_eigenvalues(int n, int first, double period, double step);

/* The sock: platefold.c. */
int  platefold_init(Plate *p);
void platefold_solve(const Plate *p, double a, double b, double c, double *z);

#endif
