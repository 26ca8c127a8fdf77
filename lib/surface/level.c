/* level.c - the grids from coarse to fine of the surface method. */
#include <math.h>
#include <stdlib.h>

#include "../grid/resample.h"
#include "level.h"

enum { COARSEST = 65*65 };      /* fewest nodes of a coarse grid */
static const double SQUARE = M_SQRT2;   /* below this ratio of the steps both axes are coarsened; above,
                                         * cells become more nearly square if only one is */
static const double WHOLE[2] = { 1, 1 };

size_t
level_nodes(Chart g)
{
	return (size_t)g.nu*g.nv;
}

/* The chart with half as many steps in both directions, or only in the one with clearly shorter steps. */
static Chart
coarser(Chart g)
{
	double h = chart_h(g), k = chart_k(g);
	Chart c = g;

	if (h < SQUARE*k)
		c.nu = g.nu/2 + 1;
	if (k < SQUARE*h)
		c.nv = g.nv/2 + 1;
	return c;
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
	double *t = malloc(level_nodes(g)*sizeof *t);
	int c, i, j, e = t ? 0 : LEVEL_ENOMEM;

	for (c = 0; !e && c < 3; c++) {
		e = resample_cubic(from, end, f + c*level_nodes(from), g, t);
		for (j = rings; !e && j < g.nv - rings; j++)
			for (i = rings; i < g.nu - rings; i++)
				phi[c*level_nodes(g) + (size_t)j*g.nu + i] = t[(size_t)j*g.nu + i]*factor;
	}
	free(t);
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
		e = resample_mean(f->g, f->lambda2, l->g, l->lambda2);
	if (!e)
		e = resample_mean(f->g, f->l2H, l->g, l->l2H);
	for (c = 0; !e && c < 3; c++)
		e = resample_cubic(f->g, WHOLE, f->phi + c*level_nodes(f->g), l->g, l->phi + c*level_nodes(l->g));
	return e;
}
