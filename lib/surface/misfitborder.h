/* misfitborder.h - the energy of border nodes where the boundary is free.  Private to misfit.
 *
 * Each border node adds only the residuals of the metric (the third and the fourth line of E, with
 * w/10), and none of Delta phi.  phi_u and phi_v are central differences along the border and
 * one-sided ones across it (stencil.h). */
#ifndef MISFITBORDER_H
#define MISFITBORDER_H

#include "misfit.h"

/* (h^2 + k^2)/2 */
double misfit_step2(Chart g);

/* (lambda/lambda0)^2 at node p, times a constant (round.h). */
double misfit_size2(const Misfit *m, size_t p);

/* The weight o of a node from |grad log(lambda/lambda0)|^2 there. */
double misfit_weight(const Misfit *m, size_t p, double gradient2);

/* Sets o of the border nodes. */
void misfit_border_weights(Misfit *m);

/* The contribution of the border to E.  *worst is set to the node that contributes most, *most to
 * its contribution. */
double misfit_border_energy(const Misfit *m, const double *phi, size_t *worst, double *most);

/* Adds to g what the border nodes contribute to J'J d or, if d is NULL, to J'r. */
void misfit_border_apply(const Misfit *m, const double *phi, const double *d, double *g);

#endif
