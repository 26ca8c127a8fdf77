/* damped.c - Newton steps with a damping that adapts. */
#include <math.h>

#include "damped.h"

static const double FIRST = 1e-2, LEAST = 1e-6, HIGHEST = 1e8;  /* the damping t */
static const double TINY = 1e-12;       /* of the largest entry on the diagonal, added to each */

/* Solves A x = b, A positive definite of n x n numbers, by Cholesky's method.  A and b are overwritten. */
static void
solve(int n, double A[][DAMPED_MOST], double *b)
{
	int i, j, k;

	for (j = 0; j < n; j++) {
		for (k = 0; k < j; k++)
			A[j][j] -= A[j][k]*A[j][k];
		A[j][j] = sqrt(A[j][j]);
		for (i = j + 1; i < n; i++) {
			for (k = 0; k < j; k++)
				A[i][j] -= A[i][k]*A[j][k];
			A[i][j] /= A[j][j];
		}
	}
	for (i = 0; i < n; i++) {
		for (k = 0; k < i; k++)
			b[i] -= A[i][k]*b[k];
		b[i] /= A[i][i];
	}
	for (i = n - 1; i >= 0; i--) {
		for (k = i + 1; k < n; k++)
			b[i] -= A[k][i]*b[k];
		b[i] /= A[i][i];
	}
}

/* The step for a damping t. */
static void
step(int n, const double *g, double (*H)[DAMPED_MOST], double t, double *x)
{
	double A[DAMPED_MOST][DAMPED_MOST], most = 0;
	int i, k;

	for (i = 0; i < n; i++)
		most = fmax(most, H[i][i]);
	for (i = 0; i < n; i++) {
		for (k = 0; k < n; k++)
			A[i][k] = H[i][k];
		A[i][i] += t*H[i][i] + TINY*most;
		x[i] = -g[i];
	}
	solve(n, A, x);
}

double
damped_newton(const DampedProblem *p)
{
	double g[DAMPED_MOST], H[DAMPED_MOST][DAMPED_MOST], x[DAMPED_MOST], t = FIRST, f, to;
	int k;

	f = p->derivatives(p->ctx, g, H);
	for (k = 0; k < p->steps && t <= HIGHEST; k++) {
		step(p->n, g, H, t, x);
		to = p->value(p->ctx, x);
		while (!(to < f) && t <= HIGHEST) {
			t *= 8;
			step(p->n, g, H, t, x);
			to = p->value(p->ctx, x);
		}
		if (!(to < f))
			break;
		p->move(p->ctx, x);
		if (f - to <= p->near)
			return to;
		t = fmax(t/5, LEAST);
		f = p->derivatives(p->ctx, g, H);
	}
	return f;
}
