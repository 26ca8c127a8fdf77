/* patchsolve.c - the matrix of the unresolved nodes, and its products. */
#include <math.h>
#include <string.h>

#include "patchnode.h"

static const double SHIFT = 1e-12;      /* times the largest diagonal entry, added to the diagonal:
                                         * A_SS is singular at nodes of weight 0 */

/* The derivatives of the weighted residuals of node q with respect to q and its four neighbours.  Each
 * of the four lanes computes a different residual of this node. */
static void
derivatives(const Misfit *m, const double *phi, int q, double *J)
{
	Quad quad = { .g = m->g, .per_h = chart_steps(m->g, 0), .per_k = chart_steps(m->g, 1)/m->g.T,
	    .i = q%m->g.nu, .j = q/m->g.nu, .count = 1, .p = q };
	double h = quad.per_h, k = quad.per_k;
	Nodes w[MISFIT_PARTS], r[MISFIT_PARTS], f[9];
	Local a;
	int e, from, c;

	local(m, phi, &quad, &a);
	weights(m, &quad, w);
	for (from = 0; from < MISFIT_PARTS; from += NODES) {
		memset(r, 0, sizeof r);
		for (e = from; e < MISFIT_PARTS && e < from + NODES; e++)
			r[e][e-from] = sqrt(w[e][0]);
		change_adjoint(&a, r, f);
		for (e = from; e < MISFIT_PARTS && e < from + NODES; e++)
			for (c = 0; c < 3; c++) {
				double u = f[c][e-from]*h/2, v = f[3+c][e-from]*k/2, L = f[6+c][e-from];

				J[NUMBERS*e+c] = -2*L*(h*h + k*k);
				J[NUMBERS*e+3+c] = L*h*h + u;
				J[NUMBERS*e+6+c] = L*h*h - u;
				J[NUMBERS*e+9+c] = L*k*k + v;
				J[NUMBERS*e+12+c] = L*k*k - v;
			}
	}
}

/* Adds block (ka,kb) of J'J of row r. */
static void
add_block(Patch *p, int r, int ka, int kb)
{
	const double *J = p->J + (size_t)JACOBIAN*r, *x = J + 3*ka, *y = J + 3*kb;
	int b = p->number[p->beside[BESIDE*r+kb]], place = p->place[BESIDE*(BESIDE*r+ka)+kb], c, d, e;

	if (place < 0)
		return;
	for (c = 0; c < 3; c++)
		for (d = place ? 0 : c; d < 3; d++) {
			double sum = 0;

			for (e = 0; e < JACOBIAN; e += NUMBERS)
				sum += x[e+d]*y[e+c];
			p->value[p->column[3*b+c] + 3*place + d - c] += sum;
		}
}

int
patch_set(Patch *p, const double *phi)
{
	double most = 0;
	int r, k, i;

#pragma omp parallel for schedule(static)
	for (r = 0; r < p->rows; r++)
		derivatives(p->m, phi, p->row[r], p->J + (size_t)JACOBIAN*r);
	memset(p->value, 0, p->column[3*p->nodes]*sizeof *p->value);
	for (r = 0; r < p->rows; r++)
		for (k = 0; k < BESIDE*BESIDE; k++)
			add_block(p, r, k/BESIDE, k%BESIDE);
	for (i = 0; i < 3*p->nodes && p->m->place; i++)
		p->value[p->column[i]] += p->m->hold[p->node[i/3]];
	for (i = 0; i < 3*p->nodes; i++)
		most = fmax(most, p->value[p->column[i]]);
	for (i = 0; i < 3*p->nodes; i++)
		p->value[p->column[i]] += SHIFT*most;
	if (!(most > 0 && isfinite(most)))
		return PATCH_EINDEFINITE;
	switch (spd_factor_set(p->factor, p->value)) {
	case 0: return 0;
	case SPD_EINDEFINITE: return PATCH_EINDEFINITE;
	default: return PATCH_ENOMEM;
	}
}

double
patch_start(Patch *p, const double *r, double *d)
{
	size_t n = (size_t)p->m->g.nu*p->m->g.nv;
	double sum = 0;
	int i, c;

	for (i = 0; i < p->nodes; i++)
		for (c = 0; c < 3; c++)
			p->b[3*i+c] = r[c*n + p->node[i]];
	if (spd_factor_solve(p->factor, p->b))
		return NAN;
	for (i = 0; i < p->nodes; i++)
		for (c = 0; c < 3; c++) {
			d[c*n + p->node[i]] = p->b[3*i+c];
			sum += p->b[3*i+c]*r[c*n + p->node[i]];
		}
	return sum;
}

/* s = J_S' J_R z_R of row r, R being the nodes outside S. */
static void
product(Patch *p, const double *z, int r)
{
	size_t n = (size_t)p->m->g.nu*p->m->g.nv;
	const double *J = p->J + (size_t)JACOBIAN*r;
	double x[NUMBERS], *s = p->s + (size_t)NUMBERS*r, y;
	int k, c, e;

	for (k = 0; k < BESIDE; k++)
		for (c = 0; c < 3; c++) {
			int q = p->beside[BESIDE*r+k];

			x[3*k+c] = p->number[q] < 0 ? z[c*n + q] : 0;
			s[3*k+c] = 0;
		}
	for (e = 0; e < JACOBIAN; e += NUMBERS) {
		for (y = 0, k = 0; k < NUMBERS; k++)
			y += J[e+k]*x[k];
		for (k = 0; k < NUMBERS; k++)
			s[k] += J[e+k]*y;
	}
}

int
patch_correct(Patch *p, double *z)
{
	size_t n = (size_t)p->m->g.nu*p->m->g.nv;
	int r, k, i, c, a;

#pragma omp parallel for schedule(static)
	for (r = 0; r < p->edge; r++)
		product(p, z, r);
	memset(p->b, 0, 3*(size_t)p->nodes*sizeof *p->b);
	for (k = 0; k < BESIDE*p->edge; k++)
		if ((a = p->number[p->beside[k]]) >= 0)
			for (c = 0; c < 3; c++)
				p->b[3*a+c] -= p->s[3*k+c];
	if (spd_factor_solve(p->factor, p->b))
		return PATCH_ENOMEM;
	for (i = 0; i < p->nodes; i++)
		for (c = 0; c < 3; c++)
			z[c*n + p->node[i]] = p->b[3*i+c];
	return 0;
}

void
patch_clear(const Patch *p, double *x)
{
	size_t n = (size_t)p->m->g.nu*p->m->g.nv;
	int i, c;

	for (i = 0; i < p->nodes; i++)
		for (c = 0; c < 3; c++)
			x[c*n + p->node[i]] = 0;
}
