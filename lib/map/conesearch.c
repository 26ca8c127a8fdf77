/* conesearch.c - damped Newton steps over three cones and the height. */
#include <string.h>

#include "../base/damped.h"
#include "conesearch.h"

enum {
	CONES  = SPHEREPARTS_CONES,
	FREE   = 7,             /* log T, and two numbers for each of three cones */
	STEPS  = 40
};
static const double LEAST = 0.02, MOST = 12.5;  /* T */
static const double REACH = 1e-5;       /* of the difference quotients for the change of cones */
static const double SCAN = 0.6;         /* steps of log T before the search */
static const double NEAR = 1e-4;        /* of log chi^2 */

static int
numbers(const ConeSearch *s)
{
	return s->fixed ? 1 : FREE;
}

/* The cones that x leads to: log T changes by x[0], P[k] moves to x[2k+1] + i x[2k+2] of the plane in which it is
 * at 0. */
static void
change(const ConeSearch *s, const double *x, ConeSearch *to)
{
	int k;

	*to = *s;
	to->T = s->T*exp(x[0]);
	for (k = 0; k < 3 && !s->fixed; k++)
		moebius_point(s->P[k], CMPLX(x[2*k+1], x[2*k+2]), to->P[k]);
}

/* All four cones that x leads to.  Returns 0 if they are not finite: two of them are equal. */
static int
cones_at(const ConeSearch *s, const double *x, Spinor cone[CONES])
{
	ConeSearch to;
	ConeMap c;
	int k;

	change(s, x, &to);
	memcpy(cone, to.P, sizeof to.P);
	conemap_three(to.P, to.T, &c);
	conemap_place(&c, 3, cone[3]);
	for (k = 0; k < CONES && isfinite(creal(cone[k][0])); k++)
		;
	return k == CONES;
}

static double
value(void *ctx, const double *x)
{
	const ConeSearch *s = ctx;
	Spinor cone[CONES];
	double T = s->T*exp(x[0]);

	return T >= LEAST && T <= MOST && cones_at(s, x, cone) ? sphereparts_value(s->p, cone) : HUGE_VAL;
}

static void
move(void *ctx, const double *x)
{
	ConeSearch *s = ctx;
	ConeSearch to;

	change(s, x, &to);
	*s = to;
}

/* The derivatives of the places of the cones, two numbers each, by the n numbers of the search. */
static void
cone_slopes(const ConeSearch *s, Spinor cone[CONES], double J[SPHEREPARTS_FREE][DAMPED_MOST])
{
	Spinor plus[CONES], minus[CONES];
	double x[DAMPED_MOST] = { 0 };
	double complex d;
	int k, i;

	for (i = 0; i < numbers(s); i++) {
		x[i] = REACH;
		cones_at(s, x, plus);
		x[i] = -REACH;
		cones_at(s, x, minus);
		x[i] = 0;
		for (k = 0; k < CONES; k++) {
			d = (moebius_seen_from(cone[k], plus[k]) - moebius_seen_from(cone[k], minus[k]))/(2*REACH);
			J[2*k][i] = creal(d);
			J[2*k+1][i] = cimag(d);
		}
	}
}

/* g and H by the numbers of the search: J' g and J' H J. */
static double
derivatives(void *ctx, double *g, double (*H)[DAMPED_MOST])
{
	enum { N = SPHEREPARTS_FREE };
	const ConeSearch *s = ctx;
	const double zero[DAMPED_MOST] = { 0 };
	double J[N][DAMPED_MOST], cg[N], CH[N][N], HJ, f;
	Spinor cone[CONES];
	int n = numbers(s), i, j, k, l;

	cones_at(s, zero, cone);
	cone_slopes(s, cone, J);
	f = sphereparts_derivatives(s->p, cone, cg, CH);
	for (i = 0; i < n; i++) {
		for (g[i] = 0, k = 0; k < N; k++)
			g[i] += J[k][i]*cg[k];
		for (j = 0; j < n; j++)
			for (H[i][j] = 0, k = 0; k < N; k++) {
				for (HJ = 0, l = 0; l < N; l++)
					HJ += CH[k][l]*J[l][j];
				H[i][j] += J[k][i]*HJ;
			}
	}
	return f;
}

double
conesearch_descend(ConeSearch *s)
{
	DampedProblem problem = { numbers(s), s, value, move, derivatives, STEPS, NEAR };

	return damped_newton(&problem);
}

int
conesearch_scan(ConeSearch *s)
{
	double x[DAMPED_MOST] = { log(LEAST*1.5) }, least = HUGE_VAL, T = 1, f;

	for (s->T = 1; x[0] < log(MOST); x[0] += SCAN) {
		f = value(s, x);
		if (f < least) {
			least = f;
			T = exp(x[0]);
		}
	}
	s->T = T;
	return least < HUGE_VAL;
}
