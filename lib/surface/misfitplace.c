/* misfitplace.c - the line of the misfit that holds the place. */
#include <math.h>
#include <stdlib.h>

#include "misfitborder.h"
#include "misfitnode.h"
#include "misfitplace.h"

/* The wave number up to which the place holds everywhere is the geometric mean of two: 1/s, up to which
 * the filter keeps waves of the place, and 8 cycles per square root of the area.  lambda and H do not
 * determine long waves well, since an error of H is magnified by 1/k^2, k the wave number.  If the
 * place held up to 1/s, surfaces with folds would get the defects of filtered positions; if up to 8
 * cycles, a face at a small scale would move by a fifth more than with the mean.  A closed surface has no boundary
 * that holds it, and 11 cycles serve better. */
static const double CYCLES = 8, CYCLES_CLOSED = 11;
/* The place also holds waves down to a length of seven steps where the grid does not resolve the
 * surface, and at the border.  There H is extrapolated, and its filter is free at the sides while that
 * of the place is held.  At the border this stiffness halves with each ring of nodes. */
static const double SHORTEST = 7, RING = 0.5;
static const double STRETCH = 0.01;     /* share of the third line: lambda counts less than the place */

static double
fourth(double x)
{
	return x*x*x*x;
}

/* Steps from node (i,j) to the nearest open side. */
static int
ring(Chart g, int i, int j)
{
	Range u = stencil_inner(g, 0), v = stencil_inner(g, 1);
	int r = g.nu + g.nv;

	r = u.from > 0 && i < r ? i : r;
	r = u.to < g.nu && g.nu - 1 - i < r ? g.nu - 1 - i : r;
	r = v.from > 0 && j < r ? j : r;
	return v.to < g.nv && g.nv - 1 - j < r ? g.nv - 1 - j : r;
}

/* The fourth power of that geometric mean, in radians per unit of u.  In this unit 1/s is
 * <lambda^2>^(1/2)/s, and one cycle per square root of the area is 2 pi/sqrt(T). */
static double
held_everywhere(const Misfit *m, double s)
{
	double mean2 = m->g.T/m->scale, cycles = 2*M_PI*(m->g.kind->closed ? CYCLES_CLOSED : CYCLES);

	return mean2/(s*s)*(cycles*cycles/m->g.T);
}

/* kappa at inner node (i,j). */
static double
kappa(const Misfit *m, double s, int i, int j)
{
	size_t p = (size_t)j*m->g.nu + i;
	double shortest = 2*M_PI/SHORTEST/sqrt(misfit_step2(m->g));
	double unresolved = fourth(1 - m->o[p]), rim = pow(RING, ring(m->g, i, j) - 1);

	return held_everywhere(m, s) + fourth(shortest)*fmax(unresolved, rim);
}

int
misfit_hold(Misfit *m, const MisfitPlace *place)
{
	Range columns = stencil_inner(m->g, 0), rows = stencil_inner(m->g, 1);
	int i, j;

	m->place = place ? place->phi : NULL;
	m->stretch = place ? STRETCH : 1;
	m->stiffness = 0;
	if (!place)
		return 0;
	if (!m->hold)
		m->hold = calloc((size_t)m->g.nu*m->g.nv, sizeof *m->hold);
	if (!m->hold)
		return MISFIT_ENOMEM;
	for (j = rows.from; j < rows.to; j++)
		for (i = columns.from; i < columns.to; i++)
			m->hold[(size_t)j*m->g.nu + i] = m->scale*kappa(m, place->s, i, j);
	m->stiffness = m->scale*held_everywhere(m, place->s);
	return 0;
}

double
misfit_place_row(const Misfit *m, const double *phi, int j)
{
	size_t n = (size_t)m->g.nu*m->g.nv, p;
	double sum = 0, x;
	int c, i;

	for (c = 0; c < 3; c++)
		for (i = 0, p = (size_t)j*m->g.nu; i < m->g.nu; i++, p++) {
			x = phi[c*n+p] - m->place[c*n+p];
			sum += m->hold[p]*x*x;
		}
	return sum;
}

void
misfit_place_apply(const Misfit *m, const double *phi, const double *d, double *g)
{
	size_t n = (size_t)m->g.nu*m->g.nv, p;
	int c;

#pragma omp parallel for schedule(static) private(p)
	for (c = 0; c < 3; c++)
		for (p = 0; p < n; p++)
			g[c*n+p] += m->hold[p]*(d ? d[c*n+p] : phi[c*n+p] - m->place[c*n+p]);
}
