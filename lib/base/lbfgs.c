/* lbfgs.c - the limited-memory BFGS method. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "lbfgs.h"

enum {
	PAIRS = 8,              /* kept steps and changes of the gradient */
	HALVES = 25,            /* of a step */
	FIRST = 6               /* steps before the tolerance counts */
};

typedef struct Memory {
	int     n, pairs;
	double *s[PAIRS], *y[PAIRS];    /* [n] steps and changes of the gradient, oldest first */
	double  sy[PAIRS];
} Memory;

static double
dot(int n, const double *a, const double *b)
{
	double sum = 0;
	int i;

	for (i = 0; i < n; i++)
		sum += a[i]*b[i];
	return sum;
}

/* d = -(approximate inverse Hessian) g, by the two loops of the paper. */
static void
direction(const Memory *m, const double *prec, const double *g, double *d)
{
	double a[PAIRS], b, yy = 0, scale = 1;
	int k, i;

	memcpy(d, g, (size_t)m->n*sizeof *d);
	for (k = m->pairs - 1; k >= 0; k--) {
		a[k] = dot(m->n, m->s[k], d)/m->sy[k];
		for (i = 0; i < m->n; i++)
			d[i] -= a[k]*m->y[k][i];
	}
	if (m->pairs) {
		k = m->pairs - 1;
		for (i = 0; i < m->n; i++)
			yy += prec[i]*m->y[k][i]*m->y[k][i];
		scale = m->sy[k]/yy;
	}
	for (i = 0; i < m->n; i++)
		d[i] *= scale*prec[i];
	for (k = 0; k < m->pairs; k++) {
		b = a[k] - dot(m->n, m->y[k], d)/m->sy[k];
		for (i = 0; i < m->n; i++)
			d[i] += b*m->s[k][i];
	}
	for (i = 0; i < m->n; i++)
		d[i] = -d[i];
}

/* Keeps the step from x to x1 if the function is convex along it. */
static void
keep(Memory *m, const double *x, const double *x1, const double *g, const double *g1)
{
	int k = m->pairs < PAIRS ? m->pairs : PAIRS - 1, i;
	double *s = m->s[0], *y = m->y[0];

	if (m->pairs == PAIRS) {
		memmove(m->s, m->s + 1, (PAIRS - 1)*sizeof *m->s);
		memmove(m->y, m->y + 1, (PAIRS - 1)*sizeof *m->y);
		memmove(m->sy, m->sy + 1, (PAIRS - 1)*sizeof *m->sy);
		m->s[k] = s;
		m->y[k] = y;
	}
	for (i = 0; i < m->n; i++) {
		m->s[k][i] = x1[i] - x[i];
		m->y[k][i] = g1[i] - g[i];
	}
	m->sy[k] = dot(m->n, m->s[k], m->y[k]);
	m->pairs = k + (m->sy[k] > 1e-14);
}

static double
longest(int n, const double *d)
{
	double most = 0;
	int i;

	for (i = 0; i < n; i++)
		most = fmax(most, fabs(d[i]));
	return most;
}

/* The value at x1 = x + t d for the first t = start, start/2, .. that lowers it enough; INFINITY if
 * none does. */
static double
search(int n, LbfgsValue *f, void *ctx, double value, double slope, double start, const double *x,
	const double *d, double *x1, double *g1)
{
	double t = start, e;
	int k, i;

	for (k = 0; k < HALVES; k++, t /= 2) {
		for (i = 0; i < n; i++)
			x1[i] = x[i] + t*d[i];
		e = f(ctx, x1, g1);
		if (e <= value + 1e-4*t*slope)
			return e;
	}
	return INFINITY;
}

static void
minimise(const Lbfgs *o, Memory *m, LbfgsValue *f, void *ctx, double *x, double *work, double *value)
{
	int n = m->n, it, done = 0;
	double *g = work, *d = work + n, *x1 = work + 2*n, *g1 = work + 3*n, slope, e;

	*value = f(ctx, x, g);
	for (it = 0; it < o->steps && !done; it++) {
		direction(m, o->prec, g, d);
		if (!((slope = dot(n, g, d)) < 0)) {
			m->pairs = 0;
			direction(m, o->prec, g, d);
			if (!((slope = dot(n, g, d)) < 0))
				return;
		}
		e = search(n, f, ctx, *value, slope, m->pairs ? 1 : fmin(1, o->shorter/longest(n, d)), x, d, x1, g1);
		if (!isfinite(e))
			return;
		keep(m, x, x1, g, g1);
		done = it >= FIRST && *value - e < o->tol*fabs(*value);
		memcpy(x, x1, (size_t)n*sizeof *x);
		memcpy(g, g1, (size_t)n*sizeof *g);
		*value = e;
	}
}

int
lbfgs(const Lbfgs *o, int n, LbfgsValue *f, void *ctx, double *x, double *value)
{
	double *work = malloc((size_t)n*(2*PAIRS + 4)*sizeof *work);
	Memory m = { .n = n };
	int k;

	if (!work)
		return LBFGS_ENOMEM;
	for (k = 0; k < PAIRS; k++) {
		m.s[k] = work + (size_t)n*(4 + 2*k);
		m.y[k] = m.s[k] + n;
	}
	minimise(o, &m, f, ctx, x, work, value);
	free(work);
	return 0;
}
