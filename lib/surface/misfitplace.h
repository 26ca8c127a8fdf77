/* misfitplace.h - the line of the misfit that holds the place.  Private to misfit. */
#ifndef MISFITPLACE_H
#define MISFITPLACE_H

#include "misfit.h"

/* The sum of row j of that line. */
double misfit_place_row(const Misfit *m, const double *phi, int j);

/* Adds m->hold times d to g, or m->hold times phi - place if d is NULL. */
void misfit_place_apply(const Misfit *m, const double *phi, const double *d, double *g);

#endif
