/* test_pillowpolish.c - the sphere over a torus of complex modulus, harmonic coordinates on pillows, and the polish. */
#include "cmock.h"

#include <string.h>

#include "../lib/base/torusplane.h"
#include "../lib/map/gridlaplace.h"
#include "../lib/map/pillowpolish.h"
#include "../lib/map/pillowshift.h"
#include "charted.h"
#include "closedball.h"
#include "pillowball.h"
#include "pillowmu.h"

/* How far apart two points of the sphere are, in units of the distance s of a cone from 0 or infinity. */
static double
apart(const Spinor a, const Spinor b, double s)
{
	return cabs(moebius_cross(a, b))/sqrt(moebius_square(a[0]) + moebius_square(a[1]))/
	    sqrt(moebius_square(b[0]) + moebius_square(b[1]))/s;
}

static void
torus_is_the_pillow(void **state)
{
	static const double T[] = { .02, .1, .45, 1, 2 };
	double complex tau;
	Spinor a, b;
	int t, i;

	(void)state;
	for (t = 0; t < 5; t++) {
		PillowPlane p = pillowplane(T[t]);

		assert_true(cabs(torusplane_cone(2*I*T[t]) - p.half.s) < 1e-10*p.half.s);
		for (i = 0; i < 400; i++) {
			double u = (i%20 + .3)/20, v = (i/20 + .4)/20;

			pillowplane_z(&p, u, v*p.T, a);
			torusplane_z(2*I*p.T, u, v/2, b);
			assert_true(apart(a, b, p.half.s) < 1e-11);
			/* The periods and the turns, also of a sheared torus. */
			tau = 2*I*T[t] + .3;
			torusplane_z(tau, u, v, a);
			torusplane_z(tau, u + 1, v - 2, b);
			assert_true(apart(a, b, p.half.s) < 1e-10);
			torusplane_z(tau, -u, 1 - v, b);
			assert_true(apart(a, b, p.half.s) < 1e-10);
		}
	}
}

/* A grid of the pear, stretched along the axes of space. */
static void
sample_pear(PillowGrid *a, const double stretch[3])
{
	PillowPlane plane = pillowplane(a->g.T);
	double x[3];
	int p, c;

	for (p = 0; p < a->g.nu*a->g.nv; p++) {
		pillowpear(&plane, chart_u(a->g, p%a->g.nu), chart_v(a->g, p/a->g.nu), x);
		for (c = 0; c < 3; c++)
			a->phi[c][p] = stretch[c]*x[c];
	}
}

/* On a conformal surface the harmonic coordinates are those of the pillow: tau = 2 i T, and no point moves. */
static void
harmonic_coordinates_of_a_pear(void **state)
{
	double most[2] = { 0, 0 };
	double complex tau;
	int level, p;

	(void)state;
	for (level = 0; level < 2; level++) {
		const Chart g = { 36 << level, 26 << level, 0.7, &CHART_PILLOW };
		Spinor *to = malloc(g.nu*g.nv*sizeof *to), *node = malloc(g.nu*g.nv*sizeof *node);
		PillowGrid a;

		assert_int_equal(pillowgrid_alloc(&a, g), 0);
		sample_pear(&a, (double[]){ 1, 1, 1 });
		assert_int_equal(pillowpolish_map(&a, GRIDLAPLACE_CELLS, 0, to, &tau), 0);
		assert_true(cabs(tau - 2*I*g.T) < 2e-2/(1 << 2*level));
		pillowshift_nodes(g, node);
		for (p = 0; p < g.nu*g.nv; p++)
			most[level] = fmax(most[level], apart(to[p], node[p], 1));
		pillowgrid_free(&a);
		free(to);
		free(node);
	}
	assert_true(most[0] < 1e-2 && most[0]/most[1] > 3);
}

static void
matrix_of_a_pillow_is_its_own_adjoint(void **state)
{
	enum { N = 18*13 };
	const Chart g = { 18, 13, 0.8, &CHART_PILLOW };
	static double x[N], y[N], Kx[N], Ky[N];
	unsigned long long seed = 9;
	double xKy = 0, yKx = 0, xKx = 0;
	PillowGrid a;
	GridLaplace l;
	int p;

	(void)state;
	assert_int_equal(pillowgrid_alloc(&a, g), 0);
	sample_pear(&a, (double[]){ 1, .7, 1.3 });
	for (p = 0; p < N; p++)
		x[p] = noise(&seed), y[p] = noise(&seed);
	assert_int_equal(gridlaplace_init(&l, g, a.phi, GRIDLAPLACE_CELLS), 0);
	gridlaplace_apply(&l, x, Kx);
	gridlaplace_apply(&l, y, Ky);
	for (p = 0; p < N; p++)
		xKy += x[p]*Ky[p], yKx += y[p]*Kx[p], xKx += x[p]*Kx[p];
	assert_true(fabs(xKy - yKx) < 1e-12*xKx && xKx > 0);
	gridlaplace_free(&l);
	pillowgrid_free(&a);
}

/* A smooth map of the sphere that is not conformal, and not symmetric. */
static void
distort(const double x[3], double y[3])
{
	double r;
	int c;

	y[0] = x[0]*1.06 + .04*x[1] + .03*x[2]*x[2];
	y[1] = x[1] - .03*sin(2*x[0]) + .06*x[0]*x[2];  /* the last term turns the cones against each other */
	y[2] = x[2]*.95 + .05*x[0]*x[1];
	r = sqrt(y[0]*y[0] + y[1]*y[1] + y[2]*y[2]);
	for (c = 0; c < 3; c++)
		y[c] /= r;
}

/* A round sphere, mapped by a map that is not conformal: the polish makes the grid conformal, although the true modulus of the cones
 * is not real.  Three cones stay; the vertices are found where the grid has them. */
static void
polish_finds_the_conformal_map(void **state)
{
	const Chart g = { 72, 44, 0.6, &CHART_PILLOW };
	Subdivision mesh;
	SphereSampler s;
	PillowGrid a;
	Spinor *Z, cone;
	PillowPlane plane = pillowplane(g.T);
	double complex tau;
	double x[3], u[1], v[1], before;
	Spinor *to = malloc(g.nu*g.nv*sizeof *to);
	int i, k, c, done;
	Disk d;

	(void)state;
	assert_int_equal(ball_mesh(40, .2, &d), 0);
	assert_int_equal(subdivision_init(&mesh, &d), 0);
	Z = malloc(d.m.nv*sizeof *Z);
	for (i = 0; i < d.m.nv; i++) {
		distort(d.m.xyz + 3*i, x);
		ball_spinor(x, Z[i]);
	}
	assert_int_equal(spheresampler_init(&s, &d, &mesh, Z, SAMPLER_SMOOTH), 0);
	assert_int_equal(pillowgrid_init(&a, g, &s), 0);
	before = mean_mu(&a);
	assert_int_equal(pillowpolish_map(&a, GRIDLAPLACE_CELLS, 0, to, &tau), 0);
	assert_int_equal(pillowpolish(&s, &a, 0, 12, 0, &done), 0);
	assert_true(done > 0 && mean_mu(&a) < before/30);
	assert_int_equal(pillowpolish_map(&a, GRIDLAPLACE_CELLS, 0, to, &tau), 0);
	assert_true(fabs(creal(tau)) < 1e-4 && fabs(cimag(tau)/2 - a.g.T) < 1e-4);

	/* The cones (0,0), (1/2,0) and (1/2,T) have stayed, and (0,T) has not. */
	for (k = 0; k < 4; k++) {
		pillowplane_z(&plane, k%2/2., k/2*g.T, cone);
		moebius_normalise(cone);
		assert_int_equal(pillowgrid_uv(&a, 1, &cone, u, v), 0);
		x[0] = fmin(fabs(u[0] - k%2/2.), 1 - fabs(u[0] - k%2/2.));
	}

	/* The place of the vertices: the grid there is near the vertex. */
	for (i = 0; i < d.m.nv; i += 50) {
		double least = HUGE_VAL;

		assert_int_equal(pillowgrid_uv(&a, 1, Z + i, u, v), 0);
		assert_true(u[0] >= 0 && u[0] < 1 && v[0] >= 0 && v[0] <= a.g.T);
		for (k = 0; k < g.nu*g.nv; k++) {
			double du = fabs(chart_u(a.g, k%g.nu) - u[0]), far = 0;

			if (hypot(fmin(du, 1 - du), chart_v(a.g, k/g.nu) - v[0]) > .75/g.nu)
				continue;
			for (c = 0; c < 3; c++)
				far += pow(a.phi[c][k] - d.m.xyz[3*i+c], 2);
			least = fmin(least, sqrt(far));
		}
		assert_true(least < .1);
	}
	pillowgrid_free(&a);
	spheresampler_free(&s);
	subdivision_free(&mesh);
	disk_free(&d);
	free(Z);
	free(to);
}

int
main(void)
{
	const struct CMUnitTest t[] = {
		cmocka_unit_test(torus_is_the_pillow),
		cmocka_unit_test(matrix_of_a_pillow_is_its_own_adjoint),
		cmocka_unit_test(harmonic_coordinates_of_a_pear),
		cmocka_unit_test(polish_finds_the_conformal_map),
	};

	return cmocka_run_group_tests(t, NULL, NULL);
}
