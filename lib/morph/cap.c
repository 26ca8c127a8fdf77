/* cap.c - the part of K above H^2, and one Poisson solve that lowers lambda there. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../grid/stencil.h"
#include "../poisson/plate.h"
#include "cap.h"

enum {
	RINGS = 4,              /* lambda and H are extrapolated on the border, and ragged near it */
	PASSES = 18             /* of weights 1/4, 1/2, 1/4, of variance 1/2: a Gaussian of three nodes */
};

static const double SHARE = 0.5;        /* of e */

static int
clamp(int i, int joined, int n)
{
	return joined ? i : i < 0 ? 0 : i >= n ? n - 1 : i;
}

/* f at the place (i,j), at most one step outside the grid; beyond an open side that of the nearest node. */
static double
at(Chart g, const double *f, int i, int j)
{
	int sign = 1;

	return f[stencil_node(g, clamp(i, g.kind->joined[0][i > 0], g.nu), clamp(j, g.kind->joined[1][j > 0], g.nv), &sign)];
}

/* The mean at (i,j) with weights 1/4, 1/2, 1/4 along u and v, near the sides. */
static double
mean_at(Chart g, const double *f, int i, int j)
{
	static const double w[3] = { 0.25, 0.5, 0.25 };
	double sum = 0;
	int k, l;

	for (k = 0; k < 3; k++)
		for (l = 0; l < 3; l++)
			sum += w[k]*w[l]*at(g, f, i + l - 1, j + k - 1);
	return sum;
}

/* The same at the nodes 0 < i < nu-1 of a row that has both neighbours. */
static void
mean_row(int nu, const double *f, double *to)
{
	const double *below = f - nu, *above = f + nu;
	int i;

	for (i = 1; i < nu - 1; i++)
		to[i] = (below[i-1] + below[i+1] + above[i-1] + above[i+1])/16
		    + (below[i] + above[i] + f[i-1] + f[i+1])/8 + f[i]/4;
}

static void
mean(Chart g, const double *f, double *to)
{
	int i, j;

#pragma omp parallel for schedule(static) private(i)
	for (j = 0; j < g.nv; j++) {
		size_t row = (size_t)j*g.nu;
		int within = j > 0 && j < g.nv - 1;

		if (within)
			mean_row(g.nu, f + row, to + row);
		for (i = 0; i < g.nu; i += within && i == 0 ? g.nu - 1 : 1)
			to[row+i] = mean_at(g, f, i, j);
	}
}

/* Replaces f by its Gaussian mean. */
static void
smooth(Chart g, double *f, double *work)
{
	int k;

	for (k = 0; k < PASSES; k += 2) {
		mean(g, f, work);
		mean(g, work, f);
	}
}

/* -Delta f at inner nodes, 0 on open sides. */
static void
curvature(Chart g, const double *f, double *to)
{
	double h = chart_h(g), k = chart_k(g);
	int i, j;

#pragma omp parallel for schedule(static) private(i)
	for (j = 0; j < g.nv; j++)
		for (i = 0; i < g.nu; i++) {
			size_t p = (size_t)j*g.nu + i;
			int within = stencil_is_within(g, i, j);
			Stencil uu, vv;

			to[p] = 0;
			if (!within && !stencil_is_inner(g, i, j))
				continue;
			uu = within ? stencil_within(g, 0, 2, i, j) : stencil_at(g, 0, 2, i, j);
			vv = within ? stencil_within(g, 1, 2, i, j) : stencil_at(g, 1, 2, i, j);
			to[p] = -stencil_sum(&uu, f)/(h*h) - stencil_sum(&vv, f)/(k*k);
		}
}

int
cap_excess(Chart g, const double *lambda, const double *H, double *x)
{
	Range columns = stencil_apart(g, 0, RINGS), rows = stencil_apart(g, 1, RINGS);
	size_t n = (size_t)g.nu*g.nv, p;
	double *f = malloc(2*n*sizeof *f), *work = f + n;
	int i, j;

	if (!f)
		return CAP_ENOMEM;
	for (p = 0; p < n; p++)
		f[p] = log(lambda[p]);
	curvature(g, f, x);
	smooth(g, x, work);
	for (p = 0; p < n; p++)
		f[p] = lambda[p]*H[p];
	smooth(g, f, work);
	for (p = 0, j = 0; j < g.nv; j++)
		for (i = 0; i < g.nu; i++, p++) {
			int apart = i >= columns.from && i < columns.to && j >= rows.from && j < rows.to;

			x[p] = apart ? fmax(0, x[p] - f[p]*f[p]) : 0;
		}
	free(f);
	return 0;
}

double
cap_integral(Chart g, const double *x)
{
	size_t n = (size_t)g.nu*g.nv, p;
	double sum = 0;

	for (p = 0; p < n; p++)
		sum += x[p];
	return sum*chart_h(g)*chart_k(g);
}

int
cap_lower(Chart g, const double *x, double *lambda, double *H)
{
	size_t n = (size_t)g.nu*g.nv, p;
	double *e, f;
	Plate plate;

	if (g.nu <= 2*RINGS || g.nv <= 2*RINGS)
		return 0;
	e = calloc(3*n, sizeof *e);                     /* plate_solve is for three fields */
	if (!e || plate_init(&plate, g, 0)) {
		free(e);
		return CAP_ENOMEM;
	}
	memcpy(e, x, n*sizeof *e);
	plate_solve(&plate, 0, 1, 0, e);                /* -e */
	for (p = 0; p < n; p++) {
		f = exp(-SHARE*e[p]);
		lambda[p] *= f;
		H[p] /= f*f;
	}
	plate_free(&plate);
	free(e);
	return 0;
}
