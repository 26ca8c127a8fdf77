/* test_frame.c - frame.h: the frame method reconstructs a surface from its lambda, its H and a band
 * of nodes along the border. */
#include "cmock.h"

#include "../lib/surface/frame.h"
#include "../lib/grid/lambdah.h"
#include "surfaces.h"

static const Chart COARSE = { 33, 25, 0.8, &CHART_RECTANGLE }, FINE = { 65, 49, 0.8, &CHART_RECTANGLE };
enum { MOST = 65*49 };

static double truth[3][MOST], found[3][MOST], lambda[MOST], H[MOST];

static int
in_band(Chart g, int p)
{
	int i = p%g.nu, j = p/g.nu;

	return i < FRAME_BAND || j < FRAME_BAND || i >= g.nu - FRAME_BAND || j >= g.nv - FRAME_BAND;
}

/* Reconstructs the surface from lambda, H and the nodes of the band alone.  Returns the largest
 * distance of a node from its true position. */
static double
reconstruct(Chart g)
{
	double *phi[3] = { found[0], found[1], found[2] }, max = 0, d;
	int p, c, at;

	for (c = 0; c < 3; c++)
		for (p = 0; p < g.nu*g.nv; p++)
			found[c][p] = in_band(g, p) ? truth[c][p] : 12345;
	assert_int_equal(frame_surface(g, lambda, H, phi, &at, NULL), 0);
	for (p = 0; p < g.nu*g.nv; p++) {
		for (d = 0, c = 0; c < 3; c++)
			d += pow(found[c][p] - truth[c][p], 2);
		if (!(sqrt(d) <= max))
			max = sqrt(d);
	}
	return max;
}

static double
from_truth(Immersion *f, Chart g, double s)
{
	double *phi[3] = { truth[0], truth[1], truth[2] };

	sample_immersion(f, g, s, phi, lambda, H);
	return reconstruct(g);
}

static double
from_differences(Immersion *f, Chart g)
{
	const double *phi[3] = { truth[0], truth[1], truth[2] };

	sample_immersion(f, g, 1, (double **)phi, NULL, NULL);
	lambdah(g, phi, LAMBDAH_NORMAL, lambda, H);
	return reconstruct(g);
}

static void
second_order(void **state)
{
	Immersion *f[] = { stereo, cylinder, catenoid, enneper, torus };
	size_t i;

	(void)state;
	for (i = 0; i < sizeof f/sizeof *f; i++) {
		double coarse = from_truth(f[i], COARSE, 1), fine = from_truth(f[i], FINE, 1);

		assert_true(fine < 5e-4);
		assert_true(fine < coarse/3);
		assert_true(from_differences(f[i], FINE) < 5e-4);
	}
}

static void
exact_on_plane(void **state)
{
	(void)state;
	assert_true(from_truth(plane, COARSE, 1) < 1e-10);
}

static void
free_of_the_unit_of_length(void **state)
{
	double one = from_truth(enneper, COARSE, 1);

	(void)state;
	assert_true(fabs(from_truth(enneper, COARSE, 1e4)/1e4 - one) < 1e-9);
	assert_true(fabs(from_truth(enneper, COARSE, 1e-4)*1e4 - one) < 1e-9);
}

/* The sign of H decides to which side the surface bends: with the wrong sign the error must be
 * large. */
static void
sign_of_H_matters(void **state)
{
	double right = from_truth(stereo, COARSE, 1);
	int p;

	(void)state;
	for (p = 0; p < COARSE.nu*COARSE.nv; p++)
		H[p] = -H[p];
	assert_true(reconstruct(COARSE) > 20*right);
}

/* frame_make_conformal returns two orthogonal vectors of length lambda that are nearest to the
 * given ones: rotating them a little about any axis increases the distance. */
static void
nearest_conformal_pair(void **state)
{
	const double p0[3] = { 1, 0.4, -0.3 }, q0[3] = { 0.2, 2, 0.5 }, a = 1e-3;
	double p[3], q[3], best, d;
	int axis, sign, b, c;

	(void)state;
	memcpy(p, p0, sizeof p);
	memcpy(q, q0, sizeof q);
	frame_make_conformal(1.7, p, q);
	assert_true(fabs(p[0]*q[0] + p[1]*q[1] + p[2]*q[2]) < 1e-14);
	assert_true(fabs(hypot(hypot(p[0], p[1]), p[2]) - 1.7) < 1e-14);
	assert_true(fabs(hypot(hypot(q[0], q[1]), q[2]) - 1.7) < 1e-14);
	for (best = 0, c = 0; c < 3; c++)
		best += pow(p[c] - p0[c], 2) + pow(q[c] - q0[c], 2);
	for (axis = 0; axis < 3; axis++)
		for (sign = -1; sign <= 1; sign += 2) {
			b = (axis + 1)%3, c = (axis + 2)%3;
			d = pow(p[axis] - p0[axis], 2) + pow(q[axis] - q0[axis], 2);
			d += pow(cos(a)*p[b] - sign*sin(a)*p[c] - p0[b], 2);
			d += pow(sign*sin(a)*p[b] + cos(a)*p[c] - p0[c], 2);
			d += pow(cos(a)*q[b] - sign*sin(a)*q[c] - q0[b], 2);
			d += pow(sign*sin(a)*q[b] + cos(a)*q[c] - q0[c], 2);
			assert_true(d > best);
		}
}

static void
flat_band_is_refused(void **state)
{
	double *phi[3] = { found[0], found[1], found[2] };
	int at = -1;

	(void)state;
	from_truth(stereo, COARSE, 1);
	memset(found, 0, sizeof found);
	assert_int_equal(frame_surface(COARSE, lambda, H, phi, &at, NULL), FRAME_EBAND);
	assert_int_equal(at, COARSE.nu + 1);
}

static void
all_band_stays(void **state)
{
	const Chart small = { 6, 9, 0.8, &CHART_RECTANGLE };

	(void)state;
	assert_true(from_truth(stereo, small, 1) == 0);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(second_order),
		cmocka_unit_test(exact_on_plane),
		cmocka_unit_test(free_of_the_unit_of_length),
		cmocka_unit_test(sign_of_H_matters),
		cmocka_unit_test(nearest_conformal_pair),
		cmocka_unit_test(flat_band_is_refused),
		cmocka_unit_test(all_band_stays),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
