/* test_lambdah.c - lambdah.h on surfaces whose lambda and H are known. */
#include "cmock.h"

#include "../lib/grid/lambdah.h"
#include "surfaces.h"

static const Chart COARSE = { 49, 33, 0.7, &CHART_RECTANGLE }, FINE = { 97, 65, 0.7, &CHART_RECTANGLE };
enum { MOST = 97*65 };

static double x[MOST], y[MOST], z[MOST], lambda[MOST], H[MOST], lambda0[MOST], H0[MOST];
static double *const phi[3] = { x, y, z };
static const double *const cphi[3] = { x, y, z };

typedef struct Err {
	double lambda, H;
} Err;

static Err
error(Immersion *f, Chart g, double s)
{
	LambdahFlaws flaws;

	sample_immersion(f, g, s, (double **)phi, lambda0, H0);
	flaws = lambdah(g, cphi, LAMBDAH_NORMAL, lambda, H);
	assert_int_equal(flaws.raised + flaws.parallel, 0);
	return (Err){ largest(g.nu*g.nv, lambda, lambda0), largest(g.nu*g.nv, H, H0) };
}

/* lambda and H are of second order, also on the border: halving h and k divides the error by about
 * 4; the test requires 3. */
static void
converges(Immersion *f)
{
	Err coarse = error(f, COARSE, 1), fine = error(f, FINE, 1);

	assert_true(fine.lambda < coarse.lambda/3);
	assert_true(fine.H < coarse.H/3 + 1e-11);      /* exact for Enneper's cubics */
	assert_true(fine.lambda < 5e-3 && fine.H < 5e-3);
}

static void
second_order(void **state)
{
	(void)state;
	converges(stereo);
	converges(catenoid);
	converges(enneper);
	converges(torus);
}

static void
exact_on_plane_and_signed_on_cylinder(void **state)
{
	(void)state;
	assert_true(error(plane, COARSE, 1).lambda < 1e-12);
	assert_true(error(plane, COARSE, 1).H < 1e-10);
	assert_true(error(cylinder, COARSE, 1).H < 1e-4);
	assert_true(H[5*COARSE.nu + 5] < 0);
}

static void
scales_with_the_surface(void **state)
{
	(void)state;
	assert_true(error(stereo, COARSE, 1000).H*1000 < 5e-3);
	assert_true(error(stereo, COARSE, 1e-3).H*1e-3 < 5e-3);
	assert_true(error(stereo, COARSE, 1e-3).lambda*1e3 < 5e-3);
}

/* lambda and H do not change when the surface is rotated by 1 radian about (1,2,2)/3 and
 * translated. */
static void
motions_change_nothing(void **state)
{
	const double a[3] = { 1/3.0, 2/3.0, 2/3.0 }, c = cos(1), s = sin(1);
	int p;

	(void)state;
	error(enneper, COARSE, 1);
	memcpy(lambda0, lambda, sizeof lambda);
	memcpy(H0, H, sizeof H);
	for (p = 0; p < COARSE.nu*COARSE.nv; p++) {
		double r[3] = { x[p], y[p], z[p] }, d = (a[0]*r[0] + a[1]*r[1] + a[2]*r[2])*(1 - c);

		x[p] = c*r[0] + s*(a[1]*r[2] - a[2]*r[1]) + d*a[0] + 4;
		y[p] = c*r[1] + s*(a[2]*r[0] - a[0]*r[2]) + d*a[1] - 5;
		z[p] = c*r[2] + s*(a[0]*r[1] - a[1]*r[0]) + d*a[2] + 6;
	}
	lambdah(COARSE, cphi, LAMBDAH_NORMAL, lambda, H);
	assert_true(largest(COARSE.nu*COARSE.nv, lambda, lambda0) < 1e-10);
	assert_true(largest(COARSE.nu*COARSE.nv, H, H0) < 1e-8);
}

/* On a conformal grid the Laplacian of phi has no tangential part, so LAMBDAH_MAGNITUDE and
 * LAMBDAH_NORMAL give the same H. */
static void
magnitude_agrees_where_conformal(void **state)
{
	(void)state;
	error(stereo, FINE, 1);
	memcpy(H0, H, sizeof H);
	lambdah(FINE, cphi, LAMBDAH_MAGNITUDE, lambda, H);
	assert_true(largest(FINE.nu*FINE.nv, H, H0) < 1e-3);
}

static Node
sheared(double u, double v)
{
	return (Node){ { u + v, v, 0 }, 0, 0 };
}

/* beltrami gives |mu| of the shear phi = (u+v, v, 0), where E = 1, F = 1, G = 2 and thus |mu|^2 =
 * (3-2)/(3+2), and nearly 0 on a conformal grid. */
static void
beltrami_of_a_shear(void **state)
{
	static double mu[MOST];
	int p;

	(void)state;
	sample_immersion(sheared, COARSE, 7, (double **)phi, NULL, NULL);
	beltrami(COARSE, cphi, mu);
	for (p = 0; p < (COARSE.nu - 2)*(COARSE.nv - 2); p++)
		assert_true(fabs(mu[p] - sqrt(0.2)) < 1e-12);
	sample_immersion(enneper, FINE, 1, (double **)phi, NULL, NULL);
	beltrami(FINE, cphi, mu);
	for (p = 0; p < (FINE.nu - 2)*(FINE.nv - 2); p++)
		assert_true(mu[p] < 1e-4);
}

/* If 5 x 5 nodes collapse to a point, lambda is still positive and H finite, and the nodes are
 * counted. */
static void
collapsed_nodes_are_counted(void **state)
{
	LambdahFlaws flaws;
	int i, j, p;

	(void)state;
	sample_immersion(stereo, COARSE, 1, (double **)phi, NULL, NULL);
	for (j = 10; j < 15; j++)
		for (i = 10; i < 15; i++) {
			p = j*COARSE.nu + i;
			x[p] = y[p] = z[p] = 0.5;
		}
	flaws = lambdah(COARSE, cphi, LAMBDAH_NORMAL, lambda, H);
	assert_int_equal(flaws.raised, 9);
	assert_int_equal(flaws.parallel, 12);   /* on the sides of the square phi_u or phi_v is 0 */
	for (p = 0; p < COARSE.nu*COARSE.nv; p++)
		assert_true(lambda[p] > 0 && isfinite(H[p]));
}

/* Columns 9 to 11 are put on a line, so phi_u and phi_v are parallel, up to rounding, in column 10.
 * These nodes are counted, and H is 0 there. */
static void
parallel_tangents_are_counted(void **state)
{
	const int nu = COARSE.nu, nv = COARSE.nv;
	const double a[3] = { 0.3, 0.7, -0.2 };
	LambdahFlaws flaws;
	int c, p;

	(void)state;
	sample_immersion(plane, COARSE, 1, (double **)phi, NULL, NULL);
	for (p = 0; p < nu*nv; p++)
		for (c = 0; c < 3; c++)
			if (p%nu >= 9 && p%nu <= 11)
				phi[c][p] = a[c]*(p%nu*chart_h(COARSE) + 0.37*(p/nu)*chart_k(COARSE));
	flaws = lambdah(COARSE, cphi, LAMBDAH_NORMAL, lambda, H);
	assert_int_equal(flaws.raised, 0);
	assert_int_equal(flaws.parallel, nv - 2);
	for (p = nu + 10; p < (nv - 1)*nu; p += nu)
		assert_true(H[p] == 0 && lambda[p] > 0.1);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(second_order),
		cmocka_unit_test(exact_on_plane_and_signed_on_cylinder),
		cmocka_unit_test(scales_with_the_surface),
		cmocka_unit_test(motions_change_nothing),
		cmocka_unit_test(magnitude_agrees_where_conformal),
		cmocka_unit_test(beltrami_of_a_shear),
		cmocka_unit_test(collapsed_nodes_are_counted),
		cmocka_unit_test(parallel_tangents_are_counted),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
