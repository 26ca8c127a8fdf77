/* misfit.c - the energy of a surface, its residuals and its weights. */
#include <stdlib.h>
#include <string.h>

#include "misfit.h"
#include "misfitborder.h"
#include "misfitnode.h"

static const double FINEST = 2;         /* turn of the normal over a cell beyond which H is clipped */
static const double BLUR = 1e-6;

static double
clip(const Misfit *m, double lambda2, double l2H)
{
	double q = sqrt(misfit_step2(m->g)/lambda2)*fabs(l2H);

	return q > FINEST && !m->residue ? l2H*FINEST/q : l2H;
}

/* |grad log lambda|^2 at inner node p. */
static double
gradient2(const Misfit *m, size_t p)
{
	double u = log(m->lambda2[p+1]/m->lambda2[p-1])/(4*chart_h(m->g));
	double v = log(m->lambda2[p+m->g.nu]/m->lambda2[p-m->g.nu])/(4*chart_k(m->g));

	return u*u + v*v;
}

static void
fill(Misfit *m, const double *lambda2, const double *l2H)
{
	size_t n = (size_t)m->g.nu*m->g.nv, p;
	double sum = 0;
	int i, j;

	for (p = 0; p < n; p++) {
		m->lambda2[p] = lambda2[p];
		m->l2H2[p] = 2*clip(m, lambda2[p], l2H[p]);
		m->o[p] = 0;
	}
	for (j = 1; j < m->g.nv - 1; j++)
		for (i = 1; i < m->g.nu - 1; i++)
			sum += lambda2[(size_t)j*m->g.nu + i];
	m->scale = (m->g.nu - 2.0)*(m->g.nv - 2.0)/sum;
	for (j = 1; j < m->g.nv - 1; j++)
		for (i = 1; i < m->g.nu - 1; i++) {
			p = (size_t)j*m->g.nu + i;
			m->o[p] = misfit_weight(m, p, gradient2(m, p));
		}
}

int
misfit_init(Misfit *m, Chart g, const double *lambda2, const double *l2H, const Residue *residue)
{
	size_t n = (size_t)g.nu*g.nv;

	*m = (Misfit){ .g = g, .residue = residue, .blur = residue ? 0 : BLUR };
	m->lambda2 = malloc(n*sizeof(double));
	m->l2H2 = malloc(n*sizeof(double));
	m->o = malloc(n*sizeof(double));
	m->row = malloc(2*(size_t)g.nv*sizeof(double));
	m->work = malloc((size_t)misfit_strips(g)*27*g.nu*sizeof(double));
	if (!m->lambda2 || !m->l2H2 || !m->o || !m->row || !m->work) {
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

void
misfit_free(Misfit *m)
{
	free(m->lambda2);
	free(m->l2H2);
	free(m->o);
	free(m->row);
	free(m->work);
	memset(m, 0, sizeof *m);
}

/* ---- sums over the nodes ---------------------------------------------- */

/* Rows are summed in their order, whatever the threads did. */
static double
total(const Misfit *m, const double *row)
{
	double sum = 0;
	int j;

	for (j = 1; j < m->g.nv - 1; j++)
		sum += row[j];
	return sum;
}

/* What so many neighbours share of E. */
static void
energy_of(const Misfit *m, const double *phi, size_t p, int count, Nodes *e)
{
	Nodes r[MISFIT_PARTS], w[MISFIT_PARTS];
	Local a;
	int c;

	local(m, phi, p, count, &a);
	residuals(m, &a, p, count, r);
	weights(m, p, count, w);
	*e = w[0]*r[0]*r[0];
	for (c = 1; c < MISFIT_PARTS; c++)
		*e += w[c]*r[c]*r[c];
}

static int
few(const Misfit *m, int i)
{
	return m->g.nu - 1 - i < NODES ? m->g.nu - 1 - i : NODES;
}

double
misfit_energy(const Misfit *m, const double *phi)
{
	double most;
	size_t at;
	int i, j, k;

#pragma omp parallel for schedule(static) private(i, k)
	for (j = 1; j < m->g.nv - 1; j++)
		for (m->row[j] = 0, i = 1; i < m->g.nu - 1; i += NODES) {
			Nodes e;

			energy_of(m, phi, (size_t)j*m->g.nu + i, few(m, i), &e);
			for (k = 0; k < few(m, i); k++)
				m->row[j] += e[k];
		}
	return total(m, m->row) + (m->free ? misfit_border_energy(m, phi, &at, &most) : 0);
}

size_t
misfit_worst(const Misfit *m, const double *phi)
{
	size_t at = m->g.nu + 1;
	double most = -1;
	int i, j, k;
	Nodes e;

	if (m->free)
		misfit_border_energy(m, phi, &at, &most);
	for (j = 1; j < m->g.nv - 1; j++)
		for (i = 1; i < m->g.nu - 1; i += NODES) {
			energy_of(m, phi, (size_t)j*m->g.nu + i, few(m, i), &e);
			for (k = 0; k < few(m, i); k++)
				if (!(e[k] <= most)) {
					most = e[k];
					at = (size_t)j*m->g.nu + i + k;
				}
		}
	return at;
}

double
misfit_scale_error(const Misfit *m, const double *phi)
{
	double *weight = m->row + m->g.nv, o2, x;
	int i, j, k;

#pragma omp parallel for schedule(static) private(i, k, o2, x)
	for (j = 1; j < m->g.nv - 1; j++)
		for (m->row[j] = weight[j] = 0, i = 1; i < m->g.nu - 1; i += NODES) {
			size_t p = (size_t)j*m->g.nu + i;
			Nodes r[MISFIT_PARTS];
			Local a;

			local(m, phi, p, few(m, i), &a);
			residuals(m, &a, p, few(m, i), r);
			for (k = 0; k < few(m, i); k++) {
				o2 = m->o[p+k]*m->o[p+k];
				m->row[j] += o2*r[3][k]*r[3][k]/m->lambda2[p+k];
				weight[j] += o2*m->lambda2[p+k];
			}
		}
	x = total(m, weight);
	return x > 0 ? sqrt(total(m, m->row)/x) : 0;
}
