/* test_conformal.c - conformal.h: all stages from a disk to its grid. */
#include "cmock.h"

#include <math.h>

#include "../lib/base/stats.h"
#include "../lib/grid/lambdah.h"
#include "../lib/grid/stencil.h"
#include "../lib/map/conformal.h"
#include "../lib/map/corners.h"
#include "disks.h"
#include "synthdisk.h"

/* The root mean square of H over the inner nodes of the grid of a catenoid, whose true H is 0.  The
 * callers choose n and cells so that a cell is about as wide as 1.25 edges. */
static double
rms_H(int n, int cells)
{
	const ConformalOptions options = { .map = { 1e-3, 1, 300000 }, .surface = SAMPLER_SMOOTH, .polish = 12 };
	Chart g = { cells + 1, cells + 1, 1, &CHART_RECTANGLE };
	size_t nodes = (size_t)g.nu*g.nv, p;
	double *lambda = malloc(nodes*sizeof *lambda), *H = malloc(nodes*sizeof *H), sum = 0;
	int corner[4], i, k;
	Synth s;
	SynthDomain dom;
	SpdReport report;
	Conformal c;
	Disk d;

	synth_disk("catenoid", n, &s, &dom, &d, NULL);
	for (i = 0; i < d.nb; i++)
		for (k = 0; k < 4; k++)
			if (d.loop[i] == k)
				corner[k] = i;
	assert_int_equal(conformal_grid(&d, corner, g, &options, &c, &report), 0);
	assert_true(fabs(c.grid.g.T/dom.T - 1) < 1e-3);
	lambdah(c.grid.g, (const double *const *)c.grid.phi, LAMBDAH_NORMAL, lambda, H);
	for (p = 0; p < nodes; p++)
		if (p%g.nu > 0 && (int)(p%g.nu) < g.nu - 1 && p >= (size_t)g.nu && p < nodes - g.nu)
			sum += H[p]*H[p];
	free(lambda), free(H);
	conformal_free(&c);
	disk_free(&d);
	return sqrt(sum/((g.nu - 2.0)*(g.nv - 2)));
}

/* Halving the mesh size divides the error of H by at least 3.5.  With linear elements the factor would
 * be 1.7, and without polishing the grid 2.1. */
static void
H_is_of_second_order(void **state)
{
	(void)state;
	assert_true(rms_H(16000, 101) < rms_H(4000, 50)/3.5);
}

/* The grid of a cap of the unit sphere on a sock of about cells*cells nodes: the mean distance of all nodes
 * from the sphere, and of those on the boundary from its circle; median and mean of |mu|. */
typedef struct OnSphere {
	double all, border, median, mean;
} OnSphere;

static double
off_sphere(const Grid *a, size_t from, size_t to)
{
	double *const *x = a->phi, sum = 0;
	size_t p;

	for (p = from; p < to; p++)
		sum += fabs(sqrt(x[0][p]*x[0][p] + x[1][p]*x[1][p] + x[2][p]*x[2][p]) - 1);
	return sum/(double)(to - from);
}

static OnSphere
sock_of_cap(int n, int cells)
{
	const ConformalOptions options = { .map = { 1e-3, 1, 300000 }, .surface = SAMPLER_SMOOTH, .polish = 12,
		.cone = { -1, -1 }, .shape = 1 };
	const Chart about = { cells, cells, 1, &CHART_SOCK };
	double *mu;
	int corner[4];
	size_t nodes, inner;
	OnSphere r;
	Synth s;
	SynthDomain dom;
	SpdReport report;
	Conformal c;
	Chart g;
	Disk d;

	synth_disk("cap", n, &s, &dom, &d, NULL);
	assert_true(corners_auto(&d, corner) >= 0);
	assert_int_equal(conformal_grid(&d, corner, about, &options, &c, &report), 0);
	g = c.grid.g;
	nodes = (size_t)g.nu*g.nv;
	assert_true(fabs(nodes/(double)(cells*cells) - 1) < 0.15 && g.nu%2 == 0);
	assert_true(fabs(chart_h(g)/chart_k(g) - 1) < 0.1);
	assert_int_equal(c.uv.turned, 0);
	mu = malloc(nodes*sizeof *mu);
	inner = stencil_inner_count(g);
	beltrami(g, (const double *const *)c.grid.phi, mu);
	r.mean = stats_mean(inner, mu);
	r.median = stats_median(inner, mu);
	r.all = off_sphere(&c.grid, 0, nodes);
	r.border = off_sphere(&c.grid, nodes - g.nu, nodes);
	free(mu);
	conformal_free(&c);
	disk_free(&d);
	return r;
}

/* The nodes are near the sphere to fourth order in the mesh size, on the boundary to more than second; the
 * grid is conformal to second order in its own steps. */
static void
a_cap_is_a_sock(void **state)
{
	OnSphere coarse = sock_of_cap(1000, 64), fine = sock_of_cap(4000, 64), finer = sock_of_cap(4000, 128);

	(void)state;
	assert_true(fine.all < coarse.all/10 && fine.all < 2e-7);
	assert_true(fine.border < coarse.border/4.5 && fine.border < 3e-6);
	assert_true(fine.median < 3e-4 && fine.mean < 3e-4);
	assert_true(finer.median < fine.median/3 && finer.mean < fine.mean/2);
}

/* A rectangle and a sock of that many nodes. */
static const Chart CHART[] = { { 33, 33, 1, &CHART_RECTANGLE }, { 32, 34, 1, &CHART_SOCK } };
enum { NU = 33 };

static void
grid_of(const Disk *d, const int vertex[4], Chart g, Conformal *c)
{
	const ConformalOptions options = { .map = { 1e-2, 1, 300000 }, .surface = SAMPLER_SMOOTH, .polish = 12,
		.cone = { -1, -1 } };
	SpdReport report;
	int corner[4], at;

	assert_int_equal(corners_given(d, vertex, corner, &at), 0);
	assert_int_equal(conformal_grid(d, corner, g, &options, c, &report), 0);
}

/* A disk with its vertices and faces in another order has the same grid and the same cones, and its vertices
 * the same places, to the last bit. */
static void
numbering_does_not_matter(void **state)
{
	uint64_t seed;
	int done = 0, i, k;

	(void)state;
	for (seed = 304; done < 6; seed++) {
		char tag[DISKS_TAG];
		const Chart g = CHART[done%2];
		Disk d, other, both;
		Conformal a, b;
		int *number, corner[4], vertex[2][4];

		if (disks_random(seed, DISKS_NICE, &d, tag))
			continue;
		number = malloc(d.m.nv*sizeof *number);
		assert_int_equal(disks_renumbered(&d, seed, &other, number), 0);
		assert_int_equal(disks_reordered(&other, seed, &both), 0);
		assert_true(corners_auto(&d, corner) >= 0);
		for (k = 0; k < 4; k++)
			vertex[1][k] = number[vertex[0][k] = d.loop[corner[k]]];
		grid_of(&d, vertex[0], g, &a);
		grid_of(&both, vertex[1], g, &b);
		assert_true(a.grid.g.T == b.grid.g.T);
		for (k = 0; k < 3; k++)
			assert_memory_equal(a.grid.phi[k], b.grid.phi[k], (size_t)g.nu*g.nv*sizeof(double));
		for (k = 0; k < 2 && g.kind->folded; k++)
			assert_int_equal(number[a.cone[k]], b.cone[k]);
		for (i = 0; i < d.m.nv; i++)
			assert_true(a.u[i] == b.u[number[i]] && a.v[i] == b.v[number[i]]);
		conformal_free(&a);
		conformal_free(&b);
		disk_free(&d);
		disk_free(&other);
		disk_free(&both);
		free(number);
		done++;
	}
}

/* A triangle whose longest edge is split: on its two halves the smooth surface is folded and far from
 * conformal, mean modulus .5 of the Beltrami coefficient.  It is rotated by `angle`. */
static void
halves(double angle, Disk *d)
{
	static const double x[4][2] = { { 0, 0 }, { 1.1, 0 }, { .75, .45 }, { .4, .9 } };
	double xyz[12];
	int i;

	for (i = 0; i < 4; i++) {
		xyz[3*i] = cos(angle)*x[i][0] - sin(angle)*x[i][1];
		xyz[3*i+1] = sin(angle)*x[i][0] + cos(angle)*x[i][1];
		xyz[3*i+2] = 0;
	}
	assert_int_equal(disks_of(4, xyz, 2, (int[]){ 0, 1, 2, 0, 2, 3 }, d), 0);
}

/* Polishing a grid that is far from conformal does not enlarge rounding errors: the triangle rotated,
 * or given with other corners first, has the same grid. */
static void
bad_start_is_polished_in_one_way(void **state)
{
	static const int vertex[3][4] = { { 0, 1, 2, 3 }, { 0, 1, 2, 3 }, { 1, 2, 3, 0 } };
	static const double angle[3] = { 0, 1, 0 };
	Conformal c[3];
	int i, j, k, r;
	Disk d;

	(void)state;
	for (k = 0; k < 3; k++) {
		halves(angle[k], &d);
		grid_of(&d, vertex[k], CHART[0], &c[k]);
		disk_free(&d);
	}
	assert_true(c[0].polished > 0);
	for (j = 0; j < NU; j++)
		for (i = 0; i < NU; i++)
			for (k = 1; k < 3; k++) {
				double x = c[0].grid.phi[0][j*NU+i], y = c[0].grid.phi[1][j*NU+i];

				r = k == 1 ? j*NU + i : (NU - 1 - i)*NU + j;
				assert_true(fabs(c[k].grid.phi[0][r] - cos(angle[k])*x + sin(angle[k])*y) < 1e-9);
				assert_true(fabs(c[k].grid.phi[1][r] - sin(angle[k])*x - cos(angle[k])*y) < 1e-9);
			}
	for (k = 0; k < 3; k++)
		conformal_free(&c[k]);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(H_is_of_second_order),
		cmocka_unit_test(a_cap_is_a_sock),
		cmocka_unit_test(numbering_does_not_matter),
		cmocka_unit_test(bad_start_is_polished_in_one_way),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
