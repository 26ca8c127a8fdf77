/* borderlength.c - a harmonic change of log lambda from the lengths of borders. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../grid/stencil.h"
#include "../poisson/plate.h"
#include "borderlength.h"

static const double MOST = 2;           /* of |e|: a border may turn back in a single node, and have almost no length there */
static const double LEAST = 1e-12;      /* of the length beside a node, in lengths of the border: log 0 is no number */

/* The logarithm of the share of the border that is beside node q. */
static double
log_share(const Border *b, int q)
{
	double before = q > 0 ? b->s[q] - b->s[q-1] : b->s[b->n] - b->s[b->n-1];

	return log(fmax((before + b->s[q+1] - b->s[q])/b->s[b->n], LEAST));
}

/* e at node q of the border. */
static double
value(int count, const double *w, const Border *const *of, const Border *blend, int q)
{
	double e = log_share(blend, q) + log(blend->s[blend->n]);
	int k;

	for (k = 0; k < count; k++)
		e -= w[k]*(log_share(of[k], q) + log(of[k]->s[of[k]->n]));
	return fmax(-MOST, fmin(e, MOST));
}

/* Continues e from the border into the grid as a harmonic function.  work is [3][nv][nu]. */
static int
continue_harmonic(Chart g, double *e, double *work)
{
	size_t n = (size_t)g.nu*g.nv, p;
	const double *const f[3] = { e, e, e };
	double lap[3];
	Plate plate;
	int i, j;

	if (plate_init(&plate, g, 0))
		return BORDERLENGTH_ENOMEM;
	memset(work, 0, 3*n*sizeof *work);              /* plate_solve is for three fields */
	for (j = 0; j < g.nv; j++)
		for (i = 0; i < g.nu; i++)
			if (border_number(g, i, j) < 0) {
				stencil_laplacian(g, f, i, j, lap);
				work[(size_t)j*g.nu + i] = lap[0];
			}
	plate_solve(&plate, 0, 1, 0, work);
	for (p = 0; p < n; p++)
		e[p] += work[p];
	plate_free(&plate);
	return 0;
}

int
borderlength(int count, const double *w, const Border *const *of, const Border *blend, double *e)
{
	Chart g = blend->g;
	double *work;
	int i, j, q, r;

	memset(e, 0, (size_t)g.nu*g.nv*sizeof *e);
	if (g.nu < 3 || g.nv < 3)
		return 0;
	work = malloc(3*(size_t)g.nu*g.nv*sizeof *work);
	if (!work)
		return BORDERLENGTH_ENOMEM;
	for (j = 0; j < g.nv; j++)
		for (i = 0; i < g.nu; i++) {
			q = border_number(g, i, j);
			if (q >= 0)
				e[(size_t)j*g.nu + i] = value(count, w, of, blend, q);
		}
	r = continue_harmonic(g, e, work);
	free(work);
	return r;
}
