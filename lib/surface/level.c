/* level.c - the grids from coarse to fine of the surface method. */
#include <math.h>
#include <stdlib.h>

#include "../grid/resample.h"
#include "../grid/stencil.h"
#include "../poisson/plate.h"
#include "level.h"
#include "round.h"

enum { COARSEST = 65*65 };      /* fewest nodes of a coarse grid */
static const double SQUARE = M_SQRT2;   /* below this ratio of the steps both axes are coarsened; above,
                                         * cells become more nearly square if only one is */
static const double WHOLE[2] = { 1, 1 };

size_t
level_nodes(Chart g)
{
	return (size_t)g.nu*g.nv;
}

/* The fewest nodes along an axis that have at least the steps of g over `by`. */
static int
divided(Chart g, int axis, double by)
{
	const int *joined = g.kind->joined[axis];

	return (int)ceil(chart_steps(g, axis)/by + 1 - (joined[0] + joined[1])*0.5);
}

Chart
level_thinned(Chart g, int steps)
{
	double by = fmin(chart_steps(g, 0), chart_steps(g, 1))/steps;

	return by > 1 ? plate_fast((Chart){ divided(g, 0, by), divided(g, 1, by), g.T, g.kind }) : g;
}

/* The chart with half as many steps in both directions, or only in the one with clearly shorter steps; about
 * half on a sock. */
static Chart
coarser(Chart g)
{
	double h = chart_h(g), k = chart_k(g);
	Chart c = g;

	if (h < SQUARE*k)
		c.nu = divided(g, 0, 2);
	if (k < SQUARE*h)
		c.nv = divided(g, 1, 2);
	return plate_fast(c);
}

int
level_has_coarser(Chart g)
{
	return level_nodes(coarser(g)) >= COARSEST;
}

void
level_free(Level *l)
{
	free(l->lambda2);
	free(l->l2H);
	free(l->phi);
}

int
level_interpolate(Chart from, const double end[2], const double *f, double factor, Chart g, int rings,
	double *phi)
{
	Range columns = stencil_apart(g, 0, rings), rows = stencil_apart(g, 1, rings);
	double *t = malloc(level_nodes(g)*sizeof *t);
	int c, i, j, e = t ? 0 : LEVEL_ENOMEM;

	for (c = 0; !e && c < 3; c++) {
		e = resample_cubic(from, end, f + c*level_nodes(from), g, t);
		for (j = rows.from; !e && j < rows.to; j++)
			for (i = columns.from; i < columns.to; i++)
				phi[c*level_nodes(g) + (size_t)j*g.nu + i] = t[(size_t)j*g.nu + i]*factor;
	}
	free(t);
	return e;
}

/* x times (or, if over, divided by) factor, [n]. */
static void
scale_by(size_t n, const double *factor, int over, const double *x, double *y)
{
	size_t p;

	for (p = 0; p < n; p++)
		y[p] = over ? x[p]/factor[p] : x[p]*factor[p];
}

/* Averages a density, a field with the factor lambda^2, to the coarser grid c.  On a chart with cones it
 * is divided by lambda0^2 meanwhile, since both are 0 at a cone (round.h). */
static int
coarsen_density(Chart g, const double *f, Chart c, double *to)
{
	double *fine, *coarse, *smooth = malloc(level_nodes(g)*sizeof *smooth);
	int e = round2(g, &fine) || round2(c, &coarse) || !smooth ? LEVEL_ENOMEM : 0;

	if (!e && !fine)
		e = resample_mean(g, f, c, to);
	else if (!e) {
		scale_by(level_nodes(g), fine, 1, f, smooth);
		e = resample_mean(g, smooth, c, to);
		scale_by(level_nodes(c), coarse, 0, to, to);
	}
	free(fine);
	free(coarse);
	free(smooth);
	return e;
}

int
level_coarsen(const Level *f, Level *l)
{
	int c, e = LEVEL_ENOMEM;

	l->g = coarser(f->g);
	l->lambda2 = malloc(level_nodes(l->g)*sizeof(double));
	l->l2H = malloc(level_nodes(l->g)*sizeof(double));
	l->phi = malloc(3*level_nodes(l->g)*sizeof(double));
	if (l->lambda2 && l->l2H && l->phi)
		e = coarsen_density(f->g, f->lambda2, l->g, l->lambda2);
	if (!e)
		e = coarsen_density(f->g, f->l2H, l->g, l->l2H);
	for (c = 0; !e && c < 3; c++)
		e = resample_cubic(f->g, WHOLE, f->phi + c*level_nodes(f->g), l->g, l->phi + c*level_nodes(l->g));
	return e;
}
