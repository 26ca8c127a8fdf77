/* fitsolve.h - the linear system of a Gauss-Newton step.  Private to fit.
 *
 * J'J d = -J'r, by conjugate gradients preconditioned by the plate, in a trust region.  The
 * unresolved nodes are deflated (patch.h). */
#ifndef FITSOLVE_H
#define FITSOLVE_H

#include "../poisson/plate.h"
#include "misfit.h"
#include "patch.h"

typedef struct FitSolve {
	Misfit *m;
	const double *phi;              /* the surface at which J is taken */
	Plate   plate;
	size_t  n;                      /* numbers in a vector */
	double *r, *z, *p, *q, *d, *y;  /* residual, preconditioned residual, direction,
	                                 * J'J p, step, trial surface */
	Patch   patch;
	int     deflate;                /* the patch is solved directly in this step */
	int     steps;                  /* Gauss-Newton steps before this one */
	double  tolerance;
	int     error;                  /* 0 or FIT_ENOMEM */
	double  radius;                 /* of the trust region, in the norm of the plate */
	int     near;                   /* the last step was short, not cut, and E fell as predicted */
	long    solves;
} FitSolve;

/* Returns 0 or FIT_ENOMEM; k then holds nothing to free. */
int  fitsolve_init(FitSolve *k, Misfit *m);
void fitsolve_free(FitSolve *k);

/* Computes the step d at phi, where the energy is E.  On entry k->r is the negative gradient; it is
 * overwritten.  Returns the predicted decrease of E.  *length is |d| in the norm of the plate;
 * *spent is set if CG reached its limit of steps.  After a failure k->error is set. */
double fitsolve(FitSolve *k, const double *phi, double E, double *length, int *spent);

#endif
