/* test_spherelike.c - lib/map/spherelike.h: a surface is found on itself, whatever its map to the sphere and its place. */
#include <stdlib.h>
#include <string.h>

#include "cmock.h"

#include "../lib/base/vec3.h"
#include "../lib/map/pillowpolish.h"
#include "../lib/map/spherelike.h"
#include "closedball.h"
#include "pillowball.h"
#include "pillowmu.h"

static const Chart GRID = { 96, 60, 0.62, &CHART_PILLOW };

/* The pear on the nodes of GRID; in one piece of memory. */
static void
pear_grid(double *phi[3])
{
	PillowPlane plane = pillowplane(GRID.T);
	int n = GRID.nu*GRID.nv, p, c;
	double x[3];

	phi[0] = malloc(3*n*sizeof(double));
	phi[1] = phi[0] + n, phi[2] = phi[0] + 2*n;
	for (p = 0; p < n; p++) {
		pillowpear(&plane, chart_u(GRID, p%GRID.nu), chart_v(GRID, p/GRID.nu), x);
		for (c = 0; c < 3; c++)
			phi[c][p] = x[c];
	}
}

/* A mesh of the pear of 8 n^2 faces, turned, scaled and moved; W: its places on the sphere of the pillow. */
static void
pear_mesh(int n, Disk *d, Spinor **W)
{
	static const double R[3][3] = { { .36, .48, -.8 }, { -.8, .6, 0 }, { .48, .64, .6 } };
	PillowPlane plane = pillowplane(GRID.T);
	double x[3], u, v;
	int i, k;

	assert_int_equal(ball_mesh(n, .2, d), 0);
	*W = malloc(d->m.nv*sizeof **W);
	for (i = 0; i < d->m.nv; i++) {
		ball_spinor(d->m.xyz + 3*i, (*W)[i]);
		pillowplane_uv(&plane, (*W)[i], &u, &v);
		pillowpear(&plane, u, v, x);
		for (k = 0; k < 3; k++)
			d->m.xyz[3*i+k] = 50*dot3(R[k], x) + 7*k;
	}
}

/* The largest distance of the places M Z from W, on the unit sphere. */
static double
apart(const Disk *d, Moebius M, Spinor *Z, Spinor *W)
{
	double most = 0;
	Spinor w;
	int i;

	for (i = 0; i < d->m.nv; i++) {
		moebius_apply(M, Z[i], w);
		most = fmax(most, 2*cabs(moebius_cross(w, W[i])));
	}
	return most;
}

/* The error of the map of a mesh of 8 n^2 faces whose map to the sphere is that of the pear followed by `map`. */
static double
error(int n, const double complex map[2][2])
{
	double *phi[3], far;
	Spinor *W, *Z;
	SphereLike l;
	Moebius M;
	Disk d;
	int i;

	pear_grid(phi);
	pear_mesh(n, &d, &W);
	Z = malloc(d.m.nv*sizeof *Z);
	memcpy(M, map, sizeof M);
	for (i = 0; i < d.m.nv; i++)
		moebius_apply(M, W[i], Z[i]);
	assert_int_equal(spherelike(&d.m, Z, NULL, GRID, (const double *const *)phi, &l), 0);
	far = apart(&d, l.map.M, Z, W);
	print_message("%d faces: apart %.3g on the sphere, %.3g in space, next %.3g\n", d.m.nf, far, l.rms, l.next);
	assert_true(l.rms < 1e-2 && l.next > 10*l.rms && l.map.T == GRID.T);
	free(phi[0]);
	free(W);
	free(Z);
	disk_free(&d);
	return far;
}

/* Second order in the size of the faces, which are sampled at their middles. */
static void
the_map_of_a_surface_to_itself_is_found(void **state)
{
	static const double complex map[2][2][2] = {
		{ { .7 + .2*I, .5*I }, { .3, 1 } },
		{ { 0, 1 }, { -1, 2 - I } },            /* exchanges the poles, and crowds most of the surface together */
	};
	double e[2];
	int k;

	(void)state;
	for (k = 0; k < 2; k++) {
		e[0] = error(20, map[k]);
		e[1] = error(40, map[k]);
		assert_true(e[1] < e[0]/2.5 && e[1] < 1e-2);
	}
}

static void
given_cones_become_those_of_the_pillow(void **state)
{
	int given[3] = { 5, 900, 1800 }, k;
	double *phi[3];
	Spinor *W, cone;
	SphereLike l, free_fit;
	Disk d;

	(void)state;
	pear_grid(phi);
	pear_mesh(40, &d, &W);
	assert_int_equal(spherelike(&d.m, W, given, GRID, (const double *const *)phi, &l), 0);
	assert_int_equal(spherelike(&d.m, W, NULL, GRID, (const double *const *)phi, &free_fit), 0);
	assert_true(l.map.T == GRID.T && l.next == HUGE_VAL && l.rms > 10*free_fit.rms);
	for (k = 0; k < 3; k++) {
		conemap_place(&l.map, k, cone);
		assert_true(cabs(moebius_cross(cone, W[given[k]])) < 1e-9);
	}
	given[2] = given[0];
	assert_int_equal(spherelike(&d.m, W, given, GRID, (const double *const *)phi, &l), SPHERELIKE_EEQUAL);
	memset(phi[0], 0, 3*GRID.nu*GRID.nv*sizeof(double));
	assert_int_equal(spherelike(&d.m, W, NULL, GRID, (const double *const *)phi, &l), SPHERELIKE_EEQUAL);
	free(phi[0]);
	free(W);
	disk_free(&d);
}

/* The same surface on pillows of other heights: their grids are made conformal, and their heights stay. */
static void
the_polish_keeps_a_height(void **state)
{
	static const double T[2] = { 0.5, 0.8 };
	Subdivision mesh;
	SphereSampler s;
	PillowGrid a;
	Spinor *W;
	Disk d;
	int k, i, done;
	double before;

	(void)state;
	pear_mesh(40, &d, &W);
	for (i = 0; i < d.m.nv; i++) {          /* not conformal */
		W[i][0] *= 1 + .02*creal(W[i][0]*conj(W[i][1]));
		moebius_normalise(W[i]);
	}
	assert_int_equal(subdivision_init(&mesh, &d), 0);
	assert_int_equal(spheresampler_init(&s, &d, &mesh, W, SAMPLER_SMOOTH), 0);
	for (k = 0; k < 2; k++) {
		assert_int_equal(pillowgrid_init(&a, (Chart){ 96, 60, T[k], &CHART_PILLOW }, &s), 0);
		before = mean_mu(&a);
		assert_int_equal(pillowpolish(&s, &a, T[k], 12, 0, &done), 0);
		print_message("T %g: mean |mu| %.3g, then %.3g\n", T[k], before, mean_mu(&a));
		assert_true(done > 0 && mean_mu(&a) < before/4 && a.g.T == T[k]);
		pillowgrid_free(&a);
	}
	spheresampler_free(&s);
	subdivision_free(&mesh);
	disk_free(&d);
	free(W);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(the_map_of_a_surface_to_itself_is_found),
		cmocka_unit_test(given_cones_become_those_of_the_pillow),
		cmocka_unit_test(the_polish_keeps_a_height),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
