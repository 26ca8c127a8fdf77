/* multigrid.c - the V-cycle, and the coarsest matrix by Cholesky. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "multigrid.h"

enum { FEW = 30 };              /* unknowns that are solved directly */

/* The weights of the two steps of Jacobi: the reciprocals of the zeros of the Chebyshev polynomial of
 * degree 2 on [2/5, 2], the interval of the eigenvalues of D^-1 A for waves that the coarser grid
 * does not represent. */
static const double RELAX[2] = { 1/(1.2 + 0.8*M_SQRT1_2), 1/(1.2 - 0.8*M_SQRT1_2) };

/* The number of unknowns of the coarsest grid so far. */
static int
coarsest(const Multigrid *m)
{
	const Multilevel *l = &m->level[m->levels-1];

	return l->n[0]*l->n[1];
}

void
multigrid_free(Multigrid *m)
{
	while (m->levels > 0)
		multilevel_free(&m->level[--m->levels]);
	free(m->mass);
	free(m->factor);
	memset(m, 0, sizeof *m);
}

/* store copies a field [nv][nu] into one with a rim (multilevel.h), unstore copies it back and puts 0 at
 * held nodes. */
static void
store(const Multilevel *l, const double *field, double *x)
{
	int j;

	for (j = 0; j < l->n[1]; j++)
		memcpy(x + multilevel_place(l, 0, j), field + (size_t)(j + l->from[1])*l->g.nu + l->from[0],
		    l->n[0]*sizeof *x);
}

static void
unstore(const Multilevel *l, const double *x, double *field)
{
	int before = l->from[0], after = l->g.nu - before - l->n[0], j;

	memset(field, 0, (size_t)l->from[1]*l->g.nu*sizeof *field);
	field += (size_t)l->from[1]*l->g.nu;
	for (j = 0; j < l->n[1]; j++, field += l->g.nu) {
		memset(field, 0, before*sizeof *field);
		memcpy(field + before, x + multilevel_place(l, 0, j), l->n[0]*sizeof *x);
		memset(field + l->g.nu - after, 0, after*sizeof *field);
	}
	memset(field, 0, (size_t)(l->g.nv - l->from[1] - l->n[1])*l->g.nu*sizeof *field);
}

/* The densities times the areas of the cells. */
static void
set_mass(Multigrid *m, const double *density)
{
	Multilevel *l = &m->level[0];
	double h = chart_h(m->g), k = chart_k(m->g);
	int i, j;

	store(l, density, l->mass);
	for (j = 0; j < l->n[1]; j++)
		for (i = 0; i < l->n[0]; i++)
			l->mass[multilevel_place(l, i, j)] *= h*l->width[0][i]*k*l->width[1][j];
	unstore(l, l->mass, m->mass);
}

int
multigrid_init(Multigrid *m, Chart g, int held, const double *density)
{
	int e, n;

	*m = (Multigrid){ .g = g, .levels = 0 };
	m->mass = malloc((size_t)g.nu*g.nv*sizeof *m->mass);
	e = m->mass ? multilevel_init(&m->level[0], g, held) : MULTIGRID_ENOMEM;
	if (!e) {
		m->levels = 1;
		set_mass(m, density);
	}
	while (!e && coarsest(m) > FEW && m->levels < MULTIGRID_MOST && multilevel_coarser(&m->level[m->levels-1], &g)) {
		Multilevel *l = &m->level[m->levels-1], *c = l + 1;

		e = multilevel_init(c, g, held);
		if (e)
			break;
		m->levels++;
		e = multilevel_join(l, c);
		if (!e)
			multilevel_restrict(l, c, l->mass, c->mass);
	}
	if (!e) {
		n = coarsest(m);
		m->factor = malloc((size_t)n*n*sizeof *m->factor);
	}
	if (m->factor)
		return 0;
	multigrid_free(m);
	return MULTIGRID_ENOMEM;
}

/* Computes the factor L of the coarsest A = L L'; the columns of A are its products with unit vectors. */
static void
factor(Multigrid *m)
{
	Multilevel *l = &m->level[m->levels-1];
	int n = coarsest(m), width = l->n[0], p, q, k;
	double *L = m->factor;

	for (p = 0; p < n; p++) {
		memset(l->x, 0, multilevel_row(l)*(l->n[1] + 2)*sizeof(double));
		l->x[multilevel_place(l, p%width, p/width)] = 1;
		multilevel_apply(l, m->t, 1, l->x, l->r);
		for (q = p; q < n; q++)
			L[q*n+p] = l->r[multilevel_place(l, q%width, q/width)];
	}
	for (p = 0; p < n; p++)
		for (q = p; q < n; q++) {
			for (k = 0; k < p; k++)
				L[q*n+p] -= L[q*n+k]*L[p*n+k];
			L[q*n+p] = q == p ? sqrt(L[q*n+p]) : L[q*n+p]/L[p*n+p];
		}
}

static void
solve_coarsest(Multigrid *m)
{
	Multilevel *l = &m->level[m->levels-1];
	int n = coarsest(m), width = l->n[0], p, k;
	const double *L = m->factor;
	double y[n];

	for (p = 0; p < n; p++) {
		y[p] = l->b[multilevel_place(l, p%width, p/width)];
		for (k = 0; k < p; k++)
			y[p] -= L[p*n+k]*y[k];
		y[p] /= L[p*n+p];
	}
	for (p = n - 1; p >= 0; p--) {
		for (k = p + 1; k < n; k++)
			y[p] -= L[k*n+p]*y[k];
		y[p] /= L[p*n+p];
		l->x[multilevel_place(l, p%width, p/width)] = y[p];
	}
}

void
multigrid_set(Multigrid *m, double t)
{
	int q;

	m->t = t;
	for (q = 0; q < m->levels; q++)
		multilevel_diagonal(&m->level[q], t);
	factor(m);
}

void
multigrid_stiffness(Multigrid *m, const double *x, double *y)
{
	Multilevel *l = &m->level[0];

	store(l, x, l->x);
	multilevel_apply(l, 1, 0, l->x, l->r);
	unstore(l, l->r, y);
}

/* Sets l->x to about A^-1 l->b on level `at`. */
static void
cycle(Multigrid *m, int at)
{
	Multilevel *l = &m->level[at];

	if (at == m->levels - 1) {
		solve_coarsest(m);
		return;
	}
	multilevel_begin(l, RELAX[0]);
	multilevel_relax(l, m->t, RELAX[1]);
	multilevel_residual(l, m->t);
	multilevel_restrict(l, l + 1, l->r, l[1].b);
	cycle(m, at + 1);
	multilevel_prolong(l, l + 1);
	multilevel_relax(l, m->t, RELAX[1]);
	multilevel_relax(l, m->t, RELAX[0]);
}

void
multigrid_cycle(Multigrid *m, const double *b, double *x)
{
	store(&m->level[0], b, m->level[0].b);
	cycle(m, 0);
	unstore(&m->level[0], m->level[0].x, x);
}
