/* test_sphere.c - sphere.h, spherecones.h: closed surfaces of which the conformal map is known. */
#include <stdio.h>

#include "cmock.h"

#include "../lib/map/spherecones.h"
#include "../lib/map/sphereparts.h"
#include "../lib/map/sphere.h"
#include "../lib/base/vec3.h"
#include "closedmesh.h"

static const AdaptOptions PLAIN = { 1, 1, 1000000 }, LINEAR = { 1, 0, 1000000 }, FINE = { 1e-3, 1, 1000000 };

static void
map(const Disk *d, const AdaptOptions *o, SphereMap *m)
{
	SpdReport report;

	assert_int_equal(sphere_map(d, o, m, &report), 0);
	assert_int_equal(m->turned, 0);
}

static void
map_mesh(const Mesh *mesh, const AdaptOptions *o, Disk *d, SphereMap *m)
{
	assert_int_equal(closed_disk(mesh, d), 0);
	map(d, o, m);
}

/* The largest distance of the n points Z from W, after the Moebius map that takes three of them there. */
static double
apart(int n, Spinor *Z, Spinor *W)
{
	int at[3] = { 0, 2, 4 }, i, k;
	Spinor P[3], Q[3], w;
	Moebius M;
	double most = 0;

	for (k = 0; k < 3; k++) {
		memcpy(P[k], Z[at[k]], sizeof P[k]);
		memcpy(Q[k], W[at[k]], sizeof Q[k]);
	}
	moebius_three(P, Q, M);
	for (i = 0; i < n; i++) {
		moebius_apply(M, Z[i], w);
		most = fmax(most, 2*cabs(moebius_cross(w, W[i])));
	}
	return most;
}

/* ---- surfaces of revolution ------------------------------------------ */

/* The ellipsoid with the half axes 1, 1, c: z = e^psi e^(i phi), with t the angle from the pole and
 * dpsi/dt = sqrt(cos^2 t + c^2 sin^2 t)/sin t.  The difference from the sphere, where e^psi = tan(t/2), is
 * integrated by Simpson's rule. */
static double
beyond_sphere(double c, double t)
{
	double s = fmax(sin(t), 1e-300);

	return (sqrt(cos(t)*cos(t) + c*c*s*s) - 1)/s;
}

static void
ellipsoid_point(double c, const double x[3], Spinor Z)
{
	double t = atan2(hypot(x[0], x[1]), x[2]), psi = 0, h;
	int k, n = 200;

	h = (t - M_PI/2)/n;
	for (k = 0; k < n; k++)
		psi += h/6*(beyond_sphere(c, M_PI/2 + k*h) + 4*beyond_sphere(c, M_PI/2 + (k + .5)*h)
		    + beyond_sphere(c, M_PI/2 + (k + 1)*h));
	Z[0] = exp(psi)*sin(t/2)*cexp(I*atan2(x[1], x[0]));
	Z[1] = cos(t/2);
	moebius_normalise(Z);
}

/* The error of the map of the ellipsoid. */
static double
ellipsoid_error(double c, int splits, const AdaptOptions *o)
{
	Mesh mesh = closed_sphere(splits, .2);
	Spinor *W = malloc(mesh.nv*sizeof *W);
	SphereMap m;
	double error;
	Disk d;
	int i;

	assert_non_null(W);
	for (i = 0; i < mesh.nv; i++) {
		ellipsoid_point(c, &mesh.xyz[3*i], W[i]);
		mesh.xyz[3*i+2] *= c;
	}
	map_mesh(&mesh, o, &d, &m);
	error = apart(mesh.nv, m.Z, W);
	sphere_free(&m);
	disk_free(&d);
	mesh_free(&mesh);
	free(W);
	return error;
}

static void
the_map_of_a_sphere_is_a_moebius_map(void **state)
{
	double e[3];
	int k;

	(void)state;
	for (k = 0; k < 3; k++)
		e[k] = ellipsoid_error(1, 3 + k, &PLAIN);
	print_message("sphere: %.3g %.3g %.3g\n", e[0], e[1], e[2]);
	assert_true(e[2] < e[1]/2.5 && e[1] < e[0]/2.5 && e[2] < 2e-3);
}

static void
the_map_of_an_ellipsoid_converges(void **state)
{
	static const double c[] = { .5, 2 };
	double e[2];
	int k;

	(void)state;
	for (k = 0; k < 2; k++) {
		e[0] = ellipsoid_error(c[k], 4, &PLAIN);
		e[1] = ellipsoid_error(c[k], 5, &PLAIN);
		print_message("ellipsoid %g: %.3g %.3g\n", c[k], e[0], e[1]);
		assert_true(e[1] < e[0]/2.5 && e[1] < 1e-2);
	}
}

static void
splitting_lowers_the_certificate(void **state)
{
	Mesh mesh = closed_sphere(3, .2);
	SphereMap linear, fine;
	Disk d;
	int i;

	(void)state;
	for (i = 0; i < mesh.nv; i++)
		mesh.xyz[3*i+2] *= 3;
	map_mesh(&mesh, &LINEAR, &d, &linear);
	map(&d, &FINE, &fine);
	assert_true(fine.certificate <= FINE.tolerance && linear.certificate > 5*FINE.tolerance);
	assert_true(fine.mu < linear.mu/2 && fine.quadratic && !linear.quadratic);
	sphere_free(&linear);
	sphere_free(&fine);
	disk_free(&d);
	mesh_free(&mesh);
}

/* ---- other numbers of the same surface -------------------------------- */

/* Turns, moves and scales m. */
static void
move(Mesh *m)
{
	static const double R[3][3] = { { .36, .48, -.8 }, { -.8, .6, 0 }, { .48, .64, .6 } };
	double x[3];
	int i, c;

	for (i = 0; i < m->nv; i++) {
		memcpy(x, &m->xyz[3*i], sizeof x);
		for (c = 0; c < 3; c++)
			m->xyz[3*i+c] = 1e3*(R[c][0]*x[0] + R[c][1]*x[1] + R[c][2]*x[2] + c);
	}
}

/* Vertex i becomes nv-1-i, and faces are in the opposite order; the three vertices that `apart` uses keep theirs. */
static void
renumber(Mesh *m)
{
	Mesh old = { m->nv, m->nf, malloc(3*m->nv*sizeof *m->xyz), malloc(3*m->nf*sizeof *m->tri) };
	int i, k;

	assert_non_null(old.xyz);
	assert_non_null(old.tri);
	memcpy(old.xyz, m->xyz, 3*m->nv*sizeof *m->xyz);
	memcpy(old.tri, m->tri, 3*m->nf*sizeof *m->tri);
	for (i = 0; i < m->nv; i++)
		memcpy(&m->xyz[3*(m->nv - 1 - i)], &old.xyz[3*i], 3*sizeof *m->xyz);
	for (i = 0; i < m->nf; i++)
		for (k = 0; k < 3; k++)
			m->tri[3*i+k] = m->nv - 1 - old.tri[3*(m->nf - 1 - i) + (k + 1)%3];
	mesh_free(&old);
}

static void
the_map_is_that_of_the_moved_and_renumbered_surface(void **state)
{
	Mesh mesh = closed_sphere(4, .2);
	SphereMap a, b;
	Spinor *Z;
	Disk d;
	int i;

	(void)state;
	for (i = 0; i < mesh.nv; i++)
		mesh.xyz[3*i] *= 2 + mesh.xyz[3*i+1];
	map_mesh(&mesh, &PLAIN, &d, &a);
	disk_free(&d);
	move(&mesh);
	map_mesh(&mesh, &PLAIN, &d, &b);
	disk_free(&d);
	assert_true(apart(mesh.nv, b.Z, a.Z) < 1e-9);
	sphere_free(&b);
	renumber(&mesh);
	map_mesh(&mesh, &PLAIN, &d, &b);
	disk_free(&d);
	Z = malloc(mesh.nv*sizeof *Z);
	assert_non_null(Z);
	for (i = 0; i < mesh.nv; i++)
		memcpy(Z[i], b.Z[mesh.nv-1-i], sizeof Z[i]);
	assert_true(apart(mesh.nv, Z, a.Z) < 1e-9);
	free(Z);
	sphere_free(&a);
	sphere_free(&b);
	mesh_free(&mesh);
}

/* ---- cones ----------------------------------------------------------- */

/* A body with four arms, at the corners of a tetrahedron or of a rectangle. */
static Mesh
body_with_arms(double height)
{
	Mesh m = closed_sphere(5, .1);
	const double x = sqrt(1 - height*height);
	const double arm[4][3] = { { x, 0, height }, { -x, 0, height }, { 0, x, -height }, { 0, -x, -height } };
	double near, r;
	int i, k;

	for (i = 0; i < m.nv; i++) {
		for (r = 1, k = 0; k < 4; k++) {
			near = arm[k][0]*m.xyz[3*i] + arm[k][1]*m.xyz[3*i+1] + arm[k][2]*m.xyz[3*i+2];
			r += 2*exp(-30*(1 - near));
		}
		for (k = 0; k < 3; k++)
			m.xyz[3*i+k] *= r;
	}
	return m;
}

static void
cones_go_to_the_tips_of_limbs(void **state)
{
	Mesh mesh = body_with_arms(0);
	SphereMap m;
	SphereCones c, other;
	Spinor Z;
	double far, most;
	Disk d;
	int i, k, at[3] = { 0, 2, 1 }, given[3] = { 0, 4, 3 };

	(void)state;
	map_mesh(&mesh, &PLAIN, &d, &m);
	assert_int_equal(spherecones(&m.mesh.d.m, m.Z, NULL, &c), 0);
	for (k = 0; k < 4; k++) {
		conemap_place(&c.map, k, Z);
		for (most = 1, far = 0, i = 0; i < mesh.nv; i++)
			if (cabs(moebius_cross(Z, m.Z[i])) < most) {
				most = cabs(moebius_cross(Z, m.Z[i]));
				far = sqrt(mesh.xyz[3*i]*mesh.xyz[3*i] + mesh.xyz[3*i+1]*mesh.xyz[3*i+1]);
			}
		assert_true(far > 2.5);
	}
	assert_true(c.map.T >= 0.5 && c.chi2 > 1);
	assert_int_equal(spherecones(&m.mesh.d.m, m.Z, given, &other), 0);
	assert_true(other.chi2 > 1.5*c.chi2);
	assert_int_equal(spherecones(&m.mesh.d.m, m.Z, at, &other), 0);
	assert_true(other.chi2 < 1.2*c.chi2 && other.chi2 > 0.99*c.chi2);
	for (k = 0; k < 3; k++) {
		conemap_place(&other.map, k, Z);
		assert_true(cabs(moebius_cross(Z, m.Z[at[k]])) < 1e-9);
	}
	given[1] = given[0];
	assert_int_equal(spherecones(&m.mesh.d.m, m.Z, given, &other), SPHERECONES_EEQUAL);
	sphere_free(&m);
	disk_free(&d);
	mesh_free(&mesh);
}

/* The four cones that are best for a sphere are equally far from each other, on a circle: T = 1/2. */
static void
the_pillow_of_a_sphere_is_a_square(void **state)
{
	Mesh mesh = closed_sphere(5, .3);
	SphereMap m;
	SphereCones c;
	Disk d;

	(void)state;
	map_mesh(&mesh, &PLAIN, &d, &m);
	assert_int_equal(spherecones(&m.mesh.d.m, m.Z, NULL, &c), 0);
	assert_true(fabs(c.map.T - .5) < .02);
	assert_true(c.chi2 > 1.2 && c.chi2 < 1.3);
	sphere_free(&m);
	disk_free(&d);
	mesh_free(&mesh);
}

static void
the_gradient_of_chi2_is_that_of_its_values(void **state)
{
	Mesh mesh = body_with_arms(.5);
	double g[8], H[8][8], x, h = 1e-6, f[2];
	Spinor cone[4], old;
	SphereParts p;
	SphereMap m;
	Disk d;
	int i, s;

	(void)state;
	map_mesh(&mesh, &LINEAR, &d, &m);
	assert_int_equal(sphereparts_init(&p, &m.mesh.d.m, m.Z, 512), 0);
	assert_true(p.n > 800 && p.n <= 1024);
	for (i = 0; i < 4; i++)
		memcpy(cone[i], m.Z[100*i], sizeof cone[i]);
	x = sphereparts_derivatives(&p, cone, g, H);
	assert_true(x == sphereparts_value(&p, cone));
	for (i = 0; i < 8; i++) {
		memcpy(old, cone[i/2], sizeof old);
		for (s = 0; s < 2; s++) {
			moebius_point(old, (s ? h : -h)*(i%2 ? I : 1), cone[i/2]);
			f[s] = sphereparts_value(&p, cone);
		}
		memcpy(cone[i/2], old, sizeof old);
		assert_true(fabs((f[1] - f[0])/(2*h) - g[i]) < 1e-5*(1 + fabs(g[i])));
		assert_true(H[i][i] >= 0);
	}
	sphereparts_free(&p);
	sphere_free(&m);
	disk_free(&d);
	mesh_free(&mesh);
}

/* The component along the radius of the normal of face t of a sphere round (1e4,1e4,1e4). */
static double
outward(const Mesh *m, int t)
{
	double a[3][3], n[3];
	int k, c;

	for (k = 0; k < 3; k++)
		for (c = 0; c < 3; c++)
			a[k][c] = m->xyz[3*m->tri[3*t+k] + c] - 1e4;
	cross3(a[1], a[2], n);
	return dot3(a[0], n);
}

/* ---- what is no sphere ------------------------------------------------ */

static void
a_torus_is_refused_with_its_handle(void **state)
{
	enum { N = 12 };
	Mesh m = { N*N, 2*N*N, malloc(3*N*N*sizeof *m.xyz), malloc(6*N*N*sizeof *m.tri) };
	Disk d;
	int i, j;

	(void)state;
	for (i = 0; i < N; i++)
		for (j = 0; j < N; j++) {
			int a = N*i + j, b = N*((i + 1)%N) + j, c = N*((i + 1)%N) + (j + 1)%N, e = N*i + (j + 1)%N;
			double u = 2*M_PI*i/N, v = 2*M_PI*j/N;
			const double x[3] = { (2 + cos(v))*cos(u), (2 + cos(v))*sin(u), sin(v) };
			const int t[6] = { a, b, c, a, c, e };

			memcpy(&m.xyz[3*a], x, sizeof x);
			memcpy(&m.tri[6*a], t, sizeof t);
		}
	assert_int_equal(closed_disk(&m, &d), MESH_EDISK);
	assert_non_null(strstr(d.err, "1 handle,"));
	mesh_free(&m);
}

/* The faces of a closed surface are turned outwards, here far from the origin. */
static void
normals_point_outwards(void **state)
{
	Mesh m = closed_sphere(2, 0);
	Disk d;
	int i, pass;

	(void)state;
	for (i = 0; i < 3*m.nv; i++)
		m.xyz[i] += 1e4;
	for (pass = 0; pass < 2; pass++) {
		assert_int_equal(closed_disk(&m, &d), 0);
		assert_true((d.note[0] != 0) == pass);
		for (i = 0; i < m.nf; i++)
			assert_true(outward(&d.m, i) > 0);
		for (i = 0; i < 3*m.nf; i++)
			assert_true(d.twin[d.twin[i]] == i && d.m.tri[d.twin[i]] == d.m.tri[i%3 == 2 ? i - 2 : i + 1]);
		for (i = 0; i < m.nf; i++) {
			int c = m.tri[3*i];

			m.tri[3*i] = m.tri[3*i+1];
			m.tri[3*i+1] = c;
		}
		disk_free(&d);
	}
	mesh_free(&m);
}

/* Limbs count by their area on the surface, not on the sphere: a spindle, 8 times as long as thick. */
static void
limbs_are_split_too(void **state)
{
	Mesh mesh = closed_sphere(5, 0);
	SphereMap m;
	SphereCones c;
	Disk d;
	int i;

	(void)state;
	for (i = 0; i < mesh.nv; i++)
		mesh.xyz[3*i+2] *= 8;
	map_mesh(&mesh, &FINE, &d, &m);
	assert_true(m.certificate <= FINE.tolerance && m.mu < 0.03);
	assert_int_equal(spherecones(&m.mesh.d.m, m.Z, NULL, &c), 0);
	assert_true(c.chi2 < 1.2 && c.map.T > 2.7 && c.map.T < 2.9);
	sphere_free(&m);
	disk_free(&d);
	mesh_free(&mesh);
}

/* A needle, 20 times as long as thick: its tips are 1e-11 wide on the sphere. */
static void
a_needle_is_reported(void **state)
{
	Mesh mesh = closed_sphere(5, 0);
	SphereMap m;
	SpdReport report;
	Disk d;
	int i;

	(void)state;
	for (i = 0; i < mesh.nv; i++)
		mesh.xyz[3*i+2] *= 20;
	assert_int_equal(closed_disk(&mesh, &d), 0);
	assert_int_equal(sphere_map(&d, &PLAIN, &m, &report), 0);
	assert_true(m.turned > 0);
	sphere_free(&m);
	disk_free(&d);
	mesh_free(&mesh);
}

static void
few_vertices_are_enough(void **state)
{
	Mesh octahedron = closed_sphere(0, 0);
	SphereMap m;
	Disk d;

	(void)state;
	map_mesh(&octahedron, &LINEAR, &d, &m);
	sphere_free(&m);
	disk_free(&d);
	mesh_free(&octahedron);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(the_map_of_a_sphere_is_a_moebius_map),
		cmocka_unit_test(the_map_of_an_ellipsoid_converges),
		cmocka_unit_test(splitting_lowers_the_certificate),
		cmocka_unit_test(the_map_is_that_of_the_moved_and_renumbered_surface),
		cmocka_unit_test(cones_go_to_the_tips_of_limbs),
		cmocka_unit_test(the_pillow_of_a_sphere_is_a_square),
		cmocka_unit_test(the_gradient_of_chi2_is_that_of_its_values),
		cmocka_unit_test(a_torus_is_refused_with_its_handle),
		cmocka_unit_test(normals_point_outwards),
		cmocka_unit_test(limbs_are_split_too),
		cmocka_unit_test(a_needle_is_reported),
		cmocka_unit_test(few_vertices_are_enough),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
