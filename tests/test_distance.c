/* test_distance.c - distance.h: known distances of surfaces, and crossing faces; gridmesh.h: the
 * faces of a grid. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <cmocka.h>

#include "../lib/mesh/distance.h"
#include "../lib/grid/gridmesh.h"
#include "../lib/synth/synth.h"
#include "../lib/base/vec3.h"

static Mesh
make(const char *kind, const char *par, double value, int n, uint64_t seed)
{
	Synth s;
	Mesh m;

	assert_int_equal(synth_init(&s, kind), 0);
	if (par)
		assert_int_equal(synth_set(&s, par, value), 0);
	assert_int_equal(synth_mesh(&s, n, seed, &m, NULL), 0);
	return m;
}

static void
move(Mesh *m, double x, double y, double z)
{
	int p;

	for (p = 0; p < m->nv; p++) {
		m->xyz[3*p] += x;
		m->xyz[3*p+1] += y;
		m->xyz[3*p+2] += z;
	}
}

/* The Hausdorff distance up to `error`; checks that it is symmetric. */
static double
hausdorff(const Mesh *a, const Mesh *b, double error)
{
	double ab, ba;

	assert_int_equal(distance_hausdorff(a, b, error, &ab), 0);
	assert_int_equal(distance_hausdorff(b, a, error, &ba), 0);
	assert_true(fabs(ab - ba) <= 2*error);
	return ab;
}

static long
crossings(const Mesh *m)
{
	long pairs = -1;

	assert_int_equal(distance_crossings(m, &pairs), 0);
	return pairs;
}

/* The mesh of a grid of nu x nv nodes on the graph of f over [0,3] x [0,2]. */
static Mesh
grid(int nu, int nv, double (*f)(double x, double y))
{
	double *x = malloc(sizeof *x*(size_t)(3*nu*nv)), *y = x + nu*nv, *z = y + nu*nv;
	Mesh m;
	int p;

	assert_non_null(x);
	for (p = 0; p < nu*nv; p++) {
		x[p] = 3.*(p%nu)/(nu-1);
		y[p] = 2.*(p/nu)/(nv-1);
		z[p] = f(x[p], y[p]);
	}
	assert_int_equal(mesh_from_grid(&m, (Chart){ nu, nv, 1, &CHART_RECTANGLE }, (const double *[]){ x, y, z }), 0);
	free(x);
	return m;
}

static double
level(double x, double y)
{
	(void)x, (void)y;
	return 0;
}

static double
slope(double x, double y)
{
	return 0.3*x - 0.7*y;
}

static double
wave(double x, double y)
{
	return sin(2*x + y);
}

static void
same_surface_is_at_zero(void **state)
{
	Mesh a = make("face", NULL, 0, 1500, 1), b = make("face", NULL, 0, 1500, 1);

	(void)state;
	assert_true(hausdorff(&a, &b, 0.01) == 0);
	mesh_free(&a);
	mesh_free(&b);
}

/* Two triangulations of the same plane rectangle have distance 0.  The error bound is large because
 * CGAL is slow here for small ones, see distance.h. */
static void
triangulation_does_not_matter(void **state)
{
	Mesh a = make("rectangle", NULL, 0, 700, 1), b = make("rectangle", NULL, 0, 900, 2);

	(void)state;
	assert_true(hausdorff(&a, &b, 5e-3) <= 5e-3);
	mesh_free(&a);
	mesh_free(&b);
}

/* If a plane rectangle is translated along its normal or in its own plane, the distance is the
 * length of the translation. */
static void
moved_plane(void **state)
{
	Mesh a = make("rectangle", NULL, 0, 700, 1), b = make("rectangle", NULL, 0, 900, 2);

	(void)state;
	move(&b, 0, 0, 0.25);
	assert_true(fabs(hausdorff(&a, &b, 1e-4) - 0.25) <= 1e-4);
	move(&b, 0.3, 0, -0.25);
	assert_true(fabs(hausdorff(&a, &b, 1e-4) - 0.3) <= 1e-4);
	mesh_free(&a);
	mesh_free(&b);
}

/* A small rectangle inside a large one: from the small to the large one the distance is 0, in the
 * other direction it is 3.  distance_hausdorff returns the larger of both. */
static void
hausdorff_distance_is_symmetric(void **state)
{
	Mesh a = make("rectangle", "a", 1, 300, 1), b = make("rectangle", "a", 4, 900, 2);

	(void)state;
	assert_true(fabs(hausdorff(&a, &b, 1e-2) - 3) <= 1e-2);
	mesh_free(&a);
	mesh_free(&b);
}

/* The distance is right if the farthest point is inside a face: a triangle compared with a pyramid
 * over it. */
static void
inside_of_a_face(void **state)
{
	double flat[] = { 0, 0, 0,  3, 0, 0,  0, 3, 0 };
	double roof[] = { 0, 0, 0,  3, 0, 0,  0, 3, 0,  1, 1, 0.5 };
	int one[] = { 0, 1, 2 }, three[] = { 0, 1, 3,  1, 2, 3,  2, 0, 3 };
	Mesh a = { 3, 1, flat, one }, b = { 4, 3, roof, three };

	(void)state;
	assert_true(fabs(hausdorff(&a, &b, 1e-5) - 0.5) <= 1e-5);
}

/* Concentric spherical caps of radii 1 and 1.1 are 0.1 apart, up to the error of the facets. */
static void
concentric_spheres(void **state)
{
	Mesh a = make("cap", NULL, 0, 3000, 1), b = make("cap", "R", 1.1, 3000, 1);

	(void)state;
	assert_true(fabs(hausdorff(&a, &b, 1e-4) - 0.1) <= 1e-3);
	mesh_free(&a);
	mesh_free(&b);
}

static void
vertices_by_number(void **state)
{
	Mesh a = grid(5, 4, slope), b = grid(5, 4, slope);
	double max, mean;

	(void)state;
	move(&b, 3, 0, 4);
	distance_vertices(&a, &b, &max, &mean);
	assert_true(fabs(max - 5) < 1e-12 && fabs(mean - 5) < 1e-12);
	b.xyz[3*7] += 12;       /* vertex 7 differs by (15, 0, 4) */
	distance_vertices(&a, &b, &max, &mean);
	assert_true(fabs(max - sqrt(241)) < 1e-12);
	assert_true(fabs(mean - (19*5 + sqrt(241))/20) < 1e-12);
	mesh_free(&a);
	mesh_free(&b);
}

static void
smooth_disks_do_not_cross(void **state)
{
	Mesh a = make("tooth", NULL, 0, 2000, 1), b = make("spiral", NULL, 0, 2000, 1);

	(void)state;
	assert_int_equal(crossings(&a), 0);
	assert_int_equal(crossings(&b), 0);
	mesh_free(&a);
	mesh_free(&b);
}

/* Two squares of two faces each, in planes at right angles: first they cross, then the second one
 * is moved away and nothing crosses. */
static void
crossing_squares(void **state)
{
	double xyz[] = { -1, -1, 0,  1, -1, 0,  1, 1, 0,  -1, 1, 0,
		-1, 0.1, -1,  1, 0.1, -1,  1, 0.1, 1,  -1, 0.1, 1 };
	int tri[] = { 0, 1, 2,  0, 2, 3,  4, 5, 6,  4, 6, 7 };
	Mesh m = { 8, 4, xyz, tri };
	int p;

	(void)state;
	assert_true(crossings(&m) >= 2);
	for (p = 4; p < 8; p++)
		xyz[3*p+1] = 5;
	assert_int_equal(crossings(&m), 0);
}

static void
folded_face_crosses(void **state)
{
	Mesh a = grid(9, 7, level);

	(void)state;
	assert_int_equal(crossings(&a), 0);
	a.xyz[3*(3*9 + 4)] += 1;        /* folded onto its neighbours in the same plane */
	assert_true(crossings(&a) > 0);
	mesh_free(&a);
}

/* Faces without area are ignored; a mesh that has only such faces is an error. */
static void
faces_of_no_area_are_left_out(void **state)
{
	double xyz[] = { 0, 0, 0,  1, 0, 0,  2, 0, 0,  1, 1, 0 };
	int tri[] = { 0, 1, 3,  1, 2, 3,  0, 2, 1 };
	Mesh m = { 4, 3, xyz, tri }, none = { 4, 1, xyz, tri + 6 };
	double d;

	(void)state;
	assert_int_equal(crossings(&m), 0);
	assert_true(hausdorff(&m, &m, 1e-4) == 0);
	assert_int_equal(distance_hausdorff(&m, &none, 1e-4, &d), DISTANCE_EAREA);
	assert_int_equal(distance_hausdorff(&none, &m, 1e-4, &d), DISTANCE_EAREA);
}

static void
edge_of_three_faces(void **state)
{
	double xyz[] = { 0, 0, 0,  1, 0, 0,  0, 1, 0,  0, -1, 0,  0, 0, 1 };
	int tri[] = { 0, 1, 2,  1, 0, 3,  0, 1, 4 };
	Mesh m = { 5, 3, xyz, tri };
	long pairs;

	(void)state;
	assert_int_equal(distance_crossings(&m, &pairs), DISTANCE_EEDGE);
}

/* mesh_from_grid keeps the numbers of the nodes, makes two faces of each cell, and orients them so
 * that their normals have the direction of phi_u x phi_v. */
static void
grid_mesh(void **state)
{
	const int nu = 7, nv = 5;
	Mesh m = grid(nu, nv, slope);
	double e[3], g[3], n[3];
	int f, *t;

	(void)state;
	assert_int_equal(m.nv, nu*nv);
	assert_int_equal(m.nf, 2*(nu-1)*(nv-1));
	for (f = 0; f < m.nf; f++) {
		t = m.tri + 3*f;
		sub3(m.xyz + 3*t[1], m.xyz + 3*t[0], e);
		sub3(m.xyz + 3*t[2], m.xyz + 3*t[0], g);
		cross3(e, g, n);
		assert_true(n[2] > 0);
	}
	assert_true(fabs(mesh_area(&m) - 6*sqrt(1 + 0.09 + 0.49)) < 1e-12);
	assert_true(fabs(m.xyz[3*(2*nu + 3)] - 1.5) < 1e-15);
	assert_true(fabs(m.xyz[3*(2*nu + 3) + 1] - 1) < 1e-15);
	mesh_free(&m);
}

/* Every cell is cut along its shorter diagonal. */
static void
grid_mesh_takes_the_shorter_diagonal(void **state)
{
	const int nu = 12, nv = 9;
	Mesh m = grid(nu, nv, wave);
	double d[3], ac, bd;
	int i, f, p, *t, cut;

	(void)state;
	for (f = 0; f < m.nf; f += 2) {
		p = f/2/(nu-1)*nu + f/2%(nu-1);
		sub3(m.xyz + 3*p, m.xyz + 3*(p+1+nu), d);
		ac = norm3(d);
		sub3(m.xyz + 3*(p+1), m.xyz + 3*(p+nu), d);
		bd = norm3(d);
		for (cut = i = 0, t = m.tri + 3*f; i < 6; i++)
			cut += t[i] == p;       /* cut along ac, both faces contain a = p; else one */
		assert_int_equal(cut, ac <= bd ? 2 : 1);
	}
	mesh_free(&m);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(same_surface_is_at_zero),
		cmocka_unit_test(triangulation_does_not_matter),
		cmocka_unit_test(moved_plane),
		cmocka_unit_test(hausdorff_distance_is_symmetric),
		cmocka_unit_test(inside_of_a_face),
		cmocka_unit_test(concentric_spheres),
		cmocka_unit_test(vertices_by_number),
		cmocka_unit_test(smooth_disks_do_not_cross),
		cmocka_unit_test(crossing_squares),
		cmocka_unit_test(folded_face_crosses),
		cmocka_unit_test(faces_of_no_area_are_left_out),
		cmocka_unit_test(edge_of_three_faces),
		cmocka_unit_test(grid_mesh),
		cmocka_unit_test(grid_mesh_takes_the_shorter_diagonal),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
