/* pillowpolish.c - harmonic coordinates on the torus, and the sphere by theta functions. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/stats.h"
#include "../base/torusplane.h"
#include "../grid/lambdah.h"
#include "gridlaplace.h"
#include "pillowpolish.h"
#include "pillowshift.h"
#include "rounds.h"

/* ---- the new sphere -------------------------------------------------- */

/* The map that takes the cones -s, s, 1/s to -r, r, 1/r. */
static void
cones_to_cones(double complex s, double r, Moebius M)
{
	Spinor from[3] = { { -s, 1 }, { s, 1 }, { 1, s } }, to[3] = { { -r, 1 }, { r, 1 }, { 1, r } };
	int k;

	for (k = 0; k < 3; k++) {
		moebius_normalise(from[k]);
		moebius_normalise(to[k]);
	}
	moebius_three(from, to, M);
}

/* Where the map to the pillow of height T takes the nodes of which the harmonic coordinates are those of the grid plus du,
 * dv, in steps. */
static void
map_nodes(Chart g, const double *du, const double *dv, double complex tau, double T, Spinor *to)
{
	PillowPlane plane = pillowplane(T);
	Moebius M;
	int p;

	cones_to_cones(torusplane_cone(tau), plane.half.s, M);
	#pragma omp parallel for schedule(static)
	for (p = 0; p < g.nu*g.nv; p++) {
		Spinor z;

		torusplane_z(tau, (p%g.nu + 0.5 + du[p])/g.nu, (p/g.nu + 0.5 + dv[p])/(2*g.nv), z);
		moebius_normalise(z);
		moebius_apply(M, z, to[p]);
	}
}

int
pillowpolish_map(const PillowGrid *a, int metric, double fixed, Spinor *to, double complex *tau)
{
	size_t n = (size_t)a->g.nu*a->g.nv;
	double *du = malloc(2*n*sizeof *du), *dv = du + n, Ea, Eb, A, B;
	GridLaplace l;
	int e = du ? gridlaplace_init(&l, a->g, a->phi, metric) : POLISH_ENOMEM, e1 = 0;

	if (e) {
		free(du);
		return POLISH_ENOMEM;
	}
#pragma omp parallel sections
	{
#pragma omp section
		e = gridlaplace_shift(&l, 0, du, &Ea);
#pragma omp section
		e1 = gridlaplace_shift(&l, 1, dv, &Eb);
	}
	if (!e && !e1) {
		/* Of both sheets, with b half the coordinate of a sheet. */
		A = -gridlaplace_product(&l, du, dv);
		B = 2*Ea;
		*tau = I*B/(1 + I*A);
		if (cimag(*tau) > TORUSPLANE_LEAST && isfinite(cimag(*tau)))
			map_nodes(a->g, du, dv, *tau, fixed > 0 ? fixed : cimag(*tau)/2, to);
	}
	gridlaplace_free(&l);
	free(du);
	return e || e1 ? POLISH_ENOMEM : 0;
}

/* ---- rounds ---------------------------------------------------------- */

typedef struct Polishing {
	const SphereSampler *sampler;
	PillowGrid grid[ROUNDS_GRIDS];
	double     fixed;       /* height, or 0 */
	Spinor    *to;          /* [nv][nu] of pillowpolish_map */
	double    *mu;
} Polishing;

static double
mean_beltrami(const PillowGrid *a, double *mu)
{
	beltrami(a->g, (const double *const *)a->phi, mu);
	return stats_mean((size_t)a->g.nu*a->g.nv, mu);
}

static void
copy(void *of, int i, int k)
{
	const PillowGrid *from = &((Polishing *)of)->grid[i];
	PillowGrid *to = &((Polishing *)of)->grid[k];
	size_t n = (size_t)from->g.nu*from->g.nv;

	to->g = from->g;
	memcpy(to->at, from->at, n*sizeof *to->at);
	memcpy(to->phi[0], from->phi[0], 3*n*sizeof *to->phi[0]);
}

/* The place of each new node: that of the point of the old grid that the map takes to it. */
static int
move(const PillowGrid *a, Spinor *to, PillowGrid *b)
{
	PillowShift map, place;
	int p, e;

	if (pillowshift_init(&map, a->g, to))
		return POLISH_ENOMEM;
	e = pillowshift_init(&place, a->g, a->at);
	if (!e) {
		pillowshift_nodes(b->g, b->at);
		#pragma omp parallel for schedule(dynamic, 256)
		for (p = 0; p < b->g.nu*b->g.nv; p++) {
			Spinor from;

			pillowshift_from(&map, b->at[p], from);
			pillowshift_to(&place, from, b->at[p]);
		}
		pillowshift_free(&place);
	}
	pillowshift_free(&map);
	return e ? POLISH_ENOMEM : 0;
}

static int
advance(void *of, int metric, int i, int k, double *mean)
{
	Polishing *p = of;
	const PillowGrid *a = &p->grid[i];
	PillowGrid *b = &p->grid[k];
	double complex tau;
	int n = a->g.nu*a->g.nv;

	if (pillowpolish_map(a, metric, p->fixed, p->to, &tau))
		return POLISH_ENOMEM;
	*mean = HUGE_VAL;
	b->g = a->g;
	if (!(cimag(tau) > TORUSPLANE_LEAST && isfinite(cimag(tau))))
		return 0;
	b->g.T = p->fixed > 0 ? p->fixed : cimag(tau)/2;
	if (move(a, p->to, b) || spheresampler_points(p->sampler, n, b->at, b->phi))
		return POLISH_ENOMEM;
	*mean = mean_beltrami(b, p->mu);
	return 0;
}

int
pillowpolish(const SphereSampler *s, PillowGrid *a, double fixed, int most, double enough, int *done)
{
	size_t n = (size_t)a->g.nu*a->g.nv;
	Polishing p = { s, { *a }, fixed, malloc(n*sizeof *p.to), malloc(n*sizeof *p.mu) };
	Rounds r = { advance, copy, &p };
	int e = p.to && p.mu ? 0 : POLISH_ENOMEM, k;

	*done = 0;
	for (k = 1; k < ROUNDS_GRIDS; k++)
		if (pillowgrid_alloc(&p.grid[k], a->g))
			e = POLISH_ENOMEM;
	if (!e && most > 0)
		e = rounds(&r, most, enough, mean_beltrami(a, p.mu), done);
	*a = p.grid[0];
	for (k = 1; k < ROUNDS_GRIDS; k++)
		pillowgrid_free(&p.grid[k]);
	free(p.to);
	free(p.mu);
	return e;
}
