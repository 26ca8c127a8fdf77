/* simplex.c - reflects, stretches and shrinks a simplex towards a minimum. */
#include <math.h>
#include <string.h>

#include "simplex.h"

typedef struct Simplex {
	double x[SIMPLEX_MOST+1][SIMPLEX_MOST], f[SIMPLEX_MOST+1];
} Simplex;

/* Sorts a corner into the others, which are in order. */
static void
insert(Simplex *s, int k)
{
	double x[SIMPLEX_MOST], f = s->f[k];

	memcpy(x, s->x[k], sizeof x);
	for (; k > 0 && s->f[k-1] > f; k--) {
		memcpy(s->x[k], s->x[k-1], sizeof x);
		s->f[k] = s->f[k-1];
	}
	memcpy(s->x[k], x, sizeof x);
	s->f[k] = f;
}

/* The point at `share` of the way from the centre of all corners but the worst to the worst. */
static double
try(const SimplexProblem *p, const Simplex *s, double share, double *x)
{
	double centre;
	int k, c;

	for (c = 0; c < p->n; c++) {
		for (centre = 0, k = 0; k < p->n; k++)
			centre += s->x[k][c]/p->n;
		x[c] = centre + share*(s->x[p->n][c] - centre);
	}
	return p->f(p->ctx, x);
}

static void
shrink(const SimplexProblem *p, Simplex *s)
{
	int k, c;

	for (k = 1; k <= p->n; k++) {
		for (c = 0; c < p->n; c++)
			s->x[k][c] = (s->x[k][c] + s->x[0][c])/2;
		s->f[k] = p->f(p->ctx, s->x[k]);
		insert(s, k);
	}
}

static void
descend(const SimplexProblem *p, Simplex *s)
{
	double x[SIMPLEX_MOST], y[SIMPLEX_MOST], f, g;
	const int n = p->n;

	f = try(p, s, -1, x);
	if (f < s->f[0] && (g = try(p, s, -2, y)) < f)
		f = g, memcpy(x, y, sizeof x);
	else if (f >= s->f[n-1]) {
		g = try(p, s, f < s->f[n] ? -0.5 : 0.5, y);
		if (g >= fmin(f, s->f[n])) {
			shrink(p, s);
			return;
		}
		f = g, memcpy(x, y, sizeof x);
	}
	memcpy(s->x[n], x, sizeof x);
	s->f[n] = f;
	insert(s, n);
}

double
simplex(const SimplexProblem *p, double *x)
{
	Simplex s;
	int k;

	memset(&s, 0, sizeof s);
	for (k = 0; k <= p->n; k++) {
		if (k)
			s.x[k][k-1] = p->reach;
		s.f[k] = p->f(p->ctx, s.x[k]);
		insert(&s, k);
	}
	for (k = 0; k < p->steps && s.f[p->n] - s.f[0] > p->near; k++)
		descend(p, &s);
	memcpy(x, s.x[0], p->n*sizeof *x);
	return s.f[0];
}
