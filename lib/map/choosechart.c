/* choosechart.c - cones at vertices, and where the sock is clearly better. */
#include <math.h>
#include <stdlib.h>

#include "choosechart.h"

/* The vertex of z nearest to the point a of the disk, as a hyperbolic distance; one on the boundary is
 * none. */
static int
nearest_vertex(int n, const double complex *z, double complex a)
{
	int i, best = -1;
	double d, least = HUGE_VAL;

	for (i = 0; i < n; i++) {
		d = cabs((z[i] - a)/(1 - conj(a)*z[i]));
		if (d < least && cabs(z[i]) < 1 - 1e-9) {
			least = d;
			best = i;
		}
	}
	return best;
}

/* Sets chi^2, and the cones of a sock; unless that is `wanted`, only if it might be clearly better.  z: of the
 * vertices, in the unit disk. */
static int
find_cones(const Disk *d, const int corner[4], const int given[2], int wanted, const double complex *z,
	Conformal *c)
{
	double complex at[4];
	Parts parts;
	int k;

	if (parts_init(&parts, &d->m, z))
		return SPD_ENOMEM;
	for (k = 0; k < 4; k++)
		at[k] = z[d->loop[corner[k]]];
	c->chi2[0] = parts_rectangle(&parts, at);
	for (k = 0; k < 2; k++)
		c->cone[k] = given[k];
	if (given[0] < 0 && (wanted || c->chi2[0] > CONFORMAL_CLEARLY)) {
		cones_choose(&parts, at);
		for (k = 0; k < 2; k++)
			c->cone[k] = nearest_vertex(d->m.nv, z, at[k]);
	}
	if (c->cone[0] >= 0 && c->cone[1] >= 0 && c->cone[0] != c->cone[1])
		c->chi2[1] = parts_sock(&parts, z[c->cone[0]], z[c->cone[1]]);
	parts_free(&parts);
	return 0;
}

int
choosechart(const Disk *d, const int corner[4], const Rectangle *r, const ConformalOptions *o,
	const ChartKind **kind, ChartMap *map, Conformal *c)
{
	double complex *z = malloc(d->m.nv*sizeof *z);
	double T = r->T;
	int i, e;

	if (!z)
		return SPD_ENOMEM;
	#pragma omp parallel for schedule(static)
	for (i = 0; i < d->m.nv; i++)
		z[i] = chartmap_disk(T, r->u[i], r->v[i]);
	e = find_cones(d, corner, o->cone, (*kind)->folded, z, c);
	if (!e && o->choose && c->chi2[1] > 0 && c->chi2[0] > CONFORMAL_CLEARLY*c->chi2[1])
		*kind = &CHART_SOCK;
	*map = chartmap_rectangle(T);
	if (!e && (*kind)->folded) {
		if (c->chi2[1] > 0)
			*map = chartmap_sock(T, z[c->cone[0]], z[c->cone[1]]);
		else
			e = CONFORMAL_ECONES;
	}
	free(z);
	return e;
}
