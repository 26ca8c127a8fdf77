/* fit.c - Gauss-Newton steps in a trust region. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/cg.h"
#include "../base/field.h"
#include "fit.h"

static const double BLUNT_W = 30, BLUNT_ALPHA = 1, SHARP_W = 100, SHARP_ALPHA = 0.1;
static const double TENSION = 3;        /* of the plate, over w^2; 3 takes the fewest steps */
enum { MOST_CG = 60, TEN = 10 };
/* With a free boundary surfaces bend easily and far.  CG gets few steps until a Gauss-Newton step
 * was short and E fell as predicted: more would be spent on bending that the next step undoes.
 * After that it gets as many as it needs. */
enum { MOST_CG_FREE = 20, MOST_CG_NEAR = 400 };
static const double NEAR = 0.9, NEARBY = 1e-4, WORTH_NEAR = 1e-6;
static const double REDUCTION = 0.1;    /* of the preconditioned residual, in a Gauss-Newton step */
static const double FLAT = 1e-6;        /* predicted decrease over E that is not worth another step */
/* Ratio of E to its previous value: below FAST it falls fast, below STEEP steeply; above STILL it
 * hardly falls. */
static const double FAST = 0.1, STEEP = 0.5, STILL = 0.98;
static const double SURE = 0.1;         /* a step below this share of the tolerance counts as
                                         * converged whatever E does */
static const double POOR = 0.25;        /* if the decrease is below this share of the predicted one,
                                         * the step is shortened */
enum { SHORTER = 3 };           /* how often a step is shortened at most */
static const double CREEP = 5e-4;       /* least share of E by which ten steps must lower it */
static const double WORTH = 1e-3;       /* least share of the decrease a CG step must add */

typedef struct Work {
	Misfit *m;
	const double *phi;              /* the surface at which J is taken */
	Plate   plate;
	size_t  n;                      /* numbers in a vector */
	double *r, *z, *p, *q, *d, *y;  /* residual, preconditioned, direction, J'J p; step, trial */
	double  radius;                 /* of the trust region, in the norm of the plate */
	int     near;                   /* the last step was short, not cut, and E fell as predicted */
	long    solves;
} Work;

static void
release(Work *k)
{
	plate_free(&k->plate);
	free(k->r);
	free(k->z);
	free(k->p);
	free(k->q);
	free(k->d);
	free(k->y);
}

static int
prepare(Work *k, Misfit *m)
{
	*k = (Work){ .m = m, .n = 3*(size_t)m->g.nu*m->g.nv, .radius = HUGE_VAL };
	k->r = malloc(k->n*sizeof(double));
	k->z = malloc(k->n*sizeof(double));
	k->p = malloc(k->n*sizeof(double));
	k->q = malloc(k->n*sizeof(double));
	k->d = malloc(k->n*sizeof(double));
	k->y = malloc(k->n*sizeof(double));
	if (!k->r || !k->z || !k->p || !k->q || !k->d || !k->y || plate_init(&k->plate, m->g, m->free)) {
		release(k);
		return FIT_ENOMEM;
	}
	return 0;
}

static void
apply_normal(void *work, const double *p, double *q)
{
	const Work *k = work;

	misfit_normal(k->m, k->phi, p, q);
}

static void
precondition(void *work, const double *r, double *z)
{
	Work *k = work;
	double w = k->m->w;

	field_scale(k->n, 1, r, z);
	plate_solve(&k->plate, k->m->scale, TENSION*w*w*k->m->scale, z);
	k->solves++;
}

/* Solves for the step d; the negative gradient is in r.  Returns the predicted decrease of E;
 * *length is |d| in the plate norm, *spent is set if CG reached its limit of steps. */
static double
conjugate_gradients(Work *k, const double *phi, double *length, int *spent)
{
	CgSystem s = { k->n, apply_normal, precondition, k };
	CgLimits limits = { REDUCTION, !k->m->free ? MOST_CG : k->near ? MOST_CG_NEAR : MOST_CG_FREE,
	    k->radius, k->m->free && k->near ? WORTH_NEAR : WORTH };
	CgResult is;

	k->phi = phi;
	memset(k->d, 0, k->n*sizeof *k->d);
	is = cg(&s, &limits, k->d, k->r, k->z, k->p, k->q);
	*spent = is.steps == limits.steps;
	*length = is.length;
	return is.decrease;
}

/* Outcome of a step. */
typedef struct Outcome {
	double change;          /* root mean square displacement over sqrt(area) */
	double predicted;       /* decrease of E */
	int    accepted;        /* phi is changed */
	int    cut;             /* the step was shortened: by the trust region, or by backtracking
	                         * because E rose */
	int    spent;           /* CG reached its limit of steps */
} Outcome;

/* E at phi + t d, which is left in y. */
static double
trial(Work *k, const double *phi, double t)
{
	field_scale(k->n, 1, phi, k->y);
	field_add(k->n, t, k->d, k->y);
	return misfit_energy(k->m, k->y);
}

/* Step length along d, and E there.  The length is 1 if that lowers E by at least a quarter of the
 * predicted decrease.  Otherwise it is reduced, at most SHORTER times, to the minimum of the parabola
 * that has the values of E at both ends and the slope at the start, -2 <b,d>.  *predicted is set to
 * the predicted decrease for that length.  Near folds E rises early along d; backtracking here is ten
 * times cheaper than rediscovering that with another CG solve. */
static double
step_length(Work *k, const double *phi, double E, double bd, double *predicted, double *E2)
{
	double t = 1, whole = *predicted, lowest;
	int tries;

	*E2 = trial(k, phi, t);
	for (tries = 0; tries < SHORTER && !(E - *E2 > POOR*(*predicted)); tries++) {
		lowest = isfinite(*E2) ? bd*t*t/(2*bd*t + *E2 - E) : 0;
		t = lowest > 0.5*t ? 0.5*t : lowest > 0.1*t ? lowest : 0.1*t;
		*predicted = 2*bd*t - (2*bd - whole)*t*t;
		*E2 = trial(k, phi, t);
	}
	return t;
}

/* One step from phi, with energy *E. */
static Outcome
step(Work *k, double *phi, double *E)
{
	double length, bd, t, E2, gain;
	Outcome is;

	misfit_gradient(k->m, phi, k->r);
	field_scale(k->n, -1, k->r, k->r);
	field_scale(k->n, 1, k->r, k->y);
	is.predicted = conjugate_gradients(k, phi, &length, &is.spent);
	bd = field_dot(k->n, k->y, k->d);
	is.cut = length > 0.99*k->radius;
	t = step_length(k, phi, *E, bd, &is.predicted, &E2);
	is.change = t*sqrt(field_dot(k->n, k->d, k->d)/(k->n/3.0)*k->m->scale/k->m->g.T);
	gain = (*E - E2)/is.predicted;
	is.accepted = gain > 0.01;
	if (t < 1) {
		is.cut = 1;
		k->radius = length*fmax(t, POOR);
	} else if (gain > 0.75 && is.cut)
		k->radius *= 2;
	k->near = gain > NEAR && !is.cut && is.change < NEARBY;
	if (is.accepted) {
		field_scale(k->n, 1, k->y, phi);
		*E = E2;
	}
	return is;
}

/* How far the weights may be sharpened: not at all if the metric error is 16 % or more, fully below
 * 8 %.  It is 0.05-3 % for surfaces, 7 % for whole hemispheres of the cortex, 8-13 % after a light
 * filter, 20 % after a filter that left only the coarse shape.  Rounded to eighths, so that rounding
 * differences in the start do not change the weights. */
static double
sharpness(const Misfit *m, const double *phi)
{
	double share = round(16*(1 - misfit_scale_error(m, phi)/0.16))/8;

	return share > 1 ? 1 : share < 0 ? 0 : share;
}

static void
set_weights(Misfit *m, double share)
{
	m->w = BLUNT_W*pow(SHARP_W/BLUNT_W, share);
	m->alpha = BLUNT_ALPHA*pow(SHARP_ALPHA/BLUNT_ALPHA, share);
}

/* The state before each of the last ten steps. */
typedef struct Past {
	double E[TEN], moved[TEN];      /* E, and the sum of the changes of all steps before */
	int    steps;
} Past;

static void
remember(Past *past, double E, double moved)
{
	past->E[past->steps%TEN] = E;
	past->moved[past->steps++%TEN] = moved;
}

/* A shortened step says nothing about convergence, unless the last ten steps together barely lowered
 * E or barely moved: with data that belong to no surface, steps can creep for ever.  Nor does a step
 * only just below the tolerance while E is still falling fast.  If CG reached its limit of steps, it
 * may have missed slow components; then such a step counts only when E hardly falls any more. */
static int
converged(const FitOptions *o, const Outcome *is, double E, double moved, const Past *past)
{
	int then = past->steps%TEN, last = (past->steps - 1)%TEN;
	double flat = is->spent ? STILL : FAST;

	if (past->steps >= TEN
	    && (past->E[then] - E < CREEP*past->E[then] || moved - past->moved[then] < o->tolerance))
		return 1;
	if (is->cut)
		return 0;
	return is->change < (E > flat*past->E[last] ? 1 : SURE)*o->tolerance || is->predicted <= FLAT*E;
}

int
fit(Misfit *m, const FitOptions *o, double *phi, FitProgress *at)
{
	double E, share, moved = 0;
	Past past = { .steps = 0 };
	int blunt, flat, done = 0;
	Outcome is;
	Work k;

	if (prepare(&k, m))
		return FIT_ENOMEM;
	blunt = o->sharpen && sharpness(m, phi) < 1;
	set_weights(m, o->sharpen && !blunt);
	at->nu = m->g.nu, at->nv = m->g.nv, at->step = 0;
	at->energy = E = misfit_energy(m, phi);
	while (!done && at->step < o->most && isfinite(E)) {
		remember(&past, E, moved);
		is = step(&k, phi, &E);
		moved += is.change;
		at->step++;
		at->energy = E;
		at->change = is.change;
		at->solves = k.solves;
		if (o->report)
			o->report(o->ctx, at);
		done = converged(o, &is, E, moved, &past);
		flat = done || E > STEEP*past.E[(past.steps - 1)%TEN];
		share = blunt && is.accepted ? sharpness(m, phi) : 0;
		if (blunt && is.accepted && (flat || share == 1)) {
			set_weights(m, share);
			E = misfit_energy(m, phi);
			k.radius = HUGE_VAL;
			past.steps = 0;
			blunt = done = 0;
		}
	}
	at->worst = done ? 0 : misfit_worst(m, phi);
	release(&k);
	return done;
}
