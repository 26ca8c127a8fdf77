/* misfit.c - the energy of a surface, its residuals and its weights. */
#include <stdlib.h>
#include <string.h>

#include "misfit.h"
#include "misfitborder.h"
#include "misfitnode.h"
#include "misfitplace.h"
#include "round.h"

static const double FINEST = 2;         /* |H| is clipped so that n turns by at most this angle, in
                                         * radians, over a cell */
static const double BLUR = 1e-6;        /* smooths n where phi_u x phi_v is small, misfit.h */


static double
clip(const Misfit *m, double lambda2, double l2H)
{
	double q = sqrt(misfit_step2(m->g)/lambda2)*fabs(l2H);

	return q > FINEST && !m->residue ? l2H*FINEST/q : l2H;
}

/* |grad log(lambda/lambda0)|^2 at inner node (i,j). */
static double
gradient2(const Misfit *m, int i, int j)
{
	Stencil su = stencil_at(m->g, 0, 1, i, j), sv = stencil_at(m->g, 1, 1, i, j);
	double u = log(misfit_size2(m, su.node[0])/misfit_size2(m, su.node[2]))/(4*chart_h(m->g));
	double v = log(misfit_size2(m, sv.node[0])/misfit_size2(m, sv.node[2]))/(4*chart_k(m->g));

	return u*u + v*v;
}

static void
fill(Misfit *m, const double *lambda2, const double *l2H)
{
	size_t n = (size_t)m->g.nu*m->g.nv, p;
	Range columns = stencil_inner(m->g, 0), rows = stencil_inner(m->g, 1);
	double sum = 0;
	int i, j;

	for (p = 0; p < n; p++) {
		m->lambda2[p] = lambda2[p];
		m->l2H2[p] = 2*clip(m, lambda2[p], l2H[p]);
		m->o[p] = 0;
	}
	for (j = rows.from; j < rows.to; j++)
		for (i = columns.from; i < columns.to; i++)
			sum += lambda2[(size_t)j*m->g.nu + i];
	m->scale = m->g.T*stencil_inner_count(m->g)/sum;
	for (j = rows.from; j < rows.to; j++)
		for (i = columns.from; i < columns.to; i++) {
			p = (size_t)j*m->g.nu + i;
			m->o[p] = misfit_weight(m, p, gradient2(m, i, j));
		}
}

int
misfit_init(Misfit *m, Chart g, const double *lambda2, const double *l2H, const Residue *residue)
{
	size_t n = (size_t)g.nu*g.nv;

	*m = (Misfit){ .g = g, .residue = residue, .blur = residue ? 0 : BLUR, .stretch = 1 };
	m->lambda2 = malloc(n*sizeof(double));
	m->l2H2 = malloc(n*sizeof(double));
	m->o = malloc(n*sizeof(double));
	m->row = malloc(2*(size_t)g.nv*sizeof(double));
	m->work = malloc((size_t)misfit_strips(g)*27*(g.nu + 2)*sizeof(double));
	if (!m->lambda2 || !m->l2H2 || !m->o || !m->row || !m->work || round2(g, &m->round)) {
		misfit_free(m);
		return MISFIT_ENOMEM;
	}
	fill(m, lambda2, l2H);
	return 0;
}

void
misfit_set_free(Misfit *m)
{
	m->free = 1;
	misfit_border_weights(m);
}

int
misfit_set_firm(Misfit *m, double reach)
{
	int n = m->g.nu*m->g.nv, p, c;
	double r;

	if (m->g.kind->cones == 0 || !(reach > 0))
		return 0;
	m->firm = malloc(n*sizeof *m->firm);
	for (p = 0; m->firm && p < n; p++) {
		for (r = HUGE_VAL, c = 0; c < m->g.kind->cones; c++)
			r = fmin(r, chart_from_cone(m->g, c, p));
		m->firm[p] = 1 + reach*reach/(r*r);
	}
	return m->firm ? 0 : MISFIT_ENOMEM;
}

void
misfit_free(Misfit *m)
{
	free(m->lambda2);
	free(m->l2H2);
	free(m->o);
	free(m->round);
	free(m->firm);
	free(m->row);
	free(m->work);
	free(m->hold);
	memset(m, 0, sizeof *m);
}

/* Adds the sums of the rows in a fixed order, so that the total does not depend on the number of
 * threads. */
static double
total(const Misfit *m, const double *row)
{
	Range rows = stencil_inner(m->g, 1);
	double sum = 0;
	int j;

	for (j = rows.from; j < rows.to; j++)
		sum += row[j];
	return sum;
}

/* Sets e to the contributions of the four nodes of q to E. */
static void
energy_of(const Misfit *m, const double *phi, const Quad *q, Nodes *e)
{
	Nodes r[MISFIT_PARTS], w[MISFIT_PARTS];
	Local a;
	int c;

	local(m, phi, q, &a);
	residuals(m, &a, q, r);
	weights(m, q, w);
	*e = w[0]*r[0]*r[0];
	for (c = 1; c < MISFIT_PARTS; c++)
		*e += w[c]*r[c]*r[c];
}

double
misfit_energy(const Misfit *m, const double *phi)
{
	Range columns = stencil_inner(m->g, 0), rows = stencil_inner(m->g, 1);
	double most;
	size_t at;
	int j, k;

#pragma omp parallel for schedule(static) private(k)
	for (j = rows.from; j < rows.to; j++) {
		Quad q;
		Nodes e;

		m->row[j] = 0;
		for (q = quad_row(m->g, columns, j); q.count > 0; quad_next(&q)) {
			energy_of(m, phi, &q, &e);
			for (k = 0; k < q.count; k++)
				m->row[j] += e[k];
		}
		if (m->place)
			m->row[j] += misfit_place_row(m, phi, j);
	}
	return total(m, m->row) + (m->free ? misfit_border_energy(m, phi, &at, &most) : 0);
}

size_t
misfit_worst(const Misfit *m, const double *phi)
{
	Range columns = stencil_inner(m->g, 0), rows = stencil_inner(m->g, 1);
	size_t at = (size_t)rows.from*m->g.nu + columns.from;
	double most = -1;
	int j, k;
	Nodes e;
	Quad q;

	if (m->free)
		misfit_border_energy(m, phi, &at, &most);
	for (j = rows.from; j < rows.to; j++)
		for (q = quad_row(m->g, columns, j); q.count > 0; quad_next(&q)) {
			energy_of(m, phi, &q, &e);
			for (k = 0; k < q.count; k++)
				if (!(e[k] <= most)) {
					most = e[k];
					at = q.p + k;
				}
		}
	return at;
}

double
misfit_scale_error(const Misfit *m, const double *phi)
{
	Range columns = stencil_inner(m->g, 0), rows = stencil_inner(m->g, 1);
	double *weight = m->row + m->g.nv, o2, x;
	int j, k;

#pragma omp parallel for schedule(static) private(k, o2, x)
	for (j = rows.from; j < rows.to; j++) {
		Nodes r[MISFIT_PARTS];
		Local a;
		Quad q;

		m->row[j] = weight[j] = 0;
		for (q = quad_row(m->g, columns, j); q.count > 0; quad_next(&q)) {
			local(m, phi, &q, &a);
			residuals(m, &a, &q, r);
			for (k = 0; k < q.count; k++) {
				o2 = m->o[q.p+k]*m->o[q.p+k];
				m->row[j] += o2*r[3][k]*r[3][k]/m->lambda2[q.p+k];
				weight[j] += o2*m->lambda2[q.p+k];
			}
		}
	}
	x = total(m, weight);
	return x > 0 ? sqrt(total(m, m->row)/x) : 0;
}
