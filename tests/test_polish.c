/* test_polish.c - locating points in a mesh, harmonic functions on grids, and polishing a map. */
#include "cmock.h"

#include <math.h>

#include "../lib/map/gridlaplace.h"
#include "../lib/grid/lambdah.h"
#include "../lib/grid/stencil.h"
#include "../lib/poisson/planelaplace.h"
#include "../lib/map/polish.h"
#include "../lib/base/stats.h"
#include "sockcap.h"
#include "surfaces.h"
#include "synthdisk.h"

static const Chart CHART = { 41, 29, 0.7, &CHART_RECTANGLE };
enum { N = 41*29 };

static double field[3][N];
static double *const phi[3] = { field[0], field[1], field[2] };

static double
dot(const double *a, const double *b)
{
	double sum = 0;
	int p;

	for (p = 0; p < N; p++)
		sum += a[p]*b[p];
	return sum;
}

static void
laplace_is_its_own_adjoint(void **state)
{
	static double x[N], y[N], Kx[N], Ky[N];
	unsigned long long seed = 9;
	GridLaplace l;
	double sum = 0;
	int p;

	(void)state;
	sample_immersion(torus, CHART, 1, (double **)phi, NULL, NULL);
	for (p = 0; p < N; p++) {
		field[0][p] += 0.01*noise(&seed);
		x[p] = noise(&seed), y[p] = noise(&seed);
	}
	assert_int_equal(gridlaplace_init(&l, CHART, phi, GRIDLAPLACE_CELLS), 0);
	gridlaplace_apply(&l, x, Kx);
	gridlaplace_apply(&l, y, Ky);
	assert_true(fabs(dot(Kx, y) - dot(x, Ky)) < 1e-11*dot(x, Kx));
	for (p = 0; p < N; p++)
		sum += Kx[p];
	assert_true(fabs(sum) < 1e-10*dot(x, Kx));
	gridlaplace_free(&l);
}

/* On a plane with conformal coordinates the matrix of the grid is the plane's Laplacian, which the
 * transforms invert. */
static void
transforms_invert_the_plane(void **state)
{
	static double r[N], z[N], Kz[N];
	unsigned long long seed = 11;
	PlaneLaplace q;
	GridLaplace l;
	int axis, p, held;

	(void)state;
	sample_immersion(plane, CHART, 2, (double **)phi, NULL, NULL);
	assert_int_equal(gridlaplace_init(&l, CHART, phi, GRIDLAPLACE_CELLS), 0);
	for (axis = 0; axis < 2; axis++) {
		for (p = 0; p < N; p++)
			r[p] = noise(&seed);
		assert_int_equal(planelaplace_init(&q, CHART, axis), 0);
		planelaplace_solve(&q, r, z);
		gridlaplace_apply(&l, z, Kz);
		for (p = 0; p < N; p++) {
			held = axis == 0 ? p%41 == 0 || p%41 == 40 : p/41 == 0 || p/41 == 28;
			assert_true(held ? z[p] == 0 : fabs(Kz[p] - r[p]) < 1e-10);
		}
		planelaplace_free(&q);
	}
	gridlaplace_free(&l);
}

/* The stiffness of bilinear elements applied to a field that is odd under the turns of a pillow. */
static double
plane_stiffness(Chart g, const double *f, int i, int j)
{
	double h = chart_h(g), k = chart_k(g), sum = 0;
	int a, b, sign;
	size_t p;

	for (b = -1; b <= 1; b++)
		for (a = -1; a <= 1; a++) {
			sign = 1;
			p = stencil_node(g, i + a, j + b, &sign);
			sum += sign*f[p]*((a ? -1 : 2)/h*(b ? 1 : 4)*k/6 + (b ? -1 : 2)/k*(a ? 1 : 4)*h/6);
		}
	return sum;
}

static void
transforms_invert_the_plane_of_a_pillow(void **state)
{
	static const Chart chart[] = { { 18, 13, 0.7, &CHART_PILLOW }, { 12, 18, 1.6, &CHART_PILLOW },
		{ 4, 2, 1, &CHART_PILLOW } };
	static double r[N], z[N];
	unsigned long long seed = 11;
	PlaneLaplace q;
	int t, p;

	(void)state;
	for (t = 0; t < 6; t++) {
		Chart g = chart[t/2];

		for (p = 0; p < g.nu*g.nv; p++)
			r[p] = noise(&seed);
		assert_int_equal(planelaplace_init(&q, g, t%2), 0);
		planelaplace_solve(&q, r, z);
		for (p = 0; p < g.nu*g.nv; p++)
			assert_true(fabs(plane_stiffness(g, z, p%g.nu, p/g.nu) - r[p]) < 1e-10);
		planelaplace_free(&q);
	}
}

static Node
stretched(double u, double v)
{
	return (Node){ { 2*u, v, 0 }, 0, 0 };
}

/* On a conformal surface the harmonic functions are u and v/T, with energies T and 1/T.  On the
 * plane stretched by 2 along u they are the same, with energies T/2 and 2/T. */
static void
harmonic_functions_of_known_surfaces(void **state)
{
	static double f[N];
	const struct { Immersion *f; double factor, tolerance; } c[] = {
		{ plane, 1, 1e-9 }, { stretched, 0.5, 1e-9 }, { enneper, 1, 2e-3 }, { torus, 1, 2e-3 },
	};
	GridLaplace l;
	double E;
	size_t i;
	int p;

	(void)state;
	for (i = 0; i < sizeof c/sizeof *c; i++) {
		sample_immersion(c[i].f, CHART, 3, (double **)phi, NULL, NULL);
		assert_int_equal(gridlaplace_init(&l, CHART, phi, GRIDLAPLACE_CELLS), 0);
		assert_int_equal(gridlaplace_shift(&l, 0, f, &E), 0);
		assert_true(fabs(E/(c[i].factor*CHART.T) - 1) < c[i].tolerance);
		for (p = 0; p < N; p++)
			assert_true(fabs(f[p]) < 40*c[i].tolerance);
		assert_int_equal(gridlaplace_shift(&l, 1, f, &E), 0);
		assert_true(fabs(E*c[i].factor*CHART.T - 1) < c[i].tolerance);
		for (p = 0; p < N; p++)
			assert_true(fabs(f[p]) < 28*c[i].tolerance);
		gridlaplace_free(&l);
	}
}

/* On an exact cap the harmonic coordinates are those of the sock, with energies T and 1/T, across fold and
 * seam, too; to first order, because the cells beside the cones are taken as conformal. */
static void
harmonic_coordinates_of_a_sock(void **state)
{
	double most[2] = { 0, 0 }, E, *f;
	int level, axis, p;
	GridLaplace l;

	(void)state;
	for (level = 0; level < 2; level++) {
		const Chart g = { 32 << level, (20 << level) + 1, (20 << level)/(double)(32 << level), &CHART_SOCK };
		double *x[3];

		for (p = 0; p < 3; p++)
			x[p] = malloc(sizeof(double)*(size_t)(g.nu*g.nv));
		f = malloc(sizeof(double)*(size_t)(g.nu*g.nv));
		sample_sockcap(g, 1, x, NULL, NULL);
		assert_int_equal(gridlaplace_init(&l, g, x, GRIDLAPLACE_CELLS), 0);
		for (axis = 0; axis < 2; axis++) {
			assert_int_equal(gridlaplace_shift(&l, axis, f, &E), 0);
			assert_true(fabs(E*(axis ? g.T : 1/g.T) - 1) < 0.02/(1 << 2*level));
			for (p = 0; p < g.nu*g.nv; p++)
				most[level] = fmax(most[level], fabs(f[p])*chart_h(g));
			for (p = 0; p < g.nu && axis; p++)
				assert_true(f[g.nu*g.nv - 1 - p] == 0);
		}
		gridlaplace_free(&l);
		free(f);
		for (p = 0; p < 3; p++)
			free(x[p]);
	}
	assert_true(most[0] < 1e-3 && most[0]/most[1] > 1.9);
}

/* Thorns of one node on a sock, away from the cones: their cells turn too much to tell anything of the surface, and the
 * coordinates stay about those of the cap. */
static void
cells_that_turn_are_conformal(void **state)
{
	enum { NU = 32, NV = 21, M = NU*NV };
	const Chart g = { NU, NV, 20/32., &CHART_SOCK };
	static double cap[3][M], *const x[3] = { cap[0], cap[1], cap[2] }, plain[M], f[M];
	double E, most = 0;
	GridLaplace l;
	int thorn, p, c;

	(void)state;
	sample_sockcap(g, 1, (double **)x, NULL, NULL);
	for (thorn = 0; thorn < 2; thorn++) {
		for (p = 9*NU + 3; p < 10*NU && thorn; p += 8)
			for (c = 0; c < 3; c++)
				x[c][p] *= 3;
		assert_int_equal(gridlaplace_init(&l, g, x, GRIDLAPLACE_CELLS), 0);
		assert_int_equal(gridlaplace_shift(&l, 0, thorn ? f : plain, &E), 0);
		gridlaplace_free(&l);
	}
	for (p = 0; p < M; p++)
		most = fmax(most, fabs(f[p] - plain[p]));
	assert_true(most < 0.15);               /* .08; .91 by the metric of these cells */
}

/* Points of a triangulated rectangle are located even near flat or flipped triangles, where a walk
 * from triangle to triangle fails. */
static void
points_are_located(void **state)
{
	Synth s;
	SynthDomain dom;
	Disk d;
	Locator l;
	double *xy, *u, *v, w[3], x, y;
	unsigned long long seed = 4;
	int i, t, k;

	(void)state;
	synth_disk("rectangle", 3000, &s, &dom, &d, &xy);
	u = malloc(d.m.nv*sizeof *u), v = malloc(d.m.nv*sizeof *v);
	for (i = 0; i < d.m.nv; i++)
		u[i] = xy[2*i]/dom.x1, v[i] = xy[2*i+1]/dom.x1;
	for (i = 0; i < d.m.nv; i++)            /* a collapsed edge inside */
		if (fabs(u[i] - 0.5) < 0.02 && fabs(v[i] - 0.3) < 0.02)
			break;
	u[i] = u[i+1], v[i] = v[i+1];
	for (i = 0; i < d.m.nv; i++)            /* a vertex outside the ring of its neighbours */
		if (fabs(u[i] - 0.2) < 0.02 && fabs(v[i] - 0.4) < 0.02)
			break;
	u[i] += 0.15;
	assert_int_equal(locator_init(&l, &d, u, v, dom.T), 0);
	for (i = 0; i < 5000; i++) {
		x = (1 + noise(&seed))/2, y = dom.T*(1 + noise(&seed))/2;
		if (i%10 == 0)
			x = i%20 == 0;
		t = locate(&l, x, y, w);
		for (k = 0; k < 3; k++) {
			assert_true(w[k] >= 0 && w[k] <= 1);
			x -= w[k]*u[d.m.tri[3*t+k]];
			y -= w[k]*v[d.m.tri[3*t+k]];
		}
		assert_true(fabs(x) < 1e-8 && fabs(y) < 1e-8);
	}
	locator_free(&l);
	free(xy), free(u), free(v);
	disk_free(&d);
}

static double
mean_mu(const Grid *a)
{
	static double mu[64*64];

	beltrami(a->g, (const double *const *)a->phi, mu);
	return stats_mean((size_t)(a->g.nu - 2)*(a->g.nv - 2), mu);
}

/* The map of a torus patch is deformed so that it is not conformal.  Polishing recovers the
 * conformal map and T, and moves given points with the map. */
static void
polish_finds_the_conformal_map(void **state)
{
	Synth s;
	SynthDomain dom;
	Disk d;
	Sampler sampler;
	ChartMap map;
	Grid a;
	Chart g = { 61, 49, 0, &CHART_RECTANGLE };
	double *xy, *u, *v, before, pu, pv;
	int i, done, mid = -1;

	(void)state;
	synth_disk("torus", 8000, &s, &dom, &d, &xy);
	g.T = 1.1*dom.T;
	u = malloc(d.m.nv*sizeof *u), v = malloc(d.m.nv*sizeof *v);
	for (i = 0; i < d.m.nv; i++) {
		double x = (xy[2*i] - dom.x0)/(dom.x1 - dom.x0), y = (xy[2*i+1] - dom.y0)/(dom.y1 - dom.y0);

		u[i] = x + 0.03*sin(M_PI*x)*cos(M_PI*y);
		v[i] = g.T*(y - 0.03*sin(2*M_PI*y)*cos(2*M_PI*x));
		if (fabs(x - 0.4) < 0.02 && fabs(y - 0.6) < 0.02)
			mid = i;
	}
	pu = u[mid], pv = v[mid];
	assert_int_equal(sampler_init(&sampler, &d, u, v, g.T, SAMPLER_SMOOTH), 0);
	map = chartmap_rectangle(g.T);
	assert_int_equal(grid_init(&a, &map, g.nu, g.nv, &sampler), 0);
	before = mean_mu(&a);
	assert_int_equal(polish(&sampler, &a, 8, 2e-4, 1, &pu, &pv, &done), 0);
	assert_true(done >= 1 && done <= 8);
	assert_true(mean_mu(&a) < before/50);
	assert_true(fabs(a.g.T/dom.T - 1) < 1e-3);
	assert_true(fabs(pu - (xy[2*mid] - dom.x0)/(dom.x1 - dom.x0)) < 1e-3);
	assert_true(fabs(pv - dom.T*(xy[2*mid+1] - dom.y0)/(dom.y1 - dom.y0)) < 1e-3);
	grid_free(&a);
	sampler_free(&sampler);
	free(xy), free(u), free(v);
	disk_free(&d);
}

/* After any number of rounds of polishing the grid is at least as conformal as before. */
static void
polish_never_harms(void **state)
{
	static const char *const kind[] = { "mercator", "catenoid", "cap", "enneper" };
	Synth s;
	SynthDomain dom;
	Disk d;
	Sampler sampler;
	ChartMap map;
	Grid a;
	Chart g = { 33, 25, 0, &CHART_RECTANGLE };
	double *xy, *u, *v, before;
	int i, done, rounds;
	size_t k;

	(void)state;
	for (k = 0; k < sizeof kind/sizeof *kind; k++) {
		synth_disk(kind[k], 300, &s, &dom, &d, &xy);
		u = malloc(d.m.nv*sizeof *u), v = malloc(d.m.nv*sizeof *v);
		g.T = (dom.y1 - dom.y0)/(dom.x1 - dom.x0);
		for (i = 0; i < d.m.nv; i++) {
			u[i] = (xy[2*i] - dom.x0)/(dom.x1 - dom.x0);
			v[i] = (xy[2*i+1] - dom.y0)/(dom.x1 - dom.x0);
		}
		assert_int_equal(sampler_init(&sampler, &d, u, v, g.T, SAMPLER_FACETS), 0);
		for (rounds = 1; rounds < 9; rounds++) {
			map = chartmap_rectangle(g.T);
	assert_int_equal(grid_init(&a, &map, g.nu, g.nv, &sampler), 0);
			before = mean_mu(&a);
			assert_int_equal(polish(&sampler, &a, rounds, 2e-4, 0, NULL, NULL, &done), 0);
			assert_true(mean_mu(&a) <= before && done <= rounds);
			grid_free(&a);
		}
		sampler_free(&sampler);
		free(xy), free(u), free(v);
		disk_free(&d);
	}
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(laplace_is_its_own_adjoint),
		cmocka_unit_test(transforms_invert_the_plane),
		cmocka_unit_test(transforms_invert_the_plane_of_a_pillow),
		cmocka_unit_test(harmonic_functions_of_known_surfaces),
		cmocka_unit_test(harmonic_coordinates_of_a_sock),
		cmocka_unit_test(cells_that_turn_are_conformal),
		cmocka_unit_test(points_are_located),
		cmocka_unit_test(polish_never_harms),
		cmocka_unit_test(polish_finds_the_conformal_map),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
