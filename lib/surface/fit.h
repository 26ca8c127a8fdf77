/* fit.h - the surface of least misfit on one grid, by Gauss-Newton steps.
 *
 * Each step solves  J'J d = -J'r  by conjugate gradients, preconditioned by the plate (plate.h),
 * with the unresolved nodes solved directly (patch.h), and stopped at the border of a trust region
 * (cg.h), whose radius is adapted to the ratio of the actual to the predicted decrease of E.
 * doc/mathematics.md 6.4.
 */
#ifndef FIT_H
#define FIT_H

#include "misfit.h"
#include "../poisson/plate.h"

enum { FIT_ENOMEM = -1 };

/* Why the steps ended. */
enum {
	FIT_CONVERGED = 1,      /* the last step was small, or was predicted to lower E hardly */
	FIT_CREPT               /* the last ten steps hardly lowered E, or moved the surface by less than
	                         * the tolerance in all, but the last was shortened: the surface may
	                         * still be far from that of least E */
};

/* Progress, after each step and at the end. */
typedef struct FitProgress {
	int    nu, nv, step;
	double energy, change;          /* E; root mean square displacement over sqrt(area) */
	int    stopped;                 /* FIT_CONVERGED, FIT_CREPT, or 0: not yet */
	double crept;                   /* with FIT_CREPT: the sum of the changes of the last ten steps */
	double misfit;                  /* at the end: E with w = 100 and alpha = 0.1, whatever the weights of the
	                                 * fit, over the number of nodes; without unit */
	long   solves;                  /* with the plate, on this grid */
	double cost;                    /* solves on all grids, in units of a solve on the finest */
	size_t worst;                   /* without convergence: the node of the largest residual */
} FitProgress;

/* A surface fitted to exact residues counts as the one they come from if its misfit is at most this.
 * Misfits are squares of errors: on all test meshes, at 257 x 257 and 513 x 513 nodes, the misfit is 10
 * or more times the square of the largest error over the area. */
#define FIT_EXACT 1e-11

/* E per node at which an exact fit is near: halfway between two real surfaces it stays between 1 and 40.  Above
 * this, steps that halve E go on whatever the tolerance, since E may be on its way to 0. */
#define FIT_NEAR 1e-3

typedef struct FitWeights {
	double w, alpha;                /* w on a rectangle of area 1 */
} FitWeights;

typedef struct FitOptions {
	double tolerance;               /* converged when change is smaller */
	double fine;                    /* 0, or the tolerance once E is at most FIT_NEAR per node: residues may
	                                 * have an exact fit, to which the last steps converge fast */
	int    most;                    /* steps at most */
	double flat;                    /* converged when the predicted decrease is below flat*E */
	double settled;                 /* 0, or creeping steps go on until the last ten moved the surface by at
	                                 * most this in all */
	int    sharpen;                 /* adapt w and alpha to the data */
	const FitWeights *exact;        /* NULL, or these weights are used: the residues are of the same
	                                 * surface as lambda and H, where E is 0 for any weights.  Once E is
	                                 * at most FIT_EXACT per node, any step below the tolerance counts
	                                 * as converged, however fast E falls */
	void (*report)(void *ctx, const FitProgress *at);       /* or NULL */
	void  *ctx;
} FitOptions;

/* m       in      the misfit, whose w and alpha are set here
 * phi     in/out  [3][nv][nu]: a start; the border is held unless it is free (m->free)
 * at      out     progress at the last step; solves are added to its cost
 *
 * The first weights, w = 30 and alpha = 1, converge from afar and leave fewer wrinkles where
 * lambda and H belong to no surface.  Where the metric of the surface is close to lambda^2,
 * lambda and H do belong to one.  Then sharpening goes to w = 100 and alpha = 0.1, so that the
 * deviation of the grid from conformal weighs less.  If the metric is close at the start, this
 * is done at once.  Otherwise it is checked again after every step, and the weights move part
 * of the way once the energy stops falling steeply.  doc/mathematics.md 6.3.
 *
 * Returns 1 if it converged or crept, 0 if it did neither within the steps, or FIT_ENOMEM. */
int fit(Misfit *m, const FitOptions *o, double *phi, FitProgress *at);

#endif
