/* cones.c - a downhill simplex over pairs of points. */
#include <math.h>
#include <stdlib.h>

#include "../base/simplex.h"
#include "../base/sockplane.h"
#include "cones.h"
#include "draw.h"

enum {
	STARTS = 6,
	ROUNDS = 4,             /* of the simplex, each about the best pair so far */
	STEPS  = 200,           /* of a round */
	FREE   = 4              /* two coordinates of each cone */
};
static const double REACH = 0.15;       /* size of the first simplex, as a hyperbolic distance */
static const double SPREAD = 1./16;     /* |z - a|^2 is taken as |z - a|^2 + S/16, the mean over a part
                                         * that holds the cone */

static double
softened(double complex d, double S)
{
	return creal(d)*creal(d) + cimag(d)*cimag(d) + SPREAD*S;
}

typedef double Measure(int n, const double *A, const double *ratio);

/* A measure of the areas S/sqrt(q). */
static double
measured(const Parts *p, const double *q, Measure *measure)
{
	double ratio[PARTS_MOST];
	int i;

	for (i = 0; i < p->n; i++)
		ratio[i] = p->A[i]/p->S[i]*sqrt(q[i]);
	return measure(p->n, p->A, ratio);
}

static double
measured_sock(const Parts *p, double complex a, double complex b, Measure *measure)
{
	double q[PARTS_MOST];
	int i;

	for (i = 0; i < p->n; i++)
		q[i] = softened(p->z[i] - a, p->S[i])*softened(1 - conj(a)*p->z[i], p->S[i])
		    *softened(p->z[i] - b, p->S[i])*softened(1 - conj(b)*p->z[i], p->S[i]);
	return measured(p, q, measure);
}

double
parts_sock(const Parts *p, double complex a, double complex b)
{
	return measured_sock(p, a, b, parts_chi2);
}

double
parts_rectangle(const Parts *p, const double complex corner[4])
{
	double q[PARTS_MOST];
	int i, k;

	for (i = 0; i < p->n; i++)
		for (q[i] = 1, k = 0; k < 4; k++)
			q[i] *= softened(p->z[i] - corner[k], p->S[i]);
	return measured(p, q, parts_chi2);
}

/* ---- the best pair --------------------------------------------------- */

/* The point of the disk that is (x,y) away from c, as a hyperbolic distance. */
static double complex
step(double complex c, double x, double y)
{
	double r = hypot(x, y);
	double complex w = r > 0 ? tanh(r)/r*CMPLX(x, y) : 0;

	return (w + c)/(1 + conj(c)*w);
}

/* What the simplex minimises: log parts_lost, or infinity where the sock is too low. */
static double
value(const Parts *p, const double complex cone[2], const double x[FREE])
{
	double complex a = step(cone[0], x[0], x[1]), b = step(cone[1], x[2], x[3]);
	double rho = cabs((a - b)/(1 - conj(a)*b));

	if (!(rho > 0 && rho < 1) || sockplane_height(rho) < CONES_LEAST)
		return HUGE_VAL;
	return log(measured_sock(p, a, b, parts_lost));
}

typedef struct Search {
	const Parts          *p;
	const double complex *cone;
} Search;

static double
value_of(void *ctx, const double *x)
{
	const Search *s = ctx;

	return value(s->p, s->cone, x);
}

/* Improves the pair; returns the log of parts_lost. */
static double
improve(const Parts *p, double complex cone[2])
{
	Search search = { p, cone };
	SimplexProblem problem = { FREE, value_of, &search, REACH, STEPS, 1e-6 };
	double x[FREE], f = HUGE_VAL;
	int round;

	for (round = 0; round < ROUNDS; round++) {
		f = simplex(&problem, x);
		cone[0] = step(cone[0], x[0], x[1]);
		cone[1] = step(cone[1], x[2], x[3]);
		if (fabs(x[0]) + fabs(x[1]) + fabs(x[2]) + fabs(x[3]) < 1e-3)
			break;
	}
	return f;
}

/* Starts: the part that is smallest in the disk for its area, and then, with a double cone there, the one
 * that is smallest in the sock.  Further starts weight the parts by random numbers. */
static void
begin(const Parts *p, int start, unsigned long long *state, double complex cone[2])
{
	double worst, here, weight;
	int i, k;

	for (k = 0; k < 2; k++)
		for (worst = -1, i = 0; i < p->n; i++) {
			weight = start ? -log(draw(state)) : 1;
			here = p->A[i]/p->S[i]*weight*weight;
			if (k)
				here *= softened(p->z[i] - cone[0], p->S[i])*softened(1 - conj(cone[0])*p->z[i], p->S[i]);
			if (here > worst && (k == 0 || p->z[i] != cone[0])) {
				worst = here;
				cone[k] = p->z[i];
			}
		}
	for (k = 0; k < 2; k++)
		cone[k] *= fmin(1, 0.98/cabs(cone[k]));
	while (cabs((cone[0] - cone[1])/(1 - conj(cone[0])*cone[1])) > 0.99)
		cone[0] *= 0.9, cone[1] *= 0.9;
}

void
cones_choose(const Parts *p, double complex cone[2])
{
	unsigned long long state = 1;
	double complex at[2] = { 0, 0 };
	double best = HUGE_VAL, f;
	int start;

	for (start = 0; start < STARTS; start++) {
		begin(p, start, &state, at);
		f = improve(p, at);
		if (start == 0 || f < best) {
			best = f;
			cone[0] = at[0], cone[1] = at[1];
		}
	}
}
