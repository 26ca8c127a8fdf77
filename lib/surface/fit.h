/* fit.h - the surface of least misfit on one grid, by Gauss and Newton.
 *
 * Each step solves  J'J d = -J'r  by conjugate gradients, preconditioned by the plate
 * (plate.h) and cut off at the border of a trust region (Steihaug), whose radius follows
 * how well E agrees with what was foretold.
 */
#ifndef FIT_H
#define FIT_H

#include "misfit.h"
#include "../poisson/plate.h"

enum { FIT_ENOMEM = -1 };

/* How far it is: after each step, and at the end. */
typedef struct FitProgress {
	int    nu, nv, step;
	double energy, change;          /* E; root mean square of d over sqrt(area) */
	long   solves;                  /* of the plate, on this grid */
	double cost;                    /* those of all grids, in ones of the finest */
	size_t worst;                   /* the node of the largest residual, of a failure */
} FitProgress;

typedef struct FitOptions {
	double tolerance;               /* of change: smaller, and it has converged */
	int    most;                    /* steps */
	int    sharpen;                 /* make w and alpha follow the data */
	void (*report)(void *ctx, const FitProgress *at);       /* or NULL */
	void  *ctx;
} FitOptions;

/* m       in      the misfit, whose w and alpha are set here
 * phi     in/out  [3][nv][nu]: a start; the border is held unless it is free (m->free)
 * at      out     of the last step; its cost is added to
 *
 * At first w = 30 and alpha = 1, which converges from afar and leaves no wrinkles where
 * lambda and H belong to no surface.  To sharpen is to look how far the metric of the surface
 * is from lambda^2, and where that is little, so that they do belong to one, to go to w = 100
 * and alpha = 0.1: then what is not conformal about the grid weighs less (README, the surface
 * method).  Where it is little at once that is done at once; else it is looked again after
 * every step, and a part of the way is gone when the energy no longer falls steeply.
 *
 * Returns 1 if it converged, 0 if it did not in so many steps, or FIT_ENOMEM. */
int fit(Misfit *m, const FitOptions *o, double *phi, FitProgress *at);

#endif
