/* misfitapply.c - products with the Jacobian of the residuals and with its transpose.
 *
 * This takes one pass over the rows.  For each row of nodes the adjoint values of phi_u, phi_v and
 * Delta phi are computed; the transposed differences of three such rows give the middle row of the
 * result.
 */
#include <stdlib.h>
#include <string.h>

#include "misfit.h"
#include "misfitborder.h"
#include "misfitnode.h"
#include "misfitplace.h"

/* The range of nodes along one axis whose positions are unknowns. */
static Range
unknowns(const Misfit *m, int axis)
{
	return m->free ? (Range){ 0, axis ? m->g.nv : m->g.nu } : stencil_inner(m->g, axis);
}

/* Length of a row of adjoint values, with one more at each end. */
static size_t
row_length(const Misfit *m)
{
	return (size_t)m->g.nu + 2;
}

/* The adjoint values of row j: change_adjoint of W J d, or of W r if d is NULL.  They fill nine
 * rows, three each for phi_u, phi_v and Delta phi. */
INLINE void
fill_adjoint_row(const Misfit *m, const double *phi, const double *d, int j, double *f)
{
	Nodes r[MISFIT_PARTS], w[MISFIT_PARTS], e[9];
	size_t length = row_length(m);
	Local a;
	Quad q;
	int c;

	for (q = quad_row(m->g, stencil_reach(m->g, 0), j); q.count > 0; quad_next(&q)) {
		local(m, phi, &q, &a);
		if (d)
			change(&a, d, &q, r);
		else
			residuals(m, &a, &q, r);
		weights(m, &q, w);
		for (c = 0; c < MISFIT_PARTS; c++)
			r[c] *= w[c];
		change_adjoint(&a, r, e);
		for (c = 0; c < 9; c++)
			memcpy(f + c*length + 1 + q.i, &e[c], q.count*sizeof *f);
	}
}

TARGET("avx2") static void
fill_adjoint_row_256(const Misfit *m, const double *phi, const double *d, int j, double *f)
{
	fill_adjoint_row(m, phi, d, j, f);
}

static void
adjoint_row(const Misfit *m, const double *phi, const double *d, int j, double *f)
{
	Range columns = stencil_reach(m->g, 0), rows = stencil_reach(m->g, 1);
	size_t length = row_length(m);
	int c, i;

	if (j < rows.from || j >= rows.to) {
		memset(f, 0, 9*length*sizeof *f);
		return;
	}
	for (c = 0; c < 9; c++) {
		for (i = -1; i < columns.from; i++)
			f[c*length + 1 + i] = 0;
		for (i = columns.to; i <= m->g.nu; i++)
			f[c*length + 1 + i] = 0;
	}
	if (HAS("avx2"))
		fill_adjoint_row_256(m, phi, d, j, f);
	else
		fill_adjoint_row(m, phi, d, j, f);
}

/* Computes row j of g: the transposed differences of the adjoint rows j-1, j, j+1. */
static void
result_row(const Misfit *m, double *const f[3], int j, double *g)
{
	Range r = unknowns(m, 0);
	size_t length = row_length(m);
	int c, i, k, nu = m->g.nu;

	for (c = 0; c < 3; c++, g += (size_t)nu*m->g.nv) {
		const double *v[3], *L[3];
		double *out = g + (size_t)j*nu;

		for (k = 0; k < 3; k++) {
			v[k] = f[k] + (3+c)*length + 1;
			L[k] = f[k] + (6+c)*length + 1;
		}
		for (i = 0; i < r.from; i++)
			out[i] = 0;
		stencil_transposed(m->g, r, f[1] + c*length + 1, v, L, out);
		for (i = r.to; i < nu; i++)
			out[i] = 0;
	}
}

static void
result_rows(const Misfit *m, const double *phi, const double *d, int from, int to, double *work,
	double *g)
{
	size_t rows = 9*row_length(m);
	double *f[3] = { work, work + rows, work + 2*rows }, *free;
	int j;

	if (from >= to)
		return;
	adjoint_row(m, phi, d, from - 1, f[0]);
	adjoint_row(m, phi, d, from, f[1]);
	for (j = from; j < to; j++) {
		adjoint_row(m, phi, d, j + 1, f[2]);
		result_row(m, f, j, g);
		free = f[0], f[0] = f[1], f[1] = f[2], f[2] = free;
	}
}

static void
zero_rows(const Misfit *m, int from, int to, double *g)
{
	size_t n = (size_t)m->g.nu*m->g.nv, row = m->g.nu;
	int c;

	for (c = 0; c < 3 && from < to; c++)
		memset(g + c*n + from*row, 0, (to - from)*row*sizeof *g);
}

static void
apply(const Misfit *m, const double *phi, const double *d, double *g)
{
	Range rows = stencil_inner(m->g, 1);
	int strips = misfit_strips(m->g), inner = rows.to - rows.from, s;

#pragma omp parallel for schedule(static)
	for (s = 0; s < strips; s++)
		result_rows(m, phi, d, rows.from + inner*s/strips, rows.from + inner*(s + 1)/strips,
		    m->work + s*27*row_length(m), g);
	if (m->free) {
		result_rows(m, phi, d, 0, rows.from, m->work, g);
		result_rows(m, phi, d, rows.to, m->g.nv, m->work, g);
		misfit_border_apply(m, phi, d, g);
	} else {
		zero_rows(m, 0, rows.from, g);
		zero_rows(m, rows.to, m->g.nv, g);
	}
	if (m->place)
		misfit_place_apply(m, phi, d, g);
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
