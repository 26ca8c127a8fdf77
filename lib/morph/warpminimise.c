/* warpminimise.c - the energy of a map lowered by L-BFGS. */
#include <lbfgs.h>
#include <math.h>
#include <stdlib.h>

#include "warpminimise.h"

enum {
	STEPS = 150,
	PAIRS = 8,              /* kept steps and changes of the gradient */
	PAST = 5,
	HALVES = 30             /* of a folded displacement */
};

static const double STILL = 5e-5;       /* ends when PAST steps lower the energy by less than this share */
static const double FIRST = 0.1;        /* bound of the change of a coefficient in the first step */

/* The map of the variables y of libLBFGS: x = scale y. */
typedef struct Scaled {
	WarpEnergy *e;
	double     *scale, *x;  /* [2][M][M] */
} Scaled;

/* The Hessian of the distortion grows like 1 + k^2 with the wave number k of a mode; by y it is about a
 * multiple of the identity, as L-BFGS assumes at its start.  Its first step is a unit vector. */
static void
set_scale(int M, double T, double *scale)
{
	int n = 2*M*M, i;

	for (i = 0; i < n; i++) {
		double m = i % M, row = i/M % M/T;

		scale[i] = FIRST/sqrt(1 + M_PI*M_PI*(m*m + row*row));
	}
}

static double
value(void *ctx, const double *y, double *grad, int n, double step)
{
	const Scaled *s = ctx;
	double E;
	int i;

	(void)step;
	for (i = 0; i < n; i++)
		s->x[i] = s->scale[i]*y[i];
	E = warpenergy(s->e, s->x, grad);
	for (i = 0; i < n && E < INFINITY; i++)
		grad[i] *= s->scale[i];
	return E;
}

/* A map found on a coarser grid may be folded between its nodes. */
static int
unfold(WarpEnergy *e, double *x, double *grad)
{
	int n = 2*e->M*e->M, i, k;

	for (k = 0; k <= HALVES; k++) {
		if (warpenergy(e, x, grad) < INFINITY)
			return 0;
		for (i = 0; i < n; i++)
			x[i] *= k < HALVES - 1 ? 0.5 : 0;
	}
	return WARP_EVALUE;
}

static int
lower(Scaled *s, int n, double *y)
{
	lbfgs_parameter_t o;
	int i, end;

	lbfgs_parameter_init(&o);
	o.m = PAIRS;
	o.epsilon = 0;
	o.past = PAST;
	o.delta = STILL;
	o.max_iterations = STEPS;
	o.linesearch = LBFGS_LINESEARCH_BACKTRACKING_ARMIJO;    /* it halves a step where the energy is infinite */
	for (i = 0; i < n; i++)
		y[i] = s->x[i]/s->scale[i];
	end = lbfgs(n, y, NULL, value, NULL, s, &o);
	if (end == LBFGSERR_OUTOFMEMORY)
		return WARP_ENOMEM;
	/* However else it ends, y is the best point so far. */
	for (i = 0; i < n; i++)
		s->x[i] = s->scale[i]*y[i];
	return 0;
}

int
warpminimise(WarpEnergy *e, double *x)
{
	int n = 2*e->M*e->M, bad = WARP_ENOMEM;
	double *work = malloc(2*(size_t)n*sizeof *work), *y = lbfgs_malloc(n);  /* aligned for vector units */
	Scaled s = { e, work, x };

	if (work && y) {
		set_scale(e->M, e->T, s.scale);
		bad = unfold(e, x, work + n);
		if (!bad)
			bad = lower(&s, n, y);
	}
	free(work);
	lbfgs_free(y);
	return bad;
}
