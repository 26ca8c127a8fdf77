/* test_cornersmooth.c - cornersmooth.h: folded corners are smoothed, others stay as they are. */
#include "cmock.h"

#include "../lib/grid/cornerfold.h"
#include "../lib/surface/cornersmooth.h"
#include "surfaces.h"

enum { NU = 70, NV = 61, N = NU*NV };
static const Chart chart = { NU, NV, 0.8, &CHART_RECTANGLE };
static double phi[3*N], truth[3*N], lambda[N], lambda2[N], l2H[N];

/* The plane, with w = z^2 in it: at the corner z = 0 lambda is 0, and the boundary is straight. */
static Node
doubled(double u, double v)
{
	return (Node){ { u*u - v*v, 2*u*v, 0 }, 2*hypot(u, v) + 1e-6, 0 };
}

static Misfit
misfit_of(Immersion *f)
{
	double *x[3] = { truth, truth + N, truth + 2*N }, H[N];
	Misfit m;
	int p;

	sample_immersion(f, chart, 1, x, lambda, H);
	for (p = 0; p < N; p++) {
		lambda2[p] = lambda[p]*lambda[p];
		l2H[p] = lambda2[p]*H[p];
	}
	memcpy(phi, truth, sizeof phi);
	assert_int_equal(misfit_init(&m, chart, lambda2, l2H, NULL), 0);
	return m;
}

/* Noise of the size of the cells within 3 cells of the corner that p counts from. */
static void
crumple(int right, int top, double size)
{
	unsigned long long seed = 2;
	int a, b, c;

	for (c = 0; c < 3; c++)
		for (b = 1; b < 4; b++)
			for (a = 1; a < 4; a++)
				phi[c*N + (top ? NV - 1 - b : b)*NU + (right ? NU - 1 - a : a)] += size*noise(&seed);
}

/* The area vector of cell (i,j) times that of the exact surface, over its square. */
static double
least_area(void)
{
	double least = 1, d[2][3], e[2][3], n[2][3], x;
	int i, j, c, s;

	for (j = 0; j < NV - 1; j++)
		for (i = 0; i < NU - 1; i++) {
			for (s = 0; s < 2; s++) {
				const double *f = s ? truth : phi;

				for (c = 0; c < 3; c++, f += N) {
					d[s][c] = f[(j + 1)*NU + i + 1] - f[j*NU + i];
					e[s][c] = f[(j + 1)*NU + i] - f[j*NU + i + 1];
				}
				n[s][0] = d[s][1]*e[s][2] - d[s][2]*e[s][1];
				n[s][1] = d[s][2]*e[s][0] - d[s][0]*e[s][2];
				n[s][2] = d[s][0]*e[s][1] - d[s][1]*e[s][0];
			}
			x = (n[0][0]*n[1][0] + n[0][1]*n[1][1] + n[0][2]*n[1][2])
			    /(n[1][0]*n[1][0] + n[1][1]*n[1][1] + n[1][2]*n[1][2]);
			least = x < least ? x : least;
		}
	return least;
}

static void
crumpled_corner_of_a_smooth_boundary_is_smoothed(void **state)
{
	Misfit m = misfit_of(doubled);

	(void)state;
	crumple(0, 0, 2e-3);
	assert_true(least_area() < 0);
	assert_int_equal(corners_smooth(&m, phi), 0);
	assert_true(least_area() > 0.8);
	assert_true(largest(3*N, phi, truth) < 4e-4);
	misfit_free(&m);
}

/* Node 3 of the border goes back beyond node 2.  The harmonic function follows it. */
static void
cells_that_a_ragged_border_folds_are_turned_back(void **state)
{
	const double *const x[3] = { phi, phi + N, phi + 2*N };
	Misfit m = misfit_of(doubled);
	int c;

	(void)state;
	crumple(0, 0, 2e-3);
	for (c = 0; c < 3; c++)
		phi[c*N + 3] += 2.4*(phi[c*N + 2] - phi[c*N + 3]);
	assert_true(corner_folds(chart, 0, x, 10) > 0);
	assert_int_equal(corners_smooth(&m, phi), 0);
	assert_int_equal(corner_folds(chart, 0, x, 10), 0);
	assert_true(largest(3*N, phi, truth) < 3e-3);
	misfit_free(&m);
}

/* All four corners of a sphere patch are right angles. */
static void
only_folded_corners_are_touched(void **state)
{
	static double before[3*N];
	Misfit m = misfit_of(stereo);
	int k;

	(void)state;
	crumple(0, 0, 1e-3);
	memcpy(before, phi, sizeof phi);
	assert_true(least_area() > 0);
	assert_int_equal(corners_smooth(&m, phi), 0);
	assert_memory_equal(phi, before, sizeof phi);
	for (k = 0; k < 4; k++) {
		memcpy(phi, truth, sizeof phi);
		crumple(k%2, k/2, 0.04);
		assert_true(least_area() < 0);
		assert_int_equal(corners_smooth(&m, phi), 0);
		assert_true(least_area() > 0.6);
		assert_true(largest(3*N, phi, truth) < 0.01);
	}
	misfit_free(&m);
}

/* A fold beyond the reach of smoothing, yet among the cells that are looked at. */
static void
corner_that_keeps_its_folds_stays(void **state)
{
	static double before[3*N];
	Misfit m = misfit_of(stereo);

	(void)state;
	phi[8*NU + 8] += 0.1;
	assert_true(least_area() < 0);
	memcpy(before, phi, sizeof phi);
	assert_int_equal(corners_smooth(&m, phi), 0);
	assert_memory_equal(phi, before, sizeof phi);
	misfit_free(&m);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(crumpled_corner_of_a_smooth_boundary_is_smoothed),
		cmocka_unit_test(cells_that_a_ragged_border_folds_are_turned_back),
		cmocka_unit_test(only_folded_corners_are_touched),
		cmocka_unit_test(corner_that_keeps_its_folds_stays),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
