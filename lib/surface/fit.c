/* fit.c - Gauss-Newton steps in a trust region. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/field.h"
#include "fit.h"
#include "fitsolve.h"

enum { TEN = 10 };
static const double NEAR = 0.9, NEARBY = 1e-4;
static const double BLUNT_W = 30, BLUNT_ALPHA = 1, SHARP_W = 100, SHARP_ALPHA = 0.1;
/* Ratio of E to its previous value: below FAST it falls fast, below STEEP steeply; above STILL it
 * hardly falls. */
static const double FAST = 0.1, STEEP = 0.5, STILL = 0.98;
static const double SURE = 0.1;         /* a step below this share of the tolerance counts as
                                         * converged whatever E does */
static const double POOR = 0.25;        /* if the decrease is below this share of the predicted one,
                                         * the step is shortened */
enum { SHORTER = 3 };           /* a step is shortened at most this often */
static const double CREEP = 5e-4;       /* ten steps must lower E by at least this fraction */
static const double ROUNDING = 1e-24;   /* E per node that rounding alone may leave: residuals of
                                         * w = 100 times some units in the last place */

/* Outcome of a step. */
typedef struct Outcome {
	double change;          /* root mean square displacement over sqrt(area) */
	double predicted;       /* decrease of E */
	int    accepted;        /* phi is changed */
	int    cut;             /* the step was shortened: by the trust region, or by backtracking
	                         * because E rose */
	int    spent;           /* CG reached its limit of steps */
} Outcome;

/* E at phi + t d.  Stores phi + t d in k->y. */
static double
trial(FitSolve *k, const double *phi, double t)
{
	field_scale(k->n, 1, phi, k->y);
	field_add(k->n, t, k->d, k->y);
	return misfit_energy(k->m, k->y);
}

/* The step length along d; *E2 is E after the step.  The length is 1 if that lowers E by at least a
 * quarter of the predicted decrease.  Otherwise it is reduced, at most SHORTER times, to the
 * minimum of the parabola that has the values of E at both ends and the slope at the start, -2
 * <b,d>.  *predicted is set to the predicted decrease for that length.  Near folds E rises early
 * along d; backtracking here is ten times cheaper than rediscovering that with another CG solve. */
static double
step_length(FitSolve *k, const double *phi, double E, double bd, double *predicted, double *E2)
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
step(FitSolve *k, double *phi, double *E)
{
	double length, bd, t, E2, gain;
	Outcome is;

	misfit_gradient(k->m, phi, k->r);
	field_scale(k->n, -1, k->r, k->r);
	field_scale(k->n, 1, k->r, k->y);
	is.predicted = fitsolve(k, phi, *E, &length, &is.spent);
	bd = field_dot(k->n, k->y, k->d);
	k->steps++;
	is.cut = length > 0.99*k->radius;
	t = step_length(k, phi, *E, bd, &is.predicted, &E2);
	is.change = t*sqrt(field_dot(k->n, k->d, k->d)/(k->n/3.0)*k->m->scale)/k->m->g.T;
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
 * filter, 20 % after a filter that left only the coarse shape.  Rounded to eighths, so that
 * rounding differences in the start do not change the weights. */
static double
sharpness(const Misfit *m, const double *phi)
{
	double share = round(16*(1 - misfit_scale_error(m, phi)/0.16))/8;

	return share > 1 ? 1 : share < 0 ? 0 : share;
}

static void
set_weights(Misfit *m, double share)
{
	m->w = BLUNT_W*pow(SHARP_W/BLUNT_W, share)/sqrt(m->g.T);
	m->alpha = BLUNT_ALPHA*pow(SHARP_ALPHA/BLUNT_ALPHA, share);
}

/* The values before each of the last ten steps. */
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

static double
tolerance_at(const FitOptions *o, double E, size_t nodes)
{
	return o->fine > 0 && E <= FIT_NEAR*nodes ? o->fine : o->tolerance;
}

/* A shortened step says nothing about convergence, unless the last ten steps together barely lowered
 * E or barely moved: with data that belong to no surface, steps can creep for ever.  Those that still move the surface
 * far (o->settled) go on.  Nor does a step
 * only just below the tolerance while E is still falling fast; nor, with residues, one that halves E
 * on its way to FIT_NEAR.  If CG reached its limit of steps, the step may lack slow components; then it
 * counts only when E hardly falls any more.
 *
 * Where E is 0 up to rounding, no step can lower it.  Returns FIT_CONVERGED, FIT_CREPT or 0. */
static int
converged(const FitOptions *o, const Outcome *is, double E, size_t nodes, double moved, const Past *past)
{
	int then = past->steps%TEN, last = (past->steps - 1)%TEN;
	double moves = moved - past->moved[then];
	int wanders = is->cut && o->settled > 0 && moves > o->settled;
	double tolerance = tolerance_at(o, E, nodes);
	double flat = o->exact && E <= FIT_EXACT*nodes ? 0 : is->spent ? STILL : FAST;

	if (E < ROUNDING*nodes)
		return FIT_CONVERGED;
	if (past->steps >= TEN
	    && ((past->E[then] - E < CREEP*past->E[then] && !wanders) || moves < tolerance))
		return is->cut ? FIT_CREPT : FIT_CONVERGED;
	if (is->cut || (o->fine > 0 && E > FIT_NEAR*nodes && E < past->E[last]/2))
		return 0;
	return is->change < (E > flat*past->E[last] ? 1 : SURE)*tolerance || is->predicted <= o->flat*E
	    ? FIT_CONVERGED : 0;
}

/* E over the number of nodes, with the sharp weights and without the place.  m is restored after. */
static double
mean_misfit(Misfit *m, const double *phi)
{
	double w = m->w, alpha = m->alpha, stretch = m->stretch, E;
	const double *place = m->place;

	set_weights(m, 1);
	m->place = NULL;
	m->stretch = 1;
	E = misfit_energy(m, phi);
	m->w = w;
	m->alpha = alpha;
	m->place = place;
	m->stretch = stretch;
	return E/((double)m->g.nu*m->g.nv);
}

int
fit(Misfit *m, const FitOptions *o, double *phi, FitProgress *at)
{
	double E, share, moved = 0;
	Past past = { .steps = 0 };
	int blunt, flat, done = 0;
	Outcome is;
	FitSolve k;

	if (fitsolve_init(&k, m))
		return FIT_ENOMEM;
	blunt = o->sharpen && sharpness(m, phi) < 1;
	set_weights(m, o->sharpen && !blunt);
	if (o->exact) {
		m->w = o->exact->w/sqrt(m->g.T);
		m->alpha = o->exact->alpha;
		blunt = 0;
	}
	at->nu = m->g.nu, at->nv = m->g.nv, at->step = 0;
	at->energy = E = misfit_energy(m, phi);
	while (!done && !k.error && at->step < o->most && isfinite(E)) {
		remember(&past, E, moved);
		k.tolerance = tolerance_at(o, E, (size_t)m->g.nu*m->g.nv);
		is = step(&k, phi, &E);
		moved += is.change;
		at->step++;
		at->energy = E;
		at->change = is.change;
		at->solves = k.solves;
		if (o->report)
			o->report(o->ctx, at);
		done = converged(o, &is, E, (size_t)m->g.nu*m->g.nv, moved, &past);
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
	at->stopped = done;
	at->crept = past.steps >= TEN ? moved - past.moved[past.steps%TEN] : moved;
	at->misfit = mean_misfit(m, phi);
	at->worst = done ? 0 : misfit_worst(m, phi);
	fitsolve_free(&k);
	return k.error ? k.error : done != 0;
}
