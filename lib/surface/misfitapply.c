/* misfitapply.c - products with the Jacobian of the residuals and with its transpose.
 *
 * In one pass over the rows: the nodes of a row say what they want changed in phi_u, phi_v
 * and Delta phi; of three such rows is made the middle row of the result.
 */
#include <stdlib.h>
#include <string.h>

#include "misfit.h"
#include "misfitborder.h"
#include "misfitnode.h"

/* What inner row j wants, nine rows f, to get nearer to J d; without d, to the residuals. */
INLINE void
wants(const Misfit *m, const double *phi, const double *d, int j, double *f)
{
	Nodes r[MISFIT_PARTS], w[MISFIT_PARTS], e[9];
	int i, c, count, nu = m->g.nu;
	size_t p = (size_t)j*nu;
	Local a;

	for (i = 1; i < nu - 1; i += count) {
		count = nu - 1 - i < NODES ? nu - 1 - i : NODES;
		local(m, phi, p + i, count, &a);
		if (d)
			change(m, &a, d, p + i, count, r);
		else
			residuals(m, &a, p + i, count, r);
		weights(m, p + i, count, w);
		for (c = 0; c < MISFIT_PARTS; c++)
			r[c] *= w[c];
		spread(&a, r, e);
		for (c = 0; c < 9; c++)
			memcpy(f + (size_t)c*nu + i, &e[c], count*sizeof *f);
	}
}

TARGET("avx2") static void
wants_256(const Misfit *m, const double *phi, const double *d, int j, double *f)
{
	wants(m, phi, d, j, f);
}

static void
spread_row(const Misfit *m, const double *phi, const double *d, int j, double *f)
{
	int c, nu = m->g.nu;

	if (j <= 0 || j >= m->g.nv - 1) {
		memset(f, 0, 9*(size_t)nu*sizeof *f);
		return;
	}
	for (c = 0; c < 9; c++)
		f[(size_t)c*nu] = f[(size_t)(c + 1)*nu - 1] = 0;
	if (HAS("avx2"))
		wants_256(m, phi, d, j, f);
	else
		wants(m, phi, d, j, f);
}

/* The transposes of the differences: row j of g from what rows j-1, j, j+1 want. */
static void
gather_row(const Misfit *m, double *const f[3], int j, double *g)
{
	Chart chart = m->g;
	double h = chart.nu - 1, k = (chart.nv - 1)/chart.T;
	int c, i, nu = chart.nu;

	for (c = 0; c < 3; c++, g += (size_t)nu*chart.nv) {
		const double *u = f[1] + c*nu, *below = f[0] + (3+c)*nu, *above = f[2] + (3+c)*nu;
		const double *L = f[1] + (6+c)*nu, *L0 = f[0] + (6+c)*nu, *L2 = f[2] + (6+c)*nu;
		double *out = g + (size_t)j*nu;

		for (i = 1; i < nu - 1; i++)
			out[i] = (u[i-1] - u[i+1])*(h/2) + (below[i] - above[i])*(k/2)
			    + (L[i+1] - 2*L[i] + L[i-1])*(h*h) + (L2[i] - 2*L[i] + L0[i])*(k*k);
		out[0] = m->free ? L[1]*(h*h) - u[1]*(h/2) : 0;
		out[nu-1] = m->free ? L[nu-2]*(h*h) + u[nu-2]*(h/2) : 0;
	}
}

static void
strip(const Misfit *m, const double *phi, const double *d, int from, int to, double *work, double *g)
{
	size_t rows = 9*(size_t)m->g.nu;
	double *f[3] = { work, work + rows, work + 2*rows }, *free;
	int j;

	spread_row(m, phi, d, from - 1, f[0]);
	spread_row(m, phi, d, from, f[1]);
	for (j = from; j < to; j++) {
		spread_row(m, phi, d, j + 1, f[2]);
		gather_row(m, f, j, g);
		free = f[0], f[0] = f[1], f[1] = f[2], f[2] = free;
	}
}

static void
apply(const Misfit *m, const double *phi, const double *d, double *g)
{
	int strips = misfit_strips(m->g), inner = m->g.nv - 2, s;
	size_t n = (size_t)m->g.nu*m->g.nv, row = m->g.nu*sizeof *g;

#pragma omp parallel for schedule(static)
	for (s = 0; s < strips; s++)
		strip(m, phi, d, 1 + inner*s/strips, 1 + inner*(s + 1)/strips,
		    m->work + (size_t)s*27*m->g.nu, g);
	if (m->free) {
		strip(m, phi, d, 0, 1, m->work, g);
		strip(m, phi, d, m->g.nv - 1, m->g.nv, m->work, g);
		misfit_border_apply(m, phi, d, g);
	}
	for (s = 0; s < 3 && !m->free; s++) {
		memset(g + s*n, 0, row);
		memset(g + (s + 1)*n - m->g.nu, 0, row);
	}
}

void
misfit_gradient(const Misfit *m, const double *phi, double *g)
{
	apply(m, phi, NULL, g);
}

void
misfit_normal(const Misfit *m, const double *phi, const double *d, double *g)
{
	apply(m, phi, d, g);
}
