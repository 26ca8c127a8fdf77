/* misfitborder.h - what the border nodes add where the boundary is free.  Private to misfit.
 *
 * Each adds the residuals of the metric, the third and the fourth line of E with w/10; nothing is
 * said of Delta phi there.  phi_u and phi_v are central along the border, one-sided across it:
 * (-3 f0 + 4 f1 - f2)/2 over the step, which is of second order too. */
#ifndef MISFITBORDER_H
#define MISFITBORDER_H

#include "misfit.h"

/* The square of a step, that of the longer one where they differ much. */
double misfit_step2(Chart g);

/* The weight o of a node from |grad log lambda|^2 there. */
double misfit_weight(const Misfit *m, size_t p, double gradient2);

/* Sets o of the border nodes. */
void misfit_border_weights(Misfit *m);

/* The part of E of all border nodes; the one that has the most of it, and how much. */
double misfit_border_energy(const Misfit *m, const double *phi, size_t *worst, double *most);

/* g += the part of the border nodes in J'J d; without d, in J'r. */
void misfit_border_apply(const Misfit *m, const double *phi, const double *d, double *g);

#endif
