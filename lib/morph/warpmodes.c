/* warpmodes.c - displacements of a rectangle as sums of modes, by dense products. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "warpmodes.h"

int
warpmodes_init(WarpModes *w, int nu, int nv, int M)
{
	size_t a = (size_t)nu*M, b = (size_t)nv*M;
	double *all = malloc((4*a + 4*b)*sizeof *all), x;
	int i, m, k;

	if (!all)
		return WARPMODES_ENOMEM;
	*w = (WarpModes){ nu, nv, M, { all, all + a }, { all + 4*a, all + 4*a + b }, { all + 2*a, all + 3*a },
	    all + 4*a + 2*b };
	for (i = 0; i < nu; i++)
		for (m = 0; m < M; m++) {
			x = m*M_PI*i/(nu - 1);
			w->u[0][i*M+m] = i == nu - 1 ? 0 : sin(x);
			w->u[1][i*M+m] = cos(x);
			for (k = 0; k < 2; k++)
				w->across[k][m*nu+i] = w->u[k][i*M+m];
		}
	for (i = 0; i < nv; i++)
		for (m = 0; m < M; m++) {
			x = m*M_PI*i/(nv - 1);
			w->v[0][i*M+m] = cos(x);
			w->v[1][i*M+m] = i == nv - 1 ? 0 : sin(x);
		}
	return 0;
}

void
warpmodes_free(WarpModes *w)
{
	free(w->u[0]);
	memset(w, 0, sizeof *w);
}

/* y[0..n-1] += sum over k of a[k] x[k][0..n-1] */
static void
combine(int K, int n, const double *restrict a, const double *restrict x, double *restrict y)
{
	int k, i;

	for (k = 0; k < K; k++)
		for (i = 0; i < n; i++)
			y[i] += a[k]*x[k*n+i];
}

void
warpmodes_field(const WarpModes *w, const double *c, double *d)
{
	int M = w->M, nu = w->nu, nv = w->nv, r;

#pragma omp parallel for schedule(static)
	for (r = 0; r < 2*nv; r++) {
		int k = r >= nv, j = r - k*nv;
		double *half = w->half + (size_t)r*M, *row = d + (size_t)r*nu;

		memset(half, 0, M*sizeof *half);
		memset(row, 0, nu*sizeof *row);
		combine(M, M, w->v[k] + (size_t)j*M, c + (size_t)k*M*M, half);
		combine(M, nu, half, w->across[k], row);
	}
}

void
warpmodes_adjoint(const WarpModes *w, const double *g, double *c)
{
	int M = w->M, nu = w->nu, nv = w->nv, r;

#pragma omp parallel for schedule(static)
	for (r = 0; r < 2*nv; r++) {
		double *half = w->half + (size_t)r*M;

		memset(half, 0, M*sizeof *half);
		combine(nu, M, g + (size_t)r*nu, w->u[r >= nv], half);
	}
#pragma omp parallel for schedule(static)
	for (r = 0; r < 2*M; r++) {
		int k = r >= M, n = r - k*M, j, m;
		double *row = c + (size_t)r*M;

		memset(row, 0, M*sizeof *row);
		for (j = 0; j < nv; j++)
			for (m = 0; m < M; m++)
				row[m] += w->v[k][j*M+n]*w->half[((size_t)k*nv + j)*M+m];
	}
}

/* Sines and cosines of the modes at a point: [0] of u, [1] of v/T. */
typedef struct Point {
	double s[2][WARPMODES_MOST], c[2][WARPMODES_MOST];
} Point;

static void
point(int M, double u, double w, Point *p)
{
	int m;

	for (m = 0; m < M; m++) {
		p->s[0][m] = sin(m*M_PI*u);
		p->c[0][m] = cos(m*M_PI*u);
		p->s[1][m] = sin(m*M_PI*w);
		p->c[1][m] = cos(m*M_PI*w);
	}
}

void
warpmodes_at(int M, double T, const double *c, double u, double v, double d[2])
{
	Point p;
	int n, m;

	point(M, u, v/T, &p);
	d[0] = d[1] = 0;
	for (n = 0; n < M; n++)
		for (m = 0; m < M; m++) {
			d[0] += c[n*M+m]*p.s[0][m]*p.c[1][n];
			d[1] += c[(M+n)*M+m]*p.c[0][m]*p.s[1][n];
		}
}

void
warpmodes_at_adjoint(int M, double T, const double g[2], double u, double v, double *c)
{
	Point p;
	int n, m;

	point(M, u, v/T, &p);
	for (n = 0; n < M; n++)
		for (m = 0; m < M; m++) {
			c[n*M+m] += g[0]*p.s[0][m]*p.c[1][n];
			c[(M+n)*M+m] += g[1]*p.c[0][m]*p.s[1][n];
		}
}
